/* bits in words */
#include <stdbool.h>
#include "st.h"
typedef struct { int16_t src; uint16_t mask, want, trip; } cause_t;
static cause_t tab[960];
static uint16_t inp[4], effect[60], first[60], old[60], s;
static bool filled;
static uint32_t seed = 4711;
static inline uint16_t rol16(uint16_t x, int n) { return (uint16_t)((x << n) | (x >> (16 - n))); }
static inline uint16_t ror16(uint16_t x, int n) { return (uint16_t)((x >> n) | (x << (16 - n))); }
static inline bool bit(uint16_t x, int n) { return (x >> n) & 1; }
static inline void put(uint16_t *x, int n, bool v) { *x = (uint16_t)((*x & ~(1u << n)) | ((unsigned)v << n)); }
void scan(void)
{
    if (!filled) {
        for (int i = 0; i < 960; i++) {
            seed = seed * 1664525u + 1013904223u;
            tab[i].src = (int16_t)((seed / 65536u) % 4u);
            tab[i].mask = (uint16_t)(7u << (i % 14));
            tab[i].want = (uint16_t)(seed >> 9) & tab[i].mask;
            tab[i].trip = (uint16_t)(3u << ((i * 5) % 15));
        }
        filled = true;
    }
    seed = seed * 1664525u + 1013904223u;
    inp[0] = (uint16_t)(seed >> 16);
    inp[1] = inp[0] ^ rol16(inp[1], 3);
    inp[2] = (uint16_t)((inp[1] & ~inp[0]) | ror16(inp[3], 1));
    inp[3] = (inp[3] ^ inp[1]) | inp[2];

    for (int16_t w = 0; w < 60; w++) {
        uint16_t acc = effect[w], b1 = 1;
        for (int16_t b = 0; b < 16; b++) {
            const cause_t *t = &tab[w * 16 + b];
            uint16_t x = inp[t->src];
            if ((x & t->mask) == t->want)
                acc |= b1;
            else if ((x & t->trip) == t->trip)
                acc &= (uint16_t)~b1;
            b1 = (uint16_t)(b1 << 1);
        }
        old[w] = effect[w];
        effect[w] = acc;
        first[w] = acc & (uint16_t)~old[w];
    }
    put(&s, 0, (bit(effect[0], 0) & bit(effect[0], 1)) | bit(inp[0], 15));
    put(&s, 1, bit(effect[0], 2) & !bit(effect[1], 2));
    put(&s, 2, (bit(effect[1], 3) | bit(s, 2)) & !bit(inp[1], 4));
    put(&s, 3, bit(s, 0) ^ bit(s, 1));
    put(&s, 4, bit(first[2], 5) | bit(first[3], 6) | bit(first[4], 7));
    put(&s, 5, (bit(s, 4) | bit(s, 5)) & !(bit(inp[2], 8) & bit(inp[3], 9)));
    put(&s, 6, bit(effect[5], 10) & bit(effect[6], 11) & bit(effect[7], 12));
    put(&s, 7, (bit(s, 5) & !bit(s, 6)) | bit(effect[8], 13));
    put(&s, 8, (bit(effect[9], 14) | bit(effect[9], 15)) & bit(s, 2));
    put(&s, 9, !bit(s, 8) & bit(s, 3));
    put(&s, 10, (bit(s, 7) & bit(s, 9)) | (bit(s, 10) & !bit(inp[0], 0)));
    put(&s, 11, bit(s, 10) ^ bit(s, 0));

    int32_t sum = (int16_t)s;
    for (int16_t w = 0; w < 60; w++)
        sum += (int16_t)effect[w] + 3 * (int16_t)(first[w] & 0x0FFF);
    check = (check % 100003) * 7 + sum;
}
