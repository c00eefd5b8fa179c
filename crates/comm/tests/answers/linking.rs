//! Linking and deleting of data blocks.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, PoisonError};

use sieben_comm::s7comm::answer::Linker;
use sieben_comm::s7comm::job::{BlockName, BlockPlace, BlockType, Job, Reply};
use sieben_comm::s7comm::wire::codes::Refusal;
use sieben_cpu::{DataBlockChange, DataBlockInUse, Loaded, OperatingMode, Restart};
use sieben_engine::Interpreter;

use crate::{Station, data, named};

fn done(reply: &Reply) -> bool {
    matches!(reply, Reply::Done)
}

fn both(number: u16) -> BlockName {
    named(BlockType::DataBlock, number, BlockPlace::Both)
}

#[test]
fn new_values_take_effect_when_they_are_linked_and_the_program_stays() {
    let mut station = Station::new();
    let program = Arc::clone(station.plant.cpu.program());
    assert!(done(&station.download(1, &[0, 50, 9, 9])));
    station.scan(10);
    assert_eq!(station.values(1), Some(vec![0, 7, 0x12, 0x34]), "a passive block has no effect");
    assert!(done(&station.perform(&Job::Link(vec![data(1)]))), "at once, without a linker");
    assert_eq!(station.values(1), Some(vec![0, 50, 9, 9]));
    assert!(Arc::ptr_eq(&program, station.plant.cpu.program()));
    station.scan(20);
    assert_eq!(station.values(1), Some(vec![0, 51, 9, 9]), "the program goes on with them");
    assert_eq!(station.refusal(&Job::Link(vec![data(1)])), Some(Refusal::BlockNotFound), "it is passive no longer");
    // An image that was uploaded goes back, also that of an instance, of a READ_ONLY and of an UNLINKED block.
    for number in [2, 3, 4, 5] {
        let mut image = station.image(data(number));
        image[37] ^= 0xFF;
        let values = image[36..image.len() - 43].to_vec();
        assert!(done(&station.ends(&crate::downloaded(data(number), image))));
        assert!(done(&station.perform(&Job::Link(vec![data(number)]))), "DB {number}");
        assert_eq!(station.values(number), Some(values));
    }
    station.plant.cpu.restart(Restart::Cold);
    assert_eq!(station.values(1), Some(vec![0, 50, 9, 9]), "they are in the load memory");
}

#[test]
fn new_and_longer_data_blocks_come_with_an_online_change() {
    let mut station = Station::new();
    let loaded = |station: &Station, number: u16| {
        let id = sieben_model::block::BlockId::db(number);
        sieben_cpu::Station::block(&station.plant.cpu, id).map(|view| view.loaded)
    };
    station.scan(10);
    assert!(done(&station.download(8, &[1, 2])));
    assert!(done(&station.download(7, &[9; 12])));
    assert!(matches!(station.perform(&Job::Link(vec![data(7), data(8)])), Reply::Later(_)));
    assert_eq!(station.values(8), None, "who gives it up has nothing of it");
    assert!(done(&station.ends(&Job::Link(vec![data(7), data(8)]))));
    assert_eq!((station.values(7), station.values(8)), (Some(vec![9; 12]), Some(vec![1, 2])));
    assert_eq!(station.values(1), Some(vec![0, 7, 0x12, 0x34]), "all other values stay");
    assert_eq!(station.plant.cpu.mode(), OperatingMode::Run);
    station.scan(20);
    assert_eq!(station.values(1), Some(vec![0, 8, 0x12, 0x34]));
    assert!(loaded(&station, 8) > loaded(&station, 1));
    // Another one later: those that came before keep what they have now.
    assert!(done(&station.download(8, &[3, 4])) && done(&station.ends(&Job::Link(vec![data(8)]))));
    assert!(done(&station.download(9, &[5, 6])) && done(&station.ends(&Job::Link(vec![data(9)]))));
    assert_eq!((station.values(8), station.values(7)), (Some(vec![3, 4]), Some(vec![9; 12])));
    station.plant.cpu.restart(Restart::Cold);
    assert_eq!((station.values(8), station.values(9)), (Some(vec![3, 4]), Some(vec![5, 6])));
}

