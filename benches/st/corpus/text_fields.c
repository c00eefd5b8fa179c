#include <stdint.h>
#include <string.h>
#include "st.h"

static const char *names[8] = { "valve", "motor", "pump", "heater", "mixer", "scale", "door", "lamp" };
static int32_t scans;

static char *put(char *p, const char *s)
{
    size_t n = strlen(s);
    memcpy(p, s, n);
    return p + n;
}

static char *put_int(char *p, int32_t v)
{
    char b[12];
    int n = 0;
    do {
        b[n++] = '0' + v % 10;
        v /= 10;
    } while (v);
    while (n)
        *p++ = b[--n];
    return p;
}

static int32_t parse_number(const char *s, size_t n)
{
    int32_t v = 0;
    for (size_t i = 0; i < n; i++)
        if (s[i] >= '0' && s[i] <= '9')
            v = v * 10 + (s[i] - '0');
    return v;
}

void scan(void)
{
    char line[256];
    int32_t code = 0, fields = 0;
    scans++;
    for (int row = 1; row <= 10; row++) {
        char *p = line;
        for (int i = 1; i <= 8; i++) {
            const char *n = names[i - 1];
            if (strcmp(n, "motor") < 0) {
                memcpy(p, n, 2);
                p = put_int(p + 2, (scans * i + row) % 1000);
            } else if (strcmp(n, "pump") == 0 || strcmp(n, "door") == 0) {
                p = put(p, n);
            } else {
                p = put(p, n + strlen(n) - 3);
                *p++ = '=';
                p = put_int(p, scans % 97 + i);
            }
            *p++ = ';';
        }
        *p = 0;
        code += p - line;
        const char *f = line, *semi;
        while ((semi = strchr(f, ';'))) {
            code += parse_number(f, semi - f);
            fields++;
            f = semi + 1;
        }
    }
    check = (check * 3 + code + fields) % 1000003;
}
