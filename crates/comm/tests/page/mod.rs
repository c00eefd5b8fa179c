//! Pages with telegrams: how they are read, and how a section is run.

mod run;

use std::ops::RangeInclusive;

use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TagEnd};
use sieben_comm::s7comm::guard::{Rules, Writing};
use sieben_cpu::ProtectionLevel;
use sieben_model::cpu_type::CpuType;
use sieben_workspace::settings::servers::{Access, Allowed, Password, Scope};

pub(crate) use run::{failures, failures_byte_by_byte};

/// What stands under one heading.
#[derive(Debug, Default)]
pub(crate) struct Section {
    /// Page and heading.
    pub(crate) name: String,
    /// All `stl` fences.
    pub(crate) stl: String,
    /// Each `telegrams` fence with the line of the page before its first one.
    pub(crate) telegrams: Vec<(usize, String)>,
}

/// The sections of a page.
pub(crate) fn sections(name: &str, text: &str) -> Vec<Section> {
    let mut sections = vec![Section { name: name.to_owned(), ..Section::default() }];
    let (mut in_heading, mut fence) = (false, None::<(String, usize)>);
    let mut content = String::new();
    for (event, range) in Parser::new(text).into_offset_iter() {
        let line = text[..range.start].bytes().filter(|&byte| byte == b'\n').count() + 1;
        let section = sections.last_mut().expect("there is always a section");
        match event {
            Event::Start(Tag::Heading { .. }) => {
                in_heading = true;
                sections.push(Section { name: format!("{name}, "), ..Section::default() });
            }
            Event::End(TagEnd::Heading(_)) => in_heading = false,
            Event::Text(text) | Event::Code(text) if in_heading => section.name.push_str(&text),
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => {
                content.clear();
                fence = Some((info.trim().to_owned(), line));
            }
            Event::Text(text) if fence.is_some() => content.push_str(&text),
            Event::End(TagEnd::CodeBlock) => match fence.take() {
                Some((info, _)) if info == "stl" => section.stl.push_str(&content),
                Some((info, line)) if info == "telegrams" => section.telegrams.push((line, content.clone())),
                _ => {}
            },
            _ => {}
        }
    }
    sections
}

/// A byte of an answer: one that has to be this, or any.
pub(crate) type Expected = Option<u8>;

/// A line of a fence.
#[derive(Debug)]
pub(crate) enum Line {
    /// `connect`: connect request and setup, as most clients send them.
    Connect,
    /// `> bytes`.
    Send(Vec<u8>),
    /// `< bytes`: one frame.
    Answer(Vec<Expected>),
    /// `< nothing`.
    Nothing,
    /// `< closed`.
    Closed,
    /// `scan`.
    Scan,
    /// `wait 100ms`, in microseconds.
    Wait(u64),
    /// `set NAME=VALUE`.
    Set(String, String),
    /// `expect NAME=VALUE`.
    Expect(String, String),
}

/// A fence.
#[derive(Debug)]
pub(crate) struct Telegrams {
    pub(crate) rules: Rules,
    /// Peripheral bytes that have a module.
    pub(crate) modules: Option<std::ops::Range<u32>>,
    /// The lines with their numbers.
    pub(crate) lines: Vec<(usize, Line)>,
}

impl Telegrams {
    /// Reads a fence; `first` is the line of the page before it.
    pub(crate) fn parse(text: &str, first: usize) -> Result<Self, String> {
        let rules = Rules {
            cpu: CpuType::ALL.first().expect("there are CPU types"),
            protection: ProtectionLevel::Open,
            password: None,
            writing: Writing::Allowed,
            allow: None,
            strict: false,
            strict_slot: false,
        };
        let mut telegrams = Self { rules, modules: None, lines: Vec::new() };
        for (index, line) in text.lines().enumerate() {
            let number = first + index + 1;
            let line = line.split("//").next().unwrap_or_default();
            let read = telegrams.line(number, line);
            read.map_err(|message| format!("line {number}: {message}"))?;
        }
        Ok(telegrams)
    }

