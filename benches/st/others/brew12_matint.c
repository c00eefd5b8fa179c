/* Blending: recipes x ingredients times ingredients x properties. */
#include <stdbool.h>
#include <stdint.h>
#include "st.h"

#define N 32

static int16_t recipe[N][N], prop[N][N];
static int32_t blend[N][N];
static bool init_done;
static int row, scans;

static void init(void)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            recipe[i][j] = (int16_t)(((i + 1) * 7 + (j + 1) * 3) % 100 - 40);
            prop[i][j] = (int16_t)(((i + 1) * 5 + (j + 1) * 11) % 90 - 30);
        }
    init_done = true;
}

void scan(void)
{
    if (!init_done)
        init();

    scans = (scans + 1) % 1000;
    for (int j = 0; j < N; j++) {
        recipe[row][j] = (int16_t)((scans + (j + 1) * 13) % 120 - 50);
        prop[j][row] = (int16_t)((scans * 3 + (j + 1) * 17) % 110 - 45);
    }
    row = (row + 1) % N;

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            int32_t sum = 0;
            for (int k = 0; k < N; k++)
                sum += recipe[i][k] * prop[k][j];
            blend[i][j] = sum;
        }

    uint32_t total = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            total = total * 3u + (uint32_t)blend[i][j];
    check = (int32_t)((uint32_t)check * 31u + total);
}
