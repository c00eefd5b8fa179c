//! `sieben.toml`: what a project says about itself.

mod cyclic;
pub mod modules;
pub mod servers;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::time::Duration;

use sieben_cpu::retain::Numbers;
use sieben_cpu::{CyclicInterrupt, ImageErrors, RetentiveAreas};
use sieben_lang::library::{self, Selection};
use sieben_lang::st::dialect::Dialect;
use sieben_model::address::Operand;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::profile::Profile;
use sieben_model::source::{FileId, Span};
use sieben_sim::duration::CYCLE_MAX;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use modules::Module;
use servers::Servers;
use sieben_model::nearest::{nearest, one_of};

/// Name of the file that makes a folder a project.
pub const FILE_NAME: &str = "sieben.toml";

/// What the cycle monitoring time can be set to.
pub const WATCHDOG: std::ops::RangeInclusive<Duration> = Duration::from_millis(1)..=Duration::from_secs(6);

/// A text with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// The text.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// What the file says; all of it optional.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// `project.name`.
    pub name: Option<String>,
    /// `project.sources`: patterns of paths inside the project folder.
    pub sources: Option<Vec<Placed>>,
    /// `project.symbols`: patterns of symbol tables.
    pub symbols: Option<Vec<Placed>>,
    /// `project.tests`: patterns of test files.
    pub tests: Option<Vec<Placed>>,
    /// `project.mnemonics`; `None` = judged over each file.
    pub mnemonics: Option<Mnemonics>,
    /// `project.dialect`; `None` = judged over each file.
    pub dialect: Option<Dialect>,
    /// `project.library` and the numbers under `[library]`.
    pub library: Selection,
    /// `project.extended`: the sources use the extension words of awlsim.
    pub extended: bool,
    /// `project.profile`: whose rules hold where awlsim and the manual differ.
    pub profile: Option<Profile>,
    /// `cpu.type`.
    pub cpu: Option<&'static CpuType>,
    /// `cpu.cycle`; zero = free running.
    pub cycle: Option<Duration>,
    /// `cpu.watchdog`.
    pub watchdog: Option<Duration>,
    /// `cpu.min_cycle`.
    pub min_cycle: Option<Duration>,
    /// `cpu.image_errors`: whether OB 85 comes when a module does not answer the process image.
    pub image_errors: Option<ImageErrors>,
    /// `cpu.clock_memory_byte`: the byte of bit memory that holds the clock memory.
    pub clock_memory_byte: Option<u16>,
    /// `[cyclic.35]` and the like: cyclic interrupts by the number of their organization block.
    pub cyclic: BTreeMap<u16, CyclicInterrupt>,
    /// `cpu.retain`.
    pub retain: Retain,
    /// `[[module]]`: simulated devices.
    pub modules: Vec<Module>,
    /// `[servers]`: who serves clients over the network.
    pub servers: Servers,
}

/// What is retentive, as far as the file says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Retain {
    /// Bytes of bit memory, with the place of the text.
    pub bit_memory: Option<(Numbers, Span)>,
    /// Timers.
    pub timers: Option<(Numbers, Span)>,
    /// Counters.
    pub counters: Option<(Numbers, Span)>,
    /// How often the data goes to the disk; zero = every scan.
    pub sync: Option<Duration>,
}

impl Retain {
    /// What is retentive, with the default of the CPU types for what the file does not say.
    pub fn areas(&self) -> RetentiveAreas {
        let or = |numbers: &Option<(Numbers, Span)>, default| numbers.as_ref().map_or(default, |(numbers, _)| numbers.clone());
        let default = RetentiveAreas::default();
        RetentiveAreas {
            bit_memory: or(&self.bit_memory, default.bit_memory),
            timers: or(&self.timers, default.timers),
            counters: or(&self.counters, default.counters),
        }
    }

    /// Ranges that the CPU type does not have.
    pub fn beyond(&self, cpu: &CpuType) -> Vec<Diagnostic> {
        let rows = [
            (&self.bit_memory, cpu.bit_memory, "MB"),
            (&self.timers, u32::from(cpu.timers), "T"),
            (&self.counters, u32::from(cpu.counters), "C"),
        ];
        let beyond = |(numbers, count, area): (&Option<(Numbers, Span)>, u32, &str)| {
            let (numbers, span) = numbers.as_ref()?;
            let last = numbers.last().filter(|&last| u32::from(last) >= count)?;
            let message =
                format!("{area} {last} cannot be retentive: the CPU {} has {area} 0 to {area} {}", cpu.name, count.saturating_sub(1));
            Some(Diagnostic::new(Problem::P6030, *span, message))
        };
        rows.into_iter().filter_map(beyond).collect()
    }
}

