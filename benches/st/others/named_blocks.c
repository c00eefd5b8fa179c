#include "timers.h"

typedef struct {
    bool q;
    int n;
} Debounce;

typedef struct {
    Debounce high;
    bool memory;
} Level;

typedef struct {
    bool on_line, request;
    Timer pause;
} Pump;

typedef struct {
    int volume;
    int16_t peak, starts;
    bool was_counting;
} Meter;

static int scans, seed = 9;
static int16_t word[100], result[81];
static bool bits[100];
static Level lt101;
static Level lt102;
static Level lt103;
static Level lt104;
static Level lt105;
static Level lt106;
static Level lt107;
static Level lt108;
static Level lt109;
static Level lt110;
static Level lt111;
static Level lt112;
static Level lt113;
static Level lt114;
static Level lt115;
static Level lt116;
static Level lt117;
static Level lt118;
static Level lt119;
static Level lt120;
static Level lt121;
static Level lt122;
static Level lt123;
static Level lt124;
static Level lt125;
static Level lt126;
static Level lt127;
static Level lt128;
static Level lt129;
static Level lt130;
static Level lt131;
static Level lt132;
static Level lt133;
static Level lt134;
static Level lt135;
static Level lt136;
static Level lt137;
static Level lt138;
static Level lt139;
static Level lt140;
static Level lt141;
static Level lt142;
static Level lt143;
static Level lt144;
static Level lt145;
static Level lt146;
static Level lt147;
static Level lt148;
static Level lt149;
static Level lt150;
static Level lt151;
static Level lt152;
static Level lt153;
static Level lt154;
static Level lt155;
static Level lt156;
static Level lt157;
static Level lt158;
static Level lt159;
static Level lt160;
static Level lt161;
static Level lt162;
static Level lt163;
static Level lt164;
static Level lt165;
static Level lt166;
static Level lt167;
static Level lt168;
static Level lt169;
static Level lt170;
static Level lt171;
static Level lt172;
static Level lt173;
static Level lt174;
static Level lt175;
static Level lt176;
static Level lt177;
static Level lt178;
static Level lt179;
static Level lt180;
static Pump p201;
static Pump p202;
static Pump p203;
static Pump p204;
static Pump p205;
static Pump p206;
static Pump p207;
static Pump p208;
static Pump p209;
static Pump p210;
static Pump p211;
static Pump p212;
static Pump p213;
static Pump p214;
static Pump p215;
static Pump p216;
static Pump p217;
static Pump p218;
static Pump p219;
static Pump p220;
static Pump p221;
static Pump p222;
static Pump p223;
static Pump p224;
static Pump p225;
static Pump p226;
static Pump p227;
static Pump p228;
static Pump p229;
static Pump p230;
static Pump p231;
static Pump p232;
static Pump p233;
static Pump p234;
static Pump p235;
static Pump p236;
static Pump p237;
static Pump p238;
static Pump p239;
static Pump p240;
static Pump p241;
static Pump p242;
static Pump p243;
static Pump p244;
static Pump p245;
static Pump p246;
static Pump p247;
static Pump p248;
static Pump p249;
static Pump p250;
static Pump p251;
static Pump p252;
static Pump p253;
static Pump p254;
static Pump p255;
static Pump p256;
static Pump p257;
static Pump p258;
static Pump p259;
static Pump p260;
static Pump p261;
static Pump p262;
static Pump p263;
static Pump p264;
static Pump p265;
static Pump p266;
static Pump p267;
static Pump p268;
static Pump p269;
static Pump p270;
static Meter m301;
static Meter m302;
static Meter m303;
static Meter m304;
static Meter m305;
static Meter m306;
static Meter m307;
static Meter m308;
static Meter m309;
static Meter m310;
static Meter m311;
static Meter m312;
static Meter m313;
static Meter m314;
static Meter m315;
static Meter m316;
static Meter m317;
static Meter m318;
static Meter m319;
static Meter m320;
static Meter m321;
static Meter m322;
static Meter m323;
static Meter m324;
static Meter m325;
static Meter m326;
static Meter m327;
static Meter m328;
static Meter m329;
static Meter m330;
static Meter m331;
static Meter m332;
static Meter m333;
static Meter m334;
static Meter m335;
static Meter m336;
static Meter m337;
static Meter m338;
static Meter m339;
static Meter m340;
static Meter m341;
static Meter m342;
static Meter m343;
static Meter m344;
static Meter m345;
static Meter m346;
static Meter m347;
static Meter m348;
static Meter m349;
static Meter m350;

