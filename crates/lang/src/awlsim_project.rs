//! Projects of awlsim (`.awlpro`): what their XML says, as plain data.

use std::ops::RangeInclusive;

use roxmltree::{Document, Node, ParsingOptions};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};

/// Elements, texts and comments that a project may have: one with a source per block of the largest CPU has fewer.
const NODES_MAX: u32 = 100_000;
/// Levels of elements; a project has five.
const DEPTH_MAX: usize = 32;
/// Problems that are shown of one file.
const DIAGNOSTICS_MAX: usize = 100;
/// The one version of the format.
const FORMAT_VERSION: &str = "1";

/// What a project says. What it leaves out is `None`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AwlsimProject {
    /// The CPU.
    pub specs: Specs,
    /// How it is set up.
    pub config: Config,
    /// STL sources.
    pub sources: Vec<Source>,
    /// Symbol tables, `.asc` or CSV with semicolons.
    pub symbols: Vec<Source>,
    /// Blocks of its library that it takes.
    pub libraries: Vec<LibrarySelection>,
}

/// The figures of the CPU.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Specs {
    /// 2 or 4.
    pub accumulators: Option<u8>,
    /// Timers, 1 to 65535.
    pub timers: Option<u16>,
    /// Counters, 1 to 65535.
    pub counters: Option<u16>,
    /// Bytes of bit memory, 1 to 65536.
    pub flags: Option<u32>,
    /// Bytes of the process image of the inputs, 1 to 65536.
    pub inputs: Option<u32>,
    /// Bytes of the process image of the outputs, 1 to 65536.
    pub outputs: Option<u32>,
    /// Bytes of local data of a block, 1 to 65536.
    pub local_bytes: Option<u32>,
}

/// How the CPU is set up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Config {
    /// The byte of bit memory with the clock memory.
    pub clock_memory_byte: Option<u16>,
    /// Greatest cycle time, in microseconds.
    pub cycle_time_limit_us: Option<u64>,
    /// Whether extension words may be used.
    pub extended: bool,
    /// The mnemonic language; `None` = judged over each source.
    pub mnemonics: Option<Mnemonics>,
}

/// A source or symbol table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Its name.
    pub name: String,
    /// Where its text comes from.
    pub content: Content,
    /// Its element.
    pub span: Span,
}

/// Where a text comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Content {
    /// The project holds it.
    Inline(String),
    /// A file, by its path relative to the project, with `/` between the names.
    File(String),
}

/// A library block that the project takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LibrarySelection {
    /// The library: `IEC`.
    pub library: String,
    /// The block in the library.
    pub block: BlockId,
    /// Its number in the program.
    pub number: u16,
    /// Its element.
    pub span: Span,
}

/// Reads a project; `None` if it is none. What is wrong with one part leaves the others in force.
pub fn read(file: FileId, text: &str) -> (Option<AwlsimProject>, Vec<Diagnostic>) {
    let mut reader = Reader { file, project: AwlsimProject::default(), diagnostics: Vec::new() };
    if let Some(head) = ini_head(text) {
        let start = text.find(head).unwrap_or_default() as u32;
        let span = Span::new(file, start, start + head.len() as u32);
        let message = "this project has the old format of INI files; format version 1, which is XML, is known";
        let help = "Convert it once with `awlsim-proupgrade`, a tool of awlsim, and use the file that it writes.";
        return (None, vec![Diagnostic::new(Problem::P6041, span, message).help(help)]);
    }
    // No DTD: neither entities that multiply nor files from elsewhere.
    let options = ParsingOptions { allow_dtd: false, nodes_limit: NODES_MAX, ..ParsingOptions::default() };
    let document = match Document::parse_with_options(text, options) {
        Ok(document) => document,
        Err(error) => {
            let position = error.pos();
            let at = byte_of(text, position.row, position.col);
            let character = text[at as usize..].chars().next().map_or(0, char::len_utf8);
            let span = Span::new(file, at, at + character as u32);
            reader.report(Problem::P6040, span, format!("this is not XML that a project can have: {error}"));
            return (None, reader.diagnostics);
        }
    };
    let root = document.root_element();
    if root.descendants().any(|node| node.is_element() && node.ancestors().take(DEPTH_MAX + 1).count() > DEPTH_MAX) {
        let message = format!("the elements of this file are nested more than {DEPTH_MAX} levels deep");
        reader.report(Problem::P6040, reader.head(&root), message);
        return (None, reader.diagnostics);
    }
    if root.tag_name().name() != "awlsim_project" {
        let message = format!("the first element is `{}`, that of a project is `awlsim_project`", root.tag_name().name());
        reader.report(Problem::P6041, reader.head(&root), message);
        return (None, reader.diagnostics);
    }
    let version = root.attribute("format_version").unwrap_or(FORMAT_VERSION);
    if version.trim() != FORMAT_VERSION {
        let message = format!("this project has format version `{version}`; version {FORMAT_VERSION} is known");
        reader.report(Problem::P6041, reader.head(&root), message);
        return (None, reader.diagnostics);
    }
    for part in root.children().filter(Node::is_element) {
        match part.tag_name().name() {
            "cpu" => reader.cpu(&part),
            "language_awl" => {
                let sources = reader.sources(&part);
                reader.project.sources.extend(sources);
            }
            "language_fup" => reader.diagrams(&part),
            "language_kop" => reader.diagrams(&part),
            "symbols" => {
                let sources = reader.sources(&part);
                reader.project.symbols.extend(sources);
            }
            "libraries" => reader.libraries(&part),
            "hardware" => reader.hardware(&part),
            // How its windows look, and how its parts talk to one another.
            "gui" | "core_link" => {}
            name => {
                let message = format!("`{name}` is no part of a project that is known here; it is not used");
                reader.report(Problem::P6044, reader.head(&part), message);
            }
        }
    }
    (Some(reader.project), reader.diagnostics)
}

