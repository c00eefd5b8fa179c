//! Symbols that code refers to besides those of blocks: runtime functions, and the thunks to them. Each is declared at its first use,
//! because a small program would wait longer for all their names than for its own code.

use std::cell::RefCell;
use std::collections::BTreeSet;

use cranelift_jit::JITModule;
use cranelift_module::{FuncId, Linkage, Module};
use rustc_hash::FxHashMap;
use sieben_engine::ir::Op;

use super::program::words_signature;
use super::thunks;
use crate::runtime_calls::RuntimeCall;

/// Such a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Symbol {
    /// What an operation calculates.
    Op(Op),
    /// What the Host, or what lies before it, is asked.
    Question(RuntimeCall),
    /// The same for cold code: see [`gates`].
    Gate(RuntimeCall),
}

/// Those of one program.
#[derive(Debug, Default)]
pub(super) struct Functions {
    declared: RefCell<FxHashMap<Symbol, FuncId>>,
}

impl Functions {
    /// The function, declared now if nobody referred to it before.
    pub(super) fn get(&self, module: &mut JITModule, outside: Symbol) -> FuncId {
        *self.declared.borrow_mut().entry(outside).or_insert_with(|| {
            let declared = match outside {
                Symbol::Op(op) => {
                    module.declare_function(op.name(), Linkage::Import, &words_signature(module, op.arity())).map_err(Box::new)
                }
                Symbol::Question(question) => {
                    let ask = question.ask();
                    module.declare_function(ask.name, Linkage::Import, &words_signature(module, ask.arguments)).map_err(Box::new)
                }
                Symbol::Gate(question) => thunks::declare(module, question),
            };
            declared.expect("every function has a name of its own and one signature")
        })
    }

    /// The questions that are asked through gates.
    pub(super) fn at_gates(&self) -> BTreeSet<RuntimeCall> {
        let question = |outside: &Symbol| match outside {
            Symbol::Gate(question) => Some(*question),
            _ => None,
        };
        self.declared.borrow().keys().filter_map(question).collect()
    }
}

/// Where the Rust code with this name is.
pub(super) fn address(name: &str) -> Option<*const u8> {
    let op = || Op::ALL.iter().find(|op| op.name() == name).map(|op| op.shim());
    RuntimeCall::ALL.iter().map(|question| question.ask()).find(|ask| ask.name == name).map(|ask| ask.address).or_else(op)
}
