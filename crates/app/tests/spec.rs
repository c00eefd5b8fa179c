//! Runs the executable manual: every section of every page under spec/, in both mnemonic languages, on every engine.

mod drawn;
mod equality;
mod program;

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TagEnd};
use sieben_lang::Compiled;
use sieben_lang::st::dialect::Dialect;
use sieben_lang::stl::ast::Operand;
use sieben_lang::stl::instructions::Instruction;
use sieben_lang::stl::operands::OperandClass;
use sieben_lang::stl::parser::parse;
use sieben_model::cpu_type::CpuType;
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_model::source::FileId;
use sieben_model::symbols::SymbolTable;
use sieben_sim::scenario::{Happened, Scenario};

/// The fences of diagrams, and the endings of files with such networks.
const DIAGRAMS: [&str; 2] = ["lad", "fbd"];

/// The part of a page under one heading.
#[derive(Default)]
struct Section {
    heading: String,
    line: usize,
    /// All `stl` fences, one project with those of `st`.
    stl: String,
    /// All `st` fences.
    st: String,
    /// Each `lad` and `fbd` fence, a program of its own that does the same, with its language.
    diagrams: Vec<(&'static str, String)>,
    /// The dialects that the first of them names: `st iec codesys`.
    dialects: Vec<Dialect>,
    /// `check` fences with the page's line before their first one.
    checks: Vec<(usize, String)>,
}

impl Section {
    /// The texts of all its programs.
    fn programs(&self) -> String {
        let diagrams: Vec<String> = self.diagrams.iter().map(|(language, text)| format!("({language})\n{text}")).collect();
        format!("{}{}{}", self.stl, self.st, diagrams.concat())
    }
}

fn spec_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec")
}

/// The pages of a folder under spec/, by name.
fn pages(folder: &str) -> Vec<(String, String)> {
    let path = spec_folder().join(folder);
    let mut pages: Vec<(String, String)> = fs::read_dir(&path)
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()))
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .map(|path| {
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            (format!("spec/{folder}/{name}"), fs::read_to_string(&path).unwrap_or_else(|error| panic!("{name}: {error}")))
        })
        .collect();
    pages.sort();
    assert!(!pages.is_empty(), "no page in {}", path.display());
    pages
}

fn sections(page: &str) -> Vec<Section> {
    let mut sections = vec![Section::default()];
    let (mut in_heading, mut fence) = (false, None::<(String, usize)>);
    let mut content = String::new();
    for (event, range) in Parser::new(page).into_offset_iter() {
        let line = page[..range.start].bytes().filter(|&byte| byte == b'\n').count() + 1;
        let section = sections.last_mut().expect("there is always a section");
        match event {
            Event::Start(Tag::Heading { .. }) => {
                in_heading = true;
                sections.push(Section { line, ..Section::default() });
            }
            Event::End(TagEnd::Heading(_)) => in_heading = false,
            Event::Text(text) | Event::Code(text) if in_heading => section.heading.push_str(&text),
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => {
                content.clear();
                fence = Some((info.trim().to_owned(), line));
            }
            Event::Text(text) if fence.is_some() => content.push_str(&text),
            Event::End(TagEnd::CodeBlock) => match fence.take() {
                Some((info, _)) if info == "stl" => section.stl.push_str(&content),
                Some((info, _)) if DIAGRAMS.contains(&info.as_str()) => {
                    let language = DIAGRAMS.iter().find(|language| **language == info).expect("it was just found");
                    section.diagrams.push((language, content.clone()));
                }
                Some((info, line)) if info.split(' ').next() == Some("st") => {
                    section.st.push_str(&content);
                    let words = info.split_whitespace().skip(1);
                    let dialects: Vec<Dialect> =
                        words.map(|word| Dialect::from_name(word).unwrap_or_else(|| panic!("line {line}: no dialect `{word}`"))).collect();
                    assert!(!dialects.is_empty(), "line {line}: an `st` fence names its dialects");
                    if section.dialects.is_empty() {
                        section.dialects = dialects;
                    }
                }
                Some((info, line)) if info == "check" => section.checks.push((line, content.clone())),
                _ => {}
            },
            _ => {}
        }
    }
    sections
}