/// The first section of a project that awlsim wrote before its projects were XML.
fn ini_head(text: &str) -> Option<&str> {
    const SECTION: &str = "[AWLSIM_PROJECT]";
    let lines = text.lines().map(|line| line.trim().trim_start_matches('\u{feff}'));
    let first = lines.into_iter().find(|line| !line.is_empty() && !line.starts_with([';', '#']))?;
    first.get(..SECTION.len()).filter(|head| head.eq_ignore_ascii_case(SECTION))
}

struct Reader {
    file: FileId,
    project: AwlsimProject,
    diagnostics: Vec<Diagnostic>,
}

impl Reader {
    fn report(&mut self, problem: Problem, span: Span, message: impl Into<String>) {
        if self.diagnostics.len() < DIAGNOSTICS_MAX {
            self.diagnostics.push(Diagnostic::new(problem, span, message));
        }
    }

    /// The place of an element's own tag.
    fn head(&self, node: &Node<'_, '_>) -> Span {
        let range = node.range();
        let text = node.document().input_text();
        let end = text.get(range.clone()).and_then(|inner| inner.find('>')).map_or(range.end, |end| range.start + end + 1);
        Span::new(self.file, range.start as u32, end as u32)
    }

    /// A number in an attribute; -1 and nothing mean that it is left out.
    fn number(&mut self, node: &Node<'_, '_>, name: &str, valid: RangeInclusive<u64>) -> Option<u64> {
        let attribute = node.attribute_node(name)?;
        let written = attribute.value().trim();
        if written.is_empty() || written == "-1" {
            return None;
        }
        match written.parse().ok().filter(|number| valid.contains(number)) {
            Some(number) => Some(number),
            None => {
                let range = attribute.range();
                let span = Span::new(self.file, range.start as u32, range.end as u32);
                let message = format!("`{name}` is a number from {} to {}, not `{written}`", valid.start(), valid.end());
                self.report(Problem::P6042, span, message);
                None
            }
        }
    }

    fn flag(&mut self, node: &Node<'_, '_>, name: &str) -> Option<bool> {
        let attribute = node.attribute_node(name)?;
        match attribute.value().trim().to_ascii_lowercase().as_str() {
            "1" | "true" | "yes" => Some(true),
            "0" | "false" | "no" | "" => Some(false),
            other => {
                let range = attribute.range();
                let span = Span::new(self.file, range.start as u32, range.end as u32);
                self.report(Problem::P6042, span, format!("`{name}` is 0 or 1, not `{other}`"));
                None
            }
        }
    }

