//! A run seen from outside: what `sieben top` shows, on a screen, as text and as JSON.

mod draw;
mod live;
mod look;
#[cfg(test)]
mod tests;

pub(crate) use live::{Left, run};
pub(crate) use look::Onlooker;
