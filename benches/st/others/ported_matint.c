#include "st.h"
#include <stdint.h>
static int16_t a[1024], b[1024];
static int32_t c[1024];
static int scans;
static int mat_init(int seed) {
    int i;
    for (i = 0; i < 1024; i++) {
        a[i] = (i * 7 + seed) % 101 - 50;
        b[i] = (i * 13 + seed) % 97 - 48;
    }
    return i;
}
void scan(void) {
    int n = mat_init(++scans);
    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) {
            int sum = 0;
            for (int k = 0; k < 32; k++) sum += a[i * 32 + k] * b[k * 32 + j];
            c[i * 32 + j] = sum;
        }
    int hash = 0;
    for (int i = 0; i < n; i += 33) hash = (hash + c[i]) % 65521;
    for (int i = 0; i < n; i++) hash += c[i] % 16;
    check = (check + hash) % 999983;
}
