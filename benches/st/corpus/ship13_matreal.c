#include <math.h>
#include <stdbool.h>
#include "st.h"

#define N 32

static float a[N][N], b[N][N], c[N][N];
static bool ready;
static int16_t scans;
static uint32_t crc;

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                a[i][j] = (float)((i * 13 + j * 7) % 201 - 100) * 0.013f;
                b[i][j] = (float)((i * 5 + j * 11) % 151 - 75) * 0.021f;
            }
        }
        ready = true;
    }

    scans = (scans + 1) % 1024;
    a[scans / 32][scans % 32] = (float)scans * 0.003f - 1.5f;
    b[scans % 32][scans / 32] = 1.2f - (float)scans * 0.002f;

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            float sum = 0.0f;
            for (int k = 0; k < N; k++)
                sum += a[i][k] * b[k][j];
            c[i][j] = sum;
        }
    }

    float trace = 0.0f;
    for (int i = 0; i < N; i++) {
        float row = 0.0f;
        for (int j = 0; j < N; j++)
            row += fabsf(c[i][j]);
        trace += c[i][i];
        crc = crc * 3 + (uint32_t)(int32_t)lrintf(row * 100.0f);
    }
    crc += (uint32_t)(int32_t)lrintf(trace * 1000.0f);
    check = (int32_t)crc;
}
