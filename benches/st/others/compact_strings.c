#include "st.h"
#include <string.h>

static const char alphabet[] = "abcdefghijklmnopqrstuvwxyz";
static uint32_t seed = 3;
static char text[65], back[65], both[132];

static void reverse(char *dst, const char *src)
{
    size_t n = strlen(src);
    for (size_t i = 0; i < n; i++)
        dst[i] = src[n - 1 - i];
    dst[n] = 0;
}

static int count_of(const char *s, const char *what)
{
    int n = 0;
    size_t len = strlen(what);
    while ((s = strstr(s, what))) {
        n++;
        s += len;
    }
    return n;
}

void scan(void)
{
    int i;
    for (i = 0; i < 40; i++) {
        seed = (seed * 25173 + 13849) % 65536;
        text[i] = alphabet[seed / 256 % 6];
    }
    text[i] = 0;
    reverse(back, text);
    strcpy(both, text);
    strcat(both, "-");
    strcat(both, back);
    int len = (int)strlen(both);
    int32_t hash = len;
    for (i = 0; i < len; i++) {
        const char *p = strchr(alphabet, both[i]);
        hash = (hash * 3 + (p ? (int)(p - alphabet) + 1 : 0)) % 100003;
    }
    hash += count_of(text, "ab") * 100 + count_of(back, "ab") * 10;
    char *p = strstr(both, "cd");
    int pos = 0;
    if (p) {
        pos = (int)(p - both) + 1;
        memmove(p + 3, p + 2, strlen(p + 2) + 1);
        memcpy(p, "XYZ", 3);
    }
    if (strcmp(text, back) < 0)
        hash += 1;
    else if (!strncmp(text, back + strlen(back) - 3, 3))
        hash += 2;
    check = (check + hash + (int)strlen(both) * pos) % 1000000;
}
