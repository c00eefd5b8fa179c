#include <stdint.h>
#include <stdbool.h>
#include "st.h"

struct pid_loop {
    float setpoint, actual, gain, ti, td, e1, e2, output;
    bool manual;
};

static float limit(float lo, float x, float hi) { return x < lo ? lo : x > hi ? hi : x; }

static int32_t scans;
static struct pid_loop ctl[64];
static float ts = 0.1f;

void scan(void)
{
    if (scans == 0)
        for (int n = 1; n <= 64; n++) {
            struct pid_loop *c = &ctl[n - 1];
            c->setpoint = n + 10.0f;
            c->gain = 0.5f + (n % 5) * 0.1f;
            c->ti = 2.0f + n % 3;
            c->td = 0.05f;
        }
    scans++;
    for (int cycle = 0; cycle < 5; cycle++) {
        for (int n = 1; n <= 64; n++) {
            struct pid_loop *c = &ctl[n - 1];
            if (scans % 64 == n - 1)
                c->setpoint = 100.0f - c->setpoint;
            c->manual = (scans + n) % 50 == 0;
            float e = c->setpoint - c->actual;
            if (!c->manual) {
                float du = c->gain * ((e - c->e1) + ts / c->ti * e + c->td / ts * (e - 2.0f * c->e1 + c->e2));
                c->output = limit(0.0f, c->output + du, 100.0f);
            }
            c->e2 = c->e1;
            c->e1 = e;
            c->actual = 0.9f * c->actual + 0.1f * c->output;
            check += (int32_t)(c->actual * 4.0f) + (int32_t)c->output;
        }
    }
    check %= 1000000;
}
