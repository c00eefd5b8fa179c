/* Example 8: Strings. Build a label, read it back, edit a message line. */
#include <stdbool.h>
#include <string.h>
#include "st.h"

/* --- small string helpers, positions count from 1 as on the controller --- */

static void int_to_str(char *dst, int16_t v)
{
    char tmp[8];
    int n = 0;
    int x = v;

    if (x < 0) {
        *dst++ = '-';
        x = -x;
    }
    do {
        tmp[n++] = (char)('0' + x % 10);
        x /= 10;
    } while (x > 0);
    while (n > 0)
        *dst++ = tmp[--n];
    *dst = '\0';
}

static int16_t str_to_int(const char *s)
{
    int v = 0;
    bool neg = false;

    if (*s == '-') {
        neg = true;
        s++;
    }
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return (int16_t)(neg ? -v : v);
}

static int str_find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int)(p - s) + 1 : 0;
}

/* replace n characters from position p by the text ins */
static void str_replace(char *s, const char *ins, int n, int p)
{
    char tail[81];

    strcpy(tail, s + p - 1 + n);
    strcpy(s + p - 1, ins);
    strcat(s, tail);
}

/* insert the text ins behind position p */
static void str_insert(char *s, const char *ins, int p)
{
    size_t n = strlen(ins);

    memmove(s + p + n, s + p, strlen(s + p) + 1);
    memcpy(s + p, ins, n);
}

/* delete n characters from position p */
static void str_delete(char *s, int n, int p)
{
    memmove(s + p - 1, s + p - 1 + n, strlen(s + p - 1 + n) + 1);
}

static void four_digits(char *dst, int16_t n)
{
    char s[21];

    int_to_str(s, n);
    while (strlen(s) < 4) {
        memmove(s + 1, s, strlen(s) + 1);
        s[0] = '0';
    }
    strcpy(dst, s);
}

/* value of a key in a text like "LOT=0012;ART=COLA;QTY=24;" */
static void get_field(char *dst, const char *line, const char *key)
{
    const char *p = strstr(line, key);
    const char *q;

    dst[0] = '\0';
    if (p) {
        p += strlen(key) + 1; /* behind the '=' */
        q = strchr(p, ';');
        if (q) {
            memcpy(dst, p, (size_t)(q - p));
            dst[q - p] = '\0';
        } else {
            strcpy(dst, p);
        }
    }
}

static int16_t lot;
static int16_t changes;
static const char articles[5][13] = { "COLA", "LEMON", "WATER", "ORANGE", "APPLE" };
static char text[81];
static char part[21];
static char message[81];
static char last[21];

void scan(void)
{
    uint32_t c = (uint32_t)check;
    char num[21];
    int16_t qty, art, n;
    int p;

    lot = (int16_t)((lot + 1) % 9000);
    qty = (int16_t)(10 + lot % 37);
    art = lot % 5;

    /* 1. build the label */
    strcpy(text, "LOT=");
    four_digits(num, lot);
    strcat(text, num);
    strcat(text, ";ART=");
    strcat(text, articles[art]);
    strcat(text, ";QTY=");
    int_to_str(num, qty);
    strcat(text, num);
    strcat(text, ";");
    c = c * 31u + (uint32_t)strlen(text);

    /* 2. read it back */
    get_field(part, text, "QTY");
    n = str_to_int(part);
    if (n == qty)
        c += 1;
    get_field(part, text, "LOT");
    c = c * 31u + (uint32_t)str_to_int(part);
    get_field(part, text, "ART");

    /* 3. compare with the article before */
    if (strcmp(part, last) != 0)
        changes = (int16_t)((changes + 1) % 1000);
    if (strcmp(part, last) < 0)
        c += 5;
    else if (strcmp(part, "WATER") == 0)
        c += 9;
    strcpy(last, part);

    /* 4. message for the panel */
    strcpy(message, "Station # reports: article @ filled");
    p = str_find(message, "#");
    int_to_str(num, lot % 16);
    str_replace(message, num, 1, p);
    p = str_find(message, "@");
    str_replace(message, part, 1, p);
    p = str_find(message, "reports");
    str_insert(message, "(OK) ", p - 1);
    if (lot % 3 == 0) {
        p = str_find(message, "(OK) ");
        str_delete(message, 5, p);
    }
    c = c * 31u + (uint32_t)(strlen(message) * 10) + (uint32_t)str_find(message, "filled");
    if (strcmp(message + strlen(message) - 6, "filled") == 0)
        c += (uint32_t)changes;
    check = (int32_t)c;
}
