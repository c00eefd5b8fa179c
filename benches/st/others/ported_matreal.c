#include "st.h"
#include <xmmintrin.h>
typedef struct { float rows[32][32]; float norm; } matrix;
static matrix a, b, r;
static int scans;
static int mat_mul(const matrix *a, const matrix *b, matrix *r) {
    int i;
    for (i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) {
            float s = 0.0f;
            for (int k = 0; k < 32; k++) s += a->rows[i][k] * b->rows[k][j];
            r->rows[i][j] = s;
        }
    return i;
}
static float mat_norm(matrix *m) {
    float s = 0.0f;
    for (int i = 0; i < 32; i++)
        for (int j = 0; j < 32; j++) s += m->rows[i][j] * m->rows[i][j];
    return m->norm = _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(s)));
}
void scan(void) {
    if (++scans == 1)
        for (int i = 0; i < 32; i++)
            for (int j = 0; j < 32; j++) {
                a.rows[i][j] = (float)(i + j) / 8.0f;
                b.rows[i][j] = (float)(i - j) / 16.0f;
            }
    a.rows[scans % 32][scans % 29] = (float)(scans % 50);
    int rc = mat_mul(&a, &b, &r);
    check = (check + rc + (int)mat_norm(&r) + (int)r.rows[scans % 32][7]) % 999983;
}
