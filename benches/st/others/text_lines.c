#include <string.h>
#include "st.h"
#include "digits.h"
static char line[121], s[121], t[121], names[10][21];
static int32_t scans;
void scan(void)
{
    if (!scans)
        for (int i = 0; i < 10; i++) {
            strcpy(names[i], "Motor");
            digits(i, names[i] + 5);
        }
    int32_t n = 0;
    int length = 0;
    for (int i = 0; i < 10; i++) {
        int more = strlen(names[i]);
        memcpy(line + length, names[i], more);
        length += more;
        line[length++] = ';';
    }
    while (length > 0) {
        char *found = memchr(line, ';', length);
        if (!found)
            break;
        int pos = found - line;
        memcpy(s, line, pos);
        s[pos] = 0;
        memmove(line, found + 1, length - pos);
        length -= pos + 1;
        if (!strcmp(s, "Motor7"))
            n += 100;
        n += pos;
        memcpy(t, s, pos);
        t[pos] = '=';
        n += pos + 1 + digits(n, t + pos + 1);
    }
    check += n;
    scans++;
}
