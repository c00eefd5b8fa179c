#include <stdint.h>
#include <string.h>
#include "st.h"

static const char *names[4] = { "pump", "valve", "motor", "agitator" };
static int32_t scans;

static char *put(char *p, const char *s)
{
    size_t n = strlen(s);
    memcpy(p, s, n);
    return p + n;
}

void scan(void)
{
    static char line[256];
    static char words[20][24];
    static int lengths[20], counts[20];
    int different = 0, longest = 0, most = 0;
    scans++;
    char *p = put(line, "start the ");
    p = put(p, names[scans % 4]);
    p = put(p, ", then stop the ");
    p = put(p, names[scans / 4 % 4]);
    p = put(p, " and  open the drain, check the level of the tank and wait");
    *p = 0;
    for (const char *w = line; *w;) {
        const char *end = strchr(w, ' ');
        const char *next = end ? end + 1 : (end = w + strlen(w));
        int n = end - w;
        if (n > 20)
            n = 20;
        if (n && w[n - 1] == ',')
            n--;
        if (n) {
            int i;
            for (i = 0; i < different; i++)
                if (lengths[i] == n && memcmp(words[i], w, n) == 0) {
                    counts[i]++;
                    break;
                }
            if (i == different && different < 20) {
                memcpy(words[i], w, n);
                lengths[i] = n;
                counts[i] = 1;
                different++;
            }
            if (n > longest)
                longest = n;
        }
        w = next;
    }
    for (int i = 0; i < different; i++)
        if (counts[i] > most)
            most = counts[i];
    check = (check * 3 + different * 100 + most * 10 + longest) % 1000003;
}
