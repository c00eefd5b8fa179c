/* Sixty-four room temperature controllers, each with a simple thermal model of its room */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define ROOMS 64
#define CYCLE_TIME 0.01f
#define DERIVATIVE_FILTER 0.1f

struct pid {
    /* parameters */
    float kp, ti, td, dead_band, out_min, out_max;
    /* outputs */
    float out;
    uint16_t status;
    /* state */
    float integral, derivative, previous;
    bool running;
};

static struct pid controllers[ROOMS];
static float temperature[ROOMS];
static float setpoint[ROOMS];
static int32_t scan_counter;
static bool initialized;

static inline float clampf(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static void pid_step(struct pid *p, bool enable, float sp, float actual)
{
    if (!enable) {
        p->out = p->out_min;
        p->integral = 0.0f;
        p->derivative = 0.0f;
        p->running = false;
        p->status = 0;
        return;
    }

    if (!p->running) {
        p->previous = actual;
        p->running = true;
    }

    float error = sp - actual;
    if (fabsf(error) < p->dead_band)
        error = 0.0f;

    p->derivative += DERIVATIVE_FILTER * ((p->previous - actual) * p->kp * p->td / CYCLE_TIME - p->derivative);
    p->previous = actual;

    float raw = error * p->kp + p->integral + p->derivative;
    p->out = clampf(p->out_min, raw, p->out_max);

    /* anti-windup: integrate only where the output is not saturated in that direction */
    if ((raw < p->out_max || error < 0.0f) && (raw > p->out_min || error > 0.0f))
        p->integral += error * p->kp * CYCLE_TIME / p->ti;

    p->status = (uint16_t)(1u | (raw >= p->out_max) << 1 | (raw <= p->out_min) << 2
                | (fabsf(error) > 2.0f) << 3 | (error == 0.0f) << 4);
}

static void init(void)
{
    for (int i = 0; i < ROOMS; i++) {
        controllers[i] = (struct pid){
            .kp = 8.0f, .ti = 120.0f, .td = 5.0f, .dead_band = 0.05f,
            .out_min = 0.0f, .out_max = 100.0f,
        };
        temperature[i] = 15.0f + (float)(i + 1) * 0.15f;
        setpoint[i] = 20.0f + (float)((i + 1) % 5) * 0.5f;
    }
}

void scan(void)
{
    if (!initialized) {
        init();
        initialized = true;
    }

    scan_counter++;
    float outside = (float)(scan_counter % 4000) * 0.005f - 10.0f;

    setpoint[scan_counter % ROOMS] = 18.0f + (float)(scan_counter % 37) * 0.15f;

    uint32_t sum = (uint32_t)check;
    for (int i = 0; i < ROOMS; i++) {
        struct pid *p = &controllers[i];

        pid_step(p, (scan_counter + (i + 1) * 50) % 4000 > 100, setpoint[i], temperature[i]);

        temperature[i] = temperature[i] + p->out * 0.0008f - (temperature[i] - outside) * 0.001f;

        sum = sum * 31u + (uint32_t)(int32_t)lrintf(p->out * 100.0f) + p->status;
    }
    check = (int32_t)sum;
}
