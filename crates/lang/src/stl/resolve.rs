//! Operands as written → operands with all names resolved.

mod extension;

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use sieben_model::address::{self, Area, Width, area_and_width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::{Certainty, Diagnostic, Fix};
use sieben_model::extension::is_negative;
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::literal::Value;
use sieben_model::problems::Problem;
use sieben_model::source::{Sources, Span};
use sieben_model::types::DataType;

use super::ast;
use super::check::TemporaryReads;
use super::operands::{
    Access, Actual, AddressRegister, BlockOperand, Call, CallInstance, CallParameter, DataBlockInfo, Location, NumberOperand, Operand,
    StatusScan,
};
use crate::declarations::data_block::DataLayout;
use crate::declarations::interface::is_complex;
use crate::declarations::path::{FieldNames, follow};
use crate::declarations::types::{BlockInterface, describe};
use crate::declarations::values::{Misfit, coerce, natural};
use crate::library::link::Links;
use crate::library::{self, LibraryBlock, Selection};
use crate::scope::{Global, Scope, block_of_name, did_you_mean, key};

/// Names that a message lists before it says "and others".
const NAMES_SHOWN_MAX: usize = 8;

/// What is known about the whole program when statements are resolved.
pub(crate) struct Known<'a> {
    pub(crate) sources: &'a Sources,
    pub(crate) scope: &'a Scope,
    pub(crate) cpu: &'a CpuType,
    /// Interfaces of all code and system blocks that exist and could be laid out.
    pub(crate) interfaces: &'a HashMap<BlockId, BlockInterface>,
    /// Every block that exists, laid out or not.
    pub(crate) exists: &'a dyn Fn(BlockId) -> bool,
    /// Name of a system block that the CPU does not have, and what has it.
    pub(crate) only: &'a dyn Fn(BlockId) -> Option<(&'static str, &'static str)>,
    /// Layouts of the data blocks.
    pub(crate) data: &'a HashMap<u16, DataLayout>,
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
            ast::Operand::Constant(constant) => plain(Operand::Constant(constant.value.clone()?)),
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

    /// A name without quotes or `#`: a word of the language, a local, or a symbol.
    fn name(&mut self, word: &ast::Word, path: &[ast::PathElement], span: Span) -> Option<Meaning> {
        if path.is_empty()
            && let Some(operand) = keyword(&word.text)
        {
            return Some(Meaning::Operand(operand));
        }
        if let Some(&index) = self.locals.get(&key(&word.text)) {
            return self.local(index, path, span);
        }
        if self.known.scope.global(&word.text).is_some() {
            return self.global(word, path, span);
        }
        if self.labels.contains_key(&word.text) {
            let message = format!("`{}` is a label; only a jump takes one", word.text);
            self.report(Problem::P4002, word.span, message);
            return None;
        }
        self.unknown_local(word);
        None
    }

    fn unknown_local(&mut self, word: &ast::Word) {
        let names = self.interface.variables.iter().map(|variable| variable.name.as_str());
        let nearest = self.known.scope.nearest(&word.text, names).or_else(|| self.known.scope.nearest_symbol(&word.text));
        let message = format!("`{}` is not declared in `{}`{}", word.text, self.id, did_you_mean(nearest.clone()));
        self.report(Problem::P3001, word.span, message);
        self.offer(word.span, nearest);
    }

    /// Offers to write the name that was probably meant, as the wrong one is written: with quotes, `#` or neither.
    fn offer(&mut self, span: Span, name: Option<String>) {
        let (Some(name), Some(diagnostic)) = (name, self.diagnostics.last_mut()) else { return };
        let replacement = match self.known.sources.slice(span).chars().next() {
            Some('"') => format!("\"{name}\""),
            Some('#') => format!("#{name}"),
            _ => name,
        };
        let title = format!("write `{replacement}`");
        diagnostic.fix = Some(Fix { span, replacement, title, certainty: Certainty::Guess });
    }

    fn address_of(&mut self, word: &ast::Word) -> Option<Operand> {
        let Some(&index) = self.locals.get(&key(&word.text)) else {
            self.unknown_local(word);
            return None;
        };
        let variable = &self.interface.variables[index];
        let area = match variable.section {
            Section::Temp => Area::Local,
            _ if self.id.kind == BlockKind::Function => return Some(Operand::ParameterAddress(variable.offset as u16)),
            _ => Area::InstanceData,
        };
        Some(Operand::Constant(Value::Pointer(u32::from(area.pointer_code()) << 24 | variable.offset)))
    }

    fn local(&mut self, index: usize, path: &[ast::PathElement], span: Span) -> Option<Meaning> {
        let interface = self.interface;
        let variable = &interface.variables[index];
        let base = self.location_of(variable);
        if let Some(number) = number_of(self.id, variable, &base)
            && path.is_empty()
        {
            let block = |kind| BlockOperand { kind, instance: false, number: number.clone() };
            return Some(Meaning::Operand(match variable.data_type {
                DataType::Timer => Operand::Timer(number),
                DataType::Counter => Operand::Counter(number),
                DataType::BlockFunction => Operand::Block(block(BlockKind::Function)),
                DataType::BlockFunctionBlock => Operand::Block(block(BlockKind::FunctionBlock)),
                _ => Operand::Block(block(BlockKind::DataBlock)),
            }));
        }
        // The declaration of such a name was wrong, which is reported there.
        if variable.data_type == DataType::Void {
            return None;
        }
        let reached = match follow(self.known.scope, self.known.field_names, &variable.data_type, path, span) {
            Ok(reached) => reached,
            Err(diagnostic) => {
                self.diagnostics.push(*diagnostic);
                return None;
            }
        };
        if reached.data_type == DataType::Void {
            return None;
        }
        let location = shifted(base, reached.offset as u32);
        Some(Meaning::Variable { location, data_type: reached.data_type, declared: true })
    }

    fn location_of(&self, variable: &Variable) -> Location {
        match variable.section {
            Section::Temp => Location::Fixed { area: Area::Local, position: variable.offset },
            _ if self.id.kind == BlockKind::Function => Location::Parameter {
                index: variable.offset as u16,
                offset: 0,
                complex: is_complex(&variable.data_type) || matches!(variable.data_type, DataType::Pointer | DataType::Any),
            },
            Section::InOut if is_complex(&variable.data_type) => Location::InstancePointer { position: variable.offset, offset: 0 },
            _ => Location::Instance { position: variable.offset },
        }
    }

    /// Resolves a symbol of the table with the path behind it.
    fn global(&mut self, name: &ast::Word, path: &[ast::PathElement], span: Span) -> Option<Meaning> {
        let Some(global) = self.known.scope.global(&name.text) else {
            let library = library::ALL.iter().map(|block| block.name).filter(|_| self.known.selection.enabled);
            let nearest = self.known.scope.nearest_symbol(&name.text).or_else(|| self.known.scope.nearest(&name.text, library));
            let message = format!("`\"{}\"` is not in the symbol table{}", name.text, did_you_mean(nearest.clone()));
            let help = library::by_name(&name.text).map(|block| self.why_not_linked(block));
            self.report(Problem::P3020, name.span, message).help = help;
            if library::by_name(&name.text).is_some() {
                return None;
            }
            self.offer(name.span, nearest);
            return None;
        };
        if global.ambiguous {
            let message = format!("`\"{}\"` stands in the symbol table more than once with different addresses", name.text);
            self.report(Problem::P3012, name.span, message);
            return None;
        }
        let meaning = match &global.operand {
            None => {
                let message = format!("`\"{}\"` has the address `{}`, which is not one", name.text, global.address);
                self.report(Problem::P3021, name.span, message);
                return None;
            }
            Some(address::Operand::Block(BlockId { kind: BlockKind::DataBlock, number })) if !path.is_empty() => {
                return self.field(*number, path, span);
            }
            Some(operand) => self.of_table(operand, global, span)?,
        };
        if !path.is_empty() {
            let message = format!("`\"{}\"` is `{}`, which has no fields", name.text, global.address);
            self.report(Problem::P4010, span, message);
            return None;
        }
        Some(meaning)
    }

    /// Why a name of the library does not stand for its block here, and what to do.
    fn why_not_linked(&self, block: &LibraryBlock) -> String {
        let LibraryBlock { block: number, name, .. } = block;
        if self.known.selection.enabled {
            format!(
                "`{name}` of the library is `{number}`, a number that has another block here: give it a free one in the symbol table, or in \
                 `sieben.toml` under `[library]` with `{name} = \"{} …\"`.",
                number.kind.abbreviation()
            )
        } else {
            format!("`{name}` would be `{number}` of the library, which `library = false` in `sieben.toml` switches off.")
        }
    }

    fn of_table(&mut self, operand: &address::Operand, global: &Global, span: Span) -> Option<Meaning> {
        let variable = |resolver: &mut Self, location, width| {
            let data_type = DataType::from_word(&global.data_type).filter(|data_type| data_type.width() == Some(width));
            resolver.check_area(&location, width, span);
            let declared = data_type.is_some();
            let data_type = data_type.unwrap_or_else(|| bare_type(width));
            Some(Meaning::Variable { location, data_type, declared })
        };
        match *operand {
            address::Operand::Address(address) => {
                let position = self.position(u64::from(address.byte), u32::from(address.bit), span)?;
                variable(self, Location::Fixed { area: address.area, position }, address.width)
            }
            address::Operand::InDataBlock { db, address } => {
                let position = self.position(u64::from(address.byte), u32::from(address.bit), span)?;
                variable(self, Location::InDataBlock { db, position }, address.width)
            }
            address::Operand::Timer(number) => Some(Meaning::Operand(self.timer(number, span))),
            address::Operand::Counter(number) => Some(Meaning::Operand(self.counter(number, span))),
            address::Operand::Block(block) => Some(Meaning::Operand(Self::block(block, false))),
        }
    }

    fn timer(&mut self, number: u16, span: Span) -> Operand {
        if number >= self.known.cpu.timers {
            let message = format!("`T {number}`: CPU {} has timers 0 to {}", self.known.cpu.name, self.known.cpu.timers - 1);
            self.report(Problem::P5004, span, message);
        }
        Operand::Timer(NumberOperand::Fixed(number))
    }

    fn counter(&mut self, number: u16, span: Span) -> Operand {
        if number >= self.known.cpu.counters {
            let message = format!("`{}`: CPU {} has counters 0 to {}", self.text(span), self.known.cpu.name, self.known.cpu.counters - 1);
            self.report(Problem::P5004, span, message);
        }
        Operand::Counter(NumberOperand::Fixed(number))
    }

    fn block(block: BlockId, instance: bool) -> Operand {
        Operand::Block(BlockOperand { kind: block.kind, instance, number: NumberOperand::Fixed(block.number) })
    }

    fn absolute(&mut self, written: &Written<'_>, span: Span) -> Option<Meaning> {
        let letters = written.letters.to_ascii_uppercase();
        let number = |resolver: &mut Self| match u16::try_from(written.number) {
            Ok(number) if written.bit.is_none() => Some(number),
            Ok(_) => {
                resolver.report(Problem::P4015, span, format!("`{letters}` takes one number, without a point"));
                None
            }
            Err(_) => {
                resolver.report(Problem::P4001, span, format!("`{letters} {}` has a number above 65535", written.number));
                None
            }
        };
        match letters.as_str() {
            "T" => return number(self).map(|number| Meaning::Operand(self.timer(number, span))),
            "C" | "Z" => return number(self).map(|number| Meaning::Operand(self.counter(number, span))),
            "DI" => return number(self).map(|number| Meaning::Operand(Self::block(BlockId::db(number), true))),
            _ => {}
        }
        if let Some(kind) = BlockKind::from_abbreviation(&letters) {
            let block = BlockId::new(kind, number(self)?);
            if is_negative(block) && !self.extended(span) {
                return None;
            }
            return Some(Meaning::Operand(Self::block(block, false)));
        }
        let (area, width, position) = self.area_address(written, span)?;
        let location = Location::Fixed { area, position };
        self.check_area(&location, width, span);
        Some(Meaning::Variable { location, data_type: bare_type(width), declared: false })
    }

    fn area_address(&mut self, written: &Written<'_>, span: Span) -> Option<(Area, Width, u32)> {
        let Some((area, width)) = area_and_width(written.letters) else {
            let message = match written.letters.to_ascii_uppercase().as_str() {
                "PI" | "PQ" | "PE" | "PA" => {
                    format!("the peripheral has no bits; `{}B`, `{}W` and `{}D` exist", written.letters, written.letters, written.letters)
                }
                _ => format!("`{}` is no memory area", written.letters),
            };
            self.report(Problem::P4015, span, message);
            return None;
        };
        let bit = match (width, written.bit) {
            (Width::Bit, Some(bit @ 0..=7)) => bit as u32,
            (Width::Bit, Some(bit)) => {
                self.report(Problem::P4015, span, format!("a byte has bits 0 to 7, not {bit}"));
                return None;
            }
            (Width::Bit, None) => {
                let message = format!("a bit has two numbers: `{} {}.0`", written.letters, written.number);
                self.report(Problem::P4015, span, message);
                return None;
            }
            (_, Some(_)) => {
                let message = format!("`{}` takes one number: `{} {}`", written.letters, written.letters, written.number);
                self.report(Problem::P4015, span, message);
                return None;
            }
            (_, None) => 0,
        };
        let position = self.position(written.number, bit, span)?;
        Some((area, width, position))
    }

    fn position(&mut self, byte: u64, bit: u32, span: Span) -> Option<u32> {
        if byte > 65_535 {
            self.report(Problem::P4001, span, format!("a byte address lies between 0 and 65535, not {byte}"));
            return None;
        }
        Some(byte as u32 * 8 + bit)
    }

    /// Warns of an address that the CPU type does not have: the statement would fail at run time.
    fn check_area(&mut self, location: &Location, width: Width, span: Span) {
        let cpu = self.known.cpu;
        let (position, limit, what) = match location {
            Location::Fixed { area, position } => {
                let limit = match area {
                    Area::Input | Area::Output => cpu.process_image,
                    Area::BitMemory => cpu.bit_memory,
                    Area::PeripheralInput | Area::PeripheralOutput => cpu.peripheral,
                    Area::Local | Area::CallerLocal => cpu.local_data_block,
                    Area::SharedData | Area::InstanceData => 65_536,
                };
                (*position, limit, Problem::P5001)
            }
            Location::InDataBlock { db, position } | Location::InInstanceBlock { db, position } => match self.known.data.get(db) {
                Some(layout) => (*position, layout.structure.size, Problem::P5005),
                None => {
                    if !(self.known.exists)(BlockId::db(*db)) {
                        let message = format!("`DB {db}` does not exist; the statement fails unless the program creates it");
                        self.report(Problem::P3018, span, message);
                    }
                    return;
                }
            },
            _ => return,
        };
        if position / 8 + width.bytes() <= limit {
            return;
        }
        let text = self.text(span).to_owned();
        let message = match (what, location) {
            (Problem::P5005, Location::InDataBlock { db, .. } | Location::InInstanceBlock { db, .. }) => {
                format!("`{text}` lies behind the end of `DB {db}`, which has {limit} bytes")
            }
            _ => format!("`{text}` lies outside the {limit} bytes that this area has in CPU {}", cpu.name),
        };
        self.report(what, span, message);
    }

    /// The data block that is named before a point.
    fn data_block(&mut self, name: &ast::BlockName) -> Option<u16> {
        match block_of_name(self.known.scope, name) {
            Ok(BlockId { kind: BlockKind::DataBlock, number }) => Some(number),
            Ok(other) => {
                self.report(Problem::P4002, name.span(), format!("`{other}` is not a data block"));
                None
            }
            Err(message) => {
                self.report(Problem::P3020, name.span(), message);
                None
            }
        }
    }

    fn in_block(&mut self, block: &ast::BlockName, instance: bool, written: &Written<'_>, span: Span) -> Option<Meaning> {
        let db = self.data_block(block)?;
        let (area, width, position) = self.area_address(written, span)?;
        let location = match (instance, area) {
            (false, Area::SharedData) => Location::InDataBlock { db, position },
            (true, Area::InstanceData) => Location::InInstanceBlock { db, position },
            _ => {
                let valid = if instance { "DIX, DIB, DIW or DID" } else { "DBX, DBB, DBW or DBD" };
                self.report(Problem::P4015, span, format!("behind the point stands {valid}, not `{}`", written.letters));
                return None;
            }
        };
        self.check_area(&location, width, span);
        Some(Meaning::Variable { location, data_type: bare_type(width), declared: false })
    }

    /// `"DB".field[3]`.
    fn field(&mut self, db: u16, path: &[ast::PathElement], span: Span) -> Option<Meaning> {
        let Some(layout) = self.known.data.get(&db) else {
            // A data block whose declaration is wrong is reported there.
            if !(self.known.exists)(BlockId::db(db)) {
                self.report(Problem::P3008, span, format!("`DB {db}` does not exist, so it has no fields"));
            }
            return None;
        };
        let whole = DataType::Struct(Arc::clone(&layout.structure));
        match follow(self.known.scope, self.known.field_names, &whole, path, span) {
            // The declaration of such a field was wrong, which is reported there.
            Ok(reached) if reached.data_type == DataType::Void => None,
            Ok(reached) => Some(Meaning::Variable {
                location: Location::InDataBlock { db, position: reached.offset as u32 },
                data_type: reached.data_type,
                declared: true,
            }),
            Err(diagnostic) => {
                self.diagnostics.push(*diagnostic);
                None
            }
        }
    }

    /// `MW [MD 4]`, `T [MW 2]`, `DB [MW 4]`.
    fn indirect(&mut self, letters: &str, pointer: &ast::Operand, pointer_span: Span, span: Span) -> Option<Meaning> {
        let upper = letters.to_ascii_uppercase();
        let number = match upper.as_str() {
            "T" | "C" | "Z" | "DB" | "DI" => true,
            _ => BlockKind::from_abbreviation(&upper).is_some(),
        };
        let wanted = if number { Width::Word } else { Width::DoubleWord };
        let location = Box::new(self.pointer(pointer, wanted, pointer_span)?);
        let number = NumberOperand::Indirect(location.clone());
        let block = |kind, instance| Operand::Block(BlockOperand { kind, instance, number: number.clone() });
        Some(Meaning::Operand(match upper.as_str() {
            "T" => Operand::Timer(number),
            "C" | "Z" => Operand::Counter(number),
            "DB" => block(BlockKind::DataBlock, false),
            "DI" => block(BlockKind::DataBlock, true),
            _ => match (BlockKind::from_abbreviation(&upper), area_and_width(&upper)) {
                (Some(kind @ (BlockKind::Function | BlockKind::FunctionBlock)), _) => block(kind, false),
                (None, Some((area, width))) => {
                    let location = Location::MemoryIndirect { area, pointer: location };
                    return Some(Meaning::Variable { location, data_type: bare_type(width), declared: false });
                }
                _ => {
                    let message = format!("`{letters}` cannot be addressed indirectly");
                    self.report(Problem::P4015, span, message);
                    return None;
                }
            },
        }))
    }

    /// The word or double word in which a pointer lies.
    fn pointer(&mut self, pointer: &ast::Operand, wanted: Width, span: Span) -> Option<Location> {
        let what = if wanted == Width::Word { "a word (MW, LW, DBW, DIW)" } else { "a double word (MD, LD, DBD, DID)" };
        match self.meaning(pointer, span)? {
            Meaning::Variable { location, data_type, .. } if data_type.width() == Some(wanted) => match location {
                Location::Fixed { area: Area::BitMemory | Area::Local | Area::SharedData | Area::InstanceData, .. }
                | Location::Instance { .. } => Some(location),
                Location::Parameter { .. } | Location::InstancePointer { .. } => {
                    let message = format!("the parameter `{}` cannot hold a pointer for an access", self.text(span));
                    self.report(Problem::P4014, span, message).help =
                        Some("Copy it to a variable of VAR_TEMP first and use that.".to_owned());
                    None
                }
                _ => {
                    let message = format!("a pointer lies in {what}, not in `{}`", self.text(span));
                    self.report(Problem::P4014, span, message);
                    None
                }
            },
            _ => {
                let message = format!("the pointer of this access is {what}, not `{}`", self.text(span));
                self.report(Problem::P4014, span, message);
                None
            }
        }
    }

    fn register_indirect(&mut self, letters: &str, register: &ast::Word, offset: &ast::Constant, span: Span) -> Option<Meaning> {
        let register = match register.text.to_ascii_uppercase().as_str() {
            "AR1" => AddressRegister::Ar1,
            "AR2" => AddressRegister::Ar2,
            other => {
                let message = format!("the address registers are `AR1` and `AR2`, not `{other}`");
                self.report(Problem::P4015, span, message);
                return None;
            }
        };
        let (area, width) = match letters.to_ascii_uppercase().as_str() {
            "" => (None, Width::Bit),
            "B" => (None, Width::Byte),
            "W" => (None, Width::Word),
            "D" => (None, Width::DoubleWord),
            upper => match area_and_width(upper) {
                Some((area, width)) => (Some(area), width),
                None => {
                    self.report(Problem::P4015, span, format!("`{letters}` is no memory area"));
                    return None;
                }
            },
        };
        let offset = match offset.value.as_ref()? {
            Value::Pointer(offset @ 0..=0x7FFF) => *offset,
            _ => {
                self.report(Problem::P4001, offset.span, "the offset lies between `P#0.0` and `P#4095.7`");
                return None;
            }
        };
        let location = Location::RegisterIndirect { area, register, offset };
        Some(Meaning::Variable { location, data_type: bare_type(width), declared: false })
    }

    /// What `CALL` calls, with all its parameters.
    pub(crate) fn call(&mut self, call: &ast::Call) -> Option<Operand> {
        let (callee, multi) = self.callee(call)?;
        if is_negative(callee) && !self.extended(call.callee_span) {
            return None;
        }
        let Some(BlockInterface { interface, .. }) = self.known.interfaces.get(&callee) else {
            if !(self.known.exists)(callee) {
                self.report(Problem::P3008, call.callee_span, format!("`{callee}` does not exist"));
            }
            return None;
        };
        let has_instance = matches!(callee.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock);
        let instance = match (multi, &call.instance) {
            (Some(position), None) => Some(CallInstance::Multi(position)),
            (Some(_), Some((_, span))) => {
                self.report(Problem::P3019, *span, "a multi-instance has its data in the instance of this block; write no data block");
                None
            }
            (None, Some((operand, span))) if has_instance => Some(CallInstance::DataBlock(self.instance_block(callee, operand, *span)?)),
            (None, None) if has_instance => {
                let message = format!("`{callee}` needs an instance: `CALL {callee}, DB 1`");
                self.report(Problem::P3019, call.callee_span, message);
                return None;
            }
            (None, Some((_, span))) => {
                self.report(Problem::P3019, *span, format!("`{callee}` has no instance; write no data block"));
                None
            }
            (None, None) => None,
        };
        let formals: HashSet<String> = interface.parameters().map(|parameter| key(&parameter.name)).collect();
        let mut arguments: HashMap<String, &ast::Argument> = HashMap::with_capacity(call.arguments.len());
        for argument in &call.arguments {
            // `x :=` without a value, as generated sources write an omitted parameter.
            if argument.value == ast::Operand::None || is_type_hint(argument, &formals) {
                continue;
            }
            if !formals.contains(&key(&argument.name.text)) {
                let names = interface.parameters().map(|parameter| parameter.name.as_str());
                let nearest = self.known.scope.nearest(&argument.name.text, names);
                let message = format!("`{callee}` has no parameter `{}`{}", argument.name.text, did_you_mean(nearest.clone()));
                let valid: Vec<&str> = interface.parameters().map(|parameter| parameter.name.as_str()).collect();
                let mut help = if valid.is_empty() {
                    format!("`{callee}` has no parameters.")
                } else {
                    format!("Its parameters are {}.", valid.join(", "))
                };
                if let Some(block) = self.known.library.get(&callee) {
                    help.push_str(&format!(" The project does not define it, so it is `{}` of the library.", block.name));
                }
                self.report(Problem::P3009, argument.name.span, message).help = Some(help);
                self.offer(argument.name.span, nearest);
                continue;
            }
            if let Some(first) = arguments.insert(key(&argument.name.text), argument) {
                let first = first.name.span;
                let message = format!("the parameter `{}` is given twice", argument.name.text);
                self.report(Problem::P3011, argument.name.span, message).related.push((first, "first given here".to_owned()));
            }
        }
        let mut parameters = Vec::new();
        let mut missing = Vec::new();
        for parameter in interface.parameters() {
            let actual = match arguments.get(&key(&parameter.name)) {
                Some(argument) => self.actual(argument, parameter),
                None => {
                    if !has_instance {
                        missing.push(format!("`{}`", parameter.name));
                    }
                    None
                }
            };
            parameters.push(CallParameter {
                name: parameter.name.clone(),
                span: arguments.get(&key(&parameter.name)).map_or(call.callee_span, |argument| argument.name.span.to(argument.span)),
                section: parameter.section,
                data_type: parameter.data_type.clone(),
                position: parameter.offset,
                actual,
            });
        }
        if !missing.is_empty() {
            let others = if missing.len() > NAMES_SHOWN_MAX { ", …" } else { "" };
            missing.truncate(NAMES_SHOWN_MAX);
            let message = format!("`{callee}` needs {}{others} too", missing.join(", "));
            let help = self.known.library.get(&callee).map(|block| {
                format!(
                    "The project does not define `{callee}`, so it is `{}` of the library. Give every parameter a variable.",
                    block.name
                )
            });
            self.report(Problem::P3010, call.callee_span, message).help = help;
        }
        // A parameter of a wrong type, reported at its declaration, leaves the call without a meaning.
        if interface.parameters().any(|parameter| parameter.data_type == DataType::Void) {
            return None;
        }
        Some(Operand::Call(Box::new(Call { callee, instance, parameters })))
    }

    /// The called block, and the position of the instance if it is a multi-instance.
    fn callee(&mut self, call: &ast::Call) -> Option<(BlockId, Option<u32>)> {
        let span = call.callee_span;
        if let Some(block) = plain_callee(self.known.scope, &call.callee) {
            // A local name without `#` goes before the symbol.
            let shadowed = matches!(&call.callee, ast::Operand::Name { word, .. } if self.locals.contains_key(&key(&word.text)));
            if !shadowed {
                return Some((block, None));
            }
        }
        match self.meaning(&call.callee, span)? {
            Meaning::Variable { location: Location::Instance { position }, data_type: DataType::Instance { block, .. }, .. } => {
                Some((block, Some(position)))
            }
            _ => {
                let message = format!("`CALL` takes an FC, FB, SFC, SFB or a multi-instance, not `{}`", self.text(span));
                self.report(Problem::P4002, span, message);
                None
            }
        }
    }

    fn instance_block(&mut self, callee: BlockId, operand: &ast::Operand, span: Span) -> Option<u16> {
        let Some(number) = plain_data_block(self.known.scope, operand) else {
            self.meaning(operand, span)?;
            let message = format!("the instance of `{callee}` is a data block, not `{}`", self.text(span));
            self.report(Problem::P3019, span, message);
            return None;
        };
        if number == 0 {
            self.report(Problem::P3019, span, "`DB 0` is reserved and cannot be an instance");
            return None;
        }
        if let Some(layout) = self.known.data.get(&number)
            && layout.based_on != Some(callee)
        {
            let message = match layout.based_on {
                Some(other) => format!("`DB {number}` is based on `{other}`, not on `{callee}`"),
                None => format!("`DB {number}` is not an instance of `{callee}`"),
            };
            self.report(Problem::P3017, span, message);
            return None;
        }
        Some(number)
    }

    fn actual(&mut self, argument: &ast::Argument, formal: &Variable) -> Option<Actual> {
        let span = argument.span;
        let meaning = self.meaning(&argument.value, span)?;
        // The declaration of the parameter was wrong, which is reported there.
        if formal.data_type == DataType::Void {
            return None;
        }
        let actual = match &formal.data_type {
            DataType::Timer => match meaning {
                Meaning::Operand(Operand::Timer(number)) => Ok(Actual::Timer(number)),
                _ => Err("a timer".to_owned()),
            },
            DataType::Counter => match meaning {
                Meaning::Operand(Operand::Counter(number)) => Ok(Actual::Counter(number)),
                _ => Err("a counter".to_owned()),
            },
            DataType::BlockFunction => block_actual(meaning, &[BlockKind::Function, BlockKind::SystemFunction], "an FC"),
            DataType::BlockFunctionBlock => block_actual(meaning, &[BlockKind::FunctionBlock, BlockKind::SystemFunctionBlock], "an FB"),
            DataType::BlockData | DataType::BlockSystemData => block_actual(meaning, &[BlockKind::DataBlock], "a data block"),
            DataType::Any => match meaning {
                Meaning::Operand(Operand::Constant(Value::Any(any))) => Ok(Actual::Constant(Value::Any(any))),
                Meaning::Operand(Operand::Timer(NumberOperand::Fixed(number))) => Ok(any_of_number(0x1D, number)),
                Meaning::Operand(Operand::Counter(NumberOperand::Fixed(number))) => Ok(any_of_number(0x1C, number)),
                other => self.whole(other).ok_or_else(|| "a variable or a pointer such as `P#DB5.DBX 0.0 BYTE 10`".to_owned()),
            },
            DataType::Pointer => match meaning {
                Meaning::Operand(Operand::Constant(value)) => match coerce(&value, &DataType::Pointer) {
                    Ok(value) => Ok(Actual::Constant(value)),
                    Err(_) => Err("a variable or a pointer such as `P#DB5.DBX 0.0`".to_owned()),
                },
                other => self.whole(other).ok_or_else(|| "a variable or a pointer such as `P#DB5.DBX 0.0`".to_owned()),
            },
            complex if is_complex(complex) => match self.whole(meaning) {
                Some(Actual::Complex { location, data_type }) if same_layout(complex, &data_type) => {
                    Ok(Actual::Complex { location, data_type })
                }
                _ => Err(match complex {
                    DataType::String(_) => "a STRING variable of any length".to_owned(),
                    other => format!("a variable of type {}", describe(other)),
                }),
            },
            _ => return self.elementary_actual(argument, formal, meaning),
        };
        match actual {
            Ok(actual) => Some(actual),
            Err(wanted) => {
                self.mismatch(argument, formal, &wanted);
                // A constant is what most people try first.
                if is_complex(&formal.data_type)
                    && matches!(argument.value, ast::Operand::Constant(_))
                    && let Some(diagnostic) = self.diagnostics.last_mut()
                {
                    diagnostic.help = Some(format!(
                        "The block gets a pointer, and a constant has no place: declare a {} with this initial value in a data block.",
                        describe(&formal.data_type)
                    ));
                }
                None
            }
        }
    }

    fn mismatch(&mut self, argument: &ast::Argument, formal: &Variable, wanted: &str) {
        let message = format!(
            "the parameter `{}` is {} and takes {wanted}, not `{}`",
            formal.name,
            describe(&formal.data_type),
            self.text(argument.span)
        );
        self.report(Problem::P4011, argument.span, message);
    }

    fn elementary_actual(&mut self, argument: &ast::Argument, formal: &Variable, meaning: Meaning) -> Option<Actual> {
        let span = argument.span;
        let width = formal.data_type.width()?;
        match meaning {
            Meaning::Operand(Operand::Constant(value)) => {
                if formal.section != Section::Input {
                    self.mismatch(argument, formal, "a variable that can be written");
                    return None;
                }
                match coerce(&value, &formal.data_type) {
                    Ok(fitting) => {
                        if !natural(&value, &formal.data_type) {
                            let message =
                                format!("`{}` is passed to `{}`, which is {}", self.text(span), formal.name, describe(&formal.data_type));
                            self.report(Problem::P4012, span, message);
                        }
                        Some(Actual::Constant(fitting))
                    }
                    Err(Misfit::Range) => {
                        let message = format!(
                            "`{}` is outside the range of `{}`, which is {}",
                            self.text(span),
                            formal.name,
                            describe(&formal.data_type)
                        );
                        self.report(Problem::P4001, span, message);
                        None
                    }
                    Err(Misfit::Type) => {
                        self.mismatch(argument, formal, "a constant or variable of that type");
                        None
                    }
                }
            }
            Meaning::Variable { location, data_type, declared } => {
                if data_type.width() != Some(width) {
                    let wanted = match width {
                        Width::Bit => "a bit",
                        Width::Byte => "a byte",
                        Width::Word => "a word",
                        Width::DoubleWord => "a double word",
                    };
                    self.mismatch(argument, formal, wanted);
                    return None;
                }
                let reads = matches!(formal.section, Section::Input | Section::InOut);
                let writes = formal.section != Section::Input;
                match location {
                    Location::Fixed { area: Area::PeripheralOutput, .. } if reads => {
                        self.mismatch(argument, formal, "something that can be read");
                        return None;
                    }
                    Location::Fixed { area: Area::PeripheralInput, .. } if writes => {
                        self.mismatch(argument, formal, "something that can be written");
                        return None;
                    }
                    _ => {}
                }
                if declared && !related(&data_type, &formal.data_type) {
                    let message = format!(
                        "`{}` is {}, the parameter `{}` is {}; the bits are passed as they are",
                        self.text(span),
                        describe(&data_type),
                        formal.name,
                        describe(&formal.data_type)
                    );
                    self.report(Problem::P4012, span, message);
                }
                Some(Actual::Memory(Access { width, location }))
            }
            Meaning::Operand(_) => {
                self.mismatch(argument, formal, "a constant or variable of that type");
                None
            }
        }
    }

    /// A variable of any type, or a whole data block, by place and type.
    fn whole(&self, meaning: Meaning) -> Option<Actual> {
        match meaning {
            Meaning::Variable { location, data_type, .. } => Some(Actual::Complex { location, data_type }),
            Meaning::Operand(Operand::Block(BlockOperand {
                kind: BlockKind::DataBlock,
                instance: false,
                number: NumberOperand::Fixed(db),
            })) => {
                let layout = self.known.data.get(&db)?;
                Some(Actual::Complex {
                    location: Location::InDataBlock { db, position: 0 },
                    data_type: DataType::Struct(Arc::clone(&layout.structure)),
                })
            }
            Meaning::Operand(_) => None,
        }
    }
}

