#include "st.h"
struct rec { int32_t key; float val; int16_t cnt; uint8_t used, name[4]; };
static struct rec t[128];
static int32_t scans;
void scan(void)
{
    for (int j = 0; j < 50; j++) {
        int32_t key = (scans * 7 + j * 13) % 100 + 1;
        int i = key % 128;
        while (t[i].used && t[i].key != key)
            i = (i + 1) % 128;
        if (!t[i].used) {
            t[i].used = 1;
            t[i].key = key;
            t[i].cnt = 0;
            t[i].val = 0;
        }
        t[i].cnt++;
        t[i].val += 0.5f;
        t[i].name[j % 4] = j;
    }
    int32_t sum = 0;
    int best = 0;
    for (int i = 0; i < 128; i++) {
        if (!t[i].used)
            continue;
        if (t[i].cnt > t[best].cnt)
            best = i;
        sum += t[i].cnt;
        if (sum > 100000)
            break;
    }
    struct rec tmp = t[best];
    t[best] = t[0];
    t[0] = tmp;
    t[best] = tmp;
    for (int i = 0; i < 128; i++)
        if (t[i].cnt > 200)
            t[i].cnt = 0;
    t[0].used = 0;
    check += sum + best;
    scans++;
}
