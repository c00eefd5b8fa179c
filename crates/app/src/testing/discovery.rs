//! From the paths of the command line to tests.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::{Case, Conditions, scenario, self_checking, unit};
use crate::failure::Failure;
use crate::paths::{self, is_scenario};
use crate::project::{Project, awlpro};
use crate::settings;

/// The tests that the paths mean; none = the current folder. Each of `tests` is a test of the program that the paths are.
pub(crate) fn cases(paths: &[PathBuf], tests: &[PathBuf], conditions: &Conditions) -> Result<Vec<Case>, Failure> {
    if !tests.is_empty() {
        for test in tests {
            // A test that does not exist is a mistake of the command line, not of the program.
            exists(test)?;
        }
        return Ok(tests.iter().flat_map(|test| cases_of(test, paths, conditions)).collect());
    }
    let here = [PathBuf::from(".")];
    let paths = if paths.is_empty() { &here } else { paths };
    let is_file = |path: &PathBuf| !path.is_dir();
    let (tables, paths): (Vec<_>, Vec<_>) = paths.iter().cloned().partition(|path| is_file(path) && paths::is_symbols(path));
    let (units, paths): (Vec<_>, Vec<_>) = paths.into_iter().partition(|path| is_file(path) && (paths::is_test(path) || is_scenario(path)));
    let mut cases = Vec::new();
    for test in &units {
        exists(test)?;
        // Files beside a test file are the program that it tests; without any it is what lies around it.
        let program = match paths.is_empty() {
            true => tables.iter().cloned().chain([program_around(test)]).collect(),
            false => tables.iter().chain(&paths).cloned().collect::<Vec<_>>(),
        };
        cases.extend(cases_of(test, &program, conditions));
    }
    if !units.is_empty() {
        return Ok(cases);
    }
    for path in paths {
        let with_tables = |path: PathBuf| tables.iter().cloned().chain([path]).collect::<Vec<_>>();
        if !path.is_dir() {
            crate::files::read(&path)?;
            cases.push(case(paths::shown(&path), with_tables(path), None));
        } else if path.join(settings::FILE_NAME).is_file() {
            cases.extend(of_project(&path, conditions)?);
        } else {
            let Below { projects, files, tests } = below(&path)?;
            for file in files {
                cases.push(unnamed(paths::shown(&file), with_tables(file)));
            }
            for test in tests {
                cases.extend(found(&test, &with_tables(program_around(&test)), conditions));
            }
            for project in projects {
                cases.extend(of_project(&project, conditions)?);
            }
        }
    }
    Ok(cases)
}

/// The folder with the program that a test file is about: the nearest project around it, else the folder where it lies.
fn program_around(test: &Path) -> PathBuf {
    let folder = test.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let project = folder.ancestors().find(|folder| folder.join(settings::FILE_NAME).is_file());
    let project = project.map(|project| if project.as_os_str().is_empty() { Path::new(".") } else { project });
    project.unwrap_or(folder).to_path_buf()
}

/// The tests of a file for a program: unit tests, or a program that checks itself.
fn cases_of(test: &Path, program: &[PathBuf], conditions: &Conditions) -> Vec<Case> {
    let program_or_around = || if program.is_empty() { vec![program_around(test)] } else { program.to_vec() };
    match paths::is_test(test) {
        _ if is_scenario(test) => vec![scenario::case(program_or_around(), test.to_path_buf(), true)],
        true => unit::cases(&program_or_around(), test, conditions),
        false => vec![case(paths::shown(test), program.to_vec(), Some(test.to_path_buf()))],
    }
}

/// A test file that lies in a folder: a scenario that expects nothing is no test.
fn found(test: &Path, program: &[PathBuf], conditions: &Conditions) -> Vec<Case> {
    match is_scenario(test) {
        true if scenario::is_test(test) => vec![scenario::case(program.to_vec(), test.to_path_buf(), false)],
        true => Vec::new(),
        false => cases_of(test, program, conditions),
    }
}

/// A test that does not exist is a mistake of the command line.
fn exists(test: &Path) -> Result<(), Failure> {
    if is_scenario(test) { crate::files::open(test).map(drop) } else { crate::files::read(test).map(drop) }
}

fn case(name: String, program: Vec<PathBuf>, test: Option<PathBuf>) -> Case {
    Case {
        name,
        file: None,
        perhaps: None,
        scenario: None,
        run: Box::new(move |conditions| self_checking::run(&program, test.as_ref(), true, conditions)),
    }
}

/// A program that was found in a folder: it is a test if it checks itself.
fn unnamed(name: String, program: Vec<PathBuf>) -> Case {
    let perhaps = Some(program.clone());
    Case {
        name,
        file: None,
        perhaps,
        scenario: None,
        run: Box::new(move |conditions| self_checking::run(&program, None, false, conditions)),
    }
}

/// The tests of a project: those that `sieben.toml` names, else its test files; without other tests a project may be one itself.
fn of_project(folder: &Path, conditions: &Conditions) -> Result<Vec<Case>, Failure> {
    let program = vec![folder.to_path_buf()];
    let project = Project::load(&program, None)?;
    let mut cases = Vec::new();
    if project.tests.iter().all(|test| paths::is_test(test) || is_scenario(test)) {
        let name = project.settings.name.unwrap_or_else(|| paths::shown(folder));
        cases.push(unnamed(name, program.clone()));
    }
    cases.extend(project.tests.iter().flat_map(|test| found(test, &program, conditions)));
    Ok(cases)
}

/// What lies in a folder that is no project.
struct Below {
    projects: BTreeSet<PathBuf>,
    /// Programs: every source by itself.
    files: Vec<PathBuf>,
    /// Test files.
    tests: Vec<PathBuf>,
}

/// The projects, programs and test files of a folder that is no project. What a project names belongs to that.
fn below(folder: &Path) -> Result<Below, Failure> {
    let all = paths::files_below(folder)?;
    let mut projects = BTreeSet::new();
    let mut outside = |file: &PathBuf| {
        let inside = file.ancestors().skip(1).take_while(|parent| *parent != folder);
        let project = inside.filter(|parent| parent.join(settings::FILE_NAME).is_file()).last();
        projects.extend(project.map(Path::to_path_buf));
        project.is_none()
    };
    let mut files: Vec<PathBuf> = all.iter().filter(|file| paths::is_program(file) && outside(file)).cloned().collect();
    let tests = all.iter().filter(|file| (paths::is_test(file) || is_scenario(file)) && outside(file)).cloned().collect();
    let parts: BTreeSet<PathBuf> =
        files.iter().filter(|file| paths::is_awlsim_project(file)).flat_map(|file| awlpro::parts(file)).collect();
    files.retain(|file| !parts.contains(file));
    Ok(Below { projects, files, tests })
}
