//! Every instant at which a run can be killed or lose its power, and a disk that fails: what is kept is whole and new enough.

mod failing_disk;

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use failing_disk::FailingDisk;
use sieben_cpu::RetainImage;

use super::record::{self, Content, Record};
use super::retention::{Found, renumber};
use super::slots::{self, Contents, Slots, Sync};
use super::store::{Change, Kept, Store, synced_path};

const FILE: &str = "retain.bin";
/// Bytes by which a later record may be longer.
const ROOM: usize = 64;

/// An image that is like no other one: every byte depends on the scan.
fn image(scan: u64) -> RetainImage {
    let length = 90 + (scan % 4) as usize * 8;
    RetainImage { bytes: (0..length).map(|at| (scan * 37 + at as u64 * 11) as u8).collect(), layout: 5, scan }
}

fn record_of(sequence: u64) -> Vec<u8> {
    let mut bytes = Vec::new();
    record::write(&mut bytes, sequence, &image(sequence));
    bytes
}

fn newest(disk: &FailingDisk) -> Option<Record> {
    let found = Found::read(disk, Path::new(FILE), false).unwrap_or_else(|failure| panic!("{}", failure.refusal.message));
    found.newest().cloned()
}

/// The number of the newest record of one file.
fn newest_of(disk: &FailingDisk, path: &Path) -> Option<u64> {
    let bytes = super::disk::Disk::read(disk, path).ok()?;
    slots::read(&bytes).newest().map(|record| record.sequence)
}

/// How far a run came: the newest records that are safe from a kill and from a power failure, and the newest that was begun.
#[derive(Default)]
struct Reached {
    killed: u64,
    power: u64,
    begun: u64,
}

/// Two runs one after the other, seven scans each; every third scan the newest record goes to the disk.
fn two_runs(disk: &Arc<FailingDisk>) -> Reached {
    let mut reached = Reached::default();
    for run in 0..2 {
        let mut foreground = Kept::new(disk, Path::new(FILE), Sync::Never, ROOM);
        let mut background = Kept::new(disk, &synced_path(Path::new(FILE)), Sync::EveryWrite, ROOM);
        for scan in 1..=7 {
            let sequence = run * 7 + scan;
            reached.begun = sequence;
            if foreground.write(&record_of(sequence)).is_err() {
                return reached;
            }
            reached.killed = sequence;
            if scan % 3 == 0 {
                if background.write(&record_of(sequence)).is_err() {
                    return reached;
                }
                reached.power = sequence;
            }
        }
    }
    reached
}

/// What is found is one whole image that is at least as new as promised.
fn check(disk: &FailingDisk, at_least: u64, at_most: u64, what: &str) {
    let Some(found) = newest(disk) else {
        assert_eq!(at_least, 0, "{what}: nothing is left");
        return;
    };
    assert_eq!(found.image, image(found.sequence), "{what}: one whole scan's data");
    assert!((at_least..=at_most).contains(&found.sequence), "{what}: {} is not in {at_least}..={at_most}", found.sequence);
}

/// Small, and the same on every machine.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> bool {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 63 == 1
    }
}

#[test]
fn a_run_may_end_at_every_byte() {
    let mut steps = 0;
    loop {
        let disk = Arc::new(FailingDisk::default());
        disk.end_after(steps);
        let reached = two_runs(&disk);
        let what = format!("after {steps} steps");
        check(&disk.after_kill(), reached.killed, reached.begun, &format!("{what}, killed"));
        check(&disk.after_power_failure(&mut || false), reached.power, reached.begun, &format!("{what}, all that was not synced is gone"));
        for seed in 0..2 {
            let mut chance = Chance(steps * 2 + seed);
            let what = format!("{what}, power failure {seed}");
            check(&disk.after_power_failure(&mut || chance.next()), reached.power, reached.begun, &what);
        }
        if !disk.ended() {
            assert_eq!((reached.killed, reached.power), (14, 13), "the last run came to its end");
            break;
        }
        steps += 1;
    }
    assert!(steps > 1500, "{steps} steps");
}

#[test]
fn a_sync_in_every_scan_loses_at_most_that_scan() {
    let mut steps = 0;
    loop {
        let disk = Arc::new(FailingDisk::default());
        disk.end_after(steps);
        let mut store = Store::new(&disk, Path::new(FILE), Duration::ZERO, 0);
        let (mut safe, mut begun) = (0, 0);
        for scan in 1..=6 {
            begun = scan;
            if store.keep(Some(&image(scan)), Instant::now()).is_some() {
                break;
            }
            safe = scan;
        }
        check(&disk.after_kill(), safe, begun, "killed");
        let mut chance = Chance(steps);
        check(&disk.after_power_failure(&mut || chance.next()), safe, begun, "power failure");
        if !disk.ended() {
            assert_eq!(safe, 6);
            break;
        }
        steps += 1;
    }
    assert!(steps > 500, "{steps} steps");
}

