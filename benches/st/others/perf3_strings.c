/* Telegrams "ID=xx;QTY=n;LOT=Ln;" are built, taken to pieces, checked and sorted */
#include <stdlib.h>
#include <string.h>
#include "st.h"

struct text { size_t len; char s[81]; };

static void add(struct text *t, const char *s, size_t n)
{
    if (n > sizeof t->s - 1 - t->len)
        n = sizeof t->s - 1 - t->len;
    memcpy(t->s + t->len, s, n);
    t->len += n;
    t->s[t->len] = 0;
}

static void add_str(struct text *t, const char *s)
{
    add(t, s, strlen(s));
}

static void add_int(struct text *t, int32_t value)
{
    char digits[12], *p = digits + sizeof digits;
    uint32_t u = value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
    do
        *--p = (char)('0' + u % 10);
    while (u /= 10);
    if (value < 0)
        *--p = '-';
    add(t, p, (size_t)(digits + sizeof digits - p));
}

/* Replaces n characters at pos by s. */
static void splice(struct text *t, size_t pos, size_t n, const char *s)
{
    size_t m = strlen(s);
    if (t->len - n + m >= sizeof t->s)
        return;
    memmove(t->s + pos + m, t->s + pos + n, t->len - pos - n + 1);
    memcpy(t->s + pos, s, m);
    t->len += m - n;
}

static int16_t find(const struct text *t, const char *s)
{
    const char *p = strstr(t->s, s);
    return p ? (int16_t)(p - t->s + 1) : 0;
}

static void field(char out[21], const struct text *t, const char *key)
{
    out[0] = 0;
    const char *p = strstr(t->s, key);
    if (!p)
        return;
    p += strlen(key);
    const char *end = strchr(p, ';');
    if (!end)
        return;
    size_t n = (size_t)(end - p) < 20 ? (size_t)(end - p) : 20;
    memcpy(out, p, n);
    out[n] = 0;
}

static const char *const names[8] = { "pump", "valve", "mixer", "oven", "belt", "gripper", "drill", "press" };
static int32_t tick;

void scan(void)
{
    char best[21] = "";
    uint32_t sum = 0;
    tick++;
    for (int i = 0; i < 8; i++) {
        struct text t = { .len = 0 };
        add_str(&t, "ID=");
        add_str(&t, names[i]);
        add_str(&t, ";QTY=");
        add_int(&t, tick * 7 + i);
        add_str(&t, ";LOT=L");
        add_int(&t, tick % 97);
        add_str(&t, ";");
        if (i % 2 == 1)
            splice(&t, (size_t)find(&t, "LOT=") - 1, 0, "PRIO=1;");

        char id[21], lot[21], qty[21], prio[21];
        field(id, &t, "ID=");
        field(lot, &t, "LOT=");
        field(qty, &t, "QTY=");
        if (strcmp(id, best) > 0)
            strcpy(best, id);
        field(prio, &t, "PRIO=");
        if (strcmp(prio, "1") == 0) {
            sum += 1000;
            splice(&t, (size_t)find(&t, "PRIO=") - 1, 7, "");
        }
        int16_t found = find(&t, "7;");
        if (found > 0)
            splice(&t, (size_t)found - 1, 2, "seven;");
        size_t lot_len = strlen(lot);
        if (lot_len > 1 && lot[1] == '4')
            sum += 77;
        sum = sum * 5 + (uint32_t)strtol(qty, NULL, 10) + (uint32_t)t.len + (uint32_t)found + (uint32_t)lot_len;
    }
    if (strcmp(best, "valve") == 0)
        sum += 3;
    check = (int32_t)((uint32_t)check * 31u + sum);
}
