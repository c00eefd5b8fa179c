#include <string.h>
#include <stdbool.h>
#include "st.h"
static void dint_to_str(int32_t n, char *out)
{
    char tmp[12];
    int k = 0;
    uint32_t u = n < 0 ? 0u - (uint32_t)n : (uint32_t)n;
    do { tmp[k++] = (char)('0' + u % 10); u /= 10; } while (u);
    if (n < 0) *out++ = '-';
    while (k) *out++ = tmp[--k];
    *out = 0;
}
static int32_t str_to_dint(const char *s)
{
    bool neg = false;
    int32_t v = 0;
    if (*s == '-') { neg = true; s++; }
    while (*s >= '0' && *s <= '9')
        v = v * 10 + (*s++ - '0');
    return neg ? -v : v;
}
typedef struct { char cmd[17]; int32_t args[6]; int16_t nargs; } tok_t;
static void tokenize(tok_t *t, const char *line)
{
    char rest[81], part[81];
    strcpy(rest, line);
    t->nargs = 0;
    char *p = strchr(rest, ' ');
    if (!p) {
        strcpy(t->cmd, rest);
        rest[0] = 0;
    } else {
        size_t n = (size_t)(p - rest);
        memcpy(t->cmd, rest, n);
        t->cmd[n] = 0;
        memmove(rest, p + 1, strlen(p + 1) + 1);
    }
    while (strlen(rest) > 0 && t->nargs < 6) {
        p = strchr(rest, ',');
        if (p) {
            size_t n = (size_t)(p - rest);
            memcpy(part, rest, n);
            part[n] = 0;
            memmove(rest, p + 1, strlen(p + 1) + 1);
        } else {
            strcpy(part, rest);
            rest[0] = 0;
        }
        t->args[t->nargs++] = str_to_dint(part);
    }
}
static const char lines[10][81] = {
    "MOVE 100,250,-30", "SPEED 1200", "STOP", "WAIT 15,2", "OUTPUT 1,0,1,1,0,1",
    "HOME", "MOVE -5,17,980", "LIMIT -1000,1000", "SPEED 350", "NOP 1,2,3" };
static tok_t tok;
static int32_t x, y, z, speed, outs, errors;
static int16_t turn;
void scan(void)
{
    turn = (int16_t)((turn + 1) % 10);
    for (int n = 0; n < 10; n++) {
        tokenize(&tok, lines[(n + turn) % 10]);
        if (strcmp(tok.cmd, "MOVE") == 0) {
            x = (x + tok.args[0]) % 10000;
            y = (y + tok.args[1]) % 10000;
            z = (z + tok.args[2]) % 10000;
        } else if (strcmp(tok.cmd, "SPEED") == 0) {
            speed = tok.args[0];
        } else if (strcmp(tok.cmd, "STOP") == 0) {
            speed = 0;
        } else if (strcmp(tok.cmd, "WAIT") == 0) {
            speed = speed / tok.args[1] + tok.args[0];
        } else if (strcmp(tok.cmd, "OUTPUT") == 0) {
            outs = 0;
            for (int k = 0; k < tok.nargs; k++)
                outs = outs * 2 + tok.args[k];
        } else if (strcmp(tok.cmd, "LIMIT") == 0) {
            x = x < tok.args[0] ? tok.args[0] : x > tok.args[1] ? tok.args[1] : x;
        } else if (strcmp(tok.cmd, "HOME") == 0) {
            z = 0;
        } else {
            errors = (errors + 1) % 1000;
        }
    }
    char echo[81], num[12];
    strcpy(echo, "X=");
    dint_to_str(x, num); strcat(echo, num);
    strcat(echo, " Y=");
    dint_to_str(y, num); strcat(echo, num);
    strcat(echo, " S=");
    dint_to_str(speed, num); strcat(echo, num);
    check = (check % 100003) * 3 + x + y * 2 + z * 3 + speed + outs + errors + (int32_t)strlen(echo);
}