#[test]
fn a_full_disk_is_told_once_and_tried_again() {
    let disk = Arc::new(FailingDisk::default());
    let mut store = Store::new(&disk, Path::new(FILE), Duration::ZERO, 0);
    let begin = Instant::now();
    let at = |ms: u64| begin + Duration::from_millis(ms);
    assert_eq!(store.keep(Some(&image(1)), at(0)), None);
    // Each write is cut at another byte.
    for (scan, room) in [(2, 0), (3, 10), (4, 60)] {
        disk.set_room(Some(room));
        let change = store.keep(Some(&image(scan)), at(scan * 2000));
        match scan {
            2 => assert!(matches!(change, Some(Change::Failed(why)) if why.contains("retain.bin.synced"))),
            _ => assert_eq!(change, None, "it is said once"),
        }
        assert_eq!(newest(&disk).map(|record| record.image), Some(image(1)), "what was kept stays");
    }
    disk.set_room(None);
    assert_eq!(store.keep(Some(&image(5)), at(8_100)), None, "not tried yet");
    assert_eq!(store.keep(None, at(8_999)), None);
    assert_eq!(store.keep(None, at(9_100)), Some(Change::Works), "tried again without a change of the data");
    assert_eq!(newest(&disk).map(|record| record.image), Some(image(5)));
    disk.set_sync_fails(true);
    assert!(matches!(store.keep(Some(&image(6)), at(10_000)), Some(Change::Failed(_))));
    assert!(store.keep(Some(&image(7)), at(12_000)).is_none());
    // What a failed sync may have lost was not written over the last good record.
    check(&disk.after_power_failure(&mut || false), 5, 5, "syncs fail");
    disk.set_sync_fails(false);
    assert_eq!(store.close(at(12_100)), Some(Change::Works), "the end of a run tries at once");
    check(&disk.after_power_failure(&mut || false), 7, 9, "the disk works again");
}

#[test]
fn a_file_that_could_not_be_made_is_made_later() {
    let disk = Arc::new(FailingDisk::default());
    disk.set_room(Some(5_000));
    let mut store = Store::new(&disk, Path::new(FILE), Duration::ZERO, 40);
    let begin = Instant::now();
    assert!(matches!(store.keep(Some(&image(1)), begin), Some(Change::Failed(_))));
    assert_eq!(newest(&disk), None);
    disk.set_room(None);
    assert_eq!(store.keep(None, begin + Duration::from_secs(1)), Some(Change::Works));
    assert_eq!(newest(&disk), Some(Record { sequence: 41, image: image(1) }), "sequences go on behind those of the last run");
}

#[test]
fn a_file_that_is_removed_is_made_again_with_what_is_known() {
    let disk = Arc::new(FailingDisk::default());
    let mut store = Store::new(&disk, Path::new(FILE), Duration::ZERO, 0);
    let synced = synced_path(Path::new(FILE));
    let begin = Instant::now();
    let at = |ms: u64| begin + Duration::from_millis(ms);
    assert_eq!(store.keep(Some(&image(1)), at(0)), None);
    disk.remove(&synced);
    assert_eq!(store.keep(None, at(900)), None, "it is not looked for yet");
    assert!(!disk.is_there(&synced));
    assert_eq!(store.keep(None, at(1_000)), Some(Change::MadeAgain(synced.clone())), "without a change of the data");
    assert_eq!(newest(&disk).map(|record| record.image), Some(image(1)));
    // On a full disk it is made as soon as there is room.
    disk.remove(&synced);
    disk.set_room(Some(100));
    assert!(matches!(store.keep(Some(&image(2)), at(2_100)), Some(Change::Failed(_))));
    assert!(!disk.is_there(&synced), "no part of a file");
    disk.set_room(None);
    assert_eq!(store.keep(None, at(3_200)), Some(Change::Works));
    assert_eq!(newest(&disk).map(|record| record.image), Some(image(2)));
    disk.remove(&synced);
    assert_eq!(store.close(at(3_300)), Some(Change::MadeAgain(synced.clone())), "the end of a run looks for it");
    assert!(disk.is_there(&synced));
}

#[test]
fn the_thread_makes_its_file_again_too() {
    let disk = Arc::new(FailingDisk::default());
    let mut store = Store::new(&disk, Path::new(FILE), Duration::from_secs(3600), 0);
    assert_eq!(store.keep(Some(&image(1)), Instant::now()), None);
    assert_eq!(store.close(Instant::now()), None);
    let mut store = Store::new(&disk, Path::new(FILE), Duration::from_millis(1), 1);
    let synced = synced_path(Path::new(FILE));
    assert_eq!(store.keep(Some(&image(2)), Instant::now()), None);
    let deadline = Instant::now() + Duration::from_secs(20);
    let until = |done: &mut dyn FnMut() -> bool| {
        while !done() {
            assert!(Instant::now() < deadline, "the thread writes");
            std::thread::yield_now();
        }
    };
    until(&mut || newest_of(&disk, &synced) == Some(2));
    disk.remove(&synced);
    until(&mut || disk.is_there(&synced));
    let mut told = None;
    until(&mut || {
        told = told.take().or_else(|| store.keep(None, Instant::now()));
        told.is_some()
    });
    assert_eq!(told, Some(Change::MadeAgain(synced)));
}

