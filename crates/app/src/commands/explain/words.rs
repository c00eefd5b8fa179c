//! Words of the chapters of a course: registers, parts of an operand, types and languages.

/// Spellings of a word, without spaces, and what it means.
struct Word {
    spellings: &'static [&'static str],
    title: &'static str,
    meaning: &'static [&'static str],
}

const fn word(spellings: &'static [&'static str], title: &'static str, meaning: &'static [&'static str]) -> Word {
    Word { spellings, title, meaning }
}

#[rustfmt::skip] // A table.
const WORDS: &[Word] = &[
    word(&["ACCU1", "ACCU2", "ACCU", "AKKU1", "AKKU2", "AKKU"], "ACCU 1 and ACCU 2, the accumulators", &[
        "32 bits each. `L` puts a value into ACCU 1 and what was there into ACCU 2; `T` copies ACCU 1 to a variable.",
        "Arithmetic and comparisons take ACCU 2 (left) and ACCU 1 (right); the result is in ACCU 1.",
        "Example: `L MW 0; L 5; +I; T MW 2` adds 5.",
    ]),
    word(&["ACCU3", "ACCU4", "AKKU3", "AKKU4"], "ACCU 3 and ACCU 4, accumulators of the S7-400", &[
        "`ENT` copies ACCU 2 and ACCU 3 there, `LEAVE` takes them back, and arithmetic closes the gap.",
    ]),
    word(&["AR1", "AR2"], "AR1 and AR2, the address registers", &[
        "32 bits each with a pointer: the bit in bits 0 to 2, the byte in bits 3 to 18, and the area in bits 24 to 31 if it names one.",
        "Loaded with `LAR1`, stored with `TAR1`, moved with `+AR1`; used in `MW [AR1,P#2.0]`. A function block finds its own variables through AR2.",
        "Example: `LAR1 P#M 10.0; L W [AR1,P#2.0]` loads MW 12.",
    ]),
    word(&["DB"], "DB, a data block, and the register that one of them is open in", &[
        "`OPN DB 5` opens it, `L DBW 2` reads it; `L DB5.DBW 2` does both. `CALL FB 1, DB 2` gives an FB its instance.",
    ]),
    word(&["DI"], "DI, the register of the instance data block", &[
        "A function block has its instance open there: `DIW 2` is a word of it. `OPN DI 5` opens another one; `CDB` exchanges the two registers.",
    ]),
    word(&["DBNO", "DINO"], "DBNO and DINO, the number of the open data block", &["`L DBNO` loads the number of the block in the DB register, `L DINO` that in the DI register; 0 if none is open."]),
    word(&["DBLG", "DILG"], "DBLG and DILG, the length of the open data block", &["`L DBLG` loads the length in bytes of the block in the DB register, `L DILG` that in the DI register; 0 if none is open."]),
    word(&["STW"], "STW, the status word", &[
        "Nine bits: BR CC1 CC0 OV OS OR STA RLO /FC, of which bit 0 is /FC and bit 8 is BR. `L STW` loads it, `T STW` stores it.",
        "`sieben explain status` shows what every instruction does to it.",
    ]),
    word(&["OR"], "OR, a bit of the status word", &["An AND before an `O` without an operand was 1: the result of the whole logic string will be 1."]),
    word(&["MCR"], "MCR, the master control relay", &[
        "`MCRA` switches it on for a block, `MCR(` opens a zone that is live while the RLO is 1, `)MCR` closes it, `MCRD` switches it off.",
        "In a zone that is not live `=` and `T` write 0, and `S` and `R` change nothing.",
    ]),
    word(&["POINTER"], "POINTER, a data type of 6 bytes", &[
        "The number of a data block (0 for none) in bytes 0 and 1, then a pointer with its area. Written as `P#M 10.0` or `P#DB5.DBX 0.0`.",
    ]),
    word(&["ANY"], "ANY, a data type of 10 bytes", &[
        "16#10, the code of a type, how many of it (2 bytes), the number of a data block (2 bytes), then a pointer with its area.",
        "Written as `P#M 10.0 BYTE 8` or `P#DB5.DBX 0.0 WORD 4`; a variable or a data block stands for itself.",
        "Codes: BOOL 01, BYTE 02, CHAR 03, WORD 04, INT 05, DWORD 06, DINT 07, REAL 08, DATE 09, TIME_OF_DAY 0A, TIME 0B, S5TIME 0C, DATE_AND_TIME 0E, STRING 13, FB 17, FC 18, DB 19, SDB 1A, COUNTER 1C, TIMER 1D.",
    ]),
    word(&["EN"], "EN, the enable input of a box", &[
        "In LAD and FBD a box is executed only if EN is 1; in ST a call with `EN := 0` is skipped. In STL a jump over the call does it: `JNB`.",
        "ENO is the other end: see `sieben explain ENO`.",
    ]),
    word(&["P#"], "P#, the beginning of a pointer constant", &[
        "`P#2.0` is byte 2, bit 0; `P#M 10.0` names the area too; `P#DB5.DBX 0.0 BYTE 10` is an ANY. `P##name` is the address of a variable of the block.",
    ]),
    word(&["S5T#", "S5TIME#", "S5T", "S5TIME"], "S5T#, a time of an S5 timer", &[
        "`S5T#2S`, `S5T#1M30S`, `S5T#500MS`: 10 ms to 2 h 46 min 30 s. Three BCD digits and a base of 10 ms, 100 ms, 1 s or 10 s; what is smaller than the base is dropped.",
        "Example: `A I 0.0; L S5T#2S; SD T 1`.",
    ]),
    word(&["T#", "TIME#"], "T#, a constant of the type TIME", &["`T#1H30M`, `T#-500MS`: milliseconds in 32 bits, for IEC timers (TP, TON, TOF)."]),
    word(&["L#"], "L#, an integer constant of 32 bits", &["`L L#5` loads a DINT; `L 5` loads an INT, whose upper half is 0."]),
    word(&["C#"], "C#, the value of a counter", &["`L C#25; S C 1` sets a counter to 25: three BCD digits, 0 to 999."]),
    word(&["B#16#", "W#16#", "DW#16#", "16#", "2#"], "16# and 2#, constants in hexadecimal and binary digits", &["`B#16#FF`, `W#16#00FF`, `DW#16#1234_5678` and `2#1010_0101`."]),
    word(&["LAD", "KOP"], "LAD (ladder diagram, KOP in German)", &[
        "A drawing of a network like a circuit diagram: contacts in series and in parallel, boxes, and coils at the right.",
        "Written as text in `.lad` files and after `NETWORK LAD`; `sieben convert --to lad` draws a block, `sieben explain NO` tells what an element does.",
    ]),
    word(&["FBD", "FUP"], "FBD (function block diagram, FUP in German)", &[
        "A drawing of a network with boxes such as & and >=1, whose inputs are operands or other boxes. It shows all that LAD does, and some more.",
        "Written as text in `.fbd` files and after `NETWORK FBD`; `sieben convert --to fbd` draws a block.",
    ]),
    word(&["STL", "AWL"], "STL (statement list, AWL in German)", &["One instruction in each line, such as `A I 0.0`. `sieben explain instructions` lists them."]),
    word(&["RET"], "RET, the return of a block", &["In STL `BEC` leaves the block if the RLO is 1, and `BEU` leaves it always. In Structured Text and SCL it is `RETURN`."]),
];

/// What a word of a course means; its spaces do not count.
pub(super) fn word_of_a_course(text: &str) -> Option<String> {
    let compact: String = text.split_whitespace().collect::<String>().to_ascii_uppercase();
    let found = WORDS.iter().find(|word| word.spellings.contains(&compact.as_str()))?;
    let meaning: String = found.meaning.iter().map(|line| format!("  {line}\n")).collect();
    Some(format!("{}\n{meaning}", found.title))
}

/// All spellings.
pub(super) fn spellings() -> impl Iterator<Item = &'static str> {
    WORDS.iter().flat_map(|word| word.spellings.iter().copied())
}
