//! The programs of STL, and the same work in C.

use std::fmt::Write as _;

use super::{dense, side_by_side};

/// What the kind of [`dense`] is called.
pub(crate) const DENSE: &str = "dense networks";
/// Statements of one function of generated C.
const C_FUNCTION_STATEMENTS: usize = 200;

/// A program in both languages.
pub(crate) struct Case {
    /// What it is called.
    pub(crate) name: String,
    /// In STL.
    pub(crate) stl: String,
    /// In C.
    pub(crate) c: String,
    /// Scans of a measurement.
    pub(crate) scans: u64,
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

/// Dense networks of so many statements.
fn dense_networks(statements: usize) -> Case {
    let (stl, c) = dense::source(statements);
    Case { name: format!("{DENSE}, {statements} statements"), stl, c, scans: 4_000_000 / statements as u64 }
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

pub(crate) fn from_files(name: &str, file: &str, scans: u64) -> Case {
    let read = |extension: &str| side_by_side::read(&format!("{file}.{extension}"));
    Case { name: name.to_owned(), stl: read("awl"), c: read("c"), scans }
}

/// All programs.
pub(crate) fn all() -> Vec<Case> {
    vec![
        bit_logic(4),
        bit_logic(1_000),
        bit_logic(10_000),
        from_files("arithmetic loop", "arithmetic_loop", 20_000),
        from_files("calls mix", "calls_mix", 200_000),
        calls_mix(10),
        dense_networks(1_000),
        dense_networks(10_000),
    ]
}
