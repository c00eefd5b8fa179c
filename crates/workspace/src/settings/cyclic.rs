//! `[cyclic.35]` in `sieben.toml`: interval and phase offset of cyclic interrupts.

use sieben_cpu::CyclicInterrupt;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use toml::de::{DeTable, DeValue};

use super::{Reader, Value};

const FIRST: u16 = CyclicInterrupt::FIRST;
const LAST: u16 = CyclicInterrupt::LAST;

impl Reader {
    /// One table per organization block, by its number.
    pub(super) fn cyclic(&mut self, content: &DeTable<'_>) {
        for (key, value) in content {
            let name: &str = key.get_ref();
            let Some((number, usual)) = name.parse().ok().and_then(|number| Some((number, CyclicInterrupt::usual(number)?))) else {
                let message = format!(
                    "`{name}` is no cyclic interrupt: write `[cyclic.{FIRST}]` to `[cyclic.{LAST}]`, the number of the organization block"
                );
                self.diagnostics.push(Diagnostic::new(Problem::P6008, self.span(key.span()), message));
                continue;
            };
            match value.get_ref() {
                DeValue::Table(inner) => {
                    let setting = self.cyclic_interrupt(number, usual, inner);
                    self.settings.cyclic.insert(number, setting);
                }
                _ => self.wrong(value, &format!("write `[cyclic.{number}]` on a line of its own, and `interval = \"100ms\"` below")),
            }
        }
    }

    fn cyclic_interrupt(&mut self, number: u16, usual: CyclicInterrupt, content: &DeTable<'_>) -> CyclicInterrupt {
        let mut setting = usual;
        for (key, value) in content {
            match key.get_ref().as_ref() {
                "interval" => setting.interval_ms = self.milliseconds(value, "interval", 1).unwrap_or(setting.interval_ms),
                "phase" => setting.phase_ms = self.milliseconds(value, "phase", 0).unwrap_or(setting.phase_ms),
                name => {
                    let diagnostic =
                        Diagnostic::new(Problem::P6008, self.span(key.span()), format!("there is no key `{name}` in `[cyclic.{number}]`"));
                    self.diagnostics.push(diagnostic.help("keys: `interval` and `phase`"));
                }
            }
        }
        setting
    }

    /// A time of a cyclic interrupt, in whole milliseconds.
    fn milliseconds(&mut self, value: &Value<'_>, name: &str, least: u16) -> Option<u16> {
        let duration = self.duration(value, name)?;
        let ms = u16::try_from(duration.as_millis()).ok().filter(|ms| (least..=CyclicInterrupt::MS_MAX).contains(ms));
        if ms.is_none() || duration.subsec_nanos() % 1_000_000 != 0 {
            self.wrong(
                value,
                &format!("`{name}` of a cyclic interrupt is {least} ms to 60 s, in whole milliseconds: `{name} = \"100ms\"`"),
            );
            return None;
        }
        ms
    }
}
