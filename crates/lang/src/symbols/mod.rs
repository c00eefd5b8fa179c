//! Symbol tables: the native `symbols.csv` and the exports `.sdf` and `.asc` of STEP 7 V5, and the assignment table.

pub mod asc;
pub mod assignment;
pub mod csv;
pub mod sdf;

use std::collections::HashMap;

use sieben_model::address::{Area, Operand, Width};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};
use sieben_model::symbols::{Symbol, SymbolTable};
use sieben_model::types::DataType;

/// Longest name that STEP 7 V5 takes, in characters.
pub const NAME_MAX: usize = 24;
/// Widths of name, address, data type and comment in the formats of STEP 7 V5.
pub const WIDTHS: [usize; 4] = [NAME_MAX, 12, 10, 80];

/// A file format of symbol tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// `symbols.csv`: RFC 4180 with a header.
    Csv,
    /// `.sdf`: four quoted fields a line; the tag tables of TIA with nine fields are read too.
    Sdf,
    /// `.asc`: fixed columns, 130 characters a line.
    Asc,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 3] = [Self::Csv, Self::Sdf, Self::Asc];

    /// The file name extension.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Sdf => "sdf",
            Self::Asc => "asc",
        }
    }

    /// The format of a file by the extension of its name.
    pub fn from_name(name: &str) -> Option<Self> {
        let (_, extension) = name.rsplit_once('.')?;
        Self::ALL.into_iter().find(|format| format.extension().eq_ignore_ascii_case(extension))
    }
}

/// How a table is written down: what must stay as it came when a file is written back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// The format.
    pub format: Format,
    /// What stands between the fields of a CSV: a comma, or the semicolon of some spreadsheets.
    pub delimiter: u8,
    /// Whether lines end with CR LF.
    pub carriage_returns: bool,
}

impl Layout {
    /// The usual layout of a format: commas; CR LF where STEP 7 writes it.
    pub fn new(format: Format) -> Self {
        Self { format, delimiter: b',', carriage_returns: format != Format::Csv }
    }
}

/// A table as it was read.
#[derive(Clone, Debug)]
pub struct Read {
    /// All rows that have a form at all, also those with problems.
    pub table: SymbolTable,
    /// How the file was laid out.
    pub layout: Layout,
    /// What is wrong, in the order of the lines.
    pub diagnostics: Vec<Diagnostic>,
}

/// A table as a text, and what did not fit into the format.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// The text; encode it in the code page of the project for the formats of STEP 7 V5.
    pub text: String,
    /// One sentence for each loss.
    pub losses: Vec<String>,
}

/// The format of a table by the name of its file, else by its first line.
pub fn detect(name: &str, text: &str) -> Option<Format> {
    Format::from_name(name).or_else(|| {
        let line = text.lines().find(|line| !line.trim().is_empty())?;
        let lower = line.to_lowercase();
        if line.starts_with("126,") {
            Some(Format::Asc)
        } else if lower.contains("symbol") && lower.contains("address") {
            Some(Format::Csv)
        } else if line.starts_with('"') && line.matches('"').count() >= 8 {
            Some(Format::Sdf)
        } else {
            None
        }
    })
}

/// Reads a table and checks its rows.
pub fn read(file: FileId, text: &str, format: Format) -> Read {
    let mut sink = Sink { file, rows: Vec::new(), diagnostics: Vec::new() };
    let mut layout = Layout::new(format);
    layout.carriage_returns = text.contains("\r\n") || (layout.carriage_returns && !text.contains('\n'));
    let mut columns = Vec::new();
    match format {
        Format::Csv => (columns, layout.delimiter) = csv::read(text, &mut sink),
        Format::Sdf => sdf::read(text, &mut sink),
        Format::Asc => asc::read(text, &mut sink),
    }
    let Sink { rows, mut diagnostics, .. } = sink;
    check(&rows, &mut diagnostics);
    diagnostics.sort_by_key(|diagnostic| diagnostic.span.start);
    let mut table = SymbolTable::new(rows.into_iter().map(|(symbol, _)| symbol).collect());
    table.set_columns(columns);
    Read { table, layout, diagnostics }
}

