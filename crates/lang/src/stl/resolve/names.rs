//! Names: words of the language, variables of the block, symbols.

use sieben_model::address::{self, Area};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::diagnostic::{Certainty, Fix};
use sieben_model::interface::{Section, Variable};
use sieben_model::literal::Value;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::addresses::bare_type;
use super::{Meaning, Resolver};
use crate::declarations::interface::is_complex;
use crate::library::{self, LibraryBlock};
use crate::scope::{Global, did_you_mean, key};
use crate::stl::ast;
use crate::stl::declare::path::follow;
use crate::stl::operands::{BlockOperand, DataBlockInfo, Location, NumberOperand, Operand, StatusScan};

impl Resolver<'_> {
    /// A name without quotes or `#`: a word of the language, a local, or a symbol.
    pub(super) fn name(&mut self, word: &ast::Word, path: &[ast::PathElement], span: Span) -> Option<Meaning> {
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

    pub(super) fn unknown_local(&mut self, word: &ast::Word) {
        let names = self.interface.variables.iter().map(|variable| variable.name.as_str());
        let nearest = self.known.scope.nearest(&word.text, names).or_else(|| self.known.scope.nearest_symbol(&word.text));
        let message = format!("`{}` is not declared in `{}`{}", word.text, self.id, did_you_mean(nearest.clone()));
        // Only `#` says that it is none of the symbols.
        let elsewhere = !self.known.sources.slice(word.span).starts_with('#');
        self.report(Problem::P3001, word.span, message).may_be_elsewhere = elsewhere;
        self.offer(word.span, nearest);
    }

    /// Offers to write the name that was probably meant, as the wrong one is written: with quotes, `#` or neither.
    pub(super) fn offer(&mut self, span: Span, name: Option<String>) {
        let (Some(name), Some(diagnostic)) = (name, self.diagnostics.last_mut()) else { return };
        let replacement = match self.known.sources.slice(span).chars().next() {
            Some('"') => format!("\"{name}\""),
            Some('#') => format!("#{name}"),
            _ => name,
        };
        let title = format!("write `{replacement}`");
        diagnostic.fix = Some(Fix { span, replacement, title, certainty: Certainty::Guess });
    }

    pub(super) fn address_of(&mut self, word: &ast::Word) -> Option<Operand> {
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

    pub(super) fn local(&mut self, index: usize, path: &[ast::PathElement], span: Span) -> Option<Meaning> {
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

    /// Says why a name without quotes calls no block of the library, if there is a block with this name.
    pub(super) fn unlinked(&mut self, word: &ast::Word) -> bool {
        let Some(help) = library::by_name(&word.text).map(|block| self.why_not_linked(block)) else { return false };
        let message = format!("`{}` is not declared in `{}`", word.text, self.id);
        let diagnostic = self.report(Problem::P3001, word.span, message);
        diagnostic.may_be_elsewhere = true;
        diagnostic.help = Some(help);
        true
    }

    /// Says that a name is not in the symbol table. Only what is called is compared with the names of system and library blocks.
    pub(super) fn unknown_symbol(&mut self, name: &ast::Word, called: bool) {
        let library = library::ALL.iter().map(|block| block.name).filter(|_| self.known.selection.enabled);
        let scope = self.known.scope;
        let nearest = if called {
            scope.nearest_symbol(&name.text).or_else(|| scope.nearest(&name.text, library))
        } else {
            scope.nearest_variable(&name.text)
        };
        let of_library = library::by_name(&name.text);
        let nearest = nearest.filter(|_| of_library.is_none());
        let message = format!("`\"{}\"` is not in the symbol table{}", name.text, did_you_mean(nearest.clone()));
        let help = of_library.map(|block| self.why_not_linked(block));
        let diagnostic = self.report(Problem::P3020, name.span, message);
        diagnostic.may_be_elsewhere = true;
        diagnostic.help = help;
        self.offer(name.span, nearest);
    }

    /// Resolves a symbol of the table with the path behind it.
    pub(super) fn global(&mut self, name: &ast::Word, path: &[ast::PathElement], span: Span) -> Option<Meaning> {
        let Some(global) = self.known.scope.global(&name.text) else {
            self.unknown_symbol(name, false);
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
                self.report(Problem::P3021, name.span, message).may_be_elsewhere = true;
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
        let LibraryBlock { name, .. } = block;
        let number = self.known.selection.number(block).unwrap_or(block.block);
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
