/* The same work as calls.st. */
#include "st.h"

struct stage {
    int32_t raw, value, starts;
    uint8_t on, high, before;
};

static struct stage stages[200];
static int32_t scans, highs;

static int32_t scaled(int32_t raw, int32_t gain, int32_t offset)
{
    return raw * gain / 16 + offset;
}

static void stage(struct stage *s)
{
    if (s->on && !s->before)
        s->starts++;
    s->before = s->on;
    if (s->on)
        s->value = (s->value * 3 + scaled(s->raw, 5, s->starts)) / 4;
    else
        s->value = s->value / 2;
    s->high = s->value > 1000;
}

void scan(void)
{
    for (int32_t i = 0; i < 200; i++) {
        stages[i].on = (i + scans) % 7 < 5;
        stages[i].raw = i * 16 + scans % 32;
        stage(&stages[i]);
        if (stages[i].high)
            highs++;
    }
    int32_t sum = 0;
    for (int32_t i = 0; i < 500; i++)
        sum += scaled(i, 3, scans % 8);
    check += sum + highs + stages[scans % 200].value;
    scans++;
}
