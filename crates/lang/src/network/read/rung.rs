//! Networks, rungs, T-branches and coils.

use std::collections::{BTreeSet, HashMap};

use super::logic::Inside;
use super::prepare::{Prepared, is_check, is_opening};
use super::{Class, Mode, Surroundings};
use crate::network::boxes::TimerKind;
use crate::network::model::{Alone, Content, Element, End, Kind, Line, Network, OutputKind, Place, Rung};
use crate::network::operand::Operand;
use crate::network::pin_types::TypedPin;
use crate::network::reasons::{Reason, Refusal, Rewrite};
use crate::network::statement::Statement;

/// How deep T-branches may stand inside of one another; more does not fit on any page.
const BRANCHES_NESTED_MAX: usize = 32;

pub(super) type Read<T> = Result<T, Refusal>;

/// Whether the line goes on after what was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Flow {
    /// An output may follow.
    Goes,
    /// It ended with a box whose output is open.
    Ended,
}

/// Whether a line begins with a tapped one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tapped {
    Yes,
    No,
}

/// Whether a temporary variable may become the bit of a T-branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Named {
    /// It does.
    Branches,
    /// It is a midline output.
    Midlines,
}

/// The bit of a T-branch.
pub(super) struct TapBit {
    bit: Option<u32>,
    name: Operand,
}

/// Logic that waits for the pin of a call.
pub(super) struct Feed {
    pub(super) line: Line,
    /// Where it is stored.
    pub(super) stored: usize,
}

pub(super) struct Reader<'s> {
    pub(super) prepared: &'s Prepared<'s>,
    pub(super) at: usize,
    pub(super) around: &'s dyn Surroundings,
    pub(super) mode: Mode,
    /// Whether a temporary variable may become the bit of a T-branch.
    pub(super) named: Named,
    pub(super) rewrites: BTreeSet<Rewrite>,
    /// The T-branches around, innermost last.
    taps: Vec<TapBit>,
    /// By their bits of local data.
    pub(super) feeds: HashMap<u32, Feed>,
    /// Open brackets.
    pub(super) depth: usize,
    /// Slots of boxes that are being read.
    pub(super) slots: usize,
    /// Statements whose label belongs to a box.
    pub(super) box_labels: BTreeSet<usize>,
    /// Jumps that have become the EN of a box.
    pub(super) enabling: BTreeSet<usize>,
    /// Statements that networks begin with.
    starts: BTreeSet<usize>,
}

impl<'s> Reader<'s> {
    pub(super) fn new(prepared: &'s Prepared<'s>, around: &'s dyn Surroundings, mode: Mode, named: Named) -> Self {
        Self {
            prepared,
            at: 0,
            around,
            mode,
            named,
            rewrites: BTreeSet::new(),
            taps: Vec::new(),
            feeds: HashMap::new(),
            depth: 0,
            slots: 0,
            box_labels: BTreeSet::new(),
            enabling: BTreeSet::new(),
            starts: BTreeSet::new(),
        }
    }

