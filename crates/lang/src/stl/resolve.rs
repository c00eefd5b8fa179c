//! Operands as written → operands with all names resolved.

mod addresses;
mod calls;
mod extension;
mod names;
mod parameters;

use std::collections::HashMap;

use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Interface;
use sieben_model::literal::Value;
use sieben_model::problems::Problem;
use sieben_model::source::{Sources, Span};
use sieben_model::types::DataType;

use crate::calling::pointers::IN_DATA_BLOCK;
use crate::declarations::data_block::DataLayout;
use crate::declarations::types::{BlockInterface, describe};
use crate::library::Selection;
use crate::library::link::Links;
use crate::scope::{Scope, did_you_mean, key};
use crate::stl::ast;
use crate::stl::check::TemporaryReads;
use crate::stl::declare::path::FieldNames;
use crate::stl::diagrams::first_scratch_bit;
use crate::stl::operands::{Access, Location, Operand};
pub(crate) use calls::{plain_callee, plain_data_block};

/// What is known about the whole program when statements are resolved.
pub(crate) struct Known<'a> {
    pub(crate) sources: &'a Sources,
    pub(crate) scope: &'a Scope,
    pub(crate) cpu: &'a CpuType,
    /// The blocks of the program, of which it is noted which ones are asked for.
    pub(crate) blocks: &'a dyn Blocks,
    pub(crate) field_names: &'a FieldNames,
    /// Which reads of temporary variables are reported.
    pub(crate) temporaries: TemporaryReads,
    /// The blocks that come from the library.
    pub(crate) library: &'a Links,
    /// What the project takes from the library.
    pub(crate) selection: &'a Selection,
    /// Whether extension words may be used.
    pub(crate) extended: bool,
}

/// The blocks of a program as the statements of one of them see them.
pub(crate) trait Blocks {
    /// The interface of a code or system block that exists and could be laid out.
    fn interface(&self, id: BlockId) -> Option<&BlockInterface>;
    /// Whether a block exists, laid out or not.
    fn exists(&self, id: BlockId) -> bool;
    /// The layout of a data block.
    fn data(&self, number: u16) -> Option<&DataLayout>;
    /// Name of a system block that the CPU does not have, and what has it.
    fn only(&self, id: BlockId) -> Option<(&'static str, &'static str)>;
}

/// What an operand stands for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Meaning {
    /// Something that is no variable.
    Operand(Operand),
    /// A variable of any type.
    Variable {
        location: Location,
        data_type: DataType,
        /// The type is declared, not guessed from the width of an address.
        declared: bool,
    },
}

/// Resolves the operands of one block.
pub(crate) struct Resolver<'a> {
    known: &'a Known<'a>,
    id: BlockId,
    interface: &'a Interface,
    locals: HashMap<String, usize>,
    labels: &'a HashMap<String, u32>,
    /// The declared type of the last operand, if it was a variable with one.
    pub(crate) declared: Option<DataType>,
    /// It was said that the program is not extended.
    extension_reported: bool,
    pub(crate) diagnostics: Vec<Diagnostic>,
}

/// Letters, number and bit of an absolute address.
struct Written<'w> {
    letters: &'w str,
    number: u64,
    bit: Option<u64>,
}

impl<'a> Resolver<'a> {
    pub(crate) fn new(known: &'a Known<'a>, id: BlockId, interface: &'a Interface, labels: &'a HashMap<String, u32>) -> Self {
        let mut locals = HashMap::with_capacity(interface.variables.len());
        for (index, variable) in interface.variables.iter().enumerate() {
            locals.entry(key(&variable.name)).or_insert(index);
        }
        Self { known, id, interface, locals, labels, declared: None, extension_reported: false, diagnostics: Vec::new() }
    }

    fn report(&mut self, problem: Problem, span: Span, message: impl Into<String>) -> &mut Diagnostic {
        self.diagnostics.push(Diagnostic::new(problem, span, message));
        self.diagnostics.last_mut().expect("one was pushed")
    }

