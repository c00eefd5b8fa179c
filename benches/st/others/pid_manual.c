#include <math.h>
#include "st.h"
struct pid { float sp, pv, kp, ti, td, dt, yman, y, isum, last, d; uint8_t manual, high, low; };
static struct pid loops[65];
static float pv[65];
static int32_t scans;
static void pid(struct pid *p)
{
    float e = p->sp - p->pv;
    if (p->manual) {
        p->y = p->yman;
        p->isum = p->yman - p->kp * e;
    } else {
        p->isum = p->isum + p->kp * e * p->dt / p->ti;
        p->d = p->d + (p->td * (e - p->last) / p->dt - p->d) * 0.2f;
        float u = p->kp * e + p->isum + p->d;
        p->y = u < 0 ? 0 : u > 100 ? 100 : u;
        p->high = u > 100;
        p->low = u < 0;
        if (p->high | p->low)
            p->isum = p->y - p->kp * e - p->d;
    }
    p->last = e;
}
void scan(void)
{
    for (int i = 1; i <= 64; i++) {
        struct pid *p = &loops[i];
        p->sp = 50.0f + (float)i / 4.0f;
        p->pv = pv[i];
        p->kp = 2;
        p->ti = 5;
        p->td = 0.1f;
        p->dt = 0.01f;
        p->manual = (scans + i) % 100 == 0;
        p->yman = 30;
        pid(p);
        pv[i] = pv[i] + (p->y - pv[i]) * 0.02f;
    }
    check += (int32_t)rintf(pv[scans % 64 + 1] * 10.0f);
    scans++;
}
