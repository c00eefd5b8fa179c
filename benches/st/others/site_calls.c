/* 200 calls of function blocks a scan: analog inputs, motors, control valves and totalizers with their functions. */
#include <stdbool.h>
#include "st.h"

typedef struct { float value; bool hihi, lolo, wire_break; } chan_t;
typedef struct { int16_t state; bool running, fault; int16_t starts; int32_t hours; } drive_t;
typedef struct { int16_t r1, r2; } analog_t;
typedef struct { int16_t cnt; } motor_t;
typedef struct { float pos, target; bool in_pos; } valve_t;
typedef struct { float total; int16_t pulses; } totalizer_t;

static inline float limit(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static inline int limit_int(int lo, int x, int hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static inline float scale(int raw, float lo, float hi)
{
    return lo + (float)raw * (hi - lo) / 27648.0f;
}

static inline bool in_range(float x, float lo, float hi)
{
    return x >= lo && x <= hi;
}

static inline bool hyst(float x, float on_at, float off_at, bool old)
{
    if (x > on_at)
        return true;
    if (x < off_at)
        return false;
    return old;
}

static inline int min(int a, int b) { return a < b ? a : b; }
static inline int max(int a, int b) { return a > b ? a : b; }

static inline int median3(int a, int b, int c)
{
    return max(min(a, b), min(max(a, b), c));
}

/* valve characteristic, four straight pieces */
static float char_curve(float x)
{
    if (x <= 0.0f)
        return 0.0f;
    if (x < 20.0f)
        return x * 0.25f;
    if (x < 60.0f)
        return 5.0f + (x - 20.0f) * 0.75f;
    if (x < 100.0f)
        return 35.0f + (x - 60.0f) * 1.625f;
    return 100.0f;
}

static void analog(analog_t *a, int16_t raw, float lo, float hi, float filter, chan_t *ch)
{
    int med = median3(raw, a->r1, a->r2);
    a->r2 = a->r1;
    a->r1 = raw;
    ch->wire_break = raw < 500;
    float new = scale(limit_int(0, med, 27648), lo, hi);
    ch->value += filter * (new - ch->value);
    float span = hi - lo;
    ch->hihi = hyst(ch->value, lo + span * 0.9f, lo + span * 0.85f, ch->hihi);
    ch->lolo = !hyst(ch->value, lo + span * 0.15f, lo + span * 0.1f, !ch->lolo);
}

static void motor(motor_t *m, bool start, bool stop, int16_t delay, drive_t *d)
{
    switch (d->state) {
    case 0: /* stopped */
        d->running = false;
        if (start && !stop) {
            d->state = 10;
            m->cnt = 0;
        }
        break;
    case 10: /* starting */
        m->cnt++;
        if (stop) {
            d->state = 30;
        } else if (m->cnt >= delay) {
            d->state = 20;
            d->starts = limit_int(0, d->starts + 1, 9999);
            d->running = true;
        }
        break;
    case 20: /* running */
        d->hours++;
        if (stop || !start) {
            d->state = 30;
            m->cnt = delay;
        }
        break;
    case 30: /* coasting down */
        d->running = false;
        m->cnt -= 2;
        if (m->cnt <= 0)
            d->state = 0;
        break;
    default:
        d->state = 0;
        d->fault = true;
        break;
    }
}

static float ctrl_valve(valve_t *v, float sp, bool release)
{
    v->target = release ? char_curve(limit(0.0f, sp, 100.0f)) : 0.0f;
    v->pos += limit(-4.0f, v->target - v->pos, 2.0f);
    v->in_pos = in_range(v->pos - v->target, -0.5f, 0.5f);
    return v->pos;
}

static int16_t totalizer(totalizer_t *t, float flow, bool run, float batch)
{
    if (run && in_range(flow, 0.1f, 1000.0f)) {
        t->total += flow;
        if (t->total >= batch) {
            t->total -= batch;
            t->pulses++;
        }
    }
    return t->pulses;
}

static int16_t raw[64];
static chan_t chan[50];
static drive_t drv[50];
static float valve_pos[50];
static analog_t ai[25];
static motor_t mot[25];
static valve_t vlv[25];
static totalizer_t fq[25];
static uint32_t seed = 77;
static int16_t scan_no;
static analog_t LT101;
static analog_t LT102;
static analog_t LT103;
static analog_t LT104;
static analog_t LT105;
static analog_t LT106;
static analog_t LT107;
static analog_t LT108;
static analog_t LT109;
static analog_t LT110;
static analog_t LT111;
static analog_t LT112;
static analog_t LT113;
static analog_t LT114;
static analog_t LT115;
static analog_t LT116;
static analog_t LT117;
static analog_t LT118;
static analog_t LT119;
static analog_t LT120;
static analog_t LT121;
static analog_t LT122;
static analog_t LT123;
static analog_t LT124;
static analog_t LT125;
static motor_t P201;
static motor_t P202;
static motor_t P203;
static motor_t P204;
static motor_t P205;
static motor_t P206;
static motor_t P207;
static motor_t P208;
static motor_t P209;
static motor_t P210;
static motor_t P211;
static motor_t P212;
static motor_t P213;
static motor_t P214;
static motor_t P215;
static motor_t P216;
static motor_t P217;
static motor_t P218;
static motor_t P219;
static motor_t P220;
static motor_t P221;
static motor_t P222;
static motor_t P223;
static motor_t P224;
static motor_t P225;
static valve_t CV301;
static valve_t CV302;
static valve_t CV303;
static valve_t CV304;
static valve_t CV305;
static valve_t CV306;
static valve_t CV307;
static valve_t CV308;
static valve_t CV309;
static valve_t CV310;
static valve_t CV311;
static valve_t CV312;
static valve_t CV313;
static valve_t CV314;
static valve_t CV315;
static valve_t CV316;
static valve_t CV317;
static valve_t CV318;
static valve_t CV319;
static valve_t CV320;
static valve_t CV321;
static valve_t CV322;
static valve_t CV323;
static valve_t CV324;
static valve_t CV325;
static totalizer_t FQ401;
static totalizer_t FQ402;
static totalizer_t FQ403;
static totalizer_t FQ404;
static totalizer_t FQ405;
static totalizer_t FQ406;
static totalizer_t FQ407;
static totalizer_t FQ408;
static totalizer_t FQ409;
static totalizer_t FQ410;
static totalizer_t FQ411;
static totalizer_t FQ412;
static totalizer_t FQ413;
static totalizer_t FQ414;
static totalizer_t FQ415;
static totalizer_t FQ416;
static totalizer_t FQ417;
static totalizer_t FQ418;
static totalizer_t FQ419;
static totalizer_t FQ420;
static totalizer_t FQ421;
static totalizer_t FQ422;
static totalizer_t FQ423;
static totalizer_t FQ424;
static totalizer_t FQ425;

void scan(void)
{
    int32_t sum = 0;

    scan_no = (scan_no + 1) % 32;
    for (int i = 0; i < 64; i++) {
        seed = seed * 1664525u + 1013904223u;
        int k = (seed >> 16) & 0xFFF;
        raw[i] = limit_int(0, raw[i] + k - 2000, 27648);
    }
    raw[scan_no * 2] = scan_no * 800;

    /* plant 1, single equipment */
    analog(&LT101, raw[60], -15.4f, 124.5f, 0.05f, &chan[0]);
    analog(&LT102, raw[38], -14.9f, 140.8f, 0.05f, &chan[1]);
    analog(&LT103, raw[52], -0.7f, 123.3f, 0.2f, &chan[2]);
    analog(&LT104, raw[31], -3.8f, 133.2f, 0.05f, &chan[3]);
    analog(&LT105, raw[63], -11.0f, 92.5f, 0.05f, &chan[4]);
    analog(&LT106, raw[27], -12.1f, 105.6f, 0.05f, &chan[5]);
    analog(&LT107, raw[42], -6.8f, 57.6f, 0.05f, &chan[6]);
    analog(&LT108, raw[26], -2.4f, 127.0f, 0.05f, &chan[7]);
    analog(&LT109, raw[59], -1.9f, 135.1f, 0.05f, &chan[8]);
    analog(&LT110, raw[18], -6.4f, 71.7f, 0.2f, &chan[9]);
    analog(&LT111, raw[7], -0.3f, 85.7f, 0.05f, &chan[10]);
    analog(&LT112, raw[53], -8.1f, 62.7f, 0.05f, &chan[11]);
    analog(&LT113, raw[17], -0.5f, 83.4f, 0.2f, &chan[12]);
    analog(&LT114, raw[42], -11.2f, 131.2f, 0.1f, &chan[13]);
    analog(&LT115, raw[41], -9.1f, 92.4f, 0.2f, &chan[14]);
    analog(&LT116, raw[27], -9.6f, 73.4f, 0.1f, &chan[15]);
    analog(&LT117, raw[5], -0.9f, 73.0f, 0.1f, &chan[16]);
    analog(&LT118, raw[33], -7.1f, 82.6f, 0.05f, &chan[17]);
    analog(&LT119, raw[53], -4.3f, 61.4f, 0.2f, &chan[18]);
    analog(&LT120, raw[29], -14.0f, 97.5f, 0.2f, &chan[19]);
    analog(&LT121, raw[17], -14.9f, 87.7f, 0.2f, &chan[20]);
    analog(&LT122, raw[18], -13.3f, 89.6f, 0.05f, &chan[21]);
    analog(&LT123, raw[43], -11.5f, 146.2f, 0.05f, &chan[22]);
    analog(&LT124, raw[59], -15.7f, 120.0f, 0.05f, &chan[23]);
    analog(&LT125, raw[16], -11.6f, 144.6f, 0.1f, &chan[24]);
    motor(&P201, chan[18].value > 58.1f, raw[8] < 3000, 6, &drv[0]);
    motor(&P202, chan[5].value > 32.4f, raw[0] < 3000, 7, &drv[1]);
    motor(&P203, chan[22].value > 21.7f, raw[30] < 3000, 14, &drv[2]);
    motor(&P204, chan[2].value > 22.2f, raw[25] < 3000, 12, &drv[3]);
    motor(&P205, chan[22].value > 34.6f, raw[59] < 3000, 11, &drv[4]);
    motor(&P206, chan[16].value > 20.2f, raw[55] < 3000, 16, &drv[5]);
    motor(&P207, chan[2].value > 24.2f, raw[38] < 3000, 12, &drv[6]);
    motor(&P208, chan[4].value > 15.1f, raw[32] < 3000, 19, &drv[7]);
    motor(&P209, chan[15].value > 50.1f, raw[27] < 3000, 9, &drv[8]);
    motor(&P210, chan[12].value > 53.5f, raw[22] < 3000, 19, &drv[9]);
    motor(&P211, chan[7].value > 48.4f, raw[40] < 3000, 14, &drv[10]);
    motor(&P212, chan[22].value > 57.9f, raw[5] < 3000, 15, &drv[11]);
    motor(&P213, chan[23].value > 21.7f, raw[9] < 3000, 6, &drv[12]);
    motor(&P214, chan[1].value > 56.4f, raw[16] < 3000, 9, &drv[13]);
    motor(&P215, chan[20].value > 18.8f, raw[11] < 3000, 19, &drv[14]);
    motor(&P216, chan[7].value > 18.2f, raw[62] < 3000, 8, &drv[15]);
    motor(&P217, chan[2].value > 51.5f, raw[16] < 3000, 6, &drv[16]);
    motor(&P218, chan[19].value > 38.6f, raw[3] < 3000, 6, &drv[17]);
    motor(&P219, chan[5].value > 16.2f, raw[40] < 3000, 3, &drv[18]);
    motor(&P220, chan[8].value > 13.1f, raw[3] < 3000, 8, &drv[19]);
    motor(&P221, chan[3].value > 43.0f, raw[26] < 3000, 9, &drv[20]);
    motor(&P222, chan[6].value > 34.2f, raw[59] < 3000, 8, &drv[21]);
    motor(&P223, chan[10].value > 42.4f, raw[34] < 3000, 17, &drv[22]);
    motor(&P224, chan[14].value > 40.0f, raw[27] < 3000, 15, &drv[23]);
    motor(&P225, chan[14].value > 55.1f, raw[53] < 3000, 7, &drv[24]);
    valve_pos[0] = ctrl_valve(&CV301, chan[6].value, drv[5].running);
    valve_pos[1] = ctrl_valve(&CV302, chan[9].value, drv[12].running);
    valve_pos[2] = ctrl_valve(&CV303, chan[6].value, drv[24].running);
    valve_pos[3] = ctrl_valve(&CV304, chan[5].value, drv[11].running);
    valve_pos[4] = ctrl_valve(&CV305, chan[14].value, drv[21].running);
    valve_pos[5] = ctrl_valve(&CV306, chan[0].value, drv[3].running);
    valve_pos[6] = ctrl_valve(&CV307, chan[10].value, drv[21].running);
    valve_pos[7] = ctrl_valve(&CV308, chan[0].value, drv[24].running);
    valve_pos[8] = ctrl_valve(&CV309, chan[7].value, drv[24].running);
    valve_pos[9] = ctrl_valve(&CV310, chan[16].value, drv[13].running);
    valve_pos[10] = ctrl_valve(&CV311, chan[21].value, drv[1].running);
    valve_pos[11] = ctrl_valve(&CV312, chan[6].value, drv[19].running);
    valve_pos[12] = ctrl_valve(&CV313, chan[14].value, drv[17].running);
    valve_pos[13] = ctrl_valve(&CV314, chan[15].value, drv[17].running);
    valve_pos[14] = ctrl_valve(&CV315, chan[1].value, drv[13].running);
    valve_pos[15] = ctrl_valve(&CV316, chan[10].value, drv[0].running);
    valve_pos[16] = ctrl_valve(&CV317, chan[16].value, drv[10].running);
    valve_pos[17] = ctrl_valve(&CV318, chan[17].value, drv[8].running);
    valve_pos[18] = ctrl_valve(&CV319, chan[21].value, drv[23].running);
    valve_pos[19] = ctrl_valve(&CV320, chan[5].value, drv[7].running);
    valve_pos[20] = ctrl_valve(&CV321, chan[19].value, drv[3].running);
    valve_pos[21] = ctrl_valve(&CV322, chan[13].value, drv[2].running);
    valve_pos[22] = ctrl_valve(&CV323, chan[4].value, drv[5].running);
    valve_pos[23] = ctrl_valve(&CV324, chan[0].value, drv[10].running);
    valve_pos[24] = ctrl_valve(&CV325, chan[9].value, drv[8].running);
    sum += totalizer(&FQ401, valve_pos[15] * 0.3f, drv[5].running, 500.0f);
    sum += totalizer(&FQ402, valve_pos[11] * 0.3f, drv[14].running, 500.0f);
    sum += totalizer(&FQ403, valve_pos[13] * 0.3f, drv[15].running, 500.0f);
    sum += totalizer(&FQ404, valve_pos[19] * 0.3f, drv[10].running, 500.0f);
    sum += totalizer(&FQ405, valve_pos[5] * 0.3f, drv[1].running, 500.0f);
    sum += totalizer(&FQ406, valve_pos[24] * 0.3f, drv[3].running, 500.0f);
    sum += totalizer(&FQ407, valve_pos[3] * 0.3f, drv[11].running, 500.0f);
    sum += totalizer(&FQ408, valve_pos[13] * 0.3f, drv[20].running, 500.0f);
    sum += totalizer(&FQ409, valve_pos[5] * 0.3f, drv[16].running, 500.0f);
    sum += totalizer(&FQ410, valve_pos[22] * 0.3f, drv[3].running, 500.0f);
    sum += totalizer(&FQ411, valve_pos[1] * 0.3f, drv[21].running, 500.0f);
    sum += totalizer(&FQ412, valve_pos[13] * 0.3f, drv[0].running, 500.0f);
    sum += totalizer(&FQ413, valve_pos[8] * 0.3f, drv[7].running, 500.0f);
    sum += totalizer(&FQ414, valve_pos[3] * 0.3f, drv[10].running, 500.0f);
    sum += totalizer(&FQ415, valve_pos[17] * 0.3f, drv[18].running, 500.0f);
    sum += totalizer(&FQ416, valve_pos[4] * 0.3f, drv[6].running, 500.0f);
    sum += totalizer(&FQ417, valve_pos[18] * 0.3f, drv[18].running, 500.0f);
    sum += totalizer(&FQ418, valve_pos[3] * 0.3f, drv[13].running, 500.0f);
    sum += totalizer(&FQ419, valve_pos[3] * 0.3f, drv[19].running, 500.0f);
    sum += totalizer(&FQ420, valve_pos[22] * 0.3f, drv[22].running, 500.0f);
    sum += totalizer(&FQ421, valve_pos[8] * 0.3f, drv[13].running, 500.0f);
    sum += totalizer(&FQ422, valve_pos[17] * 0.3f, drv[5].running, 500.0f);
    sum += totalizer(&FQ423, valve_pos[24] * 0.3f, drv[7].running, 500.0f);
    sum += totalizer(&FQ424, valve_pos[0] * 0.3f, drv[16].running, 500.0f);
    sum += totalizer(&FQ425, valve_pos[3] * 0.3f, drv[6].running, 500.0f);

    /* plant 2, from tables */
    for (int i = 0; i < 25; i++) {
        analog(&ai[i], raw[i + 30], 0.0f, 100.0f, 0.15f, &chan[i + 25]);
        motor(&mot[i], chan[i + 25].value > 30.0f, chan[i].hihi, 5, &drv[i + 25]);
        valve_pos[i + 25] = ctrl_valve(&vlv[i], chan[i + 25].value, drv[i + 25].running);
        sum += totalizer(&fq[i], vlv[i].pos * 0.2f, vlv[i].in_pos, 100.0f);
    }

    float mean = 0.0f;
    for (int i = 0; i < 50; i++) {
        mean += limit(-50.0f, chan[i].value, 120.0f);
        sum += (int32_t)(char_curve(chan[i].value) * 10.0f);
        if (in_range(valve_pos[i], 10.0f, 60.0f))
            sum += i;
        if (chan[i].hihi || chan[i].lolo)
            sum += 7;
        if (chan[i].wire_break)
            sum += 1;
        sum += drv[i].starts + drv[i].state + drv[i].hours;
    }
    check = (int32_t)((uint32_t)check * 13u + (uint32_t)sum + (uint32_t)(int32_t)(mean * 10.0f));
}
