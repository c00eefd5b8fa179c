//! A scenario as the text that gives it back.

use std::fmt::{self, Write};

use sieben_cpu::{ImageErrors, RetentiveAreas};

use super::spelling::{self, assignments, clock, interrupt, name, time};
use super::{Assignments, CYCLE_US, Command, Scenario};

impl fmt::Display for Scenario {
    /// All lines of its file, without comments.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.head(f)?;
        self.lines.iter().try_for_each(|line| command(f, &line.command))?;
        match self.recorded.as_ref().and_then(|recorded| recorded.end) {
            Some((_, scans)) => writeln!(f, "end {scans}"),
            None => Ok(()),
        }
    }
}

impl Scenario {
    /// What holds for the whole of it.
    fn head(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(recorded) = &self.recorded {
            writeln!(f, "recorded {:016X} \"{}\"", recorded.program, recorded.title)?;
        }
        if let Some(why) = &self.known_gap {
            writeln!(f, "known-gap \"{why}\"")?;
        }
        if let Some(cpu) = self.cpu {
            writeln!(f, "cpu {}", cpu.name)?;
        }
        if self.cycle_us != CYCLE_US {
            writeln!(f, "cycle {}", time(self.cycle_us))?;
        }
        if self.min_cycle_us > 0 {
            writeln!(f, "min-cycle {}", time(self.min_cycle_us))?;
        }
        if self.image_errors != ImageErrors::default() {
            writeln!(f, "image-errors {}", self.image_errors.name())?;
        }
        for (number, cyclic) in &self.cyclic {
            writeln!(f, "cyclic OB {number} {}ms phase {}ms", cyclic.interval_ms, cyclic.phase_ms)?;
        }
        if let Some(RetentiveAreas { bit_memory, timers, counters }) = &self.retain {
            let [m, t, c] = [bit_memory, timers, counters].map(|numbers| numbers.to_string().replace(' ', ""));
            writeln!(f, "retain m={m} t={t} c={c}")?;
        }
        match &self.modules {
            Some(bytes) if bytes.is_empty() => writeln!(f, "modules none")?,
            Some(bytes) => writeln!(f, "modules {}..{}", bytes.start, bytes.end - 1)?,
            None => {}
        }
        for plant in &self.plants {
            write!(f, "plant {}", plant.module)?;
            plant.parameters.iter().try_for_each(|(name, value)| write!(f, " {name}={value}"))?;
            plant.seed.map_or(Ok(()), |seed| write!(f, " seed={seed}"))?;
            writeln!(f)?;
        }
        self.properties.iter().try_for_each(|property| writeln!(f, "{property}"))?;
        write!(f, "{}", self.allowed)?;
        if let Some(start) = self.start {
            writeln!(f, "start {}", start.word())?;
        }
        if !self.start_with.is_empty() {
            writeln!(f, "start with{}", assignments(&self.start_with))?;
        }
        self.clock.map_or(Ok(()), |at| writeln!(f, "clock {}", clock(at)))
    }
}

fn named(values: &Assignments) -> String {
    values.iter().map(|one| format!(" {}={}", name(&one.name), one.value)).collect()
}

