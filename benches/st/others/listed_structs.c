/* The program of the same name once more, in C. */
#include "st.h"
#include <stdbool.h>

typedef struct {
  int32_t key;
  int16_t id;
  int16_t visits;
  float level;
  bool rising;
  int32_t weight;
} Station;

static int32_t cycle, seed = 99;
static bool ready;
static Station stations[100];

void scan(void)
{
  if (!ready) {
    for (int i = 0; i < 100; i++) {
      stations[i].id = i;
      stations[i].level = (float)i * 0.5f;
      stations[i].weight = i * 37 % 101;
    }
    ready = true;
  }
  cycle++;

  for (int i = 0; i < 100; i++) {
    Station *s = &stations[i];
    seed = (seed * 421 + 1663) % 7875;
    s->key = (s->key + seed + s->weight) % 10007;
    s->visits = (s->visits + 1) % 1000;
    if (s->rising) {
      s->level += 0.75f;
      if (s->level > 60.0f)
        s->rising = false;
    } else {
      s->level -= 1.25f;
      if (s->level < 5.0f)
        s->rising = true;
    }
    if (i % 7 == 0)
      s->weight = (s->weight + cycle) % 503;
  }

  int32_t swaps = 0;
  for (int pass = 1; pass <= 20; pass++)
    for (int i = 0; i <= 99 - pass; i++)
      if (stations[i].key > stations[i + 1].key) {
        Station spare = stations[i];
        stations[i] = stations[i + 1];
        stations[i + 1] = spare;
        swaps++;
      }

  int32_t acc = swaps;
  for (int i = 0; i < 100; i++) {
    const Station *s = &stations[i];
    acc = (acc * 3 + s->key + s->id + s->visits + s->weight + (int32_t)(s->level * 4.0f)) % 1000003;
    if (s->rising)
      acc++;
  }
  check = (check * 41 + acc) % 1000003;
}
