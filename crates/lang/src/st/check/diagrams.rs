//! Boxes and wires of diagrams: a box is the call that it stands for, with EN and ENO around it.

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section};
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::Checker;
use super::calls::Called;
use super::names::{Entity, Role};
use super::places::Reached;
use super::typed::{Target, Through, Typed};
use super::types::Kind;
use crate::network::boxes::{CounterKind, POWER_PINS, TimerKind};
use crate::network::elements;
use crate::st::ast::{
    self, Argument, Call, DiagramBox, Direction, Expression, ExpressionKind, GoesOn, Literal, LiteralKind, Name, Quoting, Wire,
};
use crate::st::diagrams::pins as standard_pins;
use crate::st::dialect::Construct;
use crate::st::standard;
use crate::st::tree::{Place, Scalar, Statement, StatementKind, Value, ValueKind};

/// What a wire carries.
#[derive(Clone, Debug)]
pub(super) enum Carried {
    /// A value in the local data.
    Kept(Target, Scalar),
    /// A constant, or something that was not understood.
    Known(Typed),
}

/// Functions whose result is always a BOOL.
const COMPARISONS: [&str; 6] = ["GT", "GE", "EQ", "LE", "LT", "NE"];

/// What EN and ENO are called.
const EN: &str = "EN";
const ENO: &str = "ENO";

/// What people call the result of a function at its box.
const RESULT: &str = "OUT";

