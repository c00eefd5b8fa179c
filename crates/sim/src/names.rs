//! Names of what can be watched and set from outside: addresses, timers, counters, registers, symbols, fields of data blocks.
//!
//! `exec`, scenarios and recordings speak of the same things in the same words. A name becomes an item here, once.

mod assignments;
mod catalogue;
mod local;
mod parsing;
mod reading;
mod setting;

use std::fmt;
use std::ops::Range;

pub use assignments::assignments;
pub use catalogue::catalogue;
pub use local::{Scope, variables_of};
use parsing::{absolute, named, symbolic};
pub use reading::{Displayed, Sample, TEXT_BYTES_MAX};
pub use setting::Setting;
use sieben_cpu::items::Spot;
use sieben_cpu::{AccessError, Cpu, Moment};
use sieben_engine::machine::Registers;
use sieben_engine::{Machine, Program, Stored};
use sieben_model::address::{Address, Area, Operand};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::format::{Format, FormatError};
use sieben_model::item::{Item, Local, Place, Start};
use sieben_model::symbols::SymbolTable;
use sieben_model::types::DataType;
use sieben_model::value::{Content, Value};
pub use sieben_model::value::{Kind, Shown};

/// Why a name or a value is of no use, in one sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NameError {
    message: String,
    /// What is wrong with the format that is asked for, if that is it.
    format: Option<FormatError>,
    /// A constant was to be set.
    is_of_constant: bool,
}

impl NameError {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), format: None, is_of_constant: false }
    }

    fn of_format(name: &str, error: FormatError) -> Self {
        Self { message: error.of(name), format: Some(error), is_of_constant: false }
    }

    /// Whether it says that a constant cannot be set.
    pub fn is_of_constant(&self) -> bool {
        self.is_of_constant
    }

    /// What is wrong with the format that is asked for; `None` if the name is wrong.
    pub fn format(&self) -> Option<&FormatError> {
        self.format.as_ref()
    }
}

impl fmt::Display for NameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for NameError {}

/// An item, as a user calls it.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// As the user wrote it.
    text: String,
    item: Item,
}

impl Name {
    /// What lies at an address, called as the user likes; with its type, if it has one that says more than its width.
    pub fn at(text: impl Into<String>, operand: Operand, data_type: Option<&DataType>) -> Self {
        Self { text: text.into(), item: Item::typed(operand, data_type) }
    }

    /// Reads a name: `I 0.0`, `MW10`, `DB1.DBD4`, `DB1.speed`, `"Motor on"`, `T 1`, `T1.q`, `C 1`, `ACCU1`, `AR1`, `STW`, `STW.RLO`, `RLO`,
    /// `P#DB1.DBX 0.0 BYTE 20`; addresses in either mnemonic language, spaces optional, letters in either case. A format can follow: `MD20:REAL`.
    ///
    /// # Errors
    /// Nothing is called that.
    pub fn parse(text: &str, symbols: &SymbolTable, program: &Program) -> Result<Self, NameError> {
        Self::parse_in(text, None, symbols, program)
    }

    /// Reads a name where a block's variables can be meant too: `#level`, `#list[2].name`; `FC 1.#level` means the block's from anywhere.
    ///
    /// # Errors
    /// Nothing is called that.
    pub fn parse_in(text: &str, scope: Option<Scope>, symbols: &SymbolTable, program: &Program) -> Result<Self, NameError> {
        let text = text.trim();
        // A symbol may have a colon in its name.
        let with_format = Format::split(text).filter(|_| symbols.find(text).is_none());
        let Some((name, word)) = with_format else {
            return item(text, scope, symbols, program).map(|item| Self { text: text.to_owned(), item });
        };
        let found = item(name, scope, symbols, program)?;
        let format = Format::from_name(word).ok_or_else(|| FormatError::Unknown(word.to_owned()));
        let formatted = format.and_then(|format| found.in_format(format));
        formatted.map(|item| Self { text: text.to_owned(), item }).map_err(|error| NameError::of_format(name, error))
    }

    /// The name with a value as people read it: a timer with the time that it has left.
    #[must_use]
    pub fn readable(self) -> Self {
        Self { item: self.item.readable(), ..self }
    }

    /// The name as the user wrote it.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What it means.
    pub fn item(&self) -> &Item {
        &self.item
    }

    /// What its value is.
    pub fn kind(&self) -> &Kind {
        &self.item.kind
    }

