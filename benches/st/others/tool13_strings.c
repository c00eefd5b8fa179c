#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

static const char *const names[4] = { "PUMP", "VALVE", "CONVEYOR", "OVEN" };
static int32_t tick;

void scan(void)
{
    int32_t sum = 0;
    for (int i = 0; i < 8; i++) {
        int32_t value = (tick * 37 + i * 1201) % 100000;
        char msg[81], key[21], field[21];

        size_t len = (size_t)snprintf(msg, sizeof msg, "ID=%s;VAL=%d;STATE=%s", names[i % 4],
                                      value, value % 3 == 0 ? "FAULT" : "OK");

        /* the name */
        char *eq = strchr(msg, '=');
        char *semi = strchr(msg, ';');
        size_t key_len = (size_t)(semi - eq - 1);
        memcpy(key, eq + 1, key_len);
        key[key_len] = '\0';
        if (strcmp(key, "VALVE") == 0)
            sum += 7;

        /* the value */
        char *rest = semi + 1;
        size_t rest_len = len - (size_t)(rest - msg);
        eq = strchr(rest, '=');
        semi = strchr(rest, ';');
        size_t field_len = (size_t)(semi - eq - 1);
        memcpy(field, eq + 1, field_len);
        field[field_len] = '\0';
        sum += atoi(field) * (int32_t)key_len;

        /* the state */
        if (rest_len >= 5 && strcmp(rest + rest_len - 5, "FAULT") == 0)
            sum += 100;

        char out[81];
        size_t out_len = 3;
        memcpy(out, rest, 3);
        memcpy(out + out_len, key, key_len);
        out_len += key_len;
        out[out_len++] = rest[3];
        out[out_len] = '\0';
        char *v = strchr(out, 'V');
        sum += (int32_t)out_len + (v ? (int32_t)(v - out) + 1 : 0);
    }
    tick = (tick + 1) % 10000;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
