//! Lists to choose from that lie over the screen: faults of the plants, blocks.

use std::io;

use serde_json::{Value, json};
use sieben_workspace::session::texts::{Text, fill};

use super::asks::Asks;
use super::look::Look;
use super::state::{Over, Part, Screen};
use super::words;

/// Faults of a bit that can be chosen.
const BIT_FAULTS: [&str; 5] = ["stuck=0", "stuck=1", "stuck", "late=500ms", "bounce=200ms"];
/// Faults of a word.
const WORD_FAULTS: [&str; 4] = ["stuck", "stuck=0", "drift=1", "late=500ms"];

/// A list to choose from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Menu {
    pub(crate) head: Text,
    /// What is chosen, and how it is shown.
    pub(crate) rows: Vec<(Choice, String)>,
    pub(crate) at: usize,
}

/// What a row of a list does when it is chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Choice {
    /// Injects this fault.
    Inject(String),
    /// Mends this signal.
    Mend(String),
    /// Shows this block.
    Block(String),
}

fn texts<'v>(value: &'v Value, key: &str) -> impl Iterator<Item = &'v str> {
    value[key].as_array().into_iter().flatten().filter_map(Value::as_str)
}

impl Screen {
    /// The faults that are there, to be mended, then those that the signals can have; the selected signal is chosen.
    pub(super) fn show_faults(&mut self, look: &Look) {
        if look.plants.is_empty() {
            return self.refuse(words::NO_PLANT, &[]);
        }
        let selected = look.rows.get(self.chosen(look)).map(|row| row.address.as_str());
        let (mut mends, mut faults, mut of_selected) = (Vec::new(), Vec::new(), None);
        for plant in &look.plants {
            for fault in texts(plant, "faults") {
                let signal = fault.split(' ').next().unwrap_or_default().to_owned();
                mends.push((Choice::Mend(signal), fill(self.language, words::MEND, &[&fault])));
            }
            let module = plant["module"].as_str().unwrap_or_default();
            for signal in plant["signals"].as_array().into_iter().flatten() {
                let text = |key: &str| signal[key].as_str().unwrap_or_default();
                let (name, address, symbol) = (text("name"), text("address"), text("symbol"));
                if selected == Some(address) {
                    of_selected.get_or_insert(faults.len());
                }
                let is_bit = address.contains('.');
                faults.extend(if is_bit { &BIT_FAULTS[..] } else { &WORD_FAULTS }.iter().map(|kind| {
                    let fault = format!("{module}.{name} {kind}");
                    let shown = format!("{fault:<34}  {address} {symbol}").trim_end().to_owned();
                    (Choice::Inject(fault), shown)
                }));
            }
        }
        let at = of_selected.filter(|_| mends.is_empty()).unwrap_or_default();
        mends.append(&mut faults);
        self.over = Over::Menu(Menu { head: words::FAULTS, rows: mends, at });
    }

    /// The blocks with statements; the one that is shown is chosen.
    pub(super) fn show_blocks(&mut self, look: &Look) {
        let at = look.blocks.iter().position(|(id, _)| *id == look.program.block).unwrap_or_default();
        let rows = look.blocks.iter().map(|(id, shown)| (Choice::Block(id.clone()), shown.clone())).collect();
        self.over = Over::Menu(Menu { head: words::BLOCKS, rows, at });
    }

    /// The chosen row of a menu is carried out.
    pub(super) fn choose(&mut self, menu: &Menu, asks: &mut dyn Asks) -> io::Result<()> {
        let Some((choice, _)) = menu.rows.get(menu.at) else { return Ok(()) };
        match choice {
            Choice::Block(block) => {
                self.block = Some(block.clone());
                self.top = 0;
                self.part = Part::Program;
            }
            Choice::Mend(signal) => {
                if self.command(asks, "faults", &json!({ "mend": signal }))? {
                    self.say(words::MENDED, &[signal]);
                }
            }
            Choice::Inject(fault) => {
                if self.command(asks, "faults", &json!({ "inject": fault }))? {
                    self.say(words::INJECTED, &[fault]);
                }
            }
        }
        Ok(())
    }
}
