//! What stands in the sources of blocks: titles, comments, networks with their statements, and each network as a diagram.

use std::collections::HashMap;

use sieben_lang::network::model::Network;
use sieben_lang::network::read::{Answer, Mode};
use sieben_lang::network::reasons::Refusal;
use sieben_lang::network::to_lad::to_lad;
use sieben_lang::st::diagrams::drawn;
use sieben_lang::st::diagrams::pins::{Pins, name_pins};
use sieben_lang::stl::ast::Word;
use sieben_lang::stl::diagrams::DrawnNetwork;
use sieben_lang::stl::redraw::{SourceBlock, statement_line};
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;
use sieben_workspace::project::Build;

use super::sources::block_numbered;
use super::{Blocks, CodeBlock, ElementPlaces, Written, sources};

/// The blocks of STL of the user, with what stands in their sources.
pub(crate) fn blocks(build: &Build) -> Blocks {
    let mut blocks = Blocks::new();
    for (_, source) in sources(build) {
        for block in source.blocks(Mode::Strict) {
            blocks.insert(block.id, code_block(block, source.text, source.mnemonics));
        }
    }
    of_structured_text(build, &mut blocks);
    blocks
}

/// Adds the bodies of Structured Text that are diagrams.
fn of_structured_text(build: &Build, blocks: &mut Blocks) {
    let bodies = &build.compiled.bodies;
    // The data block of a program has its name too.
    let with_code = build.compiled.block_names.iter().filter(|(id, _)| bodies.contains_key(id));
    let names: HashMap<String, BlockId> = with_code.map(|(&id, name)| (name.to_lowercase(), id)).collect();
    let block = |name: &str| {
        let by_number = || block_numbered(name).filter(|id| bodies.contains_key(id));
        names.get(&name.to_lowercase()).copied().or_else(by_number)
    };
    for file in &build.project.sources {
        let Some(dialect) = file.language(build.project.settings.dialect).dialect() else { continue };
        let pins = |name: &str| {
            let own = block(name.trim_matches('"')).and_then(|id| Some(Pins::of_block(id, bodies.get(&id)?.interface())));
            own.or_else(|| Pins::of_standard(name, dialect))
        };
        for mut network in drawn::networks(file.id, &build.project.texts.program.file(file.id).text, dialect) {
            if let Some(id) = block(&network.block) {
                name_pins(&mut network.network, &pins);
                blocks.entry(id).or_default().networks.push(drawn_network(network, file.id));
            }
        }
    }
}

/// A network of a body of Structured Text that is a diagram.
fn drawn_network(network: drawn::DrawnNetwork, file: FileId) -> Written {
    Written {
        number: network.number,
        title: some(&network.title),
        comment: some(&network.comment),
        numbers: Vec::new(),
        statements: Vec::new(),
        places: ElementPlaces::Bytes(file, network.span.start),
        read: Ok(network.network),
        text: String::new(),
    }
}

fn some(text: &str) -> Option<String> {
    Some(text.trim().to_owned()).filter(|text| !text.is_empty())
}

fn code_block(block: SourceBlock, text: &str, mnemonics: Mnemonics) -> CodeBlock {
    let lines = LineStarts::of(text);
    let header = &block.header;
    let rows = [("Author", &header.author), ("Family", &header.family), ("Name", &header.name), ("Version", &header.version)];
    let row = |(name, value): (&str, &Option<Word>)| Some((name.to_owned(), value.as_ref()?.text.clone()));
    CodeBlock {
        title: header.title.as_ref().and_then(|title| some(&title.text)),
        comment: some(&header.comment),
        header: rows.into_iter().filter_map(row).collect(),
        networks: block.networks.into_iter().map(|network| written(network, text, mnemonics, &lines)).collect(),
    }
}

fn written(network: DrawnNetwork, text: &str, mnemonics: Mnemonics, lines: &LineStarts) -> Written {
    let as_text = statements_text(&network, text, mnemonics);
    let read = match network.answer {
        Answer::Exact(ref drawn) => Ok(drawn.clone()),
        Answer::Equivalent(ref reading, None) => Ok(reading.networks.first().cloned().unwrap_or_default()),
        Answer::Equivalent(_, Some(ref refusal)) | Answer::No(ref refusal) => Err(reason(&network, refusal, text, lines)),
    };
    Written {
        number: network.number,
        title: some(&network.title),
        comment: some(&network.comment),
        numbers: network.numbers,
        statements: network.statements,
        places: ElementPlaces::Statements(network.spans),
        read,
        text: as_text,
    }
}

/// Why a network stays STL: the statement, its line, what is in the way, and what to do about it.
fn reason(network: &DrawnNetwork, refusal: &Refusal, text: &str, lines: &LineStarts) -> String {
    let fix = refusal.reason.fix();
    let fix = if fix.is_empty() { String::new() } else { format!("; {fix}") };
    let Some(span) = network.spans.get(refusal.statement) else { return format!("{}{fix}", refusal.message()) };
    let statement = text.get(span.start as usize..span.end as usize).and_then(|text| text.lines().next()).unwrap_or_default();
    let statement = statement.split_whitespace().collect::<Vec<_>>().join(" ");
    format!("`{statement}` (line {}), {}: {}{fix}", lines.line(span.start), refusal.reason, refusal.message())
}

/// The first bytes of the lines of a source.
struct LineStarts(Vec<u32>);

impl LineStarts {
    fn of(text: &str) -> Self {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Self(ends.map(|(at, _)| u32::try_from(at + 1).unwrap_or(u32::MAX)).collect())
    }

    /// The line of a byte, from 1.
    fn line(&self, byte: u32) -> usize {
        self.0.partition_point(|start| *start <= byte) + 1
    }
}

/// The network as ladder can show it.
pub(super) fn for_ladder(network: &Network) -> Result<Network, String> {
    let fixed = |refusal: Refusal| match refusal.reason.fix() {
        "" => refusal.message(),
        fix => format!("{}; {fix}", refusal.message()),
    };
    to_lad(network).map(|(network, _)| network).map_err(fixed)
}

/// The statements of a network: as the source has them, with its comments, or those that a diagram stands for.
fn statements_text(network: &DrawnNetwork, text: &str, mnemonics: Mnemonics) -> String {
    if network.drawing.is_some() {
        return network.statements.iter().map(|one| statement_line(one, mnemonics)).collect::<Vec<_>>().join("\n");
    }
    if network.statements.is_empty() {
        return String::new();
    }
    let (first, last) = (network.body.start as usize, network.body.end as usize);
    let begin = text.get(..first).and_then(|before| before.rfind('\n')).map_or(0, |at| at + 1);
    let end = text.get(last..).and_then(|after| after.find('\n')).map_or(text.len(), |at| last + at);
    text.get(begin..end).unwrap_or_default().trim_end().to_owned()
}
