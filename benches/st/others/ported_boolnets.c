#include "st.h"
#include <stdbool.h>
#include <stdint.h>
struct gate { uint16_t kind, in1, in2; };
static struct gate gates[256];
static bool nets[320];
static unsigned seed = 4711;
static int scans;
static unsigned next_random(unsigned *s) { return *s = (*s * 1103 + 12345) % 65536; }
void scan(void) {
    if (++scans == 1)
        for (unsigned i = 0; i < 256; i++) {
            gates[i].kind = next_random(&seed) / 16 % 5;
            gates[i].in1 = next_random(&seed) / 16 % (i + 64);
            gates[i].in2 = next_random(&seed) / 16 % (i + 64);
        }
    for (int i = 0; i < 64; i++) nets[i] = next_random(&seed) >= 32768;
    int hash = 0;
    for (int i = 0; i < 256; i++) {
        bool a = nets[gates[i].in1], b = nets[gates[i].in2], q;
        switch (gates[i].kind) {
        case 0: q = !(a && b); break;
        case 1: q = !(a || b); break;
        case 2: q = a ^ b; break;
        case 3: q = a && b; break;
        default: q = a || b;
        }
        nets[i + 64] = q;
        if (q) hash += i;
    }
    check = (check * 5 + hash) % 999983;
}
