//! Watch tables: names of values that belong together, with their formats, as a file of the project has them.

use csv::{ReaderBuilder, StringRecord};
use sieben_lang::encoding;
use sieben_model::format::Format;
use sieben_model::problems::Problem;
use sieben_model::visible::visible;

use crate::refusal::Refusal;

/// How the names of such files end.
pub const ENDING: &str = "watch";
/// Longest watch table, in bytes.
pub const WATCH_BYTES_MAX: usize = 1024 * 1024;
/// Rows of a watch table at most.
pub const WATCH_ROWS_MAX: usize = 20_000;
/// Longest field of a watch table, in bytes.
const WATCH_FIELD_BYTES_MAX: usize = 1_000;
/// The columns, in the order in which they are written.
pub const COLUMNS: [&str; 3] = ["name", "format", "comment"];

/// A row of a watch table.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// What is watched, as it is written.
    pub name: String,
    /// How it is shown; empty: as its type is.
    pub format: String,
    /// What the user says about it.
    pub comment: String,
}

/// Reads a watch table; `name` is what messages call it.
///
/// # Errors
/// It is no watch table: which line is wrong, and why.
pub fn parse(name: &str, bytes: &[u8]) -> Result<Vec<Row>, Refusal> {
    let wrong = |why: String| Refusal::new(Problem::P7146, format!("`{}`{why}", visible(name)));
    if bytes.len() > WATCH_BYTES_MAX {
        return Err(wrong(format!(" is longer than {WATCH_BYTES_MAX} bytes")));
    }
    let decoded = encoding::read_source_as(bytes, None).map_err(|unreadable| wrong(format!(" is no text: {unreadable}")))?;
    // Remarks become empty lines, so that those after them keep their numbers.
    let line = |line: &str| if line.starts_with("//") { "\n".to_owned() } else { line.to_owned() };
    let text: String = decoded.text.split_inclusive('\n').map(line).collect();
    let heading = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
    let delimiter = if heading.contains(';') { b';' } else { b',' };
    let mut reader = ReaderBuilder::new().has_headers(false).flexible(true).delimiter(delimiter).from_reader(text.as_bytes());
    let (mut columns, mut rows): (Option<Vec<Option<usize>>>, Vec<Row>) = (None, Vec::new());
    let mut record = StringRecord::new();
    let mut next_line = 1;
    loop {
        let begin = byte_of(&reader);
        // Reading a text in memory fails neither by I/O nor by encoding.
        if !reader.read_record(&mut record).unwrap_or(false) {
            break;
        }
        let raw = text.get(begin..byte_of(&reader)).unwrap_or_default();
        // Blank lines before a row come with it.
        let line = next_line + raw.lines().take_while(|line| line.trim().is_empty()).count();
        next_line += raw.matches('\n').count();
        let at = |why: String| wrong(format!(", line {line}: {why}"));
        if record.iter().all(|field| field.trim().is_empty()) {
            continue;
        }
        if raw.matches('"').count() % 2 == 1 {
            return Err(at("a quotation mark is never closed; `\"\"` writes one inside of quotation marks".to_owned()));
        }
        let Some(columns) = &columns else {
            let found: Vec<Option<usize>> = record.iter().map(|field| COLUMNS.iter().position(|name| field.trim().eq_ignore_ascii_case(name))).collect();
            if !found.contains(&Some(0)) {
                return Err(at(format!("the first line names the columns: {}", COLUMNS.join(","))));
            }
            columns = Some(found);
            continue;
        };
        if record.len() > columns.len() {
            let (fields, most) = (record.len(), columns.len());
            return Err(at(format!("{fields} fields, but the heading has {most}; a field with the separator in it stands in quotation marks")));
        }
        if record.iter().any(|field| field.len() > WATCH_FIELD_BYTES_MAX) {
            return Err(at(format!("a field has at most {WATCH_FIELD_BYTES_MAX} bytes")));
        }
        if rows.len() >= WATCH_ROWS_MAX {
            return Err(at(format!("a watch table has at most {WATCH_ROWS_MAX} rows")));
        }
        let field = |wanted: usize| {
            let place = columns.iter().position(|column| *column == Some(wanted));
            place.and_then(|place| record.get(place)).unwrap_or_default().trim().to_owned()
        };
        let row = Row { name: field(0), format: field(1), comment: field(2) };
        if row.name.is_empty() {
            return Err(at("the row has no name".to_owned()));
        }
        if !row.format.is_empty() && Format::from_name(&row.format).is_none() {
            return Err(at(format!("`{}` is no format; `sieben explain formats` lists them", visible(&row.format))));
        }
        rows.push(row);
    }
    if columns.is_none() {
        return Err(wrong(format!(" is empty; its first line names the columns: {}", COLUMNS.join(","))));
    }
    Ok(rows)
}

/// Where the next record begins.
fn byte_of(reader: &csv::Reader<&[u8]>) -> usize {
    usize::try_from(reader.position().byte()).unwrap_or(usize::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(name: &str, format: &str, comment: &str) -> Row {
        Row { name: name.to_owned(), format: format.to_owned(), comment: comment.to_owned() }
    }

    #[test]
    fn tables_are_read_as_people_and_spreadsheets_write_them() {
        let rows = [row("VALVE", "BOOL", "the valve, on top"), row("MW 10", "", "")];
        for text in [
            "name,format,comment\nVALVE,BOOL,\"the valve, on top\"\nMW 10\n",
            "\u{FEFF}Name;Format;Comment\r\n\r\nVALVE;BOOL;the valve, on top\r\n// a remark\r\n MW 10 ;;\r\n",
            "comment,more,name,format\n\"the valve, on top\",x,VALVE,BOOL\n,,MW 10,\n",
        ] {
            assert_eq!(parse("a.watch", text.as_bytes()).expect(text), rows, "{text}");
        }
        assert_eq!(parse("a.watch", b"name\n").expect("a heading"), []);
        assert_eq!(parse("a.watch", b"name;comment\nMW1;F\xFCller\n").expect("Windows-1252")[0].comment, "Füller");
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        let many = format!("name\n{}", "MW 10\n".repeat(WATCH_ROWS_MAX + 1));
        let long = format!("name\n{}\n", "x".repeat(WATCH_FIELD_BYTES_MAX + 1));
        for (text, wanted) in [
            ("", "`a.watch` is empty"),
            ("VALVE,BOOL\n", "`a.watch`, line 1: the first line names the columns: name,format,comment"),
            ("name,format\n\n\nVALVE,BOL\n", "`a.watch`, line 4: `BOL` is no format"),
            ("name,format\nMW 10\nA,BOOL,b\n", "`a.watch`, line 3: 3 fields, but the heading has 2"),
            ("name,format\n// one\n,BOOL\n", "`a.watch`, line 3: the row has no name"),
            ("name,comment\nA,\"open\nB,c\n", "`a.watch`, line 2: a quotation mark is never closed"),
            (&many, "`a.watch`, line 20002: a watch table has at most 20000 rows"),
            (&long, "`a.watch`, line 2: a field has at most 1000 bytes"),
        ] {
            let refusal = parse("a.watch", text.as_bytes()).expect_err(wanted);
            assert_eq!(refusal.problem, Problem::P7146);
            assert!(refusal.message.starts_with(wanted), "{}", refusal.message);
        }
        assert!(parse("a.watch", &vec![b'x'; WATCH_BYTES_MAX + 1]).is_err());
        assert!(parse("a.watch", b"name\n\x00\x01\x02").is_err(), "no text");
    }
}
