/* Course unit 6: 64 control loops with PID controller and simulated plant. */
#include "st.h"
#include <stdbool.h>

static float clamp(float low, float value, float high)
{
    if (value < low)
        return low;
    else if (value > high)
        return high;
    return value;
}

static float dead_band(float value, float width)
{
    if (value > width)
        return value - width;
    else if (value < -width)
        return value + width;
    return 0.0f;
}

typedef struct {
    float setpoint, actual, kp, tn, tv, cycle, y_min, y_max, y_manual;
    bool manual;
    float y;
    bool limited;
    float error, error_old, integral, derivative, unlimited;
} PidController;

static void pid_controller(PidController *p)
{
    p->error = dead_band(p->setpoint - p->actual, 0.05f);
    p->derivative = 0.5f * p->derivative + 0.5f * (p->error - p->error_old) / p->cycle;
    p->error_old = p->error;
    if (p->manual) {
        p->y = clamp(p->y_min, p->y_manual, p->y_max);
        p->integral = p->y - p->kp * p->error;
        p->limited = false;
    } else {
        p->unlimited = p->kp * (p->error + p->tv * p->derivative) + p->integral;
        p->y = clamp(p->y_min, p->unlimited, p->y_max);
        p->limited = p->y != p->unlimited;
        if (!p->limited)
            p->integral = p->integral + p->kp * p->error * p->cycle / p->tn;
    }
}

typedef struct { float x; } FirstOrderPlant;

static void first_order_plant(FirstOrderPlant *p, float u, float gain, float time_constant, float cycle, float disturbance)
{
    p->x = p->x + (gain * u + disturbance - p->x) * cycle / time_constant;
}

static int16_t scan_no;
static bool ready;
static PidController controllers[64];
static FirstOrderPlant plants[64];
static float setpoints[64], gains[64], tns[64];

void scan(void)
{
    if (!ready) {
        for (int i = 0; i < 64; i++) {
            setpoints[i] = 20.0f + (float)i;
            gains[i] = 0.5f + (float)(i % 8) * 0.25f;
            tns[i] = 0.2f + (float)(i % 5) * 0.1f;
            controllers[i].cycle = 0.01f;
            controllers[i].y_max = 100.0f;
        }
        ready = true;
    }
    scan_no = (int16_t)((scan_no + 1) % 2000);
    if (scan_no % 500 == 0)
        for (int i = 0; i < 64; i++)
            setpoints[i] = 100.0f - setpoints[i];
    float load = (float)(scan_no % 100) * 0.02f;

    float sum = 0.0f;
    int32_t limited_count = 0;
    for (int i = 0; i < 64; i++) {
        PidController *p = &controllers[i];
        p->setpoint = setpoints[i];
        p->actual = plants[i].x;
        p->kp = gains[i];
        p->tn = tns[i];
        p->tv = 0.01f;
        p->manual = i % 16 == 3 && scan_no < 100;
        p->y_manual = 40.0f;
        pid_controller(p);
        first_order_plant(&plants[i], p->y, 1.2f, 0.5f, 0.01f, load);
        sum += plants[i].x;
        if (p->limited)
            limited_count++;
    }
    check = (check * 31 + (int32_t)(sum * 10.0f) + limited_count) % 1000003;
}
