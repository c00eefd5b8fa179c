//! Coverage as pages for a browser, which need nothing but themselves: one with all sources, and one for each source.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fmt::Write as _;
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use sieben_model::problems::Problem;

use super::{Coverage, File, Line, Share};
use crate::failure::Failure;
use crate::files;
use crate::folder::{Folder, write_named};
use crate::testing::report::escaped;

/// Every page begins with it: what does not is somebody else's and is not overwritten.
const MARK: &str = "<!doctype html><!-- coverage written by sieben -->";
/// The page with all sources.
const INDEX: &str = "index.html";
/// Characters of the name of a page; file systems take 255 bytes.
const NAME_MAX: usize = 80;

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

impl Coverage {
    /// Writes all pages into a folder, which is made if need be; returns the page to open.
    ///
    /// The page with all sources is taken away first and comes last, so that it is there only if all that it says is.
    pub(crate) fn write_html(&self, folder: &Path, tests: &str) -> Result<PathBuf, Failure> {
        if folder.exists() && !folder.is_dir() {
            let message = format!("`{}` is a file, but the pages of coverage are written into a folder", folder.display());
            return Err(Failure::usage(Problem::P6300, message));
        }
        std::fs::create_dir_all(folder).map_err(|error| files::unwritable(folder, &error))?;
        let names = page_names(self.files.keys());
        let held = Folder::open(folder).map_err(|error| files::unwritable(folder, &error))?;
        for name in [INDEX].into_iter().chain(names.iter().map(String::as_str)) {
            is_free(&held, name, &folder.join(name))?;
        }
        let index = folder.join(INDEX);
        held.remove(OsStr::new(INDEX)).map_err(|error| files::unwritable(&index, &error))?;
        let write = |name: &str, page: String| {
            write_named(folder, name, page.as_bytes()).map_err(|error| files::unwritable(&folder.join(name), &error))
        };
        for ((source, file), page) in self.files.iter().zip(&names) {
            write(page, source_page(source, file))?;
        }
        write(INDEX, self.index(&names, tests))?;
        Ok(index)
    }

    fn index(&self, names: &[String], tests: &str) -> String {
        let mut rows = String::new();
        let row = |name: &str, lines: Share, decisions: Share| format!("<tr>{name}{}{}</tr>\n", cells(lines), cells(decisions));
        for ((source, file), page) in self.files.iter().zip(names) {
            let name = format!("<th scope=\"row\"><a href=\"{page}\">{}</a></th>", escaped(source));
            rows.push_str(&row(&name, file.lines(), file.decisions()));
        }
        let sum = row("<th scope=\"row\">all sources</th>", self.lines(), self.decisions());
        let table = match self.files.is_empty() {
            true => "<p>No unit test has run, so nothing was counted.</p>".to_owned(),
            false => format!(
                "<table class=\"sources\">\n<thead><tr><th scope=\"col\">source</th><th scope=\"col\" colspan=\"3\">lines that were run</th>\
                 <th scope=\"col\" colspan=\"3\">decisions that went every way</th></tr></thead>\n<tbody>\n{rows}</tbody>\n<tfoot>\n{sum}</tfoot>\n</table>"
            ),
        };
        page("Coverage", &format!("<header><h1>Coverage</h1><p>{}</p></header>\n<main>\n{table}\n</main>", escaped(tests)))
    }
}

/// Names of pages, each once, also where upper and lower case are the same.
fn page_names<'a>(sources: impl Iterator<Item = &'a String>) -> Vec<String> {
    let mut taken = BTreeSet::from([INDEX.to_owned()]);
    let plain = |c: char| if c.is_ascii_alphanumeric() || matches!(c, '.' | '_') { c } else { '-' };
    let names = sources.map(|source| {
        let base: String = source.chars().map(plain).collect::<String>().trim_start_matches(['.', '-']).chars().take(NAME_MAX).collect();
        let numbered = (1..).map(|number| if number == 1 { format!("{base}.html") } else { format!("{base}-{number}.html") });
        let mut free = numbered.skip_while(|name| !taken.insert(name.to_lowercase()));
        free.next().unwrap_or_default()
    });
    names.collect()
}

/// Whether a page may be written here: nothing else has its name.
fn is_free(folder: &Folder, name: &str, path: &Path) -> Result<(), Failure> {
    let mut begin = vec![0; MARK.len()];
    let read = folder.read(OsStr::new(name)).and_then(|mut file| file.read_exact(&mut begin));
    let why = match read {
        Ok(()) if begin == MARK.as_bytes() => return Ok(()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        Ok(()) => String::new(),
        Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => String::new(),
        Err(error) => format!(": {error}"),
    };
    let message = format!("`{}` is there already, and no page of coverage{why}", path.display());
    Err(Failure::usage(Problem::P6300, message))
}

/// A whole page.
fn page(title: &str, body: &str) -> String {
    format!(
        "{MARK}\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n{body}\n\
         <script>\n{SCRIPT}</script>\n</body>\n</html>\n",
        escaped(title)
    )
}

/// A share as a bar, in percent, and in numbers.
fn cells(share: Share) -> String {
    if share.all == 0 {
        return "<td class=\"bar\"></td><td class=\"percent\">–</td><td class=\"numbers\">none</td>".to_owned();
    }
    let percent = share.percent();
    format!(
        "<td class=\"bar\"><div aria-hidden=\"true\"><div style=\"width:{percent}%\"></div></div></td><td class=\"percent\">{percent} %</td>\
         <td class=\"numbers\">{} of {}</td>",
        share.hit, share.all
    )
}

/// `12 of 15 lines were run (80 %)`.
fn sentence(share: Share, what: &str, done: &str) -> String {
    match share.all {
        0 => format!("no {what}"),
        _ => format!("{} of {} {what} {done} ({} %)", share.hit, share.all, share.percent()),
    }
}

/// How a line is shown.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Nothing,
    Missed,
    Partly,
    Whole,
}

