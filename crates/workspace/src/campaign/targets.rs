//! What the names of a campaign mean: values of the program, and parameters of plants.

use sieben_campaign::spec::{Exhaustive, Placed, Value};
use sieben_model::address::{Address, Operand, Width};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::problems::Problem;
use sieben_sim::devices::Parameter;
use sieben_sim::names::{Name, Setting};

use crate::project::Build;
use sieben_model::nearest::{nearest, one_of};

/// Where a value of a campaign goes.
#[derive(Clone, Debug)]
pub enum Target {
    /// Into the program, or to an input.
    Name(Name),
    /// Into a plant, before it begins: the number of its module and that of the parameter.
    Plant(usize, usize),
}

impl Target {
    /// What a name means: a parameter, where a plant of the project is called so, else something of the program.
    ///
    /// # Errors
    /// Nothing is called that.
    pub fn of(name: &Placed, build: &Build) -> Result<Self, Box<Diagnostic>> {
        let modules = &build.project.settings.modules;
        let error = match Name::parse(&name.text, &build.project.symbols, &build.compiled.program) {
            Err(error) => error.to_string(),
            // A register is gone when a scan begins.
            Ok(parsed) if parsed.is_register() => format!("`{}` is a register, which a scan begins without", name.text),
            Ok(parsed) => return Ok(Self::Name(parsed)),
        };
        let plant = name.text.split_once('.').and_then(|(plant, parameter)| {
            let index = modules.iter().position(|module| module.device.name == plant.trim().trim_matches('"'))?;
            Some((index, parameter.trim()))
        });
        let Some((index, parameter)) = plant else { return Err(Box::new(Diagnostic::new(Problem::P7161, name.span, error))) };
        let kind = modules[index].device.kind;
        let names = || kind.parameters.iter().map(|parameter| parameter.name);
        match names().position(|known| known == parameter) {
            Some(place) => Ok(Self::Plant(index, place)),
            None => {
                let message = format!("the plant `{}` ({}) has no parameter `{parameter}`", modules[index].device.name, kind.name);
                let diagnostic = Diagnostic::new(Problem::P7161, name.span, message);
                Err(Box::new(match nearest(parameter, names()) {
                    Some(near) => diagnostic.help(format!("did you mean `{near}`?")),
                    None => diagnostic.help(format!("it has {}", one_of(names()))),
                }))
            }
        }
    }

    /// The parameter that it is, if it is one.
    pub fn parameter(&self, build: &Build) -> Option<&'static Parameter> {
        match self {
            Self::Name(_) => None,
            Self::Plant(module, parameter) => build.project.settings.modules[*module].device.kind.parameters.get(*parameter),
        }
    }
}

/// How a number becomes the value of a name that has whole numbers only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// To the nearest.
    Nearest,
    /// Not at all: it is refused.
    Never,
}

/// The value as it goes to a name of the program.
///
/// # Errors
/// It does not fit; the message says so.
pub fn setting(name: &Name, value: &Value, rounding: Rounding) -> Result<Setting, String> {
    let told = |error: sieben_sim::names::NameError| error.to_string();
    match value {
        Value::Boolean(value) => Setting::new(name.clone(), if *value { "1" } else { "0" }).map_err(told),
        Value::Text(text) => Setting::new(name.clone(), text).map_err(told),
        Value::Number(number) => {
            // As a REAL, and where that is none, as a whole number.
            let as_real = Setting::new(name.clone(), &format!("{number:?}"));
            match as_real {
                Ok(setting) => Ok(setting),
                Err(error) if rounding == Rounding::Never && number.fract() != 0.0 => Err(told(error)),
                Err(_) => Setting::new(name.clone(), &format!("{:.0}", number.round())).map_err(told),
            }
        }
    }
}

/// A number for a parameter of a plant.
///
/// # Errors
/// It is none, or out of range; the message says so.
pub fn parameter(parameter: &Parameter, value: &Value) -> Result<f64, String> {
    let Parameter { name, least, most, unit, .. } = parameter;
    let number = match value {
        Value::Number(number) => Some(*number),
        Value::Boolean(_) => None,
        Value::Text(text) => text.parse().ok(),
    };
    number.filter(|number| (*least..=*most).contains(number)).ok_or_else(|| {
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        format!("`{name}` is a number from {least} to {most}{unit}")
    })
}

/// The bits of `[exhaustive]`, the first of the number first; a range stands for each of its bits.
///
/// # Errors
/// A name is nothing that the program has, or no bit.
pub fn bits(exhaustive: &Exhaustive, build: &Build) -> Result<Vec<Name>, Vec<Diagnostic>> {
    let mut all = Vec::new();
    let mut wrong = Vec::new();
    for placed in &exhaustive.inputs {
        let found = match placed.text.split_once("..") {
            Some((first, last)) => range(placed, first, last),
            None => match Target::of(placed, build) {
                Ok(Target::Name(name)) if name.item().width() == 1 => Ok(vec![name]),
                Ok(_) => {
                    let told = Diagnostic::new(Problem::P7162, placed.span, format!("`{}` is no bit", placed.text));
                    Err(Box::new(told.help("every combination is one of bits; numbers go through a `[sweep]`")))
                }
                Err(diagnostic) => Err(diagnostic),
            },
        };
        match found {
            Ok(names) => all.extend(names),
            Err(diagnostic) => wrong.push(*diagnostic),
        }
    }
    if wrong.is_empty() { Ok(all) } else { Err(wrong) }
}

/// Most bits that a range may stand for: with more there is no end.
const RANGE_MAX: u32 = 64;

/// `I 0.0..I 1.3`.
fn range(placed: &Placed, first: &str, last: &str) -> Result<Vec<Name>, Box<Diagnostic>> {
    let wrong = |message: String| {
        Box::new(Diagnostic::new(Problem::P7162, placed.span, message).help("write the first and the last bit: `I 0.0..I 1.3`"))
    };
    let bit = |text: &str| match Operand::parse(text.trim()) {
        Some(Operand::Address(address)) if address.width == Width::Bit => Ok(address),
        _ => Err(wrong(format!("`{}` is no address of a bit", text.trim()))),
    };
    let (first, last) = (bit(first)?, bit(last)?);
    let number = |address: Address| address.byte.saturating_mul(8).saturating_add(u32::from(address.bit));
    let (from, to) = (number(first), number(last));
    if first.area != last.area || to < from || to - from >= RANGE_MAX {
        return Err(wrong(format!("`{}` is no range of up to {RANGE_MAX} bits of one area", placed.text)));
    }
    let name = |bit: u32| {
        let operand = Operand::Address(Address { byte: bit / 8, bit: (bit % 8) as u8, ..first });
        Name::at(operand.spell(Mnemonics::English), operand, None)
    };
    Ok((from..=to).map(name).collect())
}
