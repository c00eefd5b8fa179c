#include <stdio.h>
#include <string.h>
#include "st.h"
#include "digits.h"
static char names[16][25];
static const char *kinds[4] = {"Pump", "Valve", "Motor", "Mixer"};
static int32_t scans;
void scan(void)
{
    for (int i = 0; i < 16; i++) {
        int k = (scans * 5 + i * 7) % 16;
        int length = strlen(kinds[k % 4]);
        memcpy(names[i], kinds[k % 4], length);
        names[i][length] = '_';
        digits(k * 37, names[i] + length + 1);
    }
    for (int i = 1; i < 16; i++) {
        char moved[25];
        strcpy(moved, names[i]);
        int k = i - 1;
        for (; k >= 0 && strcmp(names[k], moved) > 0; k--)
            strcpy(names[k + 1], names[k]);
        strcpy(names[k + 1], moved);
    }
    int found = -1;
    for (int i = 0; i < 16; i++) {
        if (!strcmp(names[i], "Motor_222"))
            found = i;
        if (!strncmp(names[i], "Pump", 4))
            check += i;
    }
    check += found + (int)strlen(names[0]) * 3 + (int)strlen(names[15]);
    scans++;
}
