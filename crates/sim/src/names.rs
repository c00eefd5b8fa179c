//! Names of what can be watched and set from outside: addresses, timers, counters, registers, symbols, fields of data blocks.
//!
//! `exec`, scenarios and recordings speak of the same things in the same words; the words are read here.

mod assignments;
mod local;
mod parsing;
mod reading;

use std::fmt;
use std::ops::Range;

pub use assignments::assignments;
use local::{Local, Spot};
pub use local::{Scope, variables_of};
use parsing::{STATUS_NAMES, absolute, named, symbolic};
pub use reading::{Displayed, Kind, Sample, TEXT_BYTES_MAX};
use sieben_cpu::{Cpu, Station};
use sieben_engine::machine::{Register, Registers, StatusWord};
use sieben_engine::{Machine, Program, Stored};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::bcd;
use sieben_model::block::BlockId;
use sieben_model::literal::{self, Value};
use sieben_model::symbols::SymbolTable;
use sieben_model::types::DataType;

/// Why a name or a value is of no use, in one sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NameError(String);

impl NameError {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self(message.into())
    }
}

impl fmt::Display for NameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for NameError {}

/// Something that has a value in a CPU, as a user calls it.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// As the user wrote it.
    text: String,
    target: Target,
}

#[derive(Clone, Debug, PartialEq)]
enum Target {
    /// An address, timer or counter; with a data type if a symbol or a declaration gives it one.
    Operand(Operand, Option<DataType>),
    /// The status bit of a timer.
    TimerStatus(u16),
    /// Field of a data block that is no single address: DATE_AND_TIME, STRING, POINTER and longer ones.
    Field { db: u16, byte: u32, data_type: DataType },
    /// A variable of a block, while it runs.
    Local(Local),
    /// A register of 32 bits, or one status bit.
    Register(Register),
    /// All nine status bits.
    Status,
}

/// A value, ready to be shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Shown {
    /// A bit.
    Bit(bool),
    /// Bits without a type, shown in hex with so many digits.
    Hex {
        /// The bits, right-justified.
        bits: u64,
        /// 2, 4, 8 or 16.
        digits: usize,
    },
    /// A number: timers, counters, INT and DINT.
    Number(i64),
    /// A REAL.
    Real(f32),
    /// An LREAL.
    LongReal(f64),
    /// The status word.
    Status(StatusWord),
    /// A constant in the notation of its type.
    Text(String),
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bit(bit) => write!(f, "{}", u8::from(*bit)),
            Self::Hex { bits, digits } if *digits > 4 => {
                let hex = format!("{bits:0digits$X}");
                let groups: Vec<&str> = hex.as_bytes().chunks(4).filter_map(|group| std::str::from_utf8(group).ok()).collect();
                write!(f, "16#{}", groups.join("_"))
            }
            Self::Hex { bits, digits } => write!(f, "16#{bits:0digits$X}"),
            Self::Number(number) => write!(f, "{number}"),
            Self::Real(value) => f.write_str(&literal::format_as(&DataType::Real, u64::from(value.to_bits()))),
            Self::LongReal(value) => f.write_str(&literal::format_as(&DataType::LongReal, value.to_bits())),
            Self::Status(word) => write!(f, "{word}"),
            Self::Text(text) => f.write_str(text),
        }
    }
}

impl Name {
    /// What lies at an address, called as the user likes; with its type, if it has one that says more than its width.
    pub fn at(text: impl Into<String>, operand: Operand, data_type: Option<DataType>) -> Self {
        Self { text: text.into(), target: Target::Operand(operand, data_type) }
    }

