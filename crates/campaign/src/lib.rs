//! Campaigns: very many scenarios of one program, each a pure function of the program, the file of the campaign, a seed and a number.
#![forbid(unsafe_code)]

pub mod disturbed;
pub mod document;
pub mod draws;
pub mod exact;
pub mod fuzz;
pub mod given;
pub mod histogram;
pub mod identity;
pub mod judge;
pub mod numbering;
pub mod packed;
pub mod parse;
pub mod part;
pub mod ranges;
pub mod row;
pub mod shrinking;
pub mod slots;
pub mod spec;
pub mod tally;
