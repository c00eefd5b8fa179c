/* Example 1: Boolean networks of a bottling plant with four sections.
   Each assignment is one rung; logic with && and ||. */
#include <stdbool.h>
#include "st.h"

static uint32_t seed = 4711;
/* line */
static bool emergency, gateOpen, btnReset, keyAuto, keyHand;
static bool btnLine;
static bool safetyOk, lineAuto, lineHand, lineStart, btnLineMem;
static bool blinkFast, blinkSlow, secFault1, secFault2, secFault3;
static bool secFault4, lineFault, horn, lineFaultMem, towerGreen;
static bool towerYellow, towerRed;
/* Conveyor 1 */
static bool conv1_btnStart, conv1_btnStop, conv1_thermOk, conv1_peIn, conv1_peOut;
static bool conv1_btnAck, conv1_keyManual, conv1_jog;
static bool conv1_startEdge, conv1_startMem, conv1_faultTherm, conv1_ackEdge, conv1_ackMem;
static bool conv1_jam, conv1_fault, conv1_auto, conv1_man, conv1_request;
static bool conv1_motor, conv1_ready, conv1_lampGreen, conv1_lampRed;
/* Filler 1 */
static bool fill1_btnStart, fill1_btnStop, fill1_tankLow, fill1_tankHigh, fill1_bottleIn;
static bool fill1_levelOk, fill1_doorClosed, fill1_btnAck;
static bool fill1_doorOk, fill1_pump, fill1_tankDry, fill1_release, fill1_run;
static bool fill1_bottleEdge, fill1_bottleMem, fill1_clamp, fill1_valve, fill1_vent;
static bool fill1_stepDone, fill1_reject, fill1_ready, fill1_fault, fill1_lamp;
/* Capper 1 */
static bool capp1_btnStart, capp1_btnStop, capp1_headUp, capp1_headDown, capp1_torqueOk;
static bool capp1_capPresent, capp1_bottleIn, capp1_btnAck;
static bool capp1_release, capp1_sensorFault, capp1_run, capp1_step1, capp1_step2;
static bool capp1_step3, capp1_moveDown, capp1_moveUp, capp1_screw, capp1_reject;
static bool capp1_refill, capp1_ready, capp1_fault, capp1_lamp;
/* Labeller 1 */
static bool labl1_btnStart, labl1_btnStop, labl1_rollEmpty, labl1_labelSeen, labl1_bottleIn;
static bool labl1_glueWarm, labl1_airOk, labl1_btnAck;
static bool labl1_mediaOk, labl1_mediaAlarm, labl1_run, labl1_rollAlarm, labl1_bottleEdge;
static bool labl1_bottleMem, labl1_dispense, labl1_vacuum, labl1_press, labl1_reject;
static bool labl1_heater, labl1_ready, labl1_fault, labl1_lamp;
/* Packer 1 */
static bool pack1_btnStart, pack1_btnStop, pack1_boxPresent, pack1_layerFull, pack1_gripClosed;
static bool pack1_posHome, pack1_posBox, pack1_btnAck;
static bool pack1_posFault, pack1_run, pack1_reqGrip, pack1_grip, pack1_toBox;
static bool pack1_open, pack1_toHome, pack1_boxEdge, pack1_boxMem, pack1_layer;
static bool pack1_boxDone, pack1_newBox, pack1_ready, pack1_fault, pack1_lamp;
/* Conveyor 2 */
static bool conv2_btnStart, conv2_btnStop, conv2_thermOk, conv2_peIn, conv2_peOut;
static bool conv2_btnAck, conv2_keyManual, conv2_jog;
static bool conv2_startEdge, conv2_startMem, conv2_faultTherm, conv2_ackEdge, conv2_ackMem;
static bool conv2_jam, conv2_fault, conv2_auto, conv2_man, conv2_request;
static bool conv2_motor, conv2_ready, conv2_lampGreen, conv2_lampRed;
/* Filler 2 */
static bool fill2_btnStart, fill2_btnStop, fill2_tankLow, fill2_tankHigh, fill2_bottleIn;
static bool fill2_levelOk, fill2_doorClosed, fill2_btnAck;
static bool fill2_doorOk, fill2_pump, fill2_tankDry, fill2_release, fill2_run;
static bool fill2_bottleEdge, fill2_bottleMem, fill2_clamp, fill2_valve, fill2_vent;
static bool fill2_stepDone, fill2_reject, fill2_ready, fill2_fault, fill2_lamp;
/* Capper 2 */
static bool capp2_btnStart, capp2_btnStop, capp2_headUp, capp2_headDown, capp2_torqueOk;
static bool capp2_capPresent, capp2_bottleIn, capp2_btnAck;
static bool capp2_release, capp2_sensorFault, capp2_run, capp2_step1, capp2_step2;
static bool capp2_step3, capp2_moveDown, capp2_moveUp, capp2_screw, capp2_reject;
static bool capp2_refill, capp2_ready, capp2_fault, capp2_lamp;
/* Labeller 2 */
static bool labl2_btnStart, labl2_btnStop, labl2_rollEmpty, labl2_labelSeen, labl2_bottleIn;
static bool labl2_glueWarm, labl2_airOk, labl2_btnAck;
static bool labl2_mediaOk, labl2_mediaAlarm, labl2_run, labl2_rollAlarm, labl2_bottleEdge;
static bool labl2_bottleMem, labl2_dispense, labl2_vacuum, labl2_press, labl2_reject;
static bool labl2_heater, labl2_ready, labl2_fault, labl2_lamp;
/* Packer 2 */
static bool pack2_btnStart, pack2_btnStop, pack2_boxPresent, pack2_layerFull, pack2_gripClosed;
static bool pack2_posHome, pack2_posBox, pack2_btnAck;
static bool pack2_posFault, pack2_run, pack2_reqGrip, pack2_grip, pack2_toBox;
static bool pack2_open, pack2_toHome, pack2_boxEdge, pack2_boxMem, pack2_layer;
static bool pack2_boxDone, pack2_newBox, pack2_ready, pack2_fault, pack2_lamp;
/* Conveyor 3 */
static bool conv3_btnStart, conv3_btnStop, conv3_thermOk, conv3_peIn, conv3_peOut;
static bool conv3_btnAck, conv3_keyManual, conv3_jog;
static bool conv3_startEdge, conv3_startMem, conv3_faultTherm, conv3_ackEdge, conv3_ackMem;
static bool conv3_jam, conv3_fault, conv3_auto, conv3_man, conv3_request;
static bool conv3_motor, conv3_ready, conv3_lampGreen, conv3_lampRed;
/* Filler 3 */
static bool fill3_btnStart, fill3_btnStop, fill3_tankLow, fill3_tankHigh, fill3_bottleIn;
static bool fill3_levelOk, fill3_doorClosed, fill3_btnAck;
static bool fill3_doorOk, fill3_pump, fill3_tankDry, fill3_release, fill3_run;
static bool fill3_bottleEdge, fill3_bottleMem, fill3_clamp, fill3_valve, fill3_vent;
static bool fill3_stepDone, fill3_reject, fill3_ready, fill3_fault, fill3_lamp;
/* Capper 3 */
static bool capp3_btnStart, capp3_btnStop, capp3_headUp, capp3_headDown, capp3_torqueOk;
static bool capp3_capPresent, capp3_bottleIn, capp3_btnAck;
static bool capp3_release, capp3_sensorFault, capp3_run, capp3_step1, capp3_step2;
static bool capp3_step3, capp3_moveDown, capp3_moveUp, capp3_screw, capp3_reject;
static bool capp3_refill, capp3_ready, capp3_fault, capp3_lamp;
/* Labeller 3 */
static bool labl3_btnStart, labl3_btnStop, labl3_rollEmpty, labl3_labelSeen, labl3_bottleIn;
static bool labl3_glueWarm, labl3_airOk, labl3_btnAck;
static bool labl3_mediaOk, labl3_mediaAlarm, labl3_run, labl3_rollAlarm, labl3_bottleEdge;
static bool labl3_bottleMem, labl3_dispense, labl3_vacuum, labl3_press, labl3_reject;
static bool labl3_heater, labl3_ready, labl3_fault, labl3_lamp;
/* Packer 3 */
static bool pack3_btnStart, pack3_btnStop, pack3_boxPresent, pack3_layerFull, pack3_gripClosed;
static bool pack3_posHome, pack3_posBox, pack3_btnAck;
static bool pack3_posFault, pack3_run, pack3_reqGrip, pack3_grip, pack3_toBox;
static bool pack3_open, pack3_toHome, pack3_boxEdge, pack3_boxMem, pack3_layer;
static bool pack3_boxDone, pack3_newBox, pack3_ready, pack3_fault, pack3_lamp;
/* Conveyor 4 */
static bool conv4_btnStart, conv4_btnStop, conv4_thermOk, conv4_peIn, conv4_peOut;
static bool conv4_btnAck, conv4_keyManual, conv4_jog;
static bool conv4_startEdge, conv4_startMem, conv4_faultTherm, conv4_ackEdge, conv4_ackMem;
static bool conv4_jam, conv4_fault, conv4_auto, conv4_man, conv4_request;
static bool conv4_motor, conv4_ready, conv4_lampGreen, conv4_lampRed;
/* Filler 4 */
static bool fill4_btnStart, fill4_btnStop, fill4_tankLow, fill4_tankHigh, fill4_bottleIn;
static bool fill4_levelOk, fill4_doorClosed, fill4_btnAck;
static bool fill4_doorOk, fill4_pump, fill4_tankDry, fill4_release, fill4_run;
static bool fill4_bottleEdge, fill4_bottleMem, fill4_clamp, fill4_valve, fill4_vent;
static bool fill4_stepDone, fill4_reject, fill4_ready, fill4_fault, fill4_lamp;
/* Capper 4 */
static bool capp4_btnStart, capp4_btnStop, capp4_headUp, capp4_headDown, capp4_torqueOk;
static bool capp4_capPresent, capp4_bottleIn, capp4_btnAck;
static bool capp4_release, capp4_sensorFault, capp4_run, capp4_step1, capp4_step2;
static bool capp4_step3, capp4_moveDown, capp4_moveUp, capp4_screw, capp4_reject;
static bool capp4_refill, capp4_ready, capp4_fault, capp4_lamp;
/* Labeller 4 */
static bool labl4_btnStart, labl4_btnStop, labl4_rollEmpty, labl4_labelSeen, labl4_bottleIn;
static bool labl4_glueWarm, labl4_airOk, labl4_btnAck;
static bool labl4_mediaOk, labl4_mediaAlarm, labl4_run, labl4_rollAlarm, labl4_bottleEdge;
static bool labl4_bottleMem, labl4_dispense, labl4_vacuum, labl4_press, labl4_reject;
static bool labl4_heater, labl4_ready, labl4_fault, labl4_lamp;
/* Packer 4 */
static bool pack4_btnStart, pack4_btnStop, pack4_boxPresent, pack4_layerFull, pack4_gripClosed;
static bool pack4_posHome, pack4_posBox, pack4_btnAck;
static bool pack4_posFault, pack4_run, pack4_reqGrip, pack4_grip, pack4_toBox;
static bool pack4_open, pack4_toHome, pack4_boxEdge, pack4_boxMem, pack4_layer;
static bool pack4_boxDone, pack4_newBox, pack4_ready, pack4_fault, pack4_lamp;

