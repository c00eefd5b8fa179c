//! `.asc` of STEP 7 V5: the literal `126,` and four fields of fixed width, 130 characters a line.

use sieben_model::problems::Problem;
use sieben_model::symbols::{Symbol, SymbolTable};

use super::{Sink, WIDTHS, fixed_fields, report_lost_columns};

/// What every line begins with: the length of the fields.
const LEAD: &str = "126,";
/// Characters of a line without its end.
const LINE: usize = 130;

/// Reads all lines; a line whose blanks at the end were trimmed is as good as a full one.
pub(crate) fn read(text: &str, sink: &mut Sink) {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let content = line.trim_end_matches(['\n', '\r', '\u{1A}']);
        let end = start + content.len();
        match content.strip_prefix(LEAD) {
            _ if content.trim().is_empty() => {}
            Some(_) if content.trim_end().chars().count() > LINE => {
                let length = content.trim_end().chars().count();
                sink.problem(Problem::P6105, start, end, format!("this line has {length} characters; a line of .asc has {LINE}"));
            }
            Some(fields) => sink.row(row(fields), start, end),
            None => sink.problem(Problem::P6105, start, end, "this line does not begin with `126,` as every line of .asc does"),
        }
        start += line.len();
    }
}

fn row(fields: &str) -> Symbol {
    let mut characters = fields.chars();
    let [name, address, data_type, comment] = WIDTHS.map(|width| characters.by_ref().take(width).collect::<String>().trim_end().to_owned());
    Symbol { name: name.trim_start().to_owned(), address, data_type: data_type.trim().to_owned(), comment, ..Symbol::default() }
}

/// Writes all rows; `\n` ends the lines here.
pub(crate) fn write(table: &SymbolTable, losses: &mut Vec<String>) -> String {
    let mut text = String::new();
    for symbol in table.symbols() {
        text.push_str(LEAD);
        fixed_fields(symbol, losses).iter().for_each(|field| text.push_str(field));
        text.push('\n');
    }
    report_lost_columns(table, losses);
    text
}
