//! Projects of awlsim: their CPU, their sources and symbol tables, as parts of ours.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Duration;

use sieben_lang::awlsim_project::{self, AwlsimProject, LibrarySelection, Specs};
use sieben_lang::encoding::{self, Decoded, Encoding};
use sieben_lang::library::{self, Selection};
use sieben_lang::symbols::{self, Format};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;

use super::{Project, SourceFile};
use crate::finding::Finding;
use crate::settings::{Settings, WATCHDOG};

/// The columns of a symbol table without headings.
const HEADINGS: &str = "symbol;address;type;comment\n";
/// The library that we have, too.
const LIBRARY: &str = "IEC";

impl Project {
    /// Takes in a project of awlsim, with its settings. What it holds and names is answered: the caller reads these files and adds each part.
    /// None if it cannot be read, which a finding says.
    pub fn add_awlsim_project(&mut self, path: &Path, bytes: &[u8]) -> Option<AwlsimProject> {
        let name = path.display().to_string();
        let decoded = match encoding::read_source_as(bytes, Some(Encoding::Utf8)) {
            Ok(decoded) => decoded,
            Err(unreadable) => {
                let message = format!("`{name}` cannot be a project: {unreadable}");
                self.findings.push(Finding::file(unreadable.problem(), name, message));
                return None;
            }
        };
        if decoded.had_errors {
            self.findings.push(Finding::lost_bytes(&name, decoded.encoding));
        }
        let file = self.texts.documents.add(name, decoded.text);
        let (read, diagnostics) = awlsim_project::read(file, &self.texts.documents.file(file).text);
        self.findings.extend(diagnostics.into_iter().map(Finding::document));
        let read = read?;
        self.settings = settings(&read, &mut self.findings);
        Some(read)
    }

    /// Takes in a source that stands in the project of awlsim at this path.
    pub fn add_embedded_source(&mut self, path: &Path, name: &str, text: &str) {
        let id = self.texts.program.add(format!("{} ({name})", path.display()), text);
        let decoded = Decoded { text: text.to_owned(), encoding: Encoding::Utf8, had_errors: false };
        self.sources.push(SourceFile { path: path.to_path_buf(), id, decoded, embedded: true });
    }

    /// Takes in a symbol table of a project of awlsim, whose own tables have no line that names the columns.
    pub fn add_awlsim_symbols(&mut self, name: String, text: String) {
        if text.trim().is_empty() {
            return;
        }
        let (format, text) = match symbols::by_content(&text) {
            Some(format) => (format, text),
            None => (Format::Csv, format!("{HEADINGS}{text}")),
        };
        let file = self.texts.documents.add(name.clone(), text);
        let read = symbols::read(file, &self.texts.documents.file(file).text, format);
        self.findings.extend(read.diagnostics.iter().cloned().map(Finding::document));
        self.add_table(&name, &read.table);
    }
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
