//! ARRAY[*]: how many elements there are is known to the caller, who gives the bounds of each dimension beside the array.

use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::types::DataType;

/// What stands for `*` among the bounds of an array.
pub(crate) const OPEN: (i32, i32) = (0, -1);

/// One end of a dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    Low,
    High,
}

impl End {
    pub(crate) const BOTH: [Self; 2] = [Self::Low, Self::High];
}

/// Whether the bounds of an array are the caller's.
pub(crate) fn is_open(data_type: &DataType) -> bool {
    matches!(data_type, DataType::Array { bounds, .. } if bounds.first() == Some(&OPEN))
}

/// The name of the input that tells a bound; dimensions count from 1.
pub(crate) fn bound_name(array: &str, dimension: usize, end: End) -> String {
    let word = if end == End::Low { "LOW" } else { "HIGH" };
    format!("{array}__{word}{dimension}")
}

/// The inputs that tell the bounds of an array.
pub(crate) fn bound_names(array: &str, data_type: &DataType) -> Vec<String> {
    let DataType::Array { bounds, .. } = data_type else { return Vec::new() };
    let names = (1..=bounds.len()).flat_map(|dimension| End::BOTH.map(|end| bound_name(array, dimension, end)));
    if is_open(data_type) { names.collect() } else { Vec::new() }
}

/// Whether an input tells a bound: calls do not name it.
pub(crate) fn is_bound(interface: &Interface, variable: &Variable) -> bool {
    variable.section == Section::Input
        && variable.name.contains("__")
        && interface
            .variables
            .iter()
            .any(|array| is_open(&array.data_type) && bound_names(&array.name, &array.data_type).contains(&variable.name))
}
