/* The program of the same name once more, in C. */
#include "st.h"
#include <stdbool.h>

typedef struct { int32_t value; bool arrived; } Ramp;
typedef struct { int32_t result; } Smooth;
typedef struct { int32_t hash; } Mixer;
typedef struct { bool verdict, before; int32_t changes; } Voter;

static inline int32_t bounded(int32_t x, int32_t low, int32_t high)
{
  if (x < low)
    return low;
  if (x > high)
    return high;
  return x;
}

static inline int32_t scaled(int32_t x, int32_t num, int32_t den)
{
  return x * num / den;
}

static inline int32_t hash_step(int32_t hash, int32_t item)
{
  return (hash * 31 + item) % 65521;
}

static inline bool two_of_three(bool a, bool b, bool c)
{
  return (a && b) || (a && c) || (b && c);
}

static inline void ramp_step(Ramp *f, int32_t target, int32_t rate)
{
  f->value += bounded(target - f->value, -rate, rate);
  f->arrived = f->value == target;
}

static inline void smooth_step(Smooth *f, int32_t raw, int32_t num, int32_t den)
{
  f->result = bounded(f->result + scaled(raw - f->result, num, den), 0, 50000);
}

static inline void mixer_step(Mixer *f, int32_t item, bool active)
{
  if (active)
    f->hash = hash_step(f->hash, item);
  else
    f->hash = hash_step(item, f->hash);
}

static inline void voter_step(Voter *f, bool in1, bool in2, bool in3)
{
  f->verdict = two_of_three(in1, in2, in3);
  if (f->verdict != f->before)
    f->changes++;
  f->before = f->verdict;
}

static int32_t cycle;
static bool flag[8];
static Ramp b003, b004, b005, b006, b020, b023, b027, b028, b030, b031,
  b043, b046, b049, b051, b053, b056, b058, b064, b074, b077,
  b083, b085, b090, b092, b095, b096, b100, b108, b116, b117,
  b120, b127, b130, b136, b138, b152, b159, b160, b163, b167,
  b168, b169, b175, b179, b180, b184, b185, b190, b191, b200;
static Smooth b008, b012, b013, b018, b019, b024, b026, b035, b041, b045,
  b047, b059, b060, b061, b065, b068, b071, b076, b078, b080,
  b082, b088, b089, b091, b098, b099, b110, b111, b112, b114,
  b123, b124, b126, b129, b142, b145, b146, b148, b156, b158,
  b166, b171, b178, b186, b187, b189, b193, b195, b196, b197;
static Mixer b001 = { 17 }, b002 = { 17 }, b009 = { 17 }, b011 = { 17 }, b015 = { 17 }, b016 = { 17 }, b017 = { 17 }, b022 = { 17 }, b029 = { 17 }, b033 = { 17 },
  b034 = { 17 }, b038 = { 17 }, b039 = { 17 }, b044 = { 17 }, b050 = { 17 }, b054 = { 17 }, b057 = { 17 }, b062 = { 17 }, b066 = { 17 }, b067 = { 17 },
  b070 = { 17 }, b072 = { 17 }, b073 = { 17 }, b075 = { 17 }, b079 = { 17 }, b093 = { 17 }, b094 = { 17 }, b102 = { 17 }, b103 = { 17 }, b106 = { 17 },
  b113 = { 17 }, b115 = { 17 }, b128 = { 17 }, b132 = { 17 }, b134 = { 17 }, b140 = { 17 }, b144 = { 17 }, b149 = { 17 }, b150 = { 17 }, b154 = { 17 },
  b155 = { 17 }, b164 = { 17 }, b170 = { 17 }, b172 = { 17 }, b173 = { 17 }, b174 = { 17 }, b176 = { 17 }, b192 = { 17 }, b194 = { 17 }, b198 = { 17 };
