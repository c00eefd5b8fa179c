//! VS Code itself, as code-server runs it in a browser: installed below `target/code-server`, and driven by the tests of the extension.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::{package, sources};
use crate::node;
use crate::programs::{self, Build, done};
use crate::workspace;

/// Which code-server: the last one for Node.js 20; it is VS Code 1.100.3.
const VERSION: &str = "4.100.3";
/// What Debian calls all that its parts are built with.
const PACKAGES: &[&str] = &["g++", "make", "python3", "libkrb5-dev", "ripgrep"];
/// Where the headers of Node.js lie if they are a package of the system: nothing is fetched to build parts then.
const HEADERS: &str = "/usr/include/node/node.h";
/// Parts that are built here.
const BUILT: &[&str] = &["@vscode/spdlog", "node-pty", "@parcel/watcher", "native-watchdog"];

/// Runs the tests of the extension: those without an editor, then those in VS Code; further arguments go to Playwright.
pub fn tests(arguments: &[String]) -> Result<(), String> {
    if let Err(missing) = node::packages(&sources()) {
        return programs::skip("vscode-tests", &format!("the tests of the extension for VS Code: {missing}"));
    }
    let vsix = package::build(None)?;
    let named = std::env::var_os("SIEBEN").map(PathBuf::from);
    let binary = programs::sieben(named.as_ref(), Build::Debug)?;
    let mut command = node::package_command(&sources(), "playwright");
    command.arg("test").env("SIEBEN", binary);
    let skipped = match node::chromium().and_then(|chromium| Ok((chromium, code_server()?))) {
        Ok((chromium, code_server)) => {
            command.env("CHROMIUM", chromium).env("CODE_SERVER", code_server).env("VSIX", vsix);
            Ok(())
        }
        Err(missing) => {
            command.args(["--project", "parts"]);
            programs::skip("vscode-editor", &format!("the extension in VS Code itself: {missing}"))
        }
    };
    let status = command.args(arguments).status().map_err(|error| format!("cannot start npx: {error}"))?;
    let passed = if status.success() { Ok(()) } else { Err("the extension for VS Code: a check failed, see above".to_owned()) };
    passed.and(skipped)
}

/// Installs code-server, unless it is there; says where its program lies.
fn code_server() -> Result<PathBuf, String> {
    let folder = workspace::root().join("target/code-server");
    let stamp = folder.join("installed");
    let wanted = format!("code-server {VERSION}\n");
    let program = folder.join("node_modules/code-server/out/node/entry.js");
    if fs::read_to_string(&stamp).is_ok_and(|found| found == wanted) {
        return Ok(program);
    }
    install(&folder).map_err(|reason| format!("code-server {VERSION} is not installed: {reason}"))?;
    fs::write(&stamp, wanted).map_err(|error| error.to_string())?;
    Ok(program)
}

/// A plain installation fetches a program from elsewhere and fails without it: the scripts of the packages are left out, and what has to be built is built by name.
fn install(folder: &Path) -> Result<(), String> {
    if !programs::starts("rg") || !programs::starts("g++") || !Path::new("/usr/include/krb5.h").is_file() {
        programs::install_packages(PACKAGES)?;
    }
    let failed = |error: std::io::Error| error.to_string();
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(failed)?;
    }
    fs::create_dir_all(folder).map_err(failed)?;
    fs::write(folder.join("package.json"), "{\"private\": true}\n").map_err(failed)?;
    let npm = |verb: &str, words: &[&str], folder: &Path| {
        let mut command: Command = programs::npm(verb);
        command.args(words).current_dir(folder).env("npm_config_yes", "true");
        if Path::new(HEADERS).is_file() {
            command.env("npm_config_nodedir", "/usr");
        }
        done(&mut command)
    };
    npm("install", &[&format!("code-server@{VERSION}"), "--ignore-scripts"], folder)?;
    npm("rebuild", &["argon2", "--build-from-source"], folder)?;
    let code = folder.join("node_modules/code-server/lib/vscode");
    npm("install", &["--omit=dev", "--ignore-scripts"], &code)?;
    npm("rebuild", BUILT, &code)?;
    let search = programs::path_of("rg").ok_or("ripgrep is not on PATH")?;
    let place = code.join("node_modules/@vscode/ripgrep/bin");
    fs::create_dir_all(&place).map_err(failed)?;
    let _ = fs::remove_file(place.join("rg"));
    std::os::unix::fs::symlink(search, place.join("rg")).map_err(failed)?;
    npm("install", &["--omit=dev", "--ignore-scripts"], &code.join("extensions"))
}
