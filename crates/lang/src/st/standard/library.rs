//! Blocks that come with Sieben by the names that each dialect has for them.

use sieben_model::block::{BlockId, BlockKind};

use super::{Provided, Source};
use crate::library;
use crate::st::dialect::Dialect;

/// The files of the library in ST: for which dialects, in the order of the columns iec, codesys, scl, tia, in which dialect each is written,
/// and the blocks in it.
macro_rules! sources {
    ($( $path:literal $dialect:ident [$($for:literal)*]: $($block:ident)*; )*) => {
        /// All files.
        pub const SOURCES: &[&Source] = &[$(&Source {
            path: concat!("library/st/", $path),
            dialect: Dialect::$dialect,
            text: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../library/st/", $path)),
        }),*];

        /// For each file by which column it can be called, and its blocks.
        const CONTENTS: &[([u8; 4], &[&str])] = &[$(([$($for),*], &[$(stringify!($block)),*])),*];
    };
}

#[rustfmt::skip] // A table.
sources! {
    //                                  iec codesys scl tia
    "edges.st" Iec                      [1 1 0 1]: R_TRIG SEMA;
    "f_trig.st" Iec                     [1 0 0 0]: F_TRIG;
    "f_trig_quiet.st" Iec               [0 1 0 1]: F_TRIG;
    "bistables.st" Iec                  [1 0 0 1]: SR RS;
    "bistables_codesys.st" Codesys      [0 1 0 0]: SR RS;
    "timers.st" Iec                     [1 0 0 0]: TON TOF TP;
    "timers_time.st" Iec                [1 0 0 0]: TON_TIME TOF_TIME TP_TIME;
    "timers_ltime.st" Iec               [1 0 0 0]: TON_LTIME TOF_LTIME TP_LTIME;
    "timers_codesys.st" Codesys         [0 1 0 0]: TON TOF TP;
    "timers_codesys_long.st" Codesys    [0 1 0 0]: LTON LTOF LTP;
    "timers_tia.st" Iec                 [0 0 0 1]: TON TOF TP;
    "timers_tia_time.st" Iec            [0 0 0 1]: TON_TIME TOF_TIME TP_TIME;
    "timers_tia_ltime.st" Iec           [0 0 0 1]: TON_LTIME TOF_LTIME TP_LTIME;
    "iec_timer.st" Iec                  [0 0 0 1]: IEC_TIMER;
    "iec_ltimer.st" Iec                 [0 0 0 1]: IEC_LTIMER;
    "tonr.st" Iec                       [0 0 0 1]: TONR;
    "tonr_time.st" Iec                  [0 0 0 1]: TONR_TIME;
    "tonr_ltime.st" Iec                 [0 0 0 1]: TONR_LTIME;
    "rtc.st" Iec                        [1 0 0 0]: RTC;
    "rtc_codesys.st" Codesys            [0 1 0 0]: RTC;
    "counters.st" Iec                   [1 0 0 1]: CTU CTD CTUD;
    "iec_counters.st" Iec               [0 0 0 1]: IEC_COUNTER IEC_CTU_INT IEC_CTD_INT IEC_CTUD_INT
                                                   IEC_SCOUNTER IEC_CTU_SINT IEC_CTD_SINT IEC_CTUD_SINT
                                                   IEC_DCOUNTER IEC_CTU_DINT IEC_CTD_DINT IEC_CTUD_DINT
                                                   IEC_USCOUNTER IEC_CTU_USINT IEC_CTD_USINT IEC_CTUD_USINT
                                                   IEC_UCOUNTER IEC_CTU_UINT IEC_CTD_UINT IEC_CTUD_UINT
                                                   IEC_UDCOUNTER IEC_CTU_UDINT IEC_CTD_UDINT IEC_CTUD_UDINT;
    "counters_sint.st" Iec              [0 0 0 1]: CTU_SINT CTD_SINT CTUD_SINT;
    "counters_int.st" Iec               [1 0 0 1]: CTU_INT CTD_INT CTUD_INT;
    "counters_dint.st" Iec              [1 0 0 1]: CTU_DINT CTD_DINT CTUD_DINT;
    "counters_lint.st" Iec              [1 0 0 0]: CTU_LINT CTD_LINT CTUD_LINT;
    "counters_usint.st" Iec             [0 0 0 1]: CTU_USINT CTD_USINT CTUD_USINT;
    "counters_uint.st" Iec              [0 0 0 1]: CTU_UINT CTD_UINT CTUD_UINT;
    "counters_udint.st" Iec             [1 0 0 1]: CTU_UDINT CTD_UDINT CTUD_UDINT;
    "counters_ulint.st" Iec             [1 0 0 0]: CTU_ULINT CTD_ULINT CTUD_ULINT;
    "counters_codesys.st" Codesys       [0 1 0 0]: CTU CTD CTUD;
    "util_signals.st" Codesys           [0 1 0 0]: BLINK GEN;
    "util_analog.st" Codesys            [0 1 0 0]: HYSTERESIS LIMITALARM LIN_TRAFO RAMP_REAL RAMP_INT;
    "util_curves.st" Codesys            [0 1 0 0]: CHARCURVE;
    "util_mathematics.st" Codesys       [0 1 0 0]: DERIVATIVE INTEGRAL STATISTICS_REAL STATISTICS_INT VARIANCE;
    "util_controllers.st" Codesys       [0 1 0 0]: PID_FIXCYCLE PID PD;
    "util_bits.st" Codesys              [0 1 0 0]: EXTRACT PUTBIT PACK UNPACK;
    "util_numbered_bits.st" Codesys     [0 1 0 0]: GETBIT SETBIT SWITCHBIT BIT_AS_BYTE BYTE_AS_BIT BIT_AS_WORD WORD_AS_BIT BIT_AS_DWORD DWORD_AS_BIT;
    "util_frequency.st" Codesys         [0 1 0 0]: FREQ_MEASURE;
    "strings_iec.st" Iec                [1 0 0 0]: IEC_DELETE IEC_REPLACE;
    "replace_tia.st" Iec                [0 0 0 1]: TIA_REPLACE;
    "strings_codesys.st" Iec            [0 1 0 0]: CODESYS_LEFT CODESYS_RIGHT CODESYS_MID CODESYS_CONCAT CODESYS_INSERT CODESYS_DELETE
                                                   CODESYS_REPLACE CODESYS_FIND;
    "selection_strings.st" Iec          [1 1 1 1]: MAX_STRING MIN_STRING LIMIT_STRING SEL_STRING;
    "selection_wide_strings.st" Iec     [1 1 0 1]: MAX_WSTRING MIN_WSTRING LIMIT_WSTRING SEL_WSTRING WSTRING_TO_WCHAR;
    "to_string.st" Iec                  [1 1 0 1]: ULINT_TO_STRING LINT_TO_STRING LWORD_TO_STRING BOOL_TO_STRING CHAR_TO_STRING;
    "real_to_string.st" Iec             [1 1 0 1]: LREAL_TO_STRING REAL_TO_STRING DIGITS_OF_REAL;
    "duration_to_string.st" Iec         [1 0 0 0]: TIME_TO_STRING;
    "duration_to_string_codesys.st" Codesys [0 1 0 0]: TIME_TO_STRING;
    "date_to_string.st" Iec             [1 1 0 0]: DIGITS_OF_TWO CLOCK_IN_TEXT DAY_IN_TEXT TOD_TO_STRING DATE_TO_STRING DT_TO_STRING;
    "long_to_string.st" Iec             [1 1 0 0]: FRACTION_IN_TEXT PART_IN_TEXT LTIME_TO_STRING LTOD_TO_STRING LDATE_TO_STRING LDT_TO_STRING MOMENT_TO_STRING;
    "days.st" Iec                       [1 1 0 1]: DAYS_OF_DATE;
    "parts_of_dates.st" Iec             [1 0 0 0]: CONCAT_DATE CONCAT_LDATE CONCAT_LTOD CONCAT_TOD CONCAT_LDT CONCAT_DT SPLIT_LDATE SPLIT_DATE
                                                   SPLIT_LTOD SPLIT_TOD SPLIT_LDT SPLIT_DT;
    "dtl.st" Tia                        [0 0 0 1]: LDT_TO_DTL DTL_TO_LDT DT_TO_LDT LDT_TO_DATE LDT_TO_DT DTL_TO_DT DT_TO_DTL DTL_TO_DATE DTL_TO_TOD DTL_TO_LTOD
                                                   DATE_TO_DTL CONCAT_DATE_TOD CONCAT_DATE_LTOD TIA_COMBINE_DTL TIA_ADD_DTL TIA_SUB_DTL TIA_DIFF_DTL
                                                   TIA_READ_DTL TIA_READ_LDT TIA_WRITE_DTL TIA_WRITE_LDT;
    "long_to_string_tia.st" Iec         [0 0 0 1]: TIA_LINT_TO_STRING;
    "values_in_texts.st" Iec            [0 0 0 1]: TIA_STRG_TEXT TIA_VAL_STRG;
    "hexadecimal.st" Iec                [0 0 0 1]: TIA_ATH TIA_HTA TIA_SCATTER TIA_GATHER;
    "runtime.st" Iec                    [0 0 0 1]: TIA_RUNTIME;
    "characters.st" Iec                 [0 0 0 1]: Strg_TO_Chars Chars_TO_Strg;
    "counters_codesys_long.st" Codesys  [0 1 0 0]: LCTU LCTD LCTUD;
    "util_codes.st" Codesys             [0 1 0 0]: BYTE_TO_GRAY WORD_TO_GRAY DWORD_TO_GRAY GRAY_TO_BYTE GRAY_TO_WORD GRAY_TO_DWORD
                                                   BYTE_TO_HEXinASCII HEXinASCII_TO_BYTE WORD_AS_STRING;
    "times_from_text.st" Iec            [1 1 0 0]: CAPITALS_IN_TEXT CHAR_IN_TEXT VALUE_IN_TEXT DIGITS_IN_TEXT DURATION_IN_TEXT DAYS_IN_TEXT MOMENT_IN_TEXT STRING_TO_LTIME STRING_TO_DATE STRING_TO_LTOD STRING_TO_TOD STRING_TO_DT;
    "time_from_text.st" Iec             [1 0 0 0]: STRING_TO_TIME;
    "time_from_text_codesys.st" Codesys [0 1 0 0]: STRING_TO_TIME;
    "from_string.st" Iec                [1 0 0 1]: CODE_IN_TEXT NUMBER_IN_TEXT REAL_IN_TEXT STRING_TO_SINT STRING_TO_INT STRING_TO_DINT STRING_TO_USINT STRING_TO_UINT STRING_TO_UDINT STRING_TO_ULINT STRING_TO_LINT STRING_TO_BYTE STRING_TO_WORD STRING_TO_DWORD STRING_TO_LWORD STRING_TO_REAL STRING_TO_LREAL STRING_TO_BOOL STRING_TO_CHAR;
    "from_string_codesys.st" Iec        [1 1 0 0]: CODESYS_CODE_IN_TEXT CODESYS_NUMBER_IN_TEXT CODESYS_REAL_IN_TEXT STRING_TO_SINT STRING_TO_INT STRING_TO_DINT STRING_TO_USINT STRING_TO_UINT STRING_TO_UDINT STRING_TO_ULINT STRING_TO_LINT STRING_TO_BYTE STRING_TO_WORD STRING_TO_DWORD STRING_TO_LWORD STRING_TO_REAL STRING_TO_LREAL STRING_TO_BOOL STRING_TO_CHAR;
}

