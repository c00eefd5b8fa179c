//! Symbol tables: the native `symbols.csv`, the exports `.sdf`, `.asc`, `.dif` and `.seq` of STEP 7 V5, and the assignment table.

pub mod asc;
pub mod assignment;
mod check;
pub mod csv;
pub mod dif;
mod headings;
pub mod names;
pub mod sdf;
pub mod seq;

use sieben_model::address::Operand;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};
use sieben_model::symbols::{Symbol, SymbolTable};

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
    /// `.dif`: the data interchange format of spreadsheets, four cells a row.
    Dif,
    /// `.seq`: the assignment list of STEP 5, without data types.
    Seq,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 5] = [Self::Csv, Self::Sdf, Self::Asc, Self::Dif, Self::Seq];

    /// The file name extension.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Sdf => "sdf",
            Self::Asc => "asc",
            Self::Dif => "dif",
            Self::Seq => "seq",
        }
    }

    /// What the format is, in a few words.
    pub fn describe(self) -> &'static str {
        match self {
            Self::Csv => "our own: RFC 4180 with a header; of TIA and spreadsheets with their headings",
            Self::Sdf => "STEP 7 V5: four fields in quotes, padded or not; TIA: nine fields",
            Self::Asc => "STEP 7 V5: fixed columns of 130 characters a line",
            Self::Dif => "STEP 7 V5 and spreadsheets: data interchange format",
            Self::Seq => "STEP 5: address, symbol and comment with tabulators (order and first tabulator uncertain, all are read)",
        }
    }

    /// What of a table the format takes when it is written, in a few words.
    pub fn describe_written(self) -> &'static str {
        match self {
            Self::Csv => "everything",
            Self::Sdf => "in the form of STEP 7 V5, without the columns of the assignment table",
            Self::Asc | Self::Dif => "without the columns of the assignment table",
            Self::Seq => "without data types and the columns of the assignment table",
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
    /// What stands between the fields of a CSV: a comma, or the semicolon or tabulator of some spreadsheets.
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

/// The format of a table by its first lines, else by the name of its file.
pub fn detect(name: &str, text: &str) -> Option<Format> {
    by_content(text).or_else(|| Format::from_name(name))
}

/// The format that the first lines of a text show; `None` if they fit none.
pub fn by_content(text: &str) -> Option<Format> {
    let line = text.lines().find(|line| !line.trim().is_empty())?;
    match () {
        () if line.starts_with("126,") => Some(Format::Asc),
        () if dif::is_dif(text) => Some(Format::Dif),
        () if csv::begins_with_headings(line) => Some(Format::Csv),
        () if csv::begins_with_number(line) => Some(Format::Csv),
        () if line.starts_with('"') && line.matches('"').count() >= 8 => Some(Format::Sdf),
        () if seq::is_seq(text) => Some(Format::Seq),
        () => None,
    }
}

/// Reads a table and checks its rows.
pub fn read(file: FileId, text: &str, format: Format) -> Read {
    let mut sink = Sink { file, rows: Vec::new(), diagnostics: Vec::new(), unnamed: false };
    let mut layout = Layout::new(format);
    layout.carriage_returns = text.contains("\r\n") || (layout.carriage_returns && !text.contains('\n'));
    let mut columns = Vec::new();
    match format {
        Format::Csv => (columns, layout.delimiter) = csv::read(text, &mut sink),
        Format::Sdf => sdf::read(text, &mut sink),
        Format::Asc => asc::read(text, &mut sink),
        Format::Dif => dif::read(text, &mut sink),
        Format::Seq => seq::read(text, &mut sink),
    }
    let Sink { rows, mut diagnostics, unnamed, .. } = sink;
    check::rows(&rows, unnamed, &mut diagnostics);
    diagnostics.sort_by_key(|diagnostic| diagnostic.span.start);
    let mut table = SymbolTable::new(rows.into_iter().map(|(symbol, _)| symbol).collect());
    table.set_columns(columns);
    Read { table, layout, diagnostics }
}

/// Writes a table.
pub fn write(table: &SymbolTable, layout: Layout) -> Written {
    let mut losses = Vec::new();
    let named;
    let table = if layout.format == Format::Csv {
        table
    } else {
        named = with_symbols(table, &mut losses);
        &named
    };
    let text = match layout.format {
        Format::Csv => csv::write(table, layout.delimiter),
        Format::Sdf => sdf::write(table, &mut losses),
        Format::Asc => asc::write(table, &mut losses),
        Format::Dif => dif::write(table, &mut losses),
        Format::Seq => seq::write(table, &mut losses),
    };
    let text = if layout.carriage_returns { text.replace('\n', "\r\n") } else { text };
    Written { text, losses }
}

/// The rows of a table that have a symbol; the others are rows of an assignment table, which no other format has.
fn with_symbols(table: &SymbolTable, losses: &mut Vec<String>) -> SymbolTable {
    let (named, unnamed): (Vec<_>, Vec<_>) = table.symbols().iter().cloned().partition(|symbol| !symbol.name.is_empty());
    losses.extend(unnamed.iter().map(|symbol| format!("`{}` has no symbol, and its row no place in this format", symbol.address.trim())));
    let mut named = SymbolTable::new(named);
    named.set_columns(table.columns().to_vec());
    named
}

/// Where the readers put rows and what is wrong with lines.
pub(crate) struct Sink {
    file: FileId,
    rows: Vec<(Symbol, Span)>,
    diagnostics: Vec<Diagnostic>,
    /// Whether rows may have no symbol.
    unnamed: bool,
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

/// Whether a field is the address of a symbol, in either mnemonic language.
pub(crate) fn is_address(text: &str) -> bool {
    let address = text.trim();
    check::is_variable_table(address) || Operand::parse(address.strip_prefix('%').unwrap_or(address)).is_some()
}

/// The four fields of STEP 7 V5, each cut to its width; every cut is a loss.
pub(crate) fn fixed_fields(symbol: &Symbol, losses: &mut Vec<String>) -> [String; 4] {
    let fields = [(&symbol.name, "name"), (&symbol.address, "address"), (&symbol.data_type, "data type"), (&symbol.comment, "comment")];
    let mut index = 0;
    fields.map(|(text, what)| {
        let width = WIDTHS[index];
        // A name may begin with a space, an address or a type never does.
        let text = if index == 1 || index == 2 { text.trim_start() } else { text };
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
mod tests;
