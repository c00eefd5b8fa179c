//! The blocks of a program as a tree of calls, and each of them with its networks.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Value, json};
use sieben_ide::call_structure::{CallStructure, Callee};
use sieben_ide::drawing::flow::{Executed, Status};
use sieben_ide::drawing::svg::{Picture, svg};
use sieben_ide::target::Target;
use sieben_lang::body::CheckedBody;
use sieben_lang::stl::convert::{Translated, translations};
use sieben_model::address::Operand;
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};
use sieben_workbench::{View, word};
use sieben_workspace::Refusal;
use sieben_workspace::places::Places;
use sieben_workspace::project::Build;

use crate::diagrams::{CodeBlock, Diagrams, Form};

/// What begins an organization block.
fn group(block: BlockId) -> &'static str {
    match block.number {
        1 | 90 => "cyclic",
        100..=102 => "restart",
        80..=88 | 121 | 122 => "error",
        _ => "interrupt",
    }
}

/// The blocks in the order of the tree: what begins it, then what that calls; data blocks last.
pub(super) fn list(build: &Build) -> Value {
    let (places, structure) = (Places::new(build), CallStructure::new(&build.compiled));
    let diagrams = Diagrams::new(build, &places);
    let titles: BTreeMap<BlockId, &CodeBlock> = diagrams.blocks().collect();
    let instances = instances(&structure);
    let head = |block: BlockId, group: &str, depth: usize| {
        json!({
            "block": word(block), "title": titles.get(&block).and_then(|block| block.title.clone()).unwrap_or_default(),
            "symbol": places.block_symbol(block), "language": language(build, block), "group": group, "depth": depth,
            "instances": instances.get(&block).cloned().unwrap_or_default(),
        })
    };
    let mut known = BTreeSet::new();
    let mut heads = Vec::new();
    let mut add = |lines: Vec<sieben_ide::call_structure::Line<'_>>, group: &str| {
        for line in lines {
            if let Callee::Block(block) = line.callee
                && build.compiled.bodies.contains_key(&block)
                && known.insert(block)
            {
                heads.push(head(block, group, line.depth));
            }
        }
    };
    structure.roots.iter().for_each(|&root| add(structure.tree(root), group(root)));
    structure.not_called_trees().into_iter().for_each(|tree| add(tree, "not-called"));
    let data = build.compiled.program.data.keys().map(|&number| BlockId::db(number));
    heads.extend(data.map(|block| head(block, "data", 0)));
    Value::Array(heads)
}

/// The instances that each function block is called with.
fn instances(structure: &CallStructure) -> BTreeMap<BlockId, Vec<String>> {
    let mut found: BTreeMap<BlockId, Vec<String>> = BTreeMap::new();
    for site in structure.blocks.values().flat_map(|caller| &caller.calls) {
        if let (Callee::Block(block), Some(Target::Block(instance))) = (&site.callee, &site.instance) {
            let known = found.entry(*block).or_default();
            if !known.contains(&word(*instance)) {
                known.push(word(*instance));
            }
        }
    }
    found
}

fn language(build: &Build, block: BlockId) -> &'static str {
    match build.compiled.bodies.get(&block).map(AsRef::as_ref) {
        Some(CheckedBody::Stl(_)) => "STL",
        Some(CheckedBody::St(_)) => "ST",
        None => "DB",
    }
}

/// How networks are shown in a view.
pub(super) fn form(view: View) -> Form {
    match view {
        View::Stl => Form::Stl,
        View::Lad => Form::Lad,
        View::Fbd => Form::Fbd,
    }
}

/// A network while it is collected.
#[derive(Default)]
struct Network {
    statements: Vec<Value>,
    title: String,
    comment: String,
    drawn: Option<Value>,
    reason: Option<String>,
}

