/* Chapter 10: texts. Labels of 24 packages are built, checked, edited and read back. */
#include <string.h>
#include "st.h"

/* all positions count from 1, as in the chapter */

static int16_t str_find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int16_t)(p - s + 1) : 0;
}

static void str_left(char *dst, const char *src, int n)
{
    memcpy(dst, src, n);
    dst[n] = '\0';
}

static void str_right(char *dst, const char *src, int n)
{
    strcpy(dst, src + strlen(src) - n);
}

static void str_mid(char *dst, const char *src, int n, int pos)
{
    memcpy(dst, src + pos - 1, n);
    dst[n] = '\0';
}

static void str_insert(char *s, const char *what, int pos)
{
    size_t n = strlen(what);
    memmove(s + pos + n, s + pos, strlen(s + pos) + 1);
    memcpy(s + pos, what, n);
}

static void str_delete(char *s, int n, int pos)
{
    char *p = s + pos - 1;
    memmove(p, p + n, strlen(p + n) + 1);
}

static void str_replace(char *s, const char *what, int n, int pos)
{
    char *p = s + pos - 1;
    size_t m = strlen(what);
    memmove(p + m, p + n, strlen(p + n) + 1);
    memcpy(p, what, m);
}

static void int_to_str(char *dst, int32_t v)
{
    char tmp[12];
    int n = 0;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;

    do {
        tmp[n++] = '0' + u % 10;
        u /= 10;
    } while (u);
    if (v < 0)
        *dst++ = '-';
    while (n > 0)
        *dst++ = tmp[--n];
    *dst = '\0';
}

static int16_t str_to_int(const char *s)
{
    int v = 0;
    int neg = *s == '-';

    if (neg)
        s++;
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return neg ? -v : v;
}

static void pad_left(char *dst, const char *src, int width)
{
    int n = strlen(src);
    int pad = width > n ? width - n : 0;

    memset(dst, '0', pad);
    strcpy(dst + pad, src);
}

/* Code 39: check character modulo 43 */
static int16_t code39_sum(const char *text)
{
    static const char alphabet[] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ-. *=;:";
    int16_t sum = 0;

    for (; *text; text++) {
        const char *p = strchr(alphabet, *text);
        if (p)
            sum += p - alphabet;
    }
    return sum % 43;
}

static const char products[4][21] = { "COCOA BAR", "OAT BISCUIT", "MUESLI 500", "RICE CAKE MINI" };
static int32_t serial = 41900;
static char last_label[81];

void scan(void)
{
    char number[21], serial_text[21], label[81], rest[81], name[41], tmp[81];
    int16_t i, n, weight, back, p, q;
    int32_t sum = 0;

    for (i = 1; i <= 24; i++) {
        serial += 7;
        if (serial > 99999)
            serial = 1;
        n = serial % 4;
        weight = 480 + serial % 41;

        /* build */
        int_to_str(number, serial);
        pad_left(serial_text, number, 6);
        strcpy(label, products[n]);
        strcat(label, ";W=");
        int_to_str(number, weight);
        strcat(label, number);
        strcat(label, ";S=");
        strcat(label, serial_text);

        /* edit: hyphenate the serial number, shorten one product name */
        p = str_find(label, ";S=");
        str_insert(label, "-", p + 5);
        p = str_find(label, "BISCUIT");
        if (p > 0)
            str_replace(label, "BISC.", 7, p);
        p = str_find(label, " MINI");
        if (p > 0)
            str_delete(label, 5, p);

        /* read back */
        p = str_find(label, ";W=");
        str_left(name, label, p - 1);
        str_right(rest, label, (int)strlen(label) - p - 2);
        q = str_find(rest, ";");
        str_left(tmp, rest, q - 1);
        back = str_to_int(tmp);
        if (back != weight)
            sum += 1000;
        str_mid(tmp, rest, 3, q);
        if (strcmp(tmp, ";S=") == 0)
            sum += 1;

        /* compare */
        if (strcmp(label, last_label) > 0)
            sum += 2;
        if (strcmp(name, "MUESLI 500") == 0)
            sum += 4;
        else if (strcmp(name, "RICE CAKE") == 0)
            sum += 8;
        strcpy(last_label, label);

        sum += (int32_t)strlen(label) + (int32_t)strlen(name) + back + code39_sum(label) * 5;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
