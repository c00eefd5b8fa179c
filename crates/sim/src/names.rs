//! Names of what can be watched and set from outside: addresses, timers, counters, registers, symbols, fields of data blocks.
//!
//! `exec`, scenarios and recordings speak of the same things in the same words; the words are read here.

mod reading;

use std::fmt;

pub use reading::{Displayed, Kind, Sample, TEXT_BYTES_MAX};
use sieben_cpu::{Cpu, Station};
use sieben_engine::Machine;
use sieben_engine::Program;
use sieben_engine::machine::{Register, Registers, StatusWord};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::bcd;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::literal::{self, Value};
use sieben_model::symbols::SymbolTable;
use sieben_model::types::{DataType, Structure};

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
            Self::Status(word) => write!(f, "{word}"),
            Self::Text(text) => f.write_str(text),
        }
    }
}

/// Names of the status bits, in either mnemonic language.
const STATUS_NAMES: &[(&str, Register)] = &[
    ("BR", Register::Br),
    ("BIE", Register::Br),
    ("CC1", Register::Cc1),
    ("A1", Register::Cc1),
    ("CC0", Register::Cc0),
    ("A0", Register::Cc0),
    ("OV", Register::Ov),
    ("OS", Register::Os),
    ("OR", Register::Or),
    ("STA", Register::Sta),
    ("RLO", Register::Rlo),
    ("VKE", Register::Rlo),
    ("/FC", Register::Fc),
    ("FC", Register::Fc),
    ("/ER", Register::Fc),
    ("ER", Register::Fc),
];

/// Names of the other registers.
const REGISTER_NAMES: &[(&str, Register)] = &[
    ("ACCU1", Register::Accu1),
    ("ACCU2", Register::Accu2),
    ("ACCU3", Register::Accu3),
    ("ACCU4", Register::Accu4),
    ("AR1", Register::Ar1),
    ("AR2", Register::Ar2),
    ("DBNO", Register::DbNumber),
    ("DBLG", Register::DbLength),
    ("DINO", Register::DiNumber),
    ("DILG", Register::DiLength),
];

impl Name {
    /// What lies at an address, called as the user likes; with its type, if it has one that says more than its width.
    pub fn at(text: impl Into<String>, operand: Operand, data_type: Option<DataType>) -> Self {
        Self { text: text.into(), target: Target::Operand(operand, data_type) }
    }

