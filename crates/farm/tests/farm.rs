//! Campaigns over a real server, with real processes that are killed, stopped and lied to.

mod server;

use std::time::Duration;

use server::{Nats, Trial, is_there};

fn pause(milliseconds: u64) {
    std::thread::sleep(Duration::from_millis(milliseconds));
}

/// What a run that lost and doubled nothing says.
fn is_right(said: &str) {
    assert!(said.contains("whole=true sum=right") && said.contains("differing=0"), "{said}");
}

fn number(said: &str, name: &str) -> u64 {
    let word = said.split_whitespace().find_map(|word| word.strip_prefix(name)).unwrap_or_else(|| panic!("no {name} in {said}"));
    word.parse().unwrap_or_else(|_| panic!("{name} is no number in {said}"))
}

#[test]
fn a_campaign_ends_with_its_sum_and_leaves_nothing_on_the_server() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let workers: Vec<Trial> = (0..3).map(|_| nats.trial("work", "threads=2 idle=3000")).collect();
    let said = nats.trial("run", "id=a1 count=2000 range=10 us=100").ends();
    is_right(&said);
    assert_eq!((number(&said, "results="), number(&said, "duplicates="), number(&said, "sent_again=")), (200, 0, 0), "{said}");
    assert!(said.contains("removed=true") && number(&said, "workers=") == 3, "{said}");
    assert_eq!(nats.streams(), Vec::<String>::new());
    let ranges: u64 = workers.into_iter().map(|worker| number(&worker.ends(), "ranges=")).sum();
    // A worker that hears of the end may not have counted its last one.
    assert!((194..=200).contains(&ranges), "{ranges}");
}

#[test]
fn killed_workers_and_servers_lose_and_double_nothing() {
    if !is_there() {
        return;
    }
    let mut nats = Nats::start();
    let run = nats.trial("run", "id=b2 count=3000 range=10 us=2000");
    let mut workers: Vec<Trial> = (0..3).map(|_| nats.trial("work", "threads=2")).collect();
    for round in 0..6 {
        pause(300);
        let index = round % workers.len();
        workers[index].kill();
        workers[index] = nats.trial("work", "threads=2");
        if round % 3 == 1 {
            nats.kill();
            pause(100);
            nats.again();
        }
    }
    is_right(&run.ends());
}

#[test]
fn a_worker_that_slept_past_its_lease_changes_nothing() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let run = nats.trial("run", "id=c3 count=400 range=10 us=5000 lease=600");
    let sleeper = nats.trial("work", "threads=2");
    pause(400);
    sleeper.signal("STOP");
    let worker = nats.trial("work", "threads=2");
    pause(1_500);
    sleeper.signal("CONT");
    is_right(&run.ends());
    drop((sleeper, worker));
}

#[test]
fn a_store_that_is_deleted_is_made_again() {
    if !is_there() {
        return;
    }
    let mut nats = Nats::start();
    let run = nats.trial("run", "id=d4 count=1500 range=10 us=2000");
    let workers: Vec<Trial> = (0..2).map(|_| nats.trial("work", "threads=2")).collect();
    pause(700);
    nats.kill();
    nats.lose_store();
    nats.again();
    let said = run.ends();
    is_right(&said);
    assert!(number(&said, "rebuilt=") >= 1, "{said}");
    drop(workers);
}

#[test]
fn a_full_queue_slows_the_run_down_and_loses_nothing() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let run = nats.trial("run", "id=e5 count=600 range=10 us=500 queue=5");
    let worker = nats.trial("work", "threads=4");
    is_right(&run.ends());
    drop(worker);
}

#[test]
fn a_run_that_was_killed_finds_what_came_in_the_meantime() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let words = format!("id=f6 count=1000 range=10 us=2000 book={}", nats.folder.join("book").display());
    let worker = nats.trial("work", "threads=4");
    let mut run = nats.trial("run", &words);
    pause(900);
    run.kill();
    pause(500);
    let said = nats.trial("run", &words).ends();
    is_right(&said);
    assert!(number(&said, "kept=") > 0 && said.contains("removed=true"), "{said}");
    drop(worker);
}

