//! Tables for people: as aligned text, and as a web page that can be printed.

use std::fmt::Write as _;

use sieben_model::language::{Language, Text, pick};
use sieben_model::visible;

/// A title and the tables under it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Document {
    /// What it is.
    pub(crate) title: String,
    /// Its parts.
    pub(crate) sections: Vec<Section>,
    /// The language of its headings.
    pub(crate) language: Language,
}

/// A table with remarks under it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Section {
    /// What it is; empty for the only section of a document.
    pub(crate) title: String,
    /// The headings.
    pub(crate) headings: Vec<&'static str>,
    /// The cells of each row, one line each; blanks in front count.
    pub(crate) rows: Vec<Vec<String>>,
    /// Lines under the table.
    pub(crate) notes: Vec<String>,
}

/// Widest column that is lined up; longer cells push the rest of their row aside, not every row.
const WIDTH_MAX: usize = 160;

impl Section {
    fn text(&self) -> String {
        let mut text = String::new();
        if !self.title.is_empty() {
            let _ = writeln!(text, "{}\n", self.title);
        }
        if !self.rows.is_empty() {
            let widths: Vec<usize> = (0..self.headings.len())
                .map(|column| {
                    let cells = self.rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count());
                    cells.chain([self.headings[column].chars().count()]).max().unwrap_or(0).min(WIDTH_MAX)
                })
                .collect();
            let mut line = |cells: &mut dyn Iterator<Item = &str>| {
                let padded: Vec<String> = cells.zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
                let _ = writeln!(text, "{}", padded.join("  ").trim_end());
            };
            line(&mut self.headings.iter().copied());
            let rules: Vec<String> = widths.iter().map(|width| "─".repeat(*width)).collect();
            line(&mut rules.iter().map(String::as_str));
            for row in &self.rows {
                line(&mut row.iter().map(String::as_str));
            }
        }
        if !self.rows.is_empty() && !self.notes.is_empty() {
            text.push('\n');
        }
        for note in &self.notes {
            let _ = writeln!(text, "{note}");
        }
        text
    }

    fn html(&self) -> String {
        let mut page = String::from("<section>\n");
        if !self.title.is_empty() {
            let _ = writeln!(page, "<h2>{}</h2>", escaped(&self.title));
        }
        if !self.rows.is_empty() {
            page.push_str("<table>\n<thead><tr>");
            for heading in &self.headings {
                let _ = write!(page, "<th>{}</th>", escaped(heading));
            }
            page.push_str("</tr></thead>\n<tbody>\n");
            for row in &self.rows {
                page.push_str("<tr>");
                for cell in row {
                    let _ = write!(page, "<td>{}</td>", escaped(cell));
                }
                page.push_str("</tr>\n");
            }
            page.push_str("</tbody>\n</table>\n");
        }
        for note in &self.notes {
            let _ = writeln!(page, "<p>{}</p>", escaped(note));
        }
        page.push_str("</section>\n");
        page
    }
}

impl Document {
    /// The document with its headings in a language; cells are what they are.
    pub(crate) fn in_language(mut self, language: Language) -> Self {
        let said = |text: &str| WORDS.iter().find(|words| words[0] == text).map(|&words| pick(language, words));
        let owned = |text: String| said(&text).map_or(text, str::to_owned);
        self.title = owned(self.title);
        for section in &mut self.sections {
            section.title = owned(std::mem::take(&mut section.title));
            section.headings.iter_mut().for_each(|heading| *heading = said(heading).unwrap_or(heading));
            section.notes = std::mem::take(&mut section.notes).into_iter().map(owned).collect();
        }
        self.language = language;
        self
    }

    /// The document as text.
    pub(crate) fn text(&self) -> String {
        self.sections.iter().map(Section::text).collect::<Vec<_>>().join("\n")
    }

    /// The document as a web page with its style inside.
    pub(crate) fn html(&self) -> String {
        let title = escaped(&self.title);
        let sections: String = self.sections.iter().map(Section::html).collect();
        format!(
            "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n\
            <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n\
            <body>\n<h1>{title}</h1>\n{sections}</body>\n</html>\n",
            self.language.code()
        )
    }
}

