#include <stdbool.h>
#include "st.h"

static int32_t scanNo;
static bool first = true;
static int16_t a[32][32], b[32][32];
static int32_t c[32][32];

void scan(void)
{
    int32_t i, j, k, s, total;

    if (first) {
        for (i = 0; i < 32; i++) {
            for (j = 0; j < 32; j++) {
                a[i][j] = (int16_t)((i * 7 + j * 3) % 101 - 50);
                b[i][j] = (int16_t)((i * 5 + j * 11) % 97 - 48);
            }
        }
        first = false;
    }

    scanNo++;
    for (i = 0; i < 32; i++)
        a[i][(scanNo + i) % 32] = (int16_t)((scanNo + i * 13) % 199 - 99);

    for (i = 0; i < 32; i++) {
        for (j = 0; j < 32; j++) {
            s = 0;
            for (k = 0; k < 32; k++)
                s += (int32_t)a[i][k] * (int32_t)b[k][j];
            c[i][j] = s;
        }
    }

    total = 0;
    for (i = 0; i < 32; i++) {
        for (j = 0; j < 32; j++)
            total += c[i][j] % 1000;
        total += c[i][i];
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)total);
}
