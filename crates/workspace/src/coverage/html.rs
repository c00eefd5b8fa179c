//! Coverage as pages for a browser, which need nothing but themselves: one with all sources, and one for each source.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::{Coverage, File, Line, Share};
use crate::xml::escaped;

/// Every page begins with it: what does not was made by others and is not overwritten.
pub const MARK: &str = "<!doctype html><!-- coverage written by sieben -->";
/// The page with all sources.
pub const INDEX: &str = "index.html";
/// Characters of the name of a page; file systems take 255 bytes.
const NAME_MAX: usize = 80;

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// A page.
#[derive(Clone, Debug)]
pub struct Page {
    /// The name of its file.
    pub name: String,
    /// All of it.
    pub text: String,
}

impl Coverage {
    /// The names of all pages, the one with all sources first.
    pub fn page_names(&self) -> Vec<String> {
        std::iter::once(INDEX.to_owned()).chain(page_names(self.files.keys())).collect()
    }

    /// All pages, the one with all sources last; `tests` says what came of the tests.
    pub fn pages<'a>(&'a self, tests: &'a str) -> impl Iterator<Item = Page> + 'a {
        let names = page_names(self.files.keys());
        let index = self.index(&names, tests);
        let source = |((source, file), name): ((&String, &File), String)| Page { name, text: source_page(source, file) };
        self.files.iter().zip(names).map(source).chain(std::iter::once(Page { name: INDEX.to_owned(), text: index }))
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
