//! A diagram → the statements that STEP 7 makes of it.

use super::boxes::CounterKind;
use super::model::{Actual, Alone, Branch, Content, Counter, Element, End, Kind, Line, Network, Output, OutputKind, Pin, Place, Rung};
use super::operand::Operand;
use super::pin_types::{PinType, TypedPin};
use super::statement::{Parameter, Passing, Statement};

/// The statements of a network.
#[derive(Clone, Debug, Default)]
pub struct Written {
    /// In their order, each with the place of the element that makes it.
    pub statements: Vec<Statement>,
    /// What the operand of each statement is wired to; `None` for one that the diagram does not show.
    pub pins: Vec<Option<TypedPin>>,
    /// The first bit of local data after those that T-branches and the pins of calls take.
    pub scratch_end: u32,
}

/// Writes a network. `scratch` is the first free bit of local data, its byte times 8; `labels` counts the generated labels of the whole block.
///
/// Elements that only diagrams of IEC 61131-3 have stand for no statement and are left out.
pub fn write(network: &Network, scratch: u32, labels: &mut u32) -> Written {
    let mut writer = Writer {
        statements: Vec::new(),
        pins: Vec::new(),
        next_bit: scratch,
        labels,
        label: network.label.clone(),
        place: Place::default(),
    };
    match &network.content {
        Content::Empty => writer.put("NOP", "0"),
        Content::Alone(alone, place) => {
            writer.place = *place;
            writer.alone(alone);
        }
        Content::Rung(rung) => writer.rung(rung, Source { tap: None, from_left: false }),
    }
    Written { statements: writer.statements, pins: writer.pins, scratch_end: writer.next_bit }
}

/// How a bit of local data is written.
pub fn scratch_bit(bit: u32) -> Operand {
    Operand::from(format!("L {}.{}", bit / 8, bit % 8))
}

/// The number of a bit of local data, as [`scratch_bit`] writes it: its byte times 8, and the bit.
pub fn scratch_number(operand: &str) -> Option<u32> {
    let (byte, bit) = operand.strip_prefix('L')?.trim_start().split_once('.')?;
    let bit = bit.parse::<u32>().ok().filter(|bit| *bit < 8)?;
    byte.parse::<u32>().ok()?.checked_mul(8)?.checked_add(bit)
}

/// What comes after a value.
#[derive(Clone, Copy, PartialEq)]
enum Then {
    /// An output, a T-branch or the closing bracket: the value may stand bare.
    Output,
    /// More logic, a box or a slot.
    More,
    /// Nothing: it ends with a box whose output is open.
    End,
}

/// What a line may begin with.
#[derive(Clone, Copy)]
struct Source<'t> {
    /// The bit of the T-branch that the line belongs to.
    tap: Option<&'t Operand>,
    /// The tapped line comes from the left. Otherwise it is read where the diagram says so, and nowhere else.
    from_left: bool,
}

impl Source<'_> {
    /// For a line of its own: a branch, an input or a pin.
    fn inside(self) -> Self {
        Self { from_left: false, ..self }
    }
}

/// The operand that stands over a box, and what it has to be.
#[derive(Clone, Copy)]
struct Own<'o> {
    operand: &'o Operand,
    pin: TypedPin,
}

struct Writer<'l> {
    statements: Vec<Statement>,
    pins: Vec<Option<TypedPin>>,
    next_bit: u32,
    labels: &'l mut u32,
    /// The label of the statement that comes next.
    label: Option<Operand>,
    /// The place of the element that is written.
    place: Place,
}

