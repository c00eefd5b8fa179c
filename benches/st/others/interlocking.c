#include "st.h"
#include <stdbool.h>
#include <string.h>
#include <stdint.h>

typedef struct { bool q, mem; } r_trig_t;
typedef struct { bool q1; } latch_t;
static inline void r_trig(r_trig_t *t, bool clk) { t->q = clk && !t->mem; t->mem = clk; }
static inline void sr(latch_t *l, bool s1, bool r) { l->q1 = s1 || (!r && l->q1); }
static inline void rs(latch_t *l, bool s, bool r1) { l->q1 = !r1 && (s || l->q1); }

static bool sec[32], pt[16], panel[8][12], sig[24][4], emergency;
static bool xLock01, xLock02, xLock03, xLock04, xLock05, xLock06, xLock07, xLock08,
    xLock09, xLock10, xLock11, xLock12, xLock13, xLock14, xLock15, xLock16,
    xLock17, xLock18, xLock19, xLock20, xLock21, xLock22, xLock23, xLock24,
    xProved01, xProved02, xProved03, xProved04, xProved05, xProved06, xProved07, xProved08,
    xProved09, xProved10, xProved11, xProved12, xProved13, xProved14, xProved15, xProved16,
    xProved17, xProved18, xProved19, xProved20, xProved21, xProved22, xProved23, xProved24,
    xApproach01, xApproach02, xApproach03, xApproach04, xApproach05, xApproach06, xApproach07, xApproach08,
    xApproach09, xApproach10, xApproach11, xApproach12, xApproach13, xApproach14, xApproach15, xApproach16,
    xApproach17, xApproach18, xApproach19, xApproach20, xApproach21, xApproach22, xApproach23, xApproach24,
    xRelease01, xRelease02, xRelease03, xRelease04, xRelease05, xRelease06, xRelease07, xRelease08,
    xRelease09, xRelease10, xRelease11, xRelease12, xRelease13, xRelease14, xRelease15, xRelease16,
    xRelease17, xRelease18, xRelease19, xRelease20, xRelease21, xRelease22, xRelease23, xRelease24,
    xConflict01, xConflict02, xConflict03, xConflict04, xConflict05, xConflict06, xConflict07, xConflict08,
    xConflict09, xConflict10, xConflict11, xConflict12, xConflict13, xConflict14, xConflict15, xConflict16,
    xConflict17, xConflict18, xConflict19, xConflict20, xConflict21, xConflict22, xConflict23, xConflict24;
static r_trig_t edge01, edge05, edge09, edge13, edge17, edge21;
static latch_t latch01, latch05, latch09, latch13, latch17, latch21;
static latch_t hold02, hold06, hold10, hold14, hold18, hold22;
static int32_t scans, seed = 1;

