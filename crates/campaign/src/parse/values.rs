//! Values that names are given: one of any type, or a list of one kind.

use toml::de::DeValue;

use super::{Reader, VALUES_MAX};
use crate::document::{Value, number};
use crate::spec;

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

impl Reader<'_> {
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
