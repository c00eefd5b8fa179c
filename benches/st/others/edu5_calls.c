#include <stdbool.h>
#include "st.h"

typedef struct { int value, strikes; bool alarm; } Channel;

static Channel channels[200];
static int wave;

static int scale(int raw, int factor, int offset) { return raw * factor / 1024 + offset; }
static int smooth(int old, int new) { return old + (new - old) / 4; }
static bool outside(int value, int low, int high) { return value < low || value > high; }

static void channel(Channel *c, int raw, int factor, int offset)
{
    c->value = smooth(c->value, scale(raw, factor, offset));
    if (outside(c->value, 200, 700)) c->strikes++;
    else c->strikes = 0;
    c->alarm = c->strikes > 3;
}

void scan(void)
{
    wave = (wave + 37) % 1000;
    int sum = 0, alarms = 0;
    for (int i = 1; i <= 200; i++) {
        Channel *c = &channels[i - 1];
        channel(c, (wave + 5 * i) % 1000, 900 + i, i - 100);
        sum += c->value;
        alarms += c->alarm;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + alarms + 1));
}
