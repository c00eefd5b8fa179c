#include "st.h"
#include <stdbool.h>

#define N 32
static int16_t recipes[N][N], orders[N][N];
static int32_t needs[N][N];
static int16_t scans;
static bool init;

static void update(int16_t m[N][N], int n)
{
    int16_t *row = m[n % N];
    for (int c = 0; c < N; c++)
        row[c] = (int16_t)((row[c] + (c + 1) * 3 + n) % 100);
}

static void multiply(int16_t a[N][N], int16_t b[N][N], int32_t c[N][N])
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
}

static int32_t total(int32_t c[N][N])
{
    int32_t sum = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sum += c[i][j] * (i - j + 1);
    return sum;
}

void scan(void)
{
    if (!init) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                recipes[i][j] = (int16_t)(((i + 1) * 7 + (j + 1) * 3) % 41 - 10);
                orders[i][j] = (int16_t)(((i + 1) * 5 + (j + 1) * 11) % 53 - 20);
            }
        init = true;
    }
    scans = (int16_t)((scans + 1) % 1000);
    update(recipes, scans);
    update(orders, scans + 5);
    multiply(recipes, orders, needs);
    check = (int32_t)((uint32_t)check * 3u + (uint32_t)total(needs));
}
