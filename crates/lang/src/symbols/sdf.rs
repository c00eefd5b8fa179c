//! `.sdf` of STEP 7 V5: quoted fields, padded to the widths of the symbol editor; unpadded ones are read too.

use sieben_model::problems::Problem;
use sieben_model::symbols::{Symbol, SymbolTable};

use super::csv::{Record, records};
use super::{Sink, fixed_fields, report_lost_columns};

/// Fields of a row in the tag tables of TIA: name, address, type, three flags, comment, supervision, a flag.
const TIA_FIELDS: usize = 9;
/// Versions of TIA differ in the flags at the end of a row; its addresses begin with `%` in all of them.
const TIA_FIELDS_ALL: std::ops::RangeInclusive<usize> = 7..=12;

/// Reads all rows.
pub(crate) fn read(text: &str, sink: &mut Sink) {
    let text = text.strip_suffix('\u{1A}').unwrap_or(text);
    for Record { fields, start, end } in records(text, b',', sink) {
        let field = |index: usize| fields.get(index).map(|field| field.trim_end().to_owned()).unwrap_or_default();
        let (address, comment) = match fields.len() {
            4 => (field(1), field(3)),
            count if count == TIA_FIELDS || (TIA_FIELDS_ALL.contains(&count) && field(1).starts_with('%')) => {
                (field(1).trim_start_matches('%').to_owned(), field(6))
            }
            count => {
                let message = format!("this line has {count} fields; a line of .sdf has 4: symbol, address, type, comment");
                sink.problem(Problem::P6105, start, end, message);
                continue;
            }
        };
        sink.row(
            Symbol { name: field(0).trim_start().to_owned(), address, data_type: field(2).trim().to_owned(), comment, ..Symbol::default() },
            start,
            end,
        );
    }
}

/// Writes all rows in four padded fields; `\n` ends the lines here.
pub(crate) fn write(table: &SymbolTable, losses: &mut Vec<String>) -> String {
    let mut text = String::new();
    for symbol in table.symbols() {
        let fields = fixed_fields(symbol, losses).map(|field| format!("\"{}\"", field.replace('"', "\"\"")));
        text.push_str(&fields.join(","));
        text.push('\n');
    }
    report_lost_columns(table, losses);
    text
}
