#include "timers.h"

enum state { IDLE, FILLING, SETTLING, EMPTYING };

#define LANES 100

static int scans;
static enum state state[LANES];
static bool call[LANES];
static uint32_t fill_time[LANES];
static Timer filling[LANES], settling[LANES], lamp[LANES];
static Counter batches[LANES], level[80];
static Pulse horn[20];

void scan(void)
{
    now_ms = now_us / 1000;
    if (scans == 0)
        for (int i = 0; i < LANES; i++)
            fill_time[i] = 20 + 10 * ((i + 1) % 7);
    scans++;

    for (int i = 0; i < LANES; i++) {
        call[i] = (scans + i + 1) % 17 < 6;
        ton(&filling[i], state[i] == FILLING, fill_time[i]);
        ton(&settling[i], state[i] == SETTLING, 30);
        switch (state[i]) {
        case IDLE:
            if (call[i])
                state[i] = FILLING;
            break;
        case FILLING:
            if (filling[i].q)
                state[i] = SETTLING;
            else if (filling[i].et >= 40 && !call[i])
                state[i] = IDLE;
            break;
        case SETTLING:
            if (settling[i].q)
                state[i] = EMPTYING;
            break;
        case EMPTYING:
            if (!call[i])
                state[i] = IDLE;
            break;
        }
    }

    for (int i = 0; i < LANES; i++) {
        tof(&lamp[i], state[i] == EMPTYING, 50);
        ctu(&batches[i], lamp[i].q, batches[i].qu && !call[i], 9);
    }
    for (int i = 0; i < 80; i++)
        ctud(&level[i], filling[i].q, settling[i + 20].q, false, scans % 300 == 1, 15);
    for (int i = 0; i < 20; i++)
        tp(&horn[i], (scans + 2 * (i + 1)) % 11 < 5, 40);

    int sum = 0;
    for (int i = 0; i < LANES; i++) {
        if (lamp[i].q)
            sum += 5;
        sum += batches[i].cv * 2;
    }
    for (int i = 0; i < 80; i++) {
        if (level[i].qu || level[i].qd)
            sum += 13;
        sum += level[i].cv;
    }
    for (int i = 0; i < 20; i++)
        if (horn[i].q)
            sum += i + 1;
    check = (check * 31 + sum) % 1000003;
}
