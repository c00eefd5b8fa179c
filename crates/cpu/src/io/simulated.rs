//! A module whose inputs are set from outside.

use std::ops::Range;

use super::IoModule;

/// A module without a process: its inputs are set from outside and stay until changed. What is put out is at [`super::Rack::outputs`].
#[derive(Clone, Debug)]
pub struct SimulatedModule {
    name: String,
    first: u32,
    inputs: Vec<u8>,
    failed: bool,
}

impl SimulatedModule {
    /// A module with as many input as output bytes at these addresses.
    pub fn new(name: impl Into<String>, addresses: Range<u32>) -> Self {
        Self { name: name.into(), first: addresses.start, inputs: vec![0; addresses.len()], failed: false }
    }
}

impl IoModule for SimulatedModule {
    fn name(&self) -> &str {
        &self.name
    }
    fn inputs(&self) -> Range<u32> {
        self.first..self.first + self.inputs.len() as u32
    }
    fn outputs(&self) -> Range<u32> {
        self.inputs()
    }
    fn read(&self, offset: u32, into: &mut [u8]) {
        let start = offset as usize;
        into.copy_from_slice(&self.inputs[start..start + into.len()]);
    }
    fn write(&mut self, _: u32, _: &[u8]) {}
    fn answers(&self) -> bool {
        !self.failed
    }
    fn set_answering(&mut self, answers: bool) -> bool {
        self.failed = !answers;
        true
    }
    fn set_input(&mut self, offset: u32, mask: u8, value: u8) -> bool {
        let byte = &mut self.inputs[offset as usize];
        *byte = *byte & !mask | value & mask;
        true
    }
    fn copy(&self) -> Option<Box<dyn IoModule>> {
        Some(Box::new(self.clone()))
    }
}
