#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

typedef struct {
    char cmd[9];
    char product[17];
    int32_t vessel, amount;
    bool ok;
} telegram;

static const char *const products[8] = {
    "ACID", "CAUSTIC", "ETHANOL", "WATER", "CATALYST-7", "RESIN", "INHIBITOR", "SOLVENT-22",
};
static const char *const commands[3] = { "DOSE", "DRAIN", "RINSE" };
static char history[16][81];
static int32_t scan_no;

/* Appends at the end and returns the new end. */
static char *put(char *end, const char *s)
{
    size_t n = strlen(s);
    memcpy(end, s, n + 1);
    return end + n;
}

/* Appends a number >= 0 with at least width digits. */
static char *put_num(char *end, uint32_t v, int width)
{
    char tmp[12];
    int n = 0;
    do {
        tmp[n++] = (char)('0' + v % 10);
        v /= 10;
    } while (v != 0);
    while (n < width)
        tmp[n++] = '0';
    while (n > 0)
        *end++ = tmp[--n];
    *end = 0;
    return end;
}

/* Copies at most size - 1 characters. */
static void copy_field(char *dst, size_t size, const char *src, size_t n)
{
    if (n > size - 1)
        n = size - 1;
    memcpy(dst, src, n);
    dst[n] = 0;
}

/* Replaces del characters at pos by s. */
static void splice(char *str, size_t pos, size_t del, const char *s)
{
    size_t n = strlen(s);
    char *at = str + pos;
    memmove(at + n, at + del, strlen(at + del) + 1);
    memcpy(at, s, n);
}

static int32_t number(const char *s, size_t n)
{
    int32_t v = 0;
    for (size_t i = 0; i < n && s[i] >= '0' && s[i] <= '9'; i++)
        v = v * 10 + (s[i] - '0');
    return v;
}

static void parse(telegram *t, const char *line)
{
    t->ok = false;
    for (int n = 0; *line; n++) {
        const char *sep = strchr(line, ';');
        size_t l = sep ? (size_t)(sep - line) : strlen(line);
        switch (n) {
        case 0: copy_field(t->cmd, sizeof t->cmd, line, l); break;
        case 1: t->vessel = number(line + 1, 2); break;
        case 2: copy_field(t->product, sizeof t->product, line, l); break;
        case 3: t->amount = number(line, l); t->ok = true; break;
        }
        line += l + (sep != NULL);
    }
}

void scan(void)
{
    static telegram t;
    char msg[81];

    scan_no++;
    int32_t amount = (int32_t)((uint32_t)scan_no * 7919u) % 100000;

    char *e = put(msg, commands[scan_no % 3]);
    e = put(e, ";R");
    e = put_num(e, scan_no % 24, 2);
    e = put(e, ";");
    e = put(e, products[scan_no * 5 % 8]);
    e = put(e, ";");
    e = put_num(e, amount, 1);

    parse(&t, msg);
    int index = -1;
    for (int i = 0; i < 8; i++)
        if (strcmp(t.product, products[i]) == 0)
            index = i;

    uint32_t sum = (uint32_t)check;
    sum = sum * 31 + (uint32_t)(e - msg);
    sum = sum * 31 + (uint32_t)index;
    if (t.ok) {
        sum = sum * 31 + (uint32_t)t.vessel;
        sum = sum * 31 + (uint32_t)t.amount;
    }

    char *at = strstr(msg, "DOSE");
    if (at)
        splice(msg, at - msg, 4, "CHARGE");
    else if (strcmp(t.cmd, "DRAIN") == 0)
        splice(msg, 5, 0, "!");
    at = strstr(msg, ";R");
    int found = at ? (int)(at - msg) + 1 : 0;
    if (at)
        splice(msg, at - msg, 2, " reactor ");
    e = put(msg + strlen(msg), " kg #");
    e = put_num(e, scan_no % 10000, 5);
    sum = sum * 31 + (uint32_t)(e - msg) * 100 + (uint32_t)found;

    int slot = scan_no % 16;
    memcpy(history[slot], msg, e - msg + 1);
    uint32_t greater = 0, same = 0;
    for (int i = 0; i < 16; i++) {
        greater += strcmp(history[i], msg) > 0;
        same += strncmp(history[i], msg, 6) == 0;
    }
    sum = sum * 31 + greater;
    sum = sum * 31 + same;

    const char *h = history[(slot + 5) % 16];
    size_t n = strlen(h);
    const char *tail = n > 5 ? h + n - 5 : h;
    check = (int32_t)(sum * 31 + (uint32_t)number(tail, strlen(tail)));
}
