#include <stdbool.h>
#include "st.h"
typedef struct { float value, offset, gain; bool valid; int16_t errors; } sensor_t;
typedef struct { float low, high, mean; int16_t n; } stats_t;
typedef struct { sensor_t sensor[8]; stats_t stat; int16_t state; } station_t;
typedef struct { station_t station[10]; stats_t stat; int16_t worst; } line_t;
static void update_line(line_t *ln, int16_t tick)
{
    stats_t total = { 1.0e6f, -1.0e6f, 0.0f, 0 };
    float widest = -1.0f;
    for (int16_t i = 0; i < 10; i++) {
        station_t *st = &ln->station[i];
        float sum = 0.0f;
        st->stat.low = 1.0e6f;
        st->stat.high = -1.0e6f;
        st->stat.n = 0;
        for (int16_t k = 0; k < 8; k++) {
            sensor_t *se = &st->sensor[k];
            se->valid = (tick + i * 3 + k * 5) % 23 != 0;
            if (se->valid) {
                se->value = se->value * 0.75f + (float)((tick * 7 + i * 13 + k * 29) % 101);
                float x = se->value * se->gain + se->offset;
                sum += x;
                if (x < st->stat.low)
                    st->stat.low = x;
                if (x > st->stat.high)
                    st->stat.high = x;
                st->stat.n++;
            } else {
                se->errors = (int16_t)((se->errors + 1) % 1000);
            }
        }
        if (st->stat.n > 0)
            st->stat.mean = sum / (float)st->stat.n;
        float spread = st->stat.high - st->stat.low;
        if (spread > 300.0f)
            st->state = 2;
        else if (spread > 200.0f)
            st->state = 1;
        else
            st->state = 0;
        if (spread > widest) {
            widest = spread;
            ln->worst = i;
        }
        total.low = st->stat.low < total.low ? st->stat.low : total.low;
        total.high = st->stat.high > total.high ? st->stat.high : total.high;
        total.mean += sum;
        total.n = (int16_t)(total.n + st->stat.n);
    }
    total.mean = total.mean / (float)total.n;
    ln->stat = total;
}
static line_t lines[4];
static int16_t tick;
static bool ready;
void scan(void)
{
    if (!ready) {
        for (int i = 1; i <= 4; i++)
            for (int j = 0; j < 10; j++)
                for (int k = 0; k < 8; k++) {
                    lines[i - 1].station[j].sensor[k].gain = 0.9f + (float)k * 0.02f;
                    lines[i - 1].station[j].sensor[k].offset = (float)(i - j);
                }
        ready = true;
    }
    tick = (int16_t)((tick + 1) % 1000);
    int32_t s = 0;
    for (int16_t i = 1; i <= 4; i++) {
        line_t *ln = &lines[i - 1];
        update_line(ln, (int16_t)(tick + i * 17));
        s += (int32_t)(ln->stat.low * 4.0f) + (int32_t)ln->stat.high + (int32_t)(ln->stat.mean * 8.0f) + ln->worst + ln->stat.n;
        for (int16_t j = 0; j < 10; j++)
            s += ln->station[j].state * (j + 1);
    }
    check = (check % 100003) * 3 + s;
}
