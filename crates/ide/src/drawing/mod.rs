//! Pictures of diagrams: where everything stands on a grid of characters, as data, and that as text, as SVG and as a page of HTML.
//!
//! A [`Network`](sieben_lang::network::model::Network) is laid out once, as ladder ([`ladder`]) or as function block diagram ([`function_plan`]).
//! [`text`](text::text) and [`svg`](svg::svg) draw the same [`Layout`], [`page`] puts the networks of a block together; [`flow::flows`] says what its lines carry at one moment.

mod faces;
mod figures;
pub mod flow;
mod function_plan;
mod grid;
mod identity;
mod ladder;
mod layout;
mod names;
mod nesting;
pub mod page;
mod statements;
pub mod style;
pub mod svg;
pub mod text;

use sieben_lang::network::model::Place;

pub use function_plan::function_plan;
pub use ladder::ladder;
pub use layout::{Label, Layout, Net, NetId, Outline, Rail, Role, Symbol, Wire};
pub use nesting::{NESTING_MAX, Refusal};
pub use statements::statements;

use flow::Status;

/// Contacts in a row, before it goes on in the next one.
pub const CONTACTS_USUAL: usize = 8;
/// Columns of a row, before it goes on in the next one.
pub const COLUMNS_USUAL: usize = 120;

/// What a drawing is made with.
#[derive(Clone, Copy)]
pub struct Options<'a> {
    /// The line of its source that an element begins in; elements are named by it.
    pub line_of: &'a dyn Fn(Place) -> usize,
    /// What the statements did at one moment; with it there is room for values.
    pub status: Option<&'a Status>,
    /// Contacts in a row.
    pub contacts: usize,
    /// Columns of a row.
    pub columns: usize,
}

impl<'a> Options<'a> {
    /// The usual widths, and no values.
    pub fn new(line_of: &'a dyn Fn(Place) -> usize) -> Self {
        Self { line_of, status: None, contacts: CONTACTS_USUAL, columns: COLUMNS_USUAL }
    }

    /// With what the statements did at one moment.
    #[must_use]
    pub fn with_status(self, status: &'a Status) -> Self {
        Self { status: Some(status), ..self }
    }
}
