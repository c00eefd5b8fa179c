#include "st.h"

static int16_t a[32][32], b[32][32], c[32][32];
static int32_t scans;

void scan(void)
{
  scans++;
  int v = scans % 50;
  for (int i = 0; i < 32; i++)
    for (int j = 0; j < 32; j++) {
      v = (v * 7 + 3) % 101;
      a[i][j] = v % 19 - 9;
      b[j][i] = v % 23 - 11;
    }
  for (int i = 0; i < 32; i++)
    for (int j = 0; j < 32; j++)
      c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] + a[i][3] * b[3][j] +
        a[i][4] * b[4][j] + a[i][5] * b[5][j] + a[i][6] * b[6][j] + a[i][7] * b[7][j] +
        a[i][8] * b[8][j] + a[i][9] * b[9][j] + a[i][10] * b[10][j] + a[i][11] * b[11][j] +
        a[i][12] * b[12][j] + a[i][13] * b[13][j] + a[i][14] * b[14][j] + a[i][15] * b[15][j] +
        a[i][16] * b[16][j] + a[i][17] * b[17][j] + a[i][18] * b[18][j] + a[i][19] * b[19][j] +
        a[i][20] * b[20][j] + a[i][21] * b[21][j] + a[i][22] * b[22][j] + a[i][23] * b[23][j] +
        a[i][24] * b[24][j] + a[i][25] * b[25][j] + a[i][26] * b[26][j] + a[i][27] * b[27][j] +
        a[i][28] * b[28][j] + a[i][29] * b[29][j] + a[i][30] * b[30][j] + a[i][31] * b[31][j];
  int32_t s = 0;
  for (int i = 0; i < 32; i++)
    for (int j = 0; j < 32; j++)
      s += c[i][j] * ((i + j + 2) % 7);
  check = (check + s) % 1000003;
}
