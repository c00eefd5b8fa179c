/* Near infrared calibration: spectra times loadings. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include "st.h"

#define N 32

static float spectra[N][N], load[N][N], score[N][N];
static bool init_done;
static int row, scans;

static void init(void)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            spectra[i][j] = (float)(((i + 1) * 7 + (j + 1) * 3) % 100) * 0.01f - 0.4f;
            load[i][j] = (float)(((i + 1) * 5 + (j + 1) * 11) % 90) * 0.02f - 0.7f;
        }
    init_done = true;
}

void scan(void)
{
    if (!init_done)
        init();

    scans = (scans + 1) % 1000;
    for (int j = 0; j < N; j++) {
        spectra[row][j] = (float)((scans + (j + 1) * 13) % 120) * 0.01f - 0.5f;
        load[j][row] = load[j][row] * 0.9f + (float)((scans * 3 + j + 1) % 50) * 0.003f;
    }
    row = (row + 1) % N;

    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
            for (int k = 0; k < N; k++)
                sum += spectra[i][k] * load[k][j];
            score[i][j] = sum;
        }

    uint32_t total = 0;
    for (int i = 0; i < N; i++) {
        float r = 0.0f;
        for (int j = 0; j < N; j++)
            r += score[i][j] * (float)(j + 1);
        total = total * 3u + (uint32_t)(int32_t)lrintf(r * 100.0f);
    }
    check = (int32_t)((uint32_t)check * 31u + total);
}
