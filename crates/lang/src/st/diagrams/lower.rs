//! Networks → statements of ST: each contact, box and expression is evaluated once, in the order of the text.
//!
//! What stands on a line is an expression that grows from left to right. Before something that writes is reached, or where several
//! read it, its value is kept on a wire.

use std::collections::{HashMap, HashSet};

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};

use super::read::Written;
use super::{Bodies, EdgeMemory, Language, Lowered, Memory};
use crate::network::model::{Alone, Branch as Parallel, Content, Element, End, Kind, Line, Network, Output, OutputKind, Place, Rung};
use crate::network::operand::Operand;
use crate::network::write::reads_tap;
use crate::st::ast::{
    AssignOperator, BinaryOperator, Branch, Contact, Expression, ExpressionKind, Literal, LiteralKind, Name, NetworkNumber, Quoting,
    Statement, StatementKind, UnaryOperator, Wire,
};
use crate::st::dialect::Dialect;
use crate::st::parser::fragment;

/// Lines inside each other: more would make the walk through them too deep.
const NESTING_MAX: usize = 100;

/// Operators inside each other before a value is kept on a wire, so that who walks an expression may recurse.
const HEIGHT_MAX: u32 = 50;

/// The source that a diagram stands in.
#[derive(Clone, Copy)]
pub(in crate::st) struct Source<'t> {
    pub(in crate::st) file: FileId,
    pub(in crate::st) text: &'t str,
    pub(in crate::st) dialect: Dialect,
}

/// The value of a line; `None` is TRUE: nothing was on it yet.
pub(super) type Value = Option<Tall>;

/// An expression with its height.
#[derive(Clone, Debug)]
pub(super) struct Tall {
    pub(super) expression: Expression,
    height: u32,
}

impl Tall {
    pub(super) fn flat(expression: Expression) -> Self {
        Self { expression, height: 0 }
    }
}

/// A body on its way to statements.
pub(in crate::st) struct Lowering<'t, 'n> {
    pub(super) source: Source<'t>,
    pub(super) language: Language,
    memory: Memory<'n>,
    /// Edge memories that the block has from other bodies.
    edges_before: usize,
    /// What the block declares, in upper case: such a name is no address.
    declared: &'n mut HashSet<String>,
    pub(super) diagnostics: &'n mut Vec<Diagnostic>,
    out: Lowered,
    /// Where statements go.
    pub(super) statements: Vec<Statement>,
    /// The network that is read.
    pub(super) number: NetworkNumber,
    /// The wires of the network.
    wires: u32,
    /// The instances that boxes of the body call: where each was called first.
    pub(super) called: HashMap<String, (Span, NetworkNumber)>,
    /// The line that the innermost T-branch taps.
    tap: Value,
    depth: usize,
}

impl<'t, 'n> Lowering<'t, 'n> {
    pub(in crate::st) fn new(
        source: Source<'t>,
        known: Bodies<'n>,
        declared: &'n mut HashSet<String>,
        diagnostics: &'n mut Vec<Diagnostic>,
    ) -> Self {
        let Bodies { language, memory, edges: edges_before } = known;
        let (out, statements) = (Lowered::default(), Vec::new());
        Self {
            source,
            language,
            memory,
            edges_before,
            declared,
            diagnostics,
            out,
            statements,
            number: NetworkNumber(0),
            wires: 0,
            called: HashMap::new(),
            tap: None,
            depth: 0,
        }
    }

    /// All that the networks come to.
    pub(in crate::st) fn finish(mut self) -> Lowered {
        self.out.statements = self.statements;
        self.out
    }

    /// All networks of a body, each with its place.
    pub(in crate::st) fn networks(&mut self, networks: &[Written]) {
        for written in networks {
            let span = self.span(written.place);
            let label = written.network.label.as_ref().map(|label| self.label(label, span));
            self.out.labels.extend(label);
        }
        for written in networks {
            self.language = written.language;
            self.number.0 += 1;
            self.network(&written.network, written.place);
        }
    }

