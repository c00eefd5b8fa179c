//! What SFC 39 and SFC 40 have in common: which organization blocks they mean.

use std::ops::RangeInclusive;

use sieben_model::address::Width;

use crate::organization_blocks as ob;

use super::Call;
use super::interrupt_blocks::BAD_BLOCK;

const BAD_MODE: u16 = 0x8091;

/// All that can be locked.
const ALL: RangeInclusive<u16> = 10..=87;

/// The blocks that MODE and OB_NR mean: 0 all, 1 a class by its first number, 2 one block.
pub(super) fn blocks(call: &mut Call<'_, '_>, mode: u32) -> Result<RangeInclusive<u16>, u16> {
    let number = call.input(1, Width::Word)? as u16;
    match mode {
        0 => Ok(ALL),
        1 if matches!(number, 10 | 20 | 30 | 40 | 50 | 60 | 70 | 80) => Ok(number..=(number + 9).min(*ALL.end())),
        2 if ob::is_interrupt(number) && call.host.cpu_type.has_organization_block(number) => Ok(number..=number),
        1 | 2 => Err(BAD_BLOCK),
        _ => Err(BAD_MODE),
    }
}
