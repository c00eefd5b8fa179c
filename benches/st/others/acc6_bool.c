#include <stdbool.h>
#include "st.h"

static uint32_t lfsr = 12345;
static uint16_t n;
static bool in0, in1, in2, in3, in4, in5, in6, in7, in8, in9, in10, in11, in12, in13, in14, in15, in16, in17, in18, in19, in20, in21, in22, in23, in24, in25, in26, in27, in28, in29, in30, in31;
static bool auto0, run0, fault0, ready0, clamp0, adv0, ret0, part0, pulse0, drop0, lamp0, ack0, done0, horn0;
static bool auto1, run1, fault1, ready1, clamp1, adv1, ret1, part1, pulse1, drop1, lamp1, ack1, done1, horn1;
static bool auto2, run2, fault2, ready2, clamp2, adv2, ret2, part2, pulse2, drop2, lamp2, ack2, done2, horn2;
static bool auto3, run3, fault3, ready3, clamp3, adv3, ret3, part3, pulse3, drop3, lamp3, ack3, done3, horn3;
static bool auto4, run4, fault4, ready4, clamp4, adv4, ret4, part4, pulse4, drop4, lamp4, ack4, done4, horn4;
static bool auto5, run5, fault5, ready5, clamp5, adv5, ret5, part5, pulse5, drop5, lamp5, ack5, done5, horn5;
static bool auto6, run6, fault6, ready6, clamp6, adv6, ret6, part6, pulse6, drop6, lamp6, ack6, done6, horn6;
static bool auto7, run7, fault7, ready7, clamp7, adv7, ret7, part7, pulse7, drop7, lamp7, ack7, done7, horn7;
static bool auto8, run8, fault8, ready8, clamp8, adv8, ret8, part8, pulse8, drop8, lamp8, ack8, done8, horn8;
static bool auto9, run9, fault9, ready9, clamp9, adv9, ret9, part9, pulse9, drop9, lamp9, ack9, done9, horn9;
static bool auto10, run10, fault10, ready10, clamp10, adv10, ret10, part10, pulse10, drop10, lamp10, ack10, done10, horn10;
static bool auto11, run11, fault11, ready11, clamp11, adv11, ret11, part11, pulse11, drop11, lamp11, ack11, done11, horn11;
static bool auto12, run12, fault12, ready12, clamp12, adv12, ret12, part12, pulse12, drop12, lamp12, ack12, done12, horn12;
static bool auto13, run13, fault13, ready13, clamp13, adv13, ret13, part13, pulse13, drop13, lamp13, ack13, done13, horn13;
static bool auto14, run14, fault14, ready14, clamp14, adv14, ret14, part14, pulse14, drop14, lamp14, ack14, done14, horn14;
static bool auto15, run15, fault15, ready15, clamp15, adv15, ret15, part15, pulse15, drop15, lamp15, ack15, done15, horn15;
static bool auto16, run16, fault16, ready16, clamp16, adv16, ret16, part16, pulse16, drop16, lamp16, ack16, done16, horn16;
static bool auto17, run17, fault17, ready17, clamp17, adv17, ret17, part17, pulse17, drop17, lamp17, ack17, done17, horn17;
static bool auto18, run18, fault18, ready18, clamp18, adv18, ret18, part18, pulse18, drop18, lamp18, ack18, done18, horn18;
static bool auto19, run19, fault19, ready19, clamp19, adv19, ret19, part19, pulse19, drop19, lamp19, ack19, done19, horn19;
static bool auto20, run20, fault20, ready20, clamp20, adv20, ret20, part20, pulse20, drop20, lamp20, ack20, done20, horn20;
static bool auto21, run21, fault21, ready21, clamp21, adv21, ret21, part21, pulse21, drop21, lamp21, ack21, done21, horn21;
static bool auto22, run22, fault22, ready22, clamp22, adv22, ret22, part22, pulse22, drop22, lamp22, ack22, done22, horn22;
static bool auto23, run23, fault23, ready23, clamp23, adv23, ret23, part23, pulse23, drop23, lamp23, ack23, done23, horn23;
static bool sr0, rs0, rt0, ft0;
static bool sr1, rs1, rt1, ft1;
static bool sr2, rs2, rt2, ft2;
static bool sr3, rs3, rt3, ft3;
static bool sr4, rs4, rt4, ft4;
static bool sr5, rs5, rt5, ft5;
static bool sr6, rs6, rt6, ft6;
static bool sr7, rs7, rt7, ft7;
static bool sr8, rs8, rt8, ft8;
static bool sr9, rs9, rt9, ft9;
static bool sr10, rs10, rt10, ft10;
static bool sr11, rs11, rt11, ft11;
static bool sr12, rs12, rt12, ft12;
static bool sr13, rs13, rt13, ft13;
static bool sr14, rs14, rt14, ft14;
static bool sr15, rs15, rt15, ft15;
static bool sr16, rs16, rt16, ft16;
static bool sr17, rs17, rt17, ft17;
static bool sr18, rs18, rt18, ft18;
static bool sr19, rs19, rt19, ft19;
static bool sr20, rs20, rt20, ft20;
static bool sr21, rs21, rt21, ft21;
static bool sr22, rs22, rt22, ft22;
static bool sr23, rs23, rt23, ft23;

