#include "iec_timers.h"
typedef struct { float norm; float x[32]; } Line;
static float b[32][32], rows[32][32]; static Line r[32]; static int32_t scans;
static Line rowtimes(const float *row) {
  Line l = {0};
  for (int k = 0; k < 32; k++) for (int j = 0; j < 32; j++) l.x[j] += row[k] * b[k][j];
  for (int j = 0; j < 32; j++) l.norm += l.x[j] < 0 ? -l.x[j] : l.x[j];
  return l;
}
void scan(void) {
  scans++;
  for (int i = -16; i < 16; i++) for (int j = -16; j < 16; j++) {
    rows[i + 16][j + 16] = (float)((i * j + scans % 30) % 16) / 16.0f;
    b[i + 16][j + 16] = (float)(i - j) * 0.125f;
  }
  float total = 0;
  for (int i = 0; i < 32; i++) { r[i] = rowtimes(rows[i]); total = total + r[i].norm - r[i].x[i]; }
  int32_t t = (int32_t)total; if (t < 0) t = -t;
  check = (check * 31 + t % 10007) % 1000003;
}
