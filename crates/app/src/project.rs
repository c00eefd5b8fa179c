//! From the paths of the command line to the texts of a project.

pub(crate) mod awlpro;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use sieben_lang::encoding::{self, Decoded, Encoding};
use sieben_lang::language::Language;
use sieben_lang::st::dialect::Dialect;
use sieben_lang::{Compiled, LostResults, Options, TemporaryReads};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::profile::Profile;
use sieben_model::source::{FileId, Span};
use sieben_model::symbols::SymbolTable;
use sieben_workspace::finding::{self, Finding, Texts};
use sieben_workspace::settings::{self, Placed, Settings};

use crate::failure::Failure;
use crate::files;
use crate::glob::Pattern;
use crate::paths::{Listing, is_awlsim_project, is_scenario, is_source, is_symbols, is_test, join, leaves_folder, shown, slashed};
use crate::programs::{self, Folder, Kind, is_symbols_by_default};

/// What the command line says about a program.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Overrides {
    /// `--cpu`.
    pub(crate) cpu: Option<&'static CpuType>,
    /// `--mnemonics en|de`; `Some(None)` is `auto`.
    pub(crate) mnemonics: Option<Option<Mnemonics>>,
    /// `--dialect`.
    pub(crate) dialect: Option<Dialect>,
    /// `--temp`.
    pub(crate) temporaries: TemporaryReads,
    /// `--extended`.
    pub(crate) extended: bool,
    /// `--profile`.
    pub(crate) profile: Option<Profile>,
    /// The first source is a test: its blocks take the place of those with the same number.
    pub(crate) replacing: bool,
    /// Test files among the sources are compiled.
    pub(crate) tests: bool,
    /// It is told how statements and decisions are counted.
    pub(crate) counted: bool,
    /// Which lost results the CPU is told of.
    pub(crate) tells_lost: LostResults,
    /// `--strict`: what STEP 7 refuses is an error.
    pub(crate) strict: bool,
}

/// A source file as it lies on the disk.
#[derive(Clone, Debug)]
pub(crate) struct SourceFile {
    /// Where it lies.
    pub(crate) path: PathBuf,
    /// Its identity among the texts of the program.
    pub(crate) id: FileId,
    /// Its text and how it was encoded.
    pub(crate) decoded: Decoded,
    /// It lies inside another file, which is not ours to write.
    pub(crate) embedded: bool,
}

impl SourceFile {
    /// The language that it is written in; `dialect` is what the user chose for sources of ST.
    pub(crate) fn language(&self, dialect: Option<Dialect>) -> Language {
        Language::of(&self.path.to_string_lossy(), &self.decoded.text, dialect)
    }
}

/// Everything read and decoded, nothing compiled.
#[derive(Debug, Default)]
pub(crate) struct Project {
    /// All texts.
    pub(crate) texts: Texts,
    /// The sources in the order of compilation.
    pub(crate) sources: Vec<SourceFile>,
    /// All symbols.
    pub(crate) symbols: SymbolTable,
    /// What `sieben.toml` says.
    pub(crate) settings: Settings,
    /// The folder with the `sieben.toml`, if there is one.
    pub(crate) home: Option<PathBuf>,
    /// What was noticed while reading.
    pub(crate) findings: Vec<Finding>,
    /// The files that `tests` names.
    pub(crate) tests: Vec<PathBuf>,
    /// The encoding that the user chose for its files.
    pub(crate) encoding: Option<Encoding>,
    /// What a folder with several programs is.
    several: Several,
}

/// What a folder with several programs is to whoever reads it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Several {
    /// A mistake: one program is wanted.
    #[default]
    Refused,
    /// Files, each for itself.
    Files,
}

/// A project with what the compiler made of it.
pub(crate) struct Build {
    /// Where it came from.
    pub(crate) project: Project,
    /// The program.
    pub(crate) compiled: Compiled,
    /// The CPU type it is for.
    pub(crate) cpu: &'static CpuType,
    /// Everything that was noticed, in order.
    pub(crate) findings: Vec<Finding>,
}

impl Project {
    /// Reads the files and folders that the command line names; none = the current folder. `encoding` is what the user chose for
    /// the files without a byte order mark; none = guessed from each.
    pub(crate) fn load(paths: &[PathBuf], encoding: Option<Encoding>) -> Result<Self, Failure> {
        Self { encoding, ..Self::default() }.read(paths)
    }

