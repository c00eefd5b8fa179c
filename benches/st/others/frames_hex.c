#include <stdint.h>
#include <string.h>
#include "st.h"

static int32_t scans, values[6];

static char *hex(char *p, int32_t value, int digits)
{
    for (int i = digits - 1; i >= 0; i--) {
        p[i] = "0123456789ABCDEF"[value % 16];
        value /= 16;
    }
    return p + digits;
}

static int digit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'A' && c <= 'Z')
        return c - 'A' + 10;
    return -1;
}

static int32_t from_hex(const char *s, size_t n)
{
    int32_t v = 0;
    for (size_t i = 0; i < n; i++) {
        int d = digit(s[i]);
        v = v * 16 + (d < 16 ? d : -1);
    }
    return v;
}

static int32_t checksum(const char *s, size_t n)
{
    int32_t sum = 0;
    for (size_t i = 0; i < n; i++)
        sum = (sum * 7 + digit(s[i]) + 1) % 256;
    return sum;
}

static int receive(const char *frame, int32_t *address, int32_t *sum)
{
    const char *star = strchr(frame, '*');
    if (frame[0] != '$' || !star)
        return 0;
    const char *data = frame + 1;
    size_t n = star - data, length = strlen(frame);
    if (checksum(data, n) != from_hex(frame + length - 2, 2))
        return 0;
    *address = from_hex(data, 2);
    *sum = 0;
    for (size_t at = 2; at + 4 <= n; at += 4)
        *sum += from_hex(data + at, 4);
    return 1;
}

void scan(void)
{
    char frame[84];
    int32_t address, sum;
    scans++;
    frame[0] = '$';
    char *p = hex(frame + 1, scans % 32, 2);
    for (int i = 0; i < 6; i++) {
        values[i] = (scans * 37 + (i + 1) * 1001) % 65536;
        p = hex(p, values[i], 4);
    }
    int32_t own = checksum(frame + 1, p - frame - 1);
    *p++ = '*';
    p = hex(p, own, 2);
    *p = 0;
    if (scans % 5 == 0)
        frame[6] = '0';
    if (receive(frame, &address, &sum))
        check = (check * 3 + address * 1000 + sum) % 1000003;
    else
        check = (check * 3 + 1) % 1000003;
}
