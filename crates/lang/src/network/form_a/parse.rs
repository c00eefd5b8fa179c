//! Form A → a diagram: one element on each line, and what belongs to it indented below.

use super::boxes::{Boxes, pin_of};
use super::line::{TextLine, arguments, first_word, lines, operand, split};
use crate::network::boxes::COMPARISONS;
use crate::network::elements;
use crate::network::flavour::Flavour;
use crate::network::mistake::{Mistake, MistakeKind};
use crate::network::model::{Alone, Branch, Content, End, Kind, Line, Network, Output, OutputKind, Place, Rung, XorInput};
use crate::network::operand::Operand;
use crate::network::rules::{self, ELEMENTS_MAX};

/// How deep branches and pins may lie inside each other; STL takes seven levels of brackets.
pub const NESTING_MAX: usize = 64;

/// What was understood of a network, and what was not.
#[derive(Clone, Debug, Default)]
pub struct Parsed {
    /// The network.
    pub network: Network,
    /// What is wrong, in the order of places.
    pub mistakes: Vec<Mistake>,
    /// How deep each of its lines lies, without those that have only a comment.
    pub levels: Vec<usize>,
}

/// Reads the network in a part of a text.
pub fn parse(text: &str, from: usize, to: usize, flavour: Flavour) -> Parsed {
    let lines: Vec<TextLine<'_>> = lines(text, from, to).into_iter().filter(|line| !line.content.is_empty()).collect();
    let mut parser = Parser { lines: &lines, at: 0, flavour, mistakes: Vec::new(), depth: 0, elements: 0, level: 0, levels: Vec::new() };
    let network = parser.network();
    let mut mistakes = parser.mistakes;
    mistakes.sort_by_key(|mistake| mistake.start);
    // What is not read would look like open wires.
    if mistakes.iter().any(|mistake| mistake.kind == MistakeKind::Size) {
        mistakes.retain(|mistake| mistake.kind == MistakeKind::Size);
        return Parsed { mistakes, ..Parsed::default() };
    }
    let mut levels = parser.levels;
    levels.resize(lines.len(), 0);
    Parsed { network, mistakes, levels }
}

/// The line that opened what is being read: a branch or a pin.
#[derive(Clone, Copy)]
pub(super) struct Opener {
    indent: usize,
    /// `OR`, `BRANCH`; empty for a pin.
    word: &'static str,
}

/// Branches that each begin with the same word.
struct Group<'t> {
    /// Each with its first line, and whether that has a circle.
    branches: Vec<(Rung, TextLine<'t>, bool)>,
    /// It has its END.
    closed: bool,
}

pub(super) struct Parser<'l, 't> {
    pub(super) lines: &'l [TextLine<'t>],
    pub(super) at: usize,
    pub(super) flavour: Flavour,
    mistakes: Vec<Mistake>,
    depth: usize,
    elements: usize,
    /// How deep the lines that are being read lie.
    level: usize,
    levels: Vec<usize>,
}

