/* Builds, takes apart and edits messages "Motor_12=345;" */
#include <string.h>
#include <stdlib.h>
#include "st.h"

static void int_to_string(char *d, int16_t x)
{
    char tmp[8];
    int i = 0, v = x;
    if (v < 0) { *d++ = '-'; v = -v; }
    do { tmp[i++] = (char)('0' + v % 10); v /= 10; } while (v);
    while (i > 0) *d++ = tmp[--i];
    *d = 0;
}

/* 1-based position, 0 = not found */
static int find(const char *s, const char *what)
{
    const char *f = strstr(s, what);
    return f ? (int)(f - s) + 1 : 0;
}

static void mid(char *d, const char *s, int len, int pos)
{
    int n = (int)strlen(s);
    if (pos > n) { *d = 0; return; }
    if (len > n - pos + 1) len = n - pos + 1;
    memcpy(d, s + pos - 1, (size_t)len);
    d[len] = 0;
}

/* replace len characters at pos (1-based) by what, in place */
static void replace(char *s, const char *what, int len, int pos)
{
    size_t n = strlen(s), w = strlen(what);
    memmove(s + pos - 1 + w, s + pos - 1 + len, n - (size_t)(pos - 1 + len) + 1);
    memcpy(s + pos - 1, what, w);
}

static void insert(char *s, const char *what, int after)
{
    replace(s, what, 0, after + 1);
}

static void del(char *s, int len, int pos)
{
    size_t n = strlen(s);
    memmove(s + pos - 1, s + pos - 1 + len, n - (size_t)(pos - 1 + len) + 1);
}

static int16_t n;
static char name[41], key[41], text[41], last[41], msg[81], line[81];

void scan(void)
{
    char num[12];
    n = (n + 1) % 1000;
    line[0] = 0;
    for (int16_t i = 1; i <= 10; i++) {
        strcpy(name, "Motor_");
        int_to_string(num, i);
        strcat(name, num);
        strcpy(msg, name);
        strcat(msg, "=");
        int_to_string(num, (int16_t)(n * i));
        strcat(msg, num);
        strcat(msg, ";");

        int p = find(msg, "=");
        mid(key, msg, p - 1, 1);
        mid(text, msg, (int)strlen(msg) - p - 1, p + 1);
        int16_t v = (int16_t)atoi(text);
        if (strcmp(key, name) == 0)
            check = check * 31 + v;
        if (strcmp(text, last) < 0)
            check = check + 1;
        strcpy(last, text);

        replace(msg, " -> ", 1, p);
        insert(msg, "[ok] ", 0);
        del(msg, 3, 7);
        check = check + find(msg, "->") * 100 + (int32_t)strlen(msg);
        if (strlen(line) + strlen(key) < 60) {
            strcat(line, key + strlen(key) - 4);
            strcat(line, ",");
        }
    }
    check = check * 31 + (int32_t)strlen(line) + find(line, "r_7");
}
