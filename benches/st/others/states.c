#include "st.h"
struct valve { uint8_t open, reset, moving, fault; int16_t position, state, ticks; };
static struct valve v[200];
static int32_t scans;
static void valve(struct valve *v)
{
    switch (v->state) {
    case 0: v->moving = 0; if (v->open) { v->state = 1; v->ticks = 0; } break;
    case 1: v->moving = 1; v->position += 10; v->ticks++;
        if (v->position >= 100) { v->position = 100; v->state = 2; } else if (v->ticks > 20) v->state = 9;
        break;
    case 2: v->moving = 0; if (!v->open) v->state = 3; break;
    case 3: v->moving = 1; v->position = v->position - 5 > 0 ? v->position - 5 : 0; if (v->position == 0) v->state = 0; break;
    case 9: v->fault = 1; v->moving = 0; if (v->reset) { v->state = 0; v->fault = 0; v->position = 0; } break;
    default: v->state = 9;
    }
}
void scan(void)
{
    for (int i = 0; i < 200; i++) {
        v[i].open = (scans + i * 3) % 80 < 40; v[i].reset = scans % 100 == 0;
        valve(&v[i]);
        if (v[i].moving) check += v[i].position;
    }
    scans++;
}
