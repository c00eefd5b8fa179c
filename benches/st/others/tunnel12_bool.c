/* Tunnel safety logic: 24 sections with smoke detection, fans, doors and
   lights, a pump chain, the mains/generator changeover and the portal signals. */
#include <stdbool.h>
#include "st.h"

#define SECTIONS 24
#define PUMPS 8

typedef struct {
    /* outputs */
    bool pre_alarm, fire, fan_run, fan_reverse;
    bool light_full, door_lamp, horn, fault;
    /* memory */
    bool smoke_mem, ack_mem, door_mem;
    bool horn_latch;
} section_t;

typedef struct {
    bool smoke1, smoke2, sos_call, door_open;
    bool fan_request, fan_trip, local_stop, ack, neighbour_fire;
} section_in_t;

static uint32_t seed = 0x2545F491u;
static section_t section[SECTIONS + 1];
static bool pump_run[PUMPS + 1];
static bool pump_trip[PUMPS + 1];
static bool k_mains, k_gen;
static bool red, barrier_down;

static inline bool bit(uint32_t w, int n)
{
    return (w >> n) & 1u;
}

static inline uint32_t next_random(uint32_t x)
{
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    return x;
}

static inline bool rising(bool clk, bool *mem)
{
    bool q = clk && !*mem;
    *mem = clk;
    return q;
}

/* As the standard's F_TRIG: the memory holds "was low", false at the start. */
static inline bool falling(bool clk, bool *mem)
{
    bool q = !clk && !*mem;
    *mem = !clk;
    return q;
}

static void section_update(section_t *s, const section_in_t *in)
{
    bool smoke_edge = rising(in->smoke1 || in->smoke2, &s->smoke_mem);
    bool ack_edge = rising(in->ack, &s->ack_mem);
    bool door_closed = falling(in->door_open, &s->door_mem);

    s->pre_alarm = in->smoke1 != in->smoke2;
    s->fire = (in->smoke1 && in->smoke2)
              || (s->fire && !(ack_edge && !in->smoke1 && !in->smoke2));
    s->fault = in->fan_trip || (s->fault && !ack_edge);

    s->fan_run = (in->fan_request || s->fire || in->neighbour_fire)
                 && !s->fault && (!in->local_stop || s->fire);
    s->fan_reverse = s->fan_run && in->neighbour_fire && !s->fire;

    s->light_full = !(door_closed && !s->fire)
                    && (in->door_open || in->sos_call || s->fire || s->light_full);
    s->door_lamp = in->door_open || (in->sos_call && s->light_full);

    s->horn_latch = !ack_edge
                    && (smoke_edge || (in->sos_call && s->pre_alarm) || s->horn_latch);
    s->horn = s->horn_latch && (s->fire || s->pre_alarm);
}

static inline uint32_t mix(uint32_t sum, uint32_t v)
{
    return sum * 31u + v;
}

void scan(void)
{
    uint32_t in1 = seed = next_random(seed);
    uint32_t in2 = seed = next_random(seed);
    uint32_t in3 = seed = next_random(seed);
    uint32_t in4 = seed = next_random(seed);
    uint32_t rare = in1 & in2 & in3;

    /* Sections */
    bool before = false;
    for (int i = 1; i <= SECTIONS; i++) {
        bool after = i < SECTIONS ? section[i + 1].fire : false;
        section_in_t in = {
            .smoke1 = bit(in1 & in2, i),
            .smoke2 = bit(in2 & in4, i + 3),
            .sos_call = bit(rare, i),
            .door_open = bit(in3 & in4, i + 5),
            .fan_request = bit(in3, i + 2),
            .fan_trip = bit(rare, 31 - i),
            .local_stop = bit(in4, i),
            .ack = bit(in1, i + 7),
            .neighbour_fire = before || after,
        };
        section_update(&section[i], &in);
        before = section[i].fire;
    }

    /* Words for the control room */
    uint32_t fire_word = 0, fan_word = 0, light_word = 0, horn_word = 0, fault_word = 0;
    bool any_fire = false, any_horn = false, two_fires = false;
    for (int i = 1; i <= SECTIONS; i++) {
        const section_t *s = &section[i];
        uint32_t mask = 1u << i;
        if (s->fire) {
            fire_word |= mask;
            two_fires = two_fires || any_fire;
            any_fire = true;
        }
        if (s->fan_run && !s->fan_reverse)
            fan_word |= mask;
        if (s->light_full || s->door_lamp)
            light_word |= mask;
        if (s->horn) {
            horn_word |= mask;
            any_horn = true;
        }
        if (s->fault)
            fault_word |= mask;
    }

    /* Power supply: mains first, generator second, never both */
    bool mains_ok = !bit(in1 & in4, 0);
    bool gen_ok = !bit(in2, 0);
    k_mains = mains_ok && !k_gen;
    k_gen = !mains_ok && gen_ok && !k_mains;
    bool k_coupler = (k_mains != k_gen) && !bit(rare, 0);
    bool power_ok = k_coupler || (k_mains && any_fire);

    /* Pump chain: each pump needs the one before it */
    bool low_level = bit(in1 & in2, 30);
    bool high_level = bit(in3 | in4, 30);
    uint32_t pump_word = 0;
    pump_run[0] = power_ok && !low_level;
    for (int i = 1; i <= PUMPS; i++) {
        pump_trip[i] = (pump_trip[i] || bit(rare, i * 3)) && !bit(in4, i + 12);
        pump_run[i] = pump_run[i - 1] && !pump_trip[i]
                      && (pump_run[i] || high_level || bit(in2, i + 20));
        if (pump_run[i])
            pump_word |= 1u << i;
    }

    /* Portal signals */
    red = two_fires || (any_fire && any_horn) || !power_ok || (red && any_fire);
    bool yellow = !red && (any_fire || any_horn || fault_word != 0);
    bool green = !red && !yellow;
    barrier_down = red && (barrier_down || k_gen || two_fires);

    /* Checksum */
    uint32_t sum = 17;
    sum = mix(sum, fire_word);
    sum = mix(sum, fan_word);
    sum = mix(sum, light_word);
    sum = mix(sum, horn_word);
    sum = mix(sum, fault_word);
    sum = mix(sum, pump_word);
    if (red) sum += 1;
    if (yellow) sum += 2;
    if (green) sum += 4;
    if (barrier_down) sum += 8;
    check = (int32_t)sum;
}
