//! The XML of TwinCAT: declarations and statements lie in CDATA sections of its elements.

use std::ops::Range;

use roxmltree::{Document, Node, ParsingOptions};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};

use super::{Read, View};

/// Elements, texts and comments of a file: the largest blocks have some thousand, most of them identities of lines.
const NODES_MAX: u32 = 1_000_000;

/// Reads a file of TwinCAT.
pub(super) fn read(file: FileId, text: &str) -> Read {
    let mut reader = Reader { file, text, view: View::blank(text), at: 0, diagnostics: Vec::new() };
    // No DTD: neither entities that multiply nor files from elsewhere.
    let options = ParsingOptions { allow_dtd: false, nodes_limit: NODES_MAX, ..ParsingOptions::default() };
    match Document::parse_with_options(text, options) {
        Ok(document) => reader.root(document.root_element()),
        Err(error) => {
            let at = byte_of(text, error.pos().row, error.pos().col);
            let character = text[at..].chars().next().map_or(0, char::len_utf8);
            reader.report(Problem::P6077, at..at + character, format!("this is not XML that TwinCAT writes: {error}"));
        }
    }
    Read { text: reader.view.finish(), diagnostics: reader.diagnostics }
}

struct Reader<'t> {
    file: FileId,
    text: &'t str,
    view: View,
    /// Where what was put into the view ends.
    at: usize,
    diagnostics: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn report(&mut self, problem: Problem, range: Range<usize>, message: String) {
        let span = Span::new(self.file, range.start as u32, range.end as u32);
        self.diagnostics.push(Diagnostic::new(problem, span, message));
    }

    fn root(&mut self, root: Node<'_, '_>) {
        let mut read = false;
        for object in root.children().filter(Node::is_element) {
            match object.tag_name().name() {
                "POU" | "Itf" => self.block(object),
                "DUT" | "GVL" => drop(self.declaration(object)),
                _ => continue,
            }
            read = true;
        }
        if !read {
            let name = root.tag_name().name().to_owned();
            let range = self.head(root);
            self.report(
                Problem::P6079,
                range,
                format!("this file of TwinCAT (`{name}`) holds no POU, interface, type or list of global variables"),
            );
        }
    }

    /// The begin tag of an element.
    fn head(&self, node: Node<'_, '_>) -> Range<usize> {
        let range = node.range();
        let end = self.text[range.clone()].find('>').map_or(range.end, |end| range.start + end + 1);
        range.start..end
    }

    /// A program, function, function block or interface with its members.
    fn block(&mut self, block: Node<'_, '_>) {
        let name = block.attribute("Name").unwrap_or_default();
        let begin = self.declaration(block);
        self.body(block, name);
        for member in block.children().filter(Node::is_element) {
            let own = member.attribute("Name").unwrap_or_default();
            let full = format!("{name}.{own}");
            match member.tag_name().name() {
                "Method" => {
                    self.declaration(member);
                    self.body(member, &full);
                    self.word(member.range().end, "END_METHOD");
                }
                "Property" => {
                    self.declaration(member);
                    for accessor in member.children().filter(Node::is_element) {
                        let (first, last) = match accessor.tag_name().name() {
                            "Get" => ("GET", "END_GET"),
                            "Set" => ("SET", "END_SET"),
                            _ => continue,
                        };
                        self.at = self.at.max(accessor.range().start);
                        self.word(accessor.range().end, first);
                        self.declaration(accessor);
                        self.body(accessor, &full);
                        self.word(accessor.range().end, last);
                    }
                    self.word(member.range().end, "END_PROPERTY");
                }
                "Action" => {
                    self.at = self.at.max(member.range().start);
                    self.word(member.range().end, &format!("ACTION {own}:"));
                    self.body(member, &full);
                    self.word(member.range().end, "END_ACTION");
                }
                _ => {}
            }
        }
        if let Some(word) = begin {
            self.view.append(&format!("END_{word}"));
        }
    }

    /// Takes over the declaration of an element; the keyword that it begins with.
    fn declaration(&mut self, of: Node<'_, '_>) -> Option<String> {
        let declaration = of.children().find(|child| child.has_tag_name("Declaration"))?;
        let parts = self.keep(declaration);
        parts.into_iter().find_map(|part| first_word(&self.text[part]))
    }

    /// Takes over the statements of an element.
    fn body(&mut self, of: Node<'_, '_>, name: &str) {
        let bodies = of.children().filter(|child| child.has_tag_name("Implementation")).flat_map(|body| body.children());
        for body in bodies.filter(Node::is_element) {
            match body.tag_name().name() {
                "ST" => drop(self.keep(body)),
                other => {
                    let message = format!("the body of `{name}` is a diagram (`{other}`), and only Structured Text is read");
                    let range = self.head(body);
                    self.report(Problem::P6078, range, message);
                }
            }
        }
    }

    /// Takes over the CDATA sections of an element, or its text where it has none; where they lie.
    fn keep(&mut self, node: Node<'_, '_>) -> Vec<Range<usize>> {
        let head = self.head(node).end;
        let range = head..node.range().end;
        let inside = &self.text[range.clone()];
        let mut parts = Vec::new();
        let mut rest = 0;
        while let Some(begin) = inside[rest..].find("<![CDATA[").map(|at| rest + at + "<![CDATA[".len()) {
            let end = inside[begin..].find("]]>").map_or(inside.len(), |at| begin + at);
            parts.push(range.start + begin..range.start + end);
            rest = end;
        }
        if parts.is_empty() {
            let end = inside.rfind("</").unwrap_or(0);
            if inside[..end].contains('&') {
                let message = "text with characters such as `&lt;` is not read; TwinCAT writes CDATA".to_owned();
                self.report(Problem::P6077, range.start..range.start + end, message);
            } else if end > 0 {
                parts.push(range.start..range.start + end);
            }
        }
        for part in &parts {
            self.view.keep(self.text, part.clone());
            self.at = self.at.max(part.end);
        }
        parts
    }

    /// Writes a word behind what was written last, up to the end of an element: its tags are longer than the word.
    fn word(&mut self, end: usize, word: &str) {
        if let Some(at) = self.view.write(self.at..end.max(self.at), word) {
            self.at = at;
        }
    }
}

/// The first word of a declaration, in upper case, without comments and attributes before it.
fn first_word(declaration: &str) -> Option<String> {
    let mut rest = declaration.trim_start();
    loop {
        let end = match rest.get(..2).unwrap_or_default() {
            "(*" => rest.find("*)").map(|at| at + 2),
            "//" => rest.find('\n'),
            _ if rest.starts_with('{') => rest.find('}').map(|at| at + 1),
            _ => break,
        };
        rest = rest[end?..].trim_start();
    }
    let word: String = rest.chars().take_while(|&c| c.is_ascii_alphabetic() || c == '_').collect();
    (!word.is_empty()).then(|| word.to_ascii_uppercase())
}

/// The byte at a row and a column, both counted from 1, the column in characters.
fn byte_of(text: &str, row: u32, column: u32) -> usize {
    let line = text.split_inclusive('\n').take(row.saturating_sub(1) as usize).map(str::len).sum::<usize>();
    let rest = text.get(line..).unwrap_or_default();
    let inside = rest.char_indices().nth(column.saturating_sub(1) as usize).map_or(rest.len(), |(at, _)| at);
    (line + inside).min(text.len())
}
