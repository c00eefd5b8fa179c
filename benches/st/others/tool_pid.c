#include <stdbool.h>
#include "st.h"

static float limit(float mn, float x, float mx)
{
    return x < mn ? mn : x > mx ? mx : x;
}

static float deadband(float x, float width)
{
    if (x > width)
        return x - width;
    else if (x < -width)
        return x + width;
    return 0.0f;
}

static float rate_limit(float target, float last, float max_step)
{
    return last + limit(-max_step, target - last, max_step);
}

struct pid {
    float setpoint, actual;
    bool manual;
    float manual_value, kp, ti, td, out_min, out_max;
    float out;
    bool limited;
    float err, p_part, i_part, d_part, last_actual, raw, sp_ramp;
};

#define TS 0.1f

static void pid(struct pid *p)
{
    p->sp_ramp = rate_limit(p->setpoint, p->sp_ramp, 2.0f);
    p->err = deadband(p->sp_ramp - p->actual, 0.05f);
    p->p_part = p->kp * p->err;
    p->d_part = 0.8f * p->d_part + 0.2f * p->kp * p->td * (p->last_actual - p->actual) / TS;
    p->last_actual = p->actual;
    if (p->manual) {
        p->out = limit(p->out_min, p->manual_value, p->out_max);
        p->i_part = p->out - p->p_part;
        p->limited = false;
    } else {
        p->raw = p->p_part + p->i_part + p->d_part;
        p->out = limit(p->out_min, p->raw, p->out_max);
        p->limited = p->out != p->raw;
        if (!p->limited || (p->raw > p->out_max && p->err < 0.0f) || (p->raw < p->out_min && p->err > 0.0f))
            p->i_part = p->i_part + p->kp * TS / p->ti * p->err;
    }
}

static struct pid loops[64];
static float temp[64], sp[64];
static int32_t cycle = 399;
static bool init;

void scan(void)
{
    if (!init) {
        for (int i = 0; i < 64; i++) {
            loops[i].out_min = 0.0f;
            loops[i].out_max = 100.0f;
        }
        init = true;
    }
    cycle++;
    if (cycle >= 400) {
        cycle = 0;
        for (int i = 0; i < 64; i++)
            sp[i] = (float)((i * 13) % 80) + 5.0f;
    } else if (cycle == 200) {
        for (int i = 0; i < 64; i++)
            sp[i] = 60.0f - 0.5f * (float)i;
    }
    int16_t n_limited = 0;
    float total = 0.0f;
    for (int i = 0; i < 64; i++) {
        struct pid *p = &loops[i];
        p->setpoint = sp[i];
        p->actual = temp[i];
        p->manual = (i % 16 == 3) && (cycle < 50);
        p->manual_value = 30.0f;
        p->kp = 2.0f + 0.05f * (float)i;
        p->ti = 8.0f;
        p->td = 0.4f;
        pid(p);
        temp[i] = temp[i] + 0.02f * (0.9f * p->out - temp[i]);
        total = total + temp[i];
        if (p->limited)
            n_limited++;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)(total * 8.0f) + n_limited));
}