static Voter b007, b010, b014, b021, b025, b032, b036, b037, b040, b042,
  b048, b052, b055, b063, b069, b081, b084, b086, b087, b097,
  b101, b104, b105, b107, b109, b118, b119, b121, b122, b125,
  b131, b133, b135, b137, b139, b141, b143, b147, b151, b153,
  b157, b161, b162, b165, b177, b181, b182, b183, b188, b199;

void scan(void)
{
  cycle++;
  for (int i = 0; i < 8; i++)
    flag[i] = cycle % (i * 2 + 3) > i;

  mixer_step(&b001, cycle, flag[0]);
  mixer_step(&b002, b001.hash, flag[2]);
  ramp_step(&b003, b002.hash, 86);
  ramp_step(&b004, cycle, 89);
  ramp_step(&b005, b004.value, 14);
  ramp_step(&b006, b002.hash, 13);
  voter_step(&b007, b006.arrived, !flag[0], flag[4]);
  smooth_step(&b008, b006.value + cycle, 4, 8);
  mixer_step(&b009, b005.value, flag[0]);
  voter_step(&b010, b005.arrived, !b004.arrived, b005.arrived);
  mixer_step(&b011, b002.hash, flag[3]);
  smooth_step(&b012, b011.hash + b003.value, 2, 11);
  smooth_step(&b013, b012.result + b005.value, 3, 11);
  voter_step(&b014, flag[7], !b007.verdict, b010.verdict);
  mixer_step(&b015, b006.value, flag[3]);
  mixer_step(&b016, b012.result, flag[4]);
  mixer_step(&b017, b005.value, b003.arrived);
  smooth_step(&b018, b016.hash + b009.hash, 3, 10);
  smooth_step(&b019, b005.value + b013.result, 7, 10);
  ramp_step(&b020, b018.result, 40);
  voter_step(&b021, flag[5], !flag[3], flag[1]);
  mixer_step(&b022, b015.hash, b004.arrived);
  ramp_step(&b023, b020.value, 69);
  smooth_step(&b024, b022.hash + b003.value, 6, 11);
  voter_step(&b025, b023.arrived, !b021.verdict, flag[5]);
  smooth_step(&b026, b024.result + b019.result, 1, 12);
  ramp_step(&b027, b023.value, 59);
  ramp_step(&b028, b027.value, 90);
  mixer_step(&b029, b008.result, b020.arrived);
  ramp_step(&b030, b023.value, 17);
  ramp_step(&b031, b026.result, 18);
  voter_step(&b032, b014.verdict, !b028.arrived, b027.arrived);
  mixer_step(&b033, b017.hash, b030.arrived);
  mixer_step(&b034, b029.hash, b032.verdict);
  smooth_step(&b035, b018.result + b034.hash, 6, 11);
  voter_step(&b036, b031.arrived, !flag[1], b020.arrived);
  voter_step(&b037, b025.verdict, !flag[2], b036.verdict);
  mixer_step(&b038, b031.value, flag[6]);
  mixer_step(&b039, b019.result, b037.verdict);
  voter_step(&b040, b025.verdict, !b031.arrived, flag[1]);
  smooth_step(&b041, b012.result + b038.hash, 7, 9);
  voter_step(&b042, b040.verdict, !flag[1], b032.verdict);
  ramp_step(&b043, b028.value, 69);
  mixer_step(&b044, b043.value, b043.arrived);
  smooth_step(&b045, b008.result + b039.hash, 6, 11);
  ramp_step(&b046, b035.result, 15);
  smooth_step(&b047, b030.value + b017.hash, 3, 12);
  voter_step(&b048, b032.verdict, !b046.arrived, b042.verdict);
  ramp_step(&b049, b033.hash, 8);
  mixer_step(&b050, b047.result, b048.verdict);
  ramp_step(&b051, b041.result, 29);
  voter_step(&b052, b042.verdict, !b051.arrived, b020.arrived);
  ramp_step(&b053, b045.result, 17);
  mixer_step(&b054, b039.hash, b052.verdict);
  voter_step(&b055, b053.arrived, !b049.arrived, b004.arrived);
  ramp_step(&b056, b054.hash, 7);
  mixer_step(&b057, b044.hash, b049.arrived);
  ramp_step(&b058, b051.value, 68);
  smooth_step(&b059, b050.hash + b057.hash, 1, 12);
  smooth_step(&b060, b035.result + b053.value, 4, 9);
  smooth_step(&b061, b049.value + b020.value, 7, 10);
  mixer_step(&b062, b008.result, b032.verdict);
  voter_step(&b063, b052.verdict, !b055.verdict, b058.arrived);
  ramp_step(&b064, b058.value, 46);
  smooth_step(&b065, b046.value + b061.result, 7, 9);
  mixer_step(&b066, b054.hash, b064.arrived);
  mixer_step(&b067, b065.result, b036.verdict);
  smooth_step(&b068, b062.hash + b060.result, 7, 8);
  voter_step(&b069, b027.arrived, !b063.verdict, b053.arrived);
  mixer_step(&b070, b066.hash, b056.arrived);
  smooth_step(&b071, b068.result + b064.value, 4, 8);
  mixer_step(&b072, b071.result, b069.verdict);
  mixer_step(&b073, b065.result, flag[5]);
  ramp_step(&b074, b049.value, 69);
  mixer_step(&b075, b073.hash, b074.arrived);
  smooth_step(&b076, b002.hash + b056.value, 5, 9);
  ramp_step(&b077, b072.hash, 17);
  smooth_step(&b078, b067.hash + b076.result, 7, 10);
  mixer_step(&b079, b046.value, b077.arrived);
  smooth_step(&b080, b074.value + b070.hash, 1, 12);
  voter_step(&b081, flag[4], !flag[4], flag[0]);
  smooth_step(&b082, b077.value + b075.hash, 5, 9);
  ramp_step(&b083, b046.value, 5);
  voter_step(&b084, b083.arrived, !b081.verdict, b032.verdict);
  ramp_step(&b085, b079.hash, 89);
  voter_step(&b086, b084.verdict, !b085.arrived, b052.verdict);
  voter_step(&b087, flag[6], !b025.verdict, b086.verdict);
  smooth_step(&b088, b082.result + b059.result, 3, 11);
  smooth_step(&b089, b083.value + b085.value, 6, 10);
  ramp_step(&b090, b080.result, 83);
  smooth_step(&b091, b056.value + b078.result, 6, 10);
  ramp_step(&b092, b091.result, 88);
  mixer_step(&b093, b092.value, b020.arrived);
  mixer_step(&b094, b089.result, b087.verdict);
  ramp_step(&b095, b088.result, 53);
  ramp_step(&b096, b061.result, 7);
  voter_step(&b097, b096.arrived, !b092.arrived, b090.arrived);
  smooth_step(&b098, b093.hash + b095.value, 1, 9);
  smooth_step(&b099, b098.result + b091.result, 5, 10);
  ramp_step(&b100, b058.value, 69);
  voter_step(&b101, b097.verdict, !b081.verdict, b042.verdict);
  mixer_step(&b102, b090.value, b095.arrived);
  mixer_step(&b103, b033.hash, b025.verdict);
  voter_step(&b104, b101.verdict, !b100.arrived, b055.verdict);
  voter_step(&b105, b030.arrived, !b090.arrived, b104.verdict);
  mixer_step(&b106, b100.value, b105.verdict);
  voter_step(&b107, b003.arrived, !b042.verdict, b036.verdict);
  ramp_step(&b108, b045.result, 8);
  voter_step(&b109, b055.verdict, !b108.arrived, b107.verdict);
  smooth_step(&b110, b108.value + b102.hash, 1, 9);
  smooth_step(&b111, b110.result + b096.value, 4, 8);
  smooth_step(&b112, b111.result + b082.result, 7, 11);
  mixer_step(&b113, b076.result, b049.arrived);
  smooth_step(&b114, b112.result + b106.hash, 3, 8);
  mixer_step(&b115, b114.result, b049.arrived);
  ramp_step(&b116, b049.value, 49);
  ramp_step(&b117, b094.hash, 51);
  voter_step(&b118, b056.arrived, !b006.arrived, b116.arrived);
  voter_step(&b119, b109.verdict, !b118.verdict, b036.verdict);
  ramp_step(&b120, b099.result, 87);
  voter_step(&b121, b116.arrived, !b119.verdict, b010.verdict);
  voter_step(&b122, b117.arrived, !b120.arrived, b121.verdict);
  smooth_step(&b123, b117.value + b120.value, 2, 10);
  smooth_step(&b124, b083.value + b103.hash, 5, 8);
  voter_step(&b125, b023.arrived, !b122.verdict, b081.verdict);
  smooth_step(&b126, b115.hash + b116.value, 7, 10);
  ramp_step(&b127, b124.result, 80);
  mixer_step(&b128, b127.value, b127.arrived);
  smooth_step(&b129, b123.result + b128.hash, 5, 12);
  ramp_step(&b130, b129.result, 7);
  voter_step(&b131, b053.arrived, !b125.verdict, b051.arrived);
  mixer_step(&b132, b126.result, b020.arrived);
  voter_step(&b133, b130.arrived, !b131.verdict, b014.verdict);
  mixer_step(&b134, b130.value, b133.verdict);
  voter_step(&b135, b097.verdict, !b051.arrived, b100.arrived);
  ramp_step(&b136, b130.value, 24);
  voter_step(&b137, b136.arrived, !b135.verdict, b084.verdict);
  ramp_step(&b138, b099.result, 22);
  voter_step(&b139, b131.verdict, !b137.verdict, b086.verdict);
  mixer_step(&b140, b136.value, b139.verdict);
  voter_step(&b141, b096.arrived, !b138.arrived, b104.verdict);
  smooth_step(&b142, b138.value + b093.hash, 6, 12);
  voter_step(&b143, b141.verdict, !b085.arrived, b081.verdict);
  mixer_step(&b144, b138.value, b043.arrived);
  smooth_step(&b145, b134.hash + b142.result, 2, 11);
  smooth_step(&b146, b140.hash + b124.result, 1, 8);
  voter_step(&b147, b063.verdict, !b143.verdict, b107.verdict);
  smooth_step(&b148, b145.result + b113.hash, 4, 9);
  mixer_step(&b149, b144.hash, b147.verdict);
  mixer_step(&b150, b149.hash, b143.verdict);
  voter_step(&b151, b087.verdict, !b084.verdict, b077.arrived);
  ramp_step(&b152, b148.result, 79);
  voter_step(&b153, b095.arrived, !b138.arrived, b152.arrived);
  mixer_step(&b154, b152.value, b131.verdict);
  mixer_step(&b155, b092.value, b104.verdict);
  smooth_step(&b156, b154.hash + b146.result, 1, 8);
  voter_step(&b157, b153.verdict, !b125.verdict, b151.verdict);
  smooth_step(&b158, b154.hash + b132.hash, 3, 11);
  ramp_step(&b159, b158.result, 72);
  ramp_step(&b160, b150.hash, 26);
  voter_step(&b161, b083.arrived, !b053.arrived, b159.arrived);
  voter_step(&b162, b157.verdict, !b160.arrived, b087.verdict);
  ramp_step(&b163, b100.value, 5);
  mixer_step(&b164, b160.value, b162.verdict);
  voter_step(&b165, b163.arrived, !b087.verdict, b161.verdict);
  smooth_step(&b166, b103.hash + b164.hash, 2, 8);
  ramp_step(&b167, b156.result, 10);
  ramp_step(&b168, b149.hash, 89);
  ramp_step(&b169, b117.value, 73);
  mixer_step(&b170, b167.value, b169.arrived);
  smooth_step(&b171, b163.value + b113.hash, 5, 9);
  mixer_step(&b172, b166.result, b165.verdict);
  mixer_step(&b173, b170.hash, b168.arrived);
  mixer_step(&b174, b172.hash, b087.verdict);
  ramp_step(&b175, b173.hash, 22);
  mixer_step(&b176, b175.value, b175.arrived);
  voter_step(&b177, b167.arrived, !b136.arrived, b056.arrived);
  smooth_step(&b178, b095.value + b108.value, 5, 11);
  ramp_step(&b179, b168.value, 12);
  ramp_step(&b180, b175.value, 14);
  voter_step(&b181, b153.verdict, !b107.verdict, b108.arrived);
  voter_step(&b182, b177.verdict, !b179.arrived, b180.arrived);
  voter_step(&b183, b151.verdict, !b181.verdict, b182.verdict);
  ramp_step(&b184, b180.value, 10);
  ramp_step(&b185, b178.result, 86);
  smooth_step(&b186, b167.value + b152.value, 3, 10);
  smooth_step(&b187, b111.result + b145.result, 3, 12);
  voter_step(&b188, b183.verdict, !b184.arrived, b185.arrived);
  smooth_step(&b189, b174.hash + b184.value, 1, 12);
  ramp_step(&b190, b187.result, 80);
  ramp_step(&b191, b186.result, 6);
  mixer_step(&b192, b155.hash, b188.verdict);
  smooth_step(&b193, b154.hash + b159.value, 2, 9);
  mixer_step(&b194, b176.hash, b190.arrived);
  smooth_step(&b195, b191.value + b169.value, 7, 8);
  smooth_step(&b196, b185.value + b145.result, 6, 10);
  smooth_step(&b197, b193.result + b189.result, 5, 8);
  mixer_step(&b198, b192.hash, b105.verdict);
  voter_step(&b199, b191.arrived, !b118.verdict, b136.arrived);
  ramp_step(&b200, b171.result, 80);

  int32_t acc = 0;
  acc += b001.hash;
  acc += b002.hash;
  acc += b003.value;
  acc += b004.value;
  acc += b005.value;
  acc += b006.value;
  acc += b007.changes;
  acc += b008.result;
  acc += b009.hash;
  acc = (acc + b010.changes) % 100003;
  acc += b011.hash;
  acc += b012.result;
  acc += b013.result;
  acc += b014.changes;
  acc += b015.hash;
  acc += b016.hash;
  acc += b017.hash;
  acc += b018.result;
  acc += b019.result;
  acc = (acc + b020.value) % 100003;
  acc += b021.changes;
  acc += b022.hash;
  acc += b023.value;
  acc += b024.result;
  acc += b025.changes;
  acc += b026.result;
  acc += b027.value;
  acc += b028.value;
  acc += b029.hash;
  acc = (acc + b030.value) % 100003;
  acc += b031.value;
  acc += b032.changes;
  acc += b033.hash;
  acc += b034.hash;
  acc += b035.result;
  acc += b036.changes;
  acc += b037.changes;
  acc += b038.hash;
  acc += b039.hash;
  acc = (acc + b040.changes) % 100003;
  acc += b041.result;
  acc += b042.changes;
  acc += b043.value;
  acc += b044.hash;
  acc += b045.result;
  acc += b046.value;
  acc += b047.result;
  acc += b048.changes;
  acc += b049.value;
  acc = (acc + b050.hash) % 100003;
  acc += b051.value;
  acc += b052.changes;
  acc += b053.value;
  acc += b054.hash;
  acc += b055.changes;
  acc += b056.value;
  acc += b057.hash;
  acc += b058.value;
  acc += b059.result;
  acc = (acc + b060.result) % 100003;
  acc += b061.result;
  acc += b062.hash;
  acc += b063.changes;
  acc += b064.value;
  acc += b065.result;
  acc += b066.hash;
  acc += b067.hash;
  acc += b068.result;
  acc += b069.changes;
  acc = (acc + b070.hash) % 100003;
  acc += b071.result;
  acc += b072.hash;
  acc += b073.hash;
  acc += b074.value;
  acc += b075.hash;
  acc += b076.result;
  acc += b077.value;
  acc += b078.result;
  acc += b079.hash;
  acc = (acc + b080.result) % 100003;
  acc += b081.changes;
  acc += b082.result;
  acc += b083.value;
  acc += b084.changes;
  acc += b085.value;
  acc += b086.changes;
  acc += b087.changes;
  acc += b088.result;
  acc += b089.result;
  acc = (acc + b090.value) % 100003;
  acc += b091.result;
  acc += b092.value;
  acc += b093.hash;
  acc += b094.hash;
  acc += b095.value;
  acc += b096.value;
  acc += b097.changes;
  acc += b098.result;
  acc += b099.result;
  acc = (acc + b100.value) % 100003;
  acc += b101.changes;
  acc += b102.hash;
  acc += b103.hash;
  acc += b104.changes;
  acc += b105.changes;
  acc += b106.hash;
  acc += b107.changes;
  acc += b108.value;
  acc += b109.changes;
  acc = (acc + b110.result) % 100003;
  acc += b111.result;
  acc += b112.result;
  acc += b113.hash;
  acc += b114.result;
  acc += b115.hash;
  acc += b116.value;
  acc += b117.value;
  acc += b118.changes;
  acc += b119.changes;
  acc = (acc + b120.value) % 100003;
  acc += b121.changes;
  acc += b122.changes;
  acc += b123.result;
  acc += b124.result;
  acc += b125.changes;
  acc += b126.result;
  acc += b127.value;
  acc += b128.hash;
  acc += b129.result;
  acc = (acc + b130.value) % 100003;
  acc += b131.changes;
  acc += b132.hash;
  acc += b133.changes;
  acc += b134.hash;
  acc += b135.changes;
  acc += b136.value;
  acc += b137.changes;
  acc += b138.value;
  acc += b139.changes;
  acc = (acc + b140.hash) % 100003;
  acc += b141.changes;
  acc += b142.result;
  acc += b143.changes;
  acc += b144.hash;
  acc += b145.result;
  acc += b146.result;
  acc += b147.changes;
  acc += b148.result;
  acc += b149.hash;
  acc = (acc + b150.hash) % 100003;
  acc += b151.changes;
  acc += b152.value;
  acc += b153.changes;
  acc += b154.hash;
  acc += b155.hash;
  acc += b156.result;
  acc += b157.changes;
  acc += b158.result;
  acc += b159.value;
  acc = (acc + b160.value) % 100003;
  acc += b161.changes;
  acc += b162.changes;
  acc += b163.value;
  acc += b164.hash;
  acc += b165.changes;
  acc += b166.result;
  acc += b167.value;
  acc += b168.value;
  acc += b169.value;
  acc = (acc + b170.hash) % 100003;
  acc += b171.result;
  acc += b172.hash;
  acc += b173.hash;
  acc += b174.hash;
  acc += b175.value;
  acc += b176.hash;
  acc += b177.changes;
  acc += b178.result;
  acc += b179.value;
  acc = (acc + b180.value) % 100003;
  acc += b181.changes;
  acc += b182.changes;
  acc += b183.changes;
  acc += b184.value;
  acc += b185.value;
  acc += b186.result;
  acc += b187.result;
  acc += b188.changes;
  acc += b189.result;
  acc = (acc + b190.value) % 100003;
  acc += b191.value;
  acc += b192.hash;
  acc += b193.result;
  acc += b194.hash;
  acc += b195.result;
  acc += b196.result;
  acc += b197.result;
  acc += b198.hash;
  acc += b199.changes;
  acc = (acc + b200.value) % 100003;

  int32_t h = acc;
  for (int32_t i = 1; i <= 500; i++)
    h = hash_step(h, i + cycle);
  check = (check * 23 + acc + h) % 1000003;
}
