//! What changes when a running program is replaced by another one, and what of its data cannot be kept: told before it happens.

use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

use sieben_engine::{CodeBlock, Program};
use sieben_model::block::BlockId;
use sieben_model::interface::{Interface, Variable};
use sieben_model::program::DataBlock;
use sieben_model::types::{DataType, Field, Structure};

/// The difference of two programs, as it matters to a CPU that runs the first and is to run the second.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OnlineChange {
    /// Blocks that are added, changed or removed, by kind and number.
    pub blocks: Vec<(BlockId, BlockChange)>,
    /// Values that cannot be kept, by data block, in the order of the declaration.
    pub losses: Vec<Loss>,
    /// Data blocks that keep their values although the sources give other initial values: those come with a memory reset or a cold restart.
    pub initial_values: Vec<u16>,
    /// The variables of them, as far as the sources name them: `DB1.motor.speed`.
    pub initial_names: Vec<String>,
    /// Data blocks that have the values of the second program, or go with it, because that was asked for: nothing of them is a loss.
    pub new_values: Vec<u16>,
    /// How the values of each data block with another declaration come over.
    moves: Vec<(u16, Vec<Move>)>,
}

/// What happens to a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockChange {
    /// The first program does not have it.
    Added,
    /// Code or declaration differ.
    Changed,
    /// The second program does not have it.
    Removed,
}

impl BlockChange {
    /// `added`, `changed` or `removed`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Added => "added",
            Self::Changed => "changed",
            Self::Removed => "removed",
        }
    }
}

/// A value that cannot be kept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loss {
    /// The data block, 1 to 65535.
    pub data_block: u16,
    /// The variable, such as `motor.speed` or `list[*].name`; `None` = the whole block.
    pub name: Option<String>,
    /// Its type in the first program.
    pub old_type: String,
    /// Its type in the second program; `None` if it is not there.
    pub new_type: Option<String>,
    /// Why.
    pub reason: LossReason,
}

/// Why a value cannot be kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LossReason {
    /// Nothing has this name any more.
    Removed,
    /// What has this name has another type.
    TypeChanged,
    /// The array has fewer elements.
    ArrayShrinks,
    /// The data block has no values of its own any more: it is READ_ONLY or UNLINKED.
    NotWritable,
    /// The program made it at run time, and now its number belongs to a block of the sources.
    NumberTaken,
}

impl LossReason {
    /// As the end of a sentence.
    pub fn text(self) -> &'static str {
        match self {
            Self::Removed => "it is not in the new sources",
            Self::TypeChanged => "its type changes, so it begins with its initial value",
            Self::ArrayShrinks => "the array has fewer elements",
            Self::NotWritable => "the block becomes READ_ONLY or UNLINKED",
            Self::NumberTaken => "the program made it at run time, and a block of the new sources has this number",
        }
    }
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "DB{}", self.data_block)?;
        if let Some(name) = &self.name {
            write!(f, ".{name}")?;
        }
        write!(f, " ({}", self.old_type)?;
        if let Some(new) = self.new_type.as_ref().filter(|new| **new != self.old_type) {
            write!(f, " → {new}")?;
        }
        write!(f, "): {}", self.reason.text())
    }
}

/// Bits of a data block that come to another place in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Move {
    from: u64,
    to: u64,
    bits: u64,
}

impl OnlineChange {
    /// Compares two programs. `created` are data blocks that the first one has made at run time.
    pub fn between(old: &Program, new: &Program, created: &[u16]) -> Self {
        Self::between_taking(old, new, created, &BTreeSet::new())
    }

    /// The same where some data blocks are to have the values of the second program, as after a download, and keep none.
    pub fn between_taking(old: &Program, new: &Program, created: &[u16], new_values: &BTreeSet<u16>) -> Self {
        let mut change = Self::default();
        let ids: BTreeSet<BlockId> = old.code.keys().chain(new.code.keys()).copied().collect();
        for id in ids {
            let what = match (old.code.get(&id), new.code.get(&id)) {
                (None, _) => BlockChange::Added,
                (_, None) => BlockChange::Removed,
                (Some(old), Some(new)) if same_code(old, new) => continue,
                _ => BlockChange::Changed,
            };
            change.blocks.push((id, what));
        }
        let numbers: BTreeSet<u16> = old.data.keys().chain(new.data.keys()).copied().collect();
        for number in numbers {
            let created = created.contains(&number);
            match new_values.contains(&number) {
                true => change.taken(number, old.data.get(&number), new.data.get(&number)),
                false => change.data_block(number, old.data.get(&number), new.data.get(&number), created),
            }
        }
        change
    }

