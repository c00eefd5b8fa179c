/* Forty heating zones with five function blocks each: 200 calls a scan, with functions */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include "st.h"

#define ZONES 40

struct heating_curve { float flow_setpoint, damped_outside; bool summer; };
struct time_program { bool comfort, last; int16_t switchings; };
struct mixing_valve { float position, integral; };
struct circulation_pump { bool running, last; float speed; int32_t starts; };
struct supervision { uint16_t alarms, last; int32_t count; };

struct zone {
    struct heating_curve curve;
    struct time_program program;
    struct mixing_valve valve;
    struct circulation_pump pump;
    struct supervision supervision;
    float flow_temperature;
};

static struct zone zones[ZONES];
static int minute, day;
static bool initialized;

static inline float clampf(float lo, float x, float hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static inline float scale_linear(float x, float in_lo, float in_hi, float out_lo, float out_hi)
{
    if (x <= in_lo)
        return out_lo;
    if (x >= in_hi)
        return out_hi;
    return out_lo + (x - in_lo) * (out_hi - out_lo) / (in_hi - in_lo);
}

static inline bool hysteresis(float x, float on, float off, bool state)
{
    return x > on || (state && x > off);
}

static inline float ramp_limit(float target, float current, float max_delta)
{
    return current + clampf(-max_delta, target - current, max_delta);
}

static inline uint16_t pack_alarms(bool hot, bool cold, bool sensor, bool valve)
{
    return (uint16_t)(hot << 0 | cold << 1 | sensor << 2 | valve << 3);
}

static void heating_curve_step(struct heating_curve *c, float outside, float slope, bool night)
{
    c->damped_outside += (outside - c->damped_outside) * 0.05f;
    c->summer = hysteresis(c->damped_outside, 17.0f, 15.0f, c->summer);
    c->flow_setpoint = scale_linear(c->damped_outside, -15.0f, 20.0f, 20.0f + slope * 40.0f, 25.0f);
    if (night)
        c->flow_setpoint -= 8.0f;
    if (c->summer)
        c->flow_setpoint = 10.0f;
}

static void time_program_step(struct time_program *t, int now, int start, int end)
{
    if (start <= end)
        t->comfort = now >= start && now < end;
    else
        t->comfort = now >= start || now < end;
    if (t->comfort != t->last) {
        t->switchings = (int16_t)((t->switchings + 1) % 1000);
        t->last = t->comfort;
    }
}

static void mixing_valve_step(struct mixing_valve *v, float setpoint, float actual, bool release)
{
    if (release) {
        v->integral = clampf(0.0f, v->integral + (setpoint - actual) * 0.02f, 100.0f);
        v->position = ramp_limit(clampf(0.0f, (setpoint - actual) * 3.0f + v->integral, 100.0f), v->position, 1.5f);
    } else {
        v->integral = 0.0f;
        v->position = ramp_limit(0.0f, v->position, 1.5f);
    }
}

static void circulation_pump_step(struct circulation_pump *p, float valve, bool release)
{
    p->running = release && hysteresis(valve, 5.0f, 2.0f, p->running);
    if (p->running && !p->last)
        p->starts++;
    p->last = p->running;
    p->speed = p->running ? scale_linear(valve, 5.0f, 90.0f, 30.0f, 100.0f) : 0.0f;
}

static void supervision_step(struct supervision *s, float temperature, float setpoint, float valve, bool running)
{
    s->alarms = pack_alarms(temperature > setpoint + 6.0f,
                            temperature < setpoint - 6.0f && running,
                            temperature < -40.0f || temperature > 90.0f,
                            valve > 95.0f && !running);
    if (s->alarms & ~s->last)
        s->count++;
    s->last = s->alarms;
}

void scan(void)
{
    if (!initialized) {
        for (int i = 0; i < ZONES; i++) {
            zones[i].curve.damped_outside = 5.0f;
            zones[i].flow_temperature = 22.0f;
        }
        initialized = true;
    }

    if (++minute >= 1440) {
        minute = 0;
        day = (day + 1) % 7;
    }
    float outside = scale_linear((float)abs(720 - minute), 0.0f, 720.0f, 21.0f, -12.0f) + (float)day;

    uint32_t sum = (uint32_t)check;
    for (int i = 0; i < ZONES; i++) {
        struct zone *z = &zones[i];
        int n = i + 1;

        time_program_step(&z->program, minute, (n * 37) % 1440, (n * 37 + 600 + day * 10) % 1440);
        heating_curve_step(&z->curve, outside + (float)(n % 4) * 0.25f, 0.8f + (float)(n % 6) * 0.1f,
                           !z->program.comfort);
        bool release = !z->curve.summer;
        mixing_valve_step(&z->valve, z->curve.flow_setpoint, z->flow_temperature, release);
        circulation_pump_step(&z->pump, z->valve.position, release);
        supervision_step(&z->supervision, z->flow_temperature, z->curve.flow_setpoint, z->valve.position,
                         z->pump.running);

        z->flow_temperature = z->flow_temperature
                              + (20.0f + z->valve.position * 0.5f - z->flow_temperature) * 0.02f
                              - z->pump.speed * 0.0005f;

        sum = sum * 31u
              + (uint32_t)(int32_t)lrintf(z->flow_temperature * 100.0f)
              + (uint32_t)(int32_t)lrintf(z->pump.speed * 10.0f)
              + (uint32_t)z->pump.starts
              + (uint32_t)z->supervision.count * 8u
              + z->supervision.alarms
              + (uint32_t)z->program.switchings;
    }
    check = (int32_t)sum;
}
