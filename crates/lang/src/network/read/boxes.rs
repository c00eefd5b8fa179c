//! Boxes: with EN and ENO, calls, flip-flops, timers, counters.

use super::logic::Inside;
use super::rung::{Flow, Read, Reader};
use super::{Class, Mode};
use crate::network::boxes::{BoxRow, COMPARISONS, CounterKind, TimerKind};
use crate::network::model::{Actual, Counter, Kind, Line, Pin, Timer};
use crate::network::operand::Operand;
use crate::network::pin_types::TypedPin;
use crate::network::reasons::{Reason, Refusal, Rewrite};
use crate::network::statement::{Parameter, Passing};

/// How a box is written that is jumped over.
#[derive(Clone, Copy)]
enum Guard<'s> {
    /// It has no EN.
    None,
    /// JNB to this label.
    Label(&'s str),
}

impl<'s> Reader<'s> {
    /// A box that begins here joins the line; `None` if none does.
    pub(super) fn part(&mut self, line: &mut Line, has_string: bool, inside: Inside) -> Read<Option<Flow>> {
        let Some(statement) = self.current() else { return Ok(None) };
        let at = self.at;
        let operand = &statement.operand;
        match statement.mnemonic {
            "JNB" if has_string => {
                self.at += 1;
                self.enabled(line, at, Guard::Label(operand)).map(Some)
            }
            "JNB" => self.here(Reason::Logic),
            "CALL" if !has_string => self.enabled(line, at, Guard::None).map(Some),
            "L" if has_string => {
                if let (Some(kind), Some(started)) = (TimerKind::of(self.mnemonic_at(at + 1)), self.statement_at(at + 1)) {
                    if inside == Inside::Rung && self.is_coil(2, &started.operand) {
                        return Ok(None);
                    }
                    self.at += 2;
                    let (timer, flow) = self.timer(kind, operand.clone(), started.operand.clone())?;
                    line.push(timer.at(self.place(at, self.at - 1)));
                    return Ok(Some(flow));
                }
                if self.mnemonic_at(at + 1) == "S" { Ok(None) } else { self.here(Reason::Unconditional) }
            }
            "L" if self.is_comparison(at) => Ok(None),
            "L" => self.enabled(line, at, Guard::None).map(Some),
            "S" | "R" if has_string && !matches!(self.class(operand), Class::Timer | Class::Counter) => self.flip_flop(line, operand),
            "CU" | "CD" if has_string => {
                if inside == Inside::Rung && self.is_coil(1, operand) {
                    return Ok(None);
                }
                let (counter, flow) = self.counter(operand)?;
                line.push(counter.at(self.place(at, self.at - 1)));
                Ok(Some(flow))
            }
            "JC" | "JCN" if has_string && inside == Inside::Rung && self.rewriting() => self.jumped_over(line, operand),
            _ => Ok(None),
        }
    }

    /// What stands here, `count` statements long, is a coil and does not begin a box.
    pub(super) fn is_coil(&self, count: usize, operand: &Operand) -> bool {
        if self.coil_ends(count) {
            return true;
        }
        if !self.rewriting() || !self.is_outside_of_slots() || self.depth > 0 {
            return false;
        }
        // Several strings become several networks, unless what follows is a part of the box.
        let next = self.at + count;
        let Some(statement) = self.statement_at(next) else { return true };
        let fed = |instruction: &str| {
            let end = self.string_end(next);
            end > next && self.statement_at(end).is_some_and(|one| one.is(instruction, operand))
        };
        let is_placeholder = statement.is("NOP", "0") || statement.is("BLD", "101");
        match self.peek() {
            "CU" => !(is_placeholder || fed("CD")),
            "CD" => !statement.is("BLD", "101"),
            // A counter that is set has no box of its own.
            _ if self.mnemonic_at(self.at + 1) == "S" => true,
            _ => !(is_placeholder || (matches!(statement.mnemonic, "A" | "L" | "LC") && statement.operand == *operand) || fed("R")),
        }
    }