/// The block of a CALL that names it itself, by number or symbol.
pub(crate) fn plain_callee(scope: &Scope, callee: &ast::Operand) -> Option<BlockId> {
    let block = match callee {
        ast::Operand::Absolute { letters, number, bit: None } => {
            BlockId::new(BlockKind::from_abbreviation(letters)?, u16::try_from(*number).ok()?)
        }
        ast::Operand::Symbol { name: word, path } | ast::Operand::Name { word, path } if path.is_empty() => {
            let global = scope.global(&word.text)?;
            if global.ambiguous {
                return None;
            }
            scope.block(&word.text)?
        }
        _ => return None,
    };
    let callable =
        matches!(block.kind, BlockKind::Function | BlockKind::FunctionBlock | BlockKind::SystemFunction | BlockKind::SystemFunctionBlock);
    callable.then_some(block)
}

/// The data block that an operand names itself, by number or symbol.
pub(crate) fn plain_data_block(scope: &Scope, operand: &ast::Operand) -> Option<u16> {
    match operand {
        ast::Operand::Absolute { letters, number, bit: None } if letters.eq_ignore_ascii_case("DB") => u16::try_from(*number).ok(),
        ast::Operand::Symbol { name: word, path } | ast::Operand::Name { word, path } if path.is_empty() => {
            match scope.block(&word.text)? {
                BlockId { kind: BlockKind::DataBlock, number } => Some(number),
                _ => None,
            }
        }
        _ => None,
    }
}

