//! `symbols.csv`, the native form: RFC 4180 with a header whose columns stand in any order.

use ::csv::{ReaderBuilder, StringRecord, Terminator, WriterBuilder};
use sieben_model::problems::Problem;
use sieben_model::symbols::{Symbol, SymbolTable};

use super::headings::{ADDRESS, NUMBER, OF_ASSIGNMENTS, SYMBOL, UNIT, are_headings, column_kinds, is_dash};
use super::{Sink, is_address};

pub use super::headings::COLUMNS;

/// One row with the bytes it came from.
pub(crate) struct Record {
    pub(crate) fields: Vec<String>,
    pub(crate) start: usize,
    pub(crate) end: usize,
}

/// The rows of a CSV; a quotation mark that is never closed is a problem, and what follows it is one field.
pub(crate) fn records(text: &str, delimiter: u8, sink: &mut Sink) -> Vec<Record> {
    let mut reader = ReaderBuilder::new().has_headers(false).flexible(true).delimiter(delimiter).from_reader(text.as_bytes());
    let mut rows = Vec::new();
    let mut record = StringRecord::new();
    // Reading a text in memory fails neither by I/O nor by encoding.
    while let Ok(true) = reader.read_record(&mut record) {
        let position = |byte: u64| usize::try_from(byte).unwrap_or(text.len()).min(text.len());
        let start = record.position().map_or(0, |place| position(place.byte()));
        let end = position(reader.position().byte()).max(start);
        let raw = text.get(start..end).unwrap_or_default();
        // The reader begins a row right behind the last one, before blank lines.
        let start = start + (raw.len() - raw.trim_start_matches(['\r', '\n']).len());
        let end = start + raw.trim_matches(['\r', '\n']).len();
        if raw.matches('"').count() % 2 == 1 {
            let line_end = text[start..].find('\n').map_or(end, |length| start + length);
            sink.problem(
                Problem::P6108,
                start,
                line_end,
                "a quotation mark in this line is never closed; `\"\"` writes one inside a quoted field",
            );
            break;
        }
        rows.push(Record { fields: record.iter().map(str::to_owned).collect(), start, end });
    }
    rows
}

/// Reads the table; gives the columns as written and the delimiter.
pub(crate) fn read(text: &str, sink: &mut Sink) -> (Vec<String>, u8) {
    let header_line = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
    let delimiter = delimiter_of(header_line);
    let mut rows = records(text, delimiter, sink).into_iter().peekable();
    let (columns, start, end) = match rows.peek().filter(|first| is_numbered(&first.fields)) {
        // The assignment table as it is printed, without its header.
        Some(first) => {
            let (start, end) = (first.start, first.end);
            if !(OF_ASSIGNMENTS.len() - 1..=OF_ASSIGNMENTS.len()).contains(&first.fields.len()) {
                let message = format!(
                    "this table has no header, and its rows have {} fields; the first line names the columns: {}",
                    first.fields.len(),
                    COLUMNS.join(",")
                );
                sink.problem(Problem::P6104, start, end, message);
                return (Vec::new(), delimiter);
            }
            let message = format!("this table has no header, and was read as one with the columns {}", OF_ASSIGNMENTS.join(", "));
            sink.problem(Problem::P6133, start, end, message);
            (OF_ASSIGNMENTS.map(str::to_owned).to_vec(), start, end)
        }
        None => rows.next().map_or((Vec::new(), 0, 0), |record| (record.fields, record.start, record.end)),
    };
    let kinds = column_kinds(&columns);
    // An assignment table lists also what has no symbol.
    sink.unnamed = kinds.contains(&Some(NUMBER)) || kinds.contains(&Some(UNIT));
    let missing: Vec<&str> =
        COLUMNS[..2].iter().enumerate().filter(|(index, _)| !kinds.contains(&Some(*index))).map(|(_, name)| *name).collect();
    if !missing.is_empty() {
        let message = format!(
            "the header has no column `{}`; the first line names the columns: {}",
            missing.join("` and no column `"),
            COLUMNS.join(",")
        );
        sink.problem(Problem::P6104, start, end, message);
        return (columns, delimiter);
    }
    for Record { fields, start, end } in rows {
        if fields.len() > columns.len() {
            let message = format!(
                "this row has {} fields, but the header has {} columns; a field with a comma is put in quotation marks",
                fields.len(),
                columns.len()
            );
            sink.problem(Problem::P6105, start, end, message);
            continue;
        }
        if fields.iter().all(|field| field.trim().is_empty()) {
            continue;
        }
        let mut symbol = Symbol::default();
        let mut values = fields.into_iter();
        for (column, kind) in columns.iter().zip(&kinds) {
            let mut value = values.next().unwrap_or_default();
            if kind.is_some_and(|kind| kind != ADDRESS) && is_dash(&value) {
                value.clear();
            }
            match kind {
                Some(SYMBOL) => symbol.name = value.trim().to_owned(),
                Some(index) => *known_field(&mut symbol, *index) = value,
                None => symbol.extra.push((column.clone(), value)),
            }
        }
        sink.row(symbol, start, end);
    }
    (columns, delimiter)
}

