//! Builds the code of one block, statement by statement.

use sieben_model::address::Width;

use super::code::{Code, Inst, OnFault, Place, Target, Var};
use super::ops::Op;
use crate::intrinsics::Intrinsic;

/// Collects instructions.
#[derive(Debug, Default)]
pub struct Builder {
    code: Code,
    temporaries: usize,
}

impl Builder {
    /// Begins the next statement and returns its index; temporaries of the one before are gone.
    pub fn begin_statement(&mut self) -> Target {
        self.code.statements.push(self.code.insts.len() as u32);
        self.temporaries = 0;
        self.here()
    }
    /// The statement being built.
    pub fn here(&self) -> Target {
        Target(self.code.statements.len().saturating_sub(1) as u32)
    }
    /// The statement behind the one being built.
    pub fn next(&self) -> Target {
        Target(self.code.statements.len() as u32)
    }
    /// A fresh temporary.
    ///
    /// # Panics
    /// If one statement needs more than about 220: callers split their work before that.
    pub fn temporary(&mut self) -> Var {
        let var = Var::temporary(self.temporaries).expect("a statement stays below 220 temporaries");
        self.temporaries += 1;
        var
    }
    /// Forgets the temporaries of this statement: none of them may be read any more.
    pub fn release_temporaries(&mut self) {
        self.temporaries = 0;
    }
    /// Adds an instruction as it is.
    pub fn push(&mut self, inst: Inst) {
        self.code.insts.push(inst);
    }
    /// A constant in a temporary.
    pub fn constant(&mut self, value: u64) -> Var {
        let dst = self.temporary();
        self.push(Inst::Constant { dst, value });
        dst
    }
    /// `dst := value`.
    pub fn set(&mut self, dst: impl Into<Var>, value: u64) {
        self.push(Inst::Constant { dst: dst.into(), value });
    }
    /// `dst := src`.
    pub fn copy(&mut self, dst: impl Into<Var>, src: impl Into<Var>) {
        self.compute_into(dst, Op::Copy, &[src.into()]);
    }
    /// The result of an operation in a temporary.
    pub fn compute(&mut self, op: Op, args: &[Var]) -> Var {
        let dst = self.temporary();
        self.compute_into(dst, op, args);
        dst
    }
    /// `dst := op(args)`.
    pub fn compute_into(&mut self, dst: impl Into<Var>, op: Op, args: &[Var]) {
        self.push(Inst::Compute { op, dst: dst.into(), args: pad(args, op.arity()) });
    }
    /// A load into a temporary.
    pub fn load(&mut self, place: Place, width: Width, on_fault: OnFault) -> Var {
        let dst = self.temporary();
        self.push(Inst::Load { dst, place, width, on_fault });
        dst
    }
    /// A store.
    pub fn store(&mut self, place: Place, width: Width, src: impl Into<Var>) {
        self.push(Inst::Store { place, width, src: src.into() });
    }
    /// The result of an intrinsic in a temporary.
    pub fn intrinsic(&mut self, intrinsic: Intrinsic, args: &[Var]) -> Var {
        let dst = self.temporary();
        self.push(Inst::Intrinsic { dst, intrinsic, args: pad(args, intrinsic.arity()) });
        dst
    }
    /// Adds a jump table and returns its first index.
    pub fn table(&mut self, targets: &[Target]) -> u32 {
        let first = self.code.tables.len() as u32;
        self.code.tables.extend_from_slice(targets);
        first
    }
    /// The finished code. Running off its end ends the block.
    pub fn finish(mut self) -> Code {
        self.begin_statement();
        self.push(Inst::Return);
        self.code.statements.push(self.code.insts.len() as u32);
        self.code
    }
}

fn pad(args: &[Var], arity: usize) -> [Var; 4] {
    assert_eq!(args.len(), arity, "as many arguments as the operation takes");
    let mut all = [Var::default(); 4];
    all[..args.len()].copy_from_slice(args);
    all
}
