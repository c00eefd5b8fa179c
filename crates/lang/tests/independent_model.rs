//! Instructions against an independent model, on the interpreter.

mod model;
mod strict;

use std::sync::Arc;

use sieben_engine::{Engine, Interpreter, Layout, Program};

const LOAD: fn(&Program, &Layout) -> Arc<dyn Engine> = Interpreter::load;
