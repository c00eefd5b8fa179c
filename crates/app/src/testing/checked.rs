//! What is wrong with the test files of a program that is right.

use std::path::{Path, PathBuf};

use sieben_workspace::finding::{Finding, Texts};
use sieben_workspace::project::{Overrides, Project};

use crate::{files, paths, programs};

/// The test files among these, without scenarios and programs that check themselves.
pub(crate) fn unit_tests(project: &Project) -> Vec<PathBuf> {
    let is_one = |test: &&PathBuf| !paths::is_scenario(test) && programs::is_test(test, project.encoding);
    project.tests.iter().filter(is_one).cloned().collect()
}

/// What is wrong with one of them. One that cannot be read says so where it is run.
pub(crate) fn findings(project: &Project, test: &Path, overrides: Overrides, texts: &mut Texts) -> Vec<Finding> {
    files::read(test).map_or_else(|_| Vec::new(), |bytes| project.findings_of_test(test, &bytes, overrides, texts))
}
