//! Boxes of form A: their operand, their pins on the same line or on lines of their own.

use super::line::{Argument, Input, Mark, TextLine, arguments, is_name, operand, split};
use super::parse::Parser;
use crate::network::boxes::{BoxRow, CounterKind, TimerKind};
use crate::network::flavour::Flavour;
use crate::network::mistake::{Mistake, MistakeKind};
use crate::network::model::{Actual, Counter, Element, Kind, Line, NamedBox, NamedInput, Pin, Place, Timer};
use crate::network::operand::{Operand, may_name_output};

/// The first line of a box.
#[derive(Clone, Copy)]
pub(super) struct Boxes<'w, 't> {
    pub line: TextLine<'t>,
    /// The name of the box.
    pub word: &'w str,
    /// Where what follows the name begins.
    pub rest: usize,
    pub place: Place,
}

/// A pin as it is written.
struct Wired {
    name: Option<Operand>,
    wire: Wire,
    start: usize,
    end: usize,
}

enum Wire {
    Input(Input),
    Logic(Line),
    Output(Operand),
}

impl Wired {
    fn is(&self, name: &str) -> bool {
        self.name.as_deref().is_some_and(|own| own.eq_ignore_ascii_case(name))
    }
}

impl Wire {
    /// As logic: an operand is a contact.
    fn line(self, place: Place) -> Option<Line> {
        match self {
            Self::Input(Input { operand, mark }) => Some(vec![Kind::contact(operand, mark == Mark::Negated).at(place)]),
            Self::Logic(line) => Some(line),
            Self::Output(_) => None,
        }
    }
}

