//! Projects made from memory alone.

use std::path::Path;
use std::sync::Arc;

use sieben_cpu::{Cpu, Loaded, Rack, Restart, Settings};
use sieben_engine::Interpreter;
use sieben_sim::names::Name;

use super::{Build, Overrides, Project};
use crate::finding;

const SOURCE: &[u8] = b"ORGANIZATION_BLOCK OB 1\nBEGIN\n  L \"count\"\n  L 1\n  +I\n  T \"count\"\nEND_ORGANIZATION_BLOCK\n";

fn codes(build: &Build) -> Vec<&'static str> {
    build.findings.iter().map(|finding| finding.diagnostic.problem.code()).collect()
}

#[test]
fn a_project_made_of_strings_runs() {
    let mut project = Project::default();
    project.add_settings(Path::new("sieben.toml"), b"[cpu]\ntype = \"416-3\"\n[[module]]\nkind = \"tank\"\ninput = 4\noutput = 4\n");
    project.add_symbols(Path::new("symbols.csv"), b"symbol;address;type;comment\ncount;MW10;INT;scans\n").expect("a symbol table");
    project.add_source(Path::new("main.awl"), SOURCE);
    let build = project.compile(Overrides::default(), false);
    assert_eq!(codes(&build), [""; 0]);
    assert_eq!((build.cpu.name, build.project.settings.modules.len()), ("416-3", 1));
    let loaded = Loaded::new(build.cpu, Arc::new(build.compiled.program.clone()), Interpreter::load);
    let mut cpu = Cpu::new(loaded, Rack::simulated(build.cpu), Settings::default());
    cpu.restart_with(Restart::Warm, &mut || 0, None);
    for scan in 0..3 {
        cpu.scan_with(&mut || scan * 10_000, None);
    }
    let count = Name::parse("count", &build.project.symbols, cpu.program()).expect("the symbol is known");
    assert_eq!(count.read(&cpu).map(|value| value.to_string()), Ok("3".to_owned()));
}

#[test]
fn what_is_wrong_with_a_text_is_a_finding_of_the_project() {
    for (path, bytes, expected) in [
        ("sieben.toml", &b"\xFF\xFE\xFD"[..], "P6007"),
        ("sieben.toml", b"[project]\nsoruces = []\n", "P6008"),
        ("symbols.csv", b"\0\0\0\0\0\0\0\0", "P1101"),
        ("empty.awl", b" \n", "P6004"),
        ("binary.awl", b"\0\0\0\0\0\0\0\0", "P1101"),
        ("wrong.awl", b"ORGANIZATION_BLOCK OB 1\nBEGIN\n  XYZ 1\nEND_ORGANIZATION_BLOCK\n", "P2001"),
        ("plant.awlpro", b"<nothing>", "P6040"),
    ] {
        let mut project = Project::default();
        project.add_source(Path::new("count.awl"), SOURCE);
        match path.rsplit_once('.').map(|(_, ending)| ending) {
            Some("toml") => project.add_settings(Path::new(path), bytes),
            Some("csv") => project.add_symbols(Path::new(path), bytes).expect("the refusal is a finding"),
            Some("awlpro") => assert!(project.add_awlsim_project(Path::new(path), bytes).is_none(), "{path}"),
            _ => project.add_source(Path::new(path), bytes),
        }
        let build = project.compile(Overrides::default(), false);
        assert!(codes(&build).contains(&expected), "{path}: {:?}", codes(&build));
        let json = finding::to_json(&build.findings, &build.project.texts);
        assert!(json.as_array().is_some_and(|list| list.iter().any(|one| one["code"] == expected)), "{path}: {json}");
    }
}

#[test]
fn a_project_without_a_text_says_so() {
    let mut project = Project::default();
    project.add_source(Path::new("empty.awl"), b"\n");
    project.require_text(&[]);
    let build = project.compile(Overrides::default(), false);
    assert_eq!(codes(&build), ["P6005"]);
}
