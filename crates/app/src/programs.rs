//! A folder of files as people have it: one program, or several that share blocks and symbols.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use sieben_lang::encoding::{self, Encoding};
use sieben_lang::language::role::{self, Role};
use sieben_lang::{awlsim_project, awlsim_project::Content};
use sieben_model::address::Operand;
use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_model::source::Sources;
use sieben_model::visible;
use sieben_workspace::finding::Finding;
use sieben_workspace::settings;

use crate::failure::Failure;
use crate::paths::{self, Listing, is_awlsim_project, is_scenario, is_source, join, shown};
use crate::{files, symbol_files};

/// Most bytes that are read for all programs of a folder: what belongs to all of them counts for each.
const BYTES_MAX: u64 = 256 << 20;
/// Programs of a folder that a message names.
const NAMED_MAX: usize = 8;

/// One of the programs of a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Program {
    /// What reports call it: the path of its file or folder.
    pub(crate) name: String,
    /// What it is read from.
    pub(crate) paths: Vec<PathBuf>,
    /// What it is.
    pub(crate) kind: Kind,
}

/// What makes a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A folder with a `sieben.toml`.
    Project,
    /// A project of awlsim.
    Awlsim,
    /// One of several files that make OB 1, with what belongs to all of them.
    File(PathBuf),
    /// All sources that are nothing else.
    Sources,
}

/// A test file or scenario, and what it tests.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TestFile {
    /// Where it lies.
    pub(crate) path: PathBuf,
    /// What it tests.
    pub(crate) tests: Tested,
}

/// What a test file tests.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Tested {
    /// These programs, by their places in the list.
    Programs(Vec<usize>),
    /// Blocks that belong to several programs, read from these files.
    Blocks(Vec<PathBuf>),
    /// There are several programs, and it is called like none of them.
    Nothing,
}

/// What a folder without a `sieben.toml` holds.
#[derive(Clone, Debug, Default)]
pub(crate) struct Folder {
    /// The folder.
    root: PathBuf,
    /// Its programs; none if it has no source.
    pub(crate) programs: Vec<Program>,
    /// What belongs to several programs.
    pub(crate) shared: Vec<PathBuf>,
    /// Its test files and scenarios, those of projects in it left out.
    pub(crate) tests: Vec<TestFile>,
    /// The sources of its programs, those of projects in it left out.
    sources: Vec<PathBuf>,
    /// Links to sources outside the folder, which are not read.
    pub(crate) links_outside: Vec<PathBuf>,
}

/// Whether a file is a test file by its name or its text.
pub(crate) fn is_test(path: &Path, encoding: Option<Encoding>) -> bool {
    paths::is_test(path) || text(path, encoding).is_some_and(|text| role::holds_tests(&text))
}

/// The text of a file, if it is one that can be read as a source.
fn text(path: &Path, encoding: Option<Encoding>) -> Option<String> {
    let bytes = files::read(path).ok()?;
    encoding::read_source_as(&bytes, encoding).ok().map(|decoded| decoded.text)
}

/// The files that a project of awlsim consists of beside itself; none if it cannot be read.
fn parts(path: &Path) -> BTreeSet<PathBuf> {
    let read = text(path, None).and_then(|text| awlsim_project::read(Default::default(), &text).0);
    let sources = read.into_iter().flat_map(|project| project.sources);
    sources
        .filter_map(|source| match source.content {
            Content::File(file) => Some(join(paths::folder_of(path), Path::new(&file))),
            Content::Inline(_) => None,
        })
        .collect()
}

/// The outermost folders with a `sieben.toml` below a folder.
fn projects(files: &[PathBuf], root: &Path) -> BTreeSet<PathBuf> {
    let settings = files.iter().filter(|file| file.file_name() == Some(OsStr::new(settings::FILE_NAME)));
    let mut projects: BTreeSet<PathBuf> =
        settings.map(|file| paths::folder_of(file).to_path_buf()).filter(|folder| folder != root).collect();
    let all = projects.clone();
    projects.retain(|project| !project.ancestors().skip(1).any(|above| all.contains(above)));
    projects
}

/// A source of a folder.
struct Found {
    path: PathBuf,
    role: Role,
}

