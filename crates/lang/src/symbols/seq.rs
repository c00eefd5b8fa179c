//! `.seq`, the assignment list of STEP 5: operand, symbol and comment, with tabulators or blanks between them.

use sieben_model::problems::Problem;
use sieben_model::symbols::{Symbol, SymbolTable};

use super::{Sink, fixed_fields, is_address, report_lost_columns};

/// What begins a line that is only a remark.
const REMARK: char = ';';

/// The fields of a line with tabulators; the first one may be empty, as some lists begin each line with a tabulator.
fn tabbed(line: &str) -> Option<[&str; 3]> {
    let line = line.strip_prefix('\t').unwrap_or(line);
    let (first, rest) = line.split_once('\t')?;
    let (second, third) = rest.split_once('\t').unwrap_or((rest, ""));
    Some([first.trim(), second.trim(), third.trim()])
}

/// Whether the first line of a text has an address and a symbol with a tabulator between them.
pub(crate) fn is_seq(text: &str) -> bool {
    let line = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with(REMARK));
    let fields = line.and_then(|line| tabbed(line.trim_end_matches(['\r', '\u{1A}'])));
    fields.is_some_and(|[first, second, _]| is_address(first) != is_address(second) && !first.is_empty() && !second.is_empty())
}

/// Reads all lines. Which of the first two fields is the address is the same in a whole file and judged over all lines.
pub(crate) fn read(text: &str, sink: &mut Sink) {
    let mut votes = (0_usize, 0_usize);
    for [first, second, _] in text.lines().filter_map(tabbed) {
        votes.0 += usize::from(is_address(first));
        votes.1 += usize::from(is_address(second));
    }
    let symbol_first = votes.1 > votes.0;
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let content = line.trim_end_matches(['\n', '\r', '\u{1A}']);
        let (begin, end) = (start, start + content.len());
        start += line.len();
        if content.trim().is_empty() || content.starts_with(REMARK) {
            continue;
        }
        let fields = match tabbed(content) {
            Some([symbol, address, comment]) if symbol_first => Some([address, symbol, comment]),
            Some(fields) => Some(fields),
            None => spaced(content.trim_start()),
        };
        let Some([address, name, comment]) = fields else {
            let message = "this line has no address; a line of .seq has an address, a symbol and a comment with tabulators between them";
            sink.problem(Problem::P6105, begin, end, message);
            continue;
        };
        let symbol = Symbol { name: name.to_owned(), address: address.to_owned(), comment: comment.to_owned(), ..Symbol::default() };
        sink.row(symbol, begin, end);
    }
}

/// `E 1.0  START  Start button` or `START  E 1.0  Start button`: address, symbol, comment.
fn spaced(line: &str) -> Option<[&str; 3]> {
    if let Some((address, rest)) = leading_address(line) {
        // A symbol may hold single blanks where columns are further apart.
        let end = rest.find("  ").or_else(|| rest.find(' ')).unwrap_or(rest.len());
        return Some([address, &rest[..end], rest[end..].trim()]);
    }
    let (name, rest) = line.split_once("  ").or_else(|| line.split_once(' '))?;
    let (address, comment) = leading_address(rest.trim_start())?;
    Some([address, name, comment.trim_end()])
}

/// An address of one or two words, and what follows it.
fn leading_address(text: &str) -> Option<(&str, &str)> {
    let word = |from: usize| {
        let start = from + (text[from..].len() - text[from..].trim_start_matches(' ').len());
        let end = text[start..].find(' ').map_or(text.len(), |length| start + length);
        (end > start).then_some(end)
    };
    let first = word(0)?;
    [word(first), Some(first)]
        .into_iter()
        .flatten()
        .find(|&end| is_address(&text[..end]))
        .map(|end| (&text[..end], text[end..].trim_start()))
}

/// Writes all rows with tabulators; `\n` ends the lines here.
pub(crate) fn write(table: &SymbolTable, losses: &mut Vec<String>) -> String {
    let mut text = String::new();
    for symbol in table.symbols() {
        let [name, address, _, comment] = fixed_fields(symbol, losses);
        text.push_str(&format!("\t{}\t{}\t{}\n", address.trim_end(), name.trim_end(), comment.trim_end()));
    }
    if table.symbols().iter().any(|symbol| !symbol.data_type.trim().is_empty()) {
        losses.push("the data types have no place in this format".to_owned());
    }
    report_lost_columns(table, losses);
    text
}
