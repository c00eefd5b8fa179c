//! The names in a source of STL.

use sieben_model::address::{Area, Operand as Address, area_and_width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Section;
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::{FileId, Span};

use super::ast::{Argument, Block, BlockName, Call, Constant, Declaration, Initial, Operand, PathElement, Statement, TypeKind, TypeName};
use super::instructions::Instruction;
use super::operands::OperandClass;
use super::parser::parse_as;
use crate::access::Direction;
use crate::names::{Access, Builder, Bytes, DefinitionKind, SourceNames, TypeRef, Written};
use crate::network::flavour::Drawing;

/// The names of a source.
pub(crate) fn names(text: &str, mnemonics: Option<Mnemonics>, drawing: Option<Drawing>) -> SourceNames {
    let parsed = parse_as(FileId::default(), text, mnemonics, drawing);
    let mut collector = Collector { to: Builder::new(text, Some(parsed.mnemonics)), mnemonics: parsed.mnemonics };
    parsed.file.blocks.iter().for_each(|block| collector.block(block));
    collector.to.finish()
}

struct Collector<'t> {
    to: Builder<'t>,
    mnemonics: Mnemonics,
}

/// What a block of a kind is.
fn kind_of(kind: BlockKind) -> DefinitionKind {
    match kind {
        BlockKind::OrganizationBlock => DefinitionKind::OrganizationBlock,
        BlockKind::Function | BlockKind::SystemFunction => DefinitionKind::Function,
        BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock => DefinitionKind::FunctionBlock,
        BlockKind::DataBlock => DefinitionKind::DataBlock,
        BlockKind::UserDefinedType => DefinitionKind::Type,
    }
}

/// A block by its number, if there can be one.
fn block_id(kind: BlockKind, number: u64) -> Option<BlockId> {
    u16::try_from(number).ok().map(|number| BlockId::new(kind, number))
}

