#include "st.h"
#include <stdbool.h>
#define LOOPS 64
typedef struct { float last_error, integral, output; bool saturated; } pid_ctl;
static pid_ctl ctl[LOOPS];
static float process[LOOPS];
static int scans;

static inline float limit(float lo, float x, float hi) { return x < lo ? lo : x > hi ? hi : x; }

static void pid_step(pid_ctl *p, float sp, float pv, float gain, float ti, float td, float cycle) {
    float error = sp - pv;
    float derivative = (error - p->last_error) / cycle;
    p->last_error = error;
    float u = gain * (error + p->integral / ti + td * derivative);
    p->output = limit(0.0f, u, 100.0f);
    p->saturated = p->output != u;
    if (!p->saturated) p->integral += error * cycle;
}

void scan(void) {
    scans++;
    int limited = 0;
    float sum = 0.0f;
    for (int i = 0; i < LOOPS; i++) {
        float sp = (scans / 200) % 2 == 0 ? 20.0f + (float)(i + 1) : 80.0f - (float)(i + 1);
        pid_step(&ctl[i], sp, process[i], 2.0f, 0.5f, 0.01f, 0.01f);
        process[i] = process[i] + (ctl[i].output - process[i]) * 0.01f / 0.8f;
        sum += process[i];
        limited += ctl[i].saturated;
    }
    check = (check + (int)sum + limited) % 1000003;
}
