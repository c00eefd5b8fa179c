//! Machine code beside C: `cargo bench -p sieben-app --bench native [NAME [listing]]`; with `listing` the machine code of these programs is
//! printed instead. A name that is an absolute path stands for two files of one's own, `PATH.awl` and `PATH.c`. With `first` it is how long
//! programs take to become machine code that is measured.
//!
//! The same programs in STL and, by hand, in C (`benches/*.c`), compiled by the system's `cc -O3`, take turns in one run. A figure is the
//! best of all turns, as CPU time of the thread, because other work on the machine only ever adds time.
#![allow(clippy::print_stdout)] // A measurement prints its figures.

use std::collections::BTreeMap;
use std::env;
use std::fmt::Write as _;
use std::process::Command;

use side_by_side::{CProgram, Loaded, TURNS, c_program, compiled, load, now_ns};
use sieben_engine::{Interpreter, Machine, StatementEvent, Tracer};
use sieben_jit::{Jit, StatusBits};

#[path = "native/first_tier.rs"]
mod first_tier;
mod side_by_side;

/// The allocator of the command line.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Statements of one function of generated C.
const C_FUNCTION_STATEMENTS: usize = 200;

/// Counts executed statements.
#[derive(Default)]
struct Count(u64);

impl Tracer for Count {
    fn statement(&mut self, _: &Machine, _: &StatementEvent) {
        self.0 += 1;
    }
}

/// A program in both languages.
struct Case {
    name: String,
    stl: String,
    c: String,
    scans: u64,
}

/// Networks of bit logic over random addresses, the same in both languages.
fn bit_logic(statements: usize) -> Case {
    let mut state = 12_345_u32;
    let mut random = |below: u32| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) % below
    };
    let mut stl = String::new();
    let mut c = String::from("#include \"plc.h\"\n");
    let mut functions = 0;
    for network in 0..statements / 4 {
        // A function of 10,000 statements would keep the C compiler for minutes.
        if network % (C_FUNCTION_STATEMENTS / 4) == 0 {
            let end = if functions > 0 { "}\n" } else { "" };
            let _ = write!(c, "{end}\nstatic __attribute__((noinline)) void part_{functions}(void)\n{{\n");
            functions += 1;
        }
        let mut place = || (random(64), random(8));
        let [a, b, o] = [place(), place(), place()];
        let (byte, bit) = (network / 8 % 64, network % 8);
        let _ = write!(stl, "A I {}.{};\nAN M {}.{};\nO I {}.{};\n= Q {byte}.{bit};\n", a.0, a.1, b.0, b.1, o.0, o.1);
        let _ = writeln!(
            c,
            "    put_bit(Q, {byte}, {bit}, (get_bit(I, {}, {}) & !get_bit(M, {}, {})) | get_bit(I, {}, {}));",
            a.0, a.1, b.0, b.1, o.0, o.1
        );
    }
    c.push_str("}\n\nvoid scan(void)\n{\n");
    for part in 0..functions {
        let _ = writeln!(c, "    part_{part}();");
    }
    c.push_str("}\n");
    Case { name: format!("bit logic, {statements} statements"), stl, c, scans: 4_000_000 / statements as u64 }
}