    /// Reads a name: `I 0.0`, `MW10`, `DB1.DBD4`, `DB1.speed`, `"Motor on"`, `T 1`, `T1.q`, `C 1`, `ACCU1`, `AR1`, `STW`, `STW.RLO`, `RLO`;
    /// addresses in either mnemonic language, blanks optional, letters in either case.
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
        if let Some(local) = parsing::local(text, scope, symbols, program)? {
            if matches!(local.data_type, DataType::Array { .. } | DataType::Struct(_) | DataType::Instance { .. }) {
                let example = if matches!(local.data_type, DataType::Array { .. }) { "`[1]`" } else { "`.name`" };
                return Err(NameError::new(format!("`{text}` is no single value; name one of its elements, such as {example}")));
            }
            return Ok(Self { text: text.to_owned(), target: Target::Local(local) });
        }
        if let Some(target) = named(text, program)? {
            return Ok(Self { text: text.to_owned(), target });
        }
        let target = if text.starts_with('"') { None } else { absolute(text)? };
        let target = match target {
            Some(target) => target,
            None => symbolic(text, symbols, program)?,
        };
        Ok(Self { text: text.to_owned(), target })
    }

    /// The name as the user wrote it.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The name as it can be read again wherever a run stands: a variable of a block with its block.
    pub fn full_text(&self) -> String {
        match &self.target {
            Target::Local(local) => local.full_text(&self.text),
            _ => self.text.clone(),
        }
    }

    /// The block whose variable it is.
    pub fn block(&self) -> Option<BlockId> {
        match &self.target {
            Target::Local(local) => Some(local.block),
            _ => None,
        }
    }

    /// The address, timer or counter that it means, if it is a single one.
    pub fn operand(&self) -> Option<&Operand> {
        match &self.target {
            Target::Operand(operand, _) => Some(operand),
            _ => None,
        }
    }

    /// Whether the name means a timer, which changes by itself.
    pub fn is_timer(&self) -> bool {
        matches!(self.target, Target::Operand(Operand::Timer(_), _) | Target::TimerStatus(_))
    }

    /// Whether the name means a register.
    pub fn is_register(&self) -> bool {
        matches!(self.target, Target::Register(_) | Target::Status)
    }

    /// The value in a CPU, ready to be shown. Registers are those after the last statement of OB 1.
    ///
    /// # Errors
    /// The CPU has nothing of that name.
    pub fn read(&self, cpu: &Cpu) -> Result<Shown, NameError> {
        if let Target::Field { db, byte, data_type } = &self.target
            && !is_one_number(data_type)
        {
            return self.read_long(cpu, *db, *byte, data_type);
        }
        if let Target::Local(local) = &self.target
            && self.kind() == Kind::Text
        {
            return match self.shown_in(cpu.machine(), cpu.registers()) {
                Some(shown) => Ok(shown),
                None => Err(self.does_not_run(local)),
            };
        }
        let bits = self.bits(cpu)?;
        Ok(self.show_bits(bits))
    }

    /// Sets the value: an input in its module, a register for the beginning of OB 1 in the next scan, anything else in place.
    ///
    /// # Errors
    /// The value is none, does not fit, or the CPU has nothing of that name that could be set.
    pub fn write(&self, cpu: &mut Cpu, value: &str) -> Result<(), NameError> {
        if let (Target::Field { db, byte, .. }, Some(bytes)) = (&self.target, self.characters(value)?) {
            for (offset, &value) in (0_u32..).zip(&bytes) {
                let address = Address { area: Area::SharedData, width: Width::Byte, byte: byte + offset, bit: 0 };
                cpu.modify(&Operand::InDataBlock { db: *db, address }, u32::from(value))
                    .map_err(|error| NameError::new(format!("cannot set `{}`: {error}", self.text)))?;
            }
            return Ok(());
        }
        if let Target::Local(local) = &self.target {
            return self.write_local(cpu, local, value);
        }
        let bits = self.value(value)?;
        match &self.target {
            Target::Local(_) => Ok(()),
            Target::Operand(operand, _) => {
                cpu.modify(operand, bits as u32).map_err(|error| NameError::new(format!("cannot set `{}`: {error}", self.text)))
            }
            Target::TimerStatus(_) => Err(NameError::new(format!("`{}` can only be read; set `T n` to an S5TIME instead", self.text))),
            Target::Field { db, byte, data_type } if is_one_number(data_type) => {
                for (offset, half) in [(0, bits >> 32), (4, bits & 0xFFFF_FFFF)] {
                    let address = Address { area: Area::SharedData, width: Width::DoubleWord, byte: byte + offset, bit: 0 };
                    cpu.modify(&Operand::InDataBlock { db: *db, address }, half as u32)
                        .map_err(|error| NameError::new(format!("cannot set `{}`: {error}", self.text)))?;
                }
                Ok(())
            }
            Target::Field { .. } => Err(NameError::new(format!("`{}` can only be read", self.text))),
            Target::Status => {
                cpu.preset_registers_mut().set_status(StatusWord(bits as u16));
                Ok(())
            }
            Target::Register(register) => {
                self.check_register(*register, cpu)?;
                if matches!(register, Register::DbNumber | Register::DbLength | Register::DiNumber | Register::DiLength) {
                    return Err(NameError::new(format!("`{}` can only be read; open a data block with `OPN`", self.text)));
                }
                cpu.preset_registers_mut().set(*register, bits);
                Ok(())
            }
        }
    }

    fn write_local(&self, cpu: &mut Cpu, local: &Local, value: &str) -> Result<(), NameError> {
        let spot = local.spot(cpu.machine(), cpu.registers());
        let Some(Spot::Arena(at, bit)) = spot else {
            return Err(match spot {
                Some(_) => NameError::new(format!("`{}` is given by the caller and cannot be set", self.text)),
                None => self.does_not_run(local),
            });
        };
        let set = match (self.characters(value)?, local.width()) {
            (Some(bytes), _) => (at..).zip(bytes).all(|(at, byte)| cpu.modify_memory(at, 0, Width::Byte, u64::from(byte))),
            (None, Some(width)) => {
                let bits = self.value(value)?;
                cpu.modify_memory(at, bit, width, bits)
            }
            (None, None) => return Err(NameError::new(format!("`{}` can only be read", self.text))),
        };
        if set { Ok(()) } else { Err(self.does_not_run(local)) }
    }

    fn does_not_run(&self, local: &Local) -> NameError {
        NameError::new(format!("`{}` has no value here: `{}` is not the block that runs", self.text, local.block))
    }

    /// Forces it to this value, until [`Self::unforce`].
    ///
    /// # Errors
    /// The value is none or does not fit, or the CPU type does not force anything of that name.
    pub fn force(&self, cpu: &mut Cpu, value: &str) -> Result<(), NameError> {
        let bits = self.value(value)?;
        cpu.force(self.forcible()?, bits as u32).map_err(|error| NameError::new(format!("cannot force `{}`: {error}", self.text)))
    }

    /// Ends its forcing.
    ///
    /// # Errors
    /// It is not forced, or the CPU type does not force anything of that name.
    pub fn unforce(&self, cpu: &mut Cpu) -> Result<(), NameError> {
        match cpu.unforce(self.forcible()?) {
            Ok(true) => Ok(()),
            Ok(false) => Err(NameError::new(format!("`{}` is not forced", self.text))),
            Err(error) => Err(NameError::new(format!("`{}` cannot be forced: {error}", self.text))),
        }
    }

    fn forcible(&self) -> Result<&Operand, NameError> {
        match &self.target {
            Target::Operand(operand, _) => Ok(operand),
            _ => Err(NameError::new(format!("`{}` cannot be forced: {}", self.text, sieben_cpu::AccessError::NotForced))),
        }
    }

    /// Whether the value in a CPU is this one. `NaN` stands for every REAL that is no number.
    ///
    /// # Errors
    /// The expected value is none or does not fit, or the CPU has nothing of that name.
    pub fn holds(&self, cpu: &Cpu, expected: &str) -> Result<bool, NameError> {
        if self.kind() == Kind::Text && !matches!(self.target, Target::Operand(..)) {
            return Ok(self.read(cpu)?.to_string() == expected);
        }
        if expected.eq_ignore_ascii_case("NaN") {
            return match self.width() {
                32 => Ok(f32::from_bits(self.bits(cpu)? as u32).is_nan()),
                _ => Err(NameError::new(format!("`NaN` is a value of 32 bits, which `{}` is not", self.text))),
            };
        }
        Ok(self.bits(cpu)? == self.value(expected)?)
    }

    /// The bits of a value that is expected here; those of one that is no number for `NaN`.
    ///
    /// # Errors
    /// The value is none, or does not fit.
    pub(crate) fn expected(&self, text: &str) -> Result<u64, NameError> {
        if text.eq_ignore_ascii_case("NaN") && self.width() == 32 { Ok(u64::from(f32::NAN.to_bits())) } else { self.value(text) }
    }

    /// Sets the value of an input in its module at a time to come, anything else now.
    ///
    /// # Errors
    /// As of [`Self::write`].
    pub fn write_at(&self, cpu: &mut Cpu, value: &str, at_us: u64) -> Result<(), NameError> {
        match &self.target {
            Target::Operand(operand @ Operand::Address(Address { area: Area::Input | Area::PeripheralInput, .. }), _) => {
                let bits = self.value(value)?;
                cpu.modify_input_at(at_us, operand, bits as u32)
                    .map_err(|error| NameError::new(format!("cannot set `{}`: {error}", self.text)))
            }
            _ => self.write(cpu, value),
        }
    }

    /// Whether a value written by a user can be set here.
    ///
    /// # Errors
    /// The text is no constant, or does not fit.
    pub fn accepts(&self, text: &str) -> Result<(), NameError> {
        match self.characters(text)? {
            Some(_) => Ok(()),
            None => self.value(text).map(drop),
        }
    }

    /// The bytes of a STRING with these characters: maximum length, length, characters; `None` if this is no STRING.
    fn characters(&self, text: &str) -> Result<Option<Vec<u8>>, NameError> {
        let (Target::Field { data_type: DataType::String(length_max), .. }
        | Target::Local(Local { data_type: DataType::String(length_max), .. })) = &self.target
        else {
            return Ok(None);
        };
        let value = match text.trim() {
            "''" => Value::Characters(Vec::new()),
            text => literal::parse(text).map_err(|error| NameError::new(error.to_string()))?,
        };
        match value {
            Value::Characters(characters) => match u8::try_from(characters.len()) {
                Ok(length) if length <= *length_max => Ok(Some([*length_max, length].into_iter().chain(characters).collect())),
                _ => Err(NameError::new(format!("`{text}` does not fit into `{}`, which holds {length_max} characters", self.text))),
            },
            _ => Err(NameError::new(format!("`{text}` is no value of the STRING `{}`; write characters in single quotes", self.text))),
        }
    }

    /// The bits that a value written by a user has in this place.
    ///
    /// # Errors
    /// The text is no constant, or does not fit.
    pub fn value(&self, text: &str) -> Result<u64, NameError> {
        let text = text.trim();
        let width = self.width();
        if self.target == Target::Status {
            if let Some(word) = StatusWord::parse(text) {
                return Ok(u64::from(word.0));
            }
            // `STW=111` would be a number to some and three bits to others.
            if text.bytes().all(|byte| byte.is_ascii_digit()) {
                return Err(NameError::new(format!("`{text}` is no status word, which has nine characters 0 or 1")));
            }
        }
        if width == 1 {
            return match text.to_ascii_uppercase().as_str() {
                "0" | "FALSE" | "2#0" => Ok(0),
                "1" | "TRUE" | "2#1" => Ok(1),
                _ => Err(NameError::new(format!("`{text}` is no value of the bit `{}`; write 0 or 1", self.text))),
            };
        }
        // `DB1.speed=5` means the number where the field is a REAL.
        if let (Some(DataType::Real), Ok(number)) = (self.data_type(), text.parse::<f32>()) {
            return Ok(u64::from(number.to_bits()));
        }
        if let Some(data_type) = self.data_type()
            && let Some(bits) = literal::elsewhere::parse_as(data_type, text)
        {
            return Ok(bits);
        }
        if let Ok(number) = text.parse::<i64>() {
            return self.integer(text, number);
        }
        match text.to_ascii_uppercase().as_str() {
            "+INF" | "INF" if width == 32 => return Ok(u64::from(f32::INFINITY.to_bits())),
            "-INF" if width == 32 => return Ok(u64::from(f32::NEG_INFINITY.to_bits())),
            _ => {}
        }
        let value = literal::parse(text).map_err(|error| NameError::new(error.to_string()))?;
        if let (Target::Operand(Operand::Counter(_), _), Value::Counter(count)) = (&self.target, &value) {
            return Ok(u64::from(bcd::decode(u32::from(*count), 3)));
        }
        let bits = value.bits().ok_or_else(|| NameError::new(format!("`{text}` is no value of at most 64 bits")))?;
        match width {
            1..=63 if bits >> width != 0 => Err(self.does_not_fit(text)),
            _ => Ok(bits),
        }
    }

    /// A plain decimal number in this place; negative numbers as two's complement.
    fn integer(&self, text: &str, number: i64) -> Result<u64, NameError> {
        let width = self.width();
        // A register takes what `L` would bring into it: 16 bits without the sign, as long as the number has no more.
        let width = if self.is_register() && i16::try_from(number).is_ok() { 16 } else { width };
        let (min, max) = match width {
            1..=62 => (-(1_i64 << (width - 1)), (1_i64 << width) - 1),
            _ => (i64::MIN, i64::MAX),
        };
        if !(min..=max).contains(&number) {
            return Err(self.does_not_fit(text));
        }
        Ok((number as u64) & if width >= 64 { u64::MAX } else { (1 << width) - 1 })
    }

    fn does_not_fit(&self, text: &str) -> NameError {
        NameError::new(format!("`{text}` does not fit into `{}`, which has {} bits", self.text, self.width()))
    }

    /// The bits of the value in a CPU.
    fn bits(&self, cpu: &Cpu) -> Result<u64, NameError> {
        let cannot = |error: &dyn fmt::Display| NameError::new(format!("cannot read `{}`: {error}", self.text));
        match &self.target {
            Target::Operand(operand, _) => cpu.read(operand).map(u64::from).map_err(|error| cannot(&error)),
            Target::TimerStatus(number) => match cpu.timer(*number) {
                Some(reading) => Ok(u64::from(reading.status)),
                None => Err(cannot(&format!("the CPU has timers T 0 to T {}", cpu.cpu_type().timers - 1))),
            },
            Target::Field { db, byte, .. } => {
                let mut bits = 0;
                for offset in [0, 4] {
                    let address = Address { area: Area::SharedData, width: Width::DoubleWord, byte: byte + offset, bit: 0 };
                    let half = cpu.read(&Operand::InDataBlock { db: *db, address }).map_err(|error| cannot(&error))?;
                    bits = bits << 32 | u64::from(half);
                }
                Ok(bits)
            }
            Target::Local(local) => self.bits_in(cpu.machine(), cpu.registers()).ok_or_else(|| self.does_not_run(local)),
            Target::Status => Ok(u64::from(cpu.registers().status().0)),
            Target::Register(register) => {
                self.check_register(*register, cpu)?;
                Ok(cpu.registers().get(*register))
            }
        }
    }

    /// The bits of the value in a machine whose registers are these, between any two statements; `None` if it has none there: a data block
    /// that is not loaded, or a field of more than 64 bits. A peripheral input has the value of the process image, an output likewise.
    pub fn bits_in(&self, machine: &Machine, registers: &Registers) -> Option<u64> {
        match &self.target {
            Target::Operand(Operand::Timer(number), _) => {
                let mut timer = machine.timers.get(usize::from(*number))?.clone();
                timer.refresh(machine.clock_us);
                Some(u64::from(timer.remaining(machine.clock_us)))
            }
            Target::Operand(Operand::Counter(number), _) => Some(u64::from(machine.counters.get(usize::from(*number))?.count)),
            Target::Operand(Operand::Address(address), _) => {
                let area = match address.area {
                    Area::PeripheralInput => Area::Input,
                    Area::PeripheralOutput => Area::Output,
                    area => area,
                };
                machine.memory.read(&Operand::Address(Address { area, ..*address })).map(u64::from)
            }
            Target::Operand(operand, _) => machine.memory.read(operand).map(u64::from),
            Target::TimerStatus(number) => {
                let mut timer = machine.timers.get(usize::from(*number))?.clone();
                timer.refresh(machine.clock_us);
                Some(u64::from(timer.status))
            }
            Target::Field { db, byte, data_type } if is_one_number(data_type) => {
                let half = |offset| {
                    let address = Address { area: Area::SharedData, width: Width::DoubleWord, byte: byte + offset, bit: 0 };
                    machine.memory.read(&Operand::InDataBlock { db: *db, address }).map(u64::from)
                };
                Some(half(0)? << 32 | half(4)?)
            }
            Target::Field { .. } => None,
            Target::Local(local) => local.read(machine, registers),
            Target::Status => Some(u64::from(registers.status().0)),
            Target::Register(register) => Some(registers.get(*register)),
        }
    }

    /// The bytes of the arena where it lies in a machine whose registers are these, and which bits of them; `None` if it lies elsewhere.
    pub fn extent(&self, machine: &Machine, registers: &Registers) -> Option<(Range<usize>, u8)> {
        let at = |first: usize, width: Width, bit: u8| {
            let mask = if width == Width::Bit { 1 << (bit & 7) } else { 0xFF };
            (first..first + width.bytes() as usize, mask)
        };
        let long = |first: usize, data_type: &DataType| Some((first..first + usize::try_from(data_type.bits().div_ceil(8)).ok()?, 0xFF));
        match &self.target {
            Target::Operand(operand @ (Operand::Address(address) | Operand::InDataBlock { address, .. }), _) => {
                machine.memory.locate(operand).map(|first| at(first, address.width, address.bit))
            }
            Target::Field { db, byte, data_type } => {
                machine.memory.data_block(u64::from(*db)).and_then(|entry| long((entry.base + byte) as usize, data_type))
            }
            Target::Local(local) => match (local.spot(machine, registers)?, local.width()) {
                (Spot::Arena(first, bit), Some(width)) => Some(at(first, width, bit)),
                (Spot::Arena(first, _), None) => long(first, &local.data_type),
                (Spot::Number(_), _) => None,
            },
            Target::Operand(..) | Target::TimerStatus(_) | Target::Register(_) | Target::Status => None,
        }
    }

    /// Whether what is stored lies where this name does, in a machine whose registers are these. Registers are no place.
    pub fn is_stored(&self, machine: &Machine, registers: &Registers, stored: &Stored) -> bool {
        match (&self.target, *stored) {
            (Target::Operand(Operand::Timer(number), _) | Target::TimerStatus(number), Stored::Timer(other)) => *number == other,
            (Target::Operand(Operand::Counter(number), _), Stored::Counter(other)) => *number == other,
            // `T PQW` writes the process image as well.
            (Target::Operand(Operand::Address(address), _), Stored::Peripheral { first, bytes }) => {
                matches!(address.area, Area::Output | Area::PeripheralOutput)
                    && address.byte < first + bytes
                    && first < address.byte + address.width.bytes()
            }
            (_, Stored::Memory { first, bytes, mask }) => self
                .extent(machine, registers)
                .is_some_and(|(own, own_mask)| own.start < first + bytes && first < own.end && own_mask & mask != 0),
            _ => false,
        }
    }

    /// What setting it from outside stores, at once: an input only comes with the next process image.
    pub(crate) fn stores(&self, machine: &Machine) -> Option<Stored> {
        match &self.target {
            Target::Operand(Operand::Timer(number), _) => Some(Stored::Timer(*number)),
            Target::Operand(Operand::Counter(number), _) => Some(Stored::Counter(*number)),
            Target::Operand(Operand::Address(Address { area: Area::Input | Area::PeripheralInput, .. }), _) => None,
            Target::Operand(Operand::Address(address @ Address { area: Area::PeripheralOutput, .. }), _) => {
                Some(Stored::Peripheral { first: address.byte, bytes: address.width.bytes() })
            }
            _ => {
                let (range, mask) = self.extent(machine, &machine.registers)?;
                Some(Stored::Memory { first: range.start, bytes: range.len(), mask })
            }
        }
    }

    /// A variable of an instance as the address that it has now; everything else as it is.
    ///
    /// # Errors
    /// The block is not the one that runs: which instance is meant is not known.
    pub fn of_this_instance(self, machine: &Machine, registers: &Registers) -> Result<Self, NameError> {
        let Target::Local(local) = &self.target else { return Ok(self) };
        if !local.is_in_instance() {
            return Ok(self);
        }
        let here = || {
            let Some(Spot::Arena(at, bit)) = local.spot(machine, registers) else { return None };
            let db = u16::try_from(registers.di_number).ok()?;
            let byte = u32::try_from(at).ok()?.checked_sub(machine.memory.data_block(u64::from(db))?.base)?;
            parsing::target_of_field(db, byte * 8 + u32::from(bit), local.data_type.clone(), &self.text).ok()
        };
        match here() {
            Some(target) => Ok(Self { text: self.text, target }),
            None => Err(NameError::new(format!(
                "`{}` lies in an instance, and `{}` is not the block that runs; step into it, or name the data block: `DB1.name`",
                self.text, local.block
            ))),
        }
    }

    /// How bits of a value that [`Self::bits_in`] gave are written.
    pub fn show_bits(&self, bits: u64) -> Shown {
        match &self.target {
            // Not by the kind, which makes a text of an enumeration.
            Target::Operand(operand @ (Operand::Address(_) | Operand::InDataBlock { .. }), data_type) => {
                shown(bits, operand_width(operand), data_type.as_ref())
            }
            Target::Field { data_type, .. } => shown(bits, 64, Some(data_type)),
            Target::Local(local) => shown_number(bits, local),
            _ => self.kind().shown(bits),
        }
    }

    /// How two values of this name compare: as REAL if it is one, words and double words with their sign, as `>I` and `>D` do, all else
    /// without. `None` if one of them is no number.
    pub fn compare(&self, left: u64, right: u64) -> Option<std::cmp::Ordering> {
        match (self.data_type(), self.width()) {
            (Some(DataType::Real), _) => f32::from_bits(left as u32).partial_cmp(&f32::from_bits(right as u32)),
            (Some(DataType::LongReal), _) => f64::from_bits(left).partial_cmp(&f64::from_bits(right)),
            (_, 16) => Some((left as u16).cast_signed().cmp(&(right as u16).cast_signed())),
            (_, 32) => Some((left as u32).cast_signed().cmp(&(right as u32).cast_signed())),
            _ => Some(left.cmp(&right)),
        }
    }

    /// Shows a field of more than 64 bits.
    fn read_long(&self, cpu: &Cpu, db: u16, byte: u32, data_type: &DataType) -> Result<Shown, NameError> {
        let memory = &cpu.machine().memory;
        let entry = memory.data_block(u64::from(db));
        let length = data_type.bits().div_ceil(8);
        let end = u64::from(byte) + length;
        let bytes = entry
            .filter(|entry| end <= u64::from(entry.length))
            .and_then(|entry| memory.arena.get((entry.base + byte) as usize..).and_then(|from| from.get(..usize::try_from(length).ok()?)))
            .ok_or_else(|| NameError::new(format!("cannot read `{}`: it lies outside its data block", self.text)))?;
        Ok(Shown::Text(text_of(bytes, data_type)))
    }

    /// The value in a machine whose registers are these, ready to be shown; `None` if it has none there.
    pub fn shown_in(&self, machine: &Machine, registers: &Registers) -> Option<Shown> {
        match &self.target {
            Target::Local(local) if local.width().is_none() => {
                local.bytes(machine, registers).map(|bytes| Shown::Text(text_of(bytes, &local.data_type)))
            }
            _ => self.bits_in(machine, registers).map(|bits| self.show_bits(bits)),
        }
    }
    fn check_register(&self, register: Register, cpu: &Cpu) -> Result<(), NameError> {
        let beyond = matches!(register, Register::Accu3 | Register::Accu4) && cpu.cpu_type().accumulators < 4;
        match beyond {
            true => Err(NameError::new(format!(
                "the CPU {} has no `{}`, only the accumulators 1 and 2; the S7-400 has four",
                cpu.cpu_type().name,
                self.text
            ))),
            false => Ok(()),
        }
    }

    fn data_type(&self) -> Option<&DataType> {
        match &self.target {
            Target::Operand(_, data_type) => data_type.as_ref(),
            Target::Field { data_type, .. } | Target::Local(Local { data_type, .. }) => Some(data_type),
            _ => None,
        }
    }

    /// The number of bits that the value has.
    fn width(&self) -> u32 {
        match &self.target {
            Target::Operand(operand, _) => operand_width(operand),
            Target::TimerStatus(_) => 1,
            Target::Field { .. } => 64,
            Target::Local(local) => local.bits().min(64),
            Target::Register(register) if is_status(*register) => 1,
            Target::Register(_) => 32,
            Target::Status => 9,
        }
    }
}