    fn cpu(&mut self, cpu: &Node<'_, '_>) {
        for part in cpu.children().filter(Node::is_element) {
            match part.tag_name().name() {
                "specs" => {
                    let bytes = 1..=65_536;
                    self.project.specs = Specs {
                        accumulators: match self.number(&part, "nr_accus", 2..=4) {
                            Some(3) => {
                                self.report(Problem::P6042, self.head(&part), "a CPU has 2 or 4 accumulators, not 3");
                                None
                            }
                            number => number.map(|number| number as u8),
                        },
                        timers: self.number(&part, "nr_timers", 1..=65_535).map(|number| number as u16),
                        counters: self.number(&part, "nr_counters", 1..=65_535).map(|number| number as u16),
                        flags: self.number(&part, "nr_flags", bytes.clone()).map(|number| number as u32),
                        inputs: self.number(&part, "nr_inputs", bytes.clone()).map(|number| number as u32),
                        outputs: self.number(&part, "nr_outputs", bytes.clone()).map(|number| number as u32),
                        local_bytes: self.number(&part, "nr_localbytes", bytes).map(|number| number as u32),
                    };
                }
                "config" => {
                    self.project.config = Config {
                        clock_memory_byte: self.number(&part, "clock_memory_byte", 0..=65_535).map(|number| number as u16),
                        cycle_time_limit_us: self.number(&part, "cycle_time_limit_us", 0..=u64::from(u32::MAX)),
                        extended: self.flag(&part, "ext_insns_enable").unwrap_or(false),
                        mnemonics: self.mnemonics(&part),
                    };
                }
                _ => {}
            }
        }
    }

    /// The language by its name or its number there: 0 automatic, 1 English, 2 German.
    fn mnemonics(&mut self, config: &Node<'_, '_>) -> Option<Mnemonics> {
        let attribute = config.attribute_node("mnemonics")?;
        match attribute.value().trim().to_ascii_lowercase().as_str() {
            "" | "0" | "auto" | "automatic" => None,
            "1" | "en" | "english" => Some(Mnemonics::English),
            "2" | "de" | "german" => Some(Mnemonics::German),
            other => {
                let range = attribute.range();
                let span = Span::new(self.file, range.start as u32, range.end as u32);
                self.report(
                    Problem::P6042,
                    span,
                    format!("`{other}` is no mnemonic language; known are `auto` (0), `en` (1) and `de` (2)"),
                );
                None
            }
        }
    }

    /// The enabled sources of a part.
    fn sources(&mut self, part: &Node<'_, '_>) -> Vec<Source> {
        let mut sources = Vec::new();
        for node in part.children().filter(|node| node.is_element() && node.tag_name().name() == "source") {
            if self.flag(&node, "enabled") == Some(false) {
                continue;
            }
            let content = match node.attribute("file").map(str::trim).filter(|file| !file.is_empty()) {
                Some(file) => Content::File(file.replace('\\', "/")),
                None => Content::Inline(text_of(&node)),
            };
            let name = node.attribute("name").unwrap_or_default().trim().to_owned();
            sources.push(Source { name, content, span: self.head(&node) });
        }
        sources
    }

    /// Diagrams have no meaning here. Those that are enabled and hold something are refused: the program would lack them.
    fn diagrams(&mut self, part: &Node<'_, '_>) {
        for diagram in self.sources(part) {
            let empty = match &diagram.content {
                Content::File(_) => false,
                Content::Inline(text) => is_empty_diagram(text),
            };
            if !empty {
                let message = format!("the diagram `{}` is not compiled: Sieben reads the STL sources of a project", diagram.name);
                self.report(Problem::P6043, diagram.span, message);
            }
        }
    }

    fn libraries(&mut self, part: &Node<'_, '_>) {
        for node in part.children().filter(|node| node.is_element() && node.tag_name().name() == "lib_selection") {
            let span = self.head(&node);
            let kind = match node.attribute("type").unwrap_or_default().trim().to_ascii_uppercase().as_str() {
                "FC" => BlockKind::Function,
                "FB" => BlockKind::FunctionBlock,
                "" => {
                    self.report(Problem::P6042, span, "a `lib_selection` says with `type` whether its block is an `FC` or an `FB`");
                    continue;
                }
                other => {
                    self.report(Problem::P6042, span, format!("a library has blocks of type `FC` and `FB`, not `{other}`"));
                    continue;
                }
            };
            let Some(index) = self.number(&node, "index", 0..=65_535) else { continue };
            let number = self.number(&node, "effective_index", 0..=65_535).unwrap_or(index) as u16;
            let library = node.attribute("name").unwrap_or_default().trim().to_owned();
            self.project.libraries.push(LibrarySelection { library, block: BlockId::new(kind, index as u16), number, span });
        }
    }

