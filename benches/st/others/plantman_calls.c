/* 200 block calls: 40 motors, 70 valves, 50 analog inputs, 20 stations with a motor inside */
#include <stdbool.h>
#include "st.h"

static float ScaleAI(int16_t raw, float lo, float hi)
{
    return lo + (hi - lo) * (float)raw / 27648.0f;
}

static int16_t ClampInt(int16_t value, int16_t lo, int16_t hi)
{
    if (value < lo)
        return lo;
    else if (value > hi)
        return hi;
    else
        return value;
}

static int16_t AlarmCode(bool trip, bool timeout, bool warn)
{
    if (trip)
        return 3;
    else if (timeout)
        return 2;
    else if (warn)
        return 1;
    else
        return 0;
}

static int32_t MixSum(int32_t old, int32_t add)
{
    return (old * 5 + add) % 1000003;
}

typedef struct {
    bool Contactor, Running, Fault;
    int16_t Speed, Step, Cnt;
} motor_t;

static void Motor(motor_t *m, bool start, bool stop, bool trip, bool reset, int16_t ramp)
{
    if (trip)
        m->Step = 40;
    switch (m->Step) {
    case 0:
        m->Speed = 0;
        if (start && !stop) {
            m->Step = 10;
            m->Cnt = 0;
        }
        break;
    case 10:
        m->Cnt = m->Cnt + 1;
        m->Speed = ClampInt(m->Speed + 100 / ramp, 0, 100);
        if (stop)
            m->Step = 30;
        else if (m->Cnt >= ramp)
            m->Step = 20;
        break;
    case 20:
        m->Speed = 100;
        if (stop)
            m->Step = 30;
        break;
    case 30:
        m->Speed = ClampInt(m->Speed - 25, 0, 100);
        if (m->Speed == 0)
            m->Step = 0;
        break;
    case 40:
        m->Speed = 0;
        if (reset && !trip)
            m->Step = 0;
        break;
    }
    m->Contactor = m->Step == 10 || m->Step == 20;
    m->Running = m->Step == 20;
    m->Fault = m->Step == 40;
}

typedef struct {
    bool Coil, IsOpen, IsClosed, Timeout;
    int16_t Alarm, Pos, Watch;
} valve_t;

static void Valve(valve_t *v, bool open, bool sticky, bool reset)
{
    v->Coil = open && !v->Timeout;
    if (!sticky) {
        if (v->Coil)
            v->Pos = ClampInt(v->Pos + 20, 0, 100);
        else
            v->Pos = ClampInt(v->Pos - 25, 0, 100);
    }
    v->IsOpen = v->Pos >= 95;
    v->IsClosed = v->Pos <= 5;
    if ((v->Coil && !v->IsOpen) || (!v->Coil && !v->IsClosed))
        v->Watch = v->Watch + 1;
    else
        v->Watch = 0;
    if (v->Watch > 12)
        v->Timeout = true;
    else if (reset)
        v->Timeout = false;
    v->Alarm = AlarmCode(false, v->Timeout, v->Watch > 6);
}

typedef struct {
    float Lo, Hi, HiLimit, LoLimit;
    float Value;
    bool HiAlarm, LoAlarm;
} analog_t;

static void Analog(analog_t *a, int16_t raw)
{
    a->Value = a->Value * 0.75f + ScaleAI(raw, a->Lo, a->Hi) * 0.25f;
    if (a->Value > a->HiLimit)
        a->HiAlarm = true;
    else if (a->Value < a->HiLimit - 2.0f)
        a->HiAlarm = false;
    if (a->Value < a->LoLimit)
        a->LoAlarm = true;
    else if (a->Value > a->LoLimit + 2.0f)
        a->LoAlarm = false;
}

typedef struct {
    int16_t Step, Wait;
    int32_t Pieces;
    bool Busy;
    motor_t Drive;
} station_t;

static void Station(station_t *s, bool enable, bool inEye, bool outEye, bool reset)
{
    switch (s->Step) {
    case 0:
        if (enable)
            s->Step = 1;
        break;
    case 1:
        if (inEye) {
            s->Step = 2;
            s->Wait = 3;
        } else if (!enable) {
            s->Step = 0;
        }
        break;
    case 2:
        s->Wait = s->Wait - 1;
        if (s->Wait <= 0)
            s->Step = 3;
        break;
    case 3:
        if (outEye) {
            s->Pieces = s->Pieces + 1;
            s->Step = 1;
        }
        break;
    default:
        s->Step = 0;
        break;
    }
    Motor(&s->Drive, s->Step > 0, s->Step == 0, inEye && outEye && s->Wait == 1, reset, 5);
    s->Busy = s->Step >= 2 && s->Drive.Running;
}

static bool Init;
static int32_t Seed = 321;
static int16_t Cycle;
static bool Eye[32];
static motor_t Motors[32];
static motor_t Depal_Motor, Rinser_Motor, Filler_Motor, Capper_Motor;
static motor_t Labeler_Motor, Packer_Motor, Pallet_Motor, Wrapper_Motor;
static valve_t Valves[64];
static valve_t Cip_Supply, Cip_Return, Water_In, Air_Main, Co2_In, Product_In;
static analog_t Inputs[50];
static station_t Stations[16];
static station_t Filler, Capper, Labeler, Packer;
static bool Reset;

