//! Names of the elements of a picture: kind and source line, the same in ladder and function block diagram.

use std::collections::HashMap;

use sieben_lang::network::model::{Kind, OutputKind};

use super::layout::Layout;

/// Kinds of symbols that are no elements.
pub(super) const STUB: &str = "stub";
/// The label that jumps name.
pub(super) const JUMP_LABEL: &str = "label";
/// An element that stands alone.
pub(super) const ALONE: &str = "alone";

/// The kind of an element, as its name and its class in a picture say.
pub(super) fn kind_of(kind: &Kind) -> &'static str {
    match kind {
        Kind::Contact { .. } => "contact",
        Kind::Compare { .. } => "compare",
        Kind::Parallel { .. } => "or",
        Kind::Xor { .. } => "xor",
        Kind::Group { .. } => "and",
        Kind::Tap { .. } => "tap",
        Kind::Edge { .. } | Kind::EdgeBox { .. } => "edge",
        Kind::Not => "not",
        Kind::Midline { .. } => "midline",
        Kind::Box { .. } | Kind::Named(_) => "box",
        Kind::FlipFlop { .. } => "flipflop",
        Kind::Timer(_) => "timer",
        Kind::Counter(_) => "counter",
        Kind::Call { .. } => "call",
    }
}

/// The kind of what stands at the right end.
pub(super) fn kind_of_output(kind: &OutputKind) -> &'static str {
    match kind {
        OutputKind::Jump(_) | OutputKind::JumpNot(_) | OutputKind::Return => "jump",
        OutputKind::Call(_) => "call",
        _ => "coil",
    }
}

/// Gives each element its name: kind and line; the second of a line has `-2` after it, in the order of what makes them.
pub(super) fn name(layout: &mut Layout, line_of: &dyn Fn(sieben_lang::network::model::Place) -> usize) {
    let mut order: Vec<(usize, u32, usize)> = layout
        .symbols
        .iter()
        .enumerate()
        .filter(|(_, symbol)| symbol.kind != STUB && symbol.kind != JUMP_LABEL)
        .map(|(index, symbol)| (line_of(symbol.place), symbol.place.first, index))
        .collect();
    order.sort_unstable();
    let mut counts: HashMap<(&'static str, usize), usize> = HashMap::new();
    for (line, _, index) in order {
        let symbol = &mut layout.symbols[index];
        let count = counts.entry((symbol.kind, line)).or_default();
        *count += 1;
        symbol.element = if *count == 1 { format!("{}-{line}", symbol.kind) } else { format!("{}-{line}-{count}", symbol.kind) };
    }
}
