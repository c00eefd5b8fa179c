//! By how much a run may differ from what a scenario says that always is, as its lines `allow` say it.

use std::fmt;

use super::parse::{duration, name_list};
use super::rules::{Rules, Tolerance};
use super::spelling;

/// What its lines `allow` say.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Allowed {
    /// A value may come so much earlier or later, in microseconds.
    pub within_us: u64,
    /// By so much a number may be off.
    pub tolerance: Option<Tolerance>,
    /// These names are not compared.
    pub ignored: Vec<String>,
}

impl Allowed {
    /// Takes in `within 20ms`, `tolerance 2%` or `ignore Lamp Horn`.
    pub(super) fn line(&mut self, rest: &str) -> Result<(), String> {
        match rest.split_once(char::is_whitespace).unwrap_or((rest, "")) {
            ("within", time) => self.within_us = duration(time.trim())?,
            ("tolerance", number) => self.tolerance = Some(Tolerance::parse(number)?),
            ("ignore", names) if !names.trim().is_empty() => self.ignored.extend(name_list(names)),
            _ => {
                return Err(format!(
                    "`allow {rest}` is not understood; write `allow within 20ms`, `allow tolerance 2%` or `allow ignore Lamp Horn`"
                ));
            }
        }
        Ok(())
    }

    /// The rules with what is allowed here, where they do not allow more.
    pub(super) fn added_to(&self, rules: &Rules, cycle_us: u64) -> Rules {
        let mut rules = rules.clone();
        rules.within = rules.within.max(self.within_us.div_ceil(cycle_us.max(1)));
        if let Some(tolerance) = self.tolerance {
            rules.tolerate_usually(tolerance);
        }
        self.ignored.iter().for_each(|name| rules.ignore(name));
        rules
    }

    /// Whether a name is not compared.
    pub fn ignores(&self, name: &str) -> bool {
        let mut rules = Rules::default();
        self.ignored.iter().for_each(|name| rules.ignore(name));
        rules.is_ignored(name)
    }
}

impl fmt::Display for Allowed {
    /// Its lines.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.within_us > 0 {
            writeln!(f, "allow within {}", spelling::time(self.within_us))?;
        }
        match self.tolerance {
            Some(Tolerance::Absolute(by)) => writeln!(f, "allow tolerance {by}")?,
            Some(Tolerance::Percent(by)) => writeln!(f, "allow tolerance {by}%")?,
            None => {}
        }
        self.ignored.iter().try_for_each(|name| writeln!(f, "allow ignore {}", spelling::name(name)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_allowed_is_added_to_the_rules_and_takes_nothing_away() {
        let mut allowed = Allowed::default();
        for line in ["within 25ms", "tolerance 2", "ignore Lamp \"the horn\""] {
            allowed.line(line).expect(line);
        }
        let mut rules = Rules::default();
        rules.within = 1;
        rules.tolerate(None, Tolerance::Absolute(5.0));
        let both = allowed.added_to(&rules, 10_000);
        assert_eq!((both.within, both.tolerance("x")), (3, Some(Tolerance::Absolute(5.0))));
        assert!(both.is_ignored("lamp") && both.is_ignored("The Horn") && !both.is_ignored("Motor"));
        assert!(allowed.ignores("LAMP") && !allowed.ignores("Motor"));
        rules.within = 9;
        assert_eq!(allowed.added_to(&rules, 10_000).within, 9);
        assert_eq!(allowed.to_string(), "allow within 25ms\nallow tolerance 2\nallow ignore Lamp\nallow ignore \"the horn\"\n");
        for line in ["", "within", "within soon", "tolerance", "tolerance much", "ignore", "ignore ", "more"] {
            assert!(allowed.line(line).is_err(), "{line}");
        }
    }
}