    /// Modules that reach real inputs and outputs are not there; the process image takes their place.
    fn hardware(&mut self, part: &Node<'_, '_>) {
        for module in part.descendants().filter(|node| node.is_element() && node.tag_name().name() == "module") {
            let name = module.attribute("name").unwrap_or_default();
            // The one that is there for trying out does what simulated modules do.
            if !name.eq_ignore_ascii_case("dummy") && !name.eq_ignore_ascii_case("debug") {
                let message = format!("the module `{name}` is not there; simulated modules take its place");
                self.report(Problem::P6044, self.head(&module), message);
            }
        }
    }
}

/// The text inside an element, its CDATA sections joined, without the line end behind the opening tag.
fn text_of(node: &Node<'_, '_>) -> String {
    let text: String = node.children().filter(Node::is_text).filter_map(|child| child.text()).collect();
    match text.strip_prefix('\n') {
        Some(rest) => rest.to_owned(),
        None => text,
    }
}

/// Whether a grid diagram holds no element. What is no XML may be anything.
fn is_empty_diagram(text: &str) -> bool {
    if text.trim().is_empty() {
        return true;
    }
    let options = ParsingOptions { allow_dtd: false, nodes_limit: NODES_MAX, ..ParsingOptions::default() };
    match Document::parse_with_options(text.trim(), options) {
        Ok(document) => !document.descendants().any(|node| {
            let name = node.tag_name().name();
            node.is_element()
                && (name.starts_with("elem") || name.starts_with("wire"))
                && (node.has_attribute("x") || node.has_attribute("type"))
        }),
        Err(_) => false,
    }
}

/// The byte at a row and a column, both counted from 1, the column in characters.
fn byte_of(text: &str, row: u32, column: u32) -> u32 {
    let line = text.split_inclusive('\n').take(row.saturating_sub(1) as usize).map(str::len).sum::<usize>();
    let rest = text.get(line..).unwrap_or_default();
    let inside = rest.char_indices().nth(column.saturating_sub(1) as usize).map_or(rest.len(), |(at, _)| at);
    (line + inside).min(text.len()) as u32
}