    fn network(&mut self, network: &Network, place: Place) {
        self.wires = 0;
        self.tap = None;
        if let Some(label) = &network.label {
            let name = self.label(label, self.span(place));
            self.put(StatementKind::Label(name.clone()), name.span);
        }
        match &network.content {
            Content::Empty => {}
            Content::Alone(alone, place) => self.alone(alone, *place),
            Content::Rung(rung) => self.rung(rung, None),
        }
    }

    // Places, names and messages.

    pub(super) fn span(&self, place: Place) -> Span {
        let limit = u32::try_from(self.source.text.len()).unwrap_or(u32::MAX);
        let (first, last) = (place.first.min(limit), place.last.min(limit));
        Span::new(self.source.file, first, last.max(first))
    }

    /// A message about an element; it names the network.
    pub(super) fn report(&mut self, problem: Problem, span: Span, message: impl std::fmt::Display, help: &str) {
        self.diagnostics.push(Diagnostic::new(problem, span, format!("{}: {message}", self.number)).help(help));
    }

    /// Refuses an element of the S7.
    fn of_s7(&mut self, what: &str, place: Place, help: &str) {
        let span = self.span(place);
        let message = format!("{what} is an element of S7 blocks: diagrams of IEC 61131-3 do not have it");
        self.report(Problem::P2440, span, message, help);
    }

    pub(super) fn put(&mut self, kind: StatementKind, span: Span) {
        self.statements.push(Statement { kind, span });
    }

    /// Where an operand is written: its bytes in the source, where it may have spaces that it has not.
    fn written(&self, operand: &Operand) -> Option<(usize, usize)> {
        let start = operand.start? as usize;
        let mut rest = self.source.text.get(start..)?.char_indices().peekable();
        let mut end = start;
        for wanted in operand.text.chars() {
            while rest.next_if(|&(_, sign)| sign != wanted && (sign == ' ' || sign == '\t')).is_some() {}
            let (at, _) = rest.next_if(|&(_, sign)| sign == wanted)?;
            end = start + at + wanted.len_utf8();
        }
        Some((start, end))
    }

    /// What an operand is in ST.
    pub(super) fn operand(&mut self, operand: &Operand, place: Place) -> Expression {
        let span = self.span(place);
        let Some((start, end)) = self.written(operand) else {
            self.report(Problem::P2402, span, format!("`{operand}` cannot be read here"), "Write the operand on the line of its element.");
            return Expression { kind: ExpressionKind::Missing, span };
        };
        let (expression, mut diagnostics) = fragment(self.source, start, end, self.declared);
        self.diagnostics.append(&mut diagnostics);
        expression
    }

    /// A variable that is wired to a pin.
    pub(super) fn wired(&mut self, operand: &Operand, negated: bool, place: Place) -> Tall {
        let mut read = Some(Tall::flat(self.operand(operand, place)));
        if calls(operand) {
            self.settle(&mut read);
        }
        let read = self.or_true(read, self.span(place));
        self.circled(negated, read)
    }

    /// What a contact reads: a BOOL.
    fn contact(&mut self, operand: &Operand, place: Place) -> Tall {
        let operand = self.operand(operand, place);
        let span = operand.span;
        if matches!(operand.kind, ExpressionKind::Missing | ExpressionKind::Literal(Literal { kind: LiteralKind::Bool(_), .. })) {
            return Tall::flat(operand);
        }
        Tall::flat(Expression { kind: ExpressionKind::Contact(Box::new(Contact { operand, network: self.number })), span })
    }

    /// The place of an operand.
    pub(super) fn span_of(&self, operand: &Operand, otherwise: Span) -> Span {
        let spans = self.written(operand).and_then(|(start, end)| Some((u32::try_from(start).ok()?, u32::try_from(end).ok()?)));
        spans.map_or(otherwise, |(start, end)| Span::new(self.source.file, start, end))
    }

