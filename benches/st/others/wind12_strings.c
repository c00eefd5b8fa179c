#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

static const char *const code[6] = {"STOP", "IDLE", "STARTUP", "PRODUCTION", "RIDE-THROUGH", "FAULT"};
static char events[8][61];
static int32_t n;

/* The text behind key, up to the next semicolon. */
static void get_field(char *out, size_t size, const char *telegram, const char *key)
{
    out[0] = '\0';
    const char *p = strstr(telegram, key);
    if (!p)
        return;
    p += strlen(key);
    const char *q = strchr(p, ';');
    size_t len = q ? (size_t)(q - p) : strlen(p);
    if (len >= size)
        len = size - 1;
    memcpy(out, p, len);
    out[len] = '\0';
}

void scan(void)
{
    char telegram[121] = "", reply[121], name[21], field[41];
    uint32_t sum = 0;

    n++;
    for (int k = 0; k < 4; k++) {
        int32_t id = (int32_t)((uint32_t)n * 7u + k * 31) % 120;
        int32_t power = (int32_t)((uint32_t)n * 37u + id * 11) % 4200 - 150;
        int32_t pitch = (n + id) % 91;

        int name_len = snprintf(name, sizeof name, "WTG%d", (int)id);
        snprintf(telegram, sizeof telegram, "%s;ST=%s;P=%d;B=%d;", name, code[(n + k) % 6], (int)power, (int)pitch);

        get_field(field, sizeof field, telegram, ";P=");
        sum = sum * 3 + (uint32_t)atoi(field);
        get_field(field, sizeof field, telegram, ";B=");
        sum = sum * 3 + (uint32_t)atoi(field);
        get_field(field, sizeof field, telegram, ";ST=");
        if (strcmp(field, "FAULT") == 0 || strcmp(field, "STOP") == 0) {
            snprintf(reply, sizeof reply, "ACK!%s", telegram + 3);
        } else if (strlen(field) > 8) {
            snprintf(reply, sizeof reply, "%s", telegram + name_len + 1);
        } else {
            snprintf(reply, sizeof reply, "%.12s", telegram + 3);
        }
        const char *p = strstr(reply, "P=");
        sum = sum * 3 + (uint32_t)strlen(reply) + (p ? (uint32_t)(p - reply) + 1 : 0) * 5;

        snprintf(events[(n + k) % 8], sizeof events[0], "%.24s/%s", reply, field);
    }

    int hits = 0;
    for (int i = 0; i < 8; i++) {
        if (strstr(events[i], "RIDE"))
            hits++;
        sum = sum * 3 + (uint32_t)strlen(events[i]);
        if (strcmp(events[i], telegram) > 0)
            sum++;
    }
    check = (int32_t)((uint32_t)check * 31u + sum + hits);
}
