#include <stdbool.h>
#include "st.h"

static int32_t scale(int32_t x, int32_t gain, int32_t offs)
{
    int32_t y = x * gain / 100 + offs;
    if (y > 5000) y = 5000 - (y - 5000) % 777;
    else if (y < -5000) y = -5000 - (y + 5000) % 555;
    return y;
}

typedef struct { int32_t pos, vel; bool in_pos; } Axis;
typedef struct { int32_t flow, total, idle; } Meter;

static void axis(Axis *a, int32_t target, int32_t gain)
{
    a->vel = a->vel / 2 + (target - a->pos) / 4;
    a->pos = scale(a->pos + a->vel, gain, 3);
    a->in_pos = a->pos > target - 20 && a->pos < target + 20;
}

static void meter(Meter *m, bool pulse, int32_t raw)
{
    if (pulse) {
        m->total = (m->total + scale(raw, 40, 100)) % 20000;
        m->idle = 0;
    } else {
        m->idle++;
    }
    m->flow = scale(m->flow + m->total, 60, -m->idle);
}

static int32_t n;
static Axis axes[100];
static Meter meters[100];
static int32_t tab[500];

void scan(void)
{
    int32_t acc = 0;
    for (int i = 0; i < 100; i++) {
        axis(&axes[i], (n / 16 * 577 + i * 31) % 4000, 90 + i % 10);
        meter(&meters[i], axes[i].in_pos || (n + i) % 3 == 0, axes[i].pos + i);
        acc = meters[i].flow + axes[i].pos - acc;
    }
    for (int i = 0; i < 500; i++) {
        tab[i] = scale(tab[i] + n % 100, 103, i);
        acc = tab[i] - acc;
    }

    n++;
    check = (check * 31 + acc) % 1000003;
}
