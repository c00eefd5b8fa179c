//! `[[module]]` in `sieben.toml`: simulated devices, and how they fail.

use std::borrow::Cow;

use sieben_cpu::{IoModule, Rack};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_sim::devices::{DeviceSettings, Kind, Parameter};
use sieben_sim::scenario::PlantLine;
use sieben_sim::wrap::{FAULTS_MAX, Fault, Plant};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{Reader, Value};
use sieben_model::nearest::{nearest, one_of};

/// Keys that every module has, beside the parameters of its kind.
const KEYS: [&str; 6] = ["kind", "name", "input", "output", "seed", "fault"];
/// Most modules of a project: every byte of the largest CPU type could have its own.
const MODULES_MAX: usize = 1000;

/// A simulated device of the project.
#[derive(Clone, Debug, PartialEq)]
pub struct Module {
    /// The device.
    pub device: DeviceSettings,
    /// How it fails.
    pub faults: Vec<Fault>,
    /// Where it is described.
    pub span: Span,
}

impl Module {
    fn plugged(&self) -> Box<dyn IoModule> {
        let mut plant = Plant::new(self.device.clone());
        for fault in &self.faults {
            // Those that do not fit were told when the project was read.
            let _ = plant.inject(fault);
        }
        Box::new(plant)
    }
}

/// The rack of a project: its devices, and a simulated module at every address that they leave free. A project whose modules do not
/// fit together, which [`problems`] tells, has the simulated module alone.
pub fn rack(modules: &[Module], cpu: &CpuType) -> Rack {
    Rack::with_background(cpu, modules.iter().map(Module::plugged).collect()).unwrap_or_else(|_| Rack::simulated(cpu))
}

/// The modules with what a scenario says of plants.
///
/// # Errors
/// There is no such plant, or it has no such parameter or not this value; the message says so.
pub fn with_plants(modules: &[Module], lines: &[PlantLine]) -> Result<Vec<Module>, String> {
    let mut modules = modules.to_vec();
    for line in lines {
        let Some(place) = modules.iter().position(|module| module.device.name == line.module) else {
            return Err(match modules.is_empty() {
                true => format!("the project has no plant `{}`", line.module),
                false => {
                    let names = modules.iter().map(|module| module.device.name.as_str());
                    format!("the project has no plant `{}`; it has {}", line.module, one_of(names))
                }
            });
        };
        let module = &mut modules[place];
        let kind = module.device.kind;
        for (name, value) in &line.parameters {
            let parameter = kind.parameters.iter().position(|parameter| parameter.name == name);
            let Some(index) = parameter else {
                let known = one_of(kind.parameters.iter().map(|parameter| parameter.name));
                return Err(format!("the plant `{}` has no parameter `{name}`; it has {known}", line.module));
            };
            let Parameter { least, most, .. } = kind.parameters[index];
            if !(least..=most).contains(value) {
                return Err(format!("`{name}` of the plant `{}` is a number from {least} to {most}", line.module));
            }
            module.device.parameters[index] = *value;
        }
        module.device.seed = line.seed.unwrap_or(module.device.seed);
    }
    Ok(modules)
}

/// What keeps the modules from being plugged in together on this CPU type.
pub fn problems(modules: &[Module], cpu: &CpuType) -> Vec<Diagnostic> {
    // The rack names the first of them that does not fit.
    (1..=modules.len())
        .find_map(|count| {
            let error = Rack::with_background(cpu, modules[..count].iter().map(Module::plugged).collect()).err()?;
            Some(Diagnostic::new(error.problem(), modules[count - 1].span, error.to_string()))
        })
        .into_iter()
        .collect()
}

