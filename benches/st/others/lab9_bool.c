/* Boolean network: interlocks, latched alarms, step chain, ripple adder, 2-of-3 votes. */
#include <stdbool.h>
#include "st.h"

#define N 64
#define STEPS 16

static int32_t seed = 74755;
static bool inp[N], ilk[N], old[N], alm[N];
static bool chain[STEPS], next[STEPS];
static bool sum[32], vote[16];
static bool horn;

static int32_t Rand(void)
{
    seed = (seed * 1309 + 13849) & 65535;
    return seed;
}

void scan(void)
{
    int32_t i, w = 0, cnt = 0;
    bool ack, rise, any, carry, x, y, z;

    /* inputs: 8 bits from each random number */
    for (i = 0; i < N; i++) {
        if (i % 8 == 0)
            w = Rand() / 256;
        inp[i] = w % 2 == 1;
        w = w / 2;
    }
    ack = inp[3] && inp[17] && !inp[40];

    /* interlocks */
    for (i = 0; i < N; i++)
        ilk[i] = (inp[i] && !inp[(i + 1) % N]) || (inp[(i + 5) % N] && inp[(i + 11) % N] && !inp[(i + 23) % N]);

    /* alarms: edge, latch, acknowledge */
    for (i = 0; i < N; i++) {
        rise = ilk[i] && !old[i];
        old[i] = ilk[i];
        alm[i] = (alm[i] || rise) && !(ack && !ilk[i]);
        horn = horn || (rise && inp[(i + 7) % N]);
    }
    horn = horn && !ack;

    /* step chain */
    any = false;
    for (i = 0; i < STEPS; i++) {
        next[i] = chain[i];
        any = any || chain[i];
    }
    if (!any)
        next[0] = true;
    for (i = 0; i < STEPS; i++) {
        if (chain[i] && (inp[i * 4] || inp[i * 4 + 1]) && !(alm[i * 2] && ilk[i * 2 + 1])) {
            next[i] = false;
            next[(i + 1) % STEPS] = true;
        }
    }
    for (i = 0; i < STEPS; i++)
        chain[i] = next[i];

    /* ripple carry adder over interlocks and alarms */
    carry = horn;
    for (i = 0; i < 32; i++) {
        x = ilk[i];
        y = alm[i + 32];
        sum[i] = x ^ y ^ carry;
        carry = (x && y) || (carry && (x ^ y));
    }

    /* 2 of 3 */
    for (i = 0; i < 16; i++) {
        x = inp[i * 3];
        y = sum[i * 2];
        z = alm[i * 4];
        vote[i] = (x && y) || (y && z) || (x && z);
    }

    /* fold everything into the checksum */
    w = 0;
    for (i = 0; i < 32; i++) {
        w = (w * 3) % 1000003;
        if (sum[i])
            w = w + 1;
    }
    for (i = 0; i < N; i++) {
        if (alm[i])
            cnt = cnt + i;
    }
    for (i = 0; i < STEPS; i++) {
        if (chain[i])
            cnt = cnt + 100 * i;
        if (vote[i])
            cnt = cnt + 7 * i;
    }
    if (carry)
        cnt = cnt + 10000;
    if (horn)
        cnt = cnt + 20000;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)w + (uint32_t)cnt);
}
