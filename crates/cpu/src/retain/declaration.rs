//! What the bytes of the retentive data blocks mean, as numbers that can be compared: image and program must agree.

use std::collections::{BTreeMap, BTreeSet};

use sieben_engine::Program;
use sieben_model::program::DataBlock;
use sieben_model::types::{DataType, Structure};

/// The retentive data blocks of a program with what their declarations amount to.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Declarations {
    /// Hash of the declaration, by number of the data block.
    pub(crate) blocks: BTreeMap<u16, u64>,
    /// Hash of all of them together.
    pub(crate) hash: u64,
    /// Data blocks of any kind, whose numbers the program cannot create, with their initial values.
    pub(crate) all: BTreeMap<u16, Initial>,
    /// Retentive data blocks that belong to the hash and were changed from outside since: they are not kept.
    pub(crate) gone: BTreeSet<u16>,
}

/// The initial values of a data block, to be compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Initial {
    pub(crate) hash: u64,
    /// How many bytes there are.
    pub(crate) length: usize,
}

impl Declarations {
    /// Those of a program. Constant (READ_ONLY) data blocks are not retentive: their values come from the program.
    pub(crate) fn of(program: &Program) -> Self {
        let retentive = program.data.values().filter(|block| !block.non_retain && !block.unlinked && !block.read_only);
        let blocks: BTreeMap<u16, u64> = retentive.map(|block| (block.number, declaration(block))).collect();
        let mut hash = Hash::new();
        for (&number, &declaration) in &blocks {
            hash.number(u64::from(number));
            hash.number(declaration);
        }
        Self {
            blocks,
            hash: hash.0,
            all: program.data.values().map(|block| (block.number, initial(block))).collect(),
            gone: BTreeSet::new(),
        }
    }

    /// What is kept after data blocks came, went or changed that the sources know nothing of: the data blocks of the sources that are as they were.
    /// They belong together as before, so that the next start takes them back.
    pub(crate) fn after_change(&self, now: &Self) -> Self {
        let is_same = |number: &u16, declaration: &u64| now.blocks.get(number) == Some(declaration);
        let (same, other): (BTreeMap<u16, u64>, BTreeMap<u16, u64>) = self.blocks.iter().partition(|&(number, hash)| is_same(number, hash));
        let gone = self.gone.iter().copied().chain(other.into_keys()).collect();
        Self { blocks: same, hash: self.hash, all: now.all.clone(), gone }
    }
}

/// Length, names, types and places. Initial values are left out: a changed one takes effect with the next cold restart.
fn declaration(block: &DataBlock) -> u64 {
    let mut hash = Hash::new();
    hash.number(block.image.len() as u64);
    hash.structure(&block.structure);
    hash.0
}

fn initial(block: &DataBlock) -> Initial {
    let mut hash = Hash::new();
    for &byte in &block.image {
        hash.byte(byte);
    }
    Initial { hash: hash.0, length: block.image.len() }
}

/// FNV-1a with 64 bits: the same in every version and on every machine, as an image outlives both.
struct Hash(u64);

impl Hash {
    fn new() -> Self {
        Self(0xCBF2_9CE4_8422_2325)
    }

    fn byte(&mut self, byte: u8) {
        self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3);
    }

    fn number(&mut self, number: u64) {
        for byte in number.to_be_bytes() {
            self.byte(byte);
        }
    }

    fn text(&mut self, text: &str) {
        self.number(text.len() as u64);
        for byte in text.bytes() {
            self.byte(byte.to_ascii_lowercase());
        }
    }

    fn structure(&mut self, structure: &Structure) {
        self.number(u64::from(structure.size));
        // One without bytes has nothing that could be confused, and nested ones could be very many.
        let fields = if structure.size == 0 { [].as_slice() } else { &structure.fields };
        for field in fields {
            self.text(&field.name);
            self.number(u64::from(field.offset));
            self.data_type(&field.data_type);
        }
    }

    fn data_type(&mut self, data_type: &DataType) {
        match data_type {
            DataType::String(length) => {
                self.text("STRING");
                self.byte(*length);
            }
            DataType::Array { bounds, element } => {
                self.text("ARRAY");
                for &(low, high) in bounds {
                    self.number(u64::from(low as u32));
                    self.number(u64::from(high as u32));
                }
                self.data_type(element);
            }
            DataType::Struct(structure) | DataType::Instance { structure, .. } => {
                self.text("STRUCT");
                self.structure(structure);
            }
            DataType::WideString(length) => {
                self.text("WSTRING");
                self.number(u64::from(*length));
            }
            DataType::Reference(_) => self.text("REF_TO"),
            other => self.text(other.base().word().unwrap_or_default()),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use sieben_model::types::Field;

    use super::*;

    fn block(fields: &[(&str, DataType, u32)], bytes: usize) -> DataBlock {
        let fields = fields.iter().map(|(name, data_type, offset)| Field {
            name: (*name).to_owned(),
            data_type: data_type.clone(),
            offset: *offset,
            initial: Vec::new(),
            comment: String::new(),
        });
        let structure = Arc::new(Structure { name: None, fields: fields.collect(), size: bytes as u32, index: Default::default() });
        DataBlock { number: 1, based_on: None, structure, image: vec![0; bytes], read_only: false, non_retain: false, unlinked: false }
    }

    #[test]
    fn a_declaration_is_known_by_names_types_places_and_length() {
        let first = block(&[("a", DataType::Int, 0), ("b", DataType::Word, 16)], 4);
        let same = DataBlock { image: vec![7; 4], ..block(&[("A", DataType::Int, 0), ("B", DataType::Word, 16)], 4) };
        assert_eq!(declaration(&first), declaration(&same), "neither case nor initial values count");
        for other in [
            block(&[("b", DataType::Int, 0), ("a", DataType::Word, 16)], 4),
            block(&[("a", DataType::Int, 0), ("b", DataType::Int, 16)], 4),
            block(&[("a", DataType::Int, 0), ("b", DataType::Word, 32)], 4),
            block(&[("a", DataType::Int, 0), ("b", DataType::Word, 16)], 6),
            block(&[("a", DataType::Int, 0)], 4),
            block(&[("a", DataType::Int, 0), ("b", DataType::Array { bounds: vec![(1, 1)], element: Box::new(DataType::Word) }, 16)], 4),
        ] {
            assert_ne!(declaration(&first), declaration(&other), "{other:?}");
        }
        let string = |length| declaration(&block(&[("s", DataType::String(length), 0)], 4));
        assert_ne!(string(1), string(2));
    }

    #[test]
    fn the_hash_of_a_declaration_stays_what_it_is() {
        // Images on disks know it: another number here means that every plant starts without its data.
        let known = block(&[("count", DataType::DoubleInt, 0), ("name", DataType::String(10), 32)], 16);
        assert_eq!(declaration(&known), KNOWN, "{:#X}", declaration(&known));
    }

    const KNOWN: u64 = 0x3C4A_3AA3_A1C2_CB5A;
}