void scan(void)
{
  scans++;
  seed = (seed * 75 + 74) % 65537;
  bool feed = seed % 3 == 0;
  emergency = scans % 50 == 7;
  memmove(sec + 1, sec, sizeof sec - 1);
  sec[0] = feed;
  for (int i = 0; i < 8; i++) {
    memmove(panel[i] + 1, panel[i], 11);
    panel[i][0] = feed != sec[i * 4];
    feed = panel[i][11];
  }
  /* route 1 */
  xConflict01 = (xLock15 && pt[10]) || (xLock05 && !pt[9]) || ((xLock14 != sec[17]) && sec[6]);
  r_trig(&edge01, panel[3][4]);
  sr(&latch01, edge01.q && !xConflict01, sec[8] && xRelease01);
  xLock01 = latch01.q1;
  xProved01 = xLock01 && pt[13] && !(sec[2] || sec[22]);
  xApproach01 = (sec[9] || (xApproach01 && sec[4])) && (xLock01 || xProved15);
  xRelease01 = (xApproach01 && !sec[17]) || ((emergency != pt[15]) && sec[6]);
  if (!xLock01 && !xLock15) {
    pt[14] = panel[2][0] != pt[14];
  }
  sig[0][0] = !xProved01 || emergency;
  sig[0][1] = xProved01 && !emergency && !sec[28];
  sig[0][2] = sig[0][1] && xProved05;
  sig[0][3] = (sig[0][0] != sig[8][2]) && (panel[3][10] || xApproach01);
  /* route 2 */
  xConflict02 = (xLock12 && pt[8]) || (xLock15 && !pt[0]) || ((xLock09 != sec[10]) && sec[7]);
  rs(&hold02, panel[7][6] && !xConflict02, sec[7] || xRelease02);
  xLock02 = hold02.q1;
  xProved02 = xLock02 && pt[15] && !(sec[25] || sec[27]);
  xApproach02 = (sec[25] || (xApproach02 && sec[28])) && (xLock02 || xProved12);
  xRelease02 = (xApproach02 && !sec[21]) || ((emergency != pt[11]) && sec[3]);
  if (!xLock02 && !xLock12) {
    pt[1] = panel[5][4] != pt[1];
  }
  sig[1][0] = !xProved02 || emergency;
  sig[1][1] = xProved02 && !emergency && !sec[27];
  sig[1][2] = sig[1][1] && xProved15;
  sig[1][3] = (sig[1][0] != sig[4][2]) && (panel[4][11] || xApproach02);
  /* route 3 */
  xConflict03 = (xLock09 && pt[2]) || (xLock21 && !pt[14]) || ((xLock15 != sec[4]) && sec[21]);
  xLock03 = (panel[1][6] || xLock03) && !xConflict03 && !xRelease03;
  xProved03 = xLock03 && pt[6] && !(sec[8] || sec[6]);
  xApproach03 = (sec[18] || (xApproach03 && sec[29])) && (xLock03 || xProved09);
  xRelease03 = (xApproach03 && !sec[27]) || ((emergency != pt[12]) && sec[2]);
  if (!xLock03 && !xLock09) {
    pt[0] = panel[3][5] != pt[0];
  }
  sig[2][0] = !xProved03 || emergency;
  sig[2][1] = xProved03 && !emergency && !sec[9];
  sig[2][2] = sig[2][1] && xProved21;
  sig[2][3] = (sig[2][0] != sig[5][2]) && (panel[6][7] || xApproach03);
  /* route 4 */
  xConflict04 = (xLock07 && pt[9]) || (xLock05 && !pt[6]) || ((xLock24 != sec[18]) && sec[31]);
  if (panel[0][11] && !xConflict04) {
    xLock04 = true;
  } else if (xRelease04 || sec[20]) {
    xLock04 = false;
  }
  xProved04 = xLock04 && pt[6] && !(sec[29] || sec[15]);
  xApproach04 = (sec[24] || (xApproach04 && sec[13])) && (xLock04 || xProved07);
  xRelease04 = (xApproach04 && !sec[2]) || ((emergency != pt[8]) && sec[24]);
  if (!xLock04 && !xLock07) {
    pt[8] = panel[7][6] != pt[8];
  }
  sig[3][0] = !xProved04 || emergency;
  sig[3][1] = xProved04 && !emergency && !sec[18];
  sig[3][2] = sig[3][1] && xProved05;
  sig[3][3] = (sig[3][0] != sig[13][2]) && (panel[3][2] || xApproach04);
  /* route 5 */
  xConflict05 = (xLock03 && pt[5]) || (xLock12 && !pt[8]) || ((xLock16 != sec[18]) && sec[25]);
  r_trig(&edge05, panel[5][5]);
  sr(&latch05, edge05.q && !xConflict05, sec[20] && xRelease05);
  xLock05 = latch05.q1;
  xProved05 = xLock05 && pt[5] && !(sec[11] || sec[4]);
  xApproach05 = (sec[20] || (xApproach05 && sec[22])) && (xLock05 || xProved03);
  xRelease05 = (xApproach05 && !sec[23]) || ((emergency != pt[4]) && sec[11]);
  if (!xLock05 && !xLock03) {
    pt[13] = panel[7][5] != pt[13];
  }
  sig[4][0] = !xProved05 || emergency;
  sig[4][1] = xProved05 && !emergency && !sec[18];
  sig[4][2] = sig[4][1] && xProved12;
  sig[4][3] = (sig[4][0] != sig[3][2]) && (panel[7][0] || xApproach05);
  /* route 6 */
  xConflict06 = (xLock24 && pt[2]) || (xLock15 && !pt[8]) || ((xLock19 != sec[6]) && sec[19]);
  rs(&hold06, panel[3][1] && !xConflict06, sec[24] || xRelease06);
  xLock06 = hold06.q1;
  xProved06 = xLock06 && pt[0] && !(sec[1] || sec[29]);
  xApproach06 = (sec[28] || (xApproach06 && sec[26])) && (xLock06 || xProved24);
  xRelease06 = (xApproach06 && !sec[26]) || ((emergency != pt[1]) && sec[19]);
  if (!xLock06 && !xLock24) {
    pt[15] = panel[2][1] != pt[15];
  }
  sig[5][0] = !xProved06 || emergency;
  sig[5][1] = xProved06 && !emergency && !sec[11];
  sig[5][2] = sig[5][1] && xProved15;
  sig[5][3] = (sig[5][0] != sig[9][2]) && (panel[7][6] || xApproach06);
  /* route 7 */
  xConflict07 = (xLock15 && pt[10]) || (xLock12 && !pt[0]) || ((xLock20 != sec[23]) && sec[17]);
  xLock07 = (panel[1][10] || xLock07) && !xConflict07 && !xRelease07;
  xProved07 = xLock07 && pt[5] && !(sec[21] || sec[5]);
  xApproach07 = (sec[27] || (xApproach07 && sec[8])) && (xLock07 || xProved15);
  xRelease07 = (xApproach07 && !sec[4]) || ((emergency != pt[4]) && sec[14]);
  if (!xLock07 && !xLock15) {
    pt[11] = panel[4][3] != pt[11];
  }
  sig[6][0] = !xProved07 || emergency;
  sig[6][1] = xProved07 && !emergency && !sec[5];
  sig[6][2] = sig[6][1] && xProved12;
  sig[6][3] = (sig[6][0] != sig[3][2]) && (panel[0][8] || xApproach07);
  /* route 8 */
  xConflict08 = (xLock12 && pt[11]) || (xLock07 && !pt[7]) || ((xLock09 != sec[19]) && sec[24]);
  if (panel[5][2] && !xConflict08) {
    xLock08 = true;
  } else if (xRelease08 || sec[28]) {
    xLock08 = false;
  }
  xProved08 = xLock08 && pt[11] && !(sec[17] || sec[27]);
  xApproach08 = (sec[15] || (xApproach08 && sec[23])) && (xLock08 || xProved12);
  xRelease08 = (xApproach08 && !sec[29]) || ((emergency != pt[0]) && sec[9]);
  if (!xLock08 && !xLock12) {
    pt[5] = panel[0][3] != pt[5];
  }
  sig[7][0] = !xProved08 || emergency;
  sig[7][1] = xProved08 && !emergency && !sec[26];
  sig[7][2] = sig[7][1] && xProved07;
  sig[7][3] = (sig[7][0] != sig[11][2]) && (panel[7][10] || xApproach08);
  /* route 9 */
  xConflict09 = (xLock14 && pt[6]) || (xLock18 && !pt[15]) || ((xLock20 != sec[17]) && sec[24]);
  r_trig(&edge09, panel[4][2]);
  sr(&latch09, edge09.q && !xConflict09, sec[31] && xRelease09);
  xLock09 = latch09.q1;
  xProved09 = xLock09 && pt[2] && !(sec[4] || sec[22]);
  xApproach09 = (sec[18] || (xApproach09 && sec[15])) && (xLock09 || xProved14);
  xRelease09 = (xApproach09 && !sec[10]) || ((emergency != pt[6]) && sec[9]);
  if (!xLock09 && !xLock14) {
    pt[4] = panel[6][9] != pt[4];
  }
  sig[8][0] = !xProved09 || emergency;
  sig[8][1] = xProved09 && !emergency && !sec[19];
  sig[8][2] = sig[8][1] && xProved18;
  sig[8][3] = (sig[8][0] != sig[0][2]) && (panel[5][4] || xApproach09);
  /* route 10 */
  xConflict10 = (xLock20 && pt[9]) || (xLock19 && !pt[13]) || ((xLock13 != sec[29]) && sec[3]);
  rs(&hold10, panel[5][6] && !xConflict10, sec[4] || xRelease10);
  xLock10 = hold10.q1;
  xProved10 = xLock10 && pt[3] && !(sec[25] || sec[14]);
  xApproach10 = (sec[22] || (xApproach10 && sec[5])) && (xLock10 || xProved20);
  xRelease10 = (xApproach10 && !sec[31]) || ((emergency != pt[5]) && sec[22]);
  if (!xLock10 && !xLock20) {
    pt[13] = panel[6][5] != pt[13];
  }
  sig[9][0] = !xProved10 || emergency;
  sig[9][1] = xProved10 && !emergency && !sec[5];
  sig[9][2] = sig[9][1] && xProved19;
  sig[9][3] = (sig[9][0] != sig[14][2]) && (panel[6][1] || xApproach10);
  /* route 11 */
  xConflict11 = (xLock16 && pt[12]) || (xLock15 && !pt[6]) || ((xLock12 != sec[22]) && sec[29]);
  xLock11 = (panel[5][7] || xLock11) && !xConflict11 && !xRelease11;
  xProved11 = xLock11 && pt[7] && !(sec[7] || sec[13]);
  xApproach11 = (sec[15] || (xApproach11 && sec[21])) && (xLock11 || xProved16);
  xRelease11 = (xApproach11 && !sec[28]) || ((emergency != pt[2]) && sec[15]);
  if (!xLock11 && !xLock16) {
    pt[7] = panel[4][8] != pt[7];
  }
  sig[10][0] = !xProved11 || emergency;
  sig[10][1] = xProved11 && !emergency && !sec[22];
  sig[10][2] = sig[10][1] && xProved15;
  sig[10][3] = (sig[10][0] != sig[9][2]) && (panel[1][8] || xApproach11);
  /* route 12 */
  xConflict12 = (xLock02 && pt[15]) || (xLock19 && !pt[3]) || ((xLock13 != sec[12]) && sec[25]);
  if (panel[1][2] && !xConflict12) {
    xLock12 = true;
  } else if (xRelease12 || sec[25]) {
    xLock12 = false;
  }
  xProved12 = xLock12 && pt[11] && !(sec[17] || sec[26]);
  xApproach12 = (sec[4] || (xApproach12 && sec[16])) && (xLock12 || xProved02);
  xRelease12 = (xApproach12 && !sec[14]) || ((emergency != pt[15]) && sec[6]);
  if (!xLock12 && !xLock02) {
    pt[4] = panel[5][10] != pt[4];
  }
  sig[11][0] = !xProved12 || emergency;
  sig[11][1] = xProved12 && !emergency && !sec[25];
  sig[11][2] = sig[11][1] && xProved19;
  sig[11][3] = (sig[11][0] != sig[12][2]) && (panel[2][11] || xApproach12);
  /* route 13 */
  xConflict13 = (xLock14 && pt[3]) || (xLock18 && !pt[12]) || ((xLock16 != sec[7]) && sec[16]);
  r_trig(&edge13, panel[7][1]);
  sr(&latch13, edge13.q && !xConflict13, sec[9] && xRelease13);
  xLock13 = latch13.q1;
  xProved13 = xLock13 && pt[7] && !(sec[25] || sec[8]);
  xApproach13 = (sec[10] || (xApproach13 && sec[11])) && (xLock13 || xProved14);
  xRelease13 = (xApproach13 && !sec[14]) || ((emergency != pt[6]) && sec[28]);
  if (!xLock13 && !xLock14) {
    pt[8] = panel[2][9] != pt[8];
  }
  sig[12][0] = !xProved13 || emergency;
  sig[12][1] = xProved13 && !emergency && !sec[26];
  sig[12][2] = sig[12][1] && xProved18;
  sig[12][3] = (sig[12][0] != sig[17][2]) && (panel[3][4] || xApproach13);
  /* route 14 */
  xConflict14 = (xLock16 && pt[11]) || (xLock15 && !pt[6]) || ((xLock19 != sec[25]) && sec[4]);
  rs(&hold14, panel[6][7] && !xConflict14, sec[3] || xRelease14);
  xLock14 = hold14.q1;
  xProved14 = xLock14 && pt[14] && !(sec[25] || sec[2]);
  xApproach14 = (sec[16] || (xApproach14 && sec[18])) && (xLock14 || xProved16);
  xRelease14 = (xApproach14 && !sec[20]) || ((emergency != pt[3]) && sec[21]);
  if (!xLock14 && !xLock16) {
    pt[12] = panel[1][6] != pt[12];
  }
  sig[13][0] = !xProved14 || emergency;
  sig[13][1] = xProved14 && !emergency && !sec[28];
  sig[13][2] = sig[13][1] && xProved15;
  sig[13][3] = (sig[13][0] != sig[21][2]) && (panel[6][1] || xApproach14);
  /* route 15 */
  xConflict15 = (xLock13 && pt[2]) || (xLock01 && !pt[13]) || ((xLock21 != sec[11]) && sec[5]);
  xLock15 = (panel[0][3] || xLock15) && !xConflict15 && !xRelease15;
  xProved15 = xLock15 && pt[4] && !(sec[11] || sec[21]);
  xApproach15 = (sec[19] || (xApproach15 && sec[25])) && (xLock15 || xProved13);
  xRelease15 = (xApproach15 && !sec[1]) || ((emergency != pt[6]) && sec[24]);
  if (!xLock15 && !xLock13) {
    pt[4] = panel[6][10] != pt[4];
  }
  sig[14][0] = !xProved15 || emergency;
  sig[14][1] = xProved15 && !emergency && !sec[22];
  sig[14][2] = sig[14][1] && xProved01;
  sig[14][3] = (sig[14][0] != sig[15][2]) && (panel[6][3] || xApproach15);
  /* route 16 */
  xConflict16 = (xLock03 && pt[4]) || (xLock14 && !pt[14]) || ((xLock05 != sec[13]) && sec[30]);
  if (panel[1][9] && !xConflict16) {
    xLock16 = true;
  } else if (xRelease16 || sec[7]) {
    xLock16 = false;
  }
  xProved16 = xLock16 && pt[9] && !(sec[3] || sec[31]);
  xApproach16 = (sec[20] || (xApproach16 && sec[19])) && (xLock16 || xProved03);
  xRelease16 = (xApproach16 && !sec[4]) || ((emergency != pt[0]) && sec[20]);
  if (!xLock16 && !xLock03) {
    pt[5] = panel[6][5] != pt[5];
  }
  sig[15][0] = !xProved16 || emergency;
  sig[15][1] = xProved16 && !emergency && !sec[9];
  sig[15][2] = sig[15][1] && xProved14;
  sig[15][3] = (sig[15][0] != sig[19][2]) && (panel[1][1] || xApproach16);
  /* route 17 */
  xConflict17 = (xLock06 && pt[4]) || (xLock22 && !pt[14]) || ((xLock11 != sec[20]) && sec[12]);
  r_trig(&edge17, panel[7][3]);
  sr(&latch17, edge17.q && !xConflict17, sec[12] && xRelease17);
  xLock17 = latch17.q1;
  xProved17 = xLock17 && pt[5] && !(sec[16] || sec[5]);
  xApproach17 = (sec[8] || (xApproach17 && sec[12])) && (xLock17 || xProved06);
  xRelease17 = (xApproach17 && !sec[21]) || ((emergency != pt[11]) && sec[26]);
  if (!xLock17 && !xLock06) {
    pt[6] = panel[3][2] != pt[6];
  }
  sig[16][0] = !xProved17 || emergency;
  sig[16][1] = xProved17 && !emergency && !sec[10];
  sig[16][2] = sig[16][1] && xProved22;
  sig[16][3] = (sig[16][0] != sig[7][2]) && (panel[1][9] || xApproach17);
  /* route 18 */
  xConflict18 = (xLock11 && pt[1]) || (xLock04 && !pt[13]) || ((xLock10 != sec[15]) && sec[17]);
  rs(&hold18, panel[1][4] && !xConflict18, sec[13] || xRelease18);
  xLock18 = hold18.q1;
  xProved18 = xLock18 && pt[9] && !(sec[26] || sec[10]);
  xApproach18 = (sec[12] || (xApproach18 && sec[10])) && (xLock18 || xProved11);
  xRelease18 = (xApproach18 && !sec[3]) || ((emergency != pt[4]) && sec[30]);
  if (!xLock18 && !xLock11) {
    pt[14] = panel[1][2] != pt[14];
  }
  sig[17][0] = !xProved18 || emergency;
  sig[17][1] = xProved18 && !emergency && !sec[6];
  sig[17][2] = sig[17][1] && xProved04;
  sig[17][3] = (sig[17][0] != sig[5][2]) && (panel[1][0] || xApproach18);
  /* route 19 */
  xConflict19 = (xLock21 && pt[7]) || (xLock08 && !pt[5]) || ((xLock17 != sec[31]) && sec[4]);
  xLock19 = (panel[3][5] || xLock19) && !xConflict19 && !xRelease19;
  xProved19 = xLock19 && pt[13] && !(sec[11] || sec[6]);
  xApproach19 = (sec[25] || (xApproach19 && sec[27])) && (xLock19 || xProved21);
  xRelease19 = (xApproach19 && !sec[22]) || ((emergency != pt[0]) && sec[22]);
  if (!xLock19 && !xLock21) {
    pt[6] = panel[7][7] != pt[6];
  }
  sig[18][0] = !xProved19 || emergency;
  sig[18][1] = xProved19 && !emergency && !sec[15];
  sig[18][2] = sig[18][1] && xProved08;
  sig[18][3] = (sig[18][0] != sig[18][2]) && (panel[0][10] || xApproach19);
  /* route 20 */
  xConflict20 = (xLock11 && pt[9]) || (xLock16 && !pt[8]) || ((xLock04 != sec[28]) && sec[2]);
  if (panel[4][11] && !xConflict20) {
    xLock20 = true;
  } else if (xRelease20 || sec[23]) {
    xLock20 = false;
  }
  xProved20 = xLock20 && pt[12] && !(sec[21] || sec[8]);
  xApproach20 = (sec[31] || (xApproach20 && sec[12])) && (xLock20 || xProved11);
  xRelease20 = (xApproach20 && !sec[18]) || ((emergency != pt[9]) && sec[10]);
  if (!xLock20 && !xLock11) {
    pt[8] = panel[1][6] != pt[8];
  }
  sig[19][0] = !xProved20 || emergency;
  sig[19][1] = xProved20 && !emergency && !sec[15];
  sig[19][2] = sig[19][1] && xProved16;
  sig[19][3] = (sig[19][0] != sig[1][2]) && (panel[5][9] || xApproach20);
  /* route 21 */
  xConflict21 = (xLock16 && pt[13]) || (xLock18 && !pt[11]) || ((xLock08 != sec[9]) && sec[27]);
  r_trig(&edge21, panel[2][7]);
  sr(&latch21, edge21.q && !xConflict21, sec[15] && xRelease21);
  xLock21 = latch21.q1;
  xProved21 = xLock21 && pt[1] && !(sec[5] || sec[14]);
  xApproach21 = (sec[21] || (xApproach21 && sec[23])) && (xLock21 || xProved16);
  xRelease21 = (xApproach21 && !sec[2]) || ((emergency != pt[11]) && sec[28]);
  if (!xLock21 && !xLock16) {
    pt[4] = panel[3][9] != pt[4];
  }
  sig[20][0] = !xProved21 || emergency;
  sig[20][1] = xProved21 && !emergency && !sec[1];
  sig[20][2] = sig[20][1] && xProved18;
  sig[20][3] = (sig[20][0] != sig[13][2]) && (panel[3][4] || xApproach21);
  /* route 22 */
  xConflict22 = (xLock21 && pt[0]) || (xLock08 && !pt[14]) || ((xLock13 != sec[8]) && sec[1]);
  rs(&hold22, panel[3][3] && !xConflict22, sec[0] || xRelease22);
  xLock22 = hold22.q1;
  xProved22 = xLock22 && pt[11] && !(sec[5] || sec[26]);
  xApproach22 = (sec[27] || (xApproach22 && sec[15])) && (xLock22 || xProved21);
  xRelease22 = (xApproach22 && !sec[2]) || ((emergency != pt[6]) && sec[12]);
  if (!xLock22 && !xLock21) {
    pt[8] = panel[3][2] != pt[8];
  }
  sig[21][0] = !xProved22 || emergency;
  sig[21][1] = xProved22 && !emergency && !sec[8];
  sig[21][2] = sig[21][1] && xProved08;
  sig[21][3] = (sig[21][0] != sig[0][2]) && (panel[6][5] || xApproach22);
  /* route 23 */
  xConflict23 = (xLock06 && pt[10]) || (xLock13 && !pt[4]) || ((xLock19 != sec[30]) && sec[22]);
  xLock23 = (panel[2][2] || xLock23) && !xConflict23 && !xRelease23;
  xProved23 = xLock23 && pt[14] && !(sec[21] || sec[15]);
  xApproach23 = (sec[20] || (xApproach23 && sec[6])) && (xLock23 || xProved06);
  xRelease23 = (xApproach23 && !sec[2]) || ((emergency != pt[14]) && sec[20]);
  if (!xLock23 && !xLock06) {
    pt[4] = panel[2][3] != pt[4];
  }
  sig[22][0] = !xProved23 || emergency;
  sig[22][1] = xProved23 && !emergency && !sec[10];
  sig[22][2] = sig[22][1] && xProved13;
  sig[22][3] = (sig[22][0] != sig[1][2]) && (panel[3][0] || xApproach23);
  /* route 24 */
  xConflict24 = (xLock12 && pt[6]) || (xLock23 && !pt[4]) || ((xLock04 != sec[0]) && sec[0]);
  if (panel[6][10] && !xConflict24) {
    xLock24 = true;
  } else if (xRelease24 || sec[19]) {
    xLock24 = false;
  }
  xProved24 = xLock24 && pt[5] && !(sec[21] || sec[30]);
  xApproach24 = (sec[26] || (xApproach24 && sec[26])) && (xLock24 || xProved12);
  xRelease24 = (xApproach24 && !sec[5]) || ((emergency != pt[7]) && sec[23]);
  if (!xLock24 && !xLock12) {
    pt[6] = panel[4][1] != pt[6];
  }
  sig[23][0] = !xProved24 || emergency;
  sig[23][1] = xProved24 && !emergency && !sec[26];
  sig[23][2] = sig[23][1] && xProved23;
  sig[23][3] = (sig[23][0] != sig[14][2]) && (panel[4][8] || xApproach24);
  int n = 0;
  for (int i = 0; i < 24; i++)
    for (int j = 0; j < 4; j++)
      if (sig[i][j]) n += i + j;
  for (int i = 0; i < 16; i++)
    if (pt[i]) n += i;
  if (xLock01) n += 1;
  if (xLock04) n += 4;
  if (xLock07) n += 7;
  if (xLock10) n += 1;
  if (xLock13) n += 4;
  if (xLock16) n += 7;
  if (xLock19) n += 1;
  if (xLock22) n += 4;
  if (xProved01) n += 7;
  if (xProved04) n += 1;
  if (xProved07) n += 4;
  if (xProved10) n += 7;
  if (xProved13) n += 1;
  if (xProved16) n += 4;
  if (xProved19) n += 7;
  if (xProved22) n += 1;
  if (xApproach01) n += 4;
  if (xApproach04) n += 7;
  if (xApproach07) n += 1;
  if (xApproach10) n += 4;
  if (xApproach13) n += 7;
  if (xApproach16) n += 1;
  if (xApproach19) n += 4;
  if (xApproach22) n += 7;
  if (xRelease01) n += 1;
  if (xRelease04) n += 4;
  if (xRelease07) n += 7;
  if (xRelease10) n += 1;
  if (xRelease13) n += 4;
  if (xRelease16) n += 7;
  if (xRelease19) n += 1;
  if (xRelease22) n += 4;
  if (xConflict01) n += 7;
  if (xConflict04) n += 1;
  if (xConflict07) n += 4;
  if (xConflict10) n += 7;
  if (xConflict13) n += 1;
  if (xConflict16) n += 4;
  if (xConflict19) n += 7;
  if (xConflict22) n += 1;
  check = (check * 3 + n) % 1000003;
}
