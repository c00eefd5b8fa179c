//! Which bytes of the process images a program may write, so that the cycle control point can leave the others alone.
//!
//! What counts is what its instructions say. System functions, and whoever writes from outside, are not looked at here.

use std::collections::BTreeMap;
use std::ops::Range;

use sieben_model::address::Area;

use crate::access::pointed_area;
use crate::ir::{Code, Inst, Op, Place};
use crate::program::Program;

/// Bytes of the images between the first and the last that may be written; [`ANYWHERE`] if nobody can tell.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ImageWrites {
    /// Of the inputs.
    pub inputs: Range<usize>,
    /// Of the outputs.
    pub outputs: Range<usize>,
}

/// All bytes of an image, however many it has.
pub const ANYWHERE: Range<usize> = 0..usize::MAX;

impl ImageWrites {
    /// Nobody can tell.
    pub fn anywhere() -> Self {
        Self { inputs: ANYWHERE, outputs: ANYWHERE }
    }

    /// What a program writes.
    pub fn of(program: &Program) -> Self {
        let mut search = Search::default();
        program.code.values().for_each(|block| search.look_at(&block.code));
        search.finish()
    }

    fn image(&mut self, area: Area) -> Option<&mut Range<usize>> {
        match area {
            Area::Input => Some(&mut self.inputs),
            Area::Output => Some(&mut self.outputs),
            _ => None,
        }
    }

    fn write(&mut self, area: Area, bytes: Range<usize>) {
        if let Some(image) = self.image(area) {
            *image = if Range::is_empty(image) { bytes } else { image.start.min(bytes.start)..image.end.max(bytes.end) };
        }
    }

    fn write_anywhere(&mut self) {
        *self = Self::anywhere();
    }
}

/// What a variable of the IR holds.
#[derive(Clone, Copy)]
enum Held {
    Constant(u64),
    Parameter,
}

#[derive(Default)]
struct Search {
    writes: ImageWrites,
    /// Constant pointers that go to blocks as parameters: area and first byte.
    passed: Vec<(Area, usize)>,
    /// A pointer that is no constant goes to a block as a parameter.
    passes_others: bool,
    /// So many bytes from where a parameter points may be written.
    through_parameters: usize,
}

impl Search {
    fn look_at(&mut self, code: &Code) {
        for statement in 0..code.statement_count() {
            let mut held: BTreeMap<u8, Held> = BTreeMap::new();
            for inst in code.statement(statement) {
                let result = match *inst {
                    Inst::Constant { dst, value } => Some((dst, Some(Held::Constant(value)))),
                    Inst::Parameter { dst, .. } => Some((dst, Some(Held::Parameter))),
                    Inst::Compute { op: Op::Copy, dst, args } => Some((dst, held.get(&args[0].0).copied())),
                    Inst::Compute { dst, .. } | Inst::Load { dst, .. } | Inst::Intrinsic { dst, .. } => Some((dst, None)),
                    Inst::Store { place, width, .. } => {
                        self.write(place, width.bytes() as usize, &held);
                        None
                    }
                    Inst::Move { to, bytes, .. } => {
                        self.write(to, bytes as usize, &held);
                        None
                    }
                    Inst::Text { dst, to, .. } => {
                        self.write(to, usize::MAX, &held);
                        Some((dst, None))
                    }
                    Inst::PassParameter { src } => {
                        self.pass(held.get(&src.0));
                        None
                    }
                    // A called block changes registers.
                    Inst::Call { .. } => {
                        held.clear();
                        None
                    }
                    Inst::Require { .. }
                    | Inst::RequireStack { .. }
                    | Inst::Open { .. }
                    | Inst::Jump { .. }
                    | Inst::Branch { .. }
                    | Inst::JumpTable { .. }
                    | Inst::Return => None,
                };
                match result {
                    Some((dst, Some(value))) => drop(held.insert(dst.0, value)),
                    Some((dst, None)) => drop(held.remove(&dst.0)),
                    None => {}
                }
            }
        }
    }

    fn write(&mut self, place: Place, bytes: usize, held: &BTreeMap<u8, Held>) {
        let from = |first: u32| first as usize / 8;
        match place {
            Place::Fixed { area, position } => self.writes.write(area, from(position)..from(position).saturating_add(bytes)),
            Place::Indirect { area, .. } => self.writes.write(area, ANYWHERE),
            Place::Crossing { pointer, offset } => match held.get(&pointer.0) {
                // A bit of the pointer and one of the offset may make a byte.
                Some(Held::Parameter) => {
                    self.through_parameters = self.through_parameters.max(from(offset).saturating_add(bytes).saturating_add(1));
                }
                Some(&Held::Constant(pointer)) => match target(pointer) {
                    Some((area, first)) => {
                        self.writes.write(area, first..first.saturating_add(from(offset)).saturating_add(bytes).saturating_add(1))
                    }
                    None => self.writes.write_anywhere(),
                },
                None => self.writes.write_anywhere(),
            },
        }
    }

    fn pass(&mut self, held: Option<&Held>) {
        match held {
            Some(&Held::Constant(pointer)) => match target(pointer) {
                Some(target) => self.passed.push(target),
                None => self.passes_others = true,
            },
            // One that was given to this block was looked at where that was done.
            Some(Held::Parameter) => {}
            None => self.passes_others = true,
        }
    }

    fn finish(mut self) -> ImageWrites {
        if self.through_parameters > 0 {
            if self.passes_others {
                self.writes.write_anywhere();
            }
            for (area, first) in self.passed {
                self.writes.write(area, first..first.saturating_add(self.through_parameters));
            }
        }
        self.writes
    }
}

/// Where a constant pointer goes: area and first byte.
fn target(pointer: u64) -> Option<(Area, usize)> {
    let area = pointed_area(pointer & 0xFFFF_FFFF, true).ok()?;
    Some((area, (pointer & 0x00FF_FFFF) as usize / 8))
}
