#include "st.h"
#include <stdio.h>
#include <string.h>
#include <stdbool.h>
static char log_[10][81];
static int scans;

static char *put_int(char *p, int v) {
    char b[12]; int n = 0;
    do { b[n++] = '0' + v % 10; v /= 10; } while (v);
    while (n) *p++ = b[--n];
    *p = 0;
    return p;
}
static void message_text(char *m, int station, int part, bool good) {
    strcpy(m, "Station ");
    m += 8;
    if (station < 10) *m++ = '0';
    m = put_int(m, station);
    strcpy(m, ": part ");
    m = put_int(m + 7, part);
    strcpy(m, good ? " ok" : " rejected");
}
static int count_char(const char *s, char c) {
    int n = 0;
    for (; *s; s++) n += *s == c;
    return n;
}
void scan(void) {
    scans++;
    int lengths = 0, blanks = 0, places = 0, equal = 0;
    for (int i = 1; i <= 10; i++) {
        char m[81], t[81];
        message_text(m, i, (scans * 7 + i) % 10000, (scans + i) % 3 != 0);
        blanks += count_char(m, ' ');
        int pos = (int)(strstr(m, "part") - m) + 1;
        places += pos;
        /* remove "part " */
        memmove(m + pos - 1, m + pos + 4, strlen(m + pos + 4) + 1);
        /* "Station" -> "St.", then '#' after four characters */
        memcpy(t, "St. #", 5);
        strcpy(t + 5, m + 8);
        int len = (int)strlen(t);
        if (strcmp(t + len - 2, "ok") == 0) { len -= 3; t[len] = 0; }
        if (strcmp(t, log_[i - 1]) == 0) equal++;
        strcpy(log_[i - 1], t);
        lengths += len;
    }
    check = (check + lengths + 3 * blanks + 5 * places + equal) % 1000003;
}
