#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"
static char line[101];
static int32_t scans;
static void field(char *to, const char *text, const char *name)
{
    char key[12];
    int length = strlen(name);
    memcpy(key, name, length);
    key[length] = '=';
    key[length + 1] = 0;
    const char *found = strstr(text, key);
    if (!found) {
        *to = 0;
        return;
    }
    found += length + 1;
    const char *end = strchr(found, ';');
    int count = end ? end - found : (int)strlen(found);
    if (count > 20)
        count = 20;
    memcpy(to, found, count);
    to[count] = 0;
}
void scan(void)
{
    float sum = 0;
    for (int i = 1; i <= 10; i++) {
        char t[21], p[21], n[21], x[21];
        int end = snprintf(line, sizeof line, "T=%g;P=%g", i * 2.25f, scans % 50 - 12.5f);
        snprintf(line + end, sizeof line - end, ";N=%d", i * 100);
        field(t, line, "T");
        field(p, line, "P");
        field(n, line, "N");
        field(x, line, "X");
        float temperature = strtof(t, 0), pressure = strtof(p, 0);
        int count = atoi(n);
        if (pressure >= 0 && !*x)
            sum = sum + temperature + pressure + count;
    }
    check += (int32_t)(sum * 4);
    scans++;
}
