/* 64 batch records: update, search, sort */
#include "st.h"
#include <stdbool.h>
#include <string.h>

typedef enum { EMPTY, HEATING, HOLDING, COOLING } phase_t;

typedef struct {
    int16_t id;
    phase_t phase;
    float temp;
    float target;
    int32_t count;
    bool alarm;
} batch_t;

#define N 64

static int16_t find_id(const batch_t *list, int16_t id)
{
    for (int16_t k = 0; k < N; k++) {
        if (list[k].id == id)
            return k;
    }
    return -1;
}

static int32_t done;

static void batch_step(batch_t *b, float ambient)
{
    switch (b->phase) {
    case EMPTY:
        b->count++;
        if (b->count > 20) {
            b->phase = HEATING;
            b->count = 0;
        }
        break;
    case HEATING:
        b->temp = b->temp + (b->target + 10.0f - b->temp) * 0.04f;
        if (b->temp >= b->target) {
            b->phase = HOLDING;
            b->count = 0;
        }
        break;
    case HOLDING:
        b->count++;
        if (b->count > 50)
            b->phase = COOLING;
        break;
    case COOLING:
        b->temp = b->temp - (b->temp - ambient) * 0.03f;
        if (b->temp < ambient + 5.0f) {
            b->phase = EMPTY;
            b->count = 0;
            done++;
        }
        break;
    }
    b->alarm = b->temp > 90.0f;
}

static bool init_done;
static int32_t scan_no;
static batch_t batch[N];
static batch_t sorted[N];

void scan(void)
{
    int i, j;
    int hot, alarms, found;
    batch_t key;
    int32_t sum;

    if (!init_done) {
        init_done = true;
        for (i = 0; i < N; i++) {
            batch[i].id = (int16_t)((i * 37) % 64 + 100);
            batch[i].temp = 20.0f;
            batch[i].target = 60.0f + (float)((i * 29) % 40);
            batch[i].count = (i * 13) % 20;
        }
    }
    scan_no = (scan_no + 1) % 10000;

    for (i = 0; i < N; i++)
        batch_step(&batch[i], 18.0f);

    hot = 0;
    alarms = 0;
    for (i = 0; i < N; i++) {
        if (batch[i].temp > batch[hot].temp)
            hot = i;
        if (batch[i].alarm)
            alarms++;
    }
    found = find_id(batch, (int16_t)(scan_no % 64 + 100));

    memcpy(sorted, batch, sizeof sorted);
    for (i = 1; i < N; i++) {
        key = sorted[i];
        j = i - 1;
        while (j >= 0 && sorted[j].temp > key.temp) {
            sorted[j + 1] = sorted[j];
            j--;
        }
        sorted[j + 1] = key;
    }

    sum = hot + alarms * 3 + found * 5 + done % 1000;
    for (i = 0; i < N; i += 8)
        sum += sorted[i].id * (i + 1) + sorted[i].count;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)(int32_t)(sorted[32].temp * 100.0f));
}
