//! `sieben explain WORD`: an instruction, an element of a diagram, a function, a problem code, a CPU type, a status bit, an OB, a system function or an event, from the tables.

mod diagrams;
mod functions;
mod tables;
mod words;

use clap::Args;
use sieben_cpu::CyclicInterrupt;
use sieben_cpu::diagnostic_buffer::event_text;
use sieben_cpu::organization_blocks::{self, Missing};
use sieben_cpu::system::summaries::summary;
use sieben_lang::Options;
use sieben_lang::description::describe;
use sieben_lang::library::{self, LibraryBlock};
use sieben_lang::reason;
use sieben_lang::stl::extension::Word;
use sieben_lang::stl::instructions::Instruction;
use sieben_lang::stl::latin;
use sieben_lang::stl::operands::OperandClass;
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::interface::{Interface, Section, SystemBlock};
use sieben_model::language::{Language, Text, pick};
use sieben_model::mnemonics::Mnemonics;
use sieben_model::nearest::nearest;
use sieben_model::problems::Problem;

use crate::failure::{Exit, Failure};
use crate::language;
use crate::output;
use crate::problem_pages::PAGES;

/// The nine bits of the status word: name, other spellings, what it holds.
const STATUS_BITS: &[(&str, &[&str], &str)] = &[
    ("BR", &["BIE", "ENO"], "binary result: the RLO that SAVE kept; ENO of a block"),
    ("CC1", &["CC 1", "A1"], "condition code, with CC0: 10 above 0 or greater, 01 below 0 or less, 00 zero or equal, 11 no number"),
    ("CC0", &["CC 0", "A0"], "condition code, with CC1: 10 above 0 or greater, 01 below 0 or less, 00 zero or equal, 11 no number"),
    ("OV", &[], "overflow: the last calculation left its range"),
    ("OS", &[], "stored overflow: some calculation since the last JOS or call left its range"),
    ("OR", &[], "an AND before OR is under way"),
    ("STA", &["STATUS BIT"], "the value of the bit that was addressed last"),
    ("RLO", &["VKE"], "result of logic operation: the value of the chain so far"),
    ("/FC", &["FC", "/ER"], "first check: 0 if the next scan of a bit begins a new chain"),
];

/// The organization blocks that the CPU calls, from one number to another, and what starts them.
const ORGANIZATION_BLOCKS: &[(u16, u16, &str)] = &[
    (1, 1, "the cyclic program: called in every scan, between reading the inputs and writing the outputs"),
    (10, 17, "time-of-day interrupt: at a date and time, once or again and again; set with SFC 28, activated with SFC 30"),
    (20, 23, "delay interrupt: a time after the call of SFC 32"),
    (30, 38, "cyclic interrupt: at a fixed distance, whatever the scan takes; `[cyclic.NUMBER]` in sieben.toml sets it"),
    (40, 47, "hardware interrupt: a module raises it, as when an input changes"),
    (55, 57, "interrupt of a DPV1 slave: status (OB 55), update (OB 56), manufacturer (OB 57)"),
    (60, 60, "multicomputing interrupt: raised by SFC 35"),
    (80, 80, "time error, as when a scan lasts longer than the watchdog allows"),
    (81, 81, "power supply error, as an empty battery"),
    (82, 82, "diagnostic interrupt: a module found a fault, or that it is gone"),
    (83, 83, "a module was plugged in or pulled out"),
    (84, 84, "CPU hardware error"),
    (85, 85, "priority class error, as the start of an organization block that is not loaded"),
    (86, 86, "failure of a rack or of a DP station"),
    (87, 87, "communication error"),
    (88, 88, "a program was aborted, as by too many nested calls (S7-400)"),
    (90, 90, "background: runs in what is left of the minimum cycle time, `min_cycle` in sieben.toml (S7-400)"),
    (100, 100, "warm restart: called once before the first scan"),
    (101, 101, "hot restart: called once before the first scan"),
    (102, 102, "cold restart: called once before the first scan"),
    (121, 121, "programming error, as BCD digits above 9 or a missing block"),
    (122, 122, "error at the access to a module"),
];

/// Reasons of an instruction that are shown.
const REASONS_SHOWN: usize = 4;

