//! Places in sources and names of blocks, as reference data prints them.

use std::borrow::Cow;
use std::collections::HashMap;

use sieben_ide::cross_reference::Reference;
use sieben_ide::target::{Memory, Target};
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Span};

use crate::project::Build;

/// What is looked up to print the places of a program, found once.
#[derive(Clone, Debug)]
pub struct Index {
    /// Names of blocks that no source of the user names: functions of the CPU and blocks of the library.
    other_names: HashMap<BlockId, &'static str>,
    /// The bytes at which the lines of each source end.
    line_ends: HashMap<FileId, Vec<usize>>,
    mnemonics: Mnemonics,
}

/// A program with what is needed to print its places.
pub struct Places<'a> {
    build: &'a Build,
    index: Cow<'a, Index>,
    /// The language for addresses: German if every source is.
    pub mnemonics: Mnemonics,
}

impl Index {
    /// Looks through the sources once.
    pub fn new(build: &Build) -> Self {
        let ends = |text: &str| text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n').map(|(index, _)| index).collect();
        let line_ends = build.project.texts.program.iter().map(|(id, source)| (id, ends(&source.text))).collect();
        let mut languages = build.compiled.mnemonics.values().peekable();
        let german = languages.peek().is_some() && languages.all(|language| *language == Mnemonics::German);
        let system = sieben_cpu::system::interfaces().into_iter().map(|block| (block.block, block.name));
        let library = build.compiled.library.iter().map(|linked| (linked.id, linked.block.name));
        let other_names = system.chain(library).collect();
        Self { other_names, line_ends, mnemonics: if german { Mnemonics::German } else { Mnemonics::English } }
    }
}

impl<'a> Places<'a> {
    /// Looks through the sources once.
    pub fn new(build: &'a Build) -> Self {
        let index = Index::new(build);
        Self { build, mnemonics: index.mnemonics, index: Cow::Owned(index) }
    }

    /// The same with what was looked up before, of the same program.
    pub fn with(build: &'a Build, index: &'a Index) -> Self {
        Self { build, mnemonics: index.mnemonics, index: Cow::Borrowed(index) }
    }

    /// The line of a place, from 1.
    pub fn line(&self, span: Span) -> usize {
        self.index.line_ends.get(&span.file).map_or(0, |ends| ends.partition_point(|&end| end < span.start as usize)) + 1
    }

    /// The file of a place as the user named it.
    pub fn file(&self, span: Span) -> &'a str {
        &self.build.project.texts.program.file(span.file).name
    }

    /// `main.awl:12`.
    pub fn place(&self, span: Span) -> String {
        format!("{}:{}", self.file(span), self.line(span))
    }

    /// The first line of what stands there, with single blanks.
    pub fn text(&self, span: Span) -> String {
        let text = self.build.project.texts.program.slice(span);
        text.lines().next().unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// The statement of a reference, in ST the line that it stands on.
    pub fn statement(&self, reference: &Reference) -> String {
        let span = reference.span;
        if reference.instruction.is_some() {
            return self.text(span);
        }
        let text = &self.build.project.texts.program.file(span.file).text;
        let line = text.lines().nth(self.line(span) - 1).unwrap_or_default();
        line.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// The symbol of a target, or nothing.
    ///
    /// A function of the CPU or block of the library that has no symbol has its own name.
    pub fn symbol(&self, target: &Target) -> String {
        let symbol = target.symbol(&self.build.project.symbols, &self.build.compiled.program.data);
        let names = &self.build.compiled.block_names;
        match (target, symbol) {
            // A data block of ST has its name from the source.
            (Target::Memory(Memory { db: Some(db), .. }), Some(symbol)) => {
                let name = names.get(&BlockId::db(*db));
                let path = symbol.strip_prefix(&format!("DB{db}")).filter(|path| path.is_empty() || path.starts_with('.'));
                name.zip(path).map_or(symbol.clone(), |(name, path)| format!("{name}{path}"))
            }
            (_, Some(symbol)) => symbol,
            (Target::Block(block), None) => {
                let name = self.index.other_names.get(block).copied().or_else(|| names.get(block).map(String::as_str));
                name.unwrap_or_default().to_owned()
            }
            (target, None) => {
                let operand = target.operand();
                let located = &self.build.compiled.program.names.located;
                let found =
                    located.iter().filter(|(name, (place, _))| Some(*place) == operand && !name.contains('.')).map(|(name, _)| name).min();
                found.cloned().unwrap_or_default()
            }
        }
    }

    /// What the variables of programs and global lists of ST are called without the name of their data block.
    pub fn plain_name(&self, target: &Target) -> Option<String> {
        let Target::Memory(Memory { db: Some(db), .. }) = target else { return None };
        let open = self.build.compiled.program.names.open.contains(db);
        open.then(|| self.symbol(target)).and_then(|name| name.split_once('.').map(|(_, path)| path.to_owned()))
    }

    /// The symbol of a block, or nothing.
    pub fn block_symbol(&self, block: BlockId) -> String {
        self.symbol(&Target::Block(block))
    }

    /// `FC 1` or `FC 1 (Dosing)`.
    pub fn block(&self, block: BlockId) -> String {
        match self.block_symbol(block) {
            symbol if symbol.is_empty() => block.to_string(),
            symbol => format!("{block} ({symbol})"),
        }
    }

    /// A reference as JSON.
    pub fn reference_json(&self, reference: &Reference) -> serde_json::Value {
        let mut value = serde_json::json!({
            "block": reference.block.to_string(),
            "network": reference.network,
            "statement": reference.statement,
            "file": self.file(reference.span),
            "line": self.line(reference.span),
            "type": reference.usage.word(),
            "instruction": reference.instruction.map(|instruction| instruction.mnemonic(self.mnemonics)),
            "text": self.statement(reference),
        });
        if let Some(parameter) = &reference.parameter {
            value["parameter"] = serde_json::Value::from(parameter.as_str());
        }
        value
    }
}
