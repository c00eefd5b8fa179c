//! Functions of texts, written out where they are called: LEFT, CONCAT, REPLACE.

use sieben_engine::ir::{Inst, Op, TextAction as Action, Var};
use sieben_engine::machine::Register;
use sieben_engine::numbers_in_texts::{NumberForm, NumberKind, Spelling};
use sieben_model::address::{Area, Width};
use sieben_model::types::{DataType, STRING_LENGTH_MAX};

use super::Lowering;
use crate::st::standard::texts::{Manner, TextAction, TextFunction};
use crate::st::tree::{Argument, Base, Bounds, Call, Place, Scalar, Text, TextRoom, Value, ValueKind};

/// More characters than any text has.
const ALL: u64 = i32::MAX as u64;

/// Texts that are joined at once; one that is cut out of another one counts as two. More would take more temporaries than there are.
const TEXTS_MAX: usize = 16;
const WEIGHT_OF_A_CUT: usize = 2;

/// A text that is there, and how many of its characters count.
type Ready = (Place, TextRoom);

/// A piece of one of the texts: from which character on, counted from 0, and how many.
struct Part {
    text: usize,
    first: Var,
    count: Var,
}

impl Lowering<'_> {
    /// Writes out a call of a function of texts; `None` if its arguments are not those of one. The result goes to `target` if nobody can
    /// tell the difference, else to hidden local data, whose position is left in `self.result`; whether it went to the target.
    pub(super) fn write_out(&mut self, function: TextFunction, call: &Call, target: Option<(&Place, TextRoom)>) -> Option<bool> {
        if !is_usual(function, call) {
            return None;
        }
        let mut texts: Vec<Ready> = Vec::new();
        let mut numbers: Vec<(u32, Value)> = Vec::new();
        let joined = self.joined(function, call, TEXTS_MAX);
        let mut cuts: Vec<(usize, TextFunction, Vec<Value>)> = Vec::new();
        if let Some(joined) = &joined {
            let all = joined.texts();
            let last_change = all.iter().rposition(|(text, _)| self.text_changes(text));
            for (position, (text, cut)) in all.iter().enumerate() {
                let changes = last_change.is_some_and(|last| last > position);
                texts.push(if changes { self.kept_text(text) } else { self.ready(text) });
                if let Some(Cut { function, numbers, .. }) = cut {
                    cuts.push((position, *function, numbers.iter().map(|number| self.keep(number)).collect()));
                }
            }
        } else {
            let mut given: Vec<(u32, Ready)> = Vec::new();
            let last_change = call.arguments.iter().rposition(|argument| self.argument_changes(argument));
            for (position, argument) in call.arguments.iter().enumerate() {
                match argument {
                    Argument::Text { parameter, text, .. } => {
                        let changes = last_change.is_some_and(|last| last > position);
                        given.push((*parameter, if changes { self.kept_text(text) } else { self.ready(text) }));
                    }
                    Argument::Value { parameter, value } => numbers.push((*parameter, self.keep(value))),
                    _ => {}
                }
            }
            texts.extend(by_parameter(given));
        }
        let numbers = by_parameter(numbers);
        if function.action == TextAction::Find {
            let found = self.text_instruction(Action::Find, (&texts[0].0, texts[0].1), (&texts[1].0, texts[1].1), None);
            self.result = Some(self.spill(found, Width::Word));
            self.set_br(None);
            return Some(false);
        }
        if function.action == TextAction::Number {
            let good = self.number(function, number_kind(&call.result)?, &texts[0]);
            self.set_br(good);
            return Some(false);
        }
        let first_is_cut = cuts.first().is_some_and(|&(position, ..)| position == 0);
        let begins = target.and_then(|target| begins_in(function, target, &texts));
        // What the first text leaves out would stay.
        let begins = begins.filter(|&begins| begins == Begins::Empty || !first_is_cut);
        let (to, room) = match (target, begins) {
            (Some((place, room)), Some(_)) => (self.freeze(place), room),
            _ => {
                let room = function.result_room();
                (self.hidden_bytes(room.bytes()), room)
            }
        };
        if function.arity().0 == 0 {
            let good = self.digits(function, &numbers, (&to, room));
            self.set_br(good);
            self.result = begins.is_none().then_some(to.offset);
            return Some(begins.is_some());
        }
        let target = target.filter(|_| begins.is_some());
        let grows = begins == Some(Begins::ItsFirstText);
        let stays = begins == Some(Begins::ItsHead);
        let numbers = self.numbers_of_characters(&numbers);
        let (mut parts, good) = self.parts(function, &texts, &numbers);
        if !cuts.is_empty() {
            let zero_and_one = [0, 1].map(|number| self.constant(number));
            for (position, function, numbers) in cuts {
                let numbers = self.numbers_of_characters(&numbers);
                parts[position] = self.piece(function, (position, &texts[position]), &numbers, zero_and_one);
            }
        }
        if target.is_some() {
            // What lies outside its data block is found before anything is written.
            let written_first = parts.get(usize::from(grows)).map(|part| part.text);
            for (index, (place, max)) in texts.iter().enumerate() {
                let may_fail = place.base != Base::Area(Area::Local) || !place.indexes.is_empty();
                if may_fail && written_first != Some(index) && !(grows && index == 0) {
                    let length = self.text_instruction(Action::Length, (place, *max), (place, *max), None);
                    self.release(length);
                }
            }
        }
        let mut lengths = Vec::with_capacity(parts.len());
        let tail = parts.pop_if(|_| stays).map(|Part { text, first, count }| {
            // What goes on behind the piece that stays is kept first: it may be written over.
            let (place, max) = &texts[text];
            let room = function.result_room();
            let kept = self.hidden_bytes(room.bytes());
            let length = self.text_instruction(Action::Piece, (&kept, room), (place, *max), Some([first, count]));
            self.release(length);
            (kept, room)
        });
        for (index, Part { text, first, count }) in parts.into_iter().enumerate() {
            let (place, max) = &texts[text];
            let action = match index {
                0 if grows => Action::Length,
                0 => Action::Piece,
                _ => Action::Append,
            };
            let piece = action.takes_piece().then_some([first, count]);
            lengths.push(self.text_instruction(action, (&to, room), (place, *max), piece));
        }
        if let Some((kept, kept_room)) = tail {
            let [zero, all] = [0, ALL].map(|number| self.constant(number));
            lengths.push(self.text_instruction(Action::Append, (&to, room), (&kept, kept_room), Some([zero, all])));
        }
        let whole = match &joined {
            _ if good.is_none() => None,
            Some(joined) => Some(self.whole_length(joined, &mut lengths.into_iter())),
            None => lengths.into_iter().reduce(|whole, length| self.compute(Op::AddU32, &[whole, length])),
        };
        let good = good.zip(whole).map(|(good, whole)| {
            // What the result of the block would have no room for.
            let most = self.constant(u64::from(STRING_LENGTH_MAX));
            let fits = self.compute(Op::LeI32, &[whole, most]);
            self.compute(Op::And, &[good, fits])
        });
        self.set_br(good);
        self.result = target.is_none().then_some(to.offset);
        Some(target.is_some())
    }

    /// Numbers and positions of characters.
    fn numbers_of_characters(&mut self, numbers: &[Value]) -> Vec<Var> {
        let extended = |this: &mut Self, number: &Value| {
            let number = this.value(number);
            this.compute(Op::Extend16, &[number])
        };
        numbers.iter().map(|number| extended(self, number)).collect()
    }

    /// A text whose place stays the same until the end of the source statement.
    fn ready(&mut self, text: &Text) -> Ready {
        let (place, room) = self.text(text);
        (self.freeze(&place), room)
    }

    /// What a CONCAT joins, with the texts of those that are its texts: nobody sees what they join on the way.
    fn joined<'c>(&self, function: TextFunction, call: &'c Call, most: usize) -> Option<Joined<'c>> {
        if function.action != TextAction::Concat {
            return None;
        }
        let mut given: Vec<(u32, &Text)> = call
            .arguments
            .iter()
            .filter_map(|argument| match argument {
                Argument::Text { parameter, text, .. } => Some((*parameter, text)),
                _ => None,
            })
            .collect();
        // They are computed in the order in which they are written; where that is another one, each is joined for itself.
        let is_ordered = given.is_sorted_by_key(|(parameter, _)| *parameter);
        given.sort_by_key(|(parameter, _)| *parameter);
        let [(_, first), (_, second)] = given[..] else { return None };
        if !is_ordered {
            return None;
        }
        let inner = |text: &'c Text, most: usize| match text {
            Text::Call { call, .. } if call.written_out == Some(function) && is_unseen(function, call) => self.joined(function, call, most),
            _ => None,
        };
        // The last text is computed before the first ones are looked at.
        let calm = [first, second].iter().all(|text| self.changes_nothing(text));
        let join = |text: &'c Text, most: usize| match inner(text, most) {
            Some(joined) if calm && joined.weight() <= most => joined,
            _ => cut(text).filter(|_| calm && most >= WEIGHT_OF_A_CUT).map_or(Joined::Text(text), Joined::Cut),
        };
        let first = join(first, most.saturating_sub(1));
        let left = most.saturating_sub(first.weight());
        Some(Joined::Both(Box::new([first, join(second, left)])))
    }

    /// A text that keeps its characters, whatever is computed before it is used.
    pub(super) fn kept_text(&mut self, text: &Text) -> Ready {
        let (place, most) = self.text(text);
        let Text::Place { .. } = text else { return (place, most) };
        let room = if most.is_unknown() { TextRoom { characters_max: STRING_LENGTH_MAX.into(), ..most } } else { most };
        let kept = self.empty_text(room);
        self.copy_text(&kept, room, &place, most);
        (kept, room)
    }

    /// Whether something that a program sees may change while an argument is computed.
    pub(super) fn argument_changes(&self, argument: &Argument) -> bool {
        match argument {
            Argument::Text { text, .. } => self.text_changes(text),
            Argument::Value { value, .. } | Argument::Number { value, .. } => self.value_changes(value),
            other => other.place().is_some_and(|place| self.place_changes(place)),
        }
    }

    /// The same of a text.
    pub(super) fn text_changes(&self, text: &Text) -> bool {
        match text {
            Text::Constant(_) | Text::WideConstant(_) => false,
            Text::Converted(text) => self.text_changes(text),
            Text::Place { place, .. } => self.place_changes(place),
            Text::Character(value) => self.value_changes(value),
            Text::Call { call, .. } => self.call_changes(call),
            Text::After(..) => true,
        }
    }

    fn call_changes(&self, call: &Call) -> bool {
        !call.of_library || call.enable.is_some() || call.arguments.iter().any(|argument| self.argument_changes(argument))
    }

    fn value_changes(&self, value: &Value) -> bool {
        // A value whose computation begins no new IR statement calls nothing.
        match &value.kind {
            _ if !self.breaks(value) => false,
            ValueKind::Call(call) => self.call_changes(call),
            ValueKind::Load(place) | ValueKind::AddressOf(place) => self.place_changes(place),
            ValueKind::Compute { args, .. } | ValueKind::Checked { args, .. } | ValueKind::Intrinsic { args, .. } => {
                args.iter().any(|arg| self.value_changes(arg))
            }
            ValueKind::AndThen(a, b) | ValueKind::OrElse(a, b) => self.value_changes(a) || self.value_changes(b),
            ValueKind::Choose { condition, a, b } => [condition, a, b].into_iter().any(|value| self.value_changes(value)),
            ValueKind::CompareTexts(a, b) => self.text_changes(a) || self.text_changes(b),
            ValueKind::Length(text) => self.text_changes(text),
            _ => true,
        }
    }

    fn place_changes(&self, place: &Place) -> bool {
        let base = match &place.base {
            Base::ComputedDataBlock(value) | Base::Reference(value) => self.value_changes(value),
            _ => false,
        };
        base || place.indexes.iter().any(|index| self.value_changes(&index.value))
    }

    /// Whether nothing that a program sees changes while a text is computed.
    fn changes_nothing(&self, text: &Text) -> bool {
        match text {
            Text::Constant(_) | Text::WideConstant(_) | Text::Place { .. } | Text::Character(_) => !self.text_breaks(text),
            Text::Converted(text) => self.changes_nothing(text),
            Text::After(..) => false,
            Text::Call { call, .. } => {
                let calm = |argument: &Argument| match argument {
                    Argument::Text { text, .. } => self.changes_nothing(text),
                    Argument::Value { value, .. } => !self.breaks(value),
                    _ => false,
                };
                call.enable.is_none()
                    && call.written_out.is_some_and(|function| is_usual(function, call))
                    && call.arguments.iter().all(calm)
            }
        }
    }

    /// How many characters joined texts have; a result inside has at most so many as any result.
    fn whole_length(&mut self, joined: &Joined<'_>, lengths: &mut dyn Iterator<Item = Var>) -> Var {
        let Joined::Both(both) = joined else { return lengths.next().unwrap_or_else(|| self.constant(0)) };
        let [first, second] = [&both[0], &both[1]].map(|part| {
            let length = self.whole_length(part, lengths);
            match part {
                Joined::Text(_) | Joined::Cut(_) => length,
                Joined::Both(_) => self.compute_with(Op::MinI32, length, u64::from(STRING_LENGTH_MAX)),
            }
        });
        self.compute(Op::AddU32, &[first, second])
    }

    /// Reads a number from a text to hidden local data; whether it is one, if anybody asks.
    fn number(&mut self, function: TextFunction, kind: NumberKind, (text, room): &Ready) -> Option<Var> {
        let spelling = match function.manner {
            Manner::S7 => Spelling::S7,
            Manner::Codesys => Spelling::Beginning,
            Manner::Iec | Manner::Tia => Spelling::Literal,
        };
        let form = self.constant(NumberForm { spelling, kind }.word());
        let zero = self.constant(0);
        let to = self.hidden_bytes(TextRoom::NUMBER.bytes());
        let good = self.text_instruction(Action::Number, (&to, TextRoom::NUMBER), (text, *room), Some([form, zero]));
        self.release(form);
        self.release(zero);
        self.result = Some(to.offset);
        if spelling == Spelling::Beginning {
            self.release(good);
            return None;
        }
        Some(good)
    }

    /// Writes the characters of a number; whether it has some, if that is not sure.
    fn digits(&mut self, function: TextFunction, numbers: &[Value], (to, room): (&Place, TextRoom)) -> Option<Var> {
        let action = match (function.action, function.manner) {
            (TextAction::Unsigned, _) => Action::Unsigned,
            (TextAction::Real, Manner::S7) => Action::RealS7,
            (TextAction::Real, _) => Action::Real,
            (TextAction::LongReal, _) => Action::LongReal,
            (_, Manner::S7) => Action::SignedAlways,
            _ => Action::Signed,
        };
        let number = self.value(&numbers[0]);
        let number = match numbers[0].scalar {
            Scalar::I16 => self.compute(Op::ExtendI16I64, &[number]),
            Scalar::I32 => self.compute(Op::ExtendI32I64, &[number]),
            _ => number,
        };
        let length = self.text_instruction(action, (to, room), (to, room), Some([number, number]));
        self.release(number);
        if action == Action::RealS7 {
            let least = self.constant(1);
            return Some(self.compute(Op::GeI32, &[length, least]));
        }
        self.release(length);
        None
    }

    /// BR is what the block would leave there; `None` = 1.
    fn set_br(&mut self, good: Option<Var>) {
        let br = Register::Br.into();
        match good {
            Some(good) => {
                self.copy_var(br, good);
                self.release(good);
            }
            None => self.push(Inst::Constant { dst: br, value: 1 }),
        }
    }

    /// The piece of one of the texts that LEFT, MID or RIGHT gives.
    fn piece(&mut self, function: TextFunction, (text, ready): (usize, &Ready), numbers: &[Var], [zero, one]: [Var; 2]) -> Part {
        let TextFunction { action, manner, .. } = function;
        match *numbers {
            // A piece that begins behind the text, or has no characters, is empty of itself.
            [wanted, position] => {
                let from = self.compute_from(Op::MaxI32, &[position, one]);
                let first = self.compute_from(Op::SubU32, &[from, one]);
                if manner == Manner::Codesys {
                    return Part { text, first, count: wanted };
                }
                let inside = self.compute_from(Op::LtI32, &[zero, position]);
                let count = self.compute_from(Op::Gate, &[wanted, inside]);
                Part { text, first, count }
            }
            [wanted] if action == TextAction::Right => {
                let length = self.length_of(ready);
                let count = self.compute_from(Op::MaxI32, &[wanted, zero]);
                let count = self.compute_from(Op::MinI32, &[count, length]);
                let first = self.compute_from(Op::SubU32, &[length, count]);
                Part { text, first, count }
            }
            _ => Part { text, first: zero, count: numbers[0] },
        }
    }

    /// How many characters a text has.
    fn length_of(&mut self, (place, room): &Ready) -> Var {
        self.text_instruction(Action::Length, (place, *room), (place, *room), None)
    }

    /// The pieces of which the result consists, and whether the numbers name characters; `None` = nobody asks.
    fn parts(&mut self, function: TextFunction, texts: &[Ready], numbers: &[Var]) -> (Vec<Part>, Option<Var>) {
        let TextFunction { action, manner, .. } = function;
        let reports = manner != Manner::Codesys;
        let zero = self.constant(0);
        let one = self.constant(1);
        let all = self.constant(ALL);
        let whole = |text: usize| Part { text, first: zero, count: all };
        match action {
            TextAction::Left | TextAction::Right => {
                let good = self.compute_from(Op::GeI32, &[numbers[0], zero]);
                (vec![self.piece(function, (0, &texts[0]), numbers, [zero, one])], reports.then_some(good))
            }
            TextAction::Mid => {
                let good = reports.then(|| {
                    let [wanted, position] = [numbers[0], numbers[1]];
                    let length = self.length_of(&texts[0]);
                    let some = self.compute_from(Op::LtI32, &[zero, wanted]);
                    let inside = self.compute_from(Op::LtI32, &[zero, position]);
                    let there = self.compute_from(Op::LeI32, &[position, length]);
                    let good = self.compute_from(Op::And, &[some, inside]);
                    self.compute_from(Op::And, &[good, there])
                });
                (vec![self.piece(function, (0, &texts[0]), numbers, [zero, one])], good)
            }
            TextAction::Concat => ((0..texts.len()).map(whole).collect(), reports.then_some(one)),
            TextAction::Insert => {
                let position = numbers[0];
                let good = self.compute_from(Op::GeI32, &[position, zero]);
                let inserts = match reports {
                    true => good,
                    false => {
                        let most = self.constant(u64::from(u8::MAX));
                        let near = self.compute_from(Op::LeI32, &[position, most]);
                        self.compute_from(Op::And, &[good, near])
                    }
                };
                let count = self.compute_from(Op::Gate, &[all, inserts]);
                // What inserts nothing takes all of the first text with CODESYS, and nothing of it otherwise.
                let head = if reports { position } else { self.compute_from(Op::Select, &[inserts, position, all]) };
                let parts = vec![
                    Part { text: 0, first: zero, count: head },
                    Part { text: 1, first: zero, count },
                    Part { text: 0, first: position, count },
                ];
                (parts, reports.then_some(good))
            }
            TextAction::Delete => {
                let [wanted, position] = [numbers[0], numbers[1]];
                let from = self.compute_from(Op::MaxI32, &[position, one]);
                let head = self.compute_from(Op::SubU32, &[from, one]);
                let none = self.compute_from(Op::GeI32, &[zero, position]);
                let least = if manner == Manner::Iec { one } else { zero };
                let enough = self.compute_from(Op::GeI32, &[position, least]);
                let positive = self.compute_from(Op::GeI32, &[wanted, zero]);
                let good = self.compute_from(Op::And, &[enough, positive]);
                let wanted = match manner {
                    Manner::Codesys => {
                        // Position 0 counts as one of the characters.
                        let fewer = self.compute_from(Op::SubU32, &[wanted, one]);
                        let wanted = self.compute_from(Op::Select, &[none, fewer, wanted]);
                        self.compute_from(Op::Gate, &[wanted, enough])
                    }
                    _ => {
                        let some = self.compute_from(Op::AndNot, &[good, none]);
                        self.compute_from(Op::Gate, &[wanted, some])
                    }
                };
                let gap = self.compute_from(Op::MaxI32, &[wanted, zero]);
                let behind = self.compute_from(Op::AddU32, &[head, gap]);
                // The S7 function gives nothing for a wrong number, the others all.
                let rest = if manner == Manner::S7 { self.compute_from(Op::Gate, &[all, good]) } else { all };
                let head = if manner == Manner::S7 { self.compute_from(Op::Gate, &[head, good]) } else { head };
                (vec![Part { text: 0, first: zero, count: head }, Part { text: 0, first: behind, count: rest }], reports.then_some(good))
            }
            TextAction::Replace => {
                let [wanted, position] = [numbers[0], numbers[1]];
                let from = self.compute_from(Op::MaxI32, &[position, one]);
                let head = self.compute_from(Op::SubU32, &[from, one]);
                let least = if manner == Manner::Tia { one } else { zero };
                let enough = self.compute_from(Op::GeI32, &[position, least]);
                let positive = self.compute_from(Op::GeI32, &[wanted, zero]);
                let does = self.compute_from(Op::And, &[enough, positive]);
                let behind = self.compute_from(Op::AddU32, &[head, wanted]);
                let head = self.compute_from(Op::Gate, &[head, does]);
                let rest = self.compute_from(Op::Gate, &[all, does]);
                let mut new = rest;
                if manner == Manner::S7 {
                    // Nothing replaced is nothing new.
                    let some = self.compute_from(Op::LtI32, &[zero, wanted]);
                    new = self.compute_from(Op::Gate, &[rest, some]);
                }
                let good = match manner {
                    // Position 0 counts as 1, and is reported.
                    Manner::Iec => {
                        let named = self.compute_from(Op::GeI32, &[position, one]);
                        self.compute_from(Op::And, &[does, named])
                    }
                    _ => does,
                };
                let parts = vec![
                    Part { text: 0, first: zero, count: head },
                    Part { text: 1, first: zero, count: new },
                    Part { text: 0, first: behind, count: rest },
                ];
                (parts, reports.then_some(good))
            }
            TextAction::Find | TextAction::Number => unreachable!("it makes no text"),
            TextAction::Unsigned | TextAction::Signed | TextAction::Real | TextAction::LongReal => unreachable!("it has no text"),
        }
    }
}

