/* Sieve of Eratosthenes up to a limit that moves from scan to scan */
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define SIZE 2047

static bool composite[SIZE + 1];
static int top = 1500;

void scan(void)
{
    top += 7;
    if (top > SIZE)
        top -= 600;

    memset(composite, 0, top + 1);

    for (int i = 2; i * i <= top; i++)
        if (!composite[i])
            for (int k = i * i; k <= top; k += i)
                composite[k] = true;

    int count = 0;
    uint32_t hash = 0;
    for (int i = 2; i <= top; i++)
        if (!composite[i]) {
            count++;
            hash = hash * 31 + i;
        }
    check = (int32_t)(hash + count);
}