    /// Whether both programs are the same.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty() && self.initial_values.is_empty() && self.new_values.is_empty()
    }

    /// A data block that keeps no value because that was asked for.
    fn taken(&mut self, number: u16, old: Option<&DataBlock>, new: Option<&DataBlock>) {
        let what = match (old, new) {
            (None, Some(_)) => Some(BlockChange::Added),
            (Some(_), None) => Some(BlockChange::Removed),
            (Some(old), Some(new)) => (is_declared_otherwise(old, new) || old.image != new.image).then_some(BlockChange::Changed),
            (None, None) => None,
        };
        self.blocks.extend(what.map(|what| (BlockId::db(number), what)));
        self.new_values.push(number);
    }

    fn data_block(&mut self, number: u16, old: Option<&DataBlock>, new: Option<&DataBlock>, created: bool) {
        let id = BlockId::db(number);
        match (old, new) {
            (None, Some(_)) => {
                self.blocks.push((id, BlockChange::Added));
                if created {
                    self.lose_block(number, LossReason::NumberTaken);
                }
            }
            (Some(old), None) => {
                self.blocks.push((id, BlockChange::Removed));
                if has_values(old) {
                    self.lose_block(number, LossReason::Removed);
                }
            }
            (Some(old), Some(new)) => self.both(number, old, new),
            (None, None) => {}
        }
    }

    fn both(&mut self, number: u16, old: &DataBlock, new: &DataBlock) {
        let same_layout = is_same_layout(old, new);
        let other_values = old.image != new.image && !has_values(new);
        if is_declared_otherwise(old, new) || other_values {
            self.blocks.push((BlockId::db(number), BlockChange::Changed));
        }
        if !has_values(old) {
            return;
        }
        if !has_values(new) {
            self.lose_block(number, LossReason::NotWritable);
            return;
        }
        let mut matching = Matching { data_block: number, moves: Vec::new(), losses: Vec::new(), silent: false };
        if same_layout {
            matching.moves.push(Move { from: 0, to: 0, bits: 8 * old.image.len() as u64 });
        } else {
            matching.structure("", (&old.structure, 0), (&new.structure, 0));
        }
        // Values that come over and are not the ones that the new sources give.
        let stays = |one: &&Move| !same_bits((&old.image, one.from), (&new.image, one.to), one.bits);
        let mut stay: Vec<Move> = matching.moves.iter().filter(stays).copied().collect();
        if !stay.is_empty() {
            stay.sort_by_key(|one| one.to);
            let before = self.initial_names.len();
            named(&mut self.initial_names, &format!("DB{number}"), &new.structure, 0, &|at, bits| {
                let Some(one) = stay[..stay.partition_point(|one| one.to <= at)].last() else { return false };
                at + bits <= one.to + one.bits && !same_bits((&old.image, one.from + (at - one.to)), (&new.image, at), bits)
            });
            if self.initial_names.len() == before {
                self.initial_names.push(format!("DB{number}"));
            }
            self.initial_values.push(number);
        }
        self.losses.append(&mut matching.losses);
        self.moves.push((number, matching.moves));
    }

    fn lose_block(&mut self, data_block: u16, reason: LossReason) {
        self.losses.push(Loss { data_block, name: None, old_type: "the whole block".to_owned(), new_type: None, reason });
    }

    /// Puts the values of a data block that are kept over those of the second program.
    pub(crate) fn carry_over(&self, number: u16, old: &[u8], new: &mut [u8]) {
        let Ok(index) = self.moves.binary_search_by_key(&number, |(number, _)| *number) else { return };
        for Move { from, to, bits } in &self.moves[index].1 {
            copy_bits(old, *from, new, *to, *bits);
        }
    }
}

/// Whether two blocks hold the same bits; those outside of a block are 0.
fn same_bits((old, from): (&[u8], u64), (new, to): (&[u8], u64), bits: u64) -> bool {
    if [from, to, bits].iter().all(|bits| bits.is_multiple_of(8)) {
        let part = |image: &[u8], at: u64| -> Vec<u8> {
            let image = image.get((at / 8) as usize..).unwrap_or(&[]);
            image.iter().copied().chain(std::iter::repeat(0)).take((bits / 8) as usize).collect()
        };
        return part(old, from) == part(new, to);
    }
    let bit = |image: &[u8], at: u64| image.get((at / 8) as usize).copied().unwrap_or(0) >> (at % 8) & 1;
    (0..bits).all(|index| bit(old, from + index) == bit(new, to + index))
}

