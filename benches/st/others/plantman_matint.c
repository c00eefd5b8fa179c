/* recipe matrix (INT) times order matrix (INT) gives demand (DINT) */
#include <stdbool.h>
#include "st.h"

static bool Init;
static int16_t Recipe[32][32], Orders[32][32];
static int32_t Demand[32][32];
static int16_t Cycle;

void scan(void)
{
    int16_t i, j, k;
    int32_t Sum;

    if (!Init) {
        for (i = 0; i < 32; i++) {
            for (j = 0; j < 32; j++) {
                Recipe[i][j] = (i * 7 + j * 3) % 50 - 20;
                Orders[i][j] = (i * 5 + j * 11) % 60 - 25;
            }
        }
        Init = true;
    }

    /* one order line changes per cycle */
    Cycle = (Cycle + 1) % 32;
    for (j = 0; j < 32; j++)
        Orders[Cycle][j] = (Orders[Cycle][j] + j + 3) % 100;

    for (i = 0; i < 32; i++) {
        for (j = 0; j < 32; j++) {
            Sum = 0;
            for (k = 0; k < 32; k++)
                Sum = Sum + (int32_t)Recipe[i][k] * (int32_t)Orders[k][j];
            Demand[i][j] = Sum;
        }
    }

    Sum = 0;
    for (i = 0; i < 32; i++)
        Sum = Sum + Demand[i][i] - Demand[i][31 - i] + Demand[Cycle][i];
    check = (int32_t)((uint32_t)check * 3u + (uint32_t)Sum);
}
