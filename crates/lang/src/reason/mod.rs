//! Why a statement did what it did, in one sentence: from its statement event, in English or German.
//!
//! Which kind of reason an instruction has is a column of the instruction table; the sentences are a table of their own. What is
//! said is read from the registers before and after the statement and from the machine; only the exact result of an integer calculation,
//! which a register may be too short for, is calculated once more.

mod bits;
mod control;
pub mod examples;
mod faults;
mod memory;
mod numbers;
mod operands;
pub mod sentences;
mod st;
mod st_values;
mod telling;
mod text;
mod timers;

use sieben_engine::{Machine, StatementEvent};
use sieben_model::source::{Sources, Span};
use sieben_model::symbols::SymbolTable;

use crate::project::Compiled;
use telling::Telling;

/// The language of a sentence; that of the mnemonics is the source's own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// German.
    German,
}

impl Language {
    /// Both.
    pub const ALL: [Self; 2] = [Self::English, Self::German];

    /// The language with this code, `en` or `de`.
    pub fn from_code(code: &str) -> Option<Self> {
        match code {
            "en" => Some(Self::English),
            "de" => Some(Self::German),
            _ => None,
        }
    }

    /// Its code, `en` or `de`.
    pub fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
        }
    }
}

/// One executed statement, with the machine around it.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// Which statement, and the registers before and after it.
    pub event: &'a StatementEvent,
    /// The machine before it, if it was kept. Without it a sentence about a timer or a counter says how it stands, not whether it was
    /// started, and an address that the statement itself may have changed is not named.
    pub before: Option<&'a Machine>,
    /// The machine as the tracer gets it: behind the statement.
    pub after: &'a Machine,
    /// The event of the fault (16#25xx, 16#294x, 16#357x) that this statement caused, if the CPU went to STOP for it. A fault that
    /// called OB 121 or OB 122 shows in the machine.
    pub fault: Option<u16>,
}

/// Says why statements of a program did what they did.
#[derive(Clone, Copy, Debug)]
pub struct Reasons<'a> {
    compiled: &'a Compiled,
    sources: &'a Sources,
    symbols: &'a SymbolTable,
}

impl<'a> Reasons<'a> {
    /// For a program, its sources (see [`Compiled::add_library_sources`]) and the symbols it was compiled with.
    pub fn new(compiled: &'a Compiled, sources: &'a Sources, symbols: &'a SymbolTable) -> Self {
        Self { compiled, sources, symbols }
    }

    /// The reason without the statement before it, beginning in lower case and without a full stop; empty if the program has no such
    /// statement.
    pub fn sentence(&self, moment: &Moment<'_>, language: Language) -> String {
        let place = moment.event.place;
        if let Some(block) = self.compiled.blocks.get(&place.block) {
            return Telling::new(*self, block, *moment).sentence(language);
        }
        st::sentence(*self, moment, language)
    }

    /// Which sentences the reason of a statement of STL is made of, as [`Why::forms`](crate::stl::why::Why::forms) lists them; a fault has one of its own.
    pub fn forms(&self, moment: &Moment<'_>) -> Vec<sentences::Sentence> {
        let block = self.compiled.blocks.get(&moment.event.place.block);
        block.map_or_else(Vec::new, |block| Telling::new(*self, block, *moment).forms())
    }

    /// The text of a statement as it is written, in one line: `A I 0.1`; empty if the sources do not have it.
    pub fn statement(&self, place: sieben_engine::FaultPlace) -> String {
        let spans = self.compiled.program.code.get(&place.block).map_or(&[][..], |block| &block.spans);
        spans.get(place.statement as usize).map_or_else(String::new, |&span| text::one_line(self.slice(span)))
    }

    /// The text of a span, empty if the sources do not have it.
    fn slice(&self, span: Span) -> &'a str {
        if (span.file.0 as usize) < self.sources.iter().len() { self.sources.slice(span) } else { "" }
    }
}