/// Names the variables of a structure, which begins at a bit, of which `differs` is true; an array as a whole.
fn named(names: &mut Vec<String>, path: &str, structure: &Arc<Structure>, begin: u64, differs: &dyn Fn(u64, u64) -> bool) {
    for field in structure.fields.iter().filter(|field| field.data_type.bits() > 0) {
        let (name, at) = (format!("{path}.{}", field.name), begin + u64::from(field.offset));
        match (&field.data_type, fields_of(&field.data_type)) {
            (_, Some(inner)) => named(names, &name, inner, at, differs),
            (DataType::Array { bounds, element }, _) if element.bits() > 0 => {
                let count = bounds.iter().map(|&(low, high)| u64::from(high.abs_diff(low)) + 1).fold(1, u64::saturating_mul);
                let mut elements = (0..count).map(|index| at + field.data_type.element_offset(index));
                if elements.any(|at| differs(at, element.bits())) {
                    names.push(name);
                }
            }
            (data_type, _) if differs(at, data_type.bits()) => names.push(name),
            _ => {}
        }
    }
}

/// Copies bits that lie inside both blocks; what does not is left out.
fn copy_bits(old: &[u8], from: u64, new: &mut [u8], to: u64, bits: u64) {
    if [from, to, bits].iter().all(|bits| bits.is_multiple_of(8)) {
        let (from, to, bytes) = ((from / 8) as usize, (to / 8) as usize, (bits / 8) as usize);
        let source = old.get(from..).unwrap_or(&[]);
        let target = new.get_mut(to..).unwrap_or(&mut []);
        let bytes = bytes.min(source.len()).min(target.len());
        target[..bytes].copy_from_slice(&source[..bytes]);
        return;
    }
    for bit in 0..bits {
        let (from, to) = (from + bit, to + bit);
        let (Some(source), Some(target)) = (old.get((from / 8) as usize), new.get_mut((to / 8) as usize)) else { return };
        *target = *target & !(1 << (to % 8)) | (source >> (from % 8) & 1) << (to % 8);
    }
}

fn is_same_layout(old: &DataBlock, new: &DataBlock) -> bool {
    old.image.len() == new.image.len() && same_structure(&old.structure, &new.structure)
}

fn is_declared_otherwise(old: &DataBlock, new: &DataBlock) -> bool {
    let attributes = |block: &DataBlock| (block.read_only, block.non_retain, block.unlinked);
    !is_same_layout(old, new) || attributes(old) != attributes(new)
}

/// Whether a data block has values that the program writes.
fn has_values(block: &DataBlock) -> bool {
    !block.unlinked && !block.read_only
}

fn same_code(old: &CodeBlock, new: &CodeBlock) -> bool {
    old.local_size == new.local_size && old.code == new.code && same_variables(&old.interface, &new.interface)
}

/// Whether two blocks declare the same variables, without regard to initial values and comments.
fn same_variables(old: &Interface, new: &Interface) -> bool {
    let same = |(old, new): (&Variable, &Variable)| {
        (old.section, old.offset) == (new.section, new.offset)
            && old.name.eq_ignore_ascii_case(&new.name)
            && same_type(&old.data_type, &new.data_type)
    };
    old.variables.len() == new.variables.len() && old.variables.iter().zip(&new.variables).all(same)
}

/// Whether two structures have the same names, types and places; initial values and comments do not count.
fn same_structure(old: &Arc<Structure>, new: &Arc<Structure>) -> bool {
    if Arc::ptr_eq(old, new) || old.size == 0 && new.size == 0 {
        return true;
    }
    let same = |(old, new): (&Field, &Field)| {
        old.offset == new.offset && old.name.eq_ignore_ascii_case(&new.name) && same_type(&old.data_type, &new.data_type)
    };
    old.size == new.size && old.fields.len() == new.fields.len() && old.fields.iter().zip(&new.fields).all(same)
}

fn same_type(old: &DataType, new: &DataType) -> bool {
    match (old, new) {
        (DataType::Struct(old), DataType::Struct(new)) => same_structure(old, new),
        (DataType::Instance { block: old_block, structure: old }, DataType::Instance { block, structure: new }) => {
            old_block == block && same_structure(old, new)
        }
        (DataType::Array { bounds: old_bounds, element: old }, DataType::Array { bounds, element: new }) => {
            old_bounds == bounds && same_type(old, new)
        }
        _ => old == new,
    }
}

