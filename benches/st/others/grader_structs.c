/* a production queue: 48 job records, updated, searched, sorted and filtered */
#include "st.h"
#include <stdbool.h>

#define COUNT 48

struct limits {
    float lo, hi;
};

struct job {
    int32_t id;
    int16_t prio;
    int16_t state;
    float weight;
    bool active;
    struct limits lim;
    int16_t steps[4];
};

static struct job jobs[COUNT + 1];      /* 1..COUNT */
static struct job urgent[COUNT + 1];
static int32_t hist[5];
static int32_t lap;
static bool ready;

void scan(void)
{
    struct job tmp;
    int16_t i, j, k, n_urgent, best;
    int32_t wanted, found, total;
    float sum_w;

    if (!ready) {
        for (i = 1; i <= COUNT; i++) {
            jobs[i].id = 1000 + i * 17;
            jobs[i].prio = i % 10;
            jobs[i].weight = (float)i * 1.5f;
            jobs[i].active = i % 3 != 0;
            jobs[i].lim.lo = 10.0f;
            jobs[i].lim.hi = 90.0f + (float)(i % 5);
            for (k = 0; k < 4; k++)
                jobs[i].steps[k] = i + k;
        }
        ready = true;
    }

    lap = (lap + 1) % 1009;

    /* update */
    for (i = 0; i < 5; i++)
        hist[i] = 0;
    sum_w = 0.0f;
    for (i = 1; i <= COUNT; i++) {
        struct job *p = &jobs[i];
        p->prio = (int16_t)((p->id * 7 + lap * 31) % 101);
        if (p->active) {
            p->weight = p->weight * 1.02f + 0.1f;
            if (p->weight > p->lim.hi) {
                p->weight = p->lim.lo;
                p->state = (p->state + 1) % 5;
            }
        } else if (p->prio > 90) {
            p->active = true;
        }
        for (k = 0; k < 4; k++)
            p->steps[k] = (p->steps[k] + p->prio + k) % 1000;
        hist[p->state]++;
        sum_w += p->weight;
    }

    /* insertion sort by priority */
    for (i = 2; i <= COUNT; i++) {
        tmp = jobs[i];
        j = i - 1;
        while (j >= 1) {
            if (jobs[j].prio <= tmp.prio)
                break;
            jobs[j + 1] = jobs[j];
            j--;
        }
        jobs[j + 1] = tmp;
    }

    /* look up twelve jobs by their number */
    found = 0;
    for (k = 1; k <= 12; k++) {
        wanted = 1000 + ((lap + k * 5) % 52) * 17;
        for (i = 1; i <= COUNT; i++) {
            if (jobs[i].id == wanted) {
                found += i + jobs[i].steps[k % 4];
                break;
            }
        }
    }

    /* copy the urgent ones and find the heaviest of them */
    n_urgent = 0;
    best = 0;
    for (i = 1; i <= COUNT; i++) {
        if (jobs[i].active && jobs[i].prio >= 50) {
            n_urgent++;
            urgent[n_urgent] = jobs[i];
            if (best == 0)
                best = n_urgent;
            else if (urgent[n_urgent].weight > urgent[best].weight)
                best = n_urgent;
        }
    }

    total = found + n_urgent * 3 + (int32_t)sum_w;
    if (best > 0)
        total += urgent[best].id;
    for (i = 0; i < 5; i++)
        total += hist[i] * (i + 1);
    check = (check + total) % 10000019;
}
