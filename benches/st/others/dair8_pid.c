/* 64 PID loops: temperatures, pressures, flows and levels */
#include <stdbool.h>
#include <math.h>
#include "st.h"

#define LOOPS 64

typedef enum { MODE_OFF, MODE_MANUAL, MODE_AUTO, MODE_HOLD } loop_mode;

typedef struct {
    float kp, ti, td, ts, out_min, out_max, dead_band, ramp_max;
} pid_param;

typedef struct {
    loop_mode mode;
    float setpoint, actual, manual, output;
    bool high_alm, low_alm;
} pid_io;

typedef struct {
    float integral, derivative, last_actual, last_out, limited;
    bool saturated;
} pid_state;

static pid_param params[LOOPS];
static pid_io ios[LOOPS];
static pid_state pids[LOOPS];
static bool ready;
static int32_t tick;

static inline float clampf(float v, float low, float high)
{
    if (v < low)
        return low;
    if (v > high)
        return high;
    return v;
}

static inline float dead_band(float v, float band)
{
    return fabsf(v) < band ? 0.0f : v;
}

static void pid_update(pid_state *s, const pid_param *p, pid_io *io)
{
    switch (io->mode) {
    case MODE_OFF:
        s->integral = 0.0f;
        s->derivative = 0.0f;
        s->limited = 0.0f;
        s->saturated = false;
        break;
    case MODE_MANUAL:
        s->limited = clampf(io->manual, p->out_min, p->out_max);
        s->integral = s->limited;
        s->derivative = 0.0f;
        s->saturated = false;
        break;
    case MODE_AUTO: {
        float error = dead_band(io->setpoint - io->actual, p->dead_band);
        float prop = p->kp * error;
        s->derivative = s->derivative * 0.8f + 0.2f * (p->kp * p->td / p->ts * (s->last_actual - io->actual));
        float raw = prop + s->integral + s->derivative;
        s->limited = clampf(raw, p->out_min, p->out_max);
        s->saturated = raw != s->limited;
        if (!s->saturated || (raw > p->out_max && error < 0.0f) || (raw < p->out_min && error > 0.0f))
            s->integral = clampf(s->integral + prop * p->ts / p->ti, p->out_min, p->out_max);
        break;
    }
    case MODE_HOLD:
        s->limited = s->last_out;
        break;
    }

    s->last_out = clampf(s->limited, s->last_out - p->ramp_max, s->last_out + p->ramp_max);
    s->last_actual = io->actual;
    io->output = s->last_out;
    io->high_alm = io->actual > io->setpoint + 10.0f;
    io->low_alm = io->actual < io->setpoint - 10.0f;
}

static void process_update(pid_io *io, float gain, float lag, float noise)
{
    io->actual = io->actual + (io->output * gain + noise - io->actual) * lag;
}

static void init(void)
{
    for (int i = 1; i <= LOOPS; i++) {
        params[i - 1] = (pid_param){
            .kp = 0.5f + (float)i * 0.03f, .ti = 2.0f + (float)(i % 7), .td = 0.05f * (float)(i % 4), .ts = 0.1f,
            .out_min = 0.0f, .out_max = 100.0f, .dead_band = 0.05f, .ramp_max = 5.0f,
        };
        ios[i - 1].mode = MODE_AUTO;
        ios[i - 1].setpoint = 20.0f + (float)i;
        ios[i - 1].manual = 35.0f;
    }
}

void scan(void)
{
    if (!ready) {
        init();
        ready = true;
    }

    tick = (int32_t)((uint32_t)tick + 1u);
    int n = tick % 64;
    switch (tick / 64 % 8) {
    case 0: ios[n].setpoint = 60.0f; break;
    case 2: ios[n].mode = MODE_MANUAL; break;
    case 3: ios[n].mode = MODE_AUTO; break;
    case 4: ios[n].setpoint = 15.0f + (float)(n + 1) * 0.5f; break;
    case 5: ios[n].mode = MODE_HOLD; break;
    case 6: ios[n].mode = MODE_OFF; break;
    case 7: ios[n].mode = MODE_AUTO; break;
    }

    int32_t alarms = 0;
    float total = 0.0f;
    for (int i = 0; i < LOOPS; i++) {
        pid_io *io = &ios[i];
        float noise = (float)((int32_t)((uint32_t)tick * 7u + (uint32_t)i + 1u) % 13) * 0.1f;

        process_update(io, 1.2f, 0.08f, noise);
        pid_update(&pids[i], &params[i], io);
        total += io->output;
        if (io->high_alm)
            alarms += 1;
        if (io->low_alm)
            alarms += 100;
        if (pids[i].saturated)
            alarms += 10000;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)alarms + (uint32_t)(int32_t)lrintf(total * 100.0f));
}
