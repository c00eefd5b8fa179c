/* builds, takes apart and edits telegrams with about 40 calls of string functions a scan */
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define MAX 80

/* a string with its length; the characters are not terminated */
struct str {
    int len;
    char s[MAX];
};

static void append(struct str *d, const char *s, int n)
{
    if (n > MAX - d->len)
        n = MAX - d->len;
    memcpy(d->s + d->len, s, (size_t)n);
    d->len += n;
}

#define APPEND(d, lit) append((d), (lit), (int)sizeof(lit) - 1)

static void append_int(struct str *d, int32_t v)
{
    char buf[12], *p = buf + sizeof buf;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
    do
        *--p = (char)('0' + u % 10);
    while ((u /= 10) != 0);
    if (v < 0)
        *--p = '-';
    append(d, p, (int)(buf + sizeof buf - p));
}

/* replaces n characters at index i (from 0) by the ins_len characters of ins */
static void splice(struct str *d, int i, int n, const char *ins, int ins_len)
{
    if (i > d->len)
        i = d->len;
    if (n > d->len - i)
        n = d->len - i;
    if (ins_len > MAX - i)
        ins_len = MAX - i;
    int tail = d->len - i - n;
    if (tail > MAX - i - ins_len)
        tail = MAX - i - ins_len;
    memmove(d->s + i + ins_len, d->s + i + n, (size_t)tail);
    memcpy(d->s + i, ins, (size_t)ins_len);
    d->len = i + ins_len + tail;
}

/* index from 0 of the first occurrence, -1 if there is none */
static int find(const char *s, int len, const char *what, int n)
{
    const char *p = s;
    int left = len - n + 1;
    while (left > 0 && (p = memchr(p, what[0], (size_t)left)) != NULL) {
        if (memcmp(p, what, (size_t)n) == 0)
            return (int)(p - s);
        p++;
        left = len - n + 1 - (int)(p - s);
    }
    return -1;
}

static int count_of(const struct str *s, const char *what, int n)
{
    const char *p = s->s, *end = p + s->len;
    int count = 0, at;
    while ((at = find(p, (int)(end - p), what, n)) >= 0) {
        count++;
        p += at + 1;
    }
    return count;
}

static int compare(const struct str *a, const struct str *b)
{
    int n = a->len < b->len ? a->len : b->len;
    int c = memcmp(a->s, b->s, (size_t)n);
    return c != 0 ? c : a->len - b->len;
}

static int16_t parse_int(const char *s, int n)
{
    bool negative = n > 0 && *s == '-';
    int v = 0;
    for (int i = negative; i < n; i++)
        v = v * 10 + (s[i] - '0');
    return (int16_t)(negative ? -v : v);
}

struct telegram {
    struct str text;
    int16_t value;
    int cut;
};

static void telegram(struct telegram *t, int16_t number, int state)
{
    struct str *s = &t->text;

    s->len = 0;
    APPEND(s, "ID=");
    append_int(s, number);
    t->cut = s->len;
    switch (state) {
    case 0:
        APPEND(s, ";S=RUN");
        break;
    case 1:
        APPEND(s, ";S=STOP");
        break;
    case 2:
        APPEND(s, ";S=FAULT;CODE=");
        append_int(s, number % 97);
        break;
    default:
        APPEND(s, ";");
    }
    int p = find(s->s, s->len, ";", 1);
    t->value = parse_int(s->s + 3, p - 3);
    if (t->value > 20000)
        splice(s, 0, 3, "HIGH:", 5);
    else if (t->value > 5000)
        splice(s, p, 0, "/MID", 4);
    else if (t->value < 0)
        splice(s, 3, 1, "", 0);
}

static uint32_t seed = 31415;
static struct telegram t[3];
static struct str journal, last;

void scan(void)
{
    uint32_t sum = 0;

    for (int i = 0; i < 3; i++) {
        seed = seed * 1664525u + 1013904223u;
        int r = (int)(seed / 131072);
        telegram(&t[i], (int16_t)(r - 4000), r % 4);
        sum = sum * 7 + (uint32_t)(t[i].value + t[i].cut + t[i].text.len);
        int c = compare(&t[i].text, &last);
        if (c < 0)
            sum += 3;
        else if (c == 0)
            sum += 5;
        last = t[i].text;
        int n = 2 + r % 5;
        append(&journal, last.s, n);
        APPEND(&journal, ",");
        sum += (uint32_t)(find(journal.s, journal.len, last.s, n) + 1);
    }
    while (journal.len > 50)
        splice(&journal, 0, find(journal.s, journal.len, ",", 1) + 1, "", 0);
    sum += (uint32_t)count_of(&journal, "ID", 2);
    if (count_of(&last, "1", 1) > 1) {
        struct str number;
        number.len = 0;
        append_int(&number, (int32_t)sum);
        splice(&journal, 0, 2, number.s, number.len);
    }
    check = (int32_t)((uint32_t)check * 31u + sum + (uint32_t)journal.len);
}
