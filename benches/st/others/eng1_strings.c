/* texts: telegrams, messages from templates, bar codes, recipe names */
#include <stdbool.h>
#include <string.h>
#include "st.h"

/* copies with the capacity of the target (without the NUL) */
static void copy(char *dst, int cap, const char *src)
{
    int n = (int)strlen(src);
    if (n > cap)
        n = cap;
    memmove(dst, src, n);
    dst[n] = 0;
}

static void append(char *dst, int cap, const char *src)
{
    int have = (int)strlen(dst);
    int n = (int)strlen(src);
    if (n > cap - have)
        n = cap - have;
    memcpy(dst + have, src, n);
    dst[have + n] = 0;
}

static void left(char *dst, const char *src, int l)
{
    int n = (int)strlen(src);
    if (l > n)
        l = n;
    memcpy(dst, src, l);
    dst[l] = 0;
}

static void mid(char *dst, const char *src, int l, int p)
{
    int n = (int)strlen(src);
    if (p > n) {
        dst[0] = 0;
        return;
    }
    if (l > n - p + 1)
        l = n - p + 1;
    memcpy(dst, src + p - 1, l);
    dst[l] = 0;
}

static int find(const char *s, const char *what)
{
    const char *p = strstr(s, what);
    return p ? (int)(p - s) + 1 : 0;
}

static void insert(char *s, int cap, const char *what, int p)
{
    char tmp[96];
    copy(tmp, 80, s + p);
    s[p] = 0;
    append(s, cap, what);
    append(s, cap, tmp);
}

static void replace(char *dst, int cap, const char *src, const char *with, int l, int p)
{
    left(dst, src, p - 1);
    append(dst, cap, with);
    append(dst, cap, src + p - 1 + l);
}

static void int_to_string(char *dst, int v)
{
    char tmp[8];
    int n = 0;
    if (v < 0) {
        *dst++ = '-';
        v = -v;
    }
    do {
        tmp[n++] = (char)('0' + v % 10);
        v /= 10;
    } while (v);
    while (n)
        *dst++ = tmp[--n];
    *dst = 0;
}

static int16_t string_to_int(const char *s)
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

static void pad_int(char *dst, int16_t val, int width)
{
    char tmp[13];
    int_to_string(dst, val);
    while ((int)strlen(dst) < width) {
        strcpy(tmp, dst);
        strcpy(dst, "0");
        append(dst, 12, tmp);
    }
}

/* value behind a key, up to the next semicolon */
static void get_field(char *dst, const char *tel, const char *key)
{
    int pos, end;
    char rest[81];

    pos = find(tel, key);
    if (pos == 0) {
        dst[0] = 0;
        return;
    }
    pos += (int)strlen(key);
    mid(rest, tel, (int)strlen(tel) - pos + 1, pos);
    end = find(rest, ";");
    if (end > 0)
        left(dst, rest, end - 1);
    else
        copy(dst, 20, rest);
}

/* replaces a mark in the text by a value, when it is there */
static void fill(char *dst, const char *text, const char *mark, const char *value)
{
    int pos = find(text, mark);
    if (pos > 0)
        replace(dst, 80, text, value, (int)strlen(mark), pos);
    else
        copy(dst, 80, text);
}

/* EAN-13 check digit */
static bool ean_ok(const char *code)
{
    static const char digits[] = "0123456789";
    int k, sum = 0;

    if (strlen(code) != 13)
        return false;
    for (k = 1; k <= 13; k++) {
        const char *p = strchr(digits, code[k - 1]);
        int digit;
        if (!p)
            return false;
        digit = (int)(p - digits);
        if (k % 2 == 0)
            sum += 3 * digit;
        else
            sum += digit;
    }
    return sum % 10 == 0;
}

static char stats[4][9] = { "RUN", "STOP", "FAULT", "IDLE" };
static char templates[8][61] = {
    "Batch %b: tank %t reached %v degC",
    "Tank %t empty, batch %b held",
    "Operator request: sample %v of batch %b",
    "Pressure of tank %t too high (%v mbar)",
    "Batch %b finished, %v kg",
    "Cleaning of tank %t requested",
    "Valve %v of tank %t does not open",
    "Level of tank %t below %v mm, batch %b" };
