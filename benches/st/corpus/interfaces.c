#include "iec_timers.h"
typedef struct Shape Shape;
typedef struct { int (*area)(Shape *); void (*grow)(Shape *, int); } Ops;
struct Shape { const Ops *ops; int w, h, d; };
static Shape rects[25], boxes[25], balls[25], *shapes[100]; static int32_t scans;
static int rect_area(Shape *s) { return s->w * s->h; }
static void rect_grow(Shape *s, int by) { s->w = (s->w + by) % 40; s->h = (s->h + s->w) % 30; }
static int box_area(Shape *s) { return rect_area(s) * 2 + s->d * (s->w + s->h) * 2; }
static void box_grow(Shape *s, int by) { rect_grow(s, by + 1); s->d = (s->d + by) % 20; }
static int ball_area(Shape *s) { return s->w * s->w * 157 / 50; }
static void ball_grow(Shape *s, int by) { s->w = (s->w * 3 + by) % 25; }
static const Ops rect_ops = { rect_area, rect_grow }, box_ops = { box_area, box_grow }, ball_ops = { ball_area, ball_grow };
static int work(Shape *s, int by) { s->ops->grow(s, by); return s->ops->area(s); }
void scan(void) {
  scans++;
  if (scans == 1) for (int i = 0; i < 25; i++) {
    rects[i] = (Shape){ &rect_ops, 3, 4, 0 }; boxes[i] = (Shape){ &box_ops, 3, 4, 2 }; balls[i] = (Shape){ &ball_ops, 1, 0, 0 };
    shapes[i * 4] = &rects[i]; shapes[i * 4 + 1] = &boxes[i]; shapes[i * 4 + 2] = &balls[i]; shapes[i * 4 + 3] = &rects[24 - i];
  }
  int32_t n = 0;
  for (int i = 0; i < 100; i++) n += work(shapes[i], (scans + i) % 7);
  check = (check * 31 + n) % 1000003;
}
