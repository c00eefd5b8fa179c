/* Label printing: EAN code with check digit, label text, and reading it back */
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

typedef struct {
    char name[21];
    char ean[14];
    char text[61];
    int32_t lot;
} label_t;

typedef struct {
    char name[21];
    int32_t lot, ean_tail;
    bool ok;
} read_t;

static const char *const product[4] = {"Cereal", "DarkChocolate", "Tea", "PeanutButter"};
static label_t label[4];
static int32_t scan_no;

/* Writes a number with leading zeros; returns the end. */
static char *put_number(char *p, uint32_t value, int width)
{
    char digits[12];
    int n = 0;
    do {
        digits[n++] = (char)('0' + value % 10);
        value /= 10;
    } while (value);
    while (n < width)
        digits[n++] = '0';
    while (n > 0)
        *p++ = digits[--n];
    *p = '\0';
    return p;
}

static char *put_text(char *p, const char *s)
{
    size_t n = strlen(s);
    memcpy(p, s, n + 1);
    return p + n;
}

static int ean_digit(const char *code)
{
    int sum = 0;
    for (int i = 0; i < 12; i++) {
        int d = code[i] - '0';
        sum += i % 2 ? 3 * d : d;
    }
    return (10 - sum % 10) % 10;
}

static int32_t get_number(const char *s, int n)
{
    int32_t v = 0;
    for (int i = 0; i < n && s[i] >= '0' && s[i] <= '9'; i++)
        v = v * 10 + (s[i] - '0');
    return v;
}

static void write_label(label_t *l, int32_t article)
{
    char *p = put_text(l->ean, "590");
    p = put_number(p, (uint32_t)article, 9);
    p[0] = (char)('0' + ean_digit(l->ean));
    p[1] = '\0';

    p = put_text(l->text, l->name);
    p = put_text(p, ";EAN=");
    p = put_text(p, l->ean);
    p = put_text(p, ";LOT=");
    p = put_number(p, (uint32_t)l->lot, 6);
    put_text(p, ";");
}

static void read_label(read_t *r, const char *text)
{
    r->ok = false;
    const char *semi = strchr(text, ';');
    if (!semi || semi == text)
        return;
    size_t n = (size_t)(semi - text);
    memcpy(r->name, text, n);
    r->name[n] = '\0';

    const char *ean = strstr(semi + 1, "EAN=");
    if (!ean)
        return;
    ean += 4;
    size_t ean_len = strnlen(ean, 13);
    r->ean_tail = get_number(ean + ean_len - 8, 8);
    const char *lot = strstr(semi + 1, "LOT=");
    if (!lot)
        return;
    r->lot = get_number(lot + 4, 6);
    r->ok = ean_len == 13;
}

void scan(void)
{
    static read_t reader;
    scan_no = (scan_no + 1) % 100000;

    uint32_t sum = 0;
    for (int i = 0; i < 4; i++) {
        label_t *l = &label[i];
        strcpy(l->name, product[(i + scan_no % 4) % 4]);
        l->lot = (scan_no * 17 + i) % 1000000;
        write_label(l, scan_no * 1237 + i * 100003);
        read_label(&reader, l->text);

        /* service tag: the name replaced by a short code */
        char tag[64];
        char *p = put_text(tag, "P#");
        p = put_number(p, (uint32_t)i, 1);
        p = put_text(p, l->text + strlen(reader.name));
        size_t len = (size_t)(p - tag);
        const char *lot = strstr(tag, "LOT");

        sum = sum * 31u + (uint32_t)reader.lot + (uint32_t)reader.ean_tail;
        sum = sum * 31u + (uint32_t)len + (lot ? (uint32_t)(lot - tag) + 1u : 0u);
        if (reader.ok && strcmp(reader.name, l->name) == 0)
            sum += 1;
        if (strcmp(l->text, tag) > 0)
            sum += 1000;
        if (strcmp(tag + len - 2, "5;") == 0)
            sum += 5000;
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
