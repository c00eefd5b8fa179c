//! Operands of extension words.

use sieben_engine::machine::Register;
use sieben_model::address::Area;
use sieben_model::extension::Relation;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::{Meaning, Resolver};
use crate::stl::ast;
use crate::stl::extension::{Compared, Extension, Property, Word, compared_constant, is_status_bit};
use crate::stl::operands::{Access, Location, Operand};

impl Resolver<'_> {
    /// Whether the program may use extension words; says once in a block that it may not.
    pub(crate) fn extended(&mut self, span: Span) -> bool {
        if !self.known.extended && !self.extension_reported {
            self.extension_reported = true;
            let message = format!("`{}` is an extension word, and this program is not extended", self.text(span));
            self.report(Problem::P2040, span, message);
        }
        self.known.extended
    }

    /// The same of a notation that only extended programs have.
    pub(crate) fn extended_notation(&mut self, span: Span) -> bool {
        if !self.known.extended && !self.extension_reported {
            self.extension_reported = true;
            let message = format!("`{}` is written as only extended programs may, and this program is not extended", self.text(span));
            self.report(Problem::P2040, span, message);
        }
        self.known.extended
    }

    /// The variable of a data block behind `P#DB3.name`: data block, position in bits, type.
    pub(crate) fn pointed_to(&mut self, target: &ast::Operand, at: Span, span: Span) -> Option<(u16, u32, DataType)> {
        if !self.extended_notation(span) {
            return None;
        }
        match self.meaning(target, at)? {
            Meaning::Variable { location: Location::InDataBlock { db, position }, data_type, .. } => Some((db, position, data_type)),
            _ => {
                let message = format!("`P#` with a name points to a variable of a data block; `{}` is none", self.text(at));
                self.report(Problem::P4002, at, message);
                None
            }
        }
    }

    /// A statement with an extension word; `None` if something was wrong, which is reported.
    pub(crate) fn extension(&mut self, word: Word, statement: &ast::Statement) -> Option<Operand> {
        if !self.extended(statement.mnemonic.span) {
            return None;
        }
        let operands: &[(ast::Operand, Span)] = match &statement.operand {
            ast::Operand::None => &[],
            ast::Operand::List(operands) => operands,
            _ => return None,
        };
        let extension = match (word, operands) {
            (Word::Assert(relation), [left, right]) => {
                let left = self.compared(left);
                let right = self.compared(right);
                let sides = [left?, right?];
                let numbers = sides.iter().all(|side| matches!(side, Compared::Number(..)));
                if relation == Relation::EqualReal && !numbers {
                    self.wrong(word, statement);
                    return None;
                }
                Extension::Assert { relation, sides }
            }
            (Word::StatusReset, []) => Extension::StatusReset,
            (Word::Sleep, [time]) => match self.compared(time)? {
                Compared::Number(operand, _) => Extension::Sleep(operand),
                _ => {
                    self.wrong(word, statement);
                    return None;
                }
            },
            (Word::Feature, [property, value @ ..]) if value.len() <= 1 => return self.feature(property, value.first(), statement),
            _ => {
                self.wrong(word, statement);
                return None;
            }
        };
        Some(Operand::Extension(Box::new(extension)))
    }

    fn wrong(&mut self, word: Word, statement: &ast::Statement) {
        let message = format!("`{}` takes {}", word.spelling(), word.operands());
        self.report(Problem::P2041, statement.span, message);
    }

    fn feature(
        &mut self,
        (property, property_span): &(ast::Operand, Span),
        value: Option<&(ast::Operand, Span)>,
        statement: &ast::Statement,
    ) -> Option<Operand> {
        let number = |resolver: &mut Self, operand: &ast::Operand, span: Span| match resolver.meaning(operand, span)? {
            Meaning::Operand(Operand::Constant(constant)) => constant.accumulator(),
            _ => None,
        };
        let Some(property) = number(self, property, *property_span).and_then(|number| Property::from_number(i64::from(number))) else {
            self.report(
                Problem::P2041,
                *property_span,
                "the properties are 0, the number of accumulators, and 1, the start information of OB 1",
            );
            return None;
        };
        let value = match value {
            None => None,
            Some((operand, span)) => {
                let value = number(self, operand, *span);
                let (valid, words) = match property {
                    Property::Accumulators => (matches!(value, Some(2 | 4)), "2 or 4"),
                    Property::StartInformation => (matches!(value, Some(0 | 1)), "0 or 1"),
                };
                if !valid {
                    let message = format!("`{}` is no value of this property; it is {words}", self.text(*span));
                    self.report(Problem::P2041, statement.operand_span, message);
                    return None;
                }
                value
            }
        };
        Some(Operand::Extension(Box::new(Extension::Feature { property, value })))
    }

    /// Something that has a value to compare.
    fn compared(&mut self, (operand, span): &(ast::Operand, Span)) -> Option<Compared> {
        let meaning = self.meaning(operand, *span)?;
        let bits = match &meaning {
            Meaning::Variable { location, data_type, .. } => {
                let Some(width) = data_type.width() else {
                    let bytes = u32::try_from(data_type.bits().div_ceil(8)).unwrap_or(u32::MAX);
                    return Some(Compared::Bytes(location.clone(), bytes));
                };
                let access = Access { width, location: location.clone() };
                if !access.is_in(Area::PeripheralOutput) {
                    return Some(Compared::Number(Operand::Memory(access), width.bits() as u8));
                }
                None
            }
            Meaning::Operand(Operand::Constant(constant)) => return Some(compared_constant(constant)),
            Meaning::Operand(operand) => match operand {
                Operand::Status(_) => Some(1),
                Operand::Register(register) if is_status_bit(*register) => Some(1),
                Operand::Register(Register::DbNumber | Register::DiNumber) => Some(16),
                Operand::Timer(_) | Operand::Counter(_) | Operand::StatusWord | Operand::DataBlockInfo(_) => Some(16),
                Operand::Register(_) | Operand::AddressRegister2 | Operand::ParameterAddress(_) => Some(32),
                _ => None,
            },
        };
        match (bits, meaning) {
            (Some(bits), Meaning::Operand(operand)) => Some(Compared::Number(operand, bits)),
            _ => {
                let message = format!(
                    "`{}` has no value to compare; an address that can be read, a variable or a constant has one",
                    self.text(*span)
                );
                self.report(Problem::P2041, *span, message);
                None
            }
        }
    }
}
