#include "st.h"
struct motor { uint8_t start, stop, overload, run, lamp; int16_t starts; };
static struct motor m[101];
static int16_t scans;
static uint8_t blink;
void scan(void)
{
    int16_t running = 0;
    blink = !blink;
    for (int i = 1; i <= 100; i++) {
        struct motor *p = &m[i];
        p->start = (i + scans) % 11 == 0;
        p->stop = (i * 7 + scans) % 13 == 0;
        p->overload = (i + scans) % 37 == 5;
        if (p->start && !p->run && !p->stop)
            p->starts++;
        p->run = (p->start | p->run) & !p->stop & !p->overload;
        p->lamp = p->run | (p->overload & blink);
        if (p->run) running++;
        if (p->lamp) check++;
    }
    check += running + m[50].starts;
    scans++;
}