impl Folder {
    /// Looks through a folder; `None` = it has a `sieben.toml`, or it is none.
    pub(crate) fn of(root: &Path, encoding: Option<Encoding>) -> Result<Option<Self>, Failure> {
        if !root.is_dir() || root.join(settings::FILE_NAME).is_file() {
            return Ok(None);
        }
        let listing = Listing::of(root)?;
        let mut folder = Self { root: root.to_path_buf(), ..Self::default() };
        let wanted = |path: &Path| is_source(path) || is_symbols_by_default(path);
        folder.links_outside = listing.links_outside.iter().filter(|path| wanted(path)).map(|path| join(root, path)).collect();
        let all: Vec<PathBuf> = listing.files.iter().map(|file| join(root, file)).collect();
        let projects = projects(&all, root);
        let outside = |file: &&PathBuf| !projects.iter().any(|project| file.starts_with(project));
        let awlsim: Vec<&PathBuf> = all.iter().filter(outside).filter(|file| is_awlsim_project(file)).collect();
        let parts: BTreeSet<PathBuf> = awlsim.iter().flat_map(|file| parts(file)).collect();
        let mut tables = Vec::new();
        let mut sources = Vec::new();
        let mut tests = Vec::new();
        for path in all.iter().filter(outside).filter(|path| !parts.contains(*path)) {
            match () {
                () if is_scenario(path) || paths::is_test(path) => tests.push(path.clone()),
                () if is_symbols_by_default(path) => tables.push(path.clone()),
                () if is_source(path) => {
                    // What cannot be read is reported where the program is read.
                    let text = text(path, encoding).unwrap_or_default();
                    match role::holds_tests(&text) {
                        true => tests.push(path.clone()),
                        false => sources.push(Found { role: Role::of(&shown(path), &text, None), path: path.clone() }),
                    }
                }
                () => {}
            }
        }
        resolve(&mut sources, &tables, encoding);
        let mut programs: Vec<Program> = projects
            .iter()
            .map(|path| Program { name: shown(path), paths: vec![path.clone()], kind: Kind::Project })
            .chain(awlsim.iter().map(|path| Program { name: shown(path), paths: vec![(*path).clone()], kind: Kind::Awlsim }))
            .collect();
        programs.extend(folder.of_sources(&sources, &tables));
        programs.sort_by(|a, b| a.name.cmp(&b.name));
        if let [Program { kind: Kind::Sources, paths, .. }] = programs.as_mut_slice() {
            *paths = vec![root.to_path_buf()];
        }
        folder.programs = programs;
        folder.sources = sources.into_iter().map(|found| found.path).collect();
        folder.tests = tests.into_iter().map(|path| TestFile { tests: folder.tested_by(&path), path }).collect();
        Ok(Some(folder))
    }

    /// Whether it holds more than one program.
    pub(crate) fn has_several(&self) -> bool {
        self.programs.len() > 1
    }

    /// The programs that the sources are: one for each that makes OB 1 if there are several, else all together.
    fn of_sources(&mut self, sources: &[Found], tables: &[PathBuf]) -> Vec<Program> {
        let cycles = sources.iter().filter(|found| found.role.cycle).count();
        // PROGRAMs of one name in two files cannot be in one program either.
        let of_files: Vec<BTreeSet<&String>> = sources.iter().map(|found| found.role.programs.iter().collect()).collect();
        let names: BTreeSet<&&String> = of_files.iter().flatten().collect();
        if cycles < 2 && names.len() == of_files.iter().map(BTreeSet::len).sum::<usize>() {
            return Vec::from_iter(self.together(sources, tables));
        }
        let (main, blocks): (Vec<&Found>, Vec<&Found>) =
            sources.iter().partition(|found| found.role.cycle || !found.role.programs.is_empty());
        let main: Vec<&PathBuf> = main.into_iter().map(|found| &found.path).collect();
        let mut with: BTreeMap<&PathBuf, Vec<PathBuf>> = main.iter().map(|path| (*path, Vec::new())).collect();
        for path in tables.iter().chain(blocks.iter().map(|found| &found.path)) {
            let around = self.around(path, &main);
            if around.len() > 1 {
                self.shared.push(path.clone());
            }
            for program in around {
                with.entry(program).or_default().push(path.clone());
            }
        }
        main.into_iter()
            .map(|path| {
                let mut paths = with.remove(path).unwrap_or_default();
                // Tables first, then sources in the order of their paths, as in a project.
                let at = paths.iter().position(|other| !is_symbols_by_default(other) && other > path).unwrap_or(paths.len());
                paths.insert(at, path.clone());
                Program { name: shown(path), paths, kind: Kind::File(path.clone()) }
            })
            .collect()
    }