static inline int percent(int raw, int zero, int span)
{
    int wide = (raw - zero) * 100 / span;
    return wide < 0 ? 0 : wide > 100 ? 100 : wide;
}

static inline bool between(int low, int x, int high) { return x >= low && x <= high; }

static bool debounce(Debounce *d, bool signal, int scans_needed)
{
    if (signal == d->q) {
        d->n = 0;
    } else if (++d->n >= scans_needed) {
        d->q = signal;
        d->n = 0;
    }
    return d->q;
}

static bool level(Level *l, int raw, int bound, bool quit, int16_t *value)
{
    *value = percent(raw, 4000, 16000);
    bool high = debounce(&l->high, *value > bound, 3);
    return l->memory = high || (!quit && l->memory);
}

static bool pump(Pump *p, bool release, int height, int upper, int lower)
{
    if (height > upper)
        p->request = true;
    else if (!between(lower, height, upper))
        p->request = false;
    tof(&p->pause, p->on_line, 20);
    return p->on_line = p->request && release && (p->on_line || !p->pause.q);
}

static int meter(Meter *m, int flow, bool counting, bool clear)
{
    if (clear) {
        m->volume = 0;
        m->peak = 0;
        m->starts = 0;
    } else if (counting) {
        m->volume += flow;
        if (flow > m->peak)
            m->peak = flow;
        if (!m->was_counting && m->starts < INT16_MAX)
            m->starts++;
    }
    m->was_counting = counting;
    if (m->starts >= 5)
        m->volume += m->starts;
    return m->volume % 1000;
}