    /// The same for what is done with each source by itself: all programs of a folder may be among them.
    pub(crate) fn load_files(paths: &[PathBuf], encoding: Option<Encoding>) -> Result<Self, Failure> {
        Self { encoding, several: Several::Files, ..Self::default() }.read(paths)
    }

    fn read(mut self, paths: &[PathBuf]) -> Result<Self, Failure> {
        let project = &mut self;
        let here = [PathBuf::from(".")];
        let paths = if paths.is_empty() { &here } else { paths };
        let mut seen = BTreeSet::new();
        for path in paths {
            let is_project_file = path.file_name().is_some_and(|name| name == settings::FILE_NAME);
            if is_project_file {
                let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
                project.folder(folder, &mut seen)?;
            } else if path.is_dir() {
                project.folder(path, &mut seen)?;
            } else if is_awlsim_project(path) {
                awlpro::load(project, path, &mut seen)?;
            } else if is_symbols(path) {
                project.symbol_table(path, &mut seen)?;
            } else {
                project.source(path, &mut seen)?;
            }
        }
        project.require_text(paths);
        Ok(self)
    }

    /// Compiles it for the CPU type of the command line, else of the project, else the default.
    pub(crate) fn compile(mut self, overrides: Overrides, syntax_only: bool) -> Build {
        // Blocks and symbols of a refused diagram are missing everywhere else.
        let syntax_only = syntax_only || self.findings.iter().any(|finding| finding.diagnostic.problem == Problem::P6043);
        let cpu = overrides.cpu.or(self.settings.cpu).unwrap_or(&CpuType::ALL[0]);
        let profile = overrides.profile.or(self.settings.profile).unwrap_or_default();
        // A CPU type lives as long as the process; few have rules of their own.
        let cpu = if profile == Profile::Siemens { cpu } else { Box::leak(Box::new(profile.applied_to(cpu))) };
        let extended = overrides.extended || self.settings.extended;
        let mut system_blocks = sieben_cpu::system::interfaces();
        if extended {
            system_blocks.extend(sieben_cpu::system::extension_interfaces());
        }
        if overrides.tests {
            system_blocks.extend(sieben_cpu::system::test_interfaces());
        }
        let options = Options {
            cpu: Some(cpu),
            mnemonics: overrides.mnemonics.unwrap_or(self.settings.mnemonics),
            syntax_only,
            temporaries: overrides.temporaries,
            extended,
            replacing: overrides.replacing.then_some(FileId(0)),
            system_blocks,
            library: self.settings.library.clone(),
            dialect: overrides.dialect.or(self.settings.dialect),
            tests: overrides.tests,
            counted: overrides.counted,
            tells_lost: overrides.tells_lost,
        };
        // An extended program may be empty.
        let empty = |finding: &Finding| finding.diagnostic.problem == Problem::P6005;
        let may_be_empty = extended && !self.sources.is_empty();
        let nothing = !may_be_empty && self.findings.iter().any(empty);
        let compiled = match nothing {
            true => Compiled::default(),
            false => sieben_lang::dialects::compile(&self.texts.program, &self.symbols, &options),
        };
        compiled.add_library_sources(&mut self.texts.program);
        let mut findings = self.findings.clone();
        findings.retain(|finding| !(may_be_empty && empty(finding)));
        findings.extend(self.settings.retain.beyond(cpu).into_iter().map(Finding::document));
        findings.extend(settings::modules::problems(&self.settings.modules, cpu).into_iter().map(Finding::document));
        findings.extend(compiled.diagnostics.iter().cloned().map(Finding::program));
        finding::sort(&mut findings);
        findings.iter_mut().for_each(|finding| finding.strict = overrides.strict);
        Build { project: self, compiled, cpu, findings }
    }