    /// All sources as one program.
    fn together(&self, sources: &[Found], tables: &[PathBuf]) -> Option<Program> {
        let main = sources.iter().find(|found| found.role.cycle);
        let only = sources.first().filter(|_| sources.len() == 1);
        let name = main.or(only).map_or_else(|| shown(&self.root), |found| shown(&found.path));
        let paths: Vec<PathBuf> = tables.iter().chain(sources.iter().map(|found| &found.path)).cloned().collect();
        (!sources.is_empty()).then_some(Program { name, paths, kind: Kind::Sources })
    }

    /// The files among these in the nearest folder around a path that has some, in itself or below it.
    fn around<'a>(&self, path: &Path, among: &[&'a PathBuf]) -> Vec<&'a PathBuf> {
        let folders = path.ancestors().skip(1).take_while(|folder| folder.starts_with(&self.root) || self.root == Path::new("."));
        let below = |folder: &Path| among.iter().filter(|other| other.starts_with(folder)).copied().collect::<Vec<_>>();
        folders.map(below).find(|found| !found.is_empty()).unwrap_or_else(|| among.to_vec())
    }

    /// What a test file tests.
    pub(crate) fn tested_by(&self, test: &Path) -> Tested {
        let of_sources = |program: &&Program| matches!(program.kind, Kind::File(_) | Kind::Sources);
        if self.programs.iter().filter(of_sources).all(|program| program.kind == Kind::Sources) {
            return match self.programs.iter().position(|program| program.kind == Kind::Sources) {
                Some(program) => Tested::Programs(vec![program]),
                None if self.programs.len() == 1 => Tested::Programs(vec![0]),
                None => Tested::Nothing,
            };
        }
        let mut places: HashMap<&Path, usize> = HashMap::new();
        for (at, program) in self.programs.iter().enumerate() {
            if let Kind::File(path) = &program.kind {
                places.insert(path, at);
            }
        }
        let index = |path: &PathBuf| places.get(path.as_path()).copied();
        let (main, blocks): (Vec<&PathBuf>, Vec<&PathBuf>) = self.sources.iter().partition(|path| index(path).is_some());
        let name = tested(test);
        let around = self.around(test, &main);
        let beside = |path: &&&PathBuf| path.parent() == test.parent();
        let called = |among: &[&PathBuf]| -> Vec<usize> {
            let all: Vec<&&PathBuf> = among.iter().filter(|path| is_called(path, &name)).collect();
            let near: Vec<&&PathBuf> = all.iter().copied().filter(beside).collect();
            let found = if near.is_empty() { all } else { near };
            found.into_iter().filter_map(|path| index(path)).collect()
        };
        match (called(&around), around.as_slice()) {
            (found, _) if !found.is_empty() => Tested::Programs(found),
            // The one program of its folder.
            (_, [only]) => Tested::Programs(index(only).into_iter().collect()),
            _ if blocks.iter().any(|path| is_called(path, &name)) => {
                let with = self.shared.iter().filter(|path| self.around(path, &main).iter().any(|main| around.contains(main)));
                Tested::Blocks(with.cloned().collect())
            }
            _ => Tested::Nothing,
        }
    }

    /// The path of a file of the folder as the folder itself has it.
    pub(crate) fn as_found(&self, file: &Path) -> PathBuf {
        let same = |test: &&TestFile| {
            test.path.file_name() == file.file_name() && fs::canonicalize(&test.path).ok() == fs::canonicalize(file).ok()
        };
        self.tests.iter().find(same).map_or_else(|| file.to_path_buf(), |test| test.path.clone())
    }

    /// Refuses what would take too long.
    pub(crate) fn limit(&self) -> Result<(), Failure> {
        let mut sizes: BTreeMap<&PathBuf, u64> = BTreeMap::new();
        let all = self.programs.iter().filter(|_| self.has_several()).flat_map(|program| &program.paths);
        let bytes: u64 = all.map(|path| *sizes.entry(path).or_insert_with(|| fs::metadata(path).map_or(0, |data| data.len()))).sum();
        if bytes <= BYTES_MAX {
            return Ok(());
        }
        let (programs, shared) = (self.programs.len(), self.shared.len());
        let files = if shared == 1 { "1 file that belongs".to_owned() } else { format!("{shared} files that belong") };
        let message =
            format!("`{}` holds {programs} programs and {files} to several of them: {} MiB to read", shown(&self.root), bytes >> 20);
        Err(Failure::usage(Problem::P6075, message))
    }

    /// What is wrong if one program is wanted.
    pub(crate) fn too_many(&self) -> Failure {
        let message = format!("`{}` holds {} programs: {}", shown(&self.root), self.programs.len(), self.names());
        let failure = Failure::usage(Problem::P6072, message);
        let files = |program: &Program| {
            let (own, others): (Vec<&PathBuf>, Vec<&PathBuf>) =
                program.paths.iter().partition(|path| program.kind == Kind::File(path.to_path_buf()));
            own.into_iter().chain(others).map(|path| quoted(path)).collect::<Vec<_>>().join(" ")
        };
        match self.programs.first() {
            Some(first) => failure.help(format!(
                "name one of them instead of the folder: `{}`; `sieben check` and `sieben test` take all of them",
                files(first)
            )),
            None => failure,
        }
    }

    /// One line about a folder with several programs.
    pub(crate) fn sentence(&self) -> String {
        let shared: Vec<String> = self.shared.iter().map(|path| format!("`{}`", shown(path))).collect();
        let shared = match shared.as_slice() {
            [] => String::new(),
            [one] => format!("; {} belongs to {}", visible::name(one), self.all()),
            several => format!("; {} belong to {}", listed(several), self.all()),
        };
        format!("{} programs: {}{shared}.", self.programs.len(), self.names())
    }

    /// Whose files the shared ones are: those of every program, or only of those in their folders.
    fn all(&self) -> &'static str {
        let everywhere = |path: &PathBuf| self.programs.iter().all(|program| program.paths.contains(path));
        if self.shared.iter().all(everywhere) { "all of them" } else { "those in their folders" }
    }

    fn names(&self) -> String {
        listed(&self.programs.iter().map(|program| format!("`{}`", program.name)).collect::<Vec<_>>())
    }

    /// What is wrong with the folder beside its programs: links that are not followed, test files that belong to nothing.
    pub(crate) fn findings(&self) -> Vec<Finding> {
        let links = self.links_outside.iter().map(|path| Finding::outside(&shown(path)));
        let stray = self
            .tests
            .iter()
            .filter(|test| test.tests == Tested::Nothing && !is_scenario(&test.path))
            .map(|test| Finding::refused(shown(&test.path), self.stray(&test.path).refusal));
        links.chain(stray).collect()
    }

    /// Why a test file is not run.
    pub(crate) fn stray(&self, test: &Path) -> Failure {
        let message = format!("`{}` belongs to none of the {} programs here", shown(test), self.programs.len());
        let failure = Failure::usage(Problem::P6073, message);
        let main = |program: &&Program| matches!(program.kind, Kind::File(_));
        let Some(program) = self.programs.iter().find(main) else { return failure };
        let stem = Path::new(&program.name).file_stem().map(OsStr::to_string_lossy).unwrap_or_default();
        let ending = if is_scenario(test) { "scenario" } else { "test.st" };
        failure.help(format!(
            "call it like the program that it tests: `{stem}.{ending}` for `{}`; or name both: `sieben test {} --tests {}`",
            program.name,
            quoted(Path::new(&program.name)),
            quoted(test)
        ))
    }
}

