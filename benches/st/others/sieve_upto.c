#include <stdbool.h>
#include <string.h>
#include "st.h"

#define SIZE 8000

static bool prime[SIZE + 1];
static int scans;

void scan(void)
{
    scans++;
    int top = SIZE - scans % 100;
    memset(prime + 2, true, top - 1);
    for (int i = 2; i * i <= top; i++)
        if (prime[i])
            for (int k = i * i; k <= top; k += i)
                prime[k] = false;
    int number = 0, last = 0;
    for (int i = 2; i <= top; i++)
        if (prime[i]) {
            number++;
            last = i;
        }
    check = (check * 31 + number + last) % 1000003;
}
