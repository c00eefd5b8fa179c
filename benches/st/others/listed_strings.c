/* The program of the same name once more, in C. */
#include "st.h"
#include <stdbool.h>
#include <string.h>

typedef struct { unsigned char len; char s[80]; } Str;

static inline void str_part(Str *d, const Str *a, int from, int count)
{
  memcpy(d->s, a->s + from, count);
  d->len = count;
}

static inline void str_left(Str *d, const Str *a, int l) { str_part(d, a, 0, l < a->len ? l : a->len); }

static inline void str_right(Str *d, const Str *a, int l)
{
  if (l > a->len)
    l = a->len;
  str_part(d, a, a->len - l, l);
}

static inline void str_mid(Str *d, const Str *a, int l, int p)
{
  int rest = a->len - (p - 1);
  if (rest < 0)
    rest = 0;
  str_part(d, a, p - 1, l < rest ? l : rest);
}

static inline void str_concat(Str *d, const Str *a, const Str *b)
{
  memcpy(d->s, a->s, a->len);
  memcpy(d->s + a->len, b->s, b->len);
  d->len = a->len + b->len;
}

/* The first `head` of a, all of b, and what follows `tail` in a. */
static inline void str_splice(Str *d, const Str *a, const Str *b, int head, int tail)
{
  memcpy(d->s, a->s, head);
  memcpy(d->s + head, b->s, b->len);
  memcpy(d->s + head + b->len, a->s + tail, a->len - tail);
  d->len = head + b->len + a->len - tail;
}

static inline void str_insert(Str *d, const Str *a, const Str *b, int p) { str_splice(d, a, b, p, p); }

static inline void str_replace(Str *d, const Str *a, const Str *b, int l, int p)
{
  str_splice(d, a, b, p - 1, p - 1 + l);
}

static inline void str_delete(Str *d, const Str *a, int l, int p)
{
  memcpy(d->s, a->s, p - 1);
  memcpy(d->s + p - 1, a->s + p - 1 + l, a->len - (p - 1 + l));
  d->len = a->len - l;
}

static inline int str_find(const Str *a, const Str *b)
{
  for (int i = 0; i + b->len <= a->len; i++)
    if (memcmp(a->s + i, b->s, b->len) == 0)
      return i + 1;
  return 0;
}

static inline int str_compare(const Str *a, const Str *b)
{
  int order = memcmp(a->s, b->s, a->len < b->len ? a->len : b->len);
  return order ? order : a->len - b->len;
}