/// Everything that is wrong with a section.
fn failures(page: &str, section: &Section) -> Vec<String> {
    let mut out = Vec::new();
    let place = |line: usize| format!("{page}:{line} ({})", section.heading);
    if section.programs().is_empty() != section.checks.is_empty() {
        out.push(format!("{}: a program and a `check` belong together", place(section.line)));
    }
    for (line, text) in &section.checks {
        let scenario = match Scenario::parse(text) {
            Ok(scenario) => scenario,
            Err(errors) => {
                out.extend(errors.iter().map(|error| format!("{}: {}", place(line + error.line), error.message)));
                continue;
            }
        };
        if !scenario.expects() {
            out.push(format!("{}: the check expects nothing", place(*line)));
        }
        if !scenario.properties().is_empty() {
            out.push(format!("{}: a page holds no `property`, only `sieben test` does", place(*line)));
        }
        let found = run(section, &scenario);
        match (&scenario.known_gap, found.is_empty()) {
            (Some(why), true) => out.push(format!("{}: works now; remove `known-gap \"{why}\"`", place(*line))),
            (Some(_), false) => {}
            (None, _) => out.extend(found.into_iter().map(|(at, message)| format!("{}: {message}", place(line + at)))),
        }
    }
    out
}

/// A form of the program of a section: what it is called, and what came of compiling it.
type Variant = (String, Result<Compiled, String>);

/// The program of a section in both mnemonic languages and in each dialect that it names.
fn variants(section: &Section, cpu_type: &'static CpuType) -> Result<Vec<Variant>, String> {
    let st = [("page.st", section.st.as_str())];
    let mut out = Vec::new();
    if section.stl.is_empty() && !section.st.is_empty() {
        let compiled = |&dialect: &Dialect| (dialect.name().to_owned(), program::compile_sources(&st, None, Some(dialect), cpu_type));
        out.extend(section.dialects.iter().map(compiled));
    }
    if !section.stl.is_empty() {
        out.extend(stl_variants(section, st, cpu_type)?);
    }
    for (notation, text) in &section.diagrams {
        let name = format!("page.{notation}");
        for (language, mnemonics, text) in &program::both_languages_of(&name, text)? {
            let compiled = program::compile_sources(&[(&name, text)], Some(*mnemonics), None, cpu_type);
            out.push((format!("{notation}, {language}"), compiled.map_err(|message| format!("{message}\n{text}"))));
        }
    }
    Ok(out)
}

/// The statement list of a section, with what it has of Structured Text.
fn stl_variants(section: &Section, st: [(&str, &str); 1], cpu_type: &'static CpuType) -> Result<Vec<Variant>, String> {
    let mut out = Vec::new();
    for (language, mnemonics, text) in &program::both_languages(&section.stl)? {
        let stl = ("page.awl", text.as_str());
        if section.dialects.is_empty() {
            let compiled = program::compile(text, *mnemonics, cpu_type).map_err(|message| format!("{message}\n{text}"));
            out.push(((*language).to_owned(), compiled));
        }
        for &dialect in &section.dialects {
            let compiled = program::compile_sources(&[stl, st[0]], Some(*mnemonics), Some(dialect), cpu_type);
            out.push((format!("{language}, {}", dialect.name()), compiled));
        }
    }
    Ok(out)
}

