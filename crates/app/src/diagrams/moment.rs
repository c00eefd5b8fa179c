//! One network with its power flow and values at the end of a run, written to a file.

use std::path::{Path, PathBuf};

use sieben_cpu::Cpu;
use sieben_engine::StatementEvent;
use sieben_ide::drawing::text::Characters;
use sieben_model::block::BlockId;
use sieben_model::problems::Problem;

use super::{CodeBlock, Diagrams, ElementPlaces, Form, Kind, Watch, Written, html_of, put, svg};
use crate::failure::Failure;
use crate::paths;

/// Watches a network, and draws it at the end.
pub(crate) struct LastMoment<'d> {
    diagrams: &'d Diagrams<'d>,
    id: BlockId,
    block: &'d CodeBlock,
    network: &'d Written,
    form: Form,
    file: PathBuf,
    kind: Kind,
    watch: Watch,
}

impl<'d> LastMoment<'d> {
    /// `FC1/2` or `Dosing/3`, drawn to a file.
    pub(crate) fn new(diagrams: &'d Diagrams<'d>, text: &str, form: Form, file: &Path) -> Result<Self, Failure> {
        let kind = Kind::of(file)?;
        paths::spare_sources([&file.to_path_buf()])?;
        let split = text.rsplit_once('/').and_then(|(block, number)| Some((block, number.trim().parse::<u32>().ok()?)));
        let Some((block, number)) = split else {
            let message = format!("`{text}` names no network; write a block and the number of its network: `FC1/2`");
            return Err(Failure::usage(Problem::P7082, message));
        };
        let (id, block) = diagrams.block(block.trim())?;
        let network = diagrams.network(id, block, number)?;
        // What is no diagram is said before the run, not after it.
        if let Some(reason) = diagrams.shown(id, network, form, None).reason {
            return Err(Failure::usage(Problem::P7083, format!("network {number} of {id} is no diagram. {reason}")));
        }
        if matches!(network.places, ElementPlaces::Bytes(..)) {
            let message = format!("{} is a diagram of Structured Text, whose lines cannot be followed yet", diagrams.name(id));
            return Err(Failure::usage(Problem::P7083, message).help("`sieben render` draws it without values"));
        }
        let watch = Watch::new(id, network);
        Ok(Self { diagrams, id, block, network, form, file: file.to_path_buf(), kind, watch })
    }

    /// A scan begins.
    pub(crate) fn begin(&mut self) {
        self.watch.begin();
    }

    /// A statement was executed.
    pub(crate) fn note(&mut self, event: &StatementEvent) {
        self.watch.note(event);
    }

    /// Draws the network as it is now.
    pub(crate) fn write(&self, cpu: &Cpu) -> Result<(), Failure> {
        let status = self.watch.status(self.network, cpu, &self.diagrams.build().project.symbols);
        let shown = self.diagrams.shown(self.id, self.network, self.form, Some(&status));
        let text = match self.kind {
            Kind::Svg => svg(&[(shown, self.network)]),
            Kind::Html => html_of(self.diagrams, self.id, self.block, self.network, &shown),
            Kind::Text => shown.text(Characters::Unicode).unwrap_or_else(|| self.network.text.clone()),
        };
        put(&self.file, &text)
    }
}
