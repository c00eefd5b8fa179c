/* 200 function block calls (50 channels of 4 blocks) with helper functions */
#include "st.h"
#include <stdbool.h>

typedef enum { IDLE, STARTING, RUNNING, STOPPING, FAULTED } motor_state_t;

#define N_CH 50
#define LEN_BUF 8

static int16_t triangle(int32_t phase)
{
    int32_t d = phase % 400;
    if (d < 200)
        return (int16_t)(d * 130);
    return (int16_t)((400 - d) * 130);
}

static float scale(int16_t raw, float low, float high)
{
    return (float)raw / 27648.0f * (high - low) + low;
}

static int16_t limit_int(int16_t min, int16_t in, int16_t max)
{
    if (in < min)
        return min;
    if (in > max)
        return max;
    return in;
}

typedef struct {
    int16_t out;
    int16_t buf[LEN_BUF];
    int16_t pos;
    int32_t sum;
} mov_avg_t;

static void mov_avg(mov_avg_t *f, int16_t in)
{
    f->sum = f->sum - f->buf[f->pos] + in;
    f->buf[f->pos] = in;
    f->pos++;
    if (f->pos >= LEN_BUF)
        f->pos = 0;
    f->out = (int16_t)(f->sum / 8);
}

typedef struct {
    float out;
    bool busy;
} ramp_t;

static void ramp_step(ramp_t *r, float in, float step)
{
    if (r->out + step < in) {
        r->out = r->out + step;
        r->busy = true;
    } else if (r->out - step > in) {
        r->out = r->out - step;
        r->busy = true;
    } else {
        r->out = in;
        r->busy = false;
    }
}

typedef struct {
    bool out;
    int16_t switches;
} hyst_t;

static void hysteresis(hyst_t *h, float in, float high, float low)
{
    if (h->out) {
        if (in < low)
            h->out = false;
    } else if (in > high) {
        h->out = true;
        h->switches = limit_int(0, (int16_t)(h->switches + 1), 10000);
    }
}

typedef struct {
    motor_state_t state;
    bool on;
    int32_t hours;
    int16_t tick;
} motor_t;

static void motor_step(motor_t *m, bool cmd, bool trip, int16_t ramp_time)
{
    if (trip)
        m->state = FAULTED;
    switch (m->state) {
    case IDLE:
        if (cmd) {
            m->state = STARTING;
            m->tick = 0;
        }
        break;
    case STARTING:
        m->tick++;
        if (!cmd)
            m->state = IDLE;
        else if (m->tick >= ramp_time)
            m->state = RUNNING;
        break;
    case RUNNING:
        m->hours++;
        if (!cmd) {
            m->state = STOPPING;
            m->tick = ramp_time;
        }
        break;
    case STOPPING:
        m->tick--;
        if (m->tick <= 0)
            m->state = IDLE;
        break;
    case FAULTED:
        if (!cmd && !trip)
            m->state = IDLE;
        break;
    }
    m->on = m->state == STARTING || m->state == RUNNING;
}

static int32_t scan_no;
static mov_avg_t avg[N_CH];
static ramp_t ramp[N_CH];
static hyst_t hyst[N_CH];
static motor_t motor[N_CH];

void scan(void)
{
    int i;
    int16_t raw;
    float value;
    int32_t sum = 0;

    scan_no = (scan_no + 1) % 100000;
    for (i = 0; i < N_CH; i++) {
        raw = limit_int(500, triangle(scan_no + i * 17), 25000);
        mov_avg(&avg[i], raw);
        value = scale(avg[i].out, 0.0f, 150.0f);
        ramp_step(&ramp[i], value, 0.6f + (float)i * 0.01f);
        hysteresis(&hyst[i], ramp[i].out, 90.0f, 45.0f);
        motor_step(&motor[i], hyst[i].out, (scan_no + i) % 501 == 0, 20);
        if (motor[i].on)
            sum += 1;
        if (motor[i].state == FAULTED)
            sum += 50;
        sum += motor[i].hours % 1000 + hyst[i].switches + (int32_t)ramp[i].out;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
