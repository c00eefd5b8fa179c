//! A program as it is loaded: all that any number of CPUs with the same program share.

use std::sync::Arc;

use sieben_engine::{Engine, ImageWrites, Layout, Program};
use sieben_model::cpu_type::CpuType;

use crate::data_block_change::{DataBlockChange, DataBlockInUse};
use crate::retain::Declarations;

/// A program that is ready to run, with its code; a copy shares all of it.
#[derive(Clone)]
pub struct Loaded {
    pub(super) cpu_type: &'static CpuType,
    pub(super) program: Arc<Program>,
    pub(super) layout: Arc<Layout>,
    pub(super) engine: Arc<dyn Engine>,
    pub(super) declarations: Arc<Declarations>,
    pub(super) image_writes: Arc<ImageWrites>,
}

impl Loaded {
    /// Loads a program for a CPU type; `load` makes the engine for it and the layout that it has there.
    pub fn new(cpu_type: &'static CpuType, program: Arc<Program>, load: impl FnOnce(&Program, &Layout) -> Arc<dyn Engine>) -> Self {
        let layout = Arc::new(Layout::new(cpu_type, &program));
        let engine = load(&program, &layout);
        let declarations = Arc::new(Declarations::of(&program));
        let image_writes = Arc::new(engine.image_writes(&program));
        Self { cpu_type, program, layout, engine, declarations, image_writes }
    }

    /// Loads the program of a change of data blocks.
    ///
    /// # Errors
    /// Code uses a data block that is to go.
    pub fn changed(change: &DataBlockChange, load: impl FnOnce(&Program, &Layout) -> Arc<dyn Engine>) -> Result<Self, DataBlockInUse> {
        Ok(Self::new(change.cpu_type, Arc::new(change.program()?), load))
    }

    /// Bytes of machine code that all its CPUs share; 0 if the program is interpreted.
    pub fn code_bytes(&self) -> usize {
        self.engine.code_bytes()
    }
}
