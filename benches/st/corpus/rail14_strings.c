#include <stdbool.h>
#include <string.h>
#include "st.h"

#define CAP 80

typedef struct { int len; char s[CAP + 1]; } str_t;

static int32_t tick;

static inline void str_clear(str_t *d) { d->len = 0; d->s[0] = 0; }

static void str_add(str_t *d, const char *s, int n)
{
    if (n > CAP - d->len)
        n = CAP - d->len;
    memcpy(d->s + d->len, s, (size_t)n);
    d->len += n;
    d->s[d->len] = 0;
}

static inline void str_lit(str_t *d, const char *s) { str_add(d, s, (int)strlen(s)); }

static void str_int(str_t *d, int32_t v)
{
    char buf[12];
    int n = sizeof buf;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
    do {
        buf[--n] = (char)('0' + u % 10);
        u /= 10;
    } while (u);
    if (v < 0)
        buf[--n] = '-';
    str_add(d, buf + n, (int)sizeof buf - n);
}

static int32_t str_to_int(const str_t *d)
{
    const char *p = d->s;
    bool neg = *p == '-';
    int32_t v = 0;
    if (neg)
        p++;
    while (*p >= '0' && *p <= '9')
        v = v * 10 + (*p++ - '0');
    return neg ? -v : v;
}

/* 1-based position, 0 if not found */
static int str_find(const str_t *d, const char *key)
{
    const char *p = strstr(d->s, key);
    return p ? (int)(p - d->s) + 1 : 0;
}

static void telegram(str_t *d, int32_t station, int32_t temp, bool heating)
{
    str_clear(d);
    str_lit(d, "PT");
    str_int(d, station);
    str_lit(d, ";T=");
    str_int(d, temp);
    str_lit(d, heating ? ";ST=HEAT" : ";ST=OFF");
}

static void field(str_t *d, const str_t *text, const char *key)
{
    str_clear(d);
    const char *p = strstr(text->s, key);
    if (!p)
        return;
    p += strlen(key);
    const char *q = strchr(p, ';');
    str_add(d, p, q ? (int)(q - p) : (int)(text->s + text->len - p));
}

static void str_delete(str_t *d, int n, int pos)
{
    if (pos < 1)
        return;
    memmove(d->s + pos - 1, d->s + pos - 1 + n, (size_t)(d->len - (pos - 1) - n + 1));
    d->len -= n;
}

static void str_keep_right(str_t *d, int n)
{
    if (d->len <= n)
        return;
    memmove(d->s, d->s + d->len - n, (size_t)n + 1);
    d->len = n;
}

void scan(void)
{
    str_t msg, work, f, log;
    uint32_t sum = 0;

    tick++;
    str_clear(&log);
    for (int32_t i = 0; i < 8; i++) {
        telegram(&msg, 100 + (int32_t)((uint32_t)tick * 7u + (uint32_t)i * 13u) % 9900,
                 (tick + i * 31) % 600 - 250, (tick + i) % 3 == 0);
        field(&f, &msg, ";T=");
        sum = sum * 31u + (uint32_t)str_to_int(&f);
        field(&f, &msg, "ST=");
        str_clear(&work);
        if (strcmp(f.s, "HEAT") == 0) {
            sum++;
            int p = str_find(&msg, "HEAT");
            str_add(&work, msg.s, p - 1);
            str_lit(&work, "ON");
            str_add(&work, msg.s + p + 3, msg.len - p - 3);
        } else {
            str_add(&work, msg.s, 2);
            str_lit(&work, "#");
            str_add(&work, msg.s + 2, msg.len - 2);
        }
        str_delete(&work, 1, str_find(&work, ";"));
        sum = sum * 31u + (uint32_t)work.len * 100u + (uint32_t)str_find(&work, "=O");
        str_add(&log, work.s, work.len);
        str_keep_right(&log, 40);
    }
    for (int32_t i = 0; i < 10; i++) {
        str_clear(&f);
        str_int(&f, i);
        sum = sum * 7u + (uint32_t)str_find(&log, f.s);
    }
    check = (int32_t)((uint32_t)check * 31u + sum + (uint32_t)log.len);
}
