/* Walking beam furnace: 336 slab places */
#include <stdbool.h>
#include "st.h"

typedef struct { int16_t len, wid, thk; } Size3;
typedef struct {
    int32_t id;
    int16_t grade;
    Size3 dim;
    float temp[5];
    int32_t secs;
    bool used;
} Slab;
typedef struct { float temp, cond, cp; } GradePoint;
typedef struct { int16_t code; float target; int32_t min_secs; GradePoint pt[6]; } GradeData;
typedef struct { Slab slab; int32_t cycle; bool ok; } LogEntry;

static float minf(float a, float b) { return a < b ? a : b; }
static float maxf(float a, float b) { return a > b ? a : b; }

static bool first = true;
static int32_t cycle;
static int32_t next_id = 1000;
static uint32_t seed = 8;
static Slab place[336];
static GradeData grades[12];
static LogEntry loglist[20];
static int16_t log_pos;
static float zone_temp[4];

void scan(void)
{
    int i, k, g, z;
    bool move;
    if (first) {
        for (g = 0; g < 12; g++) {
            int n = g + 1;
            grades[g].code = n * 11;
            grades[g].target = 900.0f + (float)n * 20.0f;
            grades[g].min_secs = 300 + n * 10;
            for (k = 0; k < 6; k++) {
                grades[g].pt[k].temp = (float)k * 250.0f;
                grades[g].pt[k].cond = 52.0f - (float)(k * 4) - (float)n * 0.5f;
                grades[g].pt[k].cp = 0.48f + (float)k * 0.035f;
            }
        }
        for (z = 0; z < 4; z++)
            zone_temp[z] = 700.0f + (float)(z + 1) * 150.0f;
        /* start with a loaded furnace */
        for (i = 0; i < 336; i++) {
            int n = i + 1;
            place[i].id = 900 - n;
            place[i].used = n % 8 != 0;
            place[i].grade = (n * 5 % 12 + 1) * 11;
            place[i].dim.len = 8000 + n * 10;
            place[i].dim.wid = 1200;
            place[i].dim.thk = 180 + n % 70;
            place[i].secs = n * 8;
            for (k = 0; k < 5; k++)
                place[i].temp[k] = 25.0f + (float)n * 3.0f;
        }
        first = false;
    }
    cycle++;
    move = cycle % 8 == 0;

    for (i = 0; i < 336; i++) {
        Slab *s = &place[i];
        if (s->used) {
            const GradeData *gd;
            float mean, f, lambda, cp, a, t[5];
            z = i / 84;
            s->secs++;
            mean = 0.0f;
            for (k = 0; k < 5; k++)
                mean += s->temp[k];
            mean /= 5.0f;
            g = 0;
            while (g < 11 && grades[g].code != s->grade)
                g++;
            gd = &grades[g];
            k = 0;
            while (k < 4 && mean > gd->pt[k + 1].temp)
                k++;
            f = (mean - gd->pt[k].temp) / (gd->pt[k + 1].temp - gd->pt[k].temp);
            lambda = gd->pt[k].cond + f * (gd->pt[k + 1].cond - gd->pt[k].cond);
            cp = gd->pt[k].cp + f * (gd->pt[k + 1].cp - gd->pt[k].cp);
            a = lambda / (cp * (float)s->dim.thk) * 0.25f;
            if (a > 0.3f) a = 0.3f;
            t[0] = s->temp[0] + a * (s->temp[1] - s->temp[0]) + (zone_temp[z] - s->temp[0]) * 0.05f;
            for (k = 1; k < 4; k++)
                t[k] = s->temp[k] + a * (s->temp[k - 1] - 2.0f * s->temp[k] + s->temp[k + 1]);
            t[4] = s->temp[4] + a * (s->temp[3] - s->temp[4]) + (zone_temp[z] - 40.0f - s->temp[4]) * 0.03f;
            for (k = 0; k < 5; k++)
                s->temp[k] = t[k];
        }
    }

    if (move) {
        Slab fresh = { 0 };
        if (place[335].used) {
            LogEntry *l = &loglist[log_pos];
            l->slab = place[335];
            l->cycle = cycle;
            g = place[335].grade / 11 - 1;
            l->ok = place[335].temp[2] >= grades[g].target && place[335].secs >= grades[g].min_secs;
            check = (int32_t)((uint32_t)check * 31u + (uint32_t)place[335].id + (uint32_t)(int32_t)place[335].temp[2]);
            if (l->ok) check = (int32_t)((uint32_t)check + 1u);
            log_pos = (log_pos + 1) % 20;
        }
        for (i = 335; i > 0; i--)
            place[i] = place[i - 1];
        seed = seed * 1664525u + 1013904223u;
        next_id++;
        fresh.id = next_id;
        fresh.used = seed / 65536u % 8u != 0;
        fresh.grade = ((int16_t)(seed / 262144u % 12u) + 1) * 11;
        fresh.dim.len = 8000 + (int16_t)(seed / 65536u % 1000u);
        fresh.dim.wid = 1200;
        fresh.dim.thk = 180 + (int16_t)(seed / 1048576u % 70u);
        fresh.secs = 0;
        for (k = 0; k < 5; k++)
            fresh.temp[k] = 25.0f;
        place[0] = fresh;
    }

    for (z = 0; z < 4; z++) {
        i = (z + 1) * 84 - 1;
        if (place[i].used) {
            if (place[i].temp[0] < 400.0f + (float)(z + 1) * 180.0f)
                zone_temp[z] = minf(zone_temp[z] + 0.5f, 1350.0f);
            else
                zone_temp[z] = maxf(zone_temp[z] - 0.5f, 600.0f);
        }
        check = (int32_t)((uint32_t)check * 7u + (uint32_t)(int32_t)(zone_temp[z] * 2.0f) + (uint32_t)place[i].secs + (uint32_t)(int32_t)place[i].temp[4]);
    }
    i = cycle % 20;
    check = (int32_t)((uint32_t)check + (uint32_t)loglist[i].slab.id + (uint32_t)loglist[i].cycle + (uint32_t)loglist[i].slab.dim.len);
}
