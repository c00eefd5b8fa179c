//! What code means: the IR, its operations, the machine they work on, and the interpreter.
#![forbid(unsafe_code)]

pub mod access;
pub mod fault;
pub mod host;
pub mod image_writes;
pub mod interpreter;
pub mod intrinsics;
pub mod ir;
pub mod machine;
pub mod numbers_in_texts;
pub mod program;
pub mod texts;
pub mod tracer;

pub use fault::{Abort, Fault, Place as FaultPlace};
pub use host::{Context, Engine, Entry, Exit, Host, Reaction, StopReason};
pub use image_writes::ImageWrites;
pub use interpreter::Interpreter;
pub use machine::{Layout, Machine};
pub use program::{CodeBlock, Program};
pub use tracer::{LocalAccess, StatementEvent, Stored, Tracer};
