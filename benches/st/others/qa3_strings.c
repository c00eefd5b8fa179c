#include "st.h"
#include <stdbool.h>
#include <string.h>

#define CAP 80

static void s_copy(char *dst, const char *src)
{
    size_t n = strlen(src);
    if (n > CAP)
        n = CAP;
    memmove(dst, src, n);
    dst[n] = 0;
}

static void s_append(char *dst, const char *src)
{
    size_t l = strlen(dst), n = strlen(src);
    if (n > CAP - l)
        n = CAP - l;
    memcpy(dst + l, src, n);
    dst[l + n] = 0;
}

/* count characters from position pos (1-based) */
static void s_mid(char *dst, const char *src, int count, int pos)
{
    int l = (int)strlen(src);
    if (count <= 0 || pos < 1 || pos > l) {
        dst[0] = 0;
        return;
    }
    if (count > l - pos + 1)
        count = l - pos + 1;
    memcpy(dst, src + pos - 1, (size_t)count);
    dst[count] = 0;
}

static int s_find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int)(p - s) + 1 : 0;
}

/* replaces count characters from position pos (1-based) by ins */
static void s_replace(char *s, const char *ins, int count, int pos)
{
    char tail[CAP + 1];
    int l = (int)strlen(s);
    if (pos > l + 1)
        pos = l + 1;
    if (count > l - pos + 1)
        count = l - pos + 1;
    strcpy(tail, s + pos - 1 + count);
    s[pos - 1] = 0;
    s_append(s, ins);
    s_append(s, tail);
}

static void int_to_str(char *dst, int16_t v)
{
    char tmp[8];
    int n = 0;
    int32_t u = v < 0 ? -(int32_t)v : v;
    do {
        tmp[n++] = (char)('0' + u % 10);
        u /= 10;
    } while (u != 0);
    if (v < 0)
        *dst++ = '-';
    while (n > 0)
        *dst++ = tmp[--n];
    *dst = 0;
}

static int16_t str_to_int(const char *s)
{
    bool neg = false;
    int32_t v = 0;
    if (*s == '-') {
        neg = true;
        s++;
    }
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return (int16_t)(neg ? -v : v);
}

static const char *const init[8] = {
    "Pump", "Mixer", "Conveyor", "Valve", "Heater", "Compressor", "Fan", "Boiler"
};
static bool first = true;
static int16_t cycle;
static char names[8][21];
static char msg[CAP + 1], field[CAP + 1], tail[CAP + 1], num[CAP + 1], best[CAP + 1];

void scan(void)
{
    int i, p, q;
    int16_t value;
    int32_t n = 0;

    if (first) {
        first = false;
        for (i = 0; i < 8; i++)
            strcpy(names[i], init[i]);
    }
    cycle = (int16_t)((cycle + 7) % 1000);
    best[0] = 0;
    for (i = 0; i < 8; i++) {
        value = (int16_t)(cycle * 3 + i * 211 - 900);
        s_copy(msg, "DEV=");
        s_append(msg, names[i]);
        s_append(msg, ";VAL=");
        int_to_str(num, value);
        s_append(msg, num);
        s_append(msg, ";UNIT=rpm;END");

        p = s_find(msg, "VAL=");
        s_mid(tail, msg, (int)strlen(msg) - p - 3, p + 4);
        q = s_find(tail, ";");
        s_mid(field, tail, q - 1, 1);
        n += str_to_int(field) + (int32_t)strlen(msg);
        if (strcmp(field, num) == 0)
            n += 1;

        p = s_find(msg, "rpm");
        s_replace(msg, "m/min", 3, p);
        p = s_find(msg, ";");
        s_replace(msg, "[OK]", 0, p + 1);
        if (value < 0) {
            p = s_find(msg, "[OK]");
            s_replace(msg, "", 4, p);
        }
        if (strcmp(msg, best) > 0)
            s_copy(best, msg);
        n = n * 3 + (int32_t)strlen(msg);
        if (strcmp(msg + strlen(msg) - 3, "END") == 0)
            n += s_find(msg, "min");
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)n + (uint32_t)strlen(best)
                      + (uint32_t)s_find(best, "UNIT"));
}
