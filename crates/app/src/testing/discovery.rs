//! From the paths of the command line to tests.

use std::path::{Path, PathBuf};

use sieben_lang::encoding::Encoding;
use sieben_model::problems::Problem;
use sieben_workspace::finding::{Finding, Texts};
use sieben_workspace::settings;
use sieben_workspace::testing::self_checking::FirstSource;
use sieben_workspace::testing::{Case, Conditions, Outcome, Stopwatch, Verdict, scenario, self_checking, unit};

use crate::failure::Failure;
use crate::paths::{self, folder_of, is_scenario, is_source};
use crate::programs::{self, Folder, Kind, Tested};
use crate::project;
use crate::report;
use crate::tracing::scenario::{self as files, Unusable};

/// The tests that were found.
#[derive(Default)]
pub(crate) struct Discovered {
    /// The tests.
    pub(crate) cases: Vec<Case>,
    /// The folders among the paths that hold several programs.
    pub(crate) folders: Vec<Folder>,
}

/// The tests that the paths mean; none = the current folder. Each of `tests` is a test of the program that the paths are.
pub(crate) fn cases(paths: &[PathBuf], tests: &[PathBuf], conditions: &Conditions) -> Result<Discovered, Failure> {
    let mut found = Discovered::default();
    if !tests.is_empty() {
        for test in tests {
            // A test that does not exist is a mistake of the command line, not of the program.
            exists(test)?;
        }
        for test in tests {
            found.cases.extend(named(test, paths, conditions)?);
        }
        return Ok(found);
    }
    let here = [PathBuf::from(".")];
    let paths = if paths.is_empty() { &here } else { paths };
    let is_file = |path: &PathBuf| !path.is_dir();
    let is_table = |path: &PathBuf| is_file(path) && paths::is_symbols(path);
    let (tables, paths): (Vec<_>, Vec<_>) = paths.iter().cloned().partition(is_table);
    let is_unit = |path: &PathBuf| is_file(path) && (is_scenario(path) || programs::is_test(path, conditions.encoding));
    let (units, paths): (Vec<_>, Vec<_>) = paths.into_iter().partition(is_unit);
    for test in &units {
        exists(test)?;
        // Files beside a test file are the program that it tests; without any it is what lies around it.
        if paths.is_empty() {
            found.cases.extend(of_programs(test, &programs_around(test, &tables, conditions)?, true, conditions));
        } else {
            found.cases.extend(cases_of(test, &tables.iter().chain(&paths).cloned().collect::<Vec<_>>(), true, conditions));
        }
    }
    if !units.is_empty() {
        return Ok(found);
    }
    for path in paths {
        if !path.is_dir() {
            crate::files::read(&path)?;
            found.cases.extend(of_file(&path, &tables, conditions)?);
            continue;
        }
        match Folder::of(&path, conditions.encoding)? {
            None => found.cases.extend(of_project(&path, conditions)?),
            Some(folder) => {
                found.cases.extend(of_folder(&folder, &tables, conditions)?);
                if folder.has_several() {
                    found.folders.push(folder);
                }
            }
        }
    }
    Ok(found)
}

/// The project around a file, if there is one: the nearest folder with a `sieben.toml`.
fn project_around(file: &Path) -> Option<PathBuf> {
    let project = folder_of(file).ancestors().find(|folder| folder.join(settings::FILE_NAME).is_file())?;
    Some(if project.as_os_str().is_empty() { PathBuf::from(".") } else { project.to_path_buf() })
}

/// A program to test: what reports call it, if there are several, and its files.
type ToTest = (Option<String>, Vec<PathBuf>);

/// What lies around a test file that it tests: the project around it, the program of that name in its folder, or the whole folder.
fn programs_around(test: &Path, tables: &[PathBuf], conditions: &Conditions) -> Result<Vec<ToTest>, Failure> {
    let with = |paths: &[PathBuf]| tables.iter().chain(paths).cloned().collect::<Vec<_>>();
    if let Some(project) = project_around(test) {
        return Ok(vec![(None, with(&[project]))]);
    }
    let root = folder_of(test).to_path_buf();
    match Folder::of(&root, conditions.encoding)?.filter(Folder::has_several) {
        None => Ok(vec![(None, with(&[root]))]),
        Some(folder) => tested(&folder, test, tables),
    }
}

