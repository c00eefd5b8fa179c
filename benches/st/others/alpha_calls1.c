/* Tank farm: 32 tanks, scaling, alarms, volume, two valves, totalizer */
#include <stdbool.h>
#include "st.h"

typedef struct { float hh, h, l, ll, hyst; } TankLimits;

typedef struct { float pv; bool bad, primed; } AnalogIn;

static void analog_in(AnalogIn *a, int16_t raw, float lo, float hi, float lag)
{
    a->bad = raw < -400 || raw > 28000;
    if (!a->bad) {
        float x = lo + (float)raw * (hi - lo) / 27648.0f;
        if (a->primed) {
            a->pv = a->pv + (x - a->pv) * lag;
        } else {
            a->pv = x;
            a->primed = true;
        }
    }
}

typedef struct { bool hh, h, l, ll, unacked, any_old; } LevelAlarm;

static void level_alarm(LevelAlarm *a, float pv, const TankLimits *lim, bool ack)
{
    bool any;
    if (pv > lim->hh) a->hh = true; else if (pv < lim->hh - lim->hyst) a->hh = false;
    if (pv > lim->h) a->h = true; else if (pv < lim->h - lim->hyst) a->h = false;
    if (pv < lim->l) a->l = true; else if (pv > lim->l + lim->hyst) a->l = false;
    if (pv < lim->ll) a->ll = true; else if (pv > lim->ll + lim->hyst) a->ll = false;
    any = a->hh || a->h || a->l || a->ll;
    if (any && !a->any_old)
        a->unacked = true;
    else if (ack)
        a->unacked = false;
    a->any_old = any;
}

typedef struct { bool is_open, is_closed, moving; int32_t strokes; int16_t pos; } OnOffValve;

static void valve(OnOffValve *v, bool open, bool interlock, int16_t travel)
{
    if (open && !interlock) {
        if (v->pos < travel) {
            v->pos++;
            if (v->pos == travel) v->strokes++;
        }
    } else {
        if (v->pos > 0) v->pos--;
    }
    v->is_open = v->pos >= travel;
    v->is_closed = v->pos == 0;
    v->moving = !v->is_open && !v->is_closed;
}

typedef struct { int32_t total; float rest; } Totalizer;

static void totalize(Totalizer *t, float flow, float dt, bool reset)
{
    if (reset) {
        t->total = 0;
        t->rest = 0.0f;
    } else {
        t->rest = t->rest + flow * dt;
        if (t->rest >= 1.0f) {
            int32_t n = (int32_t)t->rest;
            t->rest = t->rest - (float)n;
            t->total += n;
        }
    }
}

static float tank_volume(int16_t shape, float h, float d, float len)
{
    static const float seg[11] = { 0.0f, 0.052f, 0.1424f, 0.2523f, 0.3735f, 0.5f, 0.6265f, 0.7477f, 0.8576f, 0.948f, 1.0f };
    float x;
    int k;
    switch (shape) {
    case 1:
        return 0.785398f * d * d * h;
    case 2:
        x = h / d * 10.0f;
        if (x <= 0.0f)
            x = 0.0f;
        else if (x >= 10.0f)
            x = 10.0f;
        k = 0;
        while (k < 9 && x > 1.0f) {
            x -= 1.0f;
            k++;
        }
        return (seg[k] + (seg[k + 1] - seg[k]) * x) * 0.785398f * d * d * len;
    case 3:
        if (h < len) {
            x = d * h / len;
            return 0.261799f * x * x * h;
        }
        return 0.261799f * d * d * len + 0.785398f * d * d * (h - len);
    default:
        return d * len * h;
    }
}

static bool ready;
static int32_t cycle;
static uint32_t seed = 12345;
static AnalogIn ai[32];
static LevelAlarm al[32];
static OnOffValve inlet[32], outlet[32];
static Totalizer tot[32];
static TankLimits lim[32];
static int16_t shape[32];
static float dia[32], len[32], level[32];
static bool filling[32];

void scan(void)
{
    int i;
    bool ack;
    if (!ready) {
        for (i = 0; i < 32; i++) {
            int n = i + 1;
            shape[i] = n % 4;
            dia[i] = 2.0f + (float)(n % 5) * 0.5f;
            len[i] = 1.5f + (float)(n % 3);
            level[i] = 0.2f + (float)n * 0.05f;
            lim[i].hh = 1.9f;
            lim[i].h = 1.7f;
            lim[i].l = 0.5f;
            lim[i].ll = 0.25f;
            lim[i].hyst = 0.04f;
            filling[i] = true;
        }
        ready = true;
    }
    cycle++;
    ack = cycle % 50 == 0;
    for (i = 0; i < 32; i++) {
        int16_t raw;
        float vol, flow;
        int32_t bits;
        seed = seed * 1664525u + 1013904223u;
        raw = (int16_t)((int16_t)(level[i] * 13824.0f) + (int16_t)(seed / 65536u % 64u) - 32);
        analog_in(&ai[i], raw, 0.0f, 2.0f, 0.25f);
        level_alarm(&al[i], ai[i].pv, &lim[i], ack);
        if (al[i].h)
            filling[i] = false;
        else if (al[i].l)
            filling[i] = true;
        valve(&inlet[i], filling[i], al[i].hh || ai[i].bad, 12);
        valve(&outlet[i], !filling[i], al[i].ll, 8 + (i + 1) % 4);
        vol = tank_volume(shape[i], ai[i].pv, dia[i], len[i]);
        flow = 0.0f;
        if (inlet[i].is_open) {
            level[i] = level[i] + 0.012f;
            flow = 4.5f;
        }
        if (outlet[i].is_open) {
            level[i] = level[i] - 0.01f;
            flow = flow + 3.75f;
        }
        totalize(&tot[i], flow, 0.1f, tot[i].total > 20000);
        bits = 0;
        if (al[i].unacked) bits += 1;
        if (inlet[i].moving) bits += 2;
        if (outlet[i].is_closed) bits += 4;
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(vol * 100.0f) + (uint32_t)tot[i].total + (uint32_t)bits + (uint32_t)inlet[i].strokes);
    }
}
