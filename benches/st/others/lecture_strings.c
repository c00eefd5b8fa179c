/* Strings: forty machines report; every report is built, parsed again, edited
   and compared with the one of the scan before. */
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define CAPACITY 80

typedef struct {
    unsigned char len;
    char s[CAPACITY];
} Str;

#define CONST_STR(text) {sizeof(text) - 1, text}

/* In all of these `out` must be another string than the inputs. Positions count from one. */

static void str_append_bytes(Str *out, const char *bytes, int count)
{
    if (count > CAPACITY - out->len)
        count = CAPACITY - out->len;
    if (count > 0) {
        memcpy(out->s + out->len, bytes, count);
        out->len += count;
    }
}

static void str_append(Str *out, const Str *in)
{
    str_append_bytes(out, in->s, in->len);
}

static void str_copy(Str *out, const Str *in)
{
    out->len = in->len;
    memcpy(out->s, in->s, in->len);
}

static void str_mid(Str *out, const Str *in, int count, int position)
{
    out->len = 0;
    if (position < 1 || position > in->len)
        return;
    if (count > in->len - position + 1)
        count = in->len - position + 1;
    str_append_bytes(out, in->s + position - 1, count);
}

static void str_left(Str *out, const Str *in, int count)
{
    str_mid(out, in, count, 1);
}

static void str_right(Str *out, const Str *in, int count)
{
    if (count > in->len)
        count = in->len;
    out->len = 0;
    str_append_bytes(out, in->s + in->len - count, count);
}

static void str_replace(Str *out, const Str *in, const Str *with, int count, int position)
{
    out->len = 0;
    str_append_bytes(out, in->s, position - 1);
    str_append(out, with);
    str_append_bytes(out, in->s + position - 1 + count, in->len - (position - 1 + count));
}

static void str_insert(Str *out, const Str *in, const Str *what, int position)
{
    out->len = 0;
    str_append_bytes(out, in->s, position);
    str_append(out, what);
    str_append_bytes(out, in->s + position, in->len - position);
}

static void str_delete(Str *out, const Str *in, int count, int position)
{
    out->len = 0;
    str_append_bytes(out, in->s, position - 1);
    str_append_bytes(out, in->s + position - 1 + count, in->len - (position - 1 + count));
}

static int str_find(const Str *in, const Str *what)
{
    for (int i = 0; i + what->len <= in->len; i++) {
        if (in->s[i] == what->s[0] && memcmp(in->s + i, what->s, what->len) == 0)
            return i + 1;
    }
    return 0;
}

static bool str_equal(const Str *a, const Str *b)
{
    return a->len == b->len && memcmp(a->s, b->s, a->len) == 0;
}

static int str_compare(const Str *a, const Str *b)
{
    int order = memcmp(a->s, b->s, a->len < b->len ? a->len : b->len);
    return order != 0 ? order : a->len - b->len;
}

typedef enum { STOPPED, STARTING, RUNNING, FAULTED } MachineState;

static const Str DIGITS = CONST_STR("0123456789");
static const Str STOPPED_NAME = CONST_STR("STOPPED");
static const Str STARTING_NAME = CONST_STR("STARTING");
static const Str RUN_NAME = CONST_STR("RUN");
static const Str FAULT_NAME = CONST_STR("FAULT");
static const Str ID_KEY = CONST_STR("ID=");
static const Str STATE_KEY = CONST_STR("STATE=");
static const Str STATE_FIELD = CONST_STR(";STATE=");
static const Str TEMP_KEY = CONST_STR("TEMP=");
static const Str TEMP_FIELD = CONST_STR(";TEMP=");
static const Str SEMICOLON = CONST_STR(";");
static const Str OPENING = CONST_STR("(");
static const Str CLOSING = CONST_STR(")");
static const Str MARK = CONST_STR("!");

/* `number` is not negative. */
static void number_to_text(Str *out, int32_t number)
{
    Str longer;
    out->len = 0;
    do {
        str_mid(&longer, &DIGITS, 1, number % 10 + 1);
        str_append(&longer, out);
        str_copy(out, &longer);
        number /= 10;
    } while (number != 0);
}

static int32_t text_to_number(const Str *text)
{
    int32_t number = 0;
    for (int position = 1; position <= text->len; position++) {
        Str digit;
        str_mid(&digit, text, 1, position);
        number = number * 10 + str_find(&DIGITS, &digit) - 1;
    }
    return number;
}

/* What stands between the key and the next semicolon. */
static void field_of(Str *out, const Str *text, const Str *key)
{
    int start = str_find(text, key);
    if (start == 0) {
        out->len = 0;
    } else {
        Str rest;
        str_right(&rest, text, text->len - key->len - start + 1);
        str_left(out, &rest, str_find(&rest, &SEMICOLON) - 1);
    }
}

static MachineState state_of(int32_t temperature)
{
    if (temperature < 50)
        return STOPPED;
    if (temperature < 90)
        return STARTING;
    if (temperature < 165)
        return RUNNING;
    return FAULTED;
}

static const Str *state_name(MachineState state)
{
    switch (state) {
    case STOPPED:
        return &STOPPED_NAME;
    case STARTING:
        return &STARTING_NAME;
    case RUNNING:
        return &RUN_NAME;
    default:
        return &FAULT_NAME;
    }
}

static Str last_report[40];
static int32_t scan_count;

void scan(void)
{
    scan_count++;
    int32_t sum = 0;
    Str greatest;
    greatest.len = 0;
    for (int32_t machine = 0; machine < 40; machine++) {
        Str report, edited, text, field, other;

        /* Build: ID=117;STATE=RUN;TEMP=142; */
        int32_t temperature = (scan_count * 7 + machine * 13) % 200;
        str_copy(&report, &ID_KEY);
        number_to_text(&text, 100 + machine);
        str_append(&report, &text);
        str_append(&report, &STATE_FIELD);
        str_append(&report, state_name(state_of(temperature)));
        str_append(&report, &TEMP_FIELD);
        number_to_text(&text, temperature);
        str_append(&report, &text);
        str_append(&report, &SEMICOLON);
        sum += report.len;

        /* Parse */
        field_of(&text, &report, &TEMP_KEY);
        sum += text_to_number(&text);
        field_of(&text, &report, &ID_KEY);
        sum += text_to_number(&text);
        field_of(&field, &report, &STATE_KEY);

        /* Edit: the field STATE=... becomes (...), the key of the first field goes, a fault is marked. */
        int position = str_find(&report, &STATE_KEY);
        str_replace(&edited, &report, &OPENING, 6, position);
        str_insert(&report, &edited, &CLOSING, position + field.len);
        str_delete(&edited, &report, 3, 1);
        if (str_equal(&field, &FAULT_NAME)) {
            str_copy(&report, &MARK);
            str_append(&report, &edited);
        } else {
            str_copy(&report, &edited);
        }
        sum += report.len + 3 * str_find(&report, &CLOSING);

        /* Compare */
        if (str_equal(&report, &last_report[machine]))
            sum += 1000;
        else if (str_compare(&report, &last_report[machine]) < 0)
            sum += 7 * machine;
        if (str_compare(&report, &greatest) > 0)
            str_copy(&greatest, &report);
        str_mid(&text, &report, 3, 5);
        str_mid(&other, &last_report[machine], 3, 5);
        if (!str_equal(&text, &other))
            sum += machine;
        str_copy(&last_report[machine], &report);
    }

    Str head;
    str_left(&head, &greatest, 3);
    sum += text_to_number(&head);
    check = (check * 31 + sum) % 1000003;
}
