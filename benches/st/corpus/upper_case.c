#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include "st.h"

static const char *labels[6] = { "Feed pump 12", "main valve", "MIXER No. 4", "exit-conveyor", "Silo B, level high", "x" };
static char shown[6][256];
static int32_t scans;

static char *put_int(char *p, int32_t v)
{
    char b[12];
    int n = 0;
    do {
        b[n++] = '0' + v % 10;
        v /= 10;
    } while (v);
    while (n)
        *p++ = b[--n];
    *p = 0;
    return p;
}

static void to_upper(char *to, const char *from)
{
    while (*from) {
        char c = *from++;
        *to++ = c >= 'a' && c <= 'z' ? c - 32 : c;
    }
    *to = 0;
}

static void reverse(char *to, const char *from)
{
    size_t n = strlen(from);
    for (size_t i = 0; i < n; i++)
        to[i] = from[n - 1 - i];
    to[n] = 0;
}

static int capitals(const char *s)
{
    int n = 0;
    for (; *s; s++)
        n += *s >= 'A' && *s <= 'Z';
    return n;
}

void scan(void)
{
    char label[256], reversed[256];
    int32_t sum = 0;
    scans++;
    for (int i = 0; i < 6; i++) {
        size_t n = strlen(labels[i]);
        memcpy(label, labels[i], n);
        label[n] = ' ';
        put_int(label + n + 1, scans % 50);
        to_upper(shown[i], label);
        sum += capitals(shown[i]) * (i + 1);
        reverse(reversed, shown[i]);
        if (strcmp(reversed, shown[i]) > 0)
            sum += strlen(shown[i]);
    }
    check = (check * 3 + sum) % 1000003;
}
