#include "st.h"
#include <stdbool.h>
struct vec3 { float x, y, z; };
struct body { struct vec3 pos, vel; float mass; unsigned hits; bool alive; };
struct world { struct body bodies[150]; struct vec3 size, total; unsigned count; };
static struct world w;
static int scans;
static bool ok;

static bool vec_add_scaled(struct vec3 *a, const struct vec3 *b, float s) {
    a->x = a->x + b->x * s;
    a->y = a->y + b->y * s;
    a->z = a->z + b->z * s;
    return true;
}
static unsigned bounce(struct body *b, const struct vec3 *size) {
    unsigned n = 0;
    if (b->pos.x < 0.0f || b->pos.x > size->x) { b->vel.x = -b->vel.x; n++; }
    if (b->pos.y < 0.0f || b->pos.y > size->y) { b->vel.y = -b->vel.y; n++; }
    if (b->pos.z < 0.0f || b->pos.z > size->z) { b->vel.z = -b->vel.z; n++; }
    b->hits += n;
    return n;
}
void scan(void) {
    if (++scans == 1) {
        w.count = 150;
        w.size = (struct vec3){ 100.0f, 80.0f, 60.0f };
        for (unsigned i = 0; i < w.count; i++) {
            struct body *b = &w.bodies[i];
            b->pos = (struct vec3){ i * 7 % 100, i * 11 % 80, i * 13 % 60 };
            b->vel = (struct vec3){ (float)(i % 9) - 4.0f, (float)(i % 7) - 3.0f, (float)(i % 5) - 2.0f };
            b->mass = 1.0f + (float)(i % 4);
            b->alive = true;
        }
    }
    w.total = (struct vec3){ 0 };
    unsigned hits = 0, alive = 0;
    for (unsigned i = 0; i < w.count; i++) {
        struct body *b = &w.bodies[i];
        if (b->alive) {
            ok = vec_add_scaled(&b->pos, &b->vel, 0.25f);
            hits += bounce(b, &w.size);
            ok = vec_add_scaled(&w.total, &b->pos, b->mass);
            if (b->hits > 30) b->alive = false;
            alive++;
        } else if ((scans + (int)i) % 50 == 0) {
            b->alive = ok;
            b->hits = 0;
        }
    }
    check = (check + (int)w.total.x + (int)w.total.y * 2 + (int)w.total.z * 3 + (int)hits + (int)alive) % 999983;
}
