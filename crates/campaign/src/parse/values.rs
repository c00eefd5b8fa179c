//! Values of the file: strings, numbers, durations.

use sieben_model::source::Span;
use sieben_sim::duration;
use toml::de::DeValue;

use super::{Key, Reader, VALUES_MAX, Value};
use crate::spec::{self, Placed};

/// So many values from one to another, both of them too.
pub(super) fn steps(from: f64, to: f64, steps: u64, log: bool) -> Vec<spec::Value> {
    let last = (steps - 1).max(1) as f64;
    let at = |step: u64| {
        let part = step as f64 / last;
        match log {
            _ if step == 0 => from,
            _ if step == steps - 1 => to,
            true => libm::exp(libm::log(from) + (libm::log(to) - libm::log(from)) * part),
            false => from + (to - from) * part,
        }
    };
    (0..steps).map(|step| spec::Value::Number(at(step))).collect()
}

/// A number as the file has it; one that is not finite is none.
pub(super) fn number(value: &Value<'_>) -> Option<f64> {
    match value.get_ref() {
        DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix()).ok().map(|number| number as f64),
        DeValue::Float(float) => float.as_str().parse().ok().filter(|number: &f64| number.is_finite()),
        _ => None,
    }
}

impl Reader<'_> {
    /// The name of a key.
    pub(super) fn placed(&self, key: &Key<'_>) -> Placed {
        let span = key.span();
        self.inside(key.get_ref(), span)
    }

    /// A string with the place of what stands between its quotes, if that is the same there.
    fn inside(&self, text: &str, span: std::ops::Range<usize>) -> Placed {
        let written = self.text.get(span.clone()).unwrap_or_default();
        let at = written.find(text).filter(|_| !text.is_empty());
        let start = at.map_or(span.start, |at| span.start + at);
        let end = at.map_or(span.end, |at| span.start + at + text.len());
        Placed { text: text.to_owned(), span: Span::new(self.file, start as u32, end as u32) }
    }

    pub(super) fn string(&mut self, value: &Value<'_>, name: &str) -> Option<Placed> {
        match value.get_ref() {
            DeValue::String(text) if !text.trim().is_empty() => Some(self.inside(text, value.span())),
            DeValue::String(_) => {
                self.wrong(value, format!("`{name}` is empty"));
                None
            }
            _ => {
                self.wrong(value, format!("`{name}` is a string: `{name} = \"…\"`"));
                None
            }
        }
    }

    /// One string, or a list of them.
    pub(super) fn strings(&mut self, value: &Value<'_>, name: &str) -> Vec<Placed> {
        match value.get_ref() {
            DeValue::Array(items) => items.iter().filter_map(|item| self.string(item, name)).collect(),
            DeValue::String(_) => self.string(value, name).into_iter().collect(),
            _ => {
                self.wrong(value, format!("`{name}` is a list of strings: `{name} = [\"…\", \"…\"]`"));
                Vec::new()
            }
        }
    }

    /// A whole number from `least`.
    pub(super) fn whole(&mut self, value: &Value<'_>, name: &str, least: u64) -> Option<u64> {
        let number = match value.get_ref() {
            DeValue::Integer(integer) => u64::from_str_radix(integer.as_str(), integer.radix()).ok().filter(|&number| number >= least),
            _ => None,
        };
        if number.is_none() {
            self.wrong(value, format!("`{name}` is a whole number from {least} on: `{name} = {}`", least.max(7)));
        }
        number
    }

    pub(super) fn number(&mut self, value: &Value<'_>, name: &str) -> Option<f64> {
        let number = number(value);
        if number.is_none() {
            self.wrong(value, format!("`{name}` is a number: `{name} = 1.5`"));
        }
        number
    }

    /// A number from 0 to 1.
    pub(super) fn chance(&mut self, value: &Value<'_>, name: &str) -> Option<f64> {
        let number = number(value).filter(|number| (0.0..=1.0).contains(number));
        if number.is_none() {
            self.wrong(value, format!("`{name}` is a number from 0 to 1: `{name} = 0.25`"));
        }
        number
    }

    /// A duration in microseconds.
    pub(super) fn duration(&mut self, value: &Value<'_>, name: &str) -> Option<u64> {
        let DeValue::String(text) = value.get_ref() else {
            self.wrong(value, format!("`{name}` is a duration: `{name} = \"30s\"`"));
            return None;
        };
        match duration::parse(text) {
            // Not longer than ten years.
            Ok(time) => Some(time.as_micros() as u64),
            Err(message) => {
                self.wrong(value, message);
                None
            }
        }
    }

    /// A value of any type.
    pub(super) fn constant(&mut self, value: &Value<'_>) -> Option<spec::Value> {
        match value.get_ref() {
            DeValue::Boolean(value) => Some(spec::Value::Boolean(*value)),
            DeValue::String(text) => Some(spec::Value::Text(text.to_string())),
            _ => {
                let number = number(value);
                if number.is_none() {
                    self.wrong(value, "a value is a number, `true` or `false`, or a constant in quotes: `\"T#5s\"`");
                }
                number.map(spec::Value::Number)
            }
        }
    }

    /// A list of values of one kind; at least one.
    pub(super) fn constants(&mut self, value: &Value<'_>, name: &str) -> Option<Vec<spec::Value>> {
        let items = match value.get_ref() {
            DeValue::Array(items) if (1..=VALUES_MAX).contains(&items.len()) => items,
            _ => {
                self.wrong(value, format!("`{name}` is a list of 1 to {VALUES_MAX} values: `{name} = [20, 40, 80]`"));
                return None;
            }
        };
        let all: Vec<spec::Value> = items.iter().map_while(|item| self.constant(item)).collect();
        let kind = |value: &spec::Value| std::mem::discriminant(value);
        if all.len() < items.len() {
            return None;
        }
        if all.windows(2).any(|pair| kind(&pair[0]) != kind(&pair[1])) {
            self.wrong(value, format!("the values of `{name}` are all numbers, all strings, or all `true` and `false`"));
            return None;
        }
        Some(all)
    }
}
