/* The same work as arithmetic_loop.awl on the same bytes, as one would write it by hand. */
#include "plc.h"

void scan(void)
{
    int32_t pointer = 0;
    uint16_t count = 100;
    do {
        put16(M + 44, count);
        put16(DB10 + (pointer >> 3), (uint16_t)(count * 7 + get16(M + 20)));
        pointer += 16;
        put32(M + 40, (uint32_t)pointer);
    } while (--count);

    int32_t sum = 0;
    pointer = 0;
    count = 100;
    do {
        put16(M + 44, count);
        sum += (int16_t)get16(DB10 + (pointer >> 3));
        put32(M + 48, (uint32_t)sum);
        pointer += 16;
        put32(M + 40, (uint32_t)pointer);
    } while (--count);

    put32(DB10 + 200, (uint32_t)sum);
    float mean = (float)sum / 100.0f;
    uint32_t bits;
    memcpy(&bits, &mean, 4);
    put32(DB10 + 204, bits);
    put16(M + 20, (uint16_t)(get16(M + 20) + 1));
}