/// A key that the file may have: its table, its name, and whether this version uses it.
struct Key {
    table: &'static str,
    name: &'static str,
    used: bool,
}

const fn used(table: &'static str, name: &'static str) -> Key {
    Key { table, name, used: true }
}
const fn later(table: &'static str, name: &'static str) -> Key {
    Key { table, name, used: false }
}

/// All keys. Those of later versions are known already, so that a project may carry them without an error.
const KEYS: &[Key] = &[
    used("", "project"),
    used("", "cpu"),
    used("", "library"),
    used("", "module"),
    used("", "cyclic"),
    used("", "servers"),
    used("servers", "s7"),
    used("servers", "page"),
    used("servers.page", "listen"),
    used("servers.page", "tokens"),
    later("servers", "modbus"),
    later("servers", "mqtt"),
    used("servers.s7", "listen"),
    used("servers.s7", "protection"),
    used("servers.s7", "password"),
    used("servers.s7", "read_only"),
    used("servers.s7", "allow"),
    used("servers.s7", "max_connections"),
    used("servers.s7", "strict"),
    used("servers.s7", "strict_slot"),
    used("servers.s7", "audit"),
    used("servers.s7", "pcap"),
    used("servers.s7.audit", "file"),
    used("servers.s7.audit", "writes"),
    used("servers.s7.audit", "required"),
    used("project", "name"),
    used("project", "sources"),
    used("project", "symbols"),
    used("project", "mnemonics"),
    used("project", "dialect"),
    used("project", "tests"),
    used("project", "library"),
    later("project", "dialect"),
    used("project", "extended"),
    used("project", "profile"),
    used("cpu", "type"),
    used("cpu", "cycle"),
    used("cpu", "watchdog"),
    used("cpu", "min_cycle"),
    used("cpu", "image_errors"),
    used("cpu", "clock_memory_byte"),
    used("cpu", "retain"),
    used("cpu.retain", "m"),
    used("cpu.retain", "t"),
    used("cpu.retain", "c"),
    used("cpu.retain", "sync"),
];

/// Reads the text of a `sieben.toml`; what is wrong with one key leaves the others in force.
pub fn parse(text: &str, file: FileId) -> (Settings, Vec<Diagnostic>) {
    let mut reader = Reader { file, settings: Settings::default(), diagnostics: Vec::new() };
    match DeTable::parse(text) {
        Ok(table) => reader.root(table.get_ref()),
        Err(error) => {
            let span = error.span().unwrap_or(0..0);
            let message = format!("`{FILE_NAME}` is not valid TOML: {}", error.message().replace('\n', "; "));
            reader.diagnostics.push(Diagnostic::new(Problem::P6007, reader.span(span), message));
        }
    }
    (reader.settings, reader.diagnostics)
}

struct Reader {
    file: FileId,
    settings: Settings,
    diagnostics: Vec<Diagnostic>,
}

type Value<'i> = Spanned<DeValue<'i>>;

impl Reader {
    fn span(&self, range: std::ops::Range<usize>) -> Span {
        // Files above 64 MiB are refused before, so that offsets fit.
        Span::new(self.file, range.start as u32, range.end as u32)
    }

    fn root(&mut self, table: &DeTable<'_>) {
        for (key, value) in table {
            if !self.known("", key) {
                continue;
            }
            match (key.get_ref().as_ref(), value.get_ref()) {
                ("library", DeValue::Table(inner)) => self.library(inner),
                ("cyclic", DeValue::Table(inner)) => self.cyclic(inner),
                ("servers", DeValue::Table(inner)) => self.servers(inner),
                ("module", _) => self.modules(value),
                (name @ ("project" | "cpu"), DeValue::Table(inner)) => self.table(name, inner),
                (name, _) => self.wrong(value, &format!("`{name}` is a table: write `[{name}]` on a line of its own, and its keys below")),
            }
        }
    }