    fn folder(&mut self, folder: &Path, seen: &mut BTreeSet<PathBuf>) -> Result<(), Failure> {
        let project_file = join(folder, Path::new(settings::FILE_NAME));
        let mut settings = Settings::default();
        if project_file.is_file() {
            self.home = Some(folder.to_path_buf());
            match String::from_utf8(files::read(&project_file)?) {
                Ok(text) => {
                    let file = self.texts.documents.add(shown(&project_file), text.strip_prefix('\u{FEFF}').unwrap_or(&text));
                    let (parsed, diagnostics) = settings::parse(&self.texts.documents.file(file).text, file);
                    self.findings.extend(diagnostics.into_iter().map(Finding::document));
                    settings = parsed;
                }
                Err(_) => {
                    let message = format!("`{}` is not UTF-8 text", shown(&project_file));
                    self.findings.push(Finding::file(Problem::P6007, shown(&project_file), message));
                }
            }
        }
        let listing = Listing::of(folder)?;
        // A project of awlsim that is alone in its folder is what the folder means, unless a `sieben.toml` says otherwise.
        let others: Vec<&PathBuf> = listing.files.iter().filter(|file| is_awlsim_project(file)).collect();
        if let ([other], false) = (others.as_slice(), project_file.is_file()) {
            return awlpro::load(self, &join(folder, other), seen);
        }
        if self.several == Several::Refused
            && let Some(found) = Folder::of(folder, self.encoding)?
        {
            if found.has_several() {
                return Err(found.too_many());
            }
            if let Some(program) = found.programs.first().filter(|program| program.kind == Kind::Project) {
                return self.folder(&program.paths[0], seen);
            }
        }
        let mut symbols = self.chosen(&listing, settings.symbols.as_deref(), is_symbols_by_default);
        let mut sources = self.chosen(&listing, settings.sources.as_deref(), is_source);
        let mut tests = match &settings.tests {
            Some(tests) => self.chosen(&listing, Some(tests), |_| false),
            None => listing.files.iter().filter(|file| is_test(file) || is_scenario(file)).cloned().collect(),
        };
        // Tests are known by their text, too.
        let (by_text, others): (Vec<PathBuf>, Vec<PathBuf>) = sources
            .into_iter()
            .filter(|source| !tests.contains(source) && !is_test(source))
            .partition(|source| programs::is_test(&join(folder, source), self.encoding));
        sources = others;
        if settings.tests.is_none() {
            tests.extend(by_text);
            tests.sort();
        }
        self.tests.extend(tests.iter().map(|test| join(folder, test)));
        // `.asc` also ends the names of signatures: without a program there is nothing that they could name.
        if sources.is_empty() && settings.symbols.is_none() {
            symbols.clear();
        }
        self.settings = settings;
        for relative in symbols {
            self.symbol_table(&join(folder, &relative), seen)?;
        }
        for relative in sources {
            self.source(&join(folder, &relative), seen)?;
        }
        Ok(())
    }

    /// The files that match the patterns, in the order of the patterns, then by path; without patterns those of the default.
    fn chosen(&mut self, listing: &Listing<'_>, patterns: Option<&[Placed]>, default: impl Fn(&Path) -> bool) -> Vec<PathBuf> {
        let Some(patterns) = patterns else {
            self.links_outside(listing, &default);
            return listing.files.iter().filter(|path| default(path)).cloned().collect();
        };
        let mut chosen = Vec::new();
        for placed in patterns {
            if leaves_folder(&placed.text) {
                self.findings.push(Finding::document(Diagnostic::new(
                    Problem::P6010,
                    placed.span,
                    format!("`{}` leaves the project folder", placed.text),
                )));
                continue;
            }
            let pattern = Pattern::new(&placed.text);
            let before = chosen.len();
            let mut matched = false;
            for path in listing.files.iter().filter(|path| pattern.matches(&slashed(path))) {
                matched = true;
                if !chosen[..before].contains(path) {
                    chosen.push(path.clone());
                }
            }
            matched |= self.links_outside(listing, |path| pattern.matches(&slashed(path)));
            if !matched {
                self.findings.push(Finding::document(no_match(&placed.text, placed.span, listing)));
            }
        }
        chosen
    }

    /// Says which of the links out of the folder would have been read, and whether there are any.
    fn links_outside(&mut self, listing: &Listing<'_>, wanted: impl Fn(&Path) -> bool) -> bool {
        let before = self.findings.len();
        for relative in listing.links_outside.iter().filter(|path| wanted(path)) {
            let path = shown(&join(listing.root, relative));
            self.findings.push(Finding::outside(&path));
        }
        self.findings.len() > before
    }

