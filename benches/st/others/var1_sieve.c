#include <stdbool.h>
#include "st.h"
#define LIMIT 5000
static bool composite[LIMIT + 1];
static int32_t rnd;
void scan(void)
{
    static int32_t last;
    rnd = (rnd + 1) % 16;
    int32_t top = LIMIT - rnd, count = 0, sum = 0, i = 0;
    while (i <= top) {
        composite[i] = false;
        i++;
    }
    i = 2;
    while (i <= top) {
        if (!composite[i]) {
            count++;
            sum += i;
            last = i;
            int32_t j = i * i;
            while (j <= top) {
                composite[j] = true;
                j += i;
            }
        }
        i++;
    }
    check = (check % 100003) * 3 + count + sum + last;
}
