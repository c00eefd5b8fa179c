//! Strings of logic: checks, brackets, edges, comparisons.

use super::Mode;
use super::prepare::{is_check, is_opening};
use super::rung::{Flow, Named, Read, Reader, Tapped};
use crate::network::boxes::COMPARISONS;
use crate::network::model::{Branch, Element, Kind, Line, Place, XorInput};
use crate::network::pin_types::TypedPin;
use crate::network::reasons::{Reason, Rewrite};
use crate::network::write::keep_needed_brackets;

/// How many brackets a CPU keeps open.
const NESTING_MAX: usize = crate::network::rules::BRACKETS_MAX;

/// Whether logic stands in a bracket or a slot, where a tapped line is one operand among others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Inside {
    /// In a rung.
    Rung,
    /// In a bracket or a slot.
    Bracket,
}

/// A string so far: what the RLO says.
#[derive(Default)]
pub(super) struct Logic {
    /// Branches that are complete, each with whether it was in a bracket.
    terms: Vec<Branch>,
    /// Inputs of an exclusive OR.
    xor: Vec<XorInput>,
    /// The series that grows.
    series: Line,
    /// A bare `O` began the series.
    open: bool,
    /// Something was read.
    started: bool,
    /// The tapped line comes from the left of the series; the statement that reads it.
    left: Option<Place>,
    /// How many brackets lie inside one another because more logic came after a parallel.
    closed: usize,
}

impl Logic {
    /// The tapped line becomes an input of its own.
    fn take_left(&mut self) {
        if let Some(place) = self.left.take() {
            self.series.insert(0, Kind::Tap { negated: false }.at(place));
        }
    }
}

/// How an operand joins what the RLO says.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Joint {
    And,
    Or,
    Xor,
}

impl Joint {
    fn of(mnemonic: &str) -> Self {
        match mnemonic.as_bytes().first() {
            Some(b'O') => Self::Or,
            Some(b'X') => Self::Xor,
            _ => Self::And,
        }
    }
}

