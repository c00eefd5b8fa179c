#include <string.h>
#include "st.h"

static const char names[8][17] = { "PUMP", "VALVE", "MIXER", "HEATER", "CONVEYOR", "FILLER", "CAPPER", "LABELER" };
static const char states[4][17] = { "RUN", "STOP", "FAULT", "IDLE" };
static char msg[81], line[81], maxLine[81];
static char head[21], tail[21], num[21];
static int32_t scanNo;

static void int_to_string(char *dst, int16_t value)
{
    char tmp[8];
    int n = 0;
    int32_t x = value;

    if (x < 0) {
        *dst++ = '-';
        x = -x;
    }
    do {
        tmp[n++] = (char)('0' + x % 10);
        x /= 10;
    } while (x != 0);
    while (n > 0)
        *dst++ = tmp[--n];
    *dst = '\0';
}

static int16_t string_to_int(const char *s)
{
    int32_t x = 0;
    int neg = 0;

    if (*s == '-') {
        neg = 1;
        s++;
    }
    while (*s >= '0' && *s <= '9')
        x = x * 10 + (*s++ - '0');
    return (int16_t)(neg ? -x : x);
}

static int16_t str_find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int16_t)(p - s + 1) : 0;
}

/* n characters from position pos (1-based) */
static void str_mid(char *dst, const char *src, int n, int pos)
{
    int len = (int)strlen(src);

    if (n < 0 || pos < 1 || pos > len)
        n = 0;
    else if (n > len - pos + 1)
        n = len - pos + 1;
    memcpy(dst, src + pos - 1, (size_t)n);
    dst[n] = '\0';
}

static void str_left(char *dst, const char *src, int n)
{
    str_mid(dst, src, n, 1);
}

static void str_right(char *dst, const char *src, int n)
{
    int len = (int)strlen(src);

    if (n > len)
        n = len;
    strcpy(dst, src + len - n);
}

static void str_replace(char *dst, const char *src, const char *with, int n, int pos)
{
    int len = (int)strlen(src);
    int wlen = (int)strlen(with);

    if (pos > len + 1)
        pos = len + 1;
    if (n > len - pos + 1)
        n = len - pos + 1;
    memcpy(dst, src, (size_t)(pos - 1));
    memcpy(dst + pos - 1, with, (size_t)wlen);
    strcpy(dst + pos - 1 + wlen, src + pos - 1 + n);
}

/* text after the first pos characters, in place */
static void str_insert(char *s, const char *text, int pos)
{
    int len = (int)strlen(s);
    int tlen = (int)strlen(text);

    if (pos > len)
        pos = len;
    memmove(s + pos + tlen, s + pos, (size_t)(len - pos + 1));
    memcpy(s + pos, text, (size_t)tlen);
}

static void str_delete(char *s, int n, int pos)
{
    int len = (int)strlen(s);

    if (pos < 1 || pos > len)
        return;
    if (n > len - pos + 1)
        n = len - pos + 1;
    memmove(s + pos - 1, s + pos - 1 + n, (size_t)(len - pos + 1 - n + 1));
}

void scan(void)
{
    int32_t i, n, k, acc = 0, hits = 0;
    int16_t val, v, p, c;
    char digits[8];

    scanNo++;
    maxLine[0] = '\0';
    for (i = 0; i < 32; i++) {
        n = i % 8;
        val = (int16_t)((int32_t)((uint32_t)scanNo * 37u + (uint32_t)i * 211u) % 2000 - 500);
        k = (scanNo / 3 + i) % 4;

        strcpy(msg, names[n]);
        strcat(msg, ": T=");
        int_to_string(digits, val);
        strcat(msg, digits);
        strcat(msg, " C, STATE=");
        strcat(msg, states[k]);

        p = str_find(msg, "T=");
        c = str_find(msg, " C,");
        str_mid(num, msg, c - p - 2, p + 2);
        v = string_to_int(num);

        str_replace(line, msg, " -> ", 2, str_find(msg, ": "));
        if (strstr(line, "FAULT")) {
            str_insert(line, "!! ", 0);
            hits++;
        }
        p = str_find(line, "STATE=");
        str_delete(line, 6, p);

        str_left(head, msg, (int)strlen(names[n]));
        str_right(tail, msg, 4);
        if (strcmp(head, names[n]) == 0)
            hits++;
        if (strcmp(tail, "STOP") == 0)
            hits += 10;
        else if (strcmp(tail, "=RUN") == 0)
            hits += 20;
        if (strcmp(line, maxLine) > 0) {
            strcpy(maxLine, line);
            hits += 100;
        }
        acc += (int32_t)strlen(line) * 3 + v + p + c + (int32_t)strlen(num);
    }
    acc += (int32_t)strlen(maxLine) + str_find(maxLine, "->");
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(acc + hits * 7));
}
