//! A fault as people write it: `tank.level stuck@30s`, `tank.level drift=0.5@10s..40s`.

use std::fmt;

use crate::duration;

/// A signal fails.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// The module, as the project calls it.
    pub module: String,
    /// The signal of the module.
    pub signal: String,
    /// How it fails.
    pub kind: FaultKind,
    /// When it begins; without, it begins at once.
    pub from_us: Option<u64>,
    /// When it ends; without, it stays.
    pub until_us: Option<u64>,
}

/// How a signal fails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FaultKind {
    /// It keeps a value: this one, in its unit, or that which it has at the beginning.
    Stuck(Option<f64>),
    /// It goes away from the truth by so many of its units per second.
    Drift(f64),
    /// It comes so many microseconds late.
    Late(u64),
    /// After a change it is now 0, now 1, for so many microseconds.
    Bounce(u64),
}

/// Greatest number of a fault: far beyond what a word holds, and finite.
const NUMBER_MAX: f64 = 1e9;

impl Fault {
    /// Reads `MODULE.SIGNAL KIND[=VALUE][@BEGIN[..END]]`.
    ///
    /// # Errors
    /// It is not understood; the message shows how to write it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let (name, rest) = text.trim().split_once(char::is_whitespace).ok_or_else(|| not_understood(text))?;
        let (module, signal) = name.split_once('.').ok_or_else(|| not_understood(text))?;
        Self::of_signal(module, signal, rest)
    }

    /// Reads `SIGNAL KIND[=VALUE][@BEGIN[..END]]` of a module that is known.
    ///
    /// # Errors
    /// It is not understood; the message shows how to write it.
    pub fn parse_for(module: &str, text: &str) -> Result<Self, String> {
        let (signal, rest) = text.trim().split_once(char::is_whitespace).ok_or_else(|| not_understood(text))?;
        // The name of the module in front does no harm.
        let signal = signal.strip_prefix(module).and_then(|rest| rest.strip_prefix('.')).unwrap_or(signal);
        Self::of_signal(module, signal, rest)
    }

    fn of_signal(module: &str, signal: &str, rest: &str) -> Result<Self, String> {
        if module.is_empty() || signal.is_empty() {
            return Err(not_understood(&format!("{module}.{signal} {rest}")));
        }
        let (how, when) = rest.split_once('@').map_or((rest, None), |(how, when)| (how, Some(when)));
        let (word, value) = how.split_once('=').map_or((how, None), |(word, value)| (word, Some(value.trim())));
        let number = |text: &str| {
            let number = text.parse::<f64>().ok().filter(|number| number.abs() <= NUMBER_MAX);
            number.ok_or_else(|| format!("`{text}` is no number from -1000000000 to 1000000000"))
        };
        let time = |text: &str| duration::parse(text).map(|time| time.as_micros() as u64);
        let kind = match (word.trim(), value) {
            ("stuck", value) => FaultKind::Stuck(value.map(number).transpose()?),
            ("drift", Some(value)) => FaultKind::Drift(number(value)?),
            ("drift", None) => return Err("say how fast it drifts, in its unit per second: `drift=0.5`".to_owned()),
            ("late", Some(value)) => FaultKind::Late(time(value)?),
            ("late", None) => return Err("say how late it comes: `late=200ms`".to_owned()),
            ("bounce", Some(value)) => FaultKind::Bounce(time(value)?),
            ("bounce", None) => return Err("say how long it bounces: `bounce=50ms`".to_owned()),
            (word, _) => return Err(format!("`{word}` is no fault; write `stuck`, `stuck=1`, `drift=0.5`, `late=200ms` or `bounce=50ms`")),
        };
        let (from_us, until_us) = match when {
            None => (None, None),
            Some(when) => match when.split_once("..") {
                None => (Some(time(when)?), None),
                Some((from, until)) => (Some(time(from)?), Some(time(until)?)),
            },
        };
        if let (Some(from), Some(until)) = (from_us, until_us)
            && until <= from
        {
            return Err(format!("the fault ends before it begins: `@{}`", when.unwrap_or_default().trim()));
        }
        Ok(Self { module: module.to_owned(), signal: signal.to_owned(), kind, from_us, until_us })
    }
}