/// Titles, headings and remarks of all documents.
const WORDS: &[Text] = &[
    ["Address", "Adresse"],
    ["Addresses without a symbol", "Adressen ohne Symbol"],
    ["Area known only at run time", "Bereich erst zur Laufzeit bekannt"],
    ["Assignment list", "Belegungsplan"],
    ["Bit memory", "Merker"],
    ["Block", "Baustein"],
    ["Call", "Aufruf"],
    ["Call structure", "Programmstruktur"],
    ["Comment", "Kommentar"],
    ["Counters", "Zähler"],
    ["Cross reference", "Querverweisliste"],
    ["Data", "Daten"],
    ["First in", "Zuerst in"],
    ["From", "Ab"],
    ["In use with other widths", "In anderer Breite verwendet"],
    ["Inputs", "Eingänge"],
    ["Instance", "Instanz"],
    ["Line", "Zeile"],
    ["Local", "Lokal"],
    ["Local data", "Lokaldaten"],
    ["Network", "Netzwerk"],
    ["No.", "Nr."],
    ["No address is used in this program.", "In diesem Programm wird keine Adresse verwendet."],
    ["None.", "Keine."],
    ["Not called by any organization block", "Von keinem Organisationsbaustein aufgerufen"],
    ["Nothing is used in this program.", "In diesem Programm wird nichts verwendet."],
    ["Outputs", "Ausgänge"],
    ["Overlaps", "Überlappung"],
    ["Path", "Pfad"],
    ["Peripheral inputs", "Peripherieeingänge"],
    ["Peripheral outputs", "Peripherieausgänge"],
    ["Remark", "Bemerkung"],
    ["Statement", "Anweisung"],
    ["Symbol", "Symbol"],
    ["Symbols that no statement uses", "Symbole, die keine Anweisung verwendet"],
    [
        "The program calls blocks that are known only at run time; these may be among them.",
        "Das Programm ruft Bausteine auf, die erst zur Laufzeit bekannt sind; diese können darunter sein.",
    ],
    ["There is no code block in this program.", "In diesem Programm gibt es keinen Codebaustein."],
    ["Timers", "Zeiten"],
    ["Type", "Art"],
    ["Unused symbols and addresses without a symbol", "Unbenutzte Symbole und Adressen ohne Symbol"],
    ["Uses", "Verwendungen"],
];

/// Black on white, headings repeated on every printed page.
const STYLE: &str = "\
body { font: 14px/1.4 system-ui, sans-serif; margin: 2em; color: #1a1a1a; background: #fff }
h1 { font-size: 1.5em } h2 { font-size: 1.15em; margin: 1.5em 0 0.5em }
table { border-collapse: collapse } thead { display: table-header-group }
th, td { text-align: left; vertical-align: top; padding: 0.15em 0.8em 0.15em 0.3em; border-bottom: 1px solid #ccc }
td { font-family: ui-monospace, monospace; white-space: pre-wrap } th { border-bottom: 2px solid #333 }
tr { break-inside: avoid }
@media print { body { margin: 0; font-size: 9pt } }
";

/// The text with everything replaced that means something in HTML; characters that no page may hold become blanks.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            character if visible::is_hidden(character) => visible::push(&mut escaped, character),
            character => escaped.push(character),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_in_a_cell_can_leave_it() {
        let section = Section {
            title: "<h2>".to_owned(),
            headings: vec!["Symbol"],
            rows: vec![vec!["</td><script>alert('1')</script>&\"\u{1}".to_owned()]],
            notes: vec!["a < b".to_owned()],
        };
        let page = Document { title: "</title>".to_owned(), sections: vec![section], ..Document::default() }.html();
        assert!(!page.contains("<script>") && !page.contains('\u{1}') && page.matches("</title>").count() == 1, "{page}");
        assert!(page.contains("<td>&lt;/td&gt;&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt;&amp;&quot;␁</td>"), "{page}");
    }

    #[test]
    fn columns_are_aligned_by_characters() {
        let row = |cells: [&str; 2]| cells.map(str::to_owned).to_vec();
        let section = Section { headings: vec!["A", "B"], rows: vec![row(["Zähler", "1"]), row(["x", "2"])], ..Section::default() };
        assert_eq!(
            Document { title: String::new(), sections: vec![section], ..Document::default() }.text(),
            "A       B\n──────  ─\nZähler  1\nx       2\n"
        );
    }

    #[test]
    fn a_very_long_cell_does_not_make_every_row_long() {
        let row = |cells: [&str; 2]| cells.map(str::to_owned).to_vec();
        let long = "x".repeat(100_000);
        let section = Section { headings: vec!["A", "B"], rows: vec![row([&long, "1"]), row(["x", &long])], ..Section::default() };
        let text = Document { title: String::new(), sections: vec![section], ..Document::default() }.text();
        assert!(text.contains(&format!("{long}  1\n")) && text.contains(&format!("  {long}\n")));
        assert!(text.len() < 210_000, "{}", text.len());
    }
}
