/* Messages to the control room: eight telegrams a scan are put together,
   taken apart again and written as lines of the alarm list. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

#define DEVICES 8

static const char *const area[DEVICES] = {
    "NORTH", "SOUTH", "PORTAL", "CROSS1", "CROSS2", "SUMP", "SHAFT", "STATION"
};
static const char *const unit[DEVICES] = {
    "ppm", "ppm", "m/s", "1/km", "1/km", "cm", "m/s", "kW"
};

static uint32_t seed = 99;

static uint32_t hash(const char *s, uint32_t h)
{
    while (*s)
        h = h * 31u + (unsigned char)*s++;
    return h;
}

/* Copies n characters of src into dst, which holds size bytes. */
static void substr(char *dst, size_t size, const char *src, size_t n)
{
    if (n >= size)
        n = size - 1;
    memcpy(dst, src, n);
    dst[n] = '\0';
}

void scan(void)
{
    char telegram[81], line[81], last_line[81], tmp[81];
    char field[21], area_part[21];
    uint32_t sum = 17, alarms = 0, ascending = 0;

    last_line[0] = '\0';

    for (int i = 0; i < DEVICES; i++) {
        seed = seed * 1664525u + 1013904223u;
        int value = (int)((seed >> 16) % 2000) - 1000;

        /* Put the telegram together */
        snprintf(telegram, sizeof telegram, "TUN-%s;VAL=%d;UNIT=%s", area[i], value, unit[i]);

        /* Take it apart */
        const char *p = strstr(telegram, ";VAL=");
        const char *q = strstr(telegram, ";UNIT=");
        substr(field, sizeof field, p + 5, (size_t)(q - (p + 5)));
        int back = atoi(field);
        substr(area_part, sizeof area_part, telegram + 4, (size_t)(p - (telegram + 4)));

        /* Write the line of the alarm list */
        const char *text;
        if (back > 500) {
            text = "HIGH";
            alarms++;
        } else if (back < -500) {
            text = "LOW";
            alarms++;
        } else {
            text = "OK";
        }
        snprintf(line, sizeof line, "%s: %s %s %s", area_part, text, field, q + 6);

        if (strncmp(area_part, "CROSS", 5) == 0) {
            snprintf(tmp, sizeof tmp, "X-PASSAGE %s", line + 5);
            strcpy(line, tmp);
        } else if (strcmp(area_part, "SUMP") == 0) {
            snprintf(tmp, sizeof tmp, "%.4s LEVEL%s", line, line + 4);
            strcpy(line, tmp);
        } else {
            char *ok = strstr(line, "OK ");
            if (ok)
                memmove(ok, ok + 3, strlen(ok + 3) + 1);
        }

        if (strcmp(line, last_line) > 0)
            ascending++;
        strcpy(last_line, line);

        sum = hash(telegram, sum);
        sum = hash(line, sum);
        sum = sum * 31u + (uint32_t)back;
    }

    check = (int32_t)((sum * 31u + alarms) * 31u + ascending);
}
