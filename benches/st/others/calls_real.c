#include "st.h"
struct channel { int16_t raw; float low, high, value; uint8_t alarm; };
struct measure { float factor; int16_t count; };
static struct channel chs[201];
static struct measure ms[201];
static int32_t scans;
static float scale(int16_t raw, float low, float high) { return raw / 27648.0f * (high - low) + low; }
static float filter(float old, float new, float factor) { return old + (new - old) * factor; }
static void measure(struct measure *m, struct channel *ch)
{
    ch->value = filter(ch->value, scale(ch->raw, ch->low, ch->high), m->factor);
    ch->alarm = ch->value > ch->high * 0.9f || ch->value < ch->low + 1.0f;
    if (ch->alarm) { m->count++; if (m->count > 1000) m->count = 0; }
}
void scan(void)
{
    for (int i = 1; i <= 200; i++) {
        chs[i].raw = (scans * 37 + i * 113) % 27648; chs[i].low = 0; chs[i].high = 100;
        ms[i].factor = 0.1f;
        measure(&ms[i], &chs[i]);
        if (chs[i].alarm) check++;
    }
    check += (int32_t)chs[100].value;
    scans++;
}
