#define _GNU_SOURCE
#include "st.h"
#include <stdlib.h>
#include <string.h>

static int32_t number;
static char previous[11] = "IDLE";
static char telegram[81], edited[81], value[21], amount[21];
static int16_t orders;

/* Appends n in decimal, padded with zeros, and returns the new end. */
static char *put_int(char *to, int n, int width)
{
    char digits[12];
    int count = 0;
    unsigned u = n < 0 ? 0u - (unsigned)n : (unsigned)n;
    do {
        digits[count++] = (char)('0' + u % 10);
        u /= 10;
    } while (u);
    if (n < 0)
        digits[count++] = '-';
    while (count < width)
        digits[count++] = '0';
    while (count)
        *to++ = digits[--count];
    *to = 0;
    return to;
}

/* Replaces count characters at pos by text. */
static void splice(char *s, size_t pos, size_t count, const char *text)
{
    size_t len = strlen(s), n = strlen(text);
    memmove(s + pos + n, s + pos + count, len - pos - count + 1);
    memcpy(s + pos, text, n);
}

/* key includes the equals sign */
static void field_of(const char *tele, const char *key, char *out)
{
    *out = 0;
    const char *p = strstr(tele, key);
    if (!p)
        return;
    p += strlen(key);
    const char *end = strchr(p, ';');
    if (!end)
        return;
    memcpy(out, p, (size_t)(end - p));
    out[end - p] = 0;
}

static const char *state_name(int state)
{
    switch (state) {
    case 0: return "IDLE";
    case 1: return "RUN";
    case 2: return "HOLD";
    default: return "FAULT";
    }
}

/* position of text in s counted from 1, or 0 */
static int find(const char *s, const char *text)
{
    const char *p = strstr(s, text);
    return p ? (int)(p - s) + 1 : 0;
}

static void add_check(int32_t v) { check = (int32_t)((uint32_t)check * 31u + (uint32_t)v); }
static void bump(uint32_t v) { check = (int32_t)((uint32_t)check + v); }

void scan(void)
{
    number = (number + 37) % 10000;
    const char *name = state_name(number % 5);

    char *e = stpcpy(telegram, "ID=");
    e = put_int(e, number, 4);
    e = stpcpy(e, ";TEMP=");
    e = put_int(e, number / 20 - 150, 0);
    e = stpcpy(e, ";STATE=");
    e = stpcpy(e, name);
    e = stpcpy(e, ";");
    add_check((int32_t)(e - telegram));

    field_of(telegram, "ID=", value);
    add_check((int32_t)strtol(value, NULL, 10));
    field_of(telegram, "TEMP=", value);
    add_check((int32_t)strtol(value, NULL, 10));
    field_of(telegram, "STATE=", value);
    if (strcmp(value, name) == 0)
        bump(1);
    int order = strcmp(value, previous);
    if (order < 0)
        orders = (int16_t)(orders - 1);
    else if (order > 0)
        orders = (int16_t)(orders + 1);
    strcpy(previous, name);
    add_check(orders);
    field_of(telegram, "SPEED=", value);
    add_check((int32_t)strlen(value));

    strcpy(edited, telegram);
    char *p = strstr(edited, "FAULT");
    if (p)
        splice(edited, (size_t)(p - edited), 5, "ALARM!");
    splice(edited, (size_t)(strstr(edited, "TEMP") - edited), 4, "T");
    splice(edited, (size_t)(strchr(edited, ';') - edited) + 1, 0, "UNIT=7;");
    splice(edited, (size_t)(strstr(edited, "STATE=") - edited), 6, "");
    add_check((int32_t)strlen(edited));
    add_check(find(edited, ";T="));
    memcpy(value, edited + 3, 4);
    value[4] = 0;
    add_check((int32_t)strtol(value, NULL, 10));
    if (strcmp(edited, telegram) > 0)
        bump(3);

    size_t len = (size_t)(put_int(amount, number, 3) - amount);
    splice(amount, len - 2, 0, ".");
    len++;
    add_check(find(amount, "."));
    if (strcmp(amount + len - 3, ".00") == 0)
        bump(7);
    add_check((int32_t)len);
}