/// Explain an instruction, an element of a diagram, a function, a problem code, a CPU type, a system function or an event.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben explain SPB           an instruction, in either mnemonic language\n  \
  sieben explain 'A('          quote what the shell would take\n  \
  sieben explain TON           a function or a block of Structured Text\n  \
  sieben explain P2001         a problem code\n  \
  sieben explain NO            an element or a box of a diagram: MID, COIL, S_ODT, ADD_I\n  \
  sieben explain R-TWO         why a network is not drawn; also: what a rewrite changes, W3\n  \
  sieben explain 416-3         a CPU type\n  \
  sieben explain RLO           a bit of the status word\n  \
  sieben explain 'OB 121'      an organization block\n  \
  sieben explain 'SFC 46'      a system function, also by its name: STP\n  \
  sieben explain CONCAT        a block of the library, also by its number: FC 2\n  \
  sieben explain 16#4562       an event of the diagnostic buffer\n  \
  sieben explain AR1           a word of a course: a register, a type, a part of an operand\n  \
  sieben explain instructions  all of them; also: functions, problems, cpu, library, system, ob\n  \
  sieben explain status        what every instruction does to the status word\n  \
  sieben explain jumps         when every jump jumps\n  \
  sieben explain formats       how values can be shown: `--show MD20:REAL`")]
pub(crate) struct Arguments {
    /// What to explain
    #[arg(required = true, value_name = "WORD", allow_hyphen_values = true)]
    words: Vec<String>,
}

impl Arguments {
    /// The language that is named among the words, which may begin with a hyphen, as `-R` does.
    pub(crate) fn take_language(&mut self) -> Option<Language> {
        let (place, language) = language::option(&self.words)?;
        self.words.drain(place);
        Some(language)
    }
}

/// Explains the word.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let word = arguments.words.join(" ");
    let word = word.trim();
    let found = match (explain(word), latin(word)) {
        (None, Some(meant)) => {
            explain(&meant).map(|text| format!("`{word}` has letters of another alphabet; this is `{meant}`.\n\n{text}"))
        }
        (found, _) => found,
    };
    output::print(&found.ok_or_else(|| unknown(word))?)?;
    Ok(Exit::Success)
}

fn explain(word: &str) -> Option<String> {
    if word.eq_ignore_ascii_case("cpu") {
        return Some(cpu_types());
    }
    if word.eq_ignore_ascii_case("problems") {
        return Some(problems());
    }
    if word.eq_ignore_ascii_case("instructions") {
        return Some(instructions());
    }
    if word.eq_ignore_ascii_case("functions") {
        return Some(functions::functions());
    }
    if word.eq_ignore_ascii_case("formats") {
        return Some(tables::formats());
    }
    if word.eq_ignore_ascii_case("status") {
        return Some(tables::status());
    }
    if word.eq_ignore_ascii_case("jumps") {
        return Some(tables::jumps());
    }
    if word.eq_ignore_ascii_case("library") {
        return Some(library_blocks());
    }
    if word.eq_ignore_ascii_case("system") {
        return Some(system_functions());
    }
    if word.eq_ignore_ascii_case("OB") {
        return Some(organization_blocks());
    }
    // `MOD` is an instruction and a function, `TON` a function block and SFB 4.
    let programs: Vec<String> = [
        instruction(word),
        diagrams::element(word),
        words::word_of_a_course(word),
        functions::function(word),
        system_function(word),
        library_block(word),
        diagrams::rewrite(word),
    ]
    .into_iter()
    .flatten()
    .collect();
    (!programs.is_empty())
        .then(|| programs.join("\n"))
        .or_else(|| event(word))
        .or_else(|| Problem::from_code(word).or_else(|| diagrams::reason(word)).map(problem))
        .or_else(|| CpuType::by_name(word).map(cpu_type))
        .or_else(|| status_bit(word))
        .or_else(|| organization_block(word))
        .or_else(|| extension_word(word))
}

/// A word of awlsim, such as `__ASSERT==`.
fn extension_word(word: &str) -> Option<String> {
    let word = Word::from_spelling(word)?;
    Some(format!("{}, an extension word of awlsim\n  {}\n  Operands: {}\n", word.spelling(), word.doc(), word.operands()))
}

/// A bit of the status word, in either language.
fn status_bit(word: &str) -> Option<String> {
    let named = |name: &&str| name.eq_ignore_ascii_case(word);
    let (name, _, meaning) = STATUS_BITS.iter().find(|(name, others, _)| named(name) || others.iter().any(named))?;
    Some(format!("{name}, a bit of the status word\n  {meaning}\n"))
}

