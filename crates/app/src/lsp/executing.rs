//! Commands that a client has the server execute.

/// All of them.
pub(super) const ALL: [&str; 2] = ["sieben.runTest", "sieben.showDiagram"];
