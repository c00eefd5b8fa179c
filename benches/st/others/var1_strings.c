#include <string.h>
#include <stdbool.h>
#include "st.h"
static void dint_to_str(int32_t n, char *out)
{
    char tmp[12];
    int k = 0;
    uint32_t u = n < 0 ? 0u - (uint32_t)n : (uint32_t)n;
    do { tmp[k++] = (char)('0' + u % 10); u /= 10; } while (u);
    if (n < 0) *out++ = '-';
    while (k) *out++ = tmp[--k];
    *out = 0;
}
static void pad_int(char *out, int32_t n, int width)
{
    char s[16];
    dint_to_str(n, s);
    int len = (int)strlen(s);
    while (len < width) {
        memmove(s + 1, s, (size_t)len + 1);
        s[0] = '0';
        len++;
    }
    strcpy(out, s);
}
static int find(const char *s, const char *key)
{
    const char *p = strstr(s, key);
    return p ? (int)(p - s) + 1 : 0;
}
static void fill(char *out, const char *template_, const char *key, const char *value)
{
    const char *p = strstr(template_, key);
    if (p) {
        size_t before = (size_t)(p - template_);
        memcpy(out, template_, before);
        strcpy(out + before, value);
        strcat(out + before, p + strlen(key));
    } else {
        strcpy(out, template_);
    }
}
static const char *text[4] = {
    "Station %s: part %n finished in %t",
    "Alarm %n at %s since %t",
    "%t %s counter=%n",
    "Operator acknowledged %n (%s)" };
static const char *name[4] = { "Press", "Welder", "Paint shop", "Packing" };
static char log_[8][81];
static int32_t n;
void scan(void)
{
    char stamp[21], nr[21], a[81], b[81];
    n = (n + 7) % 86400;
    int32_t total = 0;
    for (int i = 0; i < 8; i++) {
        pad_int(stamp, n / 3600, 2);
        strcat(stamp, ":");
        pad_int(stamp + strlen(stamp), n / 60 % 60, 2);
        strcat(stamp, ":");
        pad_int(stamp + strlen(stamp), n % 60, 2);
        pad_int(nr, n * 3 + i, 6);
        fill(a, text[i % 4], "%s", name[(i + 1) % 4]);
        fill(b, a, "%n", nr);
        fill(a, b, "%t", stamp);
        if (i > 3) {
            memmove(a + 3, a, strlen(a) + 1);
            memcpy(a, ">> ", 3);
        }
        strcpy(log_[i], a);
        total += (int32_t)strlen(a) * (i + 1) + find(a, "4");
    }
    if (strncmp(log_[0], "Station", 7) == 0 && log_[3][strlen(log_[3]) - 1] == ')')
        total += 1;
    if (strcmp(log_[2], log_[6]) > 0)
        total += 2;
    check = (check % 100003) * 3 + total;
}