impl Writer<'_> {
    fn push(&mut self, mut statement: Statement) {
        statement.label = self.label.take();
        statement.place = self.place;
        self.statements.push(statement);
        self.pins.push(None);
    }

    /// A statement whose operand is wired to a pin, or belongs to an element.
    fn wired(&mut self, mnemonic: &'static str, operand: &Operand, pin: Option<TypedPin>) {
        self.put(mnemonic, operand.clone());
        if let Some(last) = self.pins.last_mut() {
            *last = pin;
        }
    }

    /// A statement whose operand is that of an element itself.
    fn own(&mut self, mnemonic: &'static str, operand: &Operand, element: &'static str, takes: PinType) {
        self.wired(mnemonic, operand, Some(TypedPin::operand(element, takes)));
    }

    /// A statement with the operand that stands over a box.
    fn of_box(&mut self, mnemonic: &'static str, own: Own<'_>) {
        self.wired(mnemonic, own.operand, Some(own.pin));
    }

    /// A contact, by what it checks with.
    fn contact(&mut self, checks: &Checks, operand: &Operand, negated: bool) {
        self.own(checks.bit(negated), operand, if negated { "NC" } else { "NO" }, PinType::Contact);
    }

    fn put(&mut self, mnemonic: &'static str, operand: impl Into<Operand>) {
        self.push(Statement::new(mnemonic, operand));
    }

    fn alone(&mut self, alone: &Alone) {
        match alone {
            Alone::Open(block) => self.own("OPN", block, "OPN", PinType::Block),
            Alone::McrActivate => self.put("MCRA", ""),
            Alone::McrDeactivate => self.put("MCRD", ""),
            Alone::McrEnd => self.put(")MCR", ""),
            Alone::Jump(label) => self.put("JU", label.clone()),
            Alone::Call(block) => self.own("UC", block, "UC", PinType::Block),
            Alone::Return => {}
        }
    }

    fn rung(&mut self, rung: &Rung, source: Source<'_>) {
        match &rung.end {
            End::Open => self.value(&rung.line, Then::End, source),
            End::Outputs(outputs) => {
                if let Some(first) = outputs.first() {
                    self.place = first.place;
                }
                self.value(&rung.line, Then::Output, source);
                if source.from_left && rung.line.is_empty() {
                    self.put("BLD", "102");
                }
                outputs.iter().for_each(|output| self.output(output));
            }
            End::Branches(rungs) => {
                if let Some(place) = rungs.first().and_then(first_place) {
                    self.place = place;
                }
                self.value(&rung.line, Then::Output, source);
                let bit = scratch_bit(self.next_bit);
                self.next_bit += 1;
                self.put("=", bit.clone());
                for rung in rungs {
                    self.place = first_place(rung).unwrap_or(self.place);
                    self.rung(rung, Source { tap: Some(&bit), from_left: !reads_tap(&rung.line) });
                }
            }
        }
    }

    fn output(&mut self, output: &Output) {
        self.place = output.place;
        match &output.kind {
            OutputKind::Assign(operand) => self.own("=", operand, "COIL", PinType::Bit),
            OutputKind::Set(operand) => self.own("S", operand, "SET", PinType::Bit),
            OutputKind::Reset(operand) => self.own("R", operand, "RESET", PinType::Resettable),
            OutputKind::Save => self.put("SAVE", ""),
            OutputKind::Return => {
                self.put("SAVE", "");
                self.put("BEC", "");
            }
            OutputKind::Jump(label) => self.put("JC", label.clone()),
            OutputKind::JumpNot(label) => self.put("JCN", label.clone()),
            OutputKind::Call(block) => self.own("CC", block, "CC", PinType::Block),
            OutputKind::McrStart => self.put("MCR(", ""),
            OutputKind::Timer { kind, timer, value } => {
                self.wired("L", value, Some(TypedPin::time_of_coil(*kind)));
                self.own(kind.instruction(), timer, kind.instruction(), PinType::Timer);
            }
            OutputKind::SetCounter { counter, value } => {
                self.wired("L", value, Some(TypedPin::COUNT_OF_COIL));
                self.own("S", counter, "SC", PinType::Counter);
            }
            OutputKind::CountUp(counter) => self.own("CU", counter, "CU", PinType::Counter),
            OutputKind::CountDown(counter) => self.own("CD", counter, "CD", PinType::Counter),
            OutputKind::AssignNegated(_) | OutputKind::AssignEdge { .. } => {}
        }
    }

    /// The value of a line. Each box takes what stands to its left as its first input, in brackets if a box is in it.
    fn value(&mut self, line: &[Element], then: Then, source: Source<'_>) {
        let boxes: Vec<usize> = line.iter().enumerate().filter(|(_, one)| one.kind.is_box()).map(|(index, _)| index).collect();
        let Some(last) = boxes.last().copied() else { return self.series(line, then, source) };
        let ends = last + 1 == line.len();
        let bare = |index: usize| index == last && ends && then != Then::More;

        // What opens before the first box: brackets, and in each of them the logic at the pins of its call.
        let mut actuals: Vec<Vec<Parameter>> = Vec::new();
        for &index in boxes.iter().rev() {
            let Some(element) = line.get(index) else { continue };
            self.place = element.place;
            if !bare(index) {
                self.put("A(", "");
            }
            actuals.push(match &element.kind {
                Kind::Call { pins, .. } => self.parameters(pins, source),
                _ => Vec::new(),
            });
        }
        let mut done = 0;
        for &index in &boxes {
            let (Some(logic), Some(element)) = (line.get(done..index), line.get(index)) else { continue };
            self.place = element.place;
            if done == 0 {
                self.series(logic, Then::More, source);
            } else {
                logic.iter().for_each(|element| self.element(element, source));
            }
            let enabled = index > 0 || source.from_left;
            let used = !(bare(index) && then == Then::End);
            self.place = element.place;
            self.part(&element.kind, actuals.pop().unwrap_or_default(), enabled, used, source);
            if !bare(index) {
                self.put(")", "");
            }
            done = index + 1;
        }
        line.iter().skip(done).for_each(|element| self.element(element, source));
    }

    /// The value of a line without a box.
    fn series(&mut self, line: &[Element], then: Then, source: Source<'_>) {
        if source.from_left {
            self.put("A", source.tap.cloned().unwrap_or_default());
        } else if let ([only], true) = (line, then != Then::More)
            && !only.kind.is_negated()
        {
            return self.bare(only, source);
        }
        line.iter().for_each(|element| self.element(element, source));
    }

    /// An element that is combined by AND with what stands to its left.
    fn element(&mut self, element: &Element, source: Source<'_>) {
        self.operand(&AND, element, false, source);
    }

    /// An operand of A, O or X.
    fn operand(&mut self, checks: &Checks, element: &Element, circle: bool, source: Source<'_>) {
        self.place = element.place;
        let negated = element.kind.is_negated() || circle;
        match &element.kind {
            Kind::Contact { operand, .. } => self.contact(checks, operand, negated),
            Kind::Tap { .. } => self.put(checks.bit(negated), source.tap.cloned().unwrap_or_default()),
            Kind::Edge { .. } | Kind::Not | Kind::Midline { .. } => self.bare(element, source),
            _ => {
                self.put(checks.bracket(negated), "");
                self.bare(element, source);
                self.place = element.place;
                self.put(")", "");
            }
        }
    }

    /// An element without brackets around it.
    fn bare(&mut self, element: &Element, source: Source<'_>) {
        self.place = element.place;
        match &element.kind {
            Kind::Contact { operand, negated } => self.contact(&AND, operand, *negated),
            Kind::Tap { negated } => self.put(AND.bit(*negated), source.tap.cloned().unwrap_or_default()),
            Kind::Compare { operation, left, right, .. } => {
                let [first, second] = TypedPin::of_comparison(operation);
                self.wired("L", left, Some(first));
                self.wired("L", right, Some(second));
                self.put(operation, "");
            }
            Kind::Parallel { branches, .. } => self.parallel(branches, source),
            Kind::Xor { inputs, .. } => {
                for input in inputs {
                    self.input(&XOR, &input.line, input.negated, source);
                }
            }
            Kind::Group { line, .. } => self.value(line, Then::Output, source.inside()),
            Kind::Edge { falling, memory } => self.own(edge(*falling), memory, if *falling { "N" } else { "P" }, PinType::Bit),
            Kind::EdgeBox { falling, operand, memory } => {
                let word = if *falling { "NEG" } else { "POS" };
                self.own("A", operand, word, PinType::Contact);
                self.put("BLD", "100");
                self.own(edge(*falling), memory.as_ref().unwrap_or(&Operand::default()), word, PinType::Bit);
            }
            Kind::Not => self.put("NOT", ""),
            Kind::Midline { operand, negated } => {
                self.own("=", operand, "MID", PinType::Bit);
                self.own(AND.bit(*negated), operand, "MID", PinType::Bit);
            }
            Kind::Box { .. } | Kind::FlipFlop { .. } | Kind::Timer(_) | Kind::Counter(_) | Kind::Call { .. } => {
                self.value(std::slice::from_ref(element), Then::Output, source.inside());
            }
            Kind::Named(_) => {}
        }
    }

    /// A line as one operand of O or X.
    fn input(&mut self, checks: &Checks, line: &[Element], negated: bool, source: Source<'_>) {
        if let [only] = line
            && !(negated && only.kind.is_negated())
            && !matches!(only.kind, Kind::Edge { .. } | Kind::Not | Kind::Midline { .. })
        {
            return self.operand(checks, only, negated, source);
        }
        self.place = line.first().map_or(self.place, |one| one.place);
        self.put(checks.bracket(negated), "");
        self.value(line, Then::Output, source.inside());
        self.put(")", "");
    }

    fn parallel(&mut self, branches: &[Branch], source: Source<'_>) {
        let last_edge = branches.iter().rposition(|branch| branch.line.iter().any(|one| one.kind.holds_edge()));
        for (index, branch) in branches.iter().enumerate() {
            if branch.line.len() == 1 {
                self.input(&OR, &branch.line, false, source);
                continue;
            }
            let plain = may_stand_bare(branch, index, last_edge);
            self.place = branch.line.first().map_or(self.place, |one| one.place);
            if branch.bracketed || !plain {
                self.put("O(", "");
                self.value(&branch.line, Then::Output, source.inside());
                self.put(")", "");
            } else {
                if index > 0 {
                    self.put("O", "");
                }
                self.value(&branch.line, Then::More, source.inside());
            }
        }
    }

    /// The actual parameters of a call. Logic is evaluated before it, into bits of local data.
    fn parameters(&mut self, pins: &[Pin], source: Source<'_>) -> Vec<Parameter> {
        let mut parameters = Vec::new();
        for pin in pins {
            let (actual, passing) = match &pin.actual {
                Actual::Direct(actual) => (actual.clone(), Passing::In),
                Actual::Output(actual) => (actual.clone(), Passing::Out),
                Actual::Logic(line) => {
                    let place = self.place;
                    self.value(line, Then::More, source.inside());
                    self.place = place;
                    let bit = scratch_bit(self.next_bit);
                    self.next_bit += 1;
                    self.put("=", bit.clone());
                    self.put("BLD", "103");
                    (bit, Passing::In)
                }
            };
            parameters.push(Parameter { name: pin.name.clone(), actual, passing });
        }
        parameters
    }

    /// A box, after the logic to its left.
    fn part(&mut self, kind: &Kind, parameters: Vec<Parameter>, enabled: bool, used: bool, source: Source<'_>) {
        match kind {
            Kind::Box { row, inputs, output } => {
                let label = self.enable(enabled);
                let mut loads: Vec<(usize, &Operand)> = inputs.iter().enumerate().collect();
                if row.reversed {
                    loads.reverse();
                }
                loads.into_iter().for_each(|(index, input)| self.wired("L", input, TypedPin::of_box(row, index)));
                if !row.instruction.is_empty() {
                    self.put(row.instruction, "");
                }
                self.wired("T", output, TypedPin::of_box(row, row.inputs.len()));
                if used {
                    match row.overflows {
                        true => self.put("AN", "OV"),
                        false => self.put("SET", ""),
                    }
                    self.put("SAVE", "");
                    self.put("CLR", "");
                }
                self.end_of_box(label, used);
            }
            Kind::Call { block, instance, .. } => {
                let label = self.enable(enabled);
                self.push(Statement { instance: instance.clone(), parameters, ..Statement::new("CALL", block.clone()) });
                self.end_of_box(label, used);
            }
            Kind::FlipFlop { reset_first, operand, second } => {
                let (word, first, other) = if *reset_first { ("RS", "R", "S") } else { ("SR", "S", "R") };
                let own = Own { operand, pin: TypedPin::operand(word, PinType::Bit) };
                self.of_box(first, own);
                self.slot(second.as_ref(), other, own, source);
                self.q(used, own);
            }
            Kind::Timer(timer) => {
                let [time, remaining, decimal] = TypedPin::of_timer(timer.kind);
                self.wired("L", &timer.value, Some(time));
                let own = Own { operand: &timer.timer, pin: TypedPin::operand(timer.kind.box_name(), PinType::Timer) };
                self.of_box(timer.kind.instruction(), own);
                self.slot(timer.reset.as_ref(), "R", own, source);
                self.output_slot("L", own, timer.binary.as_ref(), remaining);
                self.output_slot("LC", own, timer.bcd.as_ref(), decimal);
                self.q(used, own);
            }
            Kind::Counter(counter) => self.counter(counter, used, source),
            _ => {}
        }
    }

    fn counter(&mut self, counter: &Counter, used: bool, source: Source<'_>) {
        let own = Own { operand: &counter.counter, pin: TypedPin::operand(counter.kind.box_name(), PinType::Counter) };
        let [preset, count, decimal] = TypedPin::of_counter(counter.kind);
        self.of_box(counter.kind.power_pin(), own);
        match counter.kind {
            CounterKind::UpDown => self.slot(counter.down.as_ref(), "CD", own, source),
            CounterKind::Up | CounterKind::Down => self.put("BLD", "101"),
        }
        match &counter.set {
            Some((line, value)) => {
                self.pin(line, source);
                self.wired("L", value, Some(preset));
                self.of_box("S", own);
            }
            None => {
                self.put("NOP", "0");
                self.put("NOP", "0");
            }
        }
        self.slot(counter.reset.as_ref(), "R", own, source);
        self.output_slot("L", own, counter.value.as_ref(), count);
        self.output_slot("LC", own, counter.bcd.as_ref(), decimal);
        self.q(used, own);
    }

    /// The logic at a pin; the statements after it belong to the box again.
    fn pin(&mut self, line: &Line, source: Source<'_>) {
        let place = self.place;
        self.value(line, Then::More, source.inside());
        self.place = place;
    }

    fn enable(&mut self, enabled: bool) -> Option<Operand> {
        if !enabled {
            return None;
        }
        *self.labels += 1;
        let label = Operand::from(format!("_{:03x}", *self.labels));
        self.put("JNB", label.clone());
        Some(label)
    }

    fn end_of_box(&mut self, label: Option<Operand>, used: bool) {
        // A label that waits already belongs to the network; then the box has none of its own.
        self.label = label.or(self.label.take());
        match used {
            true => self.put("A", "BR"),
            false => self.put("NOP", "0"),
        }
    }

    fn slot(&mut self, logic: Option<&Line>, instruction: &'static str, own: Own<'_>, source: Source<'_>) {
        match logic {
            Some(line) => {
                self.pin(line, source);
                self.of_box(instruction, own);
            }
            None => self.put("NOP", "0"),
        }
    }

    fn output_slot(&mut self, load: &'static str, own: Own<'_>, output: Option<&Operand>, pin: TypedPin) {
        match output {
            Some(output) => {
                self.of_box(load, own);
                self.wired("T", output, Some(pin));
            }
            None => self.put("NOP", "0"),
        }
    }

    fn q(&mut self, used: bool, own: Own<'_>) {
        match used {
            true => self.of_box("A", own),
            false => self.put("NOP", "0"),
        }
    }
}

