//! The threads of a worker, and what they are to do.

use std::collections::VecDeque;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};

use super::{Offer, Opener, Work};

/// What a thread is to do.
pub(super) enum Task {
    /// Make a campaign ready.
    Open(Offer),
    /// Run a range.
    Run(Running),
}

/// A range that is to be run.
pub(super) struct Running {
    /// The message that asked for it.
    pub key: u64,
    pub range: Range<u64>,
    pub work: Arc<dyn Work>,
    /// Whether the result is no longer wanted.
    pub stop: Arc<AtomicBool>,
    /// Whether a thread has it.
    pub has_begun: Arc<AtomicBool>,
    /// Whether its only scenario is given up.
    pub is_given_up: bool,
}

/// What came of a task.
pub(super) enum Answer {
    Opened(Result<Arc<dyn Work>, String>),
    Ran(u64, Ran),
}

/// What came of a range.
pub(super) enum Ran {
    /// Its result, and whether its scenario was given up.
    Done(Vec<u8>, bool),
    /// It was over before it was done.
    Stopped,
    /// The code that runs scenarios broke one of its assumptions.
    Panicked,
}

/// Where the answers come out.
pub(super) type Answers = UnboundedReceiver<Answer>;

/// The tasks that no thread has.
pub(super) struct Pool {
    queue: Mutex<Queue>,
    change: Condvar,
    /// One answer for each task, of which there are few.
    answers: UnboundedSender<Answer>,
}

#[derive(Default)]
struct Queue {
    tasks: VecDeque<Task>,
    is_closed: bool,
}

impl Pool {
    pub(super) fn new() -> (Self, Answers) {
        let (answers, receiver) = unbounded_channel();
        (Self { queue: Mutex::default(), change: Condvar::new(), answers }, receiver)
    }

    fn queue(&self) -> MutexGuard<'_, Queue> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn put(&self, task: Task) {
        self.queue().tasks.push_back(task);
        self.change.notify_one();
    }

    /// Takes back what no thread has.
    pub(super) fn clear(&self) {
        self.queue().tasks.clear();
    }

    /// Lets the threads end.
    pub(super) fn close(&self) {
        let mut queue = self.queue();
        queue.tasks.clear();
        queue.is_closed = true;
        self.change.notify_all();
    }

    fn take(&self) -> Option<Task> {
        let mut queue = self.queue();
        loop {
            if let Some(task) = queue.tasks.pop_front() {
                if let Task::Run(running) = &task {
                    running.has_begun.store(true, Ordering::Relaxed);
                }
                return Some(task);
            }
            if queue.is_closed {
                return None;
            }
            queue = self.change.wait(queue).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// The life of a thread.
    pub(super) fn serve(&self, open: &Opener<'_>, is_over: &(dyn Fn() -> bool + Sync)) {
        while let Some(task) = self.take() {
            let answer = match task {
                Task::Open(offer) => Answer::Opened(
                    catch_unwind(AssertUnwindSafe(|| open(&offer)))
                        .unwrap_or_else(|_| Err("it broke an assumption of this program".to_owned())),
                ),
                Task::Run(running) => Answer::Ran(running.key, run(&running, is_over)),
            };
            if self.answers.send(answer).is_err() {
                return;
            }
        }
    }
}

fn run(running: &Running, is_over: &(dyn Fn() -> bool + Sync)) -> Ran {
    let is_over = || running.stop.load(Ordering::Relaxed) || is_over();
    let outcome = catch_unwind(AssertUnwindSafe(|| match running.is_given_up {
        true => Some(running.work.given_up(running.range.start)),
        false => running.work.run(running.range.clone(), &is_over),
    }));
    match outcome {
        Ok(Some(bytes)) => Ran::Done(bytes, running.is_given_up),
        Ok(None) => Ran::Stopped,
        Err(_) => Ran::Panicked,
    }
}
