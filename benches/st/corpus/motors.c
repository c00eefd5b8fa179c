#include <math.h>
#include "st.h"
struct item { int16_t id; float weight; uint8_t ok; };
struct motor { uint8_t start, stop, fault, run; int16_t speed, state, cnt, ramp; };
static struct motor m[200];
static struct item it[200];
static int32_t scans;
static float scale(int16_t x, float lo, float hi)
{
    return lo + (float)x * (hi - lo) / 27648.0f;
}
static int16_t clamp(int16_t v, int16_t mn, int16_t mx)
{
    return v < mn ? mn : v > mx ? mx : v;
}
static void motor(struct motor *m, struct item *item)
{
    switch (m->state) {
    case 0: m->run = 0; if (m->start && !m->stop) { m->state = 1; m->cnt = 0; } break;
    case 1: m->cnt++; m->ramp = clamp(m->ramp + 5, 0, m->speed); if (m->ramp >= m->speed) m->state = 2; break;
    case 2: m->run = 1; item->weight += scale(m->ramp, 0, 1); if (m->stop) m->state = 3; break;
    case 3: m->ramp = clamp(m->ramp - 10, 0, 100); m->run = m->ramp > 0; if (!m->run) m->state = 0; break;
    default: m->state = 0;
    }
    if (m->fault)
        m->state = 3;
    item->ok = m->run;
    item->id++;
}
void scan(void)
{
    int32_t n = 0;
    for (int i = 0; i < 200; i++) {
        m[i].start = (scans + i) % 40 == 0;
        m[i].stop = (scans + i) % 40 == 25;
        m[i].fault = 0;
        m[i].speed = 50;
        motor(&m[i], &it[i]);
        if (m[i].run)
            n += m[i].state;
    }
    check += n + (int32_t)rintf(it[5].weight);
    scans++;
}
