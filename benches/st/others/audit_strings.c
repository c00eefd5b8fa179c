/* Messages of a line: build, parse, search, edit and compare texts */
#include <stdlib.h>
#include <string.h>
#include "st.h"

/* dst (cap bytes with the NUL) := a b */
static void str_concat(char *dst, size_t cap, const char *a, const char *b)
{
    size_t la = strlen(a), lb = strlen(b);
    if (la > cap - 1)
        la = cap - 1;
    if (lb > cap - 1 - la)
        lb = cap - 1 - la;
    memmove(dst, a, la);
    memcpy(dst + la, b, lb);
    dst[la + lb] = '\0';
}

/* n characters of s from the 1-based position p */
static void str_mid(char *dst, size_t cap, const char *s, int n, int p)
{
    int len = (int)strlen(s);
    if (p < 1 || p > len || n <= 0) {
        dst[0] = '\0';
        return;
    }
    if (n > len - p + 1)
        n = len - p + 1;
    if (n > (int)cap - 1)
        n = (int)cap - 1;
    memcpy(dst, s + p - 1, (size_t)n);
    dst[n] = '\0';
}

static void str_left(char *dst, size_t cap, const char *s, int n)
{
    str_mid(dst, cap, s, n, 1);
}

static void str_right(char *dst, size_t cap, const char *s, int n)
{
    int len = (int)strlen(s);
    if (n > len)
        n = len;
    str_mid(dst, cap, s, n, len - n + 1);
}

/* 1-based position of t in s, 0 if it is not there */
static int str_find(const char *s, const char *t)
{
    const char *q = strstr(s, t);
    return q ? (int)(q - s) + 1 : 0;
}

/* s with n characters from position p replaced by t */
static void str_replace(char *dst, size_t cap, const char *s, const char *t, int n, int p)
{
    char tmp[160];
    size_t ls = strlen(s), lt = strlen(t), head = (size_t)(p - 1), len;
    if (head > ls)
        head = ls;
    if ((size_t)n > ls - head)
        n = (int)(ls - head);
    memcpy(tmp, s, head);
    memcpy(tmp + head, t, lt);
    memcpy(tmp + head + lt, s + head + n, ls - head - n);
    len = ls + lt - (size_t)n;
    if (len > cap - 1)
        len = cap - 1;
    memcpy(dst, tmp, len);
    dst[len] = '\0';
}

/* t put into s behind p characters */
static void str_insert(char *dst, size_t cap, const char *s, const char *t, int p)
{
    str_replace(dst, cap, s, t, 0, p + 1);
}

static void str_delete(char *dst, size_t cap, const char *s, int n, int p)
{
    str_replace(dst, cap, s, "", n, p);
}

static void int_to_str(char *dst, int16_t value)
{
    char tmp[8];
    int n = 0, neg = value < 0;
    int v = neg ? -value : value;
    do {
        tmp[n++] = (char)('0' + v % 10);
        v /= 10;
    } while (v);
    if (neg)
        *dst++ = '-';
    while (n)
        *dst++ = tmp[--n];
    *dst = '\0';
}

static int16_t scans;
static char names[8][21] = { "Mixer", "Pump", "Conveyor", "Boiler", "Chiller", "Press", "Robot", "Packer" };
static char latest[81];

void scan(void)
{
    char msg[81], num[21], part[41], line[81];
    int32_t acc = 0;
    int i, p;
    int16_t v;

    scans = (int16_t)((scans + 1) % 10000);

    for (i = 0; i < 8; i++) {
        /* build: "Pump:temp=123;state=RUN" */
        int_to_str(num, (int16_t)(scans + i * 37));
        str_concat(msg, sizeof msg, names[i], ":temp=");
        str_concat(msg, sizeof msg, msg, num);
        if ((scans + i) % 3 == 0)
            str_concat(msg, sizeof msg, msg, ";state=STOP");
        else
            str_concat(msg, sizeof msg, msg, ";state=RUN");
        acc += (int32_t)strlen(msg);

        /* parse it again */
        p = str_find(msg, "=");
        str_mid(part, sizeof part, msg, str_find(msg, ";") - p - 1, p + 1);
        v = (int16_t)atoi(part);
        acc += v;
        str_left(part, sizeof part, msg, str_find(msg, ":") - 1);
        if (strcmp(part, names[i]) == 0)
            acc += 7;
        str_right(part, sizeof part, msg, 4);
        if (strcmp(part, "STOP") == 0)
            acc += 11;

        /* edit: insert a tag, replace and delete words */
        str_insert(line, sizeof line, msg, "Line1/", 0);
        p = str_find(line, "temp");
        str_replace(line, sizeof line, line, "temperature", 4, p);
        p = str_find(line, ";state");
        if (p > 0)
            str_delete(line, sizeof line, line, 6, p);
        acc += (int32_t)strlen(line) * 3;
        if (strcmp(line, latest) > 0)
            acc += 13;
        strcpy(latest, line);
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)acc);
}
