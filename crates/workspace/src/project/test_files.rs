//! What is wrong with a test file, beside the program that it tests.

use std::path::Path;

use super::{Overrides, Project};
use crate::finding::{Finding, Origin, Texts};

impl Project {
    /// Everything that is wrong in a test file with this program; its text goes to the documents. The program runs without it: these are warnings.
    pub fn findings_of_test(&self, path: &Path, bytes: &[u8], overrides: Overrides, texts: &mut Texts) -> Vec<Finding> {
        let mut project = self.clone();
        let (noticed, known) = (project.findings.len(), project.sources.len());
        project.add_source(path, bytes);
        let Some(test) = project.sources.get(known).map(|source| source.id) else {
            return project.findings.split_off(noticed).into_iter().map(Finding::in_test).collect();
        };
        let build = project.compile(Overrides { tests: true, ..overrides }, false);
        let own = build.findings.into_iter().filter(|found| found.origin == Origin::Program && found.diagnostic.span.file == test);
        let mut own: Vec<Finding> = own.map(Finding::in_test).collect();
        if !own.is_empty() {
            let source = build.project.texts.program.file(test);
            let document = texts.documents.add(source.name.clone(), source.text.clone());
            for finding in &mut own {
                finding.origin = Origin::Document;
                let diagnostic = &mut finding.diagnostic;
                diagnostic.span.file = document;
                // What lies in other texts, and fixes of what is no source, are left out.
                (diagnostic.related, diagnostic.fix) = (Vec::new(), None);
            }
        }
        own
    }
}
