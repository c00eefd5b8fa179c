/* Alarm server: view sorted by priority, then by time; history log */
#include <stdbool.h>
#include "st.h"

#define ALARMS 64
#define LOGLEN 100

typedef struct { int32_t sec; int16_t ms; } Stamp;

typedef struct {
    int16_t number, prio, area;
    bool active, acked;
    Stamp come, gone;
    int32_t count;
} Alarm;

static bool before(const Alarm *a, const Alarm *b)
{
    if (a->active != b->active)
        return a->active;
    if (a->prio != b->prio)
        return a->prio < b->prio;
    if (a->come.sec != b->come.sec)
        return a->come.sec > b->come.sec;
    return a->come.ms > b->come.ms;
}

static bool init;
static Alarm alarms[ALARMS], view[ALARMS], log_[LOGLEN];
static int16_t log_pos;
static int32_t scan_no;
static Stamp now;
static int16_t per_area[8];

void scan(void)
{
    if (!init) {
        for (int i = 1; i <= ALARMS; i++) {
            alarms[i - 1].number = 1000 + i;
            alarms[i - 1].prio = i * 7 % 10;
            alarms[i - 1].area = i % 8;
        }
        init = true;
    }

    scan_no++;
    now.ms += 10;
    if (now.ms >= 1000) {
        now.ms = 0;
        now.sec++;
    }

    for (int i = 0; i <= 4; i++) {
        Alarm *a = &alarms[(int32_t)((uint32_t)scan_no * 13u + i * 29u) % 64];
        if (a->active) {
            a->active = false;
            a->acked = false;
            a->gone = now;
        } else {
            a->active = true;
            a->come = now;
            a->count++;
        }
        log_[log_pos] = *a;
        log_pos++;
        if (log_pos >= LOGLEN)
            log_pos = 0;
    }

    for (int i = 0; i < ALARMS; i++)
        view[i] = alarms[i];
    for (int i = 1; i < ALARMS; i++) {
        Alarm tmp = view[i];
        int j = i - 1;
        while (j >= 0) {
            if (!before(&tmp, &view[j]))
                break;
            view[j + 1] = view[j];
            j--;
        }
        view[j + 1] = tmp;
    }

    for (int i = 0; i < 8; i++)
        per_area[i] = 0;
    for (int i = 0; i < ALARMS; i++)
        if (alarms[i].active)
            per_area[alarms[i].area]++;
    int32_t sum = 0;
    for (int i = 1; i <= 20; i++)
        sum += view[i - 1].number * i + view[i - 1].come.ms;
    for (int i = 0; i < LOGLEN; i++)
        if (log_[i].active)
            sum += log_[i].prio;
    for (int i = 0; i < 8; i++)
        sum += per_area[i] * i;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
