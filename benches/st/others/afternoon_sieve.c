#include "st.h"
#include <stdbool.h>
static bool comp[10000];
static int scans;
void scan(void) {
    scans++;
    for (int i = 0; i < 10000; i++) comp[i] = false;
    int cnt = 0;
    for (int i = 2; i < 10000; i++)
        if (!comp[i]) {
            cnt += i % 10 + 1;
            for (int j = i + i; j < 10000; j += i) comp[j] = true;
        }
    check = (check + cnt * (scans % 7)) % 1000000;
}
