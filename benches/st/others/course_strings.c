/* Course unit 8: texts for an operator panel and a telegram parser. */
#include "st.h"
#include <stdbool.h>
#include <string.h>

#define SIZE 81

static const char *state_name(int16_t state)
{
    switch (state) {
    case 0: return "stopped";
    case 1: return "running";
    case 2: return "waiting";
    case 3: return "fault";
    default: return "unknown";
    }
}

static char *int_to_string(char *out, int32_t value)
{
    char digits[12];
    int n = 0, k = 0;
    uint32_t v = value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
    do {
        digits[n++] = (char)('0' + v % 10);
        v /= 10;
    } while (v != 0);
    if (value < 0)
        out[k++] = '-';
    while (n > 0)
        out[k++] = digits[--n];
    out[k] = '\0';
    return out;
}

static int32_t string_to_int(const char *s)
{
    bool negative = *s == '-';
    int32_t value = 0;
    if (negative)
        s++;
    while (*s >= '0' && *s <= '9')
        value = value * 10 + (*s++ - '0');
    return negative ? -value : value;
}

/* position counted from 1, 0 if not found */
static int find(const char *text, const char *key)
{
    const char *p = strstr(text, key);
    return p ? (int)(p - text) + 1 : 0;
}

static void insert(char *text, const char *what, int after)
{
    size_t n = strlen(what);
    memmove(text + after + n, text + after, strlen(text + after) + 1);
    memcpy(text + after, what, n);
}

static void delete(char *text, int count, int pos)
{
    memmove(text + pos - 1, text + pos - 1 + count, strlen(text + pos - 1 + count) + 1);
}

static void replace(char *text, const char *what, int count, int pos)
{
    delete(text, count, pos);
    insert(text, what, pos - 1);
}

static void build_telegram(char *line, int16_t station, int16_t state, int32_t parts)
{
    char number[12];
    strcpy(line, "Station ");
    strcat(line, int_to_string(number, station));
    strcat(line, ": ");
    strcat(line, state_name(state));
    strcat(line, ", parts=");
    strcat(line, int_to_string(number, parts));
    strcat(line, ";");
}

static int32_t read_number(const char *text, const char *key, const char *stop)
{
    char rest[SIZE];
    int start = find(text, key);
    if (start == 0)
        return -1;
    start += (int)strlen(key);
    strcpy(rest, text + start - 1);
    int last = find(rest, stop);
    if (last > 0)
        rest[last - 1] = '\0';
    return string_to_int(rest);
}

static int16_t count_words(const char *text)
{
    int16_t words = 1;
    int length = (int)strlen(text);
    for (int i = 0; i < length; i++)
        if (text[i] == ' ')
            words++;
    return words;
}

typedef struct {
    char text[SIZE];
    bool is_alarm;
} AlarmText;

static void alarm_text(AlarmText *a, const char *telegram, int16_t number)
{
    char digits[12];
    strcpy(a->text, telegram);
    int p = find(a->text, "fault");
    a->is_alarm = p > 0;
    if (a->is_alarm) {
        replace(a->text, "ALARM", 5, p);
        insert(a->text, "!! ", 0);
    } else {
        p = find(a->text, "Station ");
        delete(a->text, 8, p);
        insert(a->text, "#", 0);
    }
    strcat(a->text, " [");
    strcat(a->text, int_to_string(digits, number));
    strcat(a->text, "]");
}

static int32_t scan_no;
static char telegram[SIZE], longest[SIZE], latest[SIZE];
static AlarmText alarms[8];
static int32_t parts[8];

void scan(void)
{
    scan_no = (scan_no + 1) % 10000;
    int32_t sum = 0;
    longest[0] = '\0';
    latest[0] = '\0';
    for (int i = 0; i < 8; i++) {
        parts[i] = (parts[i] + 3 * i + 1) % 20000;
        build_telegram(telegram, (int16_t)(i + 1), (int16_t)((scan_no + i) % 5), parts[i]);
        sum += read_number(telegram, "parts=", ";") + read_number(telegram, "Station ", ":");
        alarm_text(&alarms[i], telegram, (int16_t)scan_no);
        if (alarms[i].is_alarm)
            sum += 1000;
        if (strlen(alarms[i].text) > strlen(longest))
            strcpy(longest, alarms[i].text);
        if (strcmp(alarms[i].text, latest) > 0)
            strcpy(latest, alarms[i].text);
    }
    sum += count_words(longest) + (int32_t)strlen(longest) * 10 + find(latest, "w");
    if (longest[strlen(longest) - 1] == ']')
        sum += 1;
    check = (check * 31 + sum) % 1000003;
}
