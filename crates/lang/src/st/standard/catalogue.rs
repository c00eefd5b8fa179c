//! The pages of the standard functions and blocks: one row each with its names, what they are for and how they are called.
//!
//! What a dialect has is not said here: [`known`](crate::known_names::known) asks the compiler.

use super::generic::named;
use crate::st::dialect::Dialect;
use crate::st::keywords::Keyword;

/// A page of `spec/functions/`.
#[derive(Debug, PartialEq, Eq)]
pub struct Page {
    /// Its file without the ending: `ton`.
    pub file: &'static str,
    /// What its functions are for, in a few words.
    pub purpose: &'static str,
    /// The names that it explains, in capital letters. Of the conversions, those that stand for the others.
    pub names: &'static [&'static str],
    /// How they are called: `SEL(G: BOOL; IN0: ANY; IN1: ANY): ANY`, of blocks `TON(IN: BOOL; PT: TIME) → Q: BOOL; ET: TIME`; with the
    /// dialects before it where it is not for all that have the name. `…` stands for further inputs of the same kind.
    pub calls: &'static [&'static str],
}

/// Pages of one kind.
#[derive(Debug, PartialEq, Eq)]
pub struct Chapter {
    /// Its heading.
    pub title: &'static str,
    /// Whether time or the order of calls matters: each page has a signal diagram.
    pub signals: bool,
    /// Its pages.
    pub pages: &'static [Page],
}

macro_rules! chapters {
    ($( $title:literal $signals:literal { $( $file:literal $purpose:literal [$($name:literal)*] $($call:literal)*; )* } )*) => {
        /// All pages.
        pub static CHAPTERS: &[Chapter] = &[$(Chapter {
            title: $title,
            signals: $signals,
            pages: &[$(Page { file: $file, purpose: $purpose, names: &[$($name),*], calls: &[$($call),*] }),*],
        }),*];
    };
}

