#include "st.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int32_t scans;
static char clock_text[9], line[81], telegram[81], command[21], par1[21], par2[21], rest[81], masked[81];

static int find(const char *text, const char *what)
{
    const char *p = strstr(text, what);
    return p ? (int)(p - text) + 1 : 0;
}

void scan(void)
{
    scans++;
    int32_t n = 0;
    const char *state = "";

    snprintf(clock_text, sizeof clock_text, "%02d:%02d:%02d", scans / 3600 % 24, scans / 60 % 60, scans % 60);

    for (int tank = 1; tank <= 6; tank++) {
        int level = (scans * 7 + tank * 131) % 1000;
        if (level > 800)
            state = "HIGH";
        else if (level < 150)
            state = "LOW";
        else
            state = "normal";
        int len = snprintf(line, sizeof line, "%s Tank %d: level %d mm %s", clock_text, tank, level, state);
        n += len + find(line, "HIGH") * 3;
        if (!strcmp(state, "LOW"))
            n += 11;
    }

    snprintf(telegram, sizeof telegram, "SET;valve%d;%d;END", scans % 40, scans * 13 % 5000);

    char *p = strchr(telegram, ';');
    memcpy(command, telegram, p - telegram);
    command[p - telegram] = 0;
    strcpy(rest, p + 1);
    p = strchr(rest, ';');
    memcpy(par1, rest, p - rest);
    par1[p - rest] = 0;
    memmove(rest, p + 1, strlen(p + 1) + 1);
    p = strchr(rest, ';');
    memcpy(par2, rest, p - rest);
    par2[p - rest] = 0;
    int value = atoi(par2);
    if (!strcmp(command, "SET"))
        n += value + (int)strlen(par1);

    masked[0] = '<';
    memcpy(masked + 1, telegram, 4);
    memcpy(masked + 5, "****", 4);
    strcpy(masked + 9, telegram + 7);
    if (strcmp(masked, line) > 0)
        n++;
    n += (int)strlen(masked) + find(masked, "END");
    check += n;
}
