#include "st.h"
#include <string.h>

static const char names[8][21] = {
    "Mixer", "Pump", "Conveyor", "Boiler", "Valve", "Dryer", "Feeder", "Packer"
};
static char msg[81], line[81], part[81], key[81], txt[81];
static int16_t n;

static void int_to_str(char *dst, int v)
{
    char buf[8];
    int k = 0;

    if (v < 0) {
        *dst++ = '-';
        v = -v;
    }
    do {
        buf[k++] = (char)('0' + v % 10);
        v /= 10;
    } while (v);
    while (k)
        *dst++ = buf[--k];
    *dst = 0;
}

static int str_to_int(const char *s)
{
    int neg = 0, v = 0;

    if (*s == '-') {
        neg = 1;
        s++;
    }
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return neg ? -v : v;
}

/* 1-based position, 0 if absent */
static int find(const char *s, const char *t)
{
    const char *p = strstr(s, t);
    return p ? (int)(p - s) + 1 : 0;
}

/* take len characters from 1-based pos */
static void mid(char *dst, const char *s, int len, int pos)
{
    int l = (int)strlen(s);

    if (pos > l || len <= 0) {
        dst[0] = 0;
        return;
    }
    if (len > l - pos + 1)
        len = l - pos + 1;
    memmove(dst, s + pos - 1, (size_t)len);
    dst[len] = 0;
}

/* replace len characters from 1-based pos in s by t, in place */
static void replace(char *s, const char *t, int len, int pos)
{
    size_t tl = strlen(t);
    size_t sl = strlen(s);

    memmove(s + pos - 1 + tl, s + pos - 1 + len, sl - (size_t)(pos - 1 + len) + 1);
    memcpy(s + pos - 1, t, tl);
}

void scan(void)
{
    int i, p, p2, temp;
    int32_t sum = 0;
    char num[8];

    n++;
    if (n > 9999)
        n = 0;
    for (i = 0; i < 8; i++) {
        /* build a telegram */
        int_to_str(num, n);
        strcpy(line, "ID=");
        strcat(line, num);
        strcat(line, ";NAME=");
        strcat(line, names[i]);
        strcat(line, ";TEMP=");
        int_to_str(num, (int16_t)(n * 3 + i * 17) % 400 - 50);
        strcat(line, num);
        strcat(line, ";END");
        sum += (int32_t)strlen(line);

        /* take it apart again */
        p = find(line, "NAME=");
        mid(part, line, (int)strlen(line) - p - 4, p + 5);
        p2 = find(part, ";");
        mid(key, part, p2 - 1, 1);
        if (strcmp(key, names[i]) == 0)
            sum += 1;
        if (strcmp(key, "Dryer") > 0)
            sum += 2;
        p = find(line, "TEMP=");
        strcpy(part, line + p + 4);
        mid(part, part, find(part, ";") - 1, 1);
        temp = str_to_int(part);
        sum += temp;

        /* edit an operator message */
        strcpy(msg, "Station # reports: state ok, level normal");
        p = find(msg, "#");
        replace(msg, key, 1, p);
        if (temp > 200) {
            p = find(msg, "ok");
            replace(msg, "OVERTEMP", 2, p);
        } else if (temp < 0) {
            p = find(msg, ", level");
            replace(msg, "", 14, p);
        } else {
            replace(msg, "now ", 0, find(msg, "state"));
        }
        sum += (int32_t)strlen(msg) * 3 + find(msg, "level");
        if (strncmp(msg, "Station", 7) == 0)
            sum += 5;
        if (i == 5)
            strcpy(txt, msg);
    }
    if (find(txt, "OVERTEMP") > 0)
        sum += 1000;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
