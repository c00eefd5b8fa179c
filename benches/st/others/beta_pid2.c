#include "st.h"
#include <stdbool.h>
#include <math.h>

typedef struct { float kp, ki, kd, out_min, out_max; } PidPar;
typedef struct { float temperature; float flow[3]; float valve[3]; float load; } Process;
typedef struct { float sp; } SetpointRamp;
typedef struct { float out, error, i_term, prev_pv; } TempControl;
typedef struct { float e0, e1, e2; } FlowControl;
typedef struct {
    float deviation;
    SetpointRamp ramp;
    TempControl master;
    FlowControl slaves[3];
} Furnace;

static float minf(float a, float b) { return a < b ? a : b; }
static float maxf(float a, float b) { return a > b ? a : b; }

static float schedule(float temperature)
{
    if (temperature < 200.0f)
        return 1.4f;
    else if (temperature < 400.0f)
        return 1.4f - (temperature - 200.0f) * 0.002f;
    else
        return 1.0f;
}

static void setpoint_ramp(SetpointRamp *b, float target, float rate)
{
    if (target > b->sp + rate)
        b->sp += rate;
    else if (target < b->sp - rate)
        b->sp -= rate;
    else
        b->sp = target;
}

/* position form with back calculation */
static void temp_control(TempControl *b, float sp, float pv, float feed_forward, const PidPar *par)
{
    float gain = schedule(pv) * par->kp;
    b->error = sp - pv;
    float raw = gain * b->error + b->i_term + feed_forward - par->kd * (pv - b->prev_pv);
    b->out = minf(maxf(raw, par->out_min), par->out_max);
    b->i_term = b->i_term + par->ki * b->error + 0.1f * (b->out - raw);
    b->prev_pv = pv;
}

/* velocity form */
static void flow_control(FlowControl *b, float sp, float pv, const PidPar *par, float *valve)
{
    b->e2 = b->e1;
    b->e1 = b->e0;
    b->e0 = sp - pv;
    float v = *valve + par->kp * (b->e0 - b->e1) + par->ki * b->e0 + par->kd * (b->e0 - 2.0f * b->e1 + b->e2);
    *valve = minf(maxf(v, par->out_min), par->out_max);
}

/* every furnace has its own parameters, as each can be tuned */
typedef struct { PidPar master, slave; float share[3]; } Tuning;

static Furnace furnaces[16];
static Process processes[16];
static Tuning tuning[16];
static bool ready;
static int16_t tick;

static void furnace(Furnace *b, const Tuning *t, float target, Process *prc)
{
    setpoint_ramp(&b->ramp, target, 0.5f);
    temp_control(&b->master, b->ramp.sp, prc->temperature, prc->load * 0.2f, &t->master);
    float heat = 0.0f;
    for (int z = 0; z < 3; z++) {
        flow_control(&b->slaves[z], b->master.out * t->share[z], prc->flow[z], &t->slave, &prc->valve[z]);
        prc->flow[z] = prc->flow[z] + 0.1f * (prc->valve[z] - prc->flow[z]);
        heat += prc->flow[z];
    }
    prc->temperature = prc->temperature + 0.02f * heat - 0.003f * (prc->temperature - 20.0f) - 0.001f * prc->load;
    b->deviation = b->master.error;
}

void scan(void)
{
    if (!ready) {
        ready = true;
        for (int f = 0; f < 16; f++) {
            tuning[f].master = (PidPar){ 0.8f, 0.004f, 2.0f, 0.0f, 100.0f };
            tuning[f].slave = (PidPar){ 0.3f, 0.08f, 0.02f, 0.0f, 100.0f };
            tuning[f].share[0] = 0.5f;
            tuning[f].share[1] = 0.3f;
            tuning[f].share[2] = 0.2f;
        }
    }
    tick++;
    if (tick >= 4000)
        tick = 0;
    float sum_t = 0.0f, sum_d = 0.0f;
    for (int f = 0; f < 16; f++) {
        float target;
        if ((tick + (f + 1) * 100) % 4000 < 2000)
            target = 450.0f + (float)(f + 1) * 5.0f;
        else
            target = 180.0f;
        processes[f].load = (float)((tick + (f + 1) * 17) % 300) * 0.1f;
        furnace(&furnaces[f], &tuning[f], target, &processes[f]);
        sum_t = sum_t + processes[f].temperature + processes[f].valve[1];
        sum_d = sum_d + fabsf(furnaces[f].deviation);
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(sum_t * 10.0f) + (uint32_t)(int32_t)sum_d);
}
