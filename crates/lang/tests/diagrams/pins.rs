//! What the pins of elements take: every pin of every box with operands of every width, and constants of every kind.

use sieben_lang::network::boxes::{BOXES, COMPARISONS, CounterKind, TimerKind};
use sieben_lang::network::pin_types::PinType;
use sieben_lang::network::read::{Answer, Mode, draw};
use sieben_lang::network::reasons::Reason;
use sieben_lang::{Options, compile};
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

use crate::statements::{PLAIN, statements};

/// The messages about pins of a diagram, without the name of its network.
fn messages(text: &str) -> Vec<String> {
    let mut sources = Sources::default();
    sources.add("main.lad", text);
    let found = compile(&sources, &SymbolTable::default(), &Options::default()).diagnostics;
    found
        .into_iter()
        .filter(|one| !matches!(one.problem.code(), "P3013" | "P4013" | "P5028"))
        .map(|one| {
            assert!(matches!(one.problem.code(), "P2410" | "P4022"), "{text}\n{}", one.message);
            one.message.strip_prefix("LAD network 1: ").unwrap_or_else(|| panic!("{text}\n{}", one.message)).to_owned()
        })
        .collect()
}

/// An operand of each width, with its bits.
const WIDTHS: [(&str, u8); 4] = [("M 10.0", 1), ("MB 10", 8), ("MW 10", 16), ("MD 10", 32)];

/// An operand that a pin takes.
fn fitting(pin: PinType) -> &'static str {
    match pin.bits() {
        Some(32) => "MD 20",
        _ => "MW 20",
    }
}

fn fits(pin: PinType, bits: u8) -> bool {
    pin.bits().map_or(bits != 1, |own| own == bits)
}

#[test]
fn every_pin_of_every_box_takes_its_width_and_no_other() {
    for row in BOXES {
        for (pin, takes) in row.types.iter().enumerate() {
            for (operand, bits) in WIDTHS {
                let wired: Vec<&str> =
                    row.types.iter().enumerate().map(|(at, other)| if at == pin { operand } else { fitting(*other) }).collect();
                let (output, inputs) = wired.split_last().expect("a box has an output");
                let text = format!("NETWORK LAD\n    NO  I 0.0\n    {} {} => {output}\n", row.name, inputs.join(", "));
                let found = messages(&text);
                let name = row.inputs.get(pin).copied().unwrap_or("OUT");
                match fits(*takes, bits) {
                    true => assert_eq!(found, Vec::<String>::new(), "{text}"),
                    false => assert!(
                        matches!(found.as_slice(), [one] if one.starts_with(&format!("`{name}` of `{}` takes ", row.name))),
                        "{text}{found:?}"
                    ),
                }
            }
        }
    }
}

#[test]
fn values_of_comparisons_timers_and_counters_have_a_width() {
    let line = |element: &str| format!("NETWORK LAD\n    NO  I 0.0\n{element}");
    for (operand, bits) in WIDTHS {
        for operation in COMPARISONS {
            let takes = PinType::of_comparison(operation);
            let text = format!("NETWORK LAD\n    CMP {operation} {operand}, {}\n    COIL Q 0.0\n", fitting(takes));
            assert_eq!(messages(&text).is_empty(), fits(takes, bits), "{text}");
        }
        let mut texts = vec![line(&format!("    SC C 1, {operand}\n"))];
        for (_, coil, boxed) in TimerKind::ALL {
            texts.push(line(&format!("    {coil} T 1, {operand}\n")));
            for (value, binary, decimal) in [(operand, "MW 20", "MW 22"), ("MW 0", operand, "MW 22"), ("MW 0", "MW 20", operand)] {
                texts.push(line(&format!("    {boxed} T 1\n        TV := {value}\n        BI => {binary}\n        BCD => {decimal}\n")));
            }
        }
        for (_, boxed, _) in CounterKind::ALL {
            for (value, binary, decimal) in [(operand, "MW 20", "MW 22"), ("MW 0", operand, "MW 22"), ("MW 0", "MW 20", operand)] {
                texts.push(line(&format!(
                    "    {boxed} C 1\n        S := I 0.1\n        PV := {value}\n        CV => {binary}\n        CV_BCD => {decimal}\n"
                )));
            }
        }
        for text in texts {
            let found = messages(&text);
            assert_eq!(found.len(), usize::from(bits != 16), "{text}{found:?}");
        }
    }
}