impl<'t> Parser<'_, 't> {
    /// A box with the logic at its first pin, if that is written as a pin, and the lines that belong to it.
    pub(super) fn a_box(&mut self, this: Boxes<'_, 't>) -> Option<(Line, Element)> {
        if self.flavour == Flavour::Iec {
            return self.named(this).map(|kind| (Vec::new(), kind.at(this.place)));
        }
        if let Some(row) = BoxRow::of_name(this.word) {
            return self.plain(this, row).map(|kind| (Vec::new(), kind.at(this.place)));
        }
        let timer = TimerKind::ALL.iter().find(|row| row.2 == this.word).map(|row| row.0);
        let counter = CounterKind::ALL.iter().find(|row| row.1 == this.word).map(|row| row.0);
        match (this.word, timer, counter) {
            ("CALL", ..) => self.call(this).map(|kind| (Vec::new(), kind.at(this.place))),
            ("SR" | "RS", ..) => self.flip_flop(this),
            (_, Some(kind), _) => self.timer(this, kind),
            (_, _, Some(kind)) => self.counter(this, kind),
            _ => {
                self.pins(this.line, Vec::new());
                let message = format!("`{}` is no element of a diagram", if this.word.is_empty() { this.line.content } else { this.word });
                let (start, end) = (this.line.start, this.line.end());
                self.wrong(Mistake::new(MistakeKind::Word, start, end, message).help(
                    "an element begins with a word such as NO, NC, COIL, OR, BRANCH or the name of a box (MOVE, ADD_I, S_ODT, CALL)",
                ));
                None
            }
        }
    }

    /// The operand of a box that has one, and its pins: `S_ODT T 5`, `S_ODT T 5 TV := S5T#2S`, `SR[M 0.0](R := I 0.1)`.
    fn head(&mut self, this: Boxes<'_, 't>) -> (Option<Operand>, Vec<Wired>) {
        let written = &this.line.content[this.rest..];
        let start = this.line.start + this.rest;
        let (inside, more, more_at) = bracketed(written);
        if let Some((at, inside)) = inside {
            let pins = self.inline(more, start + more_at);
            return (Some(operand(inside, start + at)), self.pins(this.line, pins));
        }
        // The operand ends where the first pin begins: a name before `:=` or `=>`.
        let end = first_pin(written);
        let own = written[..end].trim_end().trim_end_matches(',');
        let pins = self.inline(&written[end..], start + end);
        let own = (!own.trim().is_empty()).then(|| operand(own, start));
        if own.is_none() {
            self.mistake(MistakeKind::Operand, this.line, format!("`{}` needs its operand: `{0} T 5`, `{0} M 0.0`", this.word));
        }
        (own, self.pins(this.line, pins))
    }

    /// Pins on the line of the box.
    fn inline(&mut self, written: &str, start: usize) -> Vec<Wired> {
        let trimmed = written.trim();
        let (text, start) = match trimmed.strip_prefix('(').and_then(|inner| inner.strip_suffix(')')) {
            Some(inner) => (inner, start + (written.len() - written.trim_start().len()) + 1),
            None => (written, start),
        };
        arguments(text, start).into_iter().flat_map(wired).collect()
    }

    /// Pins on lines of their own, after those on the line of the box.
    fn pins(&mut self, line: TextLine<'t>, mut pins: Vec<Wired>) -> Vec<Wired> {
        while let Some(next) = self.peek() {
            let Some((name, sign, rest)) = pin_of(next.content) else { break };
            // `ADD => x` below a box of IEC 61131-3 is the next box, unless it is indented like a pin.
            if next.indent < line.indent || self.flavour == Flavour::Iec && next.indent == line.indent {
                break;
            }
            self.take(1);
            let name = operand(name, next.start);
            let (start, end) = (next.start, next.end());
            let written = &next.content[rest..];
            let wire = match sign {
                ":" => Some(Wire::Logic(self.pin_logic(next))),
                ":=" => arguments(written, next.start + rest).into_iter().find_map(|one| one.input).map(Wire::Input),
                _ => (!written.trim().is_empty()).then(|| Wire::Output(operand(written, next.start + rest))),
            };
            match wire {
                // `TRUE => x` on a line of its own: an input and the result.
                Some(wire @ Wire::Output(_)) if !may_name_output(&name) && !name.starts_with('"') => {
                    pins.push(Wired { name: None, wire: Wire::Input(Input { operand: name, mark: Mark::Plain }), start, end });
                    pins.push(Wired { name: None, wire, start, end });
                }
                Some(wire) => pins.push(Wired { name: Some(name), wire, start, end }),
                None => self.mistake(MistakeKind::Pin, next, format!("nothing is wired to `{name}`")),
            }
        }
        let mut seen: Vec<&Operand> = Vec::new();
        let mut twice = Vec::new();
        for pin in &pins {
            let Some(name) = &pin.name else { continue };
            match seen.iter().any(|before| before.eq_ignore_ascii_case(name)) {
                true => twice.push(Mistake::new(MistakeKind::Pin, pin.start, pin.end, format!("pin `{name}` is wired twice"))),
                false => seen.push(name),
            }
        }
        twice.into_iter().for_each(|mistake| self.wrong(mistake));
        pins
    }

    fn no_pin(&mut self, this: Boxes<'_, 't>, pin: &Wired, known: &[&str]) {
        let message = match &pin.name {
            Some(name) => format!("`{}` has no pin `{name}`", this.word),
            None => format!("`{}` takes no operand without the name of its pin here", this.word),
        };
        let mut mistake = Mistake::new(MistakeKind::Pin, pin.start, pin.end, message).help(format!("its pins are {}", known.join(", ")));
        if pin.is("EN") || pin.is("ENO") {
            mistake = mistake.help("EN is the line from the left and ENO the line to the right: they are not written as pins");
        }
        self.wrong(mistake);
    }

    /// An operand at a pin that takes no logic.
    fn value(&mut self, this: Boxes<'_, 't>, pin: Wired) -> Option<Operand> {
        match pin.wire {
            Wire::Input(Input { operand, mark: Mark::Plain | Mark::Direct }) => Some(operand),
            Wire::Output(operand) => Some(operand),
            Wire::Input(_) | Wire::Logic(_) => {
                let name = pin.name.as_deref().unwrap_or("this pin");
                let message = format!("{name} of `{}` takes an operand or a constant, no logic", this.word);
                self.wrong(Mistake::new(MistakeKind::Pin, pin.start, pin.end, message));
                None
            }
        }
    }

    /// A box of the table: `ADD_I MW 10, 100 => MW 12`.
    fn plain(&mut self, this: Boxes<'_, 't>, row: &'static BoxRow) -> Option<Kind> {
        let written = &this.line.content[this.rest..];
        let pins = self.inline(written, this.line.start + this.rest);
        let mut inputs: Vec<Option<Operand>> = vec![None; row.inputs.len()];
        let mut output = None;
        let mut place = 0;
        let mut known: Vec<&str> = row.inputs.to_vec();
        known.push("OUT");
        for mut pin in self.pins(this.line, pins) {
            let is_output = matches!(pin.wire, Wire::Output(_));
            if is_output && (pin.name.is_none() || pin.is("OUT")) {
                output = self.value(this, pin);
                continue;
            }
            if is_output {
                // `MW10 => MW12`: the operand before the arrow is an input unless it is the name of the output.
                let Some(operand) = pin.name.take_if(|_| place < inputs.len()) else {
                    self.no_pin(this, &pin, &known);
                    continue;
                };
                let index = place;
                place += 1;
                inputs[index] = Some(operand);
                output = self.value(this, pin);
                continue;
            }
            let index = match &pin.name {
                Some(name) => row.inputs.iter().position(|own| own.eq_ignore_ascii_case(name)),
                None => Some(place),
            };
            match index.filter(|index| *index < inputs.len()) {
                Some(index) => {
                    place += 1;
                    inputs[index] = self.value(this, pin);
                }
                None => self.no_pin(this, &pin, &known),
            }
        }
        let missing: Vec<&str> = row.inputs.iter().zip(&inputs).filter(|(_, input)| input.is_none()).map(|(name, _)| *name).collect();
        let missing: Vec<&str> = missing.into_iter().chain(output.is_none().then_some("OUT")).collect();
        if !missing.is_empty() {
            let example = format!("`{} {} => …`", row.name, row.inputs.iter().map(|_| "…").collect::<Vec<_>>().join(", "));
            let message = format!("nothing is wired to {} of `{}`", missing.join(" and "), row.name);
            self.wrong(
                Mistake::new(MistakeKind::Pin, this.line.start, this.line.end(), message)
                    .help(format!("a box has all of its pins: {example}, or one pin on each line below")),
            );
            return None;
        }
        Some(Kind::Box { row, inputs: inputs.into_iter().flatten().collect(), output: output? })
    }

    fn flip_flop(&mut self, this: Boxes<'_, 't>) -> Option<(Line, Element)> {
        let reset_first = this.word == "RS";
        let (own, other) = if reset_first { ("R", "S") } else { ("S", "R") };
        let (bit, pins) = self.head(this);
        let (mut front, mut second) = (Vec::new(), None);
        for pin in pins {
            match () {
                () if pin.is(own) => front = pin.wire.line(this.place).unwrap_or_default(),
                () if pin.is(other) => second = pin.wire.line(this.place),
                () => self.no_pin(this, &pin, &["S", "R"]),
            }
        }
        Some((front, Kind::FlipFlop { reset_first, operand: bit?, second }.at(this.place)))
    }

    fn timer(&mut self, this: Boxes<'_, 't>, kind: TimerKind) -> Option<(Line, Element)> {
        let (timer, pins) = self.head(this);
        let (mut front, mut value, mut reset, mut binary, mut bcd) = (Vec::new(), None, None, None, None);
        for pin in pins {
            match () {
                () if pin.is("S") => front = pin.wire.line(this.place).unwrap_or_default(),
                () if pin.is("TV") => value = self.value(this, pin),
                () if pin.is("R") => reset = pin.wire.line(this.place),
                () if pin.is("BI") => binary = self.value(this, pin),
                () if pin.is("BCD") => bcd = self.value(this, pin),
                () => self.no_pin(this, &pin, &["S", "TV", "R", "BI", "BCD"]),
            }
        }
        if value.is_none() {
            self.wrong(
                Mistake::new(MistakeKind::Pin, this.line.start, this.line.end(), format!("nothing is wired to TV of `{}`", this.word))
                    .help("write its time value on the next line: `TV := S5T#2S`"),
            );
        }
        let (timer, value) = (timer?, value?);
        Some((front, Kind::Timer(Box::new(Timer { kind, timer, value, reset, binary, bcd })).at(this.place)))
    }

    fn counter(&mut self, this: Boxes<'_, 't>, kind: CounterKind) -> Option<(Line, Element)> {
        let (counter, pins) = self.head(this);
        let (mut front, mut down, mut set, mut preset, mut reset, mut value, mut bcd) = (Vec::new(), None, None, None, None, None, None);
        let mut known = vec!["CU", "CD", "S", "PV", "R", "CV", "CV_BCD"];
        known.retain(|name| kind == CounterKind::UpDown || !["CU", "CD"].contains(name) || *name == kind.power_pin());
        for pin in pins {
            match () {
                () if pin.is(kind.power_pin()) => front = pin.wire.line(this.place).unwrap_or_default(),
                () if pin.is("CD") && kind == CounterKind::UpDown => down = pin.wire.line(this.place),
                () if pin.is("S") => set = pin.wire.line(this.place),
                () if pin.is("PV") => preset = self.value(this, pin),
                () if pin.is("R") => reset = pin.wire.line(this.place),
                () if pin.is("CV") => value = self.value(this, pin),
                () if pin.is("CV_BCD") => bcd = self.value(this, pin),
                () => self.no_pin(this, &pin, &known),
            }
        }
        if set.is_some() != preset.is_some() {
            let missing = if set.is_some() { "PV" } else { "S" };
            let message = format!("nothing is wired to {missing} of `{}`: S and PV belong together", this.word);
            self.mistake(MistakeKind::Pin, this.line, message);
        }
        let counter = Counter { kind, counter: counter?, down, set: set.zip(preset), reset, value, bcd };
        Some((front, Kind::Counter(Box::new(counter)).at(this.place)))
    }

    /// `CALL FB 3, DB 6` with its pins.
    fn call(&mut self, this: Boxes<'_, 't>) -> Option<Kind> {
        let written = &this.line.content[this.rest..];
        let start = this.line.start + this.rest;
        let open = outer_bracket(written);
        let mut names = split(&written[..open], ",").into_iter();
        let block = names.next().map(|(from, text)| operand(text, start + from)).filter(|block| !block.text.is_empty());
        let instance = names.next().map(|(from, text)| operand(text, start + from)).filter(|instance| !instance.text.is_empty());
        let inline = self.inline(&written[open..], start + open);
        let mut pins = Vec::new();
        for pin in self.pins(this.line, inline) {
            let Some(name) = pin.name else {
                let message = "a pin of a called block is written with its name";
                self.wrong(Mistake::new(MistakeKind::Pin, pin.start, pin.end, message).help("write `NAME := …` or `NAME => …`"));
                continue;
            };
            // The quotes belong to how it is written, not to the name.
            let plain = name.text.trim_matches('"').to_owned();
            let name = Operand { text: plain, ..name };
            let actual = match pin.wire {
                Wire::Output(operand) => Actual::Output(operand),
                Wire::Logic(line) => Actual::Logic(line),
                Wire::Input(Input { operand, mark }) => actual(operand, mark, Place::new(pin.start, pin.end)),
            };
            pins.push(Pin { name, actual });
        }
        if block.is_none() {
            self.mistake(MistakeKind::Operand, this.line, "`CALL` needs a block: `CALL FC 1`, `CALL FB 3, DB 6`");
        }
        Some(Kind::Call { block: block?, instance, pins })
    }

    /// A function or function block of IEC 61131-3: `TON[t1]`, `ADD a, b => c`.
    fn named(&mut self, this: Boxes<'_, 't>) -> Option<Kind> {
        let written = &this.line.content[this.rest..];
        let start = this.line.start + this.rest;
        if !this.word.split('.').all(is_name) {
            self.pins(this.line, Vec::new());
            let message = format!("`{}` is no element of a diagram", this.line.content);
            self.wrong(
                Mistake::new(MistakeKind::Word, this.line.start, this.line.end(), message)
                    .help("an element begins with a word such as NO, NC, COIL, OR, BRANCH or the name of a function or function block"),
            );
            return None;
        }
        let (inside, more, more_at) = bracketed(written);
        let instance = inside.map(|(at, inside)| operand(inside, start + at));
        // `TON t1` and `TON t1 PT := T#2s`: a name alone before the pins.
        let (instance, more, more_at) = match instance {
            Some(instance) => (Some(instance), more, more_at),
            None => {
                let end = first_pin(written);
                let own = written[..end].trim();
                match (is_path(own) && !written[end..].trim_start().starts_with("=>"), instance_before(written)) {
                    (true, _) => (Some(operand(own, start)), &written[end..], end),
                    (false, Some(length)) => (Some(operand(&written[..length], start)), &written[length..], length),
                    (false, None) => (None, written, 0),
                }
            }
        };
        let inline = self.inline(more, start + more_at);
        let mut named = NamedBox {
            name: Operand::at(this.word, this.line.start),
            instance,
            inputs: Vec::new(),
            outputs: Vec::new(),
            power: None,
            flow: None,
        };
        for mut pin in self.pins(this.line, inline) {
            let place = Place::new(pin.start, pin.end);
            match pin.wire {
                Wire::Input(Input { ref operand, .. }) if operand.text == "." => named.power = pin.name,
                Wire::Output(ref operand) if operand.text == "." => named.flow = pin.name,
                Wire::Output(operand) => named.outputs.push((pin.name, operand)),
                Wire::Input(Input { operand, mark }) => {
                    let line = vec![Kind::contact(operand, false).at(place)];
                    named.inputs.push(NamedInput { name: pin.name.take(), negated: mark == Mark::Negated, line });
                }
                Wire::Logic(line) => named.inputs.push(NamedInput { name: pin.name.take(), negated: false, line }),
            }
        }
        Some(Kind::Named(Box::new(named)))
    }
}

