//! Paths: what a file is by its name, which files a folder holds, and how people read them.

use std::fs;
use std::path::{Component, Path, PathBuf};

use sieben_lang::language::LANGUAGES;
use sieben_lang::language::role::is_test_name;
use sieben_model::problems::Problem;

use crate::failure::Failure;
use crate::files;

/// The settings of a project.
const PROJECT_ENDING: &str = "toml";
/// Endings of symbol tables of other tools; of `.csv` files only `symbols.csv` is one without being named.
const SYMBOL_ENDINGS: [&str; 4] = ["sdf", "asc", "dif", "seq"];
/// Projects of awlsim.
const AWLSIM_ENDING: &str = "awlpro";
/// Scenarios.
const SCENARIO_ENDING: &str = "scenario";
/// The folder beside a campaign that has what failed in it: tests from then on.
pub(crate) const FAILURES: &str = "failures";
/// Most files a folder is searched for: a home directory given by mistake must not be read for minutes.
const FILES_MAX: usize = 20_000;
/// Deepest folder that is searched.
const DEPTH_MAX: usize = 16;

/// Whether a file holds unit tests by its name alone.
pub(crate) fn is_test(path: &Path) -> bool {
    path.file_name().and_then(|name| name.to_str()).is_some_and(is_test_name)
}

/// Whether a file is a program by its name.
pub(crate) fn is_program(path: &Path) -> bool {
    is_source(path) && !is_test(path) || is_awlsim_project(path)
}

/// Whether a file is a source by its ending.
pub(crate) fn is_source(path: &Path) -> bool {
    let of_sources = LANGUAGES.iter().flat_map(|row| row.endings).filter(|one| one.in_folders);
    of_sources.map(|one| one.ending).any(|ending| has_ending(path, &[ending]))
}

/// Whether a file is a project of awlsim by its name.
pub(crate) fn is_awlsim_project(path: &Path) -> bool {
    has_ending(path, &[AWLSIM_ENDING])
}

/// Whether a file is a scenario by its name.
pub(crate) fn is_scenario(path: &Path) -> bool {
    has_ending(path, &[SCENARIO_ENDING])
}

/// Whether a file named on the command line is a symbol table by its name.
pub(crate) fn is_symbols(path: &Path) -> bool {
    is_symbol_table(path) || has_ending(path, &["csv"])
}

/// Whether a file is a symbol table of another tool by its name.
pub(crate) fn is_symbol_table(path: &Path) -> bool {
    has_ending(path, &SYMBOL_ENDINGS)
}

fn has_ending(path: &Path, endings: &[&str]) -> bool {
    path.extension().is_some_and(|ending| endings.iter().any(|known| ending.eq_ignore_ascii_case(known)))
}

/// Whether a pattern points outside the folder it is relative to.
pub(crate) fn leaves_folder(pattern: &str) -> bool {
    let path = Path::new(pattern);
    path.components().any(|part| !matches!(part, Component::Normal(_) | Component::CurDir))
        || pattern.contains('\\')
        || pattern.contains(':')
}

/// A path inside a folder, without a `./` in front that nobody typed.
pub(crate) fn join(folder: &Path, relative: &Path) -> PathBuf {
    if folder == Path::new(".") { relative.to_path_buf() } else { folder.join(relative) }
}

/// The folder that a file lies in.
pub(crate) fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// A path with `/` on every system, as patterns have it.
pub(crate) fn slashed(path: &Path) -> String {
    path.to_string_lossy().replace('\\', "/")
}

/// A path as people read it.
pub(crate) fn shown(path: &Path) -> String {
    path.display().to_string()
}

/// Refuses to write results over a program: `--svg main.awl` is a slip that must not cost the source.
pub(crate) fn spare_sources<'a>(results: impl IntoIterator<Item = &'a PathBuf>) -> Result<(), Failure> {
    let is_part = |path: &Path| is_source(path) || has_ending(path, &SYMBOL_ENDINGS) || has_ending(path, &[PROJECT_ENDING]);
    match results.into_iter().find(|path| is_part(path) && path.is_file()) {
        Some(path) => Err(Failure::usage(Problem::P6013, format!("`{}` is a source, and results do not replace it", path.display()))
            .help("give the file another name; remove the old one first if it is none of your program")),
        None => Ok(()),
    }
}

/// Paths of all files of a folder.
pub(crate) struct Listing<'a> {
    /// Relative to the folder, in order.
    pub(crate) files: Vec<PathBuf>,
    /// Links to files elsewhere: a project that somebody sends must not read what is not its own.
    pub(crate) links_outside: Vec<PathBuf>,
    /// The folder.
    pub(crate) root: &'a Path,
}

impl<'a> Listing<'a> {
    /// Looks through a folder.
    pub(crate) fn of(root: &'a Path) -> Result<Self, Failure> {
        let mut listing = Self { files: Vec::new(), links_outside: Vec::new(), root };
        listing.walk(root, 0)?;
        let open = files::open_without_file(root);
        if !open.is_empty() {
            listing.files.extend(open);
            listing.files.sort();
        }
        Ok(listing)
    }

    /// Whether a link leads to a file of the folder.
    fn holds(&self, link: &Path) -> bool {
        match (fs::canonicalize(link), fs::canonicalize(self.root)) {
            (Ok(target), Ok(root)) => target.starts_with(root),
            _ => false,
        }
    }

    /// Collects the files of a folder and those below. Hidden folders are left out, links to folders are not followed.
    fn walk(&mut self, folder: &Path, depth: usize) -> Result<(), Failure> {
        let unreadable = |error| Failure::usage(Problem::P6001, format!("the folder `{}` cannot be read: {error}", folder.display()));
        let mut entries = Vec::new();
        for entry in fs::read_dir(folder).map_err(unreadable)? {
            let entry = entry.map_err(unreadable)?;
            entries.push((entry.file_name(), entry.path(), entry.file_type().map_err(unreadable)?));
            if self.files.len() + entries.len() > FILES_MAX {
                return Err(Failure::usage(Problem::P6015, format!("`{}` holds more than {FILES_MAX} files", self.root.display())));
            }
        }
        entries.sort_by(|a, b| a.0.cmp(&b.0));
        for (name, path, kind) in entries {
            let hidden = name.to_string_lossy().starts_with('.');
            if kind.is_dir() {
                if !hidden && depth < DEPTH_MAX {
                    self.walk(&path, depth + 1)?;
                }
            } else if !hidden
                && path.is_file()
                && let Ok(relative) = path.strip_prefix(self.root)
            {
                let inside = !kind.is_symlink() || self.holds(&path);
                let list = if inside { &mut self.files } else { &mut self.links_outside };
                list.push(relative.to_path_buf());
            }
        }
        Ok(())
    }
}

/// The files of a folder and those below it, as a project would find them.
pub(crate) fn files_below(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let listing = Listing::of(folder)?;
    Ok(listing.files.iter().map(|file| join(folder, file)).collect())
}
