//! From the paths of the command line to tests.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::{Case, self_checking};
use crate::awlpro;
use crate::failure::Failure;
use crate::project::{self, Project};
use crate::settings;

/// The tests that the paths mean; none = the current folder. Each of `tests` is a test of the program that the paths are.
pub(crate) fn cases(paths: &[PathBuf], tests: &[PathBuf]) -> Result<Vec<Case>, Failure> {
    if !tests.is_empty() {
        for test in tests {
            // A test that does not exist is a mistake of the command line, not of the program.
            crate::files::read(test)?;
        }
        let program = paths.to_vec();
        return Ok(tests.iter().map(|test| case(project::shown(test), program.clone(), Some(test.clone()))).collect());
    }
    let here = [PathBuf::from(".")];
    let paths = if paths.is_empty() { &here } else { paths };
    let (tables, paths): (Vec<_>, Vec<_>) = paths.iter().cloned().partition(|path| !path.is_dir() && project::is_symbols(path));
    let mut cases = Vec::new();
    for path in paths {
        let with_tables = |path: PathBuf| tables.iter().cloned().chain([path]).collect::<Vec<_>>();
        if !path.is_dir() {
            crate::files::read(&path)?;
            cases.push(case(project::shown(&path), with_tables(path), None));
        } else if path.join(settings::FILE_NAME).is_file() {
            cases.extend(of_project(&path)?);
        } else {
            let (projects, files) = below(&path)?;
            for file in files {
                cases.push(unnamed(project::shown(&file), with_tables(file)));
            }
            for project in projects {
                cases.extend(of_project(&project)?);
            }
        }
    }
    Ok(cases)
}

fn case(name: String, program: Vec<PathBuf>, test: Option<PathBuf>) -> Case {
    Case { name, run: Box::new(move |conditions| self_checking::run(&program, test.as_ref(), true, conditions)) }
}

/// A program that was found in a folder: it is a test if it checks itself.
fn unnamed(name: String, program: Vec<PathBuf>) -> Case {
    Case { name, run: Box::new(move |conditions| self_checking::run(&program, None, false, conditions)) }
}

/// The tests that `sieben.toml` names; a project without any is one test itself.
fn of_project(folder: &Path) -> Result<Vec<Case>, Failure> {
    let program = vec![folder.to_path_buf()];
    let project = Project::load(&program, None)?;
    if project.tests.is_empty() {
        let name = project.settings.name.unwrap_or_else(|| project::shown(folder));
        return Ok(vec![unnamed(name, program)]);
    }
    Ok(project.tests.into_iter().map(|test| case(project::shown(&test), program.clone(), Some(test))).collect())
}

/// The projects and the programs of a folder that is no project: every source by itself. What a project names belongs to that.
fn below(folder: &Path) -> Result<(BTreeSet<PathBuf>, Vec<PathBuf>), Failure> {
    let mut files: Vec<PathBuf> = project::files_below(folder)?.into_iter().filter(|file| project::is_program(file)).collect();
    let mut projects = BTreeSet::new();
    files.retain(|file| {
        let inside = file.ancestors().skip(1).take_while(|parent| *parent != folder);
        let project = inside.filter(|parent| parent.join(settings::FILE_NAME).is_file()).last();
        projects.extend(project.map(Path::to_path_buf));
        project.is_none()
    });
    let parts: BTreeSet<PathBuf> = files.iter().filter(|file| awlpro::is_project(file)).flat_map(|file| awlpro::parts(file)).collect();
    files.retain(|file| !parts.contains(file));
    Ok((projects, files))
}
