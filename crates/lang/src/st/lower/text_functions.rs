//! Functions of texts, written out where they are called: LEFT, CONCAT, REPLACE.

use sieben_engine::ir::{Inst, Op, TextAction as Action, Var};
use sieben_engine::machine::Register;
use sieben_model::address::{Area, Width};
use sieben_model::types::{DataType, STRING_LENGTH_MAX};

use super::Lowering;
use crate::st::standard::texts::{Manner, TextAction, TextFunction};
use crate::st::tree::{Argument, Base, Call, Place, TextRoom, Value};

/// More characters than any text has.
const ALL: u64 = i32::MAX as u64;

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
        let mut texts: Vec<(u32, Ready)> = Vec::new();
        let mut numbers: Vec<(u32, Value)> = Vec::new();
        for argument in &call.arguments {
            match argument {
                Argument::Text { parameter, text, .. } => {
                    let (place, room) = self.text(text);
                    texts.push((*parameter, (self.freeze(&place), room)));
                }
                Argument::Value { parameter, value } => numbers.push((*parameter, self.keep(value))),
                _ => {}
            }
        }
        texts.sort_by_key(|(parameter, _)| *parameter);
        numbers.sort_by_key(|(parameter, _)| *parameter);
        let texts: Vec<Ready> = texts.into_iter().map(|(_, text)| text).collect();
        let numbers: Vec<Value> = numbers.into_iter().map(|(_, number)| number).collect();
        if function.action == TextAction::Find {
            let found = self.text_instruction(Action::Find, (&texts[0].0, texts[0].1), (&texts[1].0, texts[1].1), None);
            self.result = Some(self.spill(found, Width::Word));
            self.set_br(None);
            return Some(false);
        }
        let target = target.filter(|target| texts.iter().all(|text| are_apart(*target, text)));
        let (to, room) = match target {
            Some((place, room)) => (place.clone(), room),
            None => {
                let room = function.result_room();
                (self.hidden_bytes(room.bytes()), room)
            }
        };
        let numbers: Vec<Var> = numbers
            .iter()
            .map(|number| {
                let number = self.value(number);
                self.compute(Op::Extend16, &[number])
            })
            .collect();
        let (parts, good) = self.parts(function, &texts, &numbers);
        if target.is_some() {
            // What lies outside its data block is found before anything is written.
            for (index, (place, max)) in texts.iter().enumerate() {
                if place.base != Base::Area(Area::Local) && parts.first().is_some_and(|part| part.text != index) {
                    let length = self.text_instruction(Action::Length, (place, *max), (place, *max), None);
                    self.release(length);
                }
            }
        }
        let mut whole: Option<Var> = None;
        for (index, Part { text, first, count }) in parts.into_iter().enumerate() {
            let action = if index == 0 { Action::Piece } else { Action::Append };
            let (place, max) = &texts[text];
            let length = self.text_instruction(action, (&to, room), (place, *max), Some([first, count]));
            whole = Some(match whole {
                Some(whole) => self.compute(Op::AddU32, &[whole, length]),
                None => length,
            });
        }
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

    /// The pieces of which the result consists, and whether the numbers name characters; `None` = nobody asks.
    fn parts(&mut self, TextFunction { action, manner, .. }: TextFunction, texts: &[Ready], numbers: &[Var]) -> (Vec<Part>, Option<Var>) {
        let reports = manner != Manner::Codesys;
        let zero = self.constant(0);
        let one = self.constant(1);
        let all = self.constant(ALL);
        let whole = |text: usize| Part { text, first: zero, count: all };
        match action {
            TextAction::Left => {
                let good = self.compute_from(Op::GeI32, &[numbers[0], zero]);
                (vec![Part { text: 0, first: zero, count: numbers[0] }], reports.then_some(good))
            }
            TextAction::Right => {
                let good = self.compute_from(Op::GeI32, &[numbers[0], zero]);
                let length = self.text_instruction(Action::Length, (&texts[0].0, texts[0].1), (&texts[0].0, texts[0].1), None);
                let count = self.compute_from(Op::MaxI32, &[numbers[0], zero]);
                let count = self.compute_from(Op::MinI32, &[count, length]);
                let first = self.compute_from(Op::SubU32, &[length, count]);
                (vec![Part { text: 0, first, count }], reports.then_some(good))
            }
            TextAction::Mid => {
                let [wanted, position] = [numbers[0], numbers[1]];
                let from = self.compute_from(Op::MaxI32, &[position, one]);
                let first = self.compute_from(Op::SubU32, &[from, one]);
                if !reports {
                    return (vec![Part { text: 0, first, count: wanted }], None);
                }
                let length = self.text_instruction(Action::Length, (&texts[0].0, texts[0].1), (&texts[0].0, texts[0].1), None);
                let some = self.compute_from(Op::LtI32, &[zero, wanted]);
                let inside = self.compute_from(Op::LtI32, &[zero, position]);
                let there = self.compute_from(Op::LeI32, &[position, length]);
                let good = self.compute_from(Op::And, &[some, inside]);
                let good = self.compute_from(Op::And, &[good, there]);
                let count = self.compute_from(Op::Gate, &[wanted, good]);
                (vec![Part { text: 0, first, count }], Some(good))
            }
            TextAction::Concat => (vec![whole(0), whole(1)], reports.then_some(one)),
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
            TextAction::Find => unreachable!("it makes no text"),
        }
    }
}

/// Whether a call has exactly the texts and numbers that the function takes.
fn is_usual(function: TextFunction, call: &Call) -> bool {
    let texts = call.arguments.iter().filter(|argument| matches!(argument, Argument::Text { .. })).count();
    let numbers = call.arguments.iter().filter(|argument| matches!(argument, Argument::Value { .. })).count();
    let result = match function.action {
        TextAction::Find => DataType::Int,
        _ if function.wide => DataType::WideString(STRING_LENGTH_MAX.into()),
        _ => DataType::String(STRING_LENGTH_MAX),
    };
    (texts, numbers) == function.arity() && call.arguments.len() == texts + numbers && call.result == result
}

/// Whether a target is known to share no byte with a text, wherever the program runs.
fn are_apart((target, room): (&Place, TextRoom), (text, from_room): &Ready) -> bool {
    let is_plain = |place: &Place| {
        let area = matches!(place.base, Base::Area(Area::Local | Area::BitMemory) | Base::Instance | Base::DataBlock(_));
        area && place.indexes.is_empty()
    };
    if room.is_unknown() || !is_plain(target) || !is_plain(text) {
        return false;
    }
    let end = |place: &Place, room: TextRoom| u64::from(place.offset) + 8 * u64::from(room.bytes());
    match (&target.base, &text.base) {
        (a, b) if a == b => end(target, room) <= u64::from(text.offset) || end(text, *from_room) <= u64::from(target.offset),
        // The instance may be the same data block.
        (Base::Instance, Base::DataBlock(_)) | (Base::DataBlock(_), Base::Instance) => false,
        _ => true,
    }
}