#[rustfmt::skip] // A table.
chapters! {
    "Timers" true {
        "ton" "on late" ["TON" "TON_TIME" "TON_LTIME" "LTON"]
            "TON(IN: BOOL; PT: TIME) → Q: BOOL; ET: TIME" "TON_LTIME(IN: BOOL; PT: LTIME) → Q: BOOL; ET: LTIME" "LTON(IN: BOOL; PT: LTIME) → Q: BOOL; ET: LTIME";
        "tof" "off late" ["TOF" "TOF_TIME" "TOF_LTIME" "LTOF"]
            "TOF(IN: BOOL; PT: TIME) → Q: BOOL; ET: TIME" "TOF_LTIME(IN: BOOL; PT: LTIME) → Q: BOOL; ET: LTIME" "LTOF(IN: BOOL; PT: LTIME) → Q: BOOL; ET: LTIME";
        "tp" "a pulse" ["TP" "TP_TIME" "TP_LTIME" "LTP"]
            "TP(IN: BOOL; PT: TIME) → Q: BOOL; ET: TIME" "TP_LTIME(IN: BOOL; PT: LTIME) → Q: BOOL; ET: LTIME" "LTP(IN: BOOL; PT: LTIME) → Q: BOOL; ET: LTIME";
        "tonr" "the time of several pieces" ["TONR" "TONR_TIME" "TONR_LTIME"] "TONR(IN: BOOL; R: BOOL; PT: TIME) → Q: BOOL; ET: TIME" "TONR_LTIME(IN: BOOL; R: BOOL; PT: LTIME) → Q: BOOL; ET: LTIME";
        "iec_timer" "any timer" ["IEC_TIMER" "IEC_LTIMER" "RESET_TIMER" "PRESET_TIMER"] "RESET_TIMER(timer)" "PRESET_TIMER(duration; timer)";
        "rtc" "a clock that is set" ["RTC"] "iec: RTC(IN: BOOL; PDT: DT) → Q: BOOL; CDT: DT" "codesys: RTC(EN: BOOL; PDT: DT) → Q: BOOL; CDT: DT";
        "scan_clock" "the clock of timers" ["SCAN_CLOCK" "TIME"] "SCAN_CLOCK(): TIME" "TIME(): TIME";
        "s_pulse" "S5 timer: a pulse" ["S_PULSE" "S_IMPULS"] "S_PULSE(T_NO: TIMER; S: BOOL; TV: S5TIME; R: BOOL; BI => WORD; Q => BOOL): S5TIME";
        "s_pext" "S5 timer: a pulse of full length" ["S_PEXT" "S_VIMP"] "S_PEXT(T_NO: TIMER; S: BOOL; TV: S5TIME; R: BOOL; BI => WORD; Q => BOOL): S5TIME";
        "s_odt" "S5 timer: on late" ["S_ODT" "S_EVERZ"] "S_ODT(T_NO: TIMER; S: BOOL; TV: S5TIME; R: BOOL; BI => WORD; Q => BOOL): S5TIME";
        "s_odts" "S5 timer: on late, and it stays" ["S_ODTS" "S_SEVERZ"] "S_ODTS(T_NO: TIMER; S: BOOL; TV: S5TIME; R: BOOL; BI => WORD; Q => BOOL): S5TIME";
        "s_offdt" "S5 timer: off late" ["S_OFFDT" "S_AVERZ"] "S_OFFDT(T_NO: TIMER; S: BOOL; TV: S5TIME; R: BOOL; BI => WORD; Q => BOOL): S5TIME";
    }
    "Counters" true {
        "ctu" "up" ["CTU" "CTU_SINT" "CTU_INT" "CTU_DINT" "CTU_LINT" "CTU_USINT" "CTU_UINT" "CTU_UDINT" "CTU_ULINT" "LCTU"]
            "iec scl tia: CTU(CU: BOOL; R: BOOL; PV: INT) → Q: BOOL; CV: INT" "codesys: CTU(CU: BOOL; RESET: BOOL; PV: WORD) → Q: BOOL; CV: WORD" "CTU_DINT(CU: BOOL; R: BOOL; PV: DINT) → Q: BOOL; CV: DINT";
        "ctd" "down" ["CTD" "CTD_SINT" "CTD_INT" "CTD_DINT" "CTD_LINT" "CTD_USINT" "CTD_UINT" "CTD_UDINT" "CTD_ULINT" "LCTD"]
            "iec tia: CTD(CD: BOOL; LD: BOOL; PV: INT) → Q: BOOL; CV: INT" "codesys: CTD(CD: BOOL; LOAD: BOOL; PV: WORD) → Q: BOOL; CV: WORD" "scl: CTD(CD: BOOL; LOAD: BOOL; PV: INT) → Q: BOOL; CV: INT";
        "ctud" "up and down" ["CTUD" "CTUD_SINT" "CTUD_INT" "CTUD_DINT" "CTUD_LINT" "CTUD_USINT" "CTUD_UINT" "CTUD_UDINT" "CTUD_ULINT" "LCTUD"]
            "iec tia: CTUD(CU: BOOL; CD: BOOL; R: BOOL; LD: BOOL; PV: INT) → QU: BOOL; QD: BOOL; CV: INT"
            "codesys: CTUD(CU: BOOL; CD: BOOL; RESET: BOOL; LOAD: BOOL; PV: WORD) → QU: BOOL; QD: BOOL; CV: WORD"
            "scl: CTUD(CU: BOOL; CD: BOOL; R: BOOL; LOAD: BOOL; PV: INT) → QU: BOOL; QD: BOOL; CV: INT";
        "iec_counter" "any counter" ["IEC_COUNTER" "IEC_SCOUNTER" "IEC_DCOUNTER" "IEC_USCOUNTER" "IEC_UCOUNTER" "IEC_UDCOUNTER"]
            "tia: counter.CTU(CU: BOOL; R: BOOL; PV: INT) → Q: BOOL; CV: INT" "tia: counter.CTD(CD: BOOL; LD: BOOL; PV: INT) → Q: BOOL; CV: INT"
            "tia: counter.CTUD(CU: BOOL; CD: BOOL; R: BOOL; LD: BOOL; PV: INT) → QU: BOOL; QD: BOOL; CV: INT";
        "s_cu" "S5 counter: up" ["S_CU" "Z_VORW"] "S_CU(C_NO: COUNTER; CU: BOOL; S: BOOL; PV: WORD; R: BOOL; CV => WORD; Q => BOOL): WORD";
        "s_cd" "S5 counter: down" ["S_CD" "Z_RUECK"] "S_CD(C_NO: COUNTER; CD: BOOL; S: BOOL; PV: WORD; R: BOOL; CV => WORD; Q => BOOL): WORD";
        "s_cud" "S5 counter: up and down" ["S_CUD" "ZAEHLER"] "S_CUD(C_NO: COUNTER; CU: BOOL; CD: BOOL; S: BOOL; PV: WORD; R: BOOL; CV => WORD; Q => BOOL): WORD";
    }
    "Edges and bistables" true {
        "r_trig" "a rising edge" ["R_TRIG"] "R_TRIG(CLK: BOOL) → Q: BOOL";
        "f_trig" "a falling edge" ["F_TRIG"] "F_TRIG(CLK: BOOL) → Q: BOOL";
        "sr" "set wins" ["SR"] "iec tia: SR(S1: BOOL; R: BOOL) → Q1: BOOL" "codesys: SR(SET1: BOOL; RESET: BOOL) → Q1: BOOL";
        "rs" "reset wins" ["RS"] "iec tia: RS(S: BOOL; R1: BOOL) → Q1: BOOL" "codesys: RS(SET: BOOL; RESET1: BOOL) → Q1: BOOL";
        "sema" "a semaphore" ["SEMA"] "SEMA(CLAIM: BOOL; RELEASE: BOOL) → BUSY: BOOL";
    }
    "Arithmetic" false {
        "add" "sum, difference, product, quotient" ["ADD" "SUB" "MUL" "DIV"] "ADD(IN1: ANY_NUM; IN2: ANY_NUM; …): ANY_NUM" "SUB(IN1: ANY_NUM; IN2: ANY_NUM): ANY_NUM" "MUL(IN1: ANY_NUM; IN2: ANY_NUM; …): ANY_NUM" "DIV(IN1: ANY_NUM; IN2: ANY_NUM): ANY_NUM";
        "mod" "the rest of a division" ["MOD"] "MOD(IN1: ANY_INT; IN2: ANY_INT): ANY_INT";
        "expt" "a power" ["EXPT"] "EXPT(IN1: ANY_REAL; IN2: ANY_NUM): ANY_REAL";
        "move" "the value itself" ["MOVE"] "MOVE(IN: ANY): ANY";
        "abs" "without the sign" ["ABS"] "ABS(IN: ANY_NUM): ANY_NUM";
        "neg" "with the other sign" ["NEG"] "NEG(IN: ANY_NUM): ANY_NUM";
        "sqrt" "root and square" ["SQRT" "SQR"] "SQRT(IN: ANY_REAL): ANY_REAL" "SQR(IN: ANY_REAL): ANY_REAL";
        "exp" "powers and logarithms" ["EXP" "EXPD" "LN" "LOG"] "EXP(IN: ANY_REAL): ANY_REAL" "EXPD(IN: ANY_REAL): ANY_REAL" "LN(IN: ANY_REAL): ANY_REAL" "LOG(IN: ANY_REAL): ANY_REAL";
        "sin" "angles" ["SIN" "COS" "TAN" "ASIN" "ACOS" "ATAN"] "SIN(IN: ANY_REAL): ANY_REAL" "COS(IN: ANY_REAL): ANY_REAL" "TAN(IN: ANY_REAL): ANY_REAL" "ASIN(IN: ANY_REAL): ANY_REAL" "ACOS(IN: ANY_REAL): ANY_REAL" "ATAN(IN: ANY_REAL): ANY_REAL";
        "atan2" "the angle of a point" ["ATAN2"] "ATAN2(Y: ANY_REAL; X: ANY_REAL): ANY_REAL";
        "frac" "what is behind the point" ["FRAC"] "FRAC(IN: ANY_REAL): ANY_REAL";
        "is_valid" "whether it is a number" ["IS_VALID"] "IS_VALID(IN: ANY_REAL): BOOL";
    }
    "Bits" false {
        "and" "logic, bit by bit" ["AND" "OR" "XOR" "NOT"] "AND(IN1: ANY_BIT; IN2: ANY_BIT; …): ANY_BIT" "OR(IN1: ANY_BIT; IN2: ANY_BIT; …): ANY_BIT" "XOR(IN1: ANY_BIT; IN2: ANY_BIT; …): ANY_BIT" "NOT(value): the same type";
        "shl" "shifting" ["SHL" "SHR"] "SHL(IN: ANY_BIT; N: ANY_INT): ANY_BIT" "SHR(IN: ANY_BIT; N: ANY_INT): ANY_BIT";
        "rol" "rotating" ["ROL" "ROR"] "ROL(IN: ANY_BIT; N: ANY_INT): ANY_BIT" "ROR(IN: ANY_BIT; N: ANY_INT): ANY_BIT";
        "swap" "bytes in the other order" ["SWAP" "TO_BIG_ENDIAN" "FROM_BIG_ENDIAN" "TO_LITTLE_ENDIAN" "FROM_LITTLE_ENDIAN"] "SWAP(IN: WORD): WORD" "TO_LITTLE_ENDIAN(IN: WORD): WORD";
        "byte_to_gray" "Gray code" ["BYTE_TO_GRAY" "WORD_TO_GRAY" "DWORD_TO_GRAY" "GRAY_TO_BYTE" "GRAY_TO_WORD" "GRAY_TO_DWORD"] "BYTE_TO_GRAY(X: BYTE): BYTE" "GRAY_TO_BYTE(X: BYTE): BYTE";
        "hexinascii" "digits and characters as numbers" ["BYTE_TO_HEXINASCII" "HEXINASCII_TO_BYTE" "WORD_AS_STRING"] "BYTE_TO_HEXinASCII(B: BYTE): WORD" "HEXinASCII_TO_BYTE(W: WORD): BYTE" "WORD_AS_STRING(W: WORD): STRING";
        "extract" "single bits" ["EXTRACT" "PUTBIT" "PACK" "UNPACK"] "EXTRACT(X: DWORD; N: BYTE): BOOL" "PUTBIT(X: DWORD; N: BYTE; B: BOOL): DWORD"
            "PACK(B0: BOOL; B1: BOOL; B2: BOOL; B3: BOOL; B4: BOOL; B5: BOOL; B6: BOOL; B7: BOOL): BYTE"
            "UNPACK(B: BYTE) → B0: BOOL; B1: BOOL; B2: BOOL; B3: BOOL; B4: BOOL; B5: BOOL; B6: BOOL; B7: BOOL";
        "getbit" "bits by their numbers" ["GETBIT" "SETBIT" "SWITCHBIT"] "GETBIT(X: DWORD; N: BYTE): BOOL" "SETBIT(X: DWORD; N: BYTE): DWORD" "SWITCHBIT(X: DWORD; N: BYTE): DWORD";
        "bit_as_byte" "bits as a number" ["BIT_AS_BYTE" "BIT_AS_WORD" "BIT_AS_DWORD" "BYTE_AS_BIT" "WORD_AS_BIT" "DWORD_AS_BIT"]
            "BIT_AS_BYTE(B00: BOOL; B01: BOOL; B02: BOOL; B03: BOOL; B04: BOOL; B05: BOOL; B06: BOOL; B07: BOOL): BYTE"
            "BYTE_AS_BIT(B: BYTE) → B00: BOOL; B01: BOOL; B02: BOOL; B03: BOOL; B04: BOOL; B05: BOOL; B06: BOOL; B07: BOOL"
            "WORD_AS_BIT(W: WORD) → B00: BOOL; …" "DWORD_AS_BIT(X: DWORD) → B00: BOOL; …";
    }
    "Selection and comparison" false {
        "sel" "one of two" ["SEL"] "SEL(G: BOOL; IN0: ANY; IN1: ANY): ANY";
        "max" "the greatest, the least" ["MAX" "MIN"] "MAX(IN1: ANY; IN2: ANY; …): ANY" "MIN(IN1: ANY; IN2: ANY; …): ANY";
        "limit" "between two limits" ["LIMIT"] "LIMIT(MN: ANY; IN: ANY; MX: ANY): ANY";
        "mux" "one of several" ["MUX"] "MUX(K: ANY_INT; IN0: ANY; IN1: ANY; …): ANY" "scl tia: MUX(K: ANY_INT; IN0: ANY; …; INELSE: ANY): ANY";
        "demux" "to one of several" ["DEMUX"] "DEMUX(number; value; outputs)";
        "gt" "comparisons" ["GT" "GE" "EQ" "LE" "LT" "NE"] "GT(IN1: ANY; IN2: ANY; …): BOOL" "GE(IN1: ANY; IN2: ANY; …): BOOL" "EQ(IN1: ANY; IN2: ANY; …): BOOL" "LE(IN1: ANY; IN2: ANY; …): BOOL" "LT(IN1: ANY; IN2: ANY; …): BOOL" "NE(IN1: ANY; IN2: ANY): BOOL";
    }
    "Conversions" false {
        "round" "a REAL becomes an integer" ["TRUNC" "ROUND" "CEIL" "FLOOR" "TRUNC_INT" "ROUND_INT" "CEIL_INT" "FLOOR_INT"] "TRUNC(IN: ANY_REAL): DINT" "ROUND(IN: ANY_REAL): DINT" "CEIL(IN: ANY_REAL): DINT" "FLOOR(IN: ANY_REAL): DINT" "TRUNC_INT(IN: ANY_REAL): INT" "ROUND_INT(IN: ANY_REAL): INT";
        "real_to_int" "a REAL becomes an integer, rounded" ["REAL_TO_INT" "REAL_TO_DINT" "LREAL_TO_LINT"] "REAL_TO_INT(IN: REAL): INT" "REAL_TO_DINT(IN: REAL): DINT" "LREAL_TO_LINT(IN: LREAL): LINT";
        "int_to_real" "an integer becomes a REAL" ["INT_TO_REAL" "DINT_TO_REAL" "LINT_TO_LREAL"] "INT_TO_REAL(IN: INT): REAL" "DINT_TO_REAL(IN: DINT): REAL" "LINT_TO_LREAL(IN: LINT): LREAL";
        "int_to_dint" "integers of other sizes" ["INT_TO_DINT" "DINT_TO_INT" "DINT_TO_UINT" "DINT_TO_SINT" "TO_INT" "TO_DINT"] "INT_TO_DINT(IN: INT): DINT" "DINT_TO_INT(IN: DINT): INT" "TO_INT(IN: ANY_NUM): INT";
        "word_to_int" "bit strings and integers" ["WORD_TO_INT" "INT_TO_WORD" "WORD_TO_BYTE" "DWORD_TO_DINT" "DINT_TO_DWORD" "REAL_TO_DWORD" "DWORD_TO_REAL"] "WORD_TO_INT(IN: WORD): INT" "INT_TO_WORD(IN: INT): WORD" "REAL_TO_DWORD(IN: REAL): DWORD";
        "bool_to_int" "BOOL and numbers" ["BOOL_TO_INT" "INT_TO_BOOL" "BOOL_TO_BYTE" "BOOL_TO_WORD" "WORD_TO_BOOL"] "BOOL_TO_INT(IN: BOOL): INT" "BOOL_TO_WORD(IN: BOOL): WORD" "WORD_TO_BOOL(IN: WORD): BOOL";
        "char_to_int" "characters and codes" ["CHAR_TO_INT" "INT_TO_CHAR" "CHAR_TO_BYTE" "BYTE_TO_CHAR"] "CHAR_TO_BYTE(IN: CHAR): BYTE" "BYTE_TO_CHAR(IN: BYTE): CHAR";
        "bcd" "decimal digits" ["WORD_BCD_TO_INT" "INT_TO_BCD_WORD" "DWORD_BCD_TO_DINT" "DINT_TO_BCD_DWORD" "WORD_BCD_TO_UINT" "UINT_TO_BCD_WORD" "BCD_TO_UINT" "TO_BCD_WORD" "BCD_TO_INT" "INT_TO_BCD" "BCD_TO_BYTE" "BCD_TO_WORD" "BCD_TO_DWORD" "BYTE_TO_BCD" "WORD_TO_BCD" "DWORD_TO_BCD" "BCD16_TO_INT" "INT_TO_BCD16" "BCD32_TO_DINT" "DINT_TO_BCD32" "IS_VALID_BCD"]
            "scl tia: WORD_BCD_TO_INT(IN: WORD): INT" "scl tia: INT_TO_BCD_WORD(IN: INT): WORD" "iec: WORD_BCD_TO_UINT(IN: WORD): UINT" "iec: UINT_TO_BCD_WORD(IN: UINT): WORD" "codesys: BCD_TO_INT(IN: BYTE): INT" "codesys: INT_TO_BCD(IN: INT): BYTE" "iec: INT_TO_BCD(IN: INT): WORD" "iec: IS_VALID_BCD(IN: ANY_BIT): BOOL" "BCD16_TO_INT(IN: WORD): INT";
        "time_to_dint" "times and numbers" ["TIME_TO_DINT" "DINT_TO_TIME" "TOD_TO_DINT" "LTIME_TO_TIME" "TIME_TO_LTIME"] "TIME_TO_DINT(IN: TIME): DINT" "DINT_TO_TIME(IN: DINT): TIME" "LTIME_TO_TIME(IN: LTIME): TIME";
        "dt_to_date" "date and time of day" ["DT_TO_DATE" "DT_TO_TOD"] "DT_TO_DATE(IN: DT): DATE" "DT_TO_TOD(IN: DT): TOD";
        "s5time_to_time" "times of S5 timers" ["S5TIME_TO_TIME" "TIME_TO_S5TIME"] "S5TIME_TO_TIME(IN: S5TIME): TIME" "TIME_TO_S5TIME(IN: TIME): S5TIME";
        "to_string" "a value becomes text" ["INT_TO_STRING" "DINT_TO_STRING" "REAL_TO_STRING" "BOOL_TO_STRING" "TIME_TO_STRING" "TOD_TO_STRING" "DATE_TO_STRING" "DT_TO_STRING" "TO_STRING"] "DINT_TO_STRING(IN: DINT): STRING" "iec codesys: TO_STRING(IN: ANY): STRING";
        "string_to_time" "a text becomes a time or a date" ["STRING_TO_TIME" "STRING_TO_LTIME" "STRING_TO_DATE" "STRING_TO_TOD" "STRING_TO_LTOD" "STRING_TO_DT"] "STRING_TO_TIME(IN: STRING): TIME" "STRING_TO_DATE(IN: STRING): DATE" "STRING_TO_TOD(IN: STRING): TOD" "STRING_TO_DT(IN: STRING): DT";
        "string_to_wstring" "texts of both widths" ["STRING_TO_WSTRING" "WSTRING_TO_STRING" "CHAR_TO_WCHAR" "WCHAR_TO_WSTRING" "WSTRING_TO_WCHAR"] "STRING_TO_WSTRING(IN: STRING): WSTRING" "WSTRING_TO_STRING(IN: WSTRING): STRING";
        "string_to_int" "a text becomes a number" ["STRING_TO_INT" "STRING_TO_DINT" "STRING_TO_REAL" "STRING_TO_BOOL"] "STRING_TO_INT(IN: STRING): INT" "STRING_TO_REAL(IN: STRING): REAL";
    }
    "Texts" false {
        "len" "the length" ["LEN" "WLEN"] "iec tia: LEN(IN: STRING): INT";
        "left" "the first characters" ["LEFT" "WLEFT"] "iec: LEFT(IN: STRING; L: ANY_INT): STRING" "scl tia: LEFT(IN: STRING; L: INT): STRING" "codesys: LEFT(STR: STRING; SIZE: INT): STRING";
        "right" "the last characters" ["RIGHT" "WRIGHT"] "iec: RIGHT(IN: STRING; L: ANY_INT): STRING" "scl tia: RIGHT(IN: STRING; L: INT): STRING" "codesys: RIGHT(STR: STRING; SIZE: INT): STRING";
        "mid" "characters from the middle" ["MID" "WMID"] "iec: MID(IN: STRING; L: ANY_INT; P: ANY_INT): STRING" "scl tia: MID(IN: STRING; L: INT; P: INT): STRING" "codesys: MID(STR: STRING; LEN: INT; POS: INT): STRING";
        "concat" "one behind the other" ["CONCAT" "WCONCAT"] "iec tia: CONCAT(IN1: STRING; IN2: STRING; …): STRING" "scl: CONCAT(IN1: STRING; IN2: STRING): STRING" "codesys: CONCAT(STR1: STRING; STR2: STRING): STRING";
        "insert" "a text into another" ["INSERT" "WINSERT"] "iec: INSERT(IN1: STRING; IN2: STRING; P: ANY_INT): STRING" "scl tia: INSERT(IN1: STRING; IN2: STRING; P: INT): STRING" "codesys: INSERT(STR1: STRING; STR2: STRING; POS: INT): STRING";
        "delete" "without some characters" ["DELETE" "WDELETE"] "iec: DELETE(IN: STRING; L: ANY_INT; P: ANY_INT): STRING" "scl tia: DELETE(IN: STRING; L: INT; P: INT): STRING" "codesys: DELETE(STR: STRING; LEN: INT; POS: INT): STRING";
        "replace" "some characters by others" ["REPLACE" "WREPLACE"] "iec: REPLACE(IN1: STRING; IN2: STRING; L: ANY_INT; P: ANY_INT): STRING" "scl tia: REPLACE(IN1: STRING; IN2: STRING; L: INT; P: INT): STRING" "codesys: REPLACE(STR1: STRING; STR2: STRING; L: INT; P: INT): STRING";
        "max_len" "room for characters" ["MAX_LEN" "S_MOVE"] "MAX_LEN(text): DINT" "S_MOVE(IN: STRING; OUT => STRING)";
        "strg_to_chars" "characters one by one" ["STRG_TO_CHARS" "CHARS_TO_STRG"] "Strg_TO_Chars(text; first; count; array)" "Chars_TO_Strg(array; first; count; text)";
        "strg_val" "numbers at a place of a text" ["STRG_VAL" "VAL_STRG"] "STRG_VAL(text; format; first; number)" "VAL_STRG(number; size; decimals; format; first; text)";
        "ath" "hexadecimal digits" ["ATH" "HTA"] "ATH(text; count; bytes): WORD" "HTA(bytes; count; text): WORD";
        "find" "where a text begins" ["FIND" "WFIND"] "iec scl tia: FIND(IN1: STRING; IN2: STRING): INT" "codesys: FIND(STR1: STRING; STR2: STRING): INT";
    }
    "Times and dates" false {
        "add_time" "sums and differences" ["ADD_TIME" "ADD_TOD_TIME" "ADD_DT_TIME" "SUB_TIME" "SUB_DATE_DATE" "SUB_TOD_TIME" "SUB_TOD_TOD" "SUB_DT_TIME" "SUB_DT_DT" "ADD_LTIME" "ADD_LTOD_LTIME" "ADD_LDT_LTIME" "SUB_LTIME" "SUB_LDATE_LDATE" "SUB_LTOD_LTIME" "SUB_LTOD_LTOD" "SUB_LDT_LTIME" "SUB_LDT_LDT"]
            "ADD_TIME(IN1: TIME; IN2: TIME): TIME" "ADD_DT_TIME(IN1: DT; IN2: TIME): DT" "SUB_DT_DT(IN1: DT; IN2: DT): TIME";
        "mul_time" "times a number" ["MUL_TIME" "DIV_TIME" "MULTIME" "DIVTIME" "MUL_LTIME" "DIV_LTIME"] "MUL_TIME(IN1: TIME; IN2: ANY_NUM): TIME" "DIV_TIME(IN1: TIME; IN2: ANY_NUM): TIME";
        "concat_date_tod" "a point in time" ["CONCAT_DATE_TOD" "CONCAT_DATE_LTOD"] "CONCAT_DATE_TOD(IN1: DATE; IN2: TOD): DT";
        "concat_date" "from parts, and into parts" ["CONCAT_DATE" "CONCAT_LDATE" "CONCAT_TOD" "CONCAT_LTOD" "CONCAT_DT" "CONCAT_LDT" "SPLIT_DATE" "SPLIT_LDATE" "SPLIT_TOD" "SPLIT_LTOD" "SPLIT_DT" "SPLIT_LDT"]
            "CONCAT_DATE(YEAR: INT; MONTH: INT; DAY: INT): DATE" "CONCAT_TOD(HOUR: INT; MINUTE: INT; SECOND: INT; MILLISECOND: INT): TOD"
            "SPLIT_DATE(IN: DATE; YEAR => INT; MONTH => INT; DAY => INT)" "SPLIT_TOD(IN: TOD; HOUR => INT; MINUTE => INT; SECOND => INT; MILLISECOND => INT)";
        "t_add" "sums and differences of tia" ["T_ADD" "T_SUB" "T_DIFF"] "T_ADD(IN1: TIME; IN2: TIME): TIME" "T_SUB(IN1: TIME; IN2: TIME): TIME" "T_DIFF(IN1: TOD; IN2: TOD): TIME";
        "dtl" "a point in time as a structure" ["DTL_TO_LDT" "LDT_TO_DTL" "DTL_TO_DT" "DT_TO_DTL" "DTL_TO_DATE" "DTL_TO_TOD" "DTL_TO_LTOD" "DATE_TO_DTL"]
            "DTL_TO_LDT(IN: DTL): LDT" "DTL_TO_DATE(IN: DTL): DATE" "DTL_TO_TOD(IN: DTL): TOD" "DTL_TO_LTOD(IN: DTL): LTOD";
        "t_conv" "as what is wanted" ["T_CONV" "T_COMBINE" "S_CONV"] "T_CONV(value): type of the target" "T_COMBINE(date; time of day): type of the target" "S_CONV(value): type of the target";
        "rd_sys_t" "the clock of the CPU" ["RD_SYS_T" "RD_LOC_T" "WR_SYS_T" "WR_LOC_T"] "RD_SYS_T(variable): INT" "WR_SYS_T(variable): INT";
        "runtime" "seconds since the last call" ["RUNTIME"] "RUNTIME(variable): LREAL";
        "day_of_week" "Sunday to Saturday" ["DAY_OF_WEEK"] "DAY_OF_WEEK(IN: DATE): INT";
    }
    "Arrays and memory" false {
        "lower_bound" "first and last index" ["LOWER_BOUND" "UPPER_BOUND"] "LOWER_BOUND(array; dimension): DINT" "UPPER_BOUND(array; dimension): DINT";
        "peek" "memory by numbers" ["PEEK" "PEEK_BOOL" "PEEK_BYTE" "PEEK_WORD" "PEEK_DWORD" "PEEK_LWORD" "POKE" "POKE_BOOL" "POKE_BLK"]
            "PEEK(area: BYTE; dbNumber: DINT; byteOffset: DINT): BYTE" "PEEK_WORD(area: BYTE; dbNumber: DINT; byteOffset: DINT): WORD" "PEEK_BOOL(area: BYTE; dbNumber: DINT; byteOffset: DINT; bitOffset: INT): BOOL" "POKE(area: BYTE; dbNumber: DINT; byteOffset: DINT; value: WORD)";
        "countofelements" "how many elements" ["COUNTOFELEMENTS"] "CountOfElements(array): UDINT";
        "move_blk_variant" "elements from array to array" ["MOVE_BLK_VARIANT"] "MOVE_BLK_VARIANT(array; count; index; index; array): INT";
        "typeof" "what a VARIANT is" ["TYPEOF" "TYPEOFELEMENTS" "IS_ARRAY" "IS_NULL" "NOT_NULL"] "TypeOf(variant) = type" "TypeOfElements(variant) = type" "IS_ARRAY(variant): BOOL" "IS_NULL(variant): BOOL" "NOT_NULL(variant): BOOL";
        "variantget" "the value of a VARIANT" ["VARIANTGET" "VARIANTPUT"] "VariantGet(variant; variable)" "VariantPut(variable; variant)";
        "serialize" "variables as bytes" ["SERIALIZE" "DESERIALIZE"] "Serialize(variable; array of bytes; position): INT" "Deserialize(array of bytes; variable; position): INT";
        "scatter" "bits and arrays of BOOL" ["SCATTER" "GATHER" "SCATTER_BLK" "GATHER_BLK"] "SCATTER(bits; array of BOOL)" "GATHER(array of BOOL; bits)" "SCATTER_BLK(element; count; element of BOOL)" "GATHER_BLK(element of BOOL; count; element)";
        "move_blk" "parts of arrays" ["MOVE_BLK" "UMOVE_BLK" "FILL_BLK" "UFILL_BLK"] "MOVE_BLK(element; count; target element)" "FILL_BLK(value; count; target element)";
    }
    "Names, sizes and numbers" false {
        "sizeof" "bytes" ["SIZEOF"] "SIZEOF(variable or type): INT";
        "queryinterface" "what an interface refers to" ["__QUERYINTERFACE" "__QUERYPOINTER" "__ISVALIDREF"] "__QUERYINTERFACE(interface; wanted): BOOL" "__QUERYPOINTER(interface; pointer): BOOL" "__ISVALIDREF(reference): BOOL";
        "ref" "references" ["REF" "ADR"] "REF(variable): REF_TO its type" "ADR(variable): POINTER TO its type";
        "get_error" "the errors of this block" ["GET_ERR_ID" "GET_ERROR"] "GET_ERR_ID(): WORD" "GET_ERROR(variable of type ErrorStruct)";
        "word_to_block_db" "data blocks by number" ["WORD_TO_BLOCK_DB" "BLOCK_DB_TO_WORD"] "WORD_TO_BLOCK_DB(number): BLOCK_DB" "BLOCK_DB_TO_WORD(block): WORD";
    }
    "Signals and control" true {
        "blink" "on and off" ["BLINK"] "BLINK(ENABLE: BOOL; TIMELOW: TIME; TIMEHIGH: TIME) → OUT: BOOL";
        "gen" "a signal that repeats itself" ["GEN"] "GEN(MODE: INT; BASE: BOOL; PERIOD: TIME; CYCLES: INT; AMPLITUDE: INT; RESET: BOOL) → OUT: INT";
        "hysteresis" "two thresholds" ["HYSTERESIS"] "HYSTERESIS(IN: INT; HIGH: INT; LOW: INT) → OUT: BOOL";
        "freq_measure" "how often in a second" ["FREQ_MEASURE"] "FREQ_MEASURE(IN: BOOL; PERIODS: INT; RESET: BOOL) → OUT: REAL; VALID: BOOL";
        "limitalarm" "above, below, in between" ["LIMITALARM"] "LIMITALARM(IN: INT; HIGH: INT; LOW: INT) → O: BOOL; U: BOOL; IL: BOOL";
        "ramp" "at most so fast" ["RAMP_INT" "RAMP_REAL"] "RAMP_INT(IN: INT; ASCEND: INT; DESCEND: INT; TIMEBASE: TIME; RESET: BOOL) → OUT: INT" "RAMP_REAL(IN: REAL; ASCEND: REAL; DESCEND: REAL; TIMEBASE: TIME; RESET: BOOL) → OUT: REAL";
        "derivative" "how fast it rises" ["DERIVATIVE"] "DERIVATIVE(IN: REAL; TM: DWORD; RESET: BOOL) → OUT: REAL";
        "integral" "the sum over time" ["INTEGRAL"] "INTEGRAL(IN: REAL; TM: DWORD; RESET: BOOL) → OUT: REAL; OVERFLOW: BOOL";
        "statistics" "least, greatest, average" ["STATISTICS_INT" "STATISTICS_REAL" "VARIANCE"] "STATISTICS_INT(IN: INT; RESET: BOOL) → MN: INT; MX: INT; AVG: INT" "STATISTICS_REAL(IN: REAL; RESET: BOOL) → MN: REAL; MX: REAL; AVG: REAL" "VARIANCE(IN: REAL; RESET: BOOL) → OUT: REAL";
        "pid" "a controller" ["PID" "PID_FIXCYCLE" "PD"]
            "PID(ACTUAL: REAL; SET_POINT: REAL; KP: REAL; TN: REAL; TV: REAL; Y_MANUAL: REAL; Y_OFFSET: REAL; Y_MIN: REAL; Y_MAX: REAL; MANUAL: BOOL; RESET: BOOL) → Y: REAL; LIMITS_ACTIVE: BOOL; OVERFLOW: BOOL"
            "PID_FIXCYCLE(ACTUAL: REAL; SET_POINT: REAL; KP: REAL; TN: REAL; TV: REAL; Y_MANUAL: REAL; Y_OFFSET: REAL; Y_MIN: REAL; Y_MAX: REAL; MANUAL: BOOL; RESET: BOOL; CYCLE: REAL) → Y: REAL; LIMITS_ACTIVE: BOOL; OVERFLOW: BOOL"
            "PD(ACTUAL: REAL; SET_POINT: REAL; KP: REAL; TV: REAL; Y_MANUAL: REAL; Y_OFFSET: REAL; Y_MIN: REAL; Y_MAX: REAL; MANUAL: BOOL; RESET: BOOL) → Y: REAL; LIMITS_ACTIVE: BOOL";
    }
    "Scaling" false {
        "norm_x" "analog values" ["NORM_X" "SCALE_X"] "NORM_X(MIN: ANY_NUM; VALUE: ANY_NUM; MAX: ANY_NUM): ANY_REAL" "SCALE_X(MIN: ANY_NUM; VALUE: ANY_REAL; MAX: ANY_NUM): ANY_NUM";
        "charcurve" "a curve through points" ["CHARCURVE"] "CHARCURVE(IN: INT; N: BYTE; P: ARRAY[0..10] OF POINT) → OUT: INT; ERR: BYTE";
        "lin_trafo" "from one range to another" ["LIN_TRAFO"] "LIN_TRAFO(IN: REAL; IN_MIN: REAL; IN_MAX: REAL; OUT_MIN: REAL; OUT_MAX: REAL) → OUT: REAL; ERROR: BOOL";
    }
}