/// Writes a table.
pub fn write(table: &SymbolTable, layout: Layout) -> Written {
    let mut losses = Vec::new();
    let text = match layout.format {
        Format::Csv => csv::write(table, layout.delimiter),
        Format::Sdf => sdf::write(table, &mut losses),
        Format::Asc => asc::write(table, &mut losses),
    };
    let text = if layout.carriage_returns { text.replace('\n', "\r\n") } else { text };
    Written { text, losses }
}

/// Where the readers put rows and what is wrong with lines.
pub(crate) struct Sink {
    file: FileId,
    rows: Vec<(Symbol, Span)>,
    diagnostics: Vec<Diagnostic>,
}

impl Sink {
    fn span(&self, start: usize, end: usize) -> Span {
        let clamp = |position| u32::try_from(position).unwrap_or(u32::MAX);
        Span::new(self.file, clamp(start), clamp(end))
    }
    /// Takes a row with the bytes it came from; a row without any text is a blank line.
    pub(crate) fn row(&mut self, symbol: Symbol, start: usize, end: usize) {
        let span = self.span(start, end);
        if symbol != Symbol::default() {
            self.rows.push((symbol, span));
        }
    }
    pub(crate) fn problem(&mut self, problem: Problem, start: usize, end: usize, message: impl Into<String>) {
        let span = self.span(start, end);
        self.diagnostics.push(Diagnostic::new(problem, span, message));
    }
}

/// Checks each row, and the rows against each other.
fn check(rows: &[(Symbol, Span)], diagnostics: &mut Vec<Diagnostic>) {
    let mut names: HashMap<String, usize> = HashMap::new();
    let mut operands: HashMap<Operand, usize> = HashMap::new();
    for (index, (symbol, span)) in rows.iter().enumerate() {
        let (name, address) = (symbol.name.as_str(), symbol.address.trim());
        if name.is_empty() || address.is_empty() {
            let message = match name.is_empty() {
                true => format!("this row names no symbol for `{address}`"),
                false => format!("the symbol `{name}` has no address"),
            };
            diagnostics.push(Diagnostic::new(Problem::P6107, *span, message));
        }
        if !name.is_empty() {
            check_name(name, *span, diagnostics);
            match names.get(&name.to_lowercase()) {
                Some(&first) => {
                    let (earlier, place) = &rows[first];
                    let message = format!("the symbol `{name}` stands twice: already for `{}`", earlier.address.trim());
                    diagnostics.push(Diagnostic::new(Problem::P6101, *span, message).related(*place, "first here"));
                }
                None => {
                    names.insert(name.to_lowercase(), index);
                }
            }
        }
        if address.is_empty() {
            continue;
        }
        let Some(operand) = symbol.operand() else {
            if !is_variable_table(address) {
                let message =
                    format!("`{address}` is not an address; write one such as `I 0.0`, `QW 4`, `M 10.3`, `T 1`, `C 0`, `DB 5` or `FC 1`");
                diagnostics.push(Diagnostic::new(Problem::P6103, *span, message));
            }
            continue;
        };
        check_operand(symbol, &operand, *span, diagnostics);
        match operands.get(&operand) {
            Some(&first) => {
                let (earlier, place) = &rows[first];
                let message = format!("`{address}` already has the symbol `{}`", earlier.name);
                diagnostics.push(Diagnostic::new(Problem::P6102, *span, message).related(*place, "first here"));
            }
            None => {
                operands.insert(operand, index);
            }
        }
    }
}

fn check_name(name: &str, span: Span, diagnostics: &mut Vec<Diagnostic>) {
    if name.contains('"') || name.chars().any(char::is_control) {
        diagnostics.push(Diagnostic::new(
            Problem::P6110,
            span,
            format!("the symbol `{}` contains a quotation mark or a control character", name.escape_debug()),
        ));
    }
    let length = name.chars().count();
    if length > NAME_MAX {
        diagnostics.push(Diagnostic::new(
            Problem::P6106,
            span,
            format!("the symbol `{name}` has {length} characters; STEP 7 V5 takes {NAME_MAX}"),
        ));
    }
}

/// Entries of tables of variables, `VAT 1`, stand in exports and mean nothing to a program.
fn is_variable_table(address: &str) -> bool {
    let (word, number) = address.split_at(address.find(|character: char| !character.is_ascii_alphabetic()).unwrap_or(address.len()));
    word.eq_ignore_ascii_case("VAT") && number.trim().parse::<u16>().is_ok()
}