/// A rung, and what is said about it; nothing if it is right.
#[rustfmt::skip] // A table.
const OPERANDS: &[(&str, &str)] = &[
    // Elements that take bits, timers, counters.
    ("NO MW 10\nCOIL Q 0.0", "`NO` takes a bit, a timer, a counter or a status bit, and `MW 10` is a word"),
    ("NC MB 10\nCOIL Q 0.0", "`NC` takes a bit, a timer, a counter or a status bit, and `MB 10` is a byte"),
    ("NO T 1\nNO C 1\nNO OV\nCOIL Q 0.0", ""),
    ("NO I 0.0\nCOIL QW 0", "`COIL` takes a bit, and `QW 0` is a word"),
    ("NO I 0.0\nCOIL T 1", "`COIL` takes a bit, and `T 1` is a timer"),
    ("NO I 0.0\nSET T 1", "`SET` takes a bit, and `T 1` is a timer"),
    ("NO I 0.0\nRESET MD 0", "`RESET` takes a bit, a timer or a counter, and `MD 0` is a double word"),
    ("NO I 0.0\nRESET T 1", ""),
    ("NO I 0.0\nRESET C 1", ""),
    ("NO I 0.0\nP MB 1\nCOIL Q 0.0", "`P` takes a bit, and `MB 1` is a byte"),
    ("NO I 0.0\nN C 1\nCOIL Q 0.0", "`N` takes a bit, and `C 1` is a counter"),
    ("POS IW 0, M 1.0\nCOIL Q 0.0", "`POS` takes a bit, a timer, a counter or a status bit, and `IW 0` is a word"),
    ("NEG I 0.0, MW 1\nCOIL Q 0.0", "`NEG` takes a bit, and `MW 1` is a word"),
    ("NO I 0.0\nMID MW 0\nNO I 0.1\nCOIL Q 0.0", "`MID` takes a bit, and `MW 0` is a word"),
    ("NO I 0.0\nSR MW 0\n    R := I 0.1\nCOIL Q 0.0", "`SR` takes a bit, and `MW 0` is a word"),
    ("NO I 0.0\nRS T 1\n    S := I 0.1\nCOIL Q 0.0", "`RS` takes a bit, and `T 1` is a timer"),
    ("NO I 0.0\nSD C 1, S5T#1S", "`SD` takes a timer, and `C 1` is a counter"),
    ("NO I 0.0\nCU T 1", "`CU` takes a counter, and `T 1` is a timer"),
    ("NO I 0.0\nCD M 0.0", "`CD` takes a counter, and `M 0.0` is a bit"),
    ("NO I 0.0\nSC T 1, C#5", "`SC` takes a counter, and `T 1` is a timer"),
    ("NO I 0.0\nS_ODT M 0.0\n    TV := S5T#1S\n    R := I 0.1\nCOIL Q 0.0", "`S_ODT` takes a timer, and `M 0.0` is a bit"),
    ("NO I 0.0\nS_CUD T 1\n    CD := I 0.1\n    S := I 0.2\n    PV := C#5\n    R := I 0.3\nCOIL Q 0.0", "`S_CUD` takes a counter, and `T 1` is a timer"),
    ("OPN MW 0", "`OPN` takes a data block, `DB` or `DI`, not `MW 0`"),
    // Constants.
    ("NO I 0.0\nADD_I 5, W#16#FF => MW 0", ""),
    ("NO I 0.0\nADD_I L#5, 1 => MW 0", "`IN1` of `ADD_I` takes an INT (16 bits), and `L#5` is a number of 32 bits"),
    ("NO I 0.0\nADD_I 1.5, 1 => MW 0", "`IN1` of `ADD_I` takes an INT (16 bits), and `1.5` is a REAL"),
    ("NO I 0.0\nADD_I T#1S, 1 => MW 0", "`IN1` of `ADD_I` takes an INT (16 bits), and `T#1S` is a number of 32 bits"),
    ("NO I 0.0\nADD_I DW#16#FF, 1 => MW 0", "`IN1` of `ADD_I` takes an INT (16 bits), and `DW#16#FF` is a constant of another width"),
    ("NO I 0.0\nADD_DI MD 0, 5 => MD 4", ""),
    ("NO I 0.0\nADD_DI MD 0, L#-5 => MD 4", ""),
    ("NO I 0.0\nADD_DI MD 0, T#1S => MD 4", ""),
    ("NO I 0.0\nADD_DI MD 0, -5 => MD 4", "`IN2` of `ADD_DI` takes a DINT (32 bits), and `-5` is an INT, whose upper half would be 0"),
    ("NO I 0.0\nADD_DI MD 0, 5.0 => MD 4", "`IN2` of `ADD_DI` takes a DINT (32 bits), and `5.0` is a REAL"),
    ("NO I 0.0\nADD_R MD 0, 5 => MD 4", "`IN2` of `ADD_R` takes a REAL (32 bits), and `5` is an INT"),
    ("NO I 0.0\nADD_R MD 0, L#5 => MD 4", "`IN2` of `ADD_R` takes a REAL (32 bits), and `L#5` is a number of 32 bits"),
    ("NO I 0.0\nADD_R MD 0, 0 => MD 4", ""),
    ("NO I 0.0\nADD_R MD 0, 5.0 => MD 4", ""),
    ("NO I 0.0\nWAND_DW MD 0, DW#16#FF => MD 4", ""),
    ("NO I 0.0\nSHL_W MW 0, 4 => MW 2", ""),
    ("NO I 0.0\nSHL_DW MD 0, W#16#4 => MD 2", ""),
    ("NO I 0.0\nSHL_W MW 0, L#4 => MW 2", "`N` of `SHL_W` takes a WORD (16 bits), and `L#4` is a number of 32 bits"),
    ("NO I 0.0\nSHR_I MW 0, 2.0 => MW 2", "`N` of `SHR_I` takes a WORD (16 bits), and `2.0` is a REAL"),
    ("NO I 0.0\nMOVE 1.5 => MB 0", ""),
    ("NO I 0.0\nMOVE T 1 => MW 0", ""),
    ("NO I 0.0\nADD_I T 1, 1 => MW 0", ""),
    ("NO I 0.0\nADD_DI C 1, 1 => MD 0", "`IN1` of `ADD_DI` takes a DINT (32 bits), and `C 1` is a counter"),
    ("NO I 0.0\nMOVE MW 0 => PIW 0", "`OUT` of `MOVE` takes a byte, word or double word that can be written; or `STW`, not `PIW 0`"),
    ("CMP ==R MD 0, 5\nCOIL Q 0.0", "`IN2` of `CMP ==R` takes a REAL (32 bits), and `5` is an INT"),
    ("CMP >D MD 0, 1.0\nCOIL Q 0.0", "`IN2` of `CMP >D` takes a DINT (32 bits), and `1.0` is a REAL"),
    // Times and counts.
    ("NO I 0.0\nSD T 1, S5T#2S", ""),
    ("NO I 0.0\nSD T 1, W#16#2005", ""),
    ("NO I 0.0\nSD T 1, T#2S", "`TV` of `SD` takes an S5TIME (16 bits), and `T#2S` is a number of 32 bits"),
    ("NO I 0.0\nSD T 1, 5", "`TV` of `SD` takes an S5TIME (16 bits), and `5` is an INT"),
    ("NO I 0.0\nS_PULSE T 1\n    TV := 2.5", "`TV` of `S_PULSE` takes an S5TIME (16 bits), and `2.5` is a REAL"),
    ("NO I 0.0\nSC C 1, C#5", ""),
    ("NO I 0.0\nSC C 1, S5T#2S", "`PV` of `SC` takes a value from C#0 to C#999 (16 bits), and `S5T#2S` is an S5TIME"),
];

