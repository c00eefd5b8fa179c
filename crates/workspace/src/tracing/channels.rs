//! What is recorded: the names that a user gives, or the inputs and outputs that a program uses.

use sieben_cpu::Cpu;
use sieben_ide::cross_reference::CrossReference;
use sieben_ide::target::{Extent, Target};
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_sim::names::Name;
use sieben_sim::trace::CHANNELS_MAX;

use crate::names;
use crate::places::Places;
use crate::project::Build;
use crate::refusal::Refusal;

/// The areas whose addresses are recorded when none is named.
const AREAS: [Area; 4] = [Area::Input, Area::PeripheralInput, Area::Output, Area::PeripheralOutput];

/// The channels that the lists name; without any, those of the inputs and outputs that the program uses.
pub fn chosen(lists: &[String], build: &Build, cpu: &Cpu) -> Result<Vec<Name>, Refusal> {
    let mut channels = match lists {
        [] => used(build, cpu),
        // A recording keeps what a timer has left as a time: its count alone says nothing without the base.
        lists => names::resolve_lists(lists, &build.project.symbols, cpu)?.into_iter().map(Name::readable).collect(),
    };
    let mut seen = std::collections::HashSet::new();
    channels.retain(|name| seen.insert(name.text().to_owned()));
    match channels.len() {
        0 if lists.is_empty() => Err(Refusal::new(Problem::P7032, "the program uses no inputs and outputs that could be recorded")),
        0 => Err(Refusal::new(Problem::P7032, "`--channels` names nothing")),
        count if count > CHANNELS_MAX => {
            Err(Refusal::new(Problem::P7032, format!("{count} channels are too many; a trace has at most {CHANNELS_MAX}")))
        }
        _ => Ok(channels),
    }
}

/// The inputs and outputs of a program for a recording that other programs are held against: as symbols wherever there are some, so that addresses may be others
/// there; inputs with a symbol first, then the wider ones.
pub fn signals(build: &Build, cpu: &Cpu) -> (Vec<Name>, Vec<Name>) {
    let address = |name: &Name| match name.operand() {
        Some(Operand::Address(address)) if AREAS.contains(&address.area) => Some(*address),
        _ => None,
    };
    let bits = |address: &Address| {
        let first = u64::from(address.byte) * 8 + u64::from(if address.width == Width::Bit { address.bit } else { 0 });
        first..first + u64::from(address.width.bits())
    };
    let is_input = |area: Area| matches!(area, Area::Input | Area::PeripheralInput);
    let symbols = &build.project.symbols;
    let mnemonics = Places::new(build).mnemonics;
    let of_symbols = symbols.symbols().iter().filter_map(|symbol| match symbol.operand() {
        Some(Operand::Address(address)) if AREAS.contains(&address.area) => name_of(&address, build, mnemonics, cpu),
        _ => None,
    });
    let mut all: Vec<(Name, Address, bool)> = used(build, cpu)
        .into_iter()
        .chain(of_symbols)
        .filter_map(|name| {
            let address = address(&name)?;
            let named = Operand::parse(name.text()).is_none();
            Some((name, address, named))
        })
        .collect();
    let mut seen = std::collections::HashSet::new();
    all.retain(|(name, ..)| seen.insert(name.text().to_owned()));
    // Where a symbol has some of its bits, the others are recorded by themselves.
    let named: Vec<(bool, std::ops::Range<u64>)> =
        all.iter().filter(|(.., named)| *named).map(|(_, address, _)| (is_input(address.area), bits(address))).collect();
    all.retain(|(_, address, is_named)| {
        let own = bits(address);
        let meets = |other: &std::ops::Range<u64>| other.start < own.end && own.start < other.end;
        *is_named || !named.iter().any(|(input, other)| *input == is_input(address.area) && meets(other))
    });
    let (mut inputs, mut outputs): (Vec<_>, Vec<_>) = all.into_iter().partition(|(_, address, _)| is_input(address.area));
    inputs.sort_by_key(|(_, address, named)| (!named, std::cmp::Reverse(address.width.bits()), address.byte, address.bit));
    outputs.sort_by_key(|(_, address, _)| (address.byte, address.bit, address.width.bits()));
    let names = |all: Vec<(Name, Address, bool)>| all.into_iter().map(|(name, ..)| name).collect();
    (names(inputs), names(outputs))
}

fn used(build: &Build, cpu: &Cpu) -> Vec<Name> {
    let references = CrossReference::new(&build.compiled);
    let mut addresses: Vec<Address> = references
        .entries()
        .filter_map(|(target, _)| match target {
            Target::Memory(memory) if AREAS.contains(&memory.area) => {
                let width = match memory.extent {
                    Extent::Width(width) => width,
                    Extent::Bits(1) => Width::Bit,
                    Extent::Bits(8) => Width::Byte,
                    Extent::Bits(16) => Width::Word,
                    Extent::Bits(32) => Width::DoubleWord,
                    Extent::Bits(_) | Extent::Unknown => return None,
                };
                Some(Address { area: memory.area, width, byte: memory.position / 8, bit: (memory.position % 8) as u8 })
            }
            _ => None,
        })
        .collect();
    let order = |area: Area| AREAS.iter().position(|&known| known == area);
    addresses.sort_by_key(|address| (order(address.area), address.byte, address.bit, address.width.bits()));
    addresses.dedup();
    let mnemonics = Places::new(build).mnemonics;
    addresses.iter().filter_map(|address| name_of(address, build, mnemonics, cpu)).collect()
}

/// An address as the program calls it: a variable of ST, a symbol, or the address itself.
fn name_of(address: &Address, build: &Build, mnemonics: Mnemonics, cpu: &Cpu) -> Option<Name> {
    let operand = Operand::Address(*address);
    let (program, symbols) = (cpu.program(), &build.project.symbols);
    let located =
        program.names.located.iter().find(|(name, (place, _))| *place == operand && !name.contains('.')).map(|(name, _)| name.clone());
    let symbol = symbols.find_operand(&operand).map(|symbol| match symbol.name.contains('.') {
        true => format!("\"{}\"", symbol.name),
        false => symbol.name.clone(),
    });
    let spelled = operand.spell(mnemonics);
    let readable = |text: String| {
        let name = Name::parse(&text, symbols, program).ok()?;
        // Eight bytes of Structured Text have no name of their own.
        (name.read(cpu).is_ok() && (address.width == Width::Bit) == (name.kind().width() == 1)).then_some(name)
    };
    [located, symbol, Some(spelled)].into_iter().flatten().find_map(readable)
}
