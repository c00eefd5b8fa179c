#include "st.h"
#include <stdbool.h>

static uint32_t next_random(uint32_t seed) { return seed * 1664525u + 1013904223u; }

static uint32_t seed = 12345;
static bool inp[264], layer1[260], layer2[256], latch[256];

void scan(void)
{
    for (int i = 0; i < 8; i++) {
        seed = next_random(seed);
        uint32_t bits = seed;
        for (int j = 0; j < 32; j++) {
            inp[i * 32 + j] = bits & 0x80000000u;
            bits <<= 1;
        }
    }
    for (int i = 0; i < 8; i++)
        inp[256 + i] = inp[i];
    for (int i = 0; i < 260; i++)
        layer1[i] = (inp[i] & inp[i + 1]) | (!inp[i + 2] & inp[i + 4]);
    for (int i = 0; i < 256; i++)
        layer2[i] = (layer1[i] ^ layer1[i + 3]) & !(layer1[i + 1] & layer1[i + 2] & layer1[i + 4]);
    for (int i = 0; i < 256; i++)
        latch[i] = (latch[i] | layer2[i]) & !(inp[i + 5] & layer1[i]);
    int ones = 0;
    uint32_t hash = 0;
    for (int i = 0; i < 256; i++) {
        ones += latch[i];
        hash = (hash << 3 | hash >> 29) ^ (latch[i] ^ layer2[i]);
    }
    check = (check + ones + (int32_t)(hash & 0xffff)) % 1000003;
}