#[test]
fn operands_of_elements_are_checked_by_their_kind() {
    for (rung, expected) in OPERANDS {
        let lines: String = rung.lines().map(|line| format!("    {line}\n")).collect();
        // With the keyword and without it.
        for head in ["NETWORK LAD\n", ""] {
            let text = format!("{head}{lines}");
            assert_eq!(messages(&text).join("; "), *expected, "{text}");
        }
    }
}

/// Declarations of an FC, a box, and what is said of declared types: a warning where only the widths fit.
#[rustfmt::skip] // A table.
const DECLARED: &[(&str, &str, &str)] = &[
    ("a : INT", "ADD_I #a, 1 => MW 0", ""),
    ("a : WORD", "ADD_I #a, 1 => MW 0", ""),
    ("a : BYTE", "ADD_I #a, 1 => MW 0", "P2410 `IN1` of `ADD_I` takes an INT (16 bits), and `#a` is a byte"),
    ("a : DINT", "ADD_I #a, 1 => MW 0", "P2410 `IN1` of `ADD_I` takes an INT (16 bits), and `#a` is a double word"),
    ("a : BOOL", "MOVE #a => MW 0", "P2410 `IN` of `MOVE` takes 8, 16 or 32 bits, and `#a` is a bit"),
    ("a : DWORD", "ADD_R #a, 1.0 => MD 0", ""),
    ("a : DINT", "ADD_R #a, 1.0 => MD 0", "P4022 `IN1` of `ADD_R` takes a REAL (32 bits), and what is wired to it is a 32-bit integer"),
    ("a : REAL", "ADD_DI L#1, #a => MD 0", "P4022 `IN2` of `ADD_DI` takes a DINT (32 bits), and what is wired to it is a REAL"),
    ("a : REAL", "ROUND #a => MD 0", ""),
    ("a : STRING[5]", "MOVE #a => MD 0", "P4002 `IN` of `MOVE` cannot have it: `#a` is STRING[5], which does not fit an accumulator; name one of its elements"),
];

