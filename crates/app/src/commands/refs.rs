//! `sieben refs [PATH…] [NAME]`: where every address, timer, counter and block is used.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::Args;
use sieben_ide::cross_reference::{CrossReference, Overlaps, Reference};
use sieben_ide::target::{Memory, Target};
use sieben_ide::unused::Unused;
use sieben_model::address::Operand;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::problems::Problem;
use sieben_workspace::places::Places;
use sieben_workspace::project::Build;

use crate::arguments::{ProgramArguments, ReportArguments};
use crate::document::{Document, Section};
use crate::failure::{Exit, Failure};

/// Print where every address, timer, counter and block is used.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben refs                        the cross reference of the project in this folder\n  \
  sieben refs \"MW 10\"                one address\n  \
  sieben refs pump Start --overlaps  a symbol, with the addresses that share bits with it\n  \
  sieben refs pump \"DB 5\"            a block; of a data block also its contents\n  \
  sieben refs --unused               symbols that nothing uses, addresses without a symbol\n  \
  sieben refs --html -o refs.html    a page to print\n\n\
Types: R read, W written, RW both, call, open, inst (instance of a call),\n\
P# (the address or number is taken). `*` marks an address that is computed at run time.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables or a project folder [default: this folder]; last an address, a symbol or a variable
    #[arg(value_name = "PATH|NAME")]
    words: Vec<String>,
    #[command(flatten)]
    program: ProgramArguments,
    /// Name beside each address the others that share bits with it
    #[arg(long, conflicts_with = "unused")]
    overlaps: bool,
    /// Show parameters, local and static variables too
    #[arg(long, conflicts_with = "unused")]
    local: bool,
    /// Show symbols that nothing uses and addresses that have no symbol
    #[arg(long)]
    unused: bool,
    #[command(flatten)]
    report: ReportArguments,
}

/// Prints the cross reference.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let (paths, name) = paths_and_name(&arguments.words);
    let build = match super::build_for_report(&paths, &arguments.program, &arguments.report)? {
        Ok(build) => build,
        Err(exit) => return Ok(exit),
    };
    let places = Places::new(&build);
    let references = CrossReference::new(&build.compiled);
    if arguments.unused {
        if let Some(name) = name {
            return Err(Failure::usage(Problem::P7001, format!("`--unused` looks at the whole program; it takes no `{name}`")));
        }
        let unused = Unused::new(&build.compiled, &references, &build.project.symbols);
        arguments.report.put(&unused_document(&places, &unused), || unused_json(&places, &unused))?;
        return Ok(Exit::Success);
    }
    let overlaps = references.overlaps();
    let chosen = match name {
        Some(name) => Some(Chosen::new(name, &build, &places, &references, arguments.overlaps.then_some(&overlaps))?),
        None => None,
    };
    let shown: Vec<Entry<'_>> = references
        .entries()
        .filter(|(target, _)| match &chosen {
            Some(chosen) => chosen.targets.contains(target),
            None => arguments.local || !target.is_local(),
        })
        .map(|(target, uses)| Entry {
            target,
            uses,
            overlaps: if arguments.overlaps { overlapping(target, &overlaps) } else { Vec::new() },
        })
        .collect();
    let mut document = document(&places, &shown, arguments.overlaps);
    if shown.is_empty() {
        let note = match name {
            Some(name) => format!("{name} is not used in this program."),
            None => "Nothing is used in this program.".to_owned(),
        };
        document.sections[0].notes = vec![note];
    }
    arguments.report.put(&document, || shown.iter().map(|entry| entry_json(&places, entry, arguments.overlaps)).collect())?;
    Ok(Exit::Success)
}

/// A target with everything that is shown of it.
struct Entry<'a> {
    target: &'a Target,
    uses: &'a [Reference],
    overlaps: Vec<Memory>,
}

