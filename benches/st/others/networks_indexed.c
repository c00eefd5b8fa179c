#include <stdint.h>
#include <stdbool.h>
#include "st.h"

static int32_t scans;
static bool inp[64], mem[256], outp[256];
static bool clk_old[32], latch[32];

void scan(void)
{
    scans++;
    int32_t pattern = scans * 7919;
    for (int i = 0; i < 64; i++) {
        inp[i] = pattern % 2 == 1;
        pattern = pattern / 2 + i;
    }
    for (int i = 0; i < 256; i++)
        mem[i] = (inp[i % 64] && !inp[(i + 7) % 64]) || (mem[(i + 1) % 256] && inp[(i + 13) % 64]);

    for (int i = 0; i < 32; i++) {
        bool clk = mem[i * 8];
        bool rise = clk && !clk_old[i];
        clk_old[i] = clk;
        latch[i] = rise || (latch[i] && !(inp[i] && mem[i * 8 + 3]));
    }
    for (int i = 0; i < 256; i++) {
        if (latch[i % 32])
            outp[i] = mem[i] ^ mem[255 - i];
        else
            outp[i] = mem[i] || !outp[i];
    }
    int32_t n = 0;
    for (int i = 0; i < 256; i++)
        n += outp[i] * (i + 1);
    check += n;
    if (check > 1000000)
        check -= 1000000;
}
