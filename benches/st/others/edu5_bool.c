#include <stdbool.h>
#include "st.h"

typedef struct {
    bool running, alarm, lamp, ready;
    bool last_start, last_permit_off;
    bool service, toggle, horn;
} Motor;

static Motor motors[40];
static uint32_t seed = 1;

static void motor(Motor *m, bool start, bool stop, bool fault, bool reset, bool permit)
{
    bool start_edge = start && !m->last_start;
    m->last_start = start;
    bool permit_lost = !permit && !m->last_permit_off;
    m->last_permit_off = !permit;
    m->alarm = (m->running & (fault | permit_lost)) | (m->alarm & !reset);
    m->running = (start_edge | m->running) & !stop & permit & !m->alarm;
    m->service = !(reset & !fault) & ((m->alarm & stop) | m->service);
    m->toggle ^= start_edge;
    m->horn = (m->alarm & !m->service) | (m->horn & !reset & !stop);
    m->lamp = (m->running & !m->alarm) | (m->alarm & m->toggle) | (m->horn ^ m->service);
    m->ready = permit & !(m->running | m->alarm | m->horn);
}

void scan(void)
{
    int count = 0;
    bool previous = true;
    for (int i = 1; i <= 40; i++) {
        Motor *m = &motors[i - 1];
        seed = seed * 1103515245u + 12345u;
        motor(m, (seed & 0x10000) != 0, (seed & 0xE0000) == 0, (seed & 0xF00000) == 0,
              (seed & 0x3000000) == 0, previous || (seed & 0x8000000) != 0);
        previous = m->running;
        if (m->running) count += 1;
        if (m->alarm) count += 100;
        if (m->lamp) count += i;
        if (m->ready) count += 3 * i;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)count + 1u);
}
