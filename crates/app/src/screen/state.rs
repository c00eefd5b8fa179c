//! The state of the screen itself: what is chosen, what is asked, what was said.

use std::collections::HashMap;
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use serde_json::{Value, json};
use sieben_model::format::Format;
use sieben_workspace::Speed;
use sieben_workspace::session::Language;
use sieben_workspace::session::texts::{Text, fill, pick};

use super::asks::{Asks, Refused, asked};
use super::look::Look;
use super::menu::Menu;
use super::rows::{Driver, Group, Row};
use super::words;

/// How long a button is pressed, in milliseconds of the CPU's time.
const PRESS_MS: u64 = 400;
/// Characters of a value that is typed.
const TYPED_MAX: usize = 300;

/// What the changing part of the screen shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Part {
    /// The program with its status.
    #[default]
    Program,
    /// Timers, counters, words.
    Values,
    /// What changed.
    Changes,
    /// The diagnostic buffer.
    Diagnostics,
    /// Mode, cycle, clients.
    Run,
}

impl Part {
    const ALL: [Self; 5] = [Self::Program, Self::Values, Self::Changes, Self::Diagnostics, Self::Run];

    /// The next one.
    pub(crate) fn next(self) -> Self {
        let at = Self::ALL.iter().position(|part| *part == self).unwrap_or_default();
        Self::ALL[(at + 1) % Self::ALL.len()]
    }
}

/// What lies over the screen and takes the keys.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) enum Over {
    /// Nothing.
    #[default]
    Nothing,
    /// All keys.
    Help,
    /// A list.
    Menu(Menu),
    /// A value that is typed for a row.
    Prompt {
        /// The row.
        row: usize,
        /// What was typed.
        typed: String,
    },
    /// Whether all memory shall be reset.
    MemoryReset,
}

/// The story of the demo, which presses START by itself.
#[derive(Debug)]
pub(crate) struct Story {
    /// Whether it does.
    pub(crate) is_on: AtomicBool,
    /// The user did something.
    pub(crate) user_acted: AtomicBool,
    /// Seconds until it presses START; [`u64::MAX`] if it will not.
    pub(crate) seconds: AtomicU64,
    /// Whether its plant is there: a page may have changed to another example.
    pub(crate) has_plant: AtomicBool,
}

impl Default for Story {
    fn default() -> Self {
        Self {
            is_on: AtomicBool::new(true),
            user_acted: AtomicBool::new(false),
            seconds: AtomicU64::new(u64::MAX),
            has_plant: AtomicBool::new(true),
        }
    }
}

/// Something that was said, and how.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Said {
    /// What was done.
    Done(String),
    /// Why something was not done.
    Refused(String),
}

/// What a key means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Command {
    Quit,
    Up,
    Down,
    Left,
    Right,
    Toggle,
    Press,
    Digit(usize),
    Set,
    Format,
    Run,
    Stop,
    MemoryReset,
    Pause,
    Go,
    OneScan,
    Faster,
    Slower,
    Faults,
    Block,
    PageUp,
    PageDown,
    Part,
    Plant,
    Auto,
    Help,
}

/// What comes of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Then {
    /// The screen goes on.
    On,
    /// The user leaves.
    Leave,
}

/// The screen.
#[derive(Debug, Default)]
pub(crate) struct Screen {
    pub(crate) language: Language,
    /// Names that the user wants to see beside the table.
    pub(crate) names: Vec<String>,
    /// The row that the user chose.
    pub(crate) row: Option<usize>,
    pub(crate) part: Part,
    /// The plant that is drawn.
    pub(crate) plant: usize,
    /// The block that the user chose.
    pub(crate) block: Option<String>,
    /// The first line of the block that is shown.
    pub(crate) top: usize,
    /// Formats that the user chose.
    pub(crate) formats: HashMap<String, Format>,
    pub(crate) over: Over,
    pub(crate) said: Option<Said>,
    pub(crate) story: Option<Arc<Story>>,
    /// The number of the newest note that was said.
    pub(crate) newest_note: Option<u64>,
    /// What was switched lately, to what and in which scan: the process image only sees it with the next one.
    pub(crate) switched: HashMap<String, (bool, u64)>,
}

