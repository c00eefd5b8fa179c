#include <emmintrin.h>
#include "st.h"
typedef double T;
#define ROUND(x) _mm_cvtsd_si32(_mm_set_sd(x))
struct tuning { T kp, ti, td, low, high; };
struct controller { T setpoint, actual, cycle, y, integral, last; uint8_t manual, limited; };
static struct controller c[32];
static struct tuning t[32];
static T level[32];
static int32_t scans;
static void run(struct controller *c, struct tuning *t)
{
    T e = c->setpoint - c->actual;
    if (c->manual) { c->integral = c->y; return; }
    if (!c->limited) c->integral += t->kp * e * c->cycle / t->ti;
    T d = t->kp * t->td * (e - c->last) / c->cycle;
    c->last = e;
    T u = t->kp * e + c->integral + d;
    c->y = u < t->low ? t->low : u > t->high ? t->high : u;
    c->limited = c->y != u;
}
void scan(void)
{
    for (int i = 0; i < 32; i++) {
        if (scans == 0) { t[i] = (struct tuning){ (T)1.5, 2, (T)0.1, 0, 100 }; }
        c[i].setpoint = (T)50 + i; c[i].actual = level[i]; c[i].manual = 0; c[i].cycle = (T)0.01;
        run(&c[i], &t[i]);
        level[i] += (c[i].y - level[i]) * (T)0.02;
    }
    check += ROUND(level[5]) + ROUND(level[20]);
    scans++;
}