/// Runs a scenario in all languages, all dialects and on all engines; lines of the check with what went wrong there.
fn run(section: &Section, scenario: &Scenario) -> Vec<(usize, String)> {
    let cpu_type = scenario.cpu.unwrap_or(&CpuType::ALL[0]);
    let variants = match variants(section, cpu_type) {
        Ok(variants) => variants,
        Err(message) => return vec![(0, message)],
    };
    let mut out = Vec::new();
    // What the memory held after every scan of the first variant and engine.
    let mut first: Option<Vec<Vec<(String, u64)>>> = None;
    for (variant, compiled) in variants {
        let (compiled, settings) = match compiled {
            Ok(compiled) => {
                let settings = program::settings(&compiled);
                (Arc::new(compiled.program), settings)
            }
            Err(message) => {
                out.push((0, format!("[{variant}] {message}")));
                continue;
            }
        };
        for (engine, load) in program::ENGINES {
            let mut cpu = || program::cpu_with(&compiled, cpu_type, *load, scenario.modules.clone(), settings.clone());
            let mut held = Vec::new();
            let failed = scenario.run_watched(&SymbolTable::default(), &mut cpu, &mut |happened| {
                if let (Happened::Scan { cpu, .. }, false) = (happened, section.diagrams.is_empty()) {
                    held.push(equality::fingerprint(cpu.machine()));
                }
            });
            let first = first.get_or_insert_with(|| held.clone());
            let differs = first.iter().zip(&held).position(|(first, held)| first != held);
            out.extend(differs.map(|scan| {
                let area = first[scan].iter().zip(&held[scan]).find(|(one, other)| one != other).map_or("", |(one, _)| one.0.as_str());
                (0, format!("[{variant}, {engine}] after scan {}: the {area} are not as in the first variant", scan + 1))
            }));
            out.extend(failed.into_iter().map(|failure| (failure.line, format!("[{variant}, {engine}] {}", failure.message))));
        }
    }
    out
}

/// The first difference between the statement list of a section and its diagrams, over the values of what the statement list reads.
fn inequality(section: &Section) -> Option<String> {
    if section.stl.is_empty() || section.diagrams.is_empty() || !section.st.is_empty() {
        return None;
    }
    let cpu = section.checks.iter().filter_map(|(_, text)| Scenario::parse(text).ok()?.cpu).next();
    let cpu_type = cpu.unwrap_or(&CpuType::ALL[0]);
    let mut programs = Vec::new();
    for (name, compiled) in variants(section, cpu_type).ok()?.into_iter().filter(|(name, _)| !name.contains("German")) {
        let compiled = compiled.ok()?;
        let settings = program::settings(&compiled);
        programs.push((name, Arc::new(compiled.program), settings));
    }
    equality::first_difference(&programs, &equality::Inputs::of(&section.stl), cpu_type)
}

/// Runs all pages of a folder and reports every failure at once.
fn run_folder(folder: &str) {
    let mut report = String::new();
    let mut checks = 0;
    for (name, page) in pages(folder) {
        let sections = sections(&page);
        assert!(sections.iter().any(|section| !section.checks.is_empty()), "{name} checks nothing");
        for section in &sections {
            checks += section.checks.len();
            let mut found = failures(&name, section);
            found.extend(inequality(section).map(|message| format!("{name}:{} ({}): {message}", section.line, section.heading)));
            if !found.is_empty() {
                let _ = writeln!(report, "{}", found.join("\n"));
                let _ = writeln!(report, "    {}\n", section.programs().trim_end().replace('\n', "\n    "));
            }
        }
    }
    assert!(report.is_empty(), "pages that do not come true ({checks} checks ran):\n\n{report}");
}

#[test]
fn the_course_pages_come_true() {
    run_folder("course");
}

#[test]
fn the_diagram_pages_come_true() {
    run_folder("diagrams");
}

#[test]
fn the_stl_pages_come_true() {
    run_folder("stl");
}

#[test]
fn the_cpu_pages_come_true() {
    run_folder("cpu");
}

#[test]
fn the_system_pages_come_true() {
    run_folder("system");
}

#[test]
fn the_library_pages_come_true() {
    run_folder("library");
}

#[test]
fn the_st_pages_come_true() {
    run_folder("st");
}

#[test]
fn the_function_pages_come_true() {
    run_folder("functions");
}

#[test]
fn the_awlsim_pages_come_true() {
    run_folder("awlsim");
}