impl<'t> Parser<'_, 't> {
    pub(super) fn peek(&self) -> Option<TextLine<'t>> {
        self.lines.get(self.at).copied()
    }

    /// Takes the current line, which lies some levels deeper than what is being read.
    pub(super) fn take(&mut self, deeper: usize) {
        self.levels.resize(self.at, self.level);
        self.levels.push(self.level + deeper);
        self.at += 1;
    }

    pub(super) fn mistake(&mut self, kind: MistakeKind, line: TextLine<'_>, message: impl Into<String>) {
        self.mistakes.push(Mistake::new(kind, line.start, line.end(), message));
    }

    pub(super) fn wrong(&mut self, mistake: Mistake) {
        self.mistakes.push(mistake);
    }

    fn network(&mut self) -> Network {
        let label = self.label();
        if let Some(alone) = self.alone() {
            if let Some(line) = self.peek() {
                self.mistake(
                    MistakeKind::Position,
                    line,
                    format!("`{}` shares its network with an element that stands alone", line.content),
                );
            }
            return Network { label, content: alone };
        }
        let mut rung = self.rung(None);
        while let Some(line) = self.peek() {
            self.take(0);
            self.mistake(MistakeKind::Position, line, format!("`{}` closes nothing", line.content));
            let more = self.rung(None);
            rung.line.extend(more.line);
            if rung.end == End::Open {
                rung.end = more.end;
            }
        }
        let content = if rung == Rung::default() { Content::Empty } else { Content::Rung(rung) };
        Network { label, content }
    }

    /// `LABEL M001:`.
    fn label(&mut self) -> Option<Operand> {
        let line = self.peek()?;
        let (word, rest) = first_word(line.content);
        if word != "LABEL" {
            return None;
        }
        self.take(0);
        let name = line.content[rest..].trim_end_matches(':');
        if name.trim().is_empty() {
            self.mistake(MistakeKind::Operand, line, "`LABEL` needs a name: `LABEL M001:`");
            return None;
        }
        Some(operand(name, line.start + rest))
    }

    /// An element that stands alone in its network.
    fn alone(&mut self) -> Option<Content> {
        let line = self.peek()?;
        let (word, rest) = first_word(line.content);
        let place = Place::new(line.start, line.end());
        let named = |this: &mut Self, make: fn(Operand) -> Alone| {
            this.take(0);
            this.only_operand(line, rest).map(|operand| Content::Alone(make(operand), place))
        };
        let bare = |this: &mut Self, alone| {
            this.take(0);
            this.no_operand(line, rest);
            Some(Content::Alone(alone, place))
        };
        match word {
            "JMP" => named(self, Alone::Jump),
            "RET" if self.flavour == Flavour::Iec => bare(self, Alone::Return),
            _ if self.flavour == Flavour::Iec => None,
            "OPN" => named(self, Alone::Open),
            "UC" => named(self, Alone::Call),
            "MCRA" => bare(self, Alone::McrActivate),
            "MCRD" => bare(self, Alone::McrDeactivate),
            "MCR>" => bare(self, Alone::McrEnd),
            _ => None,
        }
    }

    /// Elements up to what closes the opener.
    pub(super) fn rung(&mut self, opener: Option<Opener>) -> Rung {
        let mut rung = Rung::default();
        while let Some(line) = self.peek() {
            let (word, rest) = first_word(line.content);
            if self.closes(opener, line, word) {
                break;
            }
            self.take(0);
            self.elements += 1;
            if self.elements == ELEMENTS_MAX + 1 {
                self.mistake(
                    MistakeKind::Size,
                    line,
                    format!("a network has at most {ELEMENTS_MAX} elements; those from here on are not read"),
                );
            }
            if self.elements > ELEMENTS_MAX {
                self.at = self.lines.len();
                break;
            }
            if rung.end != End::Open && !matches!(rung.end, End::Outputs(_)) {
                self.mistake(
                    MistakeKind::Position,
                    line,
                    format!("`{}` stands after a T-branch; nothing follows its last branch", line.content),
                );
                continue;
            }
            if let Some(output) = self.output(line, word, rest) {
                match &mut rung.end {
                    End::Outputs(outputs) => outputs.extend(output),
                    end => *end = End::Outputs(output),
                }
                continue;
            }
            if matches!(rung.end, End::Outputs(_)) {
                let message = format!("`{}` stands after a coil; coils are the right end of a rung", line.content);
                self.mistake(MistakeKind::Position, line, message);
                self.skip_deeper(line.indent);
                continue;
            }
            match word {
                "BRANCH" => rung.end = End::Branches(self.branches(line)),
                _ => self.element(&mut rung.line, line, word, rest),
            }
        }
        if let End::Outputs(outputs) = rung.end {
            rung.end = rules::outputs(outputs);
        }
        rung
    }

    /// The line ends what the opener began.
    fn closes(&self, opener: Option<Opener>, line: TextLine<'_>, word: &str) -> bool {
        match opener {
            None => word == "END",
            Some(Opener { indent, word: "" }) => line.indent <= indent || word == "END",
            // A branch may be closed with any indentation that is not that of a line around it.
            Some(opener) => {
                line.indent < opener.indent
                    || word == "END"
                    || (line.indent == opener.indent && word.trim_start_matches('/') == opener.word)
            }
        }
    }

    /// Goes one level deeper, unless that is too deep: then what lies there is skipped.
    fn deeper(&mut self, line: TextLine<'_>) -> bool {
        if self.depth >= NESTING_MAX {
            self.mistake(MistakeKind::Size, line, format!("`{}` lies more than {NESTING_MAX} levels deep", line.content));
            self.at = self.lines.len();
            return false;
        }
        self.depth += 1;
        true
    }

    /// Passes the lines that are indented further.
    fn skip_deeper(&mut self, indent: usize) {
        while self.peek().is_some_and(|line| line.indent > indent) {
            self.take(0);
        }
    }

    /// Branches that each begin with the same word, up to END.
    fn group(&mut self, first: TextLine<'t>, word: &'static str) -> Group<'t> {
        let mut branches = Vec::new();
        if !self.deeper(first) {
            return Group { branches, closed: false };
        }
        let mut closed = true;
        let opener = Opener { indent: first.indent, word };
        let mut line = first;
        loop {
            let negated = line.content.starts_with('/');
            let (_, rest) = first_word(line.content);
            self.no_operand(line, rest);
            self.level += 1;
            let rung = self.rung(Some(opener));
            self.level -= 1;
            branches.push((rung, line, negated));
            match self.peek() {
                Some(next) if next.indent >= opener.indent && first_word(next.content).0 == "END" => {
                    self.take(0);
                    break;
                }
                Some(next) if next.indent == opener.indent && first_word(next.content).0.trim_start_matches('/') == word => {
                    self.take(0);
                    line = next;
                }
                _ => {
                    self.mistake(MistakeKind::Open, first, format!("`{word}` has no `END`"));
                    closed = false;
                    break;
                }
            }
        }
        self.depth -= 1;
        Group { branches, closed }
    }

    fn branches(&mut self, first: TextLine<'t>) -> Vec<Rung> {
        let mut rungs = Vec::new();
        for (rung, line, _) in self.group(first, "BRANCH").branches {
            if rung == Rung::default() {
                self.wrong(
                    Mistake::new(MistakeKind::Open, line.start, line.end(), "this branch of the T-branch is empty")
                        .help("write a coil or a box into it, indented further, or take it away"),
                );
                continue;
            }
            rungs.push(rung);
        }
        rungs
    }

    /// The lines of a group whose branches end in nothing.
    fn inputs(&mut self, first: TextLine<'t>, word: &'static str) -> Vec<(Line, TextLine<'t>, bool)> {
        let mut inputs = Vec::new();
        let group = self.group(first, word);
        for (rung, line, negated) in group.branches {
            // Without its END a group takes in the coils after it.
            if rung.end != End::Open && group.closed {
                self.mistake(MistakeKind::Position, line, format!("a branch of `{word}` has no coil; a T-branch is written with `BRANCH`"));
            }
            if rung.line.is_empty() {
                self.mistake(MistakeKind::Short, line, format!("this branch of `{word}` has no element: it would be a short circuit"));
                continue;
            }
            inputs.push((rung.line, line, negated));
        }
        inputs
    }

    fn element(&mut self, before: &mut Line, line: TextLine<'t>, word: &str, rest: usize) {
        let place = Place::new(line.start, line.end());
        let negated = word.starts_with('/');
        if self.is_operator(line, word, rest) {
            return self.boxed(before, line, word, rest);
        }
        let kind = match word {
            "NO" | "NC" => self.only_operand(line, rest).map(|operand| Kind::Contact { operand, negated: word == "NC" }),
            "P" | "N" => self.only_operand(line, rest).map(|operand| match self.flavour {
                Flavour::S7 => Kind::Edge { falling: word == "N", memory: operand },
                Flavour::Iec => Kind::EdgeBox { falling: word == "N", operand, memory: None },
            }),
            "POS" | "NEG" if self.flavour == Flavour::S7 => self
                .two_operands(line, rest, "a bit and its edge memory bit")
                .map(|(operand, memory)| Kind::EdgeBox { falling: word == "NEG", operand, memory: Some(memory) }),
            "NOT" if line.content.len() == rest => Some(Kind::Not),
            "MID" => {
                let written = &line.content[rest..];
                let negated = written.starts_with('/');
                let skip = usize::from(negated);
                self.only_operand(line, rest + skip).map(|operand| Kind::Midline { operand, negated })
            }
            "CMP" | "/CMP" => self.compare(line, rest, negated),
            "TAP" | "/TAP" => {
                self.no_operand(line, rest);
                Some(Kind::Tap { negated })
            }
            "OR" | "/OR" => {
                let branches: Vec<Branch> = self
                    .inputs(line, "OR")
                    .into_iter()
                    .map(|(elements, branch, _)| Branch { line: elements, bracketed: branch.content.contains("( )") })
                    .collect();
                (!branches.is_empty()).then_some(Kind::Parallel { branches, negated })
            }
            "XOR" | "/XOR" => {
                let inputs: Vec<XorInput> =
                    self.inputs(line, "XOR").into_iter().map(|(line, ..)| XorInput { line, negated: false }).collect();
                (!inputs.is_empty()).then_some(Kind::Xor { inputs, negated })
            }
            "AND" | "/AND" => return self.and(before, line, place, negated),
            _ => return self.boxed(before, line, word, rest),
        };
        before.extend(kind.map(|kind| kind.at(place)));
    }

    /// AND, OR, XOR and NOT of IEC 61131-3 with pins are boxes over values of any type; alone on their lines they are logic.
    fn is_operator(&self, line: TextLine<'_>, word: &str, rest: usize) -> bool {
        let more = line.content[rest..].trim();
        if self.flavour != Flavour::Iec || !matches!(word, "AND" | "OR" | "XOR" | "NOT") {
            return false;
        }
        let pin_below = || self.peek().is_some_and(|next| next.indent > line.indent && pin_of(next.content).is_some());
        !more.is_empty() && more != "( )" || pin_below() && !self.is_closed(line.indent, word)
    }

    /// END closes what a word at this indentation has begun: `ADD => x` in a branch looks like a pin.
    fn is_closed(&self, indent: usize, word: &str) -> bool {
        let beside = self.lines.iter().skip(self.at).skip_while(|next| next.indent > indent);
        let mut beside = beside.filter(|next| next.indent <= indent).map(|next| (next.indent, first_word(next.content).0));
        beside.find(|&(at, other)| (at, other.trim_start_matches('/')) != (indent, word)) == Some((indent, "END"))
    }

    /// An & box. Without a circle its inputs are a series like any other, unless one of them acts on what stands before it.
    fn and(&mut self, before: &mut Line, line: TextLine<'t>, place: Place, negated: bool) {
        let mut all: Line = Vec::new();
        for (input, ..) in self.inputs(line, "AND") {
            match all.is_empty() || !input.iter().any(|one| one.kind.acts_on_line()) {
                true => all.extend(input),
                false => all.push(Kind::Group { line: input, negated: false }.at(place)),
            }
        }
        let plain = !negated && (before.is_empty() || !all.iter().any(|one| one.kind.acts_on_line()));
        match plain {
            true => before.extend(all),
            false if all.is_empty() => {}
            false => before.push(Kind::Group { line: all, negated }.at(place)),
        }
    }

    /// `CMP >I MW 10, 100`.
    fn compare(&mut self, line: TextLine<'_>, rest: usize, negated: bool) -> Option<Kind> {
        let written = &line.content[rest..];
        let signs = written.find(char::is_whitespace).unwrap_or(written.len());
        if self.flavour == Flavour::Iec {
            let message = "`CMP` is an element of S7 blocks: a comparison is a box here";
            self.wrong(
                Mistake::new(MistakeKind::Word, line.start, line.end(), message).help("write `GT a, 100`: one of EQ NE GT LT GE LE"),
            );
            return None;
        }
        let Some(operation) = COMPARISONS.iter().copied().find(|known| known.eq_ignore_ascii_case(&written[..signs])) else {
            let message = format!("`{}` is no comparison", &written[..signs]);
            self.wrong(
                Mistake::new(MistakeKind::Word, line.start, line.end(), message)
                    .help("write `CMP >I MW 10, 100`: one of == <> > < >= <= with I, D or R, and two operands"),
            );
            return None;
        };
        self.two_operands(line, rest + signs, "two operands").map(|(left, right)| Kind::Compare { operation, left, right, negated })
    }

    fn output(&mut self, line: TextLine<'_>, word: &str, rest: usize) -> Option<Vec<Output>> {
        let place = Place::new(line.start, line.end());
        let iec = self.flavour == Flavour::Iec;
        if !elements::is_coil(word, self.flavour) {
            return None;
        }
        let written = &line.content[rest..];
        let kind = match word {
            "COIL" if iec && written.starts_with('/') => self.only_operand(line, rest + 1).map(OutputKind::AssignNegated),
            "COIL" => self.only_operand(line, rest).map(OutputKind::Assign),
            "PCOIL" | "NCOIL" => self.only_operand(line, rest).map(|operand| OutputKind::AssignEdge { falling: word == "NCOIL", operand }),
            "SET" => self.only_operand(line, rest).map(OutputKind::Set),
            "RESET" => self.only_operand(line, rest).map(OutputKind::Reset),
            "JMP" => self.only_operand(line, rest).map(OutputKind::Jump),
            "JMPN" => self.only_operand(line, rest).map(OutputKind::JumpNot),
            "CC" => self.only_operand(line, rest).map(OutputKind::Call),
            "CU" => self.only_operand(line, rest).map(OutputKind::CountUp),
            "CD" => self.only_operand(line, rest).map(OutputKind::CountDown),
            "SC" => {
                self.two_operands(line, rest, "a counter and its value").map(|(counter, value)| OutputKind::SetCounter { counter, value })
            }
            _ => match crate::network::boxes::TimerKind::of(word) {
                Some(kind) => self.two_operands(line, rest, "a timer and its time value").map(|(timer, value)| OutputKind::Timer {
                    kind,
                    timer,
                    value,
                }),
                None => {
                    self.no_operand(line, rest);
                    match word {
                        "SAVE" => Some(OutputKind::Save),
                        "RET" => Some(OutputKind::Return),
                        _ => Some(OutputKind::McrStart),
                    }
                }
            },
        };
        Some(kind.map(|kind| kind.at(place)).into_iter().collect())
    }

    fn boxed(&mut self, before: &mut Line, line: TextLine<'t>, word: &str, rest: usize) {
        let boxes = Boxes { line, word, rest, place: Place::new(line.start, line.end()) };
        let Some((mut front, element)) = self.a_box(boxes) else { return };
        before.append(&mut front);
        before.push(element);
    }

    /// The logic at a pin: the lines that are indented further than the pin.
    pub(super) fn pin_logic(&mut self, pin: TextLine<'t>) -> Line {
        if !self.deeper(pin) {
            return Vec::new();
        }
        self.level += 2;
        let rung = self.rung(Some(Opener { indent: pin.indent, word: "" }));
        self.level -= 2;
        self.depth -= 1;
        if rung.end != End::Open {
            self.mistake(MistakeKind::Position, pin, "the logic at a pin has no coil");
        }
        if rung.line.is_empty() {
            self.wrong(
                Mistake::new(MistakeKind::Open, pin.start, pin.end(), format!("nothing is wired to `{}`", pin.content))
                    .help("its logic stands on the next lines, indented further than the pin; an open pin is left out"),
            );
        }
        rung.line
    }

    pub(super) fn no_operand(&mut self, line: TextLine<'_>, rest: usize) {
        let more = line.content[rest..].trim();
        if !more.is_empty() && more != "( )" {
            let (start, end) = (line.start + rest, line.end());
            self.wrong(Mistake::new(
                MistakeKind::Operand,
                start,
                end,
                format!("`{more}` does not belong here: this element has no operand"),
            ));
        }
    }

    pub(super) fn only_operand(&mut self, line: TextLine<'_>, rest: usize) -> Option<Operand> {
        let written = &line.content[rest..];
        let (word, _) = first_word(line.content);
        if written.trim().is_empty() {
            self.mistake(MistakeKind::Operand, line, format!("`{word}` needs an operand"));
            return None;
        }
        // Most operands have none of them, also between quotes.
        if [",", "=>", ":="].iter().any(|sign| written.contains(sign) && split(written, sign).len() > 1) {
            let (start, end) = (line.start + rest, line.end());
            self.wrong(Mistake::new(MistakeKind::Operand, start, end, format!("`{word}` has one operand; this is more")));
            return None;
        }
        Some(operand(written, line.start + rest))
    }

    fn two_operands(&mut self, line: TextLine<'_>, rest: usize, what: &str) -> Option<(Operand, Operand)> {
        let (word, _) = first_word(line.content);
        let all = arguments(&line.content[rest..], line.start + rest);
        let operands: Vec<Operand> =
            all.into_iter().filter(|one| one.output.is_none()).filter_map(|one| one.input.map(|input| input.operand)).collect();
        match <[Operand; 2]>::try_from(operands) {
            Ok([first, second]) => Some((first, second)),
            Err(_) => {
                self.mistake(MistakeKind::Operand, line, format!("`{word}` needs {what}, with a comma between them"));
                None
            }
        }
    }
}
