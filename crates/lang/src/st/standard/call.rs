//! The arguments of a call of a standard function: which belongs to which parameter, and what is wrong with them.

use sieben_model::problems::Problem;
use sieben_model::types::DataType;

use super::generic::{Group, common, scalar_of, takes, type_of};
use super::{Build, Building, Given, GivenKind, Meaning, Parameter, Refusal, Resolved};
use crate::st::dialect::Dialect;
use crate::st::tree::{Scalar, Value};

/// Arguments that a function of any number of them takes at most.
const ARGUMENTS_MAX: usize = 256;

/// A call.
pub(crate) struct Call<'a> {
    /// The name in capital letters.
    pub(crate) name: &'a str,
    /// The dialect of the caller.
    pub(crate) dialect: Dialect,
    /// The arguments.
    pub(crate) arguments: &'a [Given<'a>],
}

/// What comes of a call.
pub(crate) type Answer = Option<Result<Resolved, Refusal>>;

impl<'a> Call<'a> {
    /// The arguments in the order of the parameters: all of them have to be there.
    pub(crate) fn bind(&self, names: &[&str]) -> Result<Vec<&'a Given<'a>>, Refusal> {
        let given = self.order(names, names.len())?;
        Ok(given.into_iter().map(|(_, given)| given).collect())
    }

    /// The arguments of a function with any number of them: those with names of their own first, then `stem` with numbers from `from`.
    pub(crate) fn bind_list(
        &self,
        leading: &[&str],
        stem: &str,
        from: usize,
        least: usize,
    ) -> Result<Vec<(String, &'a Given<'a>)>, Refusal> {
        let most = leading.len() + self.arguments.len().max(least).min(ARGUMENTS_MAX);
        let names: Vec<String> =
            leading.iter().map(ToString::to_string).chain((from..from + most).map(|number| format!("{stem}{number}"))).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let bound = self.order(&names, leading.len() + least)?;
        for (place, (name, _)) in bound.iter().enumerate() {
            if *name != names[place] {
                let message = format!("`{}` is called with `{name}`, but without `{}`", self.name, names[place]);
                return Err(self.refuse(Problem::P3010, None, message, "number the inputs without a gap"));
            }
        }
        Ok(bound)
    }

    /// The arguments with the names of their parameters, in the order of `names`, of which the first `needed` must be there.
    pub(crate) fn order(&self, names: &[&str], needed: usize) -> Result<Vec<(String, &'a Given<'a>)>, Refusal> {
        let mut slots: Vec<Option<&Given<'_>>> = vec![None; names.len()];
        for (index, given) in self.arguments.iter().enumerate() {
            let slot = match given.name {
                Some(name) => names.iter().position(|one| one.eq_ignore_ascii_case(name)),
                None => (index < names.len()).then_some(index),
            };
            let Some(slot) = slot else {
                let list = names.iter().take(needed.max(4)).map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
                let message = match given.name {
                    Some(name) => format!("`{}` has no input `{name}`; it has {list}", self.name),
                    None => format!("`{}` takes {}, not {}", self.name, count(names.len()), self.arguments.len()),
                };
                return Err(self.refuse(Problem::P3009, Some(index), message, "use the inputs of the function"));
            };
            if slots[slot].replace(given).is_some() {
                let message = format!("`{}` of `{}` is given twice", names[slot], self.name);
                return Err(self.refuse(Problem::P3011, Some(index), message, "remove one of the two"));
            }
        }
        if let Some(missing) = slots.iter().take(needed).position(Option::is_none) {
            let message = format!("`{}` is called without `{}`; it takes {}", self.name, names[missing], count(needed));
            return Err(self.refuse(Problem::P3010, None, message, "give every input a value"));
        }
        Ok(names.iter().zip(slots).filter_map(|(name, slot)| Some(((*name).to_owned(), slot?))).collect())
    }