    fn table(&mut self, table: &str, content: &DeTable<'_>) {
        for (key, value) in content {
            if !self.known(table, key) {
                continue;
            }
            let name: &str = key.get_ref();
            match (table, name) {
                ("project", "name") => self.settings.name = self.text(value, name).map(|placed| placed.text),
                ("project", "sources") => self.settings.sources = self.list(value, name),
                ("project", "symbols") => self.settings.symbols = self.list(value, name),
                ("project", "tests") => self.settings.tests = self.list(value, name),
                ("project", "mnemonics") => self.mnemonics(value),
                ("project", "dialect") => self.dialect(value),
                ("project", "library") => match value.get_ref() {
                    DeValue::Boolean(enabled) => self.settings.library.enabled = *enabled,
                    _ => self.wrong(value, "`library` is `true` or `false`; numbers of its blocks stand in a table `[library]`"),
                },
                ("project", "profile") => self.profile(value),
                ("project", "extended") => match value.get_ref() {
                    DeValue::Boolean(extended) => self.settings.extended = *extended,
                    _ => self.wrong(value, "`extended` is `true` or `false`: `extended = true`"),
                },
                ("cpu", "type") => self.cpu(value),
                ("cpu", "cycle") => {
                    self.settings.cycle = match value.get_ref() {
                        DeValue::String(text) if text.eq_ignore_ascii_case("free") => Some(Duration::ZERO),
                        _ => self.cycle(value, name),
                    }
                }
                ("cpu", "watchdog") => self.watchdog(value),
                ("cpu", "min_cycle") => self.settings.min_cycle = self.cycle(value, name),
                ("cpu", "image_errors") => self.image_errors(value),
                ("cpu", "clock_memory_byte") => self.clock_memory_byte(value),
                ("cpu", "retain") => match value.get_ref() {
                    DeValue::Table(inner) => self.table("cpu.retain", inner),
                    _ => {
                        self.wrong(value, "`retain` says which numbers are retentive: `retain = { m = \"0..15\", t = \"\", c = \"0..7\" }`")
                    }
                },
                ("cpu.retain", "m") => self.settings.retain.bit_memory = self.numbers(value, name),
                ("cpu.retain", "t") => self.settings.retain.timers = self.numbers(value, name),
                ("cpu.retain", "c") => self.settings.retain.counters = self.numbers(value, name),
                ("cpu.retain", "sync") => self.settings.retain.sync = self.duration(value, name),
                _ => {}
            }
        }
    }

    /// Numbers for blocks of the library: `CONCAT = "FC 102"`.
    fn library(&mut self, content: &DeTable<'_>) {
        for (key, value) in content {
            let name: &str = key.get_ref();
            let Some(block) = library::by_name(name) else {
                let span = self.span(key.span());
                let diagnostic = Diagnostic::new(Problem::P6008, span, format!("the library has no block `{name}`"));
                self.diagnostics.push(match nearest(name, library::ALL.iter().map(|block| block.name)) {
                    Some(near) => diagnostic.help(format!("did you mean `{near}`?")).fix(span, near, format!("write `{near}`")),
                    None => diagnostic.help("`sieben explain library` lists its blocks"),
                });
                continue;
            };
            let Some(placed) = self.text(value, name) else { continue };
            match Operand::parse(&placed.text) {
                Some(Operand::Block(id)) if id.kind == block.block.kind => {
                    self.settings.library.numbers.insert(block.name.to_owned(), id);
                }
                _ => {
                    let kind = block.block.kind.abbreviation();
                    self.wrong(value, &format!("`{name}` is an {kind}: write its number as `{name} = \"{kind} 102\"`"));
                }
            }
        }
    }

    /// Whether a key exists and is used; says so if not.
    fn known(&mut self, table: &str, key: &Spanned<Cow<'_, str>>) -> bool {
        let name: &str = key.get_ref();
        let span = self.span(key.span());
        let path = if table.is_empty() { name.to_owned() } else { format!("{table}.{name}") };
        let siblings = || KEYS.iter().filter(|key| key.table == table).map(|key| key.name);
        match KEYS.iter().find(|key| key.table == table && key.name == name) {
            Some(key) if key.used => return true,
            Some(_) => self.diagnostics.push(Diagnostic::new(
                Problem::P6012,
                span,
                format!("`{path}` is known, but this version of Sieben does not use it yet"),
            )),
            None => {
                let place = if table.is_empty() { String::new() } else { format!(" in `[{table}]`") };
                let diagnostic = Diagnostic::new(Problem::P6008, span, format!("there is no key `{name}`{place}"));
                self.diagnostics.push(match nearest(name, siblings()) {
                    Some(near) => diagnostic.help(format!("did you mean `{near}`?")).guess(span, near, format!("write `{near}`")),
                    None => diagnostic.help(format!("keys{place}: {}", one_of(siblings()))),
                });
            }
        }
        false
    }

