/* String work: build 16 status lines, take them apart again, change some. */
#include "st.h"
#include <stdlib.h>
#include <string.h>

static const char *const names[8] = {"Tank", "Pump", "Valve", "Mixer", "Conveyor", "Heater", "Filter", "Boiler"};
static const char *const states[4] = {"OFF", "RUN", "WAIT", "FAULT"};
static int32_t n;

static void append_int(char *s, int v)
{
    char digits[12];
    int k = 0;
    unsigned u = v < 0 ? 0u - (unsigned)v : (unsigned)v;

    s += strlen(s);
    if (v < 0)
        *s++ = '-';
    do {
        digits[k++] = '0' + u % 10;
        u /= 10;
    } while (u);
    while (k > 0)
        *s++ = digits[--k];
    *s = '\0';
}

void scan(void)
{
    char line[81], rest[81], key[81], text[81], largest[81];
    int32_t sum = 0;
    char *p;

    n = (n + 1) % 10000;
    largest[0] = '\0';
    for (int i = 0; i < 16; i++) {
        int16_t value = (int16_t)((n * 17 + i * 53) % 2000 - 500);

        /* build */
        strcpy(line, names[i % 8]);
        strcat(line, " ");
        append_int(line, i + 1);
        strcat(line, ": value=");
        append_int(line, value);
        strcat(line, " state=");
        strcat(line, states[(n + i) % 4]);

        /* take apart */
        p = strchr(line, ':');
        memcpy(key, line, p - line);
        key[p - line] = '\0';
        p = strstr(line, "value=");
        strcpy(rest, p + 6);
        p = strchr(rest, ' ');
        memcpy(text, rest, p - rest);
        text[p - rest] = '\0';
        int16_t back = (int16_t)atoi(text);
        memmove(rest, p + 1, strlen(p + 1) + 1);
        size_t rest_len = strlen(rest);
        sum += back + (int32_t)rest_len * 3;

        /* compare */
        if (strcmp(key, largest) > 0)
            strcpy(largest, key);
        if (strcmp(rest + rest_len - 3, "RUN") == 0)
            sum += 7;
        else if (strcmp(rest, "state=OFF") == 0)
            sum += 11;

        /* change */
        p = strstr(line, "FAULT");
        if (p) {
            memcpy(p, "ALARM", 5);
            memmove(line + 3, line, strlen(line) + 1);
            memcpy(line, "!! ", 3);
        }
        sum += (int32_t)strlen(line);
    }
    if (strcmp(largest, "Valve 3") == 0)
        sum++;
    p = strchr(largest, ' ');
    sum += (p ? (int32_t)(p - largest) + 1 : 0) + (int32_t)strlen(largest);
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
