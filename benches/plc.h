/* Memory of a controller as bytes in its own order, and how to reach it: what the benchmarks in C share. */
#include <stdint.h>
#include <string.h>

extern uint8_t I[2048], Q[2048], M[2048], DB1[64], DB2[64], DB5[64], DB10[256];

static inline uint16_t get16(const uint8_t *at)
{
    uint16_t value;
    memcpy(&value, at, 2);
    return __builtin_bswap16(value);
}

static inline void put16(uint8_t *at, uint16_t value)
{
    value = __builtin_bswap16(value);
    memcpy(at, &value, 2);
}

static inline uint32_t get32(const uint8_t *at)
{
    uint32_t value;
    memcpy(&value, at, 4);
    return __builtin_bswap32(value);
}

static inline void put32(uint8_t *at, uint32_t value)
{
    value = __builtin_bswap32(value);
    memcpy(at, &value, 4);
}

static inline int get_bit(const uint8_t *area, int byte, int bit)
{
    return area[byte] >> bit & 1;
}

static inline void put_bit(uint8_t *area, int byte, int bit, int value)
{
    area[byte] = (uint8_t)((area[byte] & ~(1 << bit)) | value << bit);
}

/* One scan of the program. */
void scan(void);
