//! The names in a symbol table: each row with the places of its symbol and its address.

use std::ops::Range;

use sieben_model::source::FileId;
use sieben_model::symbols::Symbol;
use sieben_model::types::DataType;

use super::headings::{ADDRESS, SYMBOL, column_kinds};
use super::{Format, NAME_MAX, Sink, WIDTHS, asc, csv, dif, sdf, seq};
use crate::names::{Access, Builder, Bytes, DefinitionKind, SourceNames, TypeRef, Written};

/// A row of a table with the places of its cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What it says.
    pub symbol: Symbol,
    /// The whole row.
    pub whole: Range<usize>,
    /// The symbol, without padding; `None` if it is not found as it is written.
    pub name: Option<Range<usize>>,
    /// The address.
    pub address: Option<Range<usize>>,
    /// Bytes of spaces after the symbol that belong to it where columns have a fixed width.
    pub padding: usize,
}

/// The rows of a table with their places.
pub fn rows(text: &str, format: Format) -> Vec<Row> {
    let mut sink = Sink { file: FileId::default(), rows: Vec::new(), diagnostics: Vec::new(), unnamed: false };
    let (mut columns, mut delimiter) = (Vec::new(), b',');
    match format {
        Format::Csv => (columns, delimiter) = csv::read(text, &mut sink),
        Format::Sdf => sdf::read(text, &mut sink),
        Format::Asc => asc::read(text, &mut sink),
        Format::Dif => dif::read(text, &mut sink),
        Format::Seq => seq::read(text, &mut sink),
    }
    let kinds = column_kinds(&columns);
    let column = |kind| kinds.iter().position(|known| *known == Some(kind));
    let (name_column, address_column) = match format {
        Format::Csv => (column(SYMBOL), column(ADDRESS)),
        _ => (Some(0), Some(1)),
    };
    let row = |(symbol, span): (Symbol, sieben_model::source::Span)| {
        let whole = span.start as usize..span.end as usize;
        let slice = text.get(whole.clone()).unwrap_or_default();
        let cells: Vec<Range<usize>> = match format {
            Format::Csv | Format::Sdf => cells(slice, char::from(delimiter)),
            Format::Asc => fixed(slice),
            Format::Dif => lines(slice),
            Format::Seq => Vec::new(),
        };
        let wanted = |value: &str, cell: Option<usize>| {
            let value = value.trim();
            let inside = |range: &Range<usize>| {
                let text = slice.get(range.clone())?;
                let at = text.find(value)?;
                (text.trim() == value || text.trim().trim_start_matches('%') == value)
                    .then(|| range.start + at..range.start + at + value.len())
            };
            let found = match format {
                Format::Seq => slice.find(value).map(|at| at..at + value.len()),
                Format::Dif => cells.iter().find_map(inside),
                _ => cell.and_then(|cell| cells.get(cell)).and_then(inside),
            };
            found.filter(|_| !value.is_empty()).map(|range| whole.start + range.start..whole.start + range.end)
        };
        let (name, address) = (wanted(&symbol.name, name_column), wanted(&symbol.address, address_column));
        let padding = match (&name, format) {
            (Some(name), Format::Sdf | Format::Asc | Format::Dif) => {
                let after = text.get(name.end..whole.end).unwrap_or_default();
                let most = NAME_MAX.saturating_sub(symbol.name.trim().chars().count());
                after.bytes().take(most).take_while(|&byte| byte == b' ').count()
            }
            _ => 0,
        };
        Row { symbol, whole, name, address, padding }
    };
    sink.rows.into_iter().map(row).collect()
}

/// The cells of a row with a sign between them; quotes do not belong to them.
fn cells(row: &str, delimiter: char) -> Vec<Range<usize>> {
    let mut cells = Vec::new();
    let (mut start, mut quoted) = (0, false);
    for (at, sign) in row.char_indices().chain([(row.len(), delimiter)]) {
        match sign {
            '"' => quoted = !quoted,
            _ if sign == delimiter && (!quoted || at == row.len()) => {
                let cell = &row[start..at];
                let is_quoted = cell.trim().len() > 1 && cell.trim().starts_with('"') && cell.trim().ends_with('"');
                let from = start + if is_quoted { cell.find('"').unwrap_or(0) + 1 } else { 0 };
                let to = if is_quoted { start + cell.rfind('"').unwrap_or(cell.len()) } else { at };
                cells.push(from..to.max(from));
                start = at + sign.len_utf8();
            }
            _ => {}
        }
    }
    cells
}

/// The cells of a line with fixed columns.
fn fixed(row: &str) -> Vec<Range<usize>> {
    let lead = "126,".len();
    let position = |characters: usize| {
        let rest = row.get(lead..).unwrap_or_default();
        lead + rest.char_indices().nth(characters).map_or(rest.len(), |(at, _)| at)
    };
    let mut from = 0;
    let cell = |width: usize| {
        let range = position(from)..position(from + width);
        from += width;
        range
    };
    WIDTHS.into_iter().map(cell).collect()
}

/// The texts in quotes of the lines of a row.
fn lines(row: &str) -> Vec<Range<usize>> {
    let mut start = 0;
    let mut cells = Vec::new();
    for line in row.split_inclusive('\n') {
        let content = line.trim_end_matches(['\n', '\r']);
        if content.len() > 1 && content.starts_with('"') && content.ends_with('"') {
            cells.push(start + 1..start + content.len() - 1);
        }
        start += line.len();
    }
    cells
}

/// The names in a table.
pub fn names(text: &str, format: Format) -> SourceNames {
    let mut builder = Builder::new(text, None);
    for row in rows(text, format) {
        if row.symbol.name.trim().is_empty() {
            continue;
        }
        let bytes = |range: &Range<usize>| Bytes { start: range.start as u32, end: range.end as u32 };
        let whole = bytes(&row.whole);
        let name = row.name.as_ref().map_or(Bytes { start: whole.start, end: whole.start }, bytes);
        let index = builder.define_at(DefinitionKind::Symbol, row.symbol.name.trim(), name, whole);
        let operand = row.symbol.operand();
        let data_type = row.symbol.data_type.trim();
        let of = match DataType::from_word(&data_type.to_ascii_uppercase()) {
            Some(_) => TypeRef::None,
            None => match sieben_model::address::Operand::parse(data_type) {
                Some(sieben_model::address::Operand::Block(block)) if operand != Some(sieben_model::address::Operand::Block(block)) => {
                    TypeRef::Block(block)
                }
                Some(_) => TypeRef::None,
                None if data_type.is_empty() => TypeRef::None,
                None => TypeRef::Named(builder.id(data_type.trim_matches('"'))),
            },
        };
        let definition = builder.definition(index);
        definition.operand = operand;
        data_type.clone_into(&mut definition.data_type);
        definition.comment = row.symbol.comment.trim().to_owned();
        definition.of = of;
        if let (Some(operand), Some(address)) = (operand, &row.address) {
            builder.push(bytes(address), Written::Operand(operand), Access::Definition);
        }
    }
    builder.finish()
}