impl Checker<'_> {
    /// A value that is kept on a wire.
    pub(super) fn wire(&mut self, wire: Wire, value: &Expression, span: Span) -> Option<StatementKind> {
        self.begin_wire(wire);
        let typed = self.expression(value);
        self.onto(wire, typed, span)
    }

    /// The value of a wire.
    pub(super) fn of_wire(&self, wire: Wire, span: Span) -> Reached {
        match self.wires.get(&wire) {
            Some(Carried::Kept(target, scalar)) => {
                let place = Place { span, ..target.place.clone() };
                // Where a dialect computes in more bits than the type has, all of them are kept.
                match Kind::of(&target.data_type).is_some_and(|kind| kind.scalar(self.dialect) == *scalar) {
                    true => Reached::Target(Target { place, ..target.clone() }),
                    false => {
                        let value = Value { kind: ValueKind::Load(place), scalar: *scalar, span };
                        Reached::Other(Typed::Scalar { value, data_type: target.data_type.clone() })
                    }
                }
            }
            Some(Carried::Known(typed)) => Reached::Other(typed.clone()),
            None => Reached::Other(Typed::Poison),
        }
    }

    /// The first wire of a network: those of the network before it are read no more.
    fn begin_wire(&mut self, wire: Wire) {
        if wire == Wire(0) {
            self.wires.clear();
            self.locals.let_go();
        }
    }

    /// Puts a value onto a wire.
    fn onto(&mut self, wire: Wire, typed: Typed, span: Span) -> Option<StatementKind> {
        let (value, data_type) = match typed {
            Typed::Scalar { value, data_type } => (value, data_type),
            Typed::Poison | Typed::Integer { .. } | Typed::Real { .. } | Typed::Null | Typed::Number { .. } => {
                self.wires.insert(wire, Carried::Known(typed));
                return None;
            }
            other => {
                let what = self.what(&other);
                self.report(Problem::P4302, span, format!("a line of a diagram carries BOOL, bits, numbers and times, not {what}")).help =
                    Some("Assign it to a variable at the output, and wire the variable to the input.".to_owned());
                self.wires.insert(wire, Carried::Known(Typed::Poison));
                return None;
            }
        };
        let target = self.carry(wire, data_type, value.scalar, span);
        Some(StatementKind::Assign { target, value })
    }

    /// A place for what a wire carries.
    fn carry(&mut self, wire: Wire, data_type: DataType, scalar: Scalar, span: Span) -> Place {
        let place = self.locals.hold(scalar.bits().div_ceil(8), span);
        let name = "the line".to_owned();
        let target = Target { place: place.clone(), data_type, role: Role::Temp, name, through: Through::Itself };
        self.wires.insert(wire, Carried::Kept(target, scalar));
        place
    }

    /// A box.
    pub(super) fn diagram_box(&mut self, one: &DiagramBox, span: Span) -> Option<StatementKind> {
        // EN and ENO belong to every diagram, also where calls in text seldom have them.
        self.noted.insert(Construct::EnEno as u32);
        let wire = one.goes_on.wire();
        wire.into_iter().for_each(|wire| self.begin_wire(wire));
        let done = match self.is_block_box(one) {
            true => self.block_box(one, span),
            false => self.function_box(one, span),
        };
        // What was not understood is reported: who reads its line says nothing more.
        if let (None, Some(wire)) = (&done, wire) {
            self.wires.entry(wire).or_insert(Carried::Known(Typed::Poison));
        }
        done
    }

    /// Whether a box names a function block; a function is called without an instance.
    fn is_block_box(&mut self, one: &DiagramBox) -> bool {
        let ExpressionKind::Name(name) = &one.of.kind else { return self.block_of(&one.of).is_some() };
        self.block_of(&one.of).is_some() || self.is_brought_along(name)
    }

    /// Whether the dialect brings a function block of this name along.
    fn is_brought_along(&self, name: &Name) -> bool {
        standard::library::block_types(self.dialect).any(|block| name.is(block))
    }

    /// The function block of the project that an expression names.
    fn block_of(&mut self, of: &Expression) -> Option<BlockId> {
        let found = match &of.kind {
            ExpressionKind::Name(name) => match self.names.global(&name.text)? {
                Entity::Block(block) | Entity::Type(DataType::Instance { block, .. }) => block,
                _ => return None,
            },
            _ => match self.quietly(|checker| checker.reach(of)) {
                Reached::Other(Typed::Block(block) | Typed::Type(DataType::Instance { block, .. })) => block,
                _ => return None,
            },
        };
        matches!(found.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock).then_some(found)
    }

    /// Whether a function block is the one that a box names.
    fn is_named_by(&mut self, block: BlockId, of: &Expression) -> bool {
        let named = self.block_of(of);
        if named.is_some_and(|named| named == block || self.names.objects().is_a(block, named)) {
            return true;
        }
        let ExpressionKind::Name(name) = &of.kind else { return false };
        let provided = standard::library::block_type(&name.text, self.dialect).filter(|_| self.is_brought_along(name));
        provided.and_then(|provided| self.names.provided(&provided)) == Some(block)
    }

    /// The instance that a box calls; a PROGRAM stands for its own.
    fn called_by_box<'b>(&mut self, one: &'b DiagramBox) -> Option<&'b Expression> {
        let is_program = |checker: &mut Self| checker.block_of(&one.of).is_some_and(|block| checker.names.program(block).is_some());
        one.instance.as_ref().or_else(|| is_program(self).then_some(&one.of))
    }

    /// The function block that a box calls, with the instance, which must be one of the block that the box names.
    fn instance_of_box<'b>(&mut self, one: &'b DiagramBox) -> Option<(BlockId, &'b Expression)> {
        let named = match &one.of.kind {
            ExpressionKind::Name(name) => name.text.clone(),
            _ => self.block_of(&one.of).map(|block| self.names.block_name(block)).unwrap_or_default(),
        };
        let Some(instance) = self.called_by_box(one) else {
            let message = format!("`{named}` is a function block, and this box names no instance of it");
            self.report(Problem::P4303, one.of.span, message).help =
                Some(format!("Declare `x : {named};` in VAR, and write `{named} x` as the box."));
            return None;
        };
        match self.called(instance) {
            Called::Instance(block, target, _) => {
                if self.is_named_by(block, &one.of) {
                    return Some((block, instance));
                }
                let message = format!("`{}` is an instance of `{}`, and the box is `{named}`", target.name, self.names.block_name(block));
                self.report(Problem::P4304, instance.span, message);
                None
            }
            Called::Nothing => None,
            _ => {
                self.report(Problem::P4304, instance.span, format!("this is no instance of `{named}`"));
                None
            }
        }
    }

    /// The pins that a line enters and leaves, where they are not EN and ENO.
    fn power_of(&self, block: BlockId, interface: &Interface) -> Option<(&'static str, &'static str)> {
        if !self.names.is_of_library(block) && block.kind != BlockKind::SystemFunctionBlock {
            return None;
        }
        let name = self.names.block_name(block).to_ascii_uppercase();
        let typed = |base: &&str| name == **base || name.strip_prefix(*base).is_some_and(|rest| rest.starts_with('_'));
        // A system function block may have no name but its number.
        let of_system = match (block.kind, block.number) {
            (BlockKind::SystemFunctionBlock, 0) => Some("CTU"),
            (BlockKind::SystemFunctionBlock, 1) => Some("CTD"),
            (BlockKind::SystemFunctionBlock, 2) => Some("CTUD"),
            (BlockKind::SystemFunctionBlock, 3..=5) => Some("TP"),
            _ => None,
        };
        let row = POWER_PINS.iter().find(|row| row.blocks.iter().any(|base| typed(base) || of_system == Some(*base)))?;
        let input = row.input.iter().find(|input| interface.variable(input).is_some())?;
        Some((input, row.output))
    }

    /// A function block with its instance.
    fn block_box(&mut self, one: &DiagramBox, span: Span) -> Option<StatementKind> {
        let (block, instance) = self.instance_of_box(one)?;
        let interface = self.interface(block, one.of.span)?;
        let power = self.power_of(block, &interface);
        let mut pins = Pins::of(one, |name| is_flow(name, Some(&interface)));
        let pin = one.power_pin.as_ref().map(|pin| pin.text.clone()).or_else(|| power.map(|(input, _)| input.to_owned()));
        self.power_in(one, pin, &mut pins, span)?;
        let called = self.names.block_name(block);
        self.name_inputs(&mut pins, &interface, &called)?;
        let given = |inputs: &[Argument], name: &str| inputs.iter().any(|input| input.name.as_ref().is_some_and(|one| one.is(name)));
        if let Some((input, _)) = power
            && !given(&pins.inputs, input)
        {
            let message = format!("nothing is wired to {input} of `{}`", self.names.block_name(block));
            self.report(Problem::P4305, span, message).help = Some(format!("Draw a line to the box, or write `{input} := …`."));
            return None;
        }
        let flow = match (&one.flow, power) {
            (Some(said), _) => said.text.clone(),
            (None, Some((_, output))) => output.to_owned(),
            (None, None) => ENO.to_owned(),
        };
        let wants_eno = one.goes_on != GoesOn::Nothing && flow.eq_ignore_ascii_case(ENO);
        let goes = one.goes_on.wire();
        let mut arguments = pins.inputs.clone();
        arguments.extend(pins.outputs.iter().cloned());
        let mut otherwise = Vec::new();
        let mut after: Vec<(Expression, Expression)> = Vec::new();
        let enable = match &pins.enable {
            Some(enable) => Some(self.enable(enable, one.network)?),
            None => None,
        };
        if let (Some(wire), true) = (goes, wants_eno) {
            self.carry(wire, DataType::Bool, Scalar::Bool, span);
            let line = Expression { kind: ExpressionKind::Wire(wire), span };
            arguments.push(delivered(ENO, line.clone(), span));
            after.extend(pins.eno.clone().map(|target| (target, line.clone())));
            otherwise.extend(self.assigned(&line, &truth(false, span), span));
        } else if let Some(target) = &pins.eno {
            arguments.push(delivered(ENO, target.clone(), span));
            otherwise.extend(self.assigned(target, &truth(false, span), span));
        }
        let call = Call { callee: instance.clone(), arguments };
        let kind = self.call_statement(&call, span)?;
        let mut all = vec![self.enabled(enable, vec![Statement { kind, span }], otherwise, span)];
        for (target, value) in after {
            all.extend(self.assigned(&target, &value, span));
        }
        if let (Some(wire), false) = (goes, wants_eno) {
            let output = Name { text: flow.clone(), quoting: Quoting::Bare, span: one.flow.as_ref().map_or(span, |flow| flow.span) };
            let output = Expression { kind: ExpressionKind::Member(Box::new(instance.clone()), output), span };
            let typed = self.expression(&output);
            if let Typed::Scalar { data_type, .. } = &typed
                && matches!(one.goes_on, GoesOn::Line(_))
                && *data_type != DataType::Bool
            {
                let message = format!("a line goes on with a BOOL, and `{flow}` is {}", self.words(data_type));
                self.report(Problem::P4302, span, message);
                return None;
            }
            let kind = self.onto(wire, typed, span);
            all.extend(kind.map(|kind| Statement { kind, span }));
        }
        Some(in_one(all))
    }

    /// Puts the line from the left onto its pin.
    fn power_in(&mut self, one: &DiagramBox, pin: Option<String>, pins: &mut Pins, span: Span) -> Option<()> {
        let Some(power) = &one.power else { return Some(()) };
        let pin = pin.unwrap_or_else(|| EN.to_owned());
        let written = match pin.eq_ignore_ascii_case(EN) {
            true => pins.enable.as_ref().map(|enable| enable.span),
            false => pins.inputs.iter().find(|input| input.name.as_ref().is_some_and(|name| name.is(&pin))).map(|input| input.span),
        };
        if let Some(written) = written {
            let message = format!("`{pin}` is wired twice: by the line from the left and by its own pin");
            let diagnostic = self.report(Problem::P3011, written, message);
            diagnostic.related.push((power.span, "the line from the left".to_owned()));
            return None;
        }
        if pin.eq_ignore_ascii_case(EN) {
            pins.enable = Some(power.clone());
            return Some(());
        }
        let place = one.power_pin.as_ref().map_or(span, |pin| pin.span);
        let argument =
            Argument { name: Some(bare(&pin, place)), direction: Direction::Assigned, value: Some(power.clone()), span: power.span };
        pins.inputs.insert(0, argument);
        Some(())
    }

    /// Gives inputs without a name that of the next input of the interface.
    fn name_inputs(&mut self, pins: &mut Pins, interface: &Interface, of: &str) -> Option<()> {
        let takes = |section| matches!(section, Section::Input | Section::InOut);
        let mut declared: Vec<_> = interface.parameters().filter(|formal| takes(formal.section)).collect();
        declared.sort_by_key(|formal| formal.span.start);
        for index in 0..pins.inputs.len() {
            if pins.inputs[index].name.is_some() {
                continue;
            }
            let is_given = |name: &str| pins.inputs.iter().any(|input| input.name.as_ref().is_some_and(|one| one.is(name)));
            let Some(next) = declared.iter().find(|formal| !is_given(&formal.name)) else {
                let (has, given) = (declared.len(), pins.inputs.len());
                let message = format!("`{of}` takes {has} {}, and {given} are wired", if has == 1 { "input" } else { "inputs" });
                let names: Vec<String> = declared.iter().map(|formal| format!("`{}`", formal.name)).collect();
                let help = if names.is_empty() { "It has none.".to_owned() } else { format!("Its inputs are {}.", names.join(", ")) };
                self.report(Problem::P3009, pins.inputs[index].span, message).help = Some(help);
                return None;
            };
            pins.inputs[index].name = Some(bare(&next.name, pins.inputs[index].span));
        }
        Some(())
    }

    /// A function or an operator.
    fn function_box(&mut self, one: &DiagramBox, span: Span) -> Option<StatementKind> {
        let called = self.quietly(|checker| checker.called(&one.of));
        if let (Called::Standard(_), ExpressionKind::Name(name)) = (&called, &one.of.kind)
            && self.is_of_s7(name)
        {
            return None;
        }
        let interface = match &called {
            Called::Function(block) | Called::Method(block, _) => self.names.interface(*block),
            _ => None,
        };
        let mut pins = Pins::of(one, |name| is_flow(name, interface.as_deref()));
        self.power_in(one, one.power_pin.as_ref().map(|pin| pin.text.clone()), &mut pins, span)?;
        if let Some(first) = &one.instance {
            // `ABS x`: the first operand stands where a function block has its instance.
            let argument = Argument { name: None, direction: Direction::Assigned, value: Some(first.clone()), span: first.span };
            pins.inputs.insert(0, argument);
        }
        let own = match &one.of.kind {
            ExpressionKind::Name(name) => name.text.clone(),
            _ => String::new(),
        };
        let provided = interface.is_none().then(|| standard_pins::Pins::of_standard(&own, self.dialect)).flatten();
        let found = |name: &Name| interface.as_ref().and_then(|interface| interface.variable(&name.text));
        let is_output = |name: &Name| match &provided {
            Some(provided) => provided.has_output(&name.text),
            None => found(name).is_some_and(|variable| matches!(variable.section, Section::Output | Section::InOut)),
        };
        // Of functions without an interface only some names of pins are known.
        pins.split_result(&own, is_output, |name| interface.is_none() || found(name).is_some());
        // Inputs by position beside outputs by name: not every dialect has that in a call, and every box does.
        if let Some(interface) = &interface {
            self.name_inputs(&mut pins, interface, &own)?;
        }
        let mut arguments = pins.inputs.clone();
        arguments.extend(pins.outputs.iter().cloned());
        let plain = Call { callee: one.of.clone(), arguments };
        let has_result = match &interface {
            Some(interface) => interface.variables.iter().any(|variable| variable.section == Section::Return),
            None => !matches!(called, Called::Action(_)),
        };
        let is_own = matches!(called, Called::Function(_) | Called::Method(..));
        let value = |arguments: Vec<Argument>| {
            let call = Call { callee: plain.callee.clone(), arguments };
            Expression { kind: ExpressionKind::Call(Box::new(call)), span }
        };
        let result = match has_result {
            true => self.quietly(|checker| checker.expression(&value(plain.arguments.clone()))),
            false => Typed::Poison,
        };
        let is_bit = matches!(&result, Typed::Scalar { data_type: DataType::Bool, .. });
        let said = one.flow.as_ref();
        let names_result = |name: &Name| name.is(RESULT) || name.is(&own);
        let goes_result = match (one.goes_on, said) {
            (GoesOn::Nothing, _) => false,
            (_, Some(said)) => names_result(said),
            (GoesOn::Line(_), None) => is_bit && pins.results.is_empty(),
            (GoesOn::Value(_), None) => has_result && pins.results.is_empty(),
        };
        let goes_eno = one.goes_on != GoesOn::Nothing && !goes_result;
        if let Some(said) = said.filter(|said| goes_eno && !said.is(ENO)) {
            let message = format!("the line cannot go on from `{}` of `{own}`", said.text);
            self.report(Problem::P3009, said.span, message).help =
                Some("It goes on from `OUT`, the result, or from `ENO`; assign other outputs to variables.".to_owned());
            return None;
        }
        let enable = match &pins.enable {
            Some(enable) => Some(self.enable(enable, one.network)?),
            None => None,
        };
        // ENO goes to a place of its own first.
        let eno = match one.goes_on.wire().filter(|_| goes_eno) {
            Some(wire) => {
                self.carry(wire, DataType::Bool, Scalar::Bool, span);
                Some(Expression { kind: ExpressionKind::Wire(wire), span })
            }
            None => None,
        };
        let told = [eno, pins.eno.clone()];
        let told: Vec<Expression> = told.into_iter().flatten().collect();
        let mut arguments = plain.arguments.clone();
        if let Some(first) = told.first().filter(|_| is_own) {
            arguments.push(delivered(ENO, first.clone(), span));
        }
        // MOVE hands on what it gets, also a constant that has its type from where it goes.
        let moved = match (pins.inputs.as_slice(), &called) {
            ([only], Called::Standard(_)) if own.eq_ignore_ascii_case("MOVE") && !goes_result && pins.outputs.is_empty() => {
                only.value.clone().filter(|_| only.name.as_ref().is_none_or(|name| name.is("IN")))
            }
            _ => None,
        };
        let call = moved.unwrap_or_else(|| value(arguments));
        let (body, mut otherwise) = self.results(one, &pins, &call, has_result && result != Typed::Poison, goes_result, span)?;
        let mut all = Vec::new();
        match told.first() {
            Some(first) if is_own => {
                otherwise.extend(self.assigned(first, &truth(false, span), span));
                all.push(self.enabled(enable, body, otherwise, span));
            }
            Some(first) => {
                let target = self.target(first)?;
                if target.data_type != DataType::Bool {
                    let message = format!("ENO is BOOL, and `{}` is {}", target.name, self.words(&target.data_type));
                    self.report(Problem::P4011, first.span, message);
                    return None;
                }
                let kind = self.around(enable, Some(target), body, otherwise, span);
                all.push(Statement { kind, span });
            }
            None => all.push(self.enabled(enable, body, otherwise, span)),
        }
        if let [first, second] = told.as_slice() {
            all.extend(self.assigned(second, first, span));
        }
        Some(in_one(all))
    }

    /// Whether a box is one of S7 blocks only, which is said.
    fn is_of_s7(&mut self, name: &Name) -> bool {
        let upper = name.text.to_ascii_uppercase();
        if !elements::is_box(&upper) || standard::catalogue::page(&name.text).is_some() {
            return false;
        }
        let message = format!("`{}` is a box of S7 blocks: diagrams of IEC 61131-3 do not have it", name.text);
        let timer = TimerKind::ALL.iter().any(|row| row.2 == upper);
        let counter = CounterKind::ALL.iter().any(|row| row.1 == upper);
        let function = upper.split('_').next().filter(|function| standard::catalogue::page(function).is_some());
        let help = match function {
            _ if timer => "Draw a box TON, TOF or TP with an instance.".to_owned(),
            _ if counter => "Draw a box CTU, CTD or CTUD with an instance.".to_owned(),
            _ if upper == "CALL" => "Write the name of the function, or of the function block and its instance, as the box.".to_owned(),
            Some(function) => format!("Draw the function `{function}`: it takes operands of any type that fits."),
            None => "Draw the function of Structured Text; `sieben explain functions` lists them.".to_owned(),
        };
        self.report(Problem::P2440, name.span, message).help = Some(help);
        true
    }

    /// What becomes of the result of a function, and what its targets get where it is not executed: a BOOL is FALSE then.
    fn results(
        &mut self,
        one: &DiagramBox,
        pins: &Pins,
        call: &Expression,
        has_result: bool,
        goes_on: bool,
        span: Span,
    ) -> Option<(Vec<Statement>, Vec<Statement>)> {
        let mut body = Vec::new();
        let mut otherwise = Vec::new();
        let statement = |kind| Statement { kind, span };
        let no = truth(false, span);
        match (one.goes_on.wire().filter(|_| goes_on), pins.results.as_slice()) {
            (Some(wire), others) => {
                let typed = self.expression(call);
                if let Typed::Scalar { data_type, .. } = &typed
                    && matches!(one.goes_on, GoesOn::Line(_))
                    && *data_type != DataType::Bool
                {
                    let message = format!("a line goes on with a BOOL, and this result is {}", self.words(data_type));
                    self.report(Problem::P4302, span, message);
                    return None;
                }
                let kind = self.onto(wire, typed, span);
                let nothing = match (&kind, self.wires.get(&wire)) {
                    (Some(_), Some(Carried::Kept(target, scalar))) => {
                        let value = Value { kind: ValueKind::Constant(0), scalar: *scalar, span };
                        Some(StatementKind::Assign { target: target.place.clone(), value })
                    }
                    _ => None,
                };
                body.extend(kind.map(statement));
                otherwise.extend(nothing.map(statement));
                let line = Expression { kind: ExpressionKind::Wire(wire), span };
                for target in others {
                    body.extend(self.assigned(target, &line, span));
                    otherwise.extend(self.if_bit(target, &no, span));
                }
            }
            (None, []) if has_result => {
                // Only ENO is of interest: the operation is carried out all the same.
                let typed = self.expression(call);
                let (value, _) = self.scalar(typed, span)?;
                body.push(self.kept(value).0);
            }
            (None, []) => {
                let ExpressionKind::Call(inner) = &call.kind else { return None };
                body.push(statement(self.call_statement(inner, span)?));
            }
            (None, [first, others @ ..]) => {
                body.push(statement(self.assign(first, call, span)?));
                otherwise.extend(self.if_bit(first, &no, span));
                for target in others {
                    body.extend(self.assigned(target, first, span));
                    otherwise.extend(self.if_bit(target, &no, span));
                }
            }
        }
        for output in pins.outputs.iter().filter_map(|output| output.value.as_ref()) {
            otherwise.extend(self.if_bit(output, &no, span));
        }
        Some((body, otherwise))
    }

    /// The assignment of FALSE to a variable that is a BOOL.
    fn if_bit(&mut self, target: &Expression, value: &Expression, span: Span) -> Option<Statement> {
        let is_bit = matches!(self.quietly(|checker| checker.reach(target)), Reached::Target(Target { data_type: DataType::Bool, .. }));
        if is_bit { self.assigned(target, value, span) } else { None }
    }

    fn assigned(&mut self, target: &Expression, value: &Expression, span: Span) -> Option<Statement> {
        self.assign(target, value, span).map(|kind| Statement { kind, span })
    }

    /// Statements under EN.
    fn enabled(&mut self, enable: Option<Value>, mut body: Vec<Statement>, otherwise: Vec<Statement>, span: Span) -> Statement {
        let kind = match enable {
            Some(enable) => StatementKind::If { branches: vec![(enable, body)], otherwise },
            None => match (body.pop(), body.is_empty()) {
                (Some(only), true) => return only,
                (last, _) => {
                    body.extend(last);
                    StatementKind::Block(body)
                }
            },
        };
        Statement { kind, span }
    }
}