/// `OB 121`: what starts it, its priority, and what happens without it.
fn organization_block(word: &str) -> Option<String> {
    let compact: String = word.split_whitespace().collect::<String>().to_ascii_uppercase();
    let wanted: u16 = compact.strip_prefix("OB")?.parse().ok()?;
    let (_, _, meaning) = ORGANIZATION_BLOCKS.iter().find(|(first, last, _)| (*first..=*last).contains(&wanted))?;
    let block = BlockId::ob(wanted);
    let priority = match organization_blocks::priority(block) {
        0 if block == organization_blocks::BACKGROUND => "below OB 1".to_owned(),
        0 => "that of the block with the error".to_owned(),
        priority => priority.to_string(),
    };
    let missing = match organization_blocks::missing(block) {
        Missing::GoesOn => "nothing happens".to_owned(),
        Missing::PriorityClassError => "OB 85 is called, when it is to start".to_owned(),
        Missing::Stop(event) => format!("STOP with 16#{event:04X}, when it is to start"),
    };
    let mut text = format!("OB {wanted}, an organization block\n  {meaning}\n  priority    {priority}\n  not loaded  {missing}\n");
    if let Some(cyclic) = CyclicInterrupt::usual(wanted) {
        text.push_str(&format!("  interval    {} ms, unless the project says otherwise\n", cyclic.interval_ms));
    }
    Some(text)
}

/// A line for each kind of organization block.
fn organization_blocks() -> String {
    let line = |(first, last, meaning): &(u16, u16, &str)| {
        let numbers = if first == last { format!("OB {first}") } else { format!("OB {first} to {last}") };
        format!("{numbers:<13} {meaning}\n")
    };
    ORGANIZATION_BLOCKS.iter().map(line).collect()
}

/// A line for each system function.
fn system_functions() -> String {
    let line = |block: &SystemBlock| {
        let only = || block.only.map_or(String::new(), |only| format!("not here: needs {only}"));
        let meaning = summary(block.block).map_or_else(only, str::to_owned);
        format!("{:<8} {:<10} {meaning}", block.block.to_string(), block.name).trim_end().to_owned() + "\n"
    };
    sieben_cpu::system::numbered().iter().map(line).collect()
}

/// A system function by number or name, with its parameters.
fn system_function(word: &str) -> Option<String> {
    let compact: String = word.split_whitespace().collect();
    let named = |block: &SystemBlock| {
        block.name.eq_ignore_ascii_case(&compact) || block.block.to_string().replace(' ', "").eq_ignore_ascii_case(&compact)
    };
    let block = sieben_cpu::system::numbered().into_iter().find(named)?;
    let whose = match block.only {
        None => {
            let what = summary(block.block).map_or(String::new(), |sentence| format!(": {sentence}"));
            format!("a system function of the CPU{what}")
        }
        Some(only) => format!("a system function that the CPU types here do not have: it needs {only}, and a call answers with an error"),
    };
    Some(format!("{} \"{}\", {whose}\n{}", block.block, block.name, parameters(&block.interface)))
}

/// A block of the library by number or name, with what its source says.
fn library_block(word: &str) -> Option<String> {
    let compact: String = word.split_whitespace().collect();
    let named = |block: &&LibraryBlock| {
        block.name.eq_ignore_ascii_case(&compact) || block.block.to_string().replace(' ', "").eq_ignore_ascii_case(&compact)
    };
    let block = library::ALL.iter().find(named)?;
    let options = Options { system_blocks: sieben_cpu::system::interfaces(), ..Options::default() };
    let description = describe(block, &options);
    let comment: String = description.comment.lines().map(|line| format!("  {line}\n")).collect();
    Some(format!(
        "{} \"{}\", a block of the library: {}\n{comment}{}  source: {}\n",
        block.block,
        block.name,
        description.title,
        parameters(&description.interface),
        block.path
    ))
}

fn library_blocks() -> String {
    let rows = library::ALL.iter().map(|block| {
        let description = describe(block, &Options::default());
        format!("{:<7} {:<9} {}\n", block.block.to_string(), block.name, description.title)
    });
    rows.collect()
}

