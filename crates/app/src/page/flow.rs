//! What the lines of a diagram carry in one scan, and the values of its elements.

use std::rc::Rc;
use std::sync::{Arc, Mutex, PoisonError};

use serde_json::{Value, json};
use sieben_engine::FaultPlace;
use sieben_engine::machine::Registers;
use sieben_ide::drawing::svg::{Picture, svg};
use sieben_model::block::BlockId;
use sieben_workbench::View;
use sieben_workspace::places::Places;
use sieben_workspace::project::Build;

use super::blocks::form;
use crate::diagrams::{Blocks, Diagrams, Watch, blocks};

/// The diagrams of the program that was asked for last: they are read from its sources once.
#[derive(Default)]
pub(super) struct Known(Mutex<Option<(Arc<Build>, Blocks)>>);

impl Known {
    /// Of each line its number, of each element its name: with what it carries, and its value.
    pub(super) fn flow(
        &self,
        build: &Arc<Build>,
        (block, network, view): (BlockId, u32, View),
        after: &mut dyn Iterator<Item = (u32, Registers)>,
    ) -> Value {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let of_this = known.take().filter(|(known, _)| Arc::ptr_eq(known, build)).map(|(_, blocks)| blocks);
        let read = Rc::new(of_this.unwrap_or_else(|| blocks(build)));
        let places = Places::new(build);
        let found = flow(&Diagrams::of(build, &places, Rc::clone(&read)), (block, network, view), after);
        *known = Rc::try_unwrap(read).ok().map(|blocks| (Arc::clone(build), blocks));
        found
    }
}

fn flow(diagrams: &Diagrams<'_>, (block, network, view): (BlockId, u32, View), after: &mut dyn Iterator<Item = (u32, Registers)>) -> Value {
    let build = diagrams.build();
    let code = diagrams.blocks().find(|(id, _)| *id == block).map(|(_, code)| code);
    let Some(written) = code.and_then(|code| code.networks.iter().find(|written| written.number == network)) else { return json!([]) };
    let mut watch = Watch::new(block, written);
    for (statement, registers) in after {
        watch.take(FaultPlace { block, statement }, &registers);
    }
    let status = watch.status_with(written, (&build.compiled.program, &build.project.symbols), &|_| None);
    let shown = diagrams.shown(block, written, form(view), Some(&status));
    let Some(layout) = &shown.layout else { return json!([]) };
    marks(&svg(&Picture { title: &shown.title, layout, flows: shown.flows.as_deref() }))
}

/// Line or element, flow and value of all that a picture marks with them.
fn marks(picture: &str) -> Value {
    let attribute = |tag: &str, name: &str| {
        let (_, rest) = tag.split_once(&format!(" {name}=\""))?;
        rest.split_once('"').map(|(value, _)| value.to_owned())
    };
    let mut found: Vec<(String, String, String)> = Vec::new();
    for tag in picture.split('<').filter(|tag| tag.contains(" data-flow=")) {
        let tag = tag.split('>').next().unwrap_or_default();
        let (Some(id), Some(flow)) = (attribute(tag, "data-element").or(attribute(tag, "data-net")), attribute(tag, "data-flow")) else {
            continue;
        };
        let mark = (id, flow, attribute(tag, "data-value").unwrap_or_default());
        if !found.contains(&mark) {
            found.push(mark);
        }
    }
    found.into_iter().map(|(id, flow, value)| json!([id, flow, value])).collect()
}
