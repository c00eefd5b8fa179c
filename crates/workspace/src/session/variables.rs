//! The variables that there are to see where a run stands: those of the block that runs, between two scans those that the program keeps.

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Section;
use sieben_model::types::DataType;
use sieben_sim::names::{Name, Shown, catalogue, variables_of};

use super::Session;

/// Values of one variable of a block that are shown at most.
const LOCALS_MAX: usize = 32;

/// A variable with its value.
#[derive(Clone, Debug)]
pub struct LocalValue {
    /// What it is declared as.
    pub section: Section,
    /// `#level`, `#list[2]`; between two scans as it is called from anywhere: `cars`, `DB5.level`.
    pub name: Name,
    /// The word of its type.
    pub type_word: String,
    /// `None` if it lies nowhere: a parameter in the peripheral.
    pub value: Option<Shown>,
}

/// Variables that belong together.
#[derive(Clone, Debug)]
pub struct Variables {
    /// What they belong to: the block that runs, or the block whose instance the data block is.
    pub block: BlockId,
    /// Its instance, where no block runs; a shared data block belongs to itself.
    pub data_block: Option<u16>,
    /// In the order of the declaration.
    pub values: Vec<LocalValue>,
}

impl Session {
    /// The variables of the block where the run stands; between two scans those of every instance of the user, of programs and of data blocks
    /// that the sources know by name.
    pub fn locals(&self) -> Vec<Variables> {
        match self.history.next_place() {
            Some(place) => vec![self.of_block(place.block)],
            None => self.kept(),
        }
    }

    /// All variables of data blocks that have a name.
    pub fn fields(&self) -> &[Name] {
        self.fields.get_or_init(|| {
            let names = catalogue(self.symbols(), self.cpu().program());
            names.into_iter().filter(|name| name.data_block().is_some()).map(Name::readable).collect()
        })
    }

    fn of_block(&self, block: BlockId) -> Variables {
        let (machine, registers) = (self.cpu().machine(), self.cpu().registers());
        let value = |(section, name, data_type): (Section, Name, DataType)| LocalValue {
            section,
            value: name.clone().readable().shown_in(machine, registers),
            type_word: match data_type {
                DataType::LongDate | DataType::LongDateAndTime => name.kind().type_word().unwrap_or_default(),
                _ => data_type.to_string(),
            },
            name,
        };
        let values = variables_of(block, self.cpu().program(), LOCALS_MAX).into_iter().map(value).collect();
        Variables { block, data_block: None, values }
    }

    /// What stays from one scan to the next and has a name, by data block: instances before the others.
    fn kept(&self) -> Vec<Variables> {
        let program = self.cpu().program();
        let names = &program.names;
        let is_named = |number: &u16| names.open.contains(number) || names.blocks.values().any(|named| named == number);
        let mut all: Vec<Variables> = Vec::new();
        for name in self.fields() {
            let Some(number) = name.data_block() else { continue };
            let based_on = program.data.get(&number).and_then(|data| data.based_on);
            if !is_named(&number) && based_on.is_none_or(|block| self.build.compiled.is_of_library(block)) {
                continue;
            }
            let block = based_on.unwrap_or(BlockId::new(BlockKind::DataBlock, number));
            let value = LocalValue {
                section: self.section_of(block, name),
                type_word: name.kind().type_word().unwrap_or_default(),
                value: name.read(self.cpu()).ok(),
                name: name.clone(),
            };
            match all.iter_mut().find(|one| one.data_block == Some(number)) {
                Some(known) => known.values.push(value),
                None => all.push(Variables { block, data_block: Some(number), values: vec![value] }),
            }
        }
        all.sort_by_key(|one| one.block.kind == BlockKind::DataBlock);
        all
    }

    /// What a field of an instance is declared as in its block.
    fn section_of(&self, block: BlockId, name: &Name) -> Section {
        let code = self.cpu().program().code.get(&block);
        let variables = code.map_or(&[][..], |code| &code.interface.variables);
        let words = || name.text().split(['.', '[']).map(|word| word.trim_matches('"'));
        let declared = variables.iter().find(|variable| words().take(2).any(|word| variable.name.eq_ignore_ascii_case(word)));
        declared.map_or(Section::Static, |variable| variable.section)
    }

    /// What people call what variables belong to: `Lane`, `FB 5, DB 20`.
    pub fn owner(&self, of: &Variables) -> String {
        let block = self.listing.called(of.block);
        let names = &self.cpu().program().names;
        match of.data_block {
            Some(number) if of.block.number != number || of.block.kind != BlockKind::DataBlock => {
                // An instance that the compiler made has a number that nothing in the source says.
                if names.open.contains(&number) { block } else { format!("{block}, DB {number}") }
            }
            _ => block,
        }
    }
}
