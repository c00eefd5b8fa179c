//! Executable memory and the way into it: the only file that holds `unsafe`.
#![allow(unsafe_code)]

use std::fmt;

use cranelift_jit::JITModule;
use cranelift_module::FuncId;

use crate::run::Run;

/// The function of a block: run, first byte of the arena, first byte of the block's local data, link of this activation; whether
/// the run is left.
pub(crate) type Function = extern "C" fn(&mut Run<'_, '_>, *mut u8, usize, usize) -> u64;

/// The machine code of one program. It never changes, and any number of threads may run it at once.
pub(crate) struct Generation {
    /// Taken only when the generation is dropped.
    module: Option<JITModule>,
    /// By block; `None` = nobody enters it but calls that know which version they call.
    functions: Vec<Option<Function>>,
    bytes: usize,
    levels: usize,
}

// SAFETY: the module is only read after `new`, except by `drop`, which owns it; the code holds no state of its own.
unsafe impl Send for Generation {}
// SAFETY: as above; calling the code needs `&mut Run`, which no two threads have.
unsafe impl Sync for Generation {}

impl Generation {
    /// The finished functions of a module, by block. All of them have the signature of [`Function`]: the translator declares no other.
    pub(crate) fn new(module: JITModule, blocks: &[Option<FuncId>], bytes: usize, levels: usize) -> Self {
        let functions = blocks
            .iter()
            .map(|&block| {
                let address = module.get_finalized_function(block?);
                // SAFETY: the address is that of a finished function which `translate` declared with exactly this signature, and the
                // module that owns it lives as long as `self`, beside which `Compiled` keeps what it hands out.
                Some(unsafe { std::mem::transmute::<*const u8, Function>(address) })
            })
            .collect();
        Self { module: Some(module), functions, bytes, levels }
    }

    /// Bytes of machine code.
    pub(crate) fn bytes(&self) -> usize {
        self.bytes
    }

    /// Activations whose frames fit on the native stack.
    pub(crate) fn levels(&self) -> usize {
        self.levels
    }

    /// The function of a block, if somebody may enter it. Who keeps it keeps the generation, too.
    pub(crate) fn function(&self, code: usize) -> Option<Function> {
        self.functions[code]
    }

    /// Runs a block; whether the run is left.
    ///
    /// `local` is the address of its local data, which lie inside the arena, and `link` that of its entry in the list of links: the
    /// callers in `runtime_calls.rs` check both against the limits of the run.
    ///
    /// # Panics
    /// If nobody but other machine code was to enter the block: organization blocks, and those that are called by a computed number, are
    /// always there.
    pub(crate) fn call(&self, code: usize, run: &mut Run<'_, '_>, local: usize, link: usize) -> bool {
        let function = self.functions[code].expect("a block that is entered from outside has a general version");
        // Whoever was asked since the run began may have moved it.
        run.arena();
        Self::enter(function, run, local, link)
    }

    /// The same with the function of the block, where the arena is known to be where the run has found it.
    #[inline]
    pub(crate) fn enter(function: Function, run: &mut Run<'_, '_>, local: usize, link: usize) -> bool {
        let arena = run.arena_at_first();
        function(run, arena, local, link) != 0
    }
}

impl Drop for Generation {
    fn drop(&mut self) {
        if let Some(module) = self.module.take() {
            // SAFETY: every run borrows the engine that owns this generation, so that none of its functions is running, and the copies
            // of their addresses are in the same engine.
            unsafe { module.free_memory() };
        }
    }
}

impl fmt::Debug for Generation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Generation {{ functions: {}, bytes: {} }}", self.functions.len(), self.bytes)
    }
}
