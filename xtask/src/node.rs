//! What the page and the extension need of the machine: Node.js with the packages of a lock file, Chromium, fonts.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::programs::{self, done};
use crate::workspace;

/// Chromium under the names that systems give it.
const CHROMIUMS: &[&str] = &["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"];
/// Fonts that the page names first: pictures of it differ without them.
pub(crate) const FONTS: &[&str] = &["Inter", "JetBrains Mono"];
/// What Debian calls the browser and the fonts.
const PACKAGES: &[&str] = &["chromium", "fonts-inter", "fonts-jetbrains-mono"];

/// Installs the packages of the lock file of a folder, unless they are there; says what is missing if that cannot be.
pub(crate) fn packages(folder: &Path) -> Result<(), String> {
    for program in ["node", "npm"] {
        if !programs::starts(program) {
            return Err(format!("{program} is not installed (`apt-get install nodejs npm` as root, or what your system has for it)"));
        }
    }
    let failed = |error: std::io::Error| error.to_string();
    let wanted = fs::read_to_string(folder.join("package-lock.json")).map_err(failed)?;
    let stamp = folder.join("node_modules/.installed");
    if fs::read_to_string(&stamp).is_ok_and(|found| found == wanted) {
        return Ok(());
    }
    let shown = workspace::relative(&workspace::root(), folder);
    done(programs::npm("ci").arg("--prefer-offline").current_dir(folder))
        .map_err(|reason| format!("the packages of {shown} are not installed: {reason}"))?;
    fs::write(&stamp, wanted).map_err(failed)
}

/// A command of a package that is installed in a folder.
pub(crate) fn package_command(folder: &Path, name: &str) -> Command {
    let mut command = Command::new("npx");
    command.args(["--no-install", name]).current_dir(folder);
    command
}

/// Finds the path of Chromium: the one in `CHROMIUM`, or the system's, which is installed if we may.
pub(crate) fn chromium() -> Result<String, String> {
    if let Ok(named) = std::env::var("CHROMIUM") {
        return if programs::starts(&named) { Ok(named) } else { Err(format!("`{named}`, which `CHROMIUM` names, does not start")) };
    }
    let found = || CHROMIUMS.iter().filter_map(|name| programs::path_of(name)).find(|path| programs::starts(path));
    if (found().is_none() || FONTS.iter().any(|font| !has_font(font)))
        && let Err(reason) = programs::install_packages(PACKAGES)
        && found().is_none()
    {
        return Err(format!("chromium is not installed: {reason}"));
    }
    found().ok_or_else(|| "chromium is not installed".to_owned())
}

/// Whether the system has a font.
pub(crate) fn has_font(name: &str) -> bool {
    let output = Command::new("fc-match").args(["--format=%{family}", name]).output();
    output.is_ok_and(|output| String::from_utf8_lossy(&output.stdout).split(',').any(|family| family.trim() == name))
}
