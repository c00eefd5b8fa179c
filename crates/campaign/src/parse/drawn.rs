//! What is drawn: `[draw]`, `[[fault]]`, `[disturb]`.

use sieben_sim::duration;
use sieben_sim::wrap::Fault;
use toml::de::{DeTable, DeValue};

use super::Reader;
use crate::document::{Key, Value, in_order, number};
use crate::spec::{Draw, Drawn, FaultRow, Law, Walk};

/// What the numbers of a law are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unit {
    /// Numbers.
    Plain,
    /// Durations in quotes, in microseconds.
    Time,
    /// The same, which may have a sign.
    SignedTime,
}

const LAWS: [&str; 3] = ["uniform", "normal", "log_uniform"];

impl Reader<'_> {
    /// `{ normal = [180.0, 8.0], unit = "K" }` and the like.
    pub(super) fn draw(&mut self, key: &Key<'_>, value: &Value<'_>) {
        const HOW: &str = "write how it is drawn: `{ uniform = [0.0, 0.5] }`, `{ normal = [180.0, 8.0] }`, `{ log_uniform = [1, 100] }`, \
                           `{ choice = [1, 2, 5] }` or `{ walk = { every = \"2s\", chance = 0.1 } }`";
        let DeValue::Table(inner) = value.get_ref() else { return self.wrong(value, HOW) };
        let (mut drawn, mut unit, mut laws) = (None, None, 0);
        for (part, value) in in_order(inner) {
            match part.get_ref().as_ref() {
                "unit" => unit = self.string(value, "unit").map(|placed| placed.text),
                "choice" => {
                    laws += 1;
                    drawn = self.constants(value, "choice").map(Drawn::Choice);
                }
                "walk" => {
                    laws += 1;
                    drawn = self.walk(value).map(Drawn::Walk);
                }
                law if LAWS.contains(&law) => {
                    laws += 1;
                    drawn = self.law(law, value, Unit::Plain).map(Drawn::Once);
                }
                _ => self.unknown("draw", part, &["uniform", "normal", "log_uniform", "choice", "walk", "unit"]),
            }
        }
        match drawn {
            _ if laws != 1 => self.wrong(value, HOW),
            Some(drawn) => {
                let name = self.placed(key);
                self.spec.draw.push(Draw { name, drawn, unit });
            }
            // What is wrong was told.
            None => {}
        }
    }

    fn walk(&mut self, value: &Value<'_>) -> Option<Walk> {
        let DeValue::Table(inner) = value.get_ref() else {
            self.wrong(value, "write when it may change, and how likely it does: `walk = { every = \"2s\", chance = 0.1 }`");
            return None;
        };
        let (mut every, mut chance, mut step, mut least, mut most) = (None, None, None, f64::MIN, f64::MAX);
        for (part, value) in in_order(inner) {
            match part.get_ref().as_ref() {
                "every" => every = self.duration(value, "every"),
                "chance" => chance = self.chance(value, "chance"),
                "step" => step = self.number(value, "step"),
                "from" => least = self.number(value, "from").unwrap_or(least),
                "to" => most = self.number(value, "to").unwrap_or(most),
                _ => self.unknown("draw", part, &["every", "chance", "step", "from", "to"]),
            }
        }
        let (Some(every_us @ 1..), Some(chance)) = (every, chance) else {
            self.wrong(value, "a walk has `every`, a duration of more than 0, and `chance`: `walk = { every = \"2s\", chance = 0.1 }`");
            return None;
        };
        if least > most {
            self.wrong(value, "`from` of a walk is not greater than `to`");
            return None;
        }
        Some(Walk { every_us, chance, step, least, most })
    }

    /// Two numbers or times of a law.
    fn law(&mut self, law: &str, value: &Value<'_>, unit: Unit) -> Option<Law> {
        let pair = match value.get_ref() {
            DeValue::Array(items) if items.len() == 2 => Some((self.amount(&items[0], unit)?, self.amount(&items[1], unit)?)),
            _ => None,
        };
        let Some((a, b)) = pair else {
            let example = if unit == Unit::Plain { "[0.0, 0.5]" } else { "[\"5s\", \"60s\"]" };
            self.wrong(value, format!("`{law}` has two values: `{law} = {example}`"));
            return None;
        };
        let (made, message) = match law {
            "uniform" => (Law::Uniform(a, b), (a > b).then_some("the first of `uniform` is not greater than the second")),
            "normal" => (Law::Normal(a, b), (b < 0.0).then_some("the second of `normal` is the standard deviation, which is not below 0")),
            _ => (
                Law::LogUniform(a, b),
                (a <= 0.0 || a > b).then_some("both of `log_uniform` are greater than 0, and the first is not greater than the second"),
            ),
        };
        match message {
            Some(message) => {
                self.wrong(value, message);
                None
            }
            None => Some(made),
        }
    }

    /// A number, or a time in microseconds.
    fn amount(&mut self, value: &Value<'_>, unit: Unit) -> Option<f64> {
        if unit == Unit::Plain {
            return self.number(value, "a value");
        }
        let DeValue::String(text) = value.get_ref() else {
            self.wrong(value, "a time is a duration in quotes: `\"15ms\"`");
            return None;
        };
        let (sign, plain) = match text.strip_prefix('-') {
            Some(plain) if unit == Unit::SignedTime => (-1.0, plain),
            _ => (1.0, text.as_ref()),
        };
        match duration::parse(plain) {
            Ok(time) => Some(sign * time.as_micros() as f64),
            Err(message) => {
                self.wrong(value, message);
                None
            }
        }
    }

    /// A time that is fixed or drawn.
    fn time(&mut self, value: &Value<'_>, name: &str, unit: Unit) -> Option<Law> {
        match value.get_ref() {
            DeValue::String(_) => self.amount(value, unit).map(Law::Fixed),
            DeValue::Table(inner) => match in_order(inner)[..] {
                [(law, value)] if LAWS.contains(&law.get_ref().as_ref()) => self.law(law.get_ref(), value, unit),
                _ => {
                    self.wrong(value, format!("write a duration or how it is drawn: `{name} = {{ uniform = [\"5s\", \"60s\"] }}`"));
                    None
                }
            },
            _ => {
                self.wrong(
                    value,
                    format!("write a duration or how it is drawn: `{name} = \"30s\"` or `{name} = {{ uniform = [\"5s\", \"60s\"] }}`"),
                );
                None
            }
        }
    }

    /// One `[[fault]]`.
    pub(super) fn fault(&mut self, item: &Value<'_>, content: &DeTable<'_>) {
        let (mut name, mut chance, mut signal, mut from, mut lasts) = (None, Some(1.0), None, Some(Law::Fixed(0.0)), Some(None));
        let mut kinds = Vec::new();
        let before = self.diagnostics.len();
        for (key, value) in in_order(content) {
            match key.get_ref().as_ref() {
                "name" => name = self.string(value, "name"),
                "chance" => chance = self.chance(value, "chance"),
                "signal" => signal = self.string(value, "signal"),
                "from" => from = self.time(value, "from", Unit::Time),
                "for" => lasts = self.time(value, "for", Unit::Time).map(Some),
                "fault" => {
                    for placed in self.strings(value, "fault") {
                        match Fault::parse_for("x", &format!("x {}", placed.text)) {
                            Ok(fault) if fault.from_us.is_none() => kinds.push(fault.kind),
                            Ok(_) => self.document.wrong_at(placed.span, "when it begins and how long it lasts stands in `from` and `for`"),
                            Err(message) => self.document.wrong_at(placed.span, message),
                        }
                    }
                }
                _ => {}
            }
        }
        let (Some(chance), Some(signal), Some(from), Some(lasts), false) = (chance, signal, from, lasts, kinds.is_empty()) else {
            if self.diagnostics.len() == before {
                self.wrong(
                    item,
                    "a fault needs its signal and how it fails: `signal = \"oven.temperature\"` and `fault = [\"stuck\", \"drift=0.2\"]`",
                );
            }
            return;
        };
        let others = self.spec.faults.iter().filter(|row| row.signal.text == signal.text).count();
        let stream = match name {
            Some(name) => name.text,
            None if others == 0 => signal.text.clone(),
            None => format!("{} {}", signal.text, others + 1),
        };
        if self.spec.faults.iter().any(|row| row.stream == stream) {
            return self.wrong(item, format!("two faults are called `{stream}`: give this one another `name`"));
        }
        self.spec.faults.push(FaultRow { stream, chance, signal, kinds, from, lasts });
    }

    /// One key of `[disturb]`.
    pub(super) fn disturb(&mut self, name: &str, value: &Value<'_>) {
        let mut disturb = self.spec.disturb.take().unwrap_or_default();
        match name {
            "time" => disturb.time = self.time(value, name, Unit::SignedTime),
            "bounce" => disturb.bounce = self.bounce(value),
            _ => {
                disturb.value = match value.get_ref() {
                    DeValue::Table(inner) => match in_order(inner)[..] {
                        [(law, value)] if LAWS.contains(&law.get_ref().as_ref()) => self.law(law.get_ref(), value, Unit::Plain),
                        _ => self.no_value(value),
                    },
                    _ => number(value).map(Law::Fixed).or_else(|| self.no_value(value)),
                }
            }
        }
        self.spec.disturb = Some(disturb);
    }

    fn no_value(&mut self, value: &Value<'_>) -> Option<Law> {
        self.wrong(value, "write what is added to words: `value = { normal = [0.0, 3.0] }`");
        None
    }

    fn bounce(&mut self, value: &Value<'_>) -> Option<(f64, u64)> {
        const HOW: &str = "write how likely a bit bounces, and how long: `bounce = { chance = 0.2, for = \"30ms\" }`";
        let DeValue::Table(inner) = value.get_ref() else {
            self.wrong(value, HOW);
            return None;
        };
        let (mut chance, mut lasts) = (None, None);
        for (part, value) in in_order(inner) {
            match part.get_ref().as_ref() {
                "chance" => chance = self.chance(value, "chance"),
                "for" => lasts = self.duration(value, "for"),
                _ => self.unknown("disturb", part, &["chance", "for"]),
            }
        }
        if chance.is_none() || lasts.is_none() {
            self.wrong(value, HOW);
        }
        chance.zip(lasts)
    }
}
