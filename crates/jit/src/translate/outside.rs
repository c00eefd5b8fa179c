//! Functions that code refers to beside those of blocks: Rust code, and the gates to it. Each is declared when code refers to it first,
//! because a small program would wait longer for all their names than for its own code.

use std::cell::RefCell;
use std::collections::BTreeSet;

use cranelift_jit::JITModule;
use cranelift_module::{FuncId, Linkage, Module};
use rustc_hash::FxHashMap;
use sieben_engine::ir::Op;

use super::gates;
use super::program::words_signature;
use crate::ask::Question;

/// Such a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Outside {
    /// What an operation calculates.
    Op(Op),
    /// What the Host, or what lies in front of it, is asked.
    Question(Question),
    /// The same for cold code: see [`gates`].
    Gate(Question),
}

/// Those of one program.
#[derive(Debug, Default)]
pub(super) struct Functions {
    declared: RefCell<FxHashMap<Outside, FuncId>>,
}

impl Functions {
    /// The function, declared now if nobody referred to it before.
    pub(super) fn get(&self, module: &mut JITModule, outside: Outside) -> FuncId {
        *self.declared.borrow_mut().entry(outside).or_insert_with(|| {
            let declared = match outside {
                Outside::Op(op) => {
                    module.declare_function(op.name(), Linkage::Import, &words_signature(module, op.arity())).map_err(Box::new)
                }
                Outside::Question(question) => {
                    let ask = question.ask();
                    module.declare_function(ask.name, Linkage::Import, &words_signature(module, ask.arguments)).map_err(Box::new)
                }
                Outside::Gate(question) => gates::declare(module, question),
            };
            declared.expect("every function has a name of its own and one signature")
        })
    }

    /// The questions that are asked through gates.
    pub(super) fn at_gates(&self) -> BTreeSet<Question> {
        let question = |outside: &Outside| match outside {
            Outside::Gate(question) => Some(*question),
            _ => None,
        };
        self.declared.borrow().keys().filter_map(question).collect()
    }
}

/// Where the Rust code with this name is.
pub(super) fn address(name: &str) -> Option<*const u8> {
    let op = || Op::ALL.iter().find(|op| op.name() == name).map(|op| op.shim());
    Question::ALL.iter().map(|question| question.ask()).find(|ask| ask.name == name).map(|ask| ask.address).or_else(op)
}
