//! `CALL`: the called block, its instance, and its parameters by name.

use std::collections::{HashMap, HashSet};

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::extension::{SHUTDOWN, is_negative};
use sieben_model::interface::Interface;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::{Meaning, Resolver};
use crate::declarations::types::BlockInterface;
use crate::scope::{Scope, did_you_mean, key};
use crate::stl::ast;
use crate::stl::operands::{Call, CallInstance, CallParameter, Location, Operand};

/// Names that a message lists before it says "and others".
const NAMES_SHOWN_MAX: usize = 8;

impl Resolver<'_> {
    /// What `CALL` calls, with all its parameters.
    pub(crate) fn call(&mut self, call: &ast::Call) -> Option<Operand> {
        let (callee, multi) = self.callee(call)?;
        if is_negative(callee) && !self.extended(call.callee_span) {
            return None;
        }
        let Some(BlockInterface { interface, .. }) = self.known.blocks.interface(callee) else {
            if !self.known.blocks.exists(callee) {
                self.report(Problem::P3008, call.callee_span, format!("`{callee}` does not exist")).may_be_elsewhere = true;
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
        let arguments = self.arguments(call, callee, interface);
        let mut parameters = Vec::new();
        let mut missing = Vec::new();
        for parameter in interface.parameters() {
            let actual = match arguments.get(&key(&parameter.name)) {
                Some(argument) => self.actual(argument, parameter),
                None => {
                    // Older programs call it without its only parameter.
                    if !has_instance && callee != SHUTDOWN {
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

    /// The values that a call gives, by the names of the parameters; those without a value are left out.
    fn arguments<'c>(&mut self, call: &'c ast::Call, callee: BlockId, interface: &Interface) -> HashMap<String, &'c ast::Argument> {
        let formals: HashSet<String> = interface.parameters().map(|parameter| key(&parameter.name)).collect();
        let given: HashSet<String> = call.arguments.iter().map(|argument| key(&argument.name.text)).collect();
        let mut arguments: HashMap<String, &ast::Argument> = HashMap::with_capacity(call.arguments.len());
        for argument in &call.arguments {
            if is_type_hint(argument, &formals) {
                continue;
            }
            if !formals.contains(&key(&argument.name.text)) {
                let names = interface.parameters().map(|parameter| parameter.name.as_str());
                let names: Vec<&str> = names.filter(|name| !given.contains(&key(name))).collect();
                let nearest = self.known.scope.nearest_parameter(&argument.name.text, names.iter().copied());
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
            // `x :=` without a value, as generated sources write an omitted parameter.
            if argument.value == ast::Operand::None {
                continue;
            }
            if let Some(first) = arguments.insert(key(&argument.name.text), argument) {
                let first = first.name.span;
                let message = format!("the parameter `{}` is given twice", argument.name.text);
                self.report(Problem::P3011, argument.name.span, message).related.push((first, "first given here".to_owned()));
            }
        }
        arguments
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
        if let ast::Operand::Symbol { name, .. } = &call.callee
            && self.known.scope.global(&name.text).is_none()
        {
            self.unknown_symbol(name, true);
            return None;
        }
        if let ast::Operand::Name { word, .. } = &call.callee
            && !self.locals.contains_key(&key(&word.text))
            && self.known.scope.global(&word.text).is_none()
            && self.unlinked(word)
        {
            return None;
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
        if let Some(layout) = self.known.blocks.data(number)
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

/// `time_type := Time`: TIA writes the types of some calls before their parameters. They choose nothing that the block does not say itself.
fn is_type_hint(argument: &ast::Argument, formals: &HashSet<String>) -> bool {
    let name = key(&argument.name.text);
    let hint = name.len() > "_type".len() && name.get(name.len() - "_type".len()..).is_some_and(|end| end.eq_ignore_ascii_case("_type"));
    hint && !formals.contains(&name) && matches!(&argument.value, ast::Operand::Name { path, .. } if path.is_empty())
}
