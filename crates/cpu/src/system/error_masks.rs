//! What SFC 36, 37 and 38 have in common: which bit stands for which synchronous error.

use sieben_engine::Fault;
use sieben_model::address::Width;

use super::Call;

/// A filter of SFC 38 names an error that is not masked, one of SFC 36 one that is, one of SFC 37 one that was not.
pub(super) const NOT_ALL: u32 = 0x0001;

/// Bits that stand for an error: of programming errors 16#2521 to 2529 and 16#2530 to 253F, of access errors 16#2942 to 2945.
const VALID: [u32; 2] = [0xFFFF_03FE, 0x0000_003C];

/// The filter (0 = programming errors, 1 = access errors) and its bit for an error; none for one that cannot be masked.
pub(crate) fn filter_bit(fault: &Fault) -> Option<(usize, u32)> {
    match *fault {
        Fault::Programming { code: code @ 0x21..=0x29, .. } => Some((0, 1 << (code & 0xF))),
        Fault::Programming { code: code @ 0x30..=0x3F, .. } => Some((0, 1 << (16 + (code & 0xF)))),
        Fault::Programming { .. } | Fault::Abort(_) => None,
        Fault::IoAccess { write, .. } => Some((1, if write { 1 << 3 } else { 1 << 2 })),
    }
}

impl Call<'_, '_> {
    /// The two filters, the first two parameters.
    pub(super) fn filters(&mut self) -> Result<[u32; 2], u16> {
        Ok([self.input(0, Width::DoubleWord)? & VALID[0], self.input(1, Width::DoubleWord)? & VALID[1]])
    }

    /// Writes the two results behind RET_VAL.
    pub(super) fn filter_results(&mut self, results: [u32; 2]) -> Result<(), u16> {
        self.output(3, Width::DoubleWord, results[0])?;
        self.output(4, Width::DoubleWord, results[1])
    }
}

/// 16#0001 if any bit is left over.
pub(super) fn left_over(bits: [u32; 2]) -> u32 {
    if bits == [0, 0] { 0 } else { NOT_ALL }
}
