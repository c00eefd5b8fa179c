/* Runs `scan` for a while and prints the nanoseconds of CPU time that one takes, the best of several repetitions. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "plc.h"

uint8_t I[2048], Q[2048], M[2048], DB1[64], DB2[64], DB5[64], DB10[256];
uint64_t now_us;

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return time.tv_sec * 1e9 + time.tv_nsec;
}

/* Prints the outputs and the bit memory that are compared with those of the program in STL. */
static void print_memory(void)
{
    for (int byte = 0; byte < 64; byte++)
        printf("%02x", Q[byte]);
    for (int byte = 0; byte < 256; byte++)
        printf("%02x", M[byte]);
    printf("\n");
}

int main(int count, char **words)
{
    long scans = count > 1 ? atol(words[1]) : 1000;
    int repetitions = count > 2 ? atoi(words[2]) : 10;
    double best = 1e300;
    uint32_t state = 99;
    for (int byte = 0; byte < 2048; byte++) {
        state = state * 1664525u + 1013904223u;
        I[byte] = (uint8_t)(state >> 16);
    }
    put16(DB5, 42);
    for (int repetition = 0; repetition < repetitions; repetition++) {
        double start = now();
        for (long index = 0; index < scans; index++) {
            now_us += 10000;
            scan();
            __asm__ volatile("" ::: "memory");
        }
        double time = (now() - start) / (double)scans;
        if (time < best)
            best = time;
    }
    if (count > 3)
        print_memory();
    else
        printf("%.3f\n", best);
    return 0;
}
