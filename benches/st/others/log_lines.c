#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

static const char *const names[] = { "pump", "mixer", "oven", "conveyor" };
static const char *const levels[] = { "INFO", "WARN", "ERROR" };

static char lines[16][81];
static char telegram[121];
static char message[81];
static int scans, seed = 3;
static int temperature, pressure, order_no, state;

/* Both append and return the new end. */
static char *put(char *end, const char *text)
{
    size_t n = strlen(text);
    memcpy(end, text, n + 1);
    return end + n;
}

static char *put_int(char *end, int value)
{
    char digits[12];
    char *p = digits + sizeof digits;
    unsigned rest = value < 0 ? -(unsigned)value : (unsigned)value;
    do {
        *--p = '0' + rest % 10;
        rest /= 10;
    } while (rest);
    if (value < 0)
        *--p = '-';
    size_t n = digits + sizeof digits - p;
    memcpy(end, p, n);
    end[n] = 0;
    return end + n;
}

static size_t log_line(char *line, int number, int level, const char *source, int value)
{
    char *p = put_int(line, number);
    p = put(p, " [");
    p = put(p, level >= 0 && level <= 2 ? levels[level] : "?");
    p = put(p, "] ");
    p = put(p, source);
    p = put(p, ": value=");
    p = put_int(p, value);
    return p - line;
}

/* Puts `text` in place of the first `mark`. */
static void fill_in(char *into, const char *mark, const char *text)
{
    char *at = strstr(into, mark);
    if (!at)
        return;
    size_t old = strlen(mark), new = strlen(text);
    memmove(at + new, at + old, strlen(at + old) + 1);
    memcpy(at, text, new);
}

static int position(const char *in, const char *what)
{
    const char *at = strstr(in, what);
    return at ? (int)(at - in) + 1 : 0;
}

void scan(void)
{
    scans++;
    int sum = 0;
    for (int i = 0; i < 16; i++) {
        seed = (seed * 1103 + 12345) % 65536;
        sum += log_line(lines[i], scans * 16 + i, seed % 3, names[seed / 3 % 4], seed - 20000);
    }

    int hits = 0;
    for (int i = 0; i < 16; i++) {
        if (strstr(lines[i], "ERROR"))
            hits++;
        sum += atoi(strstr(lines[i], "value=") + 6) % 100;
    }
    sum += hits * 50;

    char *p = put(telegram, "TEMP=");
    p = put_int(p, seed % 400);
    p = put(p, ";PRES=");
    p = put_int(p, scans % 1000);
    p = put(p, ";ORDER=");
    p = put_int(p, 100000 + scans);
    p = put(p, ";STATE=");
    put(p, seed % 2 == 0 ? "RUN;" : "STOP;");

    char rest[121];
    strcpy(rest, telegram);
    char *field = rest;
    for (char *end; (end = strchr(field, ';')); field = end + 1) {
        *end = 0;
        char *text = strchr(field, '=');
        *text++ = 0;
        if (strcmp(field, "TEMP") == 0)
            temperature = atoi(text);
        else if (strcmp(field, "PRES") == 0)
            pressure = atoi(text);
        else if (strcmp(field, "ORDER") == 0)
            order_no = atoi(text);
        else if (strcmp(field, "STATE") == 0)
            state = strcmp(text, "RUN") == 0 ? 1 : 2;
    }
    sum += temperature + pressure * 2 + order_no % 1000 + state;

    char number[12];
    strcpy(message, "Order %1 of line %2 is %3");
    put_int(number, order_no);
    fill_in(message, "%1", number);
    fill_in(message, "%2", names[scans % 4]);
    fill_in(message, "%3", state == 1 ? "running" : "stopped");
    size_t length = strlen(message);
    if (length > 35) {
        memmove(message + 3, message, length + 1);
        memcpy(message, "!! ", 3);
        length += 3;
    }
    sum += (int)length * 3 + position(message, "run");

    int greatest = 0;
    for (int i = 1; i < 16; i++)
        if (strcmp(lines[i], lines[greatest]) > 0)
            greatest = i;
    sum += greatest;
    check = (check * 31 + sum) % 1000003;
}
