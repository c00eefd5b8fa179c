/* telegrams and alarm texts */
#include "st.h"
#include <string.h>

typedef enum { STOPPED, RUNNING, WARNING, ALARM } state_t;

static const char *state_text(state_t s)
{
    switch (s) {
    case STOPPED: return "STOP";
    case RUNNING: return "RUN";
    case WARNING: return "WARN";
    default:      return "ALARM";
    }
}

static void int_to_string(char *dst, int16_t value)
{
    char tmp[8];
    int n = 0;
    int v = value;

    if (v < 0) {
        *dst++ = '-';
        v = -v;
    }
    do {
        tmp[n++] = (char)('0' + v % 10);
        v /= 10;
    } while (v > 0);
    while (n > 0)
        *dst++ = tmp[--n];
    *dst = '\0';
}

static int16_t string_to_int(const char *s)
{
    int v = 0, neg = 0;

    if (*s == '-') {
        neg = 1;
        s++;
    }
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return (int16_t)(neg ? -v : v);
}

/* position from 1, 0 if not found */
static int16_t find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int16_t)(p - s + 1) : 0;
}

static void left(char *dst, const char *s, int n)
{
    int len = (int)strlen(s);
    if (n > len)
        n = len;
    memcpy(dst, s, (size_t)n);
    dst[n] = '\0';
}

static void pad_zero(char *dst, int16_t value, int width)
{
    int_to_string(dst, value);
    int len = (int)strlen(dst);
    while (len < width) {
        memmove(dst + 1, dst, (size_t)len + 1);
        dst[0] = '0';
        len++;
    }
}

typedef struct {
    int16_t hits;
    char ring[8][81];
    int next;
} log_t;

static void log_add(log_t *l, const char *text)
{
    strcpy(l->ring[l->next], text);
    l->next = (l->next + 1) % 8;
    l->hits = 0;
    for (int k = 0; k < 8; k++) {
        if (find(l->ring[k], "ALARM") > 0)
            l->hits++;
    }
}

static int32_t scan_no;
static char name[8][17] = { "Motor", "Pump", "Valve", "Mixer", "Conveyor", "Heater", "Fan", "Tank" };
static log_t msg_log;
static char line[81], rest[81], num[21], state_str[13], msg[81], old[17];

void scan(void)
{
    int32_t sum = 0;
    char buf[81];
    state_t state;
    int16_t value, pos;

    scan_no = (scan_no + 1) % 10000;
    for (int i = 0; i < 8; i++) {
        value = (int16_t)((scan_no * 37 + i * 211) % 2001 - 1000);
        if (value < -500)
            state = STOPPED;
        else if (value < 500)
            state = RUNNING;
        else if (value < 800)
            state = WARNING;
        else
            state = ALARM;
        strcpy(line, name[i]);
        strcat(line, "_");
        pad_zero(buf, (int16_t)(i + 1), 3);
        strcat(line, buf);
        strcat(line, ";");
        int_to_string(buf, value);
        strcat(line, buf);
        strcat(line, ";");
        strcat(line, state_text(state));

        pos = find(line, ";");
        left(msg, line, pos - 1);
        strcpy(rest, line + pos);
        pos = find(rest, ";");
        left(num, rest, pos - 1);
        strcpy(state_str, rest + pos);
        sum += string_to_int(num) + (int32_t)strlen(state_str);

        if (strcmp(state_str, "ALARM") == 0) {
            strcat(msg, " ALARM, value ");
            strcat(msg, num);
            strcpy(buf, ">> ");
            strcat(buf, msg);
            strcpy(msg, buf);
        } else if (strcmp(state_str, "WARN") == 0) {
            pos = find(msg, "_");
            left(buf, msg, pos - 1);
            strcat(buf, " no. ");
            strcat(buf, msg + pos);
            strcpy(msg, buf);
        } else {
            strcpy(buf, msg + strlen(msg) - 3);
            strcat(buf, ": ");
            strcat(buf, state_str);
            strcpy(msg, buf);
        }
        log_add(&msg_log, msg);
        if (strcmp(name[i], old) > 0)
            sum += 5;
        left(old, msg, 16);
        sum += (int32_t)strlen(msg) * 3 + msg_log.hits + find(msg, "0") * 7;
    }
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
