/* message texts: build a telegram, take it apart again, fill in templates, edit, sort names */
#include "st.h"
#include <stdbool.h>
#include <string.h>

static char names[8][13] = {
    "Pump1", "Pump2", "Mixer", "ValveA", "ValveB", "Heater", "Fan", "Conveyor"
};
static int32_t cyc;

/* cap: the longest text the buffer takes, without the final 0 */
static void s_set(char *d, size_t cap, const char *s)
{
    size_t n = strlen(s);
    if (n > cap)
        n = cap;
    memcpy(d, s, n);
    d[n] = 0;
}

static void s_add(char *d, size_t cap, const char *s)
{
    size_t l = strlen(d), n = strlen(s);
    if (n > cap - l)
        n = cap - l;
    memcpy(d + l, s, n);
    d[l + n] = 0;
}

static void s_mid(char *d, size_t cap, const char *s, size_t len, size_t pos)
{
    size_t l = strlen(s);
    if (pos < 1 || pos > l) {
        d[0] = 0;
        return;
    }
    if (len > l - pos + 1)
        len = l - pos + 1;
    if (len > cap)
        len = cap;
    memmove(d, s + pos - 1, len);
    d[len] = 0;
}

static void s_left(char *d, size_t cap, const char *s, size_t len)
{
    s_mid(d, cap, s, len, 1);
}

static void s_right(char *d, size_t cap, const char *s, size_t len)
{
    size_t l = strlen(s);
    if (len > l)
        len = l;
    s_mid(d, cap, s, len, l - len + 1);
}

static void s_delete(char *d, size_t len, size_t pos)
{
    size_t l = strlen(d);
    if (pos < 1 || pos > l)
        return;
    if (len > l - pos + 1)
        len = l - pos + 1;
    memmove(d + pos - 1, d + pos - 1 + len, l - (pos - 1) - len + 1);
}

/* puts s behind the character pos */
static void s_insert(char *d, size_t cap, const char *s, size_t pos)
{
    size_t l = strlen(d), n = strlen(s);
    if (pos > l)
        pos = l;
    if (n > cap - l)
        n = cap - l;
    memmove(d + pos + n, d + pos, l - pos + 1);
    memcpy(d + pos, s, n);
}

static void s_replace(char *d, size_t cap, const char *s, size_t len, size_t pos)
{
    s_delete(d, len, pos);
    s_insert(d, cap, s, pos - 1);
}

static int16_t s_find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int16_t)(p - s + 1) : 0;
}

static const char *s_int(char buf[12], int32_t v)
{
    char *p = buf + 11;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
    *p = 0;
    do {
        *--p = '0' + u % 10;
        u /= 10;
    } while (u);
    if (v < 0)
        *--p = '-';
    return p;
}

static int32_t s_num(const char *s)
{
    int32_t v = 0;
    bool neg = false;
    if (*s == '-' || *s == '+')
        neg = *s++ == '-';
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return neg ? -v : v;
}

void scan(void)
{
    char order[8][13], swap[13];
    char telegram[161], item[41], key[13], part[41], line[81], num[13], buf[12];
    int16_t i, j, p, q, val;
    int32_t sum = 0;

    cyc = (cyc + 1) % 5000;

    /* build "Pump1=-123;Pump2=...;" */
    telegram[0] = 0;
    for (i = 0; i < 8; i++) {
        val = (int16_t)((cyc * 37 + i * 1117) % 20000 - 10000);
        s_add(telegram, 160, names[i]);
        s_add(telegram, 160, "=");
        s_add(telegram, 160, s_int(buf, val));
        s_add(telegram, 160, ";");
    }
    sum += (int32_t)strlen(telegram);

    /* take it apart */
    p = s_find(telegram, ";");
    while (p > 0) {
        s_left(item, 40, telegram, p - 1);
        s_delete(telegram, p, 1);
        q = s_find(item, "=");
        s_left(key, 12, item, q - 1);
        s_mid(part, 40, item, strlen(item) - q, q + 1);
        val = (int16_t)s_num(part);
        if (strcmp(key, "Pump2") == 0 || strcmp(key, "Fan") == 0)
            sum += val;
        else if (strncmp(key, "Valve", 5) == 0)
            sum -= val;
        else
            sum += val / 2;
        p = s_find(telegram, ";");
    }

    /* fill in a template */
    for (i = 0; i < 4; i++) {
        s_set(line, 80, "Alarm # in unit @: value too high, check sensor");
        p = s_find(line, "#");
        s_replace(line, 80, s_int(buf, cyc + i), 1, p);
        p = s_find(line, "@");
        s_replace(line, 80, names[(i * 3) % 8], 1, p);
        if (i == 2) {
            p = s_find(line, "high");
            s_replace(line, 80, "low", 4, p);
        }
        sum += (int32_t)strlen(line) + s_find(line, "check");
        s_right(part, 40, line, 6);
        if (strcmp(part, "sensor") == 0)
            sum += 1;
    }

    /* thousands separators */
    s_set(num, 12, s_int(buf, cyc * 12345 + 1000000));
    p = (int16_t)strlen(num) - 3;
    while (p > 0) {
        s_insert(num, 12, ".", p);
        p -= 3;
    }
    sum += s_find(num, ".") + (int32_t)strlen(num);
    s_right(num, 12, num, 3);
    sum += s_num(num);

    /* sort the names, the start order turns from scan to scan */
    for (i = 0; i < 8; i++)
        s_set(order[i], 12, names[(i * 3 + cyc) % 8]);
    for (i = 0; i < 7; i++) {
        for (j = 0; j < 7 - i; j++) {
            if (strcmp(order[j], order[j + 1]) > 0) {
                s_set(swap, 12, order[j]);
                s_set(order[j], 12, order[j + 1]);
                s_set(order[j + 1], 12, swap);
                sum += 1;
            }
        }
    }
    if (strcmp(order[0], "Conveyor") == 0)
        sum += (int32_t)strlen(order[7]);

    check = (check + sum) % 10000019;
}
