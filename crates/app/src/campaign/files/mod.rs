//! What came of a campaign as files: a ledger while it runs, and the result, the same bytes however it was run.

mod columns;
mod head;
mod kept;
mod ledger;
mod merging;
mod part_file;
mod result_file;

pub(crate) use columns::Columns;
pub(crate) use kept::{Kept, Start, Wanted, beside};
pub(crate) use merging::merge;
pub(crate) use part_file::{decode, digest, encode};
pub(crate) use result_file::ResultFile;
