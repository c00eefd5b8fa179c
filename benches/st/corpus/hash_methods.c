#include "iec_timers.h"
enum { RING = 48 };
typedef struct { bool used; uint32_t key; uint64_t value; uint8_t hits; } Slot;
typedef struct { uint32_t stamp; uint8_t src; uint16_t data[4]; int16_t next; } Event;
static Slot slots[128]; static unsigned size; static uint32_t probes;
static Event ring[RING], ev; static int head, count; static int32_t scans;
static int find(uint32_t key) {
  int h = (key * 13 + key / 16) % 128;
  for (int n = 0; n < 128; n++) { probes++; if (!slots[h].used || slots[h].key == key) return h; h = (h + 1) % 128; }
  return -1;
}
static bool add(uint32_t key, uint64_t value) {
  int h = find(key);
  if (h < 0) return false;
  Slot *s = &slots[h];
  if (!s->used) { s->used = true; s->key = key; s->value = value; size++; }
  else { s->value += value; s->hits = s->hits % 250 + 1; }
  return true;
}
static Slot get(uint32_t key) { int h = find(key); return h >= 0 ? slots[h] : (Slot){0}; }
void scan(void) {
  scans++;
  memset(slots, 0, sizeof slots); size = 0; probes = 0;
  for (int i = 1; i <= 12; i++) {
    ev.stamp = scans * 12 + i; ev.src = i * 7 % 10; ev.data[i % 4] = (uint16_t)(i * 1000) ^ (uint16_t)ev.stamp;
    ring[head] = ev; head = (head + 1) % RING; if (count < RING) count++;
  }
  int first = -1;
  for (int i = 0; i < count; i++) {
    int k = (head + RING - 1 - i) % RING;
    if (ring[k].src == 4) continue;
    ring[k].next = first; first = k;
    if (!add(ring[k].src * 100u + ring[k].stamp % 17, (uint64_t)ring[k].stamp * 3)) break;
  }
  uint64_t n = size;
  while (first >= 0) {
    Event *e = &ring[first];
    for (int i = 0; i < 4; i++) n += e->data[i];
    Slot s = get(e->src * 100u + e->stamp % 17);
    n += s.value + s.hits;
    first = e->next;
  }
  check = (check * 31 + (int32_t)(n % 100003) + (int32_t)probes) % 1000003;
}