static char recipes[12][21] = {
    "RCP_Vanilla", "RCP_Chocolate", "RCP_Strawberry", "RCP_Hazelnut",
    "RCP_Lemon", "RCP_Mango", "RCP_Pistachio", "RCP_Coffee",
    "RCP_Cherry", "RCP_Caramel", "RCP_Banana", "RCP_Walnut" };
static char eans[4][21] = { "4006381333931", "9783161484100", "4006381333932", "40063X1333931" };
static char logs[32][81];
static int16_t nlog;
static int16_t nscan;

void scan(void)
{
    char tel[81], msg[81], tmp[81], num[21], batch[21], field[21], stat[21], name[21], first[21], letter[2];
    int16_t id = 0, temp = 0, pres = 0, found, val;
    int32_t sum = 0;
    int i, t;

    nscan++;
    if (nscan > 9999)
        nscan = 1;

    /* telegrams of three scales: build and take apart again */
    for (t = 1; t <= 3; t++) {
        val = (int16_t)(nscan + 37 * t);
        strcpy(tel, "ID=");
        pad_int(num, val, 5);
        append(tel, 80, num);
        append(tel, 80, ";TEMP=");
        int_to_string(num, val % 300 - 100);
        append(tel, 80, num);
        append(tel, 80, ";PRES=");
        int_to_string(num, val % 77 * 13);
        append(tel, 80, num);
        append(tel, 80, ";STAT=");
        append(tel, 80, stats[val % 4]);
        append(tel, 80, ";");

        get_field(field, tel, "ID=");
        id = string_to_int(field);
        get_field(field, tel, "TEMP=");
        temp = string_to_int(field);
        get_field(field, tel, "PRES=");
        pres = string_to_int(field);
        get_field(stat, tel, "STAT=");
        sum += id + temp * 3 + pres;
        if (strcmp(stat, "RUN") == 0)
            sum += 1;
        else if (strcmp(stat, "STOP") == 0)
            sum += 2;
        else if (strcmp(stat, "FAULT") == 0)
            sum += 4;
        else
            sum += 8;
    }

    /* eight messages from templates into the log */
    strcpy(batch, "B");
    pad_int(num, id, 6);
    append(batch, 20, num);
    for (i = 0; i < 8; i++) {
        fill(msg, templates[i], "%b", batch);
        int_to_string(num, nscan % 8 + i);
        fill(tmp, msg, "%t", num);
        int_to_string(num, pres);
        fill(msg, tmp, "%v", num);
        if (temp > 150)
            insert(msg, 80, "HOT ", 0);
        pad_int(tmp, nscan, 4);
        append(tmp, 80, " ");
        append(tmp, 80, msg);
        copy(logs[nlog], 80, tmp);
        nlog = (nlog + 1) % 32;
        sum += (int32_t)strlen(tmp);
    }

    /* search in the log */
    found = 0;
    for (i = 0; i < 32; i++) {
        int n = (int)strlen(logs[i]);
        if (find(logs[i], "empty") > 0)
            found++;
        if (strcmp(logs[i] + (n > 5 ? n - 5 : 0), "mbar)") == 0)
            found += 10;
    }
    sum += found;

    /* first recipe in the alphabet behind a given letter */
    strcpy(first, "zzz");
    for (i = 0; i < 12; i++) {
        copy(name, 20, recipes[i] + 4);
        mid(letter, "ABCDEFGHIJKLMNOPQRSTUVW", 1, nscan % 23 + 1);
        if (strcmp(name, letter) > 0 && strcmp(name, first) < 0) {
            strcpy(first, name);
            found = (int16_t)i;
        }
    }
    sum += found * 17 + (int32_t)strlen(first);

    /* bar codes */
    for (i = 0; i < 4; i++)
        if (ean_ok(eans[i]))
            sum += 100;

    check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
