#include "iec_timers.h"

static int32_t scans;
static uint32_t seed = 1;
static bool inputs[100];
static Ton on_timers[150];
static Tof off_timers[100];
static Tp pulses[50];
static Ctu ups[100];
static Ctd downs[50];
static Ctud updowns[50];

void scan(void)
{
    scans++;
    for (int i = 0; i < 100; i++) {
        seed = (seed * 25173 + 13849) % 65536;
        if (seed > 52000)
            inputs[i] = !inputs[i];
    }
    for (int i = 0; i < 150; i++)
        ton(&on_timers[i], inputs[i % 100], 40000);
    for (int i = 0; i < 100; i++)
        tof(&off_timers[i], inputs[i], 70000);
    for (int i = 0; i < 50; i++)
        tp(&pulses[i], inputs[i * 2], 30000);
    for (int i = 0; i < 100; i++)
        ctu(&ups[i], inputs[i], ups[i].q, 5 + i);
    for (int i = 0; i < 50; i++) {
        ctd(&downs[i], pulses[i].q, downs[i].cv <= 0, 20);
        ctud(&updowns[i], on_timers[i].q, off_timers[i].q, false, scans % 500 == 0, i);
    }
    int32_t sum = 0;
    for (int i = 0; i < 150; i++) {
        if (on_timers[i].q) sum += i;
        if (on_timers[i].et >= 20000) sum++;
    }
    for (int i = 0; i < 100; i++) {
        if (off_timers[i].q) sum += 2;
        sum += ups[i].cv;
    }
    for (int i = 0; i < 50; i++) {
        if (pulses[i].q) sum += 3;
        sum += downs[i].cv * 2 + updowns[i].cv;
        if (updowns[i].qu) sum += 4;
    }
    check = (check * 3 + sum) % 100003;
}