    /// A box with EN and ENO, or a call.
    fn enabled(&mut self, line: &mut Line, at: usize, guard: Guard<'s>) -> Read<Flow> {
        let (kind, begin) = (self.body()?, self.at);
        let mut boxes = vec![(kind, begin)];
        if self.rewriting() && self.peek() == "T" {
            self.more_stores(&mut boxes)?;
        }
        let Some((last, _)) = boxes.pop() else { return self.here(Reason::Store) };
        let several = !boxes.is_empty();
        for (kind, end) in boxes {
            line.push(kind.at(self.place(at, end.saturating_sub(1))));
        }
        let had_placeholder = self.rewrites.contains(&Rewrite::Placeholder);
        let flow = self.eno(&last, guard)?;
        if several && !had_placeholder {
            // The ends of boxes that were none before are part of that rewrite.
            self.rewrites.remove(&Rewrite::Placeholder);
        }
        line.push(last.at(self.place(at, self.at.saturating_sub(1))));
        Ok(flow)
    }

    /// Two stores of one load are two MOVE boxes, if the first one does not change what the second one loads.
    fn more_stores(&mut self, boxes: &mut Vec<(Kind, usize)>) -> Read<()> {
        let Some((Kind::Box { row, inputs, output }, _)) = boxes.first() else { return Ok(()) };
        let (row, inputs, mut stored) = (*row, inputs.clone(), output.clone());
        if !row.instruction.is_empty() || row.inputs.len() != inputs.len() {
            return Ok(());
        }
        while let Some(store) = self.current().filter(|one| one.mnemonic == "T") {
            let Some(input) = inputs.first() else { return Ok(()) };
            // A peripheral input may have another value when it is loaded again.
            if self.around.overlap(input, &stored) || input.to_ascii_uppercase().starts_with('P') {
                return self.here(Reason::Store);
            }
            self.at += 1;
            self.rewrite(Rewrite::TwoMoves);
            stored = store.operand.clone();
            boxes.push((Kind::Box { row, inputs: inputs.clone(), output: stored.clone() }, self.at));
        }
        Ok(())
    }

    /// What a box does: loads, an operation and a store, or a call.
    fn body(&mut self) -> Read<Kind> {
        let begin = self.at;
        match self.peek() {
            "CALL" => return Ok(self.call()),
            "L" => {}
            _ => return self.here(Reason::Mix),
        }
        let mut inputs = Vec::new();
        while let Some(load) = self.current().filter(|one| one.mnemonic == "L") {
            if inputs.len() == 2 {
                return self.here(Reason::Chain);
            }
            self.at += 1;
            inputs.push(load.operand.clone());
        }
        let name = self.peek();
        if COMPARISONS.contains(&name) {
            return self.here(Reason::Mix);
        }
        let row = match name {
            "T" if inputs.len() == 1 => BoxRow::of_instruction(""),
            "T" => return self.here(Reason::Store),
            "" => return self.before(Reason::Store),
            _ => BoxRow::of_instruction(name),
        };
        let Some(row) = row else { return self.before(Reason::Store) };
        if row.inputs.len() != inputs.len() {
            return self.here(Reason::Chain);
        }
        if name != "T" {
            self.at += 1;
        }
        let Some(store) = self.current().filter(|one| one.mnemonic == "T") else {
            let chain = self.peek() == "L"
                || COMPARISONS.contains(&self.peek())
                || (!self.ended() && BoxRow::of_instruction(self.peek()).is_some());
            return if self.ended() { self.before(Reason::Store) } else { self.here(if chain { Reason::Chain } else { Reason::Store }) };
        };
        self.at += 1;
        let output = store.operand.clone();
        let loads = inputs.len();
        if row.reversed {
            inputs.reverse();
        }
        // In the order of the statements, so that the first one is named that does not fit.
        for at in 0..=loads {
            let pin = if row.reversed && at < loads { loads - 1 - at } else { at };
            let place = if at == loads { self.at - 1 } else { begin + at };
            if let (Some(typed), Some(operand)) = (TypedPin::of_box(row, pin), inputs.iter().chain([&output]).nth(pin)) {
                self.fits(typed, operand, place)?;
            }
        }
        Ok(Kind::Box { row, inputs, output })
    }