/// Whether the address can have a symbol, and whether the data type fits its width.
fn check_operand(symbol: &Symbol, operand: &Operand, span: Span, diagnostics: &mut Vec<Diagnostic>) {
    let address = symbol.address.trim();
    if let Operand::Address(inner) = operand
        && matches!(inner.area, Area::Local | Area::CallerLocal | Area::SharedData | Area::InstanceData)
    {
        let message = format!("`{address}` cannot have a symbol: local data and open data blocks differ from block to block");
        diagnostics.push(Diagnostic::new(Problem::P6103, span, message));
        return;
    }
    let word = symbol.data_type.trim().to_ascii_uppercase();
    let valid = match (operand, word.as_str()) {
        (_, "") => None,
        (Operand::Timer(_), "TIMER") | (Operand::Counter(_), "COUNTER") => None,
        (Operand::Timer(_), _) => Some("TIMER"),
        (Operand::Counter(_), _) => Some("COUNTER"),
        (Operand::Address(inner) | Operand::InDataBlock { address: inner, .. }, _) => {
            match (DataType::from_word(&word).and_then(|data_type| data_type.width()), inner.width) {
                (Some(width), wanted) if width == wanted => None,
                (None, _) => None,
                (_, Width::Bit) => Some("BOOL"),
                (_, Width::Byte) => Some("BYTE or CHAR"),
                (_, Width::Word) => Some("WORD, INT, S5TIME or DATE"),
                (_, Width::DoubleWord) => Some("DWORD, DINT, REAL, TIME or TIME_OF_DAY"),
            }
        }
        (Operand::Block(_), _) => None,
    };
    if let Some(valid) = valid {
        let message = format!("the type `{}` does not fit the address `{address}`, which is {valid}", symbol.data_type.trim());
        diagnostics.push(Diagnostic::new(Problem::P6109, span, message));
    }
}

/// The four fields of STEP 7 V5, each cut to its width; every cut is a loss.
pub(crate) fn fixed_fields(symbol: &Symbol, losses: &mut Vec<String>) -> [String; 4] {
    let fields = [(&symbol.name, "name"), (&symbol.address, "address"), (&symbol.data_type, "data type"), (&symbol.comment, "comment")];
    let mut index = 0;
    fields.map(|(text, what)| {
        let width = WIDTHS[index];
        index += 1;
        let line: String = text.chars().map(|character| if character.is_control() { ' ' } else { character }).collect();
        let length = line.chars().count();
        if length > width {
            losses.push(format!("the {what} of `{}` is cut from {length} to {width} characters", symbol.name));
        }
        line.chars().take(width).chain(std::iter::repeat(' ')).take(width).collect()
    })
}

/// The columns that only the native table has.
pub(crate) fn report_lost_columns(table: &SymbolTable, losses: &mut Vec<String>) {
    for (index, column) in ["number", "unit", "tag", "remark"].into_iter().enumerate() {
        let used = |symbol: &Symbol| ![&symbol.number, &symbol.unit, &symbol.tag, &symbol.remark][index].is_empty();
        if table.symbols().iter().any(used) {
            losses.push(format!("the column `{column}` has no place in this format"));
        }
    }
    let mut names: Vec<&str> = table
        .symbols()
        .iter()
        .flat_map(|symbol| &symbol.extra)
        .filter(|(_, value)| !value.is_empty())
        .map(|(name, _)| name.as_str())
        .collect();
    names.sort_unstable();
    names.dedup();
    losses.extend(names.into_iter().map(|name| format!("the column `{name}` has no place in this format")));
}

