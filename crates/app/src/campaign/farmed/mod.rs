//! A campaign past one machine: its ranges go out over a queue, what comes of them comes back.

mod in_order;
mod run;
mod server;
mod unpacked;
mod work;

pub(crate) use run::{Orders, run};
pub(crate) use server::{ServerArguments, failed};
pub(crate) use work::Working;
