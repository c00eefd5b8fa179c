#include "st.h"
#include <stdbool.h>
#include <stdint.h>

enum { TANKS = 34 };
typedef enum { NORMAL, RAISED, ACKED, GONE } alarm_state;
typedef struct { int64_t start; bool run, q; } ton_t;
typedef struct { float level; bool broken; } transmitter;
typedef struct { ton_t up, down; bool opened, closed, before; uint16_t strokes; } valve;
typedef struct { float ramp, flow; bool running; int32_t scans_run; } pump;
typedef struct { alarm_state state; uint16_t count; } alarm;
typedef struct {
    float content, level;
    bool high, filling;
    int32_t score;
    transmitter lt;
    valve inlet, outlet;
    pump pump;
    alarm overfill;
} tank;

static int64_t now;

static void ton(ton_t *t, bool in, int64_t pt)
{
    if (!in) {
        t->run = t->q = false;
        return;
    }
    if (!t->run) {
        t->run = true;
        t->start = now;
    }
    t->q = now - t->start >= pt;
}

static float clamp(float lo, float x, float hi) { return x < lo ? lo : x > hi ? hi : x; }
static float scale(int raw, float lo, float hi) { return (float)raw * (hi - lo) / 27648.0f + lo; }
static int unscale(float x, float lo, float hi)
{
    return (int)((clamp(lo, x, hi) - lo) * 27648.0f / (hi - lo));
}
static bool hyst(float x, float on, float off, bool before) { return before ? x > off : x >= on; }

static void run_transmitter(transmitter *t, int raw)
{
    t->broken = raw < 0 || raw > 27648;
    if (!t->broken)
        t->level += (scale(raw, 0.0f, 100.0f) - t->level) * 0.25f;
}

static void run_valve(valve *v, bool open, bool lock, int travel)
{
    ton(&v->up, open && !lock, travel);
    ton(&v->down, !open || lock, travel);
    v->opened = v->up.q;
    v->closed = v->down.q;
    if (v->before && !v->opened)
        v->strokes++;
    v->before = v->opened;
}

static void run_pump(pump *p, bool demand, float speed)
{
    if (demand) {
        p->ramp = p->ramp + 5.0f < speed ? p->ramp + 5.0f : speed;
        p->scans_run++;
    } else {
        p->ramp = p->ramp - 8.0f > 0.0f ? p->ramp - 8.0f : 0.0f;
    }
    p->running = p->ramp > 1.0f;
    p->flow = p->running ? p->ramp * 0.02f : 0.0f;
}

static void run_alarm(alarm *a, bool active, bool ack)
{
    switch (a->state) {
    case NORMAL:
        if (active) {
            a->state = RAISED;
            a->count++;
        }
        break;
    case RAISED:
        if (ack)
            a->state = ACKED;
        else if (!active)
            a->state = GONE;
        break;
    case ACKED:
        if (!active)
            a->state = NORMAL;
        break;
    case GONE:
        if (ack)
            a->state = NORMAL;
        else if (active)
            a->state = RAISED;
        break;
    }
}

static void run_tank(tank *t, bool draw, bool ack, float wish)
{
    run_transmitter(&t->lt, unscale(t->content, 0.0f, 100.0f));
    t->level = t->lt.level;
    t->filling = !hyst(t->level, wish, wish - 15.0f, !t->filling);
    t->high = hyst(t->level, wish - 2.0f, wish - 6.0f, t->high);
    run_valve(&t->inlet, t->filling, t->lt.broken, 80);
    run_valve(&t->outlet, draw, t->level < 5.0f, 50);
    run_pump(&t->pump, t->inlet.opened, 60.0f + wish * 0.25f);
    if (t->outlet.opened)
        t->content -= 0.9f;
    t->content = clamp(0.0f, t->content + t->pump.flow, 100.0f);
    run_alarm(&t->overfill, t->high, ack);
    t->score = t->pump.scans_run + t->inlet.strokes * 3 + t->outlet.strokes + t->overfill.count;
    if (t->overfill.state == RAISED)
        t->score += 7;
}

static tank tanks[TANKS];
static int32_t scans;

void scan(void)
{
    now = now_us / 1000;
    if (scans == 0)
        for (int i = 0; i < TANKS; i++) {
            tanks[i].content = 50.0f;
            /* an F_TRIG of the standard sees an edge at its first call */
            tanks[i].inlet.before = tanks[i].outlet.before = true;
        }
    scans++;
    int32_t n = 0;
    float total = 0.0f;
    for (int i = 1; i <= TANKS; i++) {
        tank *t = &tanks[i - 1];
        run_tank(t, (scans + i * 13) % 120 < 55, (scans + i) % 64 == 0, 50.0f + (float)i);
        n += t->score;
        total += t->level;
    }
    check = (check + n + (int32_t)total) % 1000000;
}
