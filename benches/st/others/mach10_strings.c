#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

static const char *const jobName[8] = {
    "Poster A1", "Label 12-up", "Carton blank", "Flyer DIN lang",
    "Catalogue cover", "Wallpaper 53", "Textile demo", "Test form"
};
static int32_t scanNo;

/* Append s; returns the new end. */
static char *put(char *d, const char *s)
{
    size_t n = strlen(s);
    memcpy(d, s, n + 1);
    return d + n;
}

/* Append v in decimal, filled with zeros to width. */
static char *put_int(char *d, int32_t v, int width)
{
    char tmp[16];
    int n = 0;
    bool neg = v < 0;
    uint32_t u = neg ? 0u - (uint32_t)v : (uint32_t)v;
    do {
        tmp[n++] = (char)('0' + u % 10);
        u /= 10;
    } while (u);
    if (neg) tmp[n++] = '-';
    while (n < width) tmp[n++] = '0';
    while (n > 0) *d++ = tmp[--n];
    *d = '\0';
    return d;
}

static int32_t field_value(const char *telegram, const char *key)
{
    const char *p = strstr(telegram, key);
    if (!p) return -1;
    p += strlen(key);
    const char *e = strchr(p, ';');
    if (!e || e == p) return -1;
    return (int32_t)strtol(p, NULL, 10);
}

static int find_char(const char *s, char c)
{
    const char *p = strchr(s, c);
    return p ? (int)(p - s) + 1 : 0;
}

static void add(int32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)v);
}

void scan(void)
{
    char telegram[81], name[25], shortName[25], line[81];

    if (++scanNo >= 9000) scanNo = 0;
    int job = scanNo % 8;
    int32_t speed = 3000 + scanNo * 7 % 9001;
    int32_t reg = scanNo % 401 - 200;
    int32_t temp = 200 + scanNo % 97;

    char *t = put(telegram, "REG=");
    t = put_int(t, reg, 0);
    t = put(t, ";SPD=");
    t = put_int(t, speed, 0);
    t = put(t, ";TMP=");
    t = put_int(t, temp, 5);
    t = put(t, ";");
    add(field_value(telegram, "SPD="));
    add(field_value(telegram, "REG="));
    add(field_value(telegram, "TMP="));
    add(field_value(telegram, "INK="));
    add((int32_t)(t - telegram));

    strcpy(name, jobName[job]);
    strcpy(shortName, name);
    char *blank = strchr(name, ' ');
    if (blank) {
        shortName[blank - name] = '\0';
        *blank = '_';
    }
    size_t len = strlen(name);
    if (job % 2 == 1) {
        memmove(name + 4, name + 3, len - 3 + 1);
        name[3] = '#';
    } else {
        memmove(name + 1, name + 2, len - 2 + 1);
    }
    if (strncmp(name, "Te", 2) == 0)
        check = (int32_t)((uint32_t)check + 17u);

    char *l = put(line, shortName);
    l = put(l, ": ");
    l = put(l, name);
    l = put(l, " @ ");
    l = put_int(l, speed, 6);
    l = put(l, "/h");
    int at = find_char(line, '@');
    add((int32_t)(l - line));
    add(at);
    add(find_char(line, '#'));
    add((int32_t)strtol(line + at + 1, NULL, 10));

    const char *first = name;
    int smaller = 0;
    for (int i = 0; i < 8; i++) {
        if (strcmp(jobName[i], name) < 0) smaller++;
        if (strcmp(jobName[i], first) < 0) first = jobName[i];
    }
    add(smaller * 100 + (int32_t)strlen(first));
    if (strcmp(first, name) != 0)
        check = (int32_t)((uint32_t)check + 1u);
}
