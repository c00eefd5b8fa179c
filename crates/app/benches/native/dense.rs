//! Dense networks as plants have them, the same in STL and in C: brackets, exclusive or, set and reset, outputs read back, and bits that
//! lie anywhere in I, Q and 256 bytes of M.

use std::fmt::Write as _;

/// Bytes of inputs and of outputs.
pub(crate) const PROCESS_BYTES: u32 = 64;
/// Bytes of bit memory.
pub(crate) const MEMORY_BYTES: u32 = 256;
/// Statements of one function of generated C: a larger one would keep the C compiler for minutes.
const FUNCTION_STATEMENTS: usize = 200;
/// Terms of a network, and of a bracket.
const TERMS_MAX: u32 = 6;
/// Brackets in one another.
const BRACKETS_MAX: u32 = 3;

/// Numbers of a linear congruential generator.
struct Random(u32);

impl Random {
    fn below(&mut self, limit: u32) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) % limit
    }
}

/// A bit of an area.
#[derive(Clone, Copy)]
struct Bit(char, u32, u32);

impl Bit {
    /// One that is read: half of them outputs and bit memory, which networks before it may have written.
    fn read(random: &mut Random) -> Self {
        match random.below(4) {
            0 | 1 => Self('I', random.below(PROCESS_BYTES), random.below(8)),
            2 => Self('Q', random.below(PROCESS_BYTES), random.below(8)),
            _ => Self('M', random.below(MEMORY_BYTES), random.below(8)),
        }
    }

    fn written(random: &mut Random) -> Self {
        match random.below(2) {
            0 => Self('Q', random.below(PROCESS_BYTES), random.below(8)),
            _ => Self('M', random.below(MEMORY_BYTES), random.below(8)),
        }
    }

    fn in_stl(self) -> String {
        let Self(area, byte, bit) = self;
        format!("{area} {byte}.{bit}")
    }

    fn in_c(self) -> String {
        let Self(area, byte, bit) = self;
        format!("get_bit({area}, {byte}, {bit})")
    }

    fn put(self, value: &str) -> String {
        let Self(area, byte, bit) = self;
        format!("put_bit({area}, {byte}, {bit}, {value});")
    }
}

/// A program in both languages, as it is written.
#[derive(Default)]
struct Both {
    stl: String,
    statements: usize,
}

impl Both {
    fn statement(&mut self, text: &str) {
        self.stl.push_str(text);
        self.stl.push_str(";\n");
        self.statements += 1;
    }

    /// Terms that are combined from left to right; what they are in C.
    fn terms(&mut self, random: &mut Random, depth: u32) -> String {
        let mut result = String::new();
        for term in 0..2 + random.below(TERMS_MAX - 1) {
            let (word, sign) = [("A", '&'), ("O", '|'), ("X", '^')][[0, 0, 0, 1, 1, 2][random.below(6) as usize]];
            let negated = random.below(4) == 0;
            let name = if negated { format!("{word}N") } else { word.to_owned() };
            let value = if depth < BRACKETS_MAX && random.below(5) == 0 {
                self.statement(&format!("{name}("));
                let inner = self.terms(random, depth + 1);
                self.statement(")");
                format!("({inner})")
            } else {
                let bit = Bit::read(random);
                self.statement(&format!("{name} {}", bit.in_stl()));
                bit.in_c()
            };
            let value = if negated { format!("!{value}") } else { value };
            result = if term == 0 { value } else { format!("({result} {sign} {value})") };
        }
        result
    }

    /// A network: its condition, and what is done with it.
    fn network(&mut self, random: &mut Random, c: &mut String) {
        let condition = self.terms(random, 0);
        // Writing to a string cannot fail.
        let _ = writeln!(c, "    rlo = {condition};");
        for _ in 0..1 + random.below(2) {
            let bit = Bit::written(random);
            let (word, in_c) = match random.below(4) {
                0 => ("S", format!("if (rlo) {}", bit.put("1"))),
                1 => ("R", format!("if (rlo) {}", bit.put("0"))),
                _ => ("=", bit.put("rlo")),
            };
            self.statement(&format!("{word} {}", bit.in_stl()));
            let _ = writeln!(c, "    {in_c}");
        }
    }
}

/// Networks of at least so many statements, in STL and in C.
pub(crate) fn source(statements: usize) -> (String, String) {
    let (mut random, mut both) = (Random(4_711), Both::default());
    let mut c = String::from("#include \"plc.h\"\n");
    let mut functions = 0;
    while both.statements < statements {
        let _ = write!(c, "\nstatic __attribute__((noinline)) void part_{functions}(void)\n{{\n    int rlo;\n");
        let end = (both.statements + FUNCTION_STATEMENTS).min(statements);
        while both.statements < end {
            both.network(&mut random, &mut c);
        }
        c.push_str("}\n");
        functions += 1;
    }
    c.push_str("\nvoid scan(void)\n{\n");
    for part in 0..functions {
        let _ = writeln!(c, "    part_{part}();");
    }
    c.push_str("}\n");
    (both.stl, c)
}
