#include <stdbool.h>
#include "st.h"

typedef struct {
    float kp, ki, kd, dt;
    float integral, last_error, output;
    bool limited;
} Pid;

static Pid loops[64];
static float level[64];
static int tick;

static void pid(Pid *p, float setpoint, float actual)
{
    float error = setpoint - actual;
    float raw = p->kp * error + p->integral + p->kd * (error - p->last_error) / p->dt;
    p->last_error = error;
    p->output = raw < 0.0f ? 0.0f : raw > 100.0f ? 100.0f : raw;
    p->limited = raw < 0.0f || raw > 100.0f;
    if (!p->limited) p->integral += p->ki * error * p->dt;
}

void scan(void)
{
    if (++tick >= 400) tick = 0;
    float sum = 0.0f;
    int saturated = 0;
    for (int i = 0; i < 64; i++) {
        Pid *p = &loops[i];
        float n = (float)(i + 1);
        float target = tick < 200 ? 20.0f + n : 60.0f;
        p->kp = 2.0f + 0.01f * n;
        p->ki = 0.8f;
        p->kd = 0.02f;
        p->dt = 0.01f;
        pid(p, target, level[i]);
        level[i] += (p->output - level[i]) * 0.02f;
        sum += p->output;
        saturated += p->limited;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)(sum * 10.0f) + saturated + 1));
}