/// A block with its networks.
pub(super) fn block(build: &Build, block: BlockId, (view, mnemonics): (View, Option<Mnemonics>)) -> Result<Value, Refusal> {
    let Some(code) = build.compiled.program.code.get(&block) else {
        return Err(Refusal::new(Problem::P7095, format!("{block} has no statements in this program")));
    };
    let places = Places::new(build);
    let diagrams = Diagrams::new(build, &places);
    let mut networks: BTreeMap<u32, Network> = BTreeMap::new();
    let spelling = Spelling::of(build, code.spans.first().map(|span| span.file), mnemonics);
    let body = build.compiled.bodies.get(&block);
    for (number, &span) in (0_u32..).zip(&code.spans) {
        if body.is_some_and(|body| !body.is_written(number)) {
            continue;
        }
        let network = body.and_then(|body| body.network(number)).unwrap_or(1);
        let stated = body.and_then(|body| body.stated(number));
        networks.entry(network).or_default().statements.push(statement(build, (&places, &spelling), (span, number), stated));
    }
    let code_block = diagrams.blocks().find(|(id, _)| *id == block).map(|(_, block)| block);
    for written in code_block.map_or(&[][..], |block| &block.networks) {
        let network = networks.entry(written.number).or_default();
        network.title = written.title.clone().unwrap_or_default();
        network.comment = written.comment.clone().unwrap_or_default();
        // With a status there is room for values.
        let nothing = Status { statements: vec![Executed::default(); written.statements.len()] };
        let shown = diagrams.shown(block, written, form(view), Some(&nothing));
        let picture = shown.layout.as_ref().map(|layout| svg(&Picture { title: &shown.title, layout, flows: None }));
        network.drawn = picture.map(Value::String);
        network.reason = shown.reason;
    }
    let form_word = View::ALL.iter().find(|(_, one)| *one == view).map_or("stl", |(word, _)| word);
    let json_of = |(number, network): (u32, Network)| {
        let mut object = json!({
            "n": number, "title": network.title, "comment": network.comment, "view": if network.drawn.is_some() { form_word } else { "stl" },
            "statements": network.statements,
        });
        if let Some(drawn) = network.drawn {
            object["svg"] = drawn;
        }
        if let Some(reason) = network.reason {
            object["reason"] = reason.into();
        }
        object
    };
    let instances = instances(&CallStructure::new(&build.compiled));
    let is_text = matches!(build.compiled.bodies.get(&block).map(AsRef::as_ref), Some(CheckedBody::St(_)));
    Ok(json!({
        "lines": is_text.then(|| source_lines(build, &code.spans)), "block": word(block), "title": code_block.and_then(|block| block.title.clone()).unwrap_or_default(),
        "symbol": places.block_symbol(block), "language": language(build, block),
        "instances": instances.get(&block).cloned().unwrap_or_default(),
        "networks": networks.into_iter().map(json_of).collect::<Vec<_>>(),
    }))
}

/// The lines of a source of Structured Text from the first statement of a block to its last one, each with its number.
fn source_lines(build: &Build, spans: &[Span]) -> Vec<Value> {
    let texts = &build.project.texts.program;
    let Some(first) = spans.iter().find(|span| (span.file.0 as usize) < texts.iter().len()) else { return Vec::new() };
    let text = &texts.file(first.file).text;
    let starts = || spans.iter().filter(|span| span.file == first.file && span.start < span.end).map(|span| span.start as usize);
    let (Some(begin), Some(end)) = (starts().min(), starts().max()) else { return Vec::new() };
    let mut lines = Vec::new();
    let mut at = 0;
    for (number, line) in (1_u32..).zip(text.split_inclusive('\n')) {
        let next = at + line.len();
        if next > begin && at <= end {
            lines.push(json!([number, line.trim_end()]));
        }
        at = next;
    }
    lines
}

/// In which mnemonics the statements of a block are shown.
struct Spelling {
    shown: Mnemonics,
    /// Words of its source that are others then.
    words: Vec<Translated>,
}

