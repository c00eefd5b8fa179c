//! What requests have changed, for a log of what is done from outside.

use super::answer::{Answer, Done};
use super::request::{FaultChange, ModeChange, Request};
use crate::refusal::Refusal;

/// Something that a request has changed, or was refused to change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// What was done: `write`, `press`, `force`, `unforce`, `stop`, `start`, `memory_reset`, `fault`, `fault_end`, `time`, `project`.
    pub what: &'static str,
    /// To what, as it was named.
    pub object: Option<String>,
    /// The value, as it was written; the kind of a start.
    pub value: Option<String>,
    /// The last scan before it, where it is known.
    pub scan: Option<u64>,
    /// The code of the problem for which it was refused.
    pub refused: Option<&'static str>,
}

/// Hears of changes, and of the peer that made them.
pub type Listener = Box<dyn Fn(&str, &[Change]) + Send + Sync>;

/// What a request changed, by its answer; nothing for one that only looks.
pub(super) fn of(request: &Request, answer: &Result<Answer, Refusal>) -> Vec<Change> {
    let refused = answer.as_ref().err().map(|refusal| refusal.problem.code());
    let one = |what, object: Option<&str>, value: Option<&str>| Change {
        what,
        object: object.map(str::to_owned),
        value: value.map(str::to_owned),
        scan: scan(answer),
        refused,
    };
    let items = |what, items: &mut dyn Iterator<Item = (&String, Option<&String>)>| -> Vec<Change> {
        let outcomes = match answer {
            Ok(Answer::Done(Done { items, .. })) => items.as_slice(),
            _ => &[],
        };
        let change = |(index, (object, value)): (usize, (&String, Option<&String>))| {
            let own = outcomes.get(index).and_then(|(_, outcome)| outcome.as_ref().err()).map(|refusal| refusal.problem.code());
            let change = one(what, Some(object), value.map(String::as_str));
            Change { refused: own.or(change.refused), ..change }
        };
        items.enumerate().map(change).collect()
    };
    let pairs = |what, values: &[(String, String)]| items(what, &mut values.iter().map(|(name, value)| (name, Some(value))));
    match request {
        Request::Write(values) => pairs("write", values),
        Request::Force(values) => pairs("force", values),
        Request::Press { items: names, .. } => items("press", &mut names.iter().map(|name| (name, None))),
        Request::Unforce(names) => items("unforce", &mut names.iter().map(|name| (name, None))),
        Request::UnforceAll => vec![one("unforce", None, None)],
        Request::Mode(ModeChange::Stop) => vec![one("stop", None, None)],
        Request::Mode(ModeChange::Run(restart)) => vec![one("start", None, Some(restart.word()))],
        Request::Mode(ModeChange::MemoryReset) => vec![one("memory_reset", None, None)],
        Request::Faults(FaultChange::Inject(fault)) => vec![one("fault", Some(fault), None)],
        Request::Faults(FaultChange::Mend(signal)) => vec![one("fault_end", Some(signal), None)],
        Request::Time(change) => vec![one("time", None, Some(&change.to_string()))],
        Request::Faults(FaultChange::None)
        | Request::State
        | Request::Read(_)
        | Request::Diagnostics { .. }
        | Request::Blocks { .. }
        | Request::Status { .. }
        | Request::Plants
        | Request::Listing { .. }
        | Request::Names { .. }
        | Request::Changes { .. } => Vec::new(),
    }
}

fn scan(answer: &Result<Answer, Refusal>) -> Option<u64> {
    match answer {
        Ok(Answer::Done(done)) => done.scan,
        Ok(Answer::Mode(mode)) => Some(mode.scans),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use sieben_model::problems::Problem;

    use super::*;

    fn pairs(values: &[(&str, &str)]) -> Vec<(String, String)> {
        values.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect()
    }

    #[test]
    fn each_item_has_its_own_outcome() {
        let request = Request::Write(pairs(&[("MW10", "5"), ("ACCU1", "x")]));
        let refusal = Refusal::new(Problem::P7004, "it does not fit");
        let done = Done { scan: Some(7), items: vec![("MW10".to_owned(), Ok(())), ("ACCU1".to_owned(), Err(refusal))] };
        let changes = of(&request, &Ok(Answer::Done(done)));
        let change = |object: &str, value: &str, refused| Change {
            what: "write",
            object: Some(object.to_owned()),
            value: Some(value.to_owned()),
            scan: Some(7),
            refused,
        };
        assert_eq!(changes, [change("MW10", "5", None), change("ACCU1", "x", Some("P7004"))]);
    }

    #[test]
    fn a_request_that_is_refused_as_a_whole_changed_nothing_and_one_that_looks_is_not_told() {
        let closed = || Err(Refusal::new(Problem::P7094, "the run is over"));
        let changes = of(&Request::Force(pairs(&[("Q0.0", "1")])), &closed());
        assert_eq!(changes.iter().map(|change| change.refused).collect::<Vec<_>>(), [Some("P7094")]);
        assert_eq!(of(&Request::Read(vec!["MW10".to_owned()]), &closed()), []);
        assert_eq!(of(&Request::State, &closed()), []);
    }
}
