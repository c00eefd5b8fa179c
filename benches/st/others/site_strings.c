/* Texts of a packing line: label and alarm texts are made, a telegram of the scale is taken apart. */
#define _GNU_SOURCE
#include <stdbool.h>
#include <string.h>
#include "st.h"

typedef struct {
    char article[21], lot[21], text[81];
    int32_t weight;
    bool valid;
} label_t;

static label_t label;
static char telegram[81], alarm_text[81], line[81], history[121], unit[11];
static int fields;
static bool error;
static int32_t scan_no;

/* writes a number with at least so many digits, returns the end */
static char *put_num(char *dst, int32_t value, int digits)
{
    char buf[12];
    int n = 0;
    uint32_t v = value < 0 ? 0u - (uint32_t)value : (uint32_t)value;

    do {
        buf[n++] = '0' + v % 10;
        v /= 10;
    } while (v);
    if (value < 0)
        buf[n++] = '-';
    while (n < digits)
        buf[n++] = '0';
    while (n)
        *dst++ = buf[--n];
    *dst = 0;
    return dst;
}

static int32_t get_num(const char *s)
{
    bool neg = *s == '-';
    int32_t v = 0;

    if (*s == '-' || *s == '+')
        s++;
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return neg ? -v : v;
}

static void copy_field(char *dst, size_t max, const char *src, size_t len)
{
    if (len > max)
        len = max;
    memcpy(dst, src, len);
    dst[len] = 0;
}

static void parse(const char *t, label_t *l)
{
    fields = 0;
    error = false;
    l->valid = false;
    while (*t && fields < 8) {
        const char *end = strchrnul(t, ';');
        size_t len = (size_t)(end - t);

        switch (fields) {
        case 0:
            error = len != 3 || memcmp(t, "WGT", 3) != 0;
            break;
        case 1:
            copy_field(l->article, 20, t, len);
            break;
        case 2:
            copy_field(l->lot, 20, t, len);
            break;
        case 3:
            l->weight = get_num(t);
            break;
        case 4:
            l->valid = len == 2 && memcmp(t, "OK", 2) == 0;
            break;
        }
        fields++;
        t = *end ? end + 1 : end;
    }
    if (fields != 5)
        error = true;
}

static int find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int)(p - s) + 1 : 0;
}

void scan(void)
{
    char *p;

    if (++scan_no > 90000)
        scan_no = 1;
    int32_t weight = scan_no * 7919 % 25000;

    /* telegram as the scale sends it */
    p = stpcpy(telegram, "WGT;ART-");
    p = put_num(p, scan_no % 500, 4);
    p = stpcpy(p, ";L");
    p = put_num(p, scan_no, 0);
    *p++ = ';';
    p = put_num(p, weight, 6);
    p = stpcpy(p, scan_no % 11 == 0 ? ";ERR" : ";OK");
    int tel_len = (int)(p - telegram);
    parse(telegram, &label);

    /* label: ART-0123 Lot L55 12.345 kg */
    if (label.weight >= 1000) {
        strcpy(unit, "kg");
        p = put_num(line, label.weight, 5);
        memmove(p - 2, p - 3, 4);
        p[-3] = '.';
    } else {
        strcpy(unit, "g");
        put_num(line, label.weight, 0);
    }
    p = stpcpy(label.text, label.article);
    p = stpcpy(p, " Lot ");
    p = stpcpy(p, label.lot);
    *p++ = ' ';
    p = stpcpy(p, line);
    *p++ = ' ';
    p = stpcpy(p, unit);
    int text_len = (int)(p - label.text);

    /* alarm text */
    if (error || !label.valid) {
        stpcpy(stpcpy(alarm_text, "Scale fault at "), label.lot);
    } else if (label.weight > 20000) {
        stpcpy(stpcpy(stpcpy(alarm_text, "Overweight "), line), unit);
    } else {
        alarm_text[0] = 0;
    }

    /* history: the newest text in front */
    size_t hist_len = strlen(history), alarm_len = strlen(alarm_text);
    if (alarm_len > 0) {
        if (hist_len + alarm_len >= 110 && hist_len > 60) {
            hist_len = 60;
            history[60] = 0;
        }
        memmove(history + alarm_len + 1, history, hist_len + 1);
        memcpy(history, alarm_text, alarm_len);
        history[alarm_len] = '|';
        hist_len += alarm_len + 1;
    }

    int32_t sum = tel_len + text_len * 3 + (int32_t)hist_len * 5 + fields;
    sum += find(history, "Over") + find(history, "fault") * 2;
    char part[5];
    copy_field(part, 4, label.text + 4, 4);
    sum += get_num(part);
    sum += get_num(label.lot + 1);
    if (memcmp(label.text + text_len - 2, "kg", 2) == 0)
        sum += 1000;
    if (strcmp(label.text + text_len - 5, "500 g") > 0)
        sum += 17;
    check = (int32_t)((uint32_t)check * 3u + (uint32_t)sum + (uint32_t)label.weight);
}
