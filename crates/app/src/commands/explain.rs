//! `sieben explain WORD`: an instruction, a problem code or a CPU type, from the tables.

use clap::Args;
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Severity;
use sieben_model::problems::Problem;

use crate::failure::{Exit, Failure};
use crate::nearest::nearest;
use crate::output;

/// The pages of all problems by code.
const PAGES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/problem_pages.rs"));

/// Explain an instruction, a problem code or a CPU type.
#[derive(Args)]
#[command(after_help = "Examples:\n  \
  sieben explain SPB      an instruction, in either mnemonic language\n  \
  sieben explain P2001    a problem code\n  \
  sieben explain 416-3    a CPU type\n  \
  sieben explain cpu      all CPU types\n  \
  sieben explain problems all problem codes")]
pub(crate) struct Arguments {
    /// What to explain
    #[arg(required = true, value_name = "WORD", allow_hyphen_values = true)]
    words: Vec<String>,
}

/// Explains the word.
pub(crate) fn run(arguments: &Arguments) -> Result<Exit, Failure> {
    let word = arguments.words.join(" ");
    let word = word.trim();
    output::print(&explain(word).ok_or_else(|| unknown(word))?)?;
    Ok(Exit::Success)
}

fn explain(word: &str) -> Option<String> {
    if word.eq_ignore_ascii_case("cpu") {
        return Some(cpu_types());
    }
    if word.eq_ignore_ascii_case("problems") {
        return Some(problems());
    }
    Problem::from_code(word).map(problem).or_else(|| CpuType::by_name(word).map(cpu_type))
}

fn unknown(word: &str) -> Failure {
    let words = Problem::ALL.iter().map(|problem| problem.code()).chain(CpuType::ALL.iter().map(|cpu| cpu.name));
    let failure = Failure::usage(Problem::P7007, format!("nothing is known about `{word}`"));
    match nearest(word, words) {
        Some(near) => failure.help(format!("did you mean `{near}`?")),
        None => failure,
    }
}

/// The page of a problem: the row of the table, then what its page adds.
fn problem(problem: Problem) -> String {
    let severity = match problem.severity() {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    let mut text = format!("{} ({severity}): {}\n\n{}\n", problem.code(), problem.title(), problem.help());
    if let Some((_, page)) = PAGES.iter().find(|(code, _)| *code == problem.code()) {
        // The head of a page repeats the row.
        let rest = page.split_once("-->").map_or("", |(_, rest)| rest).trim();
        if !rest.is_empty() {
            text.push_str(&format!("\n{rest}\n"));
        }
    }
    text
}

fn problems() -> String {
    Problem::ALL.iter().map(|problem| format!("{}  {}\n", problem.code(), problem.title())).collect()
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
