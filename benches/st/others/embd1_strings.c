/* texts of a machine controller: status telegrams, a command line parser and an alarm text */
#include <stdbool.h>
#include <string.h>
#include "st.h"

static const char names[6][17] = { "X axis", "Y axis", "Z axis", "Spindle", "Loader", "Cooling pump" };
static const char cmds[3][81] = {
    "MOVE X 1200;SPEED 75;WAIT 20;MOVE Y -340;STOP",
    "HOME ALL;SPEED 100;MOVE Z 55;NOP;STOP",
    "SPEED 12;JOG X;JOG Y;MOVE X 7;MOVE X 8"
};
static int32_t n;
static char msg[81], last_msg[81];
static char num[17];
static char rest[81];
static char tok[41], arg[41];
static char alarm_text[81];

/* decimal text of a number; returns its length */
static int int_to_str(char *dst, int32_t v)
{
    char tmp[12];
    int len = 0, k = 0;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;

    do {
        tmp[k++] = (char)('0' + u % 10);
        u /= 10;
    } while (u != 0);
    if (v < 0)
        dst[len++] = '-';
    while (k > 0)
        dst[len++] = tmp[--k];
    dst[len] = '\0';
    return len;
}

static int32_t str_to_int(const char *s)
{
    bool neg = false;
    int32_t v = 0;

    if (*s == '-') {
        neg = true;
        s++;
    }
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return neg ? -v : v;
}

static void copy_part(char *dst, const char *src, int len)
{
    memcpy(dst, src, (size_t)len);
    dst[len] = '\0';
}

/* replace cnt characters at p by with */
static void replace(char *p, int cnt, const char *with)
{
    size_t wl = strlen(with);

    memmove(p + wl, p + cnt, strlen(p + cnt) + 1);
    memcpy(p, with, wl);
}

void scan(void)
{
    int32_t sum = 0, pos, moves, stops, speeds, others, k;
    int16_t i, spd;
    char *p, *q;
    char digits[12];
    size_t len;

    n++;

    /* 1. status telegrams */
    for (i = 0; i < 6; i++) {
        pos = (n * 37 + i * 1001) % 100000 - 20000;
        spd = (int16_t)((n + i * 13) % 120);
        strcpy(msg, names[i]);
        strcat(msg, " pos=");
        int_to_str(digits, pos);
        strcat(msg, digits);
        strcat(msg, " spd=");
        int_to_str(digits, spd);
        strcat(msg, digits);
        if (spd > 100)
            strcat(msg, " FAST");

        /* read the position back from the telegram */
        p = strstr(msg, "pos=");
        q = strstr(msg, " spd=");
        copy_part(num, p + 4, (int)(q - p - 4));
        len = strlen(msg);
        sum += str_to_int(num) + (int32_t)len;

        if (strcmp(msg, last_msg) > 0)
            sum += 1;
        if (strcmp(msg + len - 4, "FAST") == 0)
            sum += 100;
        strcpy(last_msg, msg);
    }

    /* 2. command line */
    strcpy(rest, cmds[n % 3]);
    moves = stops = speeds = others = 0;
    while (rest[0] != '\0') {
        p = strchr(rest, ';');
        if (p != NULL) {
            copy_part(tok, rest, (int)(p - rest));
            memmove(rest, p + 1, strlen(p + 1) + 1);
        } else {
            strcpy(tok, rest);
            rest[0] = '\0';
        }
        q = strchr(tok, ' ');
        if (q != NULL) {
            strcpy(arg, q + 1);
            *q = '\0';
        } else {
            arg[0] = '\0';
        }
        if (strcmp(tok, "MOVE") == 0)
            moves += str_to_int(arg + 2);
        else if (strcmp(tok, "SPEED") == 0)
            speeds += str_to_int(arg);
        else if (strcmp(tok, "STOP") == 0)
            stops++;
        else
            others += (int32_t)(strlen(tok) + strlen(arg));
    }

    /* 3. alarm text from a template */
    strcpy(alarm_text, "Alarm %n: %a over limit");
    p = strstr(alarm_text, "%n");
    int_to_str(digits, n % 1000);
    replace(p, 2, digits);
    p = strstr(alarm_text, "%a");
    replace(p, 2, names[n % 6]);
    if (n % 2 == 0) {
        memmove(alarm_text + 2, alarm_text, strlen(alarm_text) + 1);
        memcpy(alarm_text, "! ", 2);
    }
    k = (int32_t)(strstr(alarm_text, "over") - alarm_text) + 1;

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + moves * 3 + stops * 5 + speeds * 7
                      + others + (int32_t)strlen(alarm_text) * 11 + k));
}
