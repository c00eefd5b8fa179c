//! The status rows with the interpreter.

use std::sync::Arc;

use sieben_engine::{Engine, Interpreter, Layout, Program};

mod rows;
mod strict;

const LOAD: fn(&Program, &Layout) -> Arc<dyn Engine> = Interpreter::load;
