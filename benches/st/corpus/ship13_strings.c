#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

#define LINE 81

static const char *const unit[4] = {"DG1", "DG2", "BALLAST-P1", "FIREDOOR7"};
static const char *const state[3] = {"RUN", "STANDBY", "TRIPPED"};
static char logbook[16][LINE];
static int16_t scans;
static uint32_t crc;

/* The text between the key and the next semicolon. */
static void field(char *out, size_t size, const char *line, const char *key)
{
    out[0] = '\0';
    const char *p = strstr(line, key);
    if (!p)
        return;
    p += strlen(key);
    const char *end = strchr(p, ';');
    if (!end)
        return;
    size_t n = end - p;
    if (n >= size)
        n = size - 1;
    memcpy(out, p, n);
    out[n] = '\0';
}

/* Puts text in the place of the n characters at p. */
static void splice(char *p, size_t n, const char *text)
{
    size_t len = strlen(text);
    memmove(p + len, p + n, strlen(p + n) + 1);
    memcpy(p, text, len);
}

static int find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int)(p - s) + 1 : 0;
}

void scan(void)
{
    for (int n = 0; n < 4; n++) {
        char line[LINE], out[LINE], f[21];

        scans = (scans + 1) % 10000;
        int rpm = (int16_t)(scans * 3) % 1000;
        int temp = 60 + scans % 45;

        snprintf(line, sizeof line, "ALM%04d;U=%s;RPM=%d;T=%d;S=%s;", scans, unit[n], rpm, temp,
                 state[scans % 3]);

        field(f, sizeof f, line, "RPM=");
        crc = crc * 31 + atoi(f);
        field(f, sizeof f, line, ";T=");
        crc = crc * 31 + atoi(f);
        field(f, sizeof f, line, "S=");
        if (strcmp(f, "TRIPPED") == 0)
            crc += 17;
        else if (strcmp(f, "RUN") > 0)
            crc += 5;

        memcpy(out, line, sizeof out);
        char *p = strstr(out, ";U=");
        if (p)
            splice(p, 3, " ");
        p = strstr(out, ";S=");
        if (p)
            splice(p, 3, " - ");
        crc = crc * 7 + (uint32_t)strlen(out) + find(out, "-");

        strcpy(logbook[scans % 16], out);
    }

    int same = 0;
    for (int i = 0; i < 16; i++) {
        if (strstr(logbook[i], unit[scans % 4])) {
            same++;
            crc += (uint32_t)strlen(logbook[i]);
        }
        if (strlen(logbook[i]) >= 7 && memcmp(logbook[i] + 4, "001", 3) == 0)
            crc += 1;
    }
    crc = crc * 31 + same;
    check = (int32_t)crc;
}