/// Runs the checks of all pages of a folder on their programs of STL as LAD, as FBD and as STL again.
fn run_drawn(folder: &str) -> drawn::Count {
    let mut report = String::new();
    let mut count = drawn::Count::default();
    for (name, page) in pages(folder) {
        for section in sections(&page).iter().filter(|section| !section.stl.is_empty() && section.st.is_empty()) {
            for (line, text) in &section.checks {
                let Ok(scenario) = Scenario::parse(text) else { continue };
                if scenario.known_gap.is_some() {
                    continue;
                }
                let cpu_type = scenario.cpu.unwrap_or(&CpuType::ALL[0]);
                let forms = match drawn::forms(&section.stl, cpu_type, &mut count) {
                    Ok(forms) => forms,
                    Err(message) => {
                        let _ = writeln!(report, "{name}:{line}: {message}");
                        continue;
                    }
                };
                for (index, form) in forms.iter().enumerate() {
                    // The forms after the first one are made of it.
                    for (engine, load) in program::ENGINES.iter().take(if index == 0 { program::ENGINES.len() } else { 1 }) {
                        let mut cpu =
                            || program::cpu_with(&form.compiled, cpu_type, *load, scenario.modules.clone(), form.settings.clone());
                        let failed = scenario.run_watched(&SymbolTable::default(), &mut cpu, &mut |_| {});
                        if let Some(failure) = failed.first() {
                            let _ = writeln!(report, "{name}:{line} {}, {engine}: {}\n{}", form.name, failure.message, form.text);
                        }
                    }
                }
            }
        }
    }
    assert!(report.is_empty(), "programs that do something else when they are drawn:\n\n{report}");
    count
}

#[test]
fn programs_of_the_pages_do_the_same_when_they_are_drawn() {
    for folder in ["course", "stl", "diagrams"] {
        let count = run_drawn(folder);
        assert!(count.exact > 0 && count.equivalent + count.exact > count.no / 4, "{folder}: {count:?}");
    }
}

/// Random programs in each run of the test.
const RANDOM_PROGRAMS: u64 = 25;

#[test]
fn random_networks_do_the_same_when_they_are_drawn() {
    let cpu_type = &CpuType::ALL[0];
    let mut count = drawn::Count::default();
    for seed in 1..=RANDOM_PROGRAMS {
        let stl = drawn::RandomNetworks::new(seed).program();
        let compiled = program::compile(&stl, Mnemonics::English, cpu_type).unwrap_or_else(|message| panic!("{seed}: {message}\n{stl}"));
        let forms = drawn::forms(&stl, cpu_type, &mut count).unwrap_or_else(|message| panic!("{seed}: {message}\n{stl}"));
        let settings = program::settings(&compiled);
        let mut programs = vec![("STL".to_owned(), Arc::new(compiled.program), settings)];
        let text: String = forms.iter().map(|form| format!("\n{}:\n{}", form.name, form.text)).collect();
        programs.extend(forms.into_iter().map(|form| (form.name.to_owned(), form.compiled, form.settings)));
        if let Some(difference) = equality::first_difference(&programs, &equality::Inputs::of(&stl), cpu_type) {
            panic!("{seed}: {difference}\n{stl}{text}");
        }
    }
    assert!(count.exact + count.equivalent > count.no, "{count:?}");
}

#[test]
fn every_example_of_the_courses_has_a_section() {
    let headings: Vec<String> = pages("course").iter().flat_map(|(_, page)| sections(page)).map(|section| section.heading).collect();
    let ids = (1..=28)
        .map(|n| format!("S0-{n:02}"))
        .chain((1..=11).map(|n| format!("S1-{n:02}")))
        .chain((1..=17).map(|n| format!("S2-{n:02}")))
        .chain((1..=9).map(|n| format!("S3-{n:02}")))
        .chain((1..=15).map(|n| format!("S4-{n:02}")));
    let missing: Vec<String> = ids.filter(|id| !headings.iter().any(|heading| heading.starts_with(id.as_str()))).collect();
    assert!(missing.is_empty(), "no section for {}", missing.join(", "));
}

/// The diagrams of the courses in STL's world; those of IEC 61131-3 have pages of their own.
#[test]
fn every_s7_diagram_of_the_courses_has_a_section_with_a_diagram() {
    let drawn: Vec<String> = pages("diagrams")
        .iter()
        .flat_map(|(_, page)| sections(page))
        .filter(|section| !section.stl.is_empty() && !section.diagrams.is_empty())
        .map(|section| section.heading)
        .collect();
    let missing: Vec<String> = (1..=22)
        .chain(40..=44)
        .map(|n| format!("S-LAD-{n:02}"))
        .filter(|id| !drawn.iter().any(|heading| heading.starts_with(id.as_str())))
        .collect();
    assert!(missing.is_empty(), "no diagram for {}", missing.join(", "));
}

