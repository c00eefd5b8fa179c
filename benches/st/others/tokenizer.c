#include <stdint.h>
#include <string.h>
#include "st.h"

static const char *lines[4] = { "12 + 3*(level - 2)", "flow*set_point - 100 / 7", "(pi + 1) * (pi + 2)*x", "1000-level*2+   flow" };
static int32_t scans;

static struct {
    const char *at;
    int kind;
    const char *text;
    int length;
    int32_t value;
} scanner;

static void next(void)
{
    const char *p = scanner.at;
    scanner.kind = 0;
    scanner.value = 0;
    while (*p == ' ')
        p++;
    scanner.text = p;
    if (*p >= '0' && *p <= '9') {
        while (*p >= '0' && *p <= '9')
            scanner.value = scanner.value * 10 + (*p++ - '0');
        scanner.kind = 1;
    } else if (*p >= 'a' && *p <= 'z') {
        while (*p >= 'a' && *p <= 'z' || *p == '_')
            p++;
        scanner.kind = 2;
    } else if (*p) {
        char c = *p++;
        scanner.kind = c == '+' || c == '-' ? 3 : c == '*' || c == '/' ? 4 : c == '(' ? 5 : c == ')' ? 6 : 9;
    }
    scanner.length = p - scanner.text;
    scanner.at = p;
}

static int is(const char *name)
{
    return scanner.length == (int)strlen(name) && memcmp(scanner.text, name, scanner.length) == 0;
}

static int32_t value_of(void)
{
    return is("level") ? 40 : is("flow") ? 12 : is("set_point") ? 55 : is("pi") ? 3 : 0;
}

void scan(void)
{
    int32_t sum = 0;
    scans++;
    for (int row = 0; row < 4; row++) {
        char line[84];
        size_t n = strlen(lines[row]);
        memcpy(line, lines[row], n);
        line[n++] = '+';
        int32_t v = scans % 100;
        if (v >= 10)
            line[n++] = '0' + v / 10;
        line[n++] = '0' + v % 10;
        line[n] = 0;
        int32_t sign = 1, depth = 0;
        scanner.at = line;
        do {
            next();
            switch (scanner.kind) {
            case 1: sum += sign * scanner.value; break;
            case 2: sum += sign * value_of() + scanner.length; break;
            case 3: sign = *scanner.text == '-' ? -1 : 1; break;
            case 4: sum *= 2; break;
            case 5: depth++; break;
            case 6: depth--; break;
            }
        } while (scanner.kind);
        sum = (sum + depth) % 100000;
    }
    check = (check * 3 + sum) % 1000003;
}
