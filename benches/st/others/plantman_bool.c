/* 293 rungs of a bottling line */
#include <stdbool.h>
#include "st.h"

static uint32_t Seed = 0x12345678u;
static uint32_t Img0, Img1, Img2;
static int32_t Word0;
static bool Depal_PbStart, Depal_PbStop, Depal_Estop, Depal_Guard, Depal_MotTrip, Depal_InEye;
static bool Depal_OutEye, Depal_Air, Depal_SafeOk, Depal_TripMem, Depal_AirOk, Depal_AirLow;
static bool Depal_Jam, Depal_Fault, Depal_InfeedFree, Depal_Backup, Depal_Starved, Depal_Ready;
static bool Depal_StartReq, Depal_StopReq, Depal_Run, Depal_Slow, Depal_Fast, Depal_EdgeIn;
static bool Depal_InEyeOld, Depal_Toggle, Depal_GateOpen, Depal_LampG, Depal_LampY, Depal_LampR;
static bool Rinser_PbStart, Rinser_PbStop, Rinser_Estop, Rinser_Guard, Rinser_MotTrip, Rinser_InEye;
static bool Rinser_OutEye, Rinser_Air, Rinser_SafeOk, Rinser_TripMem, Rinser_AirOk, Rinser_AirLow;
static bool Rinser_Jam, Rinser_Fault, Rinser_InfeedFree, Rinser_Backup, Rinser_Starved, Rinser_Ready;
static bool Rinser_StartReq, Rinser_StopReq, Rinser_Run, Rinser_Slow, Rinser_Fast, Rinser_EdgeIn;
static bool Rinser_InEyeOld, Rinser_Toggle, Rinser_GateOpen, Rinser_LampG, Rinser_LampY, Rinser_LampR;
static bool Filler_PbStart, Filler_PbStop, Filler_Estop, Filler_Guard, Filler_MotTrip, Filler_InEye;
static bool Filler_OutEye, Filler_Air, Filler_SafeOk, Filler_TripMem, Filler_AirOk, Filler_AirLow;
static bool Filler_Jam, Filler_Fault, Filler_InfeedFree, Filler_Backup, Filler_Starved, Filler_Ready;
static bool Filler_StartReq, Filler_StopReq, Filler_Run, Filler_Slow, Filler_Fast, Filler_EdgeIn;
static bool Filler_InEyeOld, Filler_Toggle, Filler_GateOpen, Filler_LampG, Filler_LampY, Filler_LampR;
static bool Filler_ValveFill, Filler_ValveCip, Filler_ValveVent, Filler_BowlReq;
static bool Capper_PbStart, Capper_PbStop, Capper_Estop, Capper_Guard, Capper_MotTrip, Capper_InEye;
static bool Capper_OutEye, Capper_Air, Capper_SafeOk, Capper_TripMem, Capper_AirOk, Capper_AirLow;
static bool Capper_Jam, Capper_Fault, Capper_InfeedFree, Capper_Backup, Capper_Starved, Capper_Ready;
static bool Capper_StartReq, Capper_StopReq, Capper_Run, Capper_Slow, Capper_Fast, Capper_EdgeIn;
static bool Capper_InEyeOld, Capper_Toggle, Capper_GateOpen, Capper_LampG, Capper_LampY, Capper_LampR;
static bool Capper_CapFeed, Capper_HeadDown, Capper_NoCap;
static bool Inspect_PbStart, Inspect_PbStop, Inspect_Estop, Inspect_Guard, Inspect_MotTrip, Inspect_InEye;
static bool Inspect_OutEye, Inspect_Air, Inspect_SafeOk, Inspect_TripMem, Inspect_AirOk, Inspect_AirLow;
static bool Inspect_Jam, Inspect_Fault, Inspect_InfeedFree, Inspect_Backup, Inspect_Starved, Inspect_Ready;
static bool Inspect_StartReq, Inspect_StopReq, Inspect_Run, Inspect_Slow, Inspect_Fast, Inspect_EdgeIn;
static bool Inspect_InEyeOld, Inspect_Toggle, Inspect_GateOpen, Inspect_LampG, Inspect_LampY, Inspect_LampR;
static bool Inspect_Reject, Inspect_Pusher;
static bool Pasteur_PbStart, Pasteur_PbStop, Pasteur_Estop, Pasteur_Guard, Pasteur_MotTrip, Pasteur_InEye;
static bool Pasteur_OutEye, Pasteur_Air, Pasteur_SafeOk, Pasteur_TripMem, Pasteur_AirOk, Pasteur_AirLow;
static bool Pasteur_Jam, Pasteur_Fault, Pasteur_InfeedFree, Pasteur_Backup, Pasteur_Starved, Pasteur_Ready;
static bool Pasteur_StartReq, Pasteur_StopReq, Pasteur_Run, Pasteur_Slow, Pasteur_Fast, Pasteur_EdgeIn;
static bool Pasteur_InEyeOld, Pasteur_Toggle, Pasteur_GateOpen, Pasteur_LampG, Pasteur_LampY, Pasteur_LampR;
static bool Pasteur_Heat, Pasteur_Pump;
static bool Labeler_PbStart, Labeler_PbStop, Labeler_Estop, Labeler_Guard, Labeler_MotTrip, Labeler_InEye;
static bool Labeler_OutEye, Labeler_Air, Labeler_SafeOk, Labeler_TripMem, Labeler_AirOk, Labeler_AirLow;
static bool Labeler_Jam, Labeler_Fault, Labeler_InfeedFree, Labeler_Backup, Labeler_Starved, Labeler_Ready;
static bool Labeler_StartReq, Labeler_StopReq, Labeler_Run, Labeler_Slow, Labeler_Fast, Labeler_EdgeIn;
static bool Labeler_InEyeOld, Labeler_Toggle, Labeler_GateOpen, Labeler_LampG, Labeler_LampY, Labeler_LampR;
static bool Labeler_GlueOn;
static bool Coder_PbStart, Coder_PbStop, Coder_Estop, Coder_Guard, Coder_MotTrip, Coder_InEye;
static bool Coder_OutEye, Coder_Air, Coder_SafeOk, Coder_TripMem, Coder_AirOk, Coder_AirLow;
static bool Coder_Jam, Coder_Fault, Coder_InfeedFree, Coder_Backup, Coder_Starved, Coder_Ready;
static bool Coder_StartReq, Coder_StopReq, Coder_Run, Coder_Slow, Coder_Fast, Coder_EdgeIn;
static bool Coder_InEyeOld, Coder_Toggle, Coder_GateOpen, Coder_LampG, Coder_LampY, Coder_LampR;
static bool Coder_Print;
static bool Checkw_PbStart, Checkw_PbStop, Checkw_Estop, Checkw_Guard, Checkw_MotTrip, Checkw_InEye;
static bool Checkw_OutEye, Checkw_Air, Checkw_SafeOk, Checkw_TripMem, Checkw_AirOk, Checkw_AirLow;
static bool Checkw_Jam, Checkw_Fault, Checkw_InfeedFree, Checkw_Backup, Checkw_Starved, Checkw_Ready;
static bool Checkw_StartReq, Checkw_StopReq, Checkw_Run, Checkw_Slow, Checkw_Fast, Checkw_EdgeIn;
static bool Checkw_InEyeOld, Checkw_Toggle, Checkw_GateOpen, Checkw_LampG, Checkw_LampY, Checkw_LampR;
static bool Checkw_Reject;
static bool Packer_PbStart, Packer_PbStop, Packer_Estop, Packer_Guard, Packer_MotTrip, Packer_InEye;
static bool Packer_OutEye, Packer_Air, Packer_SafeOk, Packer_TripMem, Packer_AirOk, Packer_AirLow;
static bool Packer_Jam, Packer_Fault, Packer_InfeedFree, Packer_Backup, Packer_Starved, Packer_Ready;
static bool Packer_StartReq, Packer_StopReq, Packer_Run, Packer_Slow, Packer_Fast, Packer_EdgeIn;
static bool Packer_InEyeOld, Packer_Toggle, Packer_GateOpen, Packer_LampG, Packer_LampY, Packer_LampR;
static bool Packer_Grip, Packer_Lower;
static bool Pallet_PbStart, Pallet_PbStop, Pallet_Estop, Pallet_Guard, Pallet_MotTrip, Pallet_InEye;
static bool Pallet_OutEye, Pallet_Air, Pallet_SafeOk, Pallet_TripMem, Pallet_AirOk, Pallet_AirLow;
static bool Pallet_Jam, Pallet_Fault, Pallet_InfeedFree, Pallet_Backup, Pallet_Starved, Pallet_Ready;
static bool Pallet_StartReq, Pallet_StopReq, Pallet_Run, Pallet_Slow, Pallet_Fast, Pallet_EdgeIn;
static bool Pallet_InEyeOld, Pallet_Toggle, Pallet_GateOpen, Pallet_LampG, Pallet_LampY, Pallet_LampR;
static bool Pallet_LayerFull;
static bool Wrapper_PbStart, Wrapper_PbStop, Wrapper_Estop, Wrapper_Guard, Wrapper_MotTrip, Wrapper_InEye;
static bool Wrapper_OutEye, Wrapper_Air, Wrapper_Run, Wrapper_SafeOk, Wrapper_TripMem, Wrapper_AirOk;
static bool Wrapper_AirLow, Wrapper_Jam, Wrapper_Fault, Wrapper_InfeedFree, Wrapper_Backup, Wrapper_Starved;
static bool Wrapper_Ready, Wrapper_StartReq, Wrapper_StopReq, Wrapper_Slow, Wrapper_Fast, Wrapper_EdgeIn;
static bool Wrapper_InEyeOld, Wrapper_Toggle, Wrapper_GateOpen, Wrapper_LampG, Wrapper_LampY, Wrapper_LampR;
static bool Wrapper_Turn;
static bool Line_Zone1Ok, Line_Zone2Ok, Line_Zone3Ok, Line_Auto, Line_Manual, Line_Clean;
static bool Line_Reset, Line_AckHorn, Line_Horn, Line_AllRun, Line_AnyRun;

