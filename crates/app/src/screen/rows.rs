//! What can be chosen on the screen: inputs, outputs and values, with their formats.

use serde_json::Value;
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::format::{Format, ROWS};
use sieben_model::item::Item;

/// Where a row stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Group {
    /// Inputs.
    Inputs,
    /// Outputs.
    Outputs,
    /// Timers, counters, bit memory, and what the user named.
    Values,
}

impl Group {
    /// All of them, as they are gone through.
    pub(crate) const ALL: [Self; 3] = [Self::Inputs, Self::Outputs, Self::Values];
}

/// Who drives an input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Driver {
    /// People: a hand at a plant, or nothing at all.
    People,
    /// A sensor of this plant.
    Plant(String),
}

/// Something that has a value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Row {
    pub(crate) group: Group,
    /// The symbol; without one the address.
    pub(crate) name: String,
    /// `I 0.0`; empty for a name of the user's own that has none.
    pub(crate) address: String,
    /// What it is called in requests.
    pub(crate) item: String,
    pub(crate) comment: String,
    pub(crate) driver: Driver,
    /// What its address means.
    operand: Option<Operand>,
    /// It is a push button, as far as its terminal or its comment says that.
    pub(crate) is_button: bool,
}

/// Words in a comment or a name that only a push button has.
const BUTTON_WORDS: [&str; 3] = ["button", "taster", "taste"];

impl Row {
    /// A row of the assignment table; `None` for what belongs nowhere on the screen.
    pub(crate) fn of(row: &Value) -> Option<Self> {
        let text = |key: &str| row[key].as_str().unwrap_or_default().to_owned();
        let (symbol, address) = (text("symbol"), text("address"));
        let operand = Operand::parse(&address);
        let group = match &operand {
            Some(Operand::Address(Address { area: Area::Input | Area::PeripheralInput, .. })) => Group::Inputs,
            Some(Operand::Address(Address { area: Area::Output | Area::PeripheralOutput, .. })) => Group::Outputs,
            Some(Operand::Block(_)) => return None,
            _ => Group::Values,
        };
        let terminal = &row["terminal"];
        let comment = text("comment");
        let driver = match (terminal["direction"].as_str(), terminal["module"].as_str()) {
            (Some("sensor"), Some(module)) => Driver::Plant(module.to_owned()),
            _ => Driver::People,
        };
        let said = format!("{symbol} {comment}").to_lowercase();
        let is_called_so = || BUTTON_WORDS.iter().any(|word| said.contains(word));
        let is_button = terminal["operated"].as_str().map_or_else(is_called_so, |operated| operated == "button");
        // A terminal that is a person's and has no symbol is called as the plant calls it.
        let of_plant = terminal["signal"].as_str().filter(|_| terminal["direction"] == "hand");
        let name = if symbol.is_empty() { of_plant.unwrap_or(&address).to_owned() } else { symbol };
        Some(Self { group, name, item: text("item"), comment, driver, operand, is_button, address })
    }

    /// A name that the user wants to see.
    pub(crate) fn named(name: &str) -> Self {
        let operand = Operand::parse(name);
        Self {
            group: Group::Values,
            name: name.to_owned(),
            address: String::new(),
            item: name.to_owned(),
            comment: String::new(),
            driver: Driver::People,
            operand,
            is_button: false,
        }
    }

    /// Whether it is one bit.
    pub(crate) fn is_bit(&self) -> bool {
        matches!(&self.operand, Some(operand) if operand.width() == Some(Width::Bit))
    }

    /// The formats that it can be shown in.
    pub(crate) fn formats(&self) -> Vec<Format> {
        let Some(operand) = &self.operand else { return Vec::new() };
        let fits = |format: &Format| Item::operand(*operand).in_format(*format).is_ok();
        ROWS.iter().map(|row| row.format).filter(fits).collect()
    }

    /// What is asked for to read it in a format; without one as people read it.
    pub(crate) fn asked(&self, format: Option<Format>) -> String {
        let format = format.or(matches!(self.operand, Some(Operand::Timer(_))).then_some(Format::S5Time));
        match (format, self.address.is_empty()) {
            (None, _) => self.item.clone(),
            (Some(format), false) => format!("{}:{}", self.address, format.name()),
            (Some(format), true) => format!("{}:{}", self.item, format.name()),
        }
    }
}

/// A value as it was read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Shown {
    /// As people read it, or why there is none.
    pub(crate) text: String,
    /// Whether a bit is 1; `None` for everything else.
    pub(crate) on: Option<bool>,
    /// It could not be read.
    pub(crate) is_error: bool,
}

impl Shown {
    /// An item of the answer to `read`.
    pub(crate) fn of(item: &Value, row: &Row) -> Self {
        if let Some(message) = item["error"]["message"].as_str() {
            return Self { text: message.to_owned(), on: None, is_error: true };
        }
        let on = row.is_bit().then(|| item["value"].as_u64() == Some(1) || item["shown"] == "TRUE" || item["shown"] == "2#1");
        Self { text: item["shown"].as_str().unwrap_or_default().to_owned(), on, is_error: false }
    }
}