/// The ANY of one timer or counter: its type, one of it, and its number in place of an address.
fn any_of_number(type_code: u8, number: u16) -> Actual {
    let [high, low] = number.to_be_bytes();
    Actual::Constant(Value::Any([0x10, type_code, 0, 1, 0, 0, 0, 0, high, low]))
}

/// `time_type := Time`: TIA writes the types of some calls before their parameters. They choose nothing that the block does not say itself.
fn is_type_hint(argument: &ast::Argument, formals: &HashSet<String>) -> bool {
    let name = key(&argument.name.text);
    let hint = name.len() > "_type".len() && name.get(name.len() - "_type".len()..).is_some_and(|end| end.eq_ignore_ascii_case("_type"));
    hint && !formals.contains(&name) && matches!(&argument.value, ast::Operand::Name { path, .. } if path.is_empty())
}

fn block_actual(meaning: Meaning, kinds: &[BlockKind], wanted: &str) -> Result<Actual, String> {
    match meaning {
        Meaning::Operand(Operand::Block(block)) if kinds.contains(&block.kind) => Ok(Actual::Block(block.number)),
        _ => Err(wanted.to_owned()),
    }
}

/// The number of a timer, counter or block that a parameter stands for.
fn number_of(id: BlockId, variable: &Variable, base: &Location) -> Option<NumberOperand> {
    match variable.data_type {
        DataType::Timer
        | DataType::Counter
        | DataType::BlockFunction
        | DataType::BlockFunctionBlock
        | DataType::BlockData
        | DataType::BlockSystemData => Some(match id.kind {
            BlockKind::Function => NumberOperand::Parameter(variable.offset as u16),
            _ => NumberOperand::Indirect(Box::new(base.clone())),
        }),
        _ => None,
    }
}

