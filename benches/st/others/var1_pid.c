#include <stdbool.h>
#include "st.h"
typedef struct { float y; bool sat; float integral, e_old, d_f; } pid_t_;
static float limit(float mn, float x, float mx) { return x < mn ? mn : x > mx ? mx : x; }
static void pid(pid_t_ *c, float sp, float pv, float kp, float ti, float td,
                float ymin, float ymax, bool manual, float yman)
{
    float e = sp - pv;
    if (manual) {
        c->y = limit(ymin, yman, ymax);
        c->integral = c->y - kp * e;
        c->sat = false;
    } else {
        float p = kp * e;
        float d = td * (e - c->e_old) / 0.1f;
        c->d_f = c->d_f + 0.2f * (d - c->d_f);
        float u = p + c->integral + kp * c->d_f;
        c->sat = u > ymax || u < ymin;
        if (!c->sat && ti > 0.0f)
            c->integral = c->integral + kp * e * 0.1f / ti;
        c->y = limit(ymin, u, ymax);
    }
    c->e_old = e;
}
static pid_t_ loop[64];
static float kp[64], ti[64], td[64], gain[64], tau[64], pv[64], sp[64];
static bool init;
static int32_t n;
void scan(void)
{
    if (!init) {
        for (int i = 0; i < 64; i++) {
            kp[i] = 0.8f + (float)i * 0.02f;
            ti[i] = 4.0f + (float)(i % 7);
            td[i] = 0.1f * (float)(i % 3);
            gain[i] = 0.9f + 0.01f * (float)(i % 11);
            tau[i] = 0.02f + 0.002f * (float)(i % 5);
            sp[i] = 20.0f + (float)i;
        }
        init = true;
    }
    n++;
    if (n >= 600) {
        n = 0;
        for (int i = 0; i < 64; i++)
            sp[i] = 100.0f - sp[i];
    }
    float sum = 0.0f;
    for (int i = 0; i < 64; i++) {
        pid(&loop[i], sp[i], pv[i], kp[i], ti[i], td[i], 0.0f, 100.0f, n < 20 && i % 8 == 0, 30.0f);
        pv[i] = pv[i] + tau[i] * (gain[i] * loop[i].y - pv[i]);
        sum += pv[i];
        if (loop[i].sat)
            sum += 1.0f;
    }
    check = (check % 100003) * 3 + (int32_t)(sum * 10.0f);
}
