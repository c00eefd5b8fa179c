/* product of two 32 x 32 INT matrices; elements change from scan to scan, some by what the last product was */
#include <stdbool.h>
#include "st.h"

#define N 32

static uint32_t seed = 777;
static int16_t a[N][N], b[N][N], c[N][N];

static inline uint32_t next_random(void)
{
    seed = seed * 1664525u + 1013904223u;
    return seed / 65536;
}

static void multiply(void)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int16_t acc = 0;
            for (int k = 0; k < N; k++)
                acc = (int16_t)(acc + a[i][k] * b[k][j]);
            c[i][j] = acc;
        }
}

void scan(void)
{
    static bool started;

    if (!started) {
        started = true;
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                a[i][j] = (int16_t)((int)(next_random() % 200) - 100);
                b[i][j] = (int16_t)((int)(next_random() % 200) - 100);
            }
    }

    int row = (int)(next_random() % 32);
    for (int j = 0; j < N; j++)
        a[row][j] = (int16_t)((int)(next_random() % 200) - 100);

    multiply();

    /* the largest element of each row decides which element of b is changed */
    uint32_t hash = 0;
    for (int i = 0; i < N; i++) {
        const int16_t *line = c[i];
        int16_t top = line[0];
        int at = 0;
        for (int j = 1; j < N; j++)
            if (line[j] > top) {
                top = line[j];
                at = j;
            }
        hash = hash * 3 + (uint32_t)(top + at);
        if (top > 20000)
            b[i][at] = (int16_t)-b[i][at];
        else if (top % 2 == 0)
            b[at][i] = (int16_t)((b[at][i] + i) % 100);
        for (int j = 0; j < N; j++)
            hash += (uint32_t)line[j];
    }
    check = (int32_t)((uint32_t)check * 31u + hash);
}
