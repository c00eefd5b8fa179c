/* Calls: four kinds of stateful blocks, 50 instances each, all of which call
   functions, and a loop of 500 calls of functions. */
#include <stdbool.h>
#include "st.h"

typedef enum { NORMAL, PENDING, ACTIVE, ACKNOWLEDGED } AlarmState;

static int32_t clamp(int32_t value, int32_t low, int32_t high)
{
    if (value < low)
        return low;
    if (value > high)
        return high;
    return value;
}

static int32_t distance(int32_t a, int32_t b)
{
    return a >= b ? a - b : b - a;
}

static bool in_range(int32_t value, int32_t low, int32_t high)
{
    return value >= low && value <= high;
}

static int32_t median(int32_t a, int32_t b, int32_t c)
{
    int32_t smaller, larger;
    if (a < b) {
        smaller = a;
        larger = b;
    } else {
        smaller = b;
        larger = a;
    }
    return clamp(c, smaller, larger);
}

typedef struct {
    int32_t actual;
} RateLimiter;

static void rate_limiter(RateLimiter *r, int32_t target, int32_t max_step)
{
    r->actual += clamp(target - r->actual, -max_step, max_step);
}

typedef struct {
    int32_t average;
    int32_t history[8];
    int16_t position;
    int32_t total;
} MovingAverage;

static void moving_average(MovingAverage *m, int32_t sample)
{
    int32_t usable = clamp(sample, -1000, 1000);
    m->total += usable - m->history[m->position];
    m->history[m->position] = usable;
    m->position = (m->position + 1) % 8;
    m->average = m->total / 8;
}

typedef struct {
    AlarmState state;
    int32_t count;
    int16_t patience;
} Alarm;

static void alarm_step(Alarm *a, int32_t value, int32_t low, int32_t high, bool acknowledge)
{
    bool healthy = in_range(value, low, high);
    switch (a->state) {
    case NORMAL:
        if (!healthy) {
            a->state = PENDING;
            a->patience = 3;
        }
        break;
    case PENDING:
        a->patience--;
        if (healthy) {
            a->state = NORMAL;
        } else if (a->patience == 0) {
            a->state = ACTIVE;
            a->count++;
        }
        break;
    case ACTIVE:
        if (acknowledge)
            a->state = ACKNOWLEDGED;
        break;
    case ACKNOWLEDGED:
        if (healthy)
            a->state = NORMAL;
        break;
    }
}

typedef struct {
    int32_t middle;
    int32_t largest;
} Spread;

static void spread_step(Spread *s, int32_t first, int32_t second, int32_t third)
{
    s->middle = median(first, second, third);
    int32_t spread = distance(first, second) + distance(second, third);
    if (spread > s->largest)
        s->largest = spread;
    else
        s->largest--;
}

static RateLimiter limiter[50];
static MovingAverage average[50];
static Alarm alarms[50];
static Spread spread[50];
static int32_t scan_count;

void scan(void)
{
    scan_count++;
    int32_t sum = 0;

    /* 200 calls of blocks */
    for (int32_t i = 0; i < 50; i++) {
        int32_t signal = (scan_count * 37 + i * i * 11) % 2400 - 1200;
        rate_limiter(&limiter[i], signal, 20 + i);
        moving_average(&average[i], signal + limiter[i].actual);
        alarm_step(&alarms[i], average[i].average, -300 - 4 * i, 200 + 4 * i,
                   (scan_count + i) % 16 == 0);
        spread_step(&spread[i], signal, limiter[i].actual, average[i].average);

        sum += spread[i].middle + spread[i].largest + alarms[i].count;
        if (alarms[i].state == ACTIVE)
            sum += i;
    }

    /* 500 calls of a function */
    int32_t level = scan_count % 100;
    for (int32_t i = 0; i < 500; i++) {
        level = median(level + i % 7, scan_count % 500, 3 * i - level);
        sum += level;
    }

    check = (check * 31 + sum) % 1000003;
}
