//! What holds for every picture: nothing lies on something else, and no two lines cross.

use std::collections::HashMap;

use sieben_ide::drawing::{Layout, NetId, Outline, Role};

/// What lies in a character of the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Thing {
    /// A label, or the inside of a contact or coil.
    Written(usize),
    /// The side or edge of a symbol, at which lines may end.
    Edge(usize),
}

/// Columns of a text, as the text drawing counts them.
fn width(text: &str) -> usize {
    text.chars().map(|character| if ('\u{2E80}'..='\u{FFEF}').contains(&character) { 2 } else { 1 }).sum()
}

/// Whether it holds, or where it does not.
pub(crate) fn check(layout: &Layout) -> Result<(), String> {
    let things = things(layout)?;
    wires(layout, &things)?;
    for rail in &layout.rails {
        if format!("{:?}", rail.side) == "Right" && rail.column + 1 != layout.columns {
            return Err(format!("an output ends in column {} of {}", rail.column, layout.columns));
        }
    }
    Ok(())
}

fn things(layout: &Layout) -> Result<HashMap<(usize, usize), Thing>, String> {
    let mut things: HashMap<(usize, usize), Thing> = HashMap::new();
    let mut put = |at: (usize, usize), thing: Thing| {
        if at.0 >= layout.columns || at.1 >= layout.lines {
            return Err(format!("{thing:?} at {at:?} is outside of {} x {}", layout.columns, layout.lines));
        }
        match things.insert(at, thing) {
            Some(other) => Err(format!("{thing:?} lies on {other:?} at {at:?}")),
            None => Ok(()),
        }
    };
    for (index, symbol) in layout.symbols.iter().enumerate() {
        match symbol.outline {
            Outline::None => {}
            Outline::Contact { from, to, line, .. } | Outline::Coil { from, to, line } => {
                put((from, line), Thing::Edge(index))?;
                put((to, line), Thing::Edge(index))?;
            }
            Outline::Box { from, to, top, bottom } => {
                for line in top..=bottom {
                    put((from, line), Thing::Edge(index))?;
                    put((to, line), Thing::Edge(index))?;
                }
            }
        }
        for label in &symbol.labels {
            if matches!(label.role, Role::TickLeft | Role::TickRight | Role::Circle) {
                continue;
            }
            for column in label.column..label.column + width(&label.text) {
                put((column, label.line), Thing::Written(index))?;
            }
        }
    }
    Ok(things)
}

fn wires(layout: &Layout, things: &HashMap<(usize, usize), Thing>) -> Result<(), String> {
    let mut across: HashMap<(usize, usize), NetId> = HashMap::new();
    let mut down: HashMap<(usize, usize), NetId> = HashMap::new();
    for wire in &layout.wires {
        let ((from, first), (to, last)) = (wire.from, wire.to);
        if from != to && first != last || from > to || first > last {
            return Err(format!("{wire:?} is neither horizontal nor vertical"));
        }
        for column in from..=to {
            for line in first..=last {
                let at = (column, line);
                let is_end = at == wire.from || at == wire.to;
                match things.get(&at) {
                    Some(Thing::Written(symbol)) if !is_end || layout.symbols[*symbol].kind != "stub" => {
                        return Err(format!("{wire:?} goes through {:?} at {at:?}", layout.symbols[*symbol]));
                    }
                    Some(Thing::Edge(symbol)) if !is_end => {
                        return Err(format!("{wire:?} goes through {:?} at {at:?}", layout.symbols[*symbol]));
                    }
                    _ => {}
                }
                if is_end {
                    continue;
                }
                let own = if first == last { &mut across } else { &mut down };
                if let Some(other) = own.insert(at, wire.net) {
                    return Err(format!("{wire:?} lies on {other:?} at {at:?}"));
                }
            }
        }
    }
    match across.keys().find(|at| down.contains_key(*at)) {
        Some(at) => Err(format!("two lines cross at {at:?}")),
        None => Ok(()),
    }
}