/// What a test file tests in a folder with several programs.
fn tested(folder: &Folder, test: &Path, tables: &[PathBuf]) -> Result<Vec<ToTest>, Failure> {
    let with = |paths: &[PathBuf]| tables.iter().chain(paths).cloned().collect::<Vec<_>>();
    // As the folder calls it, whatever the command line did.
    let test = folder.as_found(test);
    match folder.tested_by(&test) {
        Tested::Programs(places) => {
            let programs = places.into_iter().map(|place| &folder.programs[place]);
            Ok(programs.map(|program| (Some(program.name.clone()), with(&program.paths))).collect())
        }
        Tested::Blocks(paths) => Ok(vec![(None, with(&paths))]),
        Tested::Nothing => Err(folder.stray(&test)),
    }
}

/// The tests of a file for each of these programs.
fn of_programs(test: &Path, programs: &[ToTest], named: bool, conditions: &Conditions) -> Vec<Case> {
    let mut all = Vec::new();
    for (name, program) in programs {
        let mut cases = cases_of(test, program, named, conditions);
        for case in &mut cases {
            case.program.clone_from(name);
            if let Some(name) = name.as_ref().filter(|_| programs.len() > 1) {
                case.name = format!("{} ({name})", case.name);
            }
        }
        all.extend(cases);
    }
    all
}

/// A file that `--tests` names, for the program that the paths are.
fn named(test: &Path, paths: &[PathBuf], conditions: &Conditions) -> Result<Vec<Case>, Failure> {
    let unit = is_scenario(test) || programs::is_test(test, conditions.encoding);
    match paths {
        [] if unit => Ok(of_programs(test, &programs_around(test, &[], conditions)?, true, conditions)),
        [folder] if unit && folder.is_dir() => match Folder::of(folder, conditions.encoding)?.filter(Folder::has_several) {
            Some(folder) => Ok(of_programs(test, &tested(&folder, test, &[])?, true, conditions)),
            None => Ok(cases_of(test, paths, true, conditions)),
        },
        _ => Ok(cases_of(test, paths, true, conditions)),
    }
}

/// The tests of a file for a program: unit tests, a scenario, or a program that checks itself. A scenario that nobody `named` and that
/// expects nothing is no test.
fn cases_of(test: &Path, program: &[PathBuf], named: bool, conditions: &Conditions) -> Vec<Case> {
    match () {
        () if is_scenario(test) && !named && !expects(test) => Vec::new(),
        () if is_scenario(test) => vec![scenario_case(program.to_vec(), test.to_path_buf(), named)],
        () if programs::is_test(test, conditions.encoding) => {
            let all: Vec<PathBuf> = program.iter().cloned().chain([test.to_path_buf()]).collect();
            let project = project::load(&all, conditions.encoding).map_err(|failure| failure.refusal);
            unit::cases(&paths::shown(test), project, conditions)
        }
        () => vec![case(paths::shown(test), program.to_vec(), Some(test.to_path_buf()))],
    }
}

/// The test of a scenario for a program. One that nobody `named` has to expect something.
fn scenario_case(program: Vec<PathBuf>, file: PathBuf, named: bool) -> Case {
    let scenario = Some(file.clone());
    let name = paths::shown(&file);
    let run = move |conditions: &Conditions| {
        let outcome = hold(&program, &file, named, conditions).unwrap_or_else(Outcome::nothing_ran);
        if let Some(warning) = &outcome.warning {
            report::print(&[Finding::file(Problem::P6263, paths::shown(&file), warning)], &Texts::default(), false);
        }
        outcome
    };
    Case { scenario, ..Case::new(name, Box::new(run)) }
}

