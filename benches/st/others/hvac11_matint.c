/* Influence of 32 valves upon 32 zones: product of two matrices of int16_t */
#include <stdbool.h>
#include "st.h"

#define ZONES 32

static int16_t coupling[ZONES][ZONES];
static int16_t response[ZONES][ZONES];
static int32_t influence[ZONES][ZONES];
static int16_t scan_counter;
static bool initialized;

static void init(void)
{
    for (int i = 0; i < ZONES; i++) {
        for (int j = 0; j < ZONES; j++) {
            coupling[i][j] = (int16_t)(((i + 1) * 7 + (j + 1) * 3) % 101 - 50);
            response[i][j] = (int16_t)(((i + 1) * 5 + (j + 1) * 11) % 97 - 48);
        }
    }
}

void scan(void)
{
    if (!initialized) {
        init();
        initialized = true;
    }

    scan_counter = (int16_t)((scan_counter + 1) % 1000);
    int zone = scan_counter % ZONES;
    for (int j = 0; j < ZONES; j++) {
        coupling[zone][j] = (int16_t)((coupling[zone][j] + j + 1 + scan_counter) % 200);
        response[j][zone] = (int16_t)((response[j][zone] + scan_counter) % 150);
    }

    for (int i = 0; i < ZONES; i++) {
        for (int j = 0; j < ZONES; j++) {
            int32_t total = 0;
            for (int k = 0; k < ZONES; k++)
                total += coupling[i][k] * response[k][j];
            influence[i][j] = total;
        }
    }

    uint32_t sum = (uint32_t)check;
    for (int i = 0; i < ZONES; i++) {
        int32_t total = 0;
        for (int j = 0; j < ZONES; j++)
            total += influence[i][j] * (j + 1);
        sum = sum * 31u + (uint32_t)total;
    }
    check = (int32_t)sum;
}