/// The programs that a command line names.
#[derive(Debug)]
pub(crate) struct Chosen {
    /// The programs; one that the paths are together has no name.
    pub(crate) programs: Vec<Program>,
    /// The folders among the paths that hold several of them.
    pub(crate) folders: Vec<Folder>,
}

impl Chosen {
    /// The paths as sources of which each is looked at alone, where a folder among them holds several programs.
    pub(crate) fn files(paths: &[PathBuf], encoding: Option<Encoding>) -> Result<Self, Failure> {
        let mut chosen = Self::one(paths);
        let (mut files, mut several) = (Vec::new(), false);
        for path in &chosen.programs[0].paths {
            match Folder::of(path, encoding)?.filter(Folder::has_several) {
                Some(folder) => {
                    several = true;
                    files.extend(folder.programs.into_iter().flat_map(|program| program.paths));
                    files.extend(folder.sources);
                }
                None => files.push(path.clone()),
            }
        }
        if several {
            let mut known = BTreeSet::new();
            files.retain(|file| !paths::is_symbols(file) && known.insert(file.clone()));
            files.sort();
            let alone = |path: PathBuf| Program { name: shown(&path), kind: Kind::File(path.clone()), paths: vec![path] };
            chosen.programs = files.into_iter().map(alone).collect();
        }
        Ok(chosen)
    }