    fn line(&mut self, number: usize, line: &str) -> Result<(), String> {
        let mut add = |line| {
            self.lines.push((number, line));
            Ok(())
        };
        if line.starts_with(' ') {
            let more = hex(line)?;
            return match self.lines.last_mut() {
                _ if more.is_empty() => Ok(()),
                Some((_, Line::Send(bytes))) => {
                    bytes.extend(more.iter().map(|byte| byte.unwrap_or(0)));
                    Ok(())
                }
                Some((_, Line::Answer(bytes))) => {
                    bytes.extend(more);
                    Ok(())
                }
                _ => Err("bytes go on after `>` or `<`".to_owned()),
            };
        }
        let (word, rest) = line.trim().split_once(' ').unwrap_or((line.trim(), ""));
        match (word, rest.trim()) {
            ("", _) => Ok(()),
            ("connect", "") => add(Line::Connect),
            (">", bytes) => add(Line::Send(hex(bytes)?.iter().map(|byte| byte.unwrap_or(0)).collect())),
            ("<", "nothing") => add(Line::Nothing),
            ("<", "closed") => add(Line::Closed),
            ("<", bytes) => add(Line::Answer(hex(bytes)?)),
            ("scan", "") => add(Line::Scan),
            ("wait", time) => add(Line::Wait(time_us(time).ok_or("a time is `100ms` or `10s`")?)),
            ("set", assignment) => {
                let (name, value) = assignment.split_once('=').ok_or("`set NAME=VALUE`")?;
                add(Line::Set(name.to_owned(), value.to_owned()))
            }
            ("expect", assignment) => {
                let (name, value) = assignment.split_once('=').ok_or("`expect NAME=VALUE`")?;
                add(Line::Expect(name.to_owned(), value.to_owned()))
            }
            (word, rest) => self.rule(word, rest),
        }
    }

    /// What a server is set up with.
    fn rule(&mut self, word: &str, rest: &str) -> Result<(), String> {
        let rules = &mut self.rules;
        match (word, rest) {
            ("cpu", name) => rules.cpu = CpuType::by_name(name).ok_or("there is no such CPU type")?,
            ("modules", range) => {
                let range = numbers(range).ok_or("`modules 0..63`")?;
                self.modules = Some(u32::from(*range.start())..u32::from(*range.end()) + 1);
            }
            ("protection", "2") => rules.protection = ProtectionLevel::WriteProtected,
            ("protection", "3") => rules.protection = ProtectionLevel::ReadWriteProtected,
            ("password", text) => {
                rules.password = Some(Password::new(text).ok_or("`password` has one to eight characters")?.characters());
            }
            ("read-only", "") => rules.writing = Writing::ReadOnly,
            ("strict", "") => rules.strict = true,
            ("strict-slot", "") => rules.strict_slot = true,
            ("allow", what) => {
                let (what, access) = match what.strip_suffix(" read-only") {
                    Some(what) => (what, Access::Read),
                    None => (what, Access::ReadAndWrite),
                };
                let scope = match what.split_once(' ') {
                    Some(("DB", range)) => Scope::DataBlocks(numbers(range).ok_or("`allow DB 1..9`")?),
                    None if what == "M" => Scope::BitMemory,
                    _ => return Err(format!("`allow {what}` is not known here")),
                };
                rules.allow.get_or_insert_default().push(Allowed { scope, access });
            }
            _ => return Err(format!("`{word}` is not known here")),
        }
        Ok(())
    }
}

fn numbers(text: &str) -> Option<RangeInclusive<u16>> {
    let (first, last) = text.split_once("..")?;
    Some(first.parse().ok()?..=last.parse().ok()?)
}

fn time_us(text: &str) -> Option<u64> {
    match text.strip_suffix("ms") {
        Some(ms) => Some(ms.parse::<u64>().ok()? * 1_000),
        None => Some(text.strip_suffix('s')?.parse::<u64>().ok()? * 1_000_000),
    }
}

/// Bytes in hexadecimal, with spaces between them; `..` is any byte, `00*5` five of the same.
fn hex(text: &str) -> Result<Vec<Expected>, String> {
    let mut bytes = Vec::new();
    for word in text.split_whitespace() {
        let (word, count) = match word.split_once('*') {
            Some((word, count)) => (word, count.parse().map_err(|_| format!("`{count}` is no count"))?),
            None => (word, 1),
        };
        let byte = match word {
            ".." => None,
            _ if word.len() == 2 => Some(u8::from_str_radix(word, 16).map_err(|_| format!("`{word}` is no byte"))?),
            _ => return Err(format!("`{word}` is no byte")),
        };
        bytes.extend(std::iter::repeat_n(byte, count));
    }
    Ok(bytes)
}
