//! How the operand of a statement is called in a sentence, and how it came to its address.

use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockKind;
use sieben_model::interface::Section;
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::types::DataType;

use super::telling::Telling;
use crate::sentences::memory::{Found, Trouble, address_register};
use crate::sentences::table::Sentence as S;
use crate::sentences::text::{Clause, Words, loose_words, pointer, typed};
use crate::stl::operands::{Access, Location, NumberOperand, Operand, StatusScan};

/// The operand of a statement as it is named.
pub(super) struct Named {
    /// `I 0.1 "Start"`, `#level (DB5.DBW 2)`, `T 1`.
    pub(super) name: Words,
    /// The same with what it is: `the input I 0.1`.
    pub(super) subject: Words,
    /// What stands before the sentence: the pointer, a data block that is opened.
    pub(super) leading: Vec<Clause>,
    /// Its address, or why it has none; `None` for what is not in memory.
    pub(super) found: Option<Result<Found, Trouble>>,
    /// How much, for memory.
    pub(super) width: Option<Width>,
    data_type: Option<DataType>,
}

impl Named {
    /// Names the operand of a statement.
    pub(super) fn new(telling: &Telling<'_>) -> Self {
        match telling.operand() {
            Operand::Memory(access) => Self::memory(telling, access),
            Operand::Timer(number) => Self::number(telling, number, ["the timer", "die Zeit"], "T"),
            Operand::Counter(number) => {
                let letter = if telling.mnemonics == Mnemonics::German { "Z" } else { "C" };
                Self::number(telling, number, ["the counter", "der Zähler"], letter)
            }
            Operand::Status(scan) => Self::plain(status_words(*scan, telling)),
            _ => Self::plain(telling.operand_text().into()),
        }
    }

    fn plain(name: Words) -> Self {
        Self { subject: name.clone(), name, leading: Vec::new(), found: None, width: None, data_type: None }
    }

    /// A value of the variable in the notation of its type, as far as that is known.
    pub(super) fn value(&self, bits: u64) -> Words {
        let bits = match self.width {
            Some(width) if width.bits() < 32 => bits & ((1 << width.bits()) - 1),
            _ => bits,
        };
        match &self.data_type {
            Some(data_type) => typed(data_type, bits),
            None => loose_words(bits),
        }
    }

    fn number(telling: &Telling<'_>, number: &NumberOperand, what: [&str; 2], letter: &str) -> Self {
        let text = telling.operand_text();
        let Some(found) = telling.reader().number(number) else { return Self::plain(text.into()) };
        let address = format!("{letter} {found}");
        let name = match number {
            NumberOperand::Parameter(_) => format!("{text} ({address})"),
            _ => with_symbol(telling, sieben_model::address::Operand::parse(&address), address),
        };
        Self { subject: subject(what, &name), ..Self::plain(name.into()) }
    }

    fn memory(telling: &Telling<'_>, access: &Access) -> Self {
        let written = telling.operand_text();
        let write = telling
            .statement
            .and_then(|statement| statement.instruction.direction())
            .is_some_and(|direction| direction != crate::stl::operands::Direction::Read);
        let reader = telling.reader();
        let mut found = reader.find(&access.location, write);
        // A pointer that the statement itself may have overwritten is no longer what it was.
        if let (true, None, Ok(target), Location::MemoryIndirect { pointer, .. }) = (write, telling.moment.before, found, &access.location)
            && let Ok(at) = reader.find(pointer, false)
            && at.area == target.area
            && at.position < target.position + access.width.bits()
            && target.position < at.position + 32
        {
            found = Err(Trouble::Unknown);
        }
        let data_type = data_type(telling, access, found);
        let mut named = Self { found: Some(found), width: Some(access.width), data_type, ..Self::plain(written.clone().into()) };
        let Ok(found) = found else { return named };
        let address = found.spell(access.width, telling.mnemonics);
        named.leading = leading(telling, &access.location, &address);
        let symbolic = written.starts_with(['#', '"']) || !address_written(&written);
        if symbolic && !written.is_empty() {
            named.name = if written == address { address.into() } else { format!("{written} ({address})").into() };
            named.subject = named.name.clone();
        } else {
            let name = with_symbol(telling, Some(found.operand(access.width)), address);
            named.subject = if access.width == Width::Bit { subject(area_words(found.area), &name) } else { name.as_str().into() };
            named.name = name.into();
        }
        named
    }
}

/// Whether a text is an address in letters and digits, or a pointer in brackets, and no name.
fn address_written(text: &str) -> bool {
    text.contains('[') || sieben_model::address::Operand::parse(text).is_some() || text.to_ascii_uppercase().starts_with("DI")
}