fn is_status(register: Register) -> bool {
    STATUS_NAMES.iter().any(|&(_, bit)| bit == register)
}

fn operand_width(operand: &Operand) -> u32 {
    match operand {
        Operand::Address(address) | Operand::InDataBlock { address, .. } => address.width.bits(),
        Operand::Timer(_) | Operand::Counter(_) | Operand::Block(_) => 16,
    }
}

/// Bytes of a type that is no number, as people read them.
fn text_of(bytes: &[u8], data_type: &DataType) -> String {
    match data_type {
        DataType::String(_) => {
            let count = usize::from(bytes.get(1).copied().unwrap_or(0));
            Value::Characters(bytes.iter().skip(2).take(count).copied().collect()).spell()
        }
        DataType::WideString(_) => {
            let word = |at: usize| bytes.get(at..at + 2).map_or(0, |pair| u16::from_be_bytes([pair[0], pair[1]]));
            let units: Vec<u16> = (0..usize::from(word(2))).map(|index| word(4 + 2 * index)).collect();
            format!("'{}'", String::from_utf16_lossy(&units))
        }
        DataType::Any => <[u8; 10]>::try_from(bytes).map(|bytes| Value::Any(bytes).spell()).unwrap_or_default(),
        _ => bytes.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" "),
    }
}