static Str words[8] = {
  { 8, "conveyor" },
  { 8, "gripper1" },
  { 8, "valve_07" },
  { 8, "pressure" },
  { 8, "tank_lvl" },
  { 8, "motor_on" },
  { 8, "setpoint" },
  { 8, "alarm_hi" }
};
static int32_t cycle;
static Str name_0 = { 8, "north___" };
static Str name_1 = { 8, "southern" };
static Str name_2 = { 8, "eastward" };
static Str name_3 = { 8, "westerly" };
static const Str lit01 = { 3, "[b]" };
static const Str lit02 = { 5, "ceyvl" };
static const Str lit03 = { 2, "ey" };
static const Str lit04 = { 3, "{c}" };
static const Str lit05 = { 5, "qtqhl" };
static const Str lit06 = { 1, "q" };
static const Str lit07 = { 3, "(d)" };
static const Str lit08 = { 5, "ftizs" };
static const Str lit09 = { 2, "ti" };
static const Str lit10 = { 3, "<a>" };
static const Str lit11 = { 5, "mvddw" };
static const Str lit12 = { 1, "j" };
static const Str lit13 = { 5, "frjlf" };
static const Str lit14 = { 5, "klazb" };
static const Str lit15 = { 5, "yulqz" };
static const Str lit16 = { 2, "se" };
static const Str lit17 = { 5, "ryizl" };
static const Str lit18 = { 2, "mo" };
static const Str lit19 = { 5, "ajpsw" };
static const Str lit20 = { 2, "ta" };
static const Str lit21 = { 5, "eifnb" };
static const Str lit22 = { 5, "yovjw" };
static const Str lit23 = { 5, "jlzyp" };
static const Str lit24 = { 2, "lz" };
static const Str lit25 = { 5, "ylfwo" };
static const Str lit26 = { 2, "al" };
static const Str lit27 = { 5, "slkfk" };
static const Str lit28 = { 1, "d" };
static const Str lit29 = { 5, "ajjid" };
static const Str lit30 = { 1, "a" };
static const Str lit31 = { 5, "thbzl" };
static const Str lit32 = { 1, "v" };
static const Str lit33 = { 5, "ywygh" };
static const Str lit34 = { 5, "djkjx" };
static const Str lit35 = { 1, "k" };
static const Str lit36 = { 5, "vadxv" };
static const Str lit37 = { 2, "ad" };
static const Str lit38 = { 5, "najod" };
static const Str lit39 = { 5, "hiacn" };
static const Str lit40 = { 2, "ia" };
static const Str lit41 = { 5, "vsygo" };
static const Str lit42 = { 5, "ekxku" };
static const Str lit43 = { 5, "mnaku" };
static const Str lit44 = { 5, "cveou" };
static const Str lit45 = { 5, "hsafw" };
static const Str lit46 = { 2, "sa" };
static const Str lit47 = { 5, "xvzen" };
static const Str lit48 = { 2, "vz" };
static const Str lit49 = { 5, "rbnky" };
static const Str lit50 = { 1, "g" };
static const Str lit51 = { 5, "vrvtj" };
static const Str lit52 = { 2, "rv" };
static const Str lit53 = { 5, "iwesk" };
static const Str lit54 = { 2, "va" };
static const Str lit55 = { 5, "pjofi" };
static const Str lit56 = { 5, "wfdsd" };
static const Str lit57 = { 2, "fd" };
static const Str lit58 = { 5, "zvnfq" };
static const Str lit59 = { 2, "gr" };
static const Str lit60 = { 5, "kgnif" };
static const Str lit61 = { 5, "yjynw" };
static const Str lit62 = { 1, "y" };
static const Str lit63 = { 5, "pjkhz" };
static const Str lit64 = { 5, "ndnef" };
static const Str lit65 = { 5, "laajm" };
static const Str lit66 = { 5, "jonec" };
static const Str lit67 = { 1, "o" };
static const Str lit68 = { 5, "aihub" };
static Str s01 = { 20, "mgkfuaqywakvoehdwetf" };
static Str s02 = { 20, "onkvnejfdokbehoghfah" };
static Str s03 = { 20, "uqozqapwmqmpqcpemaee" };
static Str s04 = { 20, "njwuaedrqcmjkwgnlqao" };
static Str s05 = { 20, "wlsktttmfljvnqyszknp" };
static Str s06 = { 20, "bujnzhnlbbkhqowyzwjc" };
static Str s07 = { 20, "rbxjeblrgyvhxanpeumb" };
static Str s08 = { 20, "xqvwexypjvttjcwjqsog" };
static Str s09 = { 20, "ixabkfgwmtyfpqxmswwm" };
static Str s10 = { 20, "hvubjlkmllomwumzrktm" };
static Str s11 = { 20, "fjglfwjpknqxvysngake" };
static Str s12 = { 20, "afdxvomvjgkoepuhgyzf" };
static Str s13 = { 20, "vjfxkvxqbdjfchksrtwn" };
static Str s14 = { 20, "ijgmmznajqhyecmbvcyz" };
static Str s15 = { 20, "ekbgqzknoxzxvoyndhdn" };
static Str s16 = { 20, "jywxhjmzxjjkdflqotgt" };
static Str s17 = { 20, "kjclwgqwtfmamhzndjao" };
static Str s18 = { 20, "ysjvjrilawpgkalkjtpr" };
static Str s19 = { 20, "rkzzjaklolsquyrfwvvg" };
static Str s20 = { 20, "ibcjuobmreedqjnylfxp" };
static Str s21 = { 20, "hviykhpuuhapiilicsgc" };
static Str s22 = { 20, "fkvltlplmdqcusyhfuho" };
static Str s23 = { 20, "psvuxogpbdapvvnevmhz" };
static Str s24 = { 20, "vhcigqzzufxvfvnlxptu" };
static Str s25 = { 20, "kagnppqktxvtmoxhaaqn" };
static Str s26 = { 20, "fiymkapwgxinrxwipjbk" };
static Str s27 = { 20, "setnfowtsmmyifttjrbe" };
static Str s28 = { 20, "qhmbjmfuguhbjlizahoa" };
static Str s29 = { 20, "ythuwufqkffhddartkke" };
static Str s30 = { 20, "haynebmqgvvycnszszta" };
static Str s31 = { 20, "luzjrfpaorqfaixcpaix" };
static Str s32 = { 20, "ozodzhwrtddjrfkwpvkr" };
static Str s33 = { 20, "lrxxcncvnnmxewduzjow" };
static Str s34 = { 20, "nwcqholxuribqhrcoqdq" };
static Str s35 = { 20, "kskpeagzdayqlqdeuufh" };
static Str s36 = { 20, "sizgljoojutczyronpyd" };
static Str s37 = { 20, "ieosdpkitywktocxsvwa" };
static Str s38 = { 20, "jhooplynqfrjmrrijysa" };
static Str s39 = { 20, "nzducglonsrvkxrznonk" };
static Str s40 = { 20, "orqiiwdrnswmatnouocy" };
static Str t1, t2, t3, t4;