impl State {
    fn of(line: Option<&Line>) -> Self {
        match line {
            None => Self::Nothing,
            Some(line) if line.ran == 0 => Self::Missed,
            Some(line) if line.decisions.iter().any(|decision| !decision.is_whole()) => Self::Partly,
            Some(_) => Self::Whole,
        }
    }

    fn class(self) -> &'static str {
        match self {
            Self::Nothing => "nothing",
            Self::Missed => "missed",
            Self::Partly => "partly",
            Self::Whole => "whole",
        }
    }
}

/// The lines where something is missing: the first one of each run of lines that were not run, and each decision that went some ways only.
fn gaps(file: &File) -> Vec<usize> {
    let mut gaps = Vec::new();
    let mut before = State::Whole;
    for (&number, line) in &file.lines {
        let state = State::of(Some(line));
        if state == State::Partly || state == State::Missed && before != State::Missed {
            gaps.push(number);
        }
        before = state;
    }
    gaps
}

fn source_page(name: &str, file: &File) -> String {
    let gaps = gaps(file);
    let mut rows = String::new();
    for (number, text) in (1..).zip(file.text.lines()) {
        rows.push_str(&row(number, text, file.lines.get(&number), &gaps));
    }
    let jump = match gaps.first() {
        None => "nothing is missing".to_owned(),
        Some(first) => {
            let places = if gaps.len() == 1 { "1 place".to_owned() } else { format!("{} places", gaps.len()) };
            format!("<a href=\"#L{first}\">{places} to look at ↓</a> <small>keys: <kbd>n</kbd> next, <kbd>p</kbd> previous</small>")
        }
    };
    let body = format!(
        "<header><p><a href=\"{INDEX}\">Coverage</a></p><h1>{}</h1><p>{}; {}</p><p>{jump}</p></header>\n<main>\n<table class=\"source\">\n\
         <thead><tr><th scope=\"col\">line</th><th scope=\"col\">run</th><th scope=\"col\">source and its decisions</th></tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n</main>",
        escaped(name),
        sentence(file.lines(), "lines with statements", "were run"),
        sentence(file.decisions(), "decisions", "went every way"),
    );
    page(&format!("{name} – coverage"), &body)
}

/// A line of a source.
fn row(number: usize, text: &str, line: Option<&Line>, gaps: &[usize]) -> String {
    let state = State::of(line);
    let gap = gaps.binary_search(&number).ok();
    let links = gap.map_or(String::new(), |index| {
        let link = |target: Option<&usize>, word: &str, sign: &str| match target {
            Some(target) => format!("<a href=\"#L{target}\" title=\"{word} place\" aria-label=\"{word} place\">{sign}</a>"),
            None => String::new(),
        };
        let before = link(index.checked_sub(1).and_then(|before| gaps.get(before)), "previous", "↑");
        format!("<span class=\"links\">{before}{}</span>", link(gaps.get(index + 1), "next", "↓"))
    });
    let count = match line {
        None => String::new(),
        Some(line) if line.ran == 0 => "never".to_owned(),
        Some(line) => format!("{}×", line.ran),
    };
    let mut notes = String::new();
    for decision in line.iter().flat_map(|line| &line.decisions) {
        let (class, sign) = match (decision.is_whole(), decision.is_reached()) {
            (true, _) => ("whole", "●"),
            (_, true) => ("partly", "◐"),
            _ => ("missed", "○"),
        };
        let _ = write!(
            notes,
            "<p class=\"{class}\"><span aria-hidden=\"true\">{sign}</span> <code>{}</code> – {}</p>",
            escaped(&decision.name),
            code_marked(&decision.told())
        );
    }
    let marked = if gap.is_some() { " data-gap" } else { "" };
    format!(
        "<tr id=\"L{number}\" class=\"{}\"{marked}><td class=\"number\"><a href=\"#L{number}\">{number}</a></td><td class=\"count\">{count}{links}</td>\
         <td class=\"code\"><pre>{}</pre>{notes}</td></tr>\n",
        state.class(),
        escaped(text)
    )
}

/// What stands between backticks is code.
fn code_marked(text: &str) -> String {
    let mut out = String::new();
    for (index, part) in text.split('`').enumerate() {
        match index % 2 {
            0 => out.push_str(&escaped(part)),
            _ => {
                let _ = write!(out, "<code>{}</code>", escaped(part));
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_have_names_that_no_file_system_mistakes() {
        let sources = ["src/Main.awl", "SRC/main.awl", "index", "../a b.st", "Förder-Band.scl"].map(str::to_owned);
        let names = page_names(sources.iter());
        assert_eq!(names, ["src-Main.awl.html", "SRC-main.awl-2.html", "index-2.html", "a-b.st.html", "F-rder-Band.scl.html"]);
    }
}