    /// The name as it can be read again wherever a run stands: a variable of a block with its block.
    pub fn full_text(&self) -> String {
        let Some(block) = self.block() else { return self.text.clone() };
        match self.text.split_once('#') {
            Some((_, path)) => format!("{block}.#{path}"),
            None => format!("{block}.#{}", self.text),
        }
    }

    /// The block whose variable it is.
    pub fn block(&self) -> Option<BlockId> {
        match &self.item.place {
            Place::Local(local) => Some(local.block),
            _ => None,
        }
    }

    /// The address, timer or counter that it means, if it is a single one.
    pub fn operand(&self) -> Option<&Operand> {
        self.item.as_operand()
    }

    /// Whether the name means a timer, which changes by itself.
    pub fn is_timer(&self) -> bool {
        matches!(self.item.place, Place::Operand(Operand::Timer(_)) | Place::TimerStatus(_))
    }

    /// Whether the name means a register.
    pub fn is_register(&self) -> bool {
        matches!(self.item.place, Place::Register(_) | Place::Status)
    }

    /// What it holds in a CPU. Registers are those after the last statement of OB 1.
    ///
    /// # Errors
    /// The CPU has nothing of that name.
    pub fn content(&self, cpu: &Cpu) -> Result<Content, NameError> {
        cpu.content(&self.item).map_err(|error| self.refused("read", error, cpu.cpu_type()))
    }

    /// The value in a CPU, ready to be shown.
    ///
    /// # Errors
    /// The CPU has nothing of that name.
    pub fn read(&self, cpu: &Cpu) -> Result<Shown, NameError> {
        self.content(cpu).map(|content| self.kind().show(&content))
    }

    /// Reads a value for it.
    ///
    /// # Errors
    /// The text is no constant, or does not fit.
    pub fn value(&self, text: &str) -> Result<Value, NameError> {
        self.item.value(text).map_err(|error| NameError::new(error.of(&self.text)))
    }

    /// Reads a value that is expected of it: `NaN` stands for every REAL that is no number.
    ///
    /// # Errors
    /// The text is no constant, or does not fit.
    pub fn expected(&self, text: &str) -> Result<Value, NameError> {
        self.item.expected(text).map_err(|error| NameError::new(error.of(&self.text)))
    }

    /// Sets it: an input in its module, a register for the beginning of OB 1 in the next scan, anything else in place.
    ///
    /// # Errors
    /// The CPU has nothing of that name that could be set.
    pub fn set(&self, cpu: &mut Cpu, value: &Value) -> Result<(), NameError> {
        cpu.set(&self.item, &value.content).map_err(|error| self.refused("set", error, cpu.cpu_type()))
    }

    /// As [`Self::set`], with a value as a user writes it.
    ///
    /// # Errors
    /// The value is none, does not fit, or the CPU has nothing of that name that could be set.
    pub fn write(&self, cpu: &mut Cpu, value: &str) -> Result<(), NameError> {
        let value = self.value(value)?;
        self.set(cpu, &value)
    }

    /// Sets the value of an input in its module at a time to come, anything else now.
    ///
    /// # Errors
    /// As of [`Self::set`].
    pub fn set_at(&self, cpu: &mut Cpu, value: &Value, at_us: u64) -> Result<(), NameError> {
        match (&self.item.place, &value.content) {
            (
                Place::Operand(operand @ Operand::Address(Address { area: Area::Input | Area::PeripheralInput, .. })),
                Content::Bits(bits),
            ) => cpu.modify_input_at(at_us, operand, *bits as u32).map_err(|error| self.refused("set", error, cpu.cpu_type())),
            _ => self.set(cpu, value),
        }
    }

    /// Forces it to this value, until [`Self::unforce`].
    ///
    /// # Errors
    /// The CPU type does not force anything of that name.
    pub fn force(&self, cpu: &mut Cpu, value: &Value) -> Result<(), NameError> {
        let bits = value.content.bits().unwrap_or_default();
        let forced = self.operand().ok_or(AccessError::NotForced).and_then(|operand| cpu.force(operand, bits as u32));
        forced.map_err(|error| match error {
            AccessError::NotForced if self.operand().is_none() => self.not_forced(error),
            error => NameError::new(format!("cannot force `{}`: {error}", self.text)),
        })
    }

