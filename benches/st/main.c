/* Runs `scan` so many times, 10 ms apart, and prints the nanoseconds of CPU time that one takes, and `check` behind the last one;
   with a second word on the command line it prints `check` behind each of them. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "st.h"

uint64_t now_us;
int32_t check;

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return time.tv_sec * 1e9 + time.tv_nsec;
}

int main(int count, char **words)
{
    long scans = count > 1 ? atol(words[1]) : 1000;
    if (count > 2) {
        for (long index = 0; index < scans; index++) {
            now_us += 10000;
            scan();
            printf("%d\n", check);
        }
        return 0;
    }
    double start = now();
    for (long index = 0; index < scans; index++) {
        now_us += 10000;
        scan();
        __asm__ volatile("" ::: "memory");
    }
    printf("%.3f %d\n", (now() - start) / (double)scans, check);
    return 0;
}
