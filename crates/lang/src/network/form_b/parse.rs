//! A line of form B → a diagram.

use super::boxes::is_box_with_operand;
use super::scan::Scanner;
use crate::network::boxes::{BoxRow, COMPARISONS, TimerKind};
use crate::network::flavour::Flavour;
use crate::network::mistake::{Mistake, MistakeKind};
use crate::network::model::{Alone, Branch, Content, Element, End, Kind, Line, Network, Output, OutputKind, Rung, XorInput};
use crate::network::operand::{Operand, STATUS_BITS};
use crate::network::rules;
use crate::network::write::{keep_needed_brackets, reads_tap};

/// What is wrong, and at which byte of the text that the line is part of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Wrong {
    /// The byte.
    pub(super) at: usize,
    /// What is expected there.
    pub(super) message: String,
    /// Which kind of mistake it is.
    pub(super) kind: MistakeKind,
}

pub(super) type Parsed<T> = Result<T, Wrong>;

/// Parses a line that begins at byte `offset` of its text.
///
/// # Errors
///
/// The first thing that is no diagram, with its place.
pub fn parse(text: &str, offset: usize, flavour: Flavour) -> Result<Network, Mistake> {
    let network = syntax(text, offset, flavour).map_err(|wrong| {
        let sign = wrong.at.checked_sub(offset).and_then(|at| text.get(at..)).and_then(|rest| rest.chars().next());
        Mistake::told(wrong.kind, wrong.at, wrong.at + sign.map_or(0, char::len_utf8), &wrong.message)
    })?;
    match rules::mistakes(&network, flavour, None).into_iter().next() {
        // What no element names lies at the beginning of the line.
        Some(mistake) => Err(Mistake { start: mistake.start.max(offset), end: mistake.end.max(offset), ..mistake }),
        None => Ok(network),
    }
}

/// What is written, whether or not it keeps the rules of diagrams.
fn syntax(text: &str, offset: usize, flavour: Flavour) -> Parsed<Network> {
    let mut parser = Parser { scan: Scanner::new(text, offset, flavour) };
    let network = parser.network()?;
    if !parser.scan.ended() {
        return parser.after_end();
    }
    Ok(network)
}

/// Whether the line goes on from something to its left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Left {
    /// Nothing stands there.
    Nothing,
    /// The tapped line. Written as `.` it stays an element until the whole rung is read.
    Tap,
    /// An element.
    Line,
}

pub(super) struct Parser<'t> {
    pub(super) scan: Scanner<'t>,
}

