#include <stdbool.h>
#include "st.h"

enum mode { OFF, HAND, AUTO };

typedef struct {
    enum mode mode;
    float setpoint, ramped, actual, hand;
    float gain, ki, kd;
    float e1, slope, pv1;
    float u, u_min, u_max;
    bool saturated;
} Loop;

typedef struct {
    float x, gain, rate;
    int noise;
} Plant;

static Loop controls[8][8];
static Plant plants[8][8];
static int scans;

static inline float limit(float low, float x, float high)
{
    return x < low ? low : x > high ? high : x;
}

static inline float filter(float old, float new, float share)
{
    return old + (new - old) * share;
}

static inline float ramp(float now, float goal, float pace)
{
    return now + limit(-pace, goal - now, pace);
}

static float control(Loop *c)
{
    c->ramped = ramp(c->ramped, c->setpoint, 0.75f);
    float e = c->ramped - c->actual;
    float old_slope = c->slope;
    c->slope = filter(c->slope, c->actual - c->pv1, 0.3f);
    switch (c->mode) {
    case OFF:
        c->u = 0;
        c->saturated = false;
        break;
    case HAND:
        c->u = limit(c->u_min, c->hand, c->u_max);
        c->saturated = false;
        break;
    default: {
        float change = c->gain * (e - c->e1) + c->ki * e - c->kd * (c->slope - old_slope);
        float wish = c->u + change;
        c->u = limit(c->u_min, wish, c->u_max);
        c->saturated = c->u != wish;
    }
    }
    c->e1 = e;
    c->pv1 = c->actual;
    return c->u;
}

static float simulate(Plant *p, float u)
{
    p->noise = (p->noise * 75 + 74) % 65537;
    p->x = filter(p->x, u * p->gain, p->rate);
    return p->x + (float)(p->noise % 16) * 0.01f;
}

void scan(void)
{
    if (scans == 0)
        for (int row = 0; row < 8; row++)
            for (int col = 0; col < 8; col++) {
                Loop *c = &controls[row][col];
                Plant *p = &plants[row][col];
                c->gain = 1.5f + (float)(row + 1) * 0.1f;
                c->ki = 0.05f;
                c->kd = 0.4f;
                c->u_max = 100;
                c->hand = (float)((row + 1) * (col + 1));
                p->gain = 0.9f + (float)(col + 1) * 0.02f;
                p->rate = 0.03f;
                p->noise = (row + 1) * 8 + col + 1;
            }
    scans++;
    float total = 0;
    int hits = 0, n = 0;
    for (int row = 0; row < 8; row++)
        for (int col = 0; col < 8; col++) {
            Loop *c = &controls[row][col];
            n++;
            c->setpoint = (scans + n * 9) % 300 > 150 ? 80.0f : 20.0f;
            if ((scans + n) % 250 < 20)
                c->mode = HAND;
            else if ((scans + n) % 500 == 499)
                c->mode = OFF;
            else
                c->mode = AUTO;
            float u = control(c);
            c->actual = simulate(&plants[row][col], u);
            total = total + c->actual + u;
            if (c->saturated)
                hits += n;
        }
    check = (check * 31 + (int)(total * 8.0f) + hits) % 1000003;
}