fn command(f: &mut dyn Write, command: &Command) -> fmt::Result {
    match command {
        Command::Set(values) => writeln!(f, "set{}", named(values)),
        Command::Force(values) => writeln!(f, "force{}", named(values)),
        Command::Unforce(None) => writeln!(f, "unforce"),
        Command::Unforce(Some(one)) => writeln!(f, "unforce {one}"),
        Command::Scan(count) => writeln!(f, "scan {count}"),
        Command::ScanUntil(end) => writeln!(f, "scan until {}", time(*end)),
        Command::ScanAt(at) => writeln!(f, "scan at {}", time(*at)),
        Command::At(at, values) => writeln!(f, "at {}{}", time(*at), named(values)),
        Command::InterruptAt(at, what) => writeln!(f, "at {} interrupt {}", time(*at), interrupt(what)),
        Command::Always(values) => writeln!(f, "always{}", named(values)),
        Command::Interrupt(what, None) => writeln!(f, "interrupt {}", interrupt(what)),
        Command::Interrupt(what, Some(point)) => writeln!(f, "interrupt {} at safe point {point}", interrupt(what)),
        Command::Restart(restart) => writeln!(f, "restart {}", restart.word()),
        Command::Module(byte, answers) => writeln!(f, "module {byte} {}", if *answers { "answers" } else { "fails" }),
        Command::Fault(fault) => writeln!(f, "fault {fault}"),
        Command::Mend(what) => writeln!(f, "mend {what}"),
        Command::PowerFailure => writeln!(f, "power failure"),
        Command::Expect(values, within) => {
            write!(f, "expect{}", named(values))?;
            within.map_or(Ok(()), |within| write!(f, " within {}", time(within)))?;
            writeln!(f)
        }
        Command::ExpectStop(event) => writeln!(f, "expect stop 16#{event:04X}"),
        Command::ExpectMode(mode) => writeln!(f, "expect mode {mode}"),
        Command::Table { inputs, outputs, rows } => {
            let list = |names: &[String]| names.iter().map(|one| spelling::name(one)).collect::<Vec<_>>().join(" ");
            writeln!(f, "table {} -> {}", list(inputs), list(outputs))?;
            rows.iter().try_for_each(|(_, values)| writeln!(f, "{}", values.join(" ")))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::Line;

    /// As if each line had the number that it has in the text.
    fn numbered(mut scenario: Scenario) -> Scenario {
        let at_end = scenario.recorded.as_mut().and_then(|recorded| recorded.end.as_mut());
        at_end.into_iter().for_each(|end| end.0 = 0);
        scenario.properties.iter_mut().for_each(|property| property.line = 0);
        for (index, Line { number, command }) in scenario.lines.iter_mut().enumerate() {
            *number = index;
            if let Command::Table { rows, .. } = command {
                rows.iter_mut().for_each(|row| row.0 = 0);
            }
        }
        scenario
    }

    #[test]
    fn every_scenario_is_given_back_by_its_text() {
        let all = [
            "cpu 416-3\ncycle 20ms\nmodules 0..3\nset I 0.0=1 MW10 = 16#0102 ACCU1=5\nscan\nscan 3\nscan until 1.5s\nscan at 1510ms\n\
             at 1500001us I 0.0=0 \"my name\"=3\ninterrupt OB 40 at safe point 17\nrestart cold\nexpect Q 0.0=1 T 1=70 STW.RLO=1\n\
             expect Q 4.0=1 within 20ms\nexpect stop 16#2522\nexpect mode run\ntable I 0.0 \"my name\" MW10 -> Q 0.0 STW\n0 1 2 0 000000000\n\
             known-gap \"later\"",
            "property never \"short circuit\" \"K 1\" AND K2\nproperty response \"it starts\" within 2s Start -> Running\n\
             property finally \"it's warm\" (T > 90.0)\nplant oven gain=181.25 noise=0 seed=18446744073709551615\nplant tank level=1e-3\nmodules none\nmin-cycle 50ms\nimage-errors coming\n\
             cyclic OB 35 50ms phase 10ms\nretain m=0..31,40 t=1 c=\nstart cold\nstart with I 0.1=1 PIW256=100\nclock DT#2026-11-22-09:30:00\n\
             force I 0.0=1 Q 4.0=0\nunforce I 0.0\nunforce\nfault tank.level stuck=50@10s..20s\nmend tank.level\nmodule 4 fails\npower failure\n\
             interrupt OB 40\nat 310ms interrupt OB 82 EVENT=16#3942 ID=16#0000 INFO1=16#0004 INFO2=16#00000000\nalways Q 0.0=1 MW 4=7\nscan",
            "recorded 0123456789ABCDEF \"main.awl\"\nallow within 1500us\nallow tolerance 0.5%\nallow ignore Lamp \"my name\"\nscan 2\nend 2\n",
        ];
        for text in all {
            let scenario = Scenario::parse(text).expect("a scenario");
            let written = scenario.to_string();
            let again = Scenario::parse(&written).unwrap_or_else(|errors| panic!("{errors:?}\n{written}"));
            assert_eq!(numbered(again), numbered(scenario), "{written}");
        }
    }

    #[test]
    fn a_plant_line_says_how_it_is_written() {
        for text in ["plant oven", "plant oven gain", "plant oven gain=hot", "plant oven gain=inf", "plant oven seed=-1", "plant"] {
            let errors = Scenario::parse(text).expect_err(text);
            assert!(errors[0].message.contains("oven gain=181.3") || errors[0].message.contains("is no "), "{errors:?}");
        }
    }
}
