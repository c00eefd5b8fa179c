//! The extension as one file, `.vsix`: a zip file with two lists of what is in it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

use super::sources;
use super::zip::{Entry, xml, zip};
use crate::{node, workspace};

/// Folders of the extension that are packed as they are.
const FOLDERS: &[&str] = &["dist", "icons", "languages", "snippets", "syntaxes", "walkthrough"];
/// Files that are packed: from the folder of the extension, and from that of the project.
const FILES: &[&str] = &["package.json", "README.md", "../../LICENSE-MIT", "../../LICENSE-APACHE"];
/// What a system and a processor are called in Rust, and in the manifest of an extension.
const TARGETS: &[(&str, &str, &str)] = &[
    ("linux", "x86_64", "linux-x64"),
    ("linux", "aarch64", "linux-arm64"),
    ("macos", "x86_64", "darwin-x64"),
    ("macos", "aarch64", "darwin-arm64"),
    ("windows", "x86_64", "win32-x64"),
    ("windows", "aarch64", "win32-arm64"),
];

/// Checks and bundles the sources, and packs them; with a binary for this system, if there is one. Says where the file lies.
pub(super) fn build(binary: Option<&Path>) -> Result<PathBuf, String> {
    node::packages(&sources())?;
    // What was bundled before would be packed as well.
    let _ = fs::remove_dir_all(sources().join("dist"));
    run(node::package_command(&sources(), "tsc").arg("--noEmit"))?;
    run(Command::new("node").arg("build.mjs").current_dir(sources()))?;
    let manifest = manifest()?;
    let target = binary.map(|_| target()).transpose()?;
    let mut entries = files()?;
    if let Some(binary) = binary {
        let path = format!("extension/bin/sieben{}", std::env::consts::EXE_SUFFIX);
        entries.push(Entry { path, bytes: read(binary)?, program: true });
    }
    let listed = |path: &str, text: String| Entry { path: path.to_owned(), bytes: text.into_bytes(), program: false };
    entries.insert(0, listed("[Content_Types].xml", content_types(&entries)));
    entries.insert(0, listed("extension.vsixmanifest", vsix_manifest(&manifest, target)?));
    let name = target.map_or_else(|| "sieben.vsix".to_owned(), |target| format!("sieben-{target}.vsix"));
    let path = workspace::root().join("target").join(name);
    let bytes = zip(&entries)?;
    let written = fs::create_dir_all(workspace::root().join("target")).and_then(|()| fs::write(&path, &bytes));
    written.map_err(|error| format!("{}: {error}", path.display()))?;
    println!("vsix: {} ({} files, {} KiB)", workspace::relative(&workspace::root(), &path), entries.len(), bytes.len() / 1024);
    Ok(path)
}

fn run(command: &mut Command) -> Result<(), String> {
    let line = command.get_args().map(|word| word.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" ");
    let status = command.status().map_err(|error| format!("cannot start `{line}`: {error}"))?;
    if status.success() { Ok(()) } else { Err(format!("`{line}` failed")) }
}

fn read(path: &Path) -> Result<Vec<u8>, String> {
    fs::read(path).map_err(|error| format!("{}: {error}", path.display()))
}

/// The manifest of the extension.
fn manifest() -> Result<Value, String> {
    let path = sources().join("package.json");
    serde_json::from_slice(&read(&path)?).map_err(|error| format!("{}: {error}", path.display()))
}

/// What this system is called in the manifest.
fn target() -> Result<&'static str, String> {
    let (system, processor) = (std::env::consts::OS, std::env::consts::ARCH);
    let row = TARGETS.iter().find(|row| (row.0, row.1) == (system, processor));
    row.map(|row| row.2).ok_or_else(|| format!("VS Code has no name for {system} on {processor}"))
}

/// All files of the extension, sorted by path.
fn files() -> Result<Vec<Entry>, String> {
    let mut paths: Vec<PathBuf> = FILES.iter().map(|file| sources().join(file)).collect();
    let mut folders: Vec<PathBuf> = FOLDERS.iter().map(|folder| sources().join(folder)).collect();
    while let Some(folder) = folders.pop() {
        let entries = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        for entry in entries.flatten() {
            if entry.path().is_dir() { folders.push(entry.path()) } else { paths.push(entry.path()) }
        }
    }
    let mut entries = Vec::new();
    for path in paths {
        let inner = match path.strip_prefix(sources()) {
            Ok(inner) if !inner.starts_with("..") => workspace::relative(&sources(), &path),
            _ => path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        };
        entries.push(Entry { path: format!("extension/{inner}"), bytes: read(&path)?, program: false });
    }
    entries.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(entries)
}

