//! Tests of programs in files: which there are, how many run at once, where their pages and diagrams go.

pub(crate) mod checked;
pub(crate) mod computer;
pub(crate) mod coverage_pages;
pub(crate) mod discovery;
pub(crate) mod rules;
mod time_limit;

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use sieben_workspace::testing::report::Worst;
use sieben_workspace::testing::{Case, Conditions, Finished};

use crate::failure::Exit;

/// The exit code: that of the worst of all tests.
pub(crate) fn exit(worst: Worst) -> Exit {
    match worst {
        Worst::DoesNotCompile => Exit::DoesNotCompile,
        Worst::Unreadable => Exit::Usage,
        Worst::Failed => Exit::CheckFailed,
        Worst::Passed => Exit::Success,
    }
}

/// Runs all tests, as many at once as `threads`, and tells `progress` how many are done. They come back in their order.
pub(crate) fn run_all(cases: &[Case], conditions: &Conditions, threads: usize, progress: &(dyn Fn(usize) + Sync)) -> Vec<Finished> {
    let next = AtomicUsize::new(0);
    let done = Mutex::new(Vec::with_capacity(cases.len()));
    std::thread::scope(|scope| {
        for _ in 0..threads.clamp(1, cases.len().max(1)) {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(case) = cases.get(index) else { return };
                    let begun = Instant::now();
                    let outcome = (case.run)(conditions);
                    let (name, file, program) = (case.name.clone(), case.file.clone(), case.program.clone());
                    let finished = Finished { name, file, program, outcome, took: begun.elapsed() };
                    // A panic ends the process, so that no one finds the lock poisoned.
                    let mut done = done.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
                    done.push((index, finished));
                    progress(done.len());
                }
            });
        }
    });
    let mut done = done.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, finished)| finished).collect()
}
