/* Text kernel: build a record, take it apart, edit it, reverse a number. */
#include <stdlib.h>
#include <string.h>
#include "st.h"

static int32_t seed = 74755;

static int32_t Rand(void)
{
    seed = (seed * 1309 + 13849) & 65535;
    return seed;
}

/* Decimal text of v, returns the length. */
static int itoa10(int32_t v, char *s)
{
    char tmp[12];
    int n = 0, len = 0;
    uint32_t x = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;

    do {
        tmp[n++] = (char)('0' + x % 10);
        x /= 10;
    } while (x != 0);
    if (v < 0)
        s[len++] = '-';
    while (n > 0)
        s[len++] = tmp[--n];
    s[len] = 0;
    return len;
}

/* Position of t in s from 1, 0 if there is none. */
static int find(const char *s, const char *t)
{
    const char *p = strstr(s, t);

    return p ? (int)(p - s) + 1 : 0;
}

void scan(void)
{
    char line[81], num[16], rev[16], key[81], rest[81], edit[81];
    int32_t k, i, id, v, p, q, n, sum = 0;

    for (k = 0; k < 6; k++) {
        /* build */
        id = Rand() % 1000;
        v = Rand() - 32768;
        strcpy(line, "ID=");
        itoa10(id, num);
        strcat(line, num);
        strcat(line, ";T=");
        itoa10(v, num);
        strcat(line, num);
        strcat(line, ";NAME=pump;");

        /* take apart */
        p = find(line, ";");
        memcpy(key, line, p - 1);
        key[p - 1] = 0;
        strcpy(rest, line + p);
        q = find(rest, "=");
        n = find(rest, ";") - q - 1;
        memcpy(num, rest + q, n);
        num[n] = 0;
        sum = sum + atoi(num) + atoi(key + 3);

        /* edit: insert after the first field, replace the name, drop the head */
        memcpy(edit, line, p);
        strcpy(edit + p, "OK=1;");
        strcat(edit, line + p);
        p = find(edit, "pump");
        strcpy(rest, edit + p - 1 + 4);
        strcpy(edit + p - 1, "valve");
        strcat(edit, rest);
        memmove(edit, edit + 3, strlen(edit + 3) + 1);
        sum = sum + (int32_t)strlen(edit) * 100 + find(edit, "valve") + find(edit, "7") * 3 + find(edit, "42") * 7;

        /* reverse and add */
        n = itoa10(id * 7 + 1000, num);
        for (i = 0; i < n; i++)
            rev[n - 1 - i] = num[i];
        rev[n] = 0;
        sum = sum + atoi(rev);
        if (strcmp(rev, num) == 0)
            sum = sum + 100000;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