fn shifted(location: Location, bits: u32) -> Location {
    match location {
        Location::Fixed { area, position } => Location::Fixed { area, position: position + bits },
        Location::InDataBlock { db, position } => Location::InDataBlock { db, position: position + bits },
        Location::InInstanceBlock { db, position } => Location::InInstanceBlock { db, position: position + bits },
        Location::Parameter { index, offset, complex } => Location::Parameter { index, offset: offset + bits, complex },
        Location::InstancePointer { position, offset } => Location::InstancePointer { position, offset: offset + bits },
        Location::Instance { position } => Location::Instance { position: position + bits },
        other @ (Location::MemoryIndirect { .. } | Location::RegisterIndirect { .. }) => other,
    }
}

/// The type of an address of which only the width is known.
fn bare_type(width: Width) -> DataType {
    match width {
        Width::Bit => DataType::Bool,
        Width::Byte => DataType::Byte,
        Width::Word => DataType::Word,
        Width::DoubleWord => DataType::DoubleWord,
    }
}

/// Whether two elementary types of one width may be exchanged without a remark: bit strings carry anything.
fn related(actual: &DataType, formal: &DataType) -> bool {
    let bits = |data_type: &DataType| matches!(data_type, DataType::Bool | DataType::Byte | DataType::Word | DataType::DoubleWord);
    actual == formal || bits(actual) || bits(formal)
}

