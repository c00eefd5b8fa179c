#include "timers.h"

typedef struct {
    bool coil, is_open, is_closed, fault, was_open;
    int16_t strokes;
    Timer watch;
} Valve;

typedef struct {
    float value;
    bool warning, alarmed, broken;
    Timer delay;
} Analog;

typedef struct {
    bool latch, running;
    int hours;
    Timer contact;
} Motor;

static Valve valves[80];
static Analog inputs[80];
static Motor motors[40];
static int way[80];
static int scans, seed = 5;

static inline float scale(int raw, float low, float high)
{
    return (float)raw / 27648.0f * (high - low) + low;
}

static inline bool above(float value, float bound, float gap, bool was)
{
    return value > (was ? bound - gap : bound);
}

static void valve(Valve *v, bool request, bool fb_open, bool fb_closed, bool reset)
{
    v->coil = request && !v->fault;
    v->is_open = fb_open && !fb_closed;
    v->is_closed = fb_closed && !fb_open;
    if (ton(&v->watch, v->coil ? !v->is_open : !v->is_closed, 100))
        v->fault = true;
    else if (reset)
        v->fault = false;
    if (rising(&v->was_open, v->is_open))
        v->strokes++;
}

static void analog(Analog *a, int raw)
{
    a->broken = raw < -500 || raw > 28000;
    if (!a->broken)
        a->value += (scale(raw, 0, 100) - a->value) * 0.25f;
    a->warning = above(a->value, 75, 2, a->warning);
    ton(&a->delay, above(a->value, 90, 1, a->delay.q), 30);
    a->alarmed = a->delay.q || a->broken;
}

static void motor(Motor *m, bool start, bool stop, bool trip)
{
    m->latch = !(stop || trip) && (start || m->latch);
    m->running = ton(&m->contact, m->latch, 50);
    m->hours += m->running;
}

void scan(void)
{
    now_ms = now_us / 1000;
    scans++;
    int sum = 0;
    float total = 0;
    for (int i = 0; i < 80; i++) {
        int n = i + 1, phase = (scans + n * 3) % 60;
        Valve *v = &valves[i];
        if (v->coil) {
            if (way[i] < 6 && (scans / 100 + n) % 9 != 0)
                way[i]++;
        } else if (way[i] > 0) {
            way[i]--;
        }
        valve(v, phase < 30, way[i] >= 6, way[i] == 0, phase == 59);
        if (v->is_open)
            sum += n;
        if (v->fault)
            sum += 2 * n;
        sum += v->strokes;
    }
    for (int i = 0; i < 80; i++) {
        seed = (seed * 75 + 74) % 65537;
        analog(&inputs[i], seed % 30000 / 4 + (scans * 40 + (i + 1) * 300) % 21000);
        total += inputs[i].value;
        if (inputs[i].warning)
            sum += 3;
        if (inputs[i].alarmed)
            sum += 5;
    }
    for (int i = 0; i < 40; i++) {
        motor(&motors[i], valves[i].is_open, valves[i + 40].is_closed && inputs[i].warning, inputs[i + 40].alarmed);
        if (motors[i].running)
            sum += 7;
        sum += motors[i].hours;
    }
    check = (check * 31 + sum + (int)total) % 1000003;
}
