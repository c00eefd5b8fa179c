/* Furnace: 18 zones; thermocouple chain */
#include <stdbool.h>
#include "st.h"

typedef struct { int16_t n; float x[8], y[8]; } Curve;

static float thermo_k(float mv, float cold)
{
    static const float c[6] = { 0.0f, 25.08355f, 0.07860106f, -0.02503131f, 0.00083152f, -0.00001228f };
    float t = 0.0f;
    for (int k = 5; k >= 0; k--)
        t = t * mv * 0.5f + c[k];
    return t + cold;
}

static float interpolate(float x, const Curve *tab)
{
    if (x <= tab->x[0])
        return tab->y[0];
    for (int k = 1; k < tab->n; k++)
        if (x < tab->x[k])
            return tab->y[k - 1] + (x - tab->x[k - 1]) * (tab->y[k] - tab->y[k - 1]) / (tab->x[k] - tab->x[k - 1]);
    return tab->y[tab->n - 1];
}

static float median3(float a, float b, float c)
{
    if (a > b) {
        if (b > c) return b;
        return a > c ? c : a;
    }
    if (a > c) return a;
    return b > c ? c : b;
}

static float absf(float x) { return x < 0.0f ? -x : x; }

typedef struct { float out; } Lag1;
static void lag1(Lag1 *f, float in, float tc, float dt)
{
    f->out = f->out + (in - f->out) * dt / (tc + dt);
}

typedef struct { float out, old; } LeadLag;
static void lead_lag(LeadLag *f, float in, float lead, float lag, float dt)
{
    f->out = (lag * f->out + (lead + dt) * in - lead * f->old) / (lag + dt);
    f->old = in;
}

typedef struct { float out; bool limiting; } RateLimit;
static void rate_limit(RateLimit *f, float in, float up, float down)
{
    float d = in - f->out;
    f->limiting = true;
    if (d > up) {
        f->out = f->out + up;
    } else if (d < -down) {
        f->out = f->out - down;
    } else {
        f->out = in;
        f->limiting = false;
    }
}

typedef struct { float out; } Deadband;
static void deadband(Deadband *f, float in, float width)
{
    if (absf(in - f->out) > width)
        f->out = in;
}

typedef struct { float sp; bool there; } SpRamp;
static void sp_ramp(SpRamp *f, float target, float rate, bool hold)
{
    if (!hold) {
        if (f->sp + rate < target)
            f->sp = f->sp + rate;
        else if (f->sp - rate > target)
            f->sp = f->sp - rate;
        else
            f->sp = target;
    }
    f->there = f->sp == target;
}

static bool init = true;
static int32_t cycle;
static uint32_t seed = 77;
static Lag1 fast[18], slow[18];
static LeadLag ll[18];
static RateLimit rl[18];
static Deadband db[18];
static SpRamp ramp[18];
static float mv[18];
static Curve valve_curve, air_curve;

void scan(void)
{
    int z, k;
    if (init) {
        valve_curve.n = 8;
        air_curve.n = 6;
        for (k = 0; k < 8; k++) {
            int n = k + 1;
            valve_curve.x[k] = (float)(n - 1) * 15.0f;
            valve_curve.y[k] = (float)(n * n) * 1.5f;
            air_curve.x[k] = (float)n * 14.0f;
            air_curve.y[k] = 5.0f + (float)n * 9.5f;
        }
        for (z = 0; z < 18; z++)
            mv[z] = 2.0f + (float)(z + 1) * 0.25f;
        init = false;
    }
    cycle++;
    for (z = 0; z < 18; z++) {
        float noise, ta, tb, tc, t, gas, air;
        seed = seed * 1103515245u + 12345u;
        noise = (float)(seed / 65536u % 1000u) * 0.0001f;
        ta = thermo_k(mv[z] + noise, 22.0f);
        tb = thermo_k(mv[z] - noise, 22.5f);
        tc = thermo_k(mv[z], 23.0f);
        t = median3(ta, tb, tc);
        lag1(&fast[z], t, 0.5f, 0.1f);
        lag1(&slow[z], fast[z].out, 4.0f, 0.1f);
        sp_ramp(&ramp[z], 150.0f + (float)(z + 1) * 6.0f + (float)(cycle / 1000 % 4) * 10.0f, 0.4f, slow[z].out + 80.0f < ramp[z].sp);
        lead_lag(&ll[z], ramp[z].sp - slow[z].out, 2.0f, 0.8f, 0.1f);
        rate_limit(&rl[z], ll[z].out * 1.2f + 35.0f, 2.5f, 4.0f);
        deadband(&db[z], rl[z].out, 0.5f);
        gas = interpolate(db[z].out, &valve_curve);
        air = interpolate(gas, &air_curve);
        mv[z] = mv[z] + (gas * 0.002f - mv[z] * 0.01f) * 0.5f;
        if (mv[z] > 12.0f) mv[z] = 12.0f;
        if (rl[z].limiting) check = (int32_t)((uint32_t)check + 1u);
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(air * 64.0f) + (uint32_t)(int32_t)(slow[z].out * 8.0f));
    }
}
