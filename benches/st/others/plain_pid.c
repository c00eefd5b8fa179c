#include <stdint.h>
#include <xmmintrin.h>
#include "st.h"

/* REAL_TO_DINT: round to nearest, even (lrintf without libm) */
static int32_t to_dint(float x) { return _mm_cvtss_si32(_mm_set_ss(x)); }

typedef struct { float err_old, integ, y; } pid_t_;

static float pid(pid_t_ *p, float sp, float pv, float kp, float tn, float tv, float dt, float ymin, float ymax)
{
    float err = sp - pv;
    p->integ += err * dt / tn;
    float deriv = (err - p->err_old) * tv / dt;
    p->y = kp * (err + p->integ + deriv);
    if (p->y > ymax) {
        p->y = ymax;
        p->integ -= err * dt / tn;
    } else if (p->y < ymin) {
        p->y = ymin;
        p->integ -= err * dt / tn;
    }
    p->err_old = err;
    return p->y;
}

static int32_t scans;
static pid_t_ loops[64];
static float pv[64];

void scan(void)
{
    scans++;
    float sum = 0;
    for (int sub = 0; sub < 5; sub++) {
        for (int i = 0; i < 64; i++) {
            float sp = scans % 200 < 100 ? 50.0f + i * 0.5f : 20.0f;
            float y = pid(&loops[i], sp, pv[i], 2.0f, 1.5f, 0.02f, 0.01f, 0.0f, 100.0f);
            pv[i] += (y - pv[i]) * 0.05f;
            sum += pv[i];
        }
    }
    check = (check + to_dint(sum * 10.0f)) % 1000000;
}