impl Screen {
    /// A screen in the language of the command line or the environment.
    pub(crate) fn spoken() -> Self {
        Self { language: crate::language::spoken(), ..Self::default() }
    }

    /// Another project runs from now on.
    pub(crate) fn begin_anew(&mut self) {
        let Self { language, names, story, .. } = std::mem::take(self);
        *self = Self { language, names, story, ..Self::default() };
    }

    /// A text in the language of the screen.
    pub(crate) fn word(&self, text: Text) -> &'static str {
        pick(self.language, text)
    }

    /// Says the newest note once: measured values push it out of the list of changes within seconds. Whether there was one.
    pub(crate) fn tell_note(&mut self, look: &Look) -> bool {
        // What is being typed is not interrupted, and the demo, which tells a story in notes, keeps its line of keys.
        if self.over != Over::Nothing || self.story.is_some() {
            return false;
        }
        let newest = look.changes.iter().rev().find(|entry| entry.get("note").is_some_and(Value::is_string));
        let number = newest.and_then(|entry| entry["number"].as_u64()).unwrap_or_default();
        // What was noted before the first look is no news.
        let is_news = self.newest_note.is_some_and(|before| before < number);
        self.newest_note = Some(number);
        // The first line of several is the message.
        let scan = newest.map(|entry| entry["scan"].clone());
        let first = look.changes.iter().find(|entry| Some(&entry["scan"]) == scan.as_ref() && entry["note"].is_string());
        match first.and_then(|entry| entry["note"].as_str()) {
            Some(note) if is_news => {
                self.said = Some(Said::Refused(note.trim().to_owned()));
                true
            }
            _ => false,
        }
    }

    pub(super) fn say(&mut self, text: Text, values: &[&dyn std::fmt::Display]) {
        self.said = Some(Said::Done(fill(self.language, text, values)));
    }

    pub(super) fn refuse(&mut self, text: Text, values: &[&dyn std::fmt::Display]) {
        self.said = Some(Said::Refused(fill(self.language, text, values)));
    }

    fn refused(&mut self, refused: &Refused) {
        self.said = Some(Said::Refused(format!("{}: {}", refused.code, refused.message)));
    }

    /// Asks for something that changes the run, and says why it was not done.
    pub(super) fn command(&mut self, asks: &mut dyn Asks, verb: &str, fields: &Value) -> io::Result<bool> {
        let answer = match asked(asks, verb, fields)? {
            Ok(answer) => answer,
            Err(refused) => {
                self.refused(&refused);
                return Ok(false);
            }
        };
        let of_item = answer["items"].as_array().into_iter().flatten().find_map(Refused::of);
        of_item.iter().for_each(|refused| self.refused(refused));
        Ok(of_item.is_none())
    }

    /// Does what a key means.
    ///
    /// # Errors
    /// The run is over, or does not answer.
    pub(crate) fn act(&mut self, command: Command, look: &Look, asks: &mut dyn Asks) -> io::Result<Then> {
        self.said = None;
        if let Some(story) = &self.story {
            story.user_acted.store(true, Ordering::Relaxed);
        }
        let time = |word: &str| json!({ "time": word });
        match command {
            Command::Quit => return Ok(Then::Leave),
            Command::Up => self.row = Some(self.chosen(look).saturating_sub(1)),
            Command::Down => self.row = Some((self.chosen(look) + 1).min(look.rows.len().saturating_sub(1))),
            Command::Left | Command::Right => self.change_group(command, look),
            Command::Toggle => self.toggle(self.chosen(look), look, asks)?,
            Command::Press => self.press(self.chosen(look), look, asks)?,
            Command::Digit(digit) => self.digit(digit, look, asks)?,
            Command::Set => self.ask_for_value(look),
            Command::Format => self.next_format(look),
            Command::Run => drop(self.command(asks, "mode", &json!({ "mode": "run" }))?),
            Command::Stop => drop(self.command(asks, "mode", &json!({ "mode": "stop" }))?),
            Command::MemoryReset => self.over = Over::MemoryReset,
            // The scan after which time stands still is the one whose status is shown.
            Command::Pause if !Self::state_now(look, asks)?["paused"].as_bool().unwrap_or_default() => {
                self.command(asks, "time", &time("step"))?;
            }
            Command::Pause | Command::Go => drop(self.command(asks, "time", &time("go"))?),
            Command::OneScan => drop(self.command(asks, "time", &time("step"))?),
            Command::Faster | Command::Slower => {
                let state = Self::state_now(look, asks)?;
                let now = Speed::parse(state["speed"].as_str().unwrap_or_default()).unwrap_or(Speed::Factor(1.0));
                let next = if command == Command::Faster { now.faster() } else { now.slower() };
                // As fast as it goes is too fast for the demo, which makes up for every cycle.
                if self.story.is_none() || next != Speed::Max {
                    self.command(asks, "time", &json!({ "time": "speed", "speed": next.to_string() }))?;
                }
            }
            Command::Faults => self.show_faults(look),
            Command::Block => self.show_blocks(look),
            Command::PageUp => self.top = self.top.saturating_sub(10),
            Command::PageDown => self.top = (self.top + 10).min(look.program.lines.len().saturating_sub(1)),
            Command::Part => self.part = self.part.next(),
            Command::Plant => self.plant = (self.plant + 1) % look.plants.len().max(1),
            Command::Auto => self.switch_story(),
            Command::Help => self.over = Over::Help,
        }
        Ok(Then::On)
    }

    /// The state of the run now: several keys may have been pressed since the last look.
    fn state_now(look: &Look, asks: &mut dyn Asks) -> io::Result<Value> {
        Ok(asked(asks, "state", &json!({}))?.unwrap_or_else(|_| look.state.clone()))
    }

    fn switch_story(&mut self) {
        let Some(story) = &self.story else { return };
        let was_on = story.is_on.fetch_xor(true, Ordering::Relaxed);
        story.user_acted.store(false, Ordering::Relaxed);
        self.say(if was_on { words::IS_MANUAL } else { words::IS_AUTO }, &[]);
    }

    /// Goes to the first row of the group before or after.
    /// The chosen row: at first the first input that no sensor drives.
    pub(crate) fn chosen(&self, look: &Look) -> usize {
        let is_operated = |row: &Row| row.group == Group::Inputs && row.driver == Driver::People;
        self.row.or_else(|| look.rows.iter().position(is_operated)).unwrap_or_default()
    }

    fn change_group(&mut self, command: Command, look: &Look) {
        let Some(now) = look.rows.get(self.chosen(look)).map(|row| row.group) else { return };
        let at = Group::ALL.iter().position(|group| *group == now).unwrap_or_default();
        let there = |step: usize| {
            let group = Group::ALL[(at + step) % Group::ALL.len()];
            look.rows.iter().position(|row| row.group == group)
        };
        let steps = if command == Command::Right { [1, 2] } else { [2, 1] };
        self.row = steps.into_iter().find_map(there).or(self.row);
    }

    /// The chosen row, if it can be operated.
    fn operable<'l>(&mut self, at: usize, look: &'l Look) -> Option<&'l Row> {
        let Some(row) = look.rows.get(at) else {
            self.refuse(words::NOTHING_SELECTED, &[]);
            return None;
        };
        let called = if row.name == row.address { row.address.clone() } else { format!("{} {}", row.address, row.name) };
        match (&row.driver, row.group) {
            (Driver::Plant(plant), _) => self.refuse(words::DRIVEN, &[&called, plant]),
            (Driver::People, Group::Outputs) => self.refuse(words::OUTPUT, &[&called]),
            (Driver::People, _) => return Some(row),
        }
        None
    }

    fn toggle(&mut self, at: usize, look: &Look, asks: &mut dyn Asks) -> io::Result<()> {
        let Some(row) = self.operable(at, look) else { return Ok(()) };
        let Some(on) = look.shown.get(at).and_then(|shown| shown.on) else {
            self.refuse(words::NOT_A_BIT, &[&row.name]);
            return Ok(());
        };
        let scans = look.state["scans"].as_u64().unwrap_or_default();
        self.switched.retain(|_, (_, scan)| scan.saturating_add(1) >= scans);
        let on = self.switched.get(&row.item).map_or(on, |(on, _)| *on);
        let value = u8::from(!on);
        if self.command(asks, "write", &json!({ "values": { row.item.as_str(): value } }))? {
            self.switched.insert(row.item.clone(), (!on, scans));
            self.say(words::SET, &[&row.name, &value]);
        }
        Ok(())
    }

    fn press(&mut self, at: usize, look: &Look, asks: &mut dyn Asks) -> io::Result<()> {
        let Some(row) = self.operable(at, look) else { return Ok(()) };
        if !row.is_bit() {
            self.refuse(words::NOT_A_BIT, &[&row.name]);
            return Ok(());
        }
        self.command(asks, "press", &json!({ "items": [row.item], "ms": PRESS_MS }))?;
        Ok(())
    }

    /// The rows that the keys 1 to 9 operate: inputs that are bits and that no sensor drives.
    pub(crate) fn digits(look: &Look) -> Vec<usize> {
        let is_operated = |(_, row): &(usize, &Row)| row.group == Group::Inputs && row.is_bit() && row.driver == Driver::People;
        look.rows.iter().enumerate().filter(is_operated).map(|(at, _)| at).take(9).collect()
    }

    fn digit(&mut self, digit: usize, look: &Look, asks: &mut dyn Asks) -> io::Result<()> {
        match digit.checked_sub(1).and_then(|index| Self::digits(look).get(index).copied()) {
            Some(at) if look.rows.get(at).is_some_and(|row| row.is_button) => self.press(at, look, asks),
            Some(at) => self.toggle(at, look, asks),
            None => {
                self.refuse(words::NO_INPUT, &[&digit]);
                Ok(())
            }
        }
    }

    fn ask_for_value(&mut self, look: &Look) {
        let row = self.chosen(look);
        if self.operable(row, look).is_some() {
            self.over = Over::Prompt { row, typed: String::new() };
        }
    }

    fn next_format(&mut self, look: &Look) {
        let Some(row) = look.rows.get(self.chosen(look)) else { return self.refuse(words::NOTHING_SELECTED, &[]) };
        let formats = row.formats();
        let now = self.formats.get(&row.item).and_then(|format| formats.iter().position(|other| other == format));
        // After the last one comes the value as people read it, without a format.
        let next = formats.get(now.map_or(0, |now| now + 1)).copied();
        match next {
            Some(format) => {
                self.formats.insert(row.item.clone(), format);
                self.say(["{0}: {1}", "{0}: {1}"], &[&row.name, &format.name()]);
            }
            None if formats.is_empty() => self.refuse(words::NO_FORMATS, &[&row.name]),
            None => {
                self.formats.remove(&row.item);
            }
        }
    }

    /// A typed value is written; one that does not fit stays to be corrected.
    pub(crate) fn enter(&mut self, row: usize, typed: String, look: &Look, asks: &mut dyn Asks) -> io::Result<()> {
        let Some(named) = look.rows.get(row).cloned() else { return Ok(()) };
        if typed.trim().is_empty() {
            return Ok(());
        }
        if self.command(asks, "write", &json!({ "values": { named.item.as_str(): typed.trim() } }))? {
            self.say(words::SET, &[&named.name, &typed.trim()]);
        } else {
            self.over = Over::Prompt { row, typed };
        }
        Ok(())
    }

    /// All memory is reset, or not.
    pub(crate) fn reset(&mut self, asks: &mut dyn Asks) -> io::Result<()> {
        if self.command(asks, "mode", &json!({ "mode": "mres" }))? {
            self.say(words::IS_RESET, &[]);
        }
        Ok(())
    }

    /// A character for the value that is typed.
    pub(crate) fn type_in(typed: &mut String, character: char) {
        if typed.chars().count() < TYPED_MAX && !character.is_control() {
            typed.push(character);
        }
    }
}
