//! What of a program can be read and written from outside, and where: symbols, fields of data blocks, timers and counters.

use std::collections::HashSet;

use sieben_lang::Compiled;
use sieben_model::address::{Area, Operand, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::symbols::{Symbol, SymbolTable};
use sieben_model::types::{DataType, Structure};

/// Whether an array is one tag or one for each element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrays {
    /// An array of numbers in one dimension is one tag, as clients read it in one request.
    Whole,
    /// Every element is a tag.
    Elements,
}

/// Where a tag lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// In an area of the CPU, at a byte and a bit.
    Area(Area),
    /// In a data block with this number, at a byte and a bit.
    DataBlock(u16),
    /// A timer; its number stands for the byte.
    Timer,
    /// A counter; its number stands for the byte.
    Counter,
}

/// A value that a client can ask for.
#[derive(Clone, Debug, PartialEq)]
pub struct Tag {
    /// As the program calls it: `Motor_on`, `Recipe.step[2].time`, `DB1.speed`.
    pub name: String,
    /// Where it lies.
    pub place: Place,
    /// The first byte, or the number of a timer or counter.
    pub byte: u32,
    /// The bit in the byte; 0 for what is no bit.
    pub bit: u8,
    /// The type of an element.
    pub data_type: DataType,
    /// How many elements there are.
    pub count: u32,
    /// What its declaration or the symbol table says about it.
    pub comment: String,
}

impl Tag {
    /// Bytes that it takes, from the first that has a part of it to the last.
    pub fn bytes(&self) -> u32 {
        let bits = match self.place {
            Place::Timer | Place::Counter => 16,
            _ => self.data_type.bits().min(u64::from(u32::MAX)),
        };
        let all = bits.saturating_mul(u64::from(self.count)).saturating_add(u64::from(self.bit));
        u32::try_from(all.div_ceil(8)).unwrap_or(u32::MAX)
    }
}

/// All tags: symbols in the order of their table, located variables, then data blocks by number with their fields in order.
pub fn tags(compiled: &Compiled, symbols: &SymbolTable, arrays: Arrays) -> Vec<Tag> {
    let mut tags: Vec<Tag> = symbols.symbols().iter().filter_map(of_symbol).collect();
    let located = &compiled.program.names.located;
    for (name, variable @ (operand, data_type)) in located {
        // A variable may be called with its list or without; as a symbol it has its comment there.
        let alone = name.rsplit_once('.').is_some_and(|(_, last)| located.get(last) == Some(variable));
        if !alone && symbols.find(name).is_none() {
            tags.extend(at(name, operand, Some(data_type), ""));
        }
    }
    for (number, block) in &compiled.program.data {
        // What stays in load memory cannot be reached.
        if block.unlinked {
            continue;
        }
        let open = compiled.program.names.open.contains(number);
        let id = BlockId::new(BlockKind::DataBlock, *number);
        let named = symbols.find_operand(&Operand::Block(id)).map(|symbol| &symbol.name).or_else(|| compiled.block_names.get(&id));
        let prefix = if open { String::new() } else { named.map_or_else(|| format!("DB{number}"), Clone::clone) };
        Walk { tags: &mut tags, db: *number, arrays }.structure(&block.structure, &prefix, 0);
    }
    name_apart(&mut tags);
    tags
}

/// Calls by their data block what would have the name of an earlier tag, without regard to case: a client keeps one of each name.
fn name_apart(tags: &mut [Tag]) {
    let mut names = HashSet::new();
    for tag in tags {
        if !names.insert(tag.name.to_lowercase())
            && let Place::DataBlock(db) = tag.place
        {
            tag.name = format!("DB{db}.{}", tag.name);
            names.insert(tag.name.to_lowercase());
        }
    }
}

/// The tag of a symbol; none if it names a block or has no address.
fn of_symbol(symbol: &Symbol) -> Option<Tag> {
    let data_type = DataType::from_any_word(symbol.data_type.trim());
    at(&symbol.name, &symbol.operand()?, data_type.as_ref(), symbol.comment.trim())
}