/// The structure of a type that has fields.
fn fields_of(data_type: &DataType) -> Option<&Arc<Structure>> {
    match data_type {
        DataType::Struct(structure) | DataType::Instance { structure, .. } => Some(structure),
        _ => None,
    }
}

/// Finds for each variable of a data block the one with its name and type.
struct Matching {
    data_block: u16,
    moves: Vec<Move>,
    losses: Vec<Loss>,
    /// What is lost has been told for another element of the same array.
    silent: bool,
}

impl Matching {
    /// Fields with the same names in two structures, which begin at these bits.
    fn structure(&mut self, path: &str, (old, from): (&Arc<Structure>, u64), (new, to): (&Arc<Structure>, u64)) {
        if same_structure(old, new) {
            self.moves.push(Move { from, to, bits: 8 * u64::from(old.size) });
            return;
        }
        for field in old.fields.iter().filter(|field| field.data_type.bits() > 0) {
            let name = if path.is_empty() { field.name.clone() } else { format!("{path}.{}", field.name) };
            let from = from + u64::from(field.offset);
            match new.field(&field.name) {
                Some(other) => self.variable(&name, (&field.data_type, from), (&other.data_type, to + u64::from(other.offset))),
                None => self.lose(&name, &field.data_type, None, LossReason::Removed),
            }
        }
    }

    /// A variable and the one of the same name, which begin at these bits.
    fn variable(&mut self, name: &str, (old, from): (&DataType, u64), (new, to): (&DataType, u64)) {
        if let (Some(old), Some(new)) = (fields_of(old), fields_of(new)) {
            self.structure(name, (old, from), (new, to));
        } else if same_type(old, new) {
            self.moves.push(Move { from, to, bits: old.bits() });
        } else if let (DataType::Array { bounds: old_bounds, .. }, DataType::Array { bounds: new_bounds, .. }) = (old, new)
            && old_bounds.len() == new_bounds.len()
        {
            self.array(name, (old, from), (new, to));
        } else {
            self.lose(name, old, Some(new), LossReason::TypeChanged);
        }
    }

    /// The elements with the same indexes of two arrays of as many dimensions.
    fn array(&mut self, name: &str, (old, from): (&DataType, u64), (new, to): (&DataType, u64)) {
        let (DataType::Array { bounds: old_bounds, element: old_element }, DataType::Array { bounds: new_bounds, element: new_element }) =
            (old, new)
        else {
            return;
        };
        if old_element.bits() == 0 || new_element.bits() == 0 {
            return;
        }
        let common: Vec<(i64, i64)> =
            old_bounds.iter().zip(new_bounds).map(|(a, b)| (i64::from(a.0.max(b.0)), i64::from(a.1.min(b.1)))).collect();
        if common.iter().zip(old_bounds).any(|(common, &(low, high))| *common != (i64::from(low), i64::from(high))) {
            self.lose(name, old, Some(new), LossReason::ArrayShrinks);
        }
        if common.iter().any(|(low, high)| low > high) {
            return;
        }
        let silent = self.silent;
        let element = format!("{name}[*]");
        let mut indexes: Vec<i64> = common.iter().map(|&(low, _)| low).collect();
        loop {
            if let (Some(a), Some(b)) = (old.element_number(&indexes), new.element_number(&indexes)) {
                let (from, to) = (from + old.element_offset(a), to + new.element_offset(b));
                self.variable(&element, (old_element, from), (new_element, to));
            }
            self.silent = true;
            // The last index runs fastest.
            let Some(next) = (0..indexes.len()).rev().find(|&dimension| indexes[dimension] < common[dimension].1) else { break };
            indexes[next] += 1;
            for (index, &(low, _)) in indexes.iter_mut().zip(&common).skip(next + 1) {
                *index = low;
            }
        }
        self.silent = silent;
    }

    fn lose(&mut self, name: &str, old: &DataType, new: Option<&DataType>, reason: LossReason) {
        if !self.silent {
            let (old_type, new_type) = (old.to_string(), new.map(ToString::to_string));
            self.losses.push(Loss { data_block: self.data_block, name: Some(name.to_owned()), old_type, new_type, reason });
        }
    }
}