/// The calls mix for so many pairs of motors, each with inputs, outputs, counter, timer and data blocks of its own.
fn calls_mix(pairs: usize) -> Case {
    let [stl, c] = ["awl", "c"].map(|extension| side_by_side::read(&format!("calls_mix.{extension}")));
    let (blocks, rest) = stl.split_once("DATA_BLOCK DB 1").expect("the first data block");
    let (_, last) = rest.split_once("END_ORGANIZATION_BLOCK").expect("the end of OB 1");
    let (functions, _) = c.split_once("void scan(void)").expect("the scan");
    let (mut data, mut program) = (String::new(), String::new());
    let (mut calls, mut scan) = (String::new(), String::new());
    for pair in 0..pairs {
        let (first, second, five) = (100 + 2 * pair, 101 + 2 * pair, 200 + pair);
        let (flag, raw, count, counter, timer) = (100 + pair, 120 + 4 * pair, 122 + 4 * pair, 1 + pair, 20 + pair);
        for instance in [first, second] {
            let _ = writeln!(data, "DATA_BLOCK DB {instance}\nFB 1\nBEGIN\nEND_DATA_BLOCK\n");
        }
        let _ = writeln!(
            data,
            "DATA_BLOCK DB {five}\nSTRUCT\n  setpoint : INT := 42;\n  actual : INT;\n  word : ARRAY [0..15] OF WORD;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
        );
        let _ = writeln!(
            program,
            "NETWORK
      CALL  FC 1 ( raw := MW {raw}, gain := DB{five}.DBW 0, RET_VAL := DB{five}.DBW 2, high := M {flag}.1 );
      CALL  FB 1, DB {first} ( on := I {pair}.0, feedback := I {pair}.1, run := Q {pair}.0, fault := Q {pair}.1 );
      CALL  FB 1, DB {second} ( on := M {flag}.1, feedback := Q {pair}.0, run := Q {pair}.2, fault := Q {pair}.3 );
NETWORK
      A     I {pair}.2;
      CU    C {counter};
      A     I {pair}.3;
      R     C {counter};
      L     C {counter};
      T     MW {count};
      A     I {pair}.4;
      L     S5T#2S;
      SP    T {timer};
      A     T {timer};
      =     Q {pair}.4;
NETWORK
      OPN   DB {five};
      LAR1  P#4.0;
      L     MW {raw};
      T     DBW [AR1, P#2.0];
      L     DBW [AR1, P#0.0];
      INC   1;
      T     DBW [AR1, P#0.0];
      UC    FC 2;
      L     MW {raw};
      + 3;
      T     MW {raw};"
        );
        let _ = writeln!(
            calls,
            "static uint8_t A{pair}[8], B{pair}[8], D{pair}[36] = {{ 0, 42 }};

static void pair_{pair}(void)
{{
    int high;
    put16(D{pair} + 2, (uint16_t)scale((int16_t)get16(M + {raw}), (int16_t)get16(D{pair}), &high));
    put_bit(M, {flag}, 1, high);
    motor(A{pair}, get_bit(I, {pair}, 0), get_bit(I, {pair}, 1));
    put_bit(Q, {pair}, 0, get_bit(A{pair}, 2, 0));
    put_bit(Q, {pair}, 1, get_bit(A{pair}, 2, 1));
    motor(B{pair}, get_bit(M, {flag}, 1), get_bit(Q, {pair}, 0));
    put_bit(Q, {pair}, 2, get_bit(B{pair}, 2, 0));
    put_bit(Q, {pair}, 3, get_bit(B{pair}, 2, 1));

    int up = get_bit(I, {pair}, 2);
    if (up && !C[{counter}].up_edge && C[{counter}].count < 999)
        C[{counter}].count++;
    C[{counter}].up_edge = (uint8_t)up;
    if (get_bit(I, {pair}, 3))
        C[{counter}].count = 0;
    put16(M + {count}, C[{counter}].count);

    start(&T[{timer}], get_bit(I, {pair}, 4), 200, 0, 0);
    put_bit(Q, {pair}, 4, timer_status(&T[{timer}]));

    put16(D{pair} + 6, get16(M + {raw}));
    uint16_t word = get16(D{pair} + 4);
    put16(D{pair} + 4, (uint16_t)((word & 0xFF00) | (uint8_t)(word + 1)));
    last();
    put16(M + {raw}, (uint16_t)(get16(M + {raw}) + 3));
}}
"
        );
        let _ = writeln!(scan, "    pair_{pair}();");
    }
    Case {
        name: format!("calls mix, {pairs} pairs"),
        stl: format!("{blocks}{data}ORGANIZATION_BLOCK OB 1\nBEGIN\n{program}END_ORGANIZATION_BLOCK\n{last}"),
        c: format!("{functions}{calls}void scan(void)\n{{\n{scan}}}\n"),
        scans: 20_000,
    }
}

fn from_files(name: &str, file: &str, scans: u64) -> Case {
    let read = |extension: &str| side_by_side::read(&format!("{file}.{extension}"));
    Case { name: name.to_owned(), stl: read("awl"), c: read("c"), scans }
}

fn c_ns(program: &CProgram, scans: u64) -> f64 {
    let output = Command::new(program.path()).args([scans.to_string(), "5".to_owned()]).output().expect("the C program runs");
    String::from_utf8_lossy(&output.stdout).trim().parse().expect("nanoseconds")
}

fn best_ns(loaded: &mut Loaded, scans: u64) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..5 {
        let start = now_ns();
        (0..scans).for_each(|_| loaded.scan(None));
        best = best.min((now_ns() - start) / scans as f64);
    }
    best
}

fn main() {
    let wanted = env::args().nth(1).filter(|word| !word.starts_with('-')).unwrap_or_default();
    if wanted == "first" {
        return first_tier::print();
    }
    let mut cases = vec![
        bit_logic(4),
        bit_logic(1_000),
        bit_logic(10_000),
        from_files("arithmetic loop", "arithmetic_loop", 20_000),
        from_files("calls mix", "calls_mix", 200_000),
        calls_mix(10),
    ];
    if wanted.starts_with('/') {
        cases = vec![from_files(&wanted, &wanted, 1_000_000)];
    }
    println!(
        "{:<28} {:>6} {:>9} {:>9} {:>9} {:>7} {:>9} {:>10} {:>8}",
        "ns a statement", "count", "interp.", "machine", "cc -O3", "ratio", "native cc", "compile ms", "bytes"
    );
    let mut ratios: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for (index, case) in cases.iter().enumerate() {
        if !case.name.contains(&wanted) {
            continue;
        }
        let program = compiled("bench.awl", &case.stl).expect("it compiles");
        if env::args().nth(2).is_some_and(|word| word == "listing") {
            println!("{}", Jit::listing(&program, &load(&program, Interpreter::load).machine.memory.layout).expect("machine code"));
            continue;
        }
        let [c, tuned] = [&[][..], &["-march=native"]]
            .map(|flags: &[&str]| c_program(&case.name, &case.c, "main.c", flags, index).expect("it compiles"));
        let mut interpreted = load(&program, Interpreter::load);
        let mut count = Count::default();
        interpreted.scan(Some(&mut count));
        let start = now_ns();
        let mut native = load(&program, |program, layout| Jit::compiled(program, layout, StatusBits::Needed).expect("machine code"));
        let compile_ms = (now_ns() - start) / 1e6;
        let (mut machine_ns, mut c_best, mut tuned_best) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
        for _ in 0..TURNS {
            machine_ns = machine_ns.min(best_ns(&mut native, case.scans / 10));
            c_best = c_best.min(c_ns(&c, case.scans / 10));
            tuned_best = tuned_best.min(c_ns(&tuned, case.scans / 10));
        }
        let interpreted_ns = best_ns(&mut interpreted, case.scans / 100);
        let each = |ns: f64| ns / count.0 as f64;
        // The smallest one is the way into machine code and out of it, and no program.
        if count.0 > 10 {
            let kind = case.name.split(',').next().unwrap_or_default();
            ratios.entry(kind).or_default().push(machine_ns / c_best);
        }
        println!(
            "{:<28} {:>6} {:>9.3} {:>9.3} {:>9.3} {:>7.2} {:>9.3} {:>10.2} {:>8}",
            case.name,
            count.0,
            each(interpreted_ns),
            each(machine_ns),
            each(c_best),
            machine_ns / c_best,
            each(tuned_best),
            compile_ms,
            native.engine.code_bytes()
        );
    }
    let mean = |ratios: &[f64]| ratios.iter().product::<f64>().powf(1.0 / ratios.len() as f64);
    let kinds: Vec<f64> = ratios.values().map(|ratios| mean(ratios)).collect();
    if !kinds.is_empty() {
        println!("geometric mean of the kinds, each the mean of its programs: {:.2}", mean(&kinds));
    }
}
