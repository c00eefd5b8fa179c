#include "st.h"
#include <string.h>
#include <stdio.h>
static const char *names[8] = { "Pump", "Valve", "Motor", "Heater", "Fan", "Mixer", "Conveyor", "Sensor" };
static int scans;
static int find(const char *s, const char *t) {
    const char *p = strstr(s, t);
    return p ? (int)(p - s) + 1 : 0;
}
static void num(char *d, int v) {
    char b[12]; int n = 0;
    do { b[n++] = '0' + v % 10; v /= 10; } while (v);
    while (n) *d++ = b[--n];
    *d = 0;
}
void scan(void) {
    scans++;
    int sum = 0;
    char s[81], t[81], u[81], m[4];
    size_t ul = 0;
    u[0] = 0;
    for (int i = 0; i < 8; i++) {
        strcpy(s, names[i]);
        strcat(s, "_");
        num(t, scans + i);
        strcat(s, t);
        size_t sl = strlen(s);
        sum += (int)sl + find(s, t);
        memcpy(m, s + 1, 3);
        m[3] = 0;
        if (strcmp(m, "ump") == 0 || strcmp(m, "oto") > 0) sum += 10;
        /* s with 3rd char replaced by XY, abc inserted after 2, first two deleted */
        memcpy(t, "abcXY", 5);
        strcpy(t + 5, s + 3);
        size_t tl = sl - 3 + 5;
        sum += find(t, "XY") + (int)tl;
        memcpy(u + ul, t, 4);
        memcpy(u + ul + 4, t + tl - 2, 2);
        ul += 6;
        u[ul] = 0;
        if (strcmp(s, names[(i + 1) % 8]) == 0) sum += 100;
    }
    sum += (int)ul + find(u, "1");
    check = (check + sum) % 1000000;
}
