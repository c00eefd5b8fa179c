//! The statements of a program by block, file and line.

use std::collections::BTreeMap;
use std::sync::Arc;

use sieben_engine::FaultPlace;
use sieben_lang::reason::Language;
use sieben_model::block::BlockId;
use sieben_model::source::{FileId, Span};

use super::texts::{self, END_OF_BLOCK, fill};
use crate::controller;
use crate::places::{Index, Places};
use crate::project::Build;
use sieben_model::nearest::nearest;

/// A statement as people find it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// Block and statement, counted from 0.
    pub place: FaultPlace,
    /// `FC 1`.
    pub block: String,
    /// Its network, from 1; `None` in ST, which has none.
    pub network: Option<u32>,
    /// The file as the user named it.
    pub file: String,
    /// Its line, from 1.
    pub line: usize,
    /// `A I 0.0`, with single blanks.
    pub text: String,
}

/// Where a breakpoint or a movement goes: statements of a block that are one for the CPU, as some have nothing to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Goal {
    /// The first of them.
    pub place: FaultPlace,
    /// The last of them.
    pub last: u32,
    /// The user named a line without a statement; this is the next one that has one.
    pub moved: bool,
}

/// All statements of a program.
pub struct Listing {
    build: Arc<Build>,
    index: Index,
    /// First statements of the lines of each file.
    lines: BTreeMap<FileId, BTreeMap<usize, FaultPlace>>,
}

impl Line {
    /// The statement as it is shown to people who read this language.
    pub fn said(&self, language: Language) -> &str {
        match language {
            Language::German if self.text == END_OF_BLOCK[0] => END_OF_BLOCK[1],
            _ => &self.text,
        }
    }
}

impl Listing {
    /// Looks through the program once.
    pub fn new(build: Arc<Build>) -> Self {
        let index = Index::new(&build);
        let places = Places::with(&build, &index);
        let mut lines: BTreeMap<FileId, BTreeMap<usize, FaultPlace>> = BTreeMap::new();
        for (&block, code) in &build.compiled.program.code {
            for (statement, &span) in (0_u32..).zip(&code.spans) {
                let place = FaultPlace { block, statement };
                if (span.file.0 as usize) < build.project.texts.program.iter().len() && is_written(&build, place) {
                    lines.entry(span.file).or_default().entry(places.line(span)).or_insert(place);
                }
            }
        }
        Self { build, index, lines }
    }