static uint32_t next_word(void)
{
    seed = seed * 1664525u + 1013904223u;
    return seed ^ (seed >> 15);
}

void scan(void)
{
    uint32_t inWord0 = next_word();
    uint32_t inWord1 = next_word();
    uint32_t inWord2 = next_word();
    uint32_t inWord3 = next_word();
    uint32_t inWord4 = next_word();
    uint32_t inWord5 = next_word();
    emergency = (inWord5 >> 0 & 1) && (inWord5 >> 1 & 1) && (inWord5 >> 2 & 1) && (inWord5 >> 3 & 1);
    gateOpen = (inWord5 >> 4 & 1) && (inWord5 >> 5 & 1) && (inWord5 >> 6 & 1);
    btnReset = (inWord5 >> 7 & 1);
    keyAuto = (inWord5 >> 8 & 1);
    keyHand = (inWord5 >> 9 & 1) && (inWord5 >> 10 & 1) && (inWord5 >> 11 & 1);
    btnLine = (inWord5 >> 12 & 1);
    conv1_btnStart = (inWord0 >> 0 & 1);
    conv1_btnStop = (inWord0 >> 1 & 1);
    conv1_thermOk = (inWord0 >> 2 & 1);
    conv1_peIn = (inWord0 >> 3 & 1);
    conv1_peOut = (inWord0 >> 4 & 1);
    conv1_btnAck = (inWord0 >> 5 & 1);
    conv1_keyManual = (inWord0 >> 6 & 1);
    conv1_jog = (inWord0 >> 7 & 1);
    fill1_btnStart = (inWord0 >> 8 & 1);
    fill1_btnStop = (inWord0 >> 9 & 1);
    fill1_tankLow = (inWord0 >> 10 & 1);
    fill1_tankHigh = (inWord0 >> 11 & 1);
    fill1_bottleIn = (inWord0 >> 12 & 1);
    fill1_levelOk = (inWord0 >> 13 & 1);
    fill1_doorClosed = (inWord0 >> 14 & 1);
    fill1_btnAck = (inWord0 >> 15 & 1);
    capp1_btnStart = (inWord0 >> 16 & 1);
    capp1_btnStop = (inWord0 >> 17 & 1);
    capp1_headUp = (inWord0 >> 18 & 1);
    capp1_headDown = (inWord0 >> 19 & 1);
    capp1_torqueOk = (inWord0 >> 20 & 1);
    capp1_capPresent = (inWord0 >> 21 & 1);
    capp1_bottleIn = (inWord0 >> 22 & 1);
    capp1_btnAck = (inWord0 >> 23 & 1);
    labl1_btnStart = (inWord0 >> 24 & 1);
    labl1_btnStop = (inWord0 >> 25 & 1);
    labl1_rollEmpty = (inWord0 >> 26 & 1);
    labl1_labelSeen = (inWord0 >> 27 & 1);
    labl1_bottleIn = (inWord0 >> 28 & 1);
    labl1_glueWarm = (inWord0 >> 29 & 1);
    labl1_airOk = (inWord0 >> 30 & 1);
    labl1_btnAck = (inWord0 >> 31 & 1);
    pack1_btnStart = (inWord1 >> 0 & 1);
    pack1_btnStop = (inWord1 >> 1 & 1);
    pack1_boxPresent = (inWord1 >> 2 & 1);
    pack1_layerFull = (inWord1 >> 3 & 1);
    pack1_gripClosed = (inWord1 >> 4 & 1);
    pack1_posHome = (inWord1 >> 5 & 1);
    pack1_posBox = (inWord1 >> 6 & 1);
    pack1_btnAck = (inWord1 >> 7 & 1);
    conv2_btnStart = (inWord1 >> 8 & 1);
    conv2_btnStop = (inWord1 >> 9 & 1);
    conv2_thermOk = (inWord1 >> 10 & 1);
    conv2_peIn = (inWord1 >> 11 & 1);
    conv2_peOut = (inWord1 >> 12 & 1);
    conv2_btnAck = (inWord1 >> 13 & 1);
    conv2_keyManual = (inWord1 >> 14 & 1);
    conv2_jog = (inWord1 >> 15 & 1);
    fill2_btnStart = (inWord1 >> 16 & 1);
    fill2_btnStop = (inWord1 >> 17 & 1);
    fill2_tankLow = (inWord1 >> 18 & 1);
    fill2_tankHigh = (inWord1 >> 19 & 1);
    fill2_bottleIn = (inWord1 >> 20 & 1);
    fill2_levelOk = (inWord1 >> 21 & 1);
    fill2_doorClosed = (inWord1 >> 22 & 1);
    fill2_btnAck = (inWord1 >> 23 & 1);
    capp2_btnStart = (inWord1 >> 24 & 1);
    capp2_btnStop = (inWord1 >> 25 & 1);
    capp2_headUp = (inWord1 >> 26 & 1);
    capp2_headDown = (inWord1 >> 27 & 1);
    capp2_torqueOk = (inWord1 >> 28 & 1);
    capp2_capPresent = (inWord1 >> 29 & 1);
    capp2_bottleIn = (inWord1 >> 30 & 1);
    capp2_btnAck = (inWord1 >> 31 & 1);
    labl2_btnStart = (inWord2 >> 0 & 1);
    labl2_btnStop = (inWord2 >> 1 & 1);
    labl2_rollEmpty = (inWord2 >> 2 & 1);
    labl2_labelSeen = (inWord2 >> 3 & 1);
    labl2_bottleIn = (inWord2 >> 4 & 1);
    labl2_glueWarm = (inWord2 >> 5 & 1);
    labl2_airOk = (inWord2 >> 6 & 1);
    labl2_btnAck = (inWord2 >> 7 & 1);
    pack2_btnStart = (inWord2 >> 8 & 1);
    pack2_btnStop = (inWord2 >> 9 & 1);
    pack2_boxPresent = (inWord2 >> 10 & 1);
    pack2_layerFull = (inWord2 >> 11 & 1);
    pack2_gripClosed = (inWord2 >> 12 & 1);
    pack2_posHome = (inWord2 >> 13 & 1);
    pack2_posBox = (inWord2 >> 14 & 1);
    pack2_btnAck = (inWord2 >> 15 & 1);
    conv3_btnStart = (inWord2 >> 16 & 1);
    conv3_btnStop = (inWord2 >> 17 & 1);
    conv3_thermOk = (inWord2 >> 18 & 1);
    conv3_peIn = (inWord2 >> 19 & 1);
    conv3_peOut = (inWord2 >> 20 & 1);
    conv3_btnAck = (inWord2 >> 21 & 1);
    conv3_keyManual = (inWord2 >> 22 & 1);
    conv3_jog = (inWord2 >> 23 & 1);
    fill3_btnStart = (inWord2 >> 24 & 1);
    fill3_btnStop = (inWord2 >> 25 & 1);
    fill3_tankLow = (inWord2 >> 26 & 1);
    fill3_tankHigh = (inWord2 >> 27 & 1);
    fill3_bottleIn = (inWord2 >> 28 & 1);
    fill3_levelOk = (inWord2 >> 29 & 1);
    fill3_doorClosed = (inWord2 >> 30 & 1);
    fill3_btnAck = (inWord2 >> 31 & 1);
    capp3_btnStart = (inWord3 >> 0 & 1);
    capp3_btnStop = (inWord3 >> 1 & 1);
    capp3_headUp = (inWord3 >> 2 & 1);
    capp3_headDown = (inWord3 >> 3 & 1);
    capp3_torqueOk = (inWord3 >> 4 & 1);
    capp3_capPresent = (inWord3 >> 5 & 1);
    capp3_bottleIn = (inWord3 >> 6 & 1);
    capp3_btnAck = (inWord3 >> 7 & 1);
    labl3_btnStart = (inWord3 >> 8 & 1);
    labl3_btnStop = (inWord3 >> 9 & 1);
    labl3_rollEmpty = (inWord3 >> 10 & 1);
    labl3_labelSeen = (inWord3 >> 11 & 1);
    labl3_bottleIn = (inWord3 >> 12 & 1);
    labl3_glueWarm = (inWord3 >> 13 & 1);
    labl3_airOk = (inWord3 >> 14 & 1);
    labl3_btnAck = (inWord3 >> 15 & 1);
    pack3_btnStart = (inWord3 >> 16 & 1);
    pack3_btnStop = (inWord3 >> 17 & 1);
    pack3_boxPresent = (inWord3 >> 18 & 1);
    pack3_layerFull = (inWord3 >> 19 & 1);
    pack3_gripClosed = (inWord3 >> 20 & 1);
    pack3_posHome = (inWord3 >> 21 & 1);
    pack3_posBox = (inWord3 >> 22 & 1);
    pack3_btnAck = (inWord3 >> 23 & 1);
    conv4_btnStart = (inWord3 >> 24 & 1);
    conv4_btnStop = (inWord3 >> 25 & 1);
    conv4_thermOk = (inWord3 >> 26 & 1);
    conv4_peIn = (inWord3 >> 27 & 1);
    conv4_peOut = (inWord3 >> 28 & 1);
    conv4_btnAck = (inWord3 >> 29 & 1);
    conv4_keyManual = (inWord3 >> 30 & 1);
    conv4_jog = (inWord3 >> 31 & 1);
    fill4_btnStart = (inWord4 >> 0 & 1);
    fill4_btnStop = (inWord4 >> 1 & 1);
    fill4_tankLow = (inWord4 >> 2 & 1);
    fill4_tankHigh = (inWord4 >> 3 & 1);
    fill4_bottleIn = (inWord4 >> 4 & 1);
    fill4_levelOk = (inWord4 >> 5 & 1);
    fill4_doorClosed = (inWord4 >> 6 & 1);
    fill4_btnAck = (inWord4 >> 7 & 1);
    capp4_btnStart = (inWord4 >> 8 & 1);
    capp4_btnStop = (inWord4 >> 9 & 1);
    capp4_headUp = (inWord4 >> 10 & 1);
    capp4_headDown = (inWord4 >> 11 & 1);
    capp4_torqueOk = (inWord4 >> 12 & 1);
    capp4_capPresent = (inWord4 >> 13 & 1);
    capp4_bottleIn = (inWord4 >> 14 & 1);
    capp4_btnAck = (inWord4 >> 15 & 1);
    labl4_btnStart = (inWord4 >> 16 & 1);
    labl4_btnStop = (inWord4 >> 17 & 1);
    labl4_rollEmpty = (inWord4 >> 18 & 1);
    labl4_labelSeen = (inWord4 >> 19 & 1);
    labl4_bottleIn = (inWord4 >> 20 & 1);
    labl4_glueWarm = (inWord4 >> 21 & 1);
    labl4_airOk = (inWord4 >> 22 & 1);
    labl4_btnAck = (inWord4 >> 23 & 1);
    pack4_btnStart = (inWord4 >> 24 & 1);
    pack4_btnStop = (inWord4 >> 25 & 1);
    pack4_boxPresent = (inWord4 >> 26 & 1);
    pack4_layerFull = (inWord4 >> 27 & 1);
    pack4_gripClosed = (inWord4 >> 28 & 1);
    pack4_posHome = (inWord4 >> 29 & 1);
    pack4_posBox = (inWord4 >> 30 & 1);
    pack4_btnAck = (inWord4 >> 31 & 1);

    /* line: safety and modes */
    safetyOk = (btnReset || safetyOk) && !emergency && !(gateOpen && lineAuto);
    lineAuto = (keyAuto || lineAuto) && !keyHand && safetyOk;
    lineHand = keyHand && !lineAuto;
    lineStart = btnLine && !btnLineMem && lineAuto;
    btnLineMem = btnLine;
    blinkFast = !blinkFast;
    blinkSlow = blinkSlow != blinkFast;

    /* Conveyor 1 */
    conv1_startEdge = conv1_btnStart && !conv1_startMem;
    conv1_startMem = conv1_btnStart;
    conv1_faultTherm = (!conv1_thermOk || conv1_faultTherm) && !conv1_ackEdge;
    conv1_ackEdge = conv1_btnAck && !conv1_ackMem;
    conv1_ackMem = conv1_btnAck;
    conv1_jam = ((conv1_peIn && conv1_peOut && conv1_motor) || conv1_jam) && !conv1_ackEdge;
    conv1_fault = conv1_faultTherm || conv1_jam || !safetyOk;
    conv1_auto = (conv1_startEdge || lineStart || conv1_auto) && !conv1_btnStop && !conv1_fault && !conv1_keyManual;
    conv1_man = conv1_keyManual && conv1_jog && !conv1_fault && !lineAuto;
    conv1_request = !conv1_peOut || fill1_ready;
    conv1_motor = ((conv1_auto && conv1_request) || conv1_man) && !conv1_fault && safetyOk;
    conv1_ready = conv1_auto && !conv1_peIn && !conv1_jam;
    conv1_lampGreen = conv1_motor || (conv1_auto && blinkSlow);
    conv1_lampRed = conv1_fault && (blinkFast || conv1_ackMem);

    /* Filler 1 */
    fill1_doorOk = fill1_doorClosed && safetyOk;
    fill1_pump = (fill1_tankLow || fill1_pump) && !fill1_tankHigh && safetyOk;
    fill1_tankDry = ((fill1_tankLow && !fill1_pump) || fill1_tankDry) && !fill1_btnAck;
    fill1_release = fill1_doorOk && !fill1_tankDry && (lineAuto || lineHand);
    fill1_run = (fill1_btnStart || lineStart || fill1_run) && !fill1_btnStop && fill1_release;
    fill1_bottleEdge = fill1_bottleIn && !fill1_bottleMem;
    fill1_bottleMem = fill1_bottleIn;
    fill1_clamp = ((fill1_bottleEdge && fill1_run) || fill1_clamp) && !fill1_stepDone;
    fill1_valve = fill1_clamp && !fill1_levelOk && fill1_run && !fill1_vent;
    fill1_vent = (fill1_clamp && fill1_levelOk) || (!fill1_run && fill1_tankHigh);
    fill1_stepDone = fill1_clamp && fill1_levelOk && !fill1_valve;
    fill1_reject = ((fill1_bottleMem && !fill1_bottleIn && !fill1_levelOk) || (fill1_reject && fill1_bottleIn)) && fill1_run;
    fill1_ready = fill1_run && !fill1_clamp && !fill1_bottleIn;
    fill1_fault = fill1_tankDry || (!fill1_doorOk && fill1_run);
    fill1_lamp = (fill1_run && !fill1_fault) || (fill1_fault && blinkFast);

    /* Capper 1 */
    capp1_release = safetyOk && capp1_capPresent && !(capp1_headUp && capp1_headDown);
    capp1_sensorFault = ((capp1_headUp && capp1_headDown) || capp1_sensorFault) && !capp1_btnAck;
    capp1_run = (capp1_btnStart || lineStart || capp1_run) && !capp1_btnStop && !capp1_sensorFault && safetyOk;
    capp1_step1 = ((capp1_run && capp1_bottleIn && capp1_headUp) || capp1_step1) && !capp1_step2 && capp1_release;
    capp1_step2 = ((capp1_step1 && capp1_headDown) || capp1_step2) && !capp1_step3 && capp1_run;
    capp1_step3 = ((capp1_step2 && capp1_torqueOk) || capp1_step3) && !capp1_headUp && capp1_run;
    capp1_moveDown = capp1_step1 && !capp1_headDown && !capp1_moveUp;
    capp1_moveUp = (capp1_step3 || !capp1_run) && !capp1_headUp && safetyOk;
    capp1_screw = capp1_step2 && !capp1_torqueOk && capp1_headDown;
    capp1_reject = ((capp1_step3 && !capp1_torqueOk) || capp1_reject) && capp1_bottleIn;
    capp1_refill = (!capp1_capPresent || (capp1_refill && !capp1_capPresent)) && capp1_run;
    capp1_ready = capp1_run && capp1_headUp && !capp1_step1 && !capp1_step2 && !capp1_step3;
    capp1_fault = capp1_sensorFault || (capp1_step1 && capp1_step3);
    capp1_lamp = (capp1_run != capp1_fault) && (capp1_ready || blinkSlow);

    /* Labeller 1 */
    labl1_mediaOk = labl1_airOk && (labl1_glueWarm || lineHand);
    labl1_mediaAlarm = ((labl1_run && !labl1_mediaOk) || labl1_mediaAlarm) && !labl1_btnAck;
    labl1_run = (labl1_btnStart || lineStart || labl1_run) && !(labl1_btnStop || labl1_rollAlarm || labl1_mediaAlarm) && safetyOk;
    labl1_rollAlarm = ((labl1_rollEmpty && !labl1_labelSeen) || labl1_rollAlarm) && !labl1_btnAck;
    labl1_bottleEdge = labl1_bottleIn && !labl1_bottleMem;
    labl1_bottleMem = labl1_bottleIn;
    labl1_dispense = (labl1_bottleEdge || labl1_dispense) && !labl1_labelSeen && labl1_run;
    labl1_vacuum = labl1_run && (labl1_dispense || labl1_bottleIn);
    labl1_press = labl1_vacuum && labl1_labelSeen && !labl1_dispense;
    labl1_reject = ((labl1_bottleMem && !labl1_bottleIn && !labl1_labelSeen) || labl1_reject) && !labl1_bottleEdge && labl1_run;
    labl1_heater = (!labl1_glueWarm || (labl1_heater && !labl1_run)) && safetyOk;
    labl1_ready = labl1_run && !labl1_dispense && !labl1_press;
    labl1_fault = labl1_mediaAlarm || labl1_rollAlarm || !safetyOk;
    labl1_lamp = labl1_run || (labl1_fault && blinkFast) || (labl1_heater && blinkSlow);

    /* Packer 1 */
    pack1_posFault = ((pack1_posHome && pack1_posBox) || pack1_posFault) && !pack1_btnAck;
    pack1_run = (pack1_btnStart || lineStart || pack1_run) && !pack1_btnStop && !pack1_posFault && safetyOk;
    pack1_reqGrip = pack1_run && pack1_layerFull && pack1_boxPresent && pack1_posHome;
    pack1_grip = (pack1_reqGrip || pack1_grip) && !pack1_open && safetyOk;
    pack1_toBox = pack1_grip && pack1_gripClosed && !pack1_posBox && !pack1_toHome;
    pack1_open = (pack1_posBox && pack1_gripClosed) || (!pack1_run && pack1_posHome);
    pack1_toHome = ((pack1_open && !pack1_gripClosed) || pack1_toHome) && !pack1_posHome && !pack1_toBox && pack1_run;
    pack1_boxEdge = pack1_posBox && pack1_open && !pack1_boxMem;
    pack1_boxMem = pack1_posBox && pack1_open;
    pack1_layer = pack1_layer != pack1_boxEdge;
    pack1_boxDone = pack1_boxEdge && pack1_layer;
    pack1_newBox = ((pack1_boxDone || pack1_newBox) && !pack1_boxPresent) || (pack1_run && !pack1_boxPresent);
    pack1_ready = pack1_run && !pack1_grip && !pack1_layerFull;
    pack1_fault = pack1_posFault || (pack1_toBox && pack1_toHome) || (!safetyOk && pack1_run);
    pack1_lamp = (pack1_run && !pack1_fault) || (pack1_fault && (blinkFast != pack1_layer));

    /* Conveyor 2 */
    conv2_startEdge = conv2_btnStart && !conv2_startMem;
    conv2_startMem = conv2_btnStart;
    conv2_faultTherm = (!conv2_thermOk || conv2_faultTherm) && !conv2_ackEdge;
    conv2_ackEdge = conv2_btnAck && !conv2_ackMem;
    conv2_ackMem = conv2_btnAck;
    conv2_jam = ((conv2_peIn && conv2_peOut && conv2_motor) || conv2_jam) && !conv2_ackEdge;
    conv2_fault = conv2_faultTherm || conv2_jam || !safetyOk;
    conv2_auto = (conv2_startEdge || lineStart || conv2_auto) && !conv2_btnStop && !conv2_fault && !conv2_keyManual;
    conv2_man = conv2_keyManual && conv2_jog && !conv2_fault && !lineAuto;
    conv2_request = !conv2_peOut || fill2_ready;
    conv2_motor = ((conv2_auto && conv2_request) || conv2_man) && !conv2_fault && safetyOk;
    conv2_ready = conv2_auto && !conv2_peIn && !conv2_jam;
    conv2_lampGreen = conv2_motor || (conv2_auto && blinkSlow);
    conv2_lampRed = conv2_fault && (blinkFast || conv2_ackMem);

    /* Filler 2 */
    fill2_doorOk = fill2_doorClosed && safetyOk;
    fill2_pump = (fill2_tankLow || fill2_pump) && !fill2_tankHigh && safetyOk;
    fill2_tankDry = ((fill2_tankLow && !fill2_pump) || fill2_tankDry) && !fill2_btnAck;
    fill2_release = fill2_doorOk && !fill2_tankDry && (lineAuto || lineHand);
    fill2_run = (fill2_btnStart || lineStart || fill2_run) && !fill2_btnStop && fill2_release;
    fill2_bottleEdge = fill2_bottleIn && !fill2_bottleMem;
    fill2_bottleMem = fill2_bottleIn;
    fill2_clamp = ((fill2_bottleEdge && fill2_run) || fill2_clamp) && !fill2_stepDone;
    fill2_valve = fill2_clamp && !fill2_levelOk && fill2_run && !fill2_vent;
    fill2_vent = (fill2_clamp && fill2_levelOk) || (!fill2_run && fill2_tankHigh);
    fill2_stepDone = fill2_clamp && fill2_levelOk && !fill2_valve;
    fill2_reject = ((fill2_bottleMem && !fill2_bottleIn && !fill2_levelOk) || (fill2_reject && fill2_bottleIn)) && fill2_run;
    fill2_ready = fill2_run && !fill2_clamp && !fill2_bottleIn;
    fill2_fault = fill2_tankDry || (!fill2_doorOk && fill2_run);
    fill2_lamp = (fill2_run && !fill2_fault) || (fill2_fault && blinkFast);

    /* Capper 2 */
    capp2_release = safetyOk && capp2_capPresent && !(capp2_headUp && capp2_headDown);
    capp2_sensorFault = ((capp2_headUp && capp2_headDown) || capp2_sensorFault) && !capp2_btnAck;
    capp2_run = (capp2_btnStart || lineStart || capp2_run) && !capp2_btnStop && !capp2_sensorFault && safetyOk;
    capp2_step1 = ((capp2_run && capp2_bottleIn && capp2_headUp) || capp2_step1) && !capp2_step2 && capp2_release;
    capp2_step2 = ((capp2_step1 && capp2_headDown) || capp2_step2) && !capp2_step3 && capp2_run;
    capp2_step3 = ((capp2_step2 && capp2_torqueOk) || capp2_step3) && !capp2_headUp && capp2_run;
    capp2_moveDown = capp2_step1 && !capp2_headDown && !capp2_moveUp;
    capp2_moveUp = (capp2_step3 || !capp2_run) && !capp2_headUp && safetyOk;
    capp2_screw = capp2_step2 && !capp2_torqueOk && capp2_headDown;
    capp2_reject = ((capp2_step3 && !capp2_torqueOk) || capp2_reject) && capp2_bottleIn;
    capp2_refill = (!capp2_capPresent || (capp2_refill && !capp2_capPresent)) && capp2_run;
    capp2_ready = capp2_run && capp2_headUp && !capp2_step1 && !capp2_step2 && !capp2_step3;
    capp2_fault = capp2_sensorFault || (capp2_step1 && capp2_step3);
    capp2_lamp = (capp2_run != capp2_fault) && (capp2_ready || blinkSlow);

    /* Labeller 2 */
    labl2_mediaOk = labl2_airOk && (labl2_glueWarm || lineHand);
    labl2_mediaAlarm = ((labl2_run && !labl2_mediaOk) || labl2_mediaAlarm) && !labl2_btnAck;
    labl2_run = (labl2_btnStart || lineStart || labl2_run) && !(labl2_btnStop || labl2_rollAlarm || labl2_mediaAlarm) && safetyOk;
    labl2_rollAlarm = ((labl2_rollEmpty && !labl2_labelSeen) || labl2_rollAlarm) && !labl2_btnAck;
    labl2_bottleEdge = labl2_bottleIn && !labl2_bottleMem;
    labl2_bottleMem = labl2_bottleIn;
    labl2_dispense = (labl2_bottleEdge || labl2_dispense) && !labl2_labelSeen && labl2_run;
    labl2_vacuum = labl2_run && (labl2_dispense || labl2_bottleIn);
    labl2_press = labl2_vacuum && labl2_labelSeen && !labl2_dispense;
    labl2_reject = ((labl2_bottleMem && !labl2_bottleIn && !labl2_labelSeen) || labl2_reject) && !labl2_bottleEdge && labl2_run;
    labl2_heater = (!labl2_glueWarm || (labl2_heater && !labl2_run)) && safetyOk;
    labl2_ready = labl2_run && !labl2_dispense && !labl2_press;
    labl2_fault = labl2_mediaAlarm || labl2_rollAlarm || !safetyOk;
    labl2_lamp = labl2_run || (labl2_fault && blinkFast) || (labl2_heater && blinkSlow);

    /* Packer 2 */
    pack2_posFault = ((pack2_posHome && pack2_posBox) || pack2_posFault) && !pack2_btnAck;
    pack2_run = (pack2_btnStart || lineStart || pack2_run) && !pack2_btnStop && !pack2_posFault && safetyOk;
    pack2_reqGrip = pack2_run && pack2_layerFull && pack2_boxPresent && pack2_posHome;
    pack2_grip = (pack2_reqGrip || pack2_grip) && !pack2_open && safetyOk;
    pack2_toBox = pack2_grip && pack2_gripClosed && !pack2_posBox && !pack2_toHome;
    pack2_open = (pack2_posBox && pack2_gripClosed) || (!pack2_run && pack2_posHome);
    pack2_toHome = ((pack2_open && !pack2_gripClosed) || pack2_toHome) && !pack2_posHome && !pack2_toBox && pack2_run;
    pack2_boxEdge = pack2_posBox && pack2_open && !pack2_boxMem;
    pack2_boxMem = pack2_posBox && pack2_open;
    pack2_layer = pack2_layer != pack2_boxEdge;
    pack2_boxDone = pack2_boxEdge && pack2_layer;
    pack2_newBox = ((pack2_boxDone || pack2_newBox) && !pack2_boxPresent) || (pack2_run && !pack2_boxPresent);
    pack2_ready = pack2_run && !pack2_grip && !pack2_layerFull;
    pack2_fault = pack2_posFault || (pack2_toBox && pack2_toHome) || (!safetyOk && pack2_run);
    pack2_lamp = (pack2_run && !pack2_fault) || (pack2_fault && (blinkFast != pack2_layer));

    /* Conveyor 3 */
    conv3_startEdge = conv3_btnStart && !conv3_startMem;
    conv3_startMem = conv3_btnStart;
    conv3_faultTherm = (!conv3_thermOk || conv3_faultTherm) && !conv3_ackEdge;
    conv3_ackEdge = conv3_btnAck && !conv3_ackMem;
    conv3_ackMem = conv3_btnAck;
    conv3_jam = ((conv3_peIn && conv3_peOut && conv3_motor) || conv3_jam) && !conv3_ackEdge;
    conv3_fault = conv3_faultTherm || conv3_jam || !safetyOk;
    conv3_auto = (conv3_startEdge || lineStart || conv3_auto) && !conv3_btnStop && !conv3_fault && !conv3_keyManual;
    conv3_man = conv3_keyManual && conv3_jog && !conv3_fault && !lineAuto;
    conv3_request = !conv3_peOut || fill3_ready;
    conv3_motor = ((conv3_auto && conv3_request) || conv3_man) && !conv3_fault && safetyOk;
    conv3_ready = conv3_auto && !conv3_peIn && !conv3_jam;
    conv3_lampGreen = conv3_motor || (conv3_auto && blinkSlow);
    conv3_lampRed = conv3_fault && (blinkFast || conv3_ackMem);

    /* Filler 3 */
    fill3_doorOk = fill3_doorClosed && safetyOk;
    fill3_pump = (fill3_tankLow || fill3_pump) && !fill3_tankHigh && safetyOk;
    fill3_tankDry = ((fill3_tankLow && !fill3_pump) || fill3_tankDry) && !fill3_btnAck;
    fill3_release = fill3_doorOk && !fill3_tankDry && (lineAuto || lineHand);
    fill3_run = (fill3_btnStart || lineStart || fill3_run) && !fill3_btnStop && fill3_release;
    fill3_bottleEdge = fill3_bottleIn && !fill3_bottleMem;
    fill3_bottleMem = fill3_bottleIn;
    fill3_clamp = ((fill3_bottleEdge && fill3_run) || fill3_clamp) && !fill3_stepDone;
    fill3_valve = fill3_clamp && !fill3_levelOk && fill3_run && !fill3_vent;
    fill3_vent = (fill3_clamp && fill3_levelOk) || (!fill3_run && fill3_tankHigh);
    fill3_stepDone = fill3_clamp && fill3_levelOk && !fill3_valve;
    fill3_reject = ((fill3_bottleMem && !fill3_bottleIn && !fill3_levelOk) || (fill3_reject && fill3_bottleIn)) && fill3_run;
    fill3_ready = fill3_run && !fill3_clamp && !fill3_bottleIn;
    fill3_fault = fill3_tankDry || (!fill3_doorOk && fill3_run);
    fill3_lamp = (fill3_run && !fill3_fault) || (fill3_fault && blinkFast);

    /* Capper 3 */
    capp3_release = safetyOk && capp3_capPresent && !(capp3_headUp && capp3_headDown);
    capp3_sensorFault = ((capp3_headUp && capp3_headDown) || capp3_sensorFault) && !capp3_btnAck;
    capp3_run = (capp3_btnStart || lineStart || capp3_run) && !capp3_btnStop && !capp3_sensorFault && safetyOk;
    capp3_step1 = ((capp3_run && capp3_bottleIn && capp3_headUp) || capp3_step1) && !capp3_step2 && capp3_release;
    capp3_step2 = ((capp3_step1 && capp3_headDown) || capp3_step2) && !capp3_step3 && capp3_run;
    capp3_step3 = ((capp3_step2 && capp3_torqueOk) || capp3_step3) && !capp3_headUp && capp3_run;
    capp3_moveDown = capp3_step1 && !capp3_headDown && !capp3_moveUp;
    capp3_moveUp = (capp3_step3 || !capp3_run) && !capp3_headUp && safetyOk;
    capp3_screw = capp3_step2 && !capp3_torqueOk && capp3_headDown;
    capp3_reject = ((capp3_step3 && !capp3_torqueOk) || capp3_reject) && capp3_bottleIn;
    capp3_refill = (!capp3_capPresent || (capp3_refill && !capp3_capPresent)) && capp3_run;
    capp3_ready = capp3_run && capp3_headUp && !capp3_step1 && !capp3_step2 && !capp3_step3;
    capp3_fault = capp3_sensorFault || (capp3_step1 && capp3_step3);
    capp3_lamp = (capp3_run != capp3_fault) && (capp3_ready || blinkSlow);

    /* Labeller 3 */
    labl3_mediaOk = labl3_airOk && (labl3_glueWarm || lineHand);
    labl3_mediaAlarm = ((labl3_run && !labl3_mediaOk) || labl3_mediaAlarm) && !labl3_btnAck;
    labl3_run = (labl3_btnStart || lineStart || labl3_run) && !(labl3_btnStop || labl3_rollAlarm || labl3_mediaAlarm) && safetyOk;
    labl3_rollAlarm = ((labl3_rollEmpty && !labl3_labelSeen) || labl3_rollAlarm) && !labl3_btnAck;
    labl3_bottleEdge = labl3_bottleIn && !labl3_bottleMem;
    labl3_bottleMem = labl3_bottleIn;
    labl3_dispense = (labl3_bottleEdge || labl3_dispense) && !labl3_labelSeen && labl3_run;
    labl3_vacuum = labl3_run && (labl3_dispense || labl3_bottleIn);
    labl3_press = labl3_vacuum && labl3_labelSeen && !labl3_dispense;
    labl3_reject = ((labl3_bottleMem && !labl3_bottleIn && !labl3_labelSeen) || labl3_reject) && !labl3_bottleEdge && labl3_run;
    labl3_heater = (!labl3_glueWarm || (labl3_heater && !labl3_run)) && safetyOk;
    labl3_ready = labl3_run && !labl3_dispense && !labl3_press;
    labl3_fault = labl3_mediaAlarm || labl3_rollAlarm || !safetyOk;
    labl3_lamp = labl3_run || (labl3_fault && blinkFast) || (labl3_heater && blinkSlow);

    /* Packer 3 */
    pack3_posFault = ((pack3_posHome && pack3_posBox) || pack3_posFault) && !pack3_btnAck;
    pack3_run = (pack3_btnStart || lineStart || pack3_run) && !pack3_btnStop && !pack3_posFault && safetyOk;
    pack3_reqGrip = pack3_run && pack3_layerFull && pack3_boxPresent && pack3_posHome;
    pack3_grip = (pack3_reqGrip || pack3_grip) && !pack3_open && safetyOk;
    pack3_toBox = pack3_grip && pack3_gripClosed && !pack3_posBox && !pack3_toHome;
    pack3_open = (pack3_posBox && pack3_gripClosed) || (!pack3_run && pack3_posHome);
    pack3_toHome = ((pack3_open && !pack3_gripClosed) || pack3_toHome) && !pack3_posHome && !pack3_toBox && pack3_run;
    pack3_boxEdge = pack3_posBox && pack3_open && !pack3_boxMem;
    pack3_boxMem = pack3_posBox && pack3_open;
    pack3_layer = pack3_layer != pack3_boxEdge;
    pack3_boxDone = pack3_boxEdge && pack3_layer;
    pack3_newBox = ((pack3_boxDone || pack3_newBox) && !pack3_boxPresent) || (pack3_run && !pack3_boxPresent);
    pack3_ready = pack3_run && !pack3_grip && !pack3_layerFull;
    pack3_fault = pack3_posFault || (pack3_toBox && pack3_toHome) || (!safetyOk && pack3_run);
    pack3_lamp = (pack3_run && !pack3_fault) || (pack3_fault && (blinkFast != pack3_layer));

    /* Conveyor 4 */
    conv4_startEdge = conv4_btnStart && !conv4_startMem;
    conv4_startMem = conv4_btnStart;
    conv4_faultTherm = (!conv4_thermOk || conv4_faultTherm) && !conv4_ackEdge;
    conv4_ackEdge = conv4_btnAck && !conv4_ackMem;
    conv4_ackMem = conv4_btnAck;
    conv4_jam = ((conv4_peIn && conv4_peOut && conv4_motor) || conv4_jam) && !conv4_ackEdge;
    conv4_fault = conv4_faultTherm || conv4_jam || !safetyOk;
    conv4_auto = (conv4_startEdge || lineStart || conv4_auto) && !conv4_btnStop && !conv4_fault && !conv4_keyManual;
    conv4_man = conv4_keyManual && conv4_jog && !conv4_fault && !lineAuto;
    conv4_request = !conv4_peOut || fill4_ready;
    conv4_motor = ((conv4_auto && conv4_request) || conv4_man) && !conv4_fault && safetyOk;
    conv4_ready = conv4_auto && !conv4_peIn && !conv4_jam;
    conv4_lampGreen = conv4_motor || (conv4_auto && blinkSlow);
    conv4_lampRed = conv4_fault && (blinkFast || conv4_ackMem);

    /* Filler 4 */
    fill4_doorOk = fill4_doorClosed && safetyOk;
    fill4_pump = (fill4_tankLow || fill4_pump) && !fill4_tankHigh && safetyOk;
    fill4_tankDry = ((fill4_tankLow && !fill4_pump) || fill4_tankDry) && !fill4_btnAck;
    fill4_release = fill4_doorOk && !fill4_tankDry && (lineAuto || lineHand);
    fill4_run = (fill4_btnStart || lineStart || fill4_run) && !fill4_btnStop && fill4_release;
    fill4_bottleEdge = fill4_bottleIn && !fill4_bottleMem;
    fill4_bottleMem = fill4_bottleIn;
    fill4_clamp = ((fill4_bottleEdge && fill4_run) || fill4_clamp) && !fill4_stepDone;
    fill4_valve = fill4_clamp && !fill4_levelOk && fill4_run && !fill4_vent;
    fill4_vent = (fill4_clamp && fill4_levelOk) || (!fill4_run && fill4_tankHigh);
    fill4_stepDone = fill4_clamp && fill4_levelOk && !fill4_valve;
    fill4_reject = ((fill4_bottleMem && !fill4_bottleIn && !fill4_levelOk) || (fill4_reject && fill4_bottleIn)) && fill4_run;
    fill4_ready = fill4_run && !fill4_clamp && !fill4_bottleIn;
    fill4_fault = fill4_tankDry || (!fill4_doorOk && fill4_run);
    fill4_lamp = (fill4_run && !fill4_fault) || (fill4_fault && blinkFast);

    /* Capper 4 */
    capp4_release = safetyOk && capp4_capPresent && !(capp4_headUp && capp4_headDown);
    capp4_sensorFault = ((capp4_headUp && capp4_headDown) || capp4_sensorFault) && !capp4_btnAck;
    capp4_run = (capp4_btnStart || lineStart || capp4_run) && !capp4_btnStop && !capp4_sensorFault && safetyOk;
    capp4_step1 = ((capp4_run && capp4_bottleIn && capp4_headUp) || capp4_step1) && !capp4_step2 && capp4_release;
    capp4_step2 = ((capp4_step1 && capp4_headDown) || capp4_step2) && !capp4_step3 && capp4_run;
    capp4_step3 = ((capp4_step2 && capp4_torqueOk) || capp4_step3) && !capp4_headUp && capp4_run;
    capp4_moveDown = capp4_step1 && !capp4_headDown && !capp4_moveUp;
    capp4_moveUp = (capp4_step3 || !capp4_run) && !capp4_headUp && safetyOk;
    capp4_screw = capp4_step2 && !capp4_torqueOk && capp4_headDown;
    capp4_reject = ((capp4_step3 && !capp4_torqueOk) || capp4_reject) && capp4_bottleIn;
    capp4_refill = (!capp4_capPresent || (capp4_refill && !capp4_capPresent)) && capp4_run;
    capp4_ready = capp4_run && capp4_headUp && !capp4_step1 && !capp4_step2 && !capp4_step3;
    capp4_fault = capp4_sensorFault || (capp4_step1 && capp4_step3);
    capp4_lamp = (capp4_run != capp4_fault) && (capp4_ready || blinkSlow);

    /* Labeller 4 */
    labl4_mediaOk = labl4_airOk && (labl4_glueWarm || lineHand);
    labl4_mediaAlarm = ((labl4_run && !labl4_mediaOk) || labl4_mediaAlarm) && !labl4_btnAck;
    labl4_run = (labl4_btnStart || lineStart || labl4_run) && !(labl4_btnStop || labl4_rollAlarm || labl4_mediaAlarm) && safetyOk;
    labl4_rollAlarm = ((labl4_rollEmpty && !labl4_labelSeen) || labl4_rollAlarm) && !labl4_btnAck;
    labl4_bottleEdge = labl4_bottleIn && !labl4_bottleMem;
    labl4_bottleMem = labl4_bottleIn;
    labl4_dispense = (labl4_bottleEdge || labl4_dispense) && !labl4_labelSeen && labl4_run;
    labl4_vacuum = labl4_run && (labl4_dispense || labl4_bottleIn);
    labl4_press = labl4_vacuum && labl4_labelSeen && !labl4_dispense;
    labl4_reject = ((labl4_bottleMem && !labl4_bottleIn && !labl4_labelSeen) || labl4_reject) && !labl4_bottleEdge && labl4_run;
    labl4_heater = (!labl4_glueWarm || (labl4_heater && !labl4_run)) && safetyOk;
    labl4_ready = labl4_run && !labl4_dispense && !labl4_press;
    labl4_fault = labl4_mediaAlarm || labl4_rollAlarm || !safetyOk;
    labl4_lamp = labl4_run || (labl4_fault && blinkFast) || (labl4_heater && blinkSlow);

    /* Packer 4 */
    pack4_posFault = ((pack4_posHome && pack4_posBox) || pack4_posFault) && !pack4_btnAck;
    pack4_run = (pack4_btnStart || lineStart || pack4_run) && !pack4_btnStop && !pack4_posFault && safetyOk;
    pack4_reqGrip = pack4_run && pack4_layerFull && pack4_boxPresent && pack4_posHome;
    pack4_grip = (pack4_reqGrip || pack4_grip) && !pack4_open && safetyOk;
    pack4_toBox = pack4_grip && pack4_gripClosed && !pack4_posBox && !pack4_toHome;
    pack4_open = (pack4_posBox && pack4_gripClosed) || (!pack4_run && pack4_posHome);
    pack4_toHome = ((pack4_open && !pack4_gripClosed) || pack4_toHome) && !pack4_posHome && !pack4_toBox && pack4_run;
    pack4_boxEdge = pack4_posBox && pack4_open && !pack4_boxMem;
    pack4_boxMem = pack4_posBox && pack4_open;
    pack4_layer = pack4_layer != pack4_boxEdge;
    pack4_boxDone = pack4_boxEdge && pack4_layer;
    pack4_newBox = ((pack4_boxDone || pack4_newBox) && !pack4_boxPresent) || (pack4_run && !pack4_boxPresent);
    pack4_ready = pack4_run && !pack4_grip && !pack4_layerFull;
    pack4_fault = pack4_posFault || (pack4_toBox && pack4_toHome) || (!safetyOk && pack4_run);
    pack4_lamp = (pack4_run && !pack4_fault) || (pack4_fault && (blinkFast != pack4_layer));

    /* line: faults and signal tower */
    secFault1 = conv1_fault || fill1_fault || capp1_fault || labl1_fault || pack1_fault;
    secFault2 = conv2_fault || fill2_fault || capp2_fault || labl2_fault || pack2_fault;
    secFault3 = conv3_fault || fill3_fault || capp3_fault || labl3_fault || pack3_fault;
    secFault4 = conv4_fault || fill4_fault || capp4_fault || labl4_fault || pack4_fault;
    lineFault = secFault1 || secFault2 || secFault3 || secFault4;
    horn = ((lineFault && !lineFaultMem) || horn) && !btnReset;
    lineFaultMem = lineFault;
    towerGreen = lineAuto && !lineFault;
    towerYellow = lineHand || (lineFault && !horn && blinkSlow);
    towerRed = (lineFault && blinkFast) || !safetyOk;

    /* write the output image */
    uint32_t outWord0 = (uint32_t)conv1_motor << 0
        | (uint32_t)conv1_ready << 1
        | (uint32_t)conv1_lampGreen << 2
        | (uint32_t)conv1_lampRed << 3
        | (uint32_t)conv1_fault << 4
        | (uint32_t)fill1_pump << 5
        | (uint32_t)fill1_valve << 6
        | (uint32_t)fill1_clamp << 7
        | (uint32_t)fill1_ready << 8
        | (uint32_t)fill1_lamp << 9
        | (uint32_t)capp1_moveDown << 10
        | (uint32_t)capp1_moveUp << 11
        | (uint32_t)capp1_screw << 12
        | (uint32_t)capp1_reject << 13
        | (uint32_t)capp1_ready << 14
        | (uint32_t)labl1_dispense << 15
        | (uint32_t)labl1_vacuum << 16
        | (uint32_t)labl1_press << 17
        | (uint32_t)labl1_heater << 18
        | (uint32_t)labl1_ready << 19
        | (uint32_t)pack1_grip << 20
        | (uint32_t)pack1_toBox << 21
        | (uint32_t)pack1_toHome << 22
        | (uint32_t)pack1_newBox << 23
        | (uint32_t)pack1_lamp << 24;
    uint32_t outWord1 = (uint32_t)conv2_motor << 0
        | (uint32_t)conv2_ready << 1
        | (uint32_t)conv2_lampGreen << 2
        | (uint32_t)conv2_lampRed << 3
        | (uint32_t)conv2_fault << 4
        | (uint32_t)fill2_pump << 5
        | (uint32_t)fill2_valve << 6
        | (uint32_t)fill2_clamp << 7
        | (uint32_t)fill2_ready << 8
        | (uint32_t)fill2_lamp << 9
        | (uint32_t)capp2_moveDown << 10
        | (uint32_t)capp2_moveUp << 11
        | (uint32_t)capp2_screw << 12
        | (uint32_t)capp2_reject << 13
        | (uint32_t)capp2_ready << 14
        | (uint32_t)labl2_dispense << 15
        | (uint32_t)labl2_vacuum << 16
        | (uint32_t)labl2_press << 17
        | (uint32_t)labl2_heater << 18
        | (uint32_t)labl2_ready << 19
        | (uint32_t)pack2_grip << 20
        | (uint32_t)pack2_toBox << 21
        | (uint32_t)pack2_toHome << 22
        | (uint32_t)pack2_newBox << 23
        | (uint32_t)pack2_lamp << 24;
    uint32_t outWord2 = (uint32_t)conv3_motor << 0
        | (uint32_t)conv3_ready << 1
        | (uint32_t)conv3_lampGreen << 2
        | (uint32_t)conv3_lampRed << 3
        | (uint32_t)conv3_fault << 4
        | (uint32_t)fill3_pump << 5
        | (uint32_t)fill3_valve << 6
        | (uint32_t)fill3_clamp << 7
        | (uint32_t)fill3_ready << 8
        | (uint32_t)fill3_lamp << 9
        | (uint32_t)capp3_moveDown << 10
        | (uint32_t)capp3_moveUp << 11
        | (uint32_t)capp3_screw << 12
        | (uint32_t)capp3_reject << 13
        | (uint32_t)capp3_ready << 14
        | (uint32_t)labl3_dispense << 15
        | (uint32_t)labl3_vacuum << 16
        | (uint32_t)labl3_press << 17
        | (uint32_t)labl3_heater << 18
        | (uint32_t)labl3_ready << 19
        | (uint32_t)pack3_grip << 20
        | (uint32_t)pack3_toBox << 21
        | (uint32_t)pack3_toHome << 22
        | (uint32_t)pack3_newBox << 23
        | (uint32_t)pack3_lamp << 24;
    uint32_t outWord3 = (uint32_t)conv4_motor << 0
        | (uint32_t)conv4_ready << 1
        | (uint32_t)conv4_lampGreen << 2
        | (uint32_t)conv4_lampRed << 3
        | (uint32_t)conv4_fault << 4
        | (uint32_t)fill4_pump << 5
        | (uint32_t)fill4_valve << 6
        | (uint32_t)fill4_clamp << 7
        | (uint32_t)fill4_ready << 8
        | (uint32_t)fill4_lamp << 9
        | (uint32_t)capp4_moveDown << 10
        | (uint32_t)capp4_moveUp << 11
        | (uint32_t)capp4_screw << 12
        | (uint32_t)capp4_reject << 13
        | (uint32_t)capp4_ready << 14
        | (uint32_t)labl4_dispense << 15
        | (uint32_t)labl4_vacuum << 16
        | (uint32_t)labl4_press << 17
        | (uint32_t)labl4_heater << 18
        | (uint32_t)labl4_ready << 19
        | (uint32_t)pack4_grip << 20
        | (uint32_t)pack4_toBox << 21
        | (uint32_t)pack4_toHome << 22
        | (uint32_t)pack4_newBox << 23
        | (uint32_t)pack4_lamp << 24;
    uint32_t outWord4 = (uint32_t)horn << 0
        | (uint32_t)towerGreen << 1
        | (uint32_t)towerYellow << 2
        | (uint32_t)towerRed << 3
        | (uint32_t)lineAuto << 4
        | (uint32_t)safetyOk << 5;

    uint32_t c = (uint32_t)check;
    c = c * 31u + outWord0;
    c = c * 31u + outWord1;
    c = c * 31u + outWord2;
    c = c * 31u + outWord3;
    c = c * 31u + outWord4;
    check = (int32_t)c;
}