/// A variable of a block: timers, counters and blocks that it was given by their names.
fn shown_number(bits: u64, local: &Local) -> Shown {
    let letters = match local.data_type {
        DataType::Timer => "T",
        DataType::Counter => "C",
        DataType::BlockFunction => "FC",
        DataType::BlockFunctionBlock => "FB",
        DataType::BlockData => "DB",
        DataType::BlockSystemData => "SDB",
        _ => return shown(bits, local.bits().min(64), Some(&local.data_type)),
    };
    Shown::Text(format!("{letters} {bits}"))
}

/// Whether a value of more than 32 bits is read and written as one number of 64.
fn is_one_number(data_type: &DataType) -> bool {
    *data_type == DataType::DateAndTime || data_type.is_long()
}

/// Bits by their type if that says more than their width.
fn shown(bits: u64, width: u32, data_type: Option<&DataType>) -> Shown {
    match data_type.map(DataType::base) {
        _ if width == 1 => Shown::Bit(bits != 0),
        Some(DataType::LongReal) => Shown::LongReal(f64::from_bits(bits)),
        Some(_) if data_type.is_some_and(literal::elsewhere::is_elsewhere) => {
            let text = literal::format_as(data_type.unwrap_or(&DataType::Word), bits);
            // Integers of up to 32 bits are numbers to every reader of JSON, those of 64 bits are not.
            text.parse().ok().filter(|_| width <= 32).map_or(Shown::Text(text), Shown::Number)
        }
        Some(DataType::DateAndTime) => Shown::Text(literal::format_as(&DataType::DateAndTime, bits)),
        Some(DataType::Int) => Shown::Number(i64::from(bits as u16 as i16)),
        Some(DataType::DoubleInt) => Shown::Number(i64::from(bits as u32 as i32)),
        Some(DataType::Real) => Shown::Real(f32::from_bits(bits as u32)),
        Some(DataType::Char | DataType::Date | DataType::TimeOfDay | DataType::Time | DataType::S5Time) => {
            Shown::Text(literal::format_as(data_type.unwrap_or(&DataType::Word), bits))
        }
        _ => Shown::Hex { bits, digits: (width / 4) as usize },
    }
}