/// Sections whose programs show the trap that is warned of: page, beginning of the heading, warning.
const SHOW_THE_TRAP: &[(&str, &str, Problem)] = &[
    ("spec/course/s0_statement_list.md", "S0-14 T flip-flop, the wrong version", Problem::P5030),
    ("spec/course/s0_statement_list.md", "S0-17 A load has no condition", Problem::P5021),
    ("spec/course/s4_addressing.md", "S4-15 Rules of address registers and parameters", Problem::P5025),
    ("spec/course/s4_addressing.md", "P##parameter is an address of area V", Problem::P5027),
    ("spec/course/s4_addressing.md", "AR2 and DI are the base", Problem::P5024),
    ("spec/stl/compare.md", "A comparison begins a logic string", Problem::P5021),
    ("spec/stl/mcr.md", "Without MCRA", Problem::P5023),
    ("spec/stl/mcr.md", "Status bits", Problem::P5023),
    ("spec/stl/mcr.md", "More than eight zones", Problem::P5023),
    ("spec/stl/mcr.md", "Errors of the stack on an S7-400", Problem::P5023),
    ("spec/stl/mcr.md", "In a called block", Problem::P5023),
    // Reading the inputs again brings back what was overwritten.
    ("spec/system/sfc026_process_image.md", "", Problem::P5028),
    // Every operand of every instruction, inputs among them.
    ("spec/stl/operands.md", "", Problem::P5028),
];

