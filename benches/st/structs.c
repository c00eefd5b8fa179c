/* The same work as structs.st. */
#include "st.h"

struct item {
    int32_t key;
    float value;
    int16_t count;
    uint8_t used;
};

static struct item items[100];
static int32_t scans;

void scan(void)
{
    for (int32_t i = 0; i < 100; i++) {
        items[i].key = (items[i].key * 75 + i + scans) % 65537;
        items[i].value = items[i].value * 0.5f + (float)i;
        items[i].count++;
        items[i].used = items[i].key > 30000;
    }
    for (int32_t pass = 1; pass <= 20; pass++)
        for (int32_t i = 0; i < 99; i++)
            if (items[i].key > items[i + 1].key) {
                struct item swap = items[i];
                items[i] = items[i + 1];
                items[i + 1] = swap;
            }
    for (int32_t i = 0; i < 100; i++)
        if (items[i].used)
            check += items[i].key % 16;
    scans++;
}
