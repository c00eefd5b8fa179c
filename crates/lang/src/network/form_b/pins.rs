//! The pins of a box in form B, as they are written.

use super::parse::{Parsed, Parser};
use crate::network::flavour::Flavour;
use crate::network::model::{Kind, Line};
use crate::network::operand::{Operand, may_name_output};

/// A pin: `name := logic`, `name := operand`, `name => operand`, or without a name.
#[derive(Default)]
pub(super) struct RawPin {
    pub(super) name: Option<Operand>,
    /// The name as it is written, which may be an operand before an arrow: `"Level" => MW 2`.
    pub(super) written: Operand,
    /// A circle at the pin.
    pub(super) negated: bool,
    pub(super) input: Option<RawInput>,
    pub(super) output: Option<Operand>,
    /// Its first byte in the line.
    pub(super) from: usize,
}

/// What goes into a pin.
pub(super) enum RawInput {
    /// An operand or a constant.
    Operand(Operand, Line),
    /// `= operand`: handed on as it is.
    Direct(Operand),
    /// Logic.
    Logic(Line),
}

impl RawInput {
    /// As logic: an operand is a contact.
    pub(super) fn line(self) -> Option<Line> {
        match self {
            Self::Operand(_, line) | Self::Logic(line) => Some(line),
            Self::Direct(_) => None,
        }
    }

    /// As an operand.
    pub(super) fn operand(self) -> Option<Operand> {
        match self {
            Self::Operand(operand, _) | Self::Direct(operand) => Some(operand),
            Self::Logic(_) => None,
        }
    }
}

impl Parser<'_> {
    /// The pins up to the closing bracket; the opening one is read.
    pub(super) fn pins(&mut self) -> Parsed<Vec<RawPin>> {
        self.scan.enter()?;
        let pins = self.pins_inside();
        self.scan.leave();
        pins
    }

    fn pins_inside(&mut self) -> Parsed<Vec<RawPin>> {
        let mut pins = Vec::new();
        if self.scan.eat(")") {
            return Ok(pins);
        }
        loop {
            pins.push(self.pin()?);
            if self.scan.eat(")") {
                return Ok(pins);
            }
            self.scan.want(",", "`,` or `)` is expected after a pin")?;
        }
    }

    fn pin(&mut self) -> Parsed<RawPin> {
        self.scan.space();
        let from = self.scan.at;
        let mut pin = RawPin { from, ..RawPin::default() };
        let circle = self.scan.flavour == Flavour::Iec && self.scan.eat("/");
        (pin.name, pin.written) = self.pin_name();
        // An output has no circle: `/b => x` is an input.
        if pin.name.is_some() && circle && self.scan.see("=>") {
            pin.name = None;
        }
        match pin.name {
            Some(_) => pin.negated = circle,
            None => self.scan.at = from,
        }
        let assigned = pin.name.is_some() && self.scan.eat(":=");
        if assigned || (pin.name.is_none() && !self.scan.see("=>")) {
            pin.input = Some(self.input()?);
        }
        if self.scan.eat("=>") {
            let goes_on = self.scan.flavour == Flavour::Iec && self.scan.eat(".");
            pin.output = Some(if goes_on { Operand::from(".") } else { self.scan.operand()? });
        }
        Ok(pin)
    }

    /// A word or a name in quotes, if `:=` or `=>` follows.
    fn pin_name(&mut self) -> (Option<Operand>, Operand) {
        self.scan.space();
        let from = self.scan.at;
        let rest = self.scan.rest();
        let (text, length) = match rest.strip_prefix('"').and_then(|rest| rest.split_once('"')) {
            Some((name, _)) => (name, name.len() + 2),
            None => {
                let word = self.scan.word();
                (word, word.len())
            }
        };
        let start = self.scan.since(from).first;
        self.scan.at = from + length;
        // `MOVE(TRUE => x)`, `ABS(a.b => x)`: what stands before the arrow is an input.
        let is_input = self.scan.flavour == Flavour::Iec && length == text.len() && !may_name_output(text);
        let named = !text.is_empty() && (self.scan.see(":=") || self.scan.see("=>") && !is_input);
        let at_start = |text: &str| Operand { text: text.to_owned(), start: Some(start) };
        (named.then(|| at_start(text)), at_start(rest.get(..length).unwrap_or_default()))
    }

    fn input(&mut self) -> Parsed<RawInput> {
        if self.scan.eat("=") {
            return Ok(RawInput::Direct(self.scan.operand()?));
        }
        self.scan.space();
        let from = self.scan.at;
        if let Ok(operand) = self.scan.operand() {
            let contact = Kind::contact(operand.clone(), false).at(self.scan.since(from));
            if [",", ")", "=>"].iter().any(|sign| self.scan.see(sign)) {
                return Ok(RawInput::Operand(operand, vec![contact]));
            }
        }
        self.scan.at = from;
        Ok(RawInput::Logic(self.branch()?))
    }
}
