//! What `--set` and `--show` name: addresses, timers, counters, variables, symbols and registers.

use serde_json::{Value as Json, json};
use sieben_cpu::{Cpu, Station};
use sieben_engine::machine::registers::STATUS_BITS;
use sieben_engine::machine::{Register, Registers, StatusWord};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::literal::{self, Value};
use sieben_model::problems::Problem;
use sieben_model::program::DataBlock;
use sieben_model::symbols::SymbolTable;
use sieben_model::types::{DataType, Structure};

use crate::failure::Failure;
use crate::nearest::nearest;

/// Names of the status bits, in the order of [`STATUS_BITS`].
const STATUS_NAMES: [&str; 9] = ["/FC", "RLO", "STA", "OR", "OS", "OV", "CC0", "CC1", "BR"];

/// Something that has a value and a name.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Target {
    /// The name as the caller wrote it.
    pub(crate) name: String,
    kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Register(Register),
    StatusWord,
    TimerStatus(u16),
    /// An address, timer or counter, with a type if a declaration gives it one.
    Operand(Operand, Option<DataType>),
    /// A variable longer than 32 bits, by its data block and first byte.
    Long {
        db: u16,
        byte: u32,
        data_type: DataType,
    },
}

/// Where names are looked up.
pub(crate) struct Names<'a> {
    /// The symbols of the project.
    pub(crate) symbols: &'a SymbolTable,
    /// The CPU with its loaded data blocks.
    pub(crate) cpu: &'a Cpu,
}

/// Splits a list of names at commas outside brackets and quotes: `MW 10,DB1.field[1,2],"a,b"`.
pub(crate) fn split_list(list: &str) -> Vec<&str> {
    split_outside(list, ',', usize::MAX).into_iter().map(str::trim).filter(|name| !name.is_empty()).collect()
}

/// Splits `NAME=VALUE` at the first `=` outside quotes.
pub(crate) fn split_assignment(text: &str) -> Result<(&str, &str), Failure> {
    match split_outside(text, '=', 2)[..] {
        // `:=` is what STL writes.
        [name, value] => Ok((name.trim().trim_end_matches(':').trim_end(), value.trim())),
        _ => Err(Failure::usage(Problem::P7003, format!("`{text}` gives no value"))
            .help("write `NAME=VALUE`, such as `I0.0=1` or `MW10=W#16#00FF`")),
    }
}