    fn wrong(&mut self, value: &Value<'_>, message: &str) {
        self.diagnostics.push(Diagnostic::new(Problem::P6009, self.span(value.span()), message));
    }

    fn text(&mut self, value: &Value<'_>, name: &str) -> Option<Placed> {
        match value.get_ref() {
            DeValue::String(text) => Some(Placed { text: text.to_string(), span: self.span(value.span()) }),
            _ => {
                self.wrong(value, &format!("`{name}` is a text in quotes: `{name} = \"…\"`"));
                None
            }
        }
    }

    fn list(&mut self, value: &Value<'_>, name: &str) -> Option<Vec<Placed>> {
        match value.get_ref() {
            // One pattern without brackets is what people write first.
            DeValue::String(_) => self.text(value, name).map(|placed| vec![placed]),
            DeValue::Array(items) => Some(items.iter().filter_map(|item| self.text(item, name)).collect()),
            _ => {
                self.wrong(value, &format!("`{name}` is a list of patterns: `{name} = [\"src/**/*.awl\"]`"));
                None
            }
        }
    }

    fn dialect(&mut self, value: &Value<'_>) {
        let Some(placed) = self.text(value, "dialect") else { return };
        self.settings.dialect = Dialect::from_name(&placed.text);
        if self.settings.dialect.is_none() {
            let names = Dialect::ALL.map(|dialect| format!("`{}`", dialect.name())).join(", ");
            self.wrong(value, &format!("`{}` is no dialect of ST: write one of {names}", placed.text));
        }
    }

    fn mnemonics(&mut self, value: &Value<'_>) {
        let Some(placed) = self.text(value, "mnemonics") else { return };
        self.settings.mnemonics = match placed.text.to_ascii_lowercase().as_str() {
            "auto" => None,
            "en" => Some(Mnemonics::English),
            "de" => Some(Mnemonics::German),
            _ => return self.wrong(value, &format!("`{}` is no mnemonic language: write `auto`, `en` or `de`", placed.text)),
        }
    }

    fn profile(&mut self, value: &Value<'_>) {
        let Some(placed) = self.text(value, "profile") else { return };
        match Profile::from_name(&placed.text) {
            Some(profile) => self.settings.profile = Some(profile),
            None => self.wrong(value, &format!("`{}` is no profile: write `siemens` or `awlsim`", placed.text)),
        }
    }

    fn image_errors(&mut self, value: &Value<'_>) {
        let Some(placed) = self.text(value, "image_errors") else { return };
        self.settings.image_errors = ImageErrors::from_name(&placed.text);
        if self.settings.image_errors.is_none() {
            let words = one_of(ImageErrors::NAMES.iter().map(|(word, _)| *word));
            self.wrong(value, &format!("`{}` does not say when OB 85 comes for the process image: write {words}", placed.text));
        }
    }

    fn cpu(&mut self, value: &Value<'_>) {
        let Some(placed) = self.text(value, "type") else { return };
        match CpuType::by_name(&placed.text) {
            Some(cpu) => self.settings.cpu = Some(cpu),
            None => self.wrong(value, &unknown_cpu(&placed.text)),
        }
    }

    fn clock_memory_byte(&mut self, value: &Value<'_>) {
        let number = match value.get_ref() {
            DeValue::Integer(integer) => u16::from_str_radix(integer.as_str(), integer.radix()).ok(),
            _ => None,
        };
        match number {
            Some(byte) => self.settings.clock_memory_byte = Some(byte),
            None => self.wrong(value, "`clock_memory_byte` is the number of a byte of bit memory: `clock_memory_byte = 100` for MB 100"),
        }
    }

    /// The monitoring time of the cycle, as far as a CPU can set it.
    fn watchdog(&mut self, value: &Value<'_>) {
        match self.duration(value, "watchdog") {
            Some(time) if WATCHDOG.contains(&time) => self.settings.watchdog = Some(time),
            Some(_) => self.wrong(value, "a CPU monitors a cycle for 1 ms to 6 s: `watchdog = \"150ms\"`"),
            None => {}
        }
    }

