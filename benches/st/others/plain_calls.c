#include <stdint.h>
#include <stdbool.h>
#include <xmmintrin.h>
#include "st.h"

/* REAL_TO_DINT: round to nearest, even (lrintf without libm) */
static int32_t to_dint(float x) { return _mm_cvtss_si32(_mm_set_ss(x)); }

typedef struct {
    float value;
    bool alarm;
    int32_t alarms;
} analog_in;

static float scale(int16_t raw, float lo, float hi) { return lo + raw * (hi - lo) / 27648.0f; }

static float clip(float x, float lo, float hi)
{
    if (x < lo) return lo;
    if (x > hi) return hi;
    return x;
}

static void analog_in_run(analog_in *a, int16_t raw, float lo, float hi, float limit)
{
    bool last = a->alarm;
    float scaled = clip(scale(raw, lo, hi), lo, hi);
    a->value += (scaled - a->value) * 0.2f;
    a->alarm = a->value > limit;
    if (a->alarm && !last)
        a->alarms++;
}

static int32_t scans;
static analog_in ai[200];

void scan(void)
{
    scans++;
    float sum = 0;
    int32_t count = 0;
    for (int i = 0; i < 200; i++) {
        analog_in_run(&ai[i], (scans * 137 + i * 100) % 30000, 0.0f, 100.0f, 60.0f);
        sum += ai[i].value;
        count += ai[i].alarms;
        if (ai[i].alarm)
            count += i;
    }
    check = (check + to_dint(sum) + count) % 1000000;
}
