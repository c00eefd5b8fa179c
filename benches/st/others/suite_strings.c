/* Telegrams are built, edited and taken apart with string functions. */
#include <stdlib.h>
#include <string.h>
#include "st.h"

#define MAX 80

static int32_t seed = 77;
static char telegram[MAX + 1], head[MAX + 1], tail[MAX + 1], field[MAX + 1], last[MAX + 1];

/* Writes v at p in decimal, returns the end. */
static char *put_int(char *p, int v)
{
    char digits[12];
    int n = 0;
    unsigned u = v < 0 ? 0u - (unsigned)v : (unsigned)v;

    if (v < 0)
        *p++ = '-';
    do
        digits[n++] = '0' + u % 10;
    while ((u /= 10) != 0);
    while (n > 0)
        *p++ = digits[--n];
    *p = '\0';
    return p;
}

static char *put(char *p, const char *s)
{
    size_t n = strlen(s);

    memcpy(p, s, n + 1);
    return p + n;
}

/* Position of the first t in s counted from 1, 0 if there is none. */
static int find(const char *s, const char *t)
{
    const char *p = strstr(s, t);

    return p ? (int)(p - s) + 1 : 0;
}

/* Replaces n characters of s after the first pos by t. */
static void splice(char *s, int pos, int n, const char *t)
{
    size_t len = strlen(s), m = strlen(t);

    memmove(s + pos + m, s + pos + n, len - pos - n + 1);
    memcpy(s + pos, t, m);
}

static void copy(char *to, const char *from, int n)
{
    memcpy(to, from, n);
    to[n] = '\0';
}

void scan(void)
{
    static const char *const units[3] = { "C", "degC", "Kelvin" };
    int32_t sum = 0;

    for (int i = 0; i < 3; i++) {
        int number, temperature, p, q, len;
        char *end;

        seed = (seed * 1103 + 12345) % 65536;
        number = seed % 900 + 1;
        temperature = seed % 211 - 60;

        /* build */
        end = put(telegram, "ID=");
        end = put_int(end, number);
        end = put(end, ";T=");
        end = put_int(end, temperature);
        end = put(end, ";U=");
        end = put(end, units[number % 3]);
        splice(telegram, 0, 0, "<");
        end = put(end + 1, ">");
        len = (int)(end - telegram);
        sum += len;

        /* take apart */
        p = find(telegram, ";");
        copy(head, telegram, p - 1);
        copy(tail, telegram + p, len - p);
        sum += atoi(head + 4);
        q = find(tail, ";");
        copy(field, tail + 2, q - 3);
        sum += atoi(field) * 3;

        /* edit */
        strcpy(field, tail);
        splice(field, 0, 1, "TEMP");
        p = find(field, "Kelvin");
        if (p > 0)
            splice(field, p - 1, 6, "K");
        splice(field, (int)strlen(field) - 1, 0, head);
        sum += 5 * (int)strlen(field) + 11 * find(field, "<ID") + 13 * find(field, "1");
        if (strcmp(field, last) > 0)
            sum += 1000;
        strcpy(last, field);
    }

    check = (check * 31 + sum) % 1000003;
}