    /// How its places are printed.
    pub fn places(&self) -> Places<'_> {
        Places::with(&self.build, &self.index)
    }

    /// A statement as people find it.
    pub fn line(&self, place: FaultPlace) -> Line {
        let span = self.span(place).unwrap_or_default();
        let known = self.span(place).is_some();
        let stated = self.build.compiled.bodies.get(&place.block).and_then(|body| body.stated(place.statement));
        let text = match (known && is_written(&self.build, place), stated) {
            (true, Some(stated)) => stated.to_owned(),
            (true, None) => self.places().text(span),
            (false, _) => END_OF_BLOCK[0].to_owned(),
        };
        Line {
            place,
            block: place.block.to_string(),
            network: self.network(place),
            file: if known { self.places().file(span).to_owned() } else { String::new() },
            line: if known { self.places().line(span) } else { 0 },
            text: text.trim_end_matches(';').trim_end().to_owned(),
        }
    }

    /// What people call a block: `FC 1`, or the name that it has in its source of ST.
    pub fn called(&self, block: BlockId) -> String {
        controller::name_in_source(&self.build, block).map_or_else(|| block.to_string(), str::to_owned)
    }

    /// Its network, counted from 1.
    pub fn network(&self, place: FaultPlace) -> Option<u32> {
        self.build.compiled.bodies.get(&place.block)?.network(place.statement)
    }

    /// Where the text of a statement stands.
    pub fn span(&self, place: FaultPlace) -> Option<Span> {
        let span = *self.build.compiled.program.code.get(&place.block)?.spans.get(place.statement as usize)?;
        ((span.file.0 as usize) < self.build.project.texts.program.iter().len()).then_some(span)
    }

    /// Reads `FC 5:3` (the statement, from 1), `FC 5:label`, `main.awl:12` or `12` (a line of the file in which `here` stands).
    ///
    /// # Errors
    /// There is no such place; the sentence says what there is.
    pub fn goal(&self, text: &str, here: Option<FaultPlace>, language: Language) -> Result<Goal, String> {
        let text = text.trim();
        let say = |text, values: &[&dyn std::fmt::Display]| fill(language, text, values);
        let (first, second) = text.rsplit_once(':').map_or((None, text), |(first, second)| (Some(first.trim()), second.trim()));
        let Some(first) = first else {
            if let Some(block) = self.block(text) {
                return self.statement(block, 0, language);
            }
            let line = text.parse().map_err(|_| say(texts::NO_PLACE, &[&text]))?;
            let file = here.and_then(|place| self.span(place)).map(|span| span.file).or_else(|| self.lines.keys().next().copied());
            return file.map_or_else(|| Err(say(texts::NO_STATEMENTS, &[])), |file| self.line_of(file, line, language));
        };
        if let Some(block) = self.block(first) {
            return match second.parse::<u32>() {
                Ok(number) => self.statement(block, number.checked_sub(1).ok_or_else(|| say(texts::COUNTED_FROM_ONE, &[]))?, language),
                Err(_) => self.label(block, second, language),
            };
        }
        let texts = &self.build.project.texts.program;
        let of = |id: &FileId| texts.file(*id).name.as_str();
        let same = |id: &&FileId| of(id) == first || of(id).rsplit(['/', '\\']).next() == Some(first);
        let Some(&file) = self.lines.keys().find(same) else {
            let known = self.lines.keys().map(of);
            return Err(say(texts::NEITHER, &[&first]) + &meant(nearest(first, known), language));
        };
        self.line_of(file, second.parse().map_err(|_| say(texts::NO_LINE, &[&second, &first]))?, language)
    }

    /// A block by its number or its symbol, if it has code.
    pub fn block(&self, text: &str) -> Option<BlockId> {
        let code = &self.build.compiled.program.code;
        let letters = text.trim_end_matches(|c: char| c.is_ascii_digit());
        let numbered = text[letters.len()..].parse().ok().and_then(|number| {
            let kind = sieben_model::block::BlockKind::from_abbreviation(letters.trim().to_ascii_uppercase().as_str())?;
            Some(BlockId::new(kind, number))
        });
        let name = text.trim_matches('"');
        let named = || code.keys().copied().find(|&block| self.places().block_symbol(block).eq_ignore_ascii_case(name) && !name.is_empty());
        numbered.filter(|block| code.contains_key(block)).or_else(named)
    }

    fn statement(&self, block: BlockId, statement: u32, language: Language) -> Result<Goal, String> {
        let code = &self.build.compiled.program.code[&block];
        let count = code.code.statements.len() as u32;
        if statement >= count {
            return Err(fill(language, texts::STATEMENTS_OF, &[&block, &count]));
        }
        let place = FaultPlace { block, statement };
        // A statement without an instruction of its own, such as NOP 0, is one with the next.
        let begins = &code.code.statements;
        let same = |&next: &u32| begins[next as usize] == begins[statement as usize];
        let last = (statement + 1..count).take_while(same).last().unwrap_or(statement);
        Ok(Goal { place, last, moved: false })
    }

    fn label(&self, block: BlockId, label: &str, language: Language) -> Result<Goal, String> {
        let texts = &self.build.project.texts.program;
        let count = self.build.compiled.program.code[&block].spans.len() as u32;
        let label_of = |statement: u32| {
            let span = self.span(FaultPlace { block, statement })?;
            let before = texts.file(span.file).text.get(..span.start as usize)?.trim_end();
            let name = before.strip_suffix(':')?.trim_end();
            Some(&name[name.rfind(|c: char| !c.is_alphanumeric() && c != '_').map_or(0, |at| at + 1)..])
        };
        let labels: Vec<(u32, &str)> = (0..count).filter_map(|statement| Some((statement, label_of(statement)?))).collect();
        match labels.iter().find(|(_, name)| *name == label) {
            Some(&(statement, _)) => self.statement(block, statement, language),
            None => {
                let near = nearest(label, labels.iter().map(|(_, name)| *name));
                Err(fill(language, texts::NO_LABEL, &[&block, &label]) + &meant(near, language))
            }
        }
    }

    fn line_of(&self, file: FileId, line: usize, language: Language) -> Result<Goal, String> {
        let lines = &self.lines[&file];
        let Some((&found, &place)) = lines.range(line..).next() else {
            let last = lines.keys().next_back().copied().unwrap_or_default();
            let name = &self.build.project.texts.program.file(file).name;
            return Err(fill(language, texts::NO_STATEMENT_FROM, &[name, &line, &last]));
        };
        Ok(Goal { moved: found != line, ..self.statement(place.block, place.statement, language)? })
    }
}

/// What may have been meant.
fn meant(near: Option<&str>, language: Language) -> String {
    near.map_or_else(String::new, |near| format!("; {}", fill(language, texts::DID_YOU_MEAN, &[&near])))
}

/// Whether a statement stands in a source; the end of a block need not.
fn is_written(build: &Build, place: FaultPlace) -> bool {
    build.compiled.bodies.get(&place.block).is_none_or(|body| body.is_written(place.statement))
}
