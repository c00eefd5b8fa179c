#include "st.h"
#include <stdbool.h>
struct net { bool q, r, m, old; };
static struct net n[200];
static bool x[200];
static int scans;
static void net(struct net *s, bool a, bool b, bool c, bool d) {
    s->m = ((a && b) || s->m) && !(c && d);
    s->r = (a ^ b) || ((c ^ d) && s->m);
    s->q = (s->m && !s->old) || (s->r && (b || !c));
    s->old = s->m;
}
void scan(void) {
    scans++;
    for (int i = 0; i < 200; i++) x[i] = (scans + i) % 5 < 2;
    x[0] = n[199].q;
    for (int i = 0; i < 197; i++) net(&n[i], x[i], x[i + 1], x[i + 2], x[i + 3]);
    net(&n[197], x[197], x[198], x[199], x[0]);
    net(&n[198], n[0].q, n[50].q, n[100].q, n[150].q);
    net(&n[199], n[198].q, n[197].r, n[10].q, n[20].r);
    int cnt = 0;
    for (int i = 0; i < 200; i++) cnt += n[i].q + 3 * n[i].r;
    check = (check * 2 + cnt) % 1000000;
}
