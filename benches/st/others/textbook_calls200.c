#include "st.h"
#include <stdbool.h>
#include <math.h>
#define CHANNELS 200
typedef struct { float value, min, max; bool high; } channel_t;
static channel_t ch[CHANNELS];
static int scans;

static float scale(int raw, int rmin, int rmax, float emin, float emax) {
    return emin + (float)(raw - rmin) * (emax - emin) / (float)(rmax - rmin);
}
static float dead_band(float v, float w) { return fabsf(v) < w ? 0.0f : v; }
static void limit_switch(bool *active, float v, float thr, float hys) {
    if (v > thr) *active = true;
    else if (v < thr - hys) *active = false;
}
static void channel(channel_t *c, int raw) {
    float s = dead_band(scale(raw, 0, 27648, -50.0f, 150.0f), 0.5f);
    c->value = c->value + 0.25f * (s - c->value);
    if (c->value < c->min) c->min = c->value;
    if (c->value > c->max) c->max = c->value;
    limit_switch(&c->high, c->value, 70.0f, 10.0f);
}
void scan(void) {
    if (scans == 0)
        for (int i = 0; i < CHANNELS; i++) { ch[i].min = 1000.0f; ch[i].max = -1000.0f; }
    scans++;
    int alarms = 0;
    float sum = 0.0f;
    for (int i = 0; i < CHANNELS; i++) {
        channel(&ch[i], (scans * 37 + (i + 1) * 113) % 27649);
        alarms += ch[i].high;
        sum = sum + ch[i].value + ch[i].max - ch[i].min;
    }
    check = (check + (int)sum + 3 * alarms) % 1000003;
}
