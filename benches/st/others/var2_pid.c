#include <stdbool.h>
#include "st.h"
typedef struct {
    int32_t sp, pv, out, acc, last_pv;
    int16_t kp, ki, kd;
    bool auto_on, hi_alarm, lo_alarm;
} loop_t;
static int32_t clamp(int32_t x, int32_t lo, int32_t hi)
{
    if (x < lo) return lo;
    if (x > hi) return hi;
    return x;
}
static void pid_step(loop_t *d)
{
    int32_t err = clamp(d->sp - d->pv, -20000, 20000);
    if (d->auto_on) {
        d->acc = clamp(d->acc + err * d->ki, -50000000, 50000000);
        int32_t p = err * d->kp / 100;
        int32_t dd = (d->last_pv - d->pv) * d->kd / 10;
        d->out = clamp(p + d->acc / 1000 + dd, 0, 50000);
    } else {
        d->acc = d->out * 1000;
    }
    d->hi_alarm = err < -3000;
    d->lo_alarm = err > 3000;
    d->last_pv = d->pv;
}
static loop_t loops[64];
static bool first = true;
static int32_t t;
void scan(void)
{
    if (first) {
        for (int i = 1; i <= 64; i++) {
            loop_t *l = &loops[i - 1];
            l->sp = 10000 + 400 * i;
            l->pv = 5000;
            l->kp = (int16_t)(60 + i % 9 * 5);
            l->ki = (int16_t)(8 + i % 5);
            l->kd = (int16_t)(i % 4);
            l->auto_on = true;
        }
        first = false;
    }
    t++;
    if (t == 500) {
        for (int i = 1; i <= 64; i++) {
            loop_t *l = &loops[i - 1];
            l->sp = 45000 - l->sp;
            l->auto_on = !l->auto_on || i % 3 != 0;
        }
        t = 0;
    }
    int32_t sum = 0;
    for (int i = 1; i <= 64; i++) {
        loop_t *l = &loops[i - 1];
        pid_step(l);
        l->pv = l->pv + (l->out - l->pv) / 24;
        sum += l->pv;
        if (l->hi_alarm || l->lo_alarm)
            sum += i;
    }
    check = (check % 100003) * 3 + sum;
}
