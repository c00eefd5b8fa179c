/* 200 function block calls a scan, most of them with functions inside */
#include "st.h"
#include <stdbool.h>

static float scale(int16_t raw, float lo, float hi)
{
    return lo + (float)raw * (hi - lo) / 27648.0f;
}

static int16_t clamp_int(int16_t x, int16_t lo, int16_t hi)
{
    if (x < lo)
        return lo;
    else if (x > hi)
        return hi;
    else
        return x;
}

static bool in_band(float x, float centre, float band)
{
    return x >= centre - band && x <= centre + band;
}

static int16_t noise(int32_t seed)
{
    int32_t h = (seed * 1103 + 12345) % 65536;
    return (int16_t)(h / 4);
}

struct analog_in {
    float value, last;
    bool alarm, settled;
};

static void analog_in(struct analog_in *s, int16_t raw, float lo, float hi,
                      float alarm_lo, float alarm_hi)
{
    s->last = s->value;
    s->value += (scale(clamp_int(raw, 0, 27648), lo, hi) - s->value) * 0.25f;
    s->settled = in_band(s->value, s->last, (hi - lo) * 0.01f);
    if (s->value > alarm_hi || s->value < alarm_lo)
        s->alarm = true;
    else if (in_band(s->value, (alarm_hi + alarm_lo) * 0.5f, (alarm_hi - alarm_lo) * 0.4f))
        s->alarm = false;
}

struct ramp {
    int16_t out;
    bool moving;
};

static void ramp(struct ramp *s, int16_t target, int16_t up, int16_t down)
{
    int16_t delta = clamp_int(target - s->out, -down, up);
    s->out += delta;
    s->moving = delta != 0;
}

struct valve {
    bool is_open, is_closed, fault;
    int16_t state, pos, idle;
};

static void valve(struct valve *s, bool open, bool close, int16_t travel)
{
    switch (s->state) {
    case 0:
        if (open && !close)
            s->state = 1;
        else
            s->idle = clamp_int(s->idle + 1, 0, 500);
        break;
    case 1:
        s->pos = clamp_int(s->pos + 3, 0, travel);
        if (s->pos == travel)
            s->state = 2;
        else if (close)
            s->state = 3;
        break;
    case 2:
        if (close)
            s->state = 3;
        break;
    case 3:
        s->pos = clamp_int(s->pos - 4, 0, travel);
        if (s->pos == 0) {
            s->state = 0;
            s->idle = 0;
        }
        break;
    default:
        s->state = 0;
    }
    s->is_open = s->state == 2;
    s->is_closed = s->state == 0;
    s->fault = (open && close) || s->idle >= 400;
}

struct totalizer {
    int32_t total;
    int16_t wraps;
};

static void totalizer(struct totalizer *s, int16_t rate, bool enable, int32_t limit)
{
    if (enable) {
        s->total += rate;
        if (s->total >= limit) {
            s->total -= limit;
            s->wraps = (s->wraps + 1) % 1000;
        }
    }
}

static struct analog_in ai[51 + 10];
static struct ramp ramps[51];
static struct valve valves[51];
static struct totalizer tot_water_flow1;
static struct totalizer tot_syrup_flow1;
static struct totalizer tot_steam_flow1;
static struct totalizer tot_cream_flow1;
static struct totalizer tot_milk_flow1;
static struct totalizer tot_whey_flow1;
static struct totalizer tot_acid_flow1;
static struct totalizer tot_base_flow1;
static struct totalizer tot_water_flow2;
static struct totalizer tot_syrup_flow2;
static struct totalizer tot_steam_flow2;
static struct totalizer tot_cream_flow2;
static struct totalizer tot_milk_flow2;
static struct totalizer tot_whey_flow2;
static struct totalizer tot_acid_flow2;
static struct totalizer tot_base_flow2;
static struct totalizer tot_water_flow3;
static struct totalizer tot_syrup_flow3;
static struct totalizer tot_steam_flow3;
static struct totalizer tot_cream_flow3;
static struct totalizer tot_milk_flow3;
static struct totalizer tot_whey_flow3;
static struct totalizer tot_acid_flow3;
static struct totalizer tot_base_flow3;
static struct totalizer tot_water_flow4;
static struct totalizer tot_syrup_flow4;
static struct totalizer tot_steam_flow4;
static struct totalizer tot_cream_flow4;
static struct totalizer tot_milk_flow4;
static struct totalizer tot_whey_flow4;
static struct totalizer tot_acid_flow4;
static struct totalizer tot_base_flow4;
static struct totalizer tot_water_flow5;
static struct totalizer tot_syrup_flow5;
static struct totalizer tot_steam_flow5;
static struct totalizer tot_cream_flow5;
static struct totalizer tot_milk_flow5;
static struct totalizer tot_whey_flow5;
static struct totalizer tot_acid_flow5;
static struct totalizer tot_base_flow5;
static int32_t tick;

