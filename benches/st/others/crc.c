#include "st.h"
static uint8_t buf[128];
static int32_t scans;
static uint16_t crc(uint8_t *data, int count)
{
    uint16_t c = 0xFFFF;
    for (int i = 0; i < count; i++) {
        c ^= data[i];
        for (int k = 0; k < 8; k++) c = c & 1 ? c >> 1 ^ 0xA001 : c >> 1;
    }
    return c;
}
void scan(void)
{
    for (int i = 0; i < 128; i++) buf[i] = (scans + i * 7) % 256;
    check += crc(buf, 64) % 1000;
    scans++;
}
