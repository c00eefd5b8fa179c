#include "st.h"
#include <stdbool.h>

typedef struct { bool start, stop, reset, trip; int16_t speed_ref; } MotorCmd;
typedef struct { bool running, fault; int16_t speed; int32_t starts, ticks; } MotorSts;
typedef struct { bool q, m; } Rising;
typedef struct { int32_t total; int16_t sub; } RunMeter;
typedef struct { Rising start_edge, reset_edge; RunMeter meter; } Motor;
typedef struct { bool all_running; int32_t speed_sum; Motor m1, m2, m3, m4, m5, m6; } Line;

static void rising(Rising *b, bool clk)
{
    b->q = clk && !b->m;
    b->m = clk;
}

static void run_meter(RunMeter *b, bool run)
{
    if (run) {
        b->sub++;
        if (b->sub >= 10) {
            b->sub = 0;
            b->total++;
        }
    }
}

static int16_t min16(int16_t a, int16_t b) { return a < b ? a : b; }
static int16_t max16(int16_t a, int16_t b) { return a > b ? a : b; }

static void motor(Motor *b, MotorCmd cmd, bool permit, MotorSts *sts)
{
    int16_t target;
    rising(&b->start_edge, cmd.start);
    rising(&b->reset_edge, cmd.reset);
    if (cmd.trip)
        sts->fault = true;
    else if (b->reset_edge.q)
        sts->fault = false;
    if (sts->fault || cmd.stop || !permit) {
        sts->running = false;
    } else if (b->start_edge.q && !sts->running) {
        sts->running = true;
        sts->starts++;
    }
    if (sts->running)
        target = min16(max16(cmd.speed_ref, 0), 1500);
    else
        target = 0;
    if (sts->speed < target)
        sts->speed = min16(sts->speed + 50, target);
    else if (sts->speed > target)
        sts->speed = max16(sts->speed - 80, target);
    run_meter(&b->meter, sts->running);
    sts->ticks = b->meter.total;
}

static MotorCmd make_cmd(int32_t pattern, int16_t number)
{
    MotorCmd c;
    int32_t p = (pattern + number * 7) % 97;
    c.start = p % 4 < 2;
    c.stop = p == 50;
    c.reset = p % 11 == 3;
    c.trip = p == 77;
    c.speed_ref = (int16_t)(600 + p * 12);
    return c;
}

static void line(Line *b, bool enable, int32_t pattern, MotorSts sts[6])
{
    motor(&b->m6, make_cmd(pattern, 6), enable, &sts[5]);
    motor(&b->m5, make_cmd(pattern, 5), sts[5].running, &sts[4]);
    motor(&b->m4, make_cmd(pattern, 4), sts[4].running, &sts[3]);
    motor(&b->m3, make_cmd(pattern, 3), sts[3].running, &sts[2]);
    motor(&b->m2, make_cmd(pattern, 2), sts[2].running, &sts[1]);
    motor(&b->m1, make_cmd(pattern, 1), sts[1].running && sts[2].speed > 100, &sts[0]);
    b->all_running = true;
    b->speed_sum = 0;
    for (int i = 0; i < 6; i++) {
        b->all_running = b->all_running && sts[i].running;
        b->speed_sum += sts[i].speed;
    }
}

static int32_t tick;
static Line line_a, line_b, line_c, line_d, line_e;
static MotorSts sts_a[6], sts_b[6], sts_c[6], sts_d[6], sts_e[6];

void scan(void)
{
    tick++;
    if (tick >= 100000)
        tick = 0;
    line(&line_a, true, tick, sts_a);
    line(&line_b, line_a.speed_sum > 500, tick + 13, sts_b);
    line(&line_c, tick % 500 < 400, tick + 29, sts_c);
    line(&line_d, !line_c.all_running, tick + 31, sts_d);
    line(&line_e, line_b.speed_sum + line_c.speed_sum > 100, tick + 57, sts_e);
    int32_t sum = line_a.speed_sum + line_b.speed_sum + line_c.speed_sum + line_d.speed_sum + line_e.speed_sum;
    for (int k = 0; k < 6; k++)
        sum += sts_a[k].starts + sts_b[k].ticks + sts_c[k].starts + sts_d[k].ticks + sts_e[k].starts;
    if (line_a.all_running)
        sum++;
    check = (int32_t)((uint32_t)check * 17u + (uint32_t)sum);
}
