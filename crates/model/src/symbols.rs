//! The symbol table, which is also the assignment table of the course notes.

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

/// All symbols of a project, in the order of the table.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SymbolTable {
    /// The rows.
    pub symbols: Vec<Symbol>,
}
