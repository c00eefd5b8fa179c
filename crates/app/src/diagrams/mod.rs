//! The networks of a program as diagrams: which there are, what each shows, and how that is drawn.

mod kind;
mod moment;
mod pages;
mod reading;
mod sources;
mod status;

use std::collections::BTreeMap;
use std::rc::Rc;

pub(crate) use kind::{Kind, put};
pub(crate) use moment::LastMoment;
pub(crate) use pages::{html, html_of};
pub(crate) use reading::blocks;
pub(crate) use sources::{block_named, sources};
pub(crate) use status::Watch;

use clap::ValueEnum;
use sieben_ide::drawing::flow::{Flow, Status, flows};
use sieben_ide::drawing::svg::{Picture, stand_alone};
use sieben_ide::drawing::text::{Characters, text};
use sieben_ide::drawing::{COLUMNS_USUAL, Layout, Options, function_plan, ladder, statements};
use sieben_lang::network::model::{Network, Place};
use sieben_lang::network::statement::Statement;
use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};
use sieben_workspace::controller;
use sieben_workspace::places::Places;
use sieben_workspace::project::Build;

use crate::failure::Failure;

/// How networks are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Form {
    // Ladder.
    Lad,
    // Function block diagrams.
    Fbd,
    // Statements.
    Stl,
}

impl Form {
    /// What people call it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Lad => "LAD",
            Self::Fbd => "FBD",
            Self::Stl => "STL",
        }
    }
}

/// The blocks of a program with their networks.
pub(crate) struct Diagrams<'b> {
    build: &'b Build,
    pub(crate) places: &'b Places<'b>,
    blocks: Rc<Blocks>,
}

/// Blocks with what stands in their sources.
pub(crate) type Blocks = BTreeMap<BlockId, CodeBlock>;

/// What stands in the source of a block.
#[derive(Clone, Debug, Default)]
pub(crate) struct CodeBlock {
    pub(crate) title: Option<String>,
    pub(crate) comment: Option<String>,
    /// Rows of its header.
    pub(crate) header: Vec<(String, String)>,
    pub(crate) networks: Vec<Written>,
}

/// A network as it is written.
#[derive(Clone, Debug)]
pub(crate) struct Written {
    /// Counted from 1.
    pub(crate) number: u32,
    pub(crate) title: Option<String>,
    pub(crate) comment: Option<String>,
    /// The number of each of its statements in the block.
    pub(crate) numbers: Vec<u32>,
    /// Its statements as diagrams see them.
    pub(crate) statements: Vec<Statement>,
    /// What the places of its elements are.
    pub(crate) places: ElementPlaces,
    /// As a diagram, or why it is none.
    pub(crate) read: Result<Network, String>,
    /// Its statements as text.
    pub(crate) text: String,
}

/// What the places of the elements of a network are.
#[derive(Clone, Debug)]
pub(crate) enum ElementPlaces {
    /// Its statements, which stand here.
    Statements(Vec<Span>),
    /// Bytes of a source, in a block of Structured Text, where the network begins at one of them.
    Bytes(FileId, u32),
}

impl ElementPlaces {
    /// Where an element stands.
    fn span(&self, place: Place) -> Span {
        match self {
            Self::Statements(spans) => spans.get(place.first as usize).copied().unwrap_or_default(),
            Self::Bytes(file, _) => Span::new(*file, place.first, place.first),
        }
    }
}

/// A network as it is shown.
pub(crate) struct Shown {
    /// `FC 1, network 2, as LAD`.
    pub(crate) title: String,
    /// The diagram, or nothing if it is shown as statements.
    pub(crate) layout: Option<Layout>,
    /// What its lines carry.
    pub(crate) flows: Option<Vec<Flow>>,
    /// Why it is not shown as it was asked for.
    pub(crate) reason: Option<String>,
}

impl Shown {
    /// As text.
    pub(crate) fn text(&self, characters: Characters) -> Option<String> {
        self.layout.as_ref().map(|layout| text(layout, self.flows.as_deref(), characters))
    }

    fn picture(&self) -> Option<Picture<'_>> {
        self.layout.as_ref().map(|layout| Picture { title: &self.title, layout, flows: self.flows.as_deref() })
    }
}

