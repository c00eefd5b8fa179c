//! What a subscription holds, and what of it is sent: all of it at first, then what became another.

use std::collections::BTreeMap;

use serde_json::{Map, Value as Json, json};

/// What a subscription holds at one scan.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// Rows of a table from a number on: an array at first, then an object by their numbers.
    Rows(u32, Vec<Json>),
    /// Values by a key.
    Keyed(BTreeMap<String, Json>),
    /// Something that is sent whole.
    Whole(Json),
    /// The newest entries of a log, oldest first, each with its number.
    Log(Vec<(u64, Json)>),
}

impl Content {
    /// All of it.
    pub fn all(&self) -> Json {
        match self {
            Self::Rows(_, rows) => Json::Array(rows.clone()),
            Self::Keyed(values) => values.iter().map(|(key, value)| (key.clone(), value.clone())).collect::<Map<_, _>>().into(),
            Self::Whole(json) => json.clone(),
            Self::Log(entries) => newest_first(entries.iter()),
        }
    }

    /// What is another than it was; `None` if nothing is.
    pub fn since(&self, before: &Self) -> Option<Json> {
        match (self, before) {
            (Self::Rows(from, rows), Self::Rows(known_from, known)) if from == known_from && rows.len() == known.len() => {
                let numbered = (u64::from(*from)..).zip(rows.iter().zip(known));
                let changed: Map<String, Json> =
                    numbered.filter(|(_, (row, known))| row != known).map(|(number, (row, _))| (number.to_string(), row.clone())).collect();
                (!changed.is_empty()).then_some(Json::Object(changed))
            }
            (Self::Keyed(values), Self::Keyed(known)) if values.len() == known.len() && values.keys().eq(known.keys()) => {
                let changed: Map<String, Json> = values
                    .iter()
                    .filter(|&(key, value)| known.get(key) != Some(value))
                    .map(|(key, value)| (key.clone(), value.clone()))
                    .collect();
                (!changed.is_empty()).then_some(Json::Object(changed))
            }
            (Self::Log(entries), Self::Log(known)) => {
                let last = known.last().map_or(0, |(number, _)| *number);
                let new: Vec<_> = entries.iter().filter(|(number, _)| *number > last).collect();
                (!new.is_empty()).then(|| json!({ "add": newest_first(new.into_iter()) }))
            }
            (now, before) => (now != before).then(|| now.all()),
        }
    }
}

fn newest_first<'e>(entries: impl DoubleEndedIterator<Item = &'e (u64, Json)>) -> Json {
    entries.rev().map(|(_, entry)| entry.clone()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keyed(values: &[(&str, i64)]) -> Content {
        Content::Keyed(values.iter().map(|&(key, value)| (key.to_owned(), json!(value))).collect())
    }

    #[test]
    fn only_what_changed_is_sent() {
        let rows = |values: [i64; 3]| Content::Rows(10, values.map(|value| json!([value])).to_vec());
        for (now, before, wanted) in [
            (rows([1, 2, 3]), rows([1, 2, 3]), None),
            (rows([1, 5, 3]), rows([1, 2, 3]), Some(json!({ "11": [5] }))),
            (Content::Rows(9, vec![json!([1])]), rows([1, 2, 3]), Some(json!([[1]]))),
            (keyed(&[("a", 1), ("b", 2)]), keyed(&[("a", 1), ("b", 2)]), None),
            (keyed(&[("a", 1), ("b", 3)]), keyed(&[("a", 1), ("b", 2)]), Some(json!({ "b": 3 }))),
            (Content::Whole(json!([1])), Content::Whole(json!([1])), None),
            (Content::Whole(json!([2])), Content::Whole(json!([1])), Some(json!([2]))),
            (
                Content::Log(vec![(3, json!("c")), (4, json!("d")), (5, json!("e"))]),
                Content::Log(vec![(2, json!("b")), (3, json!("c"))]),
                Some(json!({ "add": ["e", "d"] })),
            ),
            (Content::Log(vec![(3, json!("c"))]), Content::Log(vec![(3, json!("c"))]), None),
        ] {
            assert_eq!(now.since(&before), wanted, "{now:?} after {before:?}");
        }
    }

    #[test]
    fn the_beginning_and_all_changes_give_the_end() {
        let mut page: BTreeMap<String, Json> = BTreeMap::new();
        let mut known: Option<Content> = None;
        for step in 0..50_i64 {
            let now = keyed(&[("a", step / 7), ("b", step % 3), ("c", 0)]);
            let sent = known.as_ref().map_or_else(|| Some(now.all()), |known| now.since(known));
            if let Some(Json::Object(sent)) = sent {
                page.extend(sent);
            }
            assert_eq!(Content::Keyed(page.clone()), now);
            known = Some(now);
        }
    }
}
