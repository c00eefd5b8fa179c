#include <string.h>
#include "st.h"

static const char *const names[8] = { "Pump", "Valve", "Conveyor", "Mixer", "Heater", "Fan", "Compressor", "Gate" };
static const char *const units[4] = { "bar", "rpm", "C", "mm" };
static char last_key[81];
static int32_t n;

/* appends s to the buffer and returns the new end */
static char *put(char *end, const char *s)
{
    size_t len = strlen(s);
    memcpy(end, s, len + 1);
    return end + len;
}

/* at least six digits (the values are positive) */
static char *put_number(char *end, uint32_t v)
{
    char t[10];
    int k = 0;
    do {
        t[k++] = (char)('0' + v % 10);
        v /= 10;
    } while (v);
    while (k < 6)
        t[k++] = '0';
    while (k)
        *end++ = t[--k];
    *end = 0;
    return end;
}

static int32_t number(const char *s)
{
    int32_t v = 0;
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return v;
}

static int32_t find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int32_t)(p - s) + 1 : 0;
}

void scan(void)
{
    char msg[81], key[81], val[81], log[201];
    char *log_end = log;
    int32_t hits = 0, order = 0, digits = 0;

    n++;
    log[0] = 0;
    for (int i = 0; i < 8; i++) {
        /* build */
        char *e = put(msg, names[i]);
        e = put(e, ".");
        e = put(e, units[(n + i) % 4]);
        e = put(e, "=");
        e = put_number(e, (uint32_t)(n * 13 + i));
        e = put(e, ";");

        /* take apart */
        char *eq = strchr(msg, '=');
        size_t klen = (size_t)(eq - msg), vlen = (size_t)(e - eq) - 2;
        memcpy(key, msg, klen);
        key[klen] = 0;
        memcpy(val, eq + 1, vlen);
        val[vlen] = 0;

        /* change */
        char *rpm = strstr(key, ".rpm");
        if (rpm) {
            char tail[81];
            strcpy(tail, rpm + 4);
            put(put(rpm, "_speed"), tail);
            hits++;
        } else if (klen >= 2 && strcmp(key + klen - 2, ".C") == 0) {
            key[klen - 2] = 0;
            memmove(key + 2, key, klen - 1);
            memcpy(key, "T_", 2);
            hits += 10;
        }

        /* compare */
        int c = strcmp(key, last_key);
        if (c < 0)
            order++;
        else if (c == 0)
            order += 100;
        strcpy(last_key, key);

        digits += number(val);
        log_end = put(log_end, key);
        log_end = put(log_end, ":");
        log_end = put(log_end, val);
        log_end = put(log_end, " ");
    }
    if (strstr(log, "Gate"))
        hits += 100;
    check = (int32_t)((uint32_t)check * 31u
                      + (uint32_t)(hits + order * 7 + digits + (int32_t)(log_end - log) + find(log, "T_") * 3));
}