/// Survives any bytes: what is understood lies in the text.
pub fn fuzz(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let (project, diagnostics) = read(FileId::default(), &text);
    let spans = project.iter().flat_map(|project| project.sources.iter().chain(&project.symbols)).map(|source| source.span);
    for span in spans.chain(diagnostics.iter().map(|diagnostic| diagnostic.span)) {
        assert!(text.get(span.start as usize..span.end as usize).is_some(), "the place lies in the file");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn codes(text: &str) -> Vec<&'static str> {
        read(FileId::default(), text).1.iter().map(|diagnostic| diagnostic.problem.code()).collect()
    }

    fn project(inner: &str) -> String {
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<awlsim_project format_version=\"1\">\n{inner}\n</awlsim_project>\n"
        )
    }

    #[test]
    fn a_whole_project_is_read() {
        let text = project(
            "<cpu><specs call_stack_size=\"256\" nr_accus=\"4\" nr_counters=\"100\" nr_flags=\"256\" nr_inputs=\"128\" nr_outputs=\"64\" \
             nr_localbytes=\"1024\" nr_timers=\"50\"/>\
             <config clock_memory_byte=\"-1\" cycle_time_limit_us=\"1000000\" ext_insns_enable=\"1\" mnemonics=\"2\" ob_startinfo_enable=\"0\"/></cpu>\
             <language_awl><source enabled=\"1\" name=\"Main\" type=\"0\"><![CDATA[\nU E 0.0\r\n= A 0.0 // <>&]]></source>\
             <source enabled=\"0\" name=\"Off\"><![CDATA[X]]></source><source name=\"File\" file=\"src\\b.awl\"/></language_awl>\
             <language_fup><source name=\"D\" enabled=\"1\"><![CDATA[]]></source></language_fup>\
             <symbols><source name=\"S\"><![CDATA[a;M 0.0;BOOL;]]></source></symbols>\
             <libraries><lib_selection name=\"IEC\" type=\"FC\" index=\"4\" effective_index=\"-1\"/>\
             <lib_selection name=\"IEC\" type=\"FC\" index=\"2\" effective_index=\"102\"/></libraries>\
             <hardware/><gui><editor/></gui><core_link><spawn_local/></core_link>",
        );
        let (project, diagnostics) = read(FileId::default(), &text);
        assert_eq!(diagnostics, []);
        let project = project.expect("a project");
        assert_eq!(
            project.specs,
            Specs {
                accumulators: Some(4),
                timers: Some(50),
                counters: Some(100),
                flags: Some(256),
                inputs: Some(128),
                outputs: Some(64),
                local_bytes: Some(1024)
            }
        );
        assert_eq!(
            project.config,
            Config { clock_memory_byte: None, cycle_time_limit_us: Some(1_000_000), extended: true, mnemonics: Some(Mnemonics::German) }
        );
        let sources: Vec<(&str, &Content)> = project.sources.iter().map(|source| (source.name.as_str(), &source.content)).collect();
        assert_eq!(
            sources,
            [("Main", &Content::Inline("U E 0.0\n= A 0.0 // <>&".to_owned())), ("File", &Content::File("src/b.awl".to_owned()))]
        );
        let libraries: Vec<(u16, u16)> = project.libraries.iter().map(|library| (library.block.number, library.number)).collect();
        assert_eq!((project.symbols.len(), libraries), (1, vec![(4, 4), (2, 102)]));
    }

    #[test]
    fn every_mistake_has_its_code() {
        for (text, expected) in [
            ("", "P6040"),
            ("<awlsim_project", "P6040"),
            ("<a><b></a>", "P6040"),
            ("<!DOCTYPE a [<!ENTITY b \"bbbb\">]><awlsim_project>&b;</awlsim_project>", "P6040"),
            ("<!DOCTYPE a SYSTEM \"file:///etc/passwd\"><awlsim_project/>", "P6040"),
            ("<project/>", "P6041"),
            ("<awlsim_project format_version=\"2\"/>", "P6041"),
            (&project("<cpu><specs nr_flags=\"99999999999999999999\"/></cpu>"), "P6042"),
            (&project("<cpu><specs nr_accus=\"3\"/></cpu>"), "P6042"),
            (&project("<cpu><config mnemonics=\"fr\"/></cpu>"), "P6042"),
            (&project("<cpu><config ext_insns_enable=\"perhaps\"/></cpu>"), "P6042"),
            (&project("<libraries><lib_selection name=\"IEC\" type=\"OB\" index=\"1\"/></libraries>"), "P6042"),
            (
                &project("<language_fup><source name=\"D\"><![CDATA[<FUP><grid><elem x=\"1\"/></grid></FUP>]]></source></language_fup>"),
                "P6043",
            ),
            (&project("<language_fup><source name=\"D\"><![CDATA[anything]]></source></language_fup>"), "P6043"),
            (&project("<hardware><modules><module name=\"rpigpio\"/></modules></hardware>"), "P6044"),
            (&project("<spaceship/>"), "P6044"),
        ] {
            assert_eq!(codes(text), [expected], "{text}");
        }
        assert_eq!(codes(&project("<hardware><module name=\"dummy\"/></hardware><gui/>")), Vec::<&str>::new());
    }

    #[test]
    fn files_that_want_to_hurt_end_soon() {
        let deep = format!("{}{}", "<a>".repeat(50_000), "</a>".repeat(50_000));
        assert_eq!(codes(&deep), ["P6040"]);
        let wide = format!("<awlsim_project>{}</awlsim_project>", "<a/>".repeat(200_000));
        assert_eq!(codes(&wide), ["P6040"]);
        let many = project(&"<spaceship/>".repeat(5_000));
        assert_eq!(codes(&many).len(), DIAGNOSTICS_MAX);
        let attributes = format!("<awlsim_project {}/>", (0..5_000).map(|n| format!("a{n}=\"\" ")).collect::<String>());
        assert_eq!(codes(&attributes), Vec::<&str>::new());
    }

    #[test]
    fn no_cut_and_no_exchange_of_bytes_panics() {
        let text = project(
            "<cpu><specs nr_accus=\"4\"/><config mnemonics=\"2\"/></cpu><language_awl><source name=\"ü\"><![CDATA[U E 0.0]]></source></language_awl>",
        );
        for at in 0..text.len() {
            fuzz(&text.as_bytes()[..at]);
            fuzz(&text.as_bytes()[at..]);
            for other in [b'<', b'>', b'&', b'"', 0, 0xFF, b']', b'/'] {
                let mut changed = text.clone().into_bytes();
                changed[at] = other;
                fuzz(&changed);
            }
        }
    }
}