/// The instances of system function blocks by name in scl.
const SYSTEM: &[(&str, u16)] = &[("CTU", 0), ("CTD", 1), ("CTUD", 2), ("TP", 3), ("TON", 4), ("TOF", 5)];

/// Functions whose block has another name, because its own calls the one of the S7 library: the name, the dialect, the block.
const RENAMED: &[(&str, Dialect, &str)] = &[
    ("DELETE", Dialect::Iec, "IEC_DELETE"),
    ("REPLACE", Dialect::Iec, "IEC_REPLACE"),
    ("REPLACE", Dialect::Tia, "TIA_REPLACE"),
    ("LEFT", Dialect::Codesys, "CODESYS_LEFT"),
    ("RIGHT", Dialect::Codesys, "CODESYS_RIGHT"),
    ("MID", Dialect::Codesys, "CODESYS_MID"),
    ("CONCAT", Dialect::Codesys, "CODESYS_CONCAT"),
    ("INSERT", Dialect::Codesys, "CODESYS_INSERT"),
    ("DELETE", Dialect::Codesys, "CODESYS_DELETE"),
    ("REPLACE", Dialect::Codesys, "CODESYS_REPLACE"),
    ("FIND", Dialect::Codesys, "CODESYS_FIND"),
];

/// The block of a file by its name in a dialect.
fn source(name: &str, dialect: Dialect) -> Option<Provided> {
    let renamed = RENAMED.iter().find(|(one, of, _)| *of == dialect.base() && one.eq_ignore_ascii_case(name));
    let name = renamed.map_or(name, |(.., block)| block);
    CONTENTS.iter().zip(SOURCES).filter(|((columns, _), _)| columns[dialect.column()] != 0).find_map(|((_, blocks), source)| {
        let name = blocks.iter().find(|block| block.eq_ignore_ascii_case(name))?;
        Some(Provided::Source { name, source })
    })
}