    /// Ends its forcing.
    ///
    /// # Errors
    /// It is not forced, or the CPU type does not force anything of that name.
    pub fn unforce(&self, cpu: &mut Cpu) -> Result<(), NameError> {
        match self.operand().ok_or(AccessError::NotForced).and_then(|operand| cpu.unforce(operand)) {
            Ok(true) => Ok(()),
            Ok(false) => Err(NameError::new(format!("`{}` is not forced", self.text))),
            Err(error) => Err(self.not_forced(error)),
        }
    }

    fn not_forced(&self, error: AccessError) -> NameError {
        NameError::new(format!("`{}` cannot be forced: {error}", self.text))
    }

    /// Whether the value in a CPU is this one. `NaN` stands for every REAL that is no number.
    ///
    /// # Errors
    /// The expected value is none or does not fit, or the CPU has nothing of that name.
    pub fn holds(&self, cpu: &Cpu, expected: &str) -> Result<bool, NameError> {
        if matches!(self.kind().plain(), Kind::Typed(_)) && self.operand().is_none() && self.kind().is_recorded_as_text() {
            return Ok(self.read(cpu)?.to_string() == expected);
        }
        let is_nan = expected.eq_ignore_ascii_case("NaN") && self.item.width() == 32;
        let expected = self.expected(expected)?;
        let actual = self.content(cpu)?;
        match actual {
            Content::Bits(bits) if is_nan => Ok(f32::from_bits(bits as u32).is_nan()),
            actual => Ok(actual == expected.content),
        }
    }

    /// The bits of the value in a machine whose registers are these, between any two statements; `None` if it has none there: a data block
    /// that is not loaded, or a value of more than 64 bits. A peripheral input has the value of the process image, an output likewise.
    pub fn bits_in(&self, machine: &Machine, registers: &Registers) -> Option<u64> {
        Moment { machine, registers }.bits(&self.item)
    }

    /// The value in a machine whose registers are these, ready to be shown; `None` if it has none there.
    pub fn shown_in(&self, machine: &Machine, registers: &Registers) -> Option<Shown> {
        Moment { machine, registers }.content(&self.item).map(|content| self.kind().show(&content))
    }

    /// How bits of a value that [`Self::bits_in`] gave are written.
    pub fn show_bits(&self, bits: u64) -> Shown {
        self.kind().show(&Content::Bits(bits))
    }

    /// The bytes of the arena where it lies in a machine whose registers are these, and which bits of them; `None` if it lies elsewhere.
    pub fn extent(&self, machine: &Machine, registers: &Registers) -> Option<(Range<usize>, u8)> {
        Moment { machine, registers }.extent(&self.item)
    }

    /// Whether what is stored lies where this name does, in a machine whose registers are these. Registers are no place.
    pub fn is_stored(&self, machine: &Machine, registers: &Registers, stored: &Stored) -> bool {
        Moment { machine, registers }.is_stored(&self.item, stored)
    }

    /// What setting it from outside stores, at once: an input only comes with the next process image.
    pub(crate) fn stores(&self, machine: &Machine) -> Option<Stored> {
        Moment { machine, registers: &machine.registers }.stores(&self.item)
    }

    /// The data block that it lies in, wherever a run stands.
    pub fn data_block(&self) -> Option<u16> {
        match &self.item.place {
            Place::Operand(Operand::InDataBlock { db, .. }) => Some(*db),
            Place::Bytes(bytes) => bytes.db,
            _ => None,
        }
    }

    /// A variable of an instance as the address that it has in this data block; everything else as it is.
    ///
    /// # Errors
    /// The data block is not an instance of its block, or not there. Inside another instance a place is known only while the block runs.
    pub fn in_data_block(self, db: u16, program: &Program) -> Result<Self, NameError> {
        let Place::Local(Local { start: Start::Instance(position), data_type, block }) = &self.item.place else { return Ok(self) };
        match program.data.get(&db) {
            Some(data) if data.based_on == Some(*block) => Ok(Self { item: Item::field(db, *position, data_type), text: self.text }),
            _ => {
                let message =
                    format!("`{}` lay in `DB {db}`, which is no instance of `{block}`; name it again where the block runs", self.text);
                Err(NameError::new(message))
            }
        }
    }

