/* The program of the same name once more, in C. */
#include "st.h"
#include <stdbool.h>
#include <stdlib.h>

typedef struct { float u, integral, last_pv, slope; bool saturated; } PidLoop;

static inline void pid_step(PidLoop *f, float sp, float pv, float kp, float ki, float kd, bool manual)
{
  float err = sp - pv;
  if (manual) {
    f->integral = f->u - kp * err;
  } else {
    f->slope = f->slope * 0.5f + (pv - f->last_pv) * 50.0f;
    f->integral = f->integral + ki * err * 0.01f;
    if (f->integral > 100.0f)
      f->integral = 100.0f;
    else if (f->integral < -100.0f)
      f->integral = -100.0f;
    float raw = kp * err + f->integral - kd * f->slope;
    f->saturated = false;
    if (raw > 120.0f) {
      raw = 120.0f;
      f->saturated = true;
    } else if (raw < -120.0f) {
      raw = -120.0f;
      f->saturated = true;
    }
    f->u = raw;
  }
  f->last_pv = pv;
}

static int32_t cycle;
static bool hold;
static float sp_oven, sp_tank, sp[8], y[65];
static PidLoop p01, p02, p03, p04, p05, p06, p07, p08, p09, p10,
  p11, p12, p13, p14, p15, p16, p17, p18, p19, p20,
  p21, p22, p23, p24, p25, p26, p27, p28, p29, p30,
  p31, p32, p33, p34, p35, p36, p37, p38, p39, p40,
  p41, p42, p43, p44, p45, p46, p47, p48, p49, p50,
  p51, p52, p53, p54, p55, p56, p57, p58, p59, p60,
  p61, p62, p63, p64;

