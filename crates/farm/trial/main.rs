//! The processes of the tests: a run, a worker and a hostile stranger, whose scenarios are numbers that are added up.
#![forbid(unsafe_code)]

mod sums;

use std::collections::HashMap;
use std::io::Write;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;

use sieben_farm::{Announced, FarmError, Ledger, Offer, Options, Server, Work, WorkerOrders};
use sums::{Book, Sums};

/// Arguments of the form `name=value`.
struct Words(HashMap<String, String>);

impl Words {
    fn text(&self, name: &str) -> Option<String> {
        self.0.get(name).cloned()
    }

    fn number(&self, name: &str, default: u64) -> u64 {
        self.0.get(name).map_or(default, |value| value.parse().unwrap_or_else(|_| panic!("{name} is a number")))
    }

    fn time(&self, name: &str, default: u64) -> Duration {
        Duration::from_millis(self.number(name, default))
    }

    fn server(&self) -> Server {
        let path = |name: &str| self.text(name).map(PathBuf::from);
        Server { url: self.text("url").expect("a url"), credentials: path("creds"), authority: path("ca") }
    }

    fn options(&self) -> Options {
        Options {
            lease: self.time("lease", 1_500),
            sweep: self.time("sweep", 1_500),
            patience: self.time("patience", 60_000),
            arrival: self.time("arrival", 5_000),
            beat: self.time("beat", 200),
            queue: self.number("queue", 100_000),
        }
    }

    fn meaning(&self) -> u32 {
        u32::try_from(self.number("meaning", 1)).expect("a version")
    }
}

fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let verb = arguments.next().unwrap_or_default();
    let words = arguments.map(|word| {
        let (name, value) = word.split_once('=').expect("name=value");
        (name.to_owned(), value.to_owned())
    });
    let words = Words(words.collect());
    let outcome = match verb.as_str() {
        "run" => run(&words),
        "work" => work(&words),
        "ready" => sieben_farm::ready(&words.server()).map(|()| "ready".to_owned()),
        "lie" => lie(&words),
        _ => panic!("run, work, ready or lie"),
    };
    match outcome {
        Ok(line) => {
            say(&line);
            ExitCode::SUCCESS
        }
        Err(error) => {
            say(&format!("{} {error}", error.problem().code()));
            ExitCode::FAILURE
        }
    }
}

fn run(words: &Words) -> Result<String, FarmError> {
    let bundle = format!(
        "us={} pad={} poison={} {}",
        words.number("us", 0),
        words.number("pad", 0),
        words.text("poison").unwrap_or_default(),
        "x".repeat(usize::try_from(words.number("bundle", 0)).expect("a size"))
    );
    let announced = Announced { campaign: words.text("id").expect("an identity"), meaning: words.meaning(), bundle: bundle.into() };
    let mut book = Book::open(
        words.number("count", 1_000),
        words.number("range", 10),
        words.number("enough", u64::MAX),
        words.text("book").as_deref().map(Path::new),
    );
    let mut most = 0;
    let finished =
        sieben_farm::run(&words.server(), &words.options(), &announced, &mut book, &mut |workers| most = most.max(workers.alive))?;
    Ok(format!(
        "whole={} sum={} results={} duplicates={} differing={} unreadable={} sent_again={} rebuilt={} given_up={} removed={} workers={most} kept={}",
        book.is_whole(),
        book.sum(),
        finished.results,
        finished.duplicates,
        finished.differing,
        finished.unreadable,
        finished.sent_again,
        finished.rebuilt,
        finished.given_up,
        finished.is_removed,
        book.kept(),
    ))
}

fn work(words: &Words) -> Result<String, FarmError> {
    let orders = WorkerOrders {
        threads: NonZeroUsize::new(usize::try_from(words.number("threads", 1)).expect("a number")).expect("a thread"),
        campaign: words.text("id"),
        idle_exit: words.text("idle").map(|_| words.time("idle", 0)),
        meaning: words.meaning(),
        name: format!("trial-{}", std::process::id()),
    };
    let open = |offer: &Offer| -> Result<Arc<dyn Work>, String> { Ok(Arc::new(Sums::read(&offer.bundle)?)) };
    let stop = words.text("stop");
    let is_over = move || stop.as_deref().is_some_and(|path| Path::new(path).exists());
    let done = sieben_farm::work(&words.server(), &words.options(), &orders, &open, &is_over, &mut |news| say(&format!("{news}")))?;
    Ok(format!("campaigns={} ranges={} split={} given_up={}", done.campaigns, done.ranges, done.split, done.given_up))
}

/// Sends what no honest worker sends, by a client of its own.
fn lie(words: &Words) -> Result<String, FarmError> {
    let (url, id) = (words.text("url").expect("a url"), words.text("id").expect("an identity"));
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().expect("a runtime");
    runtime.block_on(async {
        let client = async_nats::connect(url).await.expect("a server");
        let (result, job) = (format!("sieben.{id}.result"), format!("sieben.{id}.job"));
        for payload in
            ["", "result", "result 0 18446744073709551615 x evil object 99999999999999 aa\n", "\u{0}\u{0}", "result 5 4 x evil whole\n"]
        {
            client.publish(result.clone(), payload.into()).await.expect("sent");
        }
        let large = format!("result 0 10 x evil object {} {}\n", u64::MAX, "a".repeat(64));
        client.publish(result.clone(), large.into()).await.expect("sent");
        for payload in ["", "9 8 x", "no job", "0 18446744073709551615 x y z"] {
            client.publish(job.clone(), payload.into()).await.expect("sent");
        }
        client.publish(format!("sieben.{id}.alive"), "a b c d".into()).await.expect("sent");
        client.publish(format!("sieben.{id}.state"), "nonsense".into()).await.expect("sent");
        client.publish(result, "result 0 10 x evil whole\nnot what others say".into()).await.expect("sent");
        client.flush().await.expect("sent");
    });
    Ok("lied".to_owned())
}
