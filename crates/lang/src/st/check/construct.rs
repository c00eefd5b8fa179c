//! The call of an FB_Init for one instance: its arguments are those of the declaration.

use sieben_model::block::BlockId;
use sieben_model::interface::Section;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, ReferenceKind};

use super::names::{Names, Role};
use super::typed::{Target, Through};
use super::{Block, Checked, Checker};
use crate::st::ast::{self, Direction, Expression, ExpressionKind, Literal, LiteralKind, Name};
use crate::st::tree::{self, Argument, Base, Call, Callee, Place, Statement, StatementKind, Text, Value, ValueKind};

/// The inputs that every FB_Init begins with: what is kept, and whether the code was copied. Both are FALSE here.
const OF_THE_SYSTEM: usize = 2;

/// An instance that begins.
pub struct Begun<'a> {
    /// Its FB_Init.
    pub function: BlockId,
    /// Where it lies.
    pub instance: Place,
    /// The instance that declares it, if one does: what its names are there, they are here.
    pub owner: Option<Place>,
    /// What the declaration gives.
    pub arguments: &'a [ast::Argument],
    /// The declaration.
    pub span: Span,
}

/// A reference or a pointer that begins with the address of a variable.
pub struct Referring<'a> {
    /// The reference.
    pub place: Place,
    /// Its name.
    pub name: &'a str,
    /// Its type.
    pub data_type: &'a DataType,
    /// The instance that declares it, if one does.
    pub owner: Option<Place>,
    /// What the declaration gives.
    pub value: &'a Expression,
}

/// The statement that calls FB_Init for an instance.
pub fn construct(block: &Block<'_>, names: &dyn Names, begun: &Begun<'_>) -> Checked {
    alone(block, names, |checker| checker.construct(begun))
}

/// The statement that gives a reference its initial value.
pub fn refer(block: &Block<'_>, names: &dyn Names, referring: &Referring<'_>) -> Checked {
    alone(block, names, |checker| checker.begin_reference(referring))
}

fn alone(block: &Block<'_>, names: &dyn Names, make: impl FnOnce(&mut Checker<'_>) -> Option<Statement>) -> Checked {
    let mut checker = Checker::new(block, names);
    let statement = make(&mut checker);
    let local_size = checker.locals.bytes();
    let Checker { failed, diagnostics, called, words, writes, .. } = checker;
    let body = tree::Body { statements: statement.into_iter().collect(), local_size, ..tree::Body::default() };
    Checked { body: (!failed).then_some(body), diagnostics, called, words, writes }
}

