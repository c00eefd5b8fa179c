#include <stdbool.h>
#include <string.h>
#include "st.h"

/* small text helpers over fixed buffers; positions count from 1, 0 = not found */
static void cut(char *s, int max)
{
    s[max] = 0;
}

static void int_to_text(int16_t v, char *out)
{
    char tmp[8];
    int n = 0;
    unsigned u = v < 0 ? (unsigned)-v : (unsigned)v;
    do {
        tmp[n++] = (char)('0' + u % 10);
        u /= 10;
    } while (u);
    if (v < 0)
        *out++ = '-';
    while (n)
        *out++ = tmp[--n];
    *out = 0;
}

static int16_t text_to_int(const char *s)
{
    bool neg = false;
    int v = 0;
    if (*s == '-' || *s == '+')
        neg = *s++ == '-';
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return (int16_t)(neg ? -v : v);
}

static int16_t find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int16_t)(p - s + 1) : 0;
}

static void left(char *out, const char *s, int n)
{
    int len = (int)strlen(s);
    if (n > len)
        n = len;
    memcpy(out, s, (size_t)n);
    out[n] = 0;
}

static void mid(char *out, const char *s, int n, int p)
{
    int len = (int)strlen(s);
    if (p > len) {
        out[0] = 0;
        return;
    }
    left(out, s + p - 1, n);
}

static void delete(char *s, int n, int p)
{
    int len = (int)strlen(s);
    if (p > len)
        return;
    if (p - 1 + n > len)
        n = len - p + 1;
    memmove(s + p - 1, s + p - 1 + n, (size_t)(len - (p - 1) - n + 1));
}

static void insert(char *s, const char *what, int p)
{
    size_t len = strlen(s), k = strlen(what);
    memmove(s + p + k, s + p, len - (size_t)p + 1);
    memcpy(s + p, what, k);
}

static void replace(char *s, const char *what, int n, int p)
{
    delete(s, n, p);
    insert(s, what, p - 1);
}

static void pad_left(char *out, int16_t value, int width)
{
    int_to_text(value, out);
    while ((int)strlen(out) < width)
        insert(out, "0", 0);
}

struct builder {
    int16_t station, order, weight;
    char status[11];
    char text[128];
};

static void builder(struct builder *b)
{
    char tmp[24];
    strcpy(b->text, "ST=");
    pad_left(tmp, b->station, 3);
    strcat(b->text, tmp);
    strcat(b->text, ";ORD=");
    pad_left(tmp, b->order, 5);
    strcat(b->text, tmp);
    strcat(b->text, ";W=");
    int_to_text(b->weight, tmp);
    strcat(b->text, tmp);
    strcat(b->text, ";STAT=");
    strcat(b->text, b->status);
    strcat(b->text, ";");
    cut(b->text, 80);
}

struct parser {
    char text[81];
    int16_t fields, station, order, weight;
    char status[81];
    char rest[81], field[81], key[81], value[81];
};

static void parser(struct parser *q)
{
    strcpy(q->rest, q->text);
    q->fields = 0;
    int p = find(q->rest, ";");
    while (p > 0) {
        left(q->field, q->rest, p - 1);
        delete(q->rest, p, 1);
        int e = find(q->field, "=");
        if (e > 0) {
            left(q->key, q->field, e - 1);
            mid(q->value, q->field, (int)strlen(q->field) - e, e + 1);
            q->fields++;
            if (strcmp(q->key, "ST") == 0)
                q->station = text_to_int(q->value);
            else if (strcmp(q->key, "ORD") == 0)
                q->order = text_to_int(q->value);
            else if (strcmp(q->key, "W") == 0)
                q->weight = text_to_int(q->value);
            else if (strcmp(q->key, "STAT") == 0)
                strcpy(q->status, q->value);
        }
        p = find(q->rest, ";");
    }
}

static int16_t n;
static struct builder bld;
static struct parser prs;
static char names[4][11] = { "RUN", "IDLE", "FAULT", "SETUP" };
static char msg[81], line[128];

void scan(void)
{
    int32_t sum = 0;
    int16_t hits = 0;
    char l[81], r[81];

    n++;
    if (n >= 3000)
        n = 0;
    for (int i = 0; i < 8; i++) {
        bld.station = (int16_t)(i + n % 90);
        bld.order = (int16_t)(n * 8 + i);
        bld.weight = (int16_t)(n - i * 100);
        strcpy(bld.status, names[(n + i) % 4]);
        builder(&bld);
        strcpy(msg, bld.text);
        strcpy(prs.text, msg);
        parser(&prs);
        sum += prs.station + prs.order + prs.weight + prs.fields + (int32_t)strlen(msg);
        if (strcmp(prs.status, "FAULT") == 0)
            hits++;

        strcpy(line, msg);
        insert(line, "*", 3);
        cut(line, 80);
        int p = find(line, "STAT=");
        if (p > 0)
            replace(line, "Zustand:", 5, p);
        p = find(line, "IDLE");
        if (p > 0)
            replace(line, "Pause", 4, p);
        left(l, line, 6);
        int len = (int)strlen(line);
        strcpy(r, line + (len > 14 ? len - 14 : 0));
        strcpy(line, l);
        strcat(line, r);
        if (strcmp(line, msg) > 0)
            hits = (int16_t)(hits + 10);
        if (strcmp(line, msg) == 0)
            hits = (int16_t)(hits + 100);
        sum += (int32_t)strlen(line) + find(line, "us");
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + hits * 1000));
}