#[test]
fn all_of_a_link_or_nothing_of_it() {
    let mut station = Station::new();
    assert!(done(&station.download(1, &[0, 50, 9, 9])));
    for (missing, refusal) in
        [(data(8), Refusal::BlockNotFound), (named(BlockType::Function, 1, BlockPlace::Passive), Refusal::BlockNotFound)]
    {
        assert_eq!(station.refusal(&Job::Link(vec![data(1), missing])), Some(refusal));
    }
    // An instance of another length does not fit its function block.
    assert!(done(&station.download(4, &[0; 4])));
    assert_eq!(station.refusal(&Job::Link(vec![data(1), data(4)])), Some(Refusal::InstanceMismatch));
    assert_eq!(station.values(1), Some(vec![0, 6, 0x12, 0x34]));
    // Without a linker there are new values and nothing else.
    station.around.linker = None;
    assert!(done(&station.download(8, &[1, 2])));
    assert_eq!(station.refusal(&Job::Link(vec![data(1), data(8)])), Some(Refusal::CannotPerform));
    assert_eq!(station.values(1), Some(vec![0, 6, 0x12, 0x34]));
    assert!(done(&station.perform(&Job::Link(vec![data(1), data(1)]))), "named twice is once");
    assert_eq!(station.values(1), Some(vec![0, 50, 9, 9]));
}

#[test]
fn data_blocks_come_only_as_long_as_the_load_memory_has_room() {
    let mut station = Station::new();
    let mut come = |numbers: std::ops::Range<u16>, bytes: usize| {
        for number in numbers.clone() {
            assert!(done(&station.download(number, &vec![0; bytes])));
        }
        station.refusal(&Job::Link(numbers.map(data).collect()))
    };
    // 8 MiB are 129 times 65,000 bytes, and no 130th time.
    assert_eq!([come(100..200, 65_000), come(200..229, 65_000)], [None; 2]);
    assert_eq!(come(229..230, 65_000), Some(Refusal::NoMemory));
    assert_eq!(come(228..229, 65_002), None, "in place of another one");
    assert_eq!(come(230..231, 2), None);
}

#[test]
fn blocks_are_deleted_unless_code_uses_them() {
    let mut station = Station::new();
    assert!(done(&station.download(7, &[1; 8])));
    assert!(done(&station.download(8, &[1, 2])));
    let delete = |names: &[BlockName]| Job::Delete(names.to_vec());
    for (names, refusal) in [
        (vec![both(1)], Refusal::BlockCoordination),
        (vec![both(7), both(4)], Refusal::BlockCoordination),
        (vec![both(9)], Refusal::BlockNotFound),
        (vec![both(7), both(9)], Refusal::BlockNotFound),
        (vec![data(2)], Refusal::BlockNotFound),
        (vec![named(BlockType::DataBlock, 8, BlockPlace::Active)], Refusal::BlockNotFound),
        (vec![named(BlockType::Function, 1, BlockPlace::Both)], Refusal::Protected),
    ] {
        assert_eq!(station.refusal(&delete(&names)), Some(refusal), "{names:?}");
    }
    assert!(station.values(7).is_some() && station.values(1).is_some());
    // The passive block of that number, then both.
    assert!(done(&station.perform(&delete(&[data(7)]))));
    assert_eq!((station.values(7), station.refusal(&Job::Link(vec![data(7)]))), (Some(vec![0; 8]), Some(Refusal::BlockNotFound)));
    assert!(done(&station.ends(&delete(&[both(7), both(7), both(8)]))));
    assert_eq!(station.values(7), None);
    assert_eq!(station.refusal(&delete(&[both(7)])), Some(Refusal::BlockNotFound));
    assert_eq!(station.refusal(&Job::Link(vec![data(8)])), Some(Refusal::BlockNotFound));
    station.scan(20);
    assert_eq!(station.values(1), Some(vec![0, 7, 0x12, 0x34]), "the program goes on");
}

