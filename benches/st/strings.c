/* The same work as strings.st: texts with their lengths, no allocation. */
#include "st.h"
#include <string.h>

struct text {
    uint8_t length;
    char chars[80];
};

static struct text text, part, other;
static int32_t scans;

static struct text literal(const char *from)
{
    struct text out;
    out.length = (uint8_t)strlen(from);
    memcpy(out.chars, from, out.length);
    return out;
}

static void append(struct text *to, const char *from, int count)
{
    if (count > 80 - to->length)
        count = 80 - to->length;
    memcpy(to->chars + to->length, from, (size_t)count);
    to->length = (uint8_t)(to->length + count);
}

static struct text mid(const struct text *from, int count, int position)
{
    struct text out = { 0 };
    if (position >= 1 && position <= from->length) {
        int rest = from->length - position + 1;
        append(&out, from->chars + position - 1, count < rest ? count : rest);
    }
    return out;
}

static struct text concat(const struct text *a, const struct text *b)
{
    struct text out = *a;
    append(&out, b->chars, b->length);
    return out;
}

static struct text replace(const struct text *in, const struct text *with, int count, int position)
{
    struct text out = mid(in, position - 1, 1);
    append(&out, with->chars, with->length);
    int behind = position - 1 + count;
    if (behind < in->length)
        append(&out, in->chars + behind, in->length - behind);
    return out;
}

static int find(const struct text *in, const struct text *what)
{
    for (int at = 0; at + what->length <= in->length; at++)
        if (memcmp(in->chars + at, what->chars, what->length) == 0)
            return at + 1;
    return 0;
}

static int compare(const struct text *a, const struct text *b)
{
    int shorter = a->length < b->length ? a->length : b->length;
    int order = memcmp(a->chars, b->chars, (size_t)shorter);
    return order ? order : a->length - b->length;
}

void scan(void)
{
    const struct text ready = literal("_07_READY"), station = literal("STATION"), on = literal("ON"), stat = literal("STAT"), none = literal("");
    text = literal("PUMP_STATION");
    for (int32_t i = 0; i < 40; i++) {
        part = mid(&text, 4, 1);
        other = concat(&part, &ready);
        other = replace(&other, &station, 5, 6);
        other = replace(&other, &on, 0, 5);
        other = replace(&other, &none, 2, 1);
        part = mid(&other, 6, 3);
        int found = find(&other, &stat);
        if (compare(&part, &text) > 0)
            check += 1;
        check += found + other.length;
        if (i % 8 == 7)
            text = literal("PUMP_STATION");
        else
            text = concat(&part, &text);
    }
    scans++;
}
