//! `sieben campaign report`: what a result says, for people, as a page, and for build servers.

use std::path::PathBuf;

use clap::Args;

use crate::failure::{Exit, Failure};

/// Say what a result came to.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben campaign report oven.parquet                      for the terminal\n  \
  sieben campaign report oven.parquet --html oven.html     one page with charts, without network\n  \
  sieben campaign report oven.parquet --svg pictures       its charts and timing diagrams as files\n  \
  sieben campaign report oven.parquet --junit oven.xml     a test case for each property\n\n\
Exit codes: 0 all scenarios are there and all held, 1 a property broke, what has to come\n\
sometimes never came, or scenarios are missing, 2 usage, or no result that can be read.")]
pub(super) struct Arguments {
    /// The result
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Write a page to this file
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Write its charts, and timing diagrams of what failed, to this folder
    #[arg(long, value_name = "FOLDER")]
    svg: Option<PathBuf>,
    /// Write a report of JUnit to this file
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Print the summary as one JSON object
    #[arg(long)]
    json: bool,
}

/// Says it.
#[cfg(feature = "parquet")]
pub(super) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    use crate::campaign::files::ResultFile;
    use crate::campaign::report::{Report, junit, page, text};
    use crate::{files, output};

    let report = Report::read(ResultFile::open(&arguments.file)?)?;
    if let Some(path) = &arguments.html {
        files::write_whole(path, page(&report).as_bytes())?;
    }
    if let Some(folder) = &arguments.svg {
        std::fs::create_dir_all(folder).map_err(|error| files::unwritable(folder, &error))?;
        for (name, svg) in report.pictures() {
            files::write_whole(&folder.join(name), svg.as_bytes())?;
        }
    }
    if let Some(path) = &arguments.junit {
        files::write_whole(path, junit(&report).as_bytes())?;
    }
    match arguments.json {
        true => output::print_json(&report.json(), false)?,
        false => output::print(&text(&report))?,
    }
    Ok(if report.holds() { Exit::Success } else { Exit::CheckFailed })
}

/// Says it.
#[cfg(not(feature = "parquet"))]
pub(super) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let Arguments { file: _, html: _, svg: _, junit: _, json: _ } = arguments;
    Err(super::without_files())
}
