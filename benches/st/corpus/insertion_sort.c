#include "iec_timers.h"
typedef struct { int32_t key; char name[11]; uint16_t qty; float price; bool flags[4]; } Order;
static Order o[41]; static int16_t ix[41]; static int32_t scans;
static bool less(const Order *a, const Order *b) { return a->key < b->key || (a->key == b->key && a->qty < b->qty); }
static int insertion(int n) {
  int moves = 0;
  for (int i = 2; i <= n; i++) {
    Order t = o[i]; int j = i - 1;
    while (j >= 1 && less(&t, &o[j])) { o[j + 1] = o[j]; j--; moves++; }
    o[j + 1] = t;
  }
  return moves;
}
static int search(int32_t key) {
  int lo = 1, hi = 40;
  while (lo <= hi) { int mid = (lo + hi) / 2; if (o[mid].key == key) return mid; if (o[mid].key < key) lo = mid + 1; else hi = mid - 1; }
  return 0;
}
void scan(void) {
  scans++;
  for (int i = 1; i <= 40; i++) {
    o[i].key = (scans * 31 + i * i * 7) % 97; o[i].qty = i; o[i].price = (float)(i % 8) * 0.5f; o[i].flags[i % 4] = i % 3 == 0; ix[i] = i;
  }
  int32_t n = insertion(40);
  for (int i = 1; i <= 39; i++) for (int j = 40; j > i; j--)
    if (o[ix[j]].price < o[ix[j - 1]].price) { int16_t k = ix[j]; ix[j] = ix[j - 1]; ix[j - 1] = k; }
  float value = 0;
  for (int i = 1; i <= 40; i++) {
    int k = search((scans + i * 5) % 97);
    if (k > 0) { n += o[k].key; if (o[k].flags[k % 4]) n += 100; }
    value += o[ix[i]].price * (float)o[i].qty;
    n += ix[i] * i;
  }
  check = (check * 31 + n + (int32_t)value) % 1000003;
}
