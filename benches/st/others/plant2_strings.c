#include <string.h>
#include "st.h"

static const char *const recipe[8] = { "Almond Bar", "Apple Juice", "Cereal Box", "Dark Chocolate",
                                       "Green Tea", "Honey Nut", "Milk 1L", "Water 0.5L" };
static int32_t nscan;

/* Append a text; gives the new end. The buffers are large enough for all texts that come. */
static char *put(char *d, const char *s)
{
    size_t n = strlen(s);
    memcpy(d, s, n + 1);
    return d + n;
}

/* Append a number with at least the given digits (numbers are not negative). */
static char *put_pad(char *d, int32_t v, int digits)
{
    char t[12];
    int n = 0;
    do {
        t[n++] = (char)('0' + v % 10);
        v /= 10;
    } while (v);
    while (n < digits) t[n++] = '0';
    while (n > 0) *d++ = t[--n];
    *d = 0;
    return d;
}

static size_t field(char *out, const char *text, const char *tag)
{
    const char *p = strstr(text, tag);
    *out = 0;
    if (!p) return 0;
    p += strlen(tag);
    const char *q = strchr(p, ';');
    size_t n = q ? (size_t)(q - p) : strlen(p);
    memcpy(out, p, n);
    out[n] = 0;
    return n;
}

static int find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int)(p - s) + 1 : 0;
}

static uint32_t lane(int32_t job, uint32_t hash)
{
    char label[101], msg[101], alarm[81], prod[31], lot[31], best[31];

    char *e = put(label, "PROD=");
    e = put(e, recipe[job % 8]);
    e = put(e, ";LOT=L");
    e = put_pad(e, job * 7 % 1000000, 6);
    e = put(e, ";LINE=");
    e = put_pad(e, job % 12 + 1, 2);
    e = put(e, ";BEST=2026-");
    e = put_pad(e, job % 12 + 1, 2);
    e = put(e, "-");
    e = put_pad(e, job % 28 + 1, 2);
    hash += (uint32_t)(e - label);

    field(prod, label, "PROD=");
    size_t nlot = field(lot, label, "LOT=");
    field(best, label, "BEST=");
    int found = -1;
    for (int n = 0; n < 8; n++) {
        int c = strcmp(recipe[n], prod);
        if (c == 0) found = n;
        if (c < 0) hash += 3;
    }
    hash = hash * 31 + (uint32_t)found;
    if (nlot >= 2 && strcmp(lot + nlot - 2, "77") == 0) hash += 1000;
    if (strncmp(best + 5, "06", 2) > 0) hash += 500;
    if (strncmp(lot, "L000", 4) == 0) hash += 50;

    /* alarm text: the pattern with the number and the product in it */
    static const char pattern[] = "Station ##: reject of @ by checkweigher";
    const char *h = strstr(pattern, "##");
    memcpy(alarm, pattern, (size_t)(h - pattern));
    e = put_pad(alarm + (h - pattern), job % 50, 2);
    e = put(e, h + 2);
    const char *at = strchr(alarm, '@');
    size_t pre = (size_t)(at - alarm);
    memcpy(msg, alarm + 8, pre - 8); /* without "Station " */
    e = put(msg + pre - 8, prod);
    e = put(e, " lot ");
    e = put(e, lot);
    e = put(e, at + 1);
    hash = hash * 31 + (uint32_t)(e - msg) + (uint32_t)find(msg, "by") * 7 + (uint32_t)find(msg, "xyz");
    if (strcmp(msg, label) > 0) hash += 17;
    return hash;
}

void scan(void)
{
    nscan++;
    uint32_t hash = 0;
    for (int i = 1; i <= 4; i++)
        hash = lane(nscan * 4 + i, hash);
    check = (int32_t)((uint32_t)check * 31u + hash);
}
