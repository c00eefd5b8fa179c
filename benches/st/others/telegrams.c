#include <stdlib.h>
#include <string.h>
#include "st.h"
static int32_t scans;
static int padded(int32_t number, int width, char *to)
{
    char reversed[12];
    int count = 0;
    do {
        reversed[count++] = '0' + number % 10;
        number /= 10;
    } while (number);
    while (count < width)
        reversed[count++] = '0';
    for (int i = 0; i < count; i++)
        to[i] = reversed[count - 1 - i];
    to[count] = 0;
    return count;
}
static int sum(const char *text, int length)
{
    int all = 0;
    for (int i = 0; i < length; i++)
        all += text[i];
    return all % 256;
}
void scan(void)
{
    int good = 0;
    for (int station = 1; station <= 12; station++) {
        char telegram[61], body[61], part[8];
        int32_t value = (scans * 31 + station * 977) % 100000;
        int count = 0;
        body[count++] = 'S';
        count += padded(station, 2, body + count);
        body[count++] = 'V';
        count += padded(value, 6, body + count);
        telegram[0] = '#';
        memcpy(telegram + 1, body, count);
        telegram[count + 1] = '*';
        int length = count + 2 + padded(sum(body, count), 3, telegram + count + 2);
        if (telegram[0] == '#' && telegram[length - 4] == '*') {
            int inner = length - 5;
            memcpy(body, telegram + 1, inner);
            body[inner] = 0;
            int sent = atoi(telegram + length - 3);
            if (sum(body, inner) == sent) {
                good++;
                memcpy(part, body + 4, 6);
                part[6] = 0;
                check += atoi(part) % 1000;
                memcpy(part, body + 1, 2);
                part[2] = 0;
                check += atoi(part);
            }
        }
    }
    check += good;
    scans++;
}
