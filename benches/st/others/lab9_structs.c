/* Array of records: update, linear search, copy, Shell sort, binary search, statistics. */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 64

typedef struct {
    int32_t id;
    int32_t key;
    int16_t group;
    bool valid;
    float val;
    int32_t hits;
} rec_t;

static int32_t seed = 74755;
static bool first = true;
static rec_t tab[N], srt[N];
static int32_t cnt[8];
static float total[8];

static int32_t Rand(void)
{
    seed = (seed * 1309 + 13849) & 65535;
    return seed;
}

void scan(void)
{
    int32_t i, j, k, gap, lo, hi, mid, found, sum = 0;
    rec_t tmp;
    float fsum, vmin, vmax;

    if (first) {
        first = false;
        for (i = 0; i < N; i++) {
            tab[i].id = (i * 37) % N;
            tab[i].key = Rand();
            tab[i].group = (int16_t)(i % 8);
            tab[i].valid = i % 3 != 0;
            tab[i].val = (float)i * 0.5f;
        }
    }

    /* update */
    for (i = 0; i < N; i++) {
        tab[i].key = (tab[i].key * 5 + i + 1) % 10007;
        tab[i].val = tab[i].val * 0.9f + (float)tab[i].key * 0.01f;
        if (tab[i].key % 4 == 0)
            tab[i].valid = !tab[i].valid;
    }

    /* linear search for some ids */
    for (k = 0; k < 8; k++) {
        found = Rand() / 256 % N;
        i = 0;
        while (i < N && tab[i].id != found)
            i = i + 1;
        if (i < N) {
            tab[i].hits = tab[i].hits + 1;
            sum = sum + i;
        }
    }

    /* copy and Shell sort by key */
    for (i = 0; i < N; i++)
        srt[i] = tab[i];
    gap = N / 2;
    while (gap > 0) {
        for (i = gap; i < N; i++) {
            tmp = srt[i];
            j = i;
            while (j >= gap) {
                if (srt[j - gap].key <= tmp.key)
                    break;
                srt[j] = srt[j - gap];
                j = j - gap;
            }
            srt[j] = tmp;
        }
        gap = gap / 2;
    }

    /* binary search of keys */
    for (k = 0; k < 16; k++) {
        found = tab[k * 4].key;
        lo = 0;
        hi = N - 1;
        while (lo < hi) {
            mid = (lo + hi) / 2;
            if (srt[mid].key < found)
                lo = mid + 1;
            else
                hi = mid;
        }
        sum = sum + lo * k + srt[lo].hits;
    }

    /* statistics by group */
    for (i = 0; i < 8; i++) {
        cnt[i] = 0;
        total[i] = 0.0f;
    }
    vmin = srt[0].val;
    vmax = srt[0].val;
    for (i = 0; i < N; i++) {
        if (srt[i].valid) {
            cnt[srt[i].group] = cnt[srt[i].group] + 1;
            total[srt[i].group] = total[srt[i].group] + srt[i].val;
        }
        if (srt[i].val < vmin)
            vmin = srt[i].val;
        if (srt[i].val > vmax)
            vmax = srt[i].val;
        sum = sum + srt[i].id * i;
    }
    fsum = vmax - vmin;
    for (i = 0; i < 8; i++) {
        if (cnt[i] > 0)
            fsum = fsum + total[i] / (float)cnt[i];
        sum = sum + cnt[i] * (i + 1);
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)(int32_t)lrintf(fsum * 10.0f));
}