#[test]
fn a_data_block_that_the_program_made_is_deleted_too() {
    let mut station = Station::with(
        "ORGANIZATION_BLOCK OB 1
         VAR_TEMP info : ARRAY [0..19] OF BYTE; END_VAR
         BEGIN
         CALL SFC 22 (LOW_LIMIT := W#16#A, UP_LIMIT := W#16#A, COUNT := W#16#6, RET_VAL := MW 0, DB_NUMBER := MW 2);
         END_ORGANIZATION_BLOCK",
    );
    assert_eq!(station.values(10), Some(vec![0; 6]));
    assert_eq!(station.image(both(10))[4], 8, "the language of a data block that the program made");
    assert!(done(&station.perform(&Job::Delete(vec![both(10)]))));
    assert_eq!(station.values(10), None);
    // The program makes it again, and a download takes its place.
    station.scan(10);
    assert!(done(&station.download(10, &[7; 6])) && done(&station.ends(&Job::Link(vec![data(10)]))));
    station.scan(20);
    assert_eq!(station.values(10), Some(vec![7; 6]));
}

/// Prepares when it is told to.
#[derive(Debug, Default)]
struct Slow(Mutex<Vec<Waiting>>);

/// A change and where its program goes.
type Waiting = (Arc<DataBlockChange>, Sender<Result<Loaded, DataBlockInUse>>);

impl Slow {
    fn finish(&self) {
        for (change, sender) in self.0.lock().unwrap_or_else(PoisonError::into_inner).drain(..) {
            let _ = sender.send(Loaded::changed(&change, Interpreter::load));
        }
    }
}

impl Linker for Slow {
    fn prepare(&self, change: Arc<DataBlockChange>) -> Receiver<Result<Loaded, DataBlockInUse>> {
        let (sender, receiver) = channel();
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push((change, sender));
        receiver
    }
}

#[test]
fn only_the_one_who_links_waits_and_another_program_is_not_undone() {
    let mut station = Station::new();
    let slow = Arc::new(Slow::default());
    station.around.linker = Some(Arc::clone(&slow) as Arc<dyn Linker>);
    let link = |station: &mut Station, number: u16| {
        assert!(done(&station.download(number, &[1, 2])));
        match station.perform(&Job::Link(vec![data(number)])) {
            Reply::Later(pending) => pending,
            reply => panic!("{reply:?}"),
        }
    };
    let mut first = link(&mut station, 20);
    let mut second = link(&mut station, 21);
    assert!(first.poll(&mut station.plant, &mut station.around).is_none());
    station.scan(10);
    slow.finish();
    // In the middle of a scan it waits.
    station.plant.cpu.stop_request().hold();
    station.scan(20);
    assert_eq!(station.plant.cpu.mode(), OperatingMode::Hold);
    assert!(first.poll(&mut station.plant, &mut station.around).is_none());
    station.plant.cpu.resume(30_000);
    assert!(first.poll(&mut station.plant, &mut station.around).is_some_and(|reply| done(&reply)));
    let reply = second.poll(&mut station.plant, &mut station.around);
    assert!(matches!(reply, Some(Reply::Refused(Refusal::BlockCoordination))), "{reply:?}");
    assert_eq!((station.values(20), station.values(21)), (Some(vec![1, 2]), None));
    // It is still there, and may be linked once more.
    let mut again = match station.perform(&Job::Link(vec![data(21)])) {
        Reply::Later(pending) => pending,
        reply => panic!("{reply:?}"),
    };
    slow.finish();
    assert!(again.poll(&mut station.plant, &mut station.around).is_some_and(|reply| done(&reply)));
    // A linker that fails leaves everything as it was.
    let mut failed = link(&mut station, 22);
    slow.0.lock().unwrap_or_else(PoisonError::into_inner).clear();
    let reply = failed.poll(&mut station.plant, &mut station.around);
    assert!(matches!(reply, Some(Reply::Refused(Refusal::CannotPerform))), "{reply:?}");
}
