#include <string.h>
#include "st.h"

static int16_t n;
static char lot[41], line[81], field[41], msg[81], code[21], lastLot[41];
static const char prod[8][21] = { "MILK 1L", "YOGHURT", "CREAM 200", "BUTTER",
    "CHEESE A", "CHEESE B", "WHEY", "QUARK 500" };

static void int_to_str(char *dst, int16_t v)
{
    char tmp[8];
    int k = 0, x = v;
    if (x < 0) {
        *dst++ = '-';
        x = -x;
    }
    do {
        tmp[k++] = (char)('0' + x % 10);
        x /= 10;
    } while (x > 0);
    while (k > 0)
        *dst++ = tmp[--k];
    *dst = 0;
}

static int16_t str_to_int(const char *s)
{
    int neg = 0, v = 0;
    if (*s == '-') {
        neg = 1;
        s++;
    }
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return (int16_t)(neg ? -v : v);
}

static int find(const char *s, const char *t)
{
    const char *p = strstr(s, t);
    return p ? (int)(p - s) + 1 : 0;
}

static void append(char *dst, int max, const char *s)
{
    int l = (int)strlen(dst), m = (int)strlen(s);
    if (l + m > max)
        m = max - l;
    memcpy(dst + l, s, m);
    dst[l + m] = 0;
}

static void left(char *dst, const char *s, int l)
{
    int m = (int)strlen(s);
    if (l < 0)
        l = 0;
    if (l > m)
        l = m;
    memmove(dst, s, l);
    dst[l] = 0;
}

static void mid(char *dst, const char *s, int l, int p)
{
    int m = (int)strlen(s);
    if (l < 0 || p < 1 || p > m) {
        dst[0] = 0;
        return;
    }
    if (l > m - p + 1)
        l = m - p + 1;
    memmove(dst, s + p - 1, l);
    dst[l] = 0;
}

static void insert(char *s, int max, const char *t, int p)
{
    int m = (int)strlen(s), k = (int)strlen(t);
    if (p > m)
        p = m;
    if (m + k > max)
        return;
    memmove(s + p + k, s + p, m - p + 1);
    memcpy(s + p, t, k);
}

static void delete(char *dst, const char *s, int l, int p)
{
    int m = (int)strlen(s);
    if (p > m) {
        strcpy(dst, s);
        return;
    }
    if (l > m - p + 1)
        l = m - p + 1;
    memcpy(dst, s, p - 1);
    memcpy(dst + p - 1, s + p - 1 + l, m - (p - 1 + l) + 1);
}

static void replace(char *s, int max, const char *t, int l, int p)
{
    int m = (int)strlen(s), k = (int)strlen(t);
    if (l > m - p + 1)
        l = m - p + 1;
    if (m - l + k > max)
        return;
    memmove(s + p - 1 + k, s + p - 1 + l, m - (p - 1 + l) + 1);
    memcpy(s + p - 1, t, k);
}

void scan(void)
{
    int16_t i;
    int p, q, l;
    int32_t sum = 0;
    char tmp[81];

    n++;
    if (n >= 10000)
        n = 0;

    for (i = 0; i < 16; i++) {
        int_to_str(code, n + i * 37);
        while (strlen(code) < 6)
            insert(code, 20, "0", 0);
        strcpy(lot, "L");
        append(lot, 40, code);
        insert(lot, 40, "-", 4);
        append(lot, 40, "/");
        int_to_str(tmp, i + 1);
        append(lot, 40, tmp);

        strcpy(line, "PRT;");
        append(line, 80, lot);
        append(line, 80, ";");
        append(line, 80, prod[(n + i) % 8]);
        append(line, 80, ";QTY=");
        int_to_str(tmp, (n % 1000 * 3 + i) % 500);
        append(line, 80, tmp);
        append(line, 80, ";END");

        p = find(line, "QTY=");
        mid(field, line, (int)strlen(line) - p - 3, p + 4);
        q = find(field, ";");
        left(field, field, q - 1);
        sum += str_to_int(field);

        delete(msg, line, 4, 1);
        p = find(msg, ";");
        left(tmp, msg, p - 1);
        if (strcmp(tmp, lot) == 0)
            sum += 1;
        p = find(msg, "CHEESE");
        if (p > 0)
            replace(msg, 80, "KAESE", 6, p);
        l = (int)strlen(msg);
        if (l >= 3 && strcmp(msg + l - 3, "END") == 0)
            sum += l;
        if (strcmp(lot, lastLot) > 0)
            sum += 5;
        strcpy(lastLot, lot);
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