    pub(super) fn statement_at(&self, at: usize) -> Option<&'s Statement> {
        self.prepared.statements.get(at).copied()
    }

    pub(super) fn current(&self) -> Option<&'s Statement> {
        self.statement_at(self.at)
    }

    pub(super) fn mnemonic_at(&self, at: usize) -> &'s str {
        self.statement_at(at).map_or("", |one| one.mnemonic)
    }

    pub(super) fn peek(&self) -> &'s str {
        self.mnemonic_at(self.at)
    }

    pub(super) fn operand(&self) -> &'s str {
        self.current().map_or("", |one| one.operand.text.as_str())
    }

    pub(super) fn is(&self, mnemonic: &str, operand: &str) -> bool {
        self.current().is_some_and(|one| one.is(mnemonic, operand))
    }

    pub(super) fn ended(&self) -> bool {
        self.at >= self.prepared.statements.len()
    }

    /// Where a statement stands in the network as it was given.
    pub(super) fn original(&self, at: usize) -> usize {
        let originals = &self.prepared.originals;
        originals.get(at).or(originals.last()).copied().unwrap_or_default()
    }

    pub(super) fn place(&self, first: usize, last: usize) -> Place {
        Place::new(self.original(first), self.original(last))
    }

    pub(super) fn refuse<T>(&self, reason: Reason, at: usize) -> Read<T> {
        Err(Refusal::new(reason, self.original(at)))
    }

    pub(super) fn here<T>(&self, reason: Reason) -> Read<T> {
        self.refuse(reason, self.at)
    }

    /// The last statement that was read.
    pub(super) fn before<T>(&self, reason: Reason) -> Read<T> {
        self.refuse(reason, self.at.saturating_sub(1))
    }

    pub(super) fn rewrite(&mut self, rewrite: Rewrite) {
        self.rewrites.insert(rewrite);
    }

    pub(super) fn rewriting(&self) -> bool {
        self.mode > Mode::Strict
    }

    /// The whole string of a rung is read, and no slot or sub-rung.
    pub(super) fn is_outside_of_slots(&self) -> bool {
        self.slots == 0 && self.taps.is_empty()
    }

    /// Which T-branch has this bit.
    pub(super) fn tap(&self, operand: &str) -> Option<usize> {
        if self.taps.is_empty() {
            return None;
        }
        let bit = self.around.scratch(operand);
        self.taps.iter().rposition(|tap| (bit.is_some() && tap.bit == bit) || tap.name == *operand)
    }

    pub(super) fn innermost_tap(&self) -> usize {
        self.taps.len().saturating_sub(1)
    }

    pub(super) fn network(&mut self) -> Read<Network> {
        self.starts.insert(self.at);
        let label = self.current().and_then(|one| one.label.clone());
        let content = self.content()?;
        if let Some(stored) = self.feeds.values().map(|feed| feed.stored).min() {
            return self.refuse(Reason::BitLeft, stored);
        }
        Ok(Network { label, content })
    }

    fn content(&mut self) -> Read<Content> {
        let at = self.at;
        if self.statement_at(at).is_none() || self.is("NOP", "0") {
            while self.is("NOP", "0") && (self.at == at || self.current().is_some_and(|one| one.label.is_none())) {
                self.at += 1;
            }
            return Ok(Content::Empty);
        }
        let operand = || self.current().map(|one| one.operand.clone()).unwrap_or_default();
        let alone = match self.peek() {
            "OPN" => Some(Alone::Open(operand())),
            "MCRA" => Some(Alone::McrActivate),
            "MCRD" => Some(Alone::McrDeactivate),
            ")MCR" => Some(Alone::McrEnd),
            "JU" => Some(Alone::Jump(operand())),
            "UC" => Some(Alone::Call(operand())),
            _ => None,
        };
        match alone {
            Some(alone) => {
                self.at += 1;
                Ok(Content::Alone(alone, self.place(at, at)))
            }
            None if self.mode == Mode::RewritingConstants && matches!(self.peek(), "SET" | "CLR") => self.constant(),
            None => Ok(Content::Rung(self.rung(Tapped::No)?)),
        }
    }

    /// `SET; = x`: a parallel that is always 1, of x itself.
    fn constant(&mut self) -> Read<Content> {
        let at = self.at;
        let one = self.peek() == "SET";
        self.at += 1;
        let stored = self.current().filter(|one| matches!(one.mnemonic, "=" | "S" | "R"));
        let Some(bit) = stored.map(|one| one.operand.clone()) else { return self.before(Reason::Opcode) };
        let place = self.place(at, at);
        let contact = |negated| Kind::contact(bit.clone(), negated).at(place);
        let line = match one {
            true => {
                let branch = |negated| crate::network::model::Branch { line: vec![contact(negated)], bracketed: false };
                vec![Kind::Parallel { branches: vec![branch(false), branch(true)], negated: false }.at(place)]
            }
            false => vec![contact(false), contact(true)],
        };
        self.rewrite(Rewrite::Constant);
        Ok(Content::Rung(self.end(line, Tapped::No)?))
    }

    /// Placeholders that belong to no box do nothing. Says whether nothing else is left.
    pub(super) fn skip_placeholders(&mut self) -> bool {
        while self.is("NOP", "0") && self.current().is_some_and(|one| one.label.is_none()) {
            self.at += 1;
            self.rewrite(Rewrite::Marks);
        }
        self.ended()
    }

    /// Labels stand at the start of a network, or belong to a box.
    pub(super) fn check_labels(&self) -> Read<()> {
        for (index, statement) in self.prepared.statements.iter().enumerate() {
            if statement.label.is_some() && !self.starts.contains(&index) && !self.box_labels.contains(&index) {
                return self.refuse(Reason::Label, index);
            }
            let is_jump = matches!(statement.mnemonic, "JU" | "JC" | "JCN");
            if let Some(target) = self.prepared.labels.get(statement.operand.text.as_str()).filter(|_| is_jump) {
                let own = self.starts.range(..=index).next_back();
                if !self.enabling.contains(&index) && (own == Some(target) || !self.starts.contains(target)) {
                    return self.refuse(Reason::Jump, index);
                }
            }
        }
        Ok(())
    }

    /// A rung; that of a T-branch begins with its line.
    fn rung(&mut self, tapped: Tapped) -> Read<Rung> {
        let (line, flow) = self.line(tapped, Inside::Rung)?;
        let (line, tap) = if tapped == Tapped::Yes { from_left(line) } else { (line, Place::default()) };
        let rung = match flow {
            Flow::Ended => Rung::new(line, End::Open),
            Flow::Goes => self.end(line, tapped)?,
        };
        Ok(Rung { tap, ..rung })
    }

    /// The right end of a rung.
    fn end(&mut self, line: Line, tapped: Tapped) -> Read<Rung> {
        let has_logic = tapped == Tapped::Yes || !line.is_empty();
        let mut outputs = Vec::new();
        while let Some(statement) = self.current() {
            let at = self.at;
            if statement.label.is_some() && at > 0 && !self.starts.contains(&at) {
                break;
            }
            if statement.mnemonic == "="
                && has_logic
                && outputs.is_empty()
                && (self.around.scratch(&statement.operand).is_some() || self.is_named_branch(at))
            {
                return self.branches(line, statement);
            }
            let Some((kind, length)) = self.output(statement, outputs.is_empty() && has_logic)? else { break };
            if !has_logic {
                return self.here(Reason::Logic);
            }
            self.at += length;
            let last = !matches!(kind, OutputKind::Assign(_) | OutputKind::Set(_) | OutputKind::Reset(_) | OutputKind::Save);
            outputs.push(kind.at(self.place(at, self.at - 1)));
            if last {
                break;
            }
        }
        if outputs.is_empty() { self.without_output() } else { Ok(Rung::new(line, End::Outputs(outputs))) }
    }

    fn without_output(&self) -> Read<Rung> {
        match self.peek() {
            ")" => self.here(Reason::Bracket),
            // Also after a box: its ENO or Q was checked, and the check goes on in the next network.
            "" => self.before(Reason::Logic),
            "L" | "T" | "CALL" | "UC" => self.here(Reason::Unconditional),
            name if TimerKind::of(name).is_some() => self.here(Reason::Order),
            _ => self.here(Reason::Two),
        }
    }

    /// A coil and how many statements make it. `alone` if a coil with a value may stand here.
    fn output(&self, statement: &Statement, alone: bool) -> Read<Option<(OutputKind, usize)>> {
        let operand = statement.operand.clone();
        let kind = match statement.mnemonic {
            "=" => OutputKind::Assign(operand),
            "S" if self.class(&operand) == Class::Counter => return self.here(Reason::Order),
            "S" => OutputKind::Set(operand),
            "R" => OutputKind::Reset(operand),
            "SAVE" if self.mnemonic_at(self.at + 1) == "BEC" => return Ok(Some((OutputKind::Return, 2))),
            "SAVE" => OutputKind::Save,
            "JC" => OutputKind::Jump(operand),
            "JCN" => OutputKind::JumpNot(operand),
            "CC" => OutputKind::Call(operand),
            "MCR(" => OutputKind::McrStart,
            "CU" if alone && self.is_coil(1, &operand) => OutputKind::CountUp(operand),
            "CD" if alone && self.is_coil(1, &operand) => OutputKind::CountDown(operand),
            "L" if alone => {
                let Some(next) = self.statement_at(self.at + 1).filter(|next| self.is_coil(2, &next.operand)) else { return Ok(None) };
                let (name, value) = (next.operand.clone(), operand);
                return Ok(match (TimerKind::of(next.mnemonic), next.mnemonic) {
                    (Some(kind), _) => {
                        self.fits(TypedPin::time_of_coil(kind), &value, self.at)?;
                        Some((OutputKind::Timer { kind, timer: name, value }, 2))
                    }
                    (None, "S") => {
                        self.fits(TypedPin::COUNT_OF_COIL, &value, self.at)?;
                        Some((OutputKind::SetCounter { counter: name, value }, 2))
                    }
                    _ => None,
                });
            }
            _ => return Ok(None),
        };
        Ok(Some((kind, 1)))
    }

    /// Refuses an operand that a pin does not take, with the statement that has it.
    pub(super) fn fits(&self, pin: TypedPin, operand: &Operand, at: usize) -> Read<()> {
        let class = self.class(operand);
        if pin.takes.takes(class) {
            return Ok(());
        }
        let detail = format!("{} takes {}, and `{operand}` is {}", pin.shown(), pin.takes.describe(), class.describe());
        Err(Refusal { detail, ..Refusal::new(Reason::Width, self.original(at)) })
    }

    /// What an operand is; addresses say it themselves.
    pub(super) fn class(&self, operand: &str) -> Class {
        self.around.class(operand)
    }

    /// After `count` statements the network ends or the next sub-rung begins.
    pub(super) fn coil_ends(&self, count: usize) -> bool {
        let next = self.at + count;
        self.statement_at(next).is_none() || self.sub_rung_at(next).is_some()
    }

    /// The T-branch whose bit a rung that begins here reads first, perhaps in brackets or after the logic of pins.
    fn sub_rung_at(&self, mut at: usize) -> Option<usize> {
        if self.taps.is_empty() {
            return None;
        }
        loop {
            let statement = self.statement_at(at)?;
            at = match self.feed_at(at) {
                Some(stored) => stored + 1 + usize::from(self.is_feed_mark(stored + 1)),
                None if is_opening(statement) => at + 1,
                None if is_check(statement) => return self.tap(&statement.operand),
                None => return None,
            };
        }
    }

    fn is_feed_mark(&self, at: usize) -> bool {
        self.statement_at(at).is_some_and(|one| one.is("BLD", "103"))
    }

    /// The statement that stores the logic of a pin which begins here.
    pub(super) fn feed_at(&self, at: usize) -> Option<usize> {
        let end = self.string_end(at);
        let store = self.statement_at(end).filter(|one| one.mnemonic == "=" && end > at)?;
        let bit = self.around.scratch(&store.operand)?;
        let read_at_once = self.statement_at(end + 1).is_some_and(|next| is_check(next) && self.around.scratch(&next.operand) == Some(bit));
        (self.is_feed_mark(end + 1) || (self.prepared.handed_over.contains(&bit) && !read_at_once)).then_some(end)
    }

    /// `‹e›; = L x.y; BLD 103` for each pin of a call that has logic.
    pub(super) fn take_feeds(&mut self) -> Read<()> {
        while let Some(stored) = self.feed_at(self.at) {
            let (line, flow) = self.rest(Line::new(), Tapped::No, Inside::Bracket)?;
            let Some(bit) = self.around.scratch(self.operand()).filter(|_| self.at == stored && flow == Flow::Goes) else {
                return self.here(Reason::Two);
            };
            self.at += 1 + usize::from(self.is_feed_mark(self.at + 1));
            if let Some(before) = self.feeds.insert(bit, Feed { line, stored }) {
                return self.refuse(Reason::BitLeft, before.stored);
            }
        }
        Ok(())
    }

    fn branches(&mut self, line: Line, store: &Statement) -> Read<Rung> {
        let stored = self.at;
        let bit = self.around.scratch(&store.operand);
        if self.taps.len() >= BRANCHES_NESTED_MAX {
            return self.here(Reason::Depth);
        }
        if bit.is_none() {
            self.rewrite(Rewrite::NamedBranch);
        }
        self.at += 1;
        self.taps.push(TapBit { bit, name: store.operand.clone() });
        let mine = self.innermost_tap();
        let mut rungs = Vec::new();
        while self.sub_rung_at(self.at) == Some(mine) {
            rungs.push(self.rung(Tapped::Yes)?);
        }
        self.taps.pop();
        let read_later = self.prepared.last_read.get(store.operand.text.as_str()).is_some_and(|last| *last >= self.at);
        if rungs.is_empty() || (bit.is_none() && read_later) {
            return self.refuse(Reason::BitLeft, stored);
        }
        Ok(Rung::new(line, End::Branches(rungs)))
    }

    /// Logic and boxes, until an output, an end or the closing bracket.
    pub(super) fn line(&mut self, tapped: Tapped, inside: Inside) -> Read<(Line, Flow)> {
        self.take_feeds()?;
        self.rest(Line::new(), tapped, inside)
    }

    /// Goes on with a line.
    pub(super) fn rest(&mut self, mut line: Line, mut tapped: Tapped, inside: Inside) -> Read<(Line, Flow)> {
        loop {
            let begin = self.at;
            let had = tapped == Tapped::Yes || !line.is_empty();
            line = if tapped == Tapped::Yes { self.tapped_string(inside)? } else { self.string(line, inside)? };
            let has_string = had || self.at > begin;
            let Some(flow) = self.part(&mut line, has_string, inside)? else { return Ok((line, Flow::Goes)) };
            tapped = Tapped::No;
            if flow == Flow::Ended {
                return Ok((line, flow));
            }
        }
    }

    /// The logic of a sub-rung, which begins with the tapped line.
    fn tapped_string(&mut self, inside: Inside) -> Read<Line> {
        let at = self.at;
        if self.peek() == "A" && self.tap(self.operand()) == Some(self.innermost_tap()) {
            self.at += 1;
            return self.string_on_tap(at, inside);
        }
        self.string(Line::new(), inside)
    }
}

/// A line that begins with the tapped one, and reads it nowhere else, has it at its left; and where it reads it there.
fn from_left(mut line: Line) -> (Line, Place) {
    match line.as_slice() {
        [Element { kind: Kind::Tap { negated: false }, place }, rest @ ..] if !crate::network::write::reads_tap(rest) => {
            let place = *place;
            line.remove(0);
            (line, place)
        }
        _ => (line, Place::default()),
    }
}