    fn call(&mut self) -> Kind {
        let Some(statement) = self.current() else { return Kind::Not };
        self.at += 1;
        let mut pins = Vec::new();
        for Parameter { name, actual, passing } in &statement.parameters {
            let fed = self.around.scratch(actual).and_then(|bit| self.feeds.remove(&bit));
            let actual = match (fed, passing) {
                (Some(feed), _) => Actual::Logic(feed.line),
                (None, Passing::In) => Actual::Direct(actual.clone()),
                (None, Passing::Out) => Actual::Output(actual.clone()),
            };
            pins.push(Pin { name: name.clone(), actual });
        }
        Kind::Call { block: statement.operand.clone(), instance: statement.instance.clone(), pins }
    }

    /// The end of a box with EN and ENO.
    fn eno(&mut self, kind: &Kind, guard: Guard<'s>) -> Read<Flow> {
        if self.is("NOP", "0") && self.label_fits(guard) {
            return self.take_end(guard, Flow::Ended);
        }
        let is_call = matches!(kind, Kind::Call { .. });
        if is_call {
            if self.is("A", "BR") && self.label_fits(guard) {
                return self.take_end(guard, Flow::Goes);
            }
        } else if matches!(self.peek(), "AN" | "SET") && self.mnemonic_at(self.at + 1) == "SAVE" && self.mnemonic_at(self.at + 2) == "CLR" {
            let overflows = matches!(kind, Kind::Box { row, .. } if row.overflows);
            let right = if overflows { self.is("AN", "OV") } else { self.peek() == "SET" };
            if !right {
                return self.here(Reason::Eno);
            }
            self.at += 3;
            if !self.is("A", "BR") {
                return self.here(Reason::Eno);
            }
            if !self.label_fits(guard) {
                return self.here(Reason::Label);
            }
            return self.take_end(guard, Flow::Goes);
        }
        if let Guard::Label(_) = guard {
            return if (self.is("NOP", "0") || (is_call && self.is("A", "BR"))) && !self.label_fits(guard) {
                self.here(Reason::Label)
            } else {
                self.here(Reason::Eno)
            };
        }
        if self.rewriting() {
            self.rewrite(Rewrite::Placeholder);
            return Ok(Flow::Ended);
        }
        match self.peek() {
            "" => self.before(Reason::Nop),
            "T" => self.here(Reason::Store),
            name if matches!(name, "L" | "CALL") || name.starts_with('J') => self.here(Reason::Two),
            _ => self.here(Reason::Nop),
        }
    }

    /// The label of the statement here is the one that JNB jumps to; without JNB there is none.
    fn label_fits(&self, guard: Guard<'_>) -> bool {
        let own = self.current().and_then(|one| one.label.as_deref());
        match guard {
            Guard::None => own.is_none(),
            Guard::Label(label) => own == Some(label),
        }
    }

    fn take_end(&mut self, guard: Guard<'_>, flow: Flow) -> Read<Flow> {
        if let Guard::Label(_) = guard {
            self.box_labels.insert(self.at);
        }
        self.at += 1;
        Ok(flow)
    }

