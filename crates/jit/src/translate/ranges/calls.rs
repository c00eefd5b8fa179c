//! What is known behind a call.

use sieben_engine::access::pointed_area;
use sieben_engine::ir::Inst;
use sieben_engine::machine::{CALLS_SHIFT, Register};
use sieben_model::address::Area;

use super::{Analysis, Known, State};
use crate::translate::effects::{Effects, Given};
use crate::translate::promote::Base;

/// Bits that a pointer may count.
const POSITIONS: i64 = 1 << 24;

/// Bytes that lie in front of a bit, if only in part.
fn bytes_before(bit: i64) -> i64 {
    bit.div_euclid(8) + i64::from(bit % 8 != 0)
}

impl Analysis<'_> {
    /// Follows a call. Variables that the called block may write are not known behind it, nor any if somebody may be asked in the middle of
    /// one of its statements.
    pub(super) fn call(&mut self, index: u32, inst: &Inst, state: &mut State, passed: &mut Vec<Known>, notes: bool) {
        let Inst::Call { parameters, .. } = *inst else { return };
        let given = passed.split_off(passed.len().saturating_sub(usize::from(parameters)));
        let ar2 = state.registers.get(&(Register::Ar2 as u8)).map(|known| known.range);
        if notes && let Some(ar2) = ar2 {
            self.found.instances.insert(index, ar2);
        }
        if notes {
            self.found.at_calls.insert(index, state.facts());
        }
        let around = self.around;
        let effects = (around.called)(inst).and_then(|code| around.effects[code].as_ref());
        let kept = effects.is_some_and(|effects| self.forget_effects(effects, state, &given).is_some());
        if !kept {
            state.cells.clear();
        }
        let written = (self.around.written)(inst);
        state.registers.retain(|&register, _| written & (1 << register) == 0);
        if notes && kept {
            self.found.over_calls.insert(index, state.facts());
        }
    }

    /// Forgets what a called block may write; `None` = it may be anything.
    fn forget_effects(&self, effects: &Effects, state: &mut State, given: &[Known]) -> Option<()> {
        if let Some(touched) = &effects.instance {
            let (_, start, length, _) = self.area(state, Area::InstanceData)?;
            let pointer = state.registers.get(&(Register::Ar2 as u8))?.range;
            let (least, most) = pointer.unsigned(24);
            let (first, end) = (least as i64 + touched.start, most as i64 + touched.end);
            // A position may turn over.
            let bytes = if first < 0 || end > POSITIONS { start..start + length } else { start + first / 8..start + bytes_before(end) };
            state.forget(Base::Arena, &bytes);
        }
        for &area in &effects.areas {
            let range = self.around.layout.area(area)?;
            state.forget(Base::Arena, &(range.start as i64..range.end as i64));
        }
        for number in effects.blocks.iter().filter(|&&number| number != 0) {
            let range = self.around.layout.data_blocks.get(number)?;
            state.forget(Base::Arena, &(range.start as i64..range.end as i64));
        }
        effects.given.iter().try_for_each(|access| self.forget_given(access, state, given))
    }

    /// Forgets what a called block may write by a pointer that it was given.
    fn forget_given(&self, access: &Given, state: &mut State, given: &[Known]) -> Option<()> {
        let (least, most) = given.get(usize::from(access.parameter)).map_or((0, 0), |known| known.range.unsigned(64));
        if least >> 24 != most >> 24 {
            return None;
        }
        let area = pointed_area(least as u64, access.writes).ok()?;
        match area {
            Area::PeripheralInput | Area::PeripheralOutput => return None,
            // The local data of this block; what lies further out may be anywhere.
            Area::CallerLocal if (most & 0x00FF_FFFF) >> CALLS_SHIFT != 0 => return None,
            _ if !access.writes => return Some(()),
            _ => {}
        }
        let area = if area == Area::CallerLocal { Area::Local } else { area };
        let (base, start, length, _) = self.area(state, area)?;
        let position = |pointer: i128| (pointer & 0x00FF_FFFF) as i64 + i64::from(access.offset);
        let end = position(most) + i64::from(access.width.bits());
        // A position may turn over.
        let bytes = if end > POSITIONS { 0..length } else { position(least) / 8..bytes_before(end) };
        state.forget(base, &(start + bytes.start..start + bytes.end));
        Some(())
    }
}
