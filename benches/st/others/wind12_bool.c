#include <stdbool.h>
#include "st.h"

struct bay {
    bool cb, ds, es, lockout, bad_cmd;
    bool p_close, p_open, p_ds, p_es, low_trip;
};

struct bay_in {
    bool close, open, ds, es, bus_earthed, trip, reset, local;
};

static struct bay bays[16];
static bool contact[32];
static bool prev_chain, first_set, horn;
static uint32_t first_fault;
static uint32_t rnd = 0x2545F491u, rnd2 = 0x1B873593u;

static inline bool rising(bool in, bool *prev)
{
    bool q = in && !*prev;
    *prev = in;
    return q;
}

/* As F_TRIG of the standard: the first call with a low input is an edge too. */
static inline bool falling(bool in, bool *low)
{
    bool q = !in && !*low;
    *low = !in;
    return q;
}

static inline uint32_t rol32(uint32_t x, int n) { return x << n | x >> (32 - n); }
static inline bool bit(uint32_t x, int n) { return x >> n & 1; }

static inline void bay_step(struct bay *b, const struct bay_in *in)
{
    bool close = rising(in->close, &b->p_close);
    bool open = rising(in->open, &b->p_open);
    bool ds = rising(in->ds, &b->p_ds);
    bool es = rising(in->es, &b->p_es);
    bool trip_gone = falling(in->trip, &b->low_trip);

    b->lockout = in->trip || (b->lockout && !(in->reset && !b->cb));

    bool rel_close = b->ds && !b->es && !b->lockout && !in->bus_earthed && !in->local;
    bool rel_ds = !b->cb && !b->es && !in->bus_earthed;
    bool rel_es = !b->cb && !b->ds;

    b->cb = !(open || in->trip || b->lockout) && ((close && rel_close) || b->cb);
    if (ds && rel_ds)
        b->ds = !b->ds;
    if (es && rel_es)
        b->es = !b->es;
    b->bad_cmd = (close && !rel_close) || (ds && !rel_ds) || (es && !rel_es) || trip_gone;
}

void scan(void)
{
    rnd ^= rnd << 13;
    rnd ^= rnd >> 17;
    rnd ^= rnd << 5;
    rnd2 = rol32(rnd2, 7) ^ rnd;

    bool chain_ok = true;
    uint32_t w = rnd | rnd2 | rol32(rnd, 11);
    for (int i = 0; i < 32; i++) {
        contact[i] = bit(w, i);
        if (chain_ok && !contact[i] && !first_set) {
            first_fault = 1u << i;
            first_set = true;
        }
        chain_ok = chain_ok && contact[i];
    }
    if (chain_ok || (bit(rnd, 3) && bit(rnd, 9)))
        first_set = false;

    bool bus_earthed = bit(rnd, 30) && bit(rnd, 21) && bit(rnd2, 5) && bit(rnd2, 17);
    uint16_t w_cb = 0, w_ds = 0, w_es = 0, w_lock = 0, w_bad = 0;
    bool any_lock = false, all_closed = true;
    for (int i = 0; i < 16; i++) {
        struct bay *b = &bays[i];
        struct bay_in in = {
            .close = (contact[i] && !contact[31 - i]) || (rnd >> i & 3) == 1,
            .open = (rnd2 >> i & 0x1F) == 0x0B,
            .ds = (rnd2 >> i & 7) == 5,
            .es = (rnd >> i & 0x1D) == 0x14,
            .bus_earthed = bus_earthed,
            .trip = (rnd >> i & 0x3F) == 0x2A,
            .reset = contact[i] && bit(rnd2, 31),
            .local = bit(rnd2, 0) && bit(rnd2, 4),
        };
        bay_step(b, &in);
        w_cb |= b->cb << i;
        w_ds |= b->ds << i;
        w_es |= b->es << i;
        w_lock |= b->lockout << i;
        w_bad |= b->bad_cmd << i;
        any_lock |= b->lockout;
        all_closed &= b->cb;
    }

    bool horn_req = any_lock && (!chain_ok || !all_closed);
    horn = (horn || (horn_req && !prev_chain)) && !(bit(rnd, 7) && bit(rnd, 12));
    prev_chain = horn_req;

    uint32_t c = (uint32_t)check * 31u + w_cb + w_ds * 3u + w_es * 5u + w_lock * 7u + w_bad * 11u;
    c += first_fault;
    if (horn)
        c += 17;
    check = (int32_t)c;
}
