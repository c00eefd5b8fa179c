//! Which statement changed a variable last, in words.

use sieben_model::address::{Address, Area, Operand};
use sieben_model::testing::Signal;
use sieben_model::types::DataType;
use sieben_sim::names::Name;
use sieben_sim::runner::Written;
use sieben_sim::trace::Moment;
use sieben_sim::trace::moment::scan_words;

use crate::controller;
use crate::project::Build;

/// Characters of a statement that are shown.
const STATEMENT_MAX: usize = 60;

/// A variable as those who look for its writers know it; none if it has no place in memory.
pub(crate) fn signal(name: &Name) -> Option<Signal> {
    let (data_block, address) = match name.operand()? {
        Operand::Address(address) => (None, *address),
        Operand::InDataBlock { db, address } => (Some(*db), *address),
        _ => return None,
    };
    // What goes out directly is written to the process image, too.
    let area = if address.area == Area::PeripheralOutput { Area::Output } else { address.area };
    Some(Signal { name: name.text().to_owned(), data_block, address: Address { area, ..address }, data_type: DataType::Bool })
}

/// One sentence about who changed a variable last; `area` is where it lies.
pub(crate) fn sentence(build: &Build, name: &str, area: Area, written: Option<Written>) -> String {
    let Some(Written { place, scan, time_us }) = written else {
        return match area {
            Area::Input => format!("`{name}`: an input that no statement writes"),
            _ => format!("`{name}`: no statement has changed it"),
        };
    };
    let at = controller::line_at(build, place).map_or_else(
        || controller::place_text(build, place),
        |line| {
            let text: String = line.statement.chars().take(STATEMENT_MAX).collect();
            format!("{}:{} `{text}` ({})", line.file, line.number, controller::place_text(build, place))
        },
    );
    // Scans that have begun.
    let when = scan.checked_sub(1).map_or_else(|| scan_words(None), |scan| Moment { scan, time_us }.to_string());
    format!("`{name}` was changed last by {at}, in {when}")
}
