/* Product of two 32 x 32 matrices of integers: recipe matrix times ingredient matrix */
#include <stdbool.h>
#include "st.h"

#define SIZE 32

/* unsigned inside, as the sums are to wrap */
static uint32_t recipe[SIZE][SIZE], content[SIZE][SIZE], product[SIZE][SIZE];
static bool ready;
static int cycle;

static void mat_mul(const uint32_t a[SIZE][SIZE], const uint32_t b[SIZE][SIZE], uint32_t result[restrict SIZE][SIZE])
{
    for (int row = 0; row < SIZE; row++) {
        for (int col = 0; col < SIZE; col++) {
            uint32_t acc = 0;
            for (int k = 0; k < SIZE; k++)
                acc += a[row][k] * b[k][col];
            result[row][col] = acc;
        }
    }
}

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < SIZE; i++) {
            for (int j = 0; j < SIZE; j++) {
                recipe[i][j] = (uint32_t)((i * 7 + j * 3) % 41 - 20);
                content[i][j] = (uint32_t)((i * 5 + j * 11) % 37 - 18);
            }
        }
        ready = true;
    }

    recipe[cycle][cycle * 3 % SIZE] += 1;
    content[cycle * 5 % SIZE][cycle] -= 2;

    mat_mul(recipe, content, product);

    uint32_t trace = 0;
    for (int i = 0; i < SIZE; i++)
        trace = trace * 3 + product[i][i] + product[i][SIZE - 1 - i];
    check = (int32_t)((uint32_t)check * 31u + trace + product[cycle][7]);
    cycle = (cycle + 1) % SIZE;
}
