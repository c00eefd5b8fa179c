/* text work: building message lines, taking telegrams apart, comparing tag names */
#include <string.h>
#include <stdlib.h>
#include "st.h"

static const char tags[8][17] = { "TIC-101", "TIC-102", "PIC-201", "FIC-301", "LIC-401", "FIC-302", "PIC-202", "QIC-501" };
static const char units[4][9] = { "degC", "bar", "l/min", "mm" };
static char msg[121], log_line[121];
static char telegram[81], rest[81], field[81];
static char key[17], num[17];
static int32_t n;

static void append(char *dst, size_t size, const char *src)
{
    size_t have = strlen(dst), add = strlen(src);

    if (add > size - 1 - have)
        add = size - 1 - have;
    memcpy(dst + have, src, add);
    dst[have + add] = '\0';
}

/* position of the first occurrence from 1, 0 if there is none */
static int find(const char *s, const char *what)
{
    const char *p = strstr(s, what);

    return p ? (int)(p - s) + 1 : 0;
}

/* len characters from pos (from 1) */
static void mid(char *dst, size_t size, const char *src, int len, int pos)
{
    int have = (int)strlen(src);

    if (pos > have)
        len = 0;
    else if (pos - 1 + len > have)
        len = have - pos + 1;
    if (len > (int)size - 1)
        len = (int)size - 1;
    memcpy(dst, src + pos - 1, (size_t)len);
    dst[len] = '\0';
}

/* replaces len characters from pos (from 1) by what */
static void replace(char *s, size_t size, const char *what, int len, int pos)
{
    int have = (int)strlen(s), add = (int)strlen(what);

    if (have - len + add > (int)size - 1)
        return;
    memmove(s + pos - 1 + add, s + pos - 1 + len, (size_t)(have - (pos - 1 + len)) + 1);
    memcpy(s + pos - 1, what, (size_t)add);
}

static const char *to_text(char *buf, int32_t v)
{
    char t[12];
    int k = 0, o = 0;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;

    do {
        t[k++] = (char)('0' + u % 10);
        u /= 10;
    } while (u != 0);
    if (v < 0)
        buf[o++] = '-';
    while (k > 0)
        buf[o++] = t[--k];
    buf[o] = '\0';
    return buf;
}

void scan(void)
{
    char buf[16];
    int i, p, q, fields;
    int16_t val, back;
    int32_t sum;

    n = (n + 1) % 10000;
    sum = 0;

    /* messages */
    log_line[0] = '\0';
    for (i = 0; i < 8; i++) {
        val = (int16_t)((n * 7 + i * 131) % 1000);
        strcpy(msg, tags[i]);
        append(msg, sizeof msg, "=");
        append(msg, sizeof msg, to_text(buf, val));
        append(msg, sizeof msg, " ");
        append(msg, sizeof msg, units[i % 4]);

        /* take it apart again */
        p = find(msg, "=");
        q = find(msg, " ");
        mid(key, sizeof key, msg, p - 1, 1);
        mid(num, sizeof num, msg, q - p - 1, p + 1);
        back = (int16_t)atoi(num);
        sum += back * p;
        if (strcmp(key, tags[(i + 1) % 8]) == 0)
            sum += 100000;
        if (strcmp(key, tags[(i + 3) % 8]) < 0)
            sum += 17;

        if (val > 800)
            replace(msg, sizeof msg, "*ALARM* ", 0, 1);
        else if (val < 100)
            replace(msg, sizeof msg, "low", q - p - 1, p + 1);
        p = find(msg, "IC-");
        if (p > 0)
            replace(msg, sizeof msg, "", 1, p + 2);
        sum += (int)strlen(msg) * (i + 1);

        if (strlen(log_line) + strlen(msg) < 100) {
            append(log_line, sizeof log_line, msg);
            append(log_line, sizeof log_line, ";");
        }
    }
    sum += (int)strlen(log_line) * 31 + find(log_line, "bar") * 7 + find(log_line, "ALARM");

    /* telegram: build it, then split it into fields */
    strcpy(telegram, "ID");
    append(telegram, sizeof telegram, to_text(buf, n));
    append(telegram, sizeof telegram, ",RUN,");
    append(telegram, sizeof telegram, to_text(buf, n % 60));
    append(telegram, sizeof telegram, ",STOP,");
    append(telegram, sizeof telegram, to_text(buf, n * 3));
    strcpy(rest, telegram);
    fields = 0;
    p = find(rest, ",");
    while (p > 0) {
        mid(field, sizeof field, rest, p - 1, 1);
        memmove(rest, rest + p, strlen(rest + p) + 1);
        fields++;
        if (strcmp(field, "RUN") == 0)
            sum += 5;
        else if (strcmp(field, "STOP") == 0)
            sum += 9;
        else
            sum += (int)strlen(field);
        p = find(rest, ",");
    }
    sum += atoi(rest) + fields;

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
