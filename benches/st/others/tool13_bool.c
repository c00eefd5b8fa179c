#include <stdbool.h>
#include "st.h"

#define N 16

static uint32_t seed = 0x1ACEB00C;
static bool motor[N], alarm_[N], lamp[N], prev_motor[N];
static bool start_btn[N], stop_btn[N], fault[N];
static int16_t starts[N];
static bool ack_old, blink;

void scan(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 17;
    seed ^= seed << 5;
    for (int i = 0; i < N; i++) {
        start_btn[i] = (seed >> i) & 1;
        stop_btn[i] = ((seed >> (i + 8)) & 7) == 5;
        fault[i] = ((seed >> (i + 3)) & 0x1F) == 0x13;
    }
    bool estop = (seed & 0x3F0) == 0x150;
    bool ack = (seed & 0x6000) != 0;

    bool ack_edge = ack && !ack_old;
    ack_old = ack;
    blink = !blink;

    bool release = !estop;
    bool any_alarm = false, all_run = true, odd_run = false;
    for (int i = 0; i < N; i++) {
        alarm_[i] = fault[i] || (alarm_[i] && !ack_edge);
        motor[i] = (start_btn[i] || motor[i]) && !stop_btn[i] && !alarm_[i]
                   && !estop && (release || motor[i]);
        release = motor[i] || (release && !start_btn[i]);
        lamp[i] = motor[i] || (alarm_[i] && blink);
        any_alarm |= alarm_[i];
        all_run &= motor[i];
        odd_run ^= motor[i];
        if (motor[i] && !prev_motor[i])
            starts[i] = (starts[i] + 1) % 1000;
        prev_motor[i] = motor[i];
    }

    uint32_t outputs = 0;
    for (int i = 0; i < N; i++) {
        if (motor[i])
            outputs |= 1u << i;
        if (lamp[i])
            outputs |= 1u << (i + 16);
    }

    uint32_t sum = (uint32_t)check * 31u + outputs;
    for (int i = 0; i < N; i++)
        sum += starts[i];
    if (any_alarm) sum += 1;
    if (all_run) sum += 2;
    if (odd_run) sum += 4;
    check = (int32_t)sum;
}