/// Whether a dialect has a function of its own where the S7 library has a block with this name.
pub fn is_own(name: &str, dialect: Dialect) -> bool {
    matches!(source(name, dialect), Some(Provided::Source { .. }))
        || ["MAX", "MIN", "SEL", "LIMIT", "LEN", "CONCAT"].iter().any(|function| function.eq_ignore_ascii_case(name))
}

/// The names of the function blocks that a dialect brings along.
pub fn block_types(dialect: Dialect) -> impl Iterator<Item = &'static str> {
    let system = SYSTEM.iter().map(|&(name, _)| name).filter(move |_| dialect.base() == Dialect::Scl);
    let of_sources =
        CONTENTS.iter().filter(move |(columns, _)| columns[dialect.column()] != 0).flat_map(|(_, blocks)| blocks.iter().copied());
    // A call with a result is that of a function: its page says so.
    let is_block = |name: &&str| super::catalogue::page(name).is_some_and(|page| page.calls.iter().any(|call| call.contains('→')));
    system.chain(of_sources.filter(is_block))
}

/// Whether a name is that of a block of ST that is no function of the dialect: only other blocks of the library call it.
pub fn is_inner(name: &str, dialect: Dialect) -> bool {
    let is_function = RENAMED.iter().any(|(_, of, block)| *of == dialect.base() && block.eq_ignore_ascii_case(name));
    !is_function && source(name, dialect).is_some() && super::catalogue::page(name).is_none()
}

