#include <string.h>
#include <stdbool.h>
#include "st.h"
static char hex_digit(int n)
{
    static const char digits[] = "0123456789ABCDEF";
    return digits[n];
}
static int hex_value(char c)
{
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return 0;
}
static void to_upper(char *out, const char *s)
{
    strcpy(out, s);
    for (; *out; out++)
        if (*out >= 'a' && *out <= 'z')
            *out = (char)(*out - 32);
}
static int word_count(const char *s)
{
    int n = 0;
    bool inside = false;
    for (; *s; s++) {
        if (*s == ' ') {
            inside = false;
        } else if (!inside) {
            inside = true;
            n++;
        }
    }
    return n;
}
static void reverse(char *out, const char *s)
{
    strcpy(out, s);
    int i = 0, j = (int)strlen(s) - 1;
    while (i < j) {
        char c = out[i];
        out[i] = out[j];
        out[j] = c;
        i++;
        j--;
    }
}
static const char *text[5] = {
    "the quick brown fox jumps over the lazy dog",
    "Pressure in vessel 3 is too high",
    "never odd or even",
    "Batch 17 of recipe Vanilla started by operator Jones",
    "ok" };
static int16_t scan_no;
void scan(void)
{
    char up[81], back[81], telegram[81];
    scan_no = (int16_t)((scan_no + 1) % 256);
    int32_t total = 0;
    for (int n = 0; n < 5; n++) {
        to_upper(up, text[n]);
        reverse(back, up);
        int words = word_count(up);
        int cmp = strcmp(back, up);
        if (cmp == 0)
            total += 100;
        else if (cmp < 0)
            total += 10;
        int sum = 0, len = 0;
        for (int i = 0; i < 16; i++) {
            int v = (scan_no * 3 + i * 17 + n * 5) % 256;
            sum = (sum + v) % 256;
            telegram[len++] = hex_digit(v / 16);
            telegram[len++] = hex_digit(v % 16);
        }
        telegram[len] = 0;
        for (int i = 0; i < 16; i++) {
            int k = hex_value(telegram[2 * i]) * 16 + hex_value(telegram[2 * i + 1]);
            sum = (sum + 256 - k) % 256;
            total += k * (i + 1);
        }
        if (sum != 0)
            total = -1;
        const char *e = strchr(up, 'E');
        total += words * 3 + (e ? (int)(e - up) + 1 : 0) + back[0];
    }
    check = (check % 100003) * 3 + total;
}
