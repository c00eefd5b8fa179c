/* blending: 32 x 32 matrix product in REAL */
#include <stdbool.h>
#include "st.h"

static bool Init;
static float Blend[32][32], Tank[32][32], Result[32][32];
static int16_t Row;

void scan(void)
{
    int16_t i, j, k;
    float Sum;

    if (!Init) {
        for (i = 0; i < 32; i++) {
            for (j = 0; j < 32; j++) {
                Blend[i][j] = (float)(((i + 1) * 3 + (j + 1) * 5) % 17) * 0.25f - 1.5f;
                Tank[i][j] = (float)(((i + 1) * 11 + (j + 1) * 2) % 23) * 0.125f;
            }
        }
        Init = true;
    }

    /* level of one tank row drifts */
    for (j = 0; j < 32; j++)
        Tank[Row][j] = Tank[Row][j] * 0.9f + 0.3f;
    Row = Row + 1;
    if (Row >= 32)
        Row = 0;

    for (i = 0; i < 32; i++) {
        for (j = 0; j < 32; j++) {
            Sum = 0.0f;
            for (k = 0; k < 32; k++)
                Sum = Sum + Blend[i][k] * Tank[k][j];
            Result[i][j] = Sum;
        }
    }

    Sum = 0.0f;
    for (i = 0; i < 32; i++)
        Sum = Sum + Result[i][i] + Result[i][31 - i] * 0.5f + Result[Row][i];
    check = (check + (int32_t)(Sum * 10.0f)) % 1000000;
}
