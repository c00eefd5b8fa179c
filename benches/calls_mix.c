/* The same work as calls_mix.awl on the same bytes, as one would write it by hand. */
#include "plc.h"

extern uint64_t now_us;

struct timer {
    uint64_t started_us;
    uint16_t value, base;
    uint8_t running, status, edge, on_delay;
};

static struct timer T[32];
static struct { uint16_t count; uint8_t up_edge, set_edge; } C[16];

static uint16_t remaining(const struct timer *timer)
{
    static const uint64_t base_us[4] = { 10000, 100000, 1000000, 10000000 };
    if (!timer->running)
        return timer->value;
    uint64_t gone = (now_us - timer->started_us) / base_us[timer->base];
    return gone >= timer->value ? 0 : (uint16_t)(timer->value - gone);
}

static void refresh(struct timer *timer)
{
    if (timer->running && remaining(timer) == 0) {
        timer->running = 0;
        timer->value = 0;
        timer->status = timer->on_delay;
    }
}

static void start(struct timer *timer, int rlo, uint16_t value, uint16_t base, int on_delay)
{
    refresh(timer);
    if (rlo && !timer->edge) {
        timer->started_us = now_us;
        timer->value = value;
        timer->base = base;
        timer->running = 1;
        timer->on_delay = (uint8_t)on_delay;
        timer->status = !on_delay;
    } else if (!rlo) {
        timer->value = remaining(timer);
        timer->running = 0;
        timer->status = 0;
    }
    timer->edge = (uint8_t)rlo;
}

static int timer_status(struct timer *timer)
{
    refresh(timer);
    return timer->status;
}

static int16_t scale(int16_t raw, int16_t gain, int *high)
{
    int16_t result = (int16_t)(raw * gain);
    *high = result > 1000;
    return result;
}

static void motor(uint8_t *db, int on, int feedback)
{
    put_bit(db, 0, 0, on);
    put_bit(db, 0, 1, feedback);
    int run = on & !get_bit(db, 2, 1);
    put_bit(db, 2, 0, run);
    int edge = run & !get_bit(db, 6, 0);
    put_bit(db, 6, 0, run);
    if (edge)
        put16(db + 4, (uint16_t)(get16(db + 4) + 1));
    start(&T[10], run & !feedback, 50, 0, 1);
    int fault = timer_status(&T[10]);
    if (fault)
        put_bit(db, 2, 1, 1);
    if (fault & !on)
        put_bit(db, 2, 1, 0);
}

static void last(void)
{
    if (get_bit(Q, 0, 0) | get_bit(Q, 0, 2))
        return;
    M[21] = M[20] & 0x0F;
}

void scan(void)
{
    int high;
    put16(DB5 + 2, (uint16_t)scale((int16_t)get16(M + 10), (int16_t)get16(DB5), &high));
    put_bit(M, 0, 1, high);
    motor(DB1, get_bit(I, 0, 0), get_bit(I, 0, 1));
    put_bit(Q, 0, 0, get_bit(DB1, 2, 0));
    put_bit(Q, 0, 1, get_bit(DB1, 2, 1));
    motor(DB2, get_bit(M, 0, 1), get_bit(Q, 0, 0));
    put_bit(Q, 0, 2, get_bit(DB2, 2, 0));
    put_bit(Q, 0, 3, get_bit(DB2, 2, 1));

    int up = get_bit(I, 0, 2);
    if (up && !C[1].up_edge && C[1].count < 999)
        C[1].count++;
    C[1].up_edge = (uint8_t)up;
    if (get_bit(I, 0, 3))
        C[1].count = 0;
    put16(M + 12, C[1].count);

    start(&T[1], get_bit(I, 0, 4), 200, 0, 0);
    put_bit(Q, 0, 4, timer_status(&T[1]));

    put16(DB5 + 6, get16(M + 10));
    uint16_t word = get16(DB5 + 4);
    put16(DB5 + 4, (uint16_t)((word & 0xFF00) | (uint8_t)(word + 1)));
    last();
    put16(M + 10, (uint16_t)(get16(M + 10) + 3));
}
