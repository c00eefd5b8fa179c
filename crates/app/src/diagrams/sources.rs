//! The sources of a program whose networks can be drawn.

use sieben_lang::body::CheckedBody;
use sieben_lang::stl::redraw::Source;
use sieben_model::address::Operand;
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_workspace::controller::name_in_source;
use sieben_workspace::project::{Build, SourceFile};

use crate::failure::Failure;

/// The sources of a program that have networks, each with its blocks.
pub(crate) fn sources(build: &Build) -> Vec<(&SourceFile, Source<'_>)> {
    let blocks: Vec<_> = build
        .compiled
        .bodies
        .values()
        .filter_map(|body| match &**body {
            CheckedBody::Stl(block) => Some(block),
            CheckedBody::St(_) => None,
        })
        .collect();
    let source = |file: &'_ SourceFile| {
        let language = file.language(build.project.settings.dialect);
        language.dialect().is_none().then(|| Source {
            file: file.id,
            text: &build.project.texts.program.file(file.id).text,
            mnemonics: build.compiled.mnemonics.get(&file.id).copied().unwrap_or(Mnemonics::English),
            drawing: language.drawing(),
            blocks: blocks.clone(),
        })
    };
    build.project.sources.iter().filter_map(|file| Some((file, source(file)?))).collect()
}

fn block_of(operand: Option<Operand>) -> Option<BlockId> {
    match operand {
        Some(Operand::Block(block)) => Some(block),
        _ => None,
    }
}

/// The block that `FC 10` or `FC10` names.
pub(super) fn block_numbered(name: &str) -> Option<BlockId> {
    block_of(Operand::parse(name))
}

/// The block that a name on the command line means.
pub(crate) fn block_named(build: &Build, name: &str) -> Result<BlockId, Failure> {
    let plain = name.trim().trim_matches('"');
    let has_code = |id: &BlockId| build.compiled.bodies.contains_key(id);
    let by_symbol = || block_of(build.project.symbols.operand(plain));
    // The data block of a program has its name too.
    let named = || build.compiled.block_names.iter().filter(|(id, own)| own.to_lowercase() == plain.to_lowercase() && has_code(id));
    let by_name = || named().map(|(id, _)| *id).next();
    let found = block_numbered(plain).or_else(by_symbol).or_else(by_name).filter(has_code);
    found.ok_or_else(|| {
        let of_user = build.compiled.bodies.keys().filter(|id| !build.compiled.is_of_library(**id));
        let all: Vec<String> = of_user.map(|&id| name_in_source(build, id).map_or_else(|| id.to_string(), str::to_owned)).collect();
        Failure::usage(Problem::P7003, format!("there is no block `{name}` in this program")).help(format!("it has {}", all.join(", ")))
    })
}
