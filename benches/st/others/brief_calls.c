/* 200 calls on objects (100 analog, 100 motor), which call functions */
#include <stdbool.h>
#include "st.h"

static int32_t scale(int16_t raw, int32_t lo, int32_t hi)
{
    return lo + raw * (hi - lo) / 27648;
}

static int32_t clamp(int32_t x, int32_t mn, int32_t mx)
{
    if (x < mn) return mn;
    if (x > mx) return mx;
    return x;
}

static bool hyst(int32_t x, int32_t limit, int32_t band, bool old)
{
    if (old) return x > limit - band;
    return x > limit;
}

typedef struct {
    int32_t value;
    bool alarm;
    int32_t filtered;
} analog_t;

typedef struct {
    bool run;
    int32_t speed, starts;
    bool edge;
} motor_t;

static void analog(analog_t *a, int16_t raw)
{
    a->filtered += (scale(raw, 0, 1000) * 16 - a->filtered) / 8;
    a->value = clamp(a->filtered / 16, 10, 990);
    a->alarm = hyst(a->value, 700, 50, a->alarm);
}

static void motor(motor_t *m, bool start, bool stop, bool fault)
{
    if (stop || fault) {
        m->run = false;
    } else if (start && !m->edge) {
        m->run = true;
        m->starts++;
    }
    m->edge = start;
    if (m->run)
        m->speed = clamp(m->speed + 15, 0, 1500);
    else
        m->speed = clamp(m->speed - 40, 0, 1500);
}

static analog_t analogs[100];
static motor_t motors[100];
static int32_t n;

void scan(void)
{
    int32_t sum = 0;
    n++;
    for (int32_t i = 0; i < 100; i++) {
        int16_t raw = (int16_t)((n * 37 + i * 211) % 27648);
        analog(&analogs[i], raw);
        motor(&motors[i], raw > 8000, raw < 1000, analogs[i].alarm);
        sum += analogs[i].value + motors[i].speed + motors[i].starts;
        if (analogs[i].alarm) sum += 1;
    }
    if (n == 50000) n = 0;
    check = check * 31 + sum;
}