/// Functions that a conversion belongs to: the type of its input, that of its result, the page. The first row that fits counts; `*` is
/// any type.
#[rustfmt::skip] // A table.
const CONVERSIONS: &[(&[&str], &[&str], &str)] = &[
    (&["STRING", "WSTRING", "CHAR", "WCHAR"], &["WSTRING"], "string_to_wstring"),
    (&["WSTRING"], &["STRING", "WCHAR"], "string_to_wstring"),
    (&["*"], &["STRING", "WSTRING"], "to_string"),
    (&["STRING", "WSTRING"], TIMES, "string_to_time"),
    (&["STRING", "WSTRING"], &["*"], "string_to_int"),
    (&["S5TIME"], &["*"], "s5time_to_time"),
    (&["*"], &["S5TIME"], "s5time_to_time"),
    (&["DT", "LDT", "DATE_AND_TIME"], &["DATE", "TOD", "LDATE", "LTOD", "TIME_OF_DAY"], "dt_to_date"),
    (TIMES, &["*"], "time_to_dint"),
    (&["*"], TIMES, "time_to_dint"),
    (&["CHAR", "WCHAR"], &["*"], "char_to_int"),
    (&["*"], &["CHAR", "WCHAR"], "char_to_int"),
    (&["BOOL"], &["*"], "bool_to_int"),
    (&["*"], &["BOOL"], "bool_to_int"),
    (BITS, &["*"], "word_to_int"),
    (&["*"], BITS, "word_to_int"),
    (REALS, &["*"], "real_to_int"),
    (&["*"], REALS, "int_to_real"),
    (&["*"], &["*"], "int_to_dint"),
];

