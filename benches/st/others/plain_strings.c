#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include "st.h"

static int32_t scans;

static int find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int)(p - s) + 1 : 0;
}

void scan(void)
{
    char msg[81], part[81], num[21], tmp[81];
    scans++;
    int32_t sum = 0;
    for (int i = 1; i <= 20; i++) {
        const char *name = i % 2 == 0 ? "Pump" : "Conveyor";
        sprintf(num, "%d", (int)(scans + i));
        strcpy(msg, name);
        strcat(msg, " ");
        strcat(msg, num);
        strcat(msg, ": running");
        int p = find(msg, ":");
        int len = strlen(msg);
        sum += len + p;
        memcpy(part, msg, p - 1);
        part[p - 1] = 0;
        if (strcmp(part, "Pump 100") == 0)
            sum += 1000;
        /* right 7, then replace its first three characters */
        strcpy(part, msg + len - 7);
        strcpy(tmp, "stopp");
        strcat(tmp, part + 3);
        strcpy(part, tmp);
        sum += strlen(part);
        /* mid 3 from 2, insert num after 1, delete 1 at 2 */
        memcpy(part, msg + 1, 3);
        part[3] = 0;
        memcpy(tmp, part, 1);
        strcpy(tmp + 1, num);
        strcat(tmp, part + 1);
        strcpy(part, tmp);
        memmove(part + 1, part + 2, strlen(part + 2) + 1);
        if (strcmp(part, "p") > 0)
            sum += strlen(part);
        sum += find(part, "m");
    }
    check = (check + sum) % 1000000;
}