    fn text(&self, span: Span) -> &'a str {
        self.known.sources.slice(span).trim()
    }

    /// The operand of a statement; `None` if something was wrong, which is reported.
    pub(crate) fn operand(&mut self, operand: &ast::Operand, span: Span) -> Option<Operand> {
        match self.meaning(operand, span)? {
            Meaning::Operand(operand) => Some(operand),
            Meaning::Variable { location, data_type, declared } => match data_type.width() {
                Some(width) => {
                    self.declared = declared.then_some(data_type);
                    Some(Operand::Memory(Access { width, location }))
                }
                None => {
                    let message = format!(
                        "`{}` is {}, which does not fit an accumulator; name one of its elements",
                        self.text(span),
                        describe(&data_type)
                    );
                    self.report(Problem::P4002, span, message);
                    None
                }
            },
        }
    }

    /// A label as the operand of a jump.
    pub(crate) fn label(&mut self, operand: &ast::Operand, span: Span) -> Option<Operand> {
        let ast::Operand::Name { word, path } = operand else {
            if !matches!(operand, ast::Operand::Error) {
                let message = match operand {
                    ast::Operand::None => "a jump needs a label".to_owned(),
                    _ => format!("a jump needs a label of this block, not `{}`", self.text(span)),
                };
                self.report(Problem::P4002, span, message);
            }
            return None;
        };
        if path.is_empty()
            && let Some(&target) = self.labels.get(&word.text)
        {
            return Some(Operand::Label(target));
        }
        let nearest = self.known.scope.nearest(&word.text, self.labels.keys().map(String::as_str));
        let message = format!("there is no label `{}` in this block{}", word.text, did_you_mean(nearest.clone()));
        self.report(Problem::P3004, word.span, message);
        self.offer(word.span, nearest);
        None
    }

    fn meaning(&mut self, operand: &ast::Operand, span: Span) -> Option<Meaning> {
        let plain = |operand| Some(Meaning::Operand(operand));
        match operand {
            ast::Operand::None => plain(Operand::None),
            ast::Operand::Error => None,
            ast::Operand::Constant(constant) => {
                if constant.extended && !self.extended_notation(span) {
                    return None;
                }
                plain(Operand::Constant(constant.value.clone()?))
            }
            ast::Operand::PointerTo { target, span: at } => {
                let (_, position, _) = self.pointed_to(target, *at, span)?;
                plain(Operand::Constant(Value::Pointer(IN_DATA_BLOCK | position)))
            }
            ast::Operand::AddressOf(word) => self.address_of(word).map(Meaning::Operand),
            ast::Operand::Absolute { letters, number, bit } => self.absolute(&Written { letters, number: *number, bit: *bit }, span),
            ast::Operand::InBlock { block, instance, letters, number, bit } => {
                self.in_block(block, *instance, &Written { letters, number: *number, bit: *bit }, span)
            }
            ast::Operand::BlockField { block, path } => {
                let db = self.data_block(block)?;
                self.field(db, path, span)
            }
            ast::Operand::Symbol { name, path } => self.global(name, path, span),
            ast::Operand::Local { name, path } => match self.locals.get(&key(&name.text)) {
                Some(&index) => self.local(index, path, span),
                None => {
                    self.unknown_local(name);
                    None
                }
            },
            ast::Operand::Indirect { letters, pointer, pointer_span } => self.indirect(letters, pointer, *pointer_span, span),
            ast::Operand::RegisterIndirect { letters, register, offset } => self.register_indirect(letters, register, offset, span),
            ast::Operand::Name { word, path } => self.name(word, path, span),
            ast::Operand::Register { name, number } => {
                let operand = super::extension::operand(&name.text, *number)?;
                self.extended(span).then_some(Meaning::Operand(operand))
            }
            ast::Operand::Scratch { bit } => {
                let position = first_scratch_bit(self.interface, self.id.kind).saturating_add(*bit);
                let location = Location::Fixed { area: Area::Local, position };
                self.check_area(&location, Width::Bit, span);
                Some(Meaning::Variable { location, data_type: DataType::Bool, declared: false })
            }
            ast::Operand::List(_) => {
                self.report(Problem::P4002, span, "only an extension word takes several operands");
                None
            }
            ast::Operand::Call(_) => {
                self.report(Problem::P4002, span, "only `CALL` takes a block with parameters");
                None
            }
        }
    }
}
