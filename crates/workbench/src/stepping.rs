//! Steps through scans of the past, by statements and by networks.

use std::sync::Arc;

use serde_json::json;
use sieben_engine::{FaultPlace, Machine, StatementEvent, Tracer};
use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_workspace::Refusal;
use sieben_workspace::control::{Control, parse};
use sieben_workspace::past::Viewer;
use sieben_workspace::status::Instances;

use crate::hub::Hub;
use crate::live::message::Unit;
use crate::live::program::Known;
use crate::live::wanted::Wanted;
use crate::moment::{Moment, is_counted};
use crate::past::not_kept;

/// Statements or networks that one message steps over at most.
const STEPS_MAX: u64 = 1_000;

/// Finds where the steps before and after a moment of a scan end.
struct Search<'s> {
    wanted: &'s Wanted,
    program: &'s Known,
    unit: Unit,
    /// Statements that have run at the moment.
    from: u64,
    instances: Instances,
    count: u64,
    /// The statement that was counted last, and the network in which it stands.
    last: Option<(u64, (BlockId, Option<u32>))>,
    before: Option<u64>,
    after: Option<u64>,
}

impl Search<'_> {
    fn stop(&mut self, at: u64) {
        if at < self.from {
            self.before = Some(at);
        } else if at > self.from {
            self.after.get_or_insert(at);
        }
    }
}

impl Tracer for Search<'_> {
    fn pauses_before(&mut self, machine: &Machine, _: FaultPlace) -> bool {
        self.instances.before(machine);
        false
    }

    fn statement(&mut self, _: &Machine, event: &StatementEvent) {
        self.count += 1;
        if !self.program.is_written(event.place) || !is_counted(self.wanted, self.instances.calls(event.place.block)) {
            return;
        }
        let network = if self.unit == Unit::Network { self.program.network(event.place) } else { None };
        let now = (event.place.block, network);
        if let Some((at, last)) = self.last.replace((self.count, now))
            && (self.unit == Unit::Statement || last != now)
        {
            self.stop(at);
        }
    }
}

/// What is stepped through: by what, and in which blocks.
struct Steps<'s> {
    hub: &'s Hub,
    program: &'s Known,
    wanted: &'s Wanted,
    unit: Unit,
}

impl Steps<'_> {
    /// The ends of the steps before and after a moment of its scan.
    fn around(&self, viewer: &mut Viewer, moment: Moment) -> Result<(Option<u64>, Option<u64>), Refusal> {
        let mut search = Search {
            wanted: self.wanted,
            program: self.program,
            unit: self.unit,
            from: moment.statements.unwrap_or(u64::MAX),
            instances: Instances::default(),
            count: 0,
            last: None,
            before: None,
            after: None,
        };
        viewer.traced(self.hub.desk.past(), moment.scan, &mut search).map_err(not_kept)?;
        if let Some((at, _)) = search.last {
            search.stop(at);
        }
        Ok((search.before, search.after))
    }

    /// One step back: after the first step of a scan comes the end of the scan before.
    ///
    /// # Errors
    /// There is nothing before that is kept.
    fn back(&self, viewer: &mut Viewer, from: Moment) -> Result<Moment, Refusal> {
        let (before, _) = self.around(viewer, from)?;
        if before.is_some() {
            return Ok(Moment { statements: before, ..from });
        }
        let oldest = self.hub.desk.past().range().map_or(0, |(oldest, _)| oldest.scan);
        let scan = from.scan.checked_sub(1).filter(|&scan| scan >= oldest);
        let scan =
            scan.ok_or_else(|| Refusal::new(Problem::P7139, "this is the oldest scan that is kept; nothing is known of what came before"))?;
        Ok(Moment { scan, statements: None })
    }

    /// One step on: after the last step of a scan comes its end, then the first step of the next scan; `None` if that has not run yet.
    ///
    /// # Errors
    /// The scan is not kept.
    fn on(&self, viewer: &mut Viewer, from: Moment) -> Result<Option<Moment>, Refusal> {
        if from.statements.is_some() {
            let (_, after) = self.around(viewer, from)?;
            return Ok(Some(Moment { statements: after, ..from }));
        }
        let newest = self.hub.desk.past().range().map_or(0, |(_, newest)| newest.scan);
        let Some(scan) = from.scan.checked_add(1).filter(|&scan| scan <= newest) else { return Ok(None) };
        let begin = Moment { scan, statements: Some(0) };
        let (_, after) = self.around(viewer, begin)?;
        Ok(Some(Moment { statements: after, ..begin }))
    }
}

/// Where a page stands, which scan it is shown as the newest, and who lets the CPU run, if that may be.
type Standing = (Option<Moment>, u64, Option<String>);

/// Where so many steps lead; `None` is the newest scan from then on.
///
/// # Errors
/// They lead to where nothing is kept, or the page may not let the CPU run.
pub(crate) fn step(
    hub: &Hub,
    viewer: &mut Viewer,
    (from, shown, runs): Standing,
    (wanted, unit, steps): (&Wanted, Unit, i64),
) -> Result<Option<Moment>, Refusal> {
    let end_of = |scan| Moment { scan, statements: None };
    let is_paused = hub.gate.look(|plant| plant.pace.is_paused())?;
    let newest = hub.gate.look(|plant| plant.scans)?.max(shown);
    if unit == Unit::Scan {
        // While time goes on others have run since the one that the page shows.
        let scan = from.map_or(if is_paused { newest } else { shown }, |from| from.scan);
        let to = scan.saturating_add_signed(steps);
        let more = to.saturating_sub(newest);
        if is_paused && more > 0 {
            run(hub, more, runs.as_deref())?;
        }
        return Ok((to < newest).then(|| end_of(to)));
    }
    let program = hub.program();
    let all = Steps { hub, program: &program, wanted, unit };
    // While time goes on the newest scan is stepped through from its beginning.
    let begin = if steps > 0 && !is_paused { newest.saturating_sub(1) } else { newest };
    let mut at = from.unwrap_or_else(|| end_of(begin));
    for _ in 0..steps.unsigned_abs().min(STEPS_MAX) {
        at = match steps > 0 {
            false => all.back(viewer, at)?,
            true => match all.on(viewer, at)? {
                Some(next) => next,
                None if is_paused => {
                    run(hub, 1, runs.as_deref())?;
                    let next = all.on(viewer, at)?;
                    next.ok_or_else(|| Refusal::new(Problem::P7139, "the CPU has run no scan: it is in STOP"))?
                }
                None => return Ok(None),
            },
        };
    }
    let newest = hub.gate.look(|plant| plant.scans)?;
    Ok(Some(at).filter(|at| at.statements.is_some() || at.scan < newest))
}

/// Lets a CPU whose time stands still run scans.
fn run(hub: &Hub, scans: u64, peer: Option<&str>) -> Result<(), Refusal> {
    let Some(peer) = peer else {
        return Err(Refusal::new(Problem::P7133, "the token of this page is for looking; letting the CPU run a scan takes the other one"));
    };
    let (_, request) = parse(json!({ "verb": "time", "time": "step", "scans": scans }).to_string().as_bytes());
    Control::of_peer(Arc::clone(&hub.facts), peer.to_owned()).answer(&hub.gate, &hub.desk, &request?).map(drop)
}
