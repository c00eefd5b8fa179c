#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

#define STATIONS 6

typedef enum { STATE_IDLE, STATE_RUN, STATE_FAULT } state_t;

static const char *state_text(state_t state)
{
    switch (state) {
    case STATE_IDLE:
        return "IDLE";
    case STATE_RUN:
        return "RUN";
    case STATE_FAULT:
        return "FAULT";
    }
    return "";
}

static void int_to_string(char *out, int16_t value)
{
    char digits[8];
    int n = 0;
    int v = value;
    if (v < 0) {
        *out++ = '-';
        v = -v;
    }
    do {
        digits[n++] = (char)('0' + v % 10);
        v /= 10;
    } while (v > 0);
    while (n > 0)
        *out++ = digits[--n];
    *out = '\0';
}

/* Fills with zeros on the left. */
static void digits(char *out, int16_t value, size_t width)
{
    char text[17];
    int_to_string(text, value);
    size_t len = strlen(text);
    while (len < width) {
        memmove(text + 1, text, len + 1);
        text[0] = '0';
        len++;
    }
    strcpy(out, text);
}

/* Value of KEY=value; in a telegram. */
static void field(char *out, const char *telegram, const char *key)
{
    out[0] = '\0';
    const char *pos = strstr(telegram, key);
    if (pos) {
        pos += strlen(key);
        const char *end = strchr(pos, ';');
        if (end) {
            size_t len = (size_t)(end - pos);
            if (len > 16)
                len = 16;
            memcpy(out, pos, len);
            out[len] = '\0';
        }
    }
}

/* Replaces n characters at pos by text. */
static void replace(char *s, const char *text, size_t n, size_t pos)
{
    size_t tail = strlen(s + pos + n);
    size_t len = strlen(text);
    memmove(s + pos + len, s + pos + n, tail + 1);
    memcpy(s + pos, text, len);
}

static const char names[STATIONS][17] = { "PRESS", "OVEN", "ROBOT", "CONVEYOR", "WASHER", "PACKER" };
static char last[STATIONS][81];
static state_t states[STATIONS];
static char telegram[81];
static char state_word[17];
static char search[17];
static char logged[201];
static int16_t scans;

void scan(void)
{
    scans = (int16_t)((scans + 1) % 9000);
    logged[0] = '\0';
    for (int i = 0; i < STATIONS; i++) {
        char word[17];

        switch (states[i]) {
        case STATE_IDLE:
            if ((scans + i) % 4 == 0)
                states[i] = STATE_RUN;
            break;
        case STATE_RUN:
            if ((scans + i) % 7 == 0)
                states[i] = STATE_FAULT;
            break;
        case STATE_FAULT:
            if ((scans + i) % 3 == 0)
                states[i] = STATE_IDLE;
            break;
        }

        int16_t temp = (int16_t)((int16_t)(scans * 3 + i * 50) % 400 - 100);
        strcpy(telegram, "NAME=");
        strcat(telegram, names[i]);
        strcat(telegram, ";NO=");
        digits(word, (int16_t)(i + 1), 3);
        strcat(telegram, word);
        strcat(telegram, ";T=");
        int_to_string(word, temp);
        strcat(telegram, word);
        strcat(telegram, ";S=");
        strcat(telegram, state_text(states[i]));
        strcat(telegram, ";");

        field(word, telegram, "T=");
        int32_t sum = atoi(word);
        field(word, telegram, "NO=");
        sum += atoi(word);
        field(state_word, telegram, "S=");
        if (strcmp(state_word, "FAULT") == 0) {
            sum += 1000;
            strncat(logged, names[i], 3);
            strcat(logged, "! ");
        } else if (strcmp(state_word, "RUN") == 0) {
            sum += 100;
        }
        check += sum;

        field(search, telegram, "NAME=");
        for (int k = 0; k < STATIONS; k++) {
            if (strcmp(names[k], search) == 0) {
                check += k;
                break;
            }
        }

        if (temp > 200)
            replace(telegram, ";HOT=", 3, (size_t)(strstr(telegram, ";T=") - telegram));
        else
            replace(telegram, "OK:", 0, 0);
        replace(telegram, "", 7, (size_t)(strstr(telegram, ";NO=") - telegram));
        if (strcmp(telegram, last[i]) > 0)
            check += 5;
        strcpy(last[i], telegram);
        size_t len = strlen(telegram);
        check += (int32_t)len * 3;
        if (len >= 4 && strcmp(telegram + len - 4, "RUN;") == 0)
            check += 11;
    }
    check += (int32_t)strlen(logged);
}
