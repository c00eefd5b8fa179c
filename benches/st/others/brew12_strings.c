/* Bottle labels: build, check and take apart lot codes. */
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

#define LABEL_MAX 81
#define BEER_MAX 17

struct label {
    char text[LABEL_MAX];
    int32_t digit;
};

struct parsed {
    bool ok;
    int32_t lot, day;
    int16_t tank;
    char beer[BEER_MAX];
};

static const char *const beers[] = {"PILS", "HELLES", "WEIZEN", "MAERZEN", "ALKOHOLFREI"};
static struct parsed parsed;
static char last[LABEL_MAX];
static int32_t lot = 1000;

static int32_t check_digit(const char *s, size_t len)
{
    int32_t sum = 104;
    for (size_t i = 0; i < len; i++)
        sum += (int32_t)(i + 1) * (unsigned char)s[i];
    return sum % 103;
}

static void build(struct label *l, int32_t lot_no, int tank, const char *beer, int32_t day)
{
    int n = snprintf(l->text, sizeof l->text, "L%06d;T%02d;%s;BB%03d", lot_no, tank, beer, day);
    l->digit = check_digit(l->text, (size_t)n);
    snprintf(l->text + n, sizeof l->text - (size_t)n, "#%d", l->digit);
}

static void parse(struct parsed *p, const char *label)
{
    const char *t = strstr(label, ";T");
    const char *d = strstr(label, ";BB");
    const char *hash = strchr(label, '#');

    p->ok = label[0] == 'L' && t && d && hash && d > t && hash > d;
    if (!p->ok)
        return;
    p->lot = (int32_t)strtol(label + 1, NULL, 10);
    p->tank = (int16_t)strtol(t + 2, NULL, 10);
    const char *beer = t + 5;
    size_t n = (size_t)(d - beer);
    if (n >= sizeof p->beer)
        n = sizeof p->beer - 1;
    memcpy(p->beer, beer, n);
    p->beer[n] = '\0';
    p->day = (int32_t)strtol(d + 3, NULL, 10);
    p->ok = strtol(hash + 1, NULL, 10) == check_digit(label, (size_t)(hash - label));
}

void scan(void)
{
    uint32_t sum = 0;
    for (int i = 0; i < 4; i++) {
        struct label l;
        lot = (lot + 7) % 1000000;
        build(&l, lot, lot % 48 + 1, beers[lot % 5], lot % 365 + 1);
        parse(&parsed, l.text);

        sum = sum * 31u + (uint32_t)(l.digit + parsed.lot + parsed.day * 3);
        if (parsed.ok)
            sum += (uint32_t)parsed.tank * 5u + (uint32_t)strlen(parsed.beer);
        if (strcmp(l.text, last) > 0)
            sum++;
        memcpy(last, l.text, sizeof last);

        /* line on the operator panel, without the last digit */
        char print[LABEL_MAX];
        const char *t = strstr(l.text, ";T");
        int n = snprintf(print, sizeof print, "LOT %.*s TANK %s", (int)(t - l.text - 1), l.text + 1, t + 2);
        print[--n] = '\0';
        sum = sum * 3u + (uint32_t)check_digit(print, (size_t)n);
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