    /// A variable of an instance as the address that it has now; everything else as it is.
    ///
    /// # Errors
    /// The block is not the one that runs: which instance is meant is not known.
    pub fn of_this_instance(self, machine: &Machine, registers: &Registers) -> Result<Self, NameError> {
        let Place::Local(local) = &self.item.place else { return Ok(self) };
        if !local.is_in_instance() {
            return Ok(self);
        }
        let here = || {
            let Some(Spot::Arena(at, bit)) = (Moment { machine, registers }).spot(local) else { return None };
            let db = u16::try_from(registers.di_number).ok()?;
            let byte = u32::try_from(at).ok()?.checked_sub(machine.memory.data_block(u64::from(db))?.base)?;
            Some(Item::field(db, byte * 8 + u32::from(bit), &local.data_type))
        };
        match here() {
            Some(item) => Ok(Self { text: self.text, item }),
            None => Err(NameError::new(format!(
                "`{}` lies in an instance, and `{}` is not the block that runs; step into it, or name the data block: `DB1.name`",
                self.text, local.block
            ))),
        }
    }

    /// Why a CPU of this type did not read or set it; the verb says which.
    pub fn refused(&self, verb: &str, error: AccessError, cpu_type: &CpuType) -> NameError {
        let text = &self.text;
        let message = match (&self.item.place, error) {
            (_, AccessError::NotRunning(block)) => format!("`{text}` has no value here: `{block}` is not the block that runs"),
            (_, AccessError::NoRegister) => {
                format!("the CPU {} has no `{text}`, only the accumulators 1 and 2; the S7-400 has four", cpu_type.name)
            }
            (Place::TimerStatus(_), AccessError::Outside) => {
                format!("cannot {verb} `{text}`: the CPU has timers T 0 to T {}", cpu_type.timers.saturating_sub(1))
            }
            (Place::TimerStatus(_), AccessError::ReadOnly) => format!("`{text}` can only be read; set `T n` to an S5TIME instead"),
            (Place::Constant(_), AccessError::ReadOnly) => {
                let message = format!("`{text}` is a constant: the statements have its value in them");
                return NameError { is_of_constant: true, ..NameError::new(message) };
            }
            (Place::Register(_), AccessError::ReadOnly) => format!("`{text}` can only be read; open a data block with `OPN`"),
            (Place::Local(_), AccessError::ReadOnly) => format!("`{text}` is given by the caller and cannot be set"),
            _ => format!("cannot {verb} `{text}`: {error}"),
        };
        NameError::new(message)
    }
}

/// The item that a user means by a name.
fn item(text: &str, scope: Option<Scope>, symbols: &SymbolTable, program: &Program) -> Result<Item, NameError> {
    meant(text, scope, symbols, program).map(|item| in_calendar(item, program))
}

/// A date or a moment of 64 bits as the sources call it: LDATE and LDT are types of their own where DATE and DT have as many bits.
fn in_calendar(item: Item, program: &Program) -> Item {
    match &item.kind {
        Kind::Typed(data_type @ (DataType::LongDate | DataType::LongDateAndTime)) if !program.names.short_dates => {
            Item { kind: Kind::Typed(data_type.clone().of_nanoseconds("L")), ..item }
        }
        _ => item,
    }
}

fn meant(text: &str, scope: Option<Scope>, symbols: &SymbolTable, program: &Program) -> Result<Item, NameError> {
    let local = match parsing::local(text, scope, symbols, program) {
        Ok(local) => local,
        Err(error) => return constant(text, scope, program).ok_or(error),
    };
    if let Some(local) = local {
        single(&local.data_type, text)?;
        return Ok(Item::local(local));
    }
    if let Some(item) = named(text, program)? {
        return Ok(item);
    }
    let item = if text.starts_with('"') { None } else { absolute(text)? };
    match item {
        Some(item) => Ok(item),
        None => symbolic(text, symbols, program).or_else(|error| constant(text, scope, program).ok_or(error)),
    }
}

/// A constant of the source; those of the block that the scope names go before others.
fn constant(text: &str, scope: Option<Scope>, program: &Program) -> Option<Item> {
    let name = text.trim_start_matches('#').to_lowercase();
    let of = |block: Option<BlockId>| program.names.constants.get(&(block, name.clone()));
    let found = scope.and_then(|scope| of(Some(scope.block))).or_else(|| of(None))?;
    Some(Item::constant(&found.data_type, found.content.clone()))
}

/// A type whose values are single ones.
fn single(data_type: &DataType, text: &str) -> Result<(), NameError> {
    let example = match data_type {
        DataType::Array { .. } => "`[1]`",
        DataType::Struct(_) | DataType::Instance { .. } => "`.name`",
        _ => return Ok(()),
    };
    Err(NameError::new(format!("`{text}` is no single value; name one of its elements, such as {example}")))
}