/// The kinds of files by their endings, which the format wants for each.
fn content_types(entries: &[Entry]) -> String {
    let mut endings: Vec<&str> =
        entries.iter().filter_map(|entry| entry.path.rsplit('/').next()?.rsplit_once('.')).map(|(_, ending)| ending).collect();
    endings.push("vsixmanifest");
    endings.sort_unstable();
    endings.dedup();
    let kind = |ending: &str| match ending {
        "json" => "application/json",
        "js" => "application/javascript",
        "md" => "text/markdown",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "txt" => "text/plain",
        "vsixmanifest" => "text/xml",
        _ => "application/octet-stream",
    };
    let named = endings.iter().map(|ending| format!("<Default Extension=\".{ending}\" ContentType=\"{}\"/>", kind(ending)));
    let plain = entries.iter().filter(|entry| entry.path.rsplit('/').next().is_some_and(|name| !name.contains('.')));
    let whole = plain.map(|entry| format!("<Override PartName=\"/{}\" ContentType=\"application/octet-stream\"/>", xml(&entry.path)));
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">{}</Types>\n",
        named.chain(whole).collect::<String>()
    )
}

/// What the extension is, for the editor that installs it.
fn vsix_manifest(manifest: &Value, target: Option<&str>) -> Result<String, String> {
    let text = |path: &str| {
        let found = manifest.pointer(path).and_then(Value::as_str);
        found.map(xml).ok_or_else(|| format!("editors/vscode/package.json has no `{path}`"))
    };
    let list = |path: &str| {
        let words = manifest.pointer(path).and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_str);
        xml(&words.collect::<Vec<_>>().join(","))
    };
    let target = target.map_or_else(String::new, |target| format!(" TargetPlatform=\"{target}\""));
    let asset =
        |kind: &str, path: &str| format!("<Asset Type=\"Microsoft.VisualStudio.{kind}\" Path=\"extension/{path}\" Addressable=\"true\"/>");
    Ok(format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
         <PackageManifest Version=\"2.0.0\" xmlns=\"http://schemas.microsoft.com/developer/vsx-schema/2011\">\n\
         <Metadata>\n\
         <Identity Language=\"en-US\" Id=\"{}\" Version=\"{}\" Publisher=\"{}\"{target}/>\n\
         <DisplayName>{}</DisplayName>\n\
         <Description xml:space=\"preserve\">{}</Description>\n\
         <Tags>{}</Tags>\n\
         <Categories>{}</Categories>\n\
         <Properties><Property Id=\"Microsoft.VisualStudio.Code.Engine\" Value=\"{}\"/></Properties>\n\
         <License>extension/LICENSE-MIT</License>\n\
         <Icon>extension/{}</Icon>\n\
         </Metadata>\n\
         <Installation><InstallationTarget Id=\"Microsoft.VisualStudio.Code\"/></Installation>\n\
         <Dependencies/>\n\
         <Assets>{}</Assets>\n\
         </PackageManifest>\n",
        text("/name")?,
        text("/version")?,
        text("/publisher")?,
        text("/displayName")?,
        text("/description")?,
        list("/keywords"),
        list("/categories"),
        text("/engines/vscode")?,
        text("/icon")?,
        [
            asset("Code.Manifest", "package.json"),
            asset("Services.Content.Details", "README.md"),
            asset("Services.Content.License", "LICENSE-MIT"),
            asset("Services.Icons.Default", &text("/icon")?),
        ]
        .concat(),
    ))
}

#[cfg(test)]
mod tests {
    use sieben_lang::language::LANGUAGES;

    use super::*;

    #[test]
    fn the_extension_has_the_version_of_the_program() {
        assert_eq!(manifest().expect("a manifest")["version"], env!("CARGO_PKG_VERSION"));
    }

    /// Endings that others use too, or that are read only where they are named: a user associates them.
    const NOT_CLAIMED: &[&str] = &["st", "exp", "tcpou", "tcdut", "tcgvl", "tcio"];

    #[test]
    fn the_extension_claims_the_endings_that_are_ours_alone() {
        let manifest = manifest().expect("a manifest");
        let languages = manifest["contributes"]["languages"].as_array().expect("languages");
        let claimed: Vec<&str> =
            languages.iter().flat_map(|language| language["extensions"].as_array()).flatten().filter_map(Value::as_str).collect();
        for ending in LANGUAGES.iter().flat_map(|row| row.endings) {
            let is_claimed = claimed.contains(&format!(".{}", ending.ending).as_str());
            assert_eq!(is_claimed, !NOT_CLAIMED.contains(&ending.ending), "{}", ending.ending);
        }
    }

    #[test]
    fn what_the_manifest_names_is_packed() {
        let manifest = manifest().expect("a manifest");
        let text = manifest.to_string();
        let named = text.split('"').map(|word| word.trim_start_matches("./"));
        for path in named.filter(|word| FOLDERS[1..].iter().any(|folder| word.starts_with(&format!("{folder}/")))) {
            assert!(sources().join(path).is_file(), "{path}");
        }
    }

    #[test]
    fn the_manifest_of_the_file_names_what_an_editor_asks_for() {
        let written = vsix_manifest(&manifest().expect("a manifest"), Some("linux-x64")).expect("it is whole");
        for part in ["Id=\"sieben\"", "TargetPlatform=\"linux-x64\"", "Value=\"^1.90.0\"", "Code.Manifest"] {
            assert!(written.contains(part), "{part}: {written}");
        }
    }
}