void scan(void)
{
    now_ms = now_us / 1000;
    scans++;
    int sum = 0;
    seed = (seed * 75 + 74) % 65537;
    for (int i = 0; i < 100; i++)
        word[i] = (seed + i * 517 + scans * 90) % 20000 + 2000;
    for (int i = 0; i < 20; i++)
        bits[i] = (scans + i) % 37 < 5;

    bits[20] = level(&lt101, word[79], 87, bits[32], &result[1]);
    bits[21] = level(&lt102, word[45], 87, bits[88], &result[2]);
    bits[22] = level(&lt103, word[83], 41, bits[67], &result[3]);
    bits[23] = level(&lt104, word[59], 55, bits[99], &result[4]);
    bits[24] = level(&lt105, word[83], 50, bits[6], &result[5]);
    bits[25] = level(&lt106, word[14], 70, bits[47], &result[6]);
    bits[26] = level(&lt107, word[31], 74, bits[48], &result[7]);
    bits[27] = level(&lt108, word[13], 55, bits[73], &result[8]);
    bits[28] = level(&lt109, word[1], 53, bits[93], &result[9]);
    bits[29] = level(&lt110, word[52], 51, bits[35], &result[10]);
    bits[30] = level(&lt111, word[98], 50, bits[49], &result[11]);
    bits[31] = level(&lt112, word[97], 48, bits[9], &result[12]);
    bits[32] = level(&lt113, word[79], 68, bits[79], &result[13]);
    bits[33] = level(&lt114, word[16], 40, bits[16], &result[14]);
    bits[34] = level(&lt115, word[0], 89, bits[26], &result[15]);
    bits[35] = level(&lt116, word[27], 50, bits[21], &result[16]);
    bits[36] = level(&lt117, word[37], 52, bits[40], &result[17]);
    bits[37] = level(&lt118, word[69], 80, bits[86], &result[18]);
    bits[38] = level(&lt119, word[26], 84, bits[23], &result[19]);
    bits[39] = level(&lt120, word[25], 59, bits[49], &result[20]);
    bits[40] = level(&lt121, word[2], 66, bits[46], &result[21]);
    bits[41] = level(&lt122, word[21], 56, bits[18], &result[22]);
    bits[42] = level(&lt123, word[8], 59, bits[42], &result[23]);
    bits[43] = level(&lt124, word[77], 40, bits[75], &result[24]);
    bits[44] = level(&lt125, word[76], 85, bits[86], &result[25]);
    bits[45] = level(&lt126, word[43], 59, bits[8], &result[26]);
    bits[46] = level(&lt127, word[45], 70, bits[39], &result[27]);
    bits[47] = level(&lt128, word[89], 51, bits[40], &result[28]);
    bits[48] = level(&lt129, word[61], 85, bits[60], &result[29]);
    bits[49] = level(&lt130, word[22], 56, bits[7], &result[30]);
    bits[50] = level(&lt131, word[2], 62, bits[95], &result[31]);
    bits[51] = level(&lt132, word[51], 75, bits[2], &result[32]);
    bits[52] = level(&lt133, word[53], 64, bits[46], &result[33]);
    bits[53] = level(&lt134, word[74], 68, bits[1], &result[34]);
    bits[54] = level(&lt135, word[5], 51, bits[90], &result[35]);
    bits[55] = level(&lt136, word[79], 47, bits[25], &result[36]);
    bits[56] = level(&lt137, word[96], 69, bits[31], &result[37]);
    bits[57] = level(&lt138, word[44], 62, bits[65], &result[38]);
    bits[58] = level(&lt139, word[67], 89, bits[32], &result[39]);
    bits[59] = level(&lt140, word[59], 77, bits[13], &result[40]);
    bits[60] = level(&lt141, word[95], 63, bits[99], &result[41]);
    bits[61] = level(&lt142, word[37], 67, bits[4], &result[42]);
    bits[62] = level(&lt143, word[11], 61, bits[26], &result[43]);
    bits[63] = level(&lt144, word[65], 63, bits[78], &result[44]);
    bits[64] = level(&lt145, word[18], 57, bits[43], &result[45]);
    bits[65] = level(&lt146, word[89], 45, bits[69], &result[46]);
    bits[66] = level(&lt147, word[39], 60, bits[87], &result[47]);
    bits[67] = level(&lt148, word[39], 45, bits[22], &result[48]);
    bits[68] = level(&lt149, word[80], 86, bits[19], &result[49]);
    bits[69] = level(&lt150, word[88], 70, bits[39], &result[50]);
    bits[70] = level(&lt151, word[20], 43, bits[92], &result[51]);
    bits[71] = level(&lt152, word[10], 74, bits[76], &result[52]);
    bits[72] = level(&lt153, word[51], 55, bits[4], &result[53]);
    bits[73] = level(&lt154, word[94], 62, bits[76], &result[54]);
    bits[74] = level(&lt155, word[32], 81, bits[58], &result[55]);
    bits[75] = level(&lt156, word[53], 43, bits[18], &result[56]);
    bits[76] = level(&lt157, word[81], 71, bits[4], &result[57]);
    bits[77] = level(&lt158, word[42], 48, bits[26], &result[58]);
    bits[78] = level(&lt159, word[93], 48, bits[72], &result[59]);
    bits[79] = level(&lt160, word[80], 46, bits[52], &result[60]);
    bits[80] = level(&lt161, word[21], 63, bits[55], &result[61]);
    bits[81] = level(&lt162, word[19], 66, bits[7], &result[62]);
    bits[82] = level(&lt163, word[37], 69, bits[18], &result[63]);
    bits[83] = level(&lt164, word[79], 73, bits[21], &result[64]);
    bits[84] = level(&lt165, word[58], 84, bits[62], &result[65]);
    bits[85] = level(&lt166, word[93], 70, bits[40], &result[66]);
    bits[86] = level(&lt167, word[35], 70, bits[37], &result[67]);
    bits[87] = level(&lt168, word[51], 47, bits[18], &result[68]);
    bits[88] = level(&lt169, word[48], 51, bits[68], &result[69]);
    bits[89] = level(&lt170, word[80], 61, bits[63], &result[70]);
    bits[90] = level(&lt171, word[23], 71, bits[11], &result[71]);
    bits[91] = level(&lt172, word[34], 75, bits[65], &result[72]);
    bits[92] = level(&lt173, word[64], 44, bits[46], &result[73]);
    bits[93] = level(&lt174, word[99], 84, bits[45], &result[74]);
    bits[94] = level(&lt175, word[75], 42, bits[84], &result[75]);
    bits[95] = level(&lt176, word[97], 63, bits[39], &result[76]);
    bits[96] = level(&lt177, word[71], 82, bits[90], &result[77]);
    bits[97] = level(&lt178, word[35], 56, bits[62], &result[78]);
    bits[98] = level(&lt179, word[98], 85, bits[88], &result[79]);
    bits[99] = level(&lt180, word[37], 81, bits[43], &result[80]);
    if (pump(&p201, !bits[74], result[23], 77, 10))
        sum += 1;
    if (pump(&p202, !bits[70], result[61], 74, 18))
        sum += 2;
    if (pump(&p203, !bits[85], result[42], 58, 24))
        sum += 3;
    if (pump(&p204, !bits[64], result[37], 70, 31))
        sum += 4;
    if (pump(&p205, !bits[44], result[46], 58, 30))
        sum += 5;
    if (pump(&p206, !bits[94], result[45], 76, 23))
        sum += 6;
    if (pump(&p207, !bits[22], result[45], 77, 37))
        sum += 7;
    if (pump(&p208, !bits[46], result[58], 60, 26))
        sum += 8;
    if (pump(&p209, !bits[67], result[19], 55, 16))
        sum += 9;
    if (pump(&p210, !bits[61], result[47], 59, 32))
        sum += 10;
    if (pump(&p211, !bits[92], result[11], 71, 33))
        sum += 11;
    if (pump(&p212, !bits[21], result[54], 69, 34))
        sum += 12;
    if (pump(&p213, !bits[66], result[75], 71, 39))
        sum += 13;
    if (pump(&p214, !bits[38], result[54], 69, 27))
        sum += 14;
    if (pump(&p215, !bits[92], result[35], 50, 16))
        sum += 15;
    if (pump(&p216, !bits[75], result[21], 64, 29))
        sum += 16;
    if (pump(&p217, !bits[28], result[24], 74, 31))
        sum += 17;
    if (pump(&p218, !bits[80], result[24], 72, 11))
        sum += 18;
    if (pump(&p219, !bits[28], result[61], 55, 11))
        sum += 19;
    if (pump(&p220, !bits[14], result[18], 60, 15))
        sum += 20;
    if (pump(&p221, !bits[24], result[62], 67, 11))
        sum += 21;
    if (pump(&p222, !bits[59], result[54], 61, 22))
        sum += 22;
    if (pump(&p223, !bits[9], result[79], 68, 16))
        sum += 23;
    if (pump(&p224, !bits[91], result[31], 78, 21))
        sum += 24;
    if (pump(&p225, !bits[44], result[1], 62, 18))
        sum += 25;
    if (pump(&p226, !bits[14], result[53], 72, 36))
        sum += 26;
    if (pump(&p227, !bits[47], result[71], 51, 27))
        sum += 27;
    if (pump(&p228, !bits[38], result[79], 53, 19))
        sum += 28;
    if (pump(&p229, !bits[65], result[70], 60, 28))
        sum += 29;
    if (pump(&p230, !bits[45], result[38], 76, 14))
        sum += 30;
    if (pump(&p231, !bits[52], result[54], 76, 28))
        sum += 31;
    if (pump(&p232, !bits[47], result[69], 64, 14))
        sum += 32;
    if (pump(&p233, !bits[76], result[21], 62, 28))
        sum += 33;
    if (pump(&p234, !bits[25], result[62], 54, 29))
        sum += 34;
    if (pump(&p235, !bits[44], result[12], 76, 38))
        sum += 35;
    if (pump(&p236, !bits[48], result[1], 53, 20))
        sum += 36;
    if (pump(&p237, !bits[78], result[73], 67, 14))
        sum += 37;
    if (pump(&p238, !bits[80], result[42], 78, 38))
        sum += 38;
    if (pump(&p239, !bits[48], result[73], 63, 23))
        sum += 39;
    if (pump(&p240, !bits[63], result[29], 59, 25))
        sum += 40;
    if (pump(&p241, !bits[49], result[49], 77, 39))
        sum += 41;
    if (pump(&p242, !bits[76], result[21], 69, 18))
        sum += 42;
    if (pump(&p243, !bits[63], result[39], 58, 23))
        sum += 43;
    if (pump(&p244, !bits[40], result[3], 59, 25))
        sum += 44;
    if (pump(&p245, !bits[18], result[37], 65, 10))
        sum += 45;
    if (pump(&p246, !bits[84], result[16], 69, 24))
        sum += 46;
    if (pump(&p247, !bits[37], result[32], 51, 35))
        sum += 47;
    if (pump(&p248, !bits[50], result[18], 50, 25))
        sum += 48;
    if (pump(&p249, !bits[71], result[69], 58, 17))
        sum += 49;
    if (pump(&p250, !bits[4], result[61], 57, 25))
        sum += 50;
    if (pump(&p251, !bits[19], result[35], 73, 19))
        sum += 51;
    if (pump(&p252, !bits[63], result[38], 69, 25))
        sum += 52;
    if (pump(&p253, !bits[82], result[67], 77, 29))
        sum += 53;
    if (pump(&p254, !bits[2], result[16], 74, 14))
        sum += 54;
    if (pump(&p255, !bits[36], result[39], 67, 32))
        sum += 55;
    if (pump(&p256, !bits[78], result[44], 59, 33))
        sum += 56;
    if (pump(&p257, !bits[3], result[68], 64, 21))
        sum += 57;
    if (pump(&p258, !bits[87], result[47], 73, 36))
        sum += 58;
    if (pump(&p259, !bits[16], result[76], 51, 10))
        sum += 59;
    if (pump(&p260, !bits[70], result[33], 64, 31))
        sum += 60;
    if (pump(&p261, !bits[87], result[14], 67, 16))
        sum += 61;
    if (pump(&p262, !bits[54], result[2], 74, 35))
        sum += 62;
    if (pump(&p263, !bits[76], result[55], 68, 32))
        sum += 63;
    if (pump(&p264, !bits[49], result[62], 65, 22))
        sum += 64;
    if (pump(&p265, !bits[37], result[26], 64, 36))
        sum += 65;
    if (pump(&p266, !bits[38], result[9], 76, 10))
        sum += 66;
    if (pump(&p267, !bits[74], result[56], 59, 30))
        sum += 67;
    if (pump(&p268, !bits[39], result[61], 54, 15))
        sum += 68;
    if (pump(&p269, !bits[88], result[62], 67, 38))
        sum += 69;
    if (pump(&p270, !bits[42], result[64], 67, 14))
        sum += 70;
    sum += meter(&m301, result[55], p270.on_line, scans % 400 == 1);
    sum += m301.peak;
    sum += meter(&m302, result[7], p209.on_line, scans % 400 == 2);
    sum += m302.peak;
    sum += meter(&m303, result[30], p235.on_line, scans % 400 == 3);
    sum += m303.peak;
    sum += meter(&m304, result[11], p209.on_line, scans % 400 == 4);
    sum += m304.peak;
    sum += meter(&m305, result[4], p243.on_line, scans % 400 == 5);
    sum += m305.peak;
    sum += meter(&m306, result[55], p209.on_line, scans % 400 == 6);
    sum += m306.peak;
    sum += meter(&m307, result[52], p263.on_line, scans % 400 == 7);
    sum += m307.peak;
    sum += meter(&m308, result[7], p216.on_line, scans % 400 == 8);
    sum += m308.peak;
    sum += meter(&m309, result[16], p229.on_line, scans % 400 == 9);
    sum += m309.peak;
    sum += meter(&m310, result[79], p215.on_line, scans % 400 == 10);
    sum += m310.peak;
    sum += meter(&m311, result[18], p238.on_line, scans % 400 == 11);
    sum += m311.peak;
    sum += meter(&m312, result[57], p220.on_line, scans % 400 == 12);
    sum += m312.peak;
    sum += meter(&m313, result[24], p224.on_line, scans % 400 == 13);
    sum += m313.peak;
    sum += meter(&m314, result[53], p221.on_line, scans % 400 == 14);
    sum += m314.peak;
    sum += meter(&m315, result[9], p228.on_line, scans % 400 == 15);
    sum += m315.peak;
    sum += meter(&m316, result[6], p214.on_line, scans % 400 == 16);
    sum += m316.peak;
    sum += meter(&m317, result[49], p210.on_line, scans % 400 == 17);
    sum += m317.peak;
    sum += meter(&m318, result[36], p208.on_line, scans % 400 == 18);
    sum += m318.peak;
    sum += meter(&m319, result[74], p216.on_line, scans % 400 == 19);
    sum += m319.peak;
    sum += meter(&m320, result[52], p218.on_line, scans % 400 == 20);
    sum += m320.peak;
    sum += meter(&m321, result[2], p256.on_line, scans % 400 == 21);
    sum += m321.peak;
    sum += meter(&m322, result[12], p241.on_line, scans % 400 == 22);
    sum += m322.peak;
    sum += meter(&m323, result[77], p263.on_line, scans % 400 == 23);
    sum += m323.peak;
    sum += meter(&m324, result[63], p246.on_line, scans % 400 == 24);
    sum += m324.peak;
    sum += meter(&m325, result[48], p208.on_line, scans % 400 == 25);
    sum += m325.peak;
    sum += meter(&m326, result[18], p238.on_line, scans % 400 == 26);
    sum += m326.peak;
    sum += meter(&m327, result[20], p265.on_line, scans % 400 == 27);
    sum += m327.peak;
    sum += meter(&m328, result[38], p229.on_line, scans % 400 == 28);
    sum += m328.peak;
    sum += meter(&m329, result[34], p209.on_line, scans % 400 == 29);
    sum += m329.peak;
    sum += meter(&m330, result[71], p231.on_line, scans % 400 == 30);
    sum += m330.peak;
    sum += meter(&m331, result[33], p237.on_line, scans % 400 == 31);
    sum += m331.peak;
    sum += meter(&m332, result[67], p218.on_line, scans % 400 == 32);
    sum += m332.peak;
    sum += meter(&m333, result[31], p248.on_line, scans % 400 == 33);
    sum += m333.peak;
    sum += meter(&m334, result[59], p250.on_line, scans % 400 == 34);
    sum += m334.peak;
    sum += meter(&m335, result[23], p217.on_line, scans % 400 == 35);
    sum += m335.peak;
    sum += meter(&m336, result[3], p244.on_line, scans % 400 == 36);
    sum += m336.peak;
    sum += meter(&m337, result[11], p205.on_line, scans % 400 == 37);
    sum += m337.peak;
    sum += meter(&m338, result[12], p216.on_line, scans % 400 == 38);
    sum += m338.peak;
    sum += meter(&m339, result[65], p259.on_line, scans % 400 == 39);
    sum += m339.peak;
    sum += meter(&m340, result[31], p250.on_line, scans % 400 == 40);
    sum += m340.peak;
    sum += meter(&m341, result[60], p262.on_line, scans % 400 == 41);
    sum += m341.peak;
    sum += meter(&m342, result[42], p214.on_line, scans % 400 == 42);
    sum += m342.peak;
    sum += meter(&m343, result[68], p204.on_line, scans % 400 == 43);
    sum += m343.peak;
    sum += meter(&m344, result[70], p250.on_line, scans % 400 == 44);
    sum += m344.peak;
    sum += meter(&m345, result[7], p220.on_line, scans % 400 == 45);
    sum += m345.peak;
    sum += meter(&m346, result[55], p229.on_line, scans % 400 == 46);
    sum += m346.peak;
    sum += meter(&m347, result[15], p211.on_line, scans % 400 == 47);
    sum += m347.peak;
    sum += meter(&m348, result[63], p228.on_line, scans % 400 == 48);
    sum += m348.peak;
    sum += meter(&m349, result[18], p249.on_line, scans % 400 == 49);
    sum += m349.peak;
    sum += meter(&m350, result[46], p231.on_line, scans % 400 == 50);
    sum += m350.peak;

    for (int i = 1; i <= 80; i++) {
        if (bits[i + 19])
            sum += i;
        sum += result[i];
    }
    check = (check * 31 + sum) % 1000003;
}
