//! The assignment table of a plant: number, address, unit, technological name, description, remark.

use sieben_model::address::{Address, Area, Operand};
use sieben_model::symbols::{Symbol, SymbolTable};

/// The headings of the table.
pub const HEADINGS: [&str; 6] = ["No.", "Address", "Unit", "Technological name", "Description", "Remark"];

/// The rows of the assignment table: by running number, rows without a number behind them by area and address.
///
/// If no row has a number, the rows are numbered as they stand. A row without a technological name has its symbol there.
pub fn rows(table: &SymbolTable) -> Vec<[String; 6]> {
    let mut symbols: Vec<&Symbol> = table.symbols().iter().collect();
    symbols.sort_by_cached_key(|symbol| (running_number(symbol), place(symbol)));
    let numbered = symbols.iter().any(|symbol| !symbol.number.trim().is_empty());
    let row = |(index, symbol): (usize, &&Symbol)| {
        let number = if numbered { symbol.number.trim().to_owned() } else { (index + 1).to_string() };
        let tag = if symbol.tag.trim().is_empty() { &symbol.name } else { &symbol.tag };
        [number, one_line(&symbol.address), one_line(&symbol.unit), one_line(tag), one_line(&symbol.comment), one_line(&symbol.remark)]
    };
    symbols.iter().enumerate().map(row).collect()
}

/// The text with single blanks between its words.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Numbers first, in their order; then texts such as `3a`; rows without a number last.
fn running_number(symbol: &Symbol) -> (u8, u64, String) {
    let text = symbol.number.trim();
    let digits = text.len() - text.trim_start_matches(|character: char| character.is_ascii_digit()).len();
    match text[..digits].parse() {
        _ if text.is_empty() => (2, 0, String::new()),
        Ok(number) => (0, number, text[digits..].to_owned()),
        Err(_) => (1, 0, text.to_owned()),
    }
}

/// Inputs, outputs, bit memory, peripherals, timers, counters, data, blocks, and last what is no address.
fn place(symbol: &Symbol) -> (u8, u16, u32, u8, String) {
    let in_area = |rank: u8, db: u16, address: Address| (rank, db, address.byte, address.bit, String::new());
    match symbol.operand() {
        Some(Operand::Address(address)) => match address.area {
            Area::Input => in_area(0, 0, address),
            Area::Output => in_area(1, 0, address),
            Area::BitMemory => in_area(2, 0, address),
            Area::PeripheralInput => in_area(3, 0, address),
            Area::PeripheralOutput => in_area(4, 0, address),
            _ => in_area(8, 0, address),
        },
        Some(Operand::Timer(number)) => (5, number, 0, 0, String::new()),
        Some(Operand::Counter(number)) => (6, number, 0, 0, String::new()),
        Some(Operand::InDataBlock { db, address }) => in_area(7, db, address),
        Some(Operand::Block(block)) => (9, block.number, 0, 0, block.kind.abbreviation().to_owned()),
        None => (10, 0, 0, 0, symbol.address.clone()),
    }
}

/// Widest column that is lined up; longer fields push the rest of their row aside, not every row.
const WIDTH_MAX: usize = 160;

/// The table in aligned columns, with a rule under the headings.
pub fn text(table: &SymbolTable) -> String {
    let rows = rows(table);
    let widths: [usize; 6] = std::array::from_fn(|column| {
        rows.iter().map(|row| row[column].chars().count()).chain([HEADINGS[column].chars().count()]).max().unwrap_or(0).min(WIDTH_MAX)
    });
    let line = |fields: [&str; 6]| {
        let padded: Vec<String> = fields.iter().zip(widths).map(|(field, width)| format!("{field:<width$}")).collect();
        format!("{}\n", padded.join("  ").trim_end())
    };
    let mut text = line(HEADINGS);
    text.push_str(&widths.map(|width| "─".repeat(width)).join("  "));
    text.push('\n');
    for row in &rows {
        text.push_str(&line(row.each_ref().map(String::as_str)));
    }
    text
}

/// The table as CSV with its headings.
pub fn csv(table: &SymbolTable) -> String {
    let mut lines = vec![HEADINGS.map(str::to_owned).to_vec()];
    lines.extend(rows(table).into_iter().map(|row| row.to_vec()));
    super::csv::lines(&lines, b',')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbols::{Format, read};
    use sieben_model::source::FileId;

    fn table(text: &str) -> SymbolTable {
        read(FileId(0), text, Format::Csv).table
    }

    #[test]
    fn the_table_is_sorted_by_number_and_then_by_address() {
        let table = table(
            "symbol,address,comment,number,unit,tag,remark\nc,C 0,,10,l,,\na,Q 0.0,Valve,2,,Y1,\"opens, closes\"\nz,M 0.0,,,,,\ny,I 0.1,,,,,\n",
        );
        assert_eq!(
            text(&table),
            "\
No.  Address  Unit  Technological name  Description  Remark
───  ───────  ────  ──────────────────  ───────────  ─────────────
2    Q 0.0          Y1                  Valve        opens, closes
10   C 0      l     c
     I 0.1          y
     M 0.0          z
"
        );
        assert!(csv(&table).starts_with("No.,Address,Unit,Technological name,Description,Remark\n2,Q 0.0,,Y1,Valve,\"opens, closes\"\n"));
    }

    #[test]
    fn rows_without_any_number_are_numbered() {
        let rows = rows(&table("symbol,address\nd,DB 2\nt,T 1\nq,A 4.0\ni,EW 2\n"));
        let short: Vec<String> = rows.iter().map(|row| format!("{} {}", row[0], row[1])).collect();
        assert_eq!(short, ["1 EW 2", "2 A 4.0", "3 T 1", "4 DB 2"]);
    }

    #[test]
    fn a_very_long_comment_does_not_make_every_row_long() {
        let long = "x".repeat(100_000);
        let text = text(&table(&format!("symbol,address,comment\na,Q 0.0,{long}\nb,Q 0.1,{long}\n")));
        assert!(text.len() > 200_000 && text.len() < 202_000, "{}", text.len());
    }
}
