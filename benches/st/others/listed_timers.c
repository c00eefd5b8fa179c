/* The program of the same name once more, in C. */
#include "st.h"
#include <stdbool.h>

typedef struct { bool q, run; int64_t et, start; } Ton;
typedef struct { bool q, run; int64_t et, start; } Tof;
typedef struct { bool q, run, last; int64_t et, start; } Tp;
typedef struct { bool q, last; int16_t cv; } Ctu;
typedef struct { bool q, last; int16_t cv; } Ctd;
typedef struct { bool qu, qd, last_u, last_d; int16_t cv; } Ctud;
typedef struct { bool q, m; } RTrig;
typedef struct { bool q, m; } FTrig;

#define MS(x) ((int64_t)(x) * 1000)

static inline int64_t elapsed(int64_t start, int64_t pt)
{
  int64_t e = (int64_t)now_us - start;
  return e < pt ? e : pt;
}

static inline void ton_step(Ton *f, bool in, int64_t pt)
{
  if (!in) {
    f->q = f->run = false;
    f->et = 0;
    return;
  }
  if (!f->run) {
    f->run = true;
    f->start = now_us;
  }
  f->et = elapsed(f->start, pt);
  f->q = f->et >= pt;
}

static inline void tof_step(Tof *f, bool in, int64_t pt)
{
  if (in) {
    f->q = true;
    f->run = false;
    f->et = 0;
  } else if (f->q) {
    if (!f->run) {
      f->run = true;
      f->start = now_us;
    }
    f->et = elapsed(f->start, pt);
    if (f->et >= pt)
      f->q = f->run = false;
  }
}

static inline void tp_step(Tp *f, bool in, int64_t pt)
{
  if (!f->run && in && !f->last) {
    f->run = f->q = true;
    f->start = now_us;
  }
  if (f->run) {
    f->et = elapsed(f->start, pt);
    if (f->et >= pt)
      f->run = f->q = false;
  }
  if (!f->run && !in)
    f->et = 0;
  f->last = in;
}

static inline void ctu_step(Ctu *f, bool cu, bool r, int16_t pv)
{
  if (r)
    f->cv = 0;
  else if (cu && !f->last && f->cv < 32767)
    f->cv++;
  f->last = cu;
  f->q = f->cv >= pv;
}

static inline void ctd_step(Ctd *f, bool cd, bool ld, int16_t pv)
{
  if (ld)
    f->cv = pv;
  else if (cd && !f->last && f->cv > -32768)
    f->cv--;
  f->last = cd;
  f->q = f->cv <= 0;
}

static inline void ctud_step(Ctud *f, bool cu, bool cd, bool r, bool ld, int16_t pv)
{
  bool up = cu && !f->last_u, down = cd && !f->last_d;
  f->last_u = cu;
  f->last_d = cd;
  if (r)
    f->cv = 0;
  else if (ld)
    f->cv = pv;
  else if (up && !down && f->cv < 32767)
    f->cv++;
  else if (down && !up && f->cv > -32768)
    f->cv--;
  f->qu = f->cv >= pv;
  f->qd = f->cv <= 0;
}

static inline void rtrig_step(RTrig *f, bool clk)
{
  f->q = clk && !f->m;
  f->m = clk;
}

static inline void ftrig_step(FTrig *f, bool clk)
{
  f->q = !clk && !f->m;
  f->m = !clk;
}

static int32_t cycle;
static bool ck[8], w[59], o[64];
static bool start, stop, run, part, jam, load;
static bool g001, g003, g005, g007, g009, g011, g013, g015, g017, g019,
  g021, g023, g025, g027, g029, g031, g033, g035, g037, g039,
  g041, g043, g045, g047, g049, g051, g053, g055, g057, g059,
  g061, g063, g065, g067, g069, g071, g073, g075, g077, g079,
  g081, g083, g085, g087, g089, g091, g093, g095, g097, g099,
  g101, g103, g105, g107, g109, g111, g113, g115, g117;
static int64_t pt_fast = MS(30);
static int64_t pt_mid = MS(120);
static int64_t pt_slow = MS(450);
static Ton t003, t009, t012, t013, t014, t015, t018, t022, t029, t034,
  t035, t042, t043, t044, t052, t054, t056, t063, t070, t071,
  t072, t078, t082, t084, t085, t090, t092, t093, t097, t098,
  t099, t100, t102, t104, t105, t107, t108, t114, t119, t123,
  t125, t126, t131, t134, t136, t141, t142, t144, t150, t155,
  t159, t160, t162, t166, t168, t169, t180, t185, t186, t191,
  t193, t194, t195, t200, t201, t202, t204, t208, t211, t213,
  t214, t216, t217, t219, t221, t222, t227, t228, t229, t231,
  t232, t237, t239, t242, t243, t261, t267, t273, t277, t278,
  t279, t283, t285, t288, t290, t293, t295, t296, t298, t300;
static Tof t001, t002, t005, t010, t011, t016, t019, t021, t024, t025,
  t026, t028, t030, t032, t033, t037, t045, t046, t049, t051,
  t058, t059, t061, t062, t064, t066, t069, t073, t074, t077,
  t079, t083, t086, t087, t089, t091, t094, t095, t101, t110,
  t111, t112, t113, t116, t117, t120, t121, t122, t127, t128,
  t133, t137, t146, t152, t156, t157, t158, t161, t164, t170,
  t171, t172, t174, t176, t177, t178, t179, t181, t184, t188,
  t190, t192, t197, t198, t203, t218, t223, t224, t225, t234,
  t236, t240, t250, t251, t253, t257, t259, t263, t265, t266,
  t270, t271, t272, t281, t282, t289, t291, t292, t294, t299;
static Tp t004, t006, t007, t008, t017, t020, t023, t027, t031, t036,
  t038, t039, t040, t041, t047, t048, t050, t053, t055, t057,
  t060, t065, t067, t068, t075, t076, t080, t081, t088, t096,
  t103, t106, t109, t115, t118, t124, t129, t130, t132, t135,
  t138, t139, t140, t143, t145, t147, t148, t149, t151, t153,
  t154, t163, t165, t167, t173, t175, t182, t183, t187, t189,
  t196, t199, t205, t206, t207, t209, t210, t212, t215, t220,
  t226, t230, t233, t235, t238, t241, t244, t245, t246, t247,
  t248, t249, t252, t254, t255, t256, t258, t260, t262, t264,
  t268, t269, t274, t275, t276, t280, t284, t286, t287, t297;
static Ctu c002, c005, c012, c016, c020, c021, c024, c027, c035, c037,
  c042, c043, c045, c046, c051, c052, c056, c057, c058, c060,
  c062, c063, c065, c066, c068, c069, c072, c073, c076, c078,
  c081, c082, c083, c084, c085, c090, c094, c095, c099, c103,
  c104, c105, c106, c108, c110, c111, c112, c114, c116, c119,
  c122, c123, c124, c127, c131, c134, c135, c137, c139, c140;
static Ctd c001, c004, c006, c009, c015, c019, c022, c025, c028, c029,
  c030, c031, c033, c034, c036, c044, c047, c049, c050, c059,
  c061, c067, c070, c071, c079, c087, c088, c089, c097, c098,
  c100, c101, c102, c117, c126, c128, c129, c132, c133, c138;
static Ctud c003, c007, c008, c010, c011, c013, c014, c017, c018, c023,
  c026, c032, c038, c039, c040, c041, c048, c053, c054, c055,
  c064, c074, c075, c077, c080, c086, c091, c092, c093, c096,
  c107, c109, c113, c115, c118, c120, c121, c125, c130, c136;
static RTrig e002, e003, e005, e006, e008, e015, e016, e017, e018, e020,
  e021, e022, e023, e025, e030, e032, e033, e036, e037, e040,
  e043, e044, e047, e049, e051, e054, e055, e057, e058, e059;
static FTrig e001, e004, e007, e009, e010, e011, e012, e013, e014, e019,
  e024, e026, e027, e028, e029, e031, e034, e035, e038, e039,
  e041, e042, e045, e046, e048, e050, e052, e053, e056, e060;

