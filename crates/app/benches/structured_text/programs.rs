//! Nine programs in Structured Text, and the same work in C.

use std::fmt::Write as _;

use super::side_by_side::{Loaded, read};
use sieben_engine::Program;

/// Scans behind which `check` is compared with a constant.
pub(crate) const CHECKED_SCANS: u64 = 30;
/// Networks of one function of generated C: a function of thousands would keep the C compiler for minutes.
const C_FUNCTION_NETWORKS: usize = 50;

/// A program in both languages.
pub(crate) struct Case {
    /// What it is called.
    pub(crate) name: &'static str,
    /// In Structured Text.
    pub(crate) st: String,
    /// In C.
    pub(crate) c: String,
    /// `check` behind `CHECKED_SCANS` scans, as the program in C counts it, if it is one of ours.
    pub(crate) check: Option<i32>,
}

/// All programs.
pub(crate) fn all() -> Vec<Case> {
    let file =
        |name: &'static str, check| Case { name, st: read(&format!("st/{name}.st")), c: read(&format!("st/{name}.c")), check: Some(check) };
    vec![
        bit_logic(),
        timers(),
        file("sieve", 30_840),
        file("matrix_int", 272_145),
        file("matrix_real", 272_145),
        file("pid", 105_351),
        file("calls", 745_441),
        file("strings", 25_200),
        file("structs", 11_176),
    ]
}

/// `check` as the program has it in memory.
pub(crate) fn check(program: &Program, loaded: &Loaded) -> i32 {
    let found = program.names.open.iter().find_map(|number| Some((number, program.data[number].structure.field("check")?.offset)));
    let (number, offset) = found.expect("a variable `check`");
    let memory = &loaded.machine.memory;
    let at = memory.layout.data_blocks[number].start + offset as usize / 8;
    i32::from_be_bytes(memory.arena[at..at + 4].try_into().expect("four bytes"))
}

/// A sequence without pattern.
struct Random(u32);

impl Random {
    fn below(&mut self, limit: u32) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) % limit
    }
}

/// A text in both languages that grows by statements.
struct Both {
    st: String,
    c: String,
    /// Networks of the last C function, and C functions.
    networks: usize,
    functions: usize,
}

impl Both {
    /// Eight of the inputs `x` change in each scan.
    const INPUTS_ST: &str =
        "FOR i := 0 TO 7 DO\n    state := (state * 75 + 74) MOD 65537;\n    x[(scans * 8 + i) MOD 64] := state > 32768;\nEND_FOR;\n";
    const INPUTS_C: &str = "    for (int32_t i = 0; i < 8; i++) {\n        state = (state * 75 + 74) % 65537;\n        x[(scans * 8 + i) % 64] = state > 32768;\n    }\n";

    /// Begins with variables beside the inputs.
    fn with(st: &str, c: &str) -> Self {
        Self {
            st: format!(
                "PROGRAM Main\nVAR\n    x : ARRAY[0..63] OF BOOL;\n    i, k, state, scans, check : DINT;\n{st}END_VAR\n{}",
                Self::INPUTS_ST
            ),
            c: format!("#include \"st.h\"\n\nstatic uint8_t x[64];\nstatic int32_t state, scans;\n{c}"),
            networks: 0,
            functions: 0,
        }
    }

    fn network(&mut self, st: &str, c: &str) {
        if self.networks.is_multiple_of(C_FUNCTION_NETWORKS) {
            let end = if self.functions > 0 { "}\n" } else { "" };
            let _ = write!(self.c, "{end}\nstatic __attribute__((noinline)) void part_{}(void)\n{{\n", self.functions);
            self.functions += 1;
        }
        self.networks += 1;
        let _ = writeln!(self.st, "{st}");
        let _ = writeln!(self.c, "    {c}");
    }

    /// The program, that counts in `check` last.
    fn case(mut self, name: &'static str, st: &str, c: &str, check: i32) -> Case {
        let _ = write!(self.c, "}}\n\nvoid scan(void)\n{{\n{}", Self::INPUTS_C);
        for part in 0..self.functions {
            let _ = writeln!(self.c, "    part_{part}();");
        }
        let _ = write!(self.c, "{c}    scans++;\n}}\n");
        let _ = write!(self.st, "{st}scans := scans + 1;\nEND_PROGRAM\n");
        Case { name, st: self.st, c: self.c, check: Some(check) }
    }
}

