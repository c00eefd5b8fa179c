/* String work: build records, take them apart, search and edit them, compare. */
#include <string.h>
#include "st.h"

#define MAX 80

static const char names[8][21] = {"Pump", "Valve", "Motor", "Heater", "Mixer", "Conveyor", "Sensor", "Lift"};
static char recs[16][MAX + 1];
static char key[MAX + 1], val[MAX + 1], s[MAX + 1], best[MAX + 1];
static int32_t cyc;

/* position of the first occurrence counted from 1, 0 if none */
static int32_t find(const char *text, const char *pat)
{
    const char *p = strstr(text, pat);
    return p ? (int32_t)(p - text) + 1 : 0;
}

static void append(char *dst, const char *src)
{
    size_t n = strlen(dst), m = strlen(src);
    if (n + m > MAX)
        m = MAX - n;
    memcpy(dst + n, src, m);
    dst[n + m] = 0;
}

/* l characters from position p on */
static void mid(char *dst, const char *src, int32_t l, int32_t p)
{
    int32_t n = (int32_t)strlen(src);
    if (p < 1 || p > n || l < 0) {
        dst[0] = 0;
        return;
    }
    if (l > n - p + 1)
        l = n - p + 1;
    memcpy(dst, src + p - 1, l);
    dst[l] = 0;
}

static void left(char *dst, const char *src, int32_t l)
{
    mid(dst, src, l, 1);
}

static const char *right(const char *src, int32_t l)
{
    int32_t n = (int32_t)strlen(src);
    return l >= n ? src : src + (n - l);
}

/* l characters at position p give way to pat, in place */
static void replace(char *t, const char *pat, int32_t l, int32_t p)
{
    int32_t n = (int32_t)strlen(t), m = (int32_t)strlen(pat);
    if (p < 1)
        p = 1;
    if (p > n + 1)
        p = n + 1;
    if (l > n - p + 1)
        l = n - p + 1;
    if (n - l + m > MAX)
        return;
    memmove(t + p - 1 + m, t + p - 1 + l, n - (p - 1 + l) + 1);
    memcpy(t + p - 1, pat, m);
}

static void insert(char *t, const char *pat, int32_t p)
{
    replace(t, pat, 0, p + 1);
}

static void delete(char *t, int32_t l, int32_t p)
{
    replace(t, "", l, p);
}

static const char *int_to_string(char *buf, int32_t v)
{
    char *p = buf + 15;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
    *p = 0;
    do {
        *--p = (char)('0' + u % 10);
        u /= 10;
    } while (u);
    if (v < 0)
        *--p = '-';
    return p;
}

static int16_t string_to_int(const char *t)
{
    int32_t v = 0, neg = 0;
    if (*t == '-') {
        neg = 1;
        t++;
    }
    while (*t >= '0' && *t <= '9')
        v = v * 10 + (*t++ - '0');
    return (int16_t)(neg ? -v : v);
}

void scan(void)
{
    int32_t i, k, sum = 0;
    int16_t p, q;
    int16_t num;
    char buf[16];

    cyc = (cyc + 1) % 1000;

    /* build: "Name_12=345;unit=bar" */
    for (i = 0; i < 16; i++) {
        k = (i + cyc) % 8;
        num = (int16_t)((cyc * 13 + i * 71) % 2000 - 1000);
        strcpy(recs[i], names[k]);
        append(recs[i], "_");
        append(recs[i], int_to_string(buf, i));
        append(recs[i], "=");
        append(recs[i], int_to_string(buf, num));
        append(recs[i], ";unit=bar");
    }

    /* parse and convert */
    for (i = 0; i < 16; i++) {
        p = (int16_t)find(recs[i], "=");
        q = (int16_t)find(recs[i], ";");
        left(key, recs[i], p - 1);
        mid(val, recs[i], q - p - 1, p + 1);
        sum += string_to_int(val) + (int32_t)strlen(key) * 100;
        if (find(key, "or_") > 0)
            sum += 7;
    }

    /* edit */
    for (i = 0; i < 16; i++) {
        p = (int16_t)find(recs[i], "unit");
        strcpy(s, recs[i]);
        replace(s, "dim", 4, p);
        insert(s, "Area1.", 0);
        p = (int16_t)find(s, "_");
        delete(s, 1, p);
        sum += (int32_t)strlen(s);
        if (strcmp(right(s, 3), "bar") == 0)
            sum += 3;
        strcpy(recs[i], s);
    }

    /* compare: the greatest text */
    best[0] = 0;
    k = 0;
    for (i = 0; i < 16; i++) {
        if (strcmp(recs[i], best) > 0) {
            strcpy(best, recs[i]);
            k = i;
        }
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + k * 1000 + (int32_t)strlen(best)));
}