void scan(void)
{
  cycle++;
  ck[0] = cycle % 2 < 1;
  ck[1] = cycle % 3 < 1;
  ck[2] = cycle % 5 < 2;
  ck[3] = cycle % 8 < 4;
  ck[4] = cycle % 13 < 6;
  ck[5] = cycle % 21 < 10;
  ck[6] = cycle % 34 < 17;
  ck[7] = cycle % 55 < 27;
  start = cycle % 40 < 3;
  stop = cycle % 97 < 5;
  run = cycle % 211 < 180;
  part = cycle % 9 < 4;
  jam = cycle % 61 < 7;
  load = cycle % 150 < 1;

  tof_step(&t001, !ck[5] ^ !start, pt_mid);
  tof_step(&t002, ck[6], MS(20));
  ton_step(&t003, !run | ck[4], MS(20));
  ctd_step(&c001, ck[2], !t002.q | part, 50);
  g001 = !ck[7] | !(!t002.q ^ (ck[3] | part));
  ctu_step(&c002, !ck[4], ck[1] & (ck[7] & !g001), 5);
  ctud_step(&c003, !ck[4] & !ck[7], ck[1] | !g001, (t003.q | ck[3]) & jam, (!stop | load) & stop, 50);
  tp_step(&t004, ck[3], MS(1500));
  w[1] = !part ^ (t004.q ^ (c003.qd | t001.q));
  ftrig_step(&e001, (jam | t002.q) & ck[3]);
  tof_step(&t005, ck[0] & !jam, MS(70));
  g003 = !c001.q & (t005.q & (!e001.q & !c003.qd));
  tp_step(&t006, !g003 & !ck[6], MS(330));
  rtrig_step(&e002, c003.qu | (jam | t006.q));
  ctd_step(&c004, !jam, ck[2] & run | !c003.qu, 8);
  rtrig_step(&e003, ck[3] | t006.q);
  ftrig_step(&e004, c004.q);
  tp_step(&t007, t006.q, MS(70));
  tp_step(&t008, !e001.q & e003.q, pt_slow);
  ton_step(&t009, t008.q, MS(25));
  w[2] = t007.q & (!t009.q & (e002.q ^ run));
  rtrig_step(&e005, g003);
  ctu_step(&c005, t008.q, !e004.q & !e005.q, 2);
  tof_step(&t010, e003.q ^ t002.q, MS(25));
  g005 = (g001 ^ w[1] | t008.q) ^ w[2];
  ctd_step(&c006, c005.q, g005 | ck[3], 2);
  rtrig_step(&e006, (t008.q | w[2]) & t010.q);
  tof_step(&t011, e006.q ^ c006.q, pt_slow);
  w[3] = !t011.q & !c003.qd & start;
  ton_step(&t012, (w[3] & !ck[3] ^ !t009.q) & !t012.q, MS(330));
  ton_step(&t013, !t012.q & t002.q & !t013.q, pt_fast);
  ctud_step(&c007, !t013.q & !t012.q, stop, (c001.q | !ck[0]) & jam, (e005.q | !c004.q & t005.q) & stop, 50);
  ton_step(&t014, t007.q, MS(25));
  g007 = t014.q ^ t006.q & !c007.qu;
  ton_step(&t015, e003.q | c007.qu & e005.q, pt_fast);
  tof_step(&t016, jam, MS(70));
  tp_step(&t017, t015.q, MS(150));
  w[4] = !t004.q & (g007 & !t016.q);
  ton_step(&t018, (t017.q & ck[0] | t002.q) & !t018.q, MS(500));
  ctud_step(&c008, w[4] & !e002.q, t013.q | t017.q, (t014.q | c005.q & t003.q) & jam, (t013.q | g003) & stop, 3);
  ctd_step(&c009, !t018.q, !ck[7] & (t018.q | !c008.qd), 10);
  ctud_step(&c010, !c009.q ^ t018.q, c008.qd | t016.q, !t007.q & c009.q & jam, (!t012.q & !c006.q ^ t011.q) & stop, 2);
  tof_step(&t019, e006.q & (c007.qd ^ !t018.q), pt_fast);
  tp_step(&t020, c010.qd, MS(25));
  ftrig_step(&e007, !t007.q);
  ctud_step(&c011, c007.qu, t019.q & t020.q, e003.q & (c008.qd | e006.q) & jam, t011.q & (e007.q & t008.q) & stop, 3);
  g009 = c011.qu & (ck[5] ^ c011.qd);
  tof_step(&t021, t013.q & g009 | !c008.qd, pt_slow);
  rtrig_step(&e008, g009);
  ton_step(&t022, !t021.q & !t010.q, pt_fast);
  tp_step(&t023, t022.q, MS(1000));
  tof_step(&t024, t023.q | c005.q, MS(200));
  ftrig_step(&e009, !t024.q);
  tof_step(&t025, !c011.qu, pt_fast);
  tof_step(&t026, c011.qd & (c010.qu | !c010.qd), MS(150));
  w[5] = !t025.q | e009.q & e002.q;
  ctu_step(&c012, !run | c010.qd, w[5] & g005, 3);
  tp_step(&t027, t021.q ^ c001.q, MS(330));
  ctud_step(&c013, t014.q, t004.q | !e002.q, (!c012.q | t026.q) & jam, (t012.q ^ t020.q | c002.q) & stop, 2);
  ctud_step(&c014, !c013.qd, !t021.q, c011.qu & e009.q & t016.q & jam, (c008.qd ^ g007 ^ c012.q) & stop, 50);
  tof_step(&t028, !t001.q ^ c014.qd, pt_fast);
  ton_step(&t029, c008.qd ^ c014.qu, pt_mid);
  tof_step(&t030, e008.q, MS(30));
  tp_step(&t031, !t030.q ^ !c003.qd, MS(200));
  tof_step(&t032, !t031.q | c013.qu, pt_slow);
  g011 = !t028.q & !g001 & t029.q;
  tof_step(&t033, !(g011 & ck[7]) ^ c012.q, pt_fast);
  ton_step(&t034, t016.q, MS(20));
  w[6] = !t002.q & e008.q | t034.q & t032.q;
  ctd_step(&c015, w[6], (t033.q ^ !c013.qd) & t030.q, 8);
  ton_step(&t035, t030.q & !c015.q ^ t009.q, pt_fast);
  ctu_step(&c016, !c014.qu & t034.q, !ck[7] & t035.q & t027.q, 8);
  g013 = t025.q & !part | c016.q;
  tp_step(&t036, !t034.q | t022.q, MS(1000));
  w[7] = (c009.q | g013) ^ (g009 | t024.q);
  tof_step(&t037, c013.qu, MS(330));
  g015 = w[7] | t019.q & t003.q;
  ftrig_step(&e010, c002.q | g015);
  tp_step(&t038, !c013.qd, MS(500));
  tp_step(&t039, t029.q ^ !t036.q & c014.qu, MS(100));
  tp_step(&t040, !t039.q, pt_fast);
  tp_step(&t041, t038.q, MS(100));
  ton_step(&t042, !g003 & !t042.q, MS(100));
  ton_step(&t043, t033.q, MS(70));
  w[8] = t008.q & (t042.q & !t043.q);
  ton_step(&t044, jam | w[3], MS(25));
  g017 = !ck[6] & t041.q | (!w[6] | t009.q);
  tof_step(&t045, t040.q & (!t032.q | t044.q), pt_slow);
  ftrig_step(&e011, t044.q & t037.q);
  tof_step(&t046, g013 & !e002.q, MS(25));
  tp_step(&t047, !t009.q, MS(150));
  ctud_step(&c017, t047.q, t046.q | e011.q, (!w[6] | !t029.q) & jam, (!(e010.q ^ t031.q) | c016.q) & stop, 1);
  tp_step(&t048, !t031.q, MS(20));
  ctud_step(&c018, !t044.q, !c017.qd, c017.qu & g011 & jam, (t048.q | g017) & stop, 20);
  ctd_step(&c019, c016.q | c018.qd, c018.qu & (t048.q ^ !c012.q), 50);
  ftrig_step(&e012, t035.q & !(c018.qd & e010.q));
  tof_step(&t049, c019.q | c005.q | c018.qd, MS(70));
  tp_step(&t050, !e012.q, pt_fast);
  tof_step(&t051, !t049.q & t050.q, MS(330));
  ton_step(&t052, g013 | t051.q, MS(30));
  tp_step(&t053, t052.q, MS(50));
  ftrig_step(&e013, w[8]);
  ctu_step(&c020, !t036.q, load ^ g015 | e013.q, 20);
  w[9] = c020.q ^ !t043.q ^ t053.q;
  ftrig_step(&e014, e013.q | c018.qd);
  ton_step(&t054, t052.q, MS(40));
  tp_step(&t055, c017.qd, MS(100));
  ton_step(&t056, (!e014.q ^ t055.q) & !t056.q, MS(1500));
  tp_step(&t057, t056.q ^ !w[9] & e014.q, pt_mid);
  g019 = !t054.q & (!t057.q & c017.qd);
  tof_step(&t058, g011 | t048.q & w[2], pt_slow);
  w[10] = !t058.q & (t044.q & !t011.q & t056.q);
  tof_step(&t059, part & (!t052.q & g019), pt_mid);
  tp_step(&t060, w[10] | (t059.q | !t044.q), MS(500));
  ctu_step(&c021, t055.q, t060.q | !t054.q, 50);
  tof_step(&t061, t047.q | !(c013.qu ^ c021.q), MS(50));
  tof_step(&t062, t031.q ^ t061.q, MS(50));
  ton_step(&t063, t062.q, MS(150));
  tof_step(&t064, t004.q & t063.q, MS(330));
  tp_step(&t065, t064.q ^ !t056.q, pt_mid);
  tof_step(&t066, t065.q, MS(30));
  tp_step(&t067, !t066.q, pt_mid);
  tp_step(&t068, t055.q | t067.q & w[10], pt_fast);
  tof_step(&t069, t065.q & t013.q | t029.q, MS(30));
  ton_step(&t070, (c003.qd | e014.q ^ c020.q) & !t070.q, pt_slow);
  ton_step(&t071, t070.q & !t068.q & !t071.q, MS(50));
  ton_step(&t072, t052.q & (!t071.q | !t064.q), pt_fast);
  ctd_step(&c022, t054.q & !t064.q, e002.q ^ t045.q, 20);
  ctud_step(&c023, w[9], t044.q, (c012.q | t011.q) & jam, (t060.q & t072.q | t069.q) & stop, 10);
  ctu_step(&c024, c023.qu, c023.qd | t062.q | !c020.q, 1);
  ctd_step(&c025, t033.q, !c024.q ^ t067.q, 8);
  tof_step(&t073, c025.q | e002.q, pt_fast);
  ctud_step(&c026, !c023.qd & !t069.q, !t057.q ^ !w[9], t054.q & t064.q & jam, ck[4] & (c023.qu ^ !t059.q) & stop, 50);
  tof_step(&t074, ck[6] ^ c026.qd, MS(150));
  ctu_step(&c027, jam | t074.q, t003.q | t069.q, 10);
  rtrig_step(&e015, t065.q);
  rtrig_step(&e016, c022.q ^ !(!t070.q & !load));
  ctd_step(&c028, t067.q ^ c024.q, !e015.q & !c026.qu ^ c027.q, 10);
  tp_step(&t075, !e002.q, pt_mid);
  tp_step(&t076, t075.q, MS(200));
  ctd_step(&c029, t073.q ^ e004.q, c015.q | !t076.q ^ t002.q, 10);
  tof_step(&t077, (!e015.q | c028.q) ^ !t069.q, pt_slow);
  ton_step(&t078, t068.q ^ t008.q & !c023.qu, pt_mid);
  ctd_step(&c030, c023.qd & !c029.q, !(t078.q | t068.q) | e016.q, 50);
  tof_step(&t079, t077.q, MS(150));
  g021 = !c030.q & t079.q | c028.q;
  tp_step(&t080, g021 | !c023.qd, pt_slow);
  w[11] = !t080.q ^ t066.q & (t032.q & t046.q);
  tp_step(&t081, w[11] & c026.qu | t079.q, pt_fast);
  g023 = t081.q | stop & t067.q;
  ton_step(&t082, t027.q | !t079.q, MS(30));
  ctd_step(&c031, t058.q, !g003 & !g023 & !t026.q, 3);
  rtrig_step(&e017, t080.q & !c025.q);
  ctud_step(&c032, !c031.q, t065.q, (!e010.q ^ e015.q) & jam, (!t082.q | c031.q | t081.q) & stop, 8);
  tof_step(&t083, !c017.qu, MS(150));
  ton_step(&t084, g021 | t074.q, MS(20));
  ton_step(&t085, t083.q, MS(200));
  tof_step(&t086, (t056.q ^ t085.q) & t084.q, MS(70));
  ctd_step(&c033, c019.q, g009 & !t077.q, 1);
  ctd_step(&c034, c033.q & c032.qu, !t054.q & t079.q & !t061.q, 3);
  ctu_step(&c035, t086.q, w[11] | c034.q, 10);
  w[12] = !c035.q & c011.qd | !c023.qu & c032.qd;
  tof_step(&t087, !c031.q | t067.q & g011, MS(100));
  tp_step(&t088, !t087.q, MS(1500));
  ctd_step(&c036, !t051.q & c032.qd, t085.q & w[12], 3);
  g025 = c036.q ^ !t088.q & c031.q;
  tof_step(&t089, g021, pt_fast);
  w[13] = (t089.q | c013.qu) & !e016.q & g025;
  ton_step(&t090, w[13] ^ e007.q, MS(40));
  tof_step(&t091, !t002.q & !(c007.qd ^ t090.q), MS(40));
  ctu_step(&c037, c015.q, t091.q & (t070.q ^ g021), 5);
  g027 = (c037.q ^ t084.q) & c036.q;
  ton_step(&t092, t052.q ^ g027 & !t008.q, MS(1000));
  ton_step(&t093, t066.q | t092.q, MS(200));
  tof_step(&t094, t093.q, MS(200));
  tof_step(&t095, t083.q, pt_mid);
  ctud_step(&c038, t075.q, t095.q & t082.q, c036.q & !w[5] & jam, (t066.q | t083.q) & stop, 2);
  w[14] = c038.qu & (!t011.q & !t022.q);
  tp_step(&t096, t092.q, pt_slow);
  rtrig_step(&e018, w[14] | t009.q);
  ctud_step(&c039, c035.q & !e018.q, t096.q, c012.q & (t088.q ^ g027) & jam, (!c038.qu | (!c034.q | w[12])) & stop, 10);
  g029 = !c039.qu & (!c039.qd | t088.q);
  ton_step(&t097, !g029, pt_mid);
  ctud_step(&c040, t097.q, t089.q ^ !g027, ((t094.q | !w[12]) ^ t084.q) & jam, (!w[2] | !t075.q) & stop, 5);
  ctud_step(&c041, !c039.qu, t095.q ^ t089.q, (!c003.qd | t095.q) & c038.qd & jam, (!t094.q | !c039.qu & g029) & stop, 20);
  ton_step(&t098, c041.qu & (!c041.qd | !e009.q), MS(25));
  ctu_step(&c042, !c003.qu, t098.q & t091.q, 5);
  w[15] = !t052.q | c038.qd & c042.q;
  ton_step(&t099, c026.qd | t006.q | c041.qu, MS(40));
  ctu_step(&c043, c037.q, w[15] | t027.q, 5);
  g031 = t099.q | c043.q | g027;
  ctd_step(&c044, c042.q, t078.q | !c039.qu & !start, 5);
  w[16] = c044.q & (g029 & !t090.q);
  ctu_step(&c045, c040.qd, !(!t032.q ^ t094.q) ^ e001.q, 1);
  ctu_step(&c046, w[16] ^ part, c045.q | g031, 8);
  ctd_step(&c047, c046.q, c014.qu & w[15], 20);
  g033 = !c047.q & c044.q & !t092.q;
  ftrig_step(&e019, !g025 | !c041.qu);
  ton_step(&t100, !g033 ^ t031.q ^ e019.q, MS(1000));
  ctud_step(&c048, !t100.q & !w[14], !c043.q | !e012.q, t078.q & c043.q & jam, ((g029 | c045.q) ^ t096.q) & stop, 5);
  tof_step(&t101, !t096.q & c048.qu, pt_mid);
  ctd_step(&c049, !c045.q, !t099.q ^ !t058.q, 8);
  ton_step(&t102, c048.qd | t101.q, MS(70));
  w[17] = t038.q & (c009.q & !c049.q);
  tp_step(&t103, !t006.q | w[5] | !t081.q, MS(25));
  ton_step(&t104, c040.qu ^ (!t101.q | c003.qu), MS(330));
  g035 = t104.q & !t103.q & w[17];
  ton_step(&t105, (ck[5] | t099.q ^ t102.q) & !t105.q, MS(20));
  tp_step(&t106, !t102.q, MS(40));
  w[18] = !t064.q ^ t097.q | (t022.q | !t105.q);
  ton_step(&t107, !c040.qd & !t107.q, pt_mid);
  ton_step(&t108, t098.q | g035, MS(30));
  g037 = g015 ^ t108.q & !t107.q;
  ctd_step(&c050, !w[16] | w[18], t019.q | !t106.q | !c044.q, 1);
  w[19] = (!g037 | !t052.q) & w[17];
  ctu_step(&c051, e002.q | g033, !w[17] & w[19], 8);
  tp_step(&t109, c051.q | !ck[3], pt_slow);
  rtrig_step(&e020, !t105.q);
  tof_step(&t110, c010.qd & !t109.q, MS(200));
  tof_step(&t111, !g037 | !ck[5], MS(25));
  tof_step(&t112, !e020.q & !c031.q & w[6], MS(150));
  g039 = t110.q & c050.q & t083.q ^ !t112.q;
  tof_step(&t113, g039 & (load & t111.q), MS(150));
  w[20] = t113.q & c020.q ^ (e006.q | !g035);
  ton_step(&t114, (w[20] | !t106.q) ^ e020.q, MS(25));
  tp_step(&t115, t100.q, MS(70));
  tof_step(&t116, t113.q | t114.q, MS(500));
  tof_step(&t117, t102.q & t115.q, pt_mid);
  g041 = t111.q & (t075.q | t117.q) | c051.q;
  tp_step(&t118, g041 & g039, MS(50));
  ton_step(&t119, !c049.q ^ t118.q & ck[4], MS(40));
  tof_step(&t120, t116.q | !t119.q | t017.q, pt_slow);
  tof_step(&t121, t108.q & t120.q, pt_mid);
  rtrig_step(&e021, ck[0] ^ !(!t117.q & !t121.q));
  rtrig_step(&e022, t029.q);
  tof_step(&t122, g007 & e022.q, MS(30));
  ctu_step(&c052, w[15], !t060.q & t115.q | t041.q, 10);
  ctud_step(&c053, !c052.q, t122.q & t118.q, w[20] & e021.q & jam, t108.q & t110.q & stop, 8);
  ton_step(&t123, ((!c053.qu | c053.qd) ^ t110.q) & !t123.q, MS(30));
  tp_step(&t124, !t006.q & (!t123.q ^ c003.qd), pt_slow);
  ton_step(&t125, c053.qd, MS(1500));
  ctud_step(&c054, t120.q, g035, t122.q & e005.q & jam, (t124.q ^ (g041 | t115.q)) & stop, 2);
  w[21] = c054.qd & (c014.qd | c054.qu | t114.q);
  ton_step(&t126, t104.q & !w[21], MS(20));
  tof_step(&t127, t038.q | t126.q | t113.q, pt_fast);
  ctud_step(&c055, g023 | g031, !t043.q | t110.q, (c053.qd | (w[20] | e020.q)) & jam, (e021.q | !c054.qu | t111.q) & stop, 20);
  ctu_step(&c056, c054.qu ^ !g041, c039.qd & c055.qu, 10);
  g043 = !c056.q ^ (!c002.q | c055.qd) & !t115.q;
  tof_step(&t128, g041 & t109.q, MS(150));
  ctu_step(&c057, !g043, t122.q ^ c052.q, 2);
  tp_step(&t129, e022.q, MS(1500));
  ctu_step(&c058, t085.q, !t128.q | t129.q, 8);
  w[22] = !c058.q & !(c057.q | ck[5]);
  rtrig_step(&e023, t095.q & c053.qd);
  g045 = w[22] ^ !c056.q & t012.q;
  tp_step(&t130, !t113.q & !g033, MS(50));
  ton_step(&t131, g029, MS(150));
  w[23] = !(!t119.q | t010.q) & !(t130.q | t131.q);
  tp_step(&t132, g045 | t117.q & !e023.q, MS(500));
  tof_step(&t133, c021.q ^ t125.q, MS(30));
  ton_step(&t134, !w[23] & !t134.q, MS(150));
  tp_step(&t135, (c023.qu | t015.q) ^ !e023.q, MS(70));
  ton_step(&t136, (!t134.q | !w[21]) & w[23], MS(25));
  g047 = (t136.q | t135.q) & c040.qu;
  tof_step(&t137, t133.q ^ t029.q & !t132.q, pt_fast);
  ftrig_step(&e024, g047);
  tp_step(&t138, !c040.qd ^ e023.q, MS(150));
  ctd_step(&c059, t070.q, (e019.q ^ c057.q) & c036.q, 50);
  w[24] = !c059.q | (!t137.q | e024.q);
  ctu_step(&c060, t133.q, t138.q & (w[24] | t119.q), 3);
  tp_step(&t139, c055.qd, MS(1500));
  ctd_step(&c061, t139.q | g047, c060.q | w[21], 20);
  tp_step(&t140, c061.q & !t065.q | t134.q, MS(500));
  ton_step(&t141, (c060.q | !t140.q) & !t141.q, pt_slow);
  ctu_step(&c062, t141.q & c056.q, e023.q & !(!c061.q & w[22]), 5);
  ton_step(&t142, t133.q, pt_mid);
  g049 = !t119.q & t015.q & !(w[22] ^ !t142.q);
  ctu_step(&c063, t134.q & e023.q, !c030.q ^ g047 | g049, 10);
  ctud_step(&c064, c062.q, c063.q | !g047, t030.q & !t132.q & jam, (c014.qu ^ c059.q | t109.q) & stop, 1);
  tp_step(&t143, !c064.qd ^ (!c060.q | !t097.q), MS(30));
  ton_step(&t144, (!g049 | c049.q) & t023.q, MS(20));
  ctu_step(&c065, t144.q ^ c048.qd, t143.q ^ (t014.q | !t144.q), 5);
  ctu_step(&c066, e023.q, !t134.q & c064.qu & c065.q, 3);
  tp_step(&t145, t133.q & t140.q | c066.q, pt_slow);
  rtrig_step(&e025, t145.q ^ w[24]);
  tof_step(&t146, (g049 | w[24]) ^ e025.q, MS(330));
  ctd_step(&c067, t146.q, c022.q & !t137.q & !t139.q, 2);
  ctu_step(&c068, !c065.q ^ g049, !e019.q & !t146.q ^ c067.q, 5);
  tp_step(&t147, t030.q ^ c068.q, MS(70));
  w[25] = t147.q | !t138.q | t146.q ^ c039.qu;
  tp_step(&t148, t144.q | t136.q, MS(70));
  g051 = !t148.q ^ !ck[7] ^ ck[6];
  tp_step(&t149, !w[25] & (!load ^ g051), MS(20));
  ctu_step(&c069, c063.q & t149.q, g051 & (e024.q ^ g049), 5);
  w[26] = c069.q & c064.qd & (!t138.q ^ t143.q);
  ctd_step(&c070, !w[26] & !t147.q, t050.q ^ t147.q, 20);
  g053 = !c070.q ^ !(t149.q & !w[23]) | !t145.q;
  ctd_step(&c071, !c062.q | t121.q, t141.q ^ t146.q & g053, 10);
  ton_step(&t150, t036.q | c062.q, pt_slow);
  ctu_step(&c072, c061.q | !g051, t150.q | c071.q, 3);
  w[27] = t062.q | c072.q & !e020.q;
  ctu_step(&c073, t148.q, w[25] & !c070.q ^ w[6], 20);
  g055 = c073.q & !w[27] & e025.q | t150.q;
  ctud_step(&c074, !g055 & g051, c073.q | e017.q, (t146.q | c065.q) & jam, (c067.q ^ !g033) & stop, 1);
  w[28] = !(!t070.q & !t024.q) & !c064.qd;
  ctud_step(&c075, !c074.qu, t144.q, t150.q & c068.q & jam, (c074.qd ^ t089.q) & stop, 10);
  tp_step(&t151, c016.q | c075.qu, pt_fast);
  tof_step(&t152, !c075.qd & !t150.q & g019, pt_mid);
  g057 = t144.q & (t152.q | w[28]);
  ctu_step(&c076, !c066.q ^ !t145.q, !t151.q | c071.q ^ !t150.q, 50);
  ctud_step(&c077, !g055 | c069.q, t152.q, (t150.q ^ c069.q) & jam, c076.q & !t151.q & stop, 3);
  ctu_step(&c078, c074.qd, t148.q | (w[27] | g057), 1);
  w[29] = c078.q & (!c077.qu & c077.qd);
  ctd_step(&c079, w[28], !w[29] | g057, 50);
  ftrig_step(&e026, !c062.q | g013);
  tp_step(&t153, c079.q, pt_slow);
  tp_step(&t154, e026.q ^ (!t153.q | c077.qd), pt_mid);
  ton_step(&t155, ((c074.qu | c070.q) ^ t103.q) & !t155.q, pt_slow);
  g059 = !t155.q | !t088.q & t154.q;
  tof_step(&t156, c013.qd, MS(50));
  tof_step(&t157, t034.q, MS(150));
  tof_step(&t158, g057 & !e026.q | t157.q, pt_mid);
  ton_step(&t159, g059 & t060.q, pt_slow);
  ton_step(&t160, (!c074.qu | !e003.q) & c074.qd, pt_slow);
  tof_step(&t161, !t156.q, MS(30));
  ton_step(&t162, t148.q, pt_fast);
  ftrig_step(&e027, t159.q & t160.q);
  ctud_step(&c080, t158.q, t161.q & c018.qu, ck[3] & t126.q & jam, (!c018.qu | !w[18]) & stop, 50);
  ctu_step(&c081, !c074.qu & !c034.q, !t162.q & t161.q, 10);
  ftrig_step(&e028, !c080.qu);
  ftrig_step(&e029, t106.q & (!t154.q | stop));
  tp_step(&t163, c081.q, pt_mid);
  tof_step(&t164, (e028.q ^ !t163.q) & c064.qu, MS(30));
  tp_step(&t165, !t159.q, pt_slow);
  ctu_step(&c082, t164.q | !c080.qu, g053 ^ e029.q | c080.qd, 5);
  w[30] = !t165.q ^ !c082.q ^ c077.qu | t160.q;
  ton_step(&t166, w[30] | g059, pt_mid);
  ctu_step(&c083, c079.q | !e027.q, t164.q ^ t166.q, 5);
  tp_step(&t167, (c083.q ^ t162.q) & !g037, MS(150));
  ctu_step(&c084, !w[6], c036.q ^ !c077.qd, 1);
  ctu_step(&c085, !t167.q & !t164.q, c084.q & !w[30] | c080.qd, 1);
  ctud_step(&c086, t162.q, t158.q, (!g023 ^ g015) & jam, w[29] & t122.q & stop, 2);
  ton_step(&t168, !c084.q & c083.q | !t092.q, MS(330));
  rtrig_step(&e030, !c076.q ^ (t168.q | t153.q));
  ctd_step(&c087, w[13] | c082.q, e030.q & t165.q | t162.q, 50);
  ctd_step(&c088, t027.q ^ c086.qd, !(c087.q | c086.qu) & t166.q, 3);
  ftrig_step(&e031, t160.q | c084.q);
  ctd_step(&c089, !e031.q ^ c081.q, c088.q & !e028.q & !c083.q, 8);
  g061 = w[24] & ((!c089.q ^ t165.q) & c040.qu);
  ton_step(&t169, c086.qd & c084.q, pt_fast);
  rtrig_step(&e032, c023.qu | (t165.q | t161.q));
  ctu_step(&c090, g045 & !e032.q, t167.q ^ c086.qu, 2);
  tof_step(&t170, !c090.q | e030.q & t169.q, MS(100));
  w[31] = g061 & !(t170.q | c086.qu) | c081.q;
  rtrig_step(&e033, e028.q & (w[31] ^ t170.q));
  ftrig_step(&e034, t077.q & e033.q | !c080.qd);
  tof_step(&t171, !g057 & (e034.q | t168.q), MS(70));
  tof_step(&t172, !g039 & (t171.q | !e034.q), MS(1500));
  g063 = t172.q | (e029.q | !c089.q);
  tp_step(&t173, g003, pt_mid);
  ctud_step(&c091, !c089.q, c087.q & !t173.q, (c083.q ^ !w[18]) & jam, (!t169.q | !t021.q) & stop, 5);
  ctud_step(&c092, !c091.qu ^ t170.q, t064.q, (!t156.q | t125.q) & jam, !t165.q & w[30] & !c086.qu & stop, 3);
  tof_step(&t174, c092.qd & c092.qu | t170.q, MS(25));
  tp_step(&t175, c086.qu & (t101.q & !t174.q), MS(100));
  w[32] = t175.q | !c088.q & !c089.q;
  tof_step(&t176, !w[32], MS(25));
  tof_step(&t177, t176.q & t175.q, pt_mid);
  g065 = !t177.q & (t169.q ^ (!c070.q ^ !c087.q));
  ctud_step(&c093, !t010.q, !c011.qd, (e014.q | !g065) & jam, (c087.q | e011.q) & stop, 50);
  tof_step(&t178, !c093.qd | c089.q & t174.q, MS(200));
  tof_step(&t179, t177.q ^ !e034.q, MS(100));
  ton_step(&t180, t178.q & t043.q ^ t172.q, MS(1500));
  ctu_step(&c094, !t179.q, g063 & c093.qu, 8);
  ctu_step(&c095, t180.q, (g065 | c094.q) & !c090.q, 3);
  ctud_step(&c096, c086.qu, !e029.q, (t122.q | !start) & !c090.q & jam, (t177.q | e032.q & !c093.qu) & stop, 50);
  ftrig_step(&e035, !c096.qu | !t176.q);
  rtrig_step(&e036, !c035.q | t133.q);
  w[33] = e036.q & e035.q & c096.qd;
  tof_step(&t181, t170.q & (!g065 ^ t013.q), pt_mid);
  g067 = (t181.q | w[32]) & t159.q;
  tp_step(&t182, w[33] ^ (c037.q | t011.q), MS(330));
  tp_step(&t183, !c093.qd, MS(1000));
  ctd_step(&c097, t183.q, t178.q ^ !g067 & t033.q, 10);
  w[34] = !t062.q | (t182.q | c097.q);
  tof_step(&t184, t117.q, pt_fast);
  ton_step(&t185, !w[34] | !g065 & g047, pt_fast);
  rtrig_step(&e037, t179.q & c093.qd);
  g069 = c091.qd | !t022.q | !e030.q & t174.q;
  ton_step(&t186, !g069 | !t184.q ^ e037.q, MS(200));
  tp_step(&t187, !t165.q ^ c094.q | c003.qd, pt_mid);
  tof_step(&t188, t179.q | t185.q, pt_fast);
  tp_step(&t189, t179.q ^ e013.q, MS(200));
  tof_step(&t190, t186.q & (c096.qu | !t037.q), MS(50));
  ton_step(&t191, t189.q & t158.q ^ t187.q, MS(70));
  w[35] = t191.q & (!t190.q & c089.q) ^ t188.q;
  tof_step(&t192, w[35], MS(500));
  ctd_step(&c098, !t096.q | t126.q, !t181.q & t192.q, 50);
  ton_step(&t193, t184.q ^ !c098.q, MS(20));
  ton_step(&t194, c094.q | (t063.q | w[34]), MS(40));
  g071 = (t194.q ^ (e037.q | t193.q)) & g067;
  ton_step(&t195, !g071 & !c097.q, pt_slow);
  w[36] = e037.q & !(t195.q | t187.q);
  ftrig_step(&e038, !w[35] ^ e032.q);
  tp_step(&t196, t024.q, pt_fast);
  ctu_step(&c099, t186.q, e038.q & !t006.q | !t196.q, 50);
  ftrig_step(&e039, !t067.q);
  ctd_step(&c100, e039.q & c099.q, !t183.q | c091.qu, 3);
  ctd_step(&c101, c100.q | w[36], t169.q & (c055.qd & c034.q), 10);
  tof_step(&t197, c101.q & w[30], pt_fast);
  g073 = !w[36] & (t197.q & t042.q);
  ctd_step(&c102, t164.q, t191.q & g073, 50);
  ctu_step(&c103, t196.q | !c102.q, !t185.q | w[35] | !t186.q, 3);
  w[37] = !c103.q | (!c097.q & t192.q | w[35]);
  tof_step(&t198, t184.q ^ (w[37] | w[35]), MS(50));
  tp_step(&t199, !t184.q ^ !t021.q & !t024.q, MS(100));
  g075 = t199.q & (t198.q | t187.q) ^ !c008.qu;
  ton_step(&t200, g071, MS(20));
  ton_step(&t201, !e026.q, MS(30));
  ctu_step(&c104, c080.qd, c003.qd ^ t194.q, 50);
  rtrig_step(&e040, t200.q & !t179.q);
  ctu_step(&c105, e013.q, e006.q & t045.q & !t201.q, 2);
  ton_step(&t202, g075 & (!e040.q | c044.q), MS(40));
  tof_step(&t203, w[29] | w[36], pt_fast);
  w[38] = (!t202.q | t186.q) & !c095.q;
  ctu_step(&c106, !t203.q, w[38] & w[19] & g075, 50);
  g077 = c105.q | (c104.q | c106.q);
  ton_step(&t204, t019.q, pt_fast);
  tp_step(&t205, t195.q, pt_slow);
  tp_step(&t206, (!g077 | !c105.q) & t084.q, pt_mid);
  ftrig_step(&e041, t199.q & c102.q | t204.q);
  w[39] = !(t206.q & t139.q) | t205.q;
  ctud_step(&c107, w[39], e008.q | c102.q, (!t204.q ^ (t134.q ^ !e039.q)) & jam, !c101.q & t206.q & !e002.q & stop, 10);
  tp_step(&t207, g077 | !(c107.qu | e015.q), pt_slow);
  ton_step(&t208, (c026.qu ^ !t154.q) & !t208.q, pt_slow);
  tp_step(&t209, c107.qd | t208.q | !t040.q, MS(1500));
  tp_step(&t210, t209.q, MS(25));
  ftrig_step(&e042, e040.q | c002.q);
  ton_step(&t211, !t210.q | c016.q, MS(50));
  tp_step(&t212, !t211.q & t072.q, MS(20));
  g079 = t212.q ^ (e042.q ^ t207.q | t210.q);
  ctu_step(&c108, g079, g075 & c104.q ^ !t208.q, 10);
  ton_step(&t213, c003.qu | !t202.q, pt_fast);
  w[40] = t213.q | !t051.q | !c108.q;
  ton_step(&t214, t145.q ^ t175.q | t212.q, MS(20));
  g081 = c057.q | t063.q & c099.q;
  tp_step(&t215, g079 & (t076.q ^ t214.q), pt_slow);
  ctud_step(&c109, g081, t210.q | c105.q, (!g081 & w[38] | c108.q) & jam, (c107.qu | !t210.q) & stop, 20);
  ton_step(&t216, !t211.q, MS(70));
  ton_step(&t217, t216.q, pt_mid);
  ctu_step(&c110, c109.qu, (t217.q ^ !t120.q) & c106.q, 5);
  ctu_step(&c111, c109.qd & w[5], t207.q & c109.qd | !t085.q, 8);
  tof_step(&t218, t191.q ^ t215.q | !t198.q, MS(200));
  ctu_step(&c112, !c108.q, t213.q & c110.q, 2);
  ton_step(&t219, t211.q | !t108.q, MS(70));
  tp_step(&t220, t219.q, MS(70));
  ton_step(&t221, t218.q, pt_fast);
  ton_step(&t222, (t218.q | t220.q) ^ w[40], MS(70));
  ctud_step(&c113, c112.q & t211.q, t222.q | t053.q, t041.q & !w[31] & jam, !c111.q & !c007.qu & stop, 20);
  rtrig_step(&e043, c113.qu & c113.qd);
  ctu_step(&c114, !e043.q | !t210.q, c109.qu & (t037.q & t216.q), 5);
  w[41] = (c114.q | w[40]) & (t213.q ^ c111.q);
  rtrig_step(&e044, !c108.q & !w[41]);
  tof_step(&t223, e044.q & !c045.q & c109.qd, MS(1500));
  g083 = t042.q | (w[11] | c034.q);
  ftrig_step(&e045, (g083 ^ !g007) & !t223.q);
  tof_step(&t224, c109.qu | (t205.q | e045.q), pt_mid);
  tof_step(&t225, g011, MS(500));
  tp_step(&t226, t225.q, MS(200));
  ton_step(&t227, t226.q ^ (c054.qd ^ w[20]), MS(500));
  ton_step(&t228, t218.q | !t224.q, MS(30));
  w[42] = t025.q | t228.q ^ !(!t227.q & !g081);
  ton_step(&t229, !t221.q ^ t215.q, pt_slow);
  tp_step(&t230, !w[42] ^ t229.q, MS(70));
  g085 = t177.q & (g055 & !t230.q);
  ton_step(&t231, g085 | t058.q, pt_fast);
  w[43] = t231.q | (c110.q | t218.q);
  ton_step(&t232, ((c114.q | g049) ^ t230.q) & !t232.q, MS(25));
  tp_step(&t233, t221.q & w[20] | !w[43], pt_slow);
  tof_step(&t234, t194.q, MS(30));
  tp_step(&t235, g083, pt_slow);
  g087 = t235.q & !t234.q & !t233.q;
  tof_step(&t236, t232.q | t224.q ^ !g087, MS(20));
  ton_step(&t237, !t236.q, MS(50));
  tp_step(&t238, e044.q ^ t237.q, MS(100));
  ctud_step(&c115, t225.q | !t224.q, c044.q | t238.q, (g087 | t236.q) & e043.q & jam, !(e044.q & !g067) & t227.q & stop, 1);
  ton_step(&t239, !w[11] & c115.qd, pt_mid);
  tof_step(&t240, t239.q ^ c014.qd, pt_mid);
  w[44] = g023 & !c115.qu & !t240.q;
  tp_step(&t241, t195.q & w[44], MS(70));
  ton_step(&t242, t226.q, MS(50));
  ton_step(&t243, !t206.q | !t242.q, MS(100));
  tp_step(&t244, t240.q | g083, MS(40));
  tp_step(&t245, t243.q ^ t237.q, MS(30));
  ctu_step(&c116, t244.q & !t162.q, !t245.q & t190.q | t112.q, 1);
  ctd_step(&c117, t224.q, !t047.q | !g007 ^ t241.q, 8);
  g089 = c116.q | (c117.q | w[44]);
  ctud_step(&c118, g089 ^ t226.q, t245.q, (t235.q | t231.q) & jam, t158.q & !c115.qu & stop, 1);
  tp_step(&t246, c118.qd, MS(100));
  tp_step(&t247, !t218.q, MS(50));
  w[45] = !t246.q & !t165.q | (t247.q | c118.qu);
  tp_step(&t248, t239.q | t178.q, MS(30));
  ctu_step(&c119, w[4], (!t248.q | w[45]) & w[44], 3);
  g091 = c119.q | t235.q & (w[15] & !t241.q);
  tp_step(&t249, !t050.q, MS(50));
  tof_step(&t250, t101.q, pt_mid);
  w[46] = c118.qu ^ (c059.q ^ !t250.q);
  ftrig_step(&e046, !c118.qd);
  g093 = g091 ^ !(w[46] & !t188.q);
  rtrig_step(&e047, !t173.q);
  w[47] = !e046.q | (c011.qu | g055);
  ctud_step(&c120, t249.q & c047.q, w[47], t162.q & e047.q & jam, (w[43] ^ !t239.q) & stop, 20);
  tof_step(&t251, e047.q | !c120.qu, MS(40));
  tp_step(&t252, t215.q, pt_fast);
  tof_step(&t253, !t250.q & !t224.q, MS(30));
  g095 = t253.q & t251.q | t252.q;
  ctud_step(&c121, !t092.q, t227.q, (t243.q ^ c119.q | c120.qd) & jam, g095 & c118.qu & stop, 8);
  ctu_step(&c122, c121.qu, (g093 | !c121.qd) & c118.qu, 8);
  tp_step(&t254, t251.q, MS(330));
  tp_step(&t255, !c122.q & (!c055.qd & t005.q), MS(25));
  tp_step(&t256, c116.q, MS(1500));
  tof_step(&t257, !t009.q, pt_mid);
  w[48] = t255.q & t249.q | !t257.q & c017.qu;
  tp_step(&t258, g093, MS(1500));
  tof_step(&t259, t256.q & (t252.q | !w[48]), MS(50));
  tp_step(&t260, t251.q ^ t248.q, MS(70));
  ton_step(&t261, w[48], MS(70));
  tp_step(&t262, c011.qd ^ c120.qd, MS(1500));
  tof_step(&t263, t259.q ^ (t258.q | c007.qd), MS(330));
  ftrig_step(&e048, !(!c121.qu | t262.q) & t261.q);
  tp_step(&t264, !t254.q & t263.q | t258.q, MS(330));
  rtrig_step(&e049, !c120.qu | !e048.q & t254.q);
  g097 = (t264.q | t260.q) & e049.q;
  ctu_step(&c123, g097, !e046.q | !g093 | c120.qu, 10);
  ctu_step(&c124, t251.q & g097, t164.q & (t262.q & !t200.q), 20);
  w[49] = !c124.q | t091.q & !c123.q ^ !t260.q;
  tof_step(&t265, !(t006.q ^ t264.q) & t257.q, MS(70));
  ctud_step(&c125, !w[49] & t095.q, !g067 & t258.q, (!(t265.q | g095) ^ !t251.q) & jam, (t254.q ^ (c120.qd | !c012.q)) & stop, 50);
  tof_step(&t266, c125.qu | t125.q & e036.q, MS(25));
  ton_step(&t267, g021 ^ (g071 ^ g055), pt_fast);
  tp_step(&t268, t039.q, MS(40));
  g099 = t254.q | t073.q & (c125.qd | !t266.q);
  ftrig_step(&e050, g073 & (t267.q & !g095));
  ctd_step(&c126, g099, (e050.q | !t126.q) & t268.q, 20);
  w[50] = !(c126.q & !c124.q) | w[49] ^ c084.q;
  rtrig_step(&e051, !t088.q | w[50]);
  g101 = t258.q ^ (!e051.q | !w[4]);
  tp_step(&t269, !t258.q, pt_mid);
  ftrig_step(&e052, !g101 & t265.q);
  w[51] = !t269.q ^ !e052.q ^ e050.q;
  tof_step(&t270, c064.qu | w[51], pt_slow);
  tof_step(&t271, !t229.q & (t270.q & t268.q), pt_slow);
  g103 = c125.qd | t271.q & g053;
  ftrig_step(&e053, t270.q);
  tof_step(&t272, e053.q | g103, MS(40));
  ctu_step(&c127, c118.qu, e048.q ^ !t272.q, 20);
  w[52] = (t167.q | c127.q) ^ e048.q | e051.q;
  ton_step(&t273, w[52] & (g103 ^ t263.q), pt_mid);
  tp_step(&t274, t117.q & w[40] | t270.q, MS(100));
  ctd_step(&c128, w[50] | !t254.q, g099 & t232.q, 3);
  ctd_step(&c129, e053.q ^ !c128.q, !(t243.q ^ t273.q) & t174.q, 8);
  tp_step(&t275, g103 & w[49], MS(70));
  g105 = t068.q & (c129.q & (t274.q & !t275.q));
  tp_step(&t276, !c125.qd, MS(150));
  ton_step(&t277, t276.q ^ (t268.q ^ e052.q), MS(70));
  w[53] = (g105 | t277.q) & (t270.q & t266.q);
  ctud_step(&c130, c129.q, t234.q & e052.q, !t191.q & t270.q & jam, (e013.q | (t277.q | !t189.q)) & stop, 3);
  ton_step(&t278, c130.qd ^ g103, MS(20));
  ton_step(&t279, (!t204.q | t145.q) & !t279.q, MS(30));
  g107 = !(e028.q | !c130.qu ^ t028.q) & e016.q;
  tp_step(&t280, !w[4], MS(330));
  tof_step(&t281, t279.q, MS(50));
  w[54] = (t278.q | !t281.q ^ !g107) ^ t280.q;
  tof_step(&t282, w[54], MS(200));
  g109 = !c107.qu | t282.q & (!g105 | w[2]);
  ctu_step(&c131, t275.q & !g109, w[54] ^ (t277.q | g103), 20);
  w[55] = !c131.q ^ w[51] & (t191.q ^ g041);
  ton_step(&t283, !w[55], MS(40));
  rtrig_step(&e054, !w[31] & c101.q | e031.q);
  tp_step(&t284, e054.q & t270.q & !t283.q, MS(200));
  g111 = !t284.q & w[55] & t274.q ^ t275.q;
  ton_step(&t285, !c081.q & (!g111 ^ c131.q), MS(330));
  rtrig_step(&e055, t273.q & g071);
  ctd_step(&c132, c022.q ^ t282.q, t285.q ^ !(c128.q ^ g105), 1);
  tp_step(&t286, !t274.q | c132.q, pt_fast);
  ftrig_step(&e056, e055.q & g037);
  ctd_step(&c133, w[28] | !e056.q, t286.q & !c125.qd, 5);
  ctu_step(&c134, c049.q, c133.q ^ !t015.q, 3);
  tp_step(&t287, t284.q, pt_mid);
  ton_step(&t288, c109.qu | !t277.q, MS(100));
  w[56] = t288.q & !c134.q & ck[2];
  ctu_step(&c135, g039 | c130.qu, c130.qu & !g105 | !t281.q, 50);
  g113 = !w[56] | t125.q | c135.q & !c086.qd;
  tof_step(&t289, g113 & w[54], MS(40));
  ton_step(&t290, t124.q | !t289.q, MS(150));
  tof_step(&t291, (t025.q | t287.q) & !w[54], pt_slow);
  w[57] = !t290.q | t291.q | t285.q;
  tof_step(&t292, t290.q, MS(40));
  ton_step(&t293, (!w[57] & t292.q | !e056.q) & !t293.q, pt_slow);
  g115 = (t293.q | g005) ^ t292.q;
  rtrig_step(&e057, !g115);
  w[58] = (!c092.qd ^ c041.qd) & !e057.q;
  ctud_step(&c136, w[19], !g115, (!t290.q | e054.q) & jam, (c133.q | c068.q) & t283.q & stop, 50);
  tof_step(&t294, !c136.qu & (w[57] & !t026.q), pt_fast);
  rtrig_step(&e058, !c136.qd | e054.q & !e057.q);
  ctu_step(&c137, e058.q, t090.q ^ t294.q | t105.q, 50);
  ctd_step(&c138, !c137.q | g013, w[57] & !t288.q, 2);
  ton_step(&t295, c138.q | t289.q, MS(30));
  ctu_step(&c139, t287.q, c077.qu | g113, 5);
  g117 = (!t001.q ^ t295.q) & c139.q | g073;
  ton_step(&t296, t288.q ^ (e055.q | !t292.q), pt_mid);
  tp_step(&t297, t288.q, MS(20));
  ctu_step(&c140, !t014.q, !g095 & !g117 | c042.q, 1);
  ton_step(&t298, !c135.q & t289.q ^ t296.q, MS(1000));
  tof_step(&t299, !t298.q & !w[22], pt_mid);
  ton_step(&t300, w[44] ^ c019.q, pt_slow);
  rtrig_step(&e059, !t300.q);
  ftrig_step(&e060, c140.q);
  o[0] = t297.q;
  o[1] = t299.q;
  o[2] = e059.q;
  o[3] = e060.q;
  o[4] = t299.q ^ e059.q;
  o[5] = t008.q ^ t297.q;
  o[6] = t051.q ^ c133.q;
  o[7] = e060.q ^ t188.q;
  o[8] = !c060.q ^ t232.q;
  o[9] = t107.q ^ t065.q;
  o[10] = t014.q ^ t107.q;
  o[11] = !t285.q ^ w[17];
  o[12] = !e050.q ^ run;
  o[13] = g067 ^ g019;
  o[14] = t009.q ^ c060.q;
  o[15] = load ^ t133.q;
  o[16] = t245.q ^ e052.q;
  o[17] = c115.qu ^ c037.q;
  o[18] = c010.qu ^ t018.q;
  o[19] = !t056.q ^ c088.q;
  o[20] = w[23] ^ e041.q;
  o[21] = c104.q ^ t186.q;
  o[22] = w[40] ^ t293.q;
  o[23] = !t075.q ^ t173.q;
  o[24] = !e005.q ^ g041;
  o[25] = g045 ^ c115.qu;
  o[26] = c116.q ^ c107.qu;
  o[27] = t045.q ^ t172.q;
  o[28] = !c064.qd ^ c070.q;
  o[29] = t298.q ^ t205.q;
  o[30] = g041 ^ c058.q;
  o[31] = !t204.q ^ t088.q;
  o[32] = !t286.q ^ c048.qd;
  o[33] = c007.qd ^ c072.q;
  o[34] = load ^ c054.qu;
  o[35] = !c078.q ^ ck[6];
  o[36] = t011.q ^ c092.qd;
  o[37] = !t254.q ^ g021;
  o[38] = c020.q ^ load;
  o[39] = g083 ^ t150.q;
  o[40] = t055.q ^ t227.q;
  o[41] = e060.q ^ c118.qd;
  o[42] = !t004.q ^ t098.q;
  o[43] = !t192.q ^ t132.q;
  o[44] = !g065 ^ ck[6];
  o[45] = t176.q ^ t095.q;
  o[46] = w[41] ^ e017.q;
  o[47] = c115.qd ^ w[9];
  o[48] = t058.q ^ e056.q;
  o[49] = !c041.qd ^ w[22];
  o[50] = c090.q ^ t228.q;
  o[51] = e052.q ^ g069;
  o[52] = t107.q ^ c013.qu;
  o[53] = !c059.q ^ t073.q;
  o[54] = t169.q ^ c064.qd;
  o[55] = ck[1] ^ g051;
  o[56] = !c119.q ^ t208.q;
  o[57] = c100.q ^ t037.q;
  o[58] = !t121.q ^ c015.q;
  o[59] = t212.q ^ t251.q;
  o[60] = !c120.qd ^ t175.q;
  o[61] = e002.q ^ w[22];
  o[62] = c016.q ^ t296.q;
  o[63] = g033 ^ c080.qu;

  int32_t acc = 0;
  if (t003.et > MS(15)) acc += 9;
  if (t009.et > MS(15)) acc += 5;
  if (t012.et > MS(60)) acc += 6;
  if (t015.et > MS(20)) acc += 7;
  if (t018.et > MS(140)) acc += 8;
  if (t021.et > MS(140)) acc += 5;
  if (t024.et > MS(140)) acc += 1;
  if (t027.et > MS(10)) acc += 3;
  if (t030.et > MS(20)) acc += 1;
  if (t033.et > MS(20)) acc += 3;
  if (t036.et > MS(10)) acc += 1;
  if (t042.et > MS(60)) acc += 7;
  if (t045.et > MS(320)) acc += 3;
  if (t051.et > MS(20)) acc += 4;
  if (t054.et > MS(15)) acc += 1;
  if (t060.et > MS(320)) acc += 7;
  if (t063.et > MS(25)) acc += 6;
  if (t066.et > MS(20)) acc += 1;
  if (t069.et > MS(20)) acc += 1;
  if (t072.et > MS(10)) acc += 7;
  if (t078.et > MS(10)) acc += 9;
  if (t081.et > MS(15)) acc += 9;
  if (t084.et > MS(15)) acc += 1;
  if (t087.et > MS(20)) acc += 2;
  if (t090.et > MS(10)) acc += 3;
  if (t093.et > MS(140)) acc += 5;
  if (t099.et > MS(15)) acc += 5;
  if (t102.et > MS(15)) acc += 3;
  if (t105.et > MS(10)) acc += 5;
  if (t108.et > MS(10)) acc += 5;
  if (t111.et > MS(10)) acc += 5;
  if (t114.et > MS(15)) acc += 8;
  if (t117.et > MS(20)) acc += 8;
  if (t120.et > MS(140)) acc += 2;
  if (t123.et > MS(15)) acc += 7;
  if (t126.et > MS(15)) acc += 3;
  if (t132.et > MS(25)) acc += 8;
  if (t135.et > MS(60)) acc += 2;
  if (t141.et > MS(60)) acc += 3;
  if (t144.et > MS(10)) acc += 9;
  if (t150.et > MS(10)) acc += 1;
  if (t153.et > MS(20)) acc += 9;
  if (t156.et > MS(15)) acc += 9;
  if (t159.et > MS(60)) acc += 3;
  if (t162.et > MS(20)) acc += 7;
  if (t168.et > MS(25)) acc += 4;
  if (t171.et > MS(10)) acc += 2;
  if (t174.et > MS(15)) acc += 8;
  if (t177.et > MS(10)) acc += 5;
  if (t180.et > MS(320)) acc += 3;
  if (t186.et > MS(20)) acc += 4;
  if (t189.et > MS(20)) acc += 6;
  if (t192.et > MS(320)) acc += 1;
  if (t195.et > MS(25)) acc += 8;
  if (t198.et > MS(25)) acc += 2;
  if (t201.et > MS(20)) acc += 6;
  if (t204.et > MS(25)) acc += 1;
  if (t207.et > MS(15)) acc += 1;
  if (t210.et > MS(20)) acc += 9;
  if (t213.et > MS(20)) acc += 1;
  if (t216.et > MS(20)) acc += 1;
  if (t219.et > MS(10)) acc += 4;
  if (t222.et > MS(25)) acc += 4;
  if (t225.et > MS(10)) acc += 6;
  if (t228.et > MS(20)) acc += 2;
  if (t231.et > MS(10)) acc += 1;
  if (t234.et > MS(10)) acc += 5;
  if (t237.et > MS(10)) acc += 6;
  if (t240.et > MS(20)) acc += 8;
  if (t243.et > MS(15)) acc += 7;
  if (t246.et > MS(10)) acc += 5;
  if (t252.et > MS(10)) acc += 2;
  if (t255.et > MS(15)) acc += 7;
  if (t261.et > MS(60)) acc += 8;
  if (t264.et > MS(140)) acc += 5;
  if (t267.et > MS(15)) acc += 1;
  if (t270.et > MS(140)) acc += 8;
  if (t273.et > MS(15)) acc += 2;
  if (t279.et > MS(20)) acc += 9;
  if (t282.et > MS(60)) acc += 1;
  if (t285.et > MS(140)) acc += 6;
  if (t288.et > MS(25)) acc += 4;
  if (t291.et > MS(10)) acc += 9;
  if (t294.et > MS(25)) acc += 4;
  if (t297.et > MS(10)) acc += 6;
  if (t300.et > MS(320)) acc += 2;
  acc += c001.cv;
  acc += c002.cv;
  acc += c003.cv;
  acc += c004.cv;
  acc += c005.cv;
  acc += c006.cv;
  acc += c007.cv;
  acc += c008.cv;
  acc += c009.cv;
  acc += c010.cv;
  acc += c011.cv;
  acc += c012.cv;
  acc += c013.cv;
  acc += c014.cv;
  acc += c015.cv;
  acc += c016.cv;
  acc += c017.cv;
  acc += c018.cv;
  acc += c019.cv;
  acc += c020.cv;
  acc += c021.cv;
  acc += c022.cv;
  acc += c023.cv;
  acc += c024.cv;
  acc += c025.cv;
  acc += c026.cv;
  acc += c027.cv;
  acc += c028.cv;
  acc += c029.cv;
  acc += c030.cv;
  acc += c031.cv;
  acc += c032.cv;
  acc += c033.cv;
  acc += c034.cv;
  acc += c035.cv;
  acc += c036.cv;
  acc += c037.cv;
  acc += c038.cv;
  acc += c039.cv;
  acc += c040.cv;
  acc += c041.cv;
  acc += c042.cv;
  acc += c043.cv;
  acc += c044.cv;
  acc += c045.cv;
  acc += c046.cv;
  acc += c047.cv;
  acc += c048.cv;
  acc += c049.cv;
  acc += c050.cv;
  acc += c051.cv;
  acc += c052.cv;
  acc += c053.cv;
  acc += c054.cv;
  acc += c055.cv;
  acc += c056.cv;
  acc += c057.cv;
  acc += c058.cv;
  acc += c059.cv;
  acc += c060.cv;
  acc += c061.cv;
  acc += c062.cv;
  acc += c063.cv;
  acc += c064.cv;
  acc += c065.cv;
  acc += c066.cv;
  acc += c067.cv;
  acc += c068.cv;
  acc += c069.cv;
  acc += c070.cv;
  acc += c071.cv;
  acc += c072.cv;
  acc += c073.cv;
  acc += c074.cv;
  acc += c075.cv;
  acc += c076.cv;
  acc += c077.cv;
  acc += c078.cv;
  acc += c079.cv;
  acc += c080.cv;
  acc += c081.cv;
  acc += c082.cv;
  acc += c083.cv;
  acc += c084.cv;
  acc += c085.cv;
  acc += c086.cv;
  acc += c087.cv;
  acc += c088.cv;
  acc += c089.cv;
  acc += c090.cv;
  acc += c091.cv;
  acc += c092.cv;
  acc += c093.cv;
  acc += c094.cv;
  acc += c095.cv;
  acc += c096.cv;
  acc += c097.cv;
  acc += c098.cv;
  acc += c099.cv;
  acc += c100.cv;
  acc += c101.cv;
  acc += c102.cv;
  acc += c103.cv;
  acc += c104.cv;
  acc += c105.cv;
  acc += c106.cv;
  acc += c107.cv;
  acc += c108.cv;
  acc += c109.cv;
  acc += c110.cv;
  acc += c111.cv;
  acc += c112.cv;
  acc += c113.cv;
  acc += c114.cv;
  acc += c115.cv;
  acc += c116.cv;
  acc += c117.cv;
  acc += c118.cv;
  acc += c119.cv;
  acc += c120.cv;
  acc += c121.cv;
  acc += c122.cv;
  acc += c123.cv;
  acc += c124.cv;
  acc += c125.cv;
  acc += c126.cv;
  acc += c127.cv;
  acc += c128.cv;
  acc += c129.cv;
  acc += c130.cv;
  acc += c131.cv;
  acc += c132.cv;
  acc += c133.cv;
  acc += c134.cv;
  acc += c135.cv;
  acc += c136.cv;
  acc += c137.cv;
  acc += c138.cv;
  acc += c139.cv;
  acc += c140.cv;
  for (int i = 0; i < 64; i++)
    if (o[i])
      acc += i;
  check = (check * 17 + acc + 100000) % 9999991;
}