/// What is wired to the pins of a box, sorted.
struct Pins {
    enable: Option<Expression>,
    eno: Option<Expression>,
    inputs: Vec<Argument>,
    /// Outputs other than the result.
    outputs: Vec<Argument>,
    /// What the result is assigned to.
    results: Vec<Expression>,
}

impl Pins {
    /// EN and ENO apart from the others.
    fn of(one: &DiagramBox, is_flow: impl Fn(&Name) -> bool) -> Self {
        let flow = |argument: &&Argument| argument.name.as_ref().is_some_and(&is_flow);
        let value = |argument: &Argument| argument.value.clone();
        Self {
            enable: one.inputs.iter().find(flow).and_then(value),
            eno: one.outputs.iter().find(flow).and_then(value),
            inputs: one.inputs.iter().filter(|argument| !flow(argument)).cloned().collect(),
            outputs: one.outputs.iter().filter(|argument| !flow(argument)).cloned().collect(),
            results: Vec::new(),
        }
    }

    /// The result apart from the other outputs: it has no name, that of the function, or OUT.
    fn split_result(&mut self, own: &str, is_output: impl Fn(&Name) -> bool, is_known: impl Fn(&Name) -> bool) {
        for mut output in std::mem::take(&mut self.outputs) {
            let Some(name) = &output.name else {
                self.results.extend(output.value);
                continue;
            };
            if is_output(name) {
                self.outputs.push(output);
            } else if name.is(RESULT) || name.is(own) {
                self.results.extend(output.value);
            } else if !is_known(name) || self.by_position() {
                // `ADD a, b => c`: what stands before the arrow is the last input.
                let value = Expression { kind: ExpressionKind::Name(name.clone()), span: name.span };
                let span = value.span;
                self.inputs.push(Argument { name: None, direction: Direction::Assigned, value: Some(value), span });
                self.results.extend(output.value.take());
            } else {
                self.outputs.push(output);
            }
        }
    }

