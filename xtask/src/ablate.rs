//! `cargo xtask ablate`: writes down what each optimization of the machine code is worth.

use std::fs;
use std::process::{Command, Stdio};

use crate::workspace;

/// Where the table goes.
const PAGE: &str = "docs/benchmarks/ablation.md";
/// What stands in front of the table of the page.
const MARK: &str = "<!-- the table of `cargo xtask ablate` -->\n";

/// Measures all optimizations, or those whose names are given, and writes the table into its page.
pub fn run(arguments: &[String]) -> Result<(), String> {
    let mut command = Command::new("cargo");
    command.args(["bench", "--quiet", "--package", "sieben-app", "--bench", "ablation", "--"]).args(arguments);
    let output = command.current_dir(workspace::root()).stderr(Stdio::inherit()).output();
    let output = output.map_err(|error| format!("cargo does not start: {error}"))?;
    if !output.status.success() {
        return Err("the optimizations could not be measured".to_owned());
    }
    let table = String::from_utf8_lossy(&output.stdout);
    print!("{table}");
    // A part of the table does not take the place of the whole.
    if !arguments.is_empty() {
        return Ok(());
    }
    let path = workspace::root().join(PAGE);
    let page = fs::read_to_string(&path).map_err(|error| format!("{PAGE}: {error}"))?;
    let (front, _) = page.split_once(MARK).ok_or_else(|| format!("{PAGE} has no line `{}`", MARK.trim()))?;
    fs::write(&path, format!("{front}{MARK}\n{table}")).map_err(|error| format!("{PAGE}: {error}"))
}
