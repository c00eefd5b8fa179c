//! Tiering: a program begins in the interpreter and is compiled while it runs.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use sieben_engine::{Context, Engine, Entry, Exit, Interpreter, Layout, Program};
use sieben_model::block::BlockId;

use crate::jit::{Source, StatusBits};
use crate::translate::Options;

/// How a program runs, from what is there at once to what takes longest to make.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Tier {
    /// Statement by statement.
    Interpreter,
    /// Machine code, compiled as fast as possible.
    Quick,
    /// Machine code, compiled so that it is fast.
    Optimized,
}

impl Tier {
    /// All tiers, in order.
    pub const ALL: [Self; 3] = [Self::Interpreter, Self::Quick, Self::Optimized];
}

/// The code of one program, for any number of CPUs of the same layout: the newest generation, and what makes the next one.
///
/// Each CPU takes the newest generation at its next scan boundary; an older one is freed when the last CPU has left it.
pub struct Tiers {
    status: StatusBits,
    /// Counts the generations, so that a scan need not lock.
    generation: AtomicU64,
    newest: Mutex<(Arc<dyn Engine>, Tier)>,
    interpreter: Arc<Interpreter>,
    source: Result<Source, String>,
}

impl Tiers {
    /// A program in the interpreter, which can run at once. Both tiers of machine code calculate the same status bits.
    pub fn load(program: &Program, layout: &Layout, status: StatusBits) -> Arc<Self> {
        let interpreter = Arc::new(Interpreter::new(program, layout));
        let source = Source::new(program, layout, Arc::clone(&interpreter));
        let newest: Arc<dyn Engine> = Arc::clone(&interpreter) as Arc<dyn Engine>;
        Arc::new(Self { status, generation: AtomicU64::new(0), newest: Mutex::new((newest, Tier::Interpreter)), interpreter, source })
    }

    /// An engine for a CPU: the newest generation, with later ones to come.
    pub fn engine(self: &Arc<Self>) -> Arc<dyn Engine> {
        let newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        let number = self.generation.load(Ordering::Relaxed);
        Arc::new(Generation { engine: Arc::clone(&newest.0), number, tiers: Arc::clone(self) })
    }

    /// Why the program stays in the interpreter, as the end of a sentence; `None` if it may become machine code.
    pub fn refusal(&self) -> Option<&str> {
        self.source.as_ref().err().map(String::as_str)
    }

    /// The tier of the newest generation.
    pub fn tier(&self) -> Tier {
        self.newest.lock().unwrap_or_else(PoisonError::into_inner).1
    }

    /// Compiles the program for a tier and makes it the newest generation; also an older tier may come after a newer one.
    ///
    /// # Errors
    /// Why the program does not become this machine code, as the end of a sentence. Then the newest generation stays.
    pub fn compile(&self, tier: Tier) -> Result<(), String> {
        let optimize = tier == Tier::Optimized;
        let source = match &self.source {
            _ if tier == Tier::Interpreter => {
                self.publish(Arc::clone(&self.interpreter) as Arc<dyn Engine>, tier);
                return Ok(());
            }
            Ok(source) if optimize && !source.may_optimize() => {
                return Err("it is too large to be optimized".to_owned());
            }
            Ok(source) => source,
            Err(reason) => return Err(reason.clone()),
        };
        let options = Options { exact: self.status == StatusBits::All, optimize, ..Options::default() };
        self.publish(Arc::new(source.compile(options)?), tier);
        Ok(())
    }

    fn publish(&self, engine: Arc<dyn Engine>, tier: Tier) {
        // The last one that leaves a generation frees it: not while the others wait for the lock.
        let old = {
            let mut newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
            self.generation.fetch_add(1, Ordering::Release);
            std::mem::replace(&mut *newest, (engine, tier))
        };
        drop(old);
    }
}

impl fmt::Debug for Tiers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Tiers {{ tier: {:?}, status: {:?} }}", self.tier(), self.status)
    }
}

/// One generation of the code as a CPU runs it.
struct Generation {
    engine: Arc<dyn Engine>,
    number: u64,
    tiers: Arc<Tiers>,
}

impl Engine for Generation {
    fn run(&self, context: &mut Context<'_>, entry: &Entry) -> Exit {
        self.engine.run(context, entry)
    }
    fn resume(&self, context: &mut Context<'_>) -> Exit {
        // All generations show frames in the same way.
        self.engine.resume(context)
    }
    fn go_on(&self, context: &mut Context<'_>) -> Exit {
        self.engine.go_on(context)
    }
    fn has_block(&self, block: BlockId) -> bool {
        self.engine.has_block(block)
    }
    fn code_bytes(&self) -> usize {
        self.engine.code_bytes()
    }
    fn newer(&self) -> Option<Arc<dyn Engine>> {
        (self.tiers.generation.load(Ordering::Acquire) != self.number).then(|| self.tiers.engine())
    }
}
