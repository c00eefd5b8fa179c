#include <stdint.h>
#include <stdbool.h>
#include <xmmintrin.h>
#include "st.h"

/* REAL_TO_DINT: round to nearest, even (lrintf without libm) */
static int32_t to_dint(float x) { return _mm_cvtss_si32(_mm_set_ss(x)); }

typedef struct {
    bool enabled, running;
    float speed, setpoint;
    int16_t temperature;
    int32_t starts, runtime;
} motor;

static int32_t scans;
static motor motors[500];

void scan(void)
{
    scans++;
    int32_t sum = 0;
    float sum_speed = 0;
    int hottest = 0;
    for (int i = 0; i < 500; i++) {
        motor *m = &motors[i];
        m->enabled = (scans + i + 1) % 30 < 20;
        m->setpoint = (i + 1) * 10.0f;
        if (m->enabled) {
            if (!m->running) {
                m->running = true;
                m->starts++;
            }
            m->speed += (m->setpoint - m->speed) * 0.1f;
            m->runtime++;
            if (m->temperature < 120)
                m->temperature++;
        } else {
            m->running = false;
            m->speed *= 0.5f;
            if (m->temperature > 20)
                m->temperature -= 2;
        }
        if (m->temperature > motors[hottest].temperature)
            hottest = i;
        sum_speed += m->speed;
        sum += m->starts + m->runtime + m->temperature;
    }
    check = (check + sum + to_dint(sum_speed) + hottest + 1) % 1000000;
}