impl Collector<'_> {
    fn block(&mut self, block: &Block) {
        let kind = kind_of(block.kind);
        let whole = bytes(block.span);
        let index = match &block.name {
            BlockName::Absolute { kind: written, number, span } => {
                let id = block_id(*written, *number);
                let name = id.map_or_else(|| block.kind.abbreviation().to_owned(), |id| id.to_string());
                let place = if block.implicit { Bytes { start: whole.start, end: whole.start } } else { bytes(*span) };
                let index = self.to.define_at(kind, &name, place, whole);
                self.to.definition(index).operand = id.map(Address::Block);
                index
            }
            BlockName::Symbol(word) => self.to.define(kind, &word.text, word.span, block.span),
        };
        self.to.definition(index).comment = block.header.title.as_ref().map(|title| title.text.trim().to_owned()).unwrap_or_default();
        (self.to.scope, self.to.parent) = (Some(index), Some(index));
        for section in &block.sections {
            let kind = match section.section {
                Section::Input => DefinitionKind::Input,
                Section::Output => DefinitionKind::Output,
                Section::InOut => DefinitionKind::InOut,
                Section::Static => DefinitionKind::Static,
                Section::Temp => DefinitionKind::Temp,
                Section::Return => DefinitionKind::Result,
            };
            section.declarations.iter().for_each(|declaration| self.declaration(declaration, kind));
        }
        if let Some(result) = block.return_type.as_ref().filter(|result| !matches!(&result.kind, TypeKind::Word(word) if word == "VOID")) {
            let place = Bytes { start: result.span.start, end: result.span.start };
            let variable = self.to.define_at(DefinitionKind::Result, "RET_VAL", place, bytes(result.span));
            self.typed(variable, result);
        }
        if let Some(body) = &block.body_type {
            match &body.kind {
                TypeKind::Struct(fields) => {
                    self.to.definition(index).of = TypeRef::Inline;
                    fields.iter().for_each(|field| self.declaration(field, DefinitionKind::Field));
                }
                _ => self.typed(index, body),
            }
        }
        for assignment in &block.assignments {
            if let Some((PathElement::Field(word), path)) = assignment.path.split_first()
                && let Some(first) = self.to.name(&word.text, word.span, Written::Local, Access::Write)
            {
                self.path(first, path, Access::Write);
            }
            assignment.values.iter().for_each(|value| self.initial(value));
        }
        if let (Some(first), Some(last)) = (block.statements.first(), block.statements.last()) {
            let start = first.label.as_ref().map_or(first.span.start, |label| label.span.start.min(first.span.start));
            self.to.definition(index).body = Bytes { start, end: last.span.end };
        }
        for statement in &block.statements {
            if let Some(label) = &statement.label
                && self.to.locate(label.span, &label.text).is_some()
            {
                self.to.define(DefinitionKind::Label, &label.text, label.span, label.span);
            }
        }
        block.statements.iter().for_each(|statement| self.statement(statement));
        (self.to.scope, self.to.parent) = (None, None);
    }

    fn declaration(&mut self, declaration: &Declaration, kind: DefinitionKind) {
        let mut first = None;
        for word in &declaration.names {
            let index = self.to.define(kind, &word.text, word.span, declaration.span);
            self.to.definition(index).comment = declaration.comment.trim().to_owned();
            match first {
                None => self.typed(index, &declaration.data_type),
                Some(first) => self.to.share_type(index, first),
            }
            first = first.or(Some(index));
        }
        declaration.initial.iter().for_each(|value| self.initial(value));
    }

    /// The type of a definition.
    fn typed(&mut self, index: u32, data_type: &TypeName) {
        let written = self.to.text().get(data_type.span.start as usize..data_type.span.end as usize).unwrap_or_default();
        let is_struct = matches!(data_type.kind, TypeKind::Struct(_));
        let one_line = if is_struct { "STRUCT".to_owned() } else { one_line(written) };
        self.to.definition(index).data_type = one_line;
        let of = self.members(index, data_type);
        self.to.definition(index).of = of;
    }

    /// Where the members of a type are.
    fn members(&mut self, index: u32, data_type: &TypeName) -> TypeRef {
        match &data_type.kind {
            TypeKind::Word(_) | TypeKind::String(_) | TypeKind::Missing => TypeRef::None,
            TypeKind::Array { element, .. } => self.members(index, element),
            TypeKind::Struct(fields) => {
                let parent = self.to.parent.replace(index);
                fields.iter().for_each(|field| self.declaration(field, DefinitionKind::Field));
                self.to.parent = parent;
                TypeRef::Inline
            }
            TypeKind::Block(kind, number) => {
                let Some(id) = block_id(*kind, *number) else { return TypeRef::None };
                self.to.operand(Address::Block(id), data_type.span, Access::Type);
                TypeRef::Block(id)
            }
            TypeKind::Symbol(name) => {
                self.to.name(name, data_type.span, Written::Global, Access::Type);
                TypeRef::Named(self.to.id(name))
            }
        }
    }

    fn initial(&mut self, value: &Initial) {
        match value {
            Initial::Value(_) => {}
            Initial::Number { operand, span } => _ = self.operand(operand, *span, Access::Address),
            Initial::Repeat { values, .. } => values.iter().for_each(|value| self.initial(value)),
        }
    }

    fn statement(&mut self, statement: &Statement) {
        let rows = || Instruction::candidates(&statement.mnemonic.text, self.mnemonics);
        let access = match rows().find_map(Instruction::direction) {
            Some(Direction::Read) => Access::Read,
            Some(Direction::Write) => Access::Write,
            Some(Direction::ReadWrite) => Access::ReadWrite,
            None if rows().any(|row| matches!(row.operand(), OperandClass::CallBlock | OperandClass::Call)) => Access::Call,
            None if rows().any(|row| row.operand() == OperandClass::OpenBlock) => Access::Open,
            None if rows().any(|row| row.operand() == OperandClass::Label) => Access::Jump,
            None => Access::Read,
        };
        if let (Operand::Name { word, path }, Access::Jump) = (&statement.operand, access)
            && path.is_empty()
        {
            self.to.label(&word.text, word.span);
            return;
        }
        self.operand(&statement.operand, statement.operand_span, access);
    }

    /// The names of an operand; gives the last one of its path.
    fn operand(&mut self, operand: &Operand, span: Span, access: Access) -> Option<u32> {
        match operand {
            Operand::None | Operand::Error | Operand::Register { .. } | Operand::Scratch { .. } => None,
            Operand::Constant(constant) => self.constant(constant, span),
            Operand::AddressOf(word) => self.to.name(&word.text, word.span, Written::Local, Access::Address),
            Operand::PointerTo { target, span } => self.operand(target, *span, Access::Address),
            Operand::Absolute { letters, number, bit } => {
                let access =
                    if access == Access::Read && BlockKind::from_abbreviation(letters).is_some() { Access::Address } else { access };
                let operand = absolute(letters, *number, *bit, span, self.to.text())?;
                self.to.operand(operand, span, access)
            }
            Operand::InBlock { block, letters, number, bit, .. } => {
                let of = self.block_name(block, Access::Open)?;
                let Some(Address::Address(address)) = spelled(letters, *number, *bit) else { return Some(of) };
                // The address stands after the point.
                let start = block.span().end;
                let place = Bytes { start: (start + 1).min(span.end), end: span.end };
                Some(self.to.push(place, Written::InBlock(of, address), access))
            }
            Operand::BlockField { block, path } => {
                let first = self.block_name(block, Access::Open)?;
                Some(self.path(first, path, access))
            }
            Operand::Symbol { name, path } => {
                let first = self.to.name(&name.text, name.span, Written::Global, access)?;
                Some(self.path(first, path, access))
            }
            Operand::Local { name, path } => {
                let first = self.to.name(&name.text, name.span, Written::Local, access)?;
                Some(self.path(first, path, access))
            }
            Operand::Name { word, path } => {
                let first = self.to.name(&word.text, word.span, Written::Plain, access)?;
                Some(self.path(first, path, access))
            }
            Operand::Indirect { letters, pointer, pointer_span } => {
                let area = area_and_width(letters).map(|(area, _)| area);
                let place = bytes(span);
                let outer = (place.start < place.end).then(|| self.to.push(place, Written::Indirect(area), access));
                self.operand(pointer, *pointer_span, Access::Read);
                outer
            }
            Operand::RegisterIndirect { letters, .. } => {
                let area = area_and_width(letters).map(|(area, _)| area);
                let place = bytes(span);
                (place.start < place.end).then(|| self.to.push(place, Written::Indirect(area), access))
            }
            Operand::List(operands) => {
                operands.iter().for_each(|(operand, span)| _ = self.operand(operand, *span, Access::Read));
                None
            }
            Operand::Call(call) => self.call(call),
        }
    }

    fn constant(&mut self, constant: &Constant, span: Span) -> Option<u32> {
        let (db, pointer, bits) = match constant.value.as_ref()? {
            Value::Pointer(pointer) => (0, *pointer, 1),
            Value::DataPointer { db, pointer } => (*db, *pointer, 1),
            Value::Any(any) => {
                let [_, code, count_high, count_low, db_high, db_low, pointer @ ..] = *any;
                let width = match code {
                    1 => 1,
                    2 | 3 => 8,
                    4 | 5 => 16,
                    _ => 32,
                };
                let count = u32::from(u16::from_be_bytes([count_high, count_low]));
                (u16::from_be_bytes([db_high, db_low]), u32::from_be_bytes(pointer), count.saturating_mul(width))
            }
            _ => return None,
        };
        const AREAS: [Area; 4] = [Area::Input, Area::Output, Area::BitMemory, Area::SharedData];
        let area = AREAS.into_iter().find(|area| u32::from(area.pointer_code()) == pointer >> 24)?;
        let place = bytes(if constant.span.start < constant.span.end { constant.span } else { span });
        let written = Written::Range(area, (db > 0).then_some(db), pointer & 0x7_FFFF, bits.max(1));
        Some(self.to.push(place, written, Access::Address))
    }

    fn block_name(&mut self, block: &BlockName, access: Access) -> Option<u32> {
        match block {
            BlockName::Absolute { kind, number, span } => self.to.operand(Address::Block(block_id(*kind, *number)?), *span, access),
            BlockName::Symbol(word) => self.to.name(&word.text, word.span, Written::Global, access),
        }
    }

    /// The steps of a path: what is used is the last one.
    fn path(&mut self, first: u32, path: &[PathElement], access: Access) -> u32 {
        let mut last = first;
        for element in path {
            let PathElement::Field(word) = element else { continue };
            let Some(next) = self.to.name(&word.text, word.span, |id| Written::Member(last, id), access) else { break };
            self.to.use_as(last, Access::Path);
            last = next;
        }
        last
    }

    fn call(&mut self, call: &Call) -> Option<u32> {
        let callee = self.operand(&call.callee, call.callee_span, Access::Call);
        if let Some((instance, span)) = &call.instance {
            self.operand(instance, *span, Access::Instance);
        }
        for argument in &call.arguments {
            if let Some(callee) = callee {
                self.to.name(&argument.name.text, argument.name.span, |id| Written::Parameter(callee, id), Access::Parameter);
            }
            self.operand(&argument.value, argument.span, Access::Argument);
        }
        if let Some(callee) = callee {
            let argument = |argument: &Argument| (bytes(argument.name.span.to(argument.span)), true);
            let last = call.arguments.last().map_or(call.callee_span, |argument| argument.span);
            self.to.call(callee, bytes(call.callee_span.to(last)), call.arguments.iter().map(argument).collect());
        }
        callee
    }
}

fn bytes(span: Span) -> Bytes {
    Bytes { start: span.start, end: span.end.max(span.start) }
}

/// A text on one line.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn spelled(letters: &str, number: u64, bit: Option<u64>) -> Option<Address> {
    let text = match bit {
        Some(bit) => format!("{letters}{number}.{bit}"),
        None => format!("{letters}{number}"),
    };
    Address::parse(&text)
}

/// An absolute operand: as its letters say, or as it stands in the text.
fn absolute(letters: &str, number: u64, bit: Option<u64>, span: Span, text: &str) -> Option<Address> {
    let written = || text.get(span.start as usize..span.end as usize).and_then(Address::parse);
    spelled(letters, number, bit).or_else(written)
}