fn subject(what: [&str; 2], name: &str) -> Words {
    Words(what.map(|what| format!("{what} {name}")))
}

fn with_symbol(telling: &Telling<'_>, operand: Option<sieben_model::address::Operand>, address: String) -> String {
    match operand.and_then(|operand| telling.around.symbols.find_operand(&operand)) {
        Some(symbol) if !symbol.name.is_empty() => format!("{address} \"{}\"", symbol.name),
        _ => address,
    }
}

fn area_words(area: Area) -> [&'static str; 2] {
    match area {
        Area::Input | Area::PeripheralInput => ["the input", "der Eingang"],
        Area::Output | Area::PeripheralOutput => ["the output", "der Ausgang"],
        Area::BitMemory => ["the memory bit", "der Merker"],
        Area::SharedData | Area::InstanceData => ["the data bit", "das Datenbit"],
        Area::Local | Area::CallerLocal => ["the local bit", "das Lokalbit"],
    }
}

/// What leads to the address, where the statement does not show it.
fn leading(telling: &Telling<'_>, location: &Location, address: &str) -> Vec<Clause> {
    let before = telling.before();
    let opens = |register: &str, number: u16| vec![Clause::new(S::OpensFirst).with("register", register).with("number", u64::from(number))];
    match location {
        Location::InDataBlock { db, .. } if before.db_number != u64::from(*db) => opens("DB", *db),
        Location::InInstanceBlock { db, .. } if before.di_number != u64::from(*db) => opens("DI", *db),
        Location::MemoryIndirect { pointer: place, .. } => {
            let reader = telling.reader();
            let Some((at, value)) = reader.find(place, false).ok().and_then(|at| Some((at, reader.read(&at, Width::DoubleWord)?))) else {
                return Vec::new();
            };
            let clause = Clause::new(S::ThroughMemory).with("pointer_place", at.spell(Width::DoubleWord, telling.mnemonics));
            vec![clause.with("pointer", pointer(value)).with("address", address)]
        }
        Location::RegisterIndirect { register, offset, .. } => {
            let register = address_register(*register);
            let name = if register == Register::Ar2 { "AR2" } else { "AR1" };
            let clause = Clause::new(S::ThroughRegister).with("register", name).with("pointer", pointer(before.get(register)));
            vec![clause.with("offset", Value::Pointer(*offset).spell()).with("address", address)]
        }
        _ => Vec::new(),
    }
}

/// The declared type of a variable, where a symbol or a declaration tells it.
fn data_type(telling: &Telling<'_>, access: &Access, found: Result<Found, Trouble>) -> Option<DataType> {
    let fits = |data_type: &DataType| data_type.width() == Some(access.width);
    let is_function = matches!(telling.block.id.kind, BlockKind::Function | BlockKind::OrganizationBlock);
    let declared = |section: &dyn Fn(Section) -> bool, offset: u32| {
        let variables = telling.block.interface.variables.iter();
        variables
            .filter(|variable| section(variable.section) && variable.offset == offset)
            .map(|variable| variable.data_type.clone())
            .find(fits)
    };
    match &access.location {
        Location::Fixed { area: Area::Local, position } => return declared(&|section| section == Section::Temp, *position),
        Location::Instance { position } => return declared(&|section| section != Section::Temp, *position),
        Location::Parameter { index, offset: 0, complex: false } if is_function => {
            return declared(&|section| section != Section::Temp && section != Section::Static, u32::from(*index));
        }
        _ => {}
    }
    let found = found.ok()?;
    if !matches!(found.area, Area::Input | Area::Output | Area::BitMemory) {
        return None;
    }
    let symbol = telling.around.symbols.find_operand(&found.operand(access.width))?;
    DataType::from_word(symbol.data_type.trim()).filter(fits)
}

/// `==0`: what it asks, and what CC 1 and CC 0 are.
fn status_words(scan: StatusScan, telling: &Telling<'_>) -> Words {
    let before = telling.before();
    match scan {
        StatusScan::Overflow => ["OV", "OV"].into(),
        StatusScan::StoredOverflow => ["OS", "OS"].into(),
        StatusScan::BinaryResult => ["BR", "das BIE"].into(),
        _ => {
            let text = telling.operand_text();
            let [english, german] = [("CC 1", "CC 0", "and"), ("A1", "A0", "und")]
                .map(|(cc1, cc0, and)| format!("`{text}` ({cc1} = {} {and} {cc0} = {})", before.cc1, before.cc0));
            Words([english, german])
        }
    }
}
