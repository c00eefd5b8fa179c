#include <stdbool.h>
#include "st.h"

struct part {
    int32_t id;
    float weight;
    int16_t station, prio;
    bool good;
    int32_t age;
    int16_t samples[4];
};

struct station_stat {
    int16_t count, bad;
    float weight_sum;
    int32_t oldest;
};

static int32_t next_random(int32_t seed)
{
    return (seed * 1109 + 12345) % 65536;
}

struct part_list {
    int32_t seed;
    int16_t found, moves;
    int32_t result;
    struct part parts[64];
    struct station_stat stats[8];
    bool init;
};

static void part_list(struct part_list *l)
{
    struct part *parts = l->parts;
    struct station_stat *stats = l->stats;
    int32_t s = l->seed;

    if (!l->init) {
        for (int i = 0; i < 64; i++) {
            s = next_random(s);
            parts[i].id = s % 5000;
            parts[i].weight = (float)(s % 300) * 0.5f;
            parts[i].station = (int16_t)(i % 8);
            parts[i].prio = (int16_t)(s % 10);
            parts[i].good = true;
        }
        l->init = true;
    }

    for (int i = 0; i < 64; i++) {
        struct part *p = &parts[i];
        s = next_random(s);
        p->age = p->age + 1 + p->prio;
        p->samples[i % 4] = (int16_t)(s % 1000);
        p->weight = p->weight + 0.01f * (float)(p->samples[(i + 1) % 4] - 500);
        p->good = p->weight > 0.0f && p->weight < 150.0f;
        if ((s / 256) % 8 == 3) {
            p->id = s % 5000;
            p->weight = (float)(s % 300) * 0.5f;
            p->station = (int16_t)((p->station + 1) % 8);
            p->age = 0;
        }
    }

    l->moves = 0;
    for (int i = 1; i < 64; i++) {
        struct part tmp = parts[i];
        int j = i - 1;
        while (j >= 0) {
            if (parts[j].id <= tmp.id)
                break;
            parts[j + 1] = parts[j];
            j--;
            l->moves++;
        }
        parts[j + 1] = tmp;
    }

    l->found = 0;
    for (int i = 0; i < 32; i++) {
        int32_t key = i * 157 + s % 10;
        int lo = 0, hi = 63;
        while (lo < hi) {
            int m = (lo + hi) / 2;
            if (parts[m].id < key)
                lo = m + 1;
            else
                hi = m;
        }
        if (parts[lo].id - key < 20)
            l->found = (int16_t)(l->found + lo);
    }

    for (int i = 0; i < 8; i++) {
        stats[i].count = 0;
        stats[i].bad = 0;
        stats[i].weight_sum = 0.0f;
        stats[i].oldest = 0;
    }
    for (int i = 0; i < 64; i++) {
        struct station_stat *t = &stats[parts[i].station];
        t->count++;
        if (!parts[i].good)
            t->bad++;
        t->weight_sum = t->weight_sum + parts[i].weight;
        if (parts[i].age > t->oldest)
            t->oldest = parts[i].age;
    }
    l->result = s;
    for (int i = 0; i < 8; i++)
        l->result += stats[i].count * (i + 1) + stats[i].bad * 100 + (int32_t)stats[i].weight_sum + stats[i].oldest;
}

static struct part_list list;
static int32_t scans = 7;

void scan(void)
{
    scans = next_random(scans);
    list.seed = scans;
    part_list(&list);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(list.result + list.found * 3 + list.moves));
}