impl Reader {
    /// One table per module.
    pub(super) fn modules(&mut self, value: &Value<'_>) {
        let DeValue::Array(tables) = value.get_ref() else {
            return self.wrong(value, "modules are a list: write `[[module]]` in two brackets on a line of its own, and its keys below");
        };
        for table in tables {
            match table.get_ref() {
                DeValue::Table(inner) if self.settings.modules.len() < MODULES_MAX => self.module(table.span(), inner),
                DeValue::Table(_) => return self.wrong(table, &format!("a project has at most {MODULES_MAX} modules")),
                _ => self.wrong(table, "a module is a table: write `[[module]]` on a line of its own, and its keys below"),
            }
        }
    }

    fn module(&mut self, place: std::ops::Range<usize>, content: &DeTable<'_>) {
        let span = self.span(place);
        let kinds = || Kind::ALL.iter().map(|kind| kind.name);
        let Some((_, value)) = content.iter().find(|(key, _)| key.get_ref() == "kind") else {
            let message = format!("a module needs its kind: `kind = \"tank\"`; there are {}", one_of(kinds()));
            return self.diagnostics.push(Diagnostic::new(Problem::P6270, span, message));
        };
        let Some(placed) = self.text(value, "kind") else { return };
        let Some(kind) = Kind::by_name(&placed.text) else {
            let message = format!("there is no kind of module `{}`; there are {}", placed.text, one_of(kinds()));
            let diagnostic = Diagnostic::new(Problem::P6270, placed.span, message);
            return self.diagnostics.push(match nearest(&placed.text, kinds()) {
                Some(near) => {
                    diagnostic.help(format!("did you mean `{near}`?")).guess(placed.span, format!("\"{near}\""), format!("write `{near}`"))
                }
                None => diagnostic,
            });
        };
        let mut device = DeviceSettings::new(kind);
        let mut faults = Vec::new();
        for (key, value) in content {
            match key.get_ref().as_ref() {
                "kind" => {}
                "name" => self.module_name(value, &mut device),
                "input" => device.input = self.whole(value, "input", u64::from(u16::MAX)).map_or(0, |byte| byte as u32),
                "output" => device.output = self.whole(value, "output", u64::from(u16::MAX)).map_or(0, |byte| byte as u32),
                "seed" => device.seed = self.whole(value, "seed", i64::MAX as u64).unwrap_or(1),
                "fault" => faults = self.list_of_faults(value),
                name => match kind.parameters.iter().position(|parameter| parameter.name == name) {
                    Some(index) => {
                        if let Some(number) = self.parameter(value, &kind.parameters[index]) {
                            device.parameters[index] = number;
                        }
                    }
                    None => self.unknown_parameter(key, kind),
                },
            }
        }
        if let Err(message) = device.terminals() {
            self.diagnostics.push(Diagnostic::new(Problem::P6271, span, message));
        }
        if self.settings.modules.iter().any(|other| other.device.name == device.name) {
            let message = format!("two modules are called `{}`: give this one another `name`", device.name);
            self.diagnostics.push(Diagnostic::new(Problem::P6271, span, message));
        }
        // The name may stand behind the faults.
        let faults = faults.into_iter().filter_map(|placed| self.fault(&placed.text, placed.span, &device)).collect();
        self.settings.modules.push(Module { device, faults, span });
    }

    fn unknown_parameter(&mut self, key: &Spanned<Cow<'_, str>>, kind: &'static Kind) {
        let name: &str = key.get_ref();
        let span = self.span(key.span());
        let known = || KEYS.into_iter().chain(kind.parameters.iter().map(|parameter| parameter.name));
        let diagnostic = Diagnostic::new(Problem::P6008, span, format!("a module of the kind `{}` has no key `{name}`", kind.name));
        self.diagnostics.push(match nearest(name, known()) {
            Some(near) => diagnostic.help(format!("did you mean `{near}`?")).guess(span, near, format!("write `{near}`")),
            None => diagnostic.help(format!("keys: {}", one_of(known()))),
        });
    }