impl Spelling {
    fn of(build: &Build, file: Option<FileId>, wanted: Option<Mnemonics>) -> Self {
        let written = file.and_then(|file| build.compiled.mnemonics.get(&file)).copied();
        let (Some(file), Some(from), Some(shown)) = (file, written, wanted.filter(|&wanted| Some(wanted) != written)) else {
            return Self { shown: wanted.or(written).unwrap_or_default(), words: Vec::new() };
        };
        let texts = &build.project.texts.program;
        let text = texts.iter().find(|&(id, _)| id == file).map_or("", |(_, file)| &file.text);
        Self { shown, words: translations(text, Some(from), shown, None) }
    }

    /// The first line of a statement that stands at this byte of its source, with single spaces.
    fn spelled(&self, text: &str, start: usize) -> String {
        let text = text.lines().next().unwrap_or_default();
        let end = start + text.len();
        let first = self.words.partition_point(|(range, _)| range.start < start);
        let (mut out, mut at) = (String::with_capacity(text.len()), start);
        for (range, word) in self.words.iter().skip(first).take_while(|(range, _)| range.end <= end) {
            out.push_str(text.get(at - start..range.start - start).unwrap_or_default());
            out.push_str(word);
            at = range.end;
        }
        out.push_str(text.get(at - start..).unwrap_or_default());
        out.split_whitespace().collect::<Vec<_>>().join(" ")
    }
}

/// A statement: line, label, operation, operand with its symbol, comment.
fn statement(build: &Build, (places, spelling): (&Places<'_>, &Spelling), (span, number): (Span, u32), stated: Option<&str>) -> Value {
    let texts = &build.project.texts.program;
    let is_there = (span.file.0 as usize) < texts.iter().len();
    let text = match stated {
        Some(stated) => stated.to_owned(),
        None if is_there => spelling.spelled(texts.slice(span), span.start as usize),
        None => String::new(),
    };
    let text = text.trim().trim_end_matches(';').trim_end();
    let (operation, operand) = text.split_once(' ').map_or((text, ""), |(operation, operand)| (operation, operand.trim()));
    let symbols = &build.project.symbols;
    let plain = operand.trim_matches('"');
    let meant = if operand.starts_with('"') { symbols.operand(plain) } else { Operand::parse(operand) };
    let symbol = meant.as_ref().and_then(|meant| symbols.find_operand(meant));
    let mut object = json!({
        "number": number, "line": if is_there { places.line(span) } else { 0 }, "op": operation,
        "operand": if operand.starts_with('"') { meant.as_ref().map_or_else(|| operand.to_owned(), |meant| meant.spell(spelling.shown)) } else { operand.to_owned() },
        "symbol": symbol.map_or("", |symbol| &symbol.name),
    });
    if let Some(address) = meant.filter(|meant| !matches!(meant, Operand::Block(_))) {
        object["address"] = address.spell(Mnemonics::English).into();
    }
    if let Some(label) = is_there.then(|| label(build, span)).flatten() {
        object["label"] = label.into();
    }
    let own = is_there.then(|| comment(build, span)).flatten();
    let of_symbol = symbol.map(|symbol| symbol.comment.trim().to_owned()).filter(|text| !text.is_empty());
    if let Some(comment) = own.or(of_symbol) {
        object["comment"] = comment.into();
    }
    object
}

/// The label before a statement.
fn label(build: &Build, span: Span) -> Option<String> {
    let before = build.project.texts.program.file(span.file).text.get(..span.start as usize)?.trim_end();
    let name = before.strip_suffix(':')?.trim_end();
    let begin = name.rfind(|c: char| !c.is_alphanumeric() && c != '_').map_or(0, |at| at + 1);
    name.get(begin..).filter(|label| !label.is_empty()).map(str::to_owned)
}

/// The comment after a statement, on its line.
fn comment(build: &Build, span: Span) -> Option<String> {
    let line = build.project.texts.program.file(span.file).text.get(span.end as usize..)?.lines().next()?;
    let after = line.trim_start().trim_start_matches(';').trim_start();
    after.strip_prefix("//").map(|comment| comment.trim().to_owned()).filter(|comment| !comment.is_empty())
}
