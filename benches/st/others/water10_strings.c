#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

struct telegram { int station, value; char unit[9], command[13]; bool ok; };

static const char *const units[4] = { "P1", "P2", "V10", "LEVEL" };
static const char *const cmds[4] = { "RUN", "STOP", "SETPOINT", "ACK" };
static char last_log[81];
static int counter;

/* Append text / number at p, return the new end (terminated). */
static char *put_str(char *p, const char *s)
{
    size_t n = strlen(s);
    memcpy(p, s, n + 1);
    return p + n;
}

static char *put_int(char *p, int v)
{
    char tmp[12];
    int n = 0;
    unsigned u = v < 0 ? 0u - (unsigned)v : (unsigned)v;
    if (v < 0)
        *p++ = '-';
    do {
        tmp[n++] = (char)('0' + u % 10);
        u /= 10;
    } while (u);
    while (n)
        *p++ = tmp[--n];
    *p = '\0';
    return p;
}

static size_t build_telegram(char *buf, int station, const char *unit, const char *command, int value)
{
    char *p = put_str(buf, "ST");
    p = put_int(p, station);
    *p++ = ';';
    p = put_str(p, unit);
    *p++ = ';';
    p = put_str(p, command);
    *p++ = '=';
    p = put_int(p, value);
    return (size_t)(p - buf);
}

static int32_t char_sum(const char *s)
{
    static const char alphabet[] = "0123456789;=-/STPVRUNOLEVKDC";
    uint32_t sum = 0;
    for (; *s; s++) {
        const char *a = strchr(alphabet, *s);
        sum = sum * 3u + (a ? (uint32_t)(a - alphabet) + 1u : 0u);
    }
    return (int32_t)sum;
}

static void copy_field(char *dst, size_t cap, const char *s, const char *end)
{
    size_t n = (size_t)(end - s);
    if (n >= cap)
        n = cap - 1;
    memcpy(dst, s, n);
    dst[n] = '\0';
}

static void parse(struct telegram *t, const char *line)
{
    t->ok = false;
    if (line[0] != 'S' || line[1] != 'T')
        return;
    const char *s = line + 2;
    const char *e = strchr(s, ';');
    if (!e || e == s)
        return;
    t->station = atoi(s);
    s = e + 1;
    e = strchr(s, ';');
    if (!e || e == s)
        return;
    copy_field(t->unit, sizeof t->unit, s, e);
    s = e + 1;
    e = strchr(s, '=');
    if (!e || e == s)
        return;
    copy_field(t->command, sizeof t->command, s, e);
    t->value = atoi(e + 1);
    t->ok = true;
}

static inline void add(int32_t v) { check = (int32_t)((uint32_t)check * 31u + (uint32_t)v); }
static inline void plus(int32_t v) { check = (int32_t)((uint32_t)check + (uint32_t)v); }

void scan(void)
{
    static struct telegram t;
    char line[81], log_line[81];

    for (int i = 0; i < 6; i++) {
        size_t len = build_telegram(line, i * 17 + 3, units[(counter + i) % 4],
                                    cmds[(counter / 4 + i) % 4], counter * 3 - 400);
        char *sp = strstr(line, "SETPOINT");
        if (sp) {
            sp[1] = 'P';
            memmove(sp + 2, sp + 8, (size_t)(line + len - (sp + 8)) + 1);
            len -= 6;
        }
        add((int32_t)len);

        parse(&t, line);
        if (t.ok) {
            add(t.station + t.value);
            if (strcmp(t.command, "RUN") == 0)
                plus(1);
            else if (strcmp(t.command, "STOP") == 0)
                plus(2);
            else if (strcmp(t.command, "SP") == 0)
                plus(3);
            if (strcmp(t.unit, "P2") >= 0)
                plus(10);
        }

        memcpy(log_line, line, 2);
        log_line[2] = '/';
        char *p = put_int(log_line + 3, counter);
        memcpy(p, line + 2, len - 2 + 1);
        if (strcmp(log_line, last_log) > 0)
            plus(100);
        strcpy(last_log, log_line);
    }
    add(char_sum(log_line));

    if (++counter >= 5000)
        counter = 0;
}
