//! A row of the symbol table for a name or an address that has none.

use std::collections::HashSet;

use sieben_lang::names::Written;
use sieben_lang::symbols::{self, Format, Layout};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::source::FileId;
use sieben_model::symbols::{Symbol, SymbolTable};

use super::super::context::{line_before, quotes_names};
use super::{Action, At, Bytes, Edit, Kind, Place, Role, TextId, line_end};

/// Bytes of bit memory that are looked through for a free one.
const BYTES_MAX: u32 = 2_048;

/// Adds a symbol for what stands at the cursor.
pub(super) fn actions(at: &At<'_>) -> Option<Action> {
    let source = at.snapshot.of_text(at.text)?;
    let index = source.at(at.range.start)?;
    let one = source.occurrence(index)?;
    let names = at.snapshot.names();
    let resolved = names.resolve(at.text.0 as u32, index);
    let written = at.snapshot.slice(at.text, one.span.into());
    let mnemonics = at.snapshot.usual_mnemonics();
    let (name, operand) = match one.written {
        Written::Operand(operand) if names.symbol_of(operand).is_none() && !matches!(operand, Operand::Block(_)) => {
            let spelled = operand.spell(mnemonics).replace(' ', "").replace('.', "_");
            (free_name(at, &format!("Tag_{spelled}")), operand)
        }
        Written::Global(_) if resolved.is_none() && quotes_names(at.snapshot.language(at.text)?) => {
            let Some(free) = free_address(at) else {
                let title = format!("Add a symbol `{written}`");
                return Some(Action::disabled(Kind::QuickFix, title, format!("the first {BYTES_MAX} bytes of bit memory are all in use")));
            };
            (written.to_owned(), free)
        }
        Written::Plain(_) if resolved.is_none() && !quotes_names(at.snapshot.language(at.text)?) => return None,
        _ => return None,
    };
    let table = at.snapshot.texts().iter().position(|text| text.role == Role::Symbols);
    let Some(table) = table else {
        let title = format!("Add a symbol `{name}`");
        return Some(Action::disabled(Kind::QuickFix, title, "the project has no symbol table; `symbols.csv` in its folder would be one"));
    };
    let table_name = at.snapshot.texts()[table].name.rsplit(['/', '\\']).next().unwrap_or_default();
    let title = format!("Add `{name}` with {} to {table_name}", operand.spell(mnemonics));
    match row(at, TextId(table), &name, operand) {
        Ok(edit) => Some(Action::new(Kind::QuickFix, title, vec![edit])),
        Err(reason) => Some(Action::disabled(Kind::QuickFix, title, reason)),
    }
}

/// The row at the end of the table.
fn row(at: &At<'_>, table: TextId, name: &str, operand: Operand) -> Result<Edit, String> {
    let text = at.snapshot.text(table).map_or("", |text| &text.text);
    let table_name = at.snapshot.text(table).map_or("", |text| text.name.as_str());
    let format = symbols::detect(table_name, text).unwrap_or(Format::Csv);
    if format == Format::Dif {
        return Err("a table in the format DIF counts its rows at its beginning; add the symbol where the table is made".to_owned());
    }
    if format != Format::Csv && name.chars().count() > symbols::NAME_MAX {
        return Err(format!("a symbol in this table has at most {} characters", symbols::NAME_MAX));
    }
    let read = symbols::read(FileId::default(), text, format);
    let address = operand.spell(at.snapshot.usual_mnemonics());
    let data_type = match operand.width() {
        Some(Width::Bit) => "BOOL",
        Some(Width::Byte) => "BYTE",
        Some(Width::Word) => "WORD",
        Some(_) => "DWORD",
        None => match operand {
            Operand::Timer(_) => "TIMER",
            Operand::Counter(_) => "COUNTER",
            _ => "",
        },
    };
    let symbol = Symbol { name: name.to_owned(), address, data_type: data_type.to_owned(), ..Symbol::default() };
    let mut one = SymbolTable::new(vec![symbol]);
    one.set_columns(read.table.columns().to_vec());
    let layout = Layout { carriage_returns: false, ..read.layout };
    let written = symbols::write(&one, layout).text;
    let line = written.lines().last().unwrap_or_default();
    let end = text.trim_end_matches(['\u{1A}', ' ', '\n', '\r']).len();
    // The row stands after the last one, before empty lines.
    let line_end = line_end(text);
    let place = Place { text: table, range: Bytes { start: end, end } };
    let header = if end == 0 { written.trim_end() } else { line };
    let new_text = if end == 0 { format!("{header}{line_end}") } else { format!("{line_end}{header}") };
    Ok(Edit { place, new_text })
}

/// The name, or the name with a number, that nothing has.
fn free_name(at: &At<'_>, wanted: &str) -> String {
    let names = at.snapshot.names();
    let numbered = (2..1_000).map(|number| format!("{wanted}_{number}"));
    let mut all = std::iter::once(wanted.to_owned()).chain(numbered);
    all.find(|name| names.global(name).is_none() && Operand::parse(name).is_none()).unwrap_or_else(|| wanted.to_owned())
}

/// Bit memory that nothing uses: a bit or a word, as the instruction takes it.
fn free_address(at: &At<'_>) -> Option<Operand> {
    let mut used = HashSet::new();
    for source in at.snapshot.names().texts() {
        let written = source.addresses().iter().filter_map(|&index| source.occurrence(index));
        for one in written {
            match one.written {
                Written::Operand(Operand::Address(Address { area: Area::BitMemory, byte, width, .. })) => {
                    used.extend(byte..byte.saturating_add(width.bytes()));
                }
                Written::Range(Area::BitMemory, _, position, bits) => {
                    let first = position / 8;
                    used.extend(first..first.saturating_add(bits.div_ceil(8).min(BYTES_MAX)));
                }
                _ => {}
            }
        }
        let symbols = source.definitions.iter().filter_map(|one| one.operand);
        for operand in symbols {
            if let Operand::Address(Address { area: Area::BitMemory, byte, width, .. }) = operand {
                used.extend(byte..byte.saturating_add(width.bytes()));
            }
        }
    }
    let line = line_before(at.content(), at.range.start);
    let word = line.trim_start().rsplit(':').next().unwrap_or_default().split_whitespace().next().unwrap_or_default().to_ascii_uppercase();
    let width = if matches!(word.as_str(), "L" | "T") { Width::Word } else { Width::Bit };
    let is_free =
        |byte: &u32| (*byte..*byte + width.bytes()).all(|byte| !used.contains(&byte)) && (width == Width::Bit || byte.is_multiple_of(2));
    let byte = (0..BYTES_MAX).find(is_free)?;
    Some(Operand::Address(Address { area: Area::BitMemory, width, byte, bit: 0 }))
}
