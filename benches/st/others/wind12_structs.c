#include <math.h>
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define WTGS 40

enum wtg_state { STOP, IDLE, START, PRODUCE, STOPPING, SERVICE };

struct blade {
    float angle, demand, battery;
    bool limit_sw;
};

struct wtg {
    enum wtg_state state;
    uint32_t status;
    struct blade blade[3];
    float speed, power, wind, nacelle;
    int32_t starts, faults, timer;
    bool enabled;
};

static struct wtg park[WTGS];
static struct wtg best;
static uint32_t rnd = 0x12345679u;
static int32_t n;

static inline float clampf(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

void scan(void)
{
    int32_t count[6] = {0};
    float total = 0.0f;
    uint32_t acc = 0;

    n++;
    rnd ^= rnd << 13;
    rnd ^= rnd >> 17;
    rnd ^= rnd << 5;

    for (int i = 0; i < WTGS; i++) {
        struct wtg *w = &park[i];
        int32_t phase = (n + (i + 1) * 29) % 601;
        float demand;

        w->enabled = phase > 20;
        w->wind = 4.0f + (float)(phase % 149) * 0.08f;
        w->timer++;
        count[w->state]++;
        switch (w->state) {
        case STOP:
            demand = 90.0f;
            if (w->enabled) {
                w->state = IDLE;
                w->timer = 0;
            }
            break;
        case IDLE:
            demand = 60.0f;
            if (w->wind > 5.0f && w->timer > 10) {
                w->state = START;
                w->starts++;
                w->timer = 0;
            }
            break;
        case START:
            demand = 15.0f;
            if (w->speed > 8.0f) {
                w->state = PRODUCE;
                w->timer = 0;
            } else if (w->timer > 120) {
                w->state = STOPPING;
                w->faults++;
            }
            break;
        case PRODUCE:
            demand = fmaxf(0.0f, (w->wind - 11.0f) * 3.0f);
            if (!w->enabled || w->wind < 4.2f) {
                w->state = STOPPING;
                w->timer = 0;
            }
            break;
        case STOPPING:
            demand = 90.0f;
            if (w->speed < 1.0f) {
                w->state = (rnd >> ((i + 1) % 24) & 3) == 0 ? SERVICE : STOP;
                w->timer = 0;
            }
            break;
        default:
            demand = 90.0f;
            if (w->timer > 30)
                w->state = STOP;
            break;
        }

        for (int b = 0; b < 3; b++) {
            struct blade *bl = &w->blade[b];
            bl->demand = demand + (float)(b - 1) * 0.3f;
            float diff = clampf(-1.5f, bl->demand - bl->angle, 1.5f);
            bl->angle += diff;
            bl->battery = bl->battery + 0.1f - fabsf(diff) * 0.05f;
            bl->limit_sw = bl->angle > 88.0f;
        }

        w->speed += (w->wind * (90.0f - w->blade[1].angle) * 0.02f - w->speed) * 0.05f;
        if (w->state == PRODUCE)
            w->power += (w->speed * w->wind * 20.0f - w->power) * 0.1f;
        else
            w->power *= 0.9f;

        uint32_t s = (w->status & 0xF0u) | w->enabled | (w->state == PRODUCE) << 1
                     | (w->blade[0].limit_sw && w->blade[1].limit_sw && w->blade[2].limit_sw) << 2
                     | (w->power > 1500.0f) << 3;
        w->status = s | (s & 0x0F) << 8;
        total += w->power;
        acc = acc * 3 + w->status + w->starts + w->faults * 5;
    }

    int best_idx = 0;
    for (int i = 1; i < WTGS; i++)
        if (park[i].power > park[best_idx].power)
            best_idx = i;
    best = park[best_idx];
    int k = n % 39;
    if (park[k].power < park[k + 1].power) {
        struct wtg tmp = park[k];
        park[k] = park[k + 1];
        park[k + 1] = tmp;
    }

    for (int i = 0; i < 6; i++)
        acc = acc * 7 + count[i];
    check = (int32_t)((uint32_t)check * 31u + acc + (uint32_t)(int32_t)lrintf(total)
                      + (uint32_t)(int32_t)lrintf(best.blade[0].battery * 10.0f) + best.starts + best_idx + 1);
}
