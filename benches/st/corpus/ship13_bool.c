#include <stdbool.h>
#include "st.h"

typedef struct {
    bool magnet, closed, fault;
    bool open_req_old;
} FireDoor;

typedef struct {
    bool closed, lockout, trip_edge;
    bool trip_old;
} Breaker;

static inline void fire_door(FireDoor *d, bool open_req, bool close_req, bool zone_fire,
                             bool lim_open, bool lim_closed, bool reset)
{
    bool open_edge = open_req && !d->open_req_old;
    d->open_req_old = open_req;

    d->magnet = !(close_req || zone_fire) && ((open_edge && !zone_fire) || d->magnet);
    d->closed = lim_closed && !lim_open;
    bool set = (lim_open && lim_closed) || (d->magnet && d->closed && zone_fire);
    d->fault = set || (!reset && d->fault);
}

static inline void breaker(Breaker *b, bool close_cmd, bool open_cmd, bool running, bool sync,
                           bool dead_bus, bool trip, bool reset)
{
    b->trip_edge = trip && !b->trip_old;
    b->trip_old = trip;
    if (b->trip_edge)
        b->lockout = true;
    else if (reset && !trip)
        b->lockout = false;
    b->closed = (b->closed || (close_cmd && (sync || dead_bus))) && running && !open_cmd && !b->lockout;
}

static uint32_t noise = 0x2545F491;
static FireDoor door[24];
static Breaker cb[4];
static bool pump_run[16], pump_req[16], zone[6];
static uint16_t alarm_old, unack;
static bool horn;
static uint32_t crc;

void scan(void)
{
    bool in[32];

    noise ^= noise << 13;
    noise ^= noise >> 17;
    noise ^= noise << 5;
    for (int i = 0; i < 32; i++)
        in[i] = (noise >> i) & 1;

    for (int i = 0; i < 6; i++)
        zone[i] = (in[i] && in[i + 6] && in[i + 12]) || (zone[i] && !in[31]);

    for (int i = 0; i < 24; i++) {
        fire_door(&door[i], in[i], in[i + 3] && in[i + 5], zone[i / 4], in[i + 7] && in[i + 1],
                  in[i + 2] && !in[i + 4], in[30]);
        crc *= 3;
        if (door[i].magnet)
            crc += 1;
        if (door[i].fault)
            crc += 7;
    }

    bool dead_bus = !(cb[0].closed || cb[1].closed || cb[2].closed || cb[3].closed);
    for (int i = 1; i <= 4; i++) {
        Breaker *b = &cb[i - 1];
        breaker(b, in[i], in[i + 4] && in[i + 8] && in[i + 9], in[i + 12] || in[i + 13] || in[i + 14],
                in[i + 16], dead_bus, in[i + 20] && in[i + 21] && in[i + 22], in[29]);
        dead_bus = dead_bus && !b->closed;
    }

    bool permit = !dead_bus;
    for (int i = 0; i < 16; i++) {
        pump_req[i] = (pump_req[i] || in[i]) && !(in[i + 16] && in[15 - i]);
        pump_run[i] = permit && pump_req[i] && (pump_run[i] || in[31 - i]);
        permit = !dead_bus && (pump_run[i] || !pump_req[i]);
    }

    uint16_t alarm = 0;
    alarm |= cb[0].lockout << 0;
    alarm |= cb[1].lockout << 1;
    alarm |= cb[2].lockout << 2;
    alarm |= cb[3].lockout << 3;
    alarm |= (door[0].fault || door[1].fault || door[2].fault || door[3].fault) << 4;
    alarm |= (door[4].fault && door[5].fault && door[6].fault) << 5;
    alarm |= (zone[0] != zone[1]) << 6;
    alarm |= (zone[2] || zone[3]) << 7;
    alarm |= (zone[4] && zone[5]) << 8;
    alarm |= dead_bus << 9;
    alarm |= (pump_req[0] && !pump_run[0]) << 10;
    alarm |= (pump_req[15] && !pump_run[15]) << 11;
    alarm |= !permit << 12;
    alarm |= (pump_run[3] ^ pump_run[7] ^ pump_run[11]) << 15;

    uint16_t fresh = alarm & ~alarm_old;
    alarm_old = alarm;
    unack |= fresh;
    if (in[27] && in[28])
        unack = 0;
    horn = (horn || fresh != 0) && !in[26];
    bool general = (alarm & 1) || (unack & (1 << 4)) || ((unack & (1 << 7)) && horn);

    for (int i = 0; i < 16; i++) {
        if (pump_run[i])
            crc = crc * 5 + 3;
        else
            crc += 11;
    }
    for (int i = 0; i < 4; i++) {
        if (cb[i].closed)
            crc = crc * 7 + 55;
        if (cb[i].trip_edge)
            crc += 101;
    }
    crc += alarm * 3u + unack * 17u;
    if (horn)
        crc += 1;
    if (general)
        crc += 2;
    check = (int32_t)crc;
}
