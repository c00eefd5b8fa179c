//! Why a statement of STL did what it did: its sentences, by the column `why` of the instruction table.

mod bits;
mod control;
mod faults;
mod numbers;
mod operands;
mod telling;
mod timers;

pub(crate) use telling::Telling;
