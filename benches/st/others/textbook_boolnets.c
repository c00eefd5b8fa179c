#include "st.h"
#include <stdbool.h>
#include <stdint.h>
#define MOTORS 64
#define WIDTH 16

typedef struct { bool run, fault, last; } motor_t;

static uint16_t state = 0xACE1;
static bool sensor[MOTORS + 2];
static motor_t motor[MOTORS];

static bool next_bit(void) {
    bool bit = state & 1;
    state >>= 1;
    if (bit) state ^= 0xB400;
    return bit;
}

static bool vote(bool a, bool b, bool c) { return (a && b) || (a && c) || (b && c); }

static void motor_step(motor_t *m, bool start, bool stop, bool overload, bool ack, bool permit) {
    bool edge = start && !m->last;
    m->last = start;
    m->fault = overload || (m->fault && !ack);
    m->run = (edge || m->run) && !stop && !m->fault && permit;
}

void scan(void) {
    for (int i = 0; i < MOTORS + 2; i++) sensor[i] = next_bit();
    int running = 0, faults = 0, sum_bits = 0;
    bool parity = false;
    for (int i = 0; i < MOTORS; i++) {
        bool a = sensor[i], b = sensor[i + 1], c = sensor[i + 2];
        motor_step(&motor[i], a, a && b && c, !vote(a, b, c) && sensor[0] && sensor[1], c, a || b || c);
        running += motor[i].run;
        faults += motor[i].fault;
        parity ^= motor[i].run;
    }
    bool carry = parity;
    for (int i = 0; i < WIDTH; i++) {
        bool a = motor[i].run, b = motor[i + WIDTH].run;
        bool sum = a ^ b ^ carry;
        carry = (a && b) || (carry && (a ^ b));
        if (sum) sum_bits += i + 1;
    }
    check = (check * 3 + running * 7 + faults * 5 + sum_bits) % 1000003;
}