/// Whether a complex variable can stand for a parameter: the same kind of type with the same layout, names aside.
fn same_layout(formal: &DataType, actual: &DataType) -> bool {
    match (formal, actual) {
        (DataType::String(_), DataType::String(_)) => true,
        (DataType::Array { bounds: a, element: x }, DataType::Array { bounds: b, element: y }) => {
            a.len() == b.len() && formal.elements() == actual.elements() && same_layout(x, y)
        }
        (DataType::Struct(a) | DataType::Instance { structure: a, .. }, DataType::Struct(b) | DataType::Instance { structure: b, .. }) => {
            Arc::ptr_eq(a, b)
                || (a.size == b.size
                    && a.fields.len() == b.fields.len()
                    && a.fields.iter().zip(&b.fields).all(|(a, b)| a.offset == b.offset && same_layout(&a.data_type, &b.data_type)))
        }
        _ => formal == actual,
    }
}

fn keyword(word: &str) -> Option<Operand> {
    Some(match word.to_ascii_uppercase().as_str() {
        "==0" => Operand::Status(StatusScan::Zero),
        "<>0" => Operand::Status(StatusScan::NonZero),
        ">0" => Operand::Status(StatusScan::Positive),
        "<0" => Operand::Status(StatusScan::Negative),
        ">=0" => Operand::Status(StatusScan::NotNegative),
        "<=0" => Operand::Status(StatusScan::NotPositive),
        "UO" => Operand::Status(StatusScan::Unordered),
        "OV" => Operand::Status(StatusScan::Overflow),
        "OS" => Operand::Status(StatusScan::StoredOverflow),
        "BR" | "BIE" => Operand::Status(StatusScan::BinaryResult),
        "STW" => Operand::StatusWord,
        "DBLG" => Operand::DataBlockInfo(DataBlockInfo::SharedLength),
        "DBNO" => Operand::DataBlockInfo(DataBlockInfo::SharedNumber),
        "DILG" => Operand::DataBlockInfo(DataBlockInfo::InstanceLength),
        "DINO" => Operand::DataBlockInfo(DataBlockInfo::InstanceNumber),
        "AR2" => Operand::AddressRegister2,
        _ => return None,
    })
}
