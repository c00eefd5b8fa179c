#include "st.h"
#include <string.h>
#include <stdbool.h>
static const char *source[4] = { "the quick brown fox jumps over", "a lazy dog and runs away from it",
    "Lorem ipsum dolor sit amet", "one two three four five six seven" };
static int scans;
static unsigned str_hash(const char *s) {
    unsigned h = 5381;
    for (; *s; s++) h = (h * 33 + (unsigned char)*s) % 16777216;
    return h;
}
static int str_upper(char *s) {
    int changed = 0;
    for (; *s; s++)
        if (*s >= 'a' && *s <= 'z') { *s -= 32; changed++; }
    return changed;
}
static int str_reverse(char *s) {
    int i = 0, j = (int)strlen(s) - 1;
    while (i < j) { char c = s[i]; s[i++] = s[j]; s[j--] = c; }
    return j + 1;
}
static int word_count(const char *s) {
    int words = 0;
    bool inside = false;
    for (; *s; s++) {
        if (*s == ' ') inside = false;
        else if (!inside) { inside = true; words++; }
    }
    return words;
}
static void num(char *d, int v) {
    char b[12]; int n = 0;
    do { b[n++] = '0' + v % 10; v /= 10; } while (v);
    while (n) *d++ = b[--n];
    *d = 0;
}
void scan(void) {
    scans++;
    int acc = 0;
    char buf[81];
    for (int k = 0; k < 4; k++) {
        size_t n = strlen(source[k]);
        memcpy(buf, source[k], n);
        num(buf + n, scans);
        acc += word_count(buf);
        acc += str_upper(buf);
        acc += str_reverse(buf);
        acc += (int)(str_hash(buf) % 1000);
    }
    check = (check + acc) % 999983;
}
