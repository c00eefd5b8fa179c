#include "st.h"
#include <stdbool.h>

typedef struct { float gain, offset; } Calibration;
typedef struct { int16_t raw; float value, low, high; Calibration cal; } Sensor;
typedef struct { Sensor sensors[4]; float average; int32_t faults; bool enabled; } Cell;
typedef struct { Cell cells[8]; int16_t hottest; float total; } LineData;
typedef struct { int32_t scan_no; int16_t line_no; Cell worst; } Snapshot;

static bool ready;
static int32_t tick;
static LineData lines[30];
static Snapshot history[16];
static int16_t slot;

void scan(void)
{
    if (!ready) {
        ready = true;
        for (int l = 0; l < 30; l++) {
            for (int c = 0; c < 8; c++) {
                lines[l].cells[c].enabled = (l + 1 + c + 1) % 5 != 0;
                for (int s = 0; s < 4; s++) {
                    lines[l].cells[c].sensors[s].raw = (l + 1) * 100 + (c + 1) * 37 + (s + 1) * 5;
                    lines[l].cells[c].sensors[s].cal.gain = 0.1f + (float)(s + 1) * 0.01f;
                    lines[l].cells[c].sensors[s].cal.offset = (float)(c + 1) * 0.5f;
                    lines[l].cells[c].sensors[s].low = 1000.0f;
                }
            }
        }
    }
    tick++;
    if (tick >= 30000)
        tick = 0;
    int32_t sum = 0;
    for (int l = 0; l < 30; l++) {
        LineData *line = &lines[l];
        line->total = 0.0f;
        float best = -1.0f;
        for (int c = 0; c < 8; c++) {
            Cell *cell = &line->cells[c];
            if (cell->enabled) {
                float acc = 0.0f;
                for (int s = 0; s < 4; s++) {
                    Sensor *x = &cell->sensors[s];
                    x->raw = (x->raw + 7 * (s + 1) + (c + 1)) % 1000;
                    x->value = (float)x->raw * x->cal.gain + x->cal.offset;
                    if (x->value > x->high)
                        x->high = x->value;
                    if (x->value < x->low)
                        x->low = x->value;
                    if (x->value > 120.0f)
                        cell->faults++;
                    acc += x->value;
                }
                cell->average = acc / 4.0f;
                line->total += cell->average;
                if (cell->average > best) {
                    best = cell->average;
                    line->hottest = c + 1;
                }
            }
        }
        /* keep the hottest cell of the line */
        history[slot].scan_no = tick;
        history[slot].line_no = l + 1;
        history[slot].worst = line->cells[line->hottest - 1];
        slot = (slot + 1) % 16;
        sum += (int32_t)(line->total * 10.0f) + line->hottest;
    }
    for (int s = 0; s < 16; s++)
        sum += history[s].scan_no + history[s].line_no + history[s].worst.sensors[1].raw
            + history[s].worst.faults % 1000 + (int32_t)history[s].worst.sensors[3].high;
    check = (int32_t)((uint32_t)check * 11u + (uint32_t)sum);
}
