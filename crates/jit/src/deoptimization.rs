//! Deoptimization: statements that the interpreter does in the middle of a run of machine code, the rest of an iteration of a loop.

use std::ops::RangeInclusive;

use sieben_engine::{Context, Exit, FaultPlace, Machine, StatementEvent, Tracer};

use crate::run::Run;
use crate::runtime_calls::{GO_ON, LEAVE};

/// Looks for the end of an iteration.
struct Watch {
    /// How many frames there are in the block of the loop.
    frames: usize,
    /// The statements of the loop that do something.
    statements: RangeInclusive<u32>,
    /// A statement has begun.
    began: bool,
    /// The block of the loop has ended.
    ended: bool,
    /// The statement behind the iteration.
    behind: Option<u32>,
}

impl Tracer for Watch {
    fn statement(&mut self, _: &Machine, _: &StatementEvent) {}

    fn pauses_before(&mut self, machine: &Machine, place: FaultPlace) -> bool {
        let began = std::mem::replace(&mut self.began, true);
        self.ended |= machine.frames.len() < self.frames;
        let begins_again = began && place.statement == *self.statements.start();
        let is_behind = !self.ended && machine.frames.len() == self.frames && (begins_again || !self.statements.contains(&place.statement));
        if is_behind {
            self.behind = Some(place.statement);
        }
        is_behind
    }
}

/// The first statement of a loop that does something and the last one, in one word.
pub(crate) fn span(first: u32, last: u32) -> u64 {
    u64::from(first) | u64::from(last) << 32
}

/// Lets the interpreter go on with a statement up to the end of the iteration of a loop, in an activation of its own or one that called it.
/// The statement behind the iteration is in `run.value`, unless the run was left.
pub(crate) extern "C" fn iteration(run: &mut Run<'_, '_>, link: u64, code: u64, statement: u64, span: u64, home: u64) -> u64 {
    run.show(run.depth(link), 0);
    let resume = run.compiled.interpreter.resume_at(code as u32, statement as u32);
    run.interrupt_at(resume);
    let statements = span as u32..=(span >> 32) as u32;
    let mut watch = Watch { frames: run.depth(home) + 1, statements, began: false, ended: false, behind: None };
    let machine = &mut *run.context.machine;
    let exit = run.compiled.interpreter.go_on(&mut Context { machine, host: &mut *run.context.host, tracer: Some(&mut watch) });
    run.take_back();
    let Some(behind) = watch.behind.filter(|_| exit == Exit::Paused) else {
        run.exit = Some(exit);
        return LEAVE;
    };
    run.check_open_blocks();
    let fits = run.follow_frames() && run.compiled.fits(&run.context.machine.memory);
    if !fits {
        // The program changed data blocks that this code takes to be as they were.
        run.exit = None;
        return LEAVE;
    }
    run.value = u64::from(behind);
    GO_ON
}
