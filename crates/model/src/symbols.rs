//! The symbol table, which is also the assignment table of the course notes.

use std::collections::HashMap;

use crate::address::Operand;

/// One row of the symbol table.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Symbol {
    /// The name; compared without regard to case.
    pub name: String,
    /// The absolute address as written, in either mnemonic language: `I 0.0`, `MW  10`, `DB 5`, `FC 1`.
    pub address: String,
    /// The data type as written: `BOOL`, `FB 100`, `UDT 3`.
    pub data_type: String,
    /// The comment.
    pub comment: String,
    /// Running number in the assignment table.
    pub number: String,
    /// Physical unit.
    pub unit: String,
    /// Technological name (tag of the device in the plant).
    pub tag: String,
    /// Remark.
    pub remark: String,
    /// Columns that a native table has beyond these, by header.
    pub extra: Vec<(String, String)>,
}

impl Symbol {
    /// The operand that the address means; `None` if it is not understood. A `%` before it, as TIA writes, does not count.
    pub fn operand(&self) -> Option<Operand> {
        let address = self.address.trim();
        Operand::parse(address.strip_prefix('%').unwrap_or(address))
    }
}

/// All symbols of a project, in the order of the table, with an index by name and by operand.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SymbolTable {
    symbols: Vec<Symbol>,
    /// Position of the first symbol with this name, in lower case.
    by_name: HashMap<String, usize>,
    /// Position of the first symbol with this address.
    by_operand: HashMap<Operand, usize>,
    columns: Vec<String>,
}

impl SymbolTable {
    /// A table of these rows. If a name or an address occurs twice, the first row answers to it.
    pub fn new(symbols: Vec<Symbol>) -> Self {
        let mut table = Self::default();
        symbols.into_iter().for_each(|symbol| table.push(symbol));
        table
    }

    /// Adds a row at the end.
    pub fn push(&mut self, symbol: Symbol) {
        let position = self.symbols.len();
        if !symbol.name.is_empty() {
            self.by_name.entry(symbol.name.to_lowercase()).or_insert(position);
        }
        if let Some(operand) = symbol.operand() {
            self.by_operand.entry(operand).or_insert(position);
        }
        self.symbols.push(symbol);
    }

    /// The rows.
    pub fn symbols(&self) -> &[Symbol] {
        &self.symbols
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.symbols.is_empty()
    }

    /// The symbol with this name, without regard to case.
    pub fn find(&self, name: &str) -> Option<&Symbol> {
        self.by_name.get(&name.to_lowercase()).map(|&position| &self.symbols[position])
    }

    /// What this symbol means: its operand; `None` if there is no such symbol or its address is not understood.
    pub fn operand(&self, name: &str) -> Option<Operand> {
        self.find(name)?.operand()
    }

    /// The first symbol of an address or block.
    pub fn find_operand(&self, operand: &Operand) -> Option<&Symbol> {
        self.by_operand.get(operand).map(|&position| &self.symbols[position])
    }

    /// The columns of the file it came from, in their order and spelling; empty for formats that have no header.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// Keeps the columns of the file for writing it back.
    pub fn set_columns(&mut self, columns: Vec<String>) {
        self.columns = columns;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn symbol(name: &str, address: &str) -> Symbol {
        Symbol { name: name.to_owned(), address: address.to_owned(), ..Symbol::default() }
    }

    #[test]
    fn names_are_found_without_case_and_addresses_in_either_mnemonic() {
        let table = SymbolTable::new(vec![symbol("Ventil_Ä", "A  4.0"), symbol("Zähler", "Z 1"), symbol("VENTIL_ä", "M 0.0")]);
        assert_eq!(table.find("ventil_Ä").map(|symbol| symbol.address.as_str()), Some("A  4.0"));
        let output = Operand::parse("Q 4.0").expect("an address");
        assert_eq!(table.find_operand(&output).map(|symbol| symbol.name.as_str()), Some("Ventil_Ä"));
        assert_eq!(table.operand("ZÄHLER"), Some(Operand::Counter(1)));
        assert_eq!(table.find("nothing"), None);
    }
}
