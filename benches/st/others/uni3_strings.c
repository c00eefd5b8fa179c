/* Messages of twelve stations: build, edit, search, take apart again */
#include <stdbool.h>
#include <string.h>
#include "st.h"

static void int_to_str(char *dst, int16_t value)
{
    char tmp[8];
    int n = 0;
    int v = value;

    if (v < 0) {
        *dst++ = '-';
        v = -v;
    }
    do {
        tmp[n++] = (char)('0' + v % 10);
        v /= 10;
    } while (v > 0);
    while (n > 0)
        *dst++ = tmp[--n];
    *dst = 0;
}

static int16_t str_to_int(const char *s)
{
    int v = 0;
    bool neg = false;

    if (*s == '-') {
        neg = true;
        s++;
    }
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return (int16_t)(neg ? -v : v);
}

/* position from 1, 0 when not found */
static int find(const char *s, const char *what)
{
    const char *p = strstr(s, what);

    return p ? (int)(p - s) + 1 : 0;
}

static void left(char *dst, const char *s, int n)
{
    int len = (int)strlen(s);

    if (n > len)
        n = len;
    memmove(dst, s, (size_t)n);
    dst[n] = 0;
}

static void right(char *dst, const char *s, int n)
{
    int len = (int)strlen(s);

    if (n > len)
        n = len;
    memmove(dst, s + len - n, (size_t)n + 1);
}

static void mid(char *dst, const char *s, int n, int pos)
{
    int len = (int)strlen(s);

    if (pos > len)
        n = 0;
    else if (pos - 1 + n > len)
        n = len - pos + 1;
    memmove(dst, s + pos - 1, (size_t)n);
    dst[n] = 0;
}

static void delete(char *s, int n, int pos)
{
    int len = (int)strlen(s);

    if (pos > len)
        return;
    if (pos - 1 + n > len)
        n = len - pos + 1;
    memmove(s + pos - 1, s + pos - 1 + n, (size_t)(len - (pos - 1 + n)) + 1);
}

static void insert(char *s, const char *what, int pos)
{
    int len = (int)strlen(s), n = (int)strlen(what);

    if (pos > len)
        pos = len;
    memmove(s + pos + n, s + pos, (size_t)(len - pos) + 1);
    memcpy(s + pos, what, (size_t)n);
}

static void replace(char *s, const char *what, int n, int pos)
{
    delete(s, n, pos);
    insert(s, what, pos - 1);
}

static bool ready;
static int16_t tick;
static char parts[10][21];
static char code[21], msg[81], part[81], num[21], best[81];

void scan(void)
{
    int i, k, p, q, found;
    int16_t temp;
    int32_t sum;
    char tmp[21];

    if (!ready) {
        ready = true;
        strcpy(parts[0], "PRT-100-A");
        strcpy(parts[1], "PRT-107-B");
        strcpy(parts[2], "PRT-114-C");
        strcpy(parts[3], "PRT-121-A");
        strcpy(parts[4], "PRT-128-B");
        strcpy(parts[5], "PRT-135-C");
        strcpy(parts[6], "PRT-142-A");
        strcpy(parts[7], "PRT-149-B");
        strcpy(parts[8], "PRT-156-C");
        strcpy(parts[9], "PRT-163-A");
    }

    tick = (tick + 1) % 1000;
    sum = 0;
    best[0] = 0;
    for (i = 1; i <= 12; i++) {
        temp = (int16_t)((tick * 3 + i * 17) % 140 - 20);

        /* build */
        strcpy(msg, "Station ");
        int_to_str(tmp, (int16_t)i);
        strcat(msg, tmp);
        strcat(msg, ": T=");
        int_to_str(tmp, temp);
        strcat(msg, tmp);
        strcat(msg, " C");
        if (temp > 80)
            strcat(msg, " HIGH");
        else if (temp < 0)
            strcat(msg, " LOW");
        else
            strcat(msg, " OK");

        /* take the number out of the text */
        p = find(msg, "T=");
        q = find(msg, " C");
        mid(num, msg, q - p - 2, p + 2);
        sum += str_to_int(num);

        /* edit */
        p = find(msg, "HIGH");
        if (p > 0)
            replace(msg, "ALARM", 4, p);
        delete(msg, 6, 2);
        insert(msg, "#", 2);
        right(tmp, msg, 2);
        if (strcmp(tmp, "OK") == 0)
            left(msg, msg, (int)strlen(msg) - 3);
        sum += (int32_t)strlen(msg);

        /* look up a part number */
        strcpy(code, "PRT-");
        int_to_str(tmp, (int16_t)(100 + ((tick + i) % 10) * 7));
        strcat(code, tmp);
        found = -1;
        for (k = 0; k <= 9; k++) {
            left(tmp, parts[k], 7);
            if (strcmp(tmp, code) == 0) {
                found = k;
                break;
            }
        }
        strcpy(part, parts[found]);
        right(tmp, part, 1);
        if (strcmp(tmp, "B") == 0)
            sum += 5;
        sum += found;

        /* keep the last one in alphabetical order */
        if (strcmp(msg, best) > 0)
            strcpy(best, msg);
    }
    sum += (int32_t)strlen(best) * 10 + find(best, ":");
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
