#include "st.h"
#define SIZE 8190
static unsigned char flags[SIZE + 1];
static int scans;
static unsigned sieve(void) {
    unsigned count = 0;
    for (unsigned i = 0; i <= SIZE; i++) flags[i] = 1;
    for (unsigned i = 0; i <= SIZE; i++)
        if (flags[i]) {
            unsigned prime = i + i + 3;
            for (unsigned k = i + prime; k <= SIZE; k += prime) flags[k] = 0;
            count++;
        }
    return count;
}
void scan(void) {
    scans++;
    check += (int)sieve();
    check = (check + flags[scans % 8191]) % 999983;
}
