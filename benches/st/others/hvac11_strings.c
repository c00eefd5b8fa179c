/* Messages of the building automation: put together, taken apart, logged */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "st.h"

#define MESSAGES_PER_SCAN 5
#define LOG_SIZE 8
#define MESSAGE_SIZE 61

static const char *const point_names[] = {
    "SupplyTemp", "ReturnTemp", "RoomTemp", "OutsideTemp", "FlowTemp", "DewPoint",
};

static char message_log[LOG_SIZE][MESSAGE_SIZE];
static int log_index;
static int scan_counter;
static int32_t repeated, outside_count, frost_count;

/* Tenths from text like "-3.5". */
static int32_t parse_temperature(const char *text)
{
    char digits[13];
    const char *dot = strchr(text, '.');
    size_t before = (size_t)(dot - text);

    memcpy(digits, text, before);
    strcpy(digits + before, dot + 1);
    return (int32_t)strtol(digits, NULL, 10);
}

void scan(void)
{
    uint32_t sum = (uint32_t)check;

    scan_counter = (scan_counter + 1) % 10000;

    for (int n = 1; n <= MESSAGES_PER_SCAN; n++) {
        char line[MESSAGE_SIZE], message[MESSAGE_SIZE], point[17], value[13];

        int unit = (scan_counter + n * 3) % 12 + 1;
        int t = (scan_counter * 3 + n * 37) % 480 - 150;
        snprintf(line, sizeof line, "AHU%02d.%s=%s%d.%d degC", unit,
                 point_names[(scan_counter / 3 + n) % 6], t < 0 ? "-" : "", abs(t) / 10, abs(t) % 10);

        const char *dot = strchr(line, '.');
        const char *equal = strchr(line, '=');
        const char *degrees = strstr(line, " degC");
        size_t len = (size_t)(equal - dot - 1);
        memcpy(point, dot + 1, len);
        point[len] = '\0';
        len = (size_t)(degrees - equal - 1);
        memcpy(value, equal + 1, len);
        value[len] = '\0';
        int32_t parsed = parse_temperature(value);
        if (strcmp(point, "OutsideTemp") == 0)
            outside_count++;

        snprintf(message, sizeof message, "%sUnit %s%s", parsed < 0 ? "FROST " : "", line + 3,
                 parsed > 250 ? " too high" : "");
        if (strncmp(message, "FROST", 5) == 0)
            frost_count++;

        for (int i = 0; i < LOG_SIZE; i++)
            if (strcmp(message_log[i], message) == 0)
                repeated++;
        strcpy(message_log[log_index], message);
        log_index = (log_index + 1) % LOG_SIZE;

        uint32_t telegram = 0;
        for (const char *c = message; *c; c++)
            telegram = telegram * 3u + (unsigned char)*c;

        sum = sum * 31u + telegram + (uint32_t)parsed + (uint32_t)strlen(message);
    }

    check = (int32_t)(sum * 31u + (uint32_t)outside_count + (uint32_t)frost_count * 3u + (uint32_t)repeated * 7u);
}
