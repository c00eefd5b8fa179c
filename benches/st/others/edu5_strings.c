#include <string.h>
#include "st.h"

#define MAX 60
typedef struct { int len; char s[MAX + 1]; } Str;

static int number;
static Str message, name, value, longest, edited;

static void append(Str *d, const char *s, int n)
{
    if (n > MAX - d->len) n = MAX - d->len;
    memcpy(d->s + d->len, s, (size_t)n);
    d->len += n;
    d->s[d->len] = 0;
}

static void append_int(Str *d, int v)
{
    char buf[12], *p = buf + sizeof buf;
    unsigned u = v < 0 ? 0u - (unsigned)v : (unsigned)v;
    do *--p = (char)('0' + u % 10); while (u /= 10);
    if (v < 0) *--p = '-';
    append(d, p, (int)(buf + sizeof buf - p));
}

static void set(Str *d, const char *s, int n)
{
    d->len = 0;
    append(d, s, n);
}

/* Replaces `count` characters at `at` (from 0) by s. */
static void splice(Str *d, int at, int count, const char *s, int n)
{
    int rest = d->len - at - count;
    if (n > MAX - at) n = MAX - at;
    if (rest > MAX - at - n) rest = MAX - at - n;
    memmove(d->s + at + n, d->s + at + count, (size_t)rest);
    memcpy(d->s + at, s, (size_t)n);
    d->len = at + n + rest;
    d->s[d->len] = 0;
}

/* The place (from 1) of a text, 0 if it is not there. */
static int find(const Str *d, const char *s)
{
    const char *p = strstr(d->s, s);
    return p ? (int)(p - d->s) + 1 : 0;
}

static int find_char(const Str *d, char c)
{
    const char *p = memchr(d->s, c, (size_t)d->len);
    return p ? (int)(p - d->s) + 1 : 0;
}

static int to_int(const Str *d)
{
    int v = 0;
    for (int i = 0; i < d->len; i++) v = v * 10 + (d->s[i] - '0');
    return v;
}

void scan(void)
{
    number++;
    int sum = 1;
    set(&longest, "", 0);
    for (int i = 1; i <= 10; i++) {
        set(&message, "Tank ", 5);
        append_int(&message, i);
        append(&message, ": level=", 8);
        append_int(&message, number * i);
        append(&message, " mm", 3);
        set(&name, message.s, find_char(&message, ':') - 1);
        int pos = find_char(&message, '=');
        set(&value, message.s + pos, message.len - pos - 3);
        if (strcmp(value.s, longest.s) > 0) longest = value;
        edited = message;
        splice(&edited, 0, 4, "Silo", 4);
        splice(&edited, edited.len - 3, 3, "", 0);
        splice(&edited, name.len, 0, " (ok)", 5);
        if (value.s[value.len - 1] == '7') sum += 100;
        if (strcmp(name.s, "Tank 5") == 0) sum += number;
        sum += message.len + value.len + find(&edited, "level") + edited.len;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum + (uint32_t)to_int(&longest));
}