/// 2500 networks of four operands, 250 latches with a seal-in contact, 125 SR and 125 RS.
fn bit_logic() -> Case {
    let mut random = Random(2_025);
    let mut both = Both::with(
        "    y : ARRAY[0..2499] OF BOOL;\n    latch : ARRAY[0..249] OF BOOL;\n    sr : ARRAY[0..124] OF SR;\n    rs : ARRAY[0..124] OF RS;\n",
        "static uint8_t y[2500], latch[250], sr[125], rs[125];\n",
    );
    for network in 0..2500 {
        let [a, b, d] = [(); 3].map(|()| random.below(64));
        let other = random.below(2500);
        both.network(
            &format!("y[{network}] := (x[{a}] AND NOT x[{b}]) OR (x[{d}] AND y[{other}]);"),
            &format!("y[{network}] = (x[{a}] & !x[{b}]) | (x[{d}] & y[{other}]);"),
        );
    }
    for latch in 0..250 {
        let [on, off] = [(); 2].map(|()| random.below(64));
        both.network(
            &format!("latch[{latch}] := (x[{on}] OR latch[{latch}]) AND NOT x[{off}];"),
            &format!("latch[{latch}] = (x[{on}] | latch[{latch}]) & !x[{off}];"),
        );
    }
    for number in 0..125 {
        let [set, reset] = [(); 2].map(|()| random.below(64));
        both.network(
            &format!("sr[{number}](S1 := x[{set}], R := y[{reset}]);"),
            &format!("sr[{number}] = x[{set}] | (!y[{reset}] & sr[{number}]);"),
        );
        both.network(
            &format!("rs[{number}](S := x[{set}], R1 := y[{reset}]);"),
            &format!("rs[{number}] = !y[{reset}] & (x[{set}] | rs[{number}]);"),
        );
    }
    both.case(
        "bool",
        "FOR i := 0 TO 99 DO
    k := (scans * 100 + i) MOD 2500;
    IF y[k] THEN check := check + 1; END_IF;
    IF latch[k MOD 250] THEN check := check + 2; END_IF;
    IF sr[k MOD 125].Q1 THEN check := check + 3; END_IF;
    IF rs[k MOD 125].Q1 THEN check := check + 5; END_IF;
END_FOR;
",
        "    for (int32_t i = 0; i < 100; i++) {
        int32_t k = (scans * 100 + i) % 2500;
        check += y[k] + 2 * latch[k % 250] + 3 * sr[k % 125] + 5 * rs[k % 125];
    }
",
        13_273,
    )
}

/// The instances of `timers` in C.
const TIMERS_C: &str = r"
struct timer { int32_t et, start; uint8_t m, q; };
struct counter { int16_t cv; uint8_t mu, md, q, qd; };
struct edge { uint8_t m, q; };

static struct timer ton[100], tof[100], tp[100];
static struct counter ctu[60], ctd[40], ctud[40];
static struct edge rise[30], fall[30];

static int32_t now_ms(void)
{
    return (int32_t)(now_us / 1000);
}

