//! `sieben structure [PATH…]`: which block calls which, and the local data of every path.

use std::path::PathBuf;

use clap::Args;
use sieben_ide::call_structure::{CallStructure, Callee, Line, Mark};
use sieben_ide::target::Target;
use sieben_workspace::places::Places;
use sieben_workspace::project::Build;

use crate::arguments::{ProgramArguments, ReportArguments};
use crate::document::{Document, Section};
use crate::failure::{Exit, Failure};

/// Levels that are indented: more than any CPU nests; deeper ones are numbered.
const LEVELS_MAX: usize = 40;

/// Print which block calls which, and the local data of every path.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben structure                            the project in this folder\n  \
  sieben structure pump --html -o calls.html  a page to print\n\n\
Each organization block begins a tree. `Local` is what a block needs itself, `Path` what\n\
all blocks from the first one down to it need together. What a block calls is written\n\
once in a tree. Blocks that nothing calls stand at the end, marked with `x`.")]
pub(crate) struct Arguments {
    /// Source files, symbol tables or a project folder [default: this folder]
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    program: ProgramArguments,
    #[command(flatten)]
    report: ReportArguments,
}

/// Prints the call structure.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let build = match super::build_for_report(&arguments.paths, &arguments.program, &arguments.report)? {
        Ok(build) => build,
        Err(exit) => return Ok(exit),
    };
    let structure = CallStructure::new(&build.compiled);
    let places = Places::new(&build);
    arguments.report.put(&document(&build, &places, &structure), || crate::page::structure::json(&build, &places, &structure))?;
    Ok(Exit::Success)
}

fn document(build: &Build, places: &Places<'_>, structure: &CallStructure) -> Document {
    let cpu = build.cpu;
    let mut sections = Vec::new();
    for &root in &structure.roots {
        let Some(caller) = structure.blocks.get(&root) else { continue };
        let tree = structure.tree(root);
        let recursive = tree.iter().any(|line| line.mark == Mark::Recursion);
        let more = if recursive { "; a recursion needs more with each turn" } else { "" };
        let note = format!(
            "{root}: at most {} bytes of local data (CPU {} has {} for a priority class), {} deep (nesting depth {}){more}.",
            caller.path_local_data, cpu.name, cpu.local_data, caller.path_depth, cpu.nesting_depth
        );
        sections.push(Section { notes: vec![note], ..section(build, places, &tree, "") });
    }
    if !structure.not_called.is_empty() {
        let mut all = Section::default();
        for tree in structure.not_called_trees() {
            let one = section(build, places, &tree, "x ");
            all.headings = one.headings;
            all.rows.extend(one.rows);
        }
        all.title = "Not called by any organization block".to_owned();
        let mut sites = structure.blocks.values().flat_map(|caller| &caller.calls);
        if sites.any(|site| matches!(site.callee, Callee::Unknown(_))) {
            all.notes.push("The program calls blocks that are known only at run time; these may be among them.".to_owned());
        }
        sections.push(all);
    }
    if sections.is_empty() {
        sections.push(Section { notes: vec!["There is no code block in this program.".to_owned()], ..Section::default() });
    }
    Document { title: "Call structure".to_owned(), sections, ..Document::default() }
}

fn section(build: &Build, places: &Places<'_>, lines: &[Line<'_>], mark: &str) -> Section {
    let rows = lines.iter().map(|line| row(build, places, line, mark)).collect();
    let headings = vec!["Block", "Symbol", "Call", "Instance", "Network", "Local", "Path", "Line", "Remark"];
    Section { headings, rows, ..Section::default() }
}

fn row(build: &Build, places: &Places<'_>, line: &Line<'_>, mark: &str) -> Vec<String> {
    let own = if line.depth == 0 { mark } else { "" };
    let indent = if line.depth == 0 { 0 } else { 2 * line.depth.min(LEVELS_MAX) + mark.len() };
    let level = if line.depth > LEVELS_MAX { format!("({}) ", line.depth) } else { String::new() };
    let symbol = match &line.callee {
        Callee::Block(block) => places.block_symbol(*block),
        Callee::Unknown(_) => String::new(),
    };
    let (mut call, mut instance, mut networks, mut place) = Default::default();
    if let Some(site) = line.site {
        call = site.kind.word().to_owned();
        if site.places.len() > 1 {
            call = format!("{call} ×{}", site.places.len());
        }
        instance = site.instance.as_ref().map(|target| instance_name(places, target)).unwrap_or_default();
        let mut numbers: Vec<u32> = site.places.iter().map(|(network, ..)| *network).collect();
        numbers.dedup();
        numbers.retain(|&network| network != 0);
        networks = numbers.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
        place = site.places.first().map(|(.., span)| places.place(*span)).unwrap_or_default();
    }
    let known = matches!(line.mark, Mark::None | Mark::Recursion | Mark::Above);
    let number = |bytes: u32| if known { bytes.to_string() } else { String::new() };
    let remark = match (&line.callee, line.mark) {
        (Callee::Block(block), Mark::None) if build.compiled.is_of_library(*block) => "library".to_owned(),
        _ => remark(line.mark).to_owned(),
    };
    let (own_bytes, path_bytes) = (number(line.own), number(line.local_data));
    vec![
        format!("{}{own}{level}{}", " ".repeat(indent), crate::page::structure::callee_name(places, &line.callee)),
        symbol,
        call,
        instance,
        networks,
        own_bytes,
        path_bytes,
        place,
        remark,
    ]
}

fn instance_name(places: &Places<'_>, target: &Target) -> String {
    match target {
        Target::Block(block) => places.block(*block),
        other => other.spell(places.mnemonics),
    }
}

fn remark(mark: Mark) -> &'static str {
    match mark {
        Mark::None => "",
        Mark::Recursion => "recursion",
        Mark::Above => "its calls stand above",
        Mark::Missing => "not in the program",
        Mark::System => "function of the CPU",
        Mark::Unknown => "known only at run time",
    }
}
