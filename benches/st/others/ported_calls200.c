#include "st.h"
#include <stdbool.h>
#include <stdint.h>
struct range { int lo, hi; };
struct biquad { int y; unsigned hits; int z1, z2; struct range range; };
static struct biquad filters[200];
static unsigned seed = 1;

static int fix_mul(int a, int b) { return a * b / 256; }
static int saturate(int v, int lim) {
    if (v > lim) return lim;
    if (v < -lim) return -lim;
    return v;
}
static bool track(struct range *r, int v) {
    bool hit = false;
    if (v < r->lo) { r->lo = v; hit = true; }
    if (v > r->hi) { r->hi = v; hit = true; }
    return hit;
}
static void biquad(struct biquad *f, int x) {
    f->y = saturate(fix_mul(x, 60) + f->z1, 30000);
    f->z1 = fix_mul(x, 100) + fix_mul(f->y, 110) + f->z2;
    f->z2 = fix_mul(x, 50) - fix_mul(f->y, 70);
    if (track(&f->range, f->y)) f->hits++;
    if (f->hits > 20) {
        f->hits = 0;
        f->range.lo = f->range.hi = f->y;
    }
}
void scan(void) {
    int acc = 0;
    for (int n = 0; n < 200; n++) {
        seed = (seed * 75 + 74) % 65537;
        biquad(&filters[n], (int)seed - 32768);
        acc += filters[n].y % 1000 + (int)filters[n].hits;
    }
    check = (check + acc) % 999983;
}
