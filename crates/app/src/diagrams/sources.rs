//! The sources of a program whose networks can be drawn.

use sieben_lang::body::CheckedBody;
use sieben_lang::stl::redraw::Source;
use sieben_model::address::Operand;
use sieben_model::block::BlockId;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;

use crate::failure::Failure;
use crate::project::{Build, SourceFile};

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

/// The block that a name on the command line means.
pub(crate) fn block_named(build: &Build, name: &str) -> Result<BlockId, Failure> {
    let plain = name.trim().trim_matches('"');
    let as_block = |operand| match operand {
        Some(Operand::Block(block)) => Some(block),
        _ => None,
    };
    let by_symbol = || as_block(build.project.symbols.operand(plain));
    let by_name = || build.compiled.block_names.iter().find(|(_, own)| own.eq_ignore_ascii_case(plain)).map(|(id, _)| *id);
    let found = as_block(Operand::parse(plain)).or_else(by_symbol).or_else(by_name).filter(|id| build.compiled.bodies.contains_key(id));
    found.ok_or_else(|| {
        let all: Vec<String> =
            build.compiled.bodies.keys().filter(|id| !build.compiled.is_of_library(**id)).map(ToString::to_string).collect();
        Failure::usage(Problem::P7003, format!("there is no block `{name}` in this program")).help(format!("it has {}", all.join(", ")))
    })
}
