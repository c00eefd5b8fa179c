#include <stdbool.h>
#include "st.h"
typedef struct { int32_t power; int16_t running, starts; int32_t limit_kw; bool hold; } area_t;
typedef struct { bool on; int16_t speed; } motor_t;
static bool permit(int32_t now, int32_t add, int32_t limit, int16_t prio) { return now + add <= limit - prio * 5; }
static int32_t load(int32_t rated, int16_t speed)
{
    int32_t s = speed;
    return rated * s / 100 + s * s / 500;
}
static int16_t ramp_to(int16_t cur, int16_t target, int16_t up, int16_t down)
{
    if (cur < target)
        return cur + up < target ? (int16_t)(cur + up) : target;
    return cur - down > target ? (int16_t)(cur - down) : target;
}
static void motor(motor_t *m, bool call, int32_t rated, int16_t prio, area_t *area)
{
    if (call && !m->on && !area->hold) {
        m->on = permit(area->power, rated, area->limit_kw, prio);
        if (m->on)
            area->starts++;
    } else if (!call) {
        m->on = false;
    }
    if (m->on) {
        m->speed = ramp_to(m->speed, (int16_t)(100 - prio), 4, 6);
        area->running++;
    } else {
        m->speed = ramp_to(m->speed, 0, 4, 6);
    }
    area->power += load(rated, m->speed);
}
static int32_t t;
static area_t feed;
static motor_t feed_m01, feed_m02, feed_m03, feed_m04, feed_m05;
static motor_t feed_m06, feed_m07, feed_m08, feed_m09, feed_m10;
static motor_t feed_m11, feed_m12, feed_m13, feed_m14, feed_m15;
static motor_t feed_m16, feed_m17, feed_m18, feed_m19, feed_m20;
static motor_t feed_m21, feed_m22, feed_m23, feed_m24, feed_m25;
static area_t mill;
static motor_t mill_m01, mill_m02, mill_m03, mill_m04, mill_m05;
static motor_t mill_m06, mill_m07, mill_m08, mill_m09, mill_m10;
static motor_t mill_m11, mill_m12, mill_m13, mill_m14, mill_m15;
static motor_t mill_m16, mill_m17, mill_m18, mill_m19, mill_m20;
static motor_t mill_m21, mill_m22, mill_m23, mill_m24, mill_m25;
static area_t bake;
static motor_t bake_m01, bake_m02, bake_m03, bake_m04, bake_m05;
static motor_t bake_m06, bake_m07, bake_m08, bake_m09, bake_m10;
static motor_t bake_m11, bake_m12, bake_m13, bake_m14, bake_m15;
static motor_t bake_m16, bake_m17, bake_m18, bake_m19, bake_m20;
static motor_t bake_m21, bake_m22, bake_m23, bake_m24, bake_m25;
static area_t cool;
static motor_t cool_m01, cool_m02, cool_m03, cool_m04, cool_m05;
static motor_t cool_m06, cool_m07, cool_m08, cool_m09, cool_m10;
static motor_t cool_m11, cool_m12, cool_m13, cool_m14, cool_m15;
static motor_t cool_m16, cool_m17, cool_m18, cool_m19, cool_m20;
static motor_t cool_m21, cool_m22, cool_m23, cool_m24, cool_m25;
static area_t pack;
static motor_t pack_m01, pack_m02, pack_m03, pack_m04, pack_m05;
static motor_t pack_m06, pack_m07, pack_m08, pack_m09, pack_m10;
static motor_t pack_m11, pack_m12, pack_m13, pack_m14, pack_m15;
static motor_t pack_m16, pack_m17, pack_m18, pack_m19, pack_m20;
static motor_t pack_m21, pack_m22, pack_m23, pack_m24, pack_m25;
static area_t store;
static motor_t store_m01, store_m02, store_m03, store_m04, store_m05;
static motor_t store_m06, store_m07, store_m08, store_m09, store_m10;
static motor_t store_m11, store_m12, store_m13, store_m14, store_m15;
static motor_t store_m16, store_m17, store_m18, store_m19, store_m20;
static motor_t store_m21, store_m22, store_m23, store_m24, store_m25;
static area_t wash;
static motor_t wash_m01, wash_m02, wash_m03, wash_m04, wash_m05;
static motor_t wash_m06, wash_m07, wash_m08, wash_m09, wash_m10;
static motor_t wash_m11, wash_m12, wash_m13, wash_m14, wash_m15;
static motor_t wash_m16, wash_m17, wash_m18, wash_m19, wash_m20;
static motor_t wash_m21, wash_m22, wash_m23, wash_m24, wash_m25;
static area_t util;
static motor_t util_m01, util_m02, util_m03, util_m04, util_m05;
static motor_t util_m06, util_m07, util_m08, util_m09, util_m10;
static motor_t util_m11, util_m12, util_m13, util_m14, util_m15;
static motor_t util_m16, util_m17, util_m18, util_m19, util_m20;
static motor_t util_m21, util_m22, util_m23, util_m24, util_m25;
void scan(void)
{
    uint32_t pattern;
    t = (t + 1) % 100000;
    pattern = (uint32_t)(t / 24) * 2654435761u;

    /* area feed */
    feed.power = 0;
    feed.running = 0;
    feed.limit_kw = 400;
    feed.hold = (pattern >> 20) & 1;
    motor(&feed_m01, (pattern >> 5) & 1, 15, 1, &feed);
    motor(&feed_m02, (pattern >> 10) & 1, 22, 2, &feed);
    motor(&feed_m03, (pattern >> 15) & 1, 29, 3, &feed);
    motor(&feed_m04, (pattern >> 20) & 1, 36, 4, &feed);
    motor(&feed_m05, (pattern >> 25) & 1, 13, 5, &feed);
    motor(&feed_m06, (pattern >> 30) & 1, 20, 6, &feed);
    motor(&feed_m07, (pattern >> 3) & 1, 27, 7, &feed);
    motor(&feed_m08, (pattern >> 8) & 1, 34, 8, &feed);
    motor(&feed_m09, (pattern >> 13) & 1, 11, 9, &feed);
    motor(&feed_m10, (pattern >> 18) & 1, 18, 0, &feed);
    motor(&feed_m11, (pattern >> 23) & 1, 25, 1, &feed);
    motor(&feed_m12, (pattern >> 28) & 1, 32, 2, &feed);
    motor(&feed_m13, (pattern >> 1) & 1, 9, 3, &feed);
    motor(&feed_m14, (pattern >> 6) & 1, 16, 4, &feed);
    motor(&feed_m15, (pattern >> 11) & 1, 23, 5, &feed);
    motor(&feed_m16, (pattern >> 16) & 1, 30, 6, &feed);
    motor(&feed_m17, (pattern >> 21) & 1, 37, 7, &feed);
    motor(&feed_m18, (pattern >> 26) & 1, 14, 8, &feed);
    motor(&feed_m19, (pattern >> 31) & 1, 21, 9, &feed);
    motor(&feed_m20, (pattern >> 4) & 1, 28, 0, &feed);
    motor(&feed_m21, (pattern >> 9) & 1, 35, 1, &feed);
    motor(&feed_m22, (pattern >> 14) & 1, 12, 2, &feed);
    motor(&feed_m23, (pattern >> 19) & 1, 19, 3, &feed);
    motor(&feed_m24, (pattern >> 24) & 1, 26, 4, &feed);
    motor(&feed_m25, (pattern >> 29) & 1, 33, 5, &feed);

    /* area mill */
    mill.power = 0;
    mill.running = 0;
    mill.limit_kw = 440;
    mill.hold = (pattern >> 21) & 1;
    motor(&mill_m01, (pattern >> 8) & 1, 16, 2, &mill);
    motor(&mill_m02, (pattern >> 13) & 1, 23, 3, &mill);
    motor(&mill_m03, (pattern >> 18) & 1, 30, 4, &mill);
    motor(&mill_m04, (pattern >> 23) & 1, 37, 5, &mill);
    motor(&mill_m05, (pattern >> 28) & 1, 14, 6, &mill);
    motor(&mill_m06, (pattern >> 1) & 1, 21, 7, &mill);
    motor(&mill_m07, (pattern >> 6) & 1, 28, 8, &mill);
    motor(&mill_m08, (pattern >> 11) & 1, 35, 9, &mill);
    motor(&mill_m09, (pattern >> 16) & 1, 12, 0, &mill);
    motor(&mill_m10, (pattern >> 21) & 1, 19, 1, &mill);
    motor(&mill_m11, (pattern >> 26) & 1, 26, 2, &mill);
    motor(&mill_m12, (pattern >> 31) & 1, 33, 3, &mill);
    motor(&mill_m13, (pattern >> 4) & 1, 10, 4, &mill);
    motor(&mill_m14, (pattern >> 9) & 1, 17, 5, &mill);
    motor(&mill_m15, (pattern >> 14) & 1, 24, 6, &mill);
    motor(&mill_m16, (pattern >> 19) & 1, 31, 7, &mill);
    motor(&mill_m17, (pattern >> 24) & 1, 8, 8, &mill);
    motor(&mill_m18, (pattern >> 29) & 1, 15, 9, &mill);
    motor(&mill_m19, (pattern >> 2) & 1, 22, 0, &mill);
    motor(&mill_m20, (pattern >> 7) & 1, 29, 1, &mill);
    motor(&mill_m21, (pattern >> 12) & 1, 36, 2, &mill);
    motor(&mill_m22, (pattern >> 17) & 1, 13, 3, &mill);
    motor(&mill_m23, (pattern >> 22) & 1, 20, 4, &mill);
    motor(&mill_m24, (pattern >> 27) & 1, 27, 5, &mill);
    motor(&mill_m25, (pattern >> 0) & 1, 34, 6, &mill);

    /* area bake */
    bake.power = 0;
    bake.running = 0;
    bake.limit_kw = 480;
    bake.hold = (pattern >> 22) & 1;
    motor(&bake_m01, (pattern >> 11) & 1, 17, 3, &bake);
    motor(&bake_m02, (pattern >> 16) & 1, 24, 4, &bake);
    motor(&bake_m03, (pattern >> 21) & 1, 31, 5, &bake);
    motor(&bake_m04, (pattern >> 26) & 1, 8, 6, &bake);
    motor(&bake_m05, (pattern >> 31) & 1, 15, 7, &bake);
    motor(&bake_m06, (pattern >> 4) & 1, 22, 8, &bake);
    motor(&bake_m07, (pattern >> 9) & 1, 29, 9, &bake);
    motor(&bake_m08, (pattern >> 14) & 1, 36, 0, &bake);
    motor(&bake_m09, (pattern >> 19) & 1, 13, 1, &bake);
    motor(&bake_m10, (pattern >> 24) & 1, 20, 2, &bake);
    motor(&bake_m11, (pattern >> 29) & 1, 27, 3, &bake);
    motor(&bake_m12, (pattern >> 2) & 1, 34, 4, &bake);
    motor(&bake_m13, (pattern >> 7) & 1, 11, 5, &bake);
    motor(&bake_m14, (pattern >> 12) & 1, 18, 6, &bake);
    motor(&bake_m15, (pattern >> 17) & 1, 25, 7, &bake);
    motor(&bake_m16, (pattern >> 22) & 1, 32, 8, &bake);
    motor(&bake_m17, (pattern >> 27) & 1, 9, 9, &bake);
    motor(&bake_m18, (pattern >> 0) & 1, 16, 0, &bake);
    motor(&bake_m19, (pattern >> 5) & 1, 23, 1, &bake);
    motor(&bake_m20, (pattern >> 10) & 1, 30, 2, &bake);
    motor(&bake_m21, (pattern >> 15) & 1, 37, 3, &bake);
    motor(&bake_m22, (pattern >> 20) & 1, 14, 4, &bake);
    motor(&bake_m23, (pattern >> 25) & 1, 21, 5, &bake);
    motor(&bake_m24, (pattern >> 30) & 1, 28, 6, &bake);
    motor(&bake_m25, (pattern >> 3) & 1, 35, 7, &bake);

    /* area cool */
    cool.power = 0;
    cool.running = 0;
    cool.limit_kw = 520;
    cool.hold = (pattern >> 23) & 1;
    motor(&cool_m01, (pattern >> 14) & 1, 18, 4, &cool);
    motor(&cool_m02, (pattern >> 19) & 1, 25, 5, &cool);
    motor(&cool_m03, (pattern >> 24) & 1, 32, 6, &cool);
    motor(&cool_m04, (pattern >> 29) & 1, 9, 7, &cool);
    motor(&cool_m05, (pattern >> 2) & 1, 16, 8, &cool);
    motor(&cool_m06, (pattern >> 7) & 1, 23, 9, &cool);
    motor(&cool_m07, (pattern >> 12) & 1, 30, 0, &cool);
    motor(&cool_m08, (pattern >> 17) & 1, 37, 1, &cool);
    motor(&cool_m09, (pattern >> 22) & 1, 14, 2, &cool);
    motor(&cool_m10, (pattern >> 27) & 1, 21, 3, &cool);
    motor(&cool_m11, (pattern >> 0) & 1, 28, 4, &cool);
    motor(&cool_m12, (pattern >> 5) & 1, 35, 5, &cool);
    motor(&cool_m13, (pattern >> 10) & 1, 12, 6, &cool);
    motor(&cool_m14, (pattern >> 15) & 1, 19, 7, &cool);
    motor(&cool_m15, (pattern >> 20) & 1, 26, 8, &cool);
    motor(&cool_m16, (pattern >> 25) & 1, 33, 9, &cool);
    motor(&cool_m17, (pattern >> 30) & 1, 10, 0, &cool);
    motor(&cool_m18, (pattern >> 3) & 1, 17, 1, &cool);
    motor(&cool_m19, (pattern >> 8) & 1, 24, 2, &cool);
    motor(&cool_m20, (pattern >> 13) & 1, 31, 3, &cool);
    motor(&cool_m21, (pattern >> 18) & 1, 8, 4, &cool);
    motor(&cool_m22, (pattern >> 23) & 1, 15, 5, &cool);
    motor(&cool_m23, (pattern >> 28) & 1, 22, 6, &cool);
    motor(&cool_m24, (pattern >> 1) & 1, 29, 7, &cool);
    motor(&cool_m25, (pattern >> 6) & 1, 36, 8, &cool);

    /* area pack */
    pack.power = 0;
    pack.running = 0;
    pack.limit_kw = 560;
    pack.hold = (pattern >> 24) & 1;
    motor(&pack_m01, (pattern >> 17) & 1, 19, 5, &pack);
    motor(&pack_m02, (pattern >> 22) & 1, 26, 6, &pack);
    motor(&pack_m03, (pattern >> 27) & 1, 33, 7, &pack);
    motor(&pack_m04, (pattern >> 0) & 1, 10, 8, &pack);
    motor(&pack_m05, (pattern >> 5) & 1, 17, 9, &pack);
    motor(&pack_m06, (pattern >> 10) & 1, 24, 0, &pack);
    motor(&pack_m07, (pattern >> 15) & 1, 31, 1, &pack);
    motor(&pack_m08, (pattern >> 20) & 1, 8, 2, &pack);
    motor(&pack_m09, (pattern >> 25) & 1, 15, 3, &pack);
    motor(&pack_m10, (pattern >> 30) & 1, 22, 4, &pack);
    motor(&pack_m11, (pattern >> 3) & 1, 29, 5, &pack);
    motor(&pack_m12, (pattern >> 8) & 1, 36, 6, &pack);
    motor(&pack_m13, (pattern >> 13) & 1, 13, 7, &pack);
    motor(&pack_m14, (pattern >> 18) & 1, 20, 8, &pack);
    motor(&pack_m15, (pattern >> 23) & 1, 27, 9, &pack);
    motor(&pack_m16, (pattern >> 28) & 1, 34, 0, &pack);
    motor(&pack_m17, (pattern >> 1) & 1, 11, 1, &pack);
    motor(&pack_m18, (pattern >> 6) & 1, 18, 2, &pack);
    motor(&pack_m19, (pattern >> 11) & 1, 25, 3, &pack);
    motor(&pack_m20, (pattern >> 16) & 1, 32, 4, &pack);
    motor(&pack_m21, (pattern >> 21) & 1, 9, 5, &pack);
    motor(&pack_m22, (pattern >> 26) & 1, 16, 6, &pack);
    motor(&pack_m23, (pattern >> 31) & 1, 23, 7, &pack);
    motor(&pack_m24, (pattern >> 4) & 1, 30, 8, &pack);
    motor(&pack_m25, (pattern >> 9) & 1, 37, 9, &pack);

    /* area store */
    store.power = 0;
    store.running = 0;
    store.limit_kw = 600;
    store.hold = (pattern >> 25) & 1;
    motor(&store_m01, (pattern >> 20) & 1, 20, 6, &store);
    motor(&store_m02, (pattern >> 25) & 1, 27, 7, &store);
    motor(&store_m03, (pattern >> 30) & 1, 34, 8, &store);
    motor(&store_m04, (pattern >> 3) & 1, 11, 9, &store);
    motor(&store_m05, (pattern >> 8) & 1, 18, 0, &store);
    motor(&store_m06, (pattern >> 13) & 1, 25, 1, &store);
    motor(&store_m07, (pattern >> 18) & 1, 32, 2, &store);
    motor(&store_m08, (pattern >> 23) & 1, 9, 3, &store);
    motor(&store_m09, (pattern >> 28) & 1, 16, 4, &store);
    motor(&store_m10, (pattern >> 1) & 1, 23, 5, &store);
    motor(&store_m11, (pattern >> 6) & 1, 30, 6, &store);
    motor(&store_m12, (pattern >> 11) & 1, 37, 7, &store);
    motor(&store_m13, (pattern >> 16) & 1, 14, 8, &store);
    motor(&store_m14, (pattern >> 21) & 1, 21, 9, &store);
    motor(&store_m15, (pattern >> 26) & 1, 28, 0, &store);
    motor(&store_m16, (pattern >> 31) & 1, 35, 1, &store);
    motor(&store_m17, (pattern >> 4) & 1, 12, 2, &store);
    motor(&store_m18, (pattern >> 9) & 1, 19, 3, &store);
    motor(&store_m19, (pattern >> 14) & 1, 26, 4, &store);
    motor(&store_m20, (pattern >> 19) & 1, 33, 5, &store);
    motor(&store_m21, (pattern >> 24) & 1, 10, 6, &store);
    motor(&store_m22, (pattern >> 29) & 1, 17, 7, &store);
    motor(&store_m23, (pattern >> 2) & 1, 24, 8, &store);
    motor(&store_m24, (pattern >> 7) & 1, 31, 9, &store);
    motor(&store_m25, (pattern >> 12) & 1, 8, 0, &store);

    /* area wash */
    wash.power = 0;
    wash.running = 0;
    wash.limit_kw = 640;
    wash.hold = (pattern >> 26) & 1;
    motor(&wash_m01, (pattern >> 23) & 1, 21, 7, &wash);
    motor(&wash_m02, (pattern >> 28) & 1, 28, 8, &wash);
    motor(&wash_m03, (pattern >> 1) & 1, 35, 9, &wash);
    motor(&wash_m04, (pattern >> 6) & 1, 12, 0, &wash);
    motor(&wash_m05, (pattern >> 11) & 1, 19, 1, &wash);
    motor(&wash_m06, (pattern >> 16) & 1, 26, 2, &wash);
    motor(&wash_m07, (pattern >> 21) & 1, 33, 3, &wash);
    motor(&wash_m08, (pattern >> 26) & 1, 10, 4, &wash);
    motor(&wash_m09, (pattern >> 31) & 1, 17, 5, &wash);
    motor(&wash_m10, (pattern >> 4) & 1, 24, 6, &wash);
    motor(&wash_m11, (pattern >> 9) & 1, 31, 7, &wash);
    motor(&wash_m12, (pattern >> 14) & 1, 8, 8, &wash);
    motor(&wash_m13, (pattern >> 19) & 1, 15, 9, &wash);
    motor(&wash_m14, (pattern >> 24) & 1, 22, 0, &wash);
    motor(&wash_m15, (pattern >> 29) & 1, 29, 1, &wash);
    motor(&wash_m16, (pattern >> 2) & 1, 36, 2, &wash);
    motor(&wash_m17, (pattern >> 7) & 1, 13, 3, &wash);
    motor(&wash_m18, (pattern >> 12) & 1, 20, 4, &wash);
    motor(&wash_m19, (pattern >> 17) & 1, 27, 5, &wash);
    motor(&wash_m20, (pattern >> 22) & 1, 34, 6, &wash);
    motor(&wash_m21, (pattern >> 27) & 1, 11, 7, &wash);
    motor(&wash_m22, (pattern >> 0) & 1, 18, 8, &wash);
    motor(&wash_m23, (pattern >> 5) & 1, 25, 9, &wash);
    motor(&wash_m24, (pattern >> 10) & 1, 32, 0, &wash);
    motor(&wash_m25, (pattern >> 15) & 1, 9, 1, &wash);

    /* area util */
    util.power = 0;
    util.running = 0;
    util.limit_kw = 680;
    util.hold = (pattern >> 27) & 1;
    motor(&util_m01, (pattern >> 26) & 1, 22, 8, &util);
    motor(&util_m02, (pattern >> 31) & 1, 29, 9, &util);
    motor(&util_m03, (pattern >> 4) & 1, 36, 0, &util);
    motor(&util_m04, (pattern >> 9) & 1, 13, 1, &util);
    motor(&util_m05, (pattern >> 14) & 1, 20, 2, &util);
    motor(&util_m06, (pattern >> 19) & 1, 27, 3, &util);
    motor(&util_m07, (pattern >> 24) & 1, 34, 4, &util);
    motor(&util_m08, (pattern >> 29) & 1, 11, 5, &util);
    motor(&util_m09, (pattern >> 2) & 1, 18, 6, &util);
    motor(&util_m10, (pattern >> 7) & 1, 25, 7, &util);
    motor(&util_m11, (pattern >> 12) & 1, 32, 8, &util);
    motor(&util_m12, (pattern >> 17) & 1, 9, 9, &util);
    motor(&util_m13, (pattern >> 22) & 1, 16, 0, &util);
    motor(&util_m14, (pattern >> 27) & 1, 23, 1, &util);
    motor(&util_m15, (pattern >> 0) & 1, 30, 2, &util);
    motor(&util_m16, (pattern >> 5) & 1, 37, 3, &util);
    motor(&util_m17, (pattern >> 10) & 1, 14, 4, &util);
    motor(&util_m18, (pattern >> 15) & 1, 21, 5, &util);
    motor(&util_m19, (pattern >> 20) & 1, 28, 6, &util);
    motor(&util_m20, (pattern >> 25) & 1, 35, 7, &util);
    motor(&util_m21, (pattern >> 30) & 1, 12, 8, &util);
    motor(&util_m22, (pattern >> 3) & 1, 19, 9, &util);
    motor(&util_m23, (pattern >> 8) & 1, 26, 0, &util);
    motor(&util_m24, (pattern >> 13) & 1, 33, 1, &util);
    motor(&util_m25, (pattern >> 18) & 1, 10, 2, &util);
    if (feed.starts > 20000) feed.starts = 0;
    if (mill.starts > 20000) mill.starts = 0;
    if (bake.starts > 20000) bake.starts = 0;
    if (cool.starts > 20000) cool.starts = 0;
    if (pack.starts > 20000) pack.starts = 0;
    if (store.starts > 20000) store.starts = 0;
    if (wash.starts > 20000) wash.starts = 0;
    if (util.starts > 20000) util.starts = 0;
    check = (check % 100003) * 3 + feed.power * 1 + feed.running + feed.starts % 7 + mill.power * 2 + mill.running + mill.starts % 7 + bake.power * 3 + bake.running + bake.starts % 7 + cool.power * 4 + cool.running + cool.starts % 7 + pack.power * 5 + pack.running + pack.starts % 7 + store.power * 6 + store.running + store.starts % 7 + wash.power * 7 + wash.running + wash.starts % 7 + util.power * 8 + util.running + util.starts % 7;
}