/// How a result comes about in its target, instead of hidden local data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Begins {
    /// Its first piece is written there.
    Empty,
    /// The target is the first text, and the others are put behind it.
    ItsFirstText,
    /// The target is the first text, of which the first piece stays and the last one is kept aside while the others are put behind it.
    ItsHead,
}

/// Texts that are joined, and how.
enum Joined<'c> {
    Text(&'c Text),
    Cut(Cut<'c>),
    Both(Box<[Joined<'c>; 2]>),
}

/// A piece of a text, of which nobody sees the text that LEFT, MID or RIGHT makes of it.
struct Cut<'c> {
    function: TextFunction,
    text: &'c Text,
    numbers: Vec<&'c Value>,
}

impl<'c> Joined<'c> {
    /// All of them, in their order, with what is cut out of them.
    fn texts(&self) -> Vec<(&'c Text, Option<&Cut<'c>>)> {
        match self {
            Self::Text(text) => vec![(text, None)],
            Self::Cut(cut) => vec![(cut.text, Some(cut))],
            Self::Both(both) => both.iter().flat_map(Self::texts).collect(),
        }
    }

    /// How much of `TEXTS_MAX` they take.
    fn weight(&self) -> usize {
        match self {
            Self::Text(_) => 1,
            Self::Cut(_) => WEIGHT_OF_A_CUT,
            Self::Both(both) => both.iter().map(Self::weight).sum(),
        }
    }
}

/// The piece that a text is of another one.
fn cut(text: &Text) -> Option<Cut<'_>> {
    let Text::Call { call, .. } = text else { return None };
    let function = call.written_out.filter(|&function| function.cuts() && is_unseen(function, call))?;
    let mut whole = None;
    let mut numbers: Vec<(u32, &Value)> = Vec::new();
    for argument in &call.arguments {
        match argument {
            Argument::Text { text, .. } => whole = Some(text),
            Argument::Value { parameter, value } => numbers.push((*parameter, value)),
            _ => return None,
        }
    }
    Some(Cut { function, text: whole?, numbers: by_parameter(numbers) })
}

/// What arguments are, in the order of the parameters.
fn by_parameter<T>(mut given: Vec<(u32, T)>) -> Vec<T> {
    given.sort_by_key(|(parameter, _)| *parameter);
    given.into_iter().map(|(_, it)| it).collect()
}

/// Whether nobody sees what a function reports that makes one of the texts of a CONCAT, nor what has no room in its result.
fn is_unseen(function: TextFunction, call: &Call) -> bool {
    !function.wide && call.enable.is_none() && !call.clears_ok && is_usual(function, call)
}

/// How the result of a function comes about in its target; `None` if somebody could tell the difference.
fn begins_in(function: TextFunction, (target, room): (&Place, TextRoom), texts: &[Ready]) -> Option<Begins> {
    let apart = |text: &Ready| are_apart((target, room), text);
    if texts.iter().all(apart) && (!texts.is_empty() || !room.is_unknown()) {
        return Some(Begins::Empty);
    }
    let fits = |(_, room): &Ready| !room.is_unknown() && room.characters_max <= function.result_room().characters_max;
    // What has room for more than a result would get more of it.
    match room.is_unknown() {
        true if !is_handed_on(target) || room.wide => return None,
        true if texts.iter().all(|text| fits(text) && is_own(text)) && !texts.is_empty() => return Some(Begins::Empty),
        true if function.makes_one_piece() && !texts.iter().all(fits) => return None,
        false if room.characters_max > function.result_room().characters_max => return None,
        _ => {}
    }
    if function.makes_one_piece() {
        return Some(Begins::Empty);
    }
    let is_it = |(place, text_room): &Ready| {
        *text_room == room
            && place.indexes.is_empty()
            && target.indexes.is_empty()
            && (is_kept(place) || is_handed_on(place))
            && place.base == target.base
            && place.offset == target.offset
    };
    let apart = |text: &Ready| apart(text) || room.is_unknown() && is_own(text);
    if matches!(function.action, TextAction::Delete | TextAction::Insert | TextAction::Replace) {
        let [first, others @ ..] = texts else { return None };
        return (is_it(first) && others.iter().all(apart)).then_some(Begins::ItsHead);
    }
    let [first, second, rest @ ..] = texts else { return None };
    // One text is read before it is put behind the other one, whatever they share.
    let grows = function.action == TextAction::Concat
        && is_it(first)
        && (rest.is_empty() || is_it(second) || apart(second))
        && rest.iter().all(apart);
    grows.then_some(Begins::ItsFirstText)
}

/// Whether a text lies where a pointer leads that the block was given.
fn is_handed_on(place: &Place) -> bool {
    matches!(place.base, Base::ComplexParameter(_) | Base::InstancePointer(_)) && place.indexes.is_empty()
}

/// Whether a text lies in the local data of its block, to which nothing leads that it was given.
fn is_own((place, room): &Ready) -> bool {
    place.base == Base::Area(Area::Local) && extent(place, *room).is_some()
}

/// Whether a place lies where it says, in an area that no pointer leads to.
fn is_kept(place: &Place) -> bool {
    matches!(place.base, Base::Area(Area::Local | Area::BitMemory) | Base::Instance | Base::DataBlock(_))
}

/// The bits of its area that a text may lie in: all elements that its indexes may name.
fn extent(place: &Place, room: TextRoom) -> Option<(u64, u64)> {
    let mut reach = 0_u64;
    for index in &place.indexes {
        if index.check == Bounds::None {
            return None;
        }
        reach = reach.checked_add(index.count.checked_sub(1)?.checked_mul(u64::from(index.step))?)?;
    }
    let start = u64::from(place.offset);
    is_kept(place).then_some((start, start.checked_add(reach)? + 8 * u64::from(room.bytes())))
}

/// Whether a call has exactly the texts and numbers that the function takes.
fn is_usual(function: TextFunction, call: &Call) -> bool {
    let texts = call.arguments.iter().filter(|argument| matches!(argument, Argument::Text { .. })).count();
    let numbers = call.arguments.iter().filter(|argument| matches!(argument, Argument::Value { .. })).count();
    let is_result = match function.action {
        TextAction::Find => call.result == DataType::Int,
        TextAction::Number => number_kind(&call.result).is_some(),
        _ if function.wide => call.result == DataType::WideString(STRING_LENGTH_MAX.into()),
        _ => call.result == DataType::String(STRING_LENGTH_MAX),
    };
    (texts, numbers) == function.arity() && call.arguments.len() == texts + numbers && is_result
}

/// What a text becomes.
fn number_kind(data_type: &DataType) -> Option<NumberKind> {
    Some(match data_type {
        DataType::SmallInt => NumberKind::I8,
        DataType::Int => NumberKind::I16,
        DataType::DoubleInt => NumberKind::I32,
        DataType::LongInt => NumberKind::I64,
        DataType::UnsignedSmallInt => NumberKind::U8,
        DataType::UnsignedInt => NumberKind::U16,
        DataType::UnsignedDoubleInt => NumberKind::U32,
        DataType::UnsignedLongInt => NumberKind::U64,
        DataType::Byte => NumberKind::Bits8,
        DataType::Word => NumberKind::Bits16,
        DataType::DoubleWord => NumberKind::Bits32,
        DataType::LongWord => NumberKind::Bits64,
        DataType::Real => NumberKind::F32,
        DataType::LongReal => NumberKind::F64,
        _ => return None,
    })
}

/// Whether a target is known to share no byte with a text, wherever the program runs.
fn are_apart((target, room): (&Place, TextRoom), (text, from_room): &Ready) -> bool {
    if room.is_unknown() {
        return false;
    }
    let (Some((start, end)), Some((from_start, from_end))) = (extent(target, room), extent(text, *from_room)) else { return false };
    match (&target.base, &text.base) {
        (a, b) if a == b => end <= from_start || from_end <= start,
        // The instance may be the same data block.
        (Base::Instance, Base::DataBlock(_)) | (Base::DataBlock(_), Base::Instance) => false,
        _ => true,
    }
}
