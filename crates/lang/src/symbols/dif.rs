//! `.dif`, the data interchange format of spreadsheets, as STEP 7 V5 writes it: a head, then four cells for each symbol.

use sieben_model::problems::Problem;
use sieben_model::symbols::{Symbol, SymbolTable};

use super::{Sink, fixed_fields, headings, report_lost_columns};

/// Cells of a row: symbol, address, data type, comment.
const CELLS: usize = 4;

/// A line without its end, and its first byte.
#[derive(Clone, Copy)]
struct Line<'t> {
    text: &'t str,
    start: usize,
}

impl Line<'_> {
    fn end(&self) -> usize {
        self.start + self.text.len()
    }

    fn is(&self, word: &str) -> bool {
        self.text.trim().eq_ignore_ascii_case(word)
    }

    /// `type,value`: both numbers of the first line of a cell or topic.
    fn numbers(&self) -> Option<(i32, &str)> {
        let (kind, value) = self.text.trim().split_once(',')?;
        Some((kind.trim().parse().ok()?, value.trim()))
    }

    /// The text of a cell without its quotation marks.
    fn cell(&self) -> String {
        let text = self.text.trim();
        let inner = text.strip_prefix('"').and_then(|inner| inner.strip_suffix('"')).unwrap_or(text);
        inner.replace("\"\"", "\"")
    }
}

/// Whether a text begins as every file of this format does.
pub(crate) fn is_dif(text: &str) -> bool {
    let mut lines = text.lines().filter(|line| !line.trim().is_empty());
    lines.next().is_some_and(|line| line.trim().eq_ignore_ascii_case("TABLE"))
        && lines.next().is_some_and(|line| line.trim().split_once(',').is_some_and(|(kind, _)| kind.trim() == "0"))
}

/// Reads the head and all rows.
pub(crate) fn read(text: &str, sink: &mut Sink) {
    let mut start = 0;
    let mut lines: Vec<Line<'_>> = text
        .split_inclusive('\n')
        .map(|line| {
            let content = line.trim_end_matches(['\n', '\r', '\u{1A}']);
            let place = Line { text: content, start };
            start += line.len();
            place
        })
        .collect();
    while lines.last().is_some_and(|line| line.text.trim().is_empty()) {
        lines.pop();
    }
    let mut lines = lines.into_iter();
    let Some(counts) = head(&mut lines, text, sink) else { return };
    let rows = data(&mut lines, text, sink);
    // STEP 7 counts the rows in VECTORS, the format itself in TUPLES.
    if let [Some((vectors, place)), Some((tuples, _))] = counts
        && ![vectors, tuples].contains(&rows)
    {
        let message =
            format!("the head of this table counts {} rows, but it holds {rows}", if vectors == CELLS { tuples } else { vectors });
        sink.problem(Problem::P6112, place.start, place.end(), message);
    }
}

/// The values of VECTORS and TUPLES, and where the first of them stands; `None` if there is no head.
type Counts<'t> = [Option<(usize, Line<'t>)>; 2];

/// Topics of three lines each, up to DATA.
fn head<'t>(lines: &mut impl Iterator<Item = Line<'t>>, text: &str, sink: &mut Sink) -> Option<Counts<'t>> {
    let mut counts = [None, None];
    loop {
        let (Some(topic), Some(numbers), Some(_)) = (lines.next(), lines.next(), lines.next()) else {
            let message = "this table ends inside its head; a .dif begins with TABLE, VECTORS, TUPLES and DATA, three lines each";
            sink.problem(Problem::P6111, 0, text.trim_end().len(), message);
            return None;
        };
        let Some((_, value)) = numbers.numbers() else {
            let message =
                format!("`{}` where the numbers of `{}` stand, such as `0,4`", numbers.text.trim().escape_debug(), topic.text.trim());
            sink.problem(Problem::P6105, numbers.start, numbers.end(), message);
            return None;
        };
        let count = value.parse().ok().map(|count| (count, numbers));
        match () {
            () if topic.is("DATA") => return Some(counts),
            () if topic.is("VECTORS") => counts[0] = count,
            () if topic.is("TUPLES") => counts[1] = count,
            // TABLE, LABEL, COMMENT and the like say nothing about symbols.
            () => {}
        }
    }
}