/// What is wired to a pin of a called block.
fn actual(operand: Operand, mark: Mark, place: Place) -> Actual {
    match mark {
        Mark::Direct => Actual::Direct(operand),
        Mark::Negated => Actual::Logic(vec![Kind::contact(operand, true).at(place)]),
        Mark::Plain => {
            let contact = vec![Kind::contact(operand.clone(), false).at(place)];
            Actual::of_operand(operand, contact)
        }
    }
}

/// The pins of an argument: `MW 10 => MW 12` are two.
fn wired(one: Argument) -> Vec<Wired> {
    let Argument { name, input, output, start, end } = one;
    let mut pins = Vec::new();
    match (input, output) {
        (Some(input), Some(output)) => {
            pins.push(Wired { name, wire: Wire::Input(input), start, end });
            pins.push(Wired { name: None, wire: Wire::Output(output), start, end });
        }
        (Some(input), None) => pins.push(Wired { name, wire: Wire::Input(input), start, end }),
        (None, Some(output)) => pins.push(Wired { name, wire: Wire::Output(output), start, end }),
        (None, None) => {}
    }
    pins
}

/// The name of a pin that begins a line, its sign, and where what follows the sign begins.
pub(super) fn pin_of(content: &str) -> Option<(&str, &str, usize)> {
    let end = match content.strip_prefix('"') {
        Some(rest) => rest.find('"')? + 2,
        None => content.find(|sign: char| !(sign.is_alphanumeric() || sign == '_')).unwrap_or(content.len()),
    };
    let name = &content[..end];
    if !is_name(name) {
        return None;
    }
    let after = content[end..].trim_start();
    let at = content.len() - after.len();
    let sign = [":=", "=>", ":"].into_iter().find(|sign| after.starts_with(sign))?;
    let rest = at + sign.len();
    // A colon alone begins the logic of the pin, on lines of its own.
    if sign == ":" && !content[rest..].trim().is_empty() {
        return None;
    }
    Some((name, sign, rest))
}

