#include <stdbool.h>
#include "st.h"

typedef struct {
    bool autom, estop_ok, guard_ok, therm_ok, air_ok;
    bool start, stop, reset, jog;
    bool pe_in, pe_out, down_ready;
} SectionIn;

typedef struct {
    bool run, fault, ready, jam, horn, lamp_g, lamp_r, full;
    bool m_start, m_reset, low_in, low_out; /* edge memories */
    bool seal, jam_mem, tog, step0, step1, step2, step3;
} Section;

static Section sec[16];
static uint32_t seed = 0x1234ABCDu;
static bool line_ready, horn_mem, blink, m_fault;

static void section(Section *s, const SectionIn *in)
{
    bool r_start = in->start && !s->m_start;
    bool r_reset = in->reset && !s->m_reset;
    bool f_in = !in->pe_in && !s->low_in;
    bool f_out = !in->pe_out && !s->low_out;
    s->m_start = in->start;
    s->m_reset = in->reset;
    s->low_in = !in->pe_in;
    s->low_out = !in->pe_out;

    bool safe = in->estop_ok & in->guard_ok & in->therm_ok;
    bool cond = !in->estop_ok | !in->therm_ok | (s->run & !in->air_ok) | (s->jam_mem & s->jam);
    s->fault = cond | (s->fault & !(r_reset & safe));
    bool perm = safe & in->air_ok & !s->fault;
    s->seal = (r_start | s->seal) & in->stop & perm & in->autom;
    s->full = (!(f_out | r_reset)) & (f_in | s->full);
    s->jam = in->pe_in & in->pe_out & !in->down_ready & s->seal;
    s->jam_mem = (s->jam | s->jam_mem) & !r_reset;

    bool any = s->step1 | s->step2 | s->step3;
    s->step0 = !any & s->seal;
    s->step1 = ((s->step0 & in->pe_in) | s->step1) & !s->step2 & perm;
    s->step2 = ((s->step1 & s->full) | s->step2) & !s->step3 & perm;
    s->step3 = ((s->step2 & in->down_ready) | s->step3) & !f_out & perm;

    bool edge = r_start ^ r_reset;
    s->tog = s->tog ^ (edge & !s->fault);
    s->run = (s->seal & (s->step0 | s->step1 | s->step3)) | (!in->autom & in->jog & perm);
    s->ready = perm & !s->full & (s->run | !s->step2);
    s->horn = (s->fault & !s->tog) | (r_start & !perm);
    s->lamp_g = s->run & !(s->jam_mem ^ s->tog);
    s->lamp_r = s->fault | (s->jam_mem & s->tog);
}

void scan(void)
{
    uint32_t r[12];
    for (int i = 0; i < 12; i++) {
        seed ^= seed << 13;
        seed ^= seed >> 17;
        seed ^= seed << 5;
        r[i] = seed;
    }
    uint32_t estop = r[0] | r[1] | r[2] | r[3];
    uint32_t guard = r[1] | r[4] | r[5];
    uint32_t therm = r[2] | r[5] | r[6] | r[7];
    uint32_t air = r[3] | r[8] | r[0];
    uint32_t stop = r[4] | r[9] | r[10];

    bool line_fault = false, any_run = false, all_run = true, horn = false;
    bool down = line_ready;
    uint32_t res = 0;
    for (int i = 15; i >= 0; i--) {
        Section *s = &sec[i];
        SectionIn in = {
            .autom = ((r[11] | r[6]) >> i) & 1,
            .estop_ok = (estop >> i) & 1,
            .guard_ok = (guard >> i) & 1,
            .therm_ok = (therm >> i) & 1,
            .air_ok = (air >> i) & 1,
            .start = (r[7] >> i) & 1,
            .stop = (stop >> i) & 1,
            .reset = (r[8] >> i) & 1,
            .jog = (r[9] >> i) & 1,
            .pe_in = (r[10] >> i) & 1,
            .pe_out = (r[5] >> i) & 1,
            .down_ready = down,
        };
        section(s, &in);
        down = s->ready;
        line_fault |= s->fault;
        any_run |= s->run;
        all_run &= s->run | s->jam;
        horn |= s->horn;
        res = res * 2;
        if (s->lamp_g ^ s->lamp_r) res += 1;
        if (s->full) res += 65536;
    }

    bool r_fault = line_fault && !m_fault;
    m_fault = line_fault;
    bool zone_a = (sec[0].run & sec[1].run) | (sec[2].run & !sec[3].fault);
    bool zone_b = (sec[8].ready | sec[9].ready) & !(sec[10].jam | sec[11].jam);
    bool starved = !sec[15].full & !sec[14].full & sec[15].run;
    horn_mem = (r_fault | horn | horn_mem) & !zone_a;
    blink ^= horn_mem;
    line_ready = (zone_a ^ zone_b) | all_run | (any_run & blink) | starved;
    if (line_ready) res += 7;
    if (horn_mem) res += 100;
    check = (int32_t)((uint32_t)check * 31u + res + 1u);
}