/// What is no file or folder, and stands last, is a name of the program.
fn paths_and_name(words: &[String]) -> (Vec<PathBuf>, Option<&str>) {
    match words.split_last() {
        Some((last, rest)) if !Path::new(last).exists() => (rest.iter().map(PathBuf::from).collect(), Some(last)),
        _ => (words.iter().map(PathBuf::from).collect(), None),
    }
}

/// The targets that a name on the command line means.
struct Chosen<'a> {
    targets: BTreeSet<&'a Target>,
}

impl<'a> Chosen<'a> {
    fn new(
        name: &str,
        build: &Build,
        places: &Places<'_>,
        references: &'a CrossReference,
        overlaps: Option<&Overlaps>,
    ) -> Result<Self, Failure> {
        let plain = name.trim().trim_matches('"');
        let symbol = build.project.symbols.find(plain);
        let operand = match symbol {
            Some(symbol) => symbol.operand(),
            None => Operand::parse(plain.strip_prefix('%').unwrap_or(plain)),
        };
        let wanted = operand.map(Target::from);
        let shared = match (&wanted, overlaps) {
            (Some(Target::Memory(memory)), Some(overlaps)) => overlaps.of(memory),
            _ => Vec::new(),
        };
        let same = |text: &str| text.to_lowercase() == plain.to_lowercase();
        let unquoted = |text: &str| text.replace('"', "").to_lowercase() == plain.replace('"', "").to_lowercase();
        let targets: BTreeSet<&Target> = references
            .entries()
            .map(|(target, _)| target)
            .filter(|target| {
                wanted.as_ref() == Some(*target)
                    || match target {
                        Target::Memory(memory) => {
                            let in_block = memory.db.is_some_and(|db| wanted == Some(Target::Block(BlockId::db(db))));
                            in_block
                                || shared.contains(memory)
                                || (wanted.is_none()
                                    && !plain.is_empty()
                                    && (unquoted(&places.symbol(target)) || places.plain_name(target).is_some_and(|name| unquoted(&name))))
                        }
                        Target::Local { name, .. } => wanted.is_none() && (same(name) || name.strip_prefix('#').is_some_and(same)),
                        Target::Indirect(_) => wanted.is_none() && same(&target.spell(places.mnemonics)),
                        Target::Block(_) => wanted.is_none() && !plain.is_empty() && unquoted(&places.symbol(target)),
                        _ => false,
                    }
            })
            .collect();
        let field = plain.split_once('.').is_some_and(|(block, _)| {
            let block = block.trim_matches('"');
            let operand = build.project.symbols.operand(block).or_else(|| Operand::parse(block));
            matches!(operand, Some(Operand::Block(BlockId { kind: BlockKind::DataBlock, .. })))
        });
        if targets.is_empty() && operand.is_none() && symbol.is_none() && !field {
            let message = format!("`{name}` is neither a file nor an address, symbol or variable of this program");
            return Err(Failure::usage(Problem::P7003, message)
                .help("write an address (`MW 10`, `T 1`, `FC 1`), a symbol, a field (`\"DB\".name`) or a `#variable`"));
        }
        Ok(Self { targets })
    }
}

fn overlapping(target: &Target, overlaps: &Overlaps) -> Vec<Memory> {
    match target {
        Target::Memory(memory) => overlaps.of(memory),
        _ => Vec::new(),
    }
}

