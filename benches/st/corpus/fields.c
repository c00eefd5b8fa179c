#include <stdlib.h>
#include <string.h>
#include "st.h"
static const char *lines[6] = {"pump, 12, 340, on", "valve, 7, -55, off", "mixer, 100, 8, on", "heater, 3, 2200, on", "belt, 45, 0, off", "fan, 9, +17, auto"};
static int32_t scans;
static void next(char *line, char *field)
{
    char *at = strstr(line, ", ");
    if (!at) {
        strcpy(field, line);
        line[0] = 0;
    } else {
        memcpy(field, line, at - line);
        field[at - line] = 0;
        memmove(line, at + 2, strlen(at + 2) + 1);
    }
}
void scan(void)
{
    int running = 0;
    for (int i = 0; i < 6; i++) {
        char rest[81], name[81], field[81];
        strcpy(rest, lines[(i + scans % 6) % 6]);
        next(rest, name);
        next(rest, field);
        int unit = atoi(field);
        next(rest, field);
        int32_t value = atoi(field);
        next(rest, field);
        if (!strcmp(field, "on")) {
            running++;
            check += unit * value;
        } else if (!strcmp(field, "off")) {
            check -= value;
        }
        if (strstr(name, "eat") || strcmp(name, "pomp") > 0)
            check += strlen(name);
    }
    check = check % 1000000 + running;
    scans++;
}