/// Networks under one another as a file of its own; statements, and why they are no diagram, stand there as text.
pub(crate) fn svg(shown: &[(Shown, &Written)]) -> String {
    let texts: Vec<Layout> = shown
        .iter()
        .map(|(shown, written)| statements(&format!("{}\n{}", written.text.trim_end(), shown.reason.as_deref().unwrap_or_default())))
        .collect();
    let pictures = shown.iter().zip(&texts).map(|((shown, _), text)| {
        let as_text = Picture { title: &shown.title, layout: text, flows: None };
        shown.picture().unwrap_or(as_text)
    });
    stand_alone(&pictures.collect::<Vec<_>>())
}

impl<'b> Diagrams<'b> {
    /// Reads the sources of the blocks.
    pub(crate) fn new(build: &'b Build, places: &'b Places<'b>) -> Self {
        Self::of(build, places, Rc::new(blocks(build)))
    }

    /// With sources that were read before.
    pub(crate) fn of(build: &'b Build, places: &'b Places<'b>, blocks: Rc<Blocks>) -> Self {
        Self { build, places, blocks }
    }

    /// The blocks that have networks, in order.
    pub(crate) fn blocks(&self) -> impl Iterator<Item = (BlockId, &CodeBlock)> {
        self.blocks.iter().map(|(id, block)| (*id, block))
    }

    /// A block by `FC 1`, `FC1` or its symbol.
    pub(crate) fn block(&self, name: &str) -> Result<(BlockId, &CodeBlock), Failure> {
        let id = block_named(self.build, name)?;
        match self.blocks.get(&id) {
            Some(block) => Ok((id, block)),
            None => {
                Err(Failure::usage(Problem::P7080, format!("{} is written as text of Structured Text, and has no networks", self.name(id))))
            }
        }
    }

    /// A network of a block by its number.
    pub(crate) fn network<'n>(&self, id: BlockId, block: &'n CodeBlock, number: u32) -> Result<&'n Written, Failure> {
        block.networks.iter().find(|network| network.number == number).ok_or_else(|| {
            let name = controller::name_in_source(self.build, id).map_or_else(|| id.to_string(), str::to_owned);
            let message = match block.networks.len() {
                0 => format!("{name} has no network"),
                1 => format!("{name} has no network {number}; it has one, network 1"),
                count => format!("{name} has no network {number}; it has networks 1 to {count}"),
            };
            Failure::usage(Problem::P7082, message)
        })
    }

    /// A network as a reader wants it; what it cannot be drawn as is shown as statements, with the reason.
    pub(crate) fn shown(&self, id: BlockId, written: &Written, form: Form, status: Option<&Status>) -> Shown {
        self.shown_in(id, written, form, status, COLUMNS_USUAL)
    }

    /// The same in so many columns.
    pub(crate) fn shown_in(&self, id: BlockId, written: &Written, form: Form, status: Option<&Status>, columns: usize) -> Shown {
        let title = |form: Form| format!("{}, network {}, as {}", self.name(id), written.number, form.name());
        let as_statements = |reason| Shown { title: title(Form::Stl), layout: None, flows: None, reason };
        let network = match (&written.read, form) {
            (_, Form::Stl) => return as_statements(None),
            (Err(reason), _) => return as_statements(Some(format!("Stays STL: {reason}"))),
            (Ok(network), _) => network,
        };
        let line_of = |place: Place| self.places.line(written.places.span(place));
        let options = Options { status, columns, ..Options::new(&line_of) };
        let drawn = match form {
            Form::Lad => reading::for_ladder(network).and_then(|network| ladder(&network, &options).map_err(|refusal| refusal.message())),
            _ => function_plan(network, &options).map_err(|refusal| refusal.message()),
        };
        match drawn {
            Ok(layout) => {
                let flows = status.map(|status| flows(&layout, Some(status)));
                Shown { title: title(form), layout: Some(layout), flows, reason: None }
            }
            Err(reason) => as_statements(Some(format!("Stays STL: {reason}"))),
        }
    }

    /// What people call a block: `FC 1 (Dosing)`, or the name that it has in its source of ST.
    pub(crate) fn name(&self, id: BlockId) -> String {
        controller::name_in_source(self.build, id).map_or_else(|| self.places.block(id), str::to_owned)
    }

    /// The program.
    pub(crate) fn build(&self) -> &'b Build {
        self.build
    }
}
