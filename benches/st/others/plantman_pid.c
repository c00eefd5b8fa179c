/* 64 PID loops: 8 by name, 56 in an array, each with its own tank */
#include <math.h>
#include <stdbool.h>
#include "st.h"

typedef struct {
    float SP, PV, KP, TN, TV, YMin, YMax;
    bool Manual;
    float YMan;
    float Y;
    bool Limited, HighAlarm, LowAlarm;
    float IPart, DPart, LastPV;
} pid_t_;

typedef struct {
    float Y, Gain, Load, PV, x1;
} tank_t;

#define TA 0.1f
#define DEADBAND 0.05f

static void Pid(pid_t_ *p)
{
    float e, u;

    e = p->SP - p->PV;
    if (fabsf(e) < DEADBAND)
        e = 0.0f;
    p->DPart = p->DPart * 0.8f + p->KP * p->TV * (p->LastPV - p->PV) / TA * 0.2f;
    p->LastPV = p->PV;
    if (p->Manual) {
        p->Y = p->YMan;
        p->IPart = p->YMan - p->KP * e;
        p->Limited = false;
    } else {
        u = p->KP * e + p->IPart + p->DPart;
        if (u > p->YMax) {
            p->Y = p->YMax;
            p->Limited = true;
        } else if (u < p->YMin) {
            p->Y = p->YMin;
            p->Limited = true;
        } else {
            p->Y = u;
            p->IPart = p->IPart + p->KP * e * TA / p->TN;
            p->Limited = false;
        }
    }
    p->HighAlarm = p->PV > p->SP + 10.0f;
    p->LowAlarm = p->PV < p->SP - 10.0f;
}

static void Tank(tank_t *t, float Y, float Load)
{
    t->Y = Y;
    t->Load = Load;
    t->x1 = t->x1 + (t->Y * t->Gain - t->x1) * 0.08f;
    t->PV = t->PV + (t->x1 - t->Load - t->PV) * 0.03f;
}

static bool Init;
static int16_t Cycle;
static pid_t_ Filler_Level = { .KP = 2.5f, .TN = 6.0f, .TV = 0.0f, .YMax = 90.0f };
static pid_t_ Filler_Pressure = { .KP = 4.0f, .TN = 4.0f, .TV = 0.1f, .YMax = 100.0f };
static pid_t_ Pasteur_Zone1 = { .KP = 1.5f, .TN = 20.0f, .TV = 1.0f, .YMax = 100.0f };
static pid_t_ Pasteur_Zone2 = { .KP = 1.5f, .TN = 20.0f, .TV = 1.0f, .YMax = 100.0f };
static pid_t_ Pasteur_Zone3 = { .KP = 1.2f, .TN = 25.0f, .TV = 0.5f, .YMax = 100.0f };
static pid_t_ Mixer_Brix = { .KP = 3.0f, .TN = 12.0f, .TV = 0.0f, .YMin = 5.0f, .YMax = 60.0f };
static pid_t_ Co2_Flow = { .KP = 2.0f, .TN = 8.0f, .TV = 0.2f, .YMax = 100.0f };
static pid_t_ Cip_Temp = { .KP = 2.2f, .TN = 15.0f, .TV = 0.4f, .YMax = 100.0f };
static tank_t Filler_Bowl = { .Gain = 1.0f }, Filler_Gas = { .Gain = 1.0f };
static tank_t Zone1 = { .Gain = 0.9f }, Zone2 = { .Gain = 1.1f }, Zone3 = { .Gain = 1.0f };
static tank_t Mixer = { .Gain = 0.5f }, Carbonator = { .Gain = 1.0f }, CipTank = { .Gain = 1.3f };
static pid_t_ Loops[56];
static tank_t Tanks[56];
static float Setpoint[56];
static float Load;

static void Loop(pid_t_ *p, float sp, float pv)
{
    p->SP = sp;
    p->PV = pv;
    Pid(p);
}

static void LoopMan(pid_t_ *p, float sp, float pv, bool manual, float yman)
{
    p->SP = sp;
    p->PV = pv;
    p->Manual = manual;
    p->YMan = yman;
    Pid(p);
}

void scan(void)
{
    int16_t i;
    float Sum;
    int32_t Alarms;

    if (!Init) {
        for (i = 1; i <= 56; i++) {
            Loops[i - 1].YMax = 100.0f;
            Loops[i - 1].KP = 1.0f + (float)i * 0.05f;
            Loops[i - 1].TN = 5.0f + (float)(i % 9);
            Loops[i - 1].TV = (float)(i % 4) * 0.25f;
            Tanks[i - 1].Gain = 0.8f + (float)(i % 7) * 0.1f;
            Setpoint[i - 1] = 30.0f + (float)(i % 20);
        }
        Init = true;
    }

    Cycle = Cycle + 1;
    if (Cycle >= 300)
        Cycle = 0;
    if (Cycle <= 99)
        Load = 0.0f;
    else if (Cycle <= 179)
        Load = 8.0f;
    else if (Cycle <= 199)
        Load = 15.0f;
    else
        Load = 3.0f;
    if (Cycle == 150) {
        for (i = 0; i < 56; i++)
            Setpoint[i] = 75.0f - Setpoint[i];
    }

    /* by name */
    Loop(&Filler_Level, 55.0f, Filler_Bowl.PV);
    Tank(&Filler_Bowl, Filler_Level.Y, Load);
    Loop(&Filler_Pressure, 35.0f, Filler_Gas.PV);
    Tank(&Filler_Gas, Filler_Pressure.Y, Load * 0.5f);
    Loop(&Pasteur_Zone1, 45.0f, Zone1.PV);
    Tank(&Zone1, Pasteur_Zone1.Y, Load);
    Loop(&Pasteur_Zone2, Zone1.PV + 17.0f, Zone2.PV);
    Tank(&Zone2, Pasteur_Zone2.Y, Load);
    LoopMan(&Pasteur_Zone3, 30.0f, Zone3.PV, Cycle > 250, 28.0f);
    Tank(&Zone3, Pasteur_Zone3.Y, Load);
    Loop(&Mixer_Brix, 11.2f, Mixer.PV);
    Tank(&Mixer, Mixer_Brix.Y, 0.2f);
    Loop(&Co2_Flow, 42.0f, Carbonator.PV);
    Tank(&Carbonator, Co2_Flow.Y, Load * 0.3f);
    LoopMan(&Cip_Temp, 82.0f, CipTank.PV, Cycle < 20, 50.0f);
    Tank(&CipTank, Cip_Temp.Y, 1.0f);

    for (i = 0; i < 56; i++) {
        LoopMan(&Loops[i], Setpoint[i], Tanks[i].PV, Cycle > 270 && (i + 1) % 8 == 0, 40.0f);
        Tank(&Tanks[i], Loops[i].Y, Load);
    }

    /* results */
    Sum = Filler_Level.Y + Filler_Pressure.Y + Pasteur_Zone1.Y + Pasteur_Zone2.Y
        + Pasteur_Zone3.Y + Mixer_Brix.Y + Co2_Flow.Y + Cip_Temp.Y;
    Alarms = 0;
    for (i = 0; i < 56; i++) {
        Sum = Sum + Loops[i].Y;
        if (Loops[i].HighAlarm)
            Alarms = Alarms + 1;
        else if (Loops[i].LowAlarm)
            Alarms = Alarms + 100;
        if (Loops[i].Limited)
            Alarms = Alarms + 7;
    }
    check = (check + (int32_t)(Sum * 10.0f) + Alarms) % 10000000;
}
