/* Heat exchange between 32 zones: product of two matrices of float */
#include <math.h>
#include <stdbool.h>
#include "st.h"

#define ZONES 32

static float heat_transfer[ZONES][ZONES];
static float air_exchange[ZONES][ZONES];
static float coupling[ZONES][ZONES];
static int scan_counter;
static bool initialized;

static void init(void)
{
    for (int i = 0; i < ZONES; i++) {
        for (int j = 0; j < ZONES; j++) {
            heat_transfer[i][j] = (float)(((i + 1) * 7 + (j + 1) * 3) % 101) * 0.01f;
            air_exchange[i][j] = (float)(((i + 1) * 5 + (j + 1) * 11) % 97) * 0.02f;
        }
    }
}

void scan(void)
{
    if (!initialized) {
        init();
        initialized = true;
    }

    scan_counter = (scan_counter + 1) % 1000;
    int zone = scan_counter % ZONES;
    for (int j = 0; j < ZONES; j++) {
        heat_transfer[zone][j] = heat_transfer[zone][j] * 0.9f + (float)(scan_counter % 17) * 0.03f;
        air_exchange[j][zone] = air_exchange[j][zone] * 0.8f + (float)(scan_counter % 13) * 0.05f;
    }

    for (int i = 0; i < ZONES; i++) {
        for (int j = 0; j < ZONES; j++) {
            float total = 0.0f;
            for (int k = 0; k < ZONES; k++)
                total += heat_transfer[i][k] * air_exchange[k][j];
            coupling[i][j] = total;
        }
    }

    uint32_t sum = (uint32_t)check;
    for (int i = 0; i < ZONES; i++) {
        float total = 0.0f;
        for (int j = 0; j < ZONES; j++)
            total += coupling[i][j] * (float)(j + 1);
        sum = sum * 31u + (uint32_t)(int32_t)lrintf(total * 100.0f);
    }
    check = (int32_t)sum;
}
