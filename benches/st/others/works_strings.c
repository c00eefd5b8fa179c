/* Label texts, barcode telegrams and an alarm line of a packaging machine */
#include <string.h>
#include "st.h"

#define T40 41
#define T80 81

/* ---- small helpers on NUL-terminated fixed buffers; size = sizeof the target ---- */

static void str_copy(char *d, int size, const char *s)
{
    int l = (int)strlen(s);
    if (l > size - 1)
        l = size - 1;
    memmove(d, s, l);
    d[l] = 0;
}

static void str_append(char *d, int size, const char *s)
{
    int l = (int)strlen(d);
    str_copy(d + l, size - l, s);
}

/* position 1..., 0 = not found */
static int str_find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int)(p - s) + 1 : 0;
}

static void str_mid(char *d, int size, const char *s, int l, int p)
{
    int n = (int)strlen(s);
    if (p < 1 || l < 0 || p > n)
        l = 0;
    else if (l > n - p + 1)
        l = n - p + 1;
    if (l > size - 1)
        l = size - 1;
    memcpy(d, s + (l ? p - 1 : 0), l);
    d[l] = 0;
}

static void str_left(char *d, int size, const char *s, int l)
{
    str_mid(d, size, s, l, 1);
}

static void str_right(char *d, int size, const char *s, int l)
{
    int n = (int)strlen(s);
    if (l > n)
        l = n;
    str_copy(d, size, s + n - l);
}

static void str_delete(char *s, int l, int p)
{
    int n = (int)strlen(s);
    if (p < 1 || p > n || l < 0)
        return;
    if (l > n - p + 1)
        l = n - p + 1;
    memmove(s + p - 1, s + p - 1 + l, n - (p - 1 + l) + 1);
}

static void str_insert(char *s, int size, const char *what, int p)
{
    int n = (int)strlen(s), w = (int)strlen(what);
    if (p > n)
        p = n;
    if (n + w > size - 1)
        return;                      /* does not happen with these texts */
    memmove(s + p + w, s + p, n - p + 1);
    memcpy(s + p, what, w);
}

static void str_replace(char *s, int size, const char *with, int l, int p)
{
    str_delete(s, l, p);
    str_insert(s, size, with, p - 1);
}

static void int_to_str(char *d, int16_t v)
{
    char tmp[8];
    int i = 0;
    uint32_t u = v < 0 ? (uint32_t)-(int32_t)v : (uint32_t)v;
    do {
        tmp[i++] = '0' + u % 10;
        u /= 10;
    } while (u);
    if (v < 0)
        *d++ = '-';
    while (i > 0)
        *d++ = tmp[--i];
    *d = 0;
}

static int16_t str_to_int(const char *s)
{
    int32_t v = 0;
    int neg = 0;
    while (*s == ' ')
        s++;
    if (*s == '-' || *s == '+')
        neg = *s++ == '-';
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return (int16_t)(neg ? -v : v);
}

/* number with leading zeros */
static void pad(char *d, int size, int16_t n, int width)
{
    int_to_str(d, n);
    while ((int)strlen(d) < width)
        str_insert(d, size, "0", 0);
}

/* ---- program ---- */

static int16_t n;
static int16_t qty;
static char lot[T40], field[T40];
static char label[T80], telegram[T80], rest[T80], alarm_text[T80];
static char recipe[6][T40] = {"Coffee 250g", "Coffee 500g", "Espresso 1kg",
                              "Decaf 250g", "Tea green", "Tea black"};

void scan(void)
{
    int16_t i, p, same;
    int32_t sum = 0;
    char num[T40];

    n = (n + 7) % 10000;

    /* lot number and label */
    str_copy(lot, T40, "LOT-");
    pad(num, T40, n, 6);
    str_append(lot, T40, num);
    str_insert(lot, T40, "/", 7);
    str_copy(label, T80, recipe[n % 6]);
    str_append(label, T80, " | ");
    str_append(label, T80, lot);
    str_append(label, T80, " | L#");
    p = str_find(label, "#");
    if (p > 0) {
        int_to_str(num, n % 9 + 1);
        str_replace(label, T80, num, 1, p);
    }
    sum += (int32_t)strlen(label);

    /* telegram: fields separated by ';', taken apart again */
    str_copy(telegram, T80, "OK;");
    int_to_str(num, n % 500);
    str_append(telegram, T80, num);
    str_append(telegram, T80, ";");
    str_append(telegram, T80, lot);
    str_append(telegram, T80, ";-12;END");
    str_copy(rest, T80, telegram);
    i = 0;
    p = str_find(rest, ";");
    while (p > 0) {
        str_left(field, T40, rest, p - 1);
        str_delete(rest, p, 1);
        if (i == 1 || i == 3) {
            qty = str_to_int(field);
            sum += qty;
        } else if (i == 2) {
            str_mid(num, T40, field, 3, 8);
            sum += str_to_int(num);
            if (strcmp(field, lot) == 0)
                sum += 11;
        }
        i++;
        p = str_find(rest, ";");
    }
    if (strcmp(rest, "END") == 0)
        sum += 5;

    /* recipe search */
    same = 0;
    for (i = 0; i < 6; i++) {
        if (str_find(recipe[i], "250g") > 0)
            same++;
        str_left(num, T40, label, (int)strlen(recipe[i]));
        if (strcmp(recipe[i], num) == 0)
            same += 10 * i;
        if (strcmp(recipe[i], "Decaf") < 0)
            same += 100;
    }

    /* alarm line */
    str_copy(alarm_text, T80, "Station % : fault @ on drive, quantity ");
    p = str_find(alarm_text, "%");
    pad(num, T40, n % 32, 2);
    str_replace(alarm_text, T80, num, 1, p);
    p = str_find(alarm_text, "@");
    int_to_str(num, n);
    str_replace(alarm_text, T80, num, 1, p);
    int_to_str(num, qty);
    str_append(alarm_text, T80, num);
    if (n % 3 == 0) {
        p = str_find(alarm_text, " on drive");
        str_delete(alarm_text, 9, p);
    }
    str_right(field, T40, alarm_text, 12);

    sum += (int32_t)strlen(alarm_text) * 3 + str_find(field, "tity") + same;
    check = (check * 3 + sum) % 10000019;
}