fn split_outside(text: &str, separator: char, parts_max: usize) -> Vec<&str> {
    let (mut parts, mut start, mut quoted, mut depth) = (Vec::new(), 0, false, 0_usize);
    for (at, c) in text.char_indices() {
        match c {
            '"' => quoted = !quoted,
            '[' if !quoted => depth += 1,
            ']' if !quoted => depth = depth.saturating_sub(1),
            _ if c == separator && !quoted && depth == 0 && parts.len() + 1 < parts_max => {
                parts.push(&text[start..at]);
                start = at + c.len_utf8();
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    parts
}

impl Names<'_> {
    /// What a name means.
    pub(crate) fn resolve(&self, name: &str) -> Result<Target, Failure> {
        let text = name.trim();
        let kind = match text.strip_prefix('"') {
            Some(rest) => self.symbol(rest),
            None => self.plain(text),
        };
        match kind {
            Ok(Some(kind)) => Ok(Target { name: text.to_owned(), kind }),
            Ok(None) => Err(self.unknown(text)),
            Err(failure) => Err(failure),
        }
    }

    fn plain(&self, text: &str) -> Result<Option<Kind>, Failure> {
        let compact: String = text.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_ascii_uppercase();
        if let Some(kind) = register(&compact) {
            return Ok(Some(kind));
        }
        if let Some(timer) = compact.strip_suffix(".Q")
            && let Some(Operand::Timer(number)) = Operand::parse(timer)
        {
            self.require_timer(number)?;
            return Ok(Some(Kind::TimerStatus(number)));
        }
        match Operand::parse(text) {
            Some(Operand::Block(block)) => {
                return Err(Failure::usage(Problem::P7003, format!("`{text}` is a block and has no value of its own"))
                    .help(format!("name an address in it, such as `{}.DBW0`, or a variable", block.to_string().replace(' ', ""))));
            }
            Some(operand) => {
                self.require(&operand, text)?;
                return Ok(Some(Kind::Operand(operand, None)));
            }
            None => {}
        }
        if let Some((block, path)) = text.split_once('.')
            && let Some(Operand::Block(BlockId { kind: BlockKind::DataBlock, number })) = Operand::parse(block)
        {
            return self.field(number, path, text).map(Some);
        }
        self.symbol(text)
    }

    /// A symbol, possibly one of a data block with a path behind it. The opening quote is gone already.
    fn symbol(&self, text: &str) -> Result<Option<Kind>, Failure> {
        let (name, path) = match text.split_once('"') {
            Some((name, rest)) => (name, rest.trim().strip_prefix('.').or((!rest.trim().is_empty()).then_some(rest))),
            None if self.symbols.find(text).is_some() => (text, None),
            None => match text.split_once('.') {
                Some((name, path)) => (name.trim(), Some(path)),
                None => (text, None),
            },
        };
        let Some(symbol) = self.symbols.find(name) else { return Ok(None) };
        let Some(operand) = symbol.operand() else {
            return Err(Failure::usage(
                Problem::P7003,
                format!("the symbol `{name}` has no address that is understood: `{}`", symbol.address),
            ));
        };
        match (operand, path) {
            (Operand::Block(BlockId { kind: BlockKind::DataBlock, number }), Some(path)) => self.in_block(number, path, text).map(Some),
            (Operand::Timer(number), Some(path)) if path.trim().eq_ignore_ascii_case("q") => {
                self.require_timer(number)?;
                Ok(Some(Kind::TimerStatus(number)))
            }
            (Operand::Block(_), _) => Err(Failure::usage(
                Problem::P7003,
                format!("`{name}` is the block {operand_text} and has no value of its own", operand_text = symbol.address.trim()),
            )
            .help("name a variable of a data block, such as `\"Data\".speed`")),
            (_, Some(path)) => Err(Failure::usage(Problem::P7003, format!("`{name}` has no part `{path}`"))),
            (operand, None) => {
                self.require(&operand, text)?;
                let data_type = elementary(&symbol.data_type)
                    .filter(|data_type| Some(data_type.bits()) == width(&operand).map(|width| u64::from(width.bits())));
                Ok(Some(Kind::Operand(operand, data_type)))
            }
        }
    }

    /// `"Data".DBW 2` or `"Data".speed`.
    fn in_block(&self, db: u16, path: &str, text: &str) -> Result<Kind, Failure> {
        if let Some(operand @ Operand::InDataBlock { .. }) = Operand::parse(&format!("DB{db}.{path}")) {
            self.require(&operand, text)?;
            return Ok(Kind::Operand(operand, None));
        }
        self.field(db, path, text)
    }

    fn block(&self, db: u16) -> Result<&DataBlock, Failure> {
        self.cpu.program().data.get(&db).ok_or_else(|| Failure::usage(Problem::P7003, format!("the program has no DB {db}")))
    }

    /// A variable of a data block: `speed`, `motor.list[3]`.
    fn field(&self, db: u16, path: &str, text: &str) -> Result<Kind, Failure> {
        let block = self.block(db)?;
        let (data_type, position) = walk(&block.structure, path).map_err(|(part, known)| {
            let failure = Failure::usage(Problem::P7003, format!("`{text}`: DB {db} has no `{part}` there"));
            match nearest(&part, known.iter().map(String::as_str)) {
                Some(near) => failure.help(format!("did you mean `{near}`?")),
                None if known.is_empty() => failure,
                None => failure.help(format!(
                    "there are {}",
                    crate::nearest::one_of(known.iter().map(String::as_str).take(20)).replace(" or ", " and ")
                )),
            }
        })?;
        let byte = u32::try_from(position / 8).unwrap_or(u32::MAX);
        let width = match data_type.bits() {
            1 => Width::Bit,
            8 => Width::Byte,
            16 => Width::Word,
            32 => Width::DoubleWord,
            _ if matches!(data_type, DataType::DateAndTime | DataType::String(_)) => {
                let end = u64::from(byte) + data_type.bits() / 8;
                if end > block.image.len() as u64 {
                    return Err(outside(text));
                }
                return Ok(Kind::Long { db, byte, data_type });
            }
            _ => {
                return Err(Failure::usage(Problem::P7003, format!("`{text}` is no single value"))
                    .help("name one of its elements, such as `.field` or `[1]`"));
            }
        };
        let operand = Operand::InDataBlock { db, address: Address { area: Area::SharedData, width, byte, bit: (position % 8) as u8 } };
        self.require(&operand, text)?;
        let known = Value::from_bits(&data_type, 0).is_some();
        Ok(Kind::Operand(operand, known.then_some(data_type)))
    }

    /// Whether an operand has a value on this CPU.
    fn require(&self, operand: &Operand, text: &str) -> Result<(), Failure> {
        self.cpu.read(operand).map(drop).map_err(|error| {
            let cpu = self.cpu.cpu_type().name;
            Failure::usage(Problem::P7003, format!("`{text}` has no value on a CPU {cpu}: {error}"))
        })
    }

    fn require_timer(&self, number: u16) -> Result<(), Failure> {
        self.require(&Operand::Timer(number), &format!("T {number}"))
    }

    fn unknown(&self, text: &str) -> Failure {
        let failure = Failure::usage(Problem::P7003, format!("`{text}` is neither an address nor a symbol of the program"));
        match nearest(text.trim_matches('"'), self.symbols.symbols().iter().map(|symbol| symbol.name.as_str())) {
            Some(near) => failure.help(format!("did you mean the symbol `{near}`?")),
            None => failure,
        }
    }
}

fn outside(text: &str) -> Failure {
    Failure::usage(Problem::P7003, format!("`{text}` lies outside its data block"))
}

fn width(operand: &Operand) -> Option<Width> {
    match operand {
        Operand::Address(address) | Operand::InDataBlock { address, .. } => Some(address.width),
        _ => None,
    }
}

/// A register by its name in capitals without blanks.
fn register(name: &str) -> Option<Kind> {
    let register = match name {
        "ACCU1" => Register::Accu1,
        "ACCU2" => Register::Accu2,
        "ACCU3" => Register::Accu3,
        "ACCU4" => Register::Accu4,
        "AR1" => Register::Ar1,
        "AR2" => Register::Ar2,
        "STW" => return Some(Kind::StatusWord),
        _ => {
            let bit = name.strip_prefix("STW.")?;
            let bit = if bit == "FC" { "/FC" } else { bit };
            STATUS_BITS[STATUS_NAMES.iter().position(|&known| known == bit)?]
        }
    };
    Some(Kind::Register(register))
}

/// The elementary type with this name.
fn elementary(name: &str) -> Option<DataType> {
    Some(match name.trim().to_ascii_uppercase().as_str() {
        "BOOL" => DataType::Bool,
        "BYTE" => DataType::Byte,
        "CHAR" => DataType::Char,
        "WORD" => DataType::Word,
        "INT" => DataType::Int,
        "DWORD" => DataType::DoubleWord,
        "DINT" => DataType::DoubleInt,
        "REAL" => DataType::Real,
        "DATE" => DataType::Date,
        "TIME_OF_DAY" | "TOD" => DataType::TimeOfDay,
        "TIME" => DataType::Time,
        "S5TIME" => DataType::S5Time,
        _ => return None,
    })
}

/// Type and position in bits of `a.b[3].c`; else the part that is unknown and the names that are known there.
fn walk(structure: &Structure, path: &str) -> Result<(DataType, u64), (String, Vec<String>)> {
    let mut data_type: Option<DataType> = None;
    let mut position = 0_u64;
    let mut rest = path.trim();
    loop {
        let inner = match &data_type {
            None => structure,
            Some(DataType::Struct(inner) | DataType::Instance { structure: inner, .. }) => inner,
            Some(_) => return Err((rest.to_owned(), Vec::new())),
        };
        let end = rest.find(['.', '[']).unwrap_or(rest.len());
        let name = rest[..end].trim().trim_matches('"').trim_start_matches('#');
        let field =
            inner.field(name).ok_or_else(|| (name.to_owned(), inner.fields.iter().map(|field| field.name.clone()).collect::<Vec<_>>()))?;
        position += u64::from(field.offset);
        let mut found = field.data_type.clone();
        rest = rest[end..].trim_start();
        while let Some(open) = rest.strip_prefix('[') {
            let (indices, behind) = open.split_once(']').ok_or_else(|| (rest.to_owned(), Vec::new()))?;
            let flat = flat_index(&found, indices).ok_or_else(|| (format!("{name}[{indices}]"), Vec::new()))?;
            position += found.element_offset(flat);
            let DataType::Array { element, .. } = found else { return Err((rest.to_owned(), Vec::new())) };
            found = *element;
            rest = behind.trim_start();
        }
        if rest.is_empty() {
            return Ok((found, position));
        }
        rest = rest.strip_prefix('.').ok_or_else(|| (rest.to_owned(), Vec::new()))?;
        data_type = Some(found);
    }
}

/// The position of `1, 2` among all elements of an array.
fn flat_index(array: &DataType, indices: &str) -> Option<u64> {
    let DataType::Array { bounds, .. } = array else { return None };
    let indices: Vec<i64> = indices.split(',').map(|index| index.trim().parse().ok()).collect::<Option<_>>()?;
    if indices.len() != bounds.len() {
        return None;
    }
    indices.iter().zip(bounds).try_fold(0_u64, |flat, (&index, &(low, high))| {
        let (low, high) = (i64::from(low), i64::from(high));
        (low..=high).contains(&index).then(|| flat * ((high - low + 1) as u64) + (index - low) as u64)
    })
}

/// A value on its way to a target.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Assignment {
    target: Target,
    bits: Bits,
}

#[derive(Clone, Debug, PartialEq)]
enum Bits {
    Word(u32),
    Bytes(Vec<u8>),
}

impl Assignment {
    /// Reads a value for a target.
    pub(crate) fn new(target: Target, text: &str) -> Result<Self, Failure> {
        let bits = bits_for(&target.kind, text).map_err(|message| {
            let failure = Failure::usage(Problem::P7004, format!("`{}={text}`: {message}", target.name));
            match target.kind {
                Kind::StatusWord => {
                    failure.help("write nine characters 0 or 1 in the order BR CC1 CC0 OV OS OR STA RLO /FC: `STW=000000110`")
                }
                _ => failure,
            }
        })?;
        Ok(Self { target, bits })
    }

    /// Whether it presets a register of OB 1's first scan.
    pub(crate) fn is_register(&self) -> bool {
        matches!(self.target.kind, Kind::Register(_) | Kind::StatusWord)
    }

    /// Presets the register.
    pub(crate) fn preset(&self, registers: &mut Registers) {
        let Bits::Word(value) = self.bits else { return };
        match self.target.kind {
            Kind::Register(register) => registers.set(register, u64::from(value)),
            Kind::StatusWord => registers.set_status(StatusWord(value as u16)),
            _ => {}
        }
    }

    /// Gives the target its value.
    pub(crate) fn apply(&self, cpu: &mut Cpu) -> Result<(), Failure> {
        let failed = |error| Failure::usage(Problem::P7004, format!("`{}` cannot be set: {error}", self.target.name));
        match (&self.target.kind, &self.bits) {
            (Kind::Operand(operand, _), Bits::Word(value)) => cpu.modify(operand, *value).map_err(failed),
            (Kind::Long { db, byte, .. }, Bits::Bytes(bytes)) => bytes.iter().zip(*byte..).try_for_each(|(&value, byte)| {
                let address = Address { area: Area::SharedData, width: Width::Byte, byte, bit: 0 };
                cpu.modify(&Operand::InDataBlock { db: *db, address }, u32::from(value)).map_err(failed)
            }),
            _ => Ok(()),
        }
    }
}

/// The bits of a constant for a target.
fn bits_for(kind: &Kind, text: &str) -> Result<Bits, String> {
    let (bits, data_type) = match kind {
        Kind::StatusWord => {
            return StatusWord::parse(text)
                .map(|word| Bits::Word(u32::from(word.0)))
                .ok_or_else(|| "the status word is nine characters 0 or 1".to_owned());
        }
        Kind::TimerStatus(_) => return Err("the status bit of a timer cannot be set; set the timer by starting it".to_owned()),
        Kind::Long { data_type, .. } => return long_bytes(data_type, text).map(Bits::Bytes),
        Kind::Register(register) if STATUS_BITS.contains(register) => (1, None),
        Kind::Register(_) => return register_bits(text).map(Bits::Word),
        Kind::Operand(Operand::Timer(_), _) => {
            return match literal::parse(text) {
                Ok(Value::S5Time(word) | Value::Word(word)) => Ok(Bits::Word(u32::from(word))),
                Ok(_) => Err("a timer takes an S5TIME, such as `S5T#2S`".to_owned()),
                Err(error) => Err(error.to_string()),
            };
        }
        Kind::Operand(Operand::Counter(_), _) => return counter_bits(text).map(Bits::Word),
        Kind::Operand(operand, data_type) => (width(operand).map_or(32, Width::bits), data_type.as_ref()),
    };
    memory_bits(bits, data_type, text).map(Bits::Word)
}

fn counter_bits(text: &str) -> Result<u32, String> {
    match literal::parse(text) {
        Ok(Value::Int(count @ 0..=999)) => Ok(count as u32),
        Ok(Value::Counter(bcd)) => Ok(u32::from(bcd >> 8 & 0xF) * 100 + u32::from(bcd >> 4 & 0xF) * 10 + u32::from(bcd & 0xF)),
        Ok(_) => Err("a counter takes 0 to 999, such as `12` or `C#12`".to_owned()),
        Err(error) => Err(error.to_string()),
    }
}

/// What `L` would load: a 16-bit constant leaves the high word 0.
fn register_bits(text: &str) -> Result<u32, String> {
    match constant(text)? {
        Constant::Number(number) => in_range(number, 32),
        Constant::Value(value) => value
            .bits()
            .and_then(|bits| u32::try_from(bits).ok())
            .ok_or_else(|| format!("`{text}` is longer than the 32 bits of a register")),
    }
}

/// A number as it stands in memory, by the width of the address or the type of the variable.
fn memory_bits(bits: u32, data_type: Option<&DataType>, text: &str) -> Result<u32, String> {
    let value = match constant(text)? {
        Constant::Number(number) => return in_range(number, bits),
        Constant::Value(value) => value,
    };
    match (&value, data_type) {
        (Value::Int(number), Some(DataType::Real)) => return Ok(f32::from(*number).to_bits()),
        (Value::DoubleInt(number), Some(DataType::Real)) => return Ok((*number as f32).to_bits()),
        (Value::Int(number), _) => return in_range(i64::from(*number), bits),
        (Value::DoubleInt(number), _) => return in_range(i64::from(*number), bits),
        (Value::Bool(bit), _) if bits == 1 => return Ok(u32::from(*bit)),
        _ => {}
    }
    let raw = value.bits().ok_or_else(|| format!("`{text}` is longer than 32 bits"))?;
    let fits = bits > 1 && (bits >= 32 || raw >> bits == 0) && raw <= u64::from(u32::MAX) && !matches!(value, Value::Bool(_));
    if fits {
        return Ok(raw as u32);
    }
    Err(match bits {
        1 => "a bit takes 0 or 1".to_owned(),
        bits => format!("`{text}` does not fit {bits} bits"),
    })
}

enum Constant {
    Value(Value),
    /// A plain number too large for an INT, which STL would want with a prefix.
    Number(i64),
}

fn constant(text: &str) -> Result<Constant, String> {
    literal::parse(text).map(Constant::Value).or_else(|error| text.trim().parse().map(Constant::Number).map_err(|_| error.to_string()))
}

fn in_range(number: i64, bits: u32) -> Result<u32, String> {
    let (low, high) = match bits {
        1 => (0, 1),
        bits => (-(1_i64 << (bits - 1)), (1_i64 << bits) - 1),
    };
    if bits == 1 && !(low..=high).contains(&number) {
        return Err("a bit takes 0 or 1".to_owned());
    }
    if !(low..=high).contains(&number) {
        return Err(format!("{number} does not fit {bits} bits: {low} to {high}"));
    }
    Ok(number as u32 & (u32::MAX >> (32 - bits)))
}

/// The bytes of a STRING or DATE_AND_TIME.
fn long_bytes(data_type: &DataType, text: &str) -> Result<Vec<u8>, String> {
    match (data_type, literal::parse(text)) {
        (_, Err(error)) => Err(error.to_string()),
        (DataType::DateAndTime, Ok(Value::DateAndTime(bytes))) => Ok(bytes.to_vec()),
        (DataType::String(maximum), Ok(Value::Characters(characters))) => {
            let length = u8::try_from(characters.len()).ok().filter(|length| length <= maximum);
            let length = length.ok_or_else(|| format!("the text has {} characters, the variable holds {maximum}", characters.len()))?;
            Ok([&[*maximum, length], characters.as_slice()].concat())
        }
        (DataType::DateAndTime, Ok(_)) => Err("the variable takes a DATE_AND_TIME, such as `DT#2024-02-29-12:00:00`".to_owned()),
        (_, Ok(_)) => Err("the variable takes a text between apostrophes, such as `'abc'`".to_owned()),
    }
}

impl Target {
    /// Its value as JSON: bits as 0 and 1, timers and counters decimal, words in hex, variables by their type.
    pub(crate) fn value(&self, cpu: &Cpu) -> Json {
        match &self.kind {
            Kind::StatusWord => json!(cpu.registers().status().to_string()),
            Kind::Register(register) if STATUS_BITS.contains(register) => json!(cpu.registers().get(*register) & 1),
            Kind::Register(register) => json!(hex(cpu.registers().get(*register) as u32, 32)),
            Kind::TimerStatus(number) => json!(u8::from(cpu.timer(*number).is_some_and(|timer| timer.status))),
            Kind::Long { db, byte, data_type } => self.long_value(cpu, *db, *byte, data_type),
            Kind::Operand(operand, data_type) => match (cpu.read(operand), operand, data_type) {
                // A data block can disappear while the program runs.
                (Err(_), ..) => Json::Null,
                (Ok(value), Operand::Timer(_) | Operand::Counter(_), _) => json!(value),
                (Ok(value), _, Some(data_type)) => typed(data_type, value),
                (Ok(value), _, None) => match width(operand) {
                    Some(Width::Bit) => json!(value & 1),
                    width => json!(hex(value, width.map_or(32, Width::bits))),
                },
            },
        }
    }

    fn long_value(&self, cpu: &Cpu, db: u16, first: u32, data_type: &DataType) -> Json {
        let length = u32::try_from(data_type.bits() / 8).unwrap_or(0);
        let read = |byte| {
            let address = Address { area: Area::SharedData, width: Width::Byte, byte, bit: 0 };
            cpu.read(&Operand::InDataBlock { db, address }).map(|value| value as u8).ok()
        };
        let Some(bytes) = (first..first + length).map(read).collect::<Option<Vec<u8>>>() else { return Json::Null };
        match (data_type, <[u8; 8]>::try_from(bytes.as_slice())) {
            (DataType::DateAndTime, Ok(bytes)) => json!(Value::DateAndTime(bytes).spell()),
            _ => {
                let used = usize::from(bytes.get(1).copied().unwrap_or(0)).min(bytes.len().saturating_sub(2));
                json!(Value::Characters(bytes.get(2..2 + used).unwrap_or_default().to_vec()).spell())
            }
        }
    }

    /// Its value as people read it.
    pub(crate) fn text(&self, cpu: &Cpu) -> String {
        match self.value(cpu) {
            Json::String(text) => text,
            Json::Null => "not loaded".to_owned(),
            value => value.to_string(),
        }
    }
}

fn typed(data_type: &DataType, value: u32) -> Json {
    match Value::from_bits(data_type, u64::from(value)) {
        Some(Value::Bool(bit)) => json!(u8::from(bit)),
        Some(Value::Int(number)) => json!(number),
        Some(Value::DoubleInt(number)) => json!(number),
        Some(Value::Byte(byte)) => json!(hex(u32::from(byte), 8)),
        Some(Value::Word(word)) => json!(hex(u32::from(word), 16)),
        Some(Value::DoubleWord(word)) => json!(hex(word, 32)),
        // The digits of the REAL itself, not those of its widening to 64 bits.
        Some(Value::Real(number)) if number.is_finite() => number.to_string().parse::<f64>().map_or(Json::Null, |number| json!(number)),
        _ => json!(literal::format_as(data_type, u64::from(value))),
    }
}

/// `16#0001`, `16#0000_0005`.
fn hex(value: u32, bits: u32) -> String {
    match bits {
        8 => format!("16#{value:02X}"),
        16 => format!("16#{value:04X}"),
        _ => format!("16#{:04X}_{:04X}", value >> 16, value & 0xFFFF),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_and_assignments_are_split_outside_quotes_and_brackets() {
        assert_eq!(split_list("MW 10, DB1.a[1,2],\"a,b\",,"), ["MW 10", "DB1.a[1,2]", "\"a,b\""]);
        assert_eq!(split_assignment("\"a=b\" = 5").ok(), Some(("\"a=b\"", "5")));
        assert_eq!(split_assignment("MW10:=5").ok(), Some(("MW10", "5")));
        assert!(split_assignment("MW10").is_err());
    }

    #[test]
    fn constants_fit_their_targets_or_say_why_not() {
        for (bits, text, expected) in [
            (1, "1", Some(1)),
            (1, "TRUE", Some(1)),
            (1, "2", None),
            (1, "W#16#1", None),
            (8, "255", Some(255)),
            (8, "-1", Some(255)),
            (8, "256", None),
            (8, "'A'", Some(0x41)),
            (16, "40000", Some(40_000)),
            (16, "-1", Some(0xFFFF)),
            (16, "W#16#00FF", Some(255)),
            (16, "16#0001", Some(1)),
            (16, "S5T#2S", Some(0x0200)),
            (16, "1.5", None),
            (32, "-1", Some(0xFFFF_FFFF)),
            (32, "1.5", Some(0x3FC0_0000)),
            (32, "16#0000_0005", Some(5)),
            (32, "nonsense", None),
        ] {
            assert_eq!(memory_bits(bits, None, text).ok(), expected, "{text} into {bits} bits");
        }
        assert_eq!(memory_bits(32, Some(&DataType::Real), "2").ok(), Some(2.0_f32.to_bits()));
        assert_eq!(register_bits("-1").ok(), Some(0xFFFF));
        assert_eq!(register_bits("L#-1").ok(), Some(0xFFFF_FFFF));
    }
}
