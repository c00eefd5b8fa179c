#include <stdbool.h>
#include "st.h"

static int16_t values[64];
static uint16_t words[64];
static int scan_no;

static bool bit(uint16_t w, int n)
{
    return w >> n & 1;
}

static uint16_t with(uint16_t w, int n, bool on)
{
    return (uint16_t)((w & ~(1 << n)) | on << n);
}

static uint16_t status(int value, int limit, uint16_t old)
{
    uint16_t s = old & 0x8421;
    s = with(s, 0, value > limit);
    if (value < 0) {
        s = with(s, 1, true);
        s = with(s, 15, false);
    }
    uint8_t half = 0x50;
    if (value % 2 == 0)
        half = (uint8_t)with(half, 0, bit(s, 5));
    else
        half = (uint8_t)with(half, 7, !bit(s, 10));
    if (value % 3 == 0)
        s |= (uint16_t)(half << 4);
    s = with(s, 2, bit(half, 0) || bit(s, 7));
    if (bit(s, 1) && value < -limit)
        s = with(s, 9, !bit(s, 9));
    return s;
}

void scan(void)
{
    scan_no = (scan_no + 7) % 1000;
    for (int i = 0; i < 64; i++)
        values[i] = (int16_t)((scan_no * 3 + i * 37) % 401 - 200);
    for (int i = 0; i < 64; i++)
        words[i] = status(values[i], 50, words[i]);
    for (int i = 0; i < 64; i++)
        check = (int32_t)((uint32_t)check * 31u + words[i]);
}
