#include "timers.h"

typedef struct {
    bool busy, done, vented, old_part;
    Timer work, vent;
    Counter pieces, stock;
} Station;

static int scans;
static bool sensor[33], home;
static Station stations[101];
static Pulse pulses[31];
static Counter places[31];
static Timer lock1;
static Timer fan2;
static Pulse lock3;
static Counter drum4;
static Counter fan5;
static Counter belt6;
static Timer fan7;
static Timer horn8;
static Pulse gate9;
static Counter pump10;
static Counter belt11;
static Counter gate12;
static Timer pump13;
static Timer fan14;
static Pulse horn15;
static Counter lock16;
static Counter lamp17;
static Counter belt18;
static Timer lamp19;
static Timer belt20;
static Pulse lock21;
static Counter drum22;
static Counter horn23;
static Counter lock24;
static Timer fan25;
static Timer belt26;
static Pulse lamp27;
static Counter drum28;
static Counter drum29;
static Counter horn30;
static Timer horn31;
static Timer drum32;
static Pulse lamp33;
static Counter fan34;
static Counter belt35;
static Counter fan36;
static Timer fan37;
static Timer belt38;
static Pulse belt39;
static Counter lock40;

static void station(Station *s, bool part, bool reset, uint32_t cycle, uint32_t hold)
{
    bool arrival = rising(&s->old_part, part);
    if (arrival)
        s->busy = true;
    s->done = ton(&s->work, s->busy, cycle);
    if (s->done)
        s->busy = false;
    s->vented = tof(&s->vent, s->busy, hold);
    ctu(&s->pieces, s->done, reset || s->pieces.qu, 20);
    ctd(&s->stock, arrival, reset || s->stock.qd, 12);
}

void scan(void)
{
    now_ms = now_us / 1000;
    scans++;
    int sum = 0;
    home = scans % 500 == 0;
    for (int i = 1; i <= 32; i++)
        sensor[i] = (scans + i * 3) % (8 + i) < 4;

    for (int i = 1; i <= 100; i++) {
        Station *s = &stations[i];
        station(s, sensor[i % 32 + 1], home && i % 3 == 0, 40, 70);
        if (s->busy)
            sum += i;
        if (s->vented)
            sum += 2 * i;
        sum += s->pieces.cv * 3 + s->stock.cv;
    }

    for (int i = 1; i <= 30; i++) {
        tp(&pulses[i], sensor[i], 30);
        ctud(&places[i], pulses[i].q, stations[i].done, home, false, 10);
        if (places[i].qu)
            sum += 7;
        if (places[i].qd)
            sum += 11;
        sum += places[i].cv;
    }

    ton(&lock1, !sensor[12] && sensor[6], 80);
    if (lock1.q)
        sum += 1;
    tof(&fan2, !sensor[32] && sensor[14], 70);
    if (fan2.q)
        sum += 6;
    tp(&lock3, sensor[6], 30);
    if (lock3.q)
        sum += 11;
    ctu(&drum4, sensor[3], drum4.qu && sensor[14], 20);
    if (drum4.qu)
        sum += 16;
    ctd(&fan5, sensor[13], fan5.qd && !sensor[23], 25);
    if (fan5.qd)
        sum += 21;
    ctud(&belt6, sensor[29], lock1.q, home, false, 4);
    if (belt6.qu)
        sum += 26;
    ton(&fan7, sensor[31] && sensor[28], 40);
    if (fan7.q)
        sum += 31;
    tof(&horn8, sensor[25] && sensor[13], 20);
    if (horn8.q)
        sum += 36;
    tp(&gate9, sensor[31], 30);
    if (gate9.q)
        sum += 41;
    ctu(&pump10, horn8.q, pump10.qu && !sensor[28], 6);
    if (pump10.qu)
        sum += 46;
    ctd(&belt11, sensor[14], belt11.qd && drum4.qu, 18);
    if (belt11.qd)
        sum += 51;
    ctud(&gate12, sensor[8], sensor[8], home, false, 3);
    if (gate12.qu)
        sum += 56;
    ton(&pump13, sensor[29] && sensor[26], 70);
    if (pump13.q)
        sum += 61;
    tof(&fan14, sensor[8] && sensor[26], 50);
    if (fan14.q)
        sum += 66;
    tp(&horn15, sensor[16], 30);
    if (horn15.q)
        sum += 71;
    ctu(&lock16, sensor[13], lock16.qu && !sensor[24], 12);
    if (lock16.qu)
        sum += 76;
    ctd(&lamp17, !lock3.q, lamp17.qd && sensor[28], 16);
    if (lamp17.qd)
        sum += 81;
    ctud(&belt18, lock16.qu, fan14.q, home, false, 15);
    if (belt18.qu)
        sum += 86;
    ton(&lamp19, !sensor[23] && sensor[29], 50);
    if (lamp19.q)
        sum += 91;
    tof(&belt20, sensor[17] && !fan14.q, 70);
    if (belt20.q)
        sum += 96;
    tp(&lock21, sensor[11], 30);
    if (lock21.q)
        sum += 101;
    ctu(&drum22, sensor[17], drum22.qu && sensor[30], 23);
    if (drum22.qu)
        sum += 106;
    ctd(&horn23, sensor[16], horn23.qd && sensor[5], 4);
    if (horn23.qd)
        sum += 111;
    ctud(&lock24, lamp19.q, fan5.qd, home, false, 27);
    if (lock24.qu)
        sum += 116;
    ton(&fan25, lamp19.q && sensor[17], 40);
    if (fan25.q)
        sum += 121;
    tof(&belt26, lock24.qu && sensor[27], 40);
    if (belt26.q)
        sum += 126;
    tp(&lamp27, sensor[31], 30);
    if (lamp27.q)
        sum += 131;
    ctu(&drum28, sensor[5], drum28.qu && !fan2.q, 13);
    if (drum28.qu)
        sum += 136;
    ctd(&drum29, sensor[21], drum29.qd && sensor[21], 16);
    if (drum29.qd)
        sum += 141;
    ctud(&horn30, lamp27.q, sensor[25], home, false, 10);
    if (horn30.qu)
        sum += 146;
    ton(&horn31, !lamp19.q && sensor[15], 30);
    if (horn31.q)
        sum += 151;
    tof(&drum32, gate9.q && drum4.qu, 40);
    if (drum32.q)
        sum += 156;
    tp(&lamp33, sensor[10], 30);
    if (lamp33.q)
        sum += 161;
    ctu(&fan34, belt26.q, fan34.qu && horn8.q, 27);
    if (fan34.qu)
        sum += 166;
    ctd(&belt35, sensor[30], belt35.qd && !lock24.qu, 8);
    if (belt35.qd)
        sum += 171;
    ctud(&fan36, drum29.qd, belt20.q, home, false, 28);
    if (fan36.qu)
        sum += 176;
    ton(&fan37, sensor[31] && sensor[11], 40);
    if (fan37.q)
        sum += 181;
    tof(&belt38, lock16.qu && belt35.qd, 60);
    if (belt38.q)
        sum += 186;
    tp(&belt39, sensor[32], 30);
    if (belt39.q)
        sum += 191;
    ctu(&lock40, sensor[6], lock40.qu && gate9.q, 24);
    if (lock40.qu)
        sum += 196;
    check = (check * 31 + sum) % 1000003;
}