    /// `JCN lab; ‹boxes›; lab: NOP 0`: boxes that are jumped over have an EN.
    fn jumped_over(&mut self, line: &mut Line, label: &Operand) -> Read<Option<Flow>> {
        let at = self.at;
        let Some(target) = self.prepared.labels.get(label.text.as_str()).copied().filter(|target| *target > at) else { return Ok(None) };
        let ends = self.statement_at(target).is_some_and(|one| one.is("NOP", "0"));
        let is_plain =
            (at + 1..target).all(|index| self.statement_at(index).is_some_and(|one| one.label.is_none() && is_part_of_body(one.mnemonic)));
        if !ends || !is_plain || at + 1 == target || self.around.branch_result_matters() {
            return Ok(None);
        }
        let negated = self.peek() == "JC";
        self.at += 1;
        let mut boxes = Vec::new();
        while self.at < target {
            let begin = self.at;
            let kind = self.body()?;
            boxes.push(kind.at(self.place(begin, self.at.saturating_sub(1))));
        }
        if self.at != target {
            return self.refuse(Reason::Jump, at);
        }
        let Some(only) = boxes.pop().filter(|_| boxes.is_empty()) else { return self.refuse(Reason::Jump, at) };
        if negated {
            line.push(Kind::Not.at(self.place(at, at)));
        }
        self.enabling.insert(at);
        self.box_labels.insert(target);
        self.at += 1;
        self.rewrite(Rewrite::Enable);
        line.push(only.kind.at(self.place(at, target)));
        Ok(Some(Flow::Ended))
    }

    /// A slot of a box: `NOP 0`, or logic that ends with an instruction.
    fn slot(&mut self, instruction: &str, operand: &Operand, name: &str) -> Read<Option<Line>> {
        if self.is("NOP", "0") {
            self.at += 1;
            return Ok(None);
        }
        let end = self.string_end(self.at);
        if end == self.at || !self.statement_at(end).is_some_and(|one| one.is(instruction, operand)) {
            self.open_slot(name)?;
            return Ok(None);
        }
        let line = self.slot_logic()?;
        if line.is_empty() || !self.is(instruction, operand) {
            return self.here(Reason::Nop);
        }
        self.at += 1;
        Ok(Some(line))
    }

    fn slot_logic(&mut self) -> Read<Line> {
        self.slots += 1;
        let line = self.string(Line::new(), Inside::Bracket)?;
        self.slots -= 1;
        Ok(line)
    }

    /// A slot that is neither used nor marked as open.
    fn open_slot(&mut self, name: &str) -> Read<()> {
        if self.rewriting() {
            self.rewrite(Rewrite::Placeholder);
            return Ok(());
        }
        Err(Refusal { detail: format!("that of {name}"), ..Refusal::new(Reason::Nop, self.original(self.at)) })
    }

    /// `NOP 0`, or a load and a store.
    fn output_slot(&mut self, load: &str, operand: &Operand, pin: TypedPin) -> Read<Option<Operand>> {
        if self.is("NOP", "0") {
            self.at += 1;
            return Ok(None);
        }
        if self.is(load, operand)
            && let Some(store) = self.statement_at(self.at + 1).filter(|one| one.mnemonic == "T")
        {
            self.fits(pin, &store.operand, self.at + 1)?;
            self.at += 2;
            return Ok(Some(store.operand.clone()));
        }
        if matches!(self.peek(), "L" | "LC") && !self.rewriting() {
            return self.here(Reason::Order);
        }
        self.open_slot(pin.name)?;
        Ok(None)
    }

    fn q(&mut self, operand: &Operand) -> Read<Flow> {
        if self.is("NOP", "0") {
            self.at += 1;
            return Ok(Flow::Ended);
        }
        if self.is("A", operand) {
            self.at += 1;
            return Ok(Flow::Goes);
        }
        if self.current().is_some_and(|one| matches!(one.mnemonic, "L" | "LC") && one.operand == *operand) {
            return self.here(Reason::Order);
        }
        self.open_slot("Q")?;
        Ok(Flow::Ended)
    }

    fn timer(&mut self, kind: TimerKind, value: Operand, timer: Operand) -> Read<(Kind, Flow)> {
        let [time, remaining, decimal] = TypedPin::of_timer(kind);
        self.fits(time, &value, self.at.saturating_sub(2))?;
        let reset = self.slot("R", &timer, "R")?;
        let binary = self.output_slot("L", &timer, remaining)?;
        let bcd = self.output_slot("LC", &timer, decimal)?;
        let flow = self.q(&timer)?;
        Ok((Kind::Timer(Box::new(Timer { kind, timer, value, reset, binary, bcd })), flow))
    }

