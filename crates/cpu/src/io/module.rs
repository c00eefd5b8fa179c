//! What a module has to do.

use std::any::Any;
use std::ops::Range;

use crate::interrupts::Interrupt;

/// An input or output module, real or simulated, at byte addresses of the peripheral area.
pub trait IoModule: Any + Send + Sync {
    /// What the user calls it.
    fn name(&self) -> &str;
    /// Input bytes it answers for; empty if it has none.
    fn inputs(&self) -> Range<u32>;
    /// Output bytes it answers for; empty if it has none.
    fn outputs(&self) -> Range<u32>;
    /// Reads input bytes, the first one `offset` bytes after the start of [`Self::inputs`].
    fn read(&self, offset: u32, into: &mut [u8]);
    /// Takes output bytes, the first one `offset` bytes after the start of [`Self::outputs`].
    fn write(&mut self, offset: u32, from: &[u8]);
    /// Time passes.
    fn advance(&mut self, dt_us: u64) {
        let _ = dt_us;
    }
    /// Whether it answers at all; one that has failed or was pulled does not.
    fn answers(&self) -> bool {
        true
    }
    /// Lets it fail, or answer again; `false` if it cannot be told so.
    fn set_answering(&mut self, answers: bool) -> bool {
        let _ = answers;
        false
    }
    /// Interrupts that the module has raised since it was asked last: hardware, diagnostic, exchange …
    fn alarms(&mut self) -> Vec<Interrupt> {
        Vec::new()
    }
    /// Sets the input bits of `mask` from outside, to stay until changed; `false` if the module has a process of its own.
    fn set_input(&mut self, offset: u32, mask: u8, value: u8) -> bool {
        let _ = (offset, mask, value);
        false
    }
    /// The module as it is now, with all that it does from here on; `None` if it cannot be copied, as one with real wires.
    fn copy(&self) -> Option<Box<dyn IoModule>> {
        None
    }
}
