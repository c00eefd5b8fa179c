/* Telegrams: build "T03=-125;S=RUN", take it apart again, change parts, compare. */
#include "st.h"
#include <string.h>

static int32_t tick;

static void int_to_string(char *out, int16_t v)
{
    char digits[8];
    int n = 0;
    int x = v;

    if (x < 0) {
        *out++ = '-';
        x = -x;
    }
    do {
        digits[n++] = (char)('0' + x % 10);
        x /= 10;
    } while (x > 0);
    while (n > 0)
        *out++ = digits[--n];
    *out = '\0';
}

static int16_t string_to_int(const char *s)
{
    int neg = 0, x = 0;

    if (*s == '-') {
        neg = 1;
        s++;
    }
    while (*s >= '0' && *s <= '9')
        x = x * 10 + (*s++ - '0');
    return (int16_t)(neg ? -x : x);
}

/* position from 1, 0 when not found */
static int16_t find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int16_t)(p - s + 1) : 0;
}

/* len characters from pos (from 1) */
static void mid(char *out, const char *s, int len, int pos)
{
    memcpy(out, s + pos - 1, (size_t)len);
    out[len] = '\0';
}

static void replace(char *s, const char *with, int len, int pos)
{
    size_t n = strlen(s), m = strlen(with);
    memmove(s + pos - 1 + m, s + pos - 1 + len, n - (size_t)(pos - 1 + len) + 1);
    memcpy(s + pos - 1, with, m);
}

static void insert(char *s, const char *what, int pos)
{
    size_t n = strlen(s), m = strlen(what);
    memmove(s + pos + m, s + pos, n - (size_t)pos + 1);
    memcpy(s + pos, what, m);
}

static void delete(char *s, int len, int pos)
{
    size_t n = strlen(s);
    memmove(s + pos - 1, s + pos - 1 + len, n - (size_t)(pos - 1 + len) + 1);
}

void scan(void)
{
    int16_t i, p, q, value, back, n;
    int32_t sum;
    char state[11], num[11], num2[11], msg[81], key[21], last_key[21], text[21], line[81];

    tick = (tick + 1) % 5000;
    sum = 0;
    line[0] = '\0';
    last_key[0] = '\0';
    for (i = 0; i <= 15; i++) {
        value = (int16_t)((tick * 37 + i * 211) % 2000 - 1000);
        if (value < -500)
            strcpy(state, "FAULT");
        else if (value < 500)
            strcpy(state, "RUN");
        else
            strcpy(state, "STOP");

        /* build */
        int_to_string(num, i);
        if (strlen(num) < 2) {
            strcpy(num2, "0");
            strcat(num2, num);
            strcpy(num, num2);
        }
        strcpy(msg, "T");
        strcat(msg, num);
        strcat(msg, "=");
        int_to_string(num, value);
        strcat(msg, num);
        strcat(msg, ";S=");
        strcat(msg, state);

        /* take apart */
        p = find(msg, "=");
        q = find(msg, ";");
        mid(key, msg, p - 1, 1);
        mid(text, msg, q - p - 1, p + 1);
        back = string_to_int(text);
        sum += back;
        strcpy(text, msg + q + 2);

        /* compare */
        if (strcmp(text, "FAULT") == 0)
            sum += 100;
        else if (strcmp(text, "STOP") == 0)
            sum += 10;
        if (strcmp(key, last_key) > 0)
            sum += 1;
        strcpy(last_key, key);

        /* change */
        if (find(msg, "RUN") > 0)
            replace(msg, "RUNNING", 3, find(msg, "RUN"));
        insert(msg, "ID:", 0);
        delete(msg, 2, q + 4);
        sum += (int32_t)strlen(msg);
        if (strlen(line) + strlen(msg) < 70)
            strcat(line, msg);
    }
    n = find(line, "STOP");
    sum += (int32_t)strlen(line) * 3 + n;
    check = (check % 1000003) * 31 + sum;
}
