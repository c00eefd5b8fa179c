//! Projects of awlsim: their CPU, their sources and symbol tables, as parts of ours.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::time::Duration;

use sieben_lang::awlsim_project::{self, AwlsimProject, Content, LibrarySelection, Source, Specs};
use sieben_lang::encoding::{self, Decoded, Encoding};
use sieben_lang::library::{self, Selection};
use sieben_lang::symbols::{self, Format};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_workspace::finding::Finding;
use sieben_workspace::settings::{Settings, WATCHDOG};

use super::{Project, SourceFile};
use crate::failure::Failure;
use crate::{files, paths};

/// The columns of a symbol table without headings.
const HEADINGS: &str = "symbol;address;type;comment\n";
/// The library that we have, too.
const LIBRARY: &str = "IEC";

/// Reads a project with everything that it names.
pub(crate) fn load(into: &mut Project, path: &Path, seen: &mut BTreeSet<PathBuf>) -> Result<(), Failure> {
    let shown = paths::shown(path);
    let decoded = match encoding::read_source_as(&files::read(path)?, Some(Encoding::Utf8)) {
        Ok(decoded) => decoded,
        Err(unreadable) => {
            let message = format!("`{shown}` cannot be a project: {unreadable}");
            into.findings.push(Finding::file(unreadable.problem(), shown, message));
            return Ok(());
        }
    };
    if decoded.had_errors {
        into.findings.push(Finding::lost_bytes(&shown, decoded.encoding));
    }
    let file = into.texts.documents.add(shown.clone(), decoded.text);
    let (read, diagnostics) = awlsim_project::read(file, &into.texts.documents.file(file).text);
    into.findings.extend(diagnostics.into_iter().map(Finding::document));
    let Some(read) = read else { return Ok(()) };
    into.settings = settings(&read, &mut into.findings);
    for table in &read.symbols {
        symbol_table(into, path, table, seen)?;
    }
    for source in &read.sources {
        match &source.content {
            Content::File(file) => {
                if let Some(file) = inside(into, path, file, source) {
                    into.source(&file, seen)?;
                }
            }
            Content::Inline(text) => {
                let name = format!("{shown} ({})", source.name);
                let id = into.texts.program.add(name, text.clone());
                let decoded = Decoded { text: text.clone(), encoding: Encoding::Utf8, had_errors: false };
                into.sources.push(SourceFile { path: path.to_path_buf(), id, decoded, embedded: true });
            }
        }
    }
    Ok(())
}

/// The path of a file that the project names; says so if it lies elsewhere or is not there.
fn inside(into: &mut Project, path: &Path, file: &str, source: &Source) -> Option<PathBuf> {
    let folder = paths::folder_of(path);
    let target = paths::join(folder, Path::new(file));
    let outside = || match (std::fs::canonicalize(&target), std::fs::canonicalize(folder)) {
        (Ok(target), Ok(folder)) => !target.starts_with(folder),
        _ => false,
    };
    let (problem, message) = if paths::leaves_folder(file) || outside() {
        (Problem::P6010, format!("`{file}` leaves the folder of the project"))
    } else if !target.is_file() {
        (Problem::P6001, format!("there is no file `{}`", paths::shown(&target)))
    } else {
        return Some(target);
    };
    into.findings.push(Finding::document(Diagnostic::new(problem, source.span, message)));
    None
}

fn symbol_table(into: &mut Project, path: &Path, table: &Source, seen: &mut BTreeSet<PathBuf>) -> Result<(), Failure> {
    let (name, text) = match &table.content {
        Content::Inline(text) => (format!("{} ({})", paths::shown(path), table.name), text.clone()),
        Content::File(file) => {
            let Some(target) = inside(into, path, file, table) else { return Ok(()) };
            let shown = paths::shown(&target);
            match encoding::read_source_as(&files::read(&target)?, into.encoding) {
                Ok(decoded) => {
                    if decoded.had_errors {
                        into.findings.push(Finding::lost_bytes(&shown, decoded.encoding));
                    }
                    (shown, decoded.text)
                }
                Err(_) => return into.symbol_table(&target, seen),
            }
        }
    };
    if text.trim().is_empty() {
        return Ok(());
    }
    // Its own tables have no line that names the columns.
    let (format, text) = match symbols::by_content(&text) {
        Some(format) => (format, text),
        None => (Format::Csv, format!("{HEADINGS}{text}")),
    };
    let file = into.texts.documents.add(name.clone(), text);
    let read = symbols::read(file, &into.texts.documents.file(file).text, format);
    into.findings.extend(read.diagnostics.iter().cloned().map(Finding::document));
    into.add_symbols(&name, &read.table);
    Ok(())
}

/// What the project says about CPU and program, in our words.
fn settings(read: &AwlsimProject, findings: &mut Vec<Finding>) -> Settings {
    let config = &read.config;
    Settings {
        mnemonics: config.mnemonics,
        extended: config.extended,
        cpu: Some(cpu_type(&read.specs)),
        clock_memory_byte: config.clock_memory_byte,
        // A limit that no CPU can have is the nearest one that it can.
        watchdog: config.cycle_time_limit_us.map(|us| Duration::from_micros(us).clamp(*WATCHDOG.start(), *WATCHDOG.end())),
        library: selection(&read.libraries, findings),
        ..Settings::default()
    }
}

/// The CPU type with these figures: the nearest of ours, with its sizes. It lives as long as the process, as the others do.
fn cpu_type(specs: &Specs) -> &'static CpuType {
    let nearest = match specs.accumulators {
        Some(4) => CpuType::by_name("416-3"),
        _ => CpuType::by_name("315-2PN/DP"),
    };
    let nearest = nearest.copied().unwrap_or_default();
    let image = specs.inputs.into_iter().chain(specs.outputs).max().unwrap_or(nearest.process_image);
    Box::leak(Box::new(CpuType {
        name: "awlsim",
        process_image: image,
        peripheral: image.max(nearest.peripheral),
        bit_memory: specs.flags.unwrap_or(nearest.bit_memory),
        timers: specs.timers.unwrap_or(nearest.timers),
        counters: specs.counters.unwrap_or(nearest.counters),
        local_data: specs.local_bytes.unwrap_or(nearest.local_data),
        local_data_block: specs.local_bytes.unwrap_or(nearest.local_data_block),
        local_data_declared: true,
        db_number_max: u16::MAX,
        fc_number_max: u16::MAX,
        ..nearest
    }))
}

/// The numbers that the project gives to library blocks; blocks that we do not have are reported.
fn selection(libraries: &[LibrarySelection], findings: &mut Vec<Finding>) -> Selection {
    let mut numbers = BTreeMap::new();
    for selected in libraries {
        let block = library::by_block(selected.block).filter(|_| selected.library.eq_ignore_ascii_case(LIBRARY));
        match block {
            Some(block) => {
                numbers.insert(block.name.to_owned(), BlockId::new(selected.block.kind, selected.number));
            }
            None => {
                let message = format!("there is no `{}` in the library `{}`", selected.block, selected.library);
                findings.push(Finding::document(Diagnostic::new(Problem::P6045, selected.span, message)));
            }
        }
    }
    Selection { numbers, only_chosen: true, ..Selection::default() }
}