#[test]
fn great_numbers_begin_anew_in_both_files() {
    let disk = FailingDisk::default();
    let path = Path::new(FILE);
    for (file, sequence) in [(path.to_path_buf(), u64::MAX), (synced_path(path), u64::MAX - 5)] {
        let mut bytes = Vec::new();
        record::write(&mut bytes, sequence, &image(3));
        Slots::create(&disk, &file, 0, &bytes).expect("the disk has room");
    }
    let found = newest(&disk).expect("a record");
    assert_eq!(renumber(&disk, path, Some(&found)).expect("the disk has room"), 1);
    assert_eq!(newest(&disk), Some(Record { sequence: 1, image: found.image }));
    assert_eq!(renumber(&disk, path, None).expect("the disk has room"), 1);
    assert_eq!(newest(&disk), None);
}

#[test]
fn the_thread_brings_the_last_record_to_the_disk_before_it_ends() {
    let disk = Arc::new(FailingDisk::default());
    let mut store = Store::new(&disk, Path::new(FILE), Duration::from_secs(3600), 0);
    for scan in 1..=5 {
        assert_eq!(store.keep(Some(&image(scan)), Instant::now()), None);
    }
    let before = disk.after_power_failure(&mut || false);
    // Making the first file syncs it; nothing else was synced within the hour.
    check(&before, 1, 1, "before the end");
    assert_eq!(store.close(Instant::now()), None);
    check(&disk.after_power_failure(&mut || false), 5, 5, "after the end");
    disk.set_sync_fails(true);
    let mut failing = Store::new(&disk, Path::new(FILE), Duration::from_secs(3600), 5);
    assert!(matches!(failing.keep(Some(&image(6)), Instant::now()), Some(Change::Failed(_))), "no file can be made");
    disk.set_sync_fails(false);
    assert_eq!(failing.keep(None, Instant::now() + Duration::from_secs(2)), Some(Change::Works));
    disk.set_sync_fails(true);
    assert!(matches!(failing.close(Instant::now()), Some(Change::Failed(_))));
}

#[test]
fn a_larger_image_gets_a_larger_file() {
    let disk = Arc::new(FailingDisk::default());
    let mut store = Store::new(&disk, Path::new(FILE), Duration::ZERO, 0);
    let large = |scan| RetainImage { bytes: vec![scan as u8; 200_000], layout: 5, scan };
    for (scan, image) in [(1, image(1)), (2, large(2)), (3, large(3)), (4, image(4))] {
        assert_eq!(store.keep(Some(&image), Instant::now()), None);
        assert_eq!(newest(&disk), Some(Record { sequence: scan, image }));
    }
}

#[test]
fn a_damaged_slot_leaves_the_other_one() {
    let path = Path::new(FILE);
    let disk = FailingDisk::default();
    let mut file = Slots::create(&disk, path, 0, &record_of(1)).expect("the disk has room");
    file.write(&record_of(5), Sync::Never).expect("the disk has room");
    let length = record_of(5).len();
    for at in 0..length {
        let damaged = disk.after_kill();
        damaged.damage(path, 8192 + at);
        let found = Found::read(&damaged, path, false).unwrap_or_else(|failure| panic!("{}", failure.refusal.message));
        assert_eq!(found.newest().map(|record| record.sequence), Some(1), "byte {at}");
        damaged.damage(path, 4096 + at);
        let found = Found::read(&damaged, path, false).unwrap_or_else(|failure| panic!("{}", failure.refusal.message));
        assert_eq!(found.newest(), None, "byte {at} of both");
    }
    for at in 0..28 {
        let damaged = disk.after_kill();
        damaged.damage(path, at);
        let bytes = super::disk::Disk::read(&damaged, path).expect("the file is there");
        assert_eq!(slots::read(&bytes), Contents::Foreign, "byte {at} of the head");
        assert!(Found::read(&damaged, path, true).is_err(), "a file that the user named is not written over");
    }
}

#[test]
fn no_bytes_are_a_mistake_of_ours() {
    let disk = FailingDisk::default();
    Slots::create(&disk, Path::new(FILE), 0, &record_of(1)).expect("the disk has room");
    let bytes = super::disk::Disk::read(&disk, Path::new(FILE)).expect("the file is there");
    for cut in (0..bytes.len()).step_by(7) {
        let contents = slots::read(&bytes[..cut]);
        assert!(contents.newest().is_none_or(|record| record.image == image(1)));
    }
    assert_eq!(record::read(&[]), Content::Empty);
    assert_eq!(record::read(&[0; 40]), Content::Empty);
    assert_eq!(record::read(&[0xFF; 40]), Content::Damaged);
}
