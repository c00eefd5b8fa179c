#include <stdbool.h>
#include <string.h>
#include "st.h"

typedef struct { int len; char s[164]; } Str;

typedef struct {
    Str lot, product, text;
    int sep;
} Label;

static void append_n(Str *d, const char *s, int n) { memcpy(d->s + d->len, s, (size_t)n); d->len += n; }
static void append_char(Str *d, char c) { d->s[d->len++] = c; }
static void append(Str *d, const Str *s) { append_n(d, s->s, s->len); }

static void append_number(Str *d, int32_t value, int width)
{
    char buf[12];
    int n = 0;
    do {
        buf[n++] = (char)('0' + value % 10);
        value /= 10;
    } while (value);
    for (int i = n; i < width; i++)
        append_char(d, '0');
    while (n)
        append_char(d, buf[--n]);
}

/* 1-based position, 0 if not found */
static int find(const char *s, int len, const char *what, int n)
{
    for (int i = 0; i + n <= len; i++)
        if (s[i] == what[0] && memcmp(s + i, what, (size_t)n) == 0)
            return i + 1;
    return 0;
}

static int find_char(const char *s, int len, char c)
{
    const char *p = memchr(s, c, (size_t)len);
    return p ? (int)(p - s) + 1 : 0;
}

static int compare(const char *a, int na, const char *b, int nb)
{
    int r = memcmp(a, b, (size_t)(na < nb ? na : nb));
    return r ? r : na - nb;
}

#define PRODUCT(t) { sizeof t - 1, t }
static const Str products[5] = {
    PRODUCT("COLA"), PRODUCT("LEMONADE"), PRODUCT("STILL WATER"), PRODUCT("ORANGE"), PRODUCT("BEER 0.0"),
};
static Label labels[8];
static struct {
    Str last, number, name, tail, rest;
    int where;
    bool cola, greater;
} parser = { .last = PRODUCT("LOT-000500") };
static int32_t scans;

static void build(Label *l, int32_t number, const Str *product)
{
    l->lot.len = 0;
    append_n(&l->lot, "LOT-", 4);
    append_number(&l->lot, number, 6);
    l->product.len = 0;
    append(&l->product, product);
    l->text.len = 0;
    append(&l->text, &l->lot);
    append_char(&l->text, ';');
    append(&l->text, &l->product);
    append_char(&l->text, ';');
    append_number(&l->text, number % 977, 1);
    l->sep = find_char(l->text.s, l->text.len, ';');
}

static void parse(const Label *l)
{
    const Str *t = &l->text;
    parser.number.len = 0;
    append_n(&parser.number, t->s + 4, l->sep - 5);
    parser.tail.len = 0;
    append_n(&parser.tail, t->s + l->sep, t->len - l->sep);
    parser.where = find_char(parser.tail.s, parser.tail.len, ';');
    parser.name.len = 0;
    append_n(&parser.name, parser.tail.s, parser.where - 1);
    parser.cola = parser.name.len == 4 && memcmp(parser.name.s, "COLA", 4) == 0;
    parser.greater = compare(l->lot.s, l->lot.len, parser.last.s, parser.last.len) > 0;
    parser.last.len = 0;
    append(&parser.last, &l->lot);

    Str *r = &parser.rest;
    r->len = 0;
    append_n(r, "<L>", 3);
    append_n(r, t->s + 4, t->len - 4);
    if (parser.cola) {
        int n = parser.name.len;
        int p = find(r->s, r->len, parser.name.s, n) - 1;
        memmove(r->s + p + 10, r->s + p + n, (size_t)(r->len - p - n));
        memcpy(r->s + p, "SUGAR FREE", 10);
        r->len += 10 - n;
    }
}

void scan(void)
{
    static Str log;
    uint32_t sum = 0;
    scans++;
    log.len = 0;
    for (int i = 0; i < 8; i++) {
        build(&labels[i], (scans * 37 + i * 1009) % 1000000, &products[(scans + i) % 5]);
        parse(&labels[i]);
        append_n(&log, parser.rest.s, parser.rest.len < 12 ? parser.rest.len : 12);
        append_char(&log, '|');
        sum = sum * 5u + (uint32_t)(parser.rest.len + find_char(parser.rest.s, parser.rest.len, '7') * 3 + parser.where);
        if (parser.cola)
            sum += 11;
        if (parser.greater)
            sum += 13;
        if (compare(parser.number.s, parser.number.len, "500000", 6) < 0)
            sum += 17;
    }
    sum += (uint32_t)(log.len * 7 + find(log.s, log.len, "99", 2) + find(log.s, log.len, "ORANGE", 6));
    if (compare(labels[0].text.s, labels[0].text.len, labels[7].text.s, labels[7].text.len) < 0)
        sum += 1000;
    check = (int32_t)((uint32_t)check * 31u + sum + 1u);
}
