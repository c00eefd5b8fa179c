//! The first step: a source as its parser understood it.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, SourceFile, Span};

use crate::codesys_files;
use crate::declarations::reuse::Stamp;
use crate::language::{Contradiction, Language, contradiction};
use crate::library::link::Mention;
use crate::options::Options;
use crate::st;
use crate::st::ast::Item;
use crate::st::declare::StFile;
use crate::st::dialect::Dialect;
use crate::st::untold::Untold;
use crate::stl;
use crate::stl::declare::links::mentions;

/// A parsed source.
#[derive(Clone, Debug)]
pub(super) struct Syntax {
    pub(super) tree: Tree,
    /// What the parser has to say.
    pub(super) diagnostics: Vec<Diagnostic>,
    /// The first bytes of its errors, in their order.
    errors: Vec<u32>,
    /// Which syntax everything outside of its blocks is.
    pub(super) rest: u64,
}

/// What a parser makes of a source.
#[derive(Clone, Debug)]
pub(super) enum Tree {
    Stl(StlFile),
    St(StFile, Untold),
    /// A test file, and tests are not asked for.
    Test,
}

/// A source of STL.
#[derive(Clone, Debug)]
pub(super) struct StlFile {
    pub(super) id: FileId,
    pub(super) file: stl::ast::File,
    pub(super) mnemonics: Mnemonics,
    /// The stamps of its blocks.
    pub(super) stamps: Vec<Stamp>,
    /// What each block mentions that may come from the library.
    pub(super) mentions: Vec<Vec<Mention>>,
    /// The statements of each block that call an instance by its data block.
    pub(super) instances: Vec<Vec<usize>>,
}

/// Gives stamps.
#[derive(Debug, Default)]
pub(super) struct Stamps {
    last: u64,
}

impl Stamps {
    /// A stamp that nothing has.
    pub(super) fn next(&mut self) -> u64 {
        self.last += 1;
        self.last
    }
}

impl Syntax {
    /// Parses a source; `before` is what was parsed there last, whose blocks keep their stamps where they are the same. A test file is
    /// written in the dialect of the program.
    pub(super) fn parse(
        id: FileId,
        source: &SourceFile,
        language: Language,
        options: &Options,
        before: Option<&Self>,
        stamps: &mut Stamps,
    ) -> Self {
        let mut syntax = match language {
            Language::Stl | Language::Diagram(_) => {
                let parsed = stl::parser::parse_as(id, &source.text, options.mnemonics, language.drawing());
                Self::of_stl(id, &source.text, parsed, before, stamps)
            }
            Language::St(_) if language.is_of_tests() && !options.tests => {
                let message = format!("`{}` is a test file, and tests are no part of a program", source.name);
                let diagnostics = vec![Diagnostic::new(Problem::P6240, Span::new(id, 0, 0), message)];
                Self { tree: Tree::Test, diagnostics, errors: Vec::new(), rest: 0 }
            }
            Language::St(dialect) => {
                let read = codesys_files::read(id, &source.name, &source.text);
                let text = read.as_ref().map_or(&source.text, |read| &read.text);
                let mut parsed = st::parser::parse(id, text, dialect);
                let untold = Untold::of(id, &parsed, text);
                if dialect == Dialect::Codesys {
                    st::declare::name_lists(&mut parsed.file, &source.name);
                }
                let file = StFile { dialect, file: Arc::new(st::declare::expand(parsed.file)), library: None, stamps: Arc::from([]) };
                let mut diagnostics = parsed.diagnostics;
                diagnostics.extend(read.iter().flat_map(|read| read.diagnostics.iter().cloned()));
                Self::of_st(text, file, untold, diagnostics, before, stamps)
            }
        };
        if let Some(Contradiction { place: (start, end), is, named }) = contradiction(&source.name, &source.text) {
            let name = source.name.rsplit(['/', '\\']).next().unwrap_or_default();
            let message =
                format!("`{name}` is read as {is}, though its name says {named}: this is a line of {is}, and no line is one of {named}");
            syntax.diagnostics.push(Diagnostic::new(Problem::P6076, Span::new(id, start as u32, end as u32), message));
        }
        syntax
    }

    /// A source of STL that is parsed.
    pub(super) fn of_stl(id: FileId, text: &str, parsed: stl::parser::Parsed, before: Option<&Self>, stamps: &mut Stamps) -> Self {
        let stl::parser::Parsed { file, mnemonics, diagnostics, .. } = parsed;
        let mentions = file.blocks.iter().map(mentions).collect();
        let calls_instance =
            |statement: &stl::ast::Statement| matches!(&statement.operand, stl::ast::Operand::Call(call) if call.instance.is_some());
        let of_block = |block: &stl::ast::Block| {
            block.statements.iter().enumerate().filter(|(_, statement)| calls_instance(statement)).map(|(index, _)| index).collect()
        };
        let instances = file.blocks.iter().map(of_block).collect();
        let before = before.and_then(|before| match &before.tree {
            Tree::Stl(stl) if stl.mnemonics == mnemonics => Some(Known::new(&stl.file.blocks, &stl.stamps, &before.errors)),
            _ => None,
        });
        let errors = errors(&diagnostics);
        let blocks: Vec<&stl::ast::Block> = file.blocks.iter().collect();
        let of_blocks = stamped(&blocks, text, &errors, before, stamps);
        let stl = StlFile { id, file, mnemonics, stamps: of_blocks, mentions, instances };
        Self { tree: Tree::Stl(stl), diagnostics, errors, rest: 0 }
    }

