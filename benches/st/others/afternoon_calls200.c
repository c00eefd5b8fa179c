#include "st.h"
struct calc { int y, n, last; };
static struct calc f[200];
static int scans;
static int clamp(int x, int lo, int hi) { return x < lo ? lo : x > hi ? hi : x; }
static int square(int x) { return x * x; }
static void calc(struct calc *c, int x) {
    c->y = clamp(square(x - c->last) + c->y / 2, 10, 5000);
    if (c->y == 5000) c->n++;
    if (c->n > 100) c->n = 0;
    c->last = x;
}
void scan(void) {
    scans++;
    int sum = 0;
    for (int i = 0; i < 200; i++) {
        calc(&f[i], (scans * (i + 3)) % 173);
        sum += f[i].y + f[i].n;
    }
    check = (check + sum) % 1000000;
}