static int32_t most(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static void run_ton(struct timer *t, uint8_t in, int32_t pt)
{
    if (!in) {
        t->m = t->q = 0;
        t->et = 0;
    } else if (!t->m) {
        t->m = 1;
        t->start = now_ms();
        t->et = 0;
        t->q = pt <= 0;
    } else if (!t->q) {
        t->et = now_ms() - t->start;
        if (t->et >= pt || t->et < 0) {
            t->et = most(pt, 0);
            t->q = 1;
        }
    }
}

static void run_tof(struct timer *t, uint8_t in, int32_t pt)
{
    if (in) {
        t->m = 0;
        t->q = 1;
        t->et = 0;
    } else if (t->q) {
        if (!t->m) {
            t->m = 1;
            t->start = now_ms();
            t->et = 0;
        }
        t->et = now_ms() - t->start;
        if (t->et >= pt || t->et < 0) {
            t->et = most(pt, 0);
            t->q = t->m = 0;
        }
    }
}

static void run_tp(struct timer *t, uint8_t in, int32_t pt)
{
    if (t->q) {
        t->et = now_ms() - t->start;
        if (t->et >= pt || t->et < 0) {
            t->et = most(pt, 0);
            t->q = 0;
        }
    } else if (in && !t->m) {
        t->start = now_ms();
        t->et = 0;
        t->q = pt > 0;
    }
    if (!t->q && !in)
        t->et = 0;
    t->m = in;
}

static void run_ctu(struct counter *c, uint8_t up, uint8_t reset, int16_t pv)
{
    if (reset)
        c->cv = 0;
    else if (up && !c->mu && c->cv < 32767)
        c->cv++;
    c->mu = up;
    c->q = c->cv >= pv;
}

static void run_ctd(struct counter *c, uint8_t down, uint8_t load, int16_t pv)
{
    if (load)
        c->cv = pv;
    else if (down && !c->md && c->cv > -32768)
        c->cv--;
    c->md = down;
    c->q = c->cv <= 0;
}

static void run_ctud(struct counter *c, uint8_t up, uint8_t down, uint8_t reset, uint8_t load, int16_t pv)
{
    uint8_t rises = up && !c->mu, falls = down && !c->md;
    if (reset)
        c->cv = 0;
    else if (load)
        c->cv = pv;
    else if (rises && !falls) {
        if (c->cv < 32767)
            c->cv++;
    } else if (falls && !rises) {
        if (c->cv > -32768)
            c->cv--;
    }
    c->mu = up;
    c->md = down;
    c->q = c->cv >= pv;
    c->qd = c->cv <= 0;
}

static void run_rise(struct edge *e, uint8_t clk)
{
    e->q = clk & !e->m;
    e->m = clk;
}

static void run_fall(struct edge *e, uint8_t clk)
{
    e->q = !clk & !e->m;
    e->m = !clk;
}
";

/// 300 timers, 140 counters and 60 edges, each an instance.
fn timers() -> Case {
    let mut random = Random(61_131);
    let mut both = Both::with(
        "    ton : ARRAY[0..99] OF TON;\n    tof : ARRAY[0..99] OF TOF;\n    tp : ARRAY[0..99] OF TP;\n    ctu : ARRAY[0..59] OF CTU;\n    \
         ctd : ARRAY[0..39] OF CTD;\n    ctud : ARRAY[0..39] OF CTUD;\n    rise : ARRAY[0..29] OF R_TRIG;\n    fall : ARRAY[0..29] OF F_TRIG;\n",
        TIMERS_C,
    );
    for kind in ["ton", "tof", "tp"] {
        for number in 0..100 {
            let (input, ms) = (random.below(64), 10 * (1 + random.below(12)));
            both.network(
                &format!("{kind}[{number}](IN := x[{input}], PT := T#{ms}ms);"),
                &format!("run_{kind}(&{kind}[{number}], x[{input}], {ms});"),
            );
        }
    }
    for (kind, count, names) in [("ctu", 60, ["CU", "R"]), ("ctd", 40, ["CD", "LD"])] {
        for number in 0..count {
            let [count, back, limit] = [random.below(64), random.below(64), random.below(5)];
            both.network(
                &format!("{kind}[{number}]({} := x[{count}], {} := x[{back}], PV := {limit});", names[0], names[1]),
                &format!("run_{kind}(&{kind}[{number}], x[{count}], x[{back}], {limit});"),
            );
        }
    }
    for number in 0..40 {
        let [up, down, reset, load, limit] = [64, 64, 64, 64, 5].map(|limit| random.below(limit));
        both.network(
            &format!("ctud[{number}](CU := x[{up}], CD := x[{down}], R := x[{reset}], LD := x[{load}], PV := {limit});"),
            &format!("run_ctud(&ctud[{number}], x[{up}], x[{down}], x[{reset}], x[{load}], {limit});"),
        );
    }
    for number in 0..30 {
        let [rising, falling] = [(); 2].map(|()| random.below(64));
        both.network(&format!("rise[{number}](CLK := x[{rising}]);"), &format!("run_rise(&rise[{number}], x[{rising}]);"));
        both.network(&format!("fall[{number}](CLK := x[{falling}]);"), &format!("run_fall(&fall[{number}], x[{falling}]);"));
    }
    both.case(
        "timers",
        "FOR i := 0 TO 9 DO
    k := (scans * 10 + i) MOD 30;
    check := check + TIME_TO_DINT(ton[k].ET) + TIME_TO_DINT(tof[k].ET) + TIME_TO_DINT(tp[k].ET);
    check := check + INT_TO_DINT(ctu[k].CV) + INT_TO_DINT(ctd[k].CV) + INT_TO_DINT(ctud[k].CV);
    IF ton[k].Q THEN check := check + 1; END_IF;
    IF tof[k].Q THEN check := check + 2; END_IF;
    IF tp[k].Q THEN check := check + 3; END_IF;
    IF ctu[k].Q THEN check := check + 4; END_IF;
    IF ctd[k].Q THEN check := check + 5; END_IF;
    IF ctud[k].QU THEN check := check + 6; END_IF;
    IF ctud[k].QD THEN check := check + 7; END_IF;
    IF rise[k].Q THEN check := check + 8; END_IF;
    IF fall[k].Q THEN check := check + 9; END_IF;
END_FOR;
",
        "    for (int32_t i = 0; i < 10; i++) {
        int32_t k = (scans * 10 + i) % 30;
        check += ton[k].et + tof[k].et + tp[k].et;
        check += ctu[k].cv + ctd[k].cv + ctud[k].cv;
        check += ton[k].q + 2 * tof[k].q + 3 * tp[k].q + 4 * ctu[k].q + 5 * ctd[k].q;
        check += 6 * ctud[k].q + 7 * ctud[k].qd + 8 * rise[k].q + 9 * fall[k].q;
    }
",
        20_406,
    )
}
