#include <string.h>
#include "st.h"

typedef struct { uint8_t len; char s[80]; } Str;

static void set(Str *r, const char *s, int n)
{
    r->len = n;
    memcpy(r->s, s, n);
}

static void left(Str *r, const Str *a, int n)
{
    set(r, a->s, n < a->len ? n : a->len);
}

static void right(Str *r, const Str *a, int n)
{
    if (n > a->len) n = a->len;
    set(r, a->s + a->len - n, n);
}

static void mid(Str *r, const Str *a, int n, int p)
{
    if (p > a->len) n = 0;
    else if (n > a->len - p + 1) n = a->len - p + 1;
    set(r, a->s + p - 1, n);
}

static void append(Str *r, const char *s, int n)
{
    if (n > (int)sizeof r->s - r->len) n = sizeof r->s - r->len;
    memcpy(r->s + r->len, s, n);
    r->len += n;
}

static void concat(Str *r, const Str *a, const Str *b)
{
    set(r, a->s, a->len);
    append(r, b->s, b->len);
}

/* n characters of a from place p on give way to b */
static void replace(Str *r, const Str *a, const Str *b, int n, int p)
{
    int rest = p - 1 + n;
    set(r, a->s, p - 1);
    append(r, b->s, b->len);
    if (rest < a->len) append(r, a->s + rest, a->len - rest);
}

static void insert(Str *r, const Str *a, const Str *b, int p)
{
    replace(r, a, b, 0, p + 1);
}

static void delete(Str *r, const Str *a, int n, int p)
{
    int rest = p - 1 + n;
    set(r, a->s, p - 1);
    if (rest < a->len) append(r, a->s + rest, a->len - rest);
}

static int find(const Str *a, const Str *b)
{
    for (int i = 0; i + b->len <= a->len; i++)
        if (memcmp(a->s + i, b->s, b->len) == 0) return i + 1;
    return 0;
}

static int compare(const Str *a, const Str *b)
{
    int c = memcmp(a->s, b->s, a->len < b->len ? a->len : b->len);
    return c ? c : a->len - b->len;
}

static int32_t n;
static const Str alpha = { 36, "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789" };
static const Str tag = { 4, "TAG_" };
static Str texts[40];

void scan(void)
{
    Str body, head, tail, work, other, part;

    if (n == 0)
        for (int i = 0; i < 40; i++) {
            mid(&part, &alpha, 8, 1 + i % 28);
            concat(&texts[i], &tag, &part);
        }

    int32_t acc = 0;
    for (int i = 0; i < 40; i++) {
        int k = (n * 5 + i * 3) % 31;
        mid(&part, &alpha, 4, 1 + k);
        concat(&body, &texts[i], &part);
        left(&head, &body, 6);
        right(&tail, &body, 7);
        insert(&work, &body, &head, 3);
        delete(&other, &work, 5, 2 + k % 7);
        replace(&work, &other, &tail, 4, 1 + k % 9);
        mid(&part, &alpha, 2, 1 + (k * 3) % 35);
        acc += find(&work, &part) * 3 + work.len;
        mid(&part, &work, 1, 1 + k % 15);
        acc += find(&alpha, &part) * (i + 1);
        if (compare(&head, &tail) < 0) {
            left(&texts[i], &work, 12);
        } else {
            right(&texts[i], &work, 13);
            acc += 100;
        }
        left(&head, &texts[i], 2);
        right(&tail, &texts[(i + 7) % 40], 2);
        if (compare(&head, &tail) == 0 || compare(&texts[i], &body) > 0) acc += i;
    }

    n++;
    check = (check * 31 + acc) % 1000003;
}