/// `[T 5](…)`: what stands in the square brackets with its place, and what follows them.
fn bracketed(written: &str) -> (Option<(usize, &str)>, &str, usize) {
    let open = written.len() - written.trim_start().len();
    let close = written.trim_start().strip_prefix('[').and_then(|inside| inside.find(']'));
    match close {
        Some(close) => {
            let (from, to) = (open + 1, open + 1 + close);
            (Some((from, &written[from..to])), &written[to + 1..], to + 1)
        }
        None => (None, written, 0),
    }
}

/// Where the first pin of a line begins: a name before `:=` or `=>`, or an opening bracket.
fn first_pin(written: &str) -> usize {
    let sign = [":=", "=>"].into_iter().filter_map(|sign| split(written, sign).get(1).map(|(from, _)| from - sign.len())).min();
    let bracket = outer_bracket(written);
    match sign {
        Some(at) if at < bracket => {
            let name = written[..at].trim_end();
            match name.strip_suffix('"') {
                Some(inner) => inner.rfind('"').unwrap_or(0),
                None => {
                    let begin = name.trim_end_matches(|sign: char| sign.is_alphanumeric() || sign == '_').len();
                    // `T#5s`, `a.b`: the last word of an operand names no pin.
                    let alone = name[..begin].ends_with([' ', '\t', ',']) || begin == 0;
                    if alone { begin } else { at }
                }
            }
        }
        _ => bracket.min(written.len()),
    }
}