void scan(void)
{
    int16_t i;
    int32_t Sum;

    if (!Init) {
        for (i = 0; i < 50; i++) {
            Inputs[i].Hi = 100.0f;
            Inputs[i].HiLimit = 80.0f;
            Inputs[i].LoLimit = 10.0f;
        }
        Init = true;
    }

    Cycle = Cycle + 1;
    if (Cycle >= 200)
        Cycle = 0;
    Reset = Cycle % 25 == 0;
    for (i = 1; i <= 4; i++) {
        Seed = (Seed * 171 + 11213) % 53125;
        Eye[Seed % 32] = !Eye[Seed % 32];
    }

    /* by name */
    Motor(&Depal_Motor, Cycle > 5, Cycle > 180, false, Reset, 5);
    Motor(&Rinser_Motor, Depal_Motor.Running, !Depal_Motor.Contactor, Eye[1] && Eye[2] && Eye[3], Reset, 5);
    Motor(&Filler_Motor, Rinser_Motor.Running, Cycle > 170, Eye[4] && Eye[5] && Eye[6], Reset, 10);
    Motor(&Capper_Motor, Filler_Motor.Running, !Filler_Motor.Contactor, false, Reset, 5);
    Motor(&Labeler_Motor, Capper_Motor.Running, Eye[7] && Eye[8], false, Reset, 8);
    Motor(&Packer_Motor, Labeler_Motor.Running, !Labeler_Motor.Contactor, false, Reset, 5);
    Motor(&Pallet_Motor, Packer_Motor.Running, Eye[9] && !Eye[10], false, Reset, 5);
    Motor(&Wrapper_Motor, Pallet_Motor.Running, !Pallet_Motor.Running, Eye[11] && Eye[12] && Eye[13], Reset, 5);

    Valve(&Cip_Supply, Cycle > 120 && Cycle < 160, false, Reset);
    Valve(&Cip_Return, Cip_Supply.IsOpen, Eye[14] && Eye[15], Reset);
    Valve(&Water_In, Rinser_Motor.Running, false, Reset);
    Valve(&Air_Main, Cycle > 3, false, Reset);
    Valve(&Co2_In, Filler_Motor.Running && Air_Main.IsOpen, Eye[16] && Eye[17], Reset);
    Valve(&Product_In, Filler_Motor.Running && !Cip_Supply.IsOpen, false, Reset);

    Station(&Filler, Filler_Motor.Running, Eye[18], Eye[19], Reset);
    Station(&Capper, Capper_Motor.Running, Eye[19], Eye[20], Reset);
    Station(&Labeler, Labeler_Motor.Running, Eye[20], Eye[21], Reset);
    Station(&Packer, Packer_Motor.Running, Eye[21], Eye[22], Reset);

    /* arrays */
    for (i = 1; i <= 32; i++)
        Motor(&Motors[i - 1], Eye[i - 1], Eye[(i + 7) % 32] && !Eye[i - 1],
              Cycle == i * 5, Reset, 4 + i % 6);
    for (i = 1; i <= 64; i++)
        Valve(&Valves[i - 1], Eye[i % 32] || Motors[(i - 1) / 2].Running,
              i % 16 == 3 && Cycle < 60, Reset);
    for (i = 1; i <= 50; i++)
        Analog(&Inputs[i - 1], ClampInt(Cycle * 100 + i * 150, 0, 27000));
    for (i = 1; i <= 16; i++)
        Station(&Stations[i - 1], Motors[i - 1].Contactor, Eye[i], Eye[i + 15], Reset);

    /* results */
    Sum = Depal_Motor.Speed + Rinser_Motor.Speed + Filler_Motor.Speed + Capper_Motor.Speed
        + Labeler_Motor.Speed + Packer_Motor.Speed + Pallet_Motor.Speed + Wrapper_Motor.Speed;
    Sum = Sum + Cip_Supply.Alarm + Cip_Return.Alarm + Water_In.Alarm + Air_Main.Alarm + Co2_In.Alarm + Product_In.Alarm;
    if (Co2_In.IsOpen)
        Sum = Sum + 50;
    if (Product_In.IsClosed)
        Sum = Sum + 70;
    Sum = Sum + Filler.Pieces + Capper.Pieces + Labeler.Pieces + Packer.Pieces;
    check = MixSum(check, Sum);
    for (i = 0; i < 32; i++) {
        Sum = Sum + Motors[i].Speed;
        if (Motors[i].Fault)
            Sum = Sum + 11;
    }
    for (i = 0; i < 64; i++) {
        Sum = Sum + Valves[i].Alarm;
        if (Valves[i].IsOpen)
            Sum = Sum + 1;
        else if (Valves[i].IsClosed)
            Sum = Sum + 2;
    }
    check = MixSum(check, Sum);
    for (i = 0; i < 50; i++) {
        Sum = Sum + (int32_t)Inputs[i].Value;
        if (Inputs[i].HiAlarm)
            Sum = Sum + 3;
        if (Inputs[i].LoAlarm)
            Sum = Sum + 4;
    }
    for (i = 0; i < 16; i++) {
        Sum = Sum + Stations[i].Step + Stations[i].Pieces % 100;
        if (Stations[i].Busy)
            Sum = Sum + 9;
    }
    check = MixSum(check, Sum % 100000);
}