    fn module_name(&mut self, value: &Value<'_>, device: &mut DeviceSettings) {
        let Some(placed) = self.text(value, "name") else { return };
        let good = !placed.text.is_empty() && placed.text.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '-');
        match good {
            true => device.name = placed.text,
            // Faults are written as `name.signal kind`.
            false => self.wrong(value, &format!("`{}` cannot be the name of a module: use letters, digits, `-` and `_`", placed.text)),
        }
    }

    /// A whole number from 0.
    fn whole(&mut self, value: &Value<'_>, name: &str, most: u64) -> Option<u64> {
        let number = match value.get_ref() {
            DeValue::Integer(integer) => u64::from_str_radix(integer.as_str(), integer.radix()).ok().filter(|&number| number <= most),
            _ => None,
        };
        if number.is_none() {
            self.wrong(value, &format!("`{name}` is a whole number from 0 to {most}: `{name} = 4`"));
        }
        number
    }

    fn parameter(&mut self, value: &Value<'_>, parameter: &Parameter) -> Option<f64> {
        let number = match value.get_ref() {
            DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix()).ok().map(|number| number as f64),
            DeValue::Float(float) => float.as_str().parse().ok(),
            _ => None,
        };
        let Parameter { name, usual, least, most, unit, about } = parameter;
        let number = number.filter(|number| (*least..=*most).contains(number));
        if number.is_none() {
            let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            let message = format!("`{name}` ({about}) is a number from {least} to {most}{unit}: `{name} = {usual}`");
            self.diagnostics.push(Diagnostic::new(Problem::P6271, self.span(value.span()), message));
        }
        number
    }

    /// One fault, or a list of them.
    fn list_of_faults(&mut self, value: &Value<'_>) -> Vec<super::Placed> {
        let faults = match value.get_ref() {
            DeValue::String(_) => self.text(value, "fault").into_iter().collect(),
            DeValue::Array(items) => items.iter().filter_map(|item| self.text(item, "fault")).collect(),
            _ => {
                self.wrong(value, "`fault` says how the module fails: `fault = \"level stuck@30s\"`, or a list of such texts");
                Vec::new()
            }
        };
        if faults.len() > FAULTS_MAX {
            self.wrong(value, &format!("a module has at most {FAULTS_MAX} faults"));
            return Vec::new();
        }
        faults
    }

    fn fault(&mut self, text: &str, span: Span, device: &DeviceSettings) -> Option<Fault> {
        let fault = Fault::parse_for(&device.name, text).and_then(|fault| {
            // Terminals that do not go together are reported where the module is read.
            let terminals = device.terminals().or_else(|_| DeviceSettings::new(device.kind).terminals())?;
            fault.fits(device.kind, &terminals.signals).map(|_| fault)
        });
        match fault {
            Ok(fault) => Some(fault),
            Err(message) => {
                self.diagnostics.push(Diagnostic::new(Problem::P6272, span, message));
                None
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use sieben_model::source::FileId;

    use super::super::parse;
    use super::*;

    fn messages(text: &str) -> Vec<String> {
        let (settings, mut diagnostics) = parse(text, FileId(0));
        diagnostics.extend(problems(&settings.modules, &CpuType::ALL[0]));
        diagnostics.into_iter().map(|diagnostic| format!("{}: {}", diagnostic.problem.code(), diagnostic.message)).collect()
    }

    #[test]
    fn modules_are_read() {
        let (settings, diagnostics) = parse(
            "[[module]]\nkind = \"tank\"\nname = \"T1\"\ninput = 4\noutput = 0x08\nseed = 7\nlevel = 55.5\nvolume = 100\nfault = \"level stuck@30s\"\n\
             [[module]]\nkind = \"thermal\"\ninput = 256\noutput = 256\nfault = [\"temperature drift=0.1\", \"thermal.fan stuck=0\"]\n",
            FileId(0),
        );
        assert_eq!(diagnostics, []);
        let [tank, thermal] = settings.modules.as_slice() else { panic!("two modules") };
        assert_eq!((tank.device.name.as_str(), tank.device.input, tank.device.output, tank.device.seed), ("T1", 4, 8, 7));
        assert_eq!((tank.device.parameters[0], tank.device.parameters[3], tank.faults.len()), (100.0, 55.5, 1));
        assert_eq!((thermal.device.name.as_str(), thermal.faults.len()), ("thermal", 2));
        let rack = rack(&settings.modules, &CpuType::ALL[0]);
        assert_eq!(rack.modules().map(IoModule::name).collect::<Vec<_>>(), ["simulated", "T1", "thermal"]);
    }

    #[test]
    fn every_mistake_has_a_sentence() {
        let kinds = "`conveyor`, `dosing`, `elevator`, `junction`, `motor`, `panel`, `tank` or `thermal`";
        for (text, expected) in [
            (
                "[module]\nkind = \"tank\"\n",
                "P6009: modules are a list: write `[[module]]` in two brackets on a line of its own, and its keys below".to_owned(),
            ),
            ("module = [1]\n", "P6009: a module is a table: write `[[module]]` on a line of its own, and its keys below".to_owned()),
            ("[[module]]\ninput = 0\n", format!("P6270: a module needs its kind: `kind = \"tank\"`; there are {kinds}")),
            ("[[module]]\nkind = \"tanc\"\n", format!("P6270: there is no kind of module `tanc`; there are {kinds}")),
            ("[[module]]\nkind = \"tank\"\nlevle = 5\n", "P6008: a module of the kind `tank` has no key `levle`".to_owned()),
            (
                "[[module]]\nkind = \"tank\"\nlevel = 101\n",
                "P6271: `level` (level at the beginning) is a number from 0 to 100 %: `level = 20`".to_owned(),
            ),
            (
                "[[module]]\nkind = \"tank\"\nlevel = nan\n",
                "P6271: `level` (level at the beginning) is a number from 0 to 100 %: `level = 20`".to_owned(),
            ),
            ("[[module]]\nkind = \"tank\"\ninput = -1\n", "P6009: `input` is a whole number from 0 to 65535: `input = 4`".to_owned()),
            (
                "[[module]]\nkind = \"tank\"\nname = \"a.b\"\n",
                "P6009: `a.b` cannot be the name of a module: use letters, digits, `-` and `_`".to_owned(),
            ),
            (
                "[[module]]\nkind = \"tank\"\nfault = 5\n",
                "P6009: `fault` says how the module fails: `fault = \"level stuck@30s\"`, or a list of such texts".to_owned(),
            ),
            (
                "[[module]]\nkind = \"tank\"\nfault = \"low drift=1\"\n",
                "P6272: `low` is a bit and cannot drift; it can be stuck, late, or bounce".to_owned(),
            ),
            (
                "[[module]]\nkind = \"tank\"\n[[module]]\nkind = \"tank\"\ninput = 4\noutput = 4\n",
                "P6271: two modules are called `tank`: give this one another `name`".to_owned(),
            ),
            (
                "[[module]]\nkind = \"panel\"\nlamps = 10\n",
                "P6271: `lamps` and `display` of the panel both use QB 12: give one of them another byte".to_owned(),
            ),
            (
                "[[module]]\nkind = \"panel\"\n[[module]]\nkind = \"tank\"\ninput = 20\noutput = 8\n",
                "P8002: the modules `panel` and `tank` both use `PQB 8`; every byte belongs to at most one module".to_owned(),
            ),
            (
                "[[module]]\nkind = \"tank\"\n[[module]]\nkind = \"motor\"\noutput = 4\n",
                "P8002: the modules `tank` and `motor` both use `PIB 0`; every byte belongs to at most one module".to_owned(),
            ),
            (
                "[[module]]\nkind = \"tank\"\ninput = 2046\n",
                "P8003: the module `tank` reaches to byte 2049, the CPU type has bytes 0 to 2047".to_owned(),
            ),
        ] {
            assert_eq!(messages(text), [expected], "{text}");
        }
    }
}