/// What lies at an address, with its type if it has one of the same width.
fn at(name: &str, operand: &Operand, data_type: Option<&DataType>, comment: &str) -> Option<Tag> {
    let tag =
        |place, byte, bit, data_type| Tag { name: name.to_owned(), place, byte, bit, data_type, count: 1, comment: comment.to_owned() };
    let (place, address) = match operand {
        Operand::Timer(number) => return Some(tag(Place::Timer, u32::from(*number), 0, DataType::Timer)),
        Operand::Counter(number) => return Some(tag(Place::Counter, u32::from(*number), 0, DataType::Counter)),
        Operand::Block(_) => return None,
        Operand::InDataBlock { db, address } => (Place::DataBlock(*db), address),
        Operand::Address(address) => (Place::Area(address.area), address),
    };
    let plain = match address.width {
        Width::Bit => DataType::Bool,
        Width::Byte => DataType::Byte,
        Width::Word => DataType::Word,
        Width::DoubleWord => DataType::DoubleWord,
        Width::QuadWord => DataType::LongWord,
    };
    let data_type = data_type.filter(|data_type| Width::of_bits(data_type.bits()) == Some(address.width)).cloned().unwrap_or(plain);
    Some(tag(place, address.byte, address.bit, data_type))
}

/// The way through the fields of a data block.
struct Walk<'a> {
    tags: &'a mut Vec<Tag>,
    db: u16,
    arrays: Arrays,
}

impl Walk<'_> {
    fn structure(&mut self, structure: &Structure, prefix: &str, offset: u64) {
        for field in &structure.fields {
            let name = if prefix.is_empty() { field.name.clone() } else { format!("{prefix}.{}", field.name) };
            self.value(&field.data_type, &name, offset.saturating_add(u64::from(field.offset)), &field.comment);
        }
    }

    fn value(&mut self, data_type: &DataType, name: &str, offset: u64, comment: &str) {
        match data_type.base() {
            DataType::Struct(structure) | DataType::Instance { structure, .. } => self.structure(structure, name, offset),
            DataType::Array { bounds, element } => {
                let one_dimension = bounds.len() == 1 && !element.stands_in_bytes();
                if one_dimension && self.arrays == Arrays::Whole {
                    return self.push(element, name, offset, data_type.elements(), comment);
                }
                for number in 0..data_type.elements() {
                    let name = format!("{name}[{}]", indexes(bounds, number));
                    self.value(element, &name, offset.saturating_add(data_type.element_offset(number)), comment);
                }
            }
            DataType::Void => {}
            _ => self.push(data_type, name, offset, 1, comment),
        }
    }

    fn push(&mut self, data_type: &DataType, name: &str, offset: u64, count: u64, comment: &str) {
        let (Ok(byte), Ok(count)) = (u32::try_from(offset / 8), u32::try_from(count)) else { return };
        if count > 0 {
            let (bit, data_type) = ((offset % 8) as u8, data_type.clone());
            let comment = comment.trim().to_owned();
            self.tags.push(Tag { name: name.to_owned(), place: Place::DataBlock(self.db), byte, bit, data_type, count, comment });
        }
    }
}

/// The indexes of an element by its number, the last one fastest: `1, 3`.
fn indexes(bounds: &[(i32, i32)], number: u64) -> String {
    let mut rest = number;
    let mut found: Vec<String> = Vec::with_capacity(bounds.len());
    for &(low, high) in bounds.iter().rev() {
        let length = u64::try_from(i64::from(high) - i64::from(low) + 1).unwrap_or(1).max(1);
        found.push((i64::from(low) + (rest % length) as i64).to_string());
        rest /= length;
    }
    found.reverse();
    found.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_are_called_by_all_their_indexes() {
        let called: Vec<String> = (0..6).map(|number| indexes(&[(1, 2), (-1, 1)], number)).collect();
        assert_eq!(called, ["1,-1", "1,0", "1,1", "2,-1", "2,0", "2,1"]);
    }

    #[test]
    fn a_type_of_another_width_than_the_address_does_not_count() {
        let tag = |address: &str, data_type: &str| {
            let symbol = Symbol { name: "a".into(), address: address.into(), data_type: data_type.into(), ..Symbol::default() };
            of_symbol(&symbol).map(|tag| (tag.data_type.to_string(), tag.bytes()))
        };
        assert_eq!(tag("MW 10", "INT"), Some(("INT".to_owned(), 2)));
        assert_eq!(tag("MW 10", "REAL"), Some(("WORD".to_owned(), 2)));
        assert_eq!(tag("M 1.7", ""), Some(("BOOL".to_owned(), 1)));
        assert_eq!(tag("FC 1", "FC 1"), None);
    }
}
