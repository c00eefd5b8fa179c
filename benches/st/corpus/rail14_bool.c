#include <stdbool.h>
#include "st.h"

struct point {
    bool mot_n, mot_r, locked_n, locked_r, alarm;
    bool edge_n, edge_r, lost, latch_n, latch_r;
};

static uint32_t seed = 0x1234ABCDu, occ;
static struct point point[16];
static bool det_n[16], det_r[16], held[16], route[8], signal_on[8];

static inline bool bit(uint32_t v, int n) { return (v >> n) & 1u; }
static inline uint32_t rol(uint32_t v, int n) { return (v << n) | (v >> (32 - n)); }

static inline bool rise(bool *m, bool clk)
{
    bool q = clk && !*m;
    *m = clk;
    return q;
}

static inline void point_run(struct point *p, bool cmd_n, bool cmd_r, bool clear, bool route_held,
                             bool dn, bool dr, bool ack)
{
    bool is_free = clear && !route_held;
    bool en = rise(&p->edge_n, cmd_n && is_free && !cmd_r);
    bool er = rise(&p->edge_r, cmd_r && is_free && !cmd_n);
    p->latch_n = !(dn || er || !clear) && (en || p->latch_n);
    p->latch_r = !(dr || en || !clear) && (er || p->latch_r);
    p->mot_n = p->latch_n && !p->latch_r;
    p->mot_r = p->latch_r && !p->latch_n;
    p->locked_n = dn && !dr && !p->mot_n && !p->mot_r;
    p->locked_r = dr && !dn && !p->mot_n && !p->mot_r;
    bool lost = rise(&p->lost, !(p->locked_n || p->locked_r));
    p->alarm = (dn && dr) || (lost && route_held) || (p->alarm && !ack);
}

void scan(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 17;
    seed ^= seed << 5;
    occ = (occ & seed) | ((seed >> 9) & 0x1111u);
    bool ack = bit(seed, 31) && bit(seed, 30) && !bit(seed, 29);

    uint32_t motors = 0, locks = 0, aspects = 0;
    bool any_alarm = false;
    for (int i = 0; i < 16; i++) {
        struct point *p = &point[i];
        point_run(p, bit(seed, i), bit(seed, i + 16), !bit(occ, i), held[i], det_n[i], det_r[i], ack);
        det_n[i] = p->mot_n || (det_n[i] && !p->mot_r);
        det_r[i] = p->mot_r || (det_r[i] && !p->mot_n);
        motors |= (uint32_t)p->mot_n << i | (uint32_t)p->mot_r << (i + 16);
        locks |= (uint32_t)p->locked_n << i | (uint32_t)p->locked_r << (i + 16);
        any_alarm |= p->alarm;
    }

    for (int i = 0; i < 8; i++) {
        int a = 2 * i, b = a + 1;
        bool req = bit(seed, 3 * i + 2);
        bool ok = (point[a].locked_n || point[b].locked_r) && !point[a].alarm && !point[b].alarm;
        if (i > 0)
            ok = ok && !route[i - 1];
        if (i < 7)
            ok = ok && !route[i + 1];
        route[i] = (route[i] || (req && ok)) && !bit(seed, 31 - i) && !ack;
        signal_on[i] = route[i] && ok && !bit(occ, a) && !bit(occ, b);
        held[a] = route[i];
        held[b] = route[i] && !point[b].locked_r;
        aspects |= (uint32_t)route[i] << i | (uint32_t)signal_on[i] << (i + 8);
    }
    aspects |= (uint32_t)any_alarm << 16;

    check = (int32_t)((uint32_t)check * 31u + (motors ^ rol(locks, 7) ^ rol(aspects, 3)));
}
