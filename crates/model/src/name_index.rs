//! Where the names of a long list stand: who asks for each of them once must not walk the list each time.

use std::collections::HashMap;
use std::fmt;
use std::sync::OnceLock;

/// Shorter lists are walked: that costs less than a table.
const WALKED_MAX: usize = 16;

/// The places of names in a list, without regard to case. It belongs to the list, is made when it is first asked, and is no part of its
/// value: a copy begins without it, and two lists are the same without it.
#[derive(Default)]
pub struct NameIndex(OnceLock<HashMap<String, usize>>);

impl NameIndex {
    /// The first item with a name.
    pub fn find<'t, T>(&self, items: &'t [T], name_of: impl Fn(&T) -> &str, name: &str) -> Option<&'t T> {
        let is_it = |item: &&T| name_of(item).eq_ignore_ascii_case(name);
        if items.len() <= WALKED_MAX {
            return items.iter().find(is_it);
        }
        let places = self.0.get_or_init(|| {
            let mut places = HashMap::with_capacity(items.len());
            for (place, item) in items.iter().enumerate() {
                places.entry(name_of(item).to_ascii_lowercase()).or_insert(place);
            }
            places
        });
        let found = places.get(&name.to_ascii_lowercase()).and_then(|&place| items.get(place)).filter(is_it);
        // A list that has changed since is walked.
        if found.is_none() && places.len() != items.len() { items.iter().find(is_it) } else { found }
    }
}

impl Clone for NameIndex {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for NameIndex {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl fmt::Debug for NameIndex {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("NameIndex")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_as_by_walking() {
        for count in [0, 1, WALKED_MAX, WALKED_MAX + 1, 500] {
            let mut items: Vec<String> = (0..count).map(|number| format!("Name{}", number % 300)).collect();
            let index = NameIndex::default();
            let found = |items: &[String], name: &str| index.find(items, String::as_str, name).map(std::ptr::from_ref);
            let walked = |items: &[String], name: &str| items.iter().find(|item| item.eq_ignore_ascii_case(name)).map(std::ptr::from_ref);
            for name in ["name0", "NAME7", "name299", "name300", "", "näme"] {
                assert_eq!(found(&items, name), walked(&items, name), "{name} in {count}");
            }
            items.push("late".to_owned());
            assert_eq!(found(&items, "LATE"), walked(&items, "LATE"), "{count}");
        }
    }
}
