/* 32 cascades = 64 loops: temperature master (velocity form), flow slave (PI), raw INT signals */
#include <stdbool.h>
#include "st.h"

static float limitf(float mn, float x, float mx)
{
    if (x < mn) x = mn;
    if (x > mx) x = mx;
    return x;
}

static float scale01(int16_t raw) { return (float)raw / 276.48f; }
static int16_t to_raw(float percent) { return (int16_t)(limitf(0.0f, percent, 100.0f) * 276.48f); }

typedef struct { float out, e1, pv1, pv2; } VelocityPid;

static void velocity_pid(VelocityPid *c, float sp, float pv, float gain, float ki, float kd, bool track, float track_val)
{
    float e = sp - pv;
    if (track) {
        c->out = track_val;
    } else {
        float du = gain * ((e - c->e1) + ki * e - kd * (pv - 2.0f * c->pv1 + c->pv2));
        if (du > 5.0f)
            du = 5.0f;
        else if (du < -5.0f)
            du = -5.0f;
        c->out = limitf(0.0f, c->out + du, 100.0f);
    }
    c->e1 = e;
    c->pv2 = c->pv1;
    c->pv1 = pv;
}

typedef struct { int16_t raw_out; float pv; bool saturated; float i; } FlowPi;

static void flow_pi(FlowPi *c, float sp, int16_t raw_pv, float kp, float ti, float ff)
{
    float e, u;
    c->pv = scale01(raw_pv);
    e = sp - c->pv;
    u = kp * e + c->i + ff;
    c->saturated = u > 100.0f || u < 0.0f;
    if (!c->saturated)
        c->i = c->i + kp * e / ti;
    c->raw_out = to_raw(u);
}

typedef struct {
    int16_t valve_raw;
    float flow_sp;
    bool sat;
    VelocityPid master;
    FlowPi slave;
} Cascade;

static void cascade(Cascade *c, float temp_sp, float temp, int16_t flow_raw, bool automatic, float demand)
{
    float g;
    if (temp < 200.0f)
        g = 0.8f;
    else if (temp < 500.0f)
        g = 0.8f + (temp - 200.0f) * 0.001f;
    else
        g = 1.1f;
    velocity_pid(&c->master, temp_sp, temp, g, 0.02f, 0.5f, !automatic || c->slave.saturated, c->slave.pv);
    c->flow_sp = c->master.out;
    flow_pi(&c->slave, c->flow_sp, flow_raw, 0.6f, 8.0f, demand * 0.2f);
    c->valve_raw = c->slave.raw_out;
    c->sat = c->slave.saturated;
}

static bool first = true;
static int32_t cycle;
static uint32_t seed = 555;
static Cascade loop[32];
static float temp[32], flow[32];

void scan(void)
{
    int k;
    int32_t sats = 0;
    if (first) {
        for (k = 0; k < 32; k++)
            temp[k] = 100.0f + (float)(k + 1) * 5.0f;
        first = false;
    }
    cycle++;
    for (k = 0; k < 32; k++) {
        int n = k + 1;
        int16_t raw;
        float sp;
        seed = seed * 1664525u + 1013904223u;
        raw = to_raw(flow[k]) + (int16_t)(seed / 65536u % 32u);
        switch ((cycle / 700 + n) % 3) {
        case 0: sp = 250.0f; break;
        case 1: sp = 420.0f; break;
        default: sp = 610.0f; break;
        }
        cascade(&loop[k], sp, temp[k], raw, (cycle + n * 31) % 2000 > 60, (float)n * 0.5f);
        flow[k] = flow[k] + (scale01(loop[k].valve_raw) - flow[k]) * 0.3f;
        temp[k] = temp[k] + (flow[k] * 9.0f + 25.0f - temp[k]) * 0.008f;
        if (loop[k].sat) sats++;
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)loop[k].valve_raw + (uint32_t)(int32_t)(temp[k] * 4.0f) + (uint32_t)(int32_t)(loop[k].flow_sp * 10.0f));
    }
    check = (int32_t)((uint32_t)check + (uint32_t)sats);
}