    /// The paths as one program.
    pub(crate) fn one(paths: &[PathBuf]) -> Self {
        let paths = if paths.is_empty() { vec![PathBuf::from(".")] } else { paths.to_vec() };
        Self { programs: vec![Program { name: String::new(), paths, kind: Kind::Sources }], folders: Vec::new() }
    }

    /// The programs of the paths: each of a folder that holds several, with the other paths.
    pub(crate) fn of(paths: &[PathBuf], encoding: Option<Encoding>) -> Result<Self, Failure> {
        let mut chosen = Self::one(paths);
        let (mut folders, mut others) = (Vec::new(), Vec::new());
        for path in &chosen.programs[0].paths {
            match Folder::of(path, encoding)?.filter(Folder::has_several) {
                Some(folder) => {
                    folder.limit()?;
                    folders.push(folder);
                }
                None => others.push(path.clone()),
            }
        }
        if !folders.is_empty() {
            let all = folders.iter().flat_map(|folder| &folder.programs);
            let with = |program: &Program| Program { paths: others.iter().chain(&program.paths).cloned().collect(), ..program.clone() };
            chosen = Self { programs: all.map(with).collect(), folders };
        }
        Ok(chosen)
    }
}

/// A path as a shell takes it.
fn quoted(path: &Path) -> String {
    let plain = visible::name(&shown(path));
    if plain.contains([' ', '\t', '(', ')', '&', ';', '\'']) { format!("\"{plain}\"") } else { plain }
}

/// A list in words, cut where it becomes long.
fn listed(names: &[String]) -> String {
    let names: Vec<String> = names.iter().map(|name| visible::name(name)).collect();
    match names.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        [all @ .., last] if names.len() <= NAMED_MAX => format!("{} and {last}", all.join(", ")),
        _ => format!("{} and {} more", names[..NAMED_MAX - 1].join(", "), names.len() - NAMED_MAX + 1),
    }
}

/// What a test file tests by its name, without ending.
pub(crate) fn tested(test: &Path) -> String {
    let name = test.file_name().map(OsStr::to_string_lossy).unwrap_or_default();
    role::tested(&name).to_owned()
}

/// Whether a source has this name, its ending left out.
pub(crate) fn is_called(source: &Path, name: &str) -> bool {
    source.file_stem().is_some_and(|stem| stem.to_string_lossy().to_lowercase() == name.to_lowercase())
}

/// Whether a file is a symbol table that a folder reads without being told.
pub(crate) fn is_symbols_by_default(path: &Path) -> bool {
    paths::is_symbol_table(path) || path.file_name().is_some_and(|name| name.eq_ignore_ascii_case("symbols.csv"))
}

/// Finds out which of the named organization blocks are OB 1, by the symbol tables.
fn resolve(sources: &mut [Found], tables: &[PathBuf], encoding: Option<Encoding>) {
    if sources.iter().all(|found| found.role.named.is_empty()) {
        return;
    }
    let mut documents = Sources::default();
    let tables: Vec<_> =
        tables.iter().filter_map(|path| symbol_files::read(path, encoding, &mut documents).ok()).map(|file| file.read.table).collect();
    let is_cycle = |name: &String| {
        let operands = tables.iter().filter_map(|table| table.find(name)?.operand());
        operands.into_iter().any(|operand| operand == Operand::Block(BlockId::ob(1)))
    };
    for found in sources {
        found.role.cycle |= found.role.named.iter().any(is_cycle);
    }
}
