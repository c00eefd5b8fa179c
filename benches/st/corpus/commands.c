#include <ctype.h>
#include <string.h>
#include "st.h"
static const char *lines[8] = {"start", "Set 1234", "ramp 99 up", "STOP", "help me", "quit", "set 77", "Ramp x"};
static struct parser { char word[21], argument[21]; int code; int32_t value; } parser;
static int32_t state, scans;
static void parse(struct parser *p, const char *text)
{
    char all[41];
    int length = strlen(text);
    for (int i = 0; i < length; i++)
        all[i] = text[i] >= 'a' && text[i] <= 'z' ? text[i] - 32 : text[i];
    all[length] = 0;
    p->value = 0;
    char *blank = memchr(all, ' ', length);
    int count = blank ? blank - all : length;
    memcpy(p->word, all, count);
    p->word[count] = 0;
    int rest = blank ? length - count - 1 : 0;
    memcpy(p->argument, all + count + 1, rest);
    p->argument[rest] = 0;
    if (!strcmp(p->word, "START"))
        p->code = 1;
    else if (!strcmp(p->word, "STOP"))
        p->code = 2;
    else if (!strcmp(p->word, "SET"))
        p->code = 3;
    else if (!strcmp(p->word, "RAMP"))
        p->code = 4;
    else
        p->code = strcmp(p->word, "M") < 0 ? 5 : 6;
    for (int i = 0; i < rest; i++) {
        int c = p->argument[i] - '0';
        if (c < 0 || c > 9)
            break;
        p->value = p->value * 10 + c;
    }
}
void scan(void)
{
    for (int i = 0; i < 8; i++) {
        parse(&parser, lines[(i + scans % 8) % 8]);
        switch (parser.code) {
        case 1: state += 1; break;
        case 2: state -= 1; break;
        case 3: state += parser.value; break;
        case 4: state += 2 * parser.value; break;
        default: state += strlen(parser.word);
        }
    }
    check += state;
    state = 0;
    scans++;
}
