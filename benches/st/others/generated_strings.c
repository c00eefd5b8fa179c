#include "st.h"
#include <string.h>
#include "digits.h"

static int32_t scans;
static char s00[81] = "MWM7ZFDEQ2XFUV9RM14ECNX45ER8Z6";
static char s01[81] = "DSEO5KR3OHS9T4RHZSU6M8GI3Z82A1";
static char s02[81] = "NPZH8JPUTZJ9FD60O0BU7JM1ZK7YTT";
static char s03[81] = "V6L4RM8N9BBGD30VK04GMBWL7DFQXK";
static char s04[81] = "I6PAKWDZJOMQH9ENC3KVVAMFNLQHRA";
static char s05[81] = "HK7QF7FJZGD8NYB5FO0GY932ZV4XJR";
static char s06[81] = "RN7S0FPSPHVS623NZGGNI9673L2OBG";
static char s07[81] = "NIKUY9N4359KUYBUDNMCGAHT1JI1HA";
static char s08[81] = "ASVX4ZLGPXZ81VQIQ7WEJZZY6ILNVP";
static char s09[81] = "J14SAECQUZ5PREGPGRMR3HM36TNFH6";
static char s10[81] = "ZEA9KEVSCDV6Q29LVQ8TLXBTC4U0BE";
static char s11[81] = "286PDO8YQYP6UU5OD49YUD9EM5DP07";
static char s12[81] = "OLTJA8TFXY2J3V1U359PFQD4JBVTLU";
static char s13[81] = "UAYZJOMCIL6BWJCQFUH065A2H33H03";
static char s14[81] = "S35M4G3FBSFXUST2WYZ8O835T9AG04";
static char s15[81] = "QLZOBNQHIY52B77JBBY7435DT0YJVC";

static void mid(char *to, const char *s, int len, int pos)
{
  memcpy(to, s + pos - 1, len);
  to[len] = 0;
}
static void left(char *to, const char *s, int len) { mid(to, s, len, 1); }
static void right(char *to, const char *s, int len) { strcpy(to, s + strlen(s) - len); }
static void concat(char *to, const char *a, const char *b)
{
  size_t la = strlen(a), lb = strlen(b);
  memcpy(to, a, la);
  memcpy(to + la, b, lb + 1);
}
static void delete(char *to, const char *s, int len, int pos)
{
  memcpy(to, s, pos - 1);
  strcpy(to + pos - 1, s + pos - 1 + len);
}
static void insert(char *to, const char *a, const char *b, int pos)
{
  size_t lb = strlen(b);
  memcpy(to, a, pos);
  memcpy(to + pos, b, lb);
  strcpy(to + pos + lb, a + pos);
}
static void replace(char *to, const char *a, const char *b, int len, int pos)
{
  size_t lb = strlen(b);
  memcpy(to, a, pos - 1);
  memcpy(to + pos - 1, b, lb);
  strcpy(to + pos - 1 + lb, a + pos - 1 + len);
}
static int find(const char *s, const char *what)
{
  const char *p = strstr(s, what);
  return p ? (int)(p - s) + 1 : 0;
}