impl Reader<'_> {
    /// A string that goes on from a line.
    pub(super) fn string(&mut self, before: Line, inside: Inside) -> Read<Line> {
        let logic = Logic { started: !before.is_empty(), series: before, ..Logic::default() };
        self.finish(logic, inside)
    }

    /// A string on a tapped line, which was just read.
    pub(super) fn string_on_tap(&mut self, tap: usize, inside: Inside) -> Read<Line> {
        let left = Some(self.place(tap, tap));
        self.finish(Logic { started: true, left, ..Logic::default() }, inside)
    }

    fn finish(&mut self, mut logic: Logic, inside: Inside) -> Read<Line> {
        self.logic(&mut logic, inside)?;
        self.close(&mut logic)?;
        // Whether it can come from the left is decided when the whole rung is read.
        logic.take_left();
        Ok(logic.series)
    }

    /// What was read so far lies one bracket deeper.
    fn deeper(&self, logic: &mut Logic) -> Read<()> {
        logic.closed += 1;
        if self.depth + logic.closed > NESTING_MAX + 1 { self.refuse(Reason::Depth, self.at) } else { Ok(()) }
    }

    /// All that was read as one series.
    fn close(&mut self, logic: &mut Logic) -> Read<()> {
        if !logic.xor.is_empty() {
            let mut inputs = std::mem::take(&mut logic.xor);
            if let [_] = inputs.as_slice() {
                // An X that was the first check.
                self.rewrite(Rewrite::FirstCheck);
                logic.series = inputs.pop().map(|only| only.line).unwrap_or_default();
                return Ok(());
            }
            let place = around(inputs.iter().map(|input| input.line.as_slice()));
            self.deeper(logic)?;
            logic.series = vec![Kind::Xor { inputs, negated: false }.at(place)];
            return Ok(());
        }
        if logic.terms.is_empty() {
            return Ok(());
        }
        if !logic.series.is_empty() || logic.open {
            let line = std::mem::take(&mut logic.series);
            if line.len() == 1 && logic.open {
                // `O; A x` for `O x`.
                self.rewrite(Rewrite::Brackets);
            }
            logic.terms.push(Branch { line, bracketed: false });
        }
        logic.open = false;
        let mut branches = std::mem::take(&mut logic.terms);
        if let [_] = branches.as_slice() {
            self.rewrite(Rewrite::FirstCheck);
            logic.series = branches.pop().map(|only| only.line).unwrap_or_default();
            return Ok(());
        }
        keep_needed_brackets(&mut branches);
        let place = around(branches.iter().map(|branch| branch.line.as_slice()));
        self.deeper(logic)?;
        logic.series = vec![Kind::Parallel { branches, negated: false }.at(place)];
        Ok(())
    }

    fn logic(&mut self, logic: &mut Logic, inside: Inside) -> Read<()> {
        while let Some(statement) = self.current() {
            let at = self.at;
            match statement.mnemonic {
                // A second check of the tapped line begins the next sub-rung.
                "A" | "AN" if inside == Inside::Rung && logic.started && self.tap(&statement.operand).is_some() => return Ok(()),
                _ if is_check(statement) => self.check(logic)?,
                _ if is_opening(statement) => self.bracket(logic)?,
                "O" => self.bare_or(logic)?,
                "NOT" | "FP" | "FN" => {
                    if !logic.started {
                        return self.here(Reason::Logic);
                    }
                    if logic.open {
                        return self.here(Reason::Neg);
                    }
                    self.at += 1;
                    if !logic.terms.is_empty() || !logic.xor.is_empty() {
                        self.close(logic)?;
                        self.rewrite(Rewrite::Brackets);
                    }
                    let kind = match statement.mnemonic {
                        "NOT" => Kind::Not,
                        edge => Kind::Edge { falling: edge == "FN", memory: statement.operand.clone() },
                    };
                    logic.series.push(kind.at(self.place(at, at)));
                }
                "=" if logic.started && self.is_midline(at) => {
                    self.at += 2;
                    if !logic.terms.is_empty() || !logic.xor.is_empty() {
                        self.close(logic)?;
                        self.rewrite(Rewrite::Brackets);
                    }
                    let negated = self.mnemonic_at(at + 1) == "AN";
                    logic.series.push(Kind::Midline { operand: statement.operand.clone(), negated }.at(self.place(at, at + 1)));
                }
                "L" if !logic.started && self.is_comparison(at) => {
                    let compare = self.comparison()?;
                    logic.series.extend(compare);
                    logic.started = true;
                }
                _ => return Ok(()),
            }
        }
        Ok(())
    }

    fn comparison(&mut self) -> Read<Option<Element>> {
        let at = self.at;
        let operation = COMPARISONS.into_iter().find(|name| *name == self.mnemonic_at(at + 2));
        let (Some(left), Some(right), Some(operation)) = (self.statement_at(at), self.statement_at(at + 1), operation) else {
            return Ok(None);
        };
        let (left, right) = (left.operand.clone(), right.operand.clone());
        let [first, second] = TypedPin::of_comparison(operation);
        self.fits(first, &left, at)?;
        self.fits(second, &right, at + 1)?;
        self.at += 3;
        Ok(Some(Kind::Compare { operation, left, right, negated: false }.at(self.place(at, at + 2))))
    }

    /// `A x`, also with the edge of a POS or NEG box.
    fn check(&mut self, logic: &mut Logic) -> Read<()> {
        let at = self.at;
        let Some(statement) = self.current() else { return Ok(()) };
        self.at += 1;
        let negated = statement.mnemonic.ends_with('N');
        let kind = match self.tap(&statement.operand) {
            Some(tap) if tap == self.innermost_tap() => Kind::Tap { negated },
            // The line of an outer T-branch cannot be led past the inner one.
            Some(_) => return self.refuse(Reason::Back, at),
            None => Kind::contact(statement.operand.clone(), negated),
        };
        let mut element = kind.at(self.place(at, at));
        if self.peek() == "BLD"
            && self.operand() == "100"
            && let Some(edge) = self.statement_at(at + 2)
        {
            self.at += 2;
            let memory = Some(edge.operand.clone());
            element =
                Kind::EdgeBox { falling: edge.mnemonic == "FN", operand: statement.operand.clone(), memory }.at(self.place(at, at + 2));
        }
        self.combine(logic, Joint::of(statement.mnemonic), vec![element], Bracketed::No, self.place(at, at))
    }

    fn bracket(&mut self, logic: &mut Logic) -> Read<()> {
        let at = self.at;
        let mnemonic = self.peek();
        self.at += 1;
        self.depth += 1;
        if self.depth > NESTING_MAX {
            return self.refuse(Reason::Depth, at);
        }
        if self.peek() == ")" {
            return self.here(Reason::Bracket);
        }
        let (line, flow) = self.line(Tapped::No, Inside::Bracket)?;
        if self.ended() {
            return self.refuse(Reason::Bracket, at);
        }
        if self.peek() != ")" {
            return self.here(match self.peek() {
                "L" | "T" | "CALL" => Reason::Unconditional,
                _ => Reason::Two,
            });
        }
        if line.is_empty() {
            return self.here(Reason::Bracket);
        }
        if flow == Flow::Ended {
            // Nothing comes out of a box whose output is open.
            return self.refuse(Reason::Nop, self.at.saturating_sub(1));
        }
        self.at += 1;
        self.depth -= 1;
        let place = self.place(at, self.at - 1);
        let line = if mnemonic.contains('N') { negate(line, place) } else { line };
        self.combine(logic, Joint::of(mnemonic), line, Bracketed::Yes, place)
    }

    fn bare_or(&mut self, logic: &mut Logic) -> Read<()> {
        let at = self.at;
        if !logic.started {
            return self.here(Reason::Logic);
        }
        self.at += 1;
        if !logic.xor.is_empty() {
            self.close(logic)?;
        }
        logic.take_left();
        if !logic.series.is_empty() || logic.open {
            self.end_branch(logic);
        }
        logic.open = true;
        if !matches!(self.peek(), "A" | "AN" | "A(" | "AN(") {
            return self.refuse(Reason::Logic, at);
        }
        Ok(())
    }

    /// The series that grew becomes a branch.
    fn end_branch(&mut self, logic: &mut Logic) {
        let line = std::mem::take(&mut logic.series);
        if let [only] = line.as_slice() {
            // `A a; O b` for `O a; O b`, and `O; A b; O c` for `O b; O c`.
            let bare = logic.open || only.kind.is_box() || matches!(only.kind, Kind::Compare { .. });
            self.rewrite(if bare { Rewrite::Brackets } else { Rewrite::FirstCheck });
        }
        logic.terms.push(Branch { line, bracketed: false });
        logic.open = false;
    }

    /// Combines an operand with what the RLO says.
    fn combine(&mut self, logic: &mut Logic, joint: Joint, mut line: Line, bracketed: Bracketed, place: Place) -> Read<()> {
        let first = !logic.started;
        logic.started = true;
        match joint {
            Joint::And => {
                if !first && !logic.open && (!logic.terms.is_empty() || !logic.xor.is_empty()) {
                    let single = logic.terms.len() == 1 || logic.xor.len() == 1;
                    if !single {
                        let whole = logic.xor.is_empty() && self.depth == 0 && self.is_outside_of_slots();
                        self.rewrite(if whole { Rewrite::ParallelBracket } else { Rewrite::Brackets });
                    }
                    self.close(logic)?;
                }
                let fresh = logic.series.is_empty() && logic.left.is_none();
                if bracketed == Bracketed::Yes && !fresh && line.iter().any(|one| one.kind.acts_on_line()) {
                    logic.series.push(Kind::Group { line, negated: false }.at(place));
                } else {
                    logic.series.append(&mut line);
                }
            }
            Joint::Or => {
                if !logic.xor.is_empty() {
                    self.close(logic)?;
                    self.rewrite(Rewrite::Brackets);
                }
                logic.take_left();
                if !logic.series.is_empty() || logic.open {
                    self.end_branch(logic);
                }
                logic.terms.push(Branch { bracketed: bracketed == Bracketed::Yes && line.len() > 1, line });
            }
            Joint::Xor => {
                logic.take_left();
                if logic.xor.is_empty() && !first {
                    if !logic.terms.is_empty() {
                        self.rewrite(Rewrite::Brackets);
                    }
                    self.close(logic)?;
                    let line = std::mem::take(&mut logic.series);
                    if !line.is_empty() {
                        self.rewrite(if line.len() == 1 { Rewrite::FirstCheck } else { Rewrite::Brackets });
                        logic.xor.push(XorInput { line, negated: false });
                    }
                }
                logic.xor.push(XorInput { line, negated: false });
            }
        }
        Ok(())
    }

    /// `= x; A x`, where x is no bit of a T-branch.
    pub(super) fn is_midline(&self, at: usize) -> bool {
        let (Some(store), Some(check)) = (self.statement_at(at), self.statement_at(at + 1)) else { return false };
        store.mnemonic == "="
            && matches!(check.mnemonic, "A" | "AN")
            && check.operand == store.operand
            && check.label.is_none()
            && self.around.scratch(&store.operand).is_none()
            && !self.is_named_branch(at)
    }

    /// `= #t; A #t; …; A #t`: a T-branch whose bit has a name.
    pub(super) fn is_named_branch(&self, at: usize) -> bool {
        let Some(store) = self.statement_at(at) else { return false };
        self.mode > Mode::Strict
            && self.named == Named::Branches
            && self.around.is_temporary(&store.operand)
            && self.prepared.last_read.get(store.operand.text.as_str()).is_some_and(|last| *last > at + 1)
            && self.prepared.writes.get(store.operand.text.as_str()) == Some(&1)
    }

    pub(super) fn is_comparison(&self, at: usize) -> bool {
        self.mnemonic_at(at) == "L" && self.mnemonic_at(at + 1) == "L" && COMPARISONS.contains(&self.mnemonic_at(at + 2))
    }

    /// Where a string that begins here ends; without reading it.
    pub(super) fn string_end(&self, from: usize) -> usize {
        let mut at = from;
        if self.is_comparison(at) {
            at += 3;
        }
        while let Some(statement) = self.statement_at(at) {
            at = match statement.mnemonic {
                _ if is_opening(statement) => match self.prepared.closing.get(at).copied().flatten() {
                    Some(closing) => closing + 1,
                    None => return at,
                },
                _ if is_check(statement) => at + 1,
                "O" | "NOT" | "FP" | "FN" => at + 1,
                "BLD" if statement.operand == "100" => at + 1,
                "=" if at > from && self.is_midline(at) => at + 2,
                _ => return at,
            };
        }
        at
    }
}

/// Whether an operand stood in a bracket.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Bracketed {
    Yes,
    No,
}

/// From the first to the last element of several lines.
fn around<'l>(lines: impl DoubleEndedIterator<Item = &'l [Element]> + Clone) -> Place {
    let first = lines.clone().flatten().next().map_or(0, |one| one.place.first);
    let last = lines.rev().find_map(|line| line.last()).map_or(first, |one| one.place.last);
    Place { first, last }
}

/// The circle of a bracket.
fn negate(mut line: Line, place: Place) -> Line {
    if let [only] = line.as_mut_slice()
        && matches!(only.kind, Kind::Compare { .. } | Kind::Parallel { .. } | Kind::Xor { .. } | Kind::Group { .. })
        && !only.kind.is_negated()
        && only.kind.negate()
    {
        return line;
    }
    vec![Kind::Group { line, negated: true }.at(place)]
}