impl Checker<'_> {
    fn begin_reference(&mut self, referring: &Referring<'_>) -> Option<Statement> {
        let Referring { place, name, data_type, owner, value } = referring;
        let span = value.span;
        let kind = match data_type {
            DataType::Reference(reference) if reference.kind == ReferenceKind::Reference => {
                let wanted = self.finished(&reference.target);
                self.refer_to(place.clone(), &wanted, value, span)?
            }
            _ => {
                let typed = self.expression_for(value, data_type);
                let (place, data_type) = (place.clone(), (*data_type).clone());
                let target = Target { place, data_type, role: Role::Global, name: (*name).to_owned(), through: Through::Itself };
                self.store(target, typed, span, span)?
            }
        };
        let outside = match kind {
            StatementKind::Assign { target, value } => value_outside(&value, owner.as_ref()).map(|value| (target, value)),
            _ => None,
        };
        let Some((target, value)) = outside else {
            self.report(Problem::P6122, span, format!("`{name}` begins with the address of a variable that lasts, or with a constant"))
                .help = Some("Assign it in the first cycle instead.".to_owned());
            return None;
        };
        Some(Statement { kind: StatementKind::Assign { target, value }, span })
    }

    fn construct(&mut self, begun: &Begun<'_>) -> Option<Statement> {
        let span = begun.span;
        let interface = self.interface(begun.function, span)?;
        let begins = interface.parameters().filter(|formal| formal.section == Section::Input).take(OF_THE_SYSTEM);
        if begins.filter(|formal| formal.data_type == DataType::Bool).count() < OF_THE_SYSTEM {
            // Said once, of the method, and not of every instance.
            self.failed = true;
            return None;
        }
        let inputs: Vec<String> = interface.parameters().map(|formal| formal.name.clone()).collect();
        let of_inputs = interface.parameters().filter(|formal| formal.section == Section::Input).skip(OF_THE_SYSTEM);
        let given = |name: &str| begun.arguments.iter().any(|argument| argument.name.as_ref().is_none_or(|given| given.is(name)));
        let missing: Vec<String> = of_inputs
            .filter(|formal| !given(&formal.name) && !self.names.has_initial(begun.function, &formal.name))
            .map(|formal| format!("`{}`", formal.name))
            .collect();
        if !missing.is_empty() {
            let message = format!("this instance leaves out {} of its FB_Init", missing.join(", "));
            self.report(Problem::P3010, span, message).help = Some("Write `drive : Motor(nr := 3);`, with all of them.".to_owned());
            return None;
        }
        let of_system = inputs.iter().take(OF_THE_SYSTEM).map(|name| ast::Argument {
            name: Some(Name { text: name.clone(), span, ..Name::default() }),
            direction: Direction::Assigned,
            value: Some(Expression { kind: ExpressionKind::Literal(Literal { kind: LiteralKind::Bool(false), prefix: None }), span }),
            span,
        });
        let given = begun.arguments.iter().enumerate().map(|(index, argument)| match (&argument.name, inputs.get(OF_THE_SYSTEM + index)) {
            (None, Some(name)) => ast::Argument { name: Some(Name { text: name.clone(), span, ..Name::default() }), ..argument.clone() },
            _ => argument.clone(),
        });
        let call = ast::Call { callee: Expression { kind: ExpressionKind::Missing, span }, arguments: of_system.chain(given).collect() };
        let callee = Callee::Method { block: begun.function, instance: begun.instance.clone(), dispatch: None };
        let (call, before) = self.arguments(callee, &interface, &call, span)?;
        let arguments: Option<Vec<Argument>> = match before.is_empty() {
            true => call.arguments.iter().map(|argument| relocated(argument, begun.owner.as_ref())).collect(),
            false => None,
        };
        let Some(arguments) = arguments else {
            let message = "an argument of FB_Init is a constant, a variable that lasts, its address, or computed from these";
            self.report(Problem::P6327, span, message).help =
                Some("Assign the value in the first cycle instead, or compute it in FB_Init.".to_owned());
            return None;
        };
        Some(Statement { kind: StatementKind::Call(Call { arguments, ..call }), span })
    }
}

/// An argument as it is outside the instance that declares it.
fn relocated(argument: &Argument, owner: Option<&Place>) -> Option<Argument> {
    Some(match argument {
        Argument::Value { parameter, value } => Argument::Value { parameter: *parameter, value: value_outside(value, owner)? },
        Argument::Text { parameter, text, room } => Argument::Text { parameter: *parameter, text: text_outside(text, owner)?, room: *room },
        Argument::Aggregate { parameter, source, data_type } => {
            Argument::Aggregate { parameter: *parameter, source: place_outside(source, owner)?, data_type: data_type.clone() }
        }
        Argument::InOut { parameter, place, data_type } => {
            Argument::InOut { parameter: *parameter, place: place_outside(place, owner)?, data_type: data_type.clone() }
        }
        Argument::Pointer { parameter, place, data_type, any } => {
            Argument::Pointer { parameter: *parameter, place: place_outside(place, owner)?, data_type: data_type.clone(), any: *any }
        }
        _ => return None,
    })
}

fn value_outside(value: &Value, owner: Option<&Place>) -> Option<Value> {
    let all = |args: &[Value]| args.iter().map(|arg| value_outside(arg, owner)).collect::<Option<Vec<_>>>();
    let kind = match &value.kind {
        ValueKind::Constant(bits) => ValueKind::Constant(*bits),
        ValueKind::Load(place) => ValueKind::Load(place_outside(place, owner)?),
        ValueKind::AddressOf(place) => ValueKind::AddressOf(place_outside(place, owner)?),
        ValueKind::Compute { op, args } => ValueKind::Compute { op: *op, args: all(args)? },
        _ => return None,
    };
    Some(Value { kind, ..value.clone() })
}

fn text_outside(text: &Text, owner: Option<&Place>) -> Option<Text> {
    Some(match text {
        Text::Place { place, room } => Text::Place { place: place_outside(place, owner)?, room: *room },
        Text::Constant(_) | Text::WideConstant(_) => text.clone(),
        _ => return None,
    })
}

fn place_outside(place: &Place, owner: Option<&Place>) -> Option<Place> {
    match (&place.base, owner) {
        _ if !place.indexes.is_empty() => None,
        (Base::Instance, Some(owner)) => Some(Place { base: owner.base.clone(), offset: owner.offset + place.offset, ..place.clone() }),
        (Base::DataBlock(_), _) => Some(place.clone()),
        (Base::Area(area), _) if *area != sieben_model::address::Area::Local => Some(place.clone()),
        _ => None,
    }
}