    /// A name that is written as it is: of a pin, of a label.
    pub(super) fn name(&self, operand: &Operand, otherwise: Span) -> Name {
        let span = self.span_of(operand, otherwise);
        let (text, quoting) = match operand.text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
            Some(inner) => (inner, Quoting::Global),
            None => (operand.text.as_str(), Quoting::Bare),
        };
        Name { text: text.to_owned(), quoting, span }
    }

    fn label(&self, label: &Operand, otherwise: Span) -> Name {
        Name { quoting: Quoting::Bare, ..self.name(label, otherwise) }
    }

    // Values.

    /// Keeps a value on a wire, unless reading it again gives the same anyway.
    pub(super) fn settle(&mut self, value: &mut Value) {
        let Some(tall) = value else { return };
        if matches!(tall.expression.kind, ExpressionKind::Wire(_) | ExpressionKind::Literal(_) | ExpressionKind::Missing) {
            return;
        }
        let span = tall.expression.span;
        let wire = self.wire();
        let expression = std::mem::replace(&mut tall.expression, Expression { kind: ExpressionKind::Wire(wire), span });
        tall.height = 0;
        self.put(StatementKind::Wire(wire, expression), span);
    }

    /// A wire of its own.
    pub(super) fn wire(&mut self) -> Wire {
        let wire = Wire(self.wires);
        self.wires += 1;
        wire
    }

    /// Two values with an operator between them; TRUE on a line is neutral to AND.
    fn both(&mut self, operator: BinaryOperator, left: Value, right: Tall) -> Tall {
        let Some(left) = left else { return right };
        let span = left.expression.span.to(right.expression.span);
        let sign = Span { start: left.expression.span.end, end: left.expression.span.end, ..span };
        let height = left.height.max(right.height) + 1;
        let (left, right) = (Box::new(left.expression), Box::new(right.expression));
        let mut value = Some(Tall { expression: Expression { kind: ExpressionKind::Binary(operator, sign, left, right), span }, height });
        if height >= HEIGHT_MAX {
            self.settle(&mut value);
        }
        value.unwrap_or_else(|| Tall::flat(Expression { kind: ExpressionKind::Missing, span }))
    }

    fn and(&mut self, left: Value, right: Tall) -> Value {
        Some(self.both(BinaryOperator::And, left, right))
    }

    pub(super) fn not(&self, value: Tall) -> Tall {
        let span = value.expression.span;
        let kind = ExpressionKind::Unary(UnaryOperator::Not, Box::new(value.expression));
        Tall { expression: Expression { kind, span }, height: value.height + 1 }
    }

    fn circled(&self, negated: bool, value: Tall) -> Tall {
        if negated { self.not(value) } else { value }
    }

    /// A value, or TRUE where there is none.
    pub(super) fn or_true(&self, value: Value, span: Span) -> Tall {
        value.unwrap_or_else(|| Tall::flat(truth(true, span)))
    }

    // Rungs.

    fn alone(&mut self, alone: &Alone, place: Place) {
        let span = self.span(place);
        match alone {
            Alone::Jump(label) => self.jump(label, None, span),
            Alone::Return => self.put(StatementKind::Return, span),
            Alone::Call(_) => self.of_s7("UC", place, "Draw the call as a box: the name of the block, then its pins."),
            Alone::Open(_) => self.of_s7("OPN", place, "Name the variable of the data block itself."),
            Alone::McrActivate | Alone::McrDeactivate | Alone::McrEnd => {
                self.of_s7("the master control relay", place, "Put a contact before each coil, or jump over the networks.");
            }
        }
    }

    fn rung(&mut self, rung: &Rung, from: Value) {
        if !self.deeper(rung.line.first().map_or_else(Place::default, |element| element.place)) {
            return;
        }
        // In FBD a line that reads the tap itself does not begin with it.
        let start = if reads_tap(&rung.line) { None } else { from };
        let last_goes_on = !matches!(rung.end, End::Open);
        let value = self.line(&rung.line, start, last_goes_on);
        match &rung.end {
            End::Open => {}
            End::Outputs(outputs) => self.outputs(outputs, value),
            End::Branches(rungs) => {
                let mut value = value;
                if rungs.len() > 1 {
                    self.settle(&mut value);
                }
                let outer = std::mem::replace(&mut self.tap, value.clone());
                rungs.iter().for_each(|rung| self.rung(rung, value.clone()));
                self.tap = outer;
            }
        }
        self.depth -= 1;
    }

    fn deeper(&mut self, place: Place) -> bool {
        if self.depth < NESTING_MAX {
            self.depth += 1;
            return true;
        }
        let span = self.span(place);
        let message = format!("this diagram is nested more than {NESTING_MAX} levels deep");
        self.report(Problem::P6063, span, message, "Keep a part of it in a variable, in a network of its own.");
        false
    }

    fn outputs(&mut self, outputs: &[Output], mut value: Value) {
        if outputs.len() > 1 {
            self.settle(&mut value);
        }
        for output in outputs {
            self.output(output, value.clone());
        }
    }

    fn output(&mut self, output: &Output, value: Value) {
        let place = output.place;
        let span = self.span(place);
        let jumps = matches!(output.kind, OutputKind::Jump(_) | OutputKind::Return);
        if value.is_none() && self.language == Language::FunctionBlocks && !jumps {
            self.report(Problem::P2441, span, "nothing is wired to this coil", "Draw what it is to be assigned before it.");
            return;
        }
        let coil = AssignOperator::Coil(self.number);
        match &output.kind {
            OutputKind::Assign(operand) => self.assign(operand, coil, value, place),
            OutputKind::AssignNegated(operand) => {
                let value = self.or_true(value, span);
                let value = self.not(value);
                self.assign(operand, coil, Some(value), place);
            }
            OutputKind::AssignEdge { falling, operand } => {
                let edge = self.edge(value, *falling, None, place);
                self.assign(operand, coil, edge, place);
            }
            OutputKind::Set(operand) => self.assign(operand, AssignOperator::SetCoil(self.number), value, place),
            OutputKind::Reset(operand) => self.assign(operand, AssignOperator::ResetCoil(self.number), value, place),
            OutputKind::Return => self.under(value, StatementKind::Return, span),
            OutputKind::Jump(label) => self.jump(label, value, span),
            OutputKind::JumpNot(label) => {
                let value = self.or_true(value, span);
                let value = self.not(value);
                self.jump(label, Some(value), span);
            }
            OutputKind::Save => self.of_s7("SAVE", place, "Assign the line to ENO of the block, or to an output."),
            OutputKind::Call(_) => self.of_s7("CC", place, "Draw the call as a box with EN."),
            OutputKind::McrStart => {
                self.of_s7("the master control relay", place, "Put a contact before each coil, or jump over the networks.");
            }
            OutputKind::Timer { .. } => self.of_s7("a timer coil", place, "Draw a box TON, TOF or TP with an instance."),
            OutputKind::SetCounter { .. } | OutputKind::CountUp(_) | OutputKind::CountDown(_) => {
                self.of_s7("a counter coil", place, "Draw a box CTU, CTD or CTUD with an instance.");
            }
        }
    }

    fn assign(&mut self, operand: &Operand, operator: AssignOperator, value: Value, place: Place) {
        let span = self.span(place);
        let targets = vec![self.operand(operand, place)];
        let value = self.or_true(value, span).expression;
        self.put(StatementKind::Assign { targets, operator, value }, span);
    }

    /// A jump to a network of this body.
    fn jump(&mut self, label: &Operand, condition: Value, span: Span) {
        let label = self.label(label, span);
        if !self.out.labels.iter().any(|known| known.is(&label.text)) {
            let message = format!("no network of this diagram has the label `{}`", label.text);
            return self.report(Problem::P3004, label.span, message, "Write `LABEL name:` after NETWORK where the jump leads to.");
        }
        self.under(condition, StatementKind::Goto(label), span);
    }

    /// A statement under a condition.
    fn under(&mut self, condition: Value, kind: StatementKind, span: Span) {
        let Some(condition) = condition else { return self.put(kind, span) };
        let branches = vec![Branch { condition: condition.expression, body: vec![Statement { kind, span }] }];
        self.put(StatementKind::If { branches, otherwise: None }, span);
    }

    // Lines.

    /// What a line comes to; the last element of one that does not go on feeds nothing.
    pub(super) fn line(&mut self, line: &Line, from: Value, goes_on: bool) -> Value {
        let mut value = from;
        for (index, element) in line.iter().enumerate() {
            let feeds = goes_on || index + 1 < line.len();
            value = self.element(element, value, feeds);
        }
        value
    }

    fn element(&mut self, element: &Element, mut value: Value, feeds: bool) -> Value {
        let place = element.place;
        let span = self.span(place);
        match &element.kind {
            Kind::Contact { operand, negated } => {
                if calls(operand) {
                    self.settle(&mut value);
                }
                let mut read = Some(self.contact(operand, place));
                if calls(operand) {
                    self.settle(&mut read);
                }
                let read = self.or_true(read, span);
                let read = self.circled(*negated, read);
                self.and(value, read)
            }
            Kind::Compare { operation, left, right, negated } => {
                let compared = self.compare(operation, left, right, place);
                let compared = self.circled(*negated, compared);
                self.and(value, compared)
            }
            Kind::Parallel { branches, negated } => self.parallel(branches, *negated, value, place),
            Kind::Xor { inputs, negated } => {
                let lines: Vec<(&Line, bool)> = inputs.iter().map(|input| (&input.line, input.negated)).collect();
                self.group(BinaryOperator::Xor, &lines, *negated, value, place)
            }
            Kind::Group { line, negated } => self.group(BinaryOperator::And, &[(line, false)], *negated, value, place),
            Kind::Tap { negated } => {
                let tapped = self.or_true(self.tap.clone(), span);
                let tapped = self.circled(*negated, tapped);
                self.and(value, tapped)
            }
            Kind::Edge { falling, memory } => {
                let memory = (!memory.is_empty()).then_some(memory);
                self.edge(value, *falling, memory, place)
            }
            Kind::EdgeBox { falling, operand, memory } => {
                self.settle(&mut value);
                let watched = Some(self.contact(operand, place));
                let edge = self.edge(watched, *falling, memory.as_ref(), place);
                let edge = self.or_true(edge, span);
                self.and(value, edge)
            }
            Kind::Not => {
                let value = self.or_true(value, span);
                Some(self.not(value))
            }
            Kind::Midline { operand, negated } => {
                self.settle(&mut value);
                self.assign(operand, AssignOperator::Coil(self.number), value.clone(), place);
                match negated {
                    true => {
                        let value = self.or_true(value, span);
                        Some(self.not(value))
                    }
                    false => value,
                }
            }
            Kind::Named(one) => self.named(one, value, feeds, place),
            Kind::Box { row, .. } => {
                self.of_s7(&format!("`{}`", row.name), place, "Draw the function of ST, such as ADD, MOVE or INT_TO_REAL.");
                value
            }
            Kind::FlipFlop { .. } => {
                self.of_s7("SR or RS with an operand", place, "Declare an instance of SR or RS and name it after the word.");
                value
            }
            Kind::Timer(_) => {
                self.of_s7("a box of an S5 timer", place, "Draw a box TON, TOF or TP with an instance.");
                value
            }
            Kind::Counter(_) => {
                self.of_s7("a box of an S5 counter", place, "Draw a box CTU, CTD or CTUD with an instance.");
                value
            }
            Kind::Call { .. } => {
                self.of_s7("CALL", place, "Write the name of the function, or of the function block and its instance, as the box.");
                value
            }
        }
    }

    /// A comparison: `>I` is `>` whatever the types are.
    fn compare(&mut self, operation: &str, left: &Operand, right: &Operand, place: Place) -> Tall {
        let operator = match operation.trim_end_matches(['I', 'D', 'R']) {
            "<>" => BinaryOperator::NotEqual,
            ">" => BinaryOperator::Greater,
            "<" => BinaryOperator::Less,
            ">=" => BinaryOperator::GreaterEqual,
            "<=" => BinaryOperator::LessEqual,
            _ => BinaryOperator::Equal,
        };
        let (left, right) = (Tall::flat(self.operand(left, place)), Tall::flat(self.operand(right, place)));
        self.both(operator, Some(left), right)
    }

    /// Branches in parallel. In ladder their line comes from the left; in FBD they are inputs of a box of their own.
    fn parallel(&mut self, branches: &[Parallel], negated: bool, mut value: Value, place: Place) -> Value {
        let carried = |branch: &Parallel| branch.line.iter().any(|element| acts(&element.kind));
        let through = self.language == Language::Ladder && value.is_some() && branches.iter().any(carried);
        let lines: Vec<(&Line, bool)> = branches.iter().map(|branch| (&branch.line, false)).collect();
        if !through {
            return self.group(BinaryOperator::Or, &lines, negated, value, place);
        }
        self.settle(&mut value);
        let joined = self.joined(BinaryOperator::Or, &lines, value, place)?;
        Some(self.circled(negated, joined))
    }

    /// Lines that are evaluated by themselves and joined, then combined with what stands to their left.
    fn group(&mut self, operator: BinaryOperator, lines: &[(&Line, bool)], negated: bool, mut value: Value, place: Place) -> Value {
        if lines.iter().any(|(line, _)| has_effects(line)) {
            self.settle(&mut value);
        }
        let Some(joined) = self.joined(operator, lines, None, place) else { return value };
        let joined = self.circled(negated, joined);
        self.and(value, joined)
    }

    /// Lines joined by an operator: what was evaluated stays as it was when a later one writes something.
    fn joined(&mut self, operator: BinaryOperator, lines: &[(&Line, bool)], from: Value, place: Place) -> Option<Tall> {
        if !self.deeper(place) {
            return None;
        }
        let span = self.span(place);
        let mut joined: Value = None;
        for (line, negated) in lines {
            if has_effects(line) {
                self.settle(&mut joined);
            }
            let value = self.line(line, from.clone(), true);
            let value = self.or_true(value, span);
            let value = self.circled(*negated, value);
            joined = Some(self.both(operator, joined, value));
        }
        self.depth -= 1;
        joined
    }

    // Edges.

    /// TRUE for one scan after an edge of a value; without a memory of its own the edge gets one in the instance.
    fn edge(&mut self, value: Value, falling: bool, memory: Option<&Operand>, place: Place) -> Value {
        let span = self.span(place);
        let quiet = self.source.dialect.switches().quiet_f_trig;
        let memory = match memory {
            Some(memory) => self.operand(memory, place),
            None => {
                let Memory::Instance(block) = self.memory else {
                    let message =
                        "an edge remembers its line from one scan to the next, and nothing of this block lasts longer than a call";
                    self.report(Problem::P4301, span, message, "Draw it in a FUNCTION_BLOCK or PROGRAM, or give the edge as an input.");
                    return value;
                };
                let name = format!("__{}_EDGE{}", block.to_uppercase(), self.edges_before + self.out.edges.len() + 1);
                self.out.edges.push(EdgeMemory { name: name.clone(), begins_true: falling && quiet, span });
                Expression { kind: ExpressionKind::Name(Name { text: name, quoting: Quoting::Bare, span }), span }
            }
        };
        // The value as it makes an edge: turned round for a falling one, as F_TRIG does it.
        let now = self.or_true(value, span);
        let now = self.circled(falling, now);
        let mut now = Some(now);
        self.settle(&mut now);
        let now = self.or_true(now, span);
        let was = self.not(Tall::flat(memory.clone()));
        let mut edge = self.and(Some(now.clone()), was);
        self.settle(&mut edge);
        let (targets, operator) = (vec![memory], AssignOperator::Becomes);
        self.put(StatementKind::Assign { targets, operator, value: now.expression }, span);
        edge
    }
}