void scan(void)
{
    uint32_t x, out = 0;
    bool blink;
    lfsr = lfsr * 1664525u + 1013904223u;
    x = lfsr;
    x ^= x >> 13;
    n++;
    blink = (n / 25) % 2 == 1;
    in0 = (x >> 0) & 1;
    in1 = (x >> 1) & 1;
    in2 = (x >> 2) & 1;
    in3 = (x >> 3) & 1;
    in4 = (x >> 4) & 1;
    in5 = (x >> 5) & 1;
    in6 = (x >> 6) & 1;
    in7 = (x >> 7) & 1;
    in8 = (x >> 8) & 1;
    in9 = (x >> 9) & 1;
    in10 = (x >> 10) & 1;
    in11 = (x >> 11) & 1;
    in12 = (x >> 12) & 1;
    in13 = (x >> 13) & 1;
    in14 = (x >> 14) & 1;
    in15 = (x >> 15) & 1;
    in16 = (x >> 16) & 1;
    in17 = (x >> 17) & 1;
    in18 = (x >> 18) & 1;
    in19 = (x >> 19) & 1;
    in20 = (x >> 20) & 1;
    in21 = (x >> 21) & 1;
    in22 = (x >> 22) & 1;
    in23 = (x >> 23) & 1;
    in24 = (x >> 24) & 1;
    in25 = (x >> 25) & 1;
    in26 = (x >> 26) & 1;
    in27 = (x >> 27) & 1;
    in28 = (x >> 28) & 1;
    in29 = (x >> 29) & 1;
    in30 = (x >> 30) & 1;
    in31 = (x >> 31) & 1;
    /* station 0 */
    auto0 = (in4 | auto0) & !in19 & !fault23;
    ready0 = auto0 & (in27 | !in15) & !fault0;
    sr0 = (ready0 & in28) | (sr0 & !(in18 | fault5)); run0 = sr0;
    clamp0 = (run0 & !part23) | (clamp0 & in16 & !done0);
    adv0 = clamp0 & !ret0 & (in6 ^ in31);
    ret0 = (!adv0 & run0 & in11) | (ret0 & !in29);
    part0 = (adv0 & in8) | (part23 & in4 & !ret5);
    { bool k = part0 & in23; pulse0 = k & !rt0; rt0 = k; }
    drop0 = !clamp0 & !ft0; ft0 = !clamp0;
    if (pulse0 & in10) ack0 = true; else if (drop0) ack0 = false;
    done0 = (ack0 ^ pulse0) | (drop0 & in29);
    rs0 = !(in24 & !run0) & (rs0 | (adv0 & ret0) | (in1 & in7 & drop0)); fault0 = rs0;
    lamp0 = (fault0 & blink) | (run0 & !fault0) | (ready0 & !run0 & !blink);
    horn0 = ((horn23 | fault0) & !ack0) ^ in8;
    /* station 1 */
    auto1 = (in23 | auto1) & !in1 & !fault0;
    ready1 = auto1 & (in0 | !in13) & !fault1;
    sr1 = (ready1 & in29) | (sr1 & !(in13 | fault6)); run1 = sr1;
    clamp1 = (run1 & !part0) | (clamp1 & in20 & !done1);
    adv1 = clamp1 & !ret1 & (in30 ^ in19);
    ret1 = (!adv1 & run1 & in12) | (ret1 & !in18);
    part1 = (adv1 & in4) | (part0 & in12 & !ret6);
    { bool k = part1 & in20; pulse1 = k & !rt1; rt1 = k; }
    drop1 = !clamp1 & !ft1; ft1 = !clamp1;
    if (pulse1 & in22) ack1 = true; else if (drop1) ack1 = false;
    done1 = (ack1 ^ pulse1) | (drop1 & in4);
    rs1 = !(in25 & !run1) & (rs1 | (adv1 & ret1) | (in19 & in5 & drop1)); fault1 = rs1;
    lamp1 = (fault1 & blink) | (run1 & !fault1) | (ready1 & !run1 & !blink);
    horn1 = ((horn0 | fault1) & !ack1) ^ in17;
    /* station 2 */
    auto2 = (in1 | auto2) & !in7 & !fault1;
    ready2 = auto2 & (in22 | !in30) & !fault2;
    sr2 = (ready2 & in26) | (sr2 & !(in3 | fault7)); run2 = sr2;
    clamp2 = (run2 & !part1) | (clamp2 & in25 & !done2);
    adv2 = clamp2 & !ret2 & (in6 ^ in27);
    ret2 = (!adv2 & run2 & in20) | (ret2 & !in30);
    part2 = (adv2 & in23) | (part1 & in23 & !ret7);
    { bool k = part2 & in13; pulse2 = k & !rt2; rt2 = k; }
    drop2 = !clamp2 & !ft2; ft2 = !clamp2;
    if (pulse2 & in11) ack2 = true; else if (drop2) ack2 = false;
    done2 = (ack2 ^ pulse2) | (drop2 & in20);
    rs2 = !(in18 & !run2) & (rs2 | (adv2 & ret2) | (in19 & in0 & drop2)); fault2 = rs2;
    lamp2 = (fault2 & blink) | (run2 & !fault2) | (ready2 & !run2 & !blink);
    horn2 = ((horn1 | fault2) & !ack2) ^ in30;
    /* station 3 */
    auto3 = (in20 | auto3) & !in29 & !fault2;
    ready3 = auto3 & (in21 | !in2) & !fault3;
    sr3 = (ready3 & in11) | (sr3 & !(in18 | fault8)); run3 = sr3;
    clamp3 = (run3 & !part2) | (clamp3 & in21 & !done3);
    adv3 = clamp3 & !ret3 & (in6 ^ in21);
    ret3 = (!adv3 & run3 & in3) | (ret3 & !in23);
    part3 = (adv3 & in7) | (part2 & in1 & !ret8);
    { bool k = part3 & in25; pulse3 = k & !rt3; rt3 = k; }
    drop3 = !clamp3 & !ft3; ft3 = !clamp3;
    if (pulse3 & in1) ack3 = true; else if (drop3) ack3 = false;
    done3 = (ack3 ^ pulse3) | (drop3 & in9);
    rs3 = !(in27 & !run3) & (rs3 | (adv3 & ret3) | (in11 & in6 & drop3)); fault3 = rs3;
    lamp3 = (fault3 & blink) | (run3 & !fault3) | (ready3 & !run3 & !blink);
    horn3 = ((horn2 | fault3) & !ack3) ^ in6;
    /* station 4 */
    auto4 = (in6 | auto4) & !in19 & !fault3;
    ready4 = auto4 & (in24 | !in14) & !fault4;
    sr4 = (ready4 & in4) | (sr4 & !(in3 | fault9)); run4 = sr4;
    clamp4 = (run4 & !part3) | (clamp4 & in31 & !done4);
    adv4 = clamp4 & !ret4 & (in5 ^ in11);
    ret4 = (!adv4 & run4 & in30) | (ret4 & !in23);
    part4 = (adv4 & in13) | (part3 & in6 & !ret9);
    { bool k = part4 & in16; pulse4 = k & !rt4; rt4 = k; }
    drop4 = !clamp4 & !ft4; ft4 = !clamp4;
    if (pulse4 & in27) ack4 = true; else if (drop4) ack4 = false;
    done4 = (ack4 ^ pulse4) | (drop4 & in17);
    rs4 = !(in22 & !run4) & (rs4 | (adv4 & ret4) | (in26 & in5 & drop4)); fault4 = rs4;
    lamp4 = (fault4 & blink) | (run4 & !fault4) | (ready4 & !run4 & !blink);
    horn4 = ((horn3 | fault4) & !ack4) ^ in10;
    /* station 5 */
    auto5 = (in25 | auto5) & !in10 & !fault4;
    ready5 = auto5 & (in13 | !in9) & !fault5;
    sr5 = (ready5 & in15) | (sr5 & !(in4 | fault10)); run5 = sr5;
    clamp5 = (run5 & !part4) | (clamp5 & in0 & !done5);
    adv5 = clamp5 & !ret5 & (in7 ^ in25);
    ret5 = (!adv5 & run5 & in7) | (ret5 & !in10);
    part5 = (adv5 & in17) | (part4 & in24 & !ret10);
    { bool k = part5 & in26; pulse5 = k & !rt5; rt5 = k; }
    drop5 = !clamp5 & !ft5; ft5 = !clamp5;
    if (pulse5 & in14) ack5 = true; else if (drop5) ack5 = false;
    done5 = (ack5 ^ pulse5) | (drop5 & in20);
    rs5 = !(in19 & !run5) & (rs5 | (adv5 & ret5) | (in21 & in19 & drop5)); fault5 = rs5;
    lamp5 = (fault5 & blink) | (run5 & !fault5) | (ready5 & !run5 & !blink);
    horn5 = ((horn4 | fault5) & !ack5) ^ in17;
    /* station 6 */
    auto6 = (in1 | auto6) & !in5 & !fault5;
    ready6 = auto6 & (in25 | !in31) & !fault6;
    sr6 = (ready6 & in23) | (sr6 & !(in6 | fault11)); run6 = sr6;
    clamp6 = (run6 & !part5) | (clamp6 & in12 & !done6);
    adv6 = clamp6 & !ret6 & (in12 ^ in13);
    ret6 = (!adv6 & run6 & in26) | (ret6 & !in17);
    part6 = (adv6 & in23) | (part5 & in15 & !ret11);
    { bool k = part6 & in25; pulse6 = k & !rt6; rt6 = k; }
    drop6 = !clamp6 & !ft6; ft6 = !clamp6;
    if (pulse6 & in13) ack6 = true; else if (drop6) ack6 = false;
    done6 = (ack6 ^ pulse6) | (drop6 & in27);
    rs6 = !(in18 & !run6) & (rs6 | (adv6 & ret6) | (in7 & in19 & drop6)); fault6 = rs6;
    lamp6 = (fault6 & blink) | (run6 & !fault6) | (ready6 & !run6 & !blink);
    horn6 = ((horn5 | fault6) & !ack6) ^ in14;
    /* station 7 */
    auto7 = (in12 | auto7) & !in10 & !fault6;
    ready7 = auto7 & (in20 | !in10) & !fault7;
    sr7 = (ready7 & in17) | (sr7 & !(in9 | fault12)); run7 = sr7;
    clamp7 = (run7 & !part6) | (clamp7 & in22 & !done7);
    adv7 = clamp7 & !ret7 & (in19 ^ in4);
    ret7 = (!adv7 & run7 & in24) | (ret7 & !in28);
    part7 = (adv7 & in20) | (part6 & in24 & !ret12);
    { bool k = part7 & in28; pulse7 = k & !rt7; rt7 = k; }
    drop7 = !clamp7 & !ft7; ft7 = !clamp7;
    if (pulse7 & in26) ack7 = true; else if (drop7) ack7 = false;
    done7 = (ack7 ^ pulse7) | (drop7 & in2);
    rs7 = !(in2 & !run7) & (rs7 | (adv7 & ret7) | (in14 & in28 & drop7)); fault7 = rs7;
    lamp7 = (fault7 & blink) | (run7 & !fault7) | (ready7 & !run7 & !blink);
    horn7 = ((horn6 | fault7) & !ack7) ^ in8;
    /* station 8 */
    auto8 = (in11 | auto8) & !in25 & !fault7;
    ready8 = auto8 & (in20 | !in17) & !fault8;
    sr8 = (ready8 & in16) | (sr8 & !(in12 | fault13)); run8 = sr8;
    clamp8 = (run8 & !part7) | (clamp8 & in27 & !done8);
    adv8 = clamp8 & !ret8 & (in25 ^ in5);
    ret8 = (!adv8 & run8 & in30) | (ret8 & !in5);
    part8 = (adv8 & in20) | (part7 & in30 & !ret13);
    { bool k = part8 & in17; pulse8 = k & !rt8; rt8 = k; }
    drop8 = !clamp8 & !ft8; ft8 = !clamp8;
    if (pulse8 & in18) ack8 = true; else if (drop8) ack8 = false;
    done8 = (ack8 ^ pulse8) | (drop8 & in3);
    rs8 = !(in20 & !run8) & (rs8 | (adv8 & ret8) | (in6 & in2 & drop8)); fault8 = rs8;
    lamp8 = (fault8 & blink) | (run8 & !fault8) | (ready8 & !run8 & !blink);
    horn8 = ((horn7 | fault8) & !ack8) ^ in31;
    /* station 9 */
    auto9 = (in12 | auto9) & !in1 & !fault8;
    ready9 = auto9 & (in19 | !in0) & !fault9;
    sr9 = (ready9 & in20) | (sr9 & !(in17 | fault14)); run9 = sr9;
    clamp9 = (run9 & !part8) | (clamp9 & in11 & !done9);
    adv9 = clamp9 & !ret9 & (in21 ^ in25);
    ret9 = (!adv9 & run9 & in9) | (ret9 & !in13);
    part9 = (adv9 & in19) | (part8 & in21 & !ret14);
    { bool k = part9 & in26; pulse9 = k & !rt9; rt9 = k; }
    drop9 = !clamp9 & !ft9; ft9 = !clamp9;
    if (pulse9 & in9) ack9 = true; else if (drop9) ack9 = false;
    done9 = (ack9 ^ pulse9) | (drop9 & in15);
    rs9 = !(in12 & !run9) & (rs9 | (adv9 & ret9) | (in2 & in23 & drop9)); fault9 = rs9;
    lamp9 = (fault9 & blink) | (run9 & !fault9) | (ready9 & !run9 & !blink);
    horn9 = ((horn8 | fault9) & !ack9) ^ in12;
    /* station 10 */
    auto10 = (in8 | auto10) & !in1 & !fault9;
    ready10 = auto10 & (in16 | !in23) & !fault10;
    sr10 = (ready10 & in13) | (sr10 & !(in15 | fault15)); run10 = sr10;
    clamp10 = (run10 & !part9) | (clamp10 & in23 & !done10);
    adv10 = clamp10 & !ret10 & (in31 ^ in0);
    ret10 = (!adv10 & run10 & in22) | (ret10 & !in9);
    part10 = (adv10 & in5) | (part9 & in27 & !ret15);
    { bool k = part10 & in7; pulse10 = k & !rt10; rt10 = k; }
    drop10 = !clamp10 & !ft10; ft10 = !clamp10;
    if (pulse10 & in18) ack10 = true; else if (drop10) ack10 = false;
    done10 = (ack10 ^ pulse10) | (drop10 & in19);
    rs10 = !(in20 & !run10) & (rs10 | (adv10 & ret10) | (in28 & in28 & drop10)); fault10 = rs10;
    lamp10 = (fault10 & blink) | (run10 & !fault10) | (ready10 & !run10 & !blink);
    horn10 = ((horn9 | fault10) & !ack10) ^ in12;
    /* station 11 */
    auto11 = (in0 | auto11) & !in13 & !fault10;
    ready11 = auto11 & (in10 | !in13) & !fault11;
    sr11 = (ready11 & in26) | (sr11 & !(in9 | fault16)); run11 = sr11;
    clamp11 = (run11 & !part10) | (clamp11 & in17 & !done11);
    adv11 = clamp11 & !ret11 & (in31 ^ in15);
    ret11 = (!adv11 & run11 & in6) | (ret11 & !in29);
    part11 = (adv11 & in10) | (part10 & in3 & !ret16);
    { bool k = part11 & in1; pulse11 = k & !rt11; rt11 = k; }
    drop11 = !clamp11 & !ft11; ft11 = !clamp11;
    if (pulse11 & in20) ack11 = true; else if (drop11) ack11 = false;
    done11 = (ack11 ^ pulse11) | (drop11 & in1);
    rs11 = !(in25 & !run11) & (rs11 | (adv11 & ret11) | (in6 & in24 & drop11)); fault11 = rs11;
    lamp11 = (fault11 & blink) | (run11 & !fault11) | (ready11 & !run11 & !blink);
    horn11 = ((horn10 | fault11) & !ack11) ^ in7;
    /* station 12 */
    auto12 = (in20 | auto12) & !in0 & !fault11;
    ready12 = auto12 & (in18 | !in6) & !fault12;
    sr12 = (ready12 & in10) | (sr12 & !(in0 | fault17)); run12 = sr12;
    clamp12 = (run12 & !part11) | (clamp12 & in11 & !done12);
    adv12 = clamp12 & !ret12 & (in25 ^ in16);
    ret12 = (!adv12 & run12 & in2) | (ret12 & !in19);
    part12 = (adv12 & in19) | (part11 & in7 & !ret17);
    { bool k = part12 & in8; pulse12 = k & !rt12; rt12 = k; }
    drop12 = !clamp12 & !ft12; ft12 = !clamp12;
    if (pulse12 & in29) ack12 = true; else if (drop12) ack12 = false;
    done12 = (ack12 ^ pulse12) | (drop12 & in28);
    rs12 = !(in20 & !run12) & (rs12 | (adv12 & ret12) | (in31 & in24 & drop12)); fault12 = rs12;
    lamp12 = (fault12 & blink) | (run12 & !fault12) | (ready12 & !run12 & !blink);
    horn12 = ((horn11 | fault12) & !ack12) ^ in31;
    /* station 13 */
    auto13 = (in7 | auto13) & !in8 & !fault12;
    ready13 = auto13 & (in3 | !in31) & !fault13;
    sr13 = (ready13 & in9) | (sr13 & !(in29 | fault18)); run13 = sr13;
    clamp13 = (run13 & !part12) | (clamp13 & in1 & !done13);
    adv13 = clamp13 & !ret13 & (in26 ^ in24);
    ret13 = (!adv13 & run13 & in22) | (ret13 & !in2);
    part13 = (adv13 & in26) | (part12 & in13 & !ret18);
    { bool k = part13 & in23; pulse13 = k & !rt13; rt13 = k; }
    drop13 = !clamp13 & !ft13; ft13 = !clamp13;
    if (pulse13 & in1) ack13 = true; else if (drop13) ack13 = false;
    done13 = (ack13 ^ pulse13) | (drop13 & in29);
    rs13 = !(in12 & !run13) & (rs13 | (adv13 & ret13) | (in15 & in9 & drop13)); fault13 = rs13;
    lamp13 = (fault13 & blink) | (run13 & !fault13) | (ready13 & !run13 & !blink);
    horn13 = ((horn12 | fault13) & !ack13) ^ in16;
    /* station 14 */
    auto14 = (in11 | auto14) & !in18 & !fault13;
    ready14 = auto14 & (in16 | !in20) & !fault14;
    sr14 = (ready14 & in26) | (sr14 & !(in8 | fault19)); run14 = sr14;
    clamp14 = (run14 & !part13) | (clamp14 & in0 & !done14);
    adv14 = clamp14 & !ret14 & (in20 ^ in25);
    ret14 = (!adv14 & run14 & in17) | (ret14 & !in31);
    part14 = (adv14 & in30) | (part13 & in10 & !ret19);
    { bool k = part14 & in16; pulse14 = k & !rt14; rt14 = k; }
    drop14 = !clamp14 & !ft14; ft14 = !clamp14;
    if (pulse14 & in29) ack14 = true; else if (drop14) ack14 = false;
    done14 = (ack14 ^ pulse14) | (drop14 & in29);
    rs14 = !(in22 & !run14) & (rs14 | (adv14 & ret14) | (in5 & in11 & drop14)); fault14 = rs14;
    lamp14 = (fault14 & blink) | (run14 & !fault14) | (ready14 & !run14 & !blink);
    horn14 = ((horn13 | fault14) & !ack14) ^ in5;
    /* station 15 */
    auto15 = (in11 | auto15) & !in20 & !fault14;
    ready15 = auto15 & (in5 | !in10) & !fault15;
    sr15 = (ready15 & in24) | (sr15 & !(in17 | fault20)); run15 = sr15;
    clamp15 = (run15 & !part14) | (clamp15 & in0 & !done15);
    adv15 = clamp15 & !ret15 & (in24 ^ in5);
    ret15 = (!adv15 & run15 & in18) | (ret15 & !in8);
    part15 = (adv15 & in30) | (part14 & in19 & !ret20);
    { bool k = part15 & in21; pulse15 = k & !rt15; rt15 = k; }
    drop15 = !clamp15 & !ft15; ft15 = !clamp15;
    if (pulse15 & in24) ack15 = true; else if (drop15) ack15 = false;
    done15 = (ack15 ^ pulse15) | (drop15 & in5);
    rs15 = !(in30 & !run15) & (rs15 | (adv15 & ret15) | (in11 & in26 & drop15)); fault15 = rs15;
    lamp15 = (fault15 & blink) | (run15 & !fault15) | (ready15 & !run15 & !blink);
    horn15 = ((horn14 | fault15) & !ack15) ^ in0;
    /* station 16 */
    auto16 = (in27 | auto16) & !in24 & !fault15;
    ready16 = auto16 & (in21 | !in23) & !fault16;
    sr16 = (ready16 & in2) | (sr16 & !(in16 | fault21)); run16 = sr16;
    clamp16 = (run16 & !part15) | (clamp16 & in15 & !done16);
    adv16 = clamp16 & !ret16 & (in2 ^ in6);
    ret16 = (!adv16 & run16 & in17) | (ret16 & !in25);
    part16 = (adv16 & in24) | (part15 & in27 & !ret21);
    { bool k = part16 & in15; pulse16 = k & !rt16; rt16 = k; }
    drop16 = !clamp16 & !ft16; ft16 = !clamp16;
    if (pulse16 & in25) ack16 = true; else if (drop16) ack16 = false;
    done16 = (ack16 ^ pulse16) | (drop16 & in15);
    rs16 = !(in3 & !run16) & (rs16 | (adv16 & ret16) | (in7 & in5 & drop16)); fault16 = rs16;
    lamp16 = (fault16 & blink) | (run16 & !fault16) | (ready16 & !run16 & !blink);
    horn16 = ((horn15 | fault16) & !ack16) ^ in25;
    /* station 17 */
    auto17 = (in5 | auto17) & !in14 & !fault16;
    ready17 = auto17 & (in18 | !in3) & !fault17;
    sr17 = (ready17 & in24) | (sr17 & !(in16 | fault22)); run17 = sr17;
    clamp17 = (run17 & !part16) | (clamp17 & in12 & !done17);
    adv17 = clamp17 & !ret17 & (in17 ^ in17);
    ret17 = (!adv17 & run17 & in13) | (ret17 & !in15);
    part17 = (adv17 & in10) | (part16 & in31 & !ret22);
    { bool k = part17 & in23; pulse17 = k & !rt17; rt17 = k; }
    drop17 = !clamp17 & !ft17; ft17 = !clamp17;
    if (pulse17 & in24) ack17 = true; else if (drop17) ack17 = false;
    done17 = (ack17 ^ pulse17) | (drop17 & in23);
    rs17 = !(in2 & !run17) & (rs17 | (adv17 & ret17) | (in31 & in5 & drop17)); fault17 = rs17;
    lamp17 = (fault17 & blink) | (run17 & !fault17) | (ready17 & !run17 & !blink);
    horn17 = ((horn16 | fault17) & !ack17) ^ in3;
    /* station 18 */
    auto18 = (in20 | auto18) & !in18 & !fault17;
    ready18 = auto18 & (in10 | !in31) & !fault18;
    sr18 = (ready18 & in15) | (sr18 & !(in8 | fault23)); run18 = sr18;
    clamp18 = (run18 & !part17) | (clamp18 & in3 & !done18);
    adv18 = clamp18 & !ret18 & (in8 ^ in24);
    ret18 = (!adv18 & run18 & in12) | (ret18 & !in20);
    part18 = (adv18 & in4) | (part17 & in20 & !ret23);
    { bool k = part18 & in0; pulse18 = k & !rt18; rt18 = k; }
    drop18 = !clamp18 & !ft18; ft18 = !clamp18;
    if (pulse18 & in18) ack18 = true; else if (drop18) ack18 = false;
    done18 = (ack18 ^ pulse18) | (drop18 & in14);
    rs18 = !(in24 & !run18) & (rs18 | (adv18 & ret18) | (in22 & in28 & drop18)); fault18 = rs18;
    lamp18 = (fault18 & blink) | (run18 & !fault18) | (ready18 & !run18 & !blink);
    horn18 = ((horn17 | fault18) & !ack18) ^ in26;
    /* station 19 */
    auto19 = (in18 | auto19) & !in8 & !fault18;
    ready19 = auto19 & (in17 | !in16) & !fault19;
    sr19 = (ready19 & in3) | (sr19 & !(in19 | fault0)); run19 = sr19;
    clamp19 = (run19 & !part18) | (clamp19 & in29 & !done19);
    adv19 = clamp19 & !ret19 & (in3 ^ in10);
    ret19 = (!adv19 & run19 & in24) | (ret19 & !in6);
    part19 = (adv19 & in7) | (part18 & in26 & !ret0);
    { bool k = part19 & in26; pulse19 = k & !rt19; rt19 = k; }
    drop19 = !clamp19 & !ft19; ft19 = !clamp19;
    if (pulse19 & in12) ack19 = true; else if (drop19) ack19 = false;
    done19 = (ack19 ^ pulse19) | (drop19 & in20);
    rs19 = !(in18 & !run19) & (rs19 | (adv19 & ret19) | (in24 & in11 & drop19)); fault19 = rs19;
    lamp19 = (fault19 & blink) | (run19 & !fault19) | (ready19 & !run19 & !blink);
    horn19 = ((horn18 | fault19) & !ack19) ^ in10;
    /* station 20 */
    auto20 = (in0 | auto20) & !in23 & !fault19;
    ready20 = auto20 & (in5 | !in9) & !fault20;
    sr20 = (ready20 & in22) | (sr20 & !(in29 | fault1)); run20 = sr20;
    clamp20 = (run20 & !part19) | (clamp20 & in16 & !done20);
    adv20 = clamp20 & !ret20 & (in28 ^ in20);
    ret20 = (!adv20 & run20 & in18) | (ret20 & !in19);
    part20 = (adv20 & in15) | (part19 & in19 & !ret1);
    { bool k = part20 & in22; pulse20 = k & !rt20; rt20 = k; }
    drop20 = !clamp20 & !ft20; ft20 = !clamp20;
    if (pulse20 & in20) ack20 = true; else if (drop20) ack20 = false;
    done20 = (ack20 ^ pulse20) | (drop20 & in1);
    rs20 = !(in27 & !run20) & (rs20 | (adv20 & ret20) | (in7 & in16 & drop20)); fault20 = rs20;
    lamp20 = (fault20 & blink) | (run20 & !fault20) | (ready20 & !run20 & !blink);
    horn20 = ((horn19 | fault20) & !ack20) ^ in4;
    /* station 21 */
    auto21 = (in8 | auto21) & !in23 & !fault20;
    ready21 = auto21 & (in30 | !in23) & !fault21;
    sr21 = (ready21 & in29) | (sr21 & !(in19 | fault2)); run21 = sr21;
    clamp21 = (run21 & !part20) | (clamp21 & in23 & !done21);
    adv21 = clamp21 & !ret21 & (in23 ^ in18);
    ret21 = (!adv21 & run21 & in11) | (ret21 & !in5);
    part21 = (adv21 & in7) | (part20 & in26 & !ret2);
    { bool k = part21 & in27; pulse21 = k & !rt21; rt21 = k; }
    drop21 = !clamp21 & !ft21; ft21 = !clamp21;
    if (pulse21 & in3) ack21 = true; else if (drop21) ack21 = false;
    done21 = (ack21 ^ pulse21) | (drop21 & in18);
    rs21 = !(in6 & !run21) & (rs21 | (adv21 & ret21) | (in14 & in2 & drop21)); fault21 = rs21;
    lamp21 = (fault21 & blink) | (run21 & !fault21) | (ready21 & !run21 & !blink);
    horn21 = ((horn20 | fault21) & !ack21) ^ in2;
    /* station 22 */
    auto22 = (in18 | auto22) & !in5 & !fault21;
    ready22 = auto22 & (in14 | !in30) & !fault22;
    sr22 = (ready22 & in14) | (sr22 & !(in10 | fault3)); run22 = sr22;
    clamp22 = (run22 & !part21) | (clamp22 & in21 & !done22);
    adv22 = clamp22 & !ret22 & (in21 ^ in31);
    ret22 = (!adv22 & run22 & in16) | (ret22 & !in18);
    part22 = (adv22 & in6) | (part21 & in17 & !ret3);
    { bool k = part22 & in13; pulse22 = k & !rt22; rt22 = k; }
    drop22 = !clamp22 & !ft22; ft22 = !clamp22;
    if (pulse22 & in31) ack22 = true; else if (drop22) ack22 = false;
    done22 = (ack22 ^ pulse22) | (drop22 & in5);
    rs22 = !(in27 & !run22) & (rs22 | (adv22 & ret22) | (in14 & in14 & drop22)); fault22 = rs22;
    lamp22 = (fault22 & blink) | (run22 & !fault22) | (ready22 & !run22 & !blink);
    horn22 = ((horn21 | fault22) & !ack22) ^ in21;
    /* station 23 */
    auto23 = (in9 | auto23) & !in7 & !fault22;
    ready23 = auto23 & (in6 | !in13) & !fault23;
    sr23 = (ready23 & in29) | (sr23 & !(in23 | fault4)); run23 = sr23;
    clamp23 = (run23 & !part22) | (clamp23 & in10 & !done23);
    adv23 = clamp23 & !ret23 & (in13 ^ in21);
    ret23 = (!adv23 & run23 & in0) | (ret23 & !in25);
    part23 = (adv23 & in9) | (part22 & in31 & !ret4);
    { bool k = part23 & in21; pulse23 = k & !rt23; rt23 = k; }
    drop23 = !clamp23 & !ft23; ft23 = !clamp23;
    if (pulse23 & in6) ack23 = true; else if (drop23) ack23 = false;
    done23 = (ack23 ^ pulse23) | (drop23 & in22);
    rs23 = !(in23 & !run23) & (rs23 | (adv23 & ret23) | (in2 & in27 & drop23)); fault23 = rs23;
    lamp23 = (fault23 & blink) | (run23 & !fault23) | (ready23 & !run23 & !blink);
    horn23 = ((horn22 | fault23) & !ack23) ^ in8;
    out |= (uint32_t)(lamp0 ^ (horn0 & !done0)) << 0;
    out |= (uint32_t)(lamp1 ^ (horn1 & !done1)) << 1;
    out |= (uint32_t)(lamp2 ^ (horn2 & !done2)) << 2;
    out |= (uint32_t)(lamp3 ^ (horn3 & !done3)) << 3;
    out |= (uint32_t)(lamp4 ^ (horn4 & !done4)) << 4;
    out |= (uint32_t)(lamp5 ^ (horn5 & !done5)) << 5;
    out |= (uint32_t)(lamp6 ^ (horn6 & !done6)) << 6;
    out |= (uint32_t)(lamp7 ^ (horn7 & !done7)) << 7;
    out |= (uint32_t)(lamp8 ^ (horn8 & !done8)) << 8;
    out |= (uint32_t)(lamp9 ^ (horn9 & !done9)) << 9;
    out |= (uint32_t)(lamp10 ^ (horn10 & !done10)) << 10;
    out |= (uint32_t)(lamp11 ^ (horn11 & !done11)) << 11;
    out |= (uint32_t)(lamp12 ^ (horn12 & !done12)) << 12;
    out |= (uint32_t)(lamp13 ^ (horn13 & !done13)) << 13;
    out |= (uint32_t)(lamp14 ^ (horn14 & !done14)) << 14;
    out |= (uint32_t)(lamp15 ^ (horn15 & !done15)) << 15;
    out |= (uint32_t)(lamp16 ^ (horn16 & !done16)) << 16;
    out |= (uint32_t)(lamp17 ^ (horn17 & !done17)) << 17;
    out |= (uint32_t)(lamp18 ^ (horn18 & !done18)) << 18;
    out |= (uint32_t)(lamp19 ^ (horn19 & !done19)) << 19;
    out |= (uint32_t)(lamp20 ^ (horn20 & !done20)) << 20;
    out |= (uint32_t)(lamp21 ^ (horn21 & !done21)) << 21;
    out |= (uint32_t)(lamp22 ^ (horn22 & !done22)) << 22;
    out |= (uint32_t)(lamp23 ^ (horn23 & !done23)) << 23;
    check = (int32_t)((uint32_t)check * 31u + out + 1u);
}
