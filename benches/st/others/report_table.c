#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include "st.h"

static const char *names[5] = { "feed,raw", "water", "steam,low,return", "power", "waste,solid" };
static const char *units[5] = { "kg", "l", "kg", "kWh", "kg" };
static int32_t totals[5] = { 120, 99500, 7, 1250000, 64000 };
static char lines[5][84];
static int32_t scans;

static int clean(char *to, const char *s)
{
    char *p = to;
    for (; *s; s++)
        if (*s == ',') {
            *p++ = ' ';
            *p++ = '-';
        } else
            *p++ = *s;
    return p - to;
}

static int thousands(char *to, int32_t v)
{
    char b[24];
    int n = 0, digits = 0;
    do {
        if (digits && digits % 3 == 0)
            b[n++] = '\'';
        b[n++] = '0' + v % 10;
        digits++;
        v /= 10;
    } while (v);
    for (int i = 0; i < n; i++)
        to[i] = b[n - 1 - i];
    return n;
}

static char *pad_right(char *p, const char *s, int n, int width, char fill)
{
    if (n > width)
        n = width;
    memcpy(p, s, n);
    memset(p + n, fill, width - n);
    return p + width;
}

static char *pad_left(char *p, const char *s, int n, int width)
{
    if (n < width) {
        memset(p, ' ', width - n);
        p += width - n;
    }
    memcpy(p, s, n);
    return p + n;
}

void scan(void)
{
    int32_t sum = 0;
    scans++;
    for (int i = 0; i < 5; i++) {
        char b[64], *p = lines[i];
        totals[i] += scans * (i + 1) % 17;
        int n = clean(b, names[i]);
        p = pad_right(p, b, n, 18, '.');
        n = thousands(b, totals[i]);
        p = pad_left(p, b, n, 12);
        *p++ = ' ';
        p = pad_right(p, units[i], strlen(units[i]), 4, ' ');
        *p = 0;
        n = p - lines[i];
        const char *q = strchr(lines[i], '\'');
        sum += n + (q ? q - lines[i] + 1 : 0);
        if (memcmp(lines[i] + 4, "er.", 3) == 0 || memcmp(p - 4, "kWh ", 4) == 0)
            sum += 100 * (i + 1);
    }
    check = (check * 3 + sum) % 1000003;
}
