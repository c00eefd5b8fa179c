#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

#define WORDS 6
#define SIZE 81

static int32_t number;

/* Position from 1, 0 if it is not there */
static int find(const char *text, const char *part)
{
    const char *p = strstr(text, part);
    return p ? (int)(p - text) + 1 : 0;
}

/* Replaces n characters from index pos (from 0) by another text */
static void splice(char *text, const char *with, size_t n, size_t pos)
{
    size_t m = strlen(with);
    memmove(text + pos + m, text + pos + n, strlen(text + pos + n) + 1);
    memcpy(text + pos, with, m);
}

static void trim(char *text)
{
    size_t skip = strspn(text, " ");
    size_t n = strlen(text + skip);
    memmove(text, text + skip, n + 1);
    while (n > 0 && text[n - 1] == ' ')
        text[--n] = '\0';
}

static void replace_all(char *text, const char *search, const char *instead)
{
    size_t n = strlen(search);
    char *p;
    while ((p = strstr(text, search)) != NULL)
        splice(text, instead, n, p - text);
}

static uint32_t signature(const char *text)
{
    uint32_t sum = strlen(text);
    sum = sum * 37 + find(text, "e");
    sum = sum * 37 + find(text, "7");
    sum = sum * 37 + find(text, "an");
    return sum;
}

void scan(void)
{
    char telegram[SIZE], field[SIZE], text[SIZE], list[SIZE];
    char words[WORDS][21];
    uint32_t result = 0;

    number = (number + 7919) % 100000;

    snprintf(telegram, sizeof telegram, "#ID=%d;VAL=%d;END", number, number * 3 - 50000);
    result += signature(telegram);

    const char *p = strstr(telegram, "VAL=");
    if (p) {
        strcpy(field, p + 4);
        char *end = strchr(field, ';');
        if (end)
            *end = '\0';
        result += (uint32_t)strtol(field, NULL, 10);
    }

    strcpy(text, "   The machine has a fault   ");
    trim(text);
    splice(text, " no. 7", 0, 11);
    splice(text, "had", 3, find(text, "has") - 1);
    if (number % 2 == 0)
        strcat(text, " again and again");
    else
        splice(text, "", 4, 0);
    replace_all(text, "a", "e");
    result = result * 3 + signature(text);

    snprintf(list, sizeof list, "motor,pump,valve,%d,lamp,fan", number);
    int count = 0;
    const char *start = list, *comma;
    while ((comma = strchr(start, ',')) != NULL) {
        memcpy(words[count], start, comma - start);
        words[count][comma - start] = '\0';
        count++;
        start = comma + 1;
    }
    strcpy(words[count++], start);
    for (int i = 0; i < count; i++) {
        result = result * 5 + strlen(words[i]);
        if (strcmp(words[i], "valve") == 0)
            result += 11;
    }
    result += (uint32_t)strtol(words[3], NULL, 10);

    check = (int32_t)((uint32_t)check * 31u + result);
}
