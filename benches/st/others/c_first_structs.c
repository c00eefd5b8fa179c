/* 100 records: update, then 20 passes of bubble sort that swap whole records */
#include <stdbool.h>
#include "st.h"

#define N 100

typedef struct {
  int16_t id;
  int32_t key;
  float weight;
  bool active;
  int16_t hist[4];
} rec_t;

static rec_t recs[N];
static bool init_done;
static int32_t n_scan;
static uint32_t rnd;

void scan(void)
{
  rec_t tmp;
  int i, pass;
  int32_t sum;
  float wsum;

  if (!init_done) {
    for (i = 0; i < N; i++) {
      recs[i].id = (int16_t)i;
      recs[i].weight = (float)i * 0.5f;
    }
    init_done = true;
  }

  rnd = (uint32_t)(n_scan * 37 + 11) % 134456;
  for (i = 0; i < N; i++) {
    rnd = (rnd * 8121 + 28411) % 134456;
    recs[i].key = (recs[i].key + (int32_t)(rnd % 5000)) % 10007;
    recs[i].weight = recs[i].weight * 0.9f + (float)(rnd % 100) * 0.1f;
    recs[i].active = recs[i].weight > 5.0f;
    recs[i].hist[3] = recs[i].hist[2];
    recs[i].hist[2] = recs[i].hist[1];
    recs[i].hist[1] = recs[i].hist[0];
    recs[i].hist[0] = (int16_t)(rnd % 1000);
  }

  pass = 0;
  while (pass < 20) {
    for (i = 0; i < N - 1 - pass; i++)
      if (recs[i].key > recs[i + 1].key) {
        tmp = recs[i];
        recs[i] = recs[i + 1];
        recs[i + 1] = tmp;
      }
    pass++;
  }

  sum = 0;
  wsum = 0.0f;
  for (i = 0; i < N; i++) {
    sum += recs[i].id * i + recs[i].hist[i % 4];
    if (recs[i].active) {
      sum += recs[i].key;
      wsum = wsum + recs[i].weight;
    }
  }
  check = (check + sum + (int32_t)(wsum * 8.0f)) % 1000003;
  n_scan++;
}
