#include "st.h"
#include <stdbool.h>

struct batch {
    int16_t id;
    int32_t prio;
    float level;
    float temp;
    bool busy;
    int32_t runs;
};

static struct batch q[64];
static int32_t seed = 99;
static bool ready;

void scan(void)
{
    int32_t i, j, best, found, wanted, sum;
    struct batch tmp;

    if (!ready) {
        ready = true;
        for (i = 0; i < 64; i++) {
            q[i].id = (int16_t)(i + 100);
            q[i].prio = (i * 37) % 64;
            q[i].level = (float)i;
            q[i].temp = 20.0f;
        }
    }

    /* update */
    for (i = 0; i < 64; i++) {
        if (q[i].busy) {
            q[i].level = q[i].level - 0.75f;
            q[i].temp = q[i].temp + 0.5f;
            if (q[i].level < 5.0f) {
                q[i].busy = false;
                q[i].runs++;
            }
        } else {
            q[i].level = q[i].level + 1.25f;
            q[i].temp = q[i].temp - 0.1f * (q[i].temp - 20.0f);
            if (q[i].level > 60.0f)
                q[i].busy = true;
        }
    }

    /* give eight batches a new priority */
    for (i = 1; i <= 8; i++) {
        seed = (seed * 1103 + 12345) % 65536;
        q[seed % 64].prio = seed / 16;
    }

    /* insertion sort by priority */
    for (i = 1; i < 64; i++) {
        tmp = q[i];
        j = i - 1;
        while (j >= 0) {
            if (q[j].prio <= tmp.prio)
                break;
            q[j + 1] = q[j];
            j--;
        }
        q[j + 1] = tmp;
    }

    /* hottest batch */
    best = 0;
    for (i = 1; i < 64; i++)
        if (q[i].temp > q[best].temp)
            best = i;

    /* look up some ids */
    sum = 0;
    for (wanted = 100; wanted <= 163; wanted += 7) {
        found = -1;
        for (i = 0; i < 64; i++) {
            if (q[i].id == wanted) {
                found = i;
                break;
            }
        }
        sum = sum * 3 + found;
    }

    for (i = 0; i < 64; i++) {
        sum += q[i].runs + q[i].prio;
        if (q[i].busy)
            sum += i;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)q[best].id);
}