void scan(void)
{
    int16_t i;
    int32_t n_alarm = 0, sum_i = 0;
    float sum_r = 0.0f;

    tick = (tick + 1) % 1500;

    for (i = 1; i <= 60; i++) {
        analog_in(&ai[i], noise(tick + i * 61) * 2 - 100, -20.0f, 120.0f, 5.0f, 75.0f);
        if (ai[i].alarm)
            n_alarm++;
        if (ai[i].settled)
            n_alarm += 2;
        sum_r += ai[i].value;
    }

    for (i = 1; i <= 50; i++) {
        ramp(&ramps[i], noise(tick / 20 + i), 50 + i, 80);
        if (ramps[i].moving)
            sum_i += ramps[i].out;
    }

    for (i = 1; i <= 50; i++) {
        valve(&valves[i], (tick + i * 7) % 120 < 60, ai[i].alarm, 60 + i);
        if (valves[i].is_open)
            sum_i += 1;
        if (valves[i].is_closed)
            sum_i += 2;
        if (valves[i].fault)
            sum_i += 4;
    }

    totalizer(&tot_water_flow1, ramps[1].out, !valves[1].is_closed, 2000000);
    totalizer(&tot_syrup_flow1, ramps[2].out, valves[4].is_open, 2001000);
    totalizer(&tot_steam_flow1, ramps[3].out, valves[7].is_closed, 2002000);
    totalizer(&tot_cream_flow1, ramps[4].out, valves[10].is_open, 2003000);
    totalizer(&tot_milk_flow1, ramps[5].out, valves[13].is_closed, 2004000);
    totalizer(&tot_whey_flow1, ramps[6].out, !valves[16].is_open, 2005000);
    totalizer(&tot_acid_flow1, ramps[7].out, valves[19].is_closed, 2006000);
    totalizer(&tot_base_flow1, ramps[8].out, valves[22].is_open, 2007000);
    totalizer(&tot_water_flow2, ramps[9].out, valves[25].is_closed, 2008000);
    totalizer(&tot_syrup_flow2, ramps[10].out, valves[28].is_open, 2009000);
    totalizer(&tot_steam_flow2, ramps[11].out, !valves[31].is_closed, 2010000);
    totalizer(&tot_cream_flow2, ramps[12].out, valves[34].is_open, 2011000);
    totalizer(&tot_milk_flow2, ramps[13].out, valves[37].is_closed, 2012000);
    totalizer(&tot_whey_flow2, ramps[14].out, valves[40].is_open, 2013000);
    totalizer(&tot_acid_flow2, ramps[15].out, valves[43].is_closed, 2014000);
    totalizer(&tot_base_flow2, ramps[16].out, !valves[46].is_open, 2015000);
    totalizer(&tot_water_flow3, ramps[17].out, valves[49].is_closed, 2016000);
    totalizer(&tot_syrup_flow3, ramps[18].out, valves[2].is_open, 2017000);
    totalizer(&tot_steam_flow3, ramps[19].out, valves[5].is_closed, 2018000);
    totalizer(&tot_cream_flow3, ramps[20].out, valves[8].is_open, 2019000);
    totalizer(&tot_milk_flow3, ramps[21].out, !valves[11].is_closed, 2020000);
    totalizer(&tot_whey_flow3, ramps[22].out, valves[14].is_open, 2021000);
    totalizer(&tot_acid_flow3, ramps[23].out, valves[17].is_closed, 2022000);
    totalizer(&tot_base_flow3, ramps[24].out, valves[20].is_open, 2023000);
    totalizer(&tot_water_flow4, ramps[25].out, valves[23].is_closed, 2024000);
    totalizer(&tot_syrup_flow4, ramps[26].out, !valves[26].is_open, 2025000);
    totalizer(&tot_steam_flow4, ramps[27].out, valves[29].is_closed, 2026000);
    totalizer(&tot_cream_flow4, ramps[28].out, valves[32].is_open, 2027000);
    totalizer(&tot_milk_flow4, ramps[29].out, valves[35].is_closed, 2028000);
    totalizer(&tot_whey_flow4, ramps[30].out, valves[38].is_open, 2029000);
    totalizer(&tot_acid_flow4, ramps[31].out, !valves[41].is_closed, 2030000);
    totalizer(&tot_base_flow4, ramps[32].out, valves[44].is_open, 2031000);
    totalizer(&tot_water_flow5, ramps[33].out, valves[47].is_closed, 2032000);
    totalizer(&tot_syrup_flow5, ramps[34].out, valves[50].is_open, 2033000);
    totalizer(&tot_steam_flow5, ramps[35].out, valves[3].is_closed, 2034000);
    totalizer(&tot_cream_flow5, ramps[36].out, !valves[6].is_open, 2035000);
    totalizer(&tot_milk_flow5, ramps[37].out, valves[9].is_closed, 2036000);
    totalizer(&tot_whey_flow5, ramps[38].out, valves[12].is_open, 2037000);
    totalizer(&tot_acid_flow5, ramps[39].out, valves[15].is_closed, 2038000);
    totalizer(&tot_base_flow5, ramps[40].out, valves[18].is_open, 2039000);
    sum_i += tot_water_flow1.total % 1000 + tot_water_flow1.wraps;
    sum_i += tot_syrup_flow1.total % 1000 + tot_syrup_flow1.wraps;
    sum_i += tot_steam_flow1.total % 1000 + tot_steam_flow1.wraps;
    sum_i += tot_cream_flow1.total % 1000 + tot_cream_flow1.wraps;
    sum_i += tot_milk_flow1.total % 1000 + tot_milk_flow1.wraps;
    sum_i += tot_whey_flow1.total % 1000 + tot_whey_flow1.wraps;
    sum_i += tot_acid_flow1.total % 1000 + tot_acid_flow1.wraps;
    sum_i += tot_base_flow1.total % 1000 + tot_base_flow1.wraps;
    sum_i += tot_water_flow2.total % 1000 + tot_water_flow2.wraps;
    sum_i += tot_syrup_flow2.total % 1000 + tot_syrup_flow2.wraps;
    sum_i += tot_steam_flow2.total % 1000 + tot_steam_flow2.wraps;
    sum_i += tot_cream_flow2.total % 1000 + tot_cream_flow2.wraps;
    sum_i += tot_milk_flow2.total % 1000 + tot_milk_flow2.wraps;
    sum_i += tot_whey_flow2.total % 1000 + tot_whey_flow2.wraps;
    sum_i += tot_acid_flow2.total % 1000 + tot_acid_flow2.wraps;
    sum_i += tot_base_flow2.total % 1000 + tot_base_flow2.wraps;
    sum_i += tot_water_flow3.total % 1000 + tot_water_flow3.wraps;
    sum_i += tot_syrup_flow3.total % 1000 + tot_syrup_flow3.wraps;
    sum_i += tot_steam_flow3.total % 1000 + tot_steam_flow3.wraps;
    sum_i += tot_cream_flow3.total % 1000 + tot_cream_flow3.wraps;
    sum_i += tot_milk_flow3.total % 1000 + tot_milk_flow3.wraps;
    sum_i += tot_whey_flow3.total % 1000 + tot_whey_flow3.wraps;
    sum_i += tot_acid_flow3.total % 1000 + tot_acid_flow3.wraps;
    sum_i += tot_base_flow3.total % 1000 + tot_base_flow3.wraps;
    sum_i += tot_water_flow4.total % 1000 + tot_water_flow4.wraps;
    sum_i += tot_syrup_flow4.total % 1000 + tot_syrup_flow4.wraps;
    sum_i += tot_steam_flow4.total % 1000 + tot_steam_flow4.wraps;
    sum_i += tot_cream_flow4.total % 1000 + tot_cream_flow4.wraps;
    sum_i += tot_milk_flow4.total % 1000 + tot_milk_flow4.wraps;
    sum_i += tot_whey_flow4.total % 1000 + tot_whey_flow4.wraps;
    sum_i += tot_acid_flow4.total % 1000 + tot_acid_flow4.wraps;
    sum_i += tot_base_flow4.total % 1000 + tot_base_flow4.wraps;
    sum_i += tot_water_flow5.total % 1000 + tot_water_flow5.wraps;
    sum_i += tot_syrup_flow5.total % 1000 + tot_syrup_flow5.wraps;
    sum_i += tot_steam_flow5.total % 1000 + tot_steam_flow5.wraps;
    sum_i += tot_cream_flow5.total % 1000 + tot_cream_flow5.wraps;
    sum_i += tot_milk_flow5.total % 1000 + tot_milk_flow5.wraps;
    sum_i += tot_whey_flow5.total % 1000 + tot_whey_flow5.wraps;
    sum_i += tot_acid_flow5.total % 1000 + tot_acid_flow5.wraps;
    sum_i += tot_base_flow5.total % 1000 + tot_base_flow5.wraps;
    check = (check + n_alarm + sum_i + (int32_t)sum_r) % 10000019;
}
