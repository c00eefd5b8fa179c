//! Text → checked program → IR.
#![forbid(unsafe_code)]

pub mod access;
pub mod awlsim_project;
pub mod body;
mod calling;
pub mod codesys_files;
pub mod compiled;
pub mod coverage;
pub mod database;
mod declarations;
pub mod description;
pub mod dialects;
pub mod encoding;
pub mod known_names;
pub mod language;
pub mod library;
pub mod names;
pub mod network;
pub mod options;
pub mod project;
pub mod reason;
pub mod references;
mod scan;
mod scope;
pub mod sentences;
pub mod source_names;
pub mod st;
pub mod stl;
pub mod symbols;

pub use body::CheckedBody;
pub use compiled::Compiled;
pub use database::Database;
pub use language::Language;
pub use options::Options;
pub use project::compile;
pub use scope::LostResults;
pub use stl::check::TemporaryReads;
