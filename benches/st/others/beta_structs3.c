#include "st.h"
#include <stdbool.h>

typedef struct {
    int32_t code;
    int16_t source;
    int16_t severity;
    float value;
    int32_t stamp;
} Event;

typedef struct {
    int16_t head, tail, count;
    int32_t lost;
    Event items[32];
} Ring;

typedef struct {
    int32_t code;
    int16_t severity;
    int32_t hits;
    int32_t last_stamp;
    float max_value;
} AlarmDef;

static bool push(Event e, Ring *r)
{
    if (r->count >= 32) {
        r->lost++;
        return false;
    }
    r->items[r->head] = e;
    r->head = (r->head + 1) % 32;
    r->count++;
    return true;
}

static bool pop(Ring *r, Event *e)
{
    if (r->count == 0)
        return false;
    *e = r->items[r->tail];
    r->tail = (r->tail + 1) % 32;
    r->count--;
    return true;
}

static int16_t find_alarm(int32_t code, const AlarmDef table[64])
{
    int16_t lo = 0, hi = 63;
    while (lo <= hi) {
        int16_t mid = (lo + hi) / 2;
        if (table[mid].code == code)
            return mid;
        else if (table[mid].code < code)
            lo = mid + 1;
        else
            hi = mid - 1;
    }
    return -1;
}

static bool ready;
static uint32_t seed = 77;
static int32_t now;
static Ring rings[4];
static AlarmDef table[64];
static Event ev;
static int32_t unknown;

void scan(void)
{
    if (!ready) {
        ready = true;
        for (int i = 0; i <= 63; i++) {
            table[i].code = i * 13 + 100;
            table[i].severity = i % 4;
        }
    }
    now++;
    if (now > 1000000)
        now = 1;
    int32_t sum = 0;

    /* produce */
    for (int i = 1; i <= 64; i++) {
        seed = seed * 1664525u + 1013904223u;
        ev.code = 100 + (int32_t)((seed / 65536u) % 64u) * 13;
        if (i % 16 == 0)
            ev.code++;
        ev.source = i;
        ev.value = (float)((seed / 4096u) % 1000u) * 0.25f;
        ev.stamp = now;
        int k = (seed / 16777216u) % 4u;
        if (!push(ev, &rings[k]))
            sum++;
    }

    /* consume, up to 18 of each ring */
    for (int k = 0; k <= 3; k++) {
        int n = 0;
        while (n < 18) {
            if (!pop(&rings[k], &ev))
                break;
            n++;
            int16_t idx = find_alarm(ev.code, table);
            if (idx < 0) {
                unknown++;
            } else {
                ev.severity = table[idx].severity;
                table[idx].hits++;
                table[idx].last_stamp = ev.stamp;
                if (ev.value > table[idx].max_value)
                    table[idx].max_value = ev.value;
                else
                    table[idx].max_value *= 0.999f;
                sum += ev.severity * 10 + idx;
            }
        }
        sum += rings[k].count + rings[k].lost % 1000;
    }
    int idx = now % 64;
    sum += table[idx].hits + (int32_t)table[idx].max_value + table[idx].last_stamp;
    check = (int32_t)((uint32_t)check * 3u + (uint32_t)sum + (uint32_t)unknown);
}