    pub(crate) fn source(&mut self, path: &Path, seen: &mut BTreeSet<PathBuf>) -> Result<(), Failure> {
        if !is_new(path, seen) {
            return Ok(());
        }
        let decoded = match encoding::read_source_as(&files::read(path)?, self.encoding) {
            Ok(decoded) => decoded,
            Err(unreadable) => {
                let message = format!("`{}` cannot be a source: {unreadable}", shown(path));
                self.findings.push(Finding::file(unreadable.problem(), shown(path), message));
                return Ok(());
            }
        };
        if decoded.had_errors {
            self.findings.push(Finding::lost_bytes(&shown(path), decoded.encoding));
        }
        if decoded.text.trim().is_empty() {
            self.findings.push(Finding::file(Problem::P6004, shown(path), format!("`{}` is empty", shown(path))));
        }
        let id = self.texts.program.add(shown(path), decoded.text.clone());
        self.sources.push(SourceFile { path: path.to_path_buf(), id, decoded, embedded: false });
        Ok(())
    }

    pub(crate) fn symbol_table(&mut self, path: &Path, seen: &mut BTreeSet<PathBuf>) -> Result<(), Failure> {
        if !is_new(path, seen) {
            return Ok(());
        }
        let file = match crate::symbol_files::read(path, self.encoding, &mut self.texts.documents) {
            Ok(file) => file,
            // What lies inside the project is a matter of the project, not of the command line.
            Err(failure) if failure.refusal.problem == Problem::P1101 => {
                self.findings.push(Finding::file(failure.refusal.problem, shown(path), failure.refusal.message));
                return Ok(());
            }
            Err(failure) => return Err(failure),
        };
        self.findings.extend(file.findings);
        self.add_symbols(&shown(path), &file.read.table);
        Ok(())
    }

    /// Takes in a symbol table. Twice in one table is found where the table is read; here are the tables before this one.
    pub(crate) fn add_symbols(&mut self, name: &str, table: &SymbolTable) {
        let before = self.symbols.clone();
        for symbol in table.symbols() {
            if let Some(other) = before.find(&symbol.name).filter(|other| other.operand() != symbol.operand()) {
                let message = format!(
                    "`{}` is `{}` in `{}` and `{}` in another symbol table",
                    symbol.name,
                    symbol.address.trim(),
                    name,
                    other.address.trim()
                );
                self.findings.push(Finding::file(Problem::P6101, name, message));
            }
            self.symbols.push(symbol.clone());
        }
    }

    /// A program needs at least one source with something in it.
    fn require_text(&mut self, paths: &[PathBuf]) {
        let blank = |source: &SourceFile| source.decoded.text.trim().is_empty();
        if finding::has_errors(&self.findings) || !self.sources.iter().all(blank) {
            return;
        }
        self.findings.retain(|finding| finding.diagnostic.problem != Problem::P6004);
        let (path, message) = match (self.sources.as_slice(), paths) {
            ([], [path]) if path.as_os_str() == "." => (String::new(), "there is no STL source in this folder".to_owned()),
            ([], [path]) => (shown(path), format!("there is no STL source in `{}`", shown(path))),
            ([], _) => (String::new(), "no STL source is among these files".to_owned()),
            ([source], _) => (shown(&source.path), format!("`{}` is empty", shown(&source.path))),
            _ => (String::new(), "all sources are empty".to_owned()),
        };
        self.findings.push(Finding::file(Problem::P6005, path, message));
    }
}

fn no_match(pattern: &str, span: Span, listing: &Listing<'_>) -> Diagnostic {
    let diagnostic = Diagnostic::new(Problem::P6011, span, format!("no file matches `{pattern}`"));
    let paths: Vec<String> = listing.files.iter().map(|path| slashed(path)).collect();
    match sieben_workspace::nearest::nearest(pattern, paths.iter().map(String::as_str)) {
        Some(near) => diagnostic.help(format!("did you mean `{near}`?")),
        None => diagnostic,
    }
}

/// Whether a file was not named before; a file named twice is read once.
fn is_new(path: &Path, seen: &mut BTreeSet<PathBuf>) -> bool {
    seen.insert(fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf()))
}
