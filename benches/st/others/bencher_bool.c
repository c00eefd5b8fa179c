/* Boolean network: 200 stations in a line, 8 rungs each, neighbours interlocked. Uses && and ||. */
#include <stdbool.h>
#include "st.h"

static uint32_t lfsr = 0xACE1;
static int32_t cyc;
static bool start[202], stop[202], run[202], prev[202], ready[202], fault[202], lamp[202];

void scan(void)
{
    int32_t i, n = 0;
    bool up, dn, edge, ack, blink, par = false;

    cyc++;
    ack = cyc % 16 == 0;
    blink = cyc % 4 < 2;

    for (i = 201; i >= 1; i--)
        start[i] = start[i - 1];
    start[0] = lfsr % 2 == 1;
    if (lfsr % 2 == 1)
        lfsr = lfsr / 2 + 0xB400;
    else
        lfsr = lfsr / 2;

    for (i = 1; i <= 200; i++) {
        up = ready[i - 1] && !fault[i - 1];
        dn = ready[i + 1] || run[i + 1];
        stop[i] = (start[i - 1] && start[i + 1]) || fault[i];
        run[i] = (start[i] || run[i]) && !stop[i] && (up || dn || i == 1);
        edge = run[i] && !prev[i];
        prev[i] = run[i];
        ready[i] = (run[i] && run[i - 1]) || (run[i] && start[i + 1]) || (run[i - 1] && start[i + 1]);
        fault[i] = (fault[i] || (edge && !up && dn)) && !ack;
        lamp[i] = (fault[i] && blink) || (run[i] != ready[i]);
    }

    for (i = 1; i <= 200; i++) {
        if (lamp[i]) n++;
        if (run[i]) n += i;
        par ^= fault[i];
    }
    if (par) n += 100000;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)n);
}