/// A line for each parameter.
fn parameters(interface: &Interface) -> String {
    let mut text = String::new();
    for parameter in interface.parameters() {
        let section = match parameter.section {
            Section::Input => "IN",
            Section::Output => "OUT",
            Section::InOut => "IN_OUT",
            _ => "RET_VAL",
        };
        // What has no word of its own is a structure: start information.
        let data_type = parameter.data_type.word().unwrap_or("STRUCT");
        let line = format!("  {section:<7} {:<15} {data_type:<13} {}", parameter.name, parameter.comment);
        text.push_str(&format!("{}\n", line.trim_end()));
    }
    if interface.parameters().next().is_none() {
        text.push_str("  no parameters\n");
    }
    text
}

/// An event of the diagnostic buffer: `16#4562`.
fn event(word: &str) -> Option<String> {
    let digits = word.to_ascii_uppercase();
    let number = u16::from_str_radix(digits.strip_prefix("W#16#").or(digits.strip_prefix("16#"))?, 16).ok()?;
    let text = event_text(number);
    (text != event_text(0)).then(|| format!("16#{number:04X}, an event of the diagnostic buffer: {text}\n"))
}

/// All instructions with this word in either mnemonic language.
fn instruction(word: &str) -> Option<String> {
    // `A (` and `A(` are the same word.
    let word: String = word.split_whitespace().collect::<String>().to_ascii_uppercase();
    let named = |row: &Instruction| row.english() == word || row.german() == word;
    // `NOP 0` and `NOP 1` are written with what belongs to them.
    let operand = |row: &Instruction| match row.operand() {
        OperandClass::Zero => Some('0'),
        OperandClass::One => Some('1'),
        _ => None,
    };
    let with_operand = |row: &Instruction| operand(row).is_some_and(|digit| word.strip_suffix(digit) == Some(row.english()));
    let rows: Vec<Instruction> = Instruction::ALL.iter().copied().filter(|row| named(row) || with_operand(row)).collect();
    if rows.is_empty() {
        return None;
    }
    let mut text: String = rows.iter().map(|&row| instruction_row(row)).collect::<Vec<_>>().join("\n");
    text.push_str("\nStatus word: - not changed, 0 or 1 always that, x written with a result.\n");
    let meanings = |mnemonics| Instruction::candidates(&word, mnemonics).next();
    if let (Some(english), Some(german)) = (meanings(Mnemonics::English), meanings(Mnemonics::German))
        && english.german() != word
    {
        text.push_str(&format!(
            "Careful: `{word}` is the English word for what German writes `{}`, and the German word for what English writes `{}`.\n",
            english.german(),
            german.english()
        ));
    }
    Some(text)
}

fn instruction_row(row: Instruction) -> String {
    let names = if row.english() == row.german() {
        row.english().to_owned()
    } else {
        format!("{} (English), {} (German)", row.english(), row.german())
    };
    // What `sieben step` would say of it, from runs.
    let examples: String = reason::examples::of(row)
        .iter()
        .take(REASONS_SHOWN)
        .enumerate()
        .map(|(index, example)| {
            let label = if index == 0 { "why:" } else { "" };
            format!("  {label:<8} `{}`: {}\n", example.statement[0], example.sentence[0])
        })
        .collect();
    format!(
        "{names}\n  {}\n  operand: {}\n           BR CC1 CC0 OV OS OR STA RLO /FC\n  status:  {}\n{examples}",
        row.doc(),
        if row.operand() == OperandClass::None { "none" } else { row.operand().describe() },
        status_columns(row.status_row())
    )
}

/// The nine effects under their headings.
fn status_columns(row: &str) -> String {
    let widths = [2, 3, 3, 2, 2, 2, 3, 3, 3];
    let columns: Vec<String> = row.split_whitespace().zip(widths).map(|(effect, width)| format!("{effect:<width$}")).collect();
    columns.join(" ").trim_end().to_owned()
}

fn instructions() -> String {
    let mut text = format!("{:<8} {:<8} what it does\n", "English", "German");
    for row in Instruction::ALL {
        text.push_str(&format!("{:<8} {:<8} {}\n", row.english(), row.german(), row.doc()));
    }
    text
}

