#include <string.h>
#include "st.h"
static struct alarm { int16_t number; uint8_t active; char text[41]; } alarms[10];
static int32_t scans;
static int digits(int32_t number, char *to)
{
    char reversed[12];
    int count = 0, length = 0;
    if (number < 0) {
        to[length++] = '-';
        number = -number;
    }
    do {
        reversed[count++] = '0' + number % 10;
        number /= 10;
    } while (number);
    while (count)
        to[length++] = reversed[--count];
    return length;
}
static int put(char *to, const char *text)
{
    int length = strlen(text);
    memcpy(to, text, length);
    return length;
}
static void make(int number, int32_t value, char *line)
{
    const char *what;
    switch (number % 5) {
    case 0: what = "temperature high"; break;
    case 1: what = "pressure low"; break;
    case 2: what = "door open"; break;
    case 3: what = "motor overload"; break;
    default: what = "no answer";
    }
    int length = put(line, "A");
    length += digits(number + 100, line + length);
    length += put(line + length, " ");
    length += put(line + length, what);
    length += put(line + length, " (");
    length += digits(value, line + length);
    length += put(line + length, ")");
    line[length] = 0;
}
void scan(void)
{
    int changed = 0;
    char line[41];
    for (int i = 0; i < 10; i++) {
        int32_t value = (scans / 4 + i * 13) % 50 - 20;
        alarms[i].number = i;
        alarms[i].active = value > 0;
        if (alarms[i].active) {
            make(alarms[i].number, value, line);
            if (strcmp(alarms[i].text, line)) {
                strcpy(alarms[i].text, line);
                changed++;
            }
        } else if (alarms[i].text[0]) {
            alarms[i].text[0] = 0;
            changed++;
        }
    }
    const char *shown = "";
    for (int i = 0; i < 10; i++)
        if (strstr(alarms[i].text, "open") || strstr(alarms[i].text, "low")) {
            shown = alarms[i].text;
            check += i;
        }
    check += changed + strlen(shown);
    scans++;
}
