#include "st.h"
#include <stdbool.h>
static int round_even(float x) { x += 12582912.0f; x -= 12582912.0f; return (int)x; }
struct pid { float kp, ki, kd, y, old, i, d; };
static struct pid loop[64];
static float pv[64];
static int scans;
static void pid(struct pid *p, float sp, float pv, bool automatic, float man) {
    float e = sp - pv;
    if (automatic) {
        p->i = p->i + p->ki * e * 0.01f;
        if (p->i > 100.0f) p->i = 100.0f;
        if (p->i < 0.0f) p->i = 0.0f;
        p->d = p->d + 0.2f * ((e - p->old) * p->kd / 0.01f - p->d);
        p->y = p->kp * e + p->i + p->d;
        if (p->y > 100.0f) p->y = 100.0f;
        if (p->y < 0.0f) p->y = 0.0f;
    } else {
        p->y = man;
        p->i = man - p->kp * e;
        p->d = 0.0f;
    }
    p->old = e;
}
void scan(void) {
    if (scans == 0)
        for (int i = 0; i < 64; i++) { loop[i].kp = 1.5f; loop[i].ki = 0.8f; loop[i].kd = 0.02f; }
    scans++;
    float sp = scans % 400 < 200 ? 60.0f : 30.0f, sum = 0;
    for (int i = 0; i < 64; i++) {
        pid(&loop[i], sp + i * 0.2f, pv[i], (scans + i * 10) % 1000 > 50, 40.0f);
        pv[i] = pv[i] + (loop[i].y - pv[i]) * 0.02f;
        sum = sum + pv[i] + loop[i].y;
    }
    check = (check + round_even(sum)) % 1000000;
}
