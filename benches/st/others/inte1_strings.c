/* Telegrams from the outstations and alarm texts for the SCADA */
#include <stdlib.h>
#include <string.h>
#include "st.h"

static int32_t scan_no;
static char name[11], num[11], tele[61], rest[61], msg[81], place[21], tmp[81];
static char last[8][81];
static const char places[8][21] = {"Reservoir North", "Pump station 2", "Tunnel portal W", "Well field",
                                   "Booster East", "Intake", "Tunnel portal E", "Sludge tank"};
static int32_t changes;

static void int_to_str(char *dst, int v)
{
    char buf[12];
    int i = 0;
    unsigned u = v < 0 ? -v : v;

    do {
        buf[i++] = '0' + u % 10;
        u /= 10;
    } while (u);
    if (v < 0)
        *dst++ = '-';
    while (i > 0)
        *dst++ = buf[--i];
    *dst = 0;
}

/* position from 1, 0 = not found */
static int find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int)(p - s) + 1 : 0;
}

static void mid(char *dst, const char *s, int len, int pos)
{
    int n = strlen(s) - (pos - 1);

    if (len > n)
        len = n;
    memcpy(dst, s + pos - 1, len);
    dst[len] = 0;
}

static void left(char *dst, const char *s, int len)
{
    mid(dst, s, len, 1);
}

/* in place: len characters from pos on give way to what */
static void replace(char *s, const char *what, int len, int pos)
{
    char *p = s + pos - 1;
    int n = strlen(what);

    memmove(p + n, p + len, strlen(p + len) + 1);
    memcpy(p, what, n);
}

static void insert(char *s, const char *what, int pos)
{
    replace(s, what, 0, pos + 1);
}

static void delete(char *s, int len, int pos)
{
    replace(s, "", len, pos);
}

void scan(void)
{
    int n, p, q;
    int16_t level, flow, rd_level, rd_flow;
    int32_t sum, sorted;

    scan_no++;
    sum = 0;

    for (n = 0; n < 8; n++) {
        /* the outstation builds its telegram: #RTU03;LVL=412;FLW=-7;OK* */
        level = (scan_no / 4 * 7 + n * 131) % 1000;
        flow = (scan_no / 8 * 13 + n * 57) % 240 - 20;
        int_to_str(num, n);
        strcpy(name, "RTU0");
        strcat(name, num);
        strcpy(tele, "#");
        strcat(tele, name);
        strcat(tele, ";LVL=");
        int_to_str(num, level);
        strcat(tele, num);
        strcat(tele, ";FLW=");
        int_to_str(num, flow);
        strcat(tele, num);
        if (flow < 0)
            strcat(tele, ";ERR*");
        else
            strcat(tele, ";OK*");

        /* the master takes it apart */
        rd_level = -1;
        rd_flow = -1;
        if (tele[0] == '#' && tele[strlen(tele) - 1] == '*') {
            p = find(tele, "LVL=");
            if (p > 0) {
                mid(rest, tele, 10, p + 4);
                q = find(rest, ";");
                left(tmp, rest, q - 1);
                rd_level = atoi(tmp);
            }
            p = find(tele, "FLW=");
            if (p > 0) {
                mid(rest, tele, (int)strlen(tele) - p - 3, p + 4);
                q = find(rest, ";");
                left(tmp, rest, q - 1);
                rd_flow = atoi(tmp);
            }
        }

        /* text for the event list */
        strcpy(place, places[n]);
        strcpy(msg, place);
        strcat(msg, ": level @ cm, flow % l/s");
        p = find(msg, "@");
        int_to_str(num, rd_level);
        replace(msg, num, 1, p);
        p = find(msg, "%");
        int_to_str(num, rd_flow);
        replace(msg, num, 1, p);
        if (find(tele, "ERR") > 0) {
            insert(msg, "FAULT ", 0);
        } else if (rd_level > 800) {
            insert(msg, " HIGH", find(msg, ":") - 1);
        } else if (rd_level < 100) {
            p = find(msg, ", flow");
            delete(msg, (int)strlen(msg) - p + 1, p);
        }

        /* only changes go into the list */
        if (strcmp(msg, last[n]) != 0) {
            strcpy(last[n], msg);
            changes++;
        }
        sum += rd_level + rd_flow * 3 + (int)strlen(msg) * 5 + (int)strlen(tele);
    }

    /* how many neighbours are in alphabetical order */
    sorted = 0;
    for (n = 0; n < 7; n++) {
        if (strcmp(last[n], last[n + 1]) < 0)
            sorted++;
    }

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(sum + sorted + changes));
}