void scan(void)
{
  int32_t acc = 0;
  int p, pos;
  cycle++;
  /* string 1 */
  p = (cycle * 6 + 14) % 20;
  str_concat(&t1, &s01, &words[(cycle + 16) % 8]);
  str_insert(&t2, &t1, &lit01, p);
  str_replace(&t3, &t2, &lit02, 4, p + 5);
  str_delete(&t4, &t3, 3, p + 4);
  pos = str_find(&t4, &lit03);
  acc += pos * 2 + t4.len;
  str_left(&t1, &t4, 4);
  str_right(&t2, &t4, 6);
  if (str_compare(&t1, &t2) < 0) acc += 1;
  if (str_compare(&s01, &s02) >= 0) acc += 3;
  str_right(&t3, &s01, 6);
  if (str_compare(&t2, &t3) == 0) acc += 4;
  str_mid(&s01, &t4, 20, p / 2 + 1);
  /* string 2 */
  p = (cycle * 4 + 7) % 20;
  str_concat(&t1, &s02, &name_1);
  str_insert(&t2, &t1, &lit04, p);
  str_replace(&t3, &t2, &lit05, 4, p + 2);
  str_delete(&t4, &t3, 3, p + 7);
  pos = str_find(&t4, &lit06);
  acc += pos * 3 + t4.len;
  str_left(&t1, &t4, 6);
  str_right(&t2, &t4, 3);
  if (str_compare(&t1, &t2) < 0) acc += 2;
  if (str_compare(&s02, &s03) >= 0) acc += 5;
  str_right(&t3, &s02, 3);
  if (str_compare(&t2, &t3) == 0) acc += 7;
  str_mid(&s02, &t4, 20, p / 2 + 1);
  /* string 3 */
  p = (cycle * 5 + 1) % 20;
  str_concat(&t1, &s03, &words[(cycle + 20) % 8]);
  str_insert(&t2, &t1, &lit07, p);
  str_replace(&t3, &t2, &lit08, 4, p + 2);
  str_delete(&t4, &t3, 3, p + 3);
  pos = str_find(&t4, &lit09);
  acc += pos * 4 + t4.len;
  str_left(&t1, &t4, 6);
  str_right(&t2, &t4, 14);
  if (str_compare(&t1, &t2) < 0) acc += 3;
  if (str_compare(&s03, &s04) >= 0) acc += 7;
  str_right(&t3, &s03, 14);
  if (str_compare(&t2, &t3) == 0) acc += 10;
  str_mid(&s03, &t4, 20, p / 2 + 1);
  /* string 4 */
  p = (cycle * 4 + 1) % 20;
  str_concat(&t1, &s04, &name_2);
  str_insert(&t2, &t1, &lit10, p);
  str_replace(&t3, &t2, &lit11, 4, p + 7);
  str_delete(&t4, &t3, 3, p + 4);
  pos = str_find(&t4, &lit12);
  acc += pos * 5 + t4.len;
  str_left(&t1, &t4, 4);
  str_right(&t2, &t4, 12);
  if (str_compare(&t1, &t2) < 0) acc += 4;
  if (str_compare(&s04, &s05) >= 0) acc += 9;
  str_right(&t3, &s04, 12);
  if (str_compare(&t2, &t3) == 0) acc += 13;
  str_mid(&s04, &t4, 20, p / 2 + 1);
  /* string 5 */
  p = (cycle * 9 + 10) % 20;
  str_concat(&t1, &s05, &words[(cycle + 22) % 8]);
  str_insert(&t2, &t1, &lit01, p);
  str_replace(&t3, &t2, &lit13, 4, p + 7);
  str_delete(&t4, &t3, 3, p + 10);
  pos = str_find(&t4, &lit07);
  acc += pos * 6 + t4.len;
  str_left(&t1, &t4, 10);
  str_right(&t2, &t4, 10);
  if (str_compare(&t1, &t2) < 0) acc += 5;
  if (str_compare(&s05, &s06) >= 0) acc += 11;
  str_right(&t3, &s05, 10);
  if (str_compare(&t2, &t3) == 0) acc += 16;
  str_mid(&s05, &t4, 20, p / 2 + 1);
  /* string 6 */
  p = (cycle * 2 + 12) % 20;
  str_concat(&t1, &s06, &name_3);
  str_insert(&t2, &t1, &lit04, p);
  str_replace(&t3, &t2, &lit14, 4, p + 8);
  str_delete(&t4, &t3, 3, p + 3);
  pos = str_find(&t4, &lit10);
  acc += pos * 7 + t4.len;
  str_left(&t1, &t4, 4);
  str_right(&t2, &t4, 14);
  if (str_compare(&t1, &t2) < 0) acc += 6;
  if (str_compare(&s06, &s07) >= 0) acc += 13;
  str_right(&t3, &s06, 14);
  if (str_compare(&t2, &t3) == 0) acc += 19;
  str_mid(&s06, &t4, 20, p / 2 + 1);
  /* string 7 */
  p = (cycle * 6 + 2) % 20;
  str_concat(&t1, &s07, &words[(cycle + 6) % 8]);
  str_insert(&t2, &t1, &lit07, p);
  str_replace(&t3, &t2, &lit15, 4, p + 1);
  str_delete(&t4, &t3, 3, p + 6);
  pos = str_find(&t4, &lit16);
  acc += pos * 1 + t4.len;
  str_left(&t1, &t4, 7);
  str_right(&t2, &t4, 11);
  if (str_compare(&t1, &t2) < 0) acc += 7;
  if (str_compare(&s07, &s08) >= 0) acc += 15;
  str_right(&t3, &s07, 11);
  if (str_compare(&t2, &t3) == 0) acc += 22;
  str_mid(&s07, &t4, 20, p / 2 + 1);
  /* string 8 */
  p = (cycle * 3 + 3) % 20;
  str_concat(&t1, &s08, &name_0);
  str_insert(&t2, &t1, &lit10, p);
  str_replace(&t3, &t2, &lit17, 4, p + 7);
  str_delete(&t4, &t3, 3, p + 5);
  pos = str_find(&t4, &lit18);
  acc += pos * 2 + t4.len;
  str_left(&t1, &t4, 7);
  str_right(&t2, &t4, 14);
  if (str_compare(&t1, &t2) < 0) acc += 8;
  if (str_compare(&s08, &s09) >= 0) acc += 17;
  str_right(&t3, &s08, 14);
  if (str_compare(&t2, &t3) == 0) acc += 25;
  str_mid(&s08, &t4, 20, p / 2 + 1);
  /* string 9 */
  p = (cycle * 8 + 1) % 20;
  str_concat(&t1, &s09, &words[(cycle + 22) % 8]);
  str_insert(&t2, &t1, &lit01, p);
  str_replace(&t3, &t2, &lit19, 4, p + 1);
  str_delete(&t4, &t3, 3, p + 9);
  pos = str_find(&t4, &lit20);
  acc += pos * 3 + t4.len;
  str_left(&t1, &t4, 6);
  str_right(&t2, &t4, 8);
  if (str_compare(&t1, &t2) < 0) acc += 9;
  if (str_compare(&s09, &s10) >= 0) acc += 19;
  str_right(&t3, &s09, 8);
  if (str_compare(&t2, &t3) == 0) acc += 28;
  str_mid(&s09, &t4, 20, p / 2 + 1);
  /* string 10 */
  p = (cycle * 1 + 19) % 20;
  str_concat(&t1, &s10, &name_1);
  str_insert(&t2, &t1, &lit04, p);
  str_replace(&t3, &t2, &lit21, 4, p + 6);
  str_delete(&t4, &t3, 3, p + 4);
  pos = str_find(&t4, &lit01);
  acc += pos * 4 + t4.len;
  str_left(&t1, &t4, 9);
  str_right(&t2, &t4, 14);
  if (str_compare(&t1, &t2) < 0) acc += 10;
  if (str_compare(&s10, &s11) >= 0) acc += 21;
  str_right(&t3, &s10, 14);
  if (str_compare(&t2, &t3) == 0) acc += 31;
  str_mid(&s10, &t4, 20, p / 2 + 1);
  /* string 11 */
  p = (cycle * 1 + 10) % 20;
  str_concat(&t1, &s11, &words[(cycle + 28) % 8]);
  str_insert(&t2, &t1, &lit07, p);
  str_replace(&t3, &t2, &lit22, 4, p + 8);
  str_delete(&t4, &t3, 3, p + 8);
  pos = str_find(&t4, &lit16);
  acc += pos * 5 + t4.len;
  str_left(&t1, &t4, 13);
  str_right(&t2, &t4, 10);
  if (str_compare(&t1, &t2) < 0) acc += 11;
  if (str_compare(&s11, &s12) >= 0) acc += 23;
  str_right(&t3, &s11, 10);
  if (str_compare(&t2, &t3) == 0) acc += 34;
  str_mid(&s11, &t4, 20, p / 2 + 1);
  /* string 12 */
  p = (cycle * 2 + 6) % 20;
  str_concat(&t1, &s12, &name_2);
  str_insert(&t2, &t1, &lit10, p);
  str_replace(&t3, &t2, &lit23, 4, p + 6);
  str_delete(&t4, &t3, 3, p + 4);
  pos = str_find(&t4, &lit24);
  acc += pos * 6 + t4.len;
  str_left(&t1, &t4, 5);
  str_right(&t2, &t4, 9);
  if (str_compare(&t1, &t2) < 0) acc += 12;
  if (str_compare(&s12, &s13) >= 0) acc += 25;
  str_right(&t3, &s12, 9);
  if (str_compare(&t2, &t3) == 0) acc += 37;
  str_mid(&s12, &t4, 20, p / 2 + 1);
  /* string 13 */
  p = (cycle * 3 + 0) % 20;
  str_concat(&t1, &s13, &words[(cycle + 11) % 8]);
  str_insert(&t2, &t1, &lit01, p);
  str_replace(&t3, &t2, &lit25, 4, p + 6);
  str_delete(&t4, &t3, 3, p + 3);
  pos = str_find(&t4, &lit26);
  acc += pos * 7 + t4.len;
  str_left(&t1, &t4, 12);
  str_right(&t2, &t4, 6);
  if (str_compare(&t1, &t2) < 0) acc += 13;
  if (str_compare(&s13, &s14) >= 0) acc += 27;
  str_right(&t3, &s13, 6);
  if (str_compare(&t2, &t3) == 0) acc += 40;
  str_mid(&s13, &t4, 20, p / 2 + 1);
  /* string 14 */
  p = (cycle * 7 + 19) % 20;
  str_concat(&t1, &s14, &name_3);
  str_insert(&t2, &t1, &lit04, p);
  str_replace(&t3, &t2, &lit27, 4, p + 6);
  str_delete(&t4, &t3, 3, p + 7);
  pos = str_find(&t4, &lit28);
  acc += pos * 1 + t4.len;
  str_left(&t1, &t4, 11);
  str_right(&t2, &t4, 7);
  if (str_compare(&t1, &t2) < 0) acc += 14;
  if (str_compare(&s14, &s15) >= 0) acc += 29;
  str_right(&t3, &s14, 7);
  if (str_compare(&t2, &t3) == 0) acc += 43;
  str_mid(&s14, &t4, 20, p / 2 + 1);
  /* string 15 */
  p = (cycle * 8 + 9) % 20;
  str_concat(&t1, &s15, &words[(cycle + 2) % 8]);
  str_insert(&t2, &t1, &lit07, p);
  str_replace(&t3, &t2, &lit29, 4, p + 3);
  str_delete(&t4, &t3, 3, p + 4);
  pos = str_find(&t4, &lit30);
  acc += pos * 2 + t4.len;
  str_left(&t1, &t4, 6);
  str_right(&t2, &t4, 13);
  if (str_compare(&t1, &t2) < 0) acc += 15;
  if (str_compare(&s15, &s16) >= 0) acc += 31;
  str_right(&t3, &s15, 13);
  if (str_compare(&t2, &t3) == 0) acc += 46;
  str_mid(&s15, &t4, 20, p / 2 + 1);
  /* string 16 */
  p = (cycle * 2 + 19) % 20;
  str_concat(&t1, &s16, &name_0);
  str_insert(&t2, &t1, &lit10, p);
  str_replace(&t3, &t2, &lit31, 4, p + 4);
  str_delete(&t4, &t3, 3, p + 1);
  pos = str_find(&t4, &lit32);
  acc += pos * 3 + t4.len;
  str_left(&t1, &t4, 7);
  str_right(&t2, &t4, 13);
  if (str_compare(&t1, &t2) < 0) acc += 16;
  if (str_compare(&s16, &s17) >= 0) acc += 33;
  str_right(&t3, &s16, 13);
  if (str_compare(&t2, &t3) == 0) acc += 49;
  str_mid(&s16, &t4, 20, p / 2 + 1);
  /* string 17 */
  p = (cycle * 7 + 5) % 20;
  str_concat(&t1, &s17, &words[(cycle + 19) % 8]);
  str_insert(&t2, &t1, &lit01, p);
  str_replace(&t3, &t2, &lit33, 4, p + 5);
  str_delete(&t4, &t3, 3, p + 1);
  pos = str_find(&t4, &lit18);
  acc += pos * 4 + t4.len;
  str_left(&t1, &t4, 14);
  str_right(&t2, &t4, 4);
  if (str_compare(&t1, &t2) < 0) acc += 17;
  if (str_compare(&s17, &s18) >= 0) acc += 35;
  str_right(&t3, &s17, 4);
  if (str_compare(&t2, &t3) == 0) acc += 52;
  str_mid(&s17, &t4, 20, p / 2 + 1);
  /* string 18 */
  p = (cycle * 7 + 3) % 20;
  str_concat(&t1, &s18, &name_1);
  str_insert(&t2, &t1, &lit04, p);
  str_replace(&t3, &t2, &lit34, 4, p + 7);
  str_delete(&t4, &t3, 3, p + 9);
  pos = str_find(&t4, &lit35);
  acc += pos * 5 + t4.len;
  str_left(&t1, &t4, 6);
  str_right(&t2, &t4, 5);
  if (str_compare(&t1, &t2) < 0) acc += 18;
  if (str_compare(&s18, &s19) >= 0) acc += 37;
  str_right(&t3, &s18, 5);
  if (str_compare(&t2, &t3) == 0) acc += 55;
  str_mid(&s18, &t4, 20, p / 2 + 1);
  /* string 19 */
  p = (cycle * 8 + 8) % 20;
  str_concat(&t1, &s19, &words[(cycle + 5) % 8]);
  str_insert(&t2, &t1, &lit07, p);
  str_replace(&t3, &t2, &lit36, 4, p + 2);
  str_delete(&t4, &t3, 3, p + 8);
  pos = str_find(&t4, &lit37);
  acc += pos * 6 + t4.len;
  str_left(&t1, &t4, 7);
  str_right(&t2, &t4, 10);
  if (str_compare(&t1, &t2) < 0) acc += 19;
  if (str_compare(&s19, &s20) >= 0) acc += 39;
  str_right(&t3, &s19, 10);
  if (str_compare(&t2, &t3) == 0) acc += 58;
  str_mid(&s19, &t4, 20, p / 2 + 1);
  /* string 20 */
  p = (cycle * 6 + 17) % 20;
  str_concat(&t1, &s20, &name_2);
  str_insert(&t2, &t1, &lit10, p);
  str_replace(&t3, &t2, &lit38, 4, p + 3);
  str_delete(&t4, &t3, 3, p + 9);
  pos = str_find(&t4, &lit10);
  acc += pos * 7 + t4.len;
  str_left(&t1, &t4, 11);
  str_right(&t2, &t4, 3);
  if (str_compare(&t1, &t2) < 0) acc += 20;
  if (str_compare(&s20, &s21) >= 0) acc += 41;
  str_right(&t3, &s20, 3);
  if (str_compare(&t2, &t3) == 0) acc += 61;
  str_mid(&s20, &t4, 20, p / 2 + 1);
  /* string 21 */
  p = (cycle * 8 + 18) % 20;
  str_concat(&t1, &s21, &words[(cycle + 7) % 8]);
  str_insert(&t2, &t1, &lit01, p);
  str_replace(&t3, &t2, &lit39, 4, p + 1);
  str_delete(&t4, &t3, 3, p + 6);
  pos = str_find(&t4, &lit40);
  acc += pos * 1 + t4.len;
  str_left(&t1, &t4, 12);
  str_right(&t2, &t4, 5);
  if (str_compare(&t1, &t2) < 0) acc += 21;
  if (str_compare(&s21, &s22) >= 0) acc += 43;
  str_right(&t3, &s21, 5);
  if (str_compare(&t2, &t3) == 0) acc += 64;
  str_mid(&s21, &t4, 20, p / 2 + 1);
  /* string 22 */
  p = (cycle * 2 + 20) % 20;
  str_concat(&t1, &s22, &name_3);
  str_insert(&t2, &t1, &lit04, p);
  str_replace(&t3, &t2, &lit41, 4, p + 8);
  str_delete(&t4, &t3, 3, p + 5);
  pos = str_find(&t4, &lit32);
  acc += pos * 2 + t4.len;
  str_left(&t1, &t4, 14);
  str_right(&t2, &t4, 8);
  if (str_compare(&t1, &t2) < 0) acc += 22;
  if (str_compare(&s22, &s23) >= 0) acc += 45;
  str_right(&t3, &s22, 8);
  if (str_compare(&t2, &t3) == 0) acc += 67;
  str_mid(&s22, &t4, 20, p / 2 + 1);
  /* string 23 */
  p = (cycle * 1 + 5) % 20;
  str_concat(&t1, &s23, &words[(cycle + 29) % 8]);
  str_insert(&t2, &t1, &lit07, p);
  str_replace(&t3, &t2, &lit42, 4, p + 6);
  str_delete(&t4, &t3, 3, p + 2);
  pos = str_find(&t4, &lit35);
  acc += pos * 3 + t4.len;
  str_left(&t1, &t4, 13);
  str_right(&t2, &t4, 12);
  if (str_compare(&t1, &t2) < 0) acc += 23;
  if (str_compare(&s23, &s24) >= 0) acc += 47;
  str_right(&t3, &s23, 12);
  if (str_compare(&t2, &t3) == 0) acc += 70;
  str_mid(&s23, &t4, 20, p / 2 + 1);
  /* string 24 */
  p = (cycle * 2 + 5) % 20;
  str_concat(&t1, &s24, &name_0);
  str_insert(&t2, &t1, &lit10, p);
  str_replace(&t3, &t2, &lit43, 4, p + 1);
  str_delete(&t4, &t3, 3, p + 7);
  pos = str_find(&t4, &lit35);
  acc += pos * 4 + t4.len;
  str_left(&t1, &t4, 14);
  str_right(&t2, &t4, 12);
  if (str_compare(&t1, &t2) < 0) acc += 24;
  if (str_compare(&s24, &s25) >= 0) acc += 49;
  str_right(&t3, &s24, 12);
  if (str_compare(&t2, &t3) == 0) acc += 73;
  str_mid(&s24, &t4, 20, p / 2 + 1);
  /* string 25 */
  p = (cycle * 4 + 12) % 20;
  str_concat(&t1, &s25, &words[(cycle + 29) % 8]);
  str_insert(&t2, &t1, &lit01, p);
  str_replace(&t3, &t2, &lit44, 4, p + 1);
  str_delete(&t4, &t3, 3, p + 4);
  pos = str_find(&t4, &lit10);
  acc += pos * 5 + t4.len;
  str_left(&t1, &t4, 9);
  str_right(&t2, &t4, 5);
  if (str_compare(&t1, &t2) < 0) acc += 25;
  if (str_compare(&s25, &s26) >= 0) acc += 51;
  str_right(&t3, &s25, 5);
  if (str_compare(&t2, &t3) == 0) acc += 76;
  str_mid(&s25, &t4, 20, p / 2 + 1);
  /* string 26 */
  p = (cycle * 9 + 10) % 20;
  str_concat(&t1, &s26, &name_1);
  str_insert(&t2, &t1, &lit04, p);
  str_replace(&t3, &t2, &lit45, 4, p + 4);
  str_delete(&t4, &t3, 3, p + 5);
  pos = str_find(&t4, &lit46);
  acc += pos * 6 + t4.len;
  str_left(&t1, &t4, 14);
  str_right(&t2, &t4, 3);
  if (str_compare(&t1, &t2) < 0) acc += 26;
  if (str_compare(&s26, &s27) >= 0) acc += 53;
  str_right(&t3, &s26, 3);
  if (str_compare(&t2, &t3) == 0) acc += 79;
  str_mid(&s26, &t4, 20, p / 2 + 1);
  /* string 27 */
  p = (cycle * 6 + 5) % 20;
  str_concat(&t1, &s27, &words[(cycle + 14) % 8]);
  str_insert(&t2, &t1, &lit07, p);
  str_replace(&t3, &t2, &lit47, 4, p + 8);
  str_delete(&t4, &t3, 3, p + 6);
  pos = str_find(&t4, &lit48);
  acc += pos * 7 + t4.len;
  str_left(&t1, &t4, 11);
  str_right(&t2, &t4, 10);
  if (str_compare(&t1, &t2) < 0) acc += 27;
  if (str_compare(&s27, &s28) >= 0) acc += 55;
  str_right(&t3, &s27, 10);
  if (str_compare(&t2, &t3) == 0) acc += 82;
  str_mid(&s27, &t4, 20, p / 2 + 1);
  /* string 28 */
  p = (cycle * 8 + 13) % 20;
  str_concat(&t1, &s28, &name_2);
  str_insert(&t2, &t1, &lit10, p);
  str_replace(&t3, &t2, &lit49, 4, p + 6);
  str_delete(&t4, &t3, 3, p + 7);
  pos = str_find(&t4, &lit50);
  acc += pos * 1 + t4.len;
  str_left(&t1, &t4, 10);
  str_right(&t2, &t4, 6);
  if (str_compare(&t1, &t2) < 0) acc += 28;
  if (str_compare(&s28, &s29) >= 0) acc += 57;
  str_right(&t3, &s28, 6);
  if (str_compare(&t2, &t3) == 0) acc += 85;
  str_mid(&s28, &t4, 20, p / 2 + 1);
  /* string 29 */
  p = (cycle * 4 + 20) % 20;
  str_concat(&t1, &s29, &words[(cycle + 11) % 8]);
  str_insert(&t2, &t1, &lit01, p);
  str_replace(&t3, &t2, &lit51, 4, p + 3);
  str_delete(&t4, &t3, 3, p + 7);
  pos = str_find(&t4, &lit52);
  acc += pos * 2 + t4.len;
  str_left(&t1, &t4, 10);
  str_right(&t2, &t4, 14);
  if (str_compare(&t1, &t2) < 0) acc += 29;
  if (str_compare(&s29, &s30) >= 0) acc += 59;
  str_right(&t3, &s29, 14);
  if (str_compare(&t2, &t3) == 0) acc += 88;
  str_mid(&s29, &t4, 20, p / 2 + 1);
  /* string 30 */
  p = (cycle * 2 + 17) % 20;
  str_concat(&t1, &s30, &name_3);
  str_insert(&t2, &t1, &lit04, p);
  str_replace(&t3, &t2, &lit53, 4, p + 3);
  str_delete(&t4, &t3, 3, p + 1);
  pos = str_find(&t4, &lit54);
  acc += pos * 3 + t4.len;
  str_left(&t1, &t4, 8);
  str_right(&t2, &t4, 4);
  if (str_compare(&t1, &t2) < 0) acc += 30;
  if (str_compare(&s30, &s31) >= 0) acc += 61;
  str_right(&t3, &s30, 4);
  if (str_compare(&t2, &t3) == 0) acc += 91;
  str_mid(&s30, &t4, 20, p / 2 + 1);
  /* string 31 */
  p = (cycle * 3 + 3) % 20;
  str_concat(&t1, &s31, &words[(cycle + 3) % 8]);
  str_insert(&t2, &t1, &lit07, p);
  str_replace(&t3, &t2, &lit55, 4, p + 3);
  str_delete(&t4, &t3, 3, p + 1);
  pos = str_find(&t4, &lit28);
  acc += pos * 4 + t4.len;
  str_left(&t1, &t4, 4);
  str_right(&t2, &t4, 3);
  if (str_compare(&t1, &t2) < 0) acc += 31;
  if (str_compare(&s31, &s32) >= 0) acc += 63;
  str_right(&t3, &s31, 3);
  if (str_compare(&t2, &t3) == 0) acc += 94;
  str_mid(&s31, &t4, 20, p / 2 + 1);
  /* string 32 */
  p = (cycle * 3 + 6) % 20;
  str_concat(&t1, &s32, &name_0);
  str_insert(&t2, &t1, &lit10, p);
  str_replace(&t3, &t2, &lit56, 4, p + 3);
  str_delete(&t4, &t3, 3, p + 2);
  pos = str_find(&t4, &lit57);
  acc += pos * 5 + t4.len;
  str_left(&t1, &t4, 10);
  str_right(&t2, &t4, 3);
  if (str_compare(&t1, &t2) < 0) acc += 32;
  if (str_compare(&s32, &s33) >= 0) acc += 65;
  str_right(&t3, &s32, 3);
  if (str_compare(&t2, &t3) == 0) acc += 97;
  str_mid(&s32, &t4, 20, p / 2 + 1);
  /* string 33 */
  p = (cycle * 5 + 12) % 20;
  str_concat(&t1, &s33, &words[(cycle + 13) % 8]);
  str_insert(&t2, &t1, &lit01, p);
  str_replace(&t3, &t2, &lit58, 4, p + 1);
  str_delete(&t4, &t3, 3, p + 7);
  pos = str_find(&t4, &lit59);
  acc += pos * 6 + t4.len;
  str_left(&t1, &t4, 11);
  str_right(&t2, &t4, 8);
  if (str_compare(&t1, &t2) < 0) acc += 33;
  if (str_compare(&s33, &s34) >= 0) acc += 67;
  str_right(&t3, &s33, 8);
  if (str_compare(&t2, &t3) == 0) acc += 100;
  str_mid(&s33, &t4, 20, p / 2 + 1);
  /* string 34 */
  p = (cycle * 7 + 12) % 20;
  str_concat(&t1, &s34, &name_1);
  str_insert(&t2, &t1, &lit04, p);
  str_replace(&t3, &t2, &lit60, 4, p + 8);
  str_delete(&t4, &t3, 3, p + 7);
  pos = str_find(&t4, &lit01);
  acc += pos * 7 + t4.len;
  str_left(&t1, &t4, 9);
  str_right(&t2, &t4, 5);
  if (str_compare(&t1, &t2) < 0) acc += 34;
  if (str_compare(&s34, &s35) >= 0) acc += 69;
  str_right(&t3, &s34, 5);
  if (str_compare(&t2, &t3) == 0) acc += 103;
  str_mid(&s34, &t4, 20, p / 2 + 1);
  /* string 35 */
  p = (cycle * 9 + 9) % 20;
  str_concat(&t1, &s35, &words[(cycle + 4) % 8]);
  str_insert(&t2, &t1, &lit07, p);
  str_replace(&t3, &t2, &lit61, 4, p + 4);
  str_delete(&t4, &t3, 3, p + 5);
  pos = str_find(&t4, &lit62);
  acc += pos * 1 + t4.len;
  str_left(&t1, &t4, 12);
  str_right(&t2, &t4, 3);
  if (str_compare(&t1, &t2) < 0) acc += 35;
  if (str_compare(&s35, &s36) >= 0) acc += 71;
  str_right(&t3, &s35, 3);
  if (str_compare(&t2, &t3) == 0) acc += 106;
  str_mid(&s35, &t4, 20, p / 2 + 1);
  /* string 36 */
  p = (cycle * 4 + 10) % 20;
  str_concat(&t1, &s36, &name_2);
  str_insert(&t2, &t1, &lit10, p);
  str_replace(&t3, &t2, &lit63, 4, p + 4);
  str_delete(&t4, &t3, 3, p + 10);
  pos = str_find(&t4, &lit54);
  acc += pos * 2 + t4.len;
  str_left(&t1, &t4, 13);
  str_right(&t2, &t4, 7);
  if (str_compare(&t1, &t2) < 0) acc += 36;
  if (str_compare(&s36, &s37) >= 0) acc += 73;
  str_right(&t3, &s36, 7);
  if (str_compare(&t2, &t3) == 0) acc += 109;
  str_mid(&s36, &t4, 20, p / 2 + 1);
  /* string 37 */
  p = (cycle * 3 + 9) % 20;
  str_concat(&t1, &s37, &words[(cycle + 24) % 8]);
  str_insert(&t2, &t1, &lit01, p);
  str_replace(&t3, &t2, &lit64, 4, p + 4);
  str_delete(&t4, &t3, 3, p + 2);
  pos = str_find(&t4, &lit07);
  acc += pos * 3 + t4.len;
  str_left(&t1, &t4, 4);
  str_right(&t2, &t4, 14);
  if (str_compare(&t1, &t2) < 0) acc += 37;
  if (str_compare(&s37, &s38) >= 0) acc += 75;
  str_right(&t3, &s37, 14);
  if (str_compare(&t2, &t3) == 0) acc += 112;
  str_mid(&s37, &t4, 20, p / 2 + 1);
  /* string 38 */
  p = (cycle * 5 + 5) % 20;
  str_concat(&t1, &s38, &name_3);
  str_insert(&t2, &t1, &lit04, p);
  str_replace(&t3, &t2, &lit65, 4, p + 5);
  str_delete(&t4, &t3, 3, p + 6);
  pos = str_find(&t4, &lit30);
  acc += pos * 4 + t4.len;
  str_left(&t1, &t4, 14);
  str_right(&t2, &t4, 6);
  if (str_compare(&t1, &t2) < 0) acc += 38;
  if (str_compare(&s38, &s39) >= 0) acc += 77;
  str_right(&t3, &s38, 6);
  if (str_compare(&t2, &t3) == 0) acc += 115;
  str_mid(&s38, &t4, 20, p / 2 + 1);
  /* string 39 */
  p = (cycle * 6 + 1) % 20;
  str_concat(&t1, &s39, &words[(cycle + 1) % 8]);
  str_insert(&t2, &t1, &lit07, p);
  str_replace(&t3, &t2, &lit66, 4, p + 1);
  str_delete(&t4, &t3, 3, p + 6);
  pos = str_find(&t4, &lit67);
  acc += pos * 5 + t4.len;
  str_left(&t1, &t4, 9);
  str_right(&t2, &t4, 14);
  if (str_compare(&t1, &t2) < 0) acc += 39;
  if (str_compare(&s39, &s40) >= 0) acc += 79;
  str_right(&t3, &s39, 14);
  if (str_compare(&t2, &t3) == 0) acc += 118;
  str_mid(&s39, &t4, 20, p / 2 + 1);
  /* string 40 */
  p = (cycle * 7 + 18) % 20;
  str_concat(&t1, &s40, &name_0);
  str_insert(&t2, &t1, &lit10, p);
  str_replace(&t3, &t2, &lit68, 4, p + 2);
  str_delete(&t4, &t3, 3, p + 2);
  pos = str_find(&t4, &lit10);
  acc += pos * 6 + t4.len;
  str_left(&t1, &t4, 11);
  str_right(&t2, &t4, 10);
  if (str_compare(&t1, &t2) < 0) acc += 40;
  if (str_compare(&s40, &s01) >= 0) acc += 81;
  str_right(&t3, &s40, 10);
  if (str_compare(&t2, &t3) == 0) acc += 121;
  str_mid(&s40, &t4, 20, p / 2 + 1);
  check = (check * 37 + acc) % 1000003;
}