    /// Reads a name: `I 0.0`, `MW10`, `DB1.DBD4`, `DB1.speed`, `"Motor on"`, `T 1`, `T1.q`, `C 1`, `ACCU1`, `AR1`, `STW`, `STW.RLO`;
    /// addresses in either mnemonic language, blanks optional, letters in either case.
    ///
    /// # Errors
    /// Nothing is called that.
    pub fn parse(text: &str, symbols: &SymbolTable, program: &Program) -> Result<Self, NameError> {
        let text = text.trim();
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

    /// The address, timer or counter that it means, if it is a single one.
    pub fn operand(&self) -> Option<&Operand> {
        match &self.target {
            Target::Operand(operand, _) => Some(operand),
            _ => None,
        }
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
        let bits = self.value(value)?;
        match &self.target {
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
        if let Target::Field { data_type, .. } = &self.target
            && !is_one_number(data_type)
        {
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
        let Target::Field { data_type: DataType::String(length_max), .. } = &self.target else { return Ok(None) };
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
            Target::Status => Some(u64::from(registers.status().0)),
            Target::Register(register) => Some(registers.get(*register)),
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
        Ok(Shown::Text(match data_type {
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
        }))
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
            Target::Field { data_type, .. } => Some(data_type),
            _ => None,
        }
    }

    /// The number of bits that the value has.
    fn width(&self) -> u32 {
        match &self.target {
            Target::Operand(operand, _) => operand_width(operand),
            Target::TimerStatus(_) => 1,
            Target::Field { .. } => 64,
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

/// Whether a value of more than 32 bits is read and written as one number of 64.
fn is_one_number(data_type: &DataType) -> bool {
    *data_type == DataType::DateAndTime || data_type.is_long()
}

/// Bits by their type if that says more than their width.
fn shown(bits: u64, width: u32, data_type: Option<&DataType>) -> Shown {
    match data_type.map(DataType::base) {
        _ if width == 1 => Shown::Bit(bits != 0),
        Some(_) if data_type.is_some_and(literal::elsewhere::is_elsewhere) => {
            Shown::Text(literal::format_as(data_type.unwrap_or(&DataType::Word), bits))
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

/// What the status bits are called in German, beside what they are called here.
const GERMAN_STATUS_NAMES: &[(&str, &str)] = &[("BIE", "BR"), ("A1", "CC1"), ("A0", "CC0"), ("VKE", "RLO"), ("/ER", "/FC"), ("ER", "/FC")];

/// Why a text that is almost an address is none: a bit number above 7.
fn bit_above_seven(text: &str) -> Option<NameError> {
    let (byte, bit) = text.rsplit_once('.')?;
    let above = bit.parse::<u32>().is_ok_and(|bit| bit > 7);
    let address = Operand::parse(&format!("{byte}.0"));
    (above && matches!(address, Some(Operand::Address(_) | Operand::InDataBlock { .. })))
        .then(|| NameError::new(format!("`{text}` has a bit number above 7; the bits of a byte are 0 to 7")))
}

/// A register, timer, counter or address; `None` if it is none of them.
fn absolute(text: &str) -> Result<Option<Target>, NameError> {
    let plain: String = text.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_ascii_uppercase();
    if plain == "STW" {
        return Ok(Some(Target::Status));
    }
    if let Some(bit) = plain.strip_prefix("STW.") {
        let german = GERMAN_STATUS_NAMES.iter().find(|&&(german, _)| german == bit);
        let bit = german.map_or(bit, |&(_, english)| english);
        return match STATUS_NAMES.iter().find(|&&(name, _)| name == bit) {
            Some(&(_, register)) => Ok(Some(Target::Register(register))),
            None => {
                let message = format!("the status word has no bit `{bit}`; its bits are BR, CC1, CC0, OV, OS, OR, STA, RLO and /FC");
                Err(NameError::new(message))
            }
        };
    }
    let register = plain.strip_prefix("AKKU").map_or_else(|| plain.clone(), |number| format!("ACCU{number}"));
    if let Some(&(_, register)) = REGISTER_NAMES.iter().find(|&&(name, _)| name == register) {
        return Ok(Some(Target::Register(register)));
    }
    if let Some(timer) = plain.strip_suffix(".Q")
        && let Some(Operand::Timer(number)) = Operand::parse(timer)
    {
        return Ok(Some(Target::TimerStatus(number)));
    }
    match Operand::parse(&plain) {
        Some(Operand::Block(block)) => {
            Err(NameError::new(format!("`{block}` is a block, which has no value; name an address or a field in it")))
        }
        Some(operand) => Ok(Some(Target::Operand(operand, None))),
        None => Ok(None),
    }
}

/// A variable that the program calls by this name alone, or a field of a data block with a name.
fn named(text: &str, program: &Program) -> Result<Option<Target>, NameError> {
    let names = &program.names;
    if names.open.is_empty() && names.blocks.is_empty() && names.located.is_empty() {
        return Ok(None);
    }
    if let Some((operand, data_type)) = names.located.get(&text.trim_matches('"').to_lowercase()) {
        return Ok(Some(Target::Operand(*operand, Some(data_type.clone()))));
    }
    let found = names.open.iter().find_map(|number| {
        let (offset, data_type) = field(&program.data.get(number)?.structure, text).ok()?;
        Some((*number, offset, data_type))
    });
    let (first, path) = split_first(text);
    let in_block = || {
        let number = *names.blocks.get(&first.to_lowercase())?;
        let (offset, data_type) = field(&program.data.get(&number)?.structure, path).ok()?;
        Some((number, offset, data_type))
    };
    match found.or_else(in_block) {
        Some((number, offset, data_type)) => target_of_field(number, offset, data_type, text).map(Some),
        None => Ok(None),
    }
}

/// A symbol, or a field of a data block.
fn symbolic(text: &str, symbols: &SymbolTable, program: &Program) -> Result<Target, NameError> {
    if let Some(error) = bit_above_seven(text) {
        return Err(error);
    }
    let (first, path) = split_first(text);
    if path.is_empty()
        && let Some(symbol) = symbols.find(first)
    {
        return match symbol.operand() {
            Some(Operand::Block(block)) => Err(NameError::new(format!("`{text}` is {block}, which has no value; name a field in it"))),
            Some(operand) => Ok(Target::Operand(operand, DataType::from_word(symbol.data_type.trim()).filter(DataType::is_elementary))),
            None => Err(NameError::new(format!("the symbol `{text}` has the address `{}`, which is none", symbol.address))),
        };
    }
    let block = match (symbols.operand(first), Operand::parse(first)) {
        (Some(Operand::Block(block)), _) | (None, Some(Operand::Block(block))) => Some(block),
        _ => None,
    };
    let Some(BlockId { kind: BlockKind::DataBlock, number }) = block.filter(|_| !path.is_empty()) else {
        return Err(NameError::new(format!(
            "nothing is called `{text}`; write an address such as `I 0.0`, `MW 10`, `T 1` or `DB1.DBW 0`, a symbol, `DB1.name`, or one of `ACCU1`, `AR1`, `STW`, `STW.RLO`"
        )));
    };
    // `"Data".DBW 2`: the symbol stands for the block.
    if let Some(operand @ Operand::InDataBlock { .. }) = Operand::parse(&format!("DB{number}.{path}")) {
        return Ok(Target::Operand(operand, None));
    }
    let Some(data) = program.data.get(&number) else {
        return Err(NameError::new(format!("the program has no `DB {number}`, which `{text}` wants")));
    };
    let (offset, data_type) = field(&data.structure, path).map_err(|part| {
        let names: Vec<&str> = data.structure.fields.iter().take(8).map(|field| field.name.as_str()).collect();
        NameError::new(format!("`DB {number}` has no `{part}`; its fields begin with {}", names.join(", ")))
    })?;
    target_of_field(number, offset, data_type, text)
}

fn target_of_field(db: u16, offset: u32, data_type: DataType, text: &str) -> Result<Target, NameError> {
    if matches!(data_type, DataType::Array { .. } | DataType::Struct(_) | DataType::Instance { .. }) {
        return Err(NameError::new(format!("`{text}` is no single value; name one of its elements, such as `[1]` or `.name`")));
    }
    // A short STRING has as many bits as a number, but is none.
    let bits = if matches!(data_type, DataType::String(_)) { 0 } else { data_type.bits() };
    let width = match bits {
        1 => Width::Bit,
        8 => Width::Byte,
        16 => Width::Word,
        32 => Width::DoubleWord,
        _ => return Ok(Target::Field { db, byte: offset / 8, data_type }),
    };
    let address = Address { area: Area::SharedData, width, byte: offset / 8, bit: (offset % 8) as u8 };
    Ok(Target::Operand(Operand::InDataBlock { db, address }, Some(data_type)))
}

/// Splits `"a name".path` and `name.path`.
fn split_first(text: &str) -> (&str, &str) {
    if let Some(quoted) = text.strip_prefix('"') {
        let (first, rest) = quoted.split_once('"').unwrap_or((quoted, ""));
        return (first, rest.strip_prefix('.').unwrap_or(rest));
    }
    text.split_once('.').unwrap_or((text, ""))
}

/// Offset in bits and type of `a.b[3].c` in a structure; the part that does not exist if it has none.
fn field<'a>(structure: &Structure, path: &'a str) -> Result<(u32, DataType), &'a str> {
    let (head, rest) = path.split_at(path.find(['.', '[']).unwrap_or(path.len()));
    let head_field = structure.field(head.trim().trim_matches('"')).ok_or(path)?;
    let (mut offset, mut data_type, mut rest) = (u64::from(head_field.offset), head_field.data_type.clone(), rest);
    while let Some(bracket) = rest.strip_prefix('[') {
        let (indices, behind) = bracket.split_once(']').ok_or(path)?;
        let DataType::Array { element, .. } = &data_type else { return Err(path) };
        let indices: Vec<i64> = indices.split(',').map(|index| index.trim().parse().map_err(|_| path)).collect::<Result<_, _>>()?;
        let number = data_type.element_number(&indices).ok_or(path)?;
        offset = offset.saturating_add(data_type.element_offset(number));
        data_type = (**element).clone();
        rest = behind;
    }
    let offset = u32::try_from(offset).map_err(|_| path)?;
    match (rest.strip_prefix('.'), &data_type) {
        (None, _) if rest.is_empty() => Ok((offset, data_type)),
        (Some(inner), DataType::Struct(structure) | DataType::Instance { structure, .. }) => {
            let (inner_offset, data_type) = field(structure, inner)?;
            Ok((offset.saturating_add(inner_offset), data_type))
        }
        _ => Err(path),
    }
}

/// Splits `I 0.0=1 MW10=16#0102` into names and values; blanks around `=` and inside names are free.
///
/// # Errors
/// A part has no `=`, no name or no value; the message says which.
pub fn assignments(text: &str) -> Result<Vec<(String, String)>, NameError> {
    let mut out = Vec::new();
    let mut rest = text.trim();
    while !rest.is_empty() {
        let Some((name, behind)) = split_at_equals(rest) else {
            return Err(NameError::new(format!("`{rest}` is no `NAME=VALUE`")));
        };
        let behind = behind.trim_start();
        let end = value_end(behind);
        let (value, next) = behind.split_at(end);
        if name.trim().is_empty() || value.is_empty() {
            return Err(NameError::new(format!("`{}` is no `NAME=VALUE`", rest.trim())));
        }
        out.push((name.trim().to_owned(), value.to_owned()));
        rest = next.trim_start();
    }
    Ok(out)
}

/// Splits at the first `=` outside of quotes.
fn split_at_equals(text: &str) -> Option<(&str, &str)> {
    let mut quoted = false;
    let at = text.char_indices().find_map(|(at, c)| {
        quoted ^= c == '"';
        (c == '=' && !quoted).then_some(at)
    })?;
    Some((&text[..at], &text[at + 1..]))
}

/// Where a value ends: at the next blank that is not inside apostrophes or brackets.
fn value_end(text: &str) -> usize {
    let (mut quoted, mut depth) = (false, 0_u32);
    for (at, c) in text.char_indices() {
        match c {
            '\'' => quoted = !quoted,
            '(' if !quoted => depth += 1,
            ')' if !quoted => depth = depth.saturating_sub(1),
            c if c.is_whitespace() && !quoted && depth == 0 => return at,
            _ => {}
        }
    }
    text.len()
}
