#include <stdbool.h>
#include <string.h>
#include "st.h"

struct telegram {
    char cmd[9], lu[17], dest[17], weight[13];
};

static uint32_t seed = 2024;
static const char *const cmds[3] = { "RCV", "POS", "DEL" };
static const char *const dests[5] = { "STORE", "PICK01", "PICK02", "OUTBOUND", "QA" };
static uint32_t hits[5];
static uint32_t no_reads, repeats, rejects;
static char last_reply[81];
static struct telegram t;

static char *put(char *p, const char *s)
{
    size_t n = strlen(s);
    memcpy(p, s, n + 1);
    return p + n;
}

static char *put_int(char *p, int32_t v)
{
    char buf[12];
    int n = 0;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
    if (v < 0)
        *p++ = '-';
    do {
        buf[n++] = (char)('0' + u % 10);
        u /= 10;
    } while (u);
    while (n)
        *p++ = buf[--n];
    *p = '\0';
    return p;
}

static int32_t get_int(const char *s)
{
    bool neg = *s == '-';
    uint32_t u = 0;
    if (neg)
        s++;
    while (*s >= '0' && *s <= '9')
        u = u * 10 + (uint32_t)(*s++ - '0');
    return (int32_t)(neg ? 0u - u : u);
}

/* Copies the field at s, ended by ';' or end, and returns what follows it. */
static const char *token(const char *s, const char *end, char *out, size_t size)
{
    const char *p = memchr(s, ';', (size_t)(end - s));
    const char *stop = p ? p : end;
    size_t n = (size_t)(stop - s);
    if (n > size - 1)
        n = size - 1;
    memcpy(out, s, n);
    out[n] = '\0';
    return p ? p + 1 : end;
}

static void add(uint32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + v);
}

void scan(void)
{
    char highest[21] = "";

    for (int n = 0; n < 3; n++) {
        char tele[81], reply[81], label[21];

        seed = seed * 1664525u + 1013904223u;
        int32_t r = (int32_t)(seed >> 16);
        int32_t grams = 1000 + r % 29000;
        char *p = put(tele, "<");
        p = put(p, cmds[n]);
        if (r % 8 == 0) {
            p = put(p, ";NOREAD;");
        } else {
            p = put(p, ";LU");
            p = put_int(p, 100000 + r * 7);
            p = put(p, ";");
        }
        p = put(p, dests[r % 5]);
        p = put(p, ";");
        p = put_int(p, grams);
        p = put(p, ">");
        size_t len = (size_t)(p - tele);

        int32_t unit_no = 0;
        if (tele[0] == '<' && tele[len - 1] == '>') {
            const char *s = tele + 1, *end = tele + len - 1;
            s = token(s, end, t.cmd, sizeof t.cmd);
            s = token(s, end, t.lu, sizeof t.lu);
            s = token(s, end, t.dest, sizeof t.dest);
            token(s, end, t.weight, sizeof t.weight);
            if (strcmp(t.lu, "NOREAD") == 0) {
                no_reads++;
                strcpy(t.dest, "REJECT");
            } else if (strncmp(t.lu, "LU", 2) == 0) {
                unit_no = get_int(t.lu + 2);
            }
            grams = get_int(t.weight);
        }

        int pos = -1;
        for (int d = 0; d < 5; d++) {
            if (strcmp(dests[d], t.dest) == 0) {
                pos = d;
                break;
            }
        }
        if (pos >= 0)
            hits[pos]++;
        else
            rejects++;

        size_t whole = strlen(t.weight) - 3;
        memcpy(label, t.weight, whole);
        label[whole] = '.';
        put(put(label + whole + 1, t.weight + whole), " kg");
        if (strcmp(label, highest) > 0)
            strcpy(highest, label);

        p = put(reply, "<ACK");
        p = put(p, tele + 1 + strlen(t.cmd));
        p[-1] = ';';                        /* in place of the '>' */
        p = put(p, label);
        p = put(p, ">");
        int reply_len = (int)(p - reply);
        const char *dot = strchr(reply, '.');
        int semi = dot ? (int)(dot - reply) + 1 : 0;
        if (strcmp(reply, last_reply) == 0)
            repeats++;
        memcpy(last_reply, reply, (size_t)reply_len + 1);

        add((uint32_t)unit_no);
        add((uint32_t)grams);
        add((uint32_t)(reply_len * 100 + semi));
    }

    add(no_reads + rejects + repeats);
    add((uint32_t)get_int(highest));
    for (int d = 0; d < 5; d++)
        add(hits[d]);
}