    fn counter(&mut self, name: &Operand) -> Read<(Kind, Flow)> {
        let up = self.peek() == "CU";
        self.at += 1;
        let (kind, down) = if self.is("BLD", "101") {
            self.at += 1;
            (if up { CounterKind::Up } else { CounterKind::Down }, None)
        } else {
            // Without it two boxes fit: S_CU and S_CUD.
            let end = self.string_end(self.at);
            let fed = self.statement_at(end).is_some_and(|one| one.is("CD", name));
            if !up || !(fed || self.is("NOP", "0")) {
                return Err(Refusal { detail: "that of CD, or BLD 101".to_owned(), ..Refusal::new(Reason::Nop, self.original(self.at)) });
            }
            (CounterKind::UpDown, self.slot("CD", name, "CD")?)
        };
        let [preset, count, decimal] = TypedPin::of_counter(kind);
        let set = self.set_slot(name, preset)?;
        let reset = self.slot("R", name, "R")?;
        let value = self.output_slot("L", name, count)?;
        let bcd = self.output_slot("LC", name, decimal)?;
        let flow = self.q(name)?;
        Ok((Kind::Counter(Box::new(Counter { kind, counter: name.clone(), down, set, reset, value, bcd })), flow))
    }

    /// `NOP 0; NOP 0`, or logic, the value and `S C n`.
    fn set_slot(&mut self, name: &Operand, pin: TypedPin) -> Read<Option<(Line, Operand)>> {
        if self.is("NOP", "0") {
            self.at += 1;
            if self.is("NOP", "0") {
                self.at += 1;
            } else {
                self.open_slot("PV")?;
            }
            return Ok(None);
        }
        let end = self.string_end(self.at);
        let fed = end > self.at && self.mnemonic_at(end) == "L" && self.statement_at(end + 1).is_some_and(|one| one.is("S", name));
        if !fed {
            self.open_slot("S")?;
            return Ok(None);
        }
        let line = self.slot_logic()?;
        let Some(load) = self.current().filter(|_| self.at == end && !line.is_empty()) else { return self.here(Reason::Nop) };
        self.fits(pin, &load.operand, self.at)?;
        self.at += 2;
        Ok(Some((line, load.operand.clone())))
    }

    /// SR or RS, if the other input and the slot of Q follow; otherwise a coil stands here.
    fn flip_flop(&mut self, line: &mut Line, operand: &Operand) -> Read<Option<Flow>> {
        let at = self.at;
        let reset_first = self.peek() == "R";
        let other = if reset_first { "S" } else { "R" };
        let is_q = |index: usize| self.statement_at(index).is_some_and(|one| one.is("NOP", "0") || one.is("A", operand));
        let second = if self.statement_at(at + 1).is_some_and(|one| one.is("NOP", "0")) && is_q(at + 2) {
            self.at += 2;
            None
        } else {
            let end = self.string_end(at + 1);
            if end == at + 1 || !self.statement_at(end).is_some_and(|one| one.is(other, operand)) {
                return Ok(None);
            }
            let ends = self.mode > Mode::Strict && self.statement_at(end + 1).is_none() && self.depth == 0 && self.is_outside_of_slots();
            if !is_q(end + 1) && !ends {
                return Ok(None);
            }
            self.at += 1;
            let logic = self.slot_logic()?;
            if self.at != end {
                return self.here(Reason::Two);
            }
            self.at += 1;
            Some(logic)
        };
        let flow = self.q(operand)?;
        line.push(Kind::FlipFlop { reset_first, operand: operand.clone(), second }.at(self.place(at, self.at.saturating_sub(1))));
        Ok(Some(flow))
    }
}

/// It belongs to a box with EN: loads, an operation, a store.
fn is_part_of_body(mnemonic: &str) -> bool {
    matches!(mnemonic, "L" | "T") || BoxRow::of_instruction(mnemonic).is_some()
}