void scan(void)
{
  cycle++;
  hold = cycle % 97 > 85;
  sp_oven = cycle % 120 < 60 ? 80.0f : 45.5f;
  sp_tank = (float)(cycle % 200) * 0.45f - 30.0f;
  for (int i = 0; i < 8; i++)
    sp[i] = (cycle / 40 + i) % 3 == 0 ? 10.0f * (float)i - 35.0f : 7.25f * (float)i;

  pid_step(&p01, sp[1], y[1], 0.75f, 1.6f, 0.02f, false);
  y[1] = y[1] + (p01.u - y[1]) * 0.08f + y[2] * 0.002f;
  pid_step(&p02, sp[2], y[2], 2.0f, 1.6f, 0.01f, false);
  y[2] = y[2] + (p02.u - y[2]) * 0.05f + y[3] * 0.002f;
  pid_step(&p03, sp_oven, y[3], 2.0f, 1.1f, 0.02f, false);
  y[3] = y[3] + (p03.u - y[3]) * 0.08f + y[4] * 0.002f;
  pid_step(&p04, sp[4], y[4], 1.5f, 1.1f, 0.02f, false);
  y[4] = y[4] + (p04.u - y[4]) * 0.15f + y[5] * 0.002f;
  pid_step(&p05, sp[5], y[5], 2.4f, 0.8f, 0.0f, hold);
  y[5] = y[5] + (p05.u - y[5]) * 0.15f + y[6] * 0.002f;
  pid_step(&p06, sp_oven, y[6], 1.2f, 1.6f, 0.0f, false);
  y[6] = y[6] + (p06.u - y[6]) * 0.05f + y[7] * 0.002f;
  pid_step(&p07, sp[7], y[7], 2.0f, 1.1f, 0.01f, false);
  y[7] = y[7] + (p07.u - y[7]) * 0.15f + y[8] * 0.002f;
  pid_step(&p08, sp[0], y[8], 1.5f, 1.1f, 0.01f, false);
  y[8] = y[8] + (p08.u - y[8]) * 0.05f + y[9] * 0.002f;
  pid_step(&p09, sp_oven, y[9], 1.2f, 1.6f, 0.01f, false);
  y[9] = y[9] + (p09.u - y[9]) * 0.15f + y[10] * 0.002f;
  pid_step(&p10, sp[2], y[10], 1.5f, 0.8f, 0.02f, hold);
  y[10] = y[10] + (p10.u - y[10]) * 0.1f + y[11] * 0.002f;
  pid_step(&p11, sp[3], y[11], 0.75f, 0.8f, 0.01f, false);
  y[11] = y[11] + (p11.u - y[11]) * 0.15f + y[12] * 0.002f;
  pid_step(&p12, sp_oven, y[12], 2.4f, 2.5f, 0.0f, false);
  y[12] = y[12] + (p12.u - y[12]) * 0.15f + y[13] * 0.002f;
  pid_step(&p13, sp[5], y[13], 2.4f, 2.5f, 0.01f, false);
  y[13] = y[13] + (p13.u - y[13]) * 0.15f + y[14] * 0.002f;
  pid_step(&p14, sp[6], y[14], 1.5f, 1.6f, 0.005f, false);
  y[14] = y[14] + (p14.u - y[14]) * 0.08f + y[15] * 0.002f;
  pid_step(&p15, sp_tank, y[15], 0.75f, 1.6f, 0.01f, hold);
  y[15] = y[15] + (p15.u - y[15]) * 0.05f + y[16] * 0.002f;
  pid_step(&p16, sp[0], y[16], 2.0f, 1.6f, 0.02f, false);
  y[16] = y[16] + (p16.u - y[16]) * 0.1f + y[17] * 0.002f;
  pid_step(&p17, sp[1], y[17], 0.75f, 1.1f, 0.01f, false);
  y[17] = y[17] + (p17.u - y[17]) * 0.1f + y[18] * 0.002f;
  pid_step(&p18, sp_oven, y[18], 0.75f, 1.6f, 0.0f, false);
  y[18] = y[18] + (p18.u - y[18]) * 0.1f + y[19] * 0.002f;
  pid_step(&p19, sp[3], y[19], 0.75f, 2.5f, 0.0f, false);
  y[19] = y[19] + (p19.u - y[19]) * 0.08f + y[20] * 0.002f;
  pid_step(&p20, sp[4], y[20], 1.2f, 1.1f, 0.0f, hold);
  y[20] = y[20] + (p20.u - y[20]) * 0.15f + y[21] * 0.002f;
  pid_step(&p21, sp_oven, y[21], 0.75f, 0.8f, 0.01f, false);
  y[21] = y[21] + (p21.u - y[21]) * 0.15f + y[22] * 0.002f;
  pid_step(&p22, sp[6], y[22], 0.75f, 0.8f, 0.02f, false);
  y[22] = y[22] + (p22.u - y[22]) * 0.05f + y[23] * 0.002f;
  pid_step(&p23, sp[7], y[23], 1.2f, 2.5f, 0.01f, false);
  y[23] = y[23] + (p23.u - y[23]) * 0.08f + y[24] * 0.002f;
  pid_step(&p24, sp_oven, y[24], 2.4f, 0.8f, 0.01f, false);
  y[24] = y[24] + (p24.u - y[24]) * 0.15f + y[25] * 0.002f;
  pid_step(&p25, sp[1], y[25], 1.5f, 2.5f, 0.0f, hold);
  y[25] = y[25] + (p25.u - y[25]) * 0.1f + y[26] * 0.002f;
  pid_step(&p26, sp[2], y[26], 1.2f, 2.5f, 0.005f, false);
  y[26] = y[26] + (p26.u - y[26]) * 0.08f + y[27] * 0.002f;
  pid_step(&p27, sp_oven, y[27], 1.2f, 1.1f, 0.0f, false);
  y[27] = y[27] + (p27.u - y[27]) * 0.05f + y[28] * 0.002f;
  pid_step(&p28, sp[4], y[28], 2.4f, 2.5f, 0.0f, false);
  y[28] = y[28] + (p28.u - y[28]) * 0.08f + y[29] * 0.002f;
  pid_step(&p29, sp[5], y[29], 2.4f, 1.6f, 0.02f, false);
  y[29] = y[29] + (p29.u - y[29]) * 0.15f + y[30] * 0.002f;
  pid_step(&p30, sp_tank, y[30], 1.2f, 0.8f, 0.01f, hold);
  y[30] = y[30] + (p30.u - y[30]) * 0.1f + y[31] * 0.002f;
  pid_step(&p31, sp[7], y[31], 1.5f, 1.6f, 0.0f, false);
  y[31] = y[31] + (p31.u - y[31]) * 0.05f + y[32] * 0.002f;
  pid_step(&p32, sp[0], y[32], 2.0f, 2.5f, 0.01f, false);
  y[32] = y[32] + (p32.u - y[32]) * 0.05f + y[33] * 0.002f;
  pid_step(&p33, sp_tank, y[33], 1.2f, 1.1f, 0.005f, false);
  y[33] = y[33] + (p33.u - y[33]) * 0.15f + y[34] * 0.002f;
  pid_step(&p34, sp[2], y[34], 1.5f, 1.1f, 0.02f, false);
  y[34] = y[34] + (p34.u - y[34]) * 0.08f + y[35] * 0.002f;
  pid_step(&p35, sp[3], y[35], 0.75f, 2.5f, 0.0f, hold);
  y[35] = y[35] + (p35.u - y[35]) * 0.1f + y[36] * 0.002f;
  pid_step(&p36, sp_tank, y[36], 1.5f, 1.1f, 0.005f, false);
  y[36] = y[36] + (p36.u - y[36]) * 0.08f + y[37] * 0.002f;
  pid_step(&p37, sp[5], y[37], 1.2f, 1.6f, 0.005f, false);
  y[37] = y[37] + (p37.u - y[37]) * 0.1f + y[38] * 0.002f;
  pid_step(&p38, sp[6], y[38], 1.5f, 0.8f, 0.02f, false);
  y[38] = y[38] + (p38.u - y[38]) * 0.15f + y[39] * 0.002f;
  pid_step(&p39, sp_oven, y[39], 1.5f, 2.5f, 0.02f, false);
  y[39] = y[39] + (p39.u - y[39]) * 0.15f + y[40] * 0.002f;
  pid_step(&p40, sp[0], y[40], 2.4f, 0.8f, 0.005f, hold);
  y[40] = y[40] + (p40.u - y[40]) * 0.15f + y[41] * 0.002f;
  pid_step(&p41, sp[1], y[41], 2.4f, 0.8f, 0.005f, false);
  y[41] = y[41] + (p41.u - y[41]) * 0.08f + y[42] * 0.002f;
  pid_step(&p42, sp_oven, y[42], 2.0f, 1.6f, 0.01f, false);
  y[42] = y[42] + (p42.u - y[42]) * 0.1f + y[43] * 0.002f;
  pid_step(&p43, sp[3], y[43], 2.0f, 2.5f, 0.0f, false);
  y[43] = y[43] + (p43.u - y[43]) * 0.15f + y[44] * 0.002f;
  pid_step(&p44, sp[4], y[44], 0.75f, 1.6f, 0.02f, false);
  y[44] = y[44] + (p44.u - y[44]) * 0.1f + y[45] * 0.002f;
  pid_step(&p45, sp_oven, y[45], 1.5f, 0.8f, 0.0f, hold);
  y[45] = y[45] + (p45.u - y[45]) * 0.05f + y[46] * 0.002f;
  pid_step(&p46, sp[6], y[46], 2.4f, 1.6f, 0.02f, false);
  y[46] = y[46] + (p46.u - y[46]) * 0.08f + y[47] * 0.002f;
  pid_step(&p47, sp[7], y[47], 0.75f, 1.6f, 0.0f, false);
  y[47] = y[47] + (p47.u - y[47]) * 0.1f + y[48] * 0.002f;
  pid_step(&p48, sp_oven, y[48], 1.5f, 1.1f, 0.01f, false);
  y[48] = y[48] + (p48.u - y[48]) * 0.15f + y[49] * 0.002f;
  pid_step(&p49, sp[1], y[49], 1.2f, 1.6f, 0.01f, false);
  y[49] = y[49] + (p49.u - y[49]) * 0.15f + y[50] * 0.002f;
  pid_step(&p50, sp[2], y[50], 1.2f, 0.8f, 0.005f, hold);
  y[50] = y[50] + (p50.u - y[50]) * 0.05f + y[51] * 0.002f;
  pid_step(&p51, sp_oven, y[51], 1.5f, 1.1f, 0.005f, false);
  y[51] = y[51] + (p51.u - y[51]) * 0.08f + y[52] * 0.002f;
  pid_step(&p52, sp[4], y[52], 1.5f, 1.6f, 0.005f, false);
  y[52] = y[52] + (p52.u - y[52]) * 0.08f + y[53] * 0.002f;
  pid_step(&p53, sp[5], y[53], 1.5f, 2.5f, 0.0f, false);
  y[53] = y[53] + (p53.u - y[53]) * 0.1f + y[54] * 0.002f;
  pid_step(&p54, sp_oven, y[54], 2.4f, 1.1f, 0.0f, false);
  y[54] = y[54] + (p54.u - y[54]) * 0.15f + y[55] * 0.002f;
  pid_step(&p55, sp[7], y[55], 1.5f, 1.1f, 0.01f, hold);
  y[55] = y[55] + (p55.u - y[55]) * 0.15f + y[56] * 0.002f;
  pid_step(&p56, sp[0], y[56], 2.0f, 1.6f, 0.005f, false);
  y[56] = y[56] + (p56.u - y[56]) * 0.05f + y[57] * 0.002f;
  pid_step(&p57, sp_oven, y[57], 1.2f, 1.1f, 0.005f, false);
  y[57] = y[57] + (p57.u - y[57]) * 0.15f + y[58] * 0.002f;
  pid_step(&p58, sp[2], y[58], 1.5f, 2.5f, 0.005f, false);
  y[58] = y[58] + (p58.u - y[58]) * 0.05f + y[59] * 0.002f;
  pid_step(&p59, sp[3], y[59], 2.0f, 1.1f, 0.0f, false);
  y[59] = y[59] + (p59.u - y[59]) * 0.05f + y[60] * 0.002f;
  pid_step(&p60, sp_tank, y[60], 1.5f, 2.5f, 0.0f, hold);
  y[60] = y[60] + (p60.u - y[60]) * 0.05f + y[61] * 0.002f;
  pid_step(&p61, sp[5], y[61], 2.0f, 0.8f, 0.01f, false);
  y[61] = y[61] + (p61.u - y[61]) * 0.05f + y[62] * 0.002f;
  pid_step(&p62, sp[6], y[62], 2.4f, 1.6f, 0.0f, false);
  y[62] = y[62] + (p62.u - y[62]) * 0.08f + y[63] * 0.002f;
  pid_step(&p63, sp_oven, y[63], 0.75f, 1.1f, 0.02f, false);
  y[63] = y[63] + (p63.u - y[63]) * 0.1f + y[64] * 0.002f;
  pid_step(&p64, sp[0], y[64], 1.5f, 1.6f, 0.0f, false);
  y[64] = y[64] + (p64.u - y[64]) * 0.08f + y[1] * 0.002f;

  int32_t acc = 0;
  if (p01.saturated) acc += 1;
  if (p02.saturated) acc += 2;
  if (p03.saturated) acc += 3;
  if (p04.saturated) acc += 4;
  if (p05.saturated) acc += 5;
  if (p06.saturated) acc += 6;
  if (p07.saturated) acc += 7;
  if (p08.saturated) acc += 8;
  if (p09.saturated) acc += 9;
  if (p10.saturated) acc += 10;
  if (p11.saturated) acc += 11;
  if (p12.saturated) acc += 12;
  if (p13.saturated) acc += 13;
  if (p14.saturated) acc += 14;
  if (p15.saturated) acc += 15;
  if (p16.saturated) acc += 16;
  if (p17.saturated) acc += 17;
  if (p18.saturated) acc += 18;
  if (p19.saturated) acc += 19;
  if (p20.saturated) acc += 20;
  if (p21.saturated) acc += 21;
  if (p22.saturated) acc += 22;
  if (p23.saturated) acc += 23;
  if (p24.saturated) acc += 24;
  if (p25.saturated) acc += 25;
  if (p26.saturated) acc += 26;
  if (p27.saturated) acc += 27;
  if (p28.saturated) acc += 28;
  if (p29.saturated) acc += 29;
  if (p30.saturated) acc += 30;
  if (p31.saturated) acc += 31;
  if (p32.saturated) acc += 32;
  if (p33.saturated) acc += 33;
  if (p34.saturated) acc += 34;
  if (p35.saturated) acc += 35;
  if (p36.saturated) acc += 36;
  if (p37.saturated) acc += 37;
  if (p38.saturated) acc += 38;
  if (p39.saturated) acc += 39;
  if (p40.saturated) acc += 40;
  if (p41.saturated) acc += 41;
  if (p42.saturated) acc += 42;
  if (p43.saturated) acc += 43;
  if (p44.saturated) acc += 44;
  if (p45.saturated) acc += 45;
  if (p46.saturated) acc += 46;
  if (p47.saturated) acc += 47;
  if (p48.saturated) acc += 48;
  if (p49.saturated) acc += 49;
  if (p50.saturated) acc += 50;
  if (p51.saturated) acc += 51;
  if (p52.saturated) acc += 52;
  if (p53.saturated) acc += 53;
  if (p54.saturated) acc += 54;
  if (p55.saturated) acc += 55;
  if (p56.saturated) acc += 56;
  if (p57.saturated) acc += 57;
  if (p58.saturated) acc += 58;
  if (p59.saturated) acc += 59;
  if (p60.saturated) acc += 60;
  if (p61.saturated) acc += 61;
  if (p62.saturated) acc += 62;
  if (p63.saturated) acc += 63;
  if (p64.saturated) acc += 64;
  for (int i = 1; i <= 64; i++)
    acc += abs((int32_t)(y[i] * 256.0f));
  check = (check * 19 + acc) % 1000003;
}
