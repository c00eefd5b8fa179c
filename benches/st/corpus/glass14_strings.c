/* Labels of the glass panes: written by the cutter, read again by the stacker */
#include "st.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int32_t serial = 100;
static char last[61];

void scan(void)
{
    uint32_t sum = 0;
    for (int n = 0; n < 4; n++) {
        serial += 37;
        if (serial > 999999)
            serial = 100;
        int line = serial % 9 + 1;
        int temp = serial % 613 - 40;
        const char *state = serial % 5 == 0 ? "REJECT" : "OK";

        char label[61];
        int len = snprintf(label, sizeof label, "L%d-%d/T%d;%s", line, (int)serial, temp, state);

        /* read it again, field by field */
        const char *dash = strchr(label, '-');
        sum = sum * 7u + (uint32_t)atoi(label + 1);
        sum = sum * 7u + (uint32_t)atoi(dash + 1);
        const char *t = strstr(dash + 1, "/T");
        sum = sum * 7u + (uint32_t)atoi(t + 2);
        if (strstr(t + 2, "REJECT")) {
            strcpy(label + len - 6, "SCRAP");
            len -= 1;
            sum += 1;
        } else {
            memmove(label + 2, label + 1, (size_t)len);
            label[1] = '*';
            len += 1;
        }
        if (strcmp(label, last) > 0)
            sum += 3;
        memcpy(last, label, (size_t)len + 1);
        const char *nine = strchr(label, '9');
        sum = sum * 7u + (uint32_t)len + (nine ? (uint32_t)(nine - label + 1) : 0u);
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
