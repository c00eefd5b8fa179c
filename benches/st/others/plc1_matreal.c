#include <stdbool.h>
#include "st.h"

static int32_t scanNo;
static bool first = true;
static float a[32][32], b[32][32], c[32][32];

void scan(void)
{
    int32_t i, j, k;
    float s, total;

    if (first) {
        for (i = 0; i < 32; i++) {
            for (j = 0; j < 32; j++) {
                a[i][j] = (float)((i * 7 + j * 3) % 101 - 50) * 0.125f;
                b[i][j] = (float)((i * 5 + j * 11) % 97 - 48) * 0.1f;
            }
        }
        first = false;
    }

    scanNo++;
    for (i = 0; i < 32; i++)
        a[i][(scanNo + i) % 32] = (float)((scanNo + i * 13) % 199 - 99) * 0.05f;

    for (i = 0; i < 32; i++) {
        for (j = 0; j < 32; j++) {
            s = 0.0f;
            for (k = 0; k < 32; k++)
                s += a[i][k] * b[k][j];
            c[i][j] = s;
        }
    }

    total = 0.0f;
    for (i = 0; i < 32; i++)
        for (j = 0; j < 32; j++)
            total += c[i][j];
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)(total * 10.0f));
}
