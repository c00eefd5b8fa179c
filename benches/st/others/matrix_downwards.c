#include "iec_timers.h"
static float gM[3][32][32], gGain = 0.03125f; static int32_t scans;
static void multiply(int src, int dst) {
  for (int i = 31; i >= 0; i--) for (int j = 0; j < 32; j++) {
    float acc = 0;
    for (int k = 31; k >= 0; k--) acc += gM[src][i][k] * gM[2][k][j];
    acc *= gGain;
    gM[dst][i][j] = acc > 8.0f ? 8.0f : acc < -8.0f ? -8.0f : acc;
  }
}
void scan(void) {
  scans++;
  int now = scans % 2;
  for (int i = 0; i < 32; i++) for (int j = 0; j < 32; j++) {
    gM[2][i][j] = (float)((scans * 3 + (i + 1) * 7 + (j + 1) * 11) % 21 - 10);
    if (scans % 10 == 1) gM[now][i][j] = (float)((i + 1 + 2 * (j + 1)) % 5);
  }
  multiply(now, 1 - now);
  float sum = 0;
  for (int i = 0; i < 32; i++) for (int j = 0; j < 32; j += 3) { float x = gM[1 - now][j][i]; sum += x < 0 ? -x : x; }
  check = (check * 31 + (int32_t)(sum * 4.0f)) % 1000003;
}
