/* 64 PID loops, each with a controlled tank (first-order lag) of its own. */
#include <stdbool.h>
#include "st.h"

#define LOOPS 64
#define CYCLE_TIME 0.01f

typedef enum { MANUAL, AUTOMATIC, HOLD } PidMode;

typedef struct {
    float proportional;
    float integral;
    float derivative;
    float low_limit;
    float high_limit;
} PidTuning;

typedef struct {
    float output;
    bool saturated;
    float last_measured;
    float integral;
} Pid;

typedef struct {
    float level;
} Tank;

static float clamp(float value, float low, float high)
{
    if (value < low)
        return low;
    if (value > high)
        return high;
    return value;
}

static void pid_step(Pid *pid, float setpoint, float measured, PidMode mode,
                     float manual_output, const PidTuning *tuning)
{
    float error = setpoint - measured;
    switch (mode) {
    case MANUAL:
        pid->output = clamp(manual_output, tuning->low_limit, tuning->high_limit);
        pid->integral = pid->output;
        pid->saturated = false;
        break;
    case AUTOMATIC: {
        /* The derivative acts on the measurement, lest a step of the setpoint kicks. */
        float slope = (pid->last_measured - measured) / CYCLE_TIME;
        pid->integral = clamp(pid->integral + error * tuning->integral * CYCLE_TIME,
                              tuning->low_limit, tuning->high_limit);
        float wanted = tuning->proportional * error + pid->integral + tuning->derivative * slope;
        pid->output = clamp(wanted, tuning->low_limit, tuning->high_limit);
        pid->saturated = pid->output != wanted;
        break;
    }
    default:
        /* Hold: the output stays as it is. */
        pid->saturated = false;
        break;
    }
    pid->last_measured = measured;
}

static void tank_step(Tank *tank, float inflow, float gain, float time_constant)
{
    tank->level = tank->level + (gain * inflow - tank->level) * 0.01f / time_constant;
}

static Pid controller[LOOPS];
static Tank tank[LOOPS];
static PidTuning tuning[LOOPS];
static float gain[LOOPS];
static float time_constant[LOOPS];
static bool initialised;
static int32_t scan_count;

void scan(void)
{
    if (!initialised) {
        for (int i = 0; i < LOOPS; i++) {
            tuning[i].proportional = 1.5f + (float)(i % 8) * 0.25f;
            tuning[i].integral = 0.8f + (float)(i % 5) * 0.3f;
            tuning[i].derivative = 0.01f * (float)(i % 3);
            tuning[i].low_limit = 0.0f;
            tuning[i].high_limit = 100.0f - (float)i * 0.5f;
            gain[i] = 0.9f + (float)(i % 7) * 0.05f;
            time_constant[i] = 0.3f + (float)(i % 11) * 0.1f;
            tank[i].level = 10.0f;
        }
        initialised = true;
    }

    scan_count++;
    int32_t sum = 0;
    for (int i = 0; i < LOOPS; i++) {
        /* The setpoint is a staircase; now and then a loop is taken out of automatic. */
        float target = 20.0f + (float)((scan_count / 40 + i) % 9) * 7.5f;
        PidMode mode;
        switch ((scan_count / 50 + i) % 16) {
        case 0:
            mode = MANUAL;
            break;
        case 7:
        case 8:
            mode = HOLD;
            break;
        default:
            mode = AUTOMATIC;
            break;
        }

        pid_step(&controller[i], target, tank[i].level, mode, 35.0f, &tuning[i]);
        tank_step(&tank[i], controller[i].output, gain[i], time_constant[i]);

        sum += (int32_t)(controller[i].output * 100.0f) + (int32_t)(tank[i].level * 10.0f);
        if (controller[i].saturated)
            sum++;
    }
    check = (check * 31 + sum) % 1000003;
}
