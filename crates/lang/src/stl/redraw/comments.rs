//! The comments of a network that is redrawn: each goes with its statement.

use std::cell::RefCell;
use std::collections::HashSet;

use crate::network::model::Place;
use crate::stl::diagrams::StatementComment;

/// Comments by statement, each given out once.
pub(super) struct Comments {
    all: Vec<StatementComment>,
    given: RefCell<HashSet<usize>>,
}

impl Comments {
    pub(super) fn new(all: Vec<StatementComment>) -> Self {
        Self { all, given: RefCell::default() }
    }

    /// Those of an element or of one of its pins: the lines before it, and the one on its line.
    pub(super) fn of(&self, place: Place, pin: Option<&str>) -> (Vec<String>, Option<String>) {
        let (mut before, mut after) = (Vec::new(), None);
        let mut given = self.given.borrow_mut();
        for (index, comment) in self.all.iter().enumerate() {
            let inside = (place.first as usize..=place.last as usize).contains(&comment.statement);
            let same_pin = match (&comment.pin, pin) {
                (None, None) => true,
                (Some(own), Some(pin)) => own.eq_ignore_ascii_case(pin),
                _ => false,
            };
            if !inside || !same_pin || !given.insert(index) {
                continue;
            }
            before.extend(comment.before.iter().cloned());
            match (&comment.after, &after) {
                (Some(text), None) => after = Some(text.clone()),
                (Some(text), Some(_)) => before.push(text.clone()),
                (None, _) => {}
            }
        }
        (before, after)
    }

    /// Those that no element took.
    pub(super) fn left(&self) -> Vec<String> {
        let given = self.given.borrow();
        let left = self.all.iter().enumerate().filter(|(index, _)| !given.contains(index));
        left.flat_map(|(_, comment)| comment.before.iter().chain(&comment.after)).cloned().collect()
    }
}