    /// No input has a name.
    fn by_position(&self) -> bool {
        self.inputs.iter().all(|input| input.name.is_none())
    }
}

/// EN or ENO, unless the interface has a parameter of that name.
fn is_flow(name: &Name, interface: Option<&Interface>) -> bool {
    (name.is(EN) || name.is(ENO)) && interface.is_none_or(|interface| interface.variable(&name.text).is_none())
}

fn bare(text: &str, span: Span) -> Name {
    Name { text: text.to_owned(), quoting: Quoting::Bare, span }
}

fn delivered(name: &str, target: Expression, span: Span) -> Argument {
    Argument { name: Some(bare(name, span)), direction: Direction::Delivered, value: Some(target), span }
}

fn truth(value: bool, span: Span) -> Expression {
    Expression { kind: ExpressionKind::Literal(Literal { kind: LiteralKind::Bool(value), prefix: None }), span }
}

/// Whether a statement is a box of which somebody asks whether it went well.
pub(super) fn asks_eno(statement: &ast::Statement) -> bool {
    let ast::StatementKind::Box(one) = &statement.kind else { return false };
    let named = one.outputs.iter().any(|output| output.name.as_ref().is_some_and(|name| name.is(ENO)));
    let said = one.flow.as_ref().is_some_and(|flow| flow.is(ENO));
    // What goes on from a comparison is its result.
    let compares = matches!(&one.of.kind, ExpressionKind::Name(name) if COMPARISONS.iter().any(|one| name.is(one)));
    let goes = matches!(one.goes_on, GoesOn::Line(_)) && one.instance.is_none() && !compares || !one.outputs.is_empty();
    named || said || one.flow.is_none() && one.goes_on != GoesOn::Nothing && goes
}

/// Statements as one.
fn in_one(mut all: Vec<Statement>) -> StatementKind {
    match (all.pop(), all.is_empty()) {
        (Some(only), true) => only.kind,
        (last, _) => {
            all.extend(last);
            StatementKind::Block(all)
        }
    }
}
