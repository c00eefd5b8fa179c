/* label texts, bar codes and alarm lines */
#include <stdbool.h>
#include <string.h>
#include "st.h"

static void IntToStr(char *d, int32_t v)
{
    char b[12];
    int n = 0;
    uint32_t u = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;

    do {
        b[n++] = '0' + u % 10;
        u /= 10;
    } while (u);
    if (v < 0)
        *d++ = '-';
    while (n > 0)
        *d++ = b[--n];
    *d = 0;
}

static int32_t StrToInt(const char *s)
{
    int32_t v = 0;
    bool neg = false;

    if (*s == '-') {
        neg = true;
        s++;
    }
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return neg ? -v : v;
}

/* position of t in s from 1, or 0 */
static int16_t Find(const char *s, const char *t)
{
    const char *f = strstr(s, t);
    return f ? (int16_t)(f - s + 1) : 0;
}

/* n characters of s from position p */
static void Mid(char *d, const char *s, int n, int p)
{
    int len = (int)strlen(s);

    if (p > len)
        n = 0;
    else if (p + n - 1 > len)
        n = len - p + 1;
    memcpy(d, s + p - 1, n);
    d[n] = 0;
}

static void Left(char *d, const char *s, int n)
{
    Mid(d, s, n, 1);
}

static void Right(char *d, const char *s, int n)
{
    int len = (int)strlen(s);

    if (n > len)
        n = len;
    strcpy(d, s + len - n);
}

/* these three work in place */
static void Delete(char *s, int n, int p)
{
    int len = (int)strlen(s);

    if (p > len)
        return;
    if (p + n - 1 > len)
        n = len - p + 1;
    memmove(s + p - 1, s + p - 1 + n, len - (p - 1 + n) + 1);
}

static void Insert(char *s, const char *t, int p)
{
    int len = (int)strlen(s);
    int n = (int)strlen(t);

    memmove(s + p + n, s + p, len - p + 1);
    memcpy(s + p, t, n);
}

static void Replace(char *s, const char *t, int n, int p)
{
    Delete(s, n, p);
    Insert(s, t, p - 1);
}

static void PadLot(char *d, int16_t lot)
{
    IntToStr(d, lot);
    while (strlen(d) < 5)
        Insert(d, "0", 0);
}

static bool Init;
static char Product[6][13];
static char Line[20][41];
static char Code[81], Part[81], Txt[81], Msg[81];
static char Short[13];
static int16_t Lot = 100, Year = 24;
static int32_t Hits;

void scan(void)
{
    int16_t i, p, q, n;
    int32_t Sum;
    char num[16];

    if (!Init) {
        strcpy(Product[0], "COLA");
        strcpy(Product[1], "ORANGE");
        strcpy(Product[2], "LEMON");
        strcpy(Product[3], "WATER");
        strcpy(Product[4], "TONIC");
        strcpy(Product[5], "APPLE JUICE");
        Init = true;
    }

    Sum = 0;
    Lot = Lot + 7;
    if (Lot > 20000) {
        Lot = 100;
        Year = Year + 1;
        if (Year > 60)
            Year = 24;
    }

    for (i = 1; i <= 20; i++) {
        /* label: PRODUCT-L3-LOT00123/24 */
        n = (i + Lot) % 6;
        strcpy(Code, Product[n]);
        strcat(Code, "-L");
        IntToStr(num, i);
        strcat(Code, num);
        strcat(Code, "-LOT");
        PadLot(num, Lot + i);
        strcat(Code, num);
        strcat(Code, "/");
        IntToStr(num, Year);
        strcat(Code, num);
        strcpy(Line[i - 1], Code);
        Sum = Sum + (int32_t)strlen(Code);

        /* read it back as the scanner does */
        p = Find(Code, "-");
        Left(Part, Code, p - 1);
        if (strcmp(Part, "WATER") == 0)
            Hits = Hits + 1;
        else if (strcmp(Part, "COLA") == 0 || strcmp(Part, "TONIC") == 0)
            Hits = Hits + 2;
        else if (strcmp(Part, "LEMON") > 0)
            Hits = Hits + 3;
        p = Find(Code, "LOT");
        Mid(Short, Code, 5, p + 3);
        Sum = Sum + StrToInt(Short);
        Right(Short, Code, 2);
        Sum = Sum + StrToInt(Short);

        /* text for the panel */
        strcpy(Txt, Code);
        Replace(Txt, " lot ", 4, p - 1);
        Insert(Txt, "<", 0);
        Insert(Txt, ">", (int)strlen(Txt));
        q = Find(Txt, "/");
        if (q > 0)
            Delete(Txt, 3, q);
        Sum = Sum + (int32_t)strlen(Txt) * 3 + Find(Txt, "lot") + Find(Txt, "JUICE");
    }

    /* alarm line of the cycle */
    switch (Lot % 4) {
    case 0:
        strcpy(Msg, "FILLER: bowl level low");
        break;
    case 1:
        strcpy(Msg, "CAPPER: no caps in chute");
        break;
    case 2:
        strcpy(Msg, "LABELER: glue temperature");
        break;
    default:
        strcpy(Msg, "LINE OK");
        break;
    }
    strcat(Msg, " [");
    IntToStr(num, Hits % 100000);
    strcat(Msg, num);
    strcat(Msg, "]");
    p = Find(Msg, ":");
    if (p > 0) {
        Left(Short, Msg, p - 1);
        if (strcmp(Short, "CAPPER") == 0)
            Sum = Sum + 1000;
        else if (strcmp(Short, "FILLER") == 0)
            Sum = Sum + 2000;
        else
            Sum = Sum + 3000;
    }
    Sum = Sum + (int32_t)strlen(Msg);

    /* compare neighbours: order of the labels */
    for (i = 1; i <= 19; i++) {
        if (strcmp(Line[i - 1], Line[i]) < 0)
            Sum = Sum + i * 10;
    }
    if (Hits > 1000000)
        Hits = 0;
    check = (check + Sum + Hits % 1000) % 10000000;
}
