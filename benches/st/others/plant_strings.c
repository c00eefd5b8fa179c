/* Telegrams to and from a scale: build, search, cut, convert, compare */
#include <stdlib.h>
#include <string.h>
#include "st.h"

#define TAGS 7
#define LEN_MAX 80

typedef char String[LEN_MAX + 1];

static int Find(const char *s, const char *t)
{
    const char *p = strstr(s, t);

    return p ? (int)(p - s) + 1 : 0;
}

static void Concat(char *dst, const char *s)
{
    size_t n = strlen(dst), m = strlen(s);

    if (n + m > LEN_MAX)
        m = LEN_MAX - n;
    memcpy(dst + n, s, m);
    dst[n + m] = 0;
}

static void Mid(char *dst, const char *s, int L, int P)
{
    int n = (int)strlen(s);

    if (L <= 0 || P < 1 || P > n) {
        dst[0] = 0;
        return;
    }
    if (L > n - P + 1)
        L = n - P + 1;
    memcpy(dst, s + P - 1, L);
    dst[L] = 0;
}

static void Right(char *dst, const char *s, int L)
{
    int n = (int)strlen(s);

    if (L > n)
        L = n;
    strcpy(dst, s + n - L);
}

static void Delete(char *s, int L, int P)
{
    int n = (int)strlen(s);

    if (P < 1 || P > n)
        return;
    if (L > n - P + 1)
        L = n - P + 1;
    memmove(s + P - 1, s + P - 1 + L, n - (P - 1 + L) + 1);
}

/* inserts t after character P */
static void Insert(char *s, const char *t, int P)
{
    int n = (int)strlen(s), m = (int)strlen(t);

    if (n + m > LEN_MAX)
        return;
    memmove(s + P + m, s + P, n - P + 1);
    memcpy(s + P, t, m);
}

static void Replace(char *s, const char *t, int L, int P)
{
    Delete(s, L, P);
    Insert(s, t, P - 1);
}

static void IntToString(char *dst, int16_t iVal)
{
    char buf[8];
    int n = 0, v = iVal;

    if (v < 0) {
        *dst++ = '-';
        v = -v;
    }
    do {
        buf[n++] = '0' + v % 10;
        v /= 10;
    } while (v);
    while (n)
        *dst++ = buf[--n];
    *dst = 0;
}

static void Field(char *dst, const char *sTel, const char *sKey)
{
    int iPos, iEnd;
    String sRest;

    dst[0] = 0;
    iPos = Find(sTel, sKey);
    if (iPos > 0) {
        Mid(sRest, sTel, (int)strlen(sTel), iPos + (int)strlen(sKey));
        iEnd = Find(sRest, ";");
        if (iEnd > 1)
            Mid(dst, sRest, iEnd - 1, 1);
    }
}

static int32_t diScan;
static String asTag[TAGS + 1] = {
    "TANK_01", "TANK_02", "MIXER_A", "MIXER_B", "PUMP_100", "PUMP_200", "VALVE_7", "HEATER"
};
static String asOld[TAGS + 1];

void scan(void)
{
    int32_t i;
    int16_t iVal;
    String sTag, sTel, sLog, sField, sState, sNum;

    diScan = diScan + 1;
    for (i = 0; i <= TAGS; i++) {
        iVal = (int16_t)((diScan * 37 + i * 411) % 4000 - 1000);
        strcpy(sTag, asTag[i]);
        if (iVal < 0)
            strcpy(sState, "STOP");
        else if (iVal < 1500)
            strcpy(sState, "RUN");
        else
            strcpy(sState, "ALARM");

        /* build */
        strcpy(sTel, "TAG=");
        Concat(sTel, sTag);
        Concat(sTel, ";VAL=");
        IntToString(sNum, iVal);
        Concat(sTel, sNum);
        Concat(sTel, ";ST=");
        Concat(sTel, sState);
        Concat(sTel, ";");

        /* read back */
        Field(sField, sTel, "VAL=");
        check = check * 3 + (int16_t)atoi(sField);
        Field(sField, sTel, "ST=");
        if (strcmp(sField, "ALARM") == 0)
            check = check + 17;
        else if (strcmp(sField, "S") < 0)
            check = check + 5;

        /* edit */
        strcpy(sLog, sTel);
        Replace(sLog, "WEIGHT:", 4, Find(sLog, "VAL="));
        Delete(sLog, 4, 1);
        Insert(sLog, " kg", Find(sLog, ";ST=") - 1);
        IntToString(sNum, (int16_t)(diScan % 10000));
        Right(sField, sNum, 3);
        Insert(sLog, sField, 0);
        check = check + (int32_t)strlen(sLog) * 7 + Find(sLog, "kg");
        if (strcmp(sLog, asOld[i]) != 0) {
            strcpy(asOld[i], sLog);
            check = check + i;
        }
    }
}