fn unknown(word: &str) -> Failure {
    let words = Problem::ALL
        .iter()
        .map(|problem| problem.code())
        .chain(CpuType::ALL.iter().map(|cpu| cpu.name))
        .chain(Instruction::ALL.iter().flat_map(|row| [row.english(), row.german()]))
        .chain(library::ALL.iter().map(|block| block.name))
        .chain(sieben_lang::st::standard::catalogue::names())
        .chain(words::spellings())
        .chain(diagrams::words())
        .chain(["cpu", "problems", "instructions", "functions", "library", "system", "status", "jumps"]);
    let failure = Failure::usage(Problem::P7007, format!("nothing is known about `{word}`"));
    // `315` is how everybody calls the 315-2PN/DP; as letters it is too far away to look alike.
    let family: Vec<String> = CpuType::ALL
        .iter()
        .filter(|cpu| cpu.name.strip_prefix(word).is_some_and(|rest| rest.starts_with('-')))
        .map(|cpu| format!("`{}`", cpu.name))
        .collect();
    if !family.is_empty() {
        return failure.help(format!("did you mean {}?", family.join(" or ")));
    }
    match nearest(word, words) {
        Some(near) => failure.help(format!("did you mean `{near}`?")),
        None => failure,
    }
}

/// The page of a problem: the row of the table, then what its page adds.
fn problem(problem: Problem) -> String {
    let language = language::spoken();
    let severity = match problem.severity() {
        Severity::Error => ["error", "Fehler"],
        Severity::Warning => ["warning", "Warnung"],
    };
    let (severity, title) = (pick(language, severity), problem.title_in(language));
    let mut text = format!("{} ({severity}): {title}\n\n{}\n", problem.code(), problem.help_in(language));
    if let Some((_, page)) = PAGES.iter().find(|(code, _)| *code == problem.code()) {
        // The head of a page repeats the row.
        let rest = page.split_once("-->").map_or("", |(_, rest)| rest).trim();
        if !rest.is_empty() {
            text.push_str(pick(language, PAGE_IS_ENGLISH));
            text.push_str(&format!("\n{rest}\n"));
        }
    }
    text
}

const PAGE_IS_ENGLISH: Text = ["", "\nDie Seite dazu ist englisch:\n"];

fn problems() -> String {
    let language = language::spoken();
    Problem::ALL.iter().map(|problem| format!("{}  {}\n", problem.code(), problem.title_in(language))).collect()
}

fn cpu_types() -> String {
    let mut text = format!("{:<12} {:>5} {:>12} {:>9} {:>7} {:>9}\n", "CPU type", "ACCUs", "I and Q each", "M", "timers", "counters");
    for cpu in CpuType::ALL {
        text.push_str(&format!(
            "{:<12} {:>5} {:>12} {:>9} {:>7} {:>9}\n",
            cpu.name,
            cpu.accumulators,
            format!("{} bytes", cpu.process_image),
            format!("{} B", cpu.bit_memory),
            cpu.timers,
            cpu.counters
        ));
    }
    text
}

fn cpu_type(cpu: &CpuType) -> String {
    let whole = if cpu.status_word_whole { "all nine bits" } else { "without /FC, STA and OR" };
    let rows: [(&str, String); 13] = [
        ("accumulators", cpu.accumulators.to_string()),
        ("process image", format!("{} bytes of inputs, as many of outputs", cpu.process_image)),
        ("peripheral addresses", format!("0 to {}", cpu.peripheral - 1)),
        ("bit memory", format!("{} bytes", cpu.bit_memory)),
        ("S5 timers", cpu.timers.to_string()),
        ("S5 counters", cpu.counters.to_string()),
        ("local data", format!("{} bytes per priority class, {} per block", cpu.local_data, cpu.local_data_block)),
        ("data blocks", format!("DB 1 to DB {}", cpu.db_number_max)),
        ("functions, FBs", format!("0 to {}", cpu.fc_number_max)),
        ("largest block", format!("{} bytes", cpu.block_size_max)),
        ("nested calls", format!("{}, and {} more in an error OB", cpu.nesting_depth, cpu.nesting_depth_error)),
        ("L STW, T STW", whole.to_owned()),
        ("diagnostic buffer", format!("{} entries", cpu.diagnostic_buffer)),
    ];
    let lines: String = rows.iter().map(|(name, value)| format!("  {name:<21} {value}\n")).collect();
    format!("CPU {}\n{lines}", cpu.name)
}