    /// A source of ST that is parsed.
    pub(super) fn of_st(
        text: &str,
        file: StFile,
        untold: Untold,
        diagnostics: Vec<Diagnostic>,
        before: Option<&Self>,
        stamps: &mut Stamps,
    ) -> Self {
        let before = before.and_then(|before| match &before.tree {
            Tree::St(known, _) if known.dialect == file.dialect => Some((before, known)),
            _ => None,
        });
        let errors = errors(&diagnostics);
        let (blocks, rest) = take_apart(&file.file.items);
        let (known, same_rest) = match before {
            Some((before, known)) => {
                let (blocks, of_before) = take_apart(&known.file.items);
                (Some(Known::new(blocks, &known.stamps, &before.errors)), (of_before == rest).then_some(before.rest))
            }
            None => (None, None),
        };
        let of_blocks = stamped(&blocks, text, &errors, known, stamps);
        let rest = same_rest.unwrap_or_else(|| stamps.next());
        let file = StFile { stamps: of_blocks.into(), ..file };
        Self { tree: Tree::St(file, untold), diagnostics, errors, rest }
    }

    /// Whether the parser found something wrong in a place.
    pub(super) fn is_reported(&self, span: Span) -> bool {
        let first = self.errors.partition_point(|&start| start < span.start);
        self.errors.get(first).is_some_and(|&start| start < span.end.max(span.start + 1))
    }
}

/// The first bytes of errors, in their order.
fn errors(diagnostics: &[Diagnostic]) -> Vec<u32> {
    let errors = diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error);
    let mut errors: Vec<u32> = errors.map(|diagnostic| diagnostic.span.start).collect();
    errors.sort_unstable();
    errors
}

/// What stands in these places.
fn written(text: &str, places: impl IntoIterator<Item = Span>) -> u64 {
    let mut hasher = DefaultHasher::new();
    for span in places {
        text.get(span.start as usize..span.end as usize).hash(&mut hasher);
    }
    hasher.finish()
}

/// A block of any language, as far as its stamp is concerned.
trait Stamped: PartialEq {
    /// Where it stands.
    fn span(&self) -> Span;
    /// Where its declarations stand.
    fn sections(&self) -> impl Iterator<Item = Span>;
}

impl Stamped for stl::ast::Block {
    fn span(&self) -> Span {
        self.span
    }

    fn sections(&self) -> impl Iterator<Item = Span> {
        self.sections.iter().map(|section| section.span)
    }
}

impl Stamped for st::ast::Block {
    fn span(&self) -> Span {
        self.span
    }

    fn sections(&self) -> impl Iterator<Item = Span> {
        self.sections.iter().map(|section| section.span)
    }
}

/// The blocks of a source before its text became another one, with their stamps.
struct Known<'a, B> {
    blocks: Vec<(&'a B, Stamp)>,
    errors: &'a [u32],
}

impl<'a, B> Known<'a, B> {
    fn new(blocks: impl IntoIterator<Item = &'a B>, stamps: &[Stamp], errors: &'a [u32]) -> Self {
        Self { blocks: blocks.into_iter().zip(stamps.iter().copied()).collect(), errors }
    }
}

/// The stamps of blocks: that of the same block of before, or a new one. Blocks that were put in or taken out move the others.
fn stamped<B: Stamped>(blocks: &[&B], text: &str, errors: &[u32], before: Option<Known<'_, B>>, stamps: &mut Stamps) -> Vec<Stamp> {
    let (old, old_errors) = before.map_or((Vec::new(), &[][..]), |known| (known.blocks, known.errors));
    let moved = blocks.len() as isize - old.len() as isize;
    let stamp = |(index, block): (usize, &&B)| {
        let written_now = written(text, [block.span()]);
        let is_same = |(old, stamp): &&(&B, Stamp)| {
            let same_errors = || errors_in(errors, block.span()) == errors_in(old_errors, block.span());
            stamp.text == written_now && *old == *block && same_errors()
        };
        let mut candidates = [Some(index), index.checked_add_signed(-moved)].into_iter().flatten().filter_map(|at| old.get(at));
        match candidates.find(is_same) {
            Some(&(_, stamp)) => stamp,
            None => Stamp { syntax: stamps.next(), text: written_now, declarations: written(text, block.sections()) },
        }
    };
    blocks.iter().enumerate().map(stamp).collect()
}

/// The errors in a block.
fn errors_in(errors: &[u32], block: Span) -> &[u32] {
    let first = errors.partition_point(|&start| start < block.start);
    let end = errors.partition_point(|&start| start <= block.end);
    &errors[first..end]
}

/// Something of a source of ST that is no block.
#[derive(PartialEq)]
enum Rest<'a> {
    Item(&'a Item),
    Namespace(&'a st::ast::Path),
    EndOfNamespace,
}

/// The blocks of a source in their order, and everything else.
fn take_apart(items: &[Item]) -> (Vec<&st::ast::Block>, Vec<Rest<'_>>) {
    let (mut blocks, mut rest) = (Vec::new(), Vec::new());
    collect(items, &mut blocks, &mut rest);
    (blocks, rest)
}

fn collect<'a>(items: &'a [Item], blocks: &mut Vec<&'a st::ast::Block>, rest: &mut Vec<Rest<'a>>) {
    for item in items {
        match item {
            Item::Block(block) => blocks.push(block),
            Item::Namespace(namespace) => {
                rest.push(Rest::Namespace(&namespace.name));
                collect(&namespace.items, blocks, rest);
                rest.push(Rest::EndOfNamespace);
            }
            other => rest.push(Rest::Item(other)),
        }
    }
}