#[test]
fn no_page_gets_a_warning_that_it_does_not_deserve() {
    let mut wrong = Vec::new();
    for (name, page) in ["course", "stl", "cpu", "system", "library"].into_iter().flat_map(pages) {
        for section in sections(&page).iter().filter(|section| !section.stl.is_empty()) {
            let Ok(compiled) = program::compile(&section.stl, Mnemonics::English, &CpuType::ALL[0]) else { continue };
            let followed = [
                Problem::P4020,
                Problem::P4022,
                Problem::P4023,
                Problem::P5021,
                Problem::P5022,
                Problem::P5023,
                Problem::P5024,
                Problem::P5025,
                Problem::P5026,
                Problem::P5027,
                Problem::P5028,
                Problem::P5029,
                Problem::P5030,
            ];
            let shows = |problem: Problem| {
                SHOW_THE_TRAP.iter().any(|&(page, heading, shown)| page == name && section.heading.starts_with(heading) && shown == problem)
            };
            let found = compiled.diagnostics.iter().filter(|diagnostic| followed.contains(&diagnostic.problem));
            for diagnostic in found.filter(|diagnostic| !shows(diagnostic.problem)) {
                let text = &section.stl[diagnostic.span.start as usize..diagnostic.span.end as usize];
                wrong.push(format!("{name}, {}: {} {} in `{text}`", section.heading, diagnostic.problem.code(), diagnostic.message));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_instruction_occurs_in_a_page() {
    let mut seen = BTreeSet::new();
    for (_, page) in ["course", "stl", "cpu", "system"].into_iter().flat_map(pages) {
        for section in sections(&page).iter().filter(|section| !section.checks.is_empty()) {
            for block in parse(FileId::default(), &section.stl, Some(Mnemonics::English)).file.blocks {
                for statement in block.statements {
                    seen.extend(
                        Instruction::candidates(&statement.mnemonic.text, Mnemonics::English)
                            .filter(|instruction| fits(instruction.operand(), &statement.operand)),
                    );
                }
            }
        }
    }
    let missing: Vec<String> = Instruction::ALL
        .iter()
        .filter(|instruction| !seen.contains(instruction))
        .map(|instruction| format!("{} ({})", instruction.english(), instruction.name()))
        .collect();
    assert!(missing.is_empty(), "instructions without a page: {}", missing.join(", "));
}

/// The kinds of operand that a page must show for an instruction, by what it takes. `FP L 8.0` is no use: the bit is lost.
fn demanded(instruction: Instruction) -> Vec<&'static str> {
    const BITS: [&str; 17] = [
        "I",
        "Q",
        "M",
        "DBX",
        "DIX",
        "a data block",
        "a variable",
        "M [MD]",
        "M [LD]",
        "M [DBD]",
        "M [DID]",
        "I [MD]",
        "DBX [MD]",
        "M [AR1]",
        "Q [AR2]",
        "[AR1]",
        "[AR2]",
    ];
    const STATUS: [&str; 10] = ["==0", "<>0", ">0", "<0", ">=0", "<=0", "UO", "OV", "OS", "BR"];
    const LOCAL: [&str; 2] = ["L", "L [MD]"];
    const READ: [&str; 3] = ["PIB", "PIW", "PID"];
    const WRITTEN: [&str; 3] = ["PQB", "PQW", "PQD"];
    const VALUES: [&str; 34] = [
        "IB",
        "IW",
        "ID",
        "QB",
        "QW",
        "QD",
        "MB",
        "MW",
        "MD",
        "LB",
        "LW",
        "LD",
        "DBB",
        "DBW",
        "DBD",
        "DIB",
        "DIW",
        "DID",
        "a data block",
        "a variable",
        "MB [MD]",
        "MW [MD]",
        "MD [MD]",
        "LW [MD]",
        "DBW [MD]",
        "DIW [MD]",
        "MW [LD]",
        "MW [DBD]",
        "MW [DID]",
        "MW [AR1]",
        "B [AR1]",
        "W [AR1]",
        "D [AR1]",
        "D [AR2]",
    ];
    let timer = ["T", "T [MW]", "T [a variable]", "a variable"];
    let counter = ["C", "C [MW]", "C [a variable]", "a variable"];
    match instruction.operand() {
        OperandClass::ScanBit => BITS.into_iter().chain(LOCAL).chain(STATUS).chain(["T", "C", "T [MW]", "C [LW]"]).collect(),
        OperandClass::AssignBit if matches!(instruction, Instruction::EdgePositive | Instruction::EdgeNegative) => BITS.to_vec(),
        OperandClass::AssignBit => BITS.into_iter().chain(LOCAL).collect(),
        OperandClass::Load => VALUES.into_iter().chain(READ).chain(["T", "C", "T [MW]", "C [MW]", "a constant", "a pointer"]).collect(),
        OperandClass::Transfer => VALUES.into_iter().chain(WRITTEN).collect(),
        OperandClass::DataBlockInfo => vec!["DBNO", "DBLG", "DINO", "DILG"],
        OperandClass::Timer => timer.to_vec(),
        OperandClass::Counter => counter.to_vec(),
        OperandClass::TimerOrCounter => timer.into_iter().chain(counter).collect(),
        OperandClass::PointerSource => vec!["MD", "LD", "DBD", "DID", "a variable", "a pointer", "AR2"],
        OperandClass::PointerSourceWithoutAr2 => vec!["MD", "LD", "DBD", "DID", "a variable", "a pointer"],
        OperandClass::PointerTarget => vec!["MD", "LD", "DBD", "DID", "a variable", "AR2"],
        OperandClass::PointerTargetWithoutAr2 => vec!["MD", "LD", "DBD", "DID", "a variable"],
        OperandClass::OptionalPointerOffset => vec!["nothing", "a pointer"],
        OperandClass::ShiftCount16 | OperandClass::ShiftCount32 | OperandClass::OptionalConstant16 | OperandClass::OptionalConstant32 => {
            vec!["nothing", "a constant"]
        }
        OperandClass::CallBlock => vec!["FC", "FB", "FC [MW]", "FC [a variable]", "FC [DBW]", "FB [MW]", "a variable"],
        OperandClass::OpenBlock => vec!["DB", "DI", "DB [MW]", "DI [MW]", "DB [a variable]", "a variable"],
        OperandClass::Call => vec!["FC", "FB", "SFC", "SFB", "a variable"],
        OperandClass::None => vec!["nothing"],
        OperandClass::StatusWord => vec!["STW"],
        OperandClass::ByteConstant
        | OperandClass::IntConstant
        | OperandClass::DoubleIntConstant
        | OperandClass::Zero
        | OperandClass::One => {
            vec!["a constant"]
        }
        OperandClass::Label => vec!["a label"],
        // Their pages are those of the extension words.
        OperandClass::Extension => Vec::new(),
    }
}

/// What kind of operand this is, in the words of [`demanded`].
fn kind_of(operand: &Operand) -> String {
    let is_keyword = |word: &str| {
        !word.starts_with(|first: char| first.is_ascii_alphabetic())
            || word.bytes().all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit())
    };
    match operand {
        Operand::None => "nothing".to_owned(),
        Operand::Constant(constant) if matches!(constant.value, Some(Value::Pointer(_))) => "a pointer".to_owned(),
        Operand::Constant(_) => "a constant".to_owned(),
        Operand::AddressOf(_) => "a pointer".to_owned(),
        Operand::Absolute { letters, .. } => letters.to_ascii_uppercase(),
        Operand::InBlock { .. } | Operand::BlockField { .. } => "a data block".to_owned(),
        Operand::Local { .. } => "a variable".to_owned(),
        Operand::Name { word, .. } if is_keyword(&word.text) => word.text.to_ascii_uppercase(),
        Operand::Name { .. } => "a label".to_owned(),
        Operand::Indirect { letters, pointer, .. } => format!("{} [{}]", letters.to_ascii_uppercase(), kind_of(pointer)),
        Operand::RegisterIndirect { letters, register, .. } => format!("{} [{}]", letters, register.text).trim_start().to_ascii_uppercase(),
        Operand::Call(call) => kind_of(&call.callee),
        _ => "something else".to_owned(),
    }
}

#[test]
fn every_kind_of_operand_of_every_instruction_occurs_in_a_page() {
    let mut seen = BTreeSet::new();
    for (_, page) in ["course", "stl", "cpu", "system"].into_iter().flat_map(pages) {
        for section in sections(&page).iter().filter(|section| !section.checks.is_empty()) {
            for block in parse(FileId::default(), &section.stl, Some(Mnemonics::English)).file.blocks {
                for statement in block.statements {
                    seen.insert((statement.mnemonic.text.to_ascii_uppercase(), kind_of(&statement.operand)));
                }
            }
        }
    }
    let shown = |word: &str, kind: &str| seen.contains(&(word.to_owned(), kind.to_owned()));
    let missing: Vec<String> = Instruction::ALL
        .iter()
        .flat_map(|&instruction| demanded(instruction).into_iter().map(move |kind| (instruction.english(), kind)))
        .filter(|(word, kind)| !shown(word, kind))
        .map(|(word, kind)| format!("`{word}` with {kind}"))
        .collect();
    assert!(missing.is_empty(), "no page shows {}", missing.join(", "));
}

/// Whether an operand belongs to this row among the rows with the same mnemonic.
fn fits(class: OperandClass, operand: &Operand) -> bool {
    let letters = match operand {
        Operand::Absolute { letters, .. } | Operand::Indirect { letters, .. } => letters.as_str(),
        _ => "",
    };
    let word = match operand {
        Operand::Name { word, .. } => word.text.to_ascii_uppercase(),
        _ => String::new(),
    };
    let status = word == "STW";
    let info = matches!(word.as_str(), "DBNO" | "DBLG" | "DINO" | "DILG");
    let constant = match operand {
        Operand::Constant(constant) => constant.value.as_ref(),
        _ => None,
    };
    match class {
        OperandClass::None => *operand == Operand::None,
        OperandClass::StatusWord => status,
        OperandClass::DataBlockInfo => info,
        OperandClass::Timer => letters == "T",
        OperandClass::Counter => letters == "C",
        OperandClass::Zero => constant == Some(&Value::Int(0)),
        OperandClass::One => constant == Some(&Value::Int(1)),
        OperandClass::DoubleIntConstant => matches!(constant, Some(Value::DoubleInt(_))),
        OperandClass::IntConstant => matches!(constant, Some(Value::Int(_))),
        OperandClass::AssignBit => !matches!(letters, "T" | "C" | "Z"),
        OperandClass::Load | OperandClass::Transfer => !status && !info,
        OperandClass::OptionalPointerOffset
        | OperandClass::ShiftCount16
        | OperandClass::ShiftCount32
        | OperandClass::OptionalConstant16
        | OperandClass::OptionalConstant32 => true,
        _ => *operand != Operand::None,
    }
}

/// All failures of a page that exists only here.
fn failures_of(page: &str) -> Vec<String> {
    sections(page).iter().flat_map(|section| failures("a page", section).into_iter().chain(inequality(section))).collect()
}

#[test]
fn a_diagram_that_does_something_else_is_seen() {
    let check = "```check\nscan\nexpect Q 0.0=0\n```\n";
    let stl = "## A part\n```stl\nA I 0.0; A I 0.1; = Q 0.0;\n```\n";
    for (diagram, wanted) in [
        ("```lad\nNO I 0.0\nNO I 0.1\nCOIL Q 0.0\n```\n", None),
        ("```fbd\nI 0.0 I 0.1 -> = Q 0.0\n```\n", None),
        ("```lad\nI 0.0 -> = Q 0.0\n```\n", Some("byte 0 of the outputs is 0x01, not 0x00")),
        ("```lad\nI 0.0 I 0.1 -> = Q 0.1\n```\n", Some("byte 0 of the outputs is 0x02, not 0x01")),
        ("```lad\nNO I 0.0\n```\n", Some("this rung has no output")),
        ("```fbd\nI 0.0 #(M 0.0) I 0.1 -> = Q 0.0\n```\n", Some("bit memory")),
    ] {
        let found = failures_of(&format!("{stl}{diagram}{check}"));
        match wanted {
            None => assert!(found.is_empty(), "{diagram}: {found:?}"),
            Some(text) => assert!(found.iter().any(|failure| failure.contains(text)), "{diagram}: {found:?}"),
        }
    }
    // What only a scan of the check brings about is compared there.
    let later = "## A part\n```stl\nL T 1; T MW 2; A M 9.0; = M 9.0;\n```\n```lad\nMOVE 0 => MW 2\nNETWORK\nNO M 9.0\nCOIL M 9.0\n```\n";
    let found = failures_of(&format!("{later}```check\nset T 1=S5T#1S\nscan\nexpect M 9.0=0\n```\n"));
    assert!(found.iter().any(|failure| failure.contains("after scan 1: the bit memory")), "{found:?}");
}

#[test]
fn the_runner_sees_what_is_wrong() {
    let stl = "# Title\n\n## A part\n\n```stl\nA I 0.0; = Q 0.0;\n```\n";
    let cases = [
        ("```check\ntable I 0.0 -> Q 0.0\n1 1\n```\n", None),
        ("```check\ntable I 0.0 -> Q 0.0\n0 0\n1 0\n```\n", Some("a page:11 (A part): [English, interpreter] expected Q 0.0 = 0, got 1")),
        ("```check\nscan\n```\n", Some("expects nothing")),
        ("```check\nscna\n```\n", Some("a page:9 (A part): `scna` begins no line")),
        ("no check\n", Some("belong together")),
        ("```check\nknown-gap \"to come\"\nscan\nexpect Q 0.0=1\n```\n", None),
        ("```check\nknown-gap \"to come\"\nscan\nexpect Q 0.0=0\n```\n", Some("works now; remove `known-gap \"to come\"`")),
    ];
    for (check, wanted) in cases {
        let found = failures_of(&format!("{stl}{check}"));
        match wanted {
            None => assert!(found.is_empty(), "{check}: {found:?}"),
            Some(text) => assert!(found.iter().any(|failure| failure.contains(text)), "{check}: {found:?}"),
        }
    }
    let broken = failures_of("## A part\n```stl\nA I 0.0 = Q;\n```\n```check\nscan\nexpect Q 0.0=1\n```\n");
    assert!(!broken.is_empty(), "a source that does not compile is a failure");
}
