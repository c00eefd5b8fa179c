//! Places in sources and names of blocks, as reference data prints them.

use std::collections::HashMap;

use sieben_ide::cross_reference::Reference;
use sieben_ide::target::Target;
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Span};

use crate::project::Build;

/// A program with what is needed to print its places.
pub(crate) struct Places<'a> {
    build: &'a Build,
    /// Names of blocks that no source of the user names: functions of the CPU and blocks of the library.
    other_names: HashMap<BlockId, &'static str>,
    /// The bytes at which the lines of each source end.
    line_ends: HashMap<FileId, Vec<usize>>,
    /// The language for addresses: German if every source is.
    pub(crate) mnemonics: Mnemonics,
}

impl<'a> Places<'a> {
    /// Looks through the sources once.
    pub(crate) fn new(build: &'a Build) -> Self {
        let ends = |text: &str| text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n').map(|(index, _)| index).collect();
        let line_ends = build.project.texts.program.iter().map(|(id, source)| (id, ends(&source.text))).collect();
        let mut languages = build.compiled.mnemonics.values().peekable();
        let german = languages.peek().is_some() && languages.all(|language| *language == Mnemonics::German);
        let system = sieben_cpu::system::interfaces().into_iter().map(|block| (block.block, block.name));
        let library = build.compiled.library.iter().map(|linked| (linked.id, linked.block.name));
        let other_names = system.chain(library).collect();
        Self { build, other_names, line_ends, mnemonics: if german { Mnemonics::German } else { Mnemonics::English } }
    }

    /// The line of a place, from 1.
    pub(crate) fn line(&self, span: Span) -> usize {
        self.line_ends.get(&span.file).map_or(0, |ends| ends.partition_point(|&end| end < span.start as usize)) + 1
    }

    /// The file of a place as the user named it.
    pub(crate) fn file(&self, span: Span) -> &'a str {
        &self.build.project.texts.program.file(span.file).name
    }

    /// `main.awl:12`.
    pub(crate) fn place(&self, span: Span) -> String {
        format!("{}:{}", self.file(span), self.line(span))
    }

    /// The first line of what stands there, with single blanks.
    pub(crate) fn text(&self, span: Span) -> String {
        let text = self.build.project.texts.program.slice(span);
        text.lines().next().unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// The symbol of a target, or nothing.
    ///
    /// A function of the CPU or block of the library that has no symbol has its own name.
    pub(crate) fn symbol(&self, target: &Target) -> String {
        let symbol = target.symbol(&self.build.project.symbols, &self.build.compiled.program.data);
        symbol.unwrap_or_else(|| match target {
            Target::Block(block) => self.other_names.get(block).copied().unwrap_or_default().to_owned(),
            _ => String::new(),
        })
    }

    /// The symbol of a block, or nothing.
    pub(crate) fn block_symbol(&self, block: BlockId) -> String {
        self.symbol(&Target::Block(block))
    }

    /// `FC 1` or `FC 1 (Dosing)`.
    pub(crate) fn block(&self, block: BlockId) -> String {
        match self.block_symbol(block) {
            symbol if symbol.is_empty() => block.to_string(),
            symbol => format!("{block} ({symbol})"),
        }
    }

    /// A reference as JSON.
    pub(crate) fn reference_json(&self, reference: &Reference) -> serde_json::Value {
        let mut value = serde_json::json!({
            "block": reference.block.to_string(),
            "network": reference.network,
            "statement": reference.statement,
            "file": self.file(reference.span),
            "line": self.line(reference.span),
            "type": reference.usage.word(),
            "instruction": reference.instruction.mnemonic(self.mnemonics),
            "text": self.text(reference.span),
        });
        if let Some(parameter) = &reference.parameter {
            value["parameter"] = serde_json::Value::from(parameter.as_str());
        }
        value
    }
}
