#include "st.h"
#include <math.h>
#include <stdbool.h>

#define LOOPS 64
enum mode { PID_OFF, PID_MANUAL, PID_AUTO };

struct par { float kp, ti, td, out_min, out_max, ramp, deadband; };
struct io { enum mode mode; float sp, pv, man, out; bool limited, deviation; };
struct pid { float ramp, filter, i, pv_old; };

static struct pid pids[LOOPS];
static struct par pars[LOOPS];
static struct io ios[LOOPS];
static bool init;
static int32_t scans;

static inline float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static float ramp(float out, float target, float step)
{
    if (target > out + step)
        return out + step;
    if (target < out - step)
        return out - step;
    return target;
}

static void pid_run(struct pid *c, const struct par *p, float dt, struct io *io)
{
    c->ramp = ramp(c->ramp, io->sp, p->ramp);
    float err = c->ramp - io->pv;
    if (fabsf(err) < p->deadband)
        err = 0.0f;

    c->filter += (io->pv - c->filter) * 0.3f;
    float d = p->kp * p->td * (c->pv_old - c->filter) / dt;
    c->pv_old = c->filter;
    float prop = p->kp * err;

    switch (io->mode) {
    case PID_OFF:
        c->i = 0.0f;
        io->out = p->out_min;
        io->limited = false;
        break;
    case PID_MANUAL:
        io->out = limit(p->out_min, io->man, p->out_max);
        c->i = io->out - prop;
        io->limited = false;
        break;
    case PID_AUTO: {
        float raw = prop + c->i + d;
        io->out = limit(p->out_min, raw, p->out_max);
        io->limited = raw != io->out;
        if (!io->limited || (raw > p->out_max && err < 0.0f) || (raw < p->out_min && err > 0.0f))
            c->i += p->kp * err * dt / p->ti;
        break;
    }
    }
    io->deviation = fabsf(io->sp - io->pv) > 10.0f;
}

void scan(void)
{
    if (!init) {
        for (int i = 0; i < LOOPS; i++) {
            pars[i] = (struct par){ .kp = 0.8f + (float)(i + 1) * 0.02f, .ti = 4.0f + (float)((i + 1) % 8),
                                    .td = 0.4f, .out_min = 0.0f, .out_max = 100.0f, .ramp = 2.5f, .deadband = 0.05f };
            ios[i].mode = PID_AUTO;
            ios[i].sp = 20.0f + (float)(i + 1);
            ios[i].pv = 15.0f;
            ios[i].man = 35.0f;
        }
        init = true;
    }

    scans++;
    struct io *op = &ios[scans % LOOPS];
    switch (scans % 5) {
    case 0: op->mode = PID_MANUAL; break;
    case 1:
    case 2: op->mode = PID_AUTO; break;
    case 3: op->sp = 20.0f + (float)(scans % 77); break;
    default: if (scans % 9 == 0) op->mode = PID_OFF; break;
    }

    int32_t sum = 0;
    for (int i = 0; i < LOOPS; i++) {
        struct io *io = &ios[i];
        pid_run(&pids[i], &pars[i], 0.1f, io);
        io->pv += (io->out * 1.1f + 5.0f - io->pv) * 0.05f;
        sum += (int32_t)lrintf(io->out * 16.0f) + (int32_t)lrintf(io->pv * 16.0f);
        if (io->limited) sum += 1;
        if (io->deviation) sum += 2;
    }
    check = (int32_t)((uint32_t)check * 13u + (uint32_t)sum);
}
