//! Constant expressions: bounds, lengths, initial values, CONST, VAR CONSTANT, values of enumerations.

use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::declaring::Declaring;
use super::interface::is_constant;
use super::sizes::Unsized;
use super::types::Resolver;
use crate::declarations::types::State;
use crate::scope::{did_you_mean, key};
use crate::st::ast::{self, BinaryOperator, Expression, ExpressionKind, LiteralKind, Name, UnaryOperator};
use crate::st::check::names::{Constant, Entity};
use crate::st::dialect::Construct;

/// Nanoseconds of a millisecond, in which durations without `L` count.
const MILLISECOND: i64 = 1_000_000;

/// What is said of an expression that is not constant.
const NOT_CONSTANT: &str = "this must be known when the program is compiled: a constant, or an expression of constants";

impl<'a> Resolver<'_, 'a> {
    /// The value of a constant expression; `None` if it has none, which is reported.
    pub(super) fn constant(&mut self, expression: &Expression) -> Option<Constant> {
        let span = expression.span;
        match &expression.kind {
            ExpressionKind::Literal(literal) => {
                let data_type = literal.prefix.and_then(|word| self.word(word));
                Some(Constant { value: literal.kind.clone(), data_type })
            }
            ExpressionKind::Parenthesized(inner) => self.constant(inner),
            ExpressionKind::Name(name) | ExpressionKind::Global(name) => self.named_constant(name),
            ExpressionKind::EnumValue { of, value } => {
                let data_type = self.named(of)?.data_type.clone();
                self.value_of(&data_type, value)
            }
            ExpressionKind::Member(base, name) => self.qualified_constant(base, name, span),
            ExpressionKind::Unary(operator, operand) => {
                let operand = self.constant(operand)?;
                self.unary(*operator, operand, span)
            }
            ExpressionKind::Binary(operator, _, left, right) => {
                let left = self.constant(left)?;
                let right = self.constant(right)?;
                self.binary(*operator, left, right, span)
            }
            ExpressionKind::Missing => None,
            ExpressionKind::Call(call) if matches!(&call.callee.kind, ExpressionKind::Name(name) if name.is("SIZEOF")) => {
                match self.size_of(call) {
                    Ok(value) => Some(Constant { value: LiteralKind::Integer { value, radix: 10 }, data_type: None }),
                    Err(Unsized::Reported) => None,
                    Err(Unsized::Unknown) => self.not_constant(span),
                }
            }
            ExpressionKind::Call(call) if takes_address(call) => {
                let message = "an address is known when the program starts, and this has to be known when it is compiled";
                self.report(Problem::P6122, span, message).help = Some(
                    "A type cannot begin with one: write it where the variable is declared, as in `x : Config := (p := ADR(y))`."
                        .to_owned(),
                );
                None
            }
            _ => self.not_constant(span),
        }
    }

    fn not_constant<T>(&mut self, span: Span) -> Option<T> {
        self.report(Problem::P6122, span, NOT_CONSTANT);
        None
    }

    /// The value as a whole number from -2^63 to 2^64 - 1.
    pub(super) fn integer(&mut self, expression: &Expression) -> Option<i128> {
        let constant = self.constant(expression)?;
        match constant.value {
            LiteralKind::Integer { value, .. } => Some(value),
            _ => {
                self.report(Problem::P4006, expression.span, "this must be a whole number");
                None
            }
        }
    }

    fn named_constant(&mut self, name: &Name) -> Option<Constant> {
        let wanted = key(&name.text);
        if let Some(found) = self.local_constant(&wanted, name.span) {
            return found;
        }
        // What the block itself declares was looked at; a constant that needs itself is not found a second time.
        let inherits = |own: &BlockId| self.items.own_declaration(*own, &name.text).is_none();
        if let Some(found) = self.own.filter(inherits).and_then(|own| self.constant_of_line(own, &name.text)) {
            return found;
        }
        let items = self.items;
        let of_list = self.list.map(|list| key(&format!("{list}.{}", name.text)));
        if let Some(found) = of_list.into_iter().chain([wanted.clone()]).find(|name| items.globals.contains_key(name)) {
            return self.global_constant(&found, name.span);
        }
        match items.values.get(&wanted).map(Vec::as_slice) {
            Some([owner]) => {
                let data_type = self.type_of_key(owner, name.span)?.data_type.clone();
                return self.value_of(&data_type, name);
            }
            Some(owners) => {
                let owners: Vec<&str> = owners.iter().map(String::as_str).collect();
                let message = format!("`{}` is a value of {} enumerations ({})", name.text, owners.len(), owners.join(", "));
                self.report(Problem::P6122, name.span, message).help = Some("Write the enumeration before it.".to_owned());
                return None;
            }
            None => {}
        }
        let nearest = self.types.scope.nearest(&name.text, self.constant_names().into_iter());
        let message = format!("there is no constant `{}`{}", name.text, did_you_mean(nearest));
        self.report(Problem::P6122, name.span, message).may_be_elsewhere = true;
        None
    }

    fn qualified_constant(&mut self, base: &Expression, name: &Name, span: Span) -> Option<Constant> {
        let Some(path) = path_of(base) else { return self.not_constant(span) };
        let before = key(&path.join("."));
        let items = self.items;
        if items.types.contains_key(&before) {
            let data_type = self.type_of_key(&before, base.span)?.data_type.clone();
            return self.value_of(&data_type, name);
        }
        let full = format!("{before}.{}", key(&name.text));
        if items.globals.contains_key(&full) {
            return self.global_constant(&full, span);
        }
        if let Some(found) = items.block_in(self.space, &path.join(".")).and_then(|block| self.constant_of_line(block, &name.text)) {
            return if self.judge(Construct::ForeignInternal, name.span) { found } else { None };
        }
        self.report(Problem::P6122, span, NOT_CONSTANT).may_be_elsewhere = true;
        None
    }

    /// A value of an enumeration.
    pub(super) fn value_of(&mut self, data_type: &DataType, name: &Name) -> Option<Constant> {
        let DataType::Enumeration(enumeration) = data_type else {
            self.report(Problem::P6122, name.span, format!("{} has no values with names", self.dialect.type_words(data_type)));
            return None;
        };
        match enumeration.values.iter().find(|(value, _)| value.eq_ignore_ascii_case(&name.text)) {
            Some(&(_, number)) => {
                Some(Constant { value: LiteralKind::Integer { value: i128::from(number), radix: 10 }, data_type: Some(data_type.clone()) })
            }
            None => {
                let nearest = self.types.scope.nearest(&name.text, enumeration.values.iter().map(|(name, _)| name.as_str()));
                let message = format!("{} has no value `{}`{}", self.dialect.type_words(data_type), name.text, did_you_mean(nearest));
                self.report(Problem::P3007, name.span, message);
                None
            }
        }
    }

    /// A constant of a VAR_GLOBAL CONSTANT section.
    pub(super) fn global_constant(&mut self, wanted: &str, span: Span) -> Option<Constant> {
        match self.types.known.constants.get(wanted) {
            Some(State::Done(done)) => return done.clone(),
            Some(State::InProgress) => {
                self.report(Problem::P3016, span, "this constant is defined by itself");
                return None;
            }
            None => {}
        }
        let &(list, declaration) = self.items.globals.get(wanted)?;
        let list = &self.items.lists[list];
        if !list.section.has(crate::st::ast::Qualifier::Constant) {
            return self.not_constant(span);
        }
        if !self.types.enter(span) {
            return None;
        }
        self.types.known.constants.insert(wanted.to_owned(), State::InProgress);
        let dialect = list.dialect;
        self.types.reuse.begin_shared();
        let mut resolver = Resolver { list: Some(&list.name), ..Resolver::new(self.types, self.items, dialect) };
        let value = resolver.declared_constant(declaration);
        self.types.reuse.end_shared();
        self.types.leave();
        self.types.known.constants.insert(wanted.to_owned(), State::Done(value.clone()));
        value
    }

    /// The value of a declaration of constants; `None` also if it is no elementary one.
    pub(super) fn declared_constant(&mut self, declaration: &crate::st::ast::Declaration) -> Option<Constant> {
        use crate::st::ast::{InitializerKind, TypeKind};
        let initial = declaration.initial.as_ref();
        if matches!(declaration.data_type.kind, TypeKind::Inferred) {
            let Some(InitializerKind::Expression(expression)) = initial.map(|initial| &initial.kind) else {
                return self.not_constant(declaration.span);
            };
            return self.constant(expression);
        }
        let (data_type, named) = self.type_and_initial(&declaration.data_type)?;
        let value = match initial.map(|initial| &initial.kind) {
            Some(InitializerKind::Expression(expression)) => {
                let constant = self.constant(expression)?;
                self.converted(constant, &data_type, expression.span)?
            }
            Some(_) => return self.not_constant(declaration.span),
            None if named.is_empty() => super::initial::default_constant(&data_type)?,
            None => return None,
        };
        Some(Constant { value, data_type: Some(data_type) })
    }

    fn unary(&mut self, operator: UnaryOperator, operand: Constant, span: Span) -> Option<Constant> {
        let Constant { value, data_type } = operand;
        let value = match (operator, value) {
            (UnaryOperator::Plus, value @ (LiteralKind::Integer { .. } | LiteralKind::Real { .. } | LiteralKind::Duration { .. })) => value,
            (UnaryOperator::Minus, LiteralKind::Integer { value, .. }) => LiteralKind::Integer { value: -value, radix: 10 },
            (UnaryOperator::Minus, LiteralKind::Real { value, single }) => LiteralKind::Real { value: -value, single: -single },
            (UnaryOperator::Minus, LiteralKind::Duration { nanoseconds, long }) => {
                LiteralKind::Duration { nanoseconds: nanoseconds.checked_neg().or_else(|| self.too_large(span))?, long }
            }
            (UnaryOperator::Not, LiteralKind::Bool(value)) => LiteralKind::Bool(!value),
            (UnaryOperator::Not, LiteralKind::Integer { value, .. }) if data_type.is_some() => {
                let bits = data_type.as_ref().map_or(64, DataType::bits).min(64);
                let mask = if bits == 64 { u64::MAX } else { (1 << bits) - 1 };
                LiteralKind::Integer { value: i128::from(!(value as u64) & mask), radix: 16 }
            }
            _ => return self.not_constant(span),
        };
        self.in_range(Constant { value, data_type }, span)
    }

    fn too_large<T>(&mut self, span: Span) -> Option<T> {
        self.report(Problem::P4001, span, "the value of this expression is too large");
        None
    }

    /// The constant, if its type holds it.
    fn in_range(&mut self, constant: Constant, span: Span) -> Option<Constant> {
        let LiteralKind::Integer { value, .. } = constant.value else { return Some(constant) };
        let (low, high) = match &constant.data_type {
            Some(data_type) => super::initial::range(data_type).unwrap_or((i128::MIN, i128::MAX)),
            None => (i128::from(i64::MIN), i128::from(u64::MAX)),
        };
        if (low..=high).contains(&value) {
            return Some(constant);
        }
        self.too_large(span)
    }

    fn binary(&mut self, operator: BinaryOperator, left: Constant, right: Constant, span: Span) -> Option<Constant> {
        use BinaryOperator as B;
        use LiteralKind as L;
        let data_type = left.data_type.clone().or_else(|| right.data_type.clone());
        let compared = |ordering: Option<std::cmp::Ordering>| {
            Some(match operator {
                B::Less => ordering.is_some_and(std::cmp::Ordering::is_lt),
                B::LessEqual => ordering.is_some_and(std::cmp::Ordering::is_le),
                B::Greater => ordering.is_some_and(std::cmp::Ordering::is_gt),
                B::GreaterEqual => ordering.is_some_and(std::cmp::Ordering::is_ge),
                B::Equal => ordering.is_some_and(std::cmp::Ordering::is_eq),
                B::NotEqual => !ordering.is_some_and(std::cmp::Ordering::is_eq),
                _ => return None,
            })
        };
        let truth = |value: bool| Some(Constant { value: L::Bool(value), data_type: Some(DataType::Bool) });
        let value = match (left.value, right.value) {
            (L::Integer { value: a, radix }, L::Integer { value: b, .. }) => {
                if let Some(result) = compared(Some(a.cmp(&b))) {
                    return truth(result);
                }
                let value = match operator {
                    B::Add => a.checked_add(b),
                    B::Subtract => a.checked_sub(b),
                    B::Multiply => a.checked_mul(b),
                    B::Divide | B::IntegerDivide | B::Modulo if b == 0 => {
                        self.report(Problem::P6122, span, "a constant expression divides by 0");
                        return None;
                    }
                    B::Divide | B::IntegerDivide => a.checked_div(b),
                    B::Modulo => a.checked_rem(b),
                    B::Power => u32::try_from(b).ok().and_then(|b| a.checked_pow(b)),
                    B::And | B::AndThen => Some(a & b),
                    B::Or | B::OrElse => Some(a | b),
                    _ => Some(a ^ b),
                };
                let Some(value) = value else { return self.too_large(span) };
                L::Integer { value, radix }
            }
            (L::Bool(a), L::Bool(b)) => match operator {
                B::And | B::AndThen => L::Bool(a && b),
                B::Or | B::OrElse => L::Bool(a || b),
                B::Xor | B::NotEqual => L::Bool(a != b),
                B::Equal => L::Bool(a == b),
                _ => return self.not_constant(span),
            },
            (a @ (L::Real { .. } | L::Integer { .. }), b @ (L::Real { .. } | L::Integer { .. })) => {
                let ((a, x), (b, y)) = (real(&a), real(&b));
                if let Some(result) = compared(a.partial_cmp(&b)) {
                    return truth(result);
                }
                let (value, single) = match operator {
                    B::Add => (a + b, x + y),
                    B::Subtract => (a - b, x - y),
                    B::Multiply => (a * b, x * y),
                    B::Divide => (a / b, x / y),
                    _ => return self.not_constant(span),
                };
                L::Real { value, single }
            }
            (L::Duration { nanoseconds: a, long }, L::Duration { nanoseconds: b, long: other }) => {
                if let Some(result) = compared(Some(a.cmp(&b))) {
                    return truth(result);
                }
                let sum = match operator {
                    B::Add => a.checked_add(b),
                    B::Subtract => a.checked_sub(b),
                    _ => return self.not_constant(span),
                };
                let Some(nanoseconds) = sum else { return self.too_large(span) };
                L::Duration { nanoseconds, long: long || other }
            }
            (L::Duration { nanoseconds, long }, L::Integer { value, .. })
            | (L::Integer { value, .. }, L::Duration { nanoseconds, long }) => {
                let result = match (operator, i64::try_from(value)) {
                    (B::Multiply, Ok(factor)) => nanoseconds.checked_mul(factor),
                    (B::Divide | B::IntegerDivide, Ok(divisor)) => nanoseconds.checked_div(divisor),
                    _ => return self.not_constant(span),
                };
                let Some(result) = result else { return self.too_large(span) };
                L::Duration { nanoseconds: if long { result } else { result / MILLISECOND * MILLISECOND }, long }
            }
            _ => return self.not_constant(span),
        };
        self.in_range(Constant { value, data_type }, span)
    }

    /// What the block that is declared has under a name: its constants, and values of enumerations written where a variable is declared.
    fn local_constant(&mut self, wanted: &str, span: Span) -> Option<Option<Constant>> {
        match self.names.get(wanted) {
            Some(Entity::Constant(constant)) => return Some(Some(constant.clone())),
            Some(Entity::EnumValue { data_type, value }) => {
                let value = LiteralKind::Integer { value: *value, radix: 10 };
                return Some(Some(Constant { value, data_type: Some(data_type.clone()) }));
            }
            // What its declaration is, nobody knows; that was told there.
            Some(Entity::Variable(variable)) if variable.data_type == DataType::Void => return Some(None),
            Some(_) => return Some(self.not_constant(span)),
            None => {}
        }
        let declaration = *self.constant_declarations.get(wanted)?;
        // A constant that needs itself finds nothing the second time.
        self.constant_declarations.remove(wanted);
        if !self.types.enter(span) {
            return Some(None);
        }
        let value = self.declared_constant(declaration);
        self.types.leave();
        if let Some(constant) = &value {
            self.names.insert(wanted.to_owned(), Entity::Constant(constant.clone()));
        }
        Some(value)
    }

    /// A constant that a block, or one that it extends, declares; `None` if none of them does.
    fn constant_of_line(&mut self, block: BlockId, name: &str) -> Option<Option<Constant>> {
        let Declaring { block, section, declaration } = self.items.declaration_of(block, name)?;
        if !is_constant(section, declaration) {
            return None;
        }
        // The value belongs to no interface that could be compared with that of before.
        self.types.reuse.depends_on_order();
        let wanted = key(&format!("{block}.{name}"));
        match self.types.known.constants.get(&wanted) {
            Some(State::Done(done)) => return Some(done.clone()),
            Some(State::InProgress) => {
                self.report(Problem::P3016, declaration.span, "this constant is defined by itself");
                return Some(None);
            }
            None => {}
        }
        if !self.types.enter(declaration.span) {
            return Some(None);
        }
        self.types.known.constants.insert(wanted.clone(), State::InProgress);
        self.types.reuse.begin_shared();
        let value = self.inside(block).and_then(|mut inner| inner.declared_constant(declaration));
        self.types.reuse.end_shared();
        self.types.leave();
        self.types.known.constants.insert(wanted, State::Done(value.clone()));
        Some(value)
    }

    /// The same for what stands in the declarations of a block.
    pub(super) fn inside(&mut self, block: BlockId) -> Option<Resolver<'_, 'a>> {
        let items = self.items;
        let code = items.code.get(&block)?;
        let mut inner = Resolver::new(self.types, items, code.dialect).within(code.space);
        inner.own = Some(block);
        let constants = code.block.sections.iter().flat_map(|section| section.declarations.iter().map(move |one| (section, one)));
        for (_, declaration) in constants.filter(|(section, declaration)| is_constant(section, declaration)) {
            for declared in &declaration.names {
                inner.constant_declarations.insert(key(&declared.name.text), declaration);
            }
        }
        Some(inner)
    }

    fn constant_names(&self) -> Vec<&str> {
        let items = self.items;
        let globals = items.globals.iter().filter(|(_, (list, _))| items.lists[*list].section.has(crate::st::ast::Qualifier::Constant));
        let own = self.names.iter().filter(|(_, entity)| matches!(entity, Entity::Constant(_)));
        let names = own.map(|(name, _)| name.as_str()).chain(self.constant_declarations.keys().map(String::as_str));
        names.chain(globals.map(|(name, _)| name.as_str())).chain(items.values.keys().map(String::as_str)).collect()
    }
}

/// A number as LREAL and as REAL.
fn real(value: &LiteralKind) -> (f64, f32) {
    match value {
        LiteralKind::Real { value, single } => (*value, *single),
        LiteralKind::Integer { value, .. } => (*value as f64, *value as f32),
        _ => (0.0, 0.0),
    }
}

/// The names of `a.b.c`.
pub(super) fn path_of(expression: &Expression) -> Option<Vec<&str>> {
    let mut names = Vec::new();
    let mut at = expression;
    loop {
        match &at.kind {
            ExpressionKind::Name(name) | ExpressionKind::Global(name) => {
                names.push(name.text.as_str());
                names.reverse();
                return Some(names);
            }
            ExpressionKind::Member(base, name) => {
                names.push(name.text.as_str());
                at = base;
            }
            _ => return None,
        }
    }
}

/// `ADR(x)`, `REF(x)`.
fn takes_address(call: &ast::Call) -> bool {
    matches!(&call.callee.kind, ExpressionKind::Name(name) if name.is("ADR") || name.is("REF"))
}