/// The function with this name, without regard to case.
pub fn function(name: &str, dialect: Dialect) -> Option<Provided> {
    source(name, dialect).or_else(|| library::by_name(name).filter(|block| block.block.kind == BlockKind::Function).map(Provided::Library))
}

/// The function block with this name as the type of an instance, without regard to case.
pub fn block_type(name: &str, dialect: Dialect) -> Option<Provided> {
    if dialect.base() == Dialect::Scl {
        let system = SYSTEM.iter().find(|(system, _)| system.eq_ignore_ascii_case(name));
        return system.map(|&(_, number)| Provided::System(BlockId::new(BlockKind::SystemFunctionBlock, number)));
    }
    source(name, dialect)
}

#[cfg(test)]
mod tests {
    use sieben_model::source::FileId;

    use super::*;
    use crate::st::ast::Item;
    use crate::st::parser::parse;

    #[test]
    fn every_source_is_read_without_a_problem_and_has_the_blocks_of_its_row() {
        for ((_, blocks), source) in CONTENTS.iter().zip(SOURCES) {
            let parsed = parse(FileId::default(), source.text, source.dialect);
            assert!(parsed.diagnostics.is_empty(), "{}: {:#?}", source.path, parsed.diagnostics);
            let names: Vec<&str> = parsed
                .file
                .items
                .iter()
                .filter_map(|item| match item {
                    Item::Block(block) => Some(block.name.text.as_str()),
                    _ => None,
                })
                .collect();
            for block in *blocks {
                assert!(names.contains(block), "{} has no {block}: {names:?}", source.path);
            }
        }
    }
}
