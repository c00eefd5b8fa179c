//! The controller's tests with the interpreter.

use std::sync::Arc;

use sieben_engine::{Engine, Interpreter, Layout, Program};

mod engine_contract;

const LOAD: fn(&Program, &Layout) -> Arc<dyn Engine> = Interpreter::load;
