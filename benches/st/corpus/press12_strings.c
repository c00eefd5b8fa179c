/* Telegrams: compose, parse, edit, compare */
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAX 80

typedef struct { int len; char s[MAX + 1]; } Str;

static void append(Str *d, const char *s, int n)
{
    if (n > MAX - d->len)
        n = MAX - d->len;
    memcpy(d->s + d->len, s, n);
    d->len += n;
    d->s[d->len] = 0;
}

static void append_z(Str *d, const char *s) { append(d, s, (int)strlen(s)); }

static void append_int(Str *d, int32_t v)
{
    char buf[12];
    int p = sizeof buf;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
    do {
        buf[--p] = '0' + u % 10;
        u /= 10;
    } while (u);
    if (v < 0)
        buf[--p] = '-';
    append(d, buf + p, (int)sizeof buf - p);
}

static int32_t parse_int(const char *s, int n)
{
    bool neg = n > 0 && *s == '-';
    uint32_t v = 0;
    for (int i = neg; i < n; i++)
        v = v * 10 + (s[i] - '0');
    return (int32_t)(neg ? 0u - v : v);
}

/* The value behind a key up to the next ';', as a view into the telegram. */
static const char *field(const Str *t, const char *key, int *n)
{
    const char *p = strstr(t->s, key);
    *n = 0;
    if (p) {
        p += strlen(key);
        const char *end = strchr(p, ';');
        if (end)
            *n = (int)(end - p);
    }
    return p;
}

static const char *const names[5] = { "IDLE", "RUN", "HOLD", "FAULT", "MAINTENANCE" };
static uint32_t seed = 4711;
static int32_t scan_no;

void scan(void)
{
    scan_no++;
    seed = seed * 1664525u + 1013904223u;
    int32_t temp = (int32_t)(seed / 65536 % 2000) - 500;

    /* compose */
    Str t;
    t.len = 0;
    append_z(&t, "ID=");
    append_int(&t, scan_no);
    append_z(&t, ";TEMP=");
    append_int(&t, temp);
    append_z(&t, ";STATE=");
    append_z(&t, names[scan_no % 5]);
    append_z(&t, ";UNIT=C;");

    /* parse */
    int n;
    const char *f;
    uint32_t hash = t.len;
    f = field(&t, "ID=", &n);
    hash = hash * 31 + parse_int(f, n);
    f = field(&t, "TEMP=", &n);
    hash = hash * 31 + parse_int(f, n);
    f = field(&t, "STATE=", &n);
    char word[21];
    memcpy(word, f, n);
    word[n] = 0;
    for (int i = 0; i < 5; i++) {
        int d = strcmp(word, names[i]);
        if (d == 0)
            hash = hash * 31 + i;
        else if (d < 0)
            hash++;
    }

    /* edit */
    Str w;
    int unit = (int)(strstr(t.s, "UNIT=") - t.s) + 5;
    w.len = 0;
    append(&w, t.s, 3);
    append(&w, "NR-", 3);
    append(&w, t.s + 3, unit - 3);
    append(&w, "F", 1);
    append(&w, t.s + unit + 1, t.len - unit - 1);
    int pos = (int)(strstr(w.s, ";TEMP=") - w.s);
    memmove(w.s + pos, w.s + pos + 6, w.len - pos - 6 + 1);
    w.len -= 6;

    Str e;
    e.len = 0;
    append(&e, w.s + w.len - 10, 10);
    append(&e, "|", 1);
    append(&e, w.s, 12);

    /* reverse, then sum up the characters */
    Str b;
    b.len = e.len;
    for (int i = 0; i < e.len; i++)
        b.s[i] = e.s[e.len - 1 - i];
    b.s[b.len] = 0;
    for (int i = 0; i < b.len; i++)
        hash = hash * 31 + (uint8_t)b.s[i];
    check = (int32_t)hash;
}
