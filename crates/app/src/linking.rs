//! Programs that a server changes while they run: a thread makes them ready, so that only the one who asked waits.

use std::io;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread::Builder;

use sieben_comm::s7comm::answer::Linker;
use sieben_cpu::{DataBlockChange, DataBlockInUse, Loaded};
use sieben_jit::StatusBits;

use crate::engines::EngineArgument;
use crate::panics;

/// Changes that wait for the thread; one more is refused. Each of them holds the values of its data blocks.
const CHANGES_MAX: usize = 8;

/// What comes of a change.
type Outcome = Result<Loaded, DataBlockInUse>;

/// A change, and where it goes when it is prepared.
type Change = (Arc<DataBlockChange>, Sender<Outcome>);

/// The thread, as long as this is there.
#[derive(Debug)]
pub(crate) struct Preparing(SyncSender<Change>);

impl Preparing {
    /// Starts the thread.
    pub(crate) fn start(engine: EngineArgument) -> io::Result<Self> {
        let (sender, changes) = sync_channel::<Change>(CHANGES_MAX);
        let work = move || {
            for (change, sender) in changes {
                // After a mistake of ours nothing is sent, which refuses the change.
                let outcome = panics::survive(|| {
                    Ok(Loaded::changed(&change, |program, layout| engine.at_once().load(program, layout, StatusBits::Needed)))
                });
                if let Ok(outcome) = outcome {
                    // The client may have given it up.
                    let _ = sender.send(outcome);
                }
            }
        };
        Builder::new().name("linking".to_owned()).spawn(work)?;
        Ok(Self(sender))
    }
}

impl Linker for Preparing {
    fn prepare(&self, change: Arc<DataBlockChange>) -> Receiver<Outcome> {
        let (sender, receiver) = channel();
        // A sender that is dropped with the change refuses it.
        let _ = self.0.try_send((change, sender));
        receiver
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::time::Duration;

    use sieben_cpu::{Cpu, Rack, Settings, undeclared};
    use sieben_engine::{Interpreter, Program};
    use sieben_model::cpu_type::CpuType;

    #[test]
    fn a_changed_program_takes_over_with_every_engine() {
        for engine in [EngineArgument::Auto, EngineArgument::Interpreter, EngineArgument::Jit, EngineArgument::Quick] {
            let cpu_type = &CpuType::ALL[0];
            let mut cpu =
                Cpu::load(cpu_type, Arc::new(Program::default()), Interpreter::load, Rack::simulated(cpu_type), Settings::default());
            let preparing = Preparing::start(engine).expect("a thread");
            let change = Arc::new(cpu.data_block_change(vec![undeclared(7, vec![1, 2])], BTreeSet::new()));
            let prepared = preparing.prepare(Arc::clone(&change));
            let loaded = prepared.recv_timeout(Duration::from_secs(60)).expect("it is prepared").expect("nothing is deleted");
            cpu.change_data_blocks(loaded, &change).expect("the program is the same");
            assert_eq!(sieben_cpu::Station::data_block_values(&cpu, 7), Some(vec![1, 2]));
        }
    }
}