/// A time as it is read again, in the largest unit that it is a whole number of.
fn time_text(us: u64) -> String {
    match us {
        0 => "0".to_owned(),
        us if us.is_multiple_of(1_000_000) => format!("{}s", us / 1_000_000),
        us if us.is_multiple_of(1_000) => format!("{}ms", us / 1_000),
        us => format!("{us}us"),
    }
}

impl fmt::Display for FaultKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stuck(None) => f.write_str("stuck"),
            Self::Stuck(Some(value)) => write!(f, "stuck={value}"),
            Self::Drift(per_second) => write!(f, "drift={per_second}"),
            Self::Late(us) => write!(f, "late={}", time_text(*us)),
            Self::Bounce(us) => write!(f, "bounce={}", time_text(*us)),
        }
    }
}

impl Fault {
    /// How the signal fails, and when: `drift=0.2@61.3s..80s`.
    pub fn how(&self) -> String {
        let from = self.from_us.map_or_else(String::new, |from| format!("@{}", time_text(from)));
        let until = self.until_us.map_or_else(String::new, |until| format!("..{}", time_text(until)));
        format!("{}{from}{until}", self.kind)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{} {}", self.module, self.signal, self.how())
    }
}

fn not_understood(text: &str) -> String {
    format!(
        "`{}` is no fault; write the plant, its signal and how it fails: `tank.level stuck@30s` or `tank.low bounce=50ms@10s..20s`",
        text.trim()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_read() {
        let fault = |text| Fault::parse(text).map(|fault| (fault.signal, fault.kind, fault.from_us, fault.until_us));
        let level = || "level".to_owned();
        assert_eq!(fault("tank.level stuck"), Ok((level(), FaultKind::Stuck(None), None, None)));
        assert_eq!(fault(" tank.level  stuck=-5 @ 30s"), Ok((level(), FaultKind::Stuck(Some(-5.0)), Some(30_000_000), None)));
        assert_eq!(fault("tank.level drift=-0.5@0..1m"), Ok((level(), FaultKind::Drift(-0.5), Some(0), Some(60_000_000))));
        assert_eq!(fault("tank.level late=200ms"), Ok((level(), FaultKind::Late(200_000), None, None)));
        assert_eq!(fault("tank.level bounce=50ms@1s..2s"), Ok((level(), FaultKind::Bounce(50_000), Some(1_000_000), Some(2_000_000))));
        assert_eq!(Fault::parse_for("tank", "tank.level stuck"), Fault::parse_for("tank", "level stuck"));
    }

    #[test]
    fn a_fault_is_written_as_it_is_read() {
        for text in [
            "tank.level stuck",
            "tank.level stuck=-5@30s",
            "tank.level drift=-0.5@0..60s",
            "tank.level late=200ms",
            "tank.low bounce=50ms@1500us..2s",
        ] {
            assert_eq!(Fault::parse(text).map(|fault| fault.to_string()).as_deref(), Ok(text));
        }
    }

    #[test]
    fn everything_else_is_refused() {
        for (text, word) in [
            ("", "write the plant"),
            ("tank.level", "write the plant"),
            ("level stuck", "write the plant"),
            (".level stuck", "write the plant"),
            ("tank. stuck", "write the plant"),
            ("tank.level broken", "`broken` is no fault"),
            ("tank.level stuck=high", "no number"),
            ("tank.level drift", "how fast"),
            ("tank.level drift=inf", "no number"),
            ("tank.level drift=nan", "no number"),
            ("tank.level late", "how late"),
            ("tank.level late=5", "duration"),
            ("tank.level bounce", "how long"),
            ("tank.level stuck@", "duration"),
            ("tank.level stuck@9s..3s", "ends before"),
        ] {
            let error = Fault::parse(text).expect_err(text);
            assert!(error.contains(word), "{text}: {error}");
        }
    }
}
