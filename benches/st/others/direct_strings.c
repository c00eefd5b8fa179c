/* 40 turns of concat, mid, replace, insert, delete, find, left, right, comparisons and numbers as text. */
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

#define CAPACITY 80

typedef struct {
    unsigned char len;
    char s[CAPACITY];
} str;

#define STR(text) { sizeof(text) - 1, text }

static const str names[8] = {
    STR("Mixer"), STR("Conveyor"), STR("Boiler"), STR("Press"),
    STR("Pump station"), STR("Oven"), STR("Drill"), STR("Packer"),
};
static const str of_line = STR(" of line ");
static const str ready = STR(" ready");
static const str angles = STR("<>");
static const str of = STR("of");
static const str digits = STR("-123456789");

static str lines[40];
static int32_t seed = 99;

static void assign(str *to, const str *from)
{
    to->len = from->len;
    memcpy(to->s, from->s, from->len);
}

static void append(str *to, const str *tail)
{
    int n = tail->len;
    if (n > CAPACITY - to->len)
        n = CAPACITY - to->len;
    memcpy(to->s + to->len, tail->s, n);
    to->len += n;
}

static void mid(str *to, const str *from, int l, int p)
{
    if (l > from->len - (p - 1))
        l = from->len - (p - 1);
    if (l < 0)
        l = 0;
    memcpy(to->s, from->s + p - 1, l);
    to->len = l;
}

static void left(str *to, const str *from, int l)
{
    mid(to, from, l, 1);
}

static void right(str *to, const str *from, int l)
{
    if (l > from->len)
        l = from->len;
    mid(to, from, l, from->len - l + 1);
}

/* Puts `what` in place of the l characters from p on. */
static void replace(str *t, const str *what, int l, int p)
{
    int rest = t->len - (p - 1 + l);
    int to = p - 1 + what->len;
    if (to + rest > CAPACITY)
        rest = CAPACITY - to;
    memmove(t->s + to, t->s + p - 1 + l, rest);
    memcpy(t->s + p - 1, what->s, what->len);
    t->len = to + rest;
}

static void insert(str *t, const str *what, int p)
{
    replace(t, what, 0, p + 1);
}

static void delete(str *t, int l, int p)
{
    int rest = t->len - (p - 1 + l);
    memmove(t->s + p - 1, t->s + p - 1 + l, rest);
    t->len -= l;
}

static int find(const str *in, const str *what)
{
    for (int i = 0; i + what->len <= in->len; i++)
        if (memcmp(in->s + i, what->s, what->len) == 0)
            return i + 1;
    return 0;
}

static int compare(const str *a, const str *b)
{
    int n = a->len < b->len ? a->len : b->len;
    int order = memcmp(a->s, b->s, n);
    return order ? order : a->len - b->len;
}

static bool equal(const str *a, const str *b)
{
    return a->len == b->len && memcmp(a->s, b->s, a->len) == 0;
}

static void from_int(str *to, int16_t value)
{
    char text[8];
    int n = 0, left = value < 0 ? -value : value;
    do {
        text[n++] = '0' + left % 10;
        left /= 10;
    } while (left);
    if (value < 0)
        text[n++] = '-';
    to->len = n;
    for (int i = 0; i < n; i++)
        to->s[i] = text[n - 1 - i];
}

void scan(void)
{
    str msg, number, number2, head, tail, part, one;

    for (int i = 0; i < 40; i++) {
        seed = (seed * 75 + 74) % 65537;
        int16_t value = seed % 20001 - 10000;
        from_int(&number, value);
        from_int(&number2, i);

        assign(&msg, &names[abs(value) % 8]);
        append(&msg, &number);
        append(&msg, &of_line);
        append(&msg, &number2);
        insert(&msg, &ready, 3);
        replace(&msg, &angles, 1, 5);
        delete(&msg, 2, 2);
        int pos = find(&msg, &of);
        left(&one, &number, 1);
        int mark = find(&digits, &one);
        left(&head, &msg, 6);
        right(&tail, &msg, 4);
        mid(&part, &msg, 5, pos - 4);

        int32_t n = msg.len + 3 * pos + 7 * mark + part.len;
        if (compare(&head, &tail) < 0)
            n += 100;
        if (compare(&part, &number) >= 0)
            n += 200;
        if (!equal(&msg, &lines[i])) {
            n += 400;
            assign(&lines[i], &msg);
        }
        if (i > 0 && compare(&lines[i], &lines[i - 1]) > 0)
            n += 800;
        mid(&one, &number, 1, number.len);
        n += find(&lines[39 - i], &one);
        check = (check * 31 + n) % 1000003;
    }
}
