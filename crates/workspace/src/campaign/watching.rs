//! The expressions of a campaign as a part of the program: a test block that computes all of them after a scan.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;

use sieben_campaign::slots::{Slot, Wanted, slots};
use sieben_campaign::spec::Spec;
use sieben_cpu::Cpu;
use sieben_lang::st::dialect::Dialect;
use sieben_model::address::Operand;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::{Diagnostic, Severity};
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};
use sieben_model::types::DataType;
use sieben_sim::names::Name;

use super::distance::Distances;
use crate::controller;
use crate::finding::Origin;
use crate::project::{Build, Overrides, Project};

/// What the source of the expressions is called; it is no file.
const SOURCE: &str = "campaign.test.st";

/// Where the expressions of a campaign lie in a program.
#[derive(Clone, Debug)]
pub(crate) struct Watching {
    block: BlockId,
    values: Vec<Computed>,
    /// Where the operands of the distances begin among the values.
    operands: usize,
    distances: Distances,
}

/// A variable that the value of an expression is stored in.
#[derive(Clone, Debug)]
struct Computed {
    name: Name,
    as_number: As,
}

/// How its bits are a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum As {
    Boolean,
    Real,
    LongReal,
}

/// A project with the expressions of a campaign, compiled.
pub(crate) struct Watched {
    /// The program with the block that computes them.
    pub(crate) build: Build,
    /// Where they lie.
    pub(crate) watching: Watching,
    /// The CPU type with room for them.
    pub(crate) cpu: &'static CpuType,
}

/// Compiles a project together with the expressions of a campaign.
///
/// # Errors
/// The program does not compile, then with its findings; or an expression does not, then with its place in the file of the campaign.
pub(crate) fn compile(project: &Project, spec: &Spec, overrides: Overrides) -> Result<Watched, Failed> {
    let own = slots(spec);
    let mut wrong: Vec<(usize, Diagnostic)> = own.iter().enumerate().filter_map(|(index, slot)| Some((index, statements(slot)?))).collect();
    if !wrong.is_empty() {
        return Err(Failed::Expressions(wrong));
    }
    let dialect = overrides.dialect.or(project.settings.dialect);
    let real = if dialect.is_none_or(|dialect| dialect == Dialect::Scl) { As::Real } else { As::LongReal };
    let kinds_of = |slots: &[Slot<'_>]| -> Vec<As> {
        slots.iter().map(|slot| if slot.wanted == Wanted::Boolean { As::Boolean } else { real }).collect()
    };
    let mut own_kinds = kinds_of(&own);
    let mut distances = Distances::of(spec, dialect.unwrap_or(Dialect::Scl));
    loop {
        let all: Vec<Slot<'_>> = own.iter().copied().chain(distances.slots()).collect();
        let mut kinds = own_kinds.clone();
        kinds.extend(kinds_of(&all[own.len()..]));
        let source = Source::of(&all, &kinds);
        let mut with = project.clone();
        with.add_source(Path::new(SOURCE), source.text.as_bytes());
        let file = with.sources.last().map_or(FileId(0), |source| source.id);
        let mut build = with.compile(Overrides { tests: true, ..overrides }, false);
        let mut changed = false;
        let mut no_numbers = BTreeSet::new();
        for finding in &build.findings {
            let diagnostic = &finding.diagnostic;
            if finding.origin != Origin::Program || diagnostic.span.file != file || finding.severity() != Severity::Error {
                continue;
            }
            let Some(index) = source.slot_at(diagnostic.span.start) else { continue };
            if let Some(operand) = index.checked_sub(own.len()) {
                no_numbers.insert(operand);
            // What is only compared is a number if it can be one, else a Boolean.
            } else if all[index].wanted == Wanted::Either && own_kinds[index] != As::Boolean {
                own_kinds[index] = As::Boolean;
                changed = true;
            } else {
                wrong.push((index, source.placed(index, &all[index], diagnostic)));
            }
        }
        if changed {
            wrong.clear();
            continue;
        }
        if !wrong.is_empty() {
            return Err(Failed::Expressions(wrong));
        }
        if !no_numbers.is_empty() {
            distances.without(&no_numbers);
            continue;
        }
        if crate::finding::has_errors(&build.findings) {
            return Err(Failed::Program(Box::new(build)));
        }
        return match computed(&build, &source, &kinds) {
            Some((block, values)) => {
                let watching = Watching { block, values, operands: own.len(), distances };
                // It is none of the program's.
                build.project.sources.pop();
                Ok(Watched { cpu: controller::with_room(build.cpu), build, watching })
            }
            None => Err(Failed::Program(Box::new(build))),
        };
    }
}

/// Why a campaign cannot be compiled.
pub(crate) enum Failed {
    /// The program does not compile.
    Program(Box<Build>),
    /// Expressions do not: the number of each, and what is wrong with its place in the file of the campaign.
    Expressions(Vec<(usize, Diagnostic)>),
}

/// What is no expression although it could be a part of the source.
fn statements(slot: &Slot<'_>) -> Option<Diagnostic> {
    let text = &slot.expression.text;
    let message = match () {
        () if text.trim().is_empty() => "an expression is missing here".to_owned(),
        () if text.contains(';') || text.contains(":=") => {
            "an expression of Structured Text belongs here, without `;` and `:=`: `\"star\" AND \"delta\"`".to_owned()
        }
        () => return None,
    };
    Some(Diagnostic::new(Problem::P7160, slot.expression.span, message))
}