/// A check and its relatives: `A`, `AN`, `A(`, `AN(`.
struct Checks([&'static str; 4]);

const AND: Checks = Checks(["A", "AN", "A(", "AN("]);
const OR: Checks = Checks(["O", "ON", "O(", "ON("]);
const XOR: Checks = Checks(["X", "XN", "X(", "XN("]);

impl Checks {
    fn bit(&self, negated: bool) -> &'static str {
        let [plain, not, ..] = self.0;
        if negated { not } else { plain }
    }

    fn bracket(&self, negated: bool) -> &'static str {
        let [.., plain, not] = self.0;
        if negated { not } else { plain }
    }
}

/// A branch of several elements needs no bracket of its own. Those up to the last one that holds an edge have one, the first one excepted;
/// so has one with NOT, a midline output or a box, which would act on the branches before it as well.
fn may_stand_bare(branch: &Branch, index: usize, last_edge: Option<usize>) -> bool {
    index == 0 || (last_edge.is_none_or(|last| index > last) && !branch.line.iter().any(|one| one.kind.acts_on_line()))
}

/// A branch keeps the flag of its bracket only where the bracket would otherwise be left out.
pub fn keep_needed_brackets(branches: &mut [Branch]) {
    let last_edge = branches.iter().rposition(|branch| branch.line.iter().any(|one| one.kind.holds_edge()));
    for (index, branch) in branches.iter_mut().enumerate() {
        branch.bracketed &= branch.line.len() > 1 && may_stand_bare(branch, index, last_edge);
    }
}

fn edge(falling: bool) -> &'static str {
    if falling { "FN" } else { "FP" }
}

/// The place of the first element or coil of a sub-rung.
fn first_place(rung: &Rung) -> Option<Place> {
    let mut rung = rung;
    loop {
        if let Some(element) = rung.line.first() {
            return Some(element.place);
        }
        match &rung.end {
            End::Open => return None,
            End::Outputs(outputs) => return outputs.first().map(|output| output.place),
            End::Branches(rungs) => rung = rungs.first()?,
        }
    }
}

/// The tapped line is read by an element of its own instead of coming from the left.
pub fn reads_tap(line: &[Element]) -> bool {
    tap_in(line).is_some()
}

/// The first element of a line that reads the tapped one.
pub fn tap_in(line: &[Element]) -> Option<&Element> {
    line.iter().find_map(|element| match &element.kind {
        Kind::Tap { .. } => Some(element),
        Kind::Parallel { branches, .. } => branches.iter().find_map(|branch| tap_in(&branch.line)),
        Kind::Xor { inputs, .. } => inputs.iter().find_map(|input| tap_in(&input.line)),
        Kind::Group { line, .. } => tap_in(line),
        _ => None,
    })
}
