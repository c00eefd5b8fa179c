//! Which statements of a program its tests have run, and which decisions they have seen both ways, as an lcov file.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use sieben_engine::{FaultPlace, Machine, StatementEvent, Tracer};
use sieben_lang::Compiled;
use sieben_lang::reason::why::Why;
use sieben_model::block::BlockId;
use sieben_model::source::Sources;

/// How often something was run with RLO 0, and with RLO 1.
type ByRlo = [u64; 2];

/// How often each statement was run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Counts {
    statements: BTreeMap<FaultPlaceKey, ByRlo>,
}

/// A statement as a key.
type FaultPlaceKey = (BlockId, u32);

fn key(place: FaultPlace) -> FaultPlaceKey {
    (place.block, place.statement)
}

impl Tracer for Counts {
    fn statement(&mut self, _machine: &Machine, event: &StatementEvent) {
        let count = &mut self.statements.entry(key(event.place)).or_default()[usize::from(event.before.rlo != 0)];
        *count = count.saturating_add(1);
    }
}

/// A line of a source.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Line {
    /// How often its statements were run.
    ran: u64,
    /// Its statements that do one thing or another by the RLO.
    decisions: Vec<ByRlo>,
}

/// The lines of the sources of all programs, with how often their statements were run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Coverage {
    /// By the name of the source and the line, counted from 1.
    lines: BTreeMap<String, BTreeMap<usize, Line>>,
}

/// Whether a statement of STL does one thing or another by the RLO.
fn decides(compiled: &Compiled, block: BlockId, statement: usize) -> bool {
    let statement = compiled.blocks.get(&block).and_then(|block| block.statements.get(statement));
    statement.is_some_and(|statement| {
        matches!(
            statement.instruction.why(),
            Why::Assign
                | Why::Set
                | Why::Reset
                | Why::Rising
                | Why::Falling
                | Why::JumpIfRlo
                | Why::JumpIfNotRlo
                | Why::CallIfRlo
                | Why::EndIfRlo
        )
    })
}

impl Coverage {
    /// Takes in what a test has run. Lines that nothing has run count with 0.
    pub(crate) fn add(&mut self, compiled: &Compiled, sources: &Sources, counts: &Counts) {
        for (&block, code) in &compiled.program.code {
            if compiled.tests.blocks.contains(&block) || compiled.is_of_library(block) {
                continue;
            }
            for (statement, &span) in code.spans.iter().enumerate() {
                // Statements that the compiler adds have no place.
                if span.end == span.start || !sources.iter().any(|(file, _)| file == span.file) {
                    continue;
                }
                let (line, _) = sources.line_column(span);
                let by_rlo = counts.statements.get(&(block, statement as u32)).copied().unwrap_or_default();
                let lines = self.lines.entry(sources.file(span.file).name.clone()).or_default();
                let known = lines.entry(line).or_default();
                // A line with several statements was run as often as the one that was run most.
                known.ran = known.ran.max(by_rlo[0].saturating_add(by_rlo[1]));
                if decides(compiled, block, statement) {
                    known.decisions.push(by_rlo);
                }
            }
        }
    }

    /// Adds what another test has run.
    pub(crate) fn merge(&mut self, other: Self) {
        for (file, lines) in other.lines {
            let known = self.lines.entry(file).or_default();
            for (number, line) in lines {
                let known = known.entry(number).or_default();
                known.ran = known.ran.saturating_add(line.ran);
                // Programs of two tests may have different sources of one name.
                known.decisions.resize(known.decisions.len().max(line.decisions.len()), ByRlo::default());
                for (known, more) in known.decisions.iter_mut().zip(line.decisions) {
                    *known = [known[0].saturating_add(more[0]), known[1].saturating_add(more[1])];
                }
            }
        }
    }

    /// Lines that were run, and all.
    pub(crate) fn sum(&self) -> (usize, usize) {
        let all = || self.lines.values().flat_map(BTreeMap::values);
        (all().filter(|line| line.ran > 0).count(), all().count())
    }

    /// Decisions that were seen with RLO 0 and with RLO 1, and all.
    pub(crate) fn decisions(&self) -> (usize, usize) {
        let all = || self.lines.values().flat_map(BTreeMap::values).flat_map(|line| &line.decisions);
        (all().filter(|by_rlo| by_rlo.iter().all(|&count| count > 0)).count(), all().count())
    }

    /// The tracefile of lcov. A decision has two branches: 0 for RLO 0, 1 for RLO 1.
    pub(crate) fn lcov(&self) -> String {
        let mut out = String::from("TN:\n");
        // Writing to a text cannot fail.
        for (file, lines) in &self.lines {
            let _ = writeln!(out, "SF:{file}");
            let (mut branches, mut taken) = (0, 0);
            for (number, line) in lines {
                for (decision, by_rlo) in line.decisions.iter().enumerate() {
                    for (branch, &count) in by_rlo.iter().enumerate() {
                        let reached = by_rlo.iter().any(|&count| count > 0);
                        let count_text = if reached { count.to_string() } else { "-".to_owned() };
                        let _ = writeln!(out, "BRDA:{number},{decision},{branch},{count_text}");
                        branches += 1;
                        taken += usize::from(count > 0);
                    }
                }
            }
            if branches > 0 {
                let _ = writeln!(out, "BRF:{branches}\nBRH:{taken}");
            }
            for (number, line) in lines {
                let _ = writeln!(out, "DA:{number},{}", line.ran);
            }
            let _ = writeln!(out, "LF:{}", lines.len());
            let _ = writeln!(out, "LH:{}", lines.values().filter(|line| line.ran > 0).count());
            out.push_str("end_of_record\n");
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_of_several_tests_add_up() {
        let one = |counts: &[(usize, u64, &[ByRlo])]| Coverage {
            lines: BTreeMap::from([(
                "a.awl".to_owned(),
                counts.iter().map(|&(line, ran, decisions)| (line, Line { ran, decisions: decisions.to_vec() })).collect(),
            )]),
        };
        let mut all = one(&[(1, 0, &[[0, 0]]), (2, 3, &[[3, 0]])]);
        all.merge(one(&[(1, 0, &[[0, 0]]), (2, 1, &[[0, 1]])]));
        assert_eq!((all.sum(), all.decisions()), ((1, 2), (1, 2)));
        let branches = "BRDA:1,0,0,-\nBRDA:1,0,1,-\nBRDA:2,0,0,3\nBRDA:2,0,1,1\nBRF:4\nBRH:2\n";
        assert_eq!(all.lcov(), format!("TN:\nSF:a.awl\n{branches}DA:1,0\nDA:2,4\nLF:2\nLH:1\nend_of_record\n"));
    }
}
