#include "st.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

#define N 48
enum state { BAT_FREE, BAT_FILLING, BAT_RIPENING, BAT_RELEASED, BAT_BLOCKED };
struct lab { float fat, ph; bool ok; };
struct batch { int32_t id; enum state state; int16_t tank, age; float volume, temp; struct lab lab; };
struct stat { int16_t count[5]; float volume, min_ph, max_ph, mean_fat; };

static struct batch batches[N], sorted[N];
static struct stat stat;
static uint32_t rnd = 4711;
static int32_t next_id = 1000;
static bool init;

static bool update(struct batch *b, int32_t new_id, uint32_t noise)
{
    bool used = false;
    b->age++;
    switch (b->state) {
    case BAT_FREE:
        if (noise % 4 == 0) {
            b->state = BAT_FILLING;
            b->id = new_id;
            b->age = 0;
            b->volume = 0.0f;
            b->temp = 6.0f;
            b->lab.fat = 3.0f + (float)(noise % 100) * 0.01f;
            b->lab.ph = 6.7f;
            b->lab.ok = false;
            used = true;
        }
        break;
    case BAT_FILLING:
        b->volume = b->volume + 250.0f + (float)(noise % 64);
        if (b->volume > 5000.0f)
            b->state = BAT_RIPENING;
        break;
    case BAT_RIPENING:
        b->temp += (42.0f - b->temp) * 0.1f;
        b->lab.ph -= b->temp * 0.001f;
        if (b->lab.ph < 4.6f) {
            b->lab.ok = b->lab.fat > 3.2f;
            b->state = b->lab.ok ? BAT_RELEASED : BAT_BLOCKED;
        }
        break;
    case BAT_RELEASED:
        b->volume -= 300.0f;
        if (b->volume <= 0.0f) {
            b->volume = 0.0f;
            b->state = BAT_FREE;
        }
        break;
    case BAT_BLOCKED:
        if (b->age > 120)
            b->state = BAT_FREE;
        break;
    }
    return used;
}

static void sort(struct batch *b)
{
    for (int i = 1; i < N; i++) {
        struct batch tmp = b[i];
        int k = i - 1;
        while (k >= 0 && b[k].volume < tmp.volume) {
            b[k + 1] = b[k];
            k--;
        }
        b[k + 1] = tmp;
    }
}

static void statistics(const struct batch *b, struct stat *s)
{
    float fat = 0.0f;
    memset(s->count, 0, sizeof s->count);
    s->volume = 0.0f;
    s->min_ph = 14.0f;
    s->max_ph = 0.0f;
    for (int i = 0; i < N; i++) {
        s->count[b[i].state]++;
        s->volume += b[i].volume;
        if (b[i].lab.ph < s->min_ph) s->min_ph = b[i].lab.ph;
        if (b[i].lab.ph > s->max_ph) s->max_ph = b[i].lab.ph;
        fat += b[i].lab.fat;
    }
    s->mean_fat = fat / 48.0f;
}

static const struct batch *find(const struct batch *b, int32_t id)
{
    for (int i = 0; i < N; i++)
        if (b[i].id == id)
            return &b[i];
    return NULL;
}

void scan(void)
{
    if (!init) {
        for (int i = 0; i < N; i++)
            batches[i].tank = (int16_t)(101 + i);
        init = true;
    }
    for (int i = 0; i < N; i++) {
        rnd = rnd * 1664525u + 1013904223u;
        if (update(&batches[i], next_id, rnd / 65536))
            next_id++;
    }
    memcpy(sorted, batches, sizeof sorted);
    sort(sorted);
    statistics(sorted, &stat);

    uint32_t sum = (uint32_t)check;
    const struct batch *b = find(sorted, next_id - 20);
    if (b)
        sum += (uint32_t)(b->tank * 3 + b->age);
    sum = sum * 31u + (uint32_t)lrintf(stat.volume) + (uint32_t)lrintf(stat.min_ph * 1000.0f)
        + (uint32_t)lrintf(stat.max_ph * 1000.0f) + (uint32_t)lrintf(stat.mean_fat * 1000.0f);
    for (int i = 0; i < 5; i++)
        sum = sum * 3u + (uint32_t)stat.count[i];
    sum += (uint32_t)sorted[0].id + (uint32_t)sorted[23].tank;
    check = (int32_t)sum;
}
