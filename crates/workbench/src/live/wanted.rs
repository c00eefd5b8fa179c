//! What pages want of a scan, one and all of them together.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use sieben_workspace::status::Calls;

use super::message::Common;
use crate::reference::View;

/// What is wanted of a scan.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// Calls whose statements are looked at.
    pub calls: BTreeSet<Calls>,
    /// Those of them whose statements are shown as rows: they are stepped through.
    pub rows: BTreeSet<Calls>,
    /// Statements whose reasons are shown.
    pub reasons: BTreeSet<(Calls, u32)>,
    /// Networks whose power flow is shown.
    pub flows: BTreeSet<(Calls, View, u32)>,
    /// Names of values.
    pub names: BTreeSet<String>,
    /// What is the same for all pages.
    pub common: BTreeSet<Common>,
}

impl Wanted {
    fn add(&mut self, other: &Self) {
        self.calls.extend(&other.calls);
        self.rows.extend(&other.rows);
        self.reasons.extend(&other.reasons);
        self.names.extend(other.names.iter().cloned());
        self.flows.extend(&other.flows);
        self.common.extend(&other.common);
    }

    /// Whether a scan has to be replayed for it.
    pub fn needs_replay(&self) -> bool {
        !self.calls.is_empty() || !self.names.is_empty() || self.common.contains(&Common::Plant)
    }
}

/// What all pages want.
#[derive(Default)]
pub struct AllWanted {
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    of_pages: BTreeMap<u64, Wanted>,
    together: Arc<Wanted>,
}

impl AllWanted {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A page wants this from now on; `None`: the page has gone.
    pub fn set(&self, page: u64, wanted: Option<Wanted>) {
        let mut state = self.state();
        match wanted {
            Some(wanted) => drop(state.of_pages.insert(page, wanted)),
            None => drop(state.of_pages.remove(&page)),
        }
        let mut together = Wanted::default();
        state.of_pages.values().for_each(|wanted| together.add(wanted));
        if *state.together != together {
            state.together = Arc::new(together);
        }
    }

    /// All of it.
    pub fn together(&self) -> Arc<Wanted> {
        Arc::clone(&self.state().together)
    }

    /// How many pages there are.
    pub fn pages(&self) -> usize {
        self.state().of_pages.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_one_page_wants_is_wanted_until_it_goes() {
        let all = AllWanted::default();
        let wanted = |names: &[&str]| Wanted { names: names.iter().map(|&name| name.to_owned()).collect(), ..Wanted::default() };
        all.set(1, Some(wanted(&["a", "b"])));
        all.set(2, Some(wanted(&["b", "c"])));
        assert_eq!(*all.together(), wanted(&["a", "b", "c"]));
        all.set(1, None);
        assert_eq!((*all.together()).clone(), wanted(&["b", "c"]));
        let before = all.together();
        all.set(2, Some(wanted(&["b", "c"])));
        assert!(Arc::ptr_eq(&before, &all.together()), "what is the same is not made again");
        all.set(2, None);
        assert_eq!((all.pages(), (*all.together()).clone()), (0, Wanted::default()));
    }
}
