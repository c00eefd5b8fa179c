/* Arrays of structs: update, linear search, sort by key, binary search, statistics per class */
#include <stdbool.h>
#include <string.h>
#include "st.h"

#define N_PARTS 64
#define N_CLASS 8

typedef struct { int16_t x, y; } point;
typedef struct {
  int32_t id;
  point pos;
  float weight;
  int16_t kind;
  bool ok;
  int32_t age;
} part;
typedef struct {
  int16_t count;
  float weight;
  int32_t oldest;
  point min_pos;
} class_stat;

static int find_id(const part *list, int32_t id)
{
  int lo = 0, hi = N_PARTS - 1;
  while (lo <= hi) {
    int mid = (lo + hi) / 2;
    if (list[mid].id == id)
      return mid;
    else if (list[mid].id < id)
      lo = mid + 1;
    else
      hi = mid - 1;
  }
  return -1;
}

static bool ready;
static part parts[N_PARTS];
static part sorted[N_PARTS];
static class_stat stats[N_CLASS];
static int32_t seed = 3;

void scan(void)
{
  int i, j, k;
  if (!ready) {
    for (i = 0; i < N_PARTS; i++) {
      parts[i].id = (i * 37) % 101 * 10;
      parts[i].weight = 1.0f + (float)(i % 13) * 0.25f;
      parts[i].kind = i % N_CLASS;
      parts[i].ok = true;
      parts[i].pos.x = i * 3;
      parts[i].pos.y = i * 5;
    }
    ready = true;
  }

  for (i = 0; i < N_PARTS; i++) {
    part *p = &parts[i];
    p->pos.x = (p->pos.x + 7) % 1000;
    p->pos.y = (p->pos.y + p->kind) % 500;
    p->age++;
    p->ok = p->pos.x > p->pos.y;
  }
  do {
    seed = (seed * 421 + 1663) % 7875;
    k = seed % 64;
    parts[k].id = seed;
    parts[k].age = 0;
    parts[k].kind = seed % 8;
    parts[k].weight = 0.5f + (float)seed * 0.001f;
  } while (seed % 4 != 0);

  memcpy(sorted, parts, sizeof sorted);
  for (i = 1; i < N_PARTS; i++) {
    part tmp = sorted[i];
    j = i - 1;
    while (j >= 0 && sorted[j].id > tmp.id) {
      sorted[j + 1] = sorted[j];
      j--;
    }
    sorted[j + 1] = tmp;
  }

  int32_t hits = 0;
  for (i = 0; i <= 31; i++) {
    k = find_id(sorted, parts[i * 2].id + i % 2);
    if (k >= 0)
      hits += 1 + sorted[k].kind;
  }

  for (i = 0; i < N_CLASS; i++) {
    stats[i].count = 0;
    stats[i].weight = 0.0f;
    stats[i].oldest = -1;
    stats[i].min_pos.x = 32767;
    stats[i].min_pos.y = 32767;
  }
  for (i = 0; i < N_PARTS; i++) {
    class_stat *s = &stats[parts[i].kind];
    s->count++;
    if (parts[i].ok)
      s->weight += parts[i].weight;
    if (parts[i].age > s->oldest) {
      s->oldest = parts[i].age;
      s->min_pos = parts[i].pos;
    }
  }

  float heavy = -1.0f;
  k = 0;
  for (i = 0; i < N_PARTS; i++) {
    if (parts[i].ok && parts[i].weight > heavy) {
      heavy = parts[i].weight;
      k = i;
    }
  }

  int32_t sum = parts[k].id + hits * 3;
  for (i = 0; i < N_CLASS; i++)
    sum += stats[i].count * (i + 1) + (int32_t)(stats[i].weight * 10.0f)
         + stats[i].oldest % 1000 + stats[i].min_pos.x - stats[i].min_pos.y;
  for (i = 0; i < N_PARTS; i++)
    sum += sorted[i].id * (i % 5) + sorted[i].pos.x;
  check = (int32_t)((uint32_t)check * 31u + (uint32_t)sum);
}