/// A row that is being collected.
#[derive(Default)]
struct Row {
    cells: Vec<String>,
    start: usize,
    end: usize,
    /// A line of it was reported already.
    broken: bool,
}

/// Cells of two lines each, up to EOD; gives the number of rows.
fn data<'t>(lines: &mut impl Iterator<Item = Line<'t>>, text: &str, sink: &mut Sink) -> usize {
    let mut rows = 0;
    let mut row: Option<Row> = None;
    while let Some(line) = lines.next() {
        let cell = line.numbers().and_then(|numbers| Some((numbers, lines.next()?)));
        let Some(((kind @ -1..=1, value), content)) = cell else {
            // A line too many or too few: the next row begins at the next BOT all the same.
            let broken = row.as_mut().is_none_or(|row| !std::mem::replace(&mut row.broken, true));
            if broken && line.numbers().is_none() {
                let shown: String = line.text.trim().chars().take(40).collect();
                let message = format!("`{}` where a cell begins, such as `1,0` with its text on the next line", shown.escape_debug());
                sink.problem(Problem::P6105, line.start, line.end(), message);
            }
            continue;
        };
        match kind {
            -1 => {
                finish(row.take(), sink);
                if content.is("EOD") {
                    return rows;
                }
                rows += 1;
                row = Some(Row::default());
            }
            _ => {
                let row = row.get_or_insert_default();
                if row.cells.is_empty() {
                    row.start = content.start;
                }
                row.end = content.end();
                row.cells.push(match (kind, content.text.trim()) {
                    (1, _) => content.cell(),
                    // A spreadsheet makes a number of a symbol or comment that looks like one.
                    (_, "V" | "v") => value.to_owned(),
                    (_, word @ ("TRUE" | "FALSE")) => word.to_owned(),
                    _ => String::new(),
                });
            }
        }
    }
    finish(row, sink);
    let end = text.trim_end().len();
    let start = text[..end].rfind('\n').map_or(0, |newline| newline + 1);
    sink.problem(Problem::P6111, start, end, "this table has no `EOD` at its end: rows may be missing");
    rows
}

fn finish(row: Option<Row>, sink: &mut Sink) {
    let Some(Row { mut cells, start, end, broken }) = row else { return };
    while cells.len() > CELLS && cells.last().is_some_and(|cell| cell.trim().is_empty()) {
        cells.pop();
    }
    if cells.len() > CELLS {
        let message = format!("this row has {} cells; a symbol has {CELLS}: symbol, address, type, comment", cells.len());
        sink.problem(Problem::P6105, start, end, message);
        return;
    }
    if broken || headings::are_headings(&cells) {
        return;
    }
    let mut cells = cells.into_iter();
    let mut next = || cells.next().unwrap_or_default().trim().to_owned();
    let symbol = Symbol { name: next(), address: next(), data_type: next(), comment: next(), ..Symbol::default() };
    sink.row(symbol, start, end);
}

/// Writes the head and all rows; `\n` ends the lines here.
pub(crate) fn write(table: &SymbolTable, losses: &mut Vec<String>) -> String {
    let rows = table.symbols().len();
    let mut text = format!("TABLE\n0,1\n\"EXCEL\"\nVECTORS\n0,{rows}\n\"\"\nTUPLES\n0,{CELLS}\n\"\"\nDATA\n0,0\n\"\"\n");
    for symbol in table.symbols() {
        text.push_str("-1,0\nBOT\n");
        for field in fixed_fields(symbol, losses) {
            text.push_str("1,0\n\"");
            text.push_str(&field.trim_end().replace('"', "\"\""));
            text.push_str("\"\n");
        }
    }
    text.push_str("-1,0\nEOD\n");
    report_lost_columns(table, losses);
    text
}
