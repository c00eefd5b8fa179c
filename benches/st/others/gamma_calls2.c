/* Packaging machine motion: virtual master, 20 cam slaves, 20 positioning axes */
#include <stdbool.h>
#include <math.h>
#include "st.h"

typedef struct {
    float pos, vel, target;
    bool in_pos;
    int16_t state;
    int32_t moves;
} AxisRef;

typedef struct {
    int16_t points;
    float x[9];
    float y[9];
} Cam;

static float limit_sym(float in, float max)
{
    if (in > max) return max;
    if (in < -max) return -max;
    return in;
}

static float modulo360(float a)
{
    while (a >= 360.0f) a -= 360.0f;
    while (a < 0.0f) a += 360.0f;
    return a;
}

static float cam_value(const Cam *c, float x)
{
    int16_t i = 1;
    while (i < c->points - 1 && x > c->x[i])
        i++;
    return c->y[i - 1] + (x - c->x[i - 1]) * (c->y[i] - c->y[i - 1]) / (c->x[i] - c->x[i - 1]);
}

typedef struct { bool done; float dist, brake, vset; } Move;

static void move(Move *m, AxisRef *ax, bool start, float vmax, float amax, float dt)
{
    m->done = false;
    switch (ax->state) {
    case 0:
        ax->vel = 0.0f;
        if (start) {
            ax->state = 1;
            ax->in_pos = false;
            ax->moves++;
        }
        break;
    case 1:
        m->dist = ax->target - ax->pos;
        m->brake = ax->vel * ax->vel / (2.0f * amax);
        if (fabsf(m->dist) <= m->brake)
            m->vset = 0.0f;
        else if (m->dist > 0.0f)
            m->vset = vmax;
        else
            m->vset = -vmax;
        ax->vel = ax->vel + limit_sym(m->vset - ax->vel, amax * dt);
        ax->pos = ax->pos + ax->vel * dt;
        if (fabsf(m->dist) < 0.5f && fabsf(ax->vel) < 2.0f * amax * dt) {
            ax->pos = ax->target;
            ax->state = 2;
        }
        break;
    case 2:
        ax->in_pos = true;
        ax->state = 0;
        m->done = true;
        break;
    }
}

typedef struct { float slave; } Gear;

static void gear(Gear *g, float master, int16_t num, int16_t den, float phase)
{
    g->slave = modulo360(master * num / den + phase);
}

typedef struct { float out; } Pt1;

static void pt1(Pt1 *p, float in, float k)
{
    p->out = p->out + (in - p->out) * k;
}

typedef struct { bool warn; float max; int16_t count; } LagMonitor;

static void lag_monitor(LagMonitor *l, float set, float act, float limit)
{
    float lag = fabsf(set - act);
    if (lag > l->max)
        l->max = lag;
    if (lag > limit) {
        if (!l->warn) {
            l->count++;
            if (l->count > 9999)
                l->count = 0;
        }
        l->warn = true;
    } else if (lag < limit * 0.8f) {
        l->warn = false;
    }
}

static bool init;
static float master;
static Cam cam_a = { 6, { 0, 60, 120, 200, 280, 360 }, { 0, 10, 85, 100, 40, 0 } };
static Cam cam_b = { 9, { 0, 30, 70, 110, 150, 190, 250, 310, 360 },
                     { 0, 5, 20, 60, 60, 60, 35, 10, 0 } };
static Gear gears[20];
static Pt1 filt[20];
static LagMonitor lag[20];
static AxisRef axes[20];
static Move moves[20];
static Pt1 ax_filt[20];
static LagMonitor ax_lag[20];

void scan(void)
{
    if (!init) {
        for (int i = 0; i < 20; i++)
            axes[i].target = 100.0f + 7.5f * i;
        init = true;
    }

    master = modulo360(master + 3.7f);
    int32_t warn = 0, done = 0;
    float sum = 0.0f;

    for (int i = 0; i < 20; i++) {
        float cam;
        gear(&gears[i], master, i % 3 + 1, i % 2 + 1, 12.0f * i);
        if (i < 10)
            cam = cam_value(&cam_a, gears[i].slave);
        else
            cam = cam_value(&cam_b, gears[i].slave);
        pt1(&filt[i], cam, 0.4f);
        lag_monitor(&lag[i], cam, filt[i].out, 8.0f);
        if (lag[i].warn)
            warn++;
        sum += filt[i].out;
    }

    for (int i = 0; i < 20; i++) {
        AxisRef *ax = &axes[i];
        move(&moves[i], ax, !ax->in_pos || master < 90.0f, 400.0f + 10.0f * i, 5000.0f, 0.002f);
        if (moves[i].done) {
            done++;
            if (ax->target > 150.0f)
                ax->target = 20.0f + i;
            else
                ax->target = 250.0f - 3.0f * i;
        }
        pt1(&ax_filt[i], ax->pos, 0.5f);
        lag_monitor(&ax_lag[i], ax->pos, ax_filt[i].out, 0.6f);
        if (ax_lag[i].warn)
            warn += 100;
        sum += limit_sym(ax->vel, 300.0f);
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)((int32_t)(sum * 8.0f) + warn + done * 7 + axes[3].moves));
}
