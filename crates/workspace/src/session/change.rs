//! Another program takes over in a session: what the user had asked for is looked up again in it, by its words.

use std::sync::Arc;

use sieben_cpu::{Loaded, OnlineChange};
use sieben_model::block::BlockId;
use sieben_sim::history::{Breakpoint, ChangeError, Condition, Target};
use sieben_sim::names::{Name, NameError, Setting};

use super::Session;
use crate::project::Build;

/// What a breakpoint waits for, in the words of the user.
#[derive(Clone, Debug)]
pub(super) enum Wanted {
    /// A place that means the same wherever the run stands.
    Place(String),
    /// A value that is written.
    Write(String),
    /// A value that changes.
    Change(String),
    /// A condition.
    Condition(String),
}

/// How a breakpoint was asked for.
#[derive(Clone, Debug)]
pub(super) struct Request {
    /// What it waits for.
    pub(super) wanted: Wanted,
    /// It pauses only while this holds.
    pub(super) only_if: Option<String>,
    /// The block whose variables the words mean; at a place it is that of the place.
    pub(super) block: Option<BlockId>,
}

/// What the user had asked for and the new program does not have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lost {
    /// What it was.
    pub what: LostKind,
    /// As the user wrote it.
    pub text: String,
    /// Why it is gone.
    pub why: String,
}

/// A kind of thing that a session keeps for its user.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LostKind {
    /// The breakpoint of this number.
    Breakpoint(u32),
    /// A value that was shown after every movement.
    Watched,
    /// A value that was to be set at a later time.
    Setting,
}

/// What a change of the program came to.
#[derive(Clone, Debug)]
pub struct Changed {
    /// What it did to the CPU.
    pub change: OnlineChange,
    /// What is dropped of what the user had asked for.
    pub lost: Vec<Lost>,
}

impl Session {
    /// Another program takes over, here and now, between two scans; `loaded` is the build as CPUs take it. The values of the CPU stay as with any
    /// online change, the history begins anew. Breakpoints and names are looked up again: a place and a variable may lie elsewhere now.
    ///
    /// # Errors
    /// The CPU does not take it. Then nothing has changed.
    pub fn change(&mut self, build: Arc<Build>, loaded: Loaded) -> Result<Changed, ChangeError> {
        let mut lost = Vec::new();
        let again = |setting: &Setting| {
            let name = Name::parse(&setting.name.full_text(), &build.project.symbols, &build.compiled.program);
            let found = name.and_then(|name| Setting::new(name, &setting.text));
            let text = || format!("{}={}", setting.name.text(), setting.text);
            found.map_err(|error| lost.push(Lost { what: LostKind::Setting, text: text(), why: error.to_string() })).ok()
        };
        let change = self.history.change_online(loaded, again)?;
        self.take(build);
        self.hits.clear();
        for name in std::mem::take(&mut self.watched) {
            match self.again(name.text(), name.block(), Some(&name)) {
                Ok(name) => self.watched.push(name),
                Err(error) => lost.push(Lost { what: LostKind::Watched, text: name.text().to_owned(), why: error.to_string() }),
            }
        }
        for (breakpoint, request) in std::mem::take(&mut self.breakpoints).into_iter().zip(std::mem::take(&mut self.requests)) {
            match self.sought(&breakpoint, &request) {
                Ok((target, only_if)) => {
                    self.breakpoints.push(Breakpoint { target, only_if, ..breakpoint });
                    self.requests.push(request);
                }
                Err(why) => lost.push(Lost { what: LostKind::Breakpoint(breakpoint.number), text: breakpoint.text, why }),
            }
        }
        Ok(Changed { change, lost })
    }

    /// What a breakpoint waits for in this program.
    fn sought(&self, old: &Breakpoint, request: &Request) -> Result<(Target, Option<Condition>), String> {
        let name = |text: &str| self.again(text, request.block, old.target.name());
        let said = |error: NameError| error.to_string();
        let (target, block) = match &request.wanted {
            Wanted::Place(text) => {
                let goal = self.listing.goal(text, None, self.language)?;
                (Target::Statement(goal.place, goal.last), Some(goal.place.block))
            }
            Wanted::Write(text) => (Target::Write(name(text).map_err(said)?), request.block),
            Wanted::Change(text) => (Target::Change(name(text).map_err(said)?), request.block),
            Wanted::Condition(text) => (Target::Condition(Condition::parse(text, name).map_err(said)?), request.block),
        };
        let only_if = request.only_if.as_ref().map(|text| {
            let old = old.only_if.as_ref().map(Condition::name);
            Condition::parse(text, |text| self.again(text, block, old))
        });
        Ok((target, only_if.transpose().map_err(said)?))
    }

    /// What a name means in this program. A variable of an instance stays with its data block.
    fn again(&self, text: &str, block: Option<BlockId>, old: Option<&Name>) -> Result<Name, NameError> {
        let name = self.name_in(text, block)?;
        match old.and_then(Name::data_block) {
            Some(db) => name.in_data_block(db, self.cpu().program()),
            None => Ok(name),
        }
    }
}
