//! The seam for what a page does to the run as a whole: the project that runs, what may run instead, and the files beside its program.

use serde_json::{Value as Json, json};
use sieben_workspace::Refusal;

/// What listeners hear a change of the project as.
pub const PROJECT: &str = "project";

/// The project that runs, and what may run instead.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Listed {
    /// What it is called.
    pub name: String,
    /// The folder that it was read from, if there is one.
    pub path: Option<String>,
    /// Examples that may run instead, with what they are; none where the page shows this project alone.
    pub examples: Vec<(&'static str, &'static str)>,
}

impl Listed {
    /// The same as pages take it.
    pub(crate) fn json(&self) -> Json {
        let examples = self.examples.iter().map(|(name, about)| json!({ "name": name, "about": about }));
        json!({ "name": self.name, "path": self.path, "examples": examples.collect::<Json>() })
    }

    /// The names of the examples.
    pub(crate) fn names(&self) -> Vec<&'static str> {
        self.examples.iter().map(|&(name, _)| name).collect()
    }
}

/// What stands around a program. All of it may wait for the disk or the CPU.
pub trait Projects: Send + Sync {
    /// The project that runs, and what may run instead.
    fn listed(&self) -> Listed;

    /// Another example runs from now on: it does when this returns.
    ///
    /// # Errors
    /// There is no such example, this run stays with its project, or it is over.
    fn change(&self, example: &str) -> Result<(), Refusal>;

    /// The names of the watch tables of the project.
    ///
    /// # Errors
    /// Its folder cannot be read.
    fn watch_tables(&self) -> Result<Vec<String>, Refusal>;

    /// The bytes of one of them.
    ///
    /// # Errors
    /// There is none of this name, or it cannot be read.
    fn watch_table(&self, name: &str) -> Result<Vec<u8>, Refusal>;
}