/// The first opening bracket outside of quotes; the end if there is none.
fn outer_bracket(written: &str) -> usize {
    let mut quote = None;
    for (at, sign) in written.char_indices() {
        match (quote, sign) {
            (Some(open), sign) if open == sign => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(sign),
            (None, '(') => return at,
            _ => {}
        }
    }
    written.len()
}

/// `own a, 1`: how long the instance is that stands before the first input.
fn instance_before(written: &str) -> Option<usize> {
    let length = written.find(char::is_whitespace).filter(|&length| is_path(&written[..length]))?;
    let next = written[length..].trim_start();
    let word = next.find(|sign: char| !(sign.is_alphanumeric() || sign == '_')).map_or(next, |end| &next[..end]);
    let is_operator = ["AND", "OR", "XOR", "MOD", "AND_THEN", "OR_ELSE"].iter().any(|one| one.eq_ignore_ascii_case(word));
    (next.starts_with(|sign: char| sign.is_alphabetic() || matches!(sign, '_' | '"' | '#' | '%')) && !is_operator).then_some(length)
}

/// A name, or names and indexes with dots between.
fn is_path(text: &str) -> bool {
    text.starts_with(|sign: char| sign.is_alphabetic() || matches!(sign, '_' | '#' | '"'))
        && text.chars().all(|sign| sign.is_alphanumeric() || matches!(sign, '_' | '.' | '[' | ']' | '#' | '"'))
}