/// A constant of BOOL.
pub(super) fn truth(value: bool, span: Span) -> Expression {
    Expression { kind: ExpressionKind::Literal(Literal { kind: LiteralKind::Bool(value), prefix: None }), span }
}

/// An operand that calls something, which may write.
fn calls(operand: &Operand) -> bool {
    operand.text.contains('(')
}

/// An element that does something else with the line than to combine it by AND.
fn acts(kind: &Kind) -> bool {
    match kind {
        Kind::Parallel { branches, .. } => branches.iter().any(|branch| branch.line.iter().any(|element| acts(&element.kind))),
        kind => kind.acts_on_line(),
    }
}

/// Whether a line writes something: then what was read before it is kept.
pub(super) fn has_effects(line: &[Element]) -> bool {
    line.iter().any(|element| match &element.kind {
        Kind::Contact { operand, .. } => calls(operand),
        Kind::Compare { left, right, .. } => calls(left) || calls(right),
        Kind::Parallel { branches, .. } => branches.iter().any(|branch| has_effects(&branch.line)),
        Kind::Xor { inputs, .. } => inputs.iter().any(|input| has_effects(&input.line)),
        Kind::Group { line, .. } => has_effects(line),
        Kind::Tap { .. } | Kind::Not => false,
        _ => true,
    })
}