    /// Ranges of numbers that are retentive.
    fn numbers(&mut self, value: &Value<'_>, name: &str) -> Option<(Numbers, Span)> {
        let placed = self.text(value, name)?;
        match Numbers::parse(&placed.text) {
            Ok(numbers) => Some((numbers, placed.span)),
            Err(message) => {
                self.wrong(value, &message);
                None
            }
        }
    }

    fn cycle(&mut self, value: &Value<'_>, name: &str) -> Option<Duration> {
        let cycle = self.duration(value, name)?;
        if cycle > CYCLE_MAX {
            self.wrong(value, &format!("`{name}` is longer than 24 hours, the longest cycle"));
            return None;
        }
        Some(cycle)
    }

    fn duration(&mut self, value: &Value<'_>, name: &str) -> Option<Duration> {
        let DeValue::String(text) = value.get_ref() else {
            self.wrong(value, &format!("`{name}` is a duration in quotes: `{name} = \"10ms\"`"));
            return None;
        };
        match sieben_sim::duration::parse(text) {
            Ok(duration) => Some(duration),
            Err(message) => {
                self.wrong(value, &message);
                None
            }
        }
    }
}

/// The message about a CPU type that does not exist, with those that do.
pub fn unknown_cpu(name: &str) -> String {
    let names = || CpuType::ALL.iter().map(|cpu| cpu.name);
    let list = one_of(names());
    match nearest(name, names()) {
        Some(near) => format!("there is no CPU type `{name}`; did you mean `{near}`? Known are {list}"),
        None => format!("there is no CPU type `{name}`; known are {list}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn messages(text: &str) -> Vec<String> {
        parse(text, FileId(0)).1.into_iter().map(|diagnostic| format!("{}: {}", diagnostic.problem.code(), diagnostic.message)).collect()
    }

    #[test]
    fn a_whole_file_is_read() {
        let (settings, diagnostics) = parse(
            "[project]\nname = \"p\"\nsources = [\"src/*.awl\"]\nsymbols = \"symbols.csv\"\nmnemonics = \"de\"\n\
             [cpu]\ntype = \"416-3\"\ncycle = \"free\"\nwatchdog = \"150ms\"\nmin_cycle = \"1ms\"\nimage_errors = \"every\"\n\
             [cyclic.35]\ninterval = \"50ms\"\nphase = \"5ms\"\n[cyclic.34]\nphase = \"1ms\"\n",
            FileId(0),
        );
        assert_eq!(diagnostics, []);
        assert_eq!(settings.mnemonics, Some(Mnemonics::German));
        assert_eq!(settings.cpu.map(|cpu| cpu.name), Some("416-3"));
        assert_eq!(settings.cycle, Some(Duration::ZERO));
        let cyclic: Vec<_> = settings.cyclic.iter().map(|(number, one)| (*number, one.interval_ms, one.phase_ms)).collect();
        assert_eq!(cyclic, [(34, 200, 1), (35, 50, 5)]);
        assert_eq!(settings.watchdog, Some(Duration::from_millis(150)));
        assert_eq!(settings.image_errors, Some(ImageErrors::EveryTime));
        assert_eq!(settings.symbols.map(|list| list.len()), Some(1));
    }

    /// Every cut of a file and every word in the place of every other: whatever it says, it is read or refused with a place in it.
    #[test]
    fn no_cut_and_no_exchange_of_words_panics() {
        let text = "[project]\nname = \"p\"\nsources = [\"src/**/*.awl\"]\nmnemonics = \"de\"\n[cpu]\ntype = \"416-3\"\ncycle = \"1.5s\"\n\
                    retain = { m = \"0..15\" }\n[[module]]\nkind = \"tank\"\n[cyclic.35]\ninterval = \"100ms\"\n";
        let words: Vec<&str> = text.split_inclusive(|c: char| !c.is_alphanumeric()).collect();
        for at in 0..words.len() {
            parse(&words[..at].concat(), FileId(0));
            parse(&words[at..].concat(), FileId(0));
            for other in ["", "99999999999999999999", "\"ü\"", "-1", "[", "]]", "{", "= ", "#", "\u{0}", words[words.len() - 1 - at]] {
                let mut changed = words.clone();
                changed[at] = other;
                for diagnostic in parse(&changed.concat(), FileId(0)).1 {
                    assert!(diagnostic.span.end as usize <= changed.concat().len(), "the place lies in the file");
                }
            }
        }
    }

    #[test]
    fn every_mistake_has_a_sentence() {
        for (text, expected) in [
            ("[project]\nsoruces = []\n", "P6008: there is no key `soruces` in `[project]`"),
            ("[zpu]\n", "P6008: there is no key `zpu`"),
            ("cpu = 1\n", "P6009: `cpu` is a table: write `[cpu]` on a line of its own, and its keys below"),
            ("[cpu]\ncycle = 10\n", "P6009: `cycle` is a duration in quotes: `cycle = \"10ms\"`"),
            ("[cpu]\ncycle = \"10\"\n", "P6009: `10` is not a duration; write a number with its unit: `10ms`, `1.5s`, `2m` or `1h`"),
            ("[cpu]\ncycle = \"87599h\"\n", "P6009: `cycle` is longer than 24 hours, the longest cycle"),
            ("[cpu]\nwatchdog = \"0ms\"\n", "P6009: a CPU monitors a cycle for 1 ms to 6 s: `watchdog = \"150ms\"`"),
            ("[cpu]\nwatchdog = \"6001ms\"\n", "P6009: a CPU monitors a cycle for 1 ms to 6 s: `watchdog = \"150ms\"`"),
            (
                "[cpu]\nimage_errors = \"always\"\n",
                "P6009: `always` does not say when OB 85 comes for the process image: write `off`, `every` or `coming`",
            ),
            ("[project]\nsources = 1\n", "P6009: `sources` is a list of patterns: `sources = [\"src/**/*.awl\"]`"),
            ("[project]\nname = true\n", "P6009: `name` is a text in quotes: `name = \"…\"`"),
            ("[project]\nmnemonics = \"fr\"\n", "P6009: `fr` is no mnemonic language: write `auto`, `en` or `de`"),
            (
                "[cyclic.29]\n",
                "P6008: `29` is no cyclic interrupt: write `[cyclic.30]` to `[cyclic.38]`, the number of the organization block",
            ),
            ("[cyclic]\n35 = 1\n", "P6009: write `[cyclic.35]` on a line of its own, and `interval = \"100ms\"` below"),
            ("[cyclic.35]\nperiod = 1\n", "P6008: there is no key `period` in `[cyclic.35]`"),
            (
                "[cyclic.35]\ninterval = \"0ms\"\n",
                "P6009: `interval` of a cyclic interrupt is 1 ms to 60 s, in whole milliseconds: `interval = \"100ms\"`",
            ),
            (
                "[cyclic.35]\nphase = \"61s\"\n",
                "P6009: `phase` of a cyclic interrupt is 0 ms to 60 s, in whole milliseconds: `phase = \"100ms\"`",
            ),
            (
                "[cpu]\nretain = 5\n",
                "P6009: `retain` says which numbers are retentive: `retain = { m = \"0..15\", t = \"\", c = \"0..7\" }`",
            ),
            ("[cpu]\nretain = { m = 5 }\n", "P6009: `m` is a text in quotes: `m = \"…\"`"),
            (
                "[cpu]\nretain = { m = \"0-5\" }\n",
                "P6009: `0-5` is no range of numbers from 0 to 65535; write `0..15`, or `0..15, 20` for several",
            ),
            ("[cpu.retain]\nt = \"9..1\"\n", "P6009: `9..1` runs backwards; write `1..9`"),
            ("[cpu.retain]\nz = \"0\"\n", "P6008: there is no key `z` in `[cpu.retain]`"),
            ("[cpu.retain]\nsync = 1\n", "P6009: `sync` is a duration in quotes: `sync = \"10ms\"`"),
            ("[servers.modbus]\nlisten = \"x\"\n", "P6012: `servers.modbus` is known, but this version of Sieben does not use it yet"),
        ] {
            assert_eq!(messages(text), [expected], "{text}");
        }
        assert!(messages("[project\n")[0].starts_with("P6007: `sieben.toml` is not valid TOML"));
        assert!(messages("[cpu]\ntype = \"315-2\"\n")[0].starts_with("P6009: there is no CPU type `315-2`"));
    }
}
