#include "st.h"
struct pid_param { float kp, ki, kd, out_limit; };
struct pid_state { float integ, prev_err, d_filt, out; };
struct pid { struct pid_param par; struct pid_state st; };
struct axis { struct pid ctl; float pos, vel, ref; };
static struct axis axes[64];
static int scans;

static float pid_step(struct pid *p, float err, float dt) {
    float d = (err - p->st.prev_err) / dt;
    p->st.d_filt = p->st.d_filt + 0.3f * (d - p->st.d_filt);
    p->st.prev_err = err;
    float u = p->par.kp * err + p->st.integ + p->par.kd * p->st.d_filt;
    if (u > p->par.out_limit) u = p->par.out_limit;
    else if (u < -p->par.out_limit) u = -p->par.out_limit;
    else p->st.integ = p->st.integ + p->par.ki * err * dt;
    p->st.out = u;
    return u;
}
static int axis_step(struct axis *ax, float dt) {
    float force = pid_step(&ax->ctl, ax->ref - ax->pos, dt);
    ax->vel = ax->vel + (force - 2.0f * ax->vel) * dt;
    ax->pos = ax->pos + ax->vel * dt;
    return 0;
}
void scan(void) {
    if (++scans == 1)
        for (unsigned i = 0; i < 64; i++) {
            struct pid_param *p = &axes[i].ctl.par;
            p->kp = 8.0f + (float)i * 0.05f;
            p->ki = 1.5f;
            p->kd = 0.4f;
            p->out_limit = 50.0f;
        }
    float acc = 0.0f;
    int rc = 0;
    for (int i = 0; i < 64; i++) {
        if (scans % 300 == 1) axes[i].ref = (float)((scans / 3 + i * 5) % 40);
        rc = axis_step(&axes[i], 0.01f);
        acc = acc + axes[i].pos + axes[i].ctl.st.out;
    }
    check = (check + (int)acc + rc) % 999983;
}
