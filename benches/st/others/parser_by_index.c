#include "iec_timers.h"
typedef enum { Start, Sign, Digits, Fraction, HexMark, HexDigits, Skip } PState;
static char lines[6][61] = { "12;-345;$1F;7.25;9;", "  88;x7;-;100000;$zz;4.5;", "1.999;2.1;3;;;;-5;",
  "$DEAD;$beef;-$10;42;", "7;7;7;7;7;7;7;7;7;7;7;7;7;7;7;", "hello;world;1;2;3;" };
static int32_t scans;
static struct { int32_t sum; int errors, fields, scale; } p;
static bool isdig(int c) { return c >= '0' && c <= '9'; }
static int hexv(int c) { return isdig(c) ? c - '0' : c >= 'A' && c <= 'F' ? c - 55 : c >= 'a' && c <= 'f' ? c - 87 : -1; }
static void parse(const char *t) {
  p.sum = 0; p.errors = p.fields = 0;
  PState st = Start; int32_t val = 0; bool neg = false;
  for (; *t; t++) {
    int c = (unsigned char)*t;
    if (c == ';') { p.sum += neg ? -val : val; p.fields++; st = Start; val = 0; neg = false; p.scale = 0; continue; }
    switch (st) {
    case Start: case Sign:
      if (c == '-' && st == Start) { neg = true; st = Sign; }
      else if (isdig(c)) { val = c - '0'; st = Digits; }
      else if (c == '$') st = HexMark;
      else if (c != ' ') { p.errors++; st = Skip; }
      break;
    case Digits:
      if (isdig(c)) val = val * 10 + (c - '0'); else if (c == '.') st = Fraction; else { p.errors++; st = Skip; }
      break;
    case Fraction:
      if (isdig(c)) { p.scale++; if (p.scale <= 2) val = val * 10 + c - '0'; } else { p.errors++; st = Skip; }
      break;
    case HexMark: case HexDigits:
      if (hexv(c) >= 0) { val = val * 16 + hexv(c); st = HexDigits; } else { p.errors++; st = Skip; }
      break;
    default: break;
    }
  }
}
void scan(void) {
  scans++; int32_t n = 0;
  for (int i = 0; i < 6; i++) {
    lines[i][0] = '0' + (scans + i) % 10;
    parse(lines[i]);
    n += p.sum * (i + 1) + p.errors * 100 + p.fields;
  }
  check = (check * 31 + (n < 0 ? -n : n) % 100003) % 1000003;
}