/// What is said of expressions that name nothing: such a property holds, or breaks, whatever the program does.
pub(crate) fn constants(spec: &Spec) -> Vec<Diagnostic> {
    let names_nothing = |slot: &Slot<'_>| {
        let text = &slot.expression.text;
        !words(text).iter().any(|word| {
            let is_constant = word.contains('#') || CONSTANT_WORDS.iter().any(|known| known.eq_ignore_ascii_case(word));
            !is_constant && word.starts_with(|c: char| c.is_alphabetic() || matches!(c, '_' | '"' | '%'))
        })
    };
    let message = |slot: &Slot<'_>| {
        let message = format!("`{}` names nothing of the program: it has the same value in every scenario", slot.expression.text.trim());
        Diagnostic::new(Problem::P7164, slot.expression.span, message)
    };
    slots(spec).iter().filter(|slot| names_nothing(slot)).map(message).collect()
}

/// The words of an expression: names, constants, functions.
pub(super) fn words(expression: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut start = None;
    let mut quoted = false;
    for (at, c) in expression.char_indices() {
        quoted ^= c == '"';
        let is_part = quoted || c.is_alphanumeric() || matches!(c, '_' | '#' | '"' | '%' | '.' | '[' | ']');
        match (is_part, start) {
            (true, None) => start = Some(at),
            (false, Some(from)) => {
                words.push(&expression[from..at]);
                start = None;
            }
            _ => {}
        }
    }
    words.extend(start.map(|from| &expression[from..]));
    words
}

/// Words of expressions that are no names.
const CONSTANT_WORDS: [&str; 7] = ["TRUE", "FALSE", "AND", "OR", "XOR", "NOT", "MOD"];

/// The source that is made of the expressions.
struct Source {
    text: String,
    /// Where each expression begins and ends in it.
    places: Vec<(u32, u32)>,
}

impl Source {
    fn of(all: &[Slot<'_>], kinds: &[As]) -> Self {
        let mut text = String::from("TEST 'campaign'\nVAR\n");
        for (index, kind) in kinds.iter().enumerate() {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "  {} : {};", variable(index), kind.data_type());
        }
        text.push_str("END_VAR\n");
        let mut places = Vec::new();
        for (index, slot) in all.iter().enumerate() {
            let _ = writeln!(text, "{} :=", variable(index));
            let start = text.len() as u32;
            text.push_str(&slot.expression.text);
            places.push((start, text.len() as u32));
            text.push_str("\n;\n");
        }
        text.push_str("END_TEST\n");
        Self { text, places }
    }

    /// The expression at a place, or before it.
    fn slot_at(&self, at: u32) -> Option<usize> {
        self.places.partition_point(|&(start, _)| start <= at.saturating_add(1)).checked_sub(1)
    }

    /// What the compiler says of an expression, at its place in the file of the campaign.
    fn placed(&self, index: usize, slot: &Slot<'_>, diagnostic: &Diagnostic) -> Diagnostic {
        let whole = slot.expression.span;
        let (start, end) = self.places[index];
        // One that is written with escapes has other bytes in the file.
        let same = (whole.end - whole.start) as usize == slot.expression.text.len();
        let at = |offset: u32| whole.start + offset.clamp(start, end) - start;
        let span = if same { Span::new(whole.file, at(diagnostic.span.start), at(diagnostic.span.end)) } else { whole };
        let span = if span.start >= span.end { whole } else { span };
        let told = Diagnostic::new(diagnostic.problem, span, diagnostic.message.clone());
        match (&diagnostic.help, slot.wanted) {
            (Some(help), _) => told.help(help.clone()),
            (None, Wanted::Boolean) => {
                told.help("a property is a Boolean expression in the names of the program: `Level > 95.0 AND NOT Valve`")
            }
            (None, _) => told,
        }
    }
}

fn variable(index: usize) -> String {
    format!("sieben_slot_{index}")
}

impl As {
    fn data_type(self) -> DataType {
        match self {
            Self::Boolean => DataType::Bool,
            Self::Real => DataType::Real,
            Self::LongReal => DataType::LongReal,
        }
    }

    fn number(self, bits: u64) -> f64 {
        match self {
            Self::Boolean => f64::from(u8::from(bits & 1 != 0)),
            Self::Real => f64::from(f32::from_bits(bits as u32)),
            Self::LongReal => f64::from_bits(bits),
        }
    }
}

/// The block that computes the values, and where they lie.
fn computed(build: &Build, source: &Source, kinds: &[As]) -> Option<(BlockId, Vec<Computed>)> {
    let plan = &build.compiled.tests;
    let block = plan.tests.first()?.block;
    let mut values = Vec::new();
    for (index, &as_number) in kinds.iter().enumerate() {
        // The assignment begins with the name of the variable, before the expression.
        let begin = source.places[index].0 - (variable(index).len() as u32 + " :=\n".len() as u32);
        let signal = plan.writes.get(&begin)?;
        let operand = Operand::InDataBlock { db: signal.data_block?, address: signal.address };
        values.push(Computed { name: Name::at(variable(index), operand, Some(&signal.data_type)), as_number });
    }
    Some((block, values))
}

impl Watching {
    /// Computes all expressions after a scan. `false`: one of them would stop the CPU.
    pub(crate) fn look(&self, cpu: &mut Cpu, values: &mut Vec<f64>) -> bool {
        values.clear();
        if self.values.is_empty() {
            return true;
        }
        let looked = cpu.look_with(self.block);
        let machine = cpu.machine();
        let value =
            |computed: &Computed| computed.name.bits_in(machine, &machine.registers).map_or(0.0, |bits| computed.as_number.number(bits));
        values.extend(self.values.iter().map(value));
        looked
    }

    /// The least distance of a property to its break, of values that were computed so.
    pub(crate) fn distance(&self, values: &[f64]) -> Option<f64> {
        self.distances.least(values.get(self.operands..)?)
    }
}
