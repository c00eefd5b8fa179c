/* alarm texts and telegrams of the outstations */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

static const char *const alarm_text[6] = {
    "Pump %1 tripped", "Level low in tank %1", "Dosing pump %1: no flow",
    "Pressure %1 high", "Mains failure %1", "Chlorine %1 out of range",
};
static char logbook[6][81];
static int32_t scans;

static uint32_t text_sum(const char *s)
{
    uint32_t n = 0;
    for (; *s; s++)
        n = n * 31 + (unsigned char)*s;
    return n;
}

/* decimal text of a number, returns its length */
static int dint_to_text(char *out, int32_t v)
{
    char buf[12];
    int n = 0, len = 0;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
    do {
        buf[n++] = (char)('0' + u % 10);
        u /= 10;
    } while (u);
    if (v < 0)
        out[len++] = '-';
    while (n)
        out[len++] = buf[--n];
    out[len] = 0;
    return len;
}

static void two_digits(char *out, int n)
{
    if (n < 10)
        *out++ = '0';
    dint_to_text(out, n);
}

static const char *tail(const char *s, size_t n)
{
    size_t len = strlen(s);
    return len > n ? s + len - n : s;
}

void scan(void)
{
    char stamp[21], num[41], line[81];
    uint32_t sum = 0;
    scans++;

    two_digits(stamp, scans / 60 % 24);
    strcat(stamp, ":");
    two_digits(stamp + strlen(stamp), scans % 60);
    size_t stamp_len = strlen(stamp);
    for (int i = 0; i < 6; i++) {
        dint_to_text(num, (int32_t)((uint32_t)scans * (uint32_t)(i + 1)) % 1000);
        strcpy(line, stamp);
        strcat(line, " ");
        const char *mark = strstr(alarm_text[i], "%1");
        if (mark) {
            strncat(line, alarm_text[i], (size_t)(mark - alarm_text[i]));
            strcat(line, num);
            strcat(line, mark + 2);
        } else
            strcat(line, alarm_text[i]);
        if (strstr(line, "ump")) {
            char *at = line + stamp_len + 1;
            memmove(at + 3, at, strlen(at) + 1);
            memcpy(at, "!! ", 3);
        } else if (strstr(line, "Level")) {
            char *at = strstr(line, "low");
            memmove(at, at + 4, strlen(at + 4) + 1);
        }
        sum += (uint32_t)strlen(line);
        strcpy(logbook[i], line);
    }
    sum += text_sum(logbook[scans % 6]);

    char telegram[81], field[41];
    strcpy(telegram, "FLOW=");
    dint_to_text(telegram + strlen(telegram), scans % 5000);
    strcat(telegram, ";LEVEL=");
    dint_to_text(telegram + strlen(telegram), 300 - scans % 600);
    strcat(telegram, ";STATE=");
    dint_to_text(telegram + strlen(telegram), scans % 4);
    strcat(telegram, ";");

    const char *work = telegram;
    const char *semi;
    while ((semi = strchr(work, ';')) != NULL) {
        size_t len = (size_t)(semi - work);
        memcpy(field, work, len);
        field[len] = 0;
        work = semi + 1;
        char *eq = strchr(field, '=');
        *eq = 0;
        int32_t value = (int32_t)strtol(eq + 1, NULL, 10);
        if (strcmp(field, "FLOW") == 0)
            sum += (uint32_t)(value * 3);
        else if (strcmp(field, "LEVEL") == 0)
            sum += (uint32_t)(value * 5);
        else if (strcmp(field, "STATE") == 0)
            sum += (uint32_t)(value * 1000);
        else
            sum -= 1;
    }

    int32_t same = 0;
    for (int i = 1; i < 6; i++) {
        if (strncmp(logbook[i] + 6, logbook[i - 1] + 6, 6) == 0)
            same += 10;
        else if (strcmp(tail(logbook[i], 4), tail(logbook[i - 1], 4)) > 0)
            same += i + 1;
    }
    check = (int32_t)((uint32_t)check * 19u + sum + (uint32_t)same + (uint32_t)strlen(telegram));
}