const TIMES: &[&str] = &["TIME", "LTIME", "DATE", "LDATE", "TOD", "TIME_OF_DAY", "LTOD", "DT", "DATE_AND_TIME", "LDT"];
const BITS: &[&str] = &["BYTE", "WORD", "DWORD", "LWORD"];
const REALS: &[&str] = &["REAL", "LREAL"];

/// All names that have a page, but those conversions that others stand for.
pub fn names() -> impl Iterator<Item = &'static str> {
    CHAPTERS.iter().flat_map(|chapter| chapter.pages).flat_map(|page| page.names).copied()
}

/// The page of a name, without regard to case: of any conversion too.
pub fn page(name: &str) -> Option<&'static Page> {
    let name = name.to_ascii_uppercase();
    let pages = || CHAPTERS.iter().flat_map(|chapter| chapter.pages);
    if let Some(page) = pages().find(|page| page.names.contains(&name.as_str())) {
        return Some(page);
    }
    let of_file = |file: &str| pages().find(|page| page.file == file);
    if name.contains("_BCD_") || name.starts_with("BCD_TO_") || name.starts_with("TO_BCD_") || name.ends_with("_TO_BCD") {
        return of_file("bcd");
    }
    if ["TRUNC_", "ROUND_", "CEIL_", "FLOOR_", "REAL_TRUNC_", "LREAL_TRUNC_"].iter().any(|start| name.starts_with(start)) {
        return of_file("round");
    }
    let (from, to) = match name.strip_prefix("TO_") {
        Some(to) => ("INT", to),
        None => name.split_once("_TO_")?,
    };
    named_anywhere(from).and(named_anywhere(to))?;
    let fits = |types: &[&str], word: &str| types == ["*"] || types.contains(&word);
    CONVERSIONS.iter().find(|(sources, targets, _)| fits(sources, from) && fits(targets, to)).and_then(|(.., file)| of_file(file))
}

/// A type of some dialect.
pub(crate) fn named_anywhere(word: &str) -> Option<()> {
    Dialect::ALL.iter().find_map(|&dialect| named(word, dialect)).map(|_| ())
}

/// Whether a word belongs to the language itself.
pub(crate) fn is_keyword(word: &str, dialect: Dialect) -> bool {
    Keyword::of(word, dialect).is_some()
}
