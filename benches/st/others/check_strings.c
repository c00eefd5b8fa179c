/* Builds, parses and logs a telegram with string functions. */
#include <stdlib.h>
#include <string.h>
#include "st.h"

static char *put_str(char *p, const char *s)
{
    size_t n = strlen(s);
    memcpy(p, s, n + 1);
    return p + n;
}

static char *put_int(char *p, int32_t v)
{
    char buf[12], *q = buf + sizeof buf;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
    do
        *--q = (char)('0' + u % 10);
    while (u /= 10);
    if (v < 0)
        *--q = '-';
    size_t n = (size_t)(buf + sizeof buf - q);
    memcpy(p, q, n);
    p[n] = 0;
    return p + n;
}

/* 1-based position of a text in another, 0 when it is not there */
static int32_t find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int32_t)(p - s) + 1 : 0;
}

static void field(char *out, const char *text, const char *key)
{
    const char *p = strstr(text, key);
    if (!p) {
        *out = 0;
        return;
    }
    p += strlen(key);
    const char *end = strchr(p, ';');
    size_t n = end ? (size_t)(end - p) : strlen(p);
    memcpy(out, p, n);
    out[n] = 0;
}

static int32_t scan_no;
static char line[84], log_text[84];

void scan(void)
{
    static const char *const states[] = { "RUN", "STOP", "FAULT", "IDLE" };
    char value[84], state[84];

    int32_t station = scan_no % 24 + 1;
    int32_t temp = scan_no * 37 % 901 - 100;
    int32_t press = scan_no * 91 % 16001;
    const char *now = states[scan_no * 5 / 3 % 4];
    scan_no = (scan_no + 1) % 1000000;

    char *p = put_int(put_str(line, "ST"), station);
    p = put_int(put_str(p, ";T="), temp);
    p = put_int(put_str(p, ";P="), press);
    p = put_str(put_str(p, ";S="), now);
    int32_t len = (int32_t)(p - line);
    p = put_int(put_str(p, ";L="), len);
    p = put_str(p, ";END");

    field(value, line, ";T=");
    int32_t sum = atoi(value) * 3;
    field(value, line, ";P=");
    sum += atoi(value);
    field(value, line, ";L=");
    sum += atoi(value) * 17;
    field(state, line, ";S=");
    if (strcmp(state, "FAULT") == 0)
        sum += 1000;
    else if (strcmp(state, "STOP") == 0)
        sum += 2000;
    else if (strcmp(state, now) != 0)
        sum += 4000;

    size_t n = strlen(state), old = strlen(log_text);
    memmove(log_text + n + 1, log_text, old + 1);
    memcpy(log_text, state, n);
    log_text[n] = '|';
    old += n + 1;
    if (old > 60) {
        old = 60;
        log_text[60] = 0;
    }
    sum += find(log_text, "FAULT|IDLE") * 5 + (int32_t)old;
    char part[6] = "";
    if (old >= 20) {
        strncpy(part, log_text + 19, 5);
        part[5] = 0;
    }
    sum += find(part, "|") * 7;

    char *t = strstr(line, ";T=") + 1;
    size_t tail = (size_t)(p - t);
    memmove(t + 4, t + 1, tail);
    memcpy(t, "TEMP", 4);
    p += 3;
    sum += find(line, now) + (int32_t)(p - line) * 3;
    if (memcmp(p - 4, ";END", 4) == 0)
        sum += 11;

    check = (check * 31 + sum) % 1000003;
}
