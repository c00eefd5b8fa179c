//! The demo plant on the terminal.

mod changes;
mod digits;
mod draw;
mod listing;
mod live;
mod operator;
mod picture;
mod plant;
#[expect(dead_code, reason = "the screen of `run` draws them")]
mod plants;
mod session;

pub(crate) use changes::{Entry, Event, clock, thousands};
pub(crate) use live::run;
pub(crate) use operator::CYCLE_US;
pub(crate) use session::{Outcome, Session};
