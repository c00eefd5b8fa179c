//! The control socket of a run: where it lies, who serves it, and who asks there.

pub(crate) mod client;
mod place;
mod server;

use std::sync::Arc;

use sieben_engine::Program;
use sieben_workspace::control::Facts;
use sieben_workspace::controller;
use sieben_workspace::project::Build;

pub(crate) use client::Client;
pub(crate) use server::Server;

/// What is known of a program beside what the CPU has of it; the program is the one that the CPU runs.
pub(crate) fn facts(build: &Build, program: &Arc<Program>) -> Facts {
    let named = build.compiled.program.code.keys().filter_map(|&id| Some((id, controller::name_in_source(build, id)?.to_owned())));
    Facts {
        project: build.project.settings.name.clone(),
        symbols: build.project.symbols.clone(),
        block_names: named.collect(),
        sources: build.project.texts.program.clone(),
        program: Arc::clone(program),
    }
}
