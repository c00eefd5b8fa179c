//! What the interpreter is tested by, on machine code: the contract between CPU and engine, the status rows and the independent model.

use std::sync::Arc;

use sieben_engine::{Engine, Layout, Program};
use sieben_jit::{Jit, StatusBits};

#[path = "../../cpu/tests/engine_contract/mod.rs"]
mod engine_contract;
#[path = "../../lang/tests/model/mod.rs"]
mod model;
#[path = "../../lang/tests/rows/mod.rs"]
mod rows;
#[path = "../../lang/tests/strict/mod.rs"]
mod strict;

const LOAD: fn(&Program, &Layout) -> Arc<dyn Engine> = machine_code;

/// Machine code and nothing else.
fn machine_code(program: &Program, layout: &Layout) -> Arc<dyn Engine> {
    Jit::compiled(program, layout, StatusBits::All).unwrap_or_else(|reason| panic!("the program becomes machine code: {reason}"))
}