/// Holds a program against a scenario, or says why that cannot be done.
fn hold(program: &[PathBuf], file: &Path, named: bool, conditions: &Conditions) -> Result<Outcome, Verdict> {
    let stopwatch = Stopwatch::start(&conditions.outside);
    let scenario = files::read(file).map_err(|unusable| match unusable {
        Unusable::File(failure) => Verdict::Unreadable(failure.refusal),
        Unusable::Lines(refusals) => Verdict::Misread(refusals),
    })?;
    if !named && !scenario.expects() {
        return Err(Verdict::NoTest);
    }
    let project = project::load(program, conditions.encoding).map_err(|failure| Verdict::Unreadable(failure.refusal))?;
    Ok(scenario::run(project, scenario, &paths::shown(file), stopwatch, conditions))
}

/// Whether a scenario expects anything; one that cannot be read says so when it is run.
fn expects(file: &Path) -> bool {
    files::read(file).map_or(true, |scenario| scenario.expects())
}

/// Runs a program that checks itself. The blocks of `test`, if there is one, take the place of those of the program.
fn check_itself(program: &[PathBuf], test: Option<&PathBuf>, named: bool, conditions: &Conditions) -> Outcome {
    let stopwatch = Stopwatch::start(&conditions.outside);
    let all: Vec<PathBuf> = test.into_iter().chain(program).cloned().collect();
    let first = if test.is_some() { FirstSource::Replaces } else { FirstSource::Belongs };
    match project::load(&all, conditions.encoding) {
        Ok(project) => self_checking::run(project, first, named, &stopwatch, conditions),
        Err(failure) => Outcome::nothing_ran(Verdict::Unreadable(failure.refusal)),
    }
}

/// Whether a program checks itself; one that cannot be read or compiled says so when it is run.
pub(crate) fn checks_itself(program: &[PathBuf], conditions: &Conditions) -> bool {
    project::load(program, conditions.encoding).map_or(true, |project| self_checking::is_test(project, conditions))
}

/// A test that does not exist is a mistake of the command line.
fn exists(test: &Path) -> Result<(), Failure> {
    if is_scenario(test) { crate::files::open(test).map(drop) } else { crate::files::read(test).map(drop) }
}

fn case(name: String, program: Vec<PathBuf>, test: Option<PathBuf>) -> Case {
    Case::new(name, Box::new(move |conditions| check_itself(&program, test.as_ref(), true, conditions)))
}

/// A program that was found: it is a test if it checks itself. One that is `tested` by others leaves it to them to say that it does not
/// compile.
fn unnamed(name: String, program: Vec<PathBuf>, tested: bool) -> Case {
    let perhaps = Some(program.clone());
    let run = move |conditions: &Conditions| {
        let outcome = check_itself(&program, None, false, conditions);
        match outcome.verdict {
            Verdict::DoesNotCompile(_) if tested => Outcome { verdict: Verdict::NoTest, ..outcome },
            _ => outcome,
        }
    };
    Case { perhaps, ..Case::new(name, Box::new(run)) }
}

/// A test that cannot be run, and why.
fn broken(name: String, failure: Failure) -> Case {
    let run = move |_: &Conditions| Outcome::nothing_ran(Verdict::Unreadable(failure.refusal.clone()));
    Case { file: Some(name.clone()), ..Case::new(name, Box::new(run)) }
}

/// The tests of a program that was named: those beside it that are called like it, else it is one itself.
fn of_file(path: &Path, tables: &[PathBuf], conditions: &Conditions) -> Result<Vec<Case>, Failure> {
    let beside = beside(path, conditions.encoding);
    if beside.is_empty() {
        return Ok(vec![case(paths::shown(path), tables.iter().cloned().chain([path.to_path_buf()]).collect(), None)]);
    }
    let mut cases = Vec::new();
    for test in &beside {
        let mut programs = programs_around(test, tables, conditions)?;
        // The tests may be those of another program with this name, too.
        if programs.iter().any(|(_, files)| is_among(path, files)) {
            programs.retain(|(_, files)| is_among(path, files));
        }
        if cases.is_empty() {
            let program = programs.first().map(|(_, files)| files.clone()).unwrap_or_default();
            cases.push(unnamed(paths::shown(path), program, true));
        }
        cases.extend(of_programs(test, &programs, false, conditions));
    }
    Ok(cases)
}