static uint32_t NextWord(uint32_t s)
{
    s ^= s << 13;
    s ^= s >> 17;
    s ^= s << 5;
    return s;
}

void scan(void)
{
    Seed = NextWord(Seed);
    Img0 = Img0 ^ (Seed & (Seed >> 7) & (Seed >> 15));
    Seed = NextWord(Seed);
    Img1 = Img1 ^ (Seed & (Seed >> 7) & (Seed >> 15));
    Seed = NextWord(Seed);
    Img2 = Img2 ^ (Seed & (Seed >> 7) & (Seed >> 15));

    /* input image */
    Depal_PbStart = (Img0 >> 0) & 1;
    Depal_PbStop = (Img0 >> 1) & 1;
    Depal_Estop = (Img0 >> 2) & 1;
    Depal_Guard = (Img0 >> 3) & 1;
    Depal_MotTrip = (Img0 >> 4) & 1;
    Depal_InEye = (Img0 >> 5) & 1;
    Depal_OutEye = (Img0 >> 6) & 1;
    Depal_Air = (Img0 >> 7) & 1;
    Rinser_PbStart = (Img0 >> 8) & 1;
    Rinser_PbStop = (Img0 >> 9) & 1;
    Rinser_Estop = (Img0 >> 10) & 1;
    Rinser_Guard = (Img0 >> 11) & 1;
    Rinser_MotTrip = (Img0 >> 12) & 1;
    Rinser_InEye = (Img0 >> 13) & 1;
    Rinser_OutEye = (Img0 >> 14) & 1;
    Rinser_Air = (Img0 >> 15) & 1;
    Filler_PbStart = (Img0 >> 16) & 1;
    Filler_PbStop = (Img0 >> 17) & 1;
    Filler_Estop = (Img0 >> 18) & 1;
    Filler_Guard = (Img0 >> 19) & 1;
    Filler_MotTrip = (Img0 >> 20) & 1;
    Filler_InEye = (Img0 >> 21) & 1;
    Filler_OutEye = (Img0 >> 22) & 1;
    Filler_Air = (Img0 >> 23) & 1;
    Capper_PbStart = (Img0 >> 24) & 1;
    Capper_PbStop = (Img0 >> 25) & 1;
    Capper_Estop = (Img0 >> 26) & 1;
    Capper_Guard = (Img0 >> 27) & 1;
    Capper_MotTrip = (Img0 >> 28) & 1;
    Capper_InEye = (Img0 >> 29) & 1;
    Capper_OutEye = (Img0 >> 30) & 1;
    Capper_Air = (Img0 >> 31) & 1;
    Inspect_PbStart = (Img1 >> 0) & 1;
    Inspect_PbStop = (Img1 >> 1) & 1;
    Inspect_Estop = (Img1 >> 2) & 1;
    Inspect_Guard = (Img1 >> 3) & 1;
    Inspect_MotTrip = (Img1 >> 4) & 1;
    Inspect_InEye = (Img1 >> 5) & 1;
    Inspect_OutEye = (Img1 >> 6) & 1;
    Inspect_Air = (Img1 >> 7) & 1;
    Pasteur_PbStart = (Img1 >> 8) & 1;
    Pasteur_PbStop = (Img1 >> 9) & 1;
    Pasteur_Estop = (Img1 >> 10) & 1;
    Pasteur_Guard = (Img1 >> 11) & 1;
    Pasteur_MotTrip = (Img1 >> 12) & 1;
    Pasteur_InEye = (Img1 >> 13) & 1;
    Pasteur_OutEye = (Img1 >> 14) & 1;
    Pasteur_Air = (Img1 >> 15) & 1;
    Labeler_PbStart = (Img1 >> 16) & 1;
    Labeler_PbStop = (Img1 >> 17) & 1;
    Labeler_Estop = (Img1 >> 18) & 1;
    Labeler_Guard = (Img1 >> 19) & 1;
    Labeler_MotTrip = (Img1 >> 20) & 1;
    Labeler_InEye = (Img1 >> 21) & 1;
    Labeler_OutEye = (Img1 >> 22) & 1;
    Labeler_Air = (Img1 >> 23) & 1;
    Coder_PbStart = (Img1 >> 24) & 1;
    Coder_PbStop = (Img1 >> 25) & 1;
    Coder_Estop = (Img1 >> 26) & 1;
    Coder_Guard = (Img1 >> 27) & 1;
    Coder_MotTrip = (Img1 >> 28) & 1;
    Coder_InEye = (Img1 >> 29) & 1;
    Coder_OutEye = (Img1 >> 30) & 1;
    Coder_Air = (Img1 >> 31) & 1;
    Checkw_PbStart = (Img2 >> 0) & 1;
    Checkw_PbStop = (Img2 >> 1) & 1;
    Checkw_Estop = (Img2 >> 2) & 1;
    Checkw_Guard = (Img2 >> 3) & 1;
    Checkw_MotTrip = (Img2 >> 4) & 1;
    Checkw_InEye = (Img2 >> 5) & 1;
    Checkw_OutEye = (Img2 >> 6) & 1;
    Checkw_Air = (Img2 >> 7) & 1;
    Packer_PbStart = (Img2 >> 8) & 1;
    Packer_PbStop = (Img2 >> 9) & 1;
    Packer_Estop = (Img2 >> 10) & 1;
    Packer_Guard = (Img2 >> 11) & 1;
    Packer_MotTrip = (Img2 >> 12) & 1;
    Packer_InEye = (Img2 >> 13) & 1;
    Packer_OutEye = (Img2 >> 14) & 1;
    Packer_Air = (Img2 >> 15) & 1;
    Pallet_PbStart = (Img2 >> 16) & 1;
    Pallet_PbStop = (Img2 >> 17) & 1;
    Pallet_Estop = (Img2 >> 18) & 1;
    Pallet_Guard = (Img2 >> 19) & 1;
    Pallet_MotTrip = (Img2 >> 20) & 1;
    Pallet_InEye = (Img2 >> 21) & 1;
    Pallet_OutEye = (Img2 >> 22) & 1;
    Pallet_Air = (Img2 >> 23) & 1;
    Wrapper_PbStart = (Img2 >> 24) & 1;
    Wrapper_PbStop = (Img2 >> 25) & 1;
    Wrapper_Estop = (Img2 >> 26) & 1;
    Wrapper_Guard = (Img2 >> 27) & 1;
    Wrapper_MotTrip = (Img2 >> 28) & 1;
    Wrapper_InEye = (Img2 >> 29) & 1;
    Wrapper_OutEye = (Img2 >> 30) & 1;
    Wrapper_Air = (Img2 >> 31) & 1;

    /* line control */
    Line_Zone1Ok = (!Depal_Estop | Depal_Guard) & (!Rinser_Estop | Rinser_Guard) & (!Filler_Estop | Filler_Guard) & (!Capper_Estop | Capper_Guard);
    Line_Zone2Ok = (!Inspect_Estop | Inspect_Guard) & (!Pasteur_Estop | Pasteur_Guard) & (!Labeler_Estop | Labeler_Guard) & (!Coder_Estop | Coder_Guard);
    Line_Zone3Ok = (!Checkw_Estop | Checkw_Guard) & (!Packer_Estop | Packer_Guard) & (!Pallet_Estop | Pallet_Guard) & (!Wrapper_Estop | Wrapper_Guard);
    Line_Auto = (Filler_PbStart | Line_Auto) & !(Filler_PbStop & Capper_PbStop);
    Line_Manual = !Line_Auto & (Depal_PbStart | Line_Manual) & !Depal_PbStop;
    Line_Clean = (Pasteur_PbStart & !Line_Auto | Line_Clean) & !Pasteur_PbStop;
    Line_Reset = Rinser_PbStart & Rinser_PbStop | Wrapper_PbStart & !Wrapper_Run;
    Line_AckHorn = Packer_PbStop | Line_Reset;

    /* station Depal */
    Depal_SafeOk = Line_Zone1Ok & Depal_Guard & !Depal_Estop;
    if (Depal_MotTrip & Depal_Run)
        Depal_TripMem = true;
    else if (Line_Reset & !Depal_MotTrip)
        Depal_TripMem = false;
    Depal_AirOk = Depal_Air | Depal_AirOk & !Depal_AirLow;
    Depal_AirLow = !Depal_Air & !Wrapper_Air;
    Depal_Jam = (Depal_InEye & Depal_OutEye & Depal_Run | Depal_Jam) & !Line_Reset;
    Depal_Fault = Depal_TripMem | Depal_Jam | !Depal_SafeOk | Depal_AirLow & !Depal_AirOk;
    Depal_InfeedFree = !Depal_InEye | Depal_Run & !Depal_Backup;
    Depal_Backup = Depal_OutEye & (Rinser_InEye | Rinser_Fault) & !Rinser_Run;
    Depal_Starved = !Depal_InEye & (Wrapper_Fault | !Wrapper_Run);
    Depal_Ready = Depal_SafeOk & Depal_AirOk & !Depal_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Depal_StartReq = Depal_Ready & (Depal_PbStart | Line_Auto & Wrapper_Run | Line_Clean & Depal_PbStart);
    Depal_StopReq = Depal_PbStop | Depal_Backup & Line_Auto | Depal_Fault;
    Depal_Run = (Depal_StartReq | Depal_Run) & !Depal_StopReq & Depal_Ready;
    Depal_Slow = Depal_Run & (Depal_Starved ^ Depal_Backup);
    Depal_Fast = Depal_Run & !Depal_Slow & Rinser_Run;
    Depal_EdgeIn = Depal_InEye & !Depal_InEyeOld;
    Depal_InEyeOld = Depal_InEye;
    Depal_Toggle = Depal_EdgeIn ^ Depal_Toggle;
    Depal_GateOpen = (Depal_EdgeIn | Depal_GateOpen) & Depal_Run & !Depal_OutEye;
    Depal_LampG = Depal_Run & !Depal_Fault;
    Depal_LampY = Depal_Starved | Depal_Backup | Depal_Slow;
    Depal_LampR = Depal_Fault & (!Line_AckHorn | Depal_Toggle);

    /* station Rinser */
    Rinser_SafeOk = Line_Zone1Ok & Rinser_Guard & !Rinser_Estop;
    if (Rinser_MotTrip & Rinser_Run)
        Rinser_TripMem = true;
    else if (Line_Reset & !Rinser_MotTrip)
        Rinser_TripMem = false;
    Rinser_AirOk = Rinser_Air | Rinser_AirOk & !Rinser_AirLow;
    Rinser_AirLow = !Rinser_Air & !Depal_Air;
    Rinser_Jam = (Rinser_InEye & Rinser_OutEye & Rinser_Run | Rinser_Jam) & !Line_Reset;
    Rinser_Fault = Rinser_TripMem | Rinser_Jam | !Rinser_SafeOk | Rinser_AirLow & !Rinser_AirOk;
    Rinser_InfeedFree = !Rinser_InEye | Rinser_Run & !Rinser_Backup;
    Rinser_Backup = Rinser_OutEye & (Filler_InEye | Filler_Fault) & !Filler_Run;
    Rinser_Starved = !Rinser_InEye & (Depal_Fault | !Depal_Run);
    Rinser_Ready = Rinser_SafeOk & Rinser_AirOk & !Rinser_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Rinser_StartReq = Rinser_Ready & (Rinser_PbStart | Line_Auto & Depal_Run | Line_Clean & Rinser_PbStart);
    Rinser_StopReq = Rinser_PbStop | Rinser_Backup & Line_Auto | Rinser_Fault;
    Rinser_Run = (Rinser_StartReq | Rinser_Run) & !Rinser_StopReq & Rinser_Ready;
    Rinser_Slow = Rinser_Run & (Rinser_Starved ^ Rinser_Backup);
    Rinser_Fast = Rinser_Run & !Rinser_Slow & Filler_Run;
    Rinser_EdgeIn = Rinser_InEye & !Rinser_InEyeOld;
    Rinser_InEyeOld = Rinser_InEye;
    Rinser_Toggle = Rinser_EdgeIn ^ Rinser_Toggle;
    Rinser_GateOpen = (Rinser_EdgeIn | Rinser_GateOpen) & Rinser_Run & !Rinser_OutEye;
    Rinser_LampG = Rinser_Run & !Rinser_Fault;
    Rinser_LampY = Rinser_Starved | Rinser_Backup | Rinser_Slow;
    Rinser_LampR = Rinser_Fault & (!Line_AckHorn | Rinser_Toggle);

    /* station Filler */
    Filler_SafeOk = Line_Zone1Ok & Filler_Guard & !Filler_Estop;
    if (Filler_MotTrip & Filler_Run)
        Filler_TripMem = true;
    else if (Line_Reset & !Filler_MotTrip)
        Filler_TripMem = false;
    Filler_AirOk = Filler_Air | Filler_AirOk & !Filler_AirLow;
    Filler_AirLow = !Filler_Air & !Rinser_Air;
    Filler_Jam = (Filler_InEye & Filler_OutEye & Filler_Run | Filler_Jam) & !Line_Reset;
    Filler_Fault = Filler_TripMem | Filler_Jam | !Filler_SafeOk | Filler_AirLow & !Filler_AirOk;
    Filler_InfeedFree = !Filler_InEye | Filler_Run & !Filler_Backup;
    Filler_Backup = Filler_OutEye & (Capper_InEye | Capper_Fault) & !Capper_Run;
    Filler_Starved = !Filler_InEye & (Rinser_Fault | !Rinser_Run);
    Filler_Ready = Filler_SafeOk & Filler_AirOk & !Filler_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Filler_StartReq = Filler_Ready & (Filler_PbStart | Line_Auto & Rinser_Run | Line_Clean & Filler_PbStart);
    Filler_StopReq = Filler_PbStop | Filler_Backup & Line_Auto | Filler_Fault;
    Filler_Run = (Filler_StartReq | Filler_Run) & !Filler_StopReq & Filler_Ready;
    Filler_Slow = Filler_Run & (Filler_Starved ^ Filler_Backup);
    Filler_Fast = Filler_Run & !Filler_Slow & Capper_Run;
    Filler_EdgeIn = Filler_InEye & !Filler_InEyeOld;
    Filler_InEyeOld = Filler_InEye;
    Filler_Toggle = Filler_EdgeIn ^ Filler_Toggle;
    Filler_GateOpen = (Filler_EdgeIn | Filler_GateOpen) & Filler_Run & !Filler_OutEye;
    Filler_LampG = Filler_Run & !Filler_Fault;
    Filler_LampY = Filler_Starved | Filler_Backup | Filler_Slow;
    Filler_LampR = Filler_Fault & (!Line_AckHorn | Filler_Toggle);

    /* station Capper */
    Capper_SafeOk = Line_Zone1Ok & Capper_Guard & !Capper_Estop;
    if (Capper_MotTrip & Capper_Run)
        Capper_TripMem = true;
    else if (Line_Reset & !Capper_MotTrip)
        Capper_TripMem = false;
    Capper_AirOk = Capper_Air | Capper_AirOk & !Capper_AirLow;
    Capper_AirLow = !Capper_Air & !Filler_Air;
    Capper_Jam = (Capper_InEye & Capper_OutEye & Capper_Run | Capper_Jam) & !Line_Reset;
    Capper_Fault = Capper_TripMem | Capper_Jam | !Capper_SafeOk | Capper_AirLow & !Capper_AirOk;
    Capper_InfeedFree = !Capper_InEye | Capper_Run & !Capper_Backup;
    Capper_Backup = Capper_OutEye & (Inspect_InEye | Inspect_Fault) & !Inspect_Run;
    Capper_Starved = !Capper_InEye & (Filler_Fault | !Filler_Run);
    Capper_Ready = Capper_SafeOk & Capper_AirOk & !Capper_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Capper_StartReq = Capper_Ready & (Capper_PbStart | Line_Auto & Filler_Run | Line_Clean & Capper_PbStart);
    Capper_StopReq = Capper_PbStop | Capper_Backup & Line_Auto | Capper_Fault;
    Capper_Run = (Capper_StartReq | Capper_Run) & !Capper_StopReq & Capper_Ready;
    Capper_Slow = Capper_Run & (Capper_Starved ^ Capper_Backup);
    Capper_Fast = Capper_Run & !Capper_Slow & Inspect_Run;
    Capper_EdgeIn = Capper_InEye & !Capper_InEyeOld;
    Capper_InEyeOld = Capper_InEye;
    Capper_Toggle = Capper_EdgeIn ^ Capper_Toggle;
    Capper_GateOpen = (Capper_EdgeIn | Capper_GateOpen) & Capper_Run & !Capper_OutEye;
    Capper_LampG = Capper_Run & !Capper_Fault;
    Capper_LampY = Capper_Starved | Capper_Backup | Capper_Slow;
    Capper_LampR = Capper_Fault & (!Line_AckHorn | Capper_Toggle);

    /* station Inspect */
    Inspect_SafeOk = Line_Zone2Ok & Inspect_Guard & !Inspect_Estop;
    if (Inspect_MotTrip & Inspect_Run)
        Inspect_TripMem = true;
    else if (Line_Reset & !Inspect_MotTrip)
        Inspect_TripMem = false;
    Inspect_AirOk = Inspect_Air | Inspect_AirOk & !Inspect_AirLow;
    Inspect_AirLow = !Inspect_Air & !Capper_Air;
    Inspect_Jam = (Inspect_InEye & Inspect_OutEye & Inspect_Run | Inspect_Jam) & !Line_Reset;
    Inspect_Fault = Inspect_TripMem | Inspect_Jam | !Inspect_SafeOk | Inspect_AirLow & !Inspect_AirOk;
    Inspect_InfeedFree = !Inspect_InEye | Inspect_Run & !Inspect_Backup;
    Inspect_Backup = Inspect_OutEye & (Pasteur_InEye | Pasteur_Fault) & !Pasteur_Run;
    Inspect_Starved = !Inspect_InEye & (Capper_Fault | !Capper_Run);
    Inspect_Ready = Inspect_SafeOk & Inspect_AirOk & !Inspect_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Inspect_StartReq = Inspect_Ready & (Inspect_PbStart | Line_Auto & Capper_Run | Line_Clean & Inspect_PbStart);
    Inspect_StopReq = Inspect_PbStop | Inspect_Backup & Line_Auto | Inspect_Fault;
    Inspect_Run = (Inspect_StartReq | Inspect_Run) & !Inspect_StopReq & Inspect_Ready;
    Inspect_Slow = Inspect_Run & (Inspect_Starved ^ Inspect_Backup);
    Inspect_Fast = Inspect_Run & !Inspect_Slow & Pasteur_Run;
    Inspect_EdgeIn = Inspect_InEye & !Inspect_InEyeOld;
    Inspect_InEyeOld = Inspect_InEye;
    Inspect_Toggle = Inspect_EdgeIn ^ Inspect_Toggle;
    Inspect_GateOpen = (Inspect_EdgeIn | Inspect_GateOpen) & Inspect_Run & !Inspect_OutEye;
    Inspect_LampG = Inspect_Run & !Inspect_Fault;
    Inspect_LampY = Inspect_Starved | Inspect_Backup | Inspect_Slow;
    Inspect_LampR = Inspect_Fault & (!Line_AckHorn | Inspect_Toggle);

    /* station Pasteur */
    Pasteur_SafeOk = Line_Zone2Ok & Pasteur_Guard & !Pasteur_Estop;
    if (Pasteur_MotTrip & Pasteur_Run)
        Pasteur_TripMem = true;
    else if (Line_Reset & !Pasteur_MotTrip)
        Pasteur_TripMem = false;
    Pasteur_AirOk = Pasteur_Air | Pasteur_AirOk & !Pasteur_AirLow;
    Pasteur_AirLow = !Pasteur_Air & !Inspect_Air;
    Pasteur_Jam = (Pasteur_InEye & Pasteur_OutEye & Pasteur_Run | Pasteur_Jam) & !Line_Reset;
    Pasteur_Fault = Pasteur_TripMem | Pasteur_Jam | !Pasteur_SafeOk | Pasteur_AirLow & !Pasteur_AirOk;
    Pasteur_InfeedFree = !Pasteur_InEye | Pasteur_Run & !Pasteur_Backup;
    Pasteur_Backup = Pasteur_OutEye & (Labeler_InEye | Labeler_Fault) & !Labeler_Run;
    Pasteur_Starved = !Pasteur_InEye & (Inspect_Fault | !Inspect_Run);
    Pasteur_Ready = Pasteur_SafeOk & Pasteur_AirOk & !Pasteur_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Pasteur_StartReq = Pasteur_Ready & (Pasteur_PbStart | Line_Auto & Inspect_Run | Line_Clean & Pasteur_PbStart);
    Pasteur_StopReq = Pasteur_PbStop | Pasteur_Backup & Line_Auto | Pasteur_Fault;
    Pasteur_Run = (Pasteur_StartReq | Pasteur_Run) & !Pasteur_StopReq & Pasteur_Ready;
    Pasteur_Slow = Pasteur_Run & (Pasteur_Starved ^ Pasteur_Backup);
    Pasteur_Fast = Pasteur_Run & !Pasteur_Slow & Labeler_Run;
    Pasteur_EdgeIn = Pasteur_InEye & !Pasteur_InEyeOld;
    Pasteur_InEyeOld = Pasteur_InEye;
    Pasteur_Toggle = Pasteur_EdgeIn ^ Pasteur_Toggle;
    Pasteur_GateOpen = (Pasteur_EdgeIn | Pasteur_GateOpen) & Pasteur_Run & !Pasteur_OutEye;
    Pasteur_LampG = Pasteur_Run & !Pasteur_Fault;
    Pasteur_LampY = Pasteur_Starved | Pasteur_Backup | Pasteur_Slow;
    Pasteur_LampR = Pasteur_Fault & (!Line_AckHorn | Pasteur_Toggle);

    /* station Labeler */
    Labeler_SafeOk = Line_Zone2Ok & Labeler_Guard & !Labeler_Estop;
    if (Labeler_MotTrip & Labeler_Run)
        Labeler_TripMem = true;
    else if (Line_Reset & !Labeler_MotTrip)
        Labeler_TripMem = false;
    Labeler_AirOk = Labeler_Air | Labeler_AirOk & !Labeler_AirLow;
    Labeler_AirLow = !Labeler_Air & !Pasteur_Air;
    Labeler_Jam = (Labeler_InEye & Labeler_OutEye & Labeler_Run | Labeler_Jam) & !Line_Reset;
    Labeler_Fault = Labeler_TripMem | Labeler_Jam | !Labeler_SafeOk | Labeler_AirLow & !Labeler_AirOk;
    Labeler_InfeedFree = !Labeler_InEye | Labeler_Run & !Labeler_Backup;
    Labeler_Backup = Labeler_OutEye & (Coder_InEye | Coder_Fault) & !Coder_Run;
    Labeler_Starved = !Labeler_InEye & (Pasteur_Fault | !Pasteur_Run);
    Labeler_Ready = Labeler_SafeOk & Labeler_AirOk & !Labeler_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Labeler_StartReq = Labeler_Ready & (Labeler_PbStart | Line_Auto & Pasteur_Run | Line_Clean & Labeler_PbStart);
    Labeler_StopReq = Labeler_PbStop | Labeler_Backup & Line_Auto | Labeler_Fault;
    Labeler_Run = (Labeler_StartReq | Labeler_Run) & !Labeler_StopReq & Labeler_Ready;
    Labeler_Slow = Labeler_Run & (Labeler_Starved ^ Labeler_Backup);
    Labeler_Fast = Labeler_Run & !Labeler_Slow & Coder_Run;
    Labeler_EdgeIn = Labeler_InEye & !Labeler_InEyeOld;
    Labeler_InEyeOld = Labeler_InEye;
    Labeler_Toggle = Labeler_EdgeIn ^ Labeler_Toggle;
    Labeler_GateOpen = (Labeler_EdgeIn | Labeler_GateOpen) & Labeler_Run & !Labeler_OutEye;
    Labeler_LampG = Labeler_Run & !Labeler_Fault;
    Labeler_LampY = Labeler_Starved | Labeler_Backup | Labeler_Slow;
    Labeler_LampR = Labeler_Fault & (!Line_AckHorn | Labeler_Toggle);

    /* station Coder */
    Coder_SafeOk = Line_Zone2Ok & Coder_Guard & !Coder_Estop;
    if (Coder_MotTrip & Coder_Run)
        Coder_TripMem = true;
    else if (Line_Reset & !Coder_MotTrip)
        Coder_TripMem = false;
    Coder_AirOk = Coder_Air | Coder_AirOk & !Coder_AirLow;
    Coder_AirLow = !Coder_Air & !Labeler_Air;
    Coder_Jam = (Coder_InEye & Coder_OutEye & Coder_Run | Coder_Jam) & !Line_Reset;
    Coder_Fault = Coder_TripMem | Coder_Jam | !Coder_SafeOk | Coder_AirLow & !Coder_AirOk;
    Coder_InfeedFree = !Coder_InEye | Coder_Run & !Coder_Backup;
    Coder_Backup = Coder_OutEye & (Checkw_InEye | Checkw_Fault) & !Checkw_Run;
    Coder_Starved = !Coder_InEye & (Labeler_Fault | !Labeler_Run);
    Coder_Ready = Coder_SafeOk & Coder_AirOk & !Coder_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Coder_StartReq = Coder_Ready & (Coder_PbStart | Line_Auto & Labeler_Run | Line_Clean & Coder_PbStart);
    Coder_StopReq = Coder_PbStop | Coder_Backup & Line_Auto | Coder_Fault;
    Coder_Run = (Coder_StartReq | Coder_Run) & !Coder_StopReq & Coder_Ready;
    Coder_Slow = Coder_Run & (Coder_Starved ^ Coder_Backup);
    Coder_Fast = Coder_Run & !Coder_Slow & Checkw_Run;
    Coder_EdgeIn = Coder_InEye & !Coder_InEyeOld;
    Coder_InEyeOld = Coder_InEye;
    Coder_Toggle = Coder_EdgeIn ^ Coder_Toggle;
    Coder_GateOpen = (Coder_EdgeIn | Coder_GateOpen) & Coder_Run & !Coder_OutEye;
    Coder_LampG = Coder_Run & !Coder_Fault;
    Coder_LampY = Coder_Starved | Coder_Backup | Coder_Slow;
    Coder_LampR = Coder_Fault & (!Line_AckHorn | Coder_Toggle);

    /* station Checkw */
    Checkw_SafeOk = Line_Zone3Ok & Checkw_Guard & !Checkw_Estop;
    if (Checkw_MotTrip & Checkw_Run)
        Checkw_TripMem = true;
    else if (Line_Reset & !Checkw_MotTrip)
        Checkw_TripMem = false;
    Checkw_AirOk = Checkw_Air | Checkw_AirOk & !Checkw_AirLow;
    Checkw_AirLow = !Checkw_Air & !Coder_Air;
    Checkw_Jam = (Checkw_InEye & Checkw_OutEye & Checkw_Run | Checkw_Jam) & !Line_Reset;
    Checkw_Fault = Checkw_TripMem | Checkw_Jam | !Checkw_SafeOk | Checkw_AirLow & !Checkw_AirOk;
    Checkw_InfeedFree = !Checkw_InEye | Checkw_Run & !Checkw_Backup;
    Checkw_Backup = Checkw_OutEye & (Packer_InEye | Packer_Fault) & !Packer_Run;
    Checkw_Starved = !Checkw_InEye & (Coder_Fault | !Coder_Run);
    Checkw_Ready = Checkw_SafeOk & Checkw_AirOk & !Checkw_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Checkw_StartReq = Checkw_Ready & (Checkw_PbStart | Line_Auto & Coder_Run | Line_Clean & Checkw_PbStart);
    Checkw_StopReq = Checkw_PbStop | Checkw_Backup & Line_Auto | Checkw_Fault;
    Checkw_Run = (Checkw_StartReq | Checkw_Run) & !Checkw_StopReq & Checkw_Ready;
    Checkw_Slow = Checkw_Run & (Checkw_Starved ^ Checkw_Backup);
    Checkw_Fast = Checkw_Run & !Checkw_Slow & Packer_Run;
    Checkw_EdgeIn = Checkw_InEye & !Checkw_InEyeOld;
    Checkw_InEyeOld = Checkw_InEye;
    Checkw_Toggle = Checkw_EdgeIn ^ Checkw_Toggle;
    Checkw_GateOpen = (Checkw_EdgeIn | Checkw_GateOpen) & Checkw_Run & !Checkw_OutEye;
    Checkw_LampG = Checkw_Run & !Checkw_Fault;
    Checkw_LampY = Checkw_Starved | Checkw_Backup | Checkw_Slow;
    Checkw_LampR = Checkw_Fault & (!Line_AckHorn | Checkw_Toggle);

    /* station Packer */
    Packer_SafeOk = Line_Zone3Ok & Packer_Guard & !Packer_Estop;
    if (Packer_MotTrip & Packer_Run)
        Packer_TripMem = true;
    else if (Line_Reset & !Packer_MotTrip)
        Packer_TripMem = false;
    Packer_AirOk = Packer_Air | Packer_AirOk & !Packer_AirLow;
    Packer_AirLow = !Packer_Air & !Checkw_Air;
    Packer_Jam = (Packer_InEye & Packer_OutEye & Packer_Run | Packer_Jam) & !Line_Reset;
    Packer_Fault = Packer_TripMem | Packer_Jam | !Packer_SafeOk | Packer_AirLow & !Packer_AirOk;
    Packer_InfeedFree = !Packer_InEye | Packer_Run & !Packer_Backup;
    Packer_Backup = Packer_OutEye & (Pallet_InEye | Pallet_Fault) & !Pallet_Run;
    Packer_Starved = !Packer_InEye & (Checkw_Fault | !Checkw_Run);
    Packer_Ready = Packer_SafeOk & Packer_AirOk & !Packer_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Packer_StartReq = Packer_Ready & (Packer_PbStart | Line_Auto & Checkw_Run | Line_Clean & Packer_PbStart);
    Packer_StopReq = Packer_PbStop | Packer_Backup & Line_Auto | Packer_Fault;
    Packer_Run = (Packer_StartReq | Packer_Run) & !Packer_StopReq & Packer_Ready;
    Packer_Slow = Packer_Run & (Packer_Starved ^ Packer_Backup);
    Packer_Fast = Packer_Run & !Packer_Slow & Pallet_Run;
    Packer_EdgeIn = Packer_InEye & !Packer_InEyeOld;
    Packer_InEyeOld = Packer_InEye;
    Packer_Toggle = Packer_EdgeIn ^ Packer_Toggle;
    Packer_GateOpen = (Packer_EdgeIn | Packer_GateOpen) & Packer_Run & !Packer_OutEye;
    Packer_LampG = Packer_Run & !Packer_Fault;
    Packer_LampY = Packer_Starved | Packer_Backup | Packer_Slow;
    Packer_LampR = Packer_Fault & (!Line_AckHorn | Packer_Toggle);

    /* station Pallet */
    Pallet_SafeOk = Line_Zone3Ok & Pallet_Guard & !Pallet_Estop;
    if (Pallet_MotTrip & Pallet_Run)
        Pallet_TripMem = true;
    else if (Line_Reset & !Pallet_MotTrip)
        Pallet_TripMem = false;
    Pallet_AirOk = Pallet_Air | Pallet_AirOk & !Pallet_AirLow;
    Pallet_AirLow = !Pallet_Air & !Packer_Air;
    Pallet_Jam = (Pallet_InEye & Pallet_OutEye & Pallet_Run | Pallet_Jam) & !Line_Reset;
    Pallet_Fault = Pallet_TripMem | Pallet_Jam | !Pallet_SafeOk | Pallet_AirLow & !Pallet_AirOk;
    Pallet_InfeedFree = !Pallet_InEye | Pallet_Run & !Pallet_Backup;
    Pallet_Backup = Pallet_OutEye & (Wrapper_InEye | Wrapper_Fault) & !Wrapper_Run;
    Pallet_Starved = !Pallet_InEye & (Packer_Fault | !Packer_Run);
    Pallet_Ready = Pallet_SafeOk & Pallet_AirOk & !Pallet_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Pallet_StartReq = Pallet_Ready & (Pallet_PbStart | Line_Auto & Packer_Run | Line_Clean & Pallet_PbStart);
    Pallet_StopReq = Pallet_PbStop | Pallet_Backup & Line_Auto | Pallet_Fault;
    Pallet_Run = (Pallet_StartReq | Pallet_Run) & !Pallet_StopReq & Pallet_Ready;
    Pallet_Slow = Pallet_Run & (Pallet_Starved ^ Pallet_Backup);
    Pallet_Fast = Pallet_Run & !Pallet_Slow & Wrapper_Run;
    Pallet_EdgeIn = Pallet_InEye & !Pallet_InEyeOld;
    Pallet_InEyeOld = Pallet_InEye;
    Pallet_Toggle = Pallet_EdgeIn ^ Pallet_Toggle;
    Pallet_GateOpen = (Pallet_EdgeIn | Pallet_GateOpen) & Pallet_Run & !Pallet_OutEye;
    Pallet_LampG = Pallet_Run & !Pallet_Fault;
    Pallet_LampY = Pallet_Starved | Pallet_Backup | Pallet_Slow;
    Pallet_LampR = Pallet_Fault & (!Line_AckHorn | Pallet_Toggle);

    /* station Wrapper */
    Wrapper_SafeOk = Line_Zone3Ok & Wrapper_Guard & !Wrapper_Estop;
    if (Wrapper_MotTrip & Wrapper_Run)
        Wrapper_TripMem = true;
    else if (Line_Reset & !Wrapper_MotTrip)
        Wrapper_TripMem = false;
    Wrapper_AirOk = Wrapper_Air | Wrapper_AirOk & !Wrapper_AirLow;
    Wrapper_AirLow = !Wrapper_Air & !Pallet_Air;
    Wrapper_Jam = (Wrapper_InEye & Wrapper_OutEye & Wrapper_Run | Wrapper_Jam) & !Line_Reset;
    Wrapper_Fault = Wrapper_TripMem | Wrapper_Jam | !Wrapper_SafeOk | Wrapper_AirLow & !Wrapper_AirOk;
    Wrapper_InfeedFree = !Wrapper_InEye | Wrapper_Run & !Wrapper_Backup;
    Wrapper_Backup = Wrapper_OutEye & (Depal_InEye | Depal_Fault) & !Depal_Run;
    Wrapper_Starved = !Wrapper_InEye & (Pallet_Fault | !Pallet_Run);
    Wrapper_Ready = Wrapper_SafeOk & Wrapper_AirOk & !Wrapper_Fault & (Line_Auto | Line_Manual | Line_Clean);
    Wrapper_StartReq = Wrapper_Ready & (Wrapper_PbStart | Line_Auto & Pallet_Run | Line_Clean & Wrapper_PbStart);
    Wrapper_StopReq = Wrapper_PbStop | Wrapper_Backup & Line_Auto | Wrapper_Fault;
    Wrapper_Run = (Wrapper_StartReq | Wrapper_Run) & !Wrapper_StopReq & Wrapper_Ready;
    Wrapper_Slow = Wrapper_Run & (Wrapper_Starved ^ Wrapper_Backup);
    Wrapper_Fast = Wrapper_Run & !Wrapper_Slow & Depal_Run;
    Wrapper_EdgeIn = Wrapper_InEye & !Wrapper_InEyeOld;
    Wrapper_InEyeOld = Wrapper_InEye;
    Wrapper_Toggle = Wrapper_EdgeIn ^ Wrapper_Toggle;
    Wrapper_GateOpen = (Wrapper_EdgeIn | Wrapper_GateOpen) & Wrapper_Run & !Wrapper_OutEye;
    Wrapper_LampG = Wrapper_Run & !Wrapper_Fault;
    Wrapper_LampY = Wrapper_Starved | Wrapper_Backup | Wrapper_Slow;
    Wrapper_LampR = Wrapper_Fault & (!Line_AckHorn | Wrapper_Toggle);

    /* specials */
    Filler_ValveFill = Filler_Run & Filler_EdgeIn & Rinser_Run & !Line_Clean;
    Filler_ValveCip = Line_Clean & !Filler_Run & Filler_SafeOk;
    Filler_ValveVent = (Filler_ValveFill | Filler_ValveVent) & !Filler_OutEye;
    Filler_BowlReq = Filler_Ready & !Filler_ValveCip & (Filler_Air | Filler_ValveFill);
    Capper_CapFeed = Capper_Run & (Capper_Toggle | !Capper_Starved);
    Capper_HeadDown = Capper_EdgeIn & Capper_CapFeed & Capper_AirOk;
    Capper_NoCap = (Capper_HeadDown & !Capper_Air | Capper_NoCap) & !Inspect_OutEye;
    Inspect_Reject = Inspect_EdgeIn & (Capper_NoCap | Inspect_Toggle & !Filler_ValveVent);
    Inspect_Pusher = (Inspect_Reject | Inspect_Pusher) & !Inspect_OutEye & Inspect_AirOk;
    Pasteur_Heat = Pasteur_Run & !Pasteur_AirLow | Line_Clean & Pasteur_SafeOk;
    Pasteur_Pump = Pasteur_Heat | Pasteur_Pump & !Pasteur_StopReq;
    Labeler_GlueOn = Labeler_Run & (Labeler_Fast | Labeler_EdgeIn);
    Coder_Print = Coder_EdgeIn & Labeler_GlueOn & !Coder_Fault;
    Checkw_Reject = Checkw_EdgeIn & (Filler_ValveVent ^ Checkw_Toggle);
    Packer_Grip = Packer_Run & Packer_Toggle & Packer_AirOk & !Checkw_Reject;
    Packer_Lower = Packer_Grip & (Packer_InEye | Packer_Lower);
    Pallet_LayerFull = Pallet_Toggle & Packer_Lower & !Pallet_StopReq;
    Wrapper_Turn = (Pallet_LayerFull | Wrapper_Turn) & Wrapper_Run;
    Line_Horn = (Depal_LampR | Rinser_LampR | Filler_LampR | Capper_LampR | Inspect_LampR | Pasteur_LampR | Labeler_LampR | Coder_LampR | Checkw_LampR | Packer_LampR | Pallet_LampR | Wrapper_LampR) & !Line_AckHorn;
    Line_AllRun = Depal_Run & Rinser_Run & Filler_Run & Capper_Run & Inspect_Run & Pasteur_Run & Labeler_Run & Coder_Run & Checkw_Run & Packer_Run & Pallet_Run & Wrapper_Run;
    Line_AnyRun = Depal_Run | Rinser_Run | Filler_Run | Capper_Run | Inspect_Run | Pasteur_Run | Labeler_Run | Coder_Run | Checkw_Run | Packer_Run | Pallet_Run | Wrapper_Run;

    /* status words */
    Word0 = Depal_Run + Depal_Fault * 2 + Depal_Slow * 4 + Depal_GateOpen * 8 + Depal_LampY * 16 + Depal_LampR * 32 + Depal_Toggle * 64 + Depal_Jam * 128 + Depal_LampG * 256 + Depal_Fast * 512 + Depal_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Rinser_Run + Rinser_Fault * 2 + Rinser_Slow * 4 + Rinser_GateOpen * 8 + Rinser_LampY * 16 + Rinser_LampR * 32 + Rinser_Toggle * 64 + Rinser_Jam * 128 + Rinser_LampG * 256 + Rinser_Fast * 512 + Rinser_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Filler_Run + Filler_Fault * 2 + Filler_Slow * 4 + Filler_GateOpen * 8 + Filler_LampY * 16 + Filler_LampR * 32 + Filler_Toggle * 64 + Filler_Jam * 128 + Filler_LampG * 256 + Filler_Fast * 512 + Filler_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Capper_Run + Capper_Fault * 2 + Capper_Slow * 4 + Capper_GateOpen * 8 + Capper_LampY * 16 + Capper_LampR * 32 + Capper_Toggle * 64 + Capper_Jam * 128 + Capper_LampG * 256 + Capper_Fast * 512 + Capper_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Inspect_Run + Inspect_Fault * 2 + Inspect_Slow * 4 + Inspect_GateOpen * 8 + Inspect_LampY * 16 + Inspect_LampR * 32 + Inspect_Toggle * 64 + Inspect_Jam * 128 + Inspect_LampG * 256 + Inspect_Fast * 512 + Inspect_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Pasteur_Run + Pasteur_Fault * 2 + Pasteur_Slow * 4 + Pasteur_GateOpen * 8 + Pasteur_LampY * 16 + Pasteur_LampR * 32 + Pasteur_Toggle * 64 + Pasteur_Jam * 128 + Pasteur_LampG * 256 + Pasteur_Fast * 512 + Pasteur_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Labeler_Run + Labeler_Fault * 2 + Labeler_Slow * 4 + Labeler_GateOpen * 8 + Labeler_LampY * 16 + Labeler_LampR * 32 + Labeler_Toggle * 64 + Labeler_Jam * 128 + Labeler_LampG * 256 + Labeler_Fast * 512 + Labeler_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Coder_Run + Coder_Fault * 2 + Coder_Slow * 4 + Coder_GateOpen * 8 + Coder_LampY * 16 + Coder_LampR * 32 + Coder_Toggle * 64 + Coder_Jam * 128 + Coder_LampG * 256 + Coder_Fast * 512 + Coder_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Checkw_Run + Checkw_Fault * 2 + Checkw_Slow * 4 + Checkw_GateOpen * 8 + Checkw_LampY * 16 + Checkw_LampR * 32 + Checkw_Toggle * 64 + Checkw_Jam * 128 + Checkw_LampG * 256 + Checkw_Fast * 512 + Checkw_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Packer_Run + Packer_Fault * 2 + Packer_Slow * 4 + Packer_GateOpen * 8 + Packer_LampY * 16 + Packer_LampR * 32 + Packer_Toggle * 64 + Packer_Jam * 128 + Packer_LampG * 256 + Packer_Fast * 512 + Packer_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Pallet_Run + Pallet_Fault * 2 + Pallet_Slow * 4 + Pallet_GateOpen * 8 + Pallet_LampY * 16 + Pallet_LampR * 32 + Pallet_Toggle * 64 + Pallet_Jam * 128 + Pallet_LampG * 256 + Pallet_Fast * 512 + Pallet_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Wrapper_Run + Wrapper_Fault * 2 + Wrapper_Slow * 4 + Wrapper_GateOpen * 8 + Wrapper_LampY * 16 + Wrapper_LampR * 32 + Wrapper_Toggle * 64 + Wrapper_Jam * 128 + Wrapper_LampG * 256 + Wrapper_Fast * 512 + Wrapper_InfeedFree * 1024;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
    Word0 = Filler_ValveFill + Filler_ValveCip * 2 + Capper_CapFeed * 4 + Capper_NoCap * 8 + Pasteur_Heat * 16 + Checkw_Reject * 32 + Packer_Grip * 64 + Pallet_LayerFull * 128 + Filler_ValveVent * 256 + Inspect_Pusher * 512 + Pasteur_Pump * 1024 + Coder_Print * 2048 + Packer_Lower * 4096 + Wrapper_Turn * 8192 + Line_Horn * 16384 + Line_AllRun * 32768 + Line_AnyRun * 65536 + Filler_BowlReq * 131072;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)Word0);
}
