#include <math.h>
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define ASSETS 40
#define QUEUE 16

enum pump_state { STANDBY, RUNNING, FAILED, MAINTENANCE };
struct asset { int16_t id; int16_t starts; enum pump_state state; int32_t hours; float power; bool alarm; };
struct event { int16_t asset_id, code; int32_t stamp; };
struct stats { int count[4]; uint32_t hours_sum; int32_t hours_max; float power_sum; int alarms; };

static uint32_t rnd = 815;
static bool ready;
static struct asset assets[ASSETS], sorted[ASSETS];
static struct { struct event buf[QUEUE]; int head, tail, fill; int16_t lost; } queue;
static int32_t cycle;

static void queue_put(const struct event *e)
{
    if (queue.fill < QUEUE) {
        queue.buf[queue.head] = *e;
        queue.head = (queue.head + 1) % QUEUE;
        queue.fill++;
    } else {
        queue.lost = (int16_t)(queue.lost + 1);
    }
}

static bool queue_get(struct event *e)
{
    if (queue.fill == 0)
        return false;
    *e = queue.buf[queue.tail];
    queue.tail = (queue.tail + 1) % QUEUE;
    queue.fill--;
    return true;
}

static int find_asset(int16_t id)
{
    for (int i = 0; i < ASSETS; i++)
        if (assets[i].id == id)
            return i;
    return -1;
}

static inline void add(uint32_t v) { check = (int32_t)((uint32_t)check * 31u + v); }

static void handle_event(const struct event *e)
{
    int pos = find_asset(e->asset_id);
    if (pos < 0)
        return;
    struct asset *a = &assets[pos];
    switch (e->code) {
    case 0: a->state = STANDBY; break;
    case 1: a->state = RUNNING; a->starts = (int16_t)(a->starts + 1); break;
    case 2: a->state = FAILED; a->alarm = true; break;
    case 3: a->state = MAINTENANCE; a->hours /= 2; break;
    default: a->alarm = false; break;
    }
    add((uint32_t)pos + (uint32_t)cycle - (uint32_t)e->stamp);
}

static void sort_by_hours(struct asset *list)
{
    for (int i = 1; i < ASSETS; i++) {
        struct asset tmp = list[i];
        int j = i - 1;
        while (j >= 0 && list[j].hours > tmp.hours) {
            list[j + 1] = list[j];
            j--;
        }
        list[j + 1] = tmp;
    }
}

void scan(void)
{
    if (!ready) {
        ready = true;
        for (int i = 0; i < ASSETS; i++) {
            assets[i].id = (int16_t)(100 + (i * 7) % 40);
            assets[i].power = 5.5f + 1.5f * (float)(i % 9);
            assets[i].hours = i * 977 % 5000;
        }
    }
    cycle = (int32_t)((uint32_t)cycle + 1u);

    for (int i = 1; i <= 4; i++) {
        rnd = rnd * 1664525u + 1013904223u;
        struct event e = {
            .asset_id = (int16_t)((rnd >> 16) % 44 + 100),
            .code = (int16_t)((rnd >> 24) % 5),
            .stamp = cycle,
        };
        queue_put(&e);
        if ((i != 4 || cycle % 8 != 0) && queue_get(&e))
            handle_event(&e);
    }

    struct stats st = {0};
    for (int i = 0; i < ASSETS; i++) {
        struct asset *a = &assets[i];
        st.count[a->state]++;
        if (a->state == RUNNING) {
            a->hours = (int32_t)((uint32_t)a->hours + 3u);
            st.power_sum += a->power;
        }
        st.hours_sum += (uint32_t)a->hours;
        if (a->hours > st.hours_max)
            st.hours_max = a->hours;
        if (a->alarm)
            st.alarms++;
    }

    memcpy(sorted, assets, sizeof sorted);
    sort_by_hours(sorted);

    for (int i = 0; i < 4; i++) {
        add((uint32_t)st.count[i]);
        add((uint32_t)(sorted[i * 10].id + sorted[i * 10].starts));
    }
    add(st.hours_sum + (uint32_t)st.hours_max + (uint32_t)(int32_t)lrintf(st.power_sum * 10.0f));
    add((uint32_t)(st.alarms + queue.fill + queue.lost));
}