impl Parser<'_> {
    fn network(&mut self) -> Parsed<Network> {
        let label = self.own_label();
        let content = self.content()?;
        Ok(Network { label, content })
    }

    /// `LABEL M001:`; without a colon LABEL is a name like others.
    fn own_label(&mut self) -> Option<Operand> {
        let from = self.scan.at;
        let label = self.scan.eat_word("LABEL").then(|| self.label().ok()).flatten();
        if label.is_some() && !self.scan.see(":=") && self.scan.eat(":") {
            return label;
        }
        self.scan.at = from;
        None
    }

    fn content(&mut self) -> Parsed<Content> {
        self.scan.space();
        let from = self.scan.at;
        if self.scan.ended() || (self.scan.eat_word("empty") && self.scan.eat_word("network") && self.scan.ended()) {
            return Ok(Content::Empty);
        }
        self.scan.at = from;
        if self.scan.eat("|-")
            && let Some(alone) = self.alone()?
        {
            return Ok(Content::Alone(alone, self.scan.since(from)));
        }
        Ok(Content::Rung(self.rung(Left::Nothing)?))
    }

    fn alone(&mut self) -> Parsed<Option<Alone>> {
        let s7 = self.scan.flavour == Flavour::S7;
        let from = self.scan.at;
        if self.scan.eat("->") {
            match self.scan.word() {
                "JMP" => {}
                "CALL" if s7 => {
                    self.scan.eat_word("CALL");
                    return Ok(Some(Alone::Call(self.scan.operand()?)));
                }
                "RET" | "RETURN" if !s7 => {}
                _ => {
                    self.scan.at = from;
                    return Ok(None);
                }
            }
        }
        Ok(Some(match self.scan.word() {
            "JMP" => {
                self.scan.eat_word("JMP");
                Alone::Jump(self.label()?)
            }
            "OPN" if s7 => {
                self.scan.eat_word("OPN");
                Alone::Open(self.scan.operand()?)
            }
            word @ "MCRA" if s7 && self.scan.eat_word(word) => Alone::McrActivate,
            word @ "MCRD" if s7 && self.scan.eat_word(word) => Alone::McrDeactivate,
            "MCR" if s7 && self.scan.eat("MCR>") => Alone::McrEnd,
            word @ ("RET" | "RETURN") if !s7 && self.scan.eat_word(word) => Alone::Return,
            _ => return Ok(None),
        }))
    }

    fn label(&mut self) -> Parsed<Operand> {
        let name = self.scan.word();
        if name.is_empty() {
            return self.scan.wrong("the name of a label is missing here");
        }
        let place = self.scan.since(self.scan.at);
        self.scan.at += name.len();
        Ok(Operand { text: name.to_owned(), start: Some(place.first) })
    }

    fn rung(&mut self, left: Left) -> Parsed<Rung> {
        self.scan.enter()?;
        let mut rung = self.rung_inside(left)?;
        self.scan.leave();
        if left == Left::Tap && rung.line.get(1..).is_some_and(|rest| !reads_tap(rest)) {
            // It comes from the left in any case.
            strip_tap(&mut rung.line);
        }
        Ok(rung)
    }

    fn rung_inside(&mut self, left: Left) -> Parsed<Rung> {
        let mut line = Line::new();
        let mut arrow = None;
        loop {
            let inside = left == Left::Tap && (self.scan.see(";") || self.scan.see("}"));
            if inside || self.scan.ended() {
                self.not_a_coil(&line, arrow)?;
                return Ok(Rung::new(line, End::Open));
            }
            if self.scan.eat("->") {
                arrow = Some(self.scan.at);
                if self.at_output() {
                    break;
                }
                if line.is_empty() && left == Left::Nothing {
                    return self
                        .scan
                        .wrong("nothing leads to this `->`; an output such as `= Q 4.0`, or `|-` for a box on the rail, is expected");
                }
                self.part(&mut line, left)?;
                continue;
            }
            if self.scan.eat("{") {
                let mut rungs = Vec::new();
                loop {
                    let rung = self.rung(Left::Tap)?;
                    if rung == Rung::default() {
                        return self.scan.wrong("this branch of the T-branch is empty; write a coil or a box into it, or take it away");
                    }
                    rungs.push(rung);
                    if self.scan.eat("}") {
                        return Ok(Rung::new(line, End::Branches(rungs)));
                    }
                    self.scan.want(";", "`;` or `}` is expected after a branch")?;
                }
            }
            self.part(&mut line, left)?;
        }
        let mut outputs = Vec::new();
        loop {
            outputs.push(self.output()?);
            if !self.scan.eat(",") {
                return Ok(Rung::new(line, rules::outputs(outputs)));
            }
        }
    }

    /// Whether a coil comes, and no element of FBD.
    fn at_output(&mut self) -> bool {
        if (self.scan.see("=") && !self.scan.see("==")) || self.scan.see("MCR<") {
            return true;
        }
        let s7 = self.scan.flavour == Flavour::S7;
        if !s7 && self.scan.see("/") {
            // A circle at an element goes on, `/ x` is a negated coil.
            let circled = self.scan.rest().get(1..).unwrap_or_default().trim_start();
            return !["#(", "and(", "or(", "xor(", "("].iter().any(|element| circled.starts_with(element));
        }
        let word = self.scan.word();
        let after = self.scan.rest().get(word.len()..).unwrap_or_default();
        let operand = !after.starts_with(['(', '[']);
        match word {
            "S" | "R" | "JMP" | "JMPN" => operand,
            "CALL" if s7 => operand && !self.is_call_box(),
            "SC" | "CU" | "CD" if s7 => operand,
            "P" | "N" if !s7 => operand,
            "RETURN" if !s7 => operand,
            "SAVE" if s7 => operand,
            "RET" => operand,
            other => s7 && TimerKind::of(other).is_some(),
        }
    }

    /// A call with pins or an instance is a box.
    fn is_call_box(&mut self) -> bool {
        let mark = self.scan.at;
        self.scan.eat_word("CALL");
        let is_box = self.scan.operand().is_ok() && (self.scan.touches('(') || self.scan.touches(','));
        self.scan.at = mark;
        is_box
    }

    fn output(&mut self) -> Parsed<Output> {
        self.scan.space();
        let from = self.scan.at;
        let s7 = self.scan.flavour == Flavour::S7;
        let kind = if s7 && self.scan.eat("MCR<") {
            OutputKind::McrStart
        } else if self.scan.eat("=") {
            OutputKind::Assign(self.scan.operand()?)
        } else if !s7 && self.scan.eat("/") {
            OutputKind::AssignNegated(self.scan.operand()?)
        } else {
            let word = self.scan.word();
            self.scan.at += word.len();
            match word {
                "S" => OutputKind::Set(self.scan.operand()?),
                "R" => OutputKind::Reset(self.scan.operand()?),
                "RET" => OutputKind::Return,
                "RETURN" if !s7 => OutputKind::Return,
                "JMP" => OutputKind::Jump(self.label()?),
                "JMPN" => OutputKind::JumpNot(self.label()?),
                "P" | "N" if !s7 => OutputKind::AssignEdge { falling: word == "N", operand: self.scan.operand()? },
                "SAVE" if s7 => OutputKind::Save,
                "CALL" if s7 => OutputKind::Call(self.scan.operand()?),
                "SC" if s7 => OutputKind::SetCounter { counter: self.scan.operand()?, value: self.scan.operand()? },
                "CU" if s7 => OutputKind::CountUp(self.scan.operand()?),
                "CD" if s7 => OutputKind::CountDown(self.scan.operand()?),
                other => match TimerKind::of(other).filter(|_| s7) {
                    Some(kind) => OutputKind::Timer { kind, timer: self.scan.operand()?, value: self.scan.operand()? },
                    None => {
                        return self.scan.wrong_at(
                            from,
                            match s7 {
                                true => "an output is expected here, such as `= Q 4.0`, `S M 0.0` or `SD T 5 S5T#2S`",
                                false => "an output is expected here, such as `= Motor`, `/ Motor`, `S Motor` or `R Motor`",
                            },
                        );
                    }
                },
            }
        };
        Ok(kind.at(self.scan.since(from)))
    }

    /// The next part of a line; what acts on a part only stays a group of its own.
    fn part(&mut self, line: &mut Line, left: Left) -> Parsed<()> {
        let left = if line.is_empty() { left } else { Left::Line };
        self.scan.space();
        let from = self.scan.at;
        let bracket = self.scan.see("(");
        let part = self.elements(left)?;
        if bracket && left != Left::Nothing && part.iter().any(|one| one.kind.acts_on_line()) {
            line.push(Kind::Group { line: part, negated: false }.at(self.scan.since(from)));
        } else {
            line.extend(part);
        }
        Ok(())
    }

    /// One element, or the several that a box of FBD stands for.
    pub(super) fn elements(&mut self, left: Left) -> Parsed<Line> {
        self.scan.enter()?;
        let line = self.elements_inside(left);
        self.scan.leave();
        line
    }

    fn elements_inside(&mut self, left: Left) -> Parsed<Line> {
        self.scan.space();
        let from = self.scan.at;
        let s7 = self.scan.flavour == Flavour::S7;
        if self.scan.eat("!") {
            // `!` at a group is its circle; alone it is the NOT of what stands to its left.
            if !self.at_group() {
                return self.one(Kind::Not, from);
            }
            let line = self.elements(Left::Nothing)?;
            return Ok(self.circle(line, from));
        }
        if self.scan.eat("/") {
            if self.scan.see("#(") {
                self.scan.eat("#");
                let operand = self.bracketed()?;
                return self.one(Kind::Midline { operand, negated: true }, from);
            }
            let line = self.elements(Left::Nothing)?;
            return Ok(self.circle(line, from));
        }
        if self.scan.eat("(") {
            return self.parallel(from);
        }
        if self.scan.eat("[") {
            return self.condition(from);
        }
        if self.scan.see("#(") {
            self.scan.eat("#");
            let operand = self.bracketed()?;
            return self.one(Kind::Midline { operand, negated: false }, from);
        }
        if self.scan.see(".") {
            self.scan.eat(".");
            return self.one(Kind::Tap { negated: false }, from);
        }
        let word = self.scan.word();
        let next = self.scan.rest().get(word.len()..).and_then(|after| after.chars().next());
        match (word, next) {
            ("and" | "or" | "xor", Some('(')) => {
                self.scan.at += word.len() + 1;
                self.group(word, from, left)
            }
            ("POS" | "NEG", Some('(')) => {
                self.scan.at += word.len() + 1;
                let operand = self.scan.operand()?;
                let memory = if s7 {
                    self.scan.want(",", "`,` and the edge memory bit are missing after the operand")?;
                    Some(self.scan.operand()?)
                } else {
                    None
                };
                self.scan.want(")", "`)` is missing after the operand")?;
                self.one(Kind::EdgeBox { falling: word == "NEG", operand, memory }, from)
            }
            ("P" | "N", Some('(')) if s7 => {
                self.scan.at += 2;
                self.edge(word == "N", from, left)
            }
            ("P" | "N", Some('(')) => {
                self.scan.wrong_at(from, format!("an edge of a variable is written `{}(…)`", if word == "P" { "POS" } else { "NEG" }))
            }
            ("CALL", next) if s7 && next != Some('(') => {
                self.scan.at += word.len();
                self.call(from)
            }
            (name, Some('[')) if s7 && is_box_with_operand(name) => {
                self.scan.at += name.len() + 1;
                let operand = self.scan.operand()?;
                self.scan.want("]", "`]` is missing after the operand of the box")?;
                self.box_with_operand(name, operand, from, left)
            }
            (name, Some('(')) if s7 && !name.is_empty() => match BoxRow::of_name(name) {
                Some(row) => {
                    self.scan.at += name.len() + 1;
                    self.plain_box(row, from)
                }
                None if is_box_with_operand(name) => {
                    self.scan.wrong_at(from, format!("`{name}` needs its operand in square brackets, such as `{name}[…](…)`"))
                }
                None => self.scan.wrong_at(from, format!("there is no box `{name}`")),
            },
            (name, Some('(' | '[')) if !s7 && !name.is_empty() && self.names_a_box(name) => self.named_box(name, from),
            _ => {
                if let Some(wrong) = self.no_element() {
                    return wrong;
                }
                let operand = self.scan.operand()?;
                if s7 && operand.starts_with(|sign: char| sign.is_ascii_digit()) {
                    return self.scan.wrong_at(from, format!("a contact reads a bit, such as `I 0.0`, and `{operand}` is a number"));
                }
                self.one(Kind::contact(operand, false), from)
            }
        }
    }

    pub(super) fn one(&self, kind: Kind, from: usize) -> Parsed<Line> {
        Ok(vec![kind.at(self.scan.since(from))])
    }

    /// A bracket, or a group of FBD, follows without a space.
    fn at_group(&self) -> bool {
        let rest = self.scan.rest();
        rest.starts_with('(') || ["and(", "or(", "xor("].iter().any(|name| rest.starts_with(name))
    }

    /// `name(` or `name[instance](`.
    fn names_a_box(&self, name: &str) -> bool {
        let after = self.scan.rest().get(name.len()..).unwrap_or_default();
        after.starts_with('(')
            || after.strip_prefix('[').and_then(|instance| instance.split_once(']')).is_some_and(|(_, after)| after.starts_with('('))
    }

    fn parallel(&mut self, from: usize) -> Parsed<Line> {
        let mut branches = Vec::new();
        loop {
            branches.push(self.or_branch()?);
            if self.scan.eat(")") {
                break;
            }
            self.scan.want("|", "`|` or `)` is expected after a branch")?;
        }
        if let [_] = branches.as_slice() {
            return Ok(branches.pop().map(|branch| branch.line).unwrap_or_default());
        }
        keep_needed_brackets(&mut branches);
        self.one(Kind::Parallel { branches, negated: false }, from)
    }

    fn bracketed(&mut self) -> Parsed<Operand> {
        self.scan.want("(", "`(` is missing before the operand")?;
        let operand = self.scan.operand()?;
        self.scan.want(")", "`)` is missing after the operand")?;
        Ok(operand)
    }

    /// Elements up to a sign that ends a branch, an input or a pin.
    pub(super) fn branch(&mut self) -> Parsed<Line> {
        self.parts().map(|(line, _)| line)
    }

    /// A branch of a parallel. In a bracket of its own it stands in `O( )`, as `OR ( )` of form A does.
    fn or_branch(&mut self) -> Parsed<Branch> {
        let bracket = self.scan.see("(") && self.scan.flavour == Flavour::S7;
        let (line, count) = self.parts()?;
        Ok(Branch { line, bracketed: bracket && count == 1 })
    }

    /// The elements of a branch, and of how many parts side by side they are.
    fn parts(&mut self) -> Parsed<(Line, usize)> {
        let (mut line, mut count) = (Line::new(), 0);
        loop {
            self.part(&mut line, Left::Nothing)?;
            count += 1;
            if self.scan.ended() || ["|", ")", ",", "=>", ";", "}"].iter().any(|sign| self.scan.see(sign)) {
                return Ok((line, count));
            }
            self.scan.eat("->");
        }
    }

    fn edge(&mut self, falling: bool, from: usize, left: Left) -> Parsed<Line> {
        let mark = self.scan.at;
        // One operand is the edge memory; two are a box of FBD with its input.
        if let Ok(memory) = self.scan.operand()
            && self.scan.eat(")")
        {
            return self.one(Kind::Edge { falling, memory }, from);
        }
        self.scan.at = mark;
        let mut line = self.branch()?;
        self.scan.want(",", "`,` and the edge memory bit are missing after the input")?;
        let memory = self.scan.operand()?;
        self.scan.want(")", "`)` is missing after the edge memory bit")?;
        if !takes_left(&mut line, left) {
            return self.scan.wrong_at(mark, "the line from the left is not used; write `.` for it: `P(and(., I 0.0), M 1.0)`");
        }
        line.push(Kind::Edge { falling, memory }.at(self.scan.since(from)));
        Ok(line)
    }

    fn condition(&mut self, from: usize) -> Parsed<Line> {
        self.scan.space();
        let at = self.scan.at;
        let rest = self.scan.rest();
        let status = STATUS_BITS.iter().find(|bit| rest.strip_prefix(**bit).is_some_and(|after| after.trim_start().starts_with(']')));
        if let Some(bit) = status {
            let place = self.scan.since(at);
            self.scan.at += bit.len();
            self.scan.want("]", "`]` is missing after the status bit")?;
            return self.one(Kind::contact(Operand { text: (*bit).to_owned(), start: Some(place.first) }, false), from);
        }
        // In IEC 61131-3 a status bit is a name like any other.
        if self.scan.flavour == Flavour::Iec {
            return self.scan.wrong_at(from, "a comparison is a box: `GT(a, b)`");
        }
        let left = self.scan.operand()?;
        self.scan.space();
        let rest = self.scan.rest();
        let Some(operation) = COMPARISONS.iter().find(|name| rest.starts_with(**name)) else {
            return self
                .scan
                .wrong("a comparison is expected here, such as `>I`, `==D` or `<=R`; I compares INT, D DINT and R REAL: `[MW 10 >I 100]`");
        };
        self.scan.at += operation.len();
        let right = self.scan.operand()?;
        self.scan.want("]", "`]` is missing after the comparison")?;
        self.one(Kind::Compare { operation, left, right, negated: false }, from)
    }

    /// `and(…)`, `or(…)`, `xor(…)`.
    fn group(&mut self, word: &str, from: usize, left: Left) -> Parsed<Line> {
        let mut inputs = Vec::new();
        loop {
            self.scan.space();
            let at = self.scan.at;
            let input = self.or_branch()?;
            inputs.push((input, self.scan.since(at)));
            if self.scan.eat(")") {
                break;
            }
            self.scan.want(",", "`,` or `)` is expected after an input")?;
        }
        match word {
            "and" => {
                let mut whole = Line::new();
                for (index, (input, place)) in inputs.into_iter().enumerate() {
                    let input = input.line;
                    if index == 0 && left == Left::Line && is_tap(&input) {
                        continue;
                    }
                    let had = left != Left::Nothing || !whole.is_empty();
                    if had && input.iter().any(|one| one.kind.acts_on_line()) {
                        whole.push(Kind::Group { line: input, negated: false }.at(place));
                    } else {
                        whole.extend(input);
                    }
                }
                Ok(whole)
            }
            "or" => {
                let mut branches: Vec<Branch> = inputs.into_iter().map(|(branch, _)| branch).collect();
                keep_needed_brackets(&mut branches);
                self.one(Kind::Parallel { branches, negated: false }, from)
            }
            _ => {
                let inputs = inputs.into_iter().map(|(input, _)| XorInput { line: input.line, negated: false }).collect();
                self.one(Kind::Xor { inputs, negated: false }, from)
            }
        }
    }

    /// The circle of a contact, a bracket or a group.
    fn circle(&self, mut line: Line, from: usize) -> Line {
        if let [only] = line.as_mut_slice()
            && !only.kind.is_negated()
            && only.kind.negate()
        {
            only.place = self.scan.since(from);
            return line;
        }
        vec![Kind::Group { line, negated: true }.at(self.scan.since(from))]
    }
}

/// A box of FBD goes on from what stands to its left, written as `.` in its first input; says whether it does.
pub(super) fn takes_left(input: &mut Line, left: Left) -> bool {
    match left {
        Left::Nothing => true,
        Left::Tap => reads_tap(input),
        Left::Line => strip_tap(input),
    }
}

/// Takes away the line from the left that a line begins with; says whether it was there.
fn strip_tap(line: &mut Line) -> bool {
    let found = line.get(..1).is_some_and(is_tap);
    if found {
        line.remove(0);
    }
    found
}

/// The line from the left and nothing else.
pub(super) fn is_tap(line: &[Element]) -> bool {
    matches!(line, [Element { kind: Kind::Tap { negated: false }, .. }])
}
