#include "st.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char chars[] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ-. */+%";
static const char *const names[5] = { "FRESH MILK 3.5%", "YOGURT MILD", "CREAM 30%", "BUTTERMILK", "APPLE JUICE" };

struct label { char product[21], batch[13], line[81], check; };
struct parsed { char product[41]; int32_t batch, litres; int16_t line; };

static struct label label;
static struct parsed parsed;
static char old[81];
static int32_t scans;

/* Decimal digits of a number that is not negative, with at least WIDTH digits; returns the end. */
static char *put_number(char *p, int32_t n, int width)
{
    char digits[12];
    int len = 0;
    do {
        digits[len++] = (char)('0' + n % 10);
        n /= 10;
    } while (n > 0);
    while (len < width)
        digits[len++] = '0';
    while (len > 0)
        *p++ = digits[--len];
    *p = 0;
    return p;
}

static char *put_text(char *p, const char *s)
{
    size_t len = strlen(s);
    memcpy(p, s, len + 1);
    return p + len;
}

static char code39(const char *s)
{
    int sum = 0;
    for (; *s; s++) {
        const char *p = strchr(chars, *s);
        if (p)
            sum += (int)(p - chars);
    }
    return chars[sum % 43];
}

static void build(struct label *l, int32_t no, int32_t litres, int line)
{
    l->batch[0] = 'B';
    put_number(l->batch + 1, no, 7);

    char *p = put_text(l->line, l->product);
    *p++ = ';';
    p = put_text(p, l->batch);
    *p++ = ';';
    p = put_number(p, litres, 1);
    p = put_text(p, ";L");
    p = put_number(p, line, 1);

    char *milk = strstr(l->line, "MILK");
    if (milk) {
        memmove(milk + 5, milk + 4, strlen(milk + 4) + 1);
        memcpy(milk, "DRINK", 5);
    }
    l->check = code39(l->line);
}

static void parse(struct parsed *r, const char *s)
{
    const char *end = strchr(s, ';');
    memcpy(r->product, s, (size_t)(end - s));
    r->product[end - s] = 0;
    s = end + 2;                               /* behind the B */
    r->batch = (int32_t)strtol(s, NULL, 10);
    s = strchr(s, ';') + 1;
    r->litres = (int32_t)strtol(s, NULL, 10);
    s = strchr(s, ';') + 2;                    /* behind the L */
    r->line = (int16_t)strtol(s, NULL, 10);
}

void scan(void)
{
    uint32_t sum = (uint32_t)check;
    scans++;
    for (int i = 0; i < 3; i++) {
        int32_t no = (scans * 37 + i) % 1000000;
        int32_t litres = (scans * 53 + i * 400) % 25000;
        strcpy(label.product, names[(scans + i) % 5]);
        build(&label, no, litres, i + 8);
        parse(&parsed, label.line);
        sum = sum * 31 + (uint32_t)(parsed.batch + parsed.litres + parsed.line);
        sum += (uint32_t)(strlen(label.line) + strlen(parsed.product));
        if (strcmp(label.line, old) > 0)
            sum += 1;
        if (label.check == 'A' || label.check == '7')
            sum += 77;
        sum += (uint32_t)(strchr(chars, label.check) - chars) + 1;
        strcpy(old, label.line);
    }
    check = (int32_t)sum;
}