fn document(places: &Places<'_>, shown: &[Entry<'_>], overlaps: bool) -> Document {
    let mut headings = vec!["Address", "Symbol", "Type", "Block", "Network", "No.", "Line", "Statement"];
    if overlaps {
        headings.push("Overlaps");
    }
    let mut rows = Vec::new();
    for entry in shown {
        for (index, reference) in entry.uses.iter().enumerate() {
            let (mut address, mut symbol, mut shared) = Default::default();
            if index == 0 {
                address = spell(places, entry.target);
                symbol = match entry.target {
                    // The same name may stand in many blocks.
                    Target::Local { block, .. } => format!("in {block}"),
                    target => places.symbol(target),
                };
                shared = entry.overlaps.iter().map(|memory| spell(places, &Target::Memory(*memory))).collect::<Vec<_>>().join(", ");
            }
            let mut row = vec![
                address,
                symbol,
                reference.usage.word().to_owned(),
                places.block(reference.block),
                if reference.network == 0 { String::new() } else { reference.network.to_string() },
                reference.statement.to_string(),
                places.place(reference.span),
                places.statement(reference),
            ];
            if overlaps {
                row.push(shared);
            }
            rows.push(row);
        }
    }
    Document {
        title: "Cross reference".to_owned(),
        sections: vec![Section { headings, rows, ..Section::default() }],
        ..Document::default()
    }
}

/// The address; `*` marks what is computed at run time.
fn spell(places: &Places<'_>, target: &Target) -> String {
    let text = target.spell(places.mnemonics);
    if matches!(target, Target::Indirect(_)) { format!("{text} *") } else { text }
}

fn entry_json(places: &Places<'_>, entry: &Entry<'_>, overlaps: bool) -> serde_json::Value {
    let symbol = places.symbol(entry.target);
    let mut value = serde_json::json!({ "address": entry.target.spell(places.mnemonics) });
    if !symbol.is_empty() {
        value["symbol"] = symbol.into();
    }
    if let Target::Local { block, .. } = entry.target {
        value["declared_in"] = block.to_string().into();
    }
    value["indirect"] = matches!(entry.target, Target::Indirect(_)).into();
    if overlaps {
        value["overlaps"] = entry.overlaps.iter().map(|memory| Target::Memory(*memory).spell(places.mnemonics)).collect();
    }
    value["references"] = entry.uses.iter().map(|reference| places.reference_json(reference)).collect();
    value
}

fn unused_document(places: &Places<'_>, unused: &Unused) -> Document {
    let symbols = unused.symbols.iter().map(|unused| {
        let overlaps = unused.overlaps.iter().map(|memory| Target::Memory(*memory).spell(places.mnemonics));
        vec![
            unused.symbol.name.clone(),
            unused.symbol.address.trim().to_owned(),
            overlaps.collect::<Vec<_>>().join(", "),
            one_line(&unused.symbol.comment),
        ]
    });
    let addresses = unused.addresses.iter().map(|(target, first, count)| {
        vec![target.spell(places.mnemonics), count.to_string(), places.block(first.block), places.place(first.span)]
    });
    let section = |title: &str, headings: Vec<&'static str>, rows: Vec<Vec<String>>| {
        let notes = if rows.is_empty() { vec!["None.".to_owned()] } else { Vec::new() };
        Section { title: title.to_owned(), headings, rows, notes }
    };
    Document {
        title: "Unused symbols and addresses without a symbol".to_owned(),
        sections: vec![
            section("Symbols that no statement uses", vec!["Symbol", "Address", "In use with other widths", "Comment"], symbols.collect()),
            section("Addresses without a symbol", vec!["Address", "Uses", "First in", "Line"], addresses.collect()),
        ],
        ..Document::default()
    }
}

fn unused_json(places: &Places<'_>, unused: &Unused) -> serde_json::Value {
    let symbols: serde_json::Value = unused
        .symbols
        .iter()
        .map(|unused| {
            let overlaps: Vec<String> = unused.overlaps.iter().map(|memory| Target::Memory(*memory).spell(places.mnemonics)).collect();
            serde_json::json!({ "symbol": unused.symbol.name, "address": unused.symbol.address.trim(), "overlaps": overlaps })
        })
        .collect();
    let addresses: serde_json::Value = unused
        .addresses
        .iter()
        .map(|(target, first, count)| {
            serde_json::json!({ "address": target.spell(places.mnemonics), "uses": count, "first": places.reference_json(first) })
        })
        .collect();
    serde_json::json!({ "unused_symbols": symbols, "addresses_without_symbol": addresses })
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
