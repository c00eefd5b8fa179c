//! The table of loaded data blocks, which knows whether anybody changed it.

use std::ops::{Deref, DerefMut};

use super::memory::DataBlockEntry;

/// Data blocks by number: first byte and length in the arena, write protection. Index 0 is never used.
#[derive(Clone, Debug, Default)]
pub struct DataBlockTable {
    entries: Vec<Option<DataBlockEntry>>,
    changed: bool,
}

impl DataBlockTable {
    /// The table of a program as it was laid out.
    pub fn new(entries: Vec<Option<DataBlockEntry>>) -> Self {
        Self { entries, changed: false }
    }

    /// Whether it certainly is as it was laid out: nobody had it to write since.
    pub fn is_as_laid_out(&self) -> bool {
        !self.changed
    }
}

/// Tables are equal if their entries are.
impl PartialEq for DataBlockTable {
    fn eq(&self, other: &Self) -> bool {
        self.entries == other.entries
    }
}

impl Deref for DataBlockTable {
    type Target = Vec<Option<DataBlockEntry>>;
    fn deref(&self) -> &Self::Target {
        &self.entries
    }
}

impl DerefMut for DataBlockTable {
    fn deref_mut(&mut self) -> &mut Self::Target {
        self.changed = true;
        &mut self.entries
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_writes_to_the_table_marks_it() {
        let entry = DataBlockEntry { base: 16, length: 4, read_only: false };
        let mut table = DataBlockTable::new(vec![None, Some(entry)]);
        let before = table.clone();
        assert_eq!(table.get(1).copied().flatten(), Some(entry));
        assert!(table.is_as_laid_out());
        table[1] = None;
        assert!(!table.is_as_laid_out() && table != before);
        table[1] = Some(entry);
        assert!(!table.is_as_laid_out() && table == before);
    }
}
