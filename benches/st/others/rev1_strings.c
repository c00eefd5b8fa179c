/* Telegrams: build, take apart again, compare, and edit a log line. */
#include <string.h>
#include <stdbool.h>
#include "st.h"

static int find(const char *s, const char *what)    /* from 1, 0 if not there */
{
    const char *p = strstr(s, what);
    return p ? (int)(p - s) + 1 : 0;
}

static void mid(char *to, const char *s, int n, int p)    /* n characters from position p */
{
    int len = (int)strlen(s);
    if (p > len) n = 0;
    else if (n > len - p + 1) n = len - p + 1;
    memcpy(to, s + p - 1, (size_t)n);
    to[n] = 0;
}

static void int_to_string(char *to, int16_t value)
{
    char digits[8];
    int n = 0, v = value < 0 ? -value : value;
    do { digits[n++] = (char)('0' + v % 10); v /= 10; } while (v > 0);
    if (value < 0) *to++ = '-';
    while (n > 0) *to++ = digits[--n];
    *to = 0;
}

static int16_t string_to_int(const char *s)
{
    bool negative = *s == '-';
    int v = 0;
    if (negative) s++;
    while (*s >= '0' && *s <= '9') v = v * 10 + (*s++ - '0');
    return (int16_t)(negative ? -v : v);
}

static void field(char *to, const char *msg, const char *key)
{
    char rest[81];
    to[0] = 0;
    int p = find(msg, key);
    if (p > 0) {
        p += (int)strlen(key);
        mid(rest, msg, (int)strlen(msg) - p + 1, p);
        int q = find(rest, ";");
        if (q > 1)
            mid(to, rest, q - 1, 1);
    }
}

static int32_t seed = 31;
static const char names[5][21] = { "IDLE", "HEATING", "RUNNING", "RUNOUT", "FAULT" };
static char msg[81], last[81], log_line[81];

void scan(void)
{
    char number[21], state[21], text[21], left1[21], left2[21];
    int32_t sum = 0;
    int16_t same = 0, longest = 0;
    for (int i = 1; i <= 24; i++) {
        seed = (seed * 1103 + 12345) % 65536;
        int16_t temp = (int16_t)(seed % 400 - 100);
        int k = seed / 64 % 5;

        /* build */
        strcpy(msg, "UNIT=");
        int_to_string(number, (int16_t)(i * 11));
        strcat(msg, number);
        strcat(msg, ";TEMP=");
        int_to_string(number, temp);
        strcat(msg, number);
        strcat(msg, ";STATE=");
        strcat(msg, names[k]);
        strcat(msg, ";END;");
        if ((int)strlen(msg) > longest) longest = (int16_t)strlen(msg);

        /* take apart */
        field(number, msg, "UNIT=");
        sum += string_to_int(number);
        field(number, msg, "TEMP=");
        sum += string_to_int(number);
        field(state, msg, "STATE=");
        int found = -1;
        for (k = 0; k < 5; k++) {
            if (strcmp(state, names[k]) == 0) {
                found = k;
                break;
            }
        }
        sum += found * 100;

        /* compare with the telegram before */
        mid(left1, msg, 6, 1);
        mid(left2, last, 6, 1);
        if (strcmp(left1, left2) == 0) same++;
        if (strcmp(msg, last) > 0) same += 10;
        strcpy(last, msg);

        /* edit */
        strcpy(log_line, "12:00:00 ");
        strcat(log_line, msg);
        log_line[strlen(log_line) - 5] = 0;
        int first = find(log_line, "RUN");
        if (first > 0) {
            char *p = log_line + first - 1;
            memmove(p + 2, p + 3, strlen(p + 3) + 1);
            memcpy(p, "GO", 2);
        }
        int len = (int)strlen(log_line);
        strcpy(text, log_line + len - 8);
        if (strcmp(text, "M") < 0) sum += 3;
        sum += len + find(text, "=");
    }
    check = (check * 31 + sum + same * 7 + longest) % 1000003;
}
