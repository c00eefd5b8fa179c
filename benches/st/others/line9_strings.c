/* Telegrams between line control, label printer and scanner */
#include "st.h"
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

struct job {
    char article[21];
    char lot[13];
    int16_t quantity;
    int32_t weight;
};

enum telegram_result { TG_OK, TG_NO_FRAME, TG_UNKNOWN_ARTICLE, TG_BAD_QUANTITY };

struct parser {
    enum telegram_result result;
    int index, quantity;
};

static char articles[8][21] = {
    "BOX-SMALL", "BOX-LARGE", "TRAY", "LABEL-A4", "BOTTLE-500", "BOTTLE-1000", "CAN", "POUCH"
};
static struct job job;
static struct parser parser;
static char telegram[81], caption[81], last_name[81];
static int scans;

/* appends src at end, returns the new end */
static char *append(char *end, const char *src)
{
    size_t n = strlen(src);
    memcpy(end, src, n + 1);
    return end + n;
}

/* decimal text of v, returns its end */
static char *format_int(char *out, int32_t v)
{
    char tmp[12];
    int n = 0;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
    do {
        tmp[n++] = (char)('0' + u % 10);
        u /= 10;
    } while (u);
    if (v < 0)
        *out++ = '-';
    while (n)
        *out++ = tmp[--n];
    *out = '\0';
    return out;
}

/* value of a field KEY=value; within a text; "" if it's missing */
static void get_field(char *out, const char *text, const char *key)
{
    size_t n = strlen(key);
    char pattern[12];
    memcpy(pattern, key, n);
    pattern[n] = '=';
    pattern[n + 1] = '\0';
    const char *p = strstr(text, pattern);
    if (!p) {
        *out = '\0';
        return;
    }
    p += n + 1;
    const char *stop = strchr(p, ';');
    size_t len = stop ? (size_t)(stop - p) : strlen(p);
    memcpy(out, p, len);
    out[len] = '\0';
}

/* replaces the first occurrence of a placeholder, in place */
static void substitute(char *text, const char *marker, const char *value)
{
    char *p = strstr(text, marker);
    if (!p)
        return;
    size_t m = strlen(marker), v = strlen(value);
    memmove(p + v, p + m, strlen(p + m) + 1);
    memcpy(p, value, v);
}

static void format_weight(char *out, int32_t gram)
{
    char digits[12];
    size_t n = (size_t)(format_int(digits, gram) - digits);
    while (n < 4) {
        memmove(digits + 1, digits, n + 1);
        digits[0] = '0';
        n++;
    }
    memcpy(out, digits, n - 3);
    out[n - 3] = '.';
    memcpy(out + n - 2, digits + n - 3, 4);
}

static int32_t digit_sum(const char *text)
{
    int32_t sum = 0;
    for (int i = 0; text[i]; i++)
        if (text[i] >= '0' && text[i] <= '9')
            sum += (text[i] - '0') * (i + 1);
    return sum;
}

static void parse(struct parser *p, const char *tg)
{
    size_t n = strlen(tg);
    p->index = -1;
    p->quantity = 0;
    if (n < 3 || tg[0] != '<' || tg[n - 1] != '>') {
        p->result = TG_NO_FRAME;
        return;
    }
    char body[81], field[81];
    memcpy(body, tg + 1, n - 2);
    body[n - 2] = '\0';
    get_field(field, body, "ART");
    for (int i = 0; i < 8; i++) {
        if (strcmp(articles[i], field) == 0) {
            p->index = i;
            break;
        }
    }
    get_field(field, body, "QTY");
    p->quantity = atoi(field);
    if (p->index < 0)
        p->result = TG_UNKNOWN_ARTICLE;
    else if (p->quantity <= 0 || p->quantity > 400)
        p->result = TG_BAD_QUANTITY;
    else
        p->result = TG_OK;
}

static void add_check(int32_t v)
{
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)v);
}

void scan(void)
{
    static const int32_t result_code[] = { 1, 20, 300, 4000 };
    char weight[16];

    scans = (scans + 1) % 10000;
    char *end = append(job.article, articles[scans % 8]);
    if (scans % 13 == 0)
        append(end, "X");
    job.lot[0] = 'L';
    format_int(job.lot + 1, scans);
    job.quantity = (int16_t)(scans % 450);
    job.weight = scans * 7;

    end = append(telegram, "<ART=");
    end = append(end, job.article);
    end = append(end, ";QTY=");
    end = format_int(end, job.quantity);
    end = append(end, ";LOT=");
    end = append(end, job.lot);
    if (scans % 17 != 0)
        end = append(end, ">");
    parse(&parser, telegram);

    strcpy(caption, "%A / Lot %L / %W kg");
    substitute(caption, "%A", job.article);
    substitute(caption, "%L", job.lot);
    format_weight(weight, job.weight);
    substitute(caption, "%W", weight);

    add_check(digit_sum(caption));
    add_check((int32_t)(strlen(telegram) * 100 + strlen(caption)));
    add_check(parser.index * 1000 + parser.quantity);
    check = (int32_t)((uint32_t)check + (uint32_t)result_code[parser.result]);
    if (strcmp(job.article, last_name) > 0)
        add_check(5);
    strcpy(last_name, job.article);
}
