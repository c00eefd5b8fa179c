#include <stdbool.h>
#include <string.h>
#include "st.h"

static int scans, seed = 4711;
static bool x[64], lamp[64], reg[32];
static bool lift1_req, lift2_req, light3_run, valve4_on, pump5_req, lift6_ok;
static bool light7_on, valve8_run, light9_req, valve10_run, valve11_run, light12_req;
static bool conv13_req, pump14_req, lift15_run, pump16_req, heat17_run, conv18_ok;
static bool door19_ok, light20_req, lift21_ok, light22_ok, valve23_ok, robot24_run;
static bool valve25_on, valve26_ok, pump27_ok, conv28_req, lift29_req, pump30_run;
static bool pump31_run, light32_on, valve33_req, lift34_on, door35_req, valve36_run;
static bool valve37_on, valve38_run, pump39_ok, door40_on, robot41_ok, door42_req;
static bool robot43_on, robot44_run, valve45_req, heat46_ok, conv47_ok, robot48_on;
static bool lift49_on, lift50_on, light51_req, light52_ok, heat53_ok, robot54_run;
static bool pump55_req, pump56_req, lift57_on, pump58_req, door59_run, lift60_run;
static bool conv61_ok, valve62_ok, robot63_ok, pump64_on, door65_req, door66_on;
static bool lift67_ok, light68_req, lift69_run, robot70_ok, pump71_req, light72_req;
static bool light73_ok, valve74_ok, pump75_run, robot76_run, light77_ok, heat78_on;
static bool pump79_run, robot80_ok, lift81_req, robot82_ok, light83_ok, lift84_run;
static bool lift85_req, heat86_ok, conv87_on, robot88_req, conv89_on, conv90_req;
static bool pump91_on, lift92_on, valve93_run, lift94_on, valve95_ok, heat96_req;
static bool lift97_req, light98_on, lift99_run, pump100_ok, lift101_req, robot102_ok;
static bool conv103_run, robot104_req, lift105_on, lift106_ok, robot107_on, pump108_run;
static bool door109_ok, lift110_req, conv111_run, door112_req, conv113_req, door114_run;
static bool valve115_on, valve116_ok, robot117_ok, robot118_ok, heat119_req, light120_run;
static bool valve121_on, conv122_on, robot123_req, lift124_req, lift125_run, heat126_ok;
static bool door127_req, robot128_req, robot129_req, light130_on, lift131_on, door132_run;
static bool valve133_run, heat134_on, valve135_run, lift136_ok, heat137_ok, heat138_req;
static bool lift139_on, valve140_run, conv141_req, conv142_run, robot143_req, conv144_run;
static bool door145_run, heat146_run, door147_ok, heat148_ok, door149_on, lift150_req;
static bool robot151_run, conv152_ok, light153_req, heat154_run, pump155_run, pump156_run;
static bool conv157_ok, lift158_req, light159_req, robot160_ok;
static bool clock5, sh5[16];
static bool edge16;
static bool rs19;
static bool sr21;
static bool edge22;
static bool rs24;
static bool sr30;
static bool edge32;
static bool edge38;
static bool clock44, sh44[16];
static bool edge46;
static bool edge53;
static bool rs64;
static bool sr65;
static bool edge67;
static bool edge72;
static bool edge73;
static bool rs79;
static bool edge85;
static bool sr86;
static bool rs89;
static bool edge94;
static bool clock99, sh99[16];
static bool edge103;
static bool edge106;
static bool edge107;
static bool sr110;
static bool rs116;
static bool edge121;
static bool edge124;
static bool edge127;
static bool sr128;
static bool edge131;
static bool clock136, sh136[16];
static bool clock137, sh137[16];
static bool rs138;
static bool sr147;
static bool edge149;
static bool clock151, sh151[16];
static bool sr158;
static bool clock159, sh159[16];
static bool clock163, sh163[16];
static bool rs164;
static bool clock166, sh166[16];
static bool clock167, sh167[16];
static bool rs171;
static bool edge173;
static bool edge176;
static bool edge179;
static bool clock183, sh183[16];
static bool rs191;
static bool edge192;
static bool rs194;
static bool edge196;
static bool clock205, sh205[16];
static bool clock207, sh207[16];
static bool sr208;
static bool sr218;
static bool sr226;
static bool clock229, sh229[16];
static bool sr233;
static bool sr235;
static bool sr236;
static bool clock239, sh239[16];
static bool sr252;
static bool sr253;
static bool rs258;
static bool sr259;
static bool rs263;
static bool rs266;
static bool clock270, sh270[16];
static bool rs272;
static bool clock273, sh273[16];
static bool clock274, sh274[16];
static bool rs280;
static bool sr281;
static bool clock282, sh282[16];
static bool sr285;
static bool clock288, sh288[16];
static bool clock290, sh290[16];
static bool clock292, sh292[16];
static bool rs295;
static bool edge299;
static bool clock300, sh300[16];

static inline bool sr(bool *q, bool s1, bool r) { return *q = s1 || (!r && *q); }
static inline bool rs(bool *q, bool s, bool r1) { return *q = !r1 && (s || *q); }
static inline bool rising(bool *old, bool clk)
{
    bool q = clk && !*old;
    *old = clk;
    return q;
}