/// Whether a file is one of these.
fn is_among(path: &Path, files: &[PathBuf]) -> bool {
    files.iter().any(|file| file.file_name() == path.file_name() && std::fs::canonicalize(file).ok() == std::fs::canonicalize(path).ok())
}

/// The test files and scenarios in the folder of a source that are called like it.
fn beside(path: &Path, encoding: Option<Encoding>) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder_of(path)) else { return Vec::new() };
    let is_called_alike = |file: &PathBuf| {
        (is_scenario(file) || is_source(file)) && programs::is_called(path, &programs::tested(file)) && file.file_name() != path.file_name()
    };
    let files = entries.filter_map(|entry| Some(paths::join(folder_of(path), Path::new(&entry.ok()?.file_name()))));
    let tests = files.filter(is_called_alike).filter(|file| file.is_file());
    let mut tests: Vec<PathBuf> = tests.filter(|file| is_scenario(file) || programs::is_test(file, encoding)).collect();
    tests.sort();
    tests
}

/// The tests of a project: those that `sieben.toml` names, else its test files; without other tests a project may be one itself.
fn of_project(folder: &Path, conditions: &Conditions) -> Result<Vec<Case>, Failure> {
    let program = vec![folder.to_path_buf()];
    let project = project::load(&program, conditions.encoding)?;
    let mut cases = Vec::new();
    let is_unit = |test: &PathBuf| is_scenario(test) || programs::is_test(test, conditions.encoding);
    if project.tests.iter().all(is_unit) {
        let name = project.settings.name.unwrap_or_else(|| paths::shown(folder));
        cases.push(unnamed(name, program.clone(), !project.tests.is_empty()));
    }
    cases.extend(project.tests.iter().flat_map(|test| cases_of(test, &program, false, conditions)));
    Ok(cases)
}

/// The tests of a folder that is no project, program by program.
fn of_folder(folder: &Folder, tables: &[PathBuf], conditions: &Conditions) -> Result<Vec<Case>, Failure> {
    folder.limit()?;
    let several = folder.has_several();
    let mut cases = Vec::new();
    let with = |paths: &[PathBuf]| tables.iter().chain(paths).cloned().collect::<Vec<_>>();
    let several_of = |test: &Tested| matches!(test, Tested::Programs(places) if places.len() > 1);
    for (place, program) in folder.programs.iter().enumerate() {
        let first = cases.len();
        if program.kind == Kind::Project {
            cases.extend(of_project(&program.paths[0], conditions)?);
        } else {
            let tests = folder.tests.iter().filter(|test| matches!(&test.tests, Tested::Programs(places) if places.contains(&place)));
            let at = cases.len();
            for test in tests {
                let mut of_test = cases_of(&test.path, &with(&program.paths), false, conditions);
                if several_of(&test.tests) {
                    of_test.iter_mut().for_each(|case| case.name = format!("{} ({})", case.name, program.name));
                }
                cases.extend(of_test);
            }
            cases.insert(at, unnamed(program.name.clone(), with(&program.paths), cases.len() > at));
        }
        if several {
            cases[first..].iter_mut().for_each(|case| case.program = Some(program.name.clone()));
        }
    }
    for test in &folder.tests {
        match &test.tests {
            Tested::Programs(_) => {}
            Tested::Blocks(paths) => cases.extend(cases_of(&test.path, &with(paths), false, conditions)),
            Tested::Nothing if is_scenario(&test.path) && !expects(&test.path) => {}
            Tested::Nothing if several => cases.push(broken(paths::shown(&test.path), folder.stray(&test.path))),
            // Without a program a test file may still test itself.
            Tested::Nothing => cases.extend(cases_of(&test.path, &with(&[]), false, conditions)),
        }
    }
    Ok(cases)
}

/// The failure of a run in which no test was found.
pub(crate) fn nothing() -> Failure {
    Failure::usage(Problem::P7020, "there is no test here")
}
