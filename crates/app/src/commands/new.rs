//! `sieben new NAME`: a project that runs and checks at once.

use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use sieben_model::problems::Problem;

use crate::examples::{self, Example};
use crate::failure::{Exit, Failure};
use crate::{files, output};

/// The files of a new project besides its source. `{name}` stands for its name, `{extension}` for the ending of its sources.
const TEMPLATE: &[(&str, &str)] = &[
    ("sieben.toml", include_str!("../../templates/basic/sieben.toml")),
    ("symbols.csv", include_str!("../../templates/basic/symbols.csv")),
    ("tests/motor.test.st", include_str!("../../templates/basic/tests/motor.test.st")),
    (".gitattributes", include_str!("../../templates/basic/gitattributes")),
    ("README.md", include_str!("../../templates/basic/README.md")),
];

/// The language of the program of a new project.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum ProgramLanguage {
    /// Statement list.
    Stl,
    /// Structured text of IEC 61131-3.
    St,
    /// SCL of the S7-300/400.
    Scl,
    /// Ladder diagram.
    Lad,
    /// Function block diagram.
    Fbd,
}

impl ProgramLanguage {
    /// The ending of its sources, and the program.
    fn source(self) -> (&'static str, &'static str) {
        match self {
            Self::Stl => ("awl", include_str!("../../templates/basic/src/main.awl")),
            Self::St => ("st", include_str!("../../templates/st/src/main.st")),
            Self::Scl => ("scl", include_str!("../../templates/scl/src/main.scl")),
            Self::Lad => ("lad", include_str!("../../templates/lad/src/main.lad")),
            Self::Fbd => ("fbd", include_str!("../../templates/fbd/src/main.fbd")),
        }
    }
}

/// Longest name: leaves room for the folders around it on every system.
const NAME_LENGTH_MAX: usize = 64;

/// Make a project that runs and checks at once.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben new pump && cd pump && sieben check && sieben run --for 5s\n  \
  sieben new pump --language st   the program in structured text; also stl, scl, lad, fbd\n  \
  sieben new lift --example elevator   a copy of an example, with its plant and its tests\n\n\
Nothing that exists is overwritten.")]
pub(crate) struct Arguments {
    /// The folder to make; its last name is the name of the project
    #[arg(value_name = "NAME")]
    folder: PathBuf,
    /// The language of its program
    #[arg(long, value_name = "LANGUAGE", default_value = "stl")]
    language: ProgramLanguage,
    /// Copy an example: program, symbols, plant, scenario and tests
    #[arg(long, value_name = "EXAMPLE", conflicts_with = "language", value_parser = example_argument)]
    example: Option<&'static Example>,
}

/// The example of this name.
fn example_argument(text: &str) -> Result<&'static Example, String> {
    Example::by_name(text).ok_or_else(|| {
        let list: String = examples::ALL.iter().map(|example| format!("\n  {:<16} {}", example.name, example.about)).collect();
        format!("there is no such example; there are:{list}")
    })
}

/// Makes the project.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let folder = &arguments.folder;
    let name = project_name(folder)?;
    if fs::symlink_metadata(folder).is_ok() {
        let empty = fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_none());
        if !empty {
            return Err(Failure::usage(Problem::P6014, format!("`{}` exists already", folder.display())));
        }
    }
    let mut made = Made::default();
    if let Some(example) = arguments.example {
        for (path, content) in example.renamed(name) {
            made.write(&folder.join(path), &content)?;
        }
        let (shown, example_name) = (folder.display(), example.name);
        let run = |path: &str| format!("  sieben campaign run {}\n", folder.join(path).display());
        let campaigns: String =
            example.files.iter().filter(|(path, _)| path.ends_with(".campaign.toml")).map(|(path, _)| run(path)).collect();
        return output::print(&format!(
            "Made `{shown}`: {}.\n\n  \
             sieben test {shown}\n  \
             sieben trace {shown} {}\n\
             {campaigns}\n\
             {} says what it is, what to try and what to break.\n",
            example.about,
            folder.join(format!("{example_name}.scenario")).display(),
            folder.join("README.md").display(),
        ))
        .map(|()| Exit::Success);
    }
    let (extension, program) = arguments.language.source();
    let source = format!("src/main.{extension}");
    for (path, content) in TEMPLATE.iter().copied().chain([(source.as_str(), program)]) {
        made.write(&folder.join(path), &content.replace("{name}", name).replace("{extension}", extension))?;
    }
    let shown = folder.display();
    output::print(&format!(
        "Made `{shown}`: a motor with self-holding START and STOP buttons.\n\n  \
         sieben check {shown}\n  \
         sieben exec {shown} --set Stop=1 --set Start=1 --show Motor\n  \
         sieben test {shown}\n  \
         sieben run {shown} --for 5s\n\n\
         The program is in {}.\n",
        folder.join(&source).display(),
    ))?;
    Ok(Exit::Success)
}

/// What was made of a project, in its order: if the rest cannot be made, nothing of it stays.
#[derive(Default)]
struct Made(Vec<PathBuf>);

impl Made {
    /// Writes a file, and makes the folders above it.
    fn write(&mut self, path: &Path, content: &str) -> Result<(), Failure> {
        let folder = path.parent().unwrap_or(Path::new("."));
        let written = self.folder(folder).and_then(|()| {
            self.0.push(path.to_path_buf());
            files::write_whole(path, content.as_bytes())
        });
        written.inspect_err(|_| self.remove())
    }

    fn folder(&mut self, folder: &Path) -> Result<(), Failure> {
        if folder.as_os_str().is_empty() || folder.is_dir() {
            return Ok(());
        }
        if let Some(above) = folder.parent() {
            self.folder(above)?;
        }
        fs::create_dir(folder).map_err(|error| files::unwritable(folder, &error))?;
        self.0.push(folder.to_path_buf());
        Ok(())
    }

    fn remove(&mut self) {
        for path in self.0.drain(..).rev() {
            // Files first, then the folders that are empty now; the error before matters more than one here.
            let _ = if path.is_dir() { fs::remove_dir(&path) } else { fs::remove_file(&path) };
        }
    }
}

fn project_name(folder: &Path) -> Result<&str, Failure> {
    let wrong = |name: &str| Failure::usage(Problem::P7008, format!("`{name}` cannot be the name of a project"));
    let Some(name) = folder.file_name() else { return Err(wrong(&folder.display().to_string())) };
    let Some(name) = name.to_str() else { return Err(wrong(&folder.display().to_string())) };
    let good = |c: char| c.is_alphanumeric() || c == '-' || c == '_';
    if name.is_empty() || name.starts_with('-') || name.chars().count() > NAME_LENGTH_MAX || !name.chars().all(good) {
        return Err(wrong(name));
    }
    Ok(name)
}