void scan(void)
{
    scans++;
    memmove(x + 1, x, 63);
    seed = (seed * 1103 + 12345) % 65536;
    x[0] = seed > 32767;
    x[21] ^= seed % 7 == 3;
    x[40] = scans % 5 < 2;

    lift1_req = x[63] || (!robot63_ok && x[42]);
    lift2_req = (lift2_req || robot118_ok) && !(!x[13] || !light68_req);
    light3_run = robot76_run && lift34_on;
    if (!x[34] || x[39]) {
        lamp[43] = true;
        valve4_on = x[4];
    } else if (valve11_run && conv47_ok) {
        lamp[43] = false;
    } else {
        valve4_on = false;
    }
    if (rising(&clock5, !conv61_ok)) {
        memmove(sh5 + 1, sh5, 15);
        sh5[0] = robot128_req || x[49];
    }
    pump5_req = sh5[15] ^ sh5[7];
    lift6_ok = lift101_req || (!x[33] && !valve23_ok);
    light7_on = (!lamp[13]) ^ (robot143_req || light22_ok);
    valve8_run = pump14_req || ((light98_on) ^ (!x[46]));
    light9_req = (light9_req || lamp[29]) && !(heat53_ok && pump5_req);
    valve10_run = (!valve38_run) ^ (!x[52] || ((!door147_ok) ^ (door132_run)));
    valve11_run = !x[42] && x[11];
    lamp[50] = (x[62]) ^ (x[7]);
    conv13_req = valve26_ok && (x[51] && ((valve26_ok) ^ (door127_req)));
    pump14_req = x[37] || lamp[55];
    lift15_run = (lift15_run || !pump55_req) && !((x[39]) ^ (x[53]));
    if (rising(&edge16, !x[62] || !pump30_run))
        pump16_req = !pump16_req;
    lamp[50] = !reg[19] && (!door149_on && (!pump16_req && valve95_ok));
    conv18_ok = lamp[6] && !light153_req;
    door19_ok = rs(&rs19, lift6_ok || !valve11_run, reg[17] || !valve26_ok);
    light20_req = !x[3] && x[59];
    lift21_ok = sr(&sr21, !heat17_run && !lift15_run, !x[14] || robot82_ok);
    if (rising(&edge22, (lift50_on) ^ (pump55_req)))
        light22_ok = !light22_ok;
    if (!x[40] || conv141_req) {
        lamp[21] = true;
        valve23_ok = x[0];
    } else if ((robot118_ok) ^ (lift110_req)) {
        lamp[21] = false;
    } else {
        valve23_ok = false;
    }
    robot24_run = rs(&rs24, robot24_run || !conv87_on, x[32] && !heat146_run);
    valve25_on = (lamp[19]) ^ (robot107_on);
    if ((!robot41_ok) ^ (!lamp[44])) {
        lamp[46] = true;
        valve26_ok = x[52];
    } else if (door42_req || pump156_run) {
        lamp[46] = false;
    } else {
        valve26_ok = false;
    }
    pump27_ok = light73_ok || (!pump58_req && conv152_ok);
    conv28_req = (conv28_req || x[42]) && !(valve11_run || !pump75_run);
    lamp[10] = x[39] && (x[5] && !x[48]);
    pump30_run = sr(&sr30, (x[59]) ^ (!conv61_ok), lift139_on || x[0]);
    lamp[52] = !x[10] && lamp[42];
    if (rising(&edge32, valve62_ok || valve45_req))
        light32_on = !light32_on;
    lamp[26] = !lift34_on && ((x[21]) ^ (lamp[0]));
    lift34_on = reg[15] && !x[36];
    lamp[22] = conv87_on || !pump56_req;
    if (x[9] || !heat17_run) {
        lamp[13] = true;
        valve36_run = pump91_on;
    } else if (light98_on && !x[20]) {
        lamp[13] = false;
    } else {
        valve36_run = false;
    }
    valve37_on = x[39] || (reg[23] || (robot129_req && reg[28]));
    if (rising(&edge38, lift139_on && !pump56_req))
        valve38_run = !valve38_run;
    pump39_ok = (pump39_ok || reg[31]) && !(pump39_ok || !door145_run);
    door40_on = (door40_on || valve10_run) && !(lamp[58] && x[15]);
    robot41_ok = (robot41_ok || !x[30]) && !(lift67_ok && !light7_on);
    if (!conv144_run && x[21]) {
        lamp[38] = true;
        door42_req = !light20_req;
    } else if (x[5] && heat119_req) {
        lamp[38] = false;
    } else {
        door42_req = false;
    }
    robot43_on = !conv103_run || light73_ok;
    if (rising(&clock44, !lamp[35])) {
        memmove(sh44 + 1, sh44, 15);
        sh44[0] = x[0] || valve135_run;
    }
    robot44_run = sh44[15] ^ sh44[7];
    valve45_req = !x[47] && !x[20];
    if (rising(&edge46, !lamp[39] || lamp[19]))
        heat46_ok = !heat46_ok;
    conv47_ok = x[22] || (!x[57] && lift101_req);
    if (x[34] || x[60]) {
        lamp[37] = true;
        robot48_on = valve95_ok;
    } else if (heat138_req || lift105_on) {
        lamp[37] = false;
    } else {
        robot48_on = false;
    }
    lift49_on = lamp[30] || ((lift158_req) ^ (x[23] && lamp[7]));
    lift50_on = (lift50_on || heat46_ok) && !((lamp[30]) ^ (valve36_run));
    light51_req = (light51_req || valve95_ok) && !(heat46_ok || pump56_req);
    light52_ok = (light52_ok || x[52]) && !((lift92_on) ^ (valve38_run));
    if (rising(&edge53, (!lift34_on) ^ (!robot44_run)))
        heat53_ok = !heat53_ok;
    robot54_run = x[23] || (reg[29] && x[34]);
    pump55_req = valve25_on || (x[2] || !x[1]);
    pump56_req = (pump56_req || x[2]) && !(!x[58] || x[58]);
    lift57_on = lift15_run && light68_req;
    if (!door19_ok || conv113_req) {
        lamp[15] = true;
        pump58_req = pump5_req;
    } else if (conv144_run && x[7]) {
        lamp[15] = false;
    } else {
        pump58_req = false;
    }
    door59_run = (pump56_req) ^ (robot70_ok || valve62_ok);
    lift60_run = (lift60_run || x[33]) && !(!reg[11] || heat78_on);
    conv61_ok = (pump31_run) ^ (!conv113_req || !conv18_ok);
    valve62_ok = !lamp[21] || (!x[46] || x[30]);
    robot63_ok = (robot63_ok || !lift97_req) && !((x[5]) ^ (x[16]));
    pump64_on = rs(&rs64, robot63_ok || valve10_run, !conv141_req || !x[53]);
    door65_req = sr(&sr65, x[16] && lift99_run, x[18] || x[29]);
    door66_on = (door66_on || door65_req) && !(x[24] && x[20]);
    if (rising(&edge67, x[38] || !door147_ok))
        lift67_ok = !lift67_ok;
    light68_req = (!x[18]) ^ ((robot82_ok) ^ (robot123_req));
    lift69_run = (lift69_run || x[38]) && !(light68_req || robot117_ok);
    robot70_ok = !lamp[48] || ((!x[16]) ^ (valve36_run));
    if ((pump91_on) ^ (!x[14])) {
        lamp[60] = true;
        pump71_req = x[49];
    } else if (door35_req || !valve93_run) {
        lamp[60] = false;
    } else {
        pump71_req = false;
    }
    if (rising(&edge72, !pump75_run && conv157_ok))
        light72_req = !light72_req;
    if (rising(&edge73, x[41] && !reg[2]))
        light73_ok = !light73_ok;
    valve74_ok = (!x[60]) ^ (heat126_ok && !door149_on);
    pump75_run = lamp[35] && (x[28] && ((!pump56_req) ^ (door65_req)));
    lamp[16] = !x[27] && (lamp[35] || !lift105_on);
    light77_ok = (light77_ok || conv103_run) && !(x[55] || robot128_req);
    heat78_on = heat126_ok && !x[12];
    pump79_run = rs(&rs79, (valve74_ok) ^ (valve74_ok), x[37] && !valve133_run);
    robot80_ok = (robot80_ok || conv144_run) && !(!x[7] && !x[32]);
    lift81_req = (x[41]) ^ (heat148_ok || !pump55_req);
    robot82_ok = heat154_run && pump30_run;
    light83_ok = reg[20] || lift110_req;
    lift84_run = valve116_ok && (robot104_req || (pump14_req || lift131_on));
    if (rising(&edge85, (x[33]) ^ (!robot80_ok)))
        lift85_req = !lift85_req;
    heat86_ok = sr(&sr86, x[59] || pump156_run, !x[37] || valve25_on);
    if (lift60_run || reg[28]) {
        lamp[47] = true;
        conv87_on = light7_on;
    } else if (!conv87_on || valve135_run) {
        lamp[47] = false;
    } else {
        conv87_on = false;
    }
    robot88_req = !x[27] && (!heat138_req && x[34]);
    conv89_on = rs(&rs89, !x[36] || reg[20], (x[62]) ^ (!heat119_req));
    if (valve135_run && !robot128_req) {
        lamp[56] = true;
        conv90_req = x[45];
    } else if (lamp[36] && x[37]) {
        lamp[56] = false;
    } else {
        conv90_req = false;
    }
    if (lamp[14] || lamp[12]) {
        lamp[27] = true;
        pump91_on = robot54_run;
    } else if (!heat134_on || reg[5]) {
        lamp[27] = false;
    } else {
        pump91_on = false;
    }
    lift92_on = lift106_ok || (!heat46_ok && (!x[62] || !x[50]));
    valve93_run = (x[49]) ^ (x[23]);
    if (rising(&edge94, (heat148_ok) ^ (!valve8_run)))
        lift94_on = !lift94_on;
    valve95_ok = lift57_on && ((lamp[48]) ^ (!lift84_run || door147_ok));
    heat96_req = pump14_req || (!lamp[53] || (!x[46] && x[24]));
    lift97_req = (lift97_req || door132_run) && !(x[16] && !x[47]);
    lamp[40] = x[36] && (x[4] || lift29_req);
    if (rising(&clock99, !x[53])) {
        memmove(sh99 + 1, sh99, 15);
        sh99[0] = !x[49] && x[53];
    }
    lift99_run = sh99[15] ^ sh99[7];
    pump100_ok = (pump100_ok || !light73_ok) && !(valve11_run || x[18]);
    lift101_req = !x[49] || (reg[20] && reg[8]);
    robot102_ok = lamp[32] || heat53_ok;
    if (rising(&edge103, lift84_run && !x[24]))
        conv103_run = !conv103_run;
    robot104_req = door35_req || (heat148_ok || robot24_run);
    lift105_on = (lift105_on || !pump27_ok) && !((!robot88_req) ^ (valve25_on));
    if (rising(&edge106, !x[59] || lift124_req))
        lift106_ok = !lift106_ok;
    if (rising(&edge107, lift34_on || !lift99_run))
        robot107_on = !robot107_on;
    pump108_run = (pump108_run || x[48]) && !(lamp[56] && x[41]);
    door109_ok = valve135_run || ((!door112_req) ^ (robot160_ok));
    lift110_req = sr(&sr110, x[46] || x[19], x[3] && lamp[40]);
    conv111_run = heat86_ok || (reg[21] && (!valve115_on || lift6_ok));
    door112_req = (conv103_run) ^ (reg[12] || !x[53]);
    if (x[8] || lamp[30]) {
        lamp[57] = true;
        conv113_req = !x[36];
    } else if (lamp[6] && !light9_req) {
        lamp[57] = false;
    } else {
        conv113_req = false;
    }
    door114_run = x[30] || !lift150_req;
    valve115_on = conv144_run || (!x[10] && (light159_req && lamp[56]));
    valve116_ok = rs(&rs116, !valve37_on || valve4_on, x[53] && lamp[10]);
    if ((x[1]) ^ (!x[30])) {
        lamp[51] = true;
        robot117_ok = lift131_on;
    } else if (lift67_ok && x[51]) {
        lamp[51] = false;
    } else {
        robot117_ok = false;
    }
    robot118_ok = robot54_run || (!x[48] || lift150_req);
    heat119_req = (!x[6]) ^ (x[41] || valve4_on);
    light120_run = (light120_run || x[34]) && !(lamp[15] || x[49]);
    if (rising(&edge121, !x[3] || !lamp[30]))
        valve121_on = !valve121_on;
    conv122_on = !x[2] || (x[28] || x[53]);
    robot123_req = !x[35] || !lift85_req;
    if (rising(&edge124, reg[31] && conv152_ok))
        lift124_req = !lift124_req;
    lift125_run = (x[45]) ^ (x[38] || (x[20] && !x[37]));
    heat126_ok = valve133_run && ((!x[33]) ^ (door19_ok));
    if (rising(&edge127, door65_req || x[27]))
        door127_req = !door127_req;
    robot128_req = sr(&sr128, !door127_req || !x[11], !lamp[10] && pump91_on);
    robot129_req = robot80_ok || x[42];
    light130_on = lift124_req && light7_on;
    if (rising(&edge131, x[12] || lift110_req))
        lift131_on = !lift131_on;
    door132_run = !lamp[61] || x[7];
    valve133_run = !x[55] || pump108_run;
    heat134_on = (x[43]) ^ (x[55] && !reg[27]);
    lamp[61] = (!lift139_on) ^ (robot76_run);
    if (rising(&clock136, !x[34])) {
        memmove(sh136 + 1, sh136, 15);
        sh136[0] = lamp[31] && robot76_run;
    }
    lift136_ok = sh136[15] ^ sh136[7];
    if (rising(&clock137, heat134_on)) {
        memmove(sh137 + 1, sh137, 15);
        sh137[0] = x[46] || !lamp[9];
    }
    heat137_ok = sh137[15] ^ sh137[7];
    heat138_req = rs(&rs138, (!x[53]) ^ (light130_on), x[24] && !x[24]);
    lamp[32] = x[18] || x[7];
    if ((!robot48_on) ^ (x[63])) {
        lamp[21] = true;
        valve140_run = reg[9];
    } else if (!lift124_req && !x[6]) {
        lamp[21] = false;
    } else {
        valve140_run = false;
    }
    conv141_req = (conv141_req || robot143_req) && !(x[61] && lift158_req);
    conv142_run = (conv142_run || valve135_run) && !((conv103_run) ^ (!x[20]));
    robot143_req = (robot143_req || conv89_on) && !(x[37] && !conv113_req);
    lamp[53] = !x[35] || door109_ok;
    lamp[63] = robot102_ok && (!lift106_ok && lamp[48]);
    heat146_run = (heat146_run || robot129_req) && !((x[10]) ^ (door59_run));
    door147_ok = sr(&sr147, !robot104_req && x[30], !light3_run || valve116_ok);
    heat148_ok = (heat148_ok || !heat148_ok) && !((conv61_ok) ^ (x[19]));
    if (rising(&edge149, x[13] && !lift57_on))
        door149_on = !door149_on;
    lamp[38] = !lamp[0] || (x[20] || lamp[4]);
    if (rising(&clock151, pump30_run)) {
        memmove(sh151 + 1, sh151, 15);
        sh151[0] = lift49_on || !light22_ok;
    }
    robot151_run = sh151[15] ^ sh151[7];
    conv152_ok = lamp[50] || lamp[62];
    light153_req = x[22] && pump156_run;
    heat154_run = lift84_run && !door109_ok;
    pump155_run = x[60] || x[16];
    pump156_run = x[38] && ((door42_req) ^ (door127_req));
    conv157_ok = robot76_run && (!pump100_ok || !robot43_on);
    lift158_req = sr(&sr158, (door65_req) ^ (x[1]), lamp[42] && lamp[55]);
    if (rising(&clock159, lift105_on)) {
        memmove(sh159 + 1, sh159, 15);
        sh159[0] = !heat53_ok || robot43_on;
    }
    light159_req = sh159[15] ^ sh159[7];
    lamp[47] = x[14] && ((valve4_on) ^ (x[8] || !robot107_on));
    if (lift2_req || !pump71_req) {
        lamp[50] = true;
        light7_on = lift21_ok;
    } else if (!lift101_req || x[24]) {
        lamp[50] = false;
    } else {
        light7_on = false;
    }
    lamp[27] = heat154_run && ((door65_req) ^ (x[20] || valve45_req));
    if (rising(&clock163, !reg[26])) {
        memmove(sh163 + 1, sh163, 15);
        sh163[0] = !conv122_on || x[2];
    }
    robot63_ok = sh163[15] ^ sh163[7];
    lift34_on = rs(&rs164, reg[14] && lift2_req, (!x[44]) ^ (!robot128_req));
    lamp[53] = conv13_req || !conv47_ok;
    if (rising(&clock166, door59_run)) {
        memmove(sh166 + 1, sh166, 15);
        sh166[0] = pump91_on || x[50];
    }
    robot107_on = sh166[15] ^ sh166[7];
    if (rising(&clock167, !x[9])) {
        memmove(sh167 + 1, sh167, 15);
        sh167[0] = !light130_on && lift81_req;
    }
    robot107_on = sh167[15] ^ sh167[7];
    valve116_ok = conv113_req && (!lamp[12] || robot63_ok);
    robot54_run = pump71_req && (valve4_on || (lift92_on && x[54]));
    light20_req = (lift69_run) ^ ((lift60_run) ^ (!x[35] || robot160_ok));
    robot104_req = rs(&rs171, !x[57] || lamp[54], x[10] || pump155_run);
    valve36_run = lift105_on || lift124_req;
    if (rising(&edge173, !lift1_req && light32_on))
        light98_on = !light98_on;
    if (!x[50] || conv144_run) {
        lamp[49] = true;
        lift136_ok = valve135_run;
    } else if (heat154_run && reg[9]) {
        lamp[49] = false;
    } else {
        lift136_ok = false;
    }
    robot104_req = !x[8] && (!x[3] || !reg[20]);
    if (rising(&edge176, pump91_on || reg[1]))
        heat86_ok = !heat86_ok;
    pump79_run = conv144_run || heat138_req;
    pump31_run = lift1_req && reg[12];
    if (rising(&edge179, (robot143_req) ^ (lift69_run)))
        heat78_on = !heat78_on;
    if (!door19_ok && x[38]) {
        lamp[52] = true;
        light3_run = !x[46];
    } else if ((!x[60]) ^ (!x[42])) {
        lamp[52] = false;
    } else {
        light3_run = false;
    }
    if (x[38] || x[38]) {
        lamp[38] = true;
        conv142_run = !x[4];
    } else if (door19_ok && x[54]) {
        lamp[38] = false;
    } else {
        conv142_run = false;
    }
    lift105_on = (x[29]) ^ (lift105_on && x[37]);
    if (rising(&clock183, lamp[18])) {
        memmove(sh183 + 1, sh183, 15);
        sh183[0] = lamp[24] || lamp[20];
    }
    lift131_on = sh183[15] ^ sh183[7];
    lamp[46] = heat126_ok && (!lamp[30] && lift6_ok);
    conv90_req = !lift106_ok && (light120_run && !lift21_ok);
    lamp[49] = (lift158_req) ^ (x[36] && (heat138_req && x[39]));
    conv122_on = robot63_ok || x[54];
    lamp[11] = (!door66_on) ^ (x[15] || pump56_req);
    if (lamp[47] || !robot117_ok) {
        lamp[4] = true;
        lift150_req = conv89_on;
    } else if (x[60] || x[39]) {
        lamp[4] = false;
    } else {
        lift150_req = false;
    }
    conv157_ok = (conv157_ok || !light22_ok) && !((valve8_run) ^ (!lift92_on));
    pump100_ok = rs(&rs191, !x[16] && reg[7], (!lift106_ok) ^ (!x[37]));
    if (rising(&edge192, x[57] && !lift136_ok))
        heat148_ok = !heat148_ok;
    lamp[28] = !conv89_on && (!robot129_req || ((conv157_ok) ^ (heat46_ok)));
    light12_req = rs(&rs194, reg[20] && !x[41], x[2] || !door149_on);
    lift6_ok = (!x[41]) ^ (x[16] && x[51]);
    if (rising(&edge196, (lamp[24]) ^ (conv18_ok)))
        lift106_ok = !lift106_ok;
    conv122_on = (conv122_on || !x[57]) && !(heat17_run || x[10]);
    light12_req = (!lamp[49]) ^ (robot107_on || !x[63]);
    if ((robot129_req) ^ (x[56])) {
        lamp[8] = true;
        heat146_run = x[7];
    } else if (x[6] || x[50]) {
        lamp[8] = false;
    } else {
        heat146_run = false;
    }
    conv28_req = (conv28_req || robot44_run) && !((x[30]) ^ (robot128_req));
    lift158_req = (lift97_req) ^ ((lift97_req) ^ (conv111_run && !reg[18]));
    conv103_run = (conv103_run || lift99_run) && !(!lamp[48] && conv47_ok);
    lift2_req = x[13] && ((!lamp[18]) ^ ((lift69_run) ^ (!x[7])));
    lamp[10] = x[2] || (!x[23] || robot43_on);
    if (rising(&clock205, valve33_req)) {
        memmove(sh205 + 1, sh205, 15);
        sh205[0] = reg[28] && x[25];
    }
    valve26_ok = sh205[15] ^ sh205[7];
    conv111_run = (conv111_run || x[0]) && !(pump108_run || valve62_ok);
    if (rising(&clock207, conv90_req)) {
        memmove(sh207 + 1, sh207, 15);
        sh207[0] = reg[27] && lift15_run;
    }
    pump58_req = sh207[15] ^ sh207[7];
    pump31_run = sr(&sr208, x[17] && !heat137_ok, !x[45] && robot80_ok);
    conv61_ok = robot143_req || light120_run;
    valve25_on = robot88_req || x[15];
    lamp[8] = (x[41]) ^ (x[8] || pump14_req);
    lamp[61] = lift60_run && (conv89_on || x[23]);
    robot70_ok = !conv152_ok || valve38_run;
    robot80_ok = (x[15]) ^ (x[50] && valve115_on);
    valve4_on = pump14_req && x[19];
    valve140_run = lift85_req || !x[31];
    lift1_req = x[51] || (!heat126_ok || (x[37] || x[44]));
    light159_req = sr(&sr218, x[5] && x[49], !light7_on && door109_ok);
    if (!x[16] && !x[12]) {
        lamp[0] = true;
        conv18_ok = !x[53];
    } else if (!x[41] && lamp[23]) {
        lamp[0] = false;
    } else {
        conv18_ok = false;
    }
    lift57_on = !x[2] || (x[8] && (valve26_ok && lift2_req));
    lift85_req = (lift85_req || !robot102_ok) && !((valve33_req) ^ (!x[59]));
    conv47_ok = door65_req && (pump27_ok || ((pump156_run) ^ (conv103_run)));
    robot129_req = lamp[10] || !lamp[0];
    robot80_ok = valve95_ok || lamp[61];
    robot104_req = !x[29] && reg[3];
    lift85_req = sr(&sr226, !robot102_ok && light3_run, !conv103_run || x[28]);
    light73_ok = lamp[55] || x[49];
    valve10_run = light120_run || (lamp[22] || (pump16_req && x[44]));
    if (rising(&clock229, x[24])) {
        memmove(sh229 + 1, sh229, 15);
        sh229[0] = light20_req || !pump108_run;
    }
    conv141_req = sh229[15] ^ sh229[7];
    valve62_ok = !x[3] && ((valve37_on) ^ (x[17]));
    conv157_ok = x[16] && lift60_run;
    robot82_ok = conv61_ok && (lamp[63] || reg[30]);
    lift67_ok = sr(&sr233, x[21] || lamp[41], x[15] || conv90_req);
    robot41_ok = light12_req || (door149_on || (valve45_req && !lift21_ok));
    pump75_run = sr(&sr235, !conv47_ok || !lamp[4], heat154_run && door149_on);
    pump14_req = sr(&sr236, reg[12] && valve4_on, !x[26] || light77_ok);
    heat86_ok = (x[6]) ^ (x[56]);
    heat86_ok = !lamp[48] && conv142_run;
    if (rising(&clock239, pump58_req)) {
        memmove(sh239 + 1, sh239, 15);
        sh239[0] = (!x[57]) ^ (!door40_on);
    }
    valve11_run = sh239[15] ^ sh239[7];
    conv61_ok = (conv61_ok || valve93_run) && !((lamp[13]) ^ (!x[40]));
    if ((!pump39_ok) ^ (heat137_ok)) {
        lamp[44] = true;
        light73_ok = robot48_on;
    } else if (x[50] && light77_ok) {
        lamp[44] = false;
    } else {
        light73_ok = false;
    }
    heat138_req = lamp[28] || (x[25] && pump30_run);
    lift125_run = (light130_on) ^ (!robot48_on);
    lamp[55] = (x[54]) ^ (!robot48_on || lift124_req);
    lift101_req = lift15_run && lamp[4];
    light22_ok = reg[6] || ((lift97_req) ^ (lamp[63]));
    if (!reg[23] || lift1_req) {
        lamp[53] = true;
        light83_ok = lift57_on;
    } else if (x[44] || x[47]) {
        lamp[53] = false;
    } else {
        light83_ok = false;
    }
    robot117_ok = (robot117_ok || x[41]) && !(x[31] || x[42]);
    robot54_run = pump27_ok || x[39];
    robot102_ok = (robot102_ok || lamp[24]) && !(light22_ok && robot70_ok);
    if ((lamp[38]) ^ (lamp[7])) {
        lamp[28] = true;
        lift2_req = valve8_run;
    } else if (x[59] && lamp[1]) {
        lamp[28] = false;
    } else {
        lift2_req = false;
    }
    lift29_req = sr(&sr252, light83_ok && lift34_on, (!pump75_run) ^ (lift101_req));
    lift92_on = sr(&sr253, !light20_req || robot128_req, light98_on && pump91_on);
    conv89_on = light68_req || lift105_on;
    lamp[44] = conv142_run && !robot102_ok;
    lamp[34] = x[59] || (light72_req || conv47_ok);
    pump155_run = robot43_on || ((!heat148_ok) ^ (x[44]));
    robot54_run = rs(&rs258, lift125_run && !pump39_ok, (!x[0]) ^ (x[48]));
    lift101_req = sr(&sr259, !robot48_on || lamp[24], lift49_on || robot43_on);
    lamp[24] = !x[18] && !valve4_on;
    door145_run = (door145_run || conv142_run) && !(heat96_req || door66_on);
    conv61_ok = (conv61_ok || !reg[11]) && !(x[7] && lamp[36]);
    lift1_req = rs(&rs263, !heat146_run || !conv28_req, (x[53]) ^ (!valve115_on));
    robot129_req = !heat86_ok || (heat126_ok || !robot24_run);
    robot82_ok = reg[0] || ((x[31]) ^ (pump31_run || x[29]));
    light7_on = rs(&rs266, !robot118_ok || !x[42], conv28_req || lift150_req);
    light51_req = (light51_req || lift158_req) && !(robot143_req && !pump39_ok);
    lift92_on = !pump100_ok || lamp[42];
    robot123_req = (robot123_req || !x[51]) && !((x[22]) ^ (!valve4_on));
    if (rising(&clock270, pump14_req)) {
        memmove(sh270 + 1, sh270, 15);
        sh270[0] = !lift57_on || pump56_req;
    }
    lift99_run = sh270[15] ^ sh270[7];
    lamp[10] = (x[13]) ^ (light153_req);
    conv144_run = rs(&rs272, x[2] && x[1], x[42] && x[42]);
    if (rising(&clock273, robot76_run)) {
        memmove(sh273 + 1, sh273, 15);
        sh273[0] = x[12] && x[32];
    }
    valve25_on = sh273[15] ^ sh273[7];
    if (rising(&clock274, lamp[25])) {
        memmove(sh274 + 1, sh274, 15);
        sh274[0] = (!light52_ok) ^ (!robot123_req);
    }
    lift57_on = sh274[15] ^ sh274[7];
    pump79_run = reg[0] || ((!pump91_on) ^ (!conv13_req));
    light51_req = (light51_req || !pump58_req) && !(x[15] || x[63]);
    lift110_req = !conv141_req || x[59];
    if ((lamp[11]) ^ (x[0])) {
        lamp[29] = true;
        robot123_req = lamp[8];
    } else if (conv142_run && !x[54]) {
        lamp[29] = false;
    } else {
        robot123_req = false;
    }
    lift139_on = !lift69_run || (door65_req || lamp[33]);
    light130_on = rs(&rs280, !heat119_req && robot160_ok, x[13] && reg[17]);
    lift1_req = sr(&sr281, (x[5]) ^ (valve11_run), x[1] || valve45_req);
    if (rising(&clock282, lift1_req)) {
        memmove(sh282 + 1, sh282, 15);
        sh282[0] = (x[48]) ^ (!lift158_req);
    }
    lift21_ok = sh282[15] ^ sh282[7];
    valve26_ok = (valve26_ok || !lift94_on) && !(!x[19] || !valve74_ok);
    conv103_run = door65_req || (lift2_req || (!x[2] && x[25]));
    robot143_req = sr(&sr285, x[37] || !x[28], robot82_ok || light7_on);
    valve23_ok = !door42_req && !conv142_run;
    conv90_req = (heat17_run) ^ (x[43] && (!robot63_ok || x[9]));
    if (rising(&clock288, !lift94_on)) {
        memmove(sh288 + 1, sh288, 15);
        sh288[0] = valve38_run && !valve36_run;
    }
    heat137_ok = sh288[15] ^ sh288[7];
    if (x[32] && x[26]) {
        lamp[29] = true;
        light153_req = lift49_on;
    } else if (x[52] && x[18]) {
        lamp[29] = false;
    } else {
        light153_req = false;
    }
    if (rising(&clock290, light73_ok)) {
        memmove(sh290 + 1, sh290, 15);
        sh290[0] = lamp[13] && heat148_ok;
    }
    lift57_on = sh290[15] ^ sh290[7];
    pump55_req = (pump55_req || lamp[50]) && !((heat146_run) ^ (x[0]));
    if (rising(&clock292, !x[0])) {
        memmove(sh292 + 1, sh292, 15);
        sh292[0] = heat126_ok && lift50_on;
    }
    pump27_ok = sh292[15] ^ sh292[7];
    lamp[42] = x[7] || (pump39_ok || robot80_ok);
    lamp[18] = !lift81_req && (x[58] || ((valve25_on) ^ (!robot80_ok)));
    lift158_req = rs(&rs295, reg[1] && lift29_req, x[12] || reg[2]);
    lift106_ok = (lift106_ok || !x[59]) && !(lift92_on || lift125_run);
    valve33_req = (valve33_req || lamp[13]) && !(lamp[26] || !x[9]);
    heat78_on = reg[0] || (!x[40] && (heat154_run || !x[45]));
    if (rising(&edge299, !x[58] || lift125_run))
        light68_req = !light68_req;
    if (rising(&clock300, !x[37])) {
        memmove(sh300 + 1, sh300, 15);
        sh300[0] = x[55] && lift139_on;
    }
    conv111_run = sh300[15] ^ sh300[7];
    reg[0] = lift1_req ^ lift2_req ^ light3_run ^ valve4_on ^ pump5_req;
    reg[1] = lift6_ok ^ light7_on ^ valve8_run ^ light9_req ^ valve10_run;
    reg[2] = valve11_run ^ light12_req ^ conv13_req ^ pump14_req ^ lift15_run;
    reg[3] = pump16_req ^ heat17_run ^ conv18_ok ^ door19_ok ^ light20_req;
    reg[4] = lift21_ok ^ light22_ok ^ valve23_ok ^ robot24_run ^ valve25_on;
    reg[5] = valve26_ok ^ pump27_ok ^ conv28_req ^ lift29_req ^ pump30_run;
    reg[6] = pump31_run ^ light32_on ^ valve33_req ^ lift34_on ^ door35_req;
    reg[7] = valve36_run ^ valve37_on ^ valve38_run ^ pump39_ok ^ door40_on;
    reg[8] = robot41_ok ^ door42_req ^ robot43_on ^ robot44_run ^ valve45_req;
    reg[9] = heat46_ok ^ conv47_ok ^ robot48_on ^ lift49_on ^ lift50_on;
    reg[10] = light51_req ^ light52_ok ^ heat53_ok ^ robot54_run ^ pump55_req;
    reg[11] = pump56_req ^ lift57_on ^ pump58_req ^ door59_run ^ lift60_run;
    reg[12] = conv61_ok ^ valve62_ok ^ robot63_ok ^ pump64_on ^ door65_req;
    reg[13] = door66_on ^ lift67_ok ^ light68_req ^ lift69_run ^ robot70_ok;
    reg[14] = pump71_req ^ light72_req ^ light73_ok ^ valve74_ok ^ pump75_run;
    reg[15] = robot76_run ^ light77_ok ^ heat78_on ^ pump79_run ^ robot80_ok;
    reg[16] = lift81_req ^ robot82_ok ^ light83_ok ^ lift84_run ^ lift85_req;
    reg[17] = heat86_ok ^ conv87_on ^ robot88_req ^ conv89_on ^ conv90_req;
    reg[18] = pump91_on ^ lift92_on ^ valve93_run ^ lift94_on ^ valve95_ok;
    reg[19] = heat96_req ^ lift97_req ^ light98_on ^ lift99_run ^ pump100_ok;
    reg[20] = lift101_req ^ robot102_ok ^ conv103_run ^ robot104_req ^ lift105_on;
    reg[21] = lift106_ok ^ robot107_on ^ pump108_run ^ door109_ok ^ lift110_req;
    reg[22] = conv111_run ^ door112_req ^ conv113_req ^ door114_run ^ valve115_on;
    reg[23] = valve116_ok ^ robot117_ok ^ robot118_ok ^ heat119_req ^ light120_run;
    reg[24] = valve121_on ^ conv122_on ^ robot123_req ^ lift124_req ^ lift125_run;
    reg[25] = heat126_ok ^ door127_req ^ robot128_req ^ robot129_req ^ light130_on;
    reg[26] = lift131_on ^ door132_run ^ valve133_run ^ heat134_on ^ valve135_run;
    reg[27] = lift136_ok ^ heat137_ok ^ heat138_req ^ lift139_on ^ valve140_run;
    reg[28] = conv141_req ^ conv142_run ^ robot143_req ^ conv144_run ^ door145_run;
    reg[29] = heat146_run ^ door147_ok ^ heat148_ok ^ door149_on ^ lift150_req;
    reg[30] = robot151_run ^ conv152_ok ^ light153_req ^ heat154_run ^ pump155_run;
    reg[31] = pump156_run ^ conv157_ok ^ lift158_req ^ light159_req ^ robot160_ok;

    int sum = 0;
    for (int i = 0; i < 64; i++)
        if (lamp[i])
            sum += i + 1;
    for (int i = 0; i < 32; i++)
        if (reg[i])
            sum += 3 * i + 100;
    check = (check * 31 + sum) % 1000003;
}