void scan(void)
{
  char x[81], y[81];
  scans++;
  int32_t sum = 0;
  sum += find(s09, "1");
  left(x, s08, 20);
  right(y, s13, 15);
  concat(s01, x, y);
  sum += find(s08, "1");
  replace(s03, s13, "ccba", 2, 2);
  delete(s04, s08, 9, 6);
  strcat(s04, "padpadpadp");
  left(x, s03, 20);
  right(y, s00, 19);
  concat(s05, x, y);
  replace(s06, s03, "c-aa", 4, 8);
  left(x, s03, 17);
  right(y, s02, 16);
  concat(s07, x, y);
  if (strcmp(s13, s12) > 0) sum += 23;
  mid(x, s04, 10, 3);
  mid(y, s14, 9, 3);
  concat(s09, x, y);
  strcat(s09, "0123456789");
  left(x, s09, 8);
  right(y, s15, 11);
  concat(s10, x, y);
  strcat(s10, "padpadpadp");
  mid(x, s10, 15, 4);
  mid(y, s02, 10, 4);
  concat(s11, x, y);
  left(x, s14, 15);
  right(y, s10, 13);
  concat(s12, x, y);
  if (strcmp(s06, s11) > 0) sum += 57;
  mid(x, s10, 15, 2);
  mid(y, s04, 9, 2);
  concat(s14, x, y);
  delete(s15, s02, 9, 2);
  strcat(s15, "0123456789");
  replace(s00, s06, "c--b", 4, 9);
  delete(s01, s03, 10, 5);
  if (strcmp(s01, s12) > 0) sum += 31;
  mid(x, s05, 14, 3);
  mid(y, s09, 15, 1);
  concat(s03, x, y);
  delete(s04, s03, 8, 5);
  strcat(s04, "0123456789");
  insert(s05, s09, "xxxxz", 9);
  replace(s06, s14, "cacb", 3, 1);
  delete(s07, s00, 10, 6);
  mid(x, s10, 14, 1);
  mid(y, s12, 13, 1);
  concat(s08, x, y);
  left(x, s00, 20);
  right(y, s05, 19);
  concat(s09, x, y);
  if (strcmp(s05, s08) > 0) sum += 22;
  delete(s11, s05, 10, 1);
  left(x, s07, 20);
  right(y, s00, 14);
  concat(s12, x, y);
  left(x, s04, 9);
  right(y, s06, 15);
  concat(s13, x, y);
  replace(s14, s08, "aba-", 5, 8);
  sum += find(s05, "9");
  replace(s00, s15, "cab-", 6, 1);
  left(x, s02, 19);
  digits(scans * 13 % 90 + 10, y);
  concat(s01, x, y);
  strcat(s01, "0123456789");
  left(x, s13, 19);
  right(y, s03, 19);
  concat(s02, x, y);
  delete(s03, s15, 10, 2);
  strcat(s03, "0123456789");
  left(x, s11, 18);
  right(y, s14, 17);
  concat(s04, x, y);
  replace(s05, s13, "-bb-", 5, 8);
  mid(x, s00, 12, 2);
  mid(y, s04, 10, 3);
  concat(s06, x, y);
  left(x, s05, 15);
  right(y, s15, 15);
  concat(s07, x, y);
  mid(x, s15, 10, 1);
  mid(y, s12, 13, 1);
  concat(s08, x, y);
  sum += find(s10, "B");
  mid(x, s15, 11, 4);
  mid(y, s04, 10, 4);
  concat(s10, x, y);
  strcat(s10, "0123456789");
  replace(s11, s10, "acb-", 3, 8);
  left(x, s05, 16);
  right(y, s11, 10);
  concat(s12, x, y);
  delete(s13, s04, 10, 8);
  insert(s14, s04, "xzzxz", 9);
  left(x, s08, 16);
  right(y, s06, 19);
  concat(s15, x, y);
  mid(x, s09, 10, 4);
  mid(y, s14, 15, 2);
  concat(s00, x, y);
  mid(x, s07, 12, 1);
  mid(y, s05, 12, 1);
  concat(s01, x, y);
  left(x, s15, 21);
  digits(scans * 4 % 7 + 1, y);
  concat(s02, x, y);
  replace(s03, s06, "-aca", 6, 8);
  strcat(s03, "padpadpadp");
  sum += find(s06, "7");
  replace(s05, s02, "cc-c", 5, 4);
  strcat(s05, "padpadpadp");
  left(x, s09, 20);
  right(y, s14, 17);
  concat(s06, x, y);
  left(x, s03, 17);
  right(y, s14, 16);
  concat(s07, x, y);
  replace(s08, s02, "cca-", 5, 10);
  strcat(s08, "0123456789");
  left(x, s10, 12);
  right(y, s15, 8);
  concat(s09, x, y);
  strcat(s09, "padpadpadp");
  if (strcmp(s13, s06) > 0) sum += 40;
  if (strcmp(s12, s07) > 0) sum += 59;
  sum += find(s08, "7");
  replace(s13, s03, "caba", 2, 9);
  sum += find(s11, "B");
  insert(s15, s04, "#xxzz", 1);
  left(x, s05, 18);
  digits(scans * 3 % 90 + 10, y);
  concat(s00, x, y);
  strcat(s00, "0123456789");
  replace(s01, s12, "bcc-", 5, 5);
  left(x, s14, 8);
  right(y, s10, 18);
  concat(s02, x, y);
  left(x, s04, 20);
  digits(scans * 5 % 7 + 1, y);
  concat(s03, x, y);
  strcat(s03, "padpadpadp");
  left(x, s11, 16);
  digits(scans * 13 % 90 + 10, y);
  concat(s04, x, y);
  strcat(s04, "0123456789");
  left(x, s13, 14);
  right(y, s01, 10);
  concat(s05, x, y);
  sum += (int)strlen(s00) * 1 + find(s00, "1");
  sum += (int)strlen(s01) * 2 + find(s01, "1");
  sum += (int)strlen(s02) * 3 + find(s02, "1");
  sum += (int)strlen(s03) * 4 + find(s03, "1");
  sum += (int)strlen(s04) * 5 + find(s04, "1");
  sum += (int)strlen(s05) * 6 + find(s05, "1");
  sum += (int)strlen(s06) * 7 + find(s06, "1");
  sum += (int)strlen(s07) * 8 + find(s07, "1");
  sum += (int)strlen(s08) * 9 + find(s08, "1");
  sum += (int)strlen(s09) * 10 + find(s09, "1");
  sum += (int)strlen(s10) * 11 + find(s10, "1");
  sum += (int)strlen(s11) * 12 + find(s11, "1");
  sum += (int)strlen(s12) * 13 + find(s12, "1");
  sum += (int)strlen(s13) * 14 + find(s13, "1");
  sum += (int)strlen(s14) * 15 + find(s14, "1");
  sum += (int)strlen(s15) * 16 + find(s15, "1");
  check = (check + sum) % 1000003;
}