#[test]
fn a_stranger_who_lies_is_an_alarm_and_not_a_wrong_count() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let run = nats.trial("run", "id=a7 count=1000 range=10 us=2000");
    let worker = nats.trial("work", "threads=4");
    pause(700);
    assert!(nats.trial("lie", "id=a7").ends().contains("lied"));
    let said = run.ends();
    // Which of the two lies is not known, not even to the ledger; that they differ is.
    assert!(said.contains("whole=true") && number(&said, "results=") == 100 && number(&said, "differing=") == 1, "{said}");
    assert!(number(&said, "unreadable=") >= 5, "{said}");
    drop(worker);
}

#[test]
fn a_scenario_that_kills_its_workers_is_given_up_and_all_others_are_run() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let run = nats.trial("run", "id=b8 count=40 range=4 us=1000 poison=17 lease=300");
    let mut worker = nats.trial("work", "threads=1");
    let mut run = Some(run);
    while !run.as_mut().expect("the run").has_ended() {
        if worker.has_ended() {
            worker = nats.trial("work", "threads=1");
        }
        pause(20);
    }
    let said = run.take().expect("the run").ends();
    is_right(&said);
    assert_eq!(number(&said, "given_up="), 1, "{said}");
}

#[test]
fn results_that_are_too_large_for_a_message_come_as_objects() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let worker = nats.trial("work", "threads=2");
    let said = nats.trial("run", "id=c9 count=60 range=10 pad=1500000 bundle=3000000").ends();
    is_right(&said);
    assert_eq!(number(&said, "results="), 6, "{said}");
    drop(worker);
}

#[test]
fn a_run_that_has_enough_ends_the_work_of_all() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let worker = nats.trial("work", "threads=2 id=da idle=1500");
    let said = nats.trial("run", "id=da count=100000 range=10 us=500 enough=20").ends();
    assert!(said.contains("whole=false") && said.contains("removed=true"), "{said}");
    assert!(worker.ends().contains("campaigns=1"));
    assert_eq!(nats.streams(), Vec::<String>::new());
}

#[test]
fn a_worker_that_ends_gives_back_what_it_has_not_begun() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let stop = nats.folder.join("stop");
    let run = nats.trial("run", "id=eb count=60 range=1 us=50000 lease=30000");
    let leaving = nats.trial("work", &format!("threads=4 stop={}", stop.display()));
    pause(700);
    std::fs::write(&stop, "").expect("a file");
    assert!(leaving.ends().contains("ranges="));
    let worker = nats.trial("work", "threads=4");
    // With a lease of 30 s this ends in time only if nothing is held by the one that left.
    is_right(&run.ends());
    drop(worker);
}

#[test]
fn a_worker_takes_one_campaign_after_another() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let worker = nats.trial("work", "threads=2 idle=2500");
    let first = nats.trial("run", "id=1c count=200 range=10 us=500");
    let second = nats.trial("run", "id=2c count=300 range=10 us=500");
    is_right(&first.ends());
    is_right(&second.ends());
    let said = worker.ends();
    assert!(said.contains("campaign 1c: at work") && said.contains("campaign 2c: at work"), "{said}");
}

#[test]
fn a_second_run_of_the_same_campaign_leaves() {
    if !is_there() {
        return;
    }
    let nats = Nats::start();
    let first = nats.trial("run", "id=3d count=400 range=10 us=5000");
    let worker = nats.trial("work", "threads=2");
    pause(1_000);
    let said = nats.trial("run", "id=3d count=400 range=10 us=5000").ends();
    assert!(said.starts_with("P7167 another run of this campaign is at work"), "{said}");
    is_right(&first.ends());
    drop(worker);
}
