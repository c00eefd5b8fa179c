//! What has to hold, and what is measured.

use sieben_model::nearest::one_of;
use toml::de::{DeTable, DeValue};

use super::Reader;
use crate::document::{Value, in_order};
use crate::spec::{Measure, Of, Placed, Property, PropertyKind};

/// Properties and measures of a campaign.
const EXPRESSIONS_MAX: usize = 1_000;

impl Reader<'_> {
    /// One `[[never]]` and the like.
    pub(super) fn property(&mut self, kind: &str, item: &Value<'_>, content: &DeTable<'_>) {
        let Some(kind) = PropertyKind::from_word(kind) else { return };
        let (mut name, mut expression, mut then, mut within) = (None, None, None, 0);
        let before = self.diagnostics.len();
        for (key, value) in in_order(content) {
            match key.get_ref().as_ref() {
                "name" => name = self.string(value, "name"),
                word @ ("expr" | "when") => expression = self.string(value, word),
                "then" => then = self.string(value, "then"),
                "within" => within = self.duration(value, "within").unwrap_or(0),
                _ => {}
            }
        }
        let complete = expression.is_some() && (kind != PropertyKind::Response || then.is_some());
        let Some(expression) = expression.filter(|_| complete) else {
            if self.diagnostics.len() == before {
                self.wrong(
                    item,
                    match kind {
                        PropertyKind::Response => {
                            "a response has `when`, `then` and `within`: `when = \"Start\"`, `then = \"Running\"`, `within = \"2s\"`"
                                .to_owned()
                        }
                        kind => format!("`[[{}]]` needs an expression: `expr = \"Star AND Delta\"`", kind.word()),
                    },
                );
            }
            return;
        };
        let Some(name) = self.own_name(name, &expression, item) else { return };
        self.spec.properties.push(Property { kind, name: name.text, span: name.span, expression, then, within_us: within });
    }

    /// One `[[measure]]`.
    pub(super) fn measure(&mut self, item: &Value<'_>, content: &DeTable<'_>) {
        let (mut name, mut of, mut expression, mut unit) = (None, None, None, None);
        let before = self.diagnostics.len();
        for (key, value) in in_order(content) {
            match key.get_ref().as_ref() {
                "name" => name = self.string(value, "name"),
                "expr" => expression = self.string(value, "expr"),
                "unit" => unit = self.string(value, "unit").map(|placed| placed.text),
                "of" => {
                    of = match value.get_ref() {
                        DeValue::String(word) => Of::from_word(word),
                        _ => None,
                    };
                    if of.is_none() {
                        self.wrong(value, format!("`of` is {}", one_of(Of::ALL.iter().map(|(_, word)| *word))));
                    }
                }
                _ => {}
            }
        }
        let (Some(expression), Some(of)) = (expression, of) else {
            if self.diagnostics.len() == before {
                self.wrong(item, "a measure has `of` and `expr`: `of = \"max\"` and `expr = \"Level\"`");
            }
            return;
        };
        let Some(name) = self.own_name(name, &expression, item) else { return };
        self.spec.measures.push(Measure { name: name.text, span: name.span, of, expression, unit });
    }

    /// The name, else the expression; no two of the file are called alike.
    fn own_name(&mut self, name: Option<Placed>, expression: &Placed, item: &Value<'_>) -> Option<Placed> {
        if self.spec.properties.len() + self.spec.measures.len() >= EXPRESSIONS_MAX {
            if !std::mem::replace(&mut self.is_full, true) {
                self.wrong(
                    item,
                    format!("a campaign has at most {EXPRESSIONS_MAX} properties and measures: each is computed after every scan"),
                );
            }
            return None;
        }
        let name =
            name.unwrap_or_else(|| Placed { text: expression.text.split_whitespace().collect::<Vec<_>>().join(" "), ..expression.clone() });
        let properties = self.spec.properties.iter().map(|property| &property.name);
        if properties.chain(self.spec.measures.iter().map(|measure| &measure.name)).any(|known| *known == name.text) {
            self.wrong(item, format!("`{}` is there already: give this one another `name`", name.text));
            return None;
        }
        Some(name)
    }
}
