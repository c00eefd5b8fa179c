/* Zero pressure accumulation conveyor: 50 zones */
#include <stdbool.h>
#include "st.h"

#define ZONES 50

typedef struct { bool q; int16_t cnt; } Debounce;

static void debounce(Debounce *d, bool in, int16_t on, int16_t off)
{
    if (in == d->q) {
        d->cnt = 0;
    } else {
        d->cnt++;
        if ((in && d->cnt >= on) || (!in && d->cnt >= off)) {
            d->q = in;
            d->cnt = 0;
        }
    }
}

static int16_t ramp_int(int16_t act, int16_t target, int16_t step)
{
    if (act < target - step)
        return act + step;
    if (act > target + step)
        return act - step;
    return target;
}

typedef struct {
    bool occupied, run, jam;
    int16_t speed;
    int32_t travel;
    Debounce eye;
    int16_t jam_cnt;
    int16_t target;
} Zone;

static void zone(Zone *z, bool sensor, bool down_free, bool enable, bool reset,
                 int16_t speed_set, int16_t jam_limit)
{
    debounce(&z->eye, sensor, 2, 3);
    z->occupied = z->eye.q;

    if (reset) {
        z->jam = false;
        z->jam_cnt = 0;
    }

    z->run = enable && !z->jam && (down_free || !z->occupied);
    z->target = z->run ? speed_set : 0;
    z->speed = ramp_int(z->speed, z->target, 40);

    if (z->run && z->occupied) {
        z->jam_cnt++;
        if (z->jam_cnt > jam_limit)
            z->jam = true;
    } else if (!z->occupied) {
        z->jam_cnt = 0;
    }

    z->travel += z->speed;
    if (z->travel >= 1000000)
        z->travel -= 1000000;
}

static int32_t zone_status(bool occ, bool run, bool jam, int16_t speed)
{
    if (jam) return 4;
    if (run && occ) return 3;
    if (run) return 2;
    if (speed > 0) return 1;
    return 0;
}

static Zone zones[ZONES];
static bool sensors[ZONES];
static int32_t scan_no;

void scan(void)
{
    scan_no++;
    bool reset = (scan_no % 200) == 0;
    int16_t line = (scan_no % 500) < 250 ? 800 : 550;

    for (int16_t i = 0; i < ZONES; i++)
        sensors[i] = ((scan_no / 4 + (i + 1) * 5) % 23) < 9;

    int32_t sum = 0;
    bool free_ = (scan_no % 16) < 11;
    for (int16_t i = ZONES - 1; i >= 0; i--) {
        Zone *z = &zones[i];
        zone(z, sensors[i], free_, true, reset, line + i + 1, 30);
        free_ = !z->occupied;
        sum = sum * 5 + zone_status(z->occupied, z->run, z->jam, z->speed);
        sum = sum % 1000003 + z->speed;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)zones[6].travel);
}
