#include <stdbool.h>
#include "st.h"

typedef struct {
    int16_t raw;
    float lo, hi, limHi, limLo;
    float val;
    bool almHi, almLo;
    float filt;
} Analog;

typedef struct {
    bool start, stop, fb, estop, reset;
    bool run, fault;
    int32_t starts, ticks;
    bool cmd, old;
    int32_t wdog;
} Motor;

typedef struct {
    int32_t setpoint, rate;
    bool hold;
    int32_t pos;
    bool done;
} Valve;

typedef struct {
    float flow;
    bool reset;
    int32_t total;
    bool pulse;
    float rest;
} Totalizer;

static float scale(int16_t raw, float lo, float hi)
{
    return lo + (float)raw * (hi - lo) / 27648.0f;
}

static float deadband(float x, float ref, float band)
{
    float d = x - ref;
    if (d < 0.0f)
        d = -d;
    return d > band ? x : ref;
}

static int32_t clamp(int32_t mn, int32_t v, int32_t mx)
{
    if (v < mn)
        return mn;
    if (v > mx)
        return mx;
    return v;
}

static bool interlock(bool enable, bool estop, bool fault, bool guard)
{
    return enable && !estop && !fault && guard;
}

static void analog_call(Analog *a, int16_t raw, float lo, float hi, float limHi, float limLo)
{
    a->raw = raw;
    a->lo = lo;
    a->hi = hi;
    a->limHi = limHi;
    a->limLo = limLo;
    a->filt = a->filt + (scale(raw, lo, hi) - a->filt) * 0.25f;
    a->val = deadband(a->filt, a->val, 0.05f);
    a->almHi = a->val > limHi;
    a->almLo = a->val < limLo;
}

static void motor_call(Motor *m, bool start, bool stop, bool fb, bool estop, bool reset)
{
    m->start = start;
    m->stop = stop;
    m->fb = fb;
    m->estop = estop;
    m->reset = reset;
    if (start)
        m->cmd = true;
    if (stop)
        m->cmd = false;
    m->run = interlock(m->cmd, estop, m->fault, true);
    if (m->run && !fb) {
        m->wdog = clamp(0, m->wdog + 1, 50);
        if (m->wdog >= 50)
            m->fault = true;
    } else {
        m->wdog = 0;
    }
    if (reset)
        m->fault = false;
    if (m->run && !m->old)
        m->starts++;
    if (m->run)
        m->ticks++;
    m->old = m->run;
}

static void valve_call(Valve *v, int32_t setpoint, int32_t rate, bool hold)
{
    v->setpoint = setpoint;
    v->rate = rate;
    v->hold = hold;
    if (!hold) {
        int32_t diff = clamp(-rate, setpoint - v->pos, rate);
        v->pos = clamp(0, v->pos + diff, 10000);
    }
    v->done = v->pos == setpoint;
}

static void totalizer_call(Totalizer *t, float flow, bool reset)
{
    t->flow = flow;
    t->reset = reset;
    t->pulse = false;
    if (reset) {
        t->total = 0;
        t->rest = 0.0f;
    } else {
        t->rest = t->rest + deadband(flow, 0.0f, 0.5f) * 0.01f;
        if (t->rest >= 1.0f) {
            t->rest = t->rest - 1.0f;
            t->total++;
            t->pulse = true;
        }
    }
}

static int32_t scanNo;
static Analog ana[50];
static Motor mot[50];
static Valve vlv[50];
static Totalizer tot[50];

void scan(void)
{
    int32_t i, pass, acc;
    int16_t raw;
    float sum;

    for (pass = 1; pass <= 5; pass++) {
        scanNo++;
        acc = 0;
        sum = 0.0f;
        for (i = 0; i < 50; i++) {
            raw = (int16_t)((int32_t)((uint32_t)scanNo * 17u + (uint32_t)i * 553u) % 27648);
            analog_call(&ana[i], raw, 0.0f, 150.0f, 90.0f, 60.0f);
            motor_call(&mot[i], ana[i].almHi, ana[i].almLo, (scanNo + i) % 200 < 140,
                       false, (scanNo + i) % 333 == 0);
            valve_call(&vlv[i], (int32_t)((uint32_t)(scanNo / 100) * 777u + (uint32_t)i * 131u) % 10000, 25 + i, mot[i].fault);
            totalizer_call(&tot[i], ana[i].val, (scanNo + i * 20) % 1000 == 0);
            sum = sum + ana[i].val;
            acc += vlv[i].pos + tot[i].total + mot[i].ticks % 1000;
            if (mot[i].run)
                acc += 1;
            if (vlv[i].done)
                acc += 2;
            if (tot[i].pulse)
                acc += 4;
        }
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)(acc + (int32_t)sum));
    }
}
