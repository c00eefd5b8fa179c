/* Pump house: 768 pumps, nested records */
#include <stdbool.h>
#include "st.h"

typedef struct { float amps, winding_temp; int32_t starts, seconds; } MotorData;
typedef struct { float temp, vib; bool alarm; } Bearing;
typedef struct {
    int16_t state, group, timer;
    MotorData motor;
    Bearing brg[2];
    float load;
    bool available;
} Pump;
typedef struct { int16_t demand, running, best, worst; float power; } GroupData;

#define PUMPS 768
#define GROUPS 64

static bool first = true;
static int32_t cycle;
static uint32_t seed = 99;
static Pump p[PUMPS];
static GroupData grp[GROUPS];

void scan(void)
{
    int i, g, b;
    float ambient;
    int32_t alarms = 0;
    if (first) {
        for (i = 0; i < PUMPS; i++) {
            p[i].group = i % GROUPS;
            p[i].available = true;
            p[i].motor.winding_temp = 20.0f;
            p[i].brg[0].temp = 20.0f;
            p[i].brg[1].temp = 20.0f;
            p[i].load = 0.6f + (float)((i + 1) % 7) * 0.05f;
        }
        first = false;
    }
    cycle++;
    ambient = 18.0f + (float)(cycle / 200 % 10);
    for (g = 0; g < GROUPS; g++) {
        grp[g].demand = (cycle / 150 + (g + 1) * 3) % 9;
        grp[g].running = 0;
        grp[g].best = -1;
        grp[g].worst = -1;
        grp[g].power = 0.0f;
    }
    for (i = 0; i < PUMPS; i++) {
        Pump *q = &p[i];
        GroupData *gr;
        seed = seed * 1664525u + 1013904223u;
        switch (q->state) {
        case 0:
            q->motor.amps = 0.0f;
            break;
        case 1:
            q->motor.amps = 240.0f;
            q->timer++;
            if (q->timer >= 10) {
                q->state = 2;
                q->timer = 0;
            }
            break;
        case 2:
            q->motor.amps = 80.0f * q->load + (float)(seed / 65536u % 16u);
            q->motor.seconds++;
            if (seed / 65536u % 4096u == 5) {
                q->state = 3;
                q->timer = 0;
                q->available = false;
            }
            break;
        case 3:
            q->motor.amps = 0.0f;
            q->timer++;
            if (q->timer > 300) {
                q->state = 0;
                q->timer = 0;
                q->available = true;
            }
            break;
        }
        q->motor.winding_temp = q->motor.winding_temp + (q->motor.amps * 0.5f + ambient - q->motor.winding_temp) * 0.02f;
        for (b = 0; b < 2; b++) {
            q->brg[b].vib = q->motor.amps * 0.02f * (float)(b + 1);
            q->brg[b].temp = q->brg[b].temp + (ambient + q->brg[b].vib * 15.0f - q->brg[b].temp) * 0.05f;
            q->brg[b].alarm = q->brg[b].temp > 62.0f;
            if (q->brg[b].alarm) alarms++;
        }
        gr = &grp[q->group];
        if (q->state == 1 || q->state == 2) {
            gr->running++;
            gr->power = gr->power + q->motor.amps * 0.69f;
            if (gr->worst < 0 || q->motor.seconds > p[gr->worst].motor.seconds)
                gr->worst = i;
        } else if (q->state == 0 && q->available) {
            if (gr->best < 0 || q->motor.seconds < p[gr->best].motor.seconds)
                gr->best = i;
        }
    }
    for (g = 0; g < GROUPS; g++) {
        if (grp[g].running < grp[g].demand && grp[g].best >= 0) {
            p[grp[g].best].state = 1;
            p[grp[g].best].timer = 0;
            p[grp[g].best].motor.starts++;
        } else if (grp[g].running > grp[g].demand && grp[g].worst >= 0) {
            p[grp[g].worst].state = 0;
        }
        check = (int32_t)((uint32_t)check * 31u + (uint32_t)(int32_t)grp[g].power + (uint32_t)(grp[g].running * 7) + (uint32_t)(grp[g].best + 1));
    }
    i = cycle % 768;
    check = (int32_t)((uint32_t)check * 31u + (uint32_t)(p[i].motor.starts + p[i].motor.seconds + (int32_t)(p[i].motor.winding_temp * 10.0f) + (int32_t)(p[i].brg[1].temp * 10.0f) + alarms));
}
