//! `sieben assignments [PATH…]`: which inputs, outputs, bit memory, timers and counters are used.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use clap::Args;
use sieben_ide::assignment_list::{AreaUse, AssignmentList, BitUse, ByteUse, PartOf};
use sieben_ide::cross_reference::{CrossReference, Reference};
use sieben_model::address::Area;
use sieben_model::mnemonics::Mnemonics;
use sieben_workspace::places::Places;

use crate::arguments::{ProgramArguments, ReportArguments};
use crate::document::{Document, Section};
use crate::failure::{Exit, Failure};

/// Print which inputs, outputs, bit memory, timers and counters are used.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben assignments                           the project in this folder\n  \
  sieben assignments pump --html -o used.html  a page to print\n\n\
A row for each byte that is used. Bits: X as a bit, o as part of a byte, word or double\n\
word, p named by a pointer or range. B, W, D: X where an access begins, | where it goes on.\n\
Accesses whose address is computed at run time may reach any byte; they are listed below.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables or a project folder [default: this folder]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    #[command(flatten)]
    report: ReportArguments,
}

/// Prints the assignment list.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let build = match super::build_for_report(&arguments.paths, &arguments.program, &arguments.report)? {
        Ok(build) => build,
        Err(exit) => return Ok(exit),
    };
    let list = AssignmentList::new(&CrossReference::new(&build.compiled));
    let places = Places::new(&build);
    arguments.report.put(&document(&places, &list), || crate::page::assignments::json(&places, &list))?;
    Ok(Exit::Success)
}

fn document(places: &Places<'_>, list: &AssignmentList) -> Document {
    let mut sections: Vec<Section> = list
        .areas
        .iter()
        .filter(|(_, used)| !used.bytes.is_empty() || !used.indirect.is_empty())
        .map(|(area, used)| Section { title: title(*area).to_owned(), ..area_section(places, *area, used) })
        .collect();
    let counter = if places.mnemonics == Mnemonics::German { "Z" } else { "C" };
    let numbers = [("Timers", "T", &list.timers, &list.timers_indirect), ("Counters", counter, &list.counters, &list.counters_indirect)];
    for (title, letter, used, indirect) in numbers {
        if !used.is_empty() || !indirect.is_empty() {
            sections.push(Section { title: title.to_owned(), notes: notes(places, indirect), ..tens(letter, used) });
        }
    }
    if !list.crossing.is_empty() {
        let notes = notes(places, &list.crossing);
        sections.push(Section { title: "Area known only at run time".to_owned(), notes, ..Section::default() });
    }
    if sections.is_empty() {
        sections.push(Section { notes: vec!["No address is used in this program.".to_owned()], ..Section::default() });
    }
    Document { title: "Assignment list".to_owned(), sections, ..Document::default() }
}

fn title(area: Area) -> &'static str {
    match area {
        Area::Input => "Inputs",
        Area::Output => "Outputs",
        Area::BitMemory => "Bit memory",
        Area::PeripheralInput => "Peripheral inputs",
        Area::PeripheralOutput => "Peripheral outputs",
        Area::SharedData | Area::InstanceData => "Data",
        Area::Local | Area::CallerLocal => "Local data",
    }
}

fn area_section(places: &Places<'_>, area: Area, used: &AreaUse) -> Section {
    let prefix = area.prefix(places.mnemonics);
    let rows = used.bytes.iter().map(|(number, byte)| byte_row(&format!("{prefix}B {number}"), byte)).collect();
    let headings = vec!["Byte", "7", "6", "5", "4", "3", "2", "1", "0", "B", "W", "D"];
    Section { headings, rows, notes: notes(places, &used.indirect), ..Section::default() }
}

fn byte_row(name: &str, byte: &ByteUse) -> Vec<String> {
    let bit = |used: &BitUse| match used {
        BitUse::None => "·",
        BitUse::Pointer => "p",
        BitUse::Wider => "o",
        BitUse::Direct => "X",
    };
    let part = |part: PartOf| match part {
        PartOf::None => "·",
        PartOf::Inside => "|",
        PartOf::First => "X",
    };
    let cells = byte.bits.iter().rev().map(bit).chain([part(byte.byte), part(byte.word), part(byte.double_word)]);
    [name].into_iter().chain(cells).map(str::to_owned).collect()
}

/// Ten numbers in a row; rows without any are left out.
fn tens(letter: &str, used: &BTreeSet<u16>) -> Section {
    let mut rows: BTreeMap<u16, [bool; 10]> = BTreeMap::new();
    for number in used {
        rows.entry(number / 10).or_default()[usize::from(number % 10)] = true;
    }
    let rows = rows.iter().map(|(ten, used)| {
        let cells = used.iter().map(|used| if *used { "X" } else { "·" }.to_owned());
        [format!("{letter} {}", u32::from(*ten) * 10)].into_iter().chain(cells).collect()
    });
    Section { headings: vec!["From", "0", "1", "2", "3", "4", "5", "6", "7", "8", "9"], rows: rows.collect(), ..Section::default() }
}

fn notes(places: &Places<'_>, indirect: &[Reference]) -> Vec<String> {
    let line = |reference: &Reference| {
        let network = if reference.network == 0 { String::new() } else { format!(", network {}", reference.network) };
        format!(
            "* {}  {}  {}{network}, statement {} ({})",
            reference.target.spell(places.mnemonics),
            reference.usage.word(),
            places.block(reference.block),
            reference.statement,
            places.place(reference.span)
        )
    };
    indirect.iter().map(line).collect()
}
