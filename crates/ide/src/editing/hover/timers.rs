//! Signal diagrams of timers as text.

use super::super::{Position, Snapshot};
use super::instruction;

/// How long the timers of the diagrams run, in steps.
const RUNS: usize = 4;
/// What starts them, step by step.
const INPUT: &str = "..######...##.....########....";

/// How a timer behaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Pulse,
    ExtendedPulse,
    OnDelay,
    StoredOnDelay,
    OffDelay,
    /// A pulse that nothing makes longer.
    SinglePulse,
}

impl Form {
    fn sentence(self) -> &'static str {
        match self {
            Self::Pulse => "1 from the edge on while the input is 1, as long as the time at most",
            Self::ExtendedPulse => "1 for the whole time from the edge on; another edge starts it from the beginning",
            Self::OnDelay => "1 once the input has been 1 for the whole time, until it is 0",
            Self::StoredOnDelay => "1 once the time is over, whatever the input does; `R` makes it 0",
            Self::OffDelay => "1 with the input, and for the time after it",
            Self::SinglePulse => "1 for the whole time from the edge on; nothing makes it longer",
        }
    }

    /// The output, step by step.
    fn output(self) -> String {
        let (mut before, mut since, mut stored) = (false, None::<usize>, false);
        let step = |sign: char| {
            let input = sign == '#';
            let rises = input && !before;
            let falls = !input && before;
            before = input;
            since = since.map(|steps| steps + 1);
            let runs = since.is_some_and(|steps| steps < RUNS);
            match self {
                Self::SinglePulse if rises && !runs => since = Some(0),
                Self::SinglePulse => {}
                Self::OffDelay if falls => since = Some(0),
                Self::OffDelay if input => since = None,
                _ if rises => since = Some(0),
                _ => {}
            }
            let runs = since.is_some_and(|steps| steps < RUNS);
            let is_over = since.is_some_and(|steps| steps >= RUNS);
            stored |= is_over;
            let on = match self {
                Self::Pulse => input && runs,
                Self::ExtendedPulse | Self::SinglePulse => runs,
                Self::OnDelay => input && is_over,
                Self::StoredOnDelay => stored,
                Self::OffDelay => input || runs,
            };
            if on { '#' } else { '.' }
        };
        INPUT.chars().map(step).collect()
    }

    fn diagram(self, input: &str, output: &str) -> String {
        let drawn = |lane: &str| lane.chars().map(|sign| if sign == '#' { '▔' } else { '▁' }).collect::<String>();
        let width = input.len().max(output.len());
        let (high, low) = (drawn(INPUT), drawn(&self.output()));
        format!(
            "\n{}:\n\n```\n{input:width$} {high}\n{output:width$} {low}\n{:width$} ├{}┤ the time\n```\n",
            self.sentence(),
            "",
            "─".repeat(RUNS - 1)
        )
    }
}

/// The diagram of the timer that an instruction starts, by its international mnemonic.
pub(super) fn of_instruction(english: &str) -> Option<String> {
    let form = match english {
        "SP" => Form::Pulse,
        "SE" => Form::ExtendedPulse,
        "SD" => Form::OnDelay,
        "SS" => Form::StoredOnDelay,
        "SF" => Form::OffDelay,
        _ => return None,
    };
    Some(form.diagram("RLO", "T"))
}

/// The diagram of a timer that is a block or a function.
pub(super) fn of_block(name: &str) -> Option<String> {
    let name = name.to_ascii_uppercase();
    let base = name.split('_').next().unwrap_or(&name).trim_start_matches('L');
    let form = match (name.as_str(), base) {
        ("S_PULSE" | "S_IMPULS", _) => Form::Pulse,
        ("S_PEXT" | "S_VIMP", _) => Form::ExtendedPulse,
        ("S_ODT" | "S_EVERZ", _) => Form::OnDelay,
        ("S_ODTS" | "S_SEVERZ", _) => Form::StoredOnDelay,
        ("S_OFFDT" | "S_AVERZ", _) => Form::OffDelay,
        (_, "TON") => Form::OnDelay,
        (_, "TOF") => Form::OffDelay,
        (_, "TP") => Form::SinglePulse,
        _ => return None,
    };
    Some(form.diagram(if name.starts_with("S_") { "S" } else { "IN" }, "Q"))
}

/// The diagram of the timer whose number stands at a position, where a statement starts it.
pub(super) fn of_statement(snapshot: &Snapshot, position: Position) -> Option<String> {
    let text = snapshot.text(position.text)?;
    let offset = snapshot.offset(position)?;
    let (_, rows) = instruction::of_line(&text.text, offset, snapshot.mnemonics(position.text))?;
    rows.iter().find_map(|row| of_instruction(row.english()))
}