/// Comma, semicolon or tabulator: the one that a header has most often.
fn delimiter_of(header: &str) -> u8 {
    let count = |delimiter: u8| header.bytes().filter(|&byte| byte == delimiter).count();
    // Of equally frequent ones the last counts.
    b"\t;,".iter().copied().max_by_key(|&delimiter| count(delimiter)).unwrap_or(b',')
}

/// Whether a row begins with a running number and an address, as the rows of an assignment table do.
fn is_numbered(fields: &[String]) -> bool {
    let [number, address, _, ..] = fields else { return false };
    let number = number.trim().trim_end_matches('.');
    !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()) && is_address(address)
}

/// Whether a text begins with a row of an assignment table that has no header.
pub(crate) fn begins_with_number(line: &str) -> bool {
    let fields: Vec<String> = line.split(char::from(delimiter_of(line))).map(|cell| cell.trim().trim_matches('"').to_owned()).collect();
    is_numbered(&fields)
}

/// Whether a line names at least the columns for symbol and address.
pub(crate) fn begins_with_headings(line: &str) -> bool {
    let cells: Vec<String> = line.split(char::from(delimiter_of(line))).map(|cell| cell.trim().trim_matches('"').to_owned()).collect();
    are_headings(&cells)
}

fn known_field(symbol: &mut Symbol, index: usize) -> &mut String {
    match index {
        0 => &mut symbol.name,
        1 => &mut symbol.address,
        2 => &mut symbol.data_type,
        3 => &mut symbol.comment,
        4 => &mut symbol.number,
        5 => &mut symbol.unit,
        6 => &mut symbol.tag,
        _ => &mut symbol.remark,
    }
}

/// Writes the table with the columns it came with, and those that it needs beyond them; `\n` ends the lines here.
pub(crate) fn write(table: &SymbolTable, delimiter: u8) -> String {
    let columns = columns_to_write(table);
    let kinds = column_kinds(&columns);
    let mut rows = vec![columns.clone()];
    for symbol in table.symbols() {
        let mut symbol = symbol.clone();
        let mut extra = std::mem::take(&mut symbol.extra);
        let row = columns.iter().zip(&kinds).map(|(column, kind)| match kind {
            Some(index) => std::mem::take(known_field(&mut symbol, *index)),
            None => match extra.iter().position(|(name, _)| name == column) {
                Some(position) => extra.remove(position).1,
                None => String::new(),
            },
        });
        rows.push(row.collect());
    }
    lines(&rows, delimiter)
}

/// Rows as CSV with `\n` behind each; fields are quoted where they must be.
pub(crate) fn lines(rows: &[Vec<String>], delimiter: u8) -> String {
    let mut writer = WriterBuilder::new().flexible(true).delimiter(delimiter).terminator(Terminator::Any(b'\n')).from_writer(Vec::new());
    for row in rows {
        // Line ends inside a field become blanks, so that a row stays a line in every tool.
        let cleaned = row.iter().map(|field| field.replace("\r\n", " ").replace(['\r', '\n'], " "));
        writer.write_record(cleaned).expect("writing to memory does not fail");
    }
    let bytes = writer.into_inner().expect("writing to memory does not fail");
    String::from_utf8(bytes).expect("fields are UTF-8 and so are the marks between them")
}

fn columns_to_write(table: &SymbolTable) -> Vec<String> {
    let mut columns = table.columns().to_vec();
    let has = |columns: &[String], index: usize| column_kinds(columns).contains(&Some(index));
    for (index, name) in COLUMNS.iter().enumerate() {
        let needed = index < 4 && table.columns().is_empty()
            || index < 2
            || table.symbols().iter().any(|symbol| !known_field(&mut symbol.clone(), index).is_empty());
        if needed && !has(&columns, index) {
            columns.push((*name).to_owned());
        }
    }
    for (name, _) in table.symbols().iter().flat_map(|symbol| &symbol.extra) {
        if !columns.contains(name) {
            columns.push(name.clone());
        }
    }
    columns
}
