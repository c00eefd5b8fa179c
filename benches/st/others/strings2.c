#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"
struct telegram { int16_t unit, value, parsed; uint8_t ok; char text[81], head[41], body[41]; };
static struct telegram ts[20];
static int32_t scans;
static int number(char *to, int v)
{
    char digits[8]; int n = 0, len = 0;
    if (v < 0) { to[len++] = '-'; v = -v; }
    do digits[n++] = '0' + v % 10; while (v /= 10);
    while (n) to[len++] = digits[--n];
    to[len] = 0;
    return len;
}
static void telegram(struct telegram *t)
{
    memcpy(t->head, "UNIT", 4);
    int h = 4 + number(t->head + 4, t->unit);
    int b = number(t->body, t->value);
    t->body[b++] = ';'; t->body[b] = 0;
    memcpy(t->text, t->head, h); t->text[h] = '='; memcpy(t->text + h + 1, t->body, b + 1);
    int len = h + 1 + b;
    char *found = strchr(t->text, '=');
    int p = found ? (int)(found - t->text) + 1 : 0;
    t->ok = p > 0 && len < 40;
    if (t->ok) {
        int n = len - p - 1;
        memcpy(t->head, t->text + p, n); t->head[n] = 0;
        t->parsed = (int16_t)atoi(t->head);
        memmove(t->text + p + 2, t->text + p, len - p + 1); memcpy(t->text + p, ">>", 2); len += 2;
        memmove(t->text + 1, t->text + 4, len - 3); t->text[0] = 'U'; len -= 3;
        t->text[--len] = 0;
    }
}
void scan(void)
{
    for (int i = 0; i < 20; i++) {
        ts[i].unit = i; ts[i].value = scans % 1000 * 7 + i;
        telegram(&ts[i]);
        if (ts[i].ok) check += ts[i].parsed + strlen(ts[i].text);
    }
    scans++;
}
