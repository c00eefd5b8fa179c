//! What a CPU with a real program answers to jobs: identity, blocks and control.

mod blocks;
mod control;
mod linking;

use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};

use sieben_comm::s7comm::answer::{Linker, Surroundings, perform};
use sieben_comm::s7comm::job::{BlockName, BlockPlace, BlockType, Download, Job, Reply};
use sieben_comm::s7comm::wire::codes::Refusal;
use sieben_cpu::{DataBlockChange, DataBlockInUse, Loaded, Requester, Restart, Settings};
use sieben_engine::Interpreter;
use sieben_workspace::controller;
use sieben_workspace::project::{Overrides, Project};
use sieben_workspace::{Pace, Plant, Speed};

/// DB 1 is counted in, DB 2 is READ_ONLY, DB 3 NON_RETAIN, DB 4 an instance, DB 5 UNLINKED, DB 7 named by nothing.
const PROGRAM: &str = "
FUNCTION FC 1 : VOID
TITLE = one
AUTHOR : Meyer
FAMILY : pumps
NAME : adder
VERSION : 2.3
VAR_TEMP n : INT; END_VAR
BEGIN
L DB1.n; L 1; +I; T DB1.n;
END_FUNCTION
FUNCTION_BLOCK FB 1
KNOW_HOW_PROTECT
VAR count : INT; END_VAR
BEGIN
L #count; L 1; +I; T #count;
END_FUNCTION_BLOCK
DATA_BLOCK DB 1
AUTHOR : Meyer
STRUCT n : INT := 5; w : WORD := W#16#1234; END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 2
READ_ONLY
STRUCT w : WORD := W#16#2222; END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 3
NON_RETAIN
STRUCT w : WORD := W#16#3333; END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 4 FB 1
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 5
UNLINKED
STRUCT w : WORD := W#16#5555; END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 7
STRUCT w : ARRAY [1..4] OF WORD; END_STRUCT
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
BEGIN
UC FC 1;
CALL FB 1, DB 4;
END_ORGANIZATION_BLOCK
";

/// A CPU with the program after one scan, and what its server has.
struct Station {
    plant: Plant,
    around: Surroundings,
}

impl Station {
    fn new() -> Self {
        Self::with(PROGRAM)
    }

    fn with(text: &str) -> Self {
        let mut project = Project::default();
        project.add_source(Path::new("main.awl"), text.as_bytes());
        let build = project.compile(Overrides::default(), false);
        assert!(!sieben_workspace::finding::has_errors(&build.findings), "{:?}", build.findings);
        let cpu = controller::load(&build, Interpreter::load, Settings::default());
        let mut plant = Plant::new(cpu, Pace::new(Speed::Max, 10_000, u64::MAX, 0));
        plant.cpu.restart(Restart::Warm);
        plant.cpu.scan(0);
        Self { plant, around: Surroundings { linker: Some(Arc::new(AtOnce)), ..Surroundings::default() } }
    }

    fn perform(&mut self, job: &Job) -> Reply {
        perform(job, &mut self.plant, &mut self.around, Requester::default())
    }

    /// What a job comes to, with all that has to be waited for.
    fn ends(&mut self, job: &Job) -> Reply {
        match self.perform(job) {
            Reply::Later(mut pending) => pending.poll(&mut self.plant, &mut self.around).expect("everything is ready at once"),
            reply => reply,
        }
    }

    fn refusal(&mut self, job: &Job) -> Option<Refusal> {
        match self.ends(job) {
            Reply::Refused(refusal) => Some(refusal),
            _ => None,
        }
    }

    fn scan(&mut self, at_ms: u64) {
        self.plant.cpu.scan(at_ms * 1000);
    }

    /// The values of a data block.
    fn values(&self, number: u16) -> Option<Vec<u8>> {
        sieben_cpu::Station::data_block_values(&self.plant.cpu, number)
    }

    fn image(&mut self, name: BlockName) -> Vec<u8> {
        match self.ends(&Job::Upload(name)) {
            Reply::Image(image) => image,
            reply => panic!("{name:?}: {reply:?}"),
        }
    }

    /// Downloads the image of a data block with these values.
    fn download(&mut self, number: u16, values: &[u8]) -> Reply {
        self.ends(&downloaded(data(number), image(number, values)))
    }
}

/// Prepares a change while it is asked to.
#[derive(Debug)]
struct AtOnce;

impl Linker for AtOnce {
    fn prepare(&self, change: Arc<DataBlockChange>) -> Receiver<Result<Loaded, DataBlockInUse>> {
        let (sender, receiver) = channel();
        let _ = sender.send(Loaded::changed(&change, Interpreter::load));
        receiver
    }
}

fn named(block_type: BlockType, number: u16, place: BlockPlace) -> BlockName {
    BlockName { block_type, number, place }
}

fn data(number: u16) -> BlockName {
    named(BlockType::DataBlock, number, BlockPlace::Passive)
}

fn downloaded(name: BlockName, image: Vec<u8>) -> Job {
    let load_bytes = image.len() as u32;
    Job::Download(Download { name, image, load_bytes, code_bytes: 0 })
}

/// The image of a data block as a programming device writes it: with a time, an author and three bytes of interface.
fn image(number: u16, values: &[u8]) -> Vec<u8> {
    let [number, bytes] = [number, values.len() as u16].map(u16::to_be_bytes);
    let load = (36 + values.len() as u32 + 3 + 36).to_be_bytes();
    [
        &b"pp\x01\x01\x05\x0A"[..],
        &number,
        &load,
        &[0; 4],
        &[0, 0, 1, 0, 0x20, 0],
        &[0, 0, 1, 0, 0x20, 0],
        &[0, 3, 0, 0, 0, 0],
        &bytes,
        values,
        &[5, 0, 0],
        b"Schmidt\0recipes\0data\0\0\0\0",
        &[0x11, 0, 0, 0],
        &[0; 8],
    ]
    .concat()
}