    /// The one type of the arguments, if it is in the group.
    pub(crate) fn common(&self, arguments: &[&Given<'_>], group: Group) -> Result<DataType, Refusal> {
        for given in arguments {
            if let GivenKind::Typed(data_type) = &given.kind
                && !group.has(data_type, self.dialect)
            {
                return Err(self.wrong(given, group.words()));
            }
        }
        match common(arguments, self.dialect) {
            Some(data_type) if group.has(&data_type, self.dialect) => Ok(data_type),
            Some(_) => Err(self.wrong(arguments[0], group.words())),
            None => {
                let message = format!("the inputs of `{}` have no type in common", self.name);
                Err(self.refuse(Problem::P4011, None, message, "convert them to one type"))
            }
        }
    }

    /// REAL or LREAL for the argument of a function that computes with them.
    pub(crate) fn real(&self, arguments: &[&Given<'_>]) -> Result<DataType, Refusal> {
        let data_type = self.common(arguments, Group::Reals)?;
        let long = match scalar_of(&data_type, self.dialect) {
            Some(Scalar::F64) => true,
            // As the implicit conversion: only where REAL would lose digits.
            Some(Scalar::I32 | Scalar::U32 | Scalar::I64 | Scalar::U64) => {
                common(
                    &[
                        &Given { name: None, kind: GivenKind::Typed(data_type) },
                        &Given { name: None, kind: GivenKind::Typed(DataType::Real) },
                    ],
                    self.dialect,
                ) == Some(DataType::LongReal)
            }
            _ => false,
        };
        Ok(if long { DataType::LongReal } else { DataType::Real })
    }

    /// The type of an argument that must be one of a group by itself; a number without a type is `otherwise` if it fits.
    pub(crate) fn own(&self, given: &Given<'_>, group: Group, otherwise: &DataType) -> Result<DataType, Refusal> {
        let data_type = match &given.kind {
            GivenKind::Typed(data_type) => data_type.base().clone(),
            _ if takes(otherwise, given, self.dialect) => otherwise.clone(),
            _ => type_of(given).ok_or_else(|| self.wrong(given, group.words()))?,
        };
        if group.has(&data_type, self.dialect) { Ok(data_type) } else { Err(self.wrong(given, group.words())) }
    }

    /// An argument of a type that the function does not take.
    pub(crate) fn wrong(&self, given: &Given<'_>, takes: &str) -> Refusal {
        let index = self.arguments.iter().position(|one| std::ptr::eq(one, given));
        let what = match &given.kind {
            GivenKind::Typed(data_type) => self.dialect.type_words(data_type),
            GivenKind::Integer { .. } => "a whole number".to_owned(),
            GivenKind::Real => "a number with a point".to_owned(),
            GivenKind::Unknown => "something without a type".to_owned(),
        };
        let message = format!("`{}` takes {takes} here, not {what}", self.name);
        self.refuse(Problem::P4011, index, message, "convert the value first")
    }

    /// A call that is refused.
    pub(crate) fn refuse(&self, problem: Problem, argument: Option<usize>, message: String, help: &str) -> Refusal {
        let mut characters = help.chars();
        let help = characters.next().map(|first| first.to_uppercase().collect::<String>() + characters.as_str() + ".").unwrap_or_default();
        Refusal { problem, argument, message, help }
    }

    /// The kind of a type that was found to have one.
    pub(crate) fn scalar(&self, data_type: &DataType) -> Scalar {
        scalar_of(data_type, self.dialect).unwrap_or(Scalar::U64)
    }
}

fn count(number: usize) -> String {
    match number {
        1 => "one input".to_owned(),
        _ => format!("{number} inputs"),
    }
}

/// A function that is composed of operations.
pub(crate) fn built(
    parameters: Vec<(&str, DataType)>,
    result: DataType,
    build: impl Fn(Vec<Value>, &mut Building<'_>) -> Value + 'static,
) -> Result<Resolved, Refusal> {
    let parameters = parameters.into_iter().map(|(name, data_type)| Parameter { name: name.to_owned(), data_type }).collect();
    let build: Build = Box::new(build);
    Ok(Resolved { parameters, result, meaning: Meaning::Build(build) })
}

/// The same with any number of parameters of one type.
pub(crate) fn built_list(
    names: Vec<String>,
    data_type: &DataType,
    result: DataType,
    build: impl Fn(Vec<Value>, &mut Building<'_>) -> Value + 'static,
) -> Result<Resolved, Refusal> {
    let parameters = names.into_iter().map(|name| Parameter { name, data_type: data_type.clone() }).collect();
    let build: Build = Box::new(build);
    Ok(Resolved { parameters, result, meaning: Meaning::Build(build) })
}
