//! The one screen of `run`, `demo` and `top`: what a run is asked for, what is drawn of it, what keys do.

mod asks;
mod columns;
mod demo;
mod digits;
mod draw;
mod keys;
mod live;
mod look;
mod menu;
mod numbers;
mod operator;
mod pictured;
mod plain;
mod plants;
mod rows;
mod state;
#[cfg(test)]
mod tests;
mod words;

pub(crate) use asks::Direct;
pub(crate) use demo::{Demo, Outcome};
pub(crate) use live::{Around, Left, show};
pub(crate) use numbers::{clock, thousands};
pub(crate) use operator::CYCLE_US;
pub(crate) use plain::changed;
pub(crate) use state::Screen;
