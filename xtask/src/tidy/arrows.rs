//! Which room may know which: the arrows of ARCHITECTURE.md.

use toml::Table;

use super::Finding;
use crate::workspace::TextFile;

/// The arrows as drawn; a room also reaches what its neighbours below reach.
const ARROWS: &[(&str, &[&str])] = &[
    ("model", &[]),
    ("engine", &["model"]),
    ("jit", &["engine"]),
    ("lang", &["engine"]),
    ("cpu", &["engine"]),
    ("sim", &["cpu"]),
    ("ide", &["lang"]),
    ("campaign", &["sim"]),
    ("farm", &["model"]),
    ("workspace", &["ide", "campaign", "sim", "cpu", "lang"]),
    ("comm", &["workspace"]),
    ("workbench", &["workspace"]),
    ("app", &["workbench", "comm", "farm", "workspace", "campaign", "ide", "sim", "cpu", "lang", "jit"]),
];

/// Rooms that may use files, network, time and processes; only they have an empty `clippy.toml`.
const WITH_IO: &[&str] = &["crates/app", "crates/comm", "crates/farm", "crates/workbench", "xtask"];

/// The only file with `unsafe`.
const UNSAFE_ROOM: &str = "crates/jit";

fn reaches(from: &str, to: &str) -> bool {
    ARROWS.iter().find(|(room, _)| *room == from).is_some_and(|(_, below)| below.iter().any(|room| *room == to || reaches(room, to)))
}

/// Checks the manifests, the roots of the crates and the files that guard them.
pub fn check(files: &[TextFile]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for file in files {
        if let Some(room) = file.path.strip_prefix("crates/").and_then(|path| path.strip_suffix("/Cargo.toml")) {
            findings.extend(manifest(room, file));
        }
        if is_crate_root(&file.path) && !file.path.starts_with(UNSAFE_ROOM) && !file.text.contains("#![forbid(unsafe_code)]") {
            findings.push(Finding::file(&file.path, "the root of a crate says `#![forbid(unsafe_code)]`"));
        }
        if file.path.ends_with(".rs")
            && file.path != "crates/jit/src/entry.rs"
            && file.text.lines().any(|line| line.trim().starts_with("#![allow(unsafe_code)]"))
        {
            findings.push(Finding::file(&file.path, "only crates/jit/src/entry.rs may allow `unsafe`"));
        }
        if let Some(folder) = file.path.strip_suffix("/clippy.toml")
            && !WITH_IO.contains(&folder)
        {
            findings
                .push(Finding::file(&file.path, "a clippy.toml here would switch off the bans of the root; only rooms with I/O have one"));
        }
    }
    for folder in WITH_IO {
        if !files.iter().any(|file| file.path == format!("{folder}/clippy.toml")) {
            findings.push(Finding::file(folder, "a room with I/O has an empty clippy.toml, or the bans of the root hold in it"));
        }
    }
    findings
}

fn manifest(room: &str, file: &TextFile) -> Vec<Finding> {
    let Ok(manifest) = file.text.parse::<Table>() else { return vec![Finding::file(&file.path, "is not TOML")] };
    if !ARROWS.iter().any(|(known, _)| *known == room) {
        return vec![Finding::file(
            &file.path,
            format!("`{room}` is no room of ARCHITECTURE.md; say there what it is and what it may know"),
        )];
    }
    let mut findings = Vec::new();
    let name = manifest.get("package").and_then(|package| package.get("name")).and_then(|name| name.as_str());
    if name != Some(&format!("sieben-{room}")) {
        findings.push(Finding::file(&file.path, format!("the package in the folder `{room}` is named `sieben-{room}`")));
    }
    if manifest.get("lints").and_then(|lints| lints.get("workspace")).and_then(|inherited| inherited.as_bool()) != Some(true) {
        findings.push(Finding::file(&file.path, "takes its lints from the workspace: `[lints] workspace = true`"));
    }
    for section in ["dependencies", "dev-dependencies", "build-dependencies"] {
        let names = manifest.get(section).and_then(|table| table.as_table()).into_iter().flat_map(|table| table.keys());
        for other in names.filter_map(|name| name.strip_prefix("sieben-")) {
            if !reaches(room, other) {
                findings.push(Finding::file(
                    &file.path,
                    format!("no arrow leads from `{room}` to `{other}`; what needs two neighbours is joined in `app`"),
                ));
            }
        }
    }
    findings
}

fn is_crate_root(path: &str) -> bool {
    let Some(name) =
        path.strip_prefix("crates/").and_then(|path| path.split_once('/')).map(|(_, rest)| rest).or_else(|| path.strip_prefix("xtask/"))
    else {
        return false;
    };
    matches!(name, "src/lib.rs" | "src/main.rs")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrows_lead_down_only() {
        assert!(reaches("workbench", "model"));
        assert!(!reaches("cpu", "lang"));
        assert!(!reaches("lang", "cpu"));
        assert!(!reaches("model", "model"));
    }

    #[test]
    fn an_arrow_that_is_not_drawn_is_found() {
        let text = "[package]\nname = \"sieben-cpu\"\n[lints]\nworkspace = true\n[dependencies]\nsieben-lang.workspace = true\n";
        let file = TextFile { path: "crates/cpu/Cargo.toml".to_owned(), text: text.to_owned() };
        assert_eq!(manifest("cpu", &file).len(), 1);
    }
}