/// Reads arbitrary bytes in every format and writes back what was understood; must never panic.
pub fn fuzz(data: &[u8]) {
    let text = crate::encoding::decode(data).text;
    for format in Format::ALL {
        let first = read(FileId(0), &text, format);
        for other in Format::ALL {
            let _ = write(&first.table, Layout::new(other));
        }
        let _ = assignment::text(&first.table);
        let _ = assignment::csv(&first.table);
    }
    let _ = detect("", &text);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const CSV: &str = "number,symbol,address,type,comment,unit,tag,remark,cabinet\n\
        1,START,I 0.0,BOOL,Start button,,S1,\"makes, contact\",A\n\
        2,Ventil_Ä,A  0.0,BOOL,\"says \"\"open\"\"\",,Y1,,A\n\
        ,Display,QW 4,WORD,,l,H1,,\n";

    fn codes(read: &Read) -> Vec<&'static str> {
        read.diagnostics.iter().map(|diagnostic| diagnostic.problem.code()).collect()
    }

    fn read_csv(text: &str) -> Read {
        read(FileId(0), text, Format::Csv)
    }

    #[test]
    fn a_native_table_comes_back_as_it_was() {
        for text in [
            CSV.to_owned(),
            CSV.replace('\n', "\r\n"),
            CSV.replace(',', ";").replace("makes;", "makes,").replace("\"makes, contact\"", "makes, contact"),
        ] {
            let first = read_csv(&text);
            assert_eq!(codes(&first), [""; 0], "{:?}", first.diagnostics);
            assert_eq!(write(&first.table, first.layout), Written { text, losses: Vec::new() });
            let valve = first.table.find("ventil_ä").expect("the valve");
            assert_eq!((valve.comment.as_str(), valve.extra.clone()), ("says \"open\"", vec![("cabinet".to_owned(), "A".to_owned())]));
        }
    }

    #[test]
    fn the_formats_of_step_7_round_trip() {
        let native = read_csv("symbol,address,type,comment\nMotor ein,A   4.0,BOOL,Förderband\nTank,DB 99,FB 100,\nVAT_1,VAT 1,,\n").table;
        for format in [Format::Sdf, Format::Asc] {
            let written = write(&native, Layout::new(format));
            assert_eq!(written.losses, Vec::<String>::new());
            assert!(written.text.ends_with("\r\n"));
            assert_eq!(detect("x", &written.text), Some(format));
            let again = read(FileId(0), &written.text, format);
            assert_eq!(codes(&again), [""; 0], "{:?}", again.diagnostics);
            assert_eq!(again.table.symbols(), native.symbols());
            assert_eq!(write(&again.table, again.layout), written);
        }
        let line = write(&native, Layout::new(Format::Asc)).text;
        assert!(line.lines().all(|line| line.starts_with("126,") && line.chars().count() == 130));
        let line = write(&native, Layout::new(Format::Sdf)).text;
        assert!(line.starts_with("\"Motor ein               \",\"A   4.0     \",\"BOOL      \",\"Förderband"));
    }

    #[test]
    fn unpadded_sdf_and_tag_tables_of_tia_are_read() {
        let read = read(
            FileId(0),
            "\"Start\",\"I 0.0\",\"BOOL\",\"\"\n\"Stop\",\"%I0.1\",\"Bool\",\"True\",\"True\",\"False\",\"stops\",\"\",\"True\"\n",
            Format::Sdf,
        );
        assert_eq!(codes(&read), [""; 0], "{:?}", read.diagnostics);
        assert_eq!(read.table.operand("START"), Operand::parse("I 0.0"));
        assert_eq!(read.table.operand("STOP"), Operand::parse("I 0.1"));
        assert_eq!(read.table.find("STOP").map(|symbol| symbol.comment.as_str()), Some("stops"));
    }

    #[test]
    fn each_fault_of_a_table_has_its_code_and_its_line() {
        for (text, code, line) in [
            ("symbol,address\nA,I 0.0\na,I 0.1\n", "P6101", 3),
            ("symbol,address\nA,I 0.0\nB,E 0.0\n", "P6102", 3),
            ("symbol,address\nA,I 0.8\n", "P6103", 2),
            ("symbol,address\nA,LW 2\n", "P6103", 2),
            ("symbol,type\nA,BOOL\n", "P6104", 1),
            ("", "P6104", 1),
            ("symbol,address\nA,I 0.0,more\n", "P6105", 2),
            ("symbol,address\nA_name_that_is_longer_than_24,I 0.0\n", "P6106", 2),
            ("symbol,address\n,I 0.0\n", "P6107", 2),
            ("symbol,address\nA,\n", "P6107", 2),
            ("symbol,address\nB,I 1.0\n\"A,I 0.0\n", "P6108", 3),
            ("symbol,address,type\nA,MW 2,BOOL\n", "P6109", 2),
            ("symbol,address,type\nA,T 2,BOOL\n", "P6109", 2),
            ("symbol,address\n\"A\"\"B\",I 0.0\n", "P6110", 2),
        ] {
            let read = read_csv(text);
            assert_eq!(codes(&read), [code], "{text}: {:?}", read.diagnostics);
            let before = &text[..read.diagnostics[0].span.start as usize];
            assert_eq!(before.lines().count() + 1, line, "{text}");
        }
        let asc = read(FileId(0), "A I 0.0\r\n126,Start                   I       0.0 BOOL\r\n", Format::Asc);
        assert_eq!(codes(&asc), ["P6105"]);
        assert_eq!(asc.table.symbols().len(), 1);
        let sdf = read(FileId(0), "\"Start\",\"I 0.0\"\r\n", Format::Sdf);
        assert_eq!(codes(&sdf), ["P6105"]);
    }

    #[test]
    fn what_a_format_cannot_hold_is_said() {
        let table = read_csv("symbol,address,comment,remark,x\nA_name_that_is_longer_than_24,I 0.0,two lines,r,y\n").table;
        assert_eq!(
            write(&table, Layout::new(Format::Asc)).losses,
            [
                "the name of `A_name_that_is_longer_than_24` is cut from 29 to 24 characters",
                "the column `remark` has no place in this format",
                "the column `x` has no place in this format"
            ]
        );
    }

    #[test]
    fn formats_are_known_by_extension_and_by_content() {
        assert_eq!(detect("a/SYMBOLS.SDF", ""), Some(Format::Sdf));
        assert_eq!(detect("table.txt", CSV), Some(Format::Csv));
        assert_eq!(detect("table.txt", "A I 0.0"), None);
    }

    /// A text without line ends and without blanks at its ends, which formats with padding cannot keep.
    fn any_text(length: usize) -> impl Strategy<Value = String> {
        proptest::collection::vec(prop_oneof![any::<char>(), prop::sample::select(vec![',', ';', '"', ' ', 'ä', 'I', '0'])], 0..length)
            .prop_map(|characters| characters.into_iter().filter(|character| !character.is_control()).collect::<String>().trim().to_owned())
    }

    fn any_symbol() -> impl Strategy<Value = Symbol> {
        (any_text(20), any_text(10), any_text(8), any_text(30), any_text(5), any_text(9)).prop_map(
            |(name, address, data_type, comment, number, remark)| Symbol {
                name: format!("n{name}"),
                address,
                data_type,
                comment,
                number,
                remark,
                ..Symbol::default()
            },
        )
    }

    proptest! {
        #[test]
        fn any_table_comes_back_from_csv(symbols in proptest::collection::vec(any_symbol(), 0..8), delimiter in prop::sample::select(vec![b',', b';'])) {
            let table = SymbolTable::new(symbols);
            let layout = Layout { delimiter, ..Layout::new(Format::Csv) };
            let again = read(FileId(0), &write(&table, layout).text, Format::Csv);
            prop_assert_eq!(again.table.symbols(), table.symbols());
            prop_assert_eq!(again.layout, layout);
        }

        #[test]
        fn what_fits_comes_back_from_the_formats_of_step_7(symbols in proptest::collection::vec(any_symbol(), 0..8)) {
            let plain = |symbol: Symbol| Symbol { number: String::new(), remark: String::new(), ..symbol };
            let table = SymbolTable::new(symbols.into_iter().map(plain).collect());
            for format in [Format::Sdf, Format::Asc] {
                let written = write(&table, Layout::new(format));
                prop_assert_eq!(&written.losses, &Vec::<String>::new());
                let again = read(FileId(0), &written.text, format);
                prop_assert_eq!(again.table.symbols(), table.symbols());
            }
        }
    }

    #[test]
    fn no_bytes_panic() {
        let seeds: [&[u8]; 6] =
            [CSV.as_bytes(), b"126,Start", b"126,\xC4\xD6", b"\"\"\"\"", b"symbol;address\n\";;\r\r\n,", b"\xFF\xFE\x22\x00"];
        for seed in seeds {
            for end in 0..=seed.len() {
                fuzz(&seed[..end]);
                let mut changed = seed.to_vec();
                if let Some(byte) = changed.get_mut(end) {
                    *byte = byte.wrapping_mul(31).wrapping_add(7);
                }
                fuzz(&changed);
            }
        }
    }
}
