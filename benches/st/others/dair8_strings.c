/* Labels, recipe lines and reports of the bottling hall */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

typedef enum { LINE_EMPTY, LINE_BATCH, LINE_CIP, LINE_ALARM } line_kind;

typedef struct {
    line_kind kind;
    char code[21];
    char text[41];
    int32_t value;
} line_t;

static const char *const kinds[4] = { "BATCH", "CIP", "ALARM", "NOTE" };
static const char *const product[4] = { "Whole milk 3.5", "Cream", "Yoghurt mild", "Orange juice" };
static int32_t tick;
static line_t line;

/* Decimal digits of a number, at least width of them; returns the length. */
static int put_number(char *out, int32_t value, int width)
{
    char tmp[12];
    int n = 0, len = 0;
    uint32_t v = value < 0 ? 0u - (uint32_t)value : (uint32_t)value;

    do {
        tmp[n++] = (char)('0' + v % 10);
        v /= 10;
    } while (v);
    while (n < width)
        tmp[n++] = '0';
    if (value < 0)
        out[len++] = '-';
    while (n)
        out[len++] = tmp[--n];
    out[len] = 0;
    return len;
}

/* Position of a text in another one, from 1, or 0. */
static int find(const char *text, const char *what)
{
    const char *p = strstr(text, what);
    return p ? (int)(p - text) + 1 : 0;
}

/* Takes the next field; returns what follows. */
static const char *next_field(const char *rest, char *field, size_t size)
{
    const char *end = strchr(rest, ';');
    size_t len = end ? (size_t)(end - rest) : strlen(rest);
    size_t n = len < size - 1 ? len : size - 1;

    memcpy(field, rest, n);
    field[n] = 0;
    return end ? end + 1 : rest + len;
}

static void parse_line(const char *source, line_t *l)
{
    char field[41];

    source = next_field(source, field, sizeof field);
    if (strcmp(field, "BATCH") == 0)
        l->kind = LINE_BATCH;
    else if (strcmp(field, "CIP") == 0)
        l->kind = LINE_CIP;
    else if (strcmp(field, "ALARM") == 0)
        l->kind = LINE_ALARM;
    else
        l->kind = LINE_EMPTY;
    source = next_field(source, l->code, sizeof l->code);
    source = next_field(source, l->text, sizeof l->text);
    next_field(source, field, sizeof field);
    l->value = (int32_t)strtol(field, NULL, 10);
}

/* Puts a text in place of length characters at p, which lies in text. */
static void replace_at(char *p, size_t length, const char *with)
{
    size_t n = strlen(with);

    memmove(p + n, p + length, strlen(p + length) + 1);
    memcpy(p, with, n);
}

static void make_label(char *text, const char *template, const char *prod, int32_t lot)
{
    char digits[13];
    char *p;

    strcpy(text, template);
    if ((p = strstr(text, "%P")))
        replace_at(p, 2, prod);
    if ((p = strstr(text, "%L"))) {
        put_number(digits, lot, 6);
        replace_at(p, 2, digits);
    }
}

void scan(void)
{
    uint32_t sum = 0;

    tick = (tick + 1) % 100000;
    for (int i = 0; i < 4; i++) {
        char source[81], label[81], part[21];
        int n = (tick + i) % 4;
        char *p = source;

        p = stpcpy(p, kinds[n]);
        p = stpcpy(p, ";T");
        p += put_number(p, tick % 97 + i, 3);
        *p++ = ';';
        p = stpcpy(p, product[i]);
        *p++ = ';';
        p += put_number(p, tick * 3 - 5000, 1);

        parse_line(source, &line);
        switch (line.kind) {
        case LINE_BATCH: sum += (uint32_t)line.value; break;
        case LINE_CIP: sum += (uint32_t)line.value * 2u; break;
        case LINE_ALARM: sum -= (uint32_t)line.value; break;
        default: sum += 1; break;
        }
        size_t code_len = strlen(line.code);
        strcpy(part, code_len > 2 ? line.code + code_len - 2 : line.code);
        sum = sum * 3u + (uint32_t)strtol(part, NULL, 10) + (uint32_t)strlen(line.text) + (uint32_t)(p - source);

        make_label(label, "%P / lot %L / keep cool", product[n], tick + i);
        memcpy(part, label + strlen(product[n]) + 3, 10);
        part[10] = 0;
        sum = sum * 3u + (uint32_t)find(label, "0") + (uint32_t)find(label, "keep") * 5u + (uint32_t)strlen(label);
        sum += (uint32_t)strtol(part + 4, NULL, 10);
        if (strcmp(label, source) < 0)
            sum += 17;
    }
    check = (int32_t)((uint32_t)check * 31u + sum);
}