#[test]
fn declared_variables_are_checked_by_width_and_by_type() {
    for (declaration, element, expected) in DECLARED {
        let text = format!(
            "FUNCTION FC 1 : VOID\nVAR_INPUT\n{declaration};\nEND_VAR\nBEGIN\nNETWORK LAD\n    NO I 0.0\n    {element}\nEND_FUNCTION\n"
        );
        let mut sources = Sources::default();
        sources.add("main.awl", &text);
        let found = compile(&sources, &SymbolTable::default(), &Options::default()).diagnostics;
        let found: Vec<String> = found
            .iter()
            .filter(|one| one.problem.code() != "P3013")
            .map(|one| format!("{} {}", one.problem.code(), one.message.trim_start_matches("LAD network 1: ")))
            .collect();
        assert_eq!(found.join("; "), *expected, "{text}");
    }
}

/// Statements that no box stands for by their widths, so that what is drawn also compiles.
const NOT_DRAWN: &[(&str, usize)] = &[
    ("L MB0; L 5; ==I; = Q4.0", 1),
    ("L MD0; L MW4; >D; = Q4.0", 2),
    ("A I0.0; L MD4; SD T1", 2),
    ("A I0.0; L MB4; S C1", 2),
    ("A I0.0; L MB4; SD T1; NOP 0; NOP 0; NOP 0; NOP 0", 2),
    ("A I0.0; L MW4; SD T1; NOP 0; L T1; T MD0; NOP 0; NOP 0", 6),
    ("A I0.0; L MW4; SD T1; NOP 0; NOP 0; LC T1; T MB0; NOP 0", 7),
    ("A I0.0; CU C1; BLD 101; A I0.1; L MD0; S C1; NOP 0; NOP 0; NOP 0; NOP 0", 5),
    ("A I0.0; CU C1; BLD 101; NOP 0; NOP 0; NOP 0; L C1; T MD0; NOP 0; NOP 0", 8),
];

#[test]
fn statements_whose_widths_fit_no_element_stay_statements() {
    for (input, statement) in NOT_DRAWN {
        match draw(&statements(input), &PLAIN, 160, Mode::RewritingConstants) {
            Answer::No(refusal) => assert_eq!((refusal.reason, refusal.statement + 1), (Reason::Width, *statement), "{input}"),
            other => panic!("{input}: {other:?}"),
        }
    }
}
