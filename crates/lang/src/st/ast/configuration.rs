//! CONFIGURATION with its resources, tasks and instances of programs.

use super::{Argument, Expression, Name, Path, Qualifier, VarSection};
use sieben_model::source::Span;

/// CONFIGURATION.
#[derive(Clone, Debug, PartialEq)]
pub struct Configuration {
    /// The name.
    pub name: Name,
    /// VAR_GLOBAL, VAR_CONFIG, VAR_ACCESS.
    pub sections: Vec<VarSection>,
    /// RESOURCEs; tasks and programs without one stand in a resource without a name.
    pub resources: Vec<Resource>,
    /// The whole configuration.
    pub span: Span,
}

/// RESOURCE.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Resource {
    /// The name; empty if none is written.
    pub name: Name,
    /// ON: the type of the controller.
    pub on: Option<Name>,
    /// VAR_GLOBAL.
    pub sections: Vec<VarSection>,
    /// TASKs.
    pub tasks: Vec<Task>,
    /// PROGRAMs.
    pub programs: Vec<ProgramInstance>,
    /// The whole resource.
    pub span: Span,
}

/// `TASK t(INTERVAL := T#10ms, PRIORITY := 1);`.
#[derive(Clone, Debug, PartialEq)]
pub struct Task {
    /// The name.
    pub name: Name,
    /// SINGLE, INTERVAL, PRIORITY.
    pub arguments: Vec<Argument>,
    /// The whole task.
    pub span: Span,
}

/// `PROGRAM p1 WITH t : MainProg(in := x, fb1 WITH t2);`.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramInstance {
    /// The name of the instance.
    pub name: Name,
    /// RETAIN or NON_RETAIN.
    pub retain: Option<(Qualifier, Span)>,
    /// WITH: the task.
    pub task: Option<Name>,
    /// The PROGRAM.
    pub program: Path,
    /// What its inputs, outputs and in-outs are tied to.
    pub arguments: Vec<Argument>,
    /// Function blocks of the program that another task runs: instance and task.
    pub bound: Vec<(Name, Name)>,
    /// The whole line.
    pub span: Span,
}

impl Task {
    /// The value of SINGLE, INTERVAL or PRIORITY, if it is written.
    pub fn argument(&self, name: &str) -> Option<&Expression> {
        let named = self.arguments.iter().find(|argument| argument.name.as_ref().is_some_and(|known| known.is(name)));
        named.and_then(|argument| argument.value.as_ref())
    }
}
