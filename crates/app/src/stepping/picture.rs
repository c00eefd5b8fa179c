//! The state of the screen, and the picture that it makes of where the run stands.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::rc::Rc;

use sieben_engine::FaultPlace;
use sieben_engine::machine::Registers;
use sieben_ide::drawing::text::Characters;
use sieben_model::address::{Address, Area, Width};
use sieben_model::format::Format;
use sieben_model::literal::Value;
use sieben_model::mnemonics::Mnemonics;
use sieben_model::source::FileId;
use sieben_model::types::DataType;
use sieben_model::value::{Content, Kind};
use sieben_model::visible::visible;
use sieben_sim::history::Target;
use sieben_sim::names::{Name, Setting, Shown};
use sieben_workspace::names;
use sieben_workspace::session::commands::{Answer, LINE_MAX, carry_out};
use sieben_workspace::session::texts::pick;
use sieben_workspace::session::{self, Language, LocalValue, Session, Variables, View, table};

use super::keys::Command;
use super::trail::{Seen, Trail};
use super::used::{self, Bits};
use super::words::{halt, refused};
use crate::diagrams::{self, Blocks, Diagrams, Form, Watch as Watching};

/// Columns of a diagram: what the smallest terminal has room for.
const DIAGRAM_COLUMNS: usize = 76;

/// What the keys work on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Focus {
    /// The source.
    Source,
    /// The bits.
    Bits,
}

/// What stays from one picture to the next.
pub(super) struct Screen {
    colour: bool,
    focus: Focus,
    /// The variables of the block are shown in the place of the bits.
    variables: bool,
    /// The source that is shown, and the line of the cursor there, from 0.
    file: FileId,
    cursor: usize,
    /// Bytes of inputs, outputs and bit memory that the program uses.
    bytes: Vec<(Area, u32)>,
    /// Timers, counters and words that it uses.
    values: used::Values,
    /// The chosen byte, and the bit in it.
    chosen: (usize, u8),
    /// Inputs that were switched since this scan began: a module shows them to the next one.
    switched: HashMap<(u32, u8), bool>,
    switched_in: u64,
    /// What the network is drawn as, above its statements.
    diagram: Option<Form>,
    /// Accumulators and address registers are shown bit by bit in its place.
    register_bits: bool,
    /// The sources of the blocks, once a diagram was asked for.
    blocks: Option<Rc<Blocks>>,
    message: String,
    prompt: Option<String>,
    help: bool,
}

/// A line of the source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct SourceLine {
    pub(super) number: usize,
    pub(super) text: String,
    pub(super) breakpoint: bool,
    pub(super) next: bool,
    pub(super) executed: bool,
    pub(super) cursor: bool,
    /// What the statement of the line that was executed last left behind.
    pub(super) seen: Option<Seen>,
}

/// Eight bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ByteLine {
    /// `I 0`.
    pub(super) name: String,
    pub(super) bits: u8,
    /// The bit that is chosen, and what it becomes with the next scan.
    pub(super) chosen: Option<(u8, Option<bool>)>,
}

/// Everything that is drawn.
pub(super) struct Picture {
    pub(super) language: Language,
    pub(super) colour: bool,
    pub(super) focus: Focus,
    /// `OB 1 › FC 3`.
    pub(super) stack: String,
    pub(super) view: View,
    pub(super) registers: Registers,
    pub(super) four_accumulators: bool,
    pub(super) file: String,
    pub(super) lines: Vec<SourceLine>,
    /// Index of the line of the cursor in `lines`.
    pub(super) cursor: usize,
    pub(super) bytes: Vec<ByteLine>,
    pub(super) watched: Vec<(String, String)>,
    /// Timers, counters and words that the program uses, those of the block that runs first.
    pub(super) used: Vec<(String, String)>,
    /// Whether the block where the run stands works on registers; in ST its variables stand in their place.
    pub(super) on_registers: bool,
    /// The variables take the place of the bits as well.
    pub(super) only_variables: bool,
    /// Blocks with their variables.
    pub(super) variables: Vec<(String, Vec<(String, String)>)>,
    /// The network as a diagram: what it is, and its lines.
    pub(super) diagram: Option<(String, Vec<String>)>,
    /// The last statement.
    pub(super) statement: String,
    pub(super) reason: String,
    pub(super) message: String,
    pub(super) prompt: Option<String>,
    pub(super) help: bool,
}

impl Screen {
    pub(super) fn new(session: &mut Session, colour: bool) -> Self {
        let bits = Bits::of(session);
        let greeting = ["s steps on, S back, h shows all keys", "s geht weiter, S zurück, h zeigt alle Tasten"];
        let mut screen = Self {
            colour,
            focus: Focus::Source,
            variables: false,
            file: FileId(0),
            cursor: 0,
            bytes: bits.bytes,
            values: used::Values::of(session),
            chosen: bits.first,
            switched: HashMap::new(),
            switched_in: 0,
            diagram: None,
            register_bits: false,
            blocks: None,
            message: pick(session.language, greeting).to_owned(),
            prompt: None,
            help: false,
        };
        screen.follow(session);
        screen
    }

    /// Whether a command line is open.
    pub(super) fn is_typing(&self) -> bool {
        self.prompt.is_some()
    }

    /// Carries a command out; `true` if it was to leave.
    pub(super) fn act(&mut self, session: &mut Session, command: Command, rows: usize) -> bool {
        self.message.clear();
        match command {
            Command::Quit => return true,
            Command::Step(unit, direction) => {
                let ended = session.step(unit, direction, 1);
                self.moved(session, halt(&ended, session.language));
            }
            Command::Run(direction) => {
                let ended = session.run(direction, session::STATEMENTS_MAX);
                self.moved(session, halt(&ended, session.language));
            }
            Command::ToCursor => match self.goal(session) {
                Ok(goal) => {
                    let ended = session.run_to(goal);
                    self.moved(session, halt(&ended, session.language));
                }
                Err(message) => self.message = message,
            },
            Command::Toggle if self.focus == Focus::Bits => self.switch(session),
            Command::Toggle => {
                if let Err(message) = self.goal(session).and_then(|goal| session.toggle(goal)) {
                    self.message = message;
                }
            }
            Command::Lines(lines) if self.focus == Focus::Bits => {
                let last = self.bytes.len().saturating_sub(1);
                self.chosen.0 = self.chosen.0.saturating_add_signed(lines as isize).min(last);
            }
            Command::Lines(lines) => self.cursor = self.cursor.saturating_add_signed(lines as isize),
            Command::Pages(pages) => self.cursor = self.cursor.saturating_add_signed(pages as isize * rows.max(1) as isize),
            // The highest bit stands left.
            Command::Bits(bits) => self.chosen.1 = (i32::from(self.chosen.1) - bits).rem_euclid(8) as u8,
            // The bits are what there is to choose from.
            Command::Focus if self.variables => {
                self.variables = false;
                self.focus = Focus::Bits;
            }
            Command::Focus => self.focus = if self.focus == Focus::Source { Focus::Bits } else { Focus::Source },
            Command::Language => {
                session.language = if session.language == Language::English { Language::German } else { Language::English };
            }
            Command::Variables => {
                self.variables = !self.variables;
                self.focus = Focus::Source;
            }
            Command::RegisterBits => {
                self.register_bits = !self.register_bits;
                self.diagram = None;
            }
            Command::Diagram => {
                self.register_bits = false;
                self.diagram = match self.diagram {
                    None => Some(Form::Lad),
                    Some(Form::Lad) => Some(Form::Fbd),
                    Some(_) => None,
                };
            }
            Command::Help => self.help = !self.help,
            Command::Prompt(words) => self.prompt = Some(words.to_owned()),
            Command::Type(character) => {
                if let Some(prompt) = &mut self.prompt
                    && prompt.len() < LINE_MAX
                {
                    prompt.push(character);
                }
            }
            Command::Erase => {
                if let Some(prompt) = &mut self.prompt {
                    prompt.pop();
                }
            }
            Command::Cancel => {
                self.prompt = None;
                self.help = false;
            }
            Command::Enter => return self.enter(session),
        }
        false
    }

    /// The command line is carried out as a line of `--commands`.
    fn enter(&mut self, session: &mut Session) -> bool {
        let Some(line) = self.prompt.take() else { return false };
        let outcome = carry_out(session, &line, &mut |_| {});
        match outcome {
            Ok(Answer::Quit) => return true,
            // Where the run stands is what the screen shows anyway.
            Ok(Answer::Moved(ended)) => self.moved(session, halt(&ended, session.language)),
            Ok(answer) => {
                let text = table::answer(session, &answer);
                self.moved(session, text.trim());
            }
            Err(refusal) => {
                let text = refused(&refusal, false, session.language);
                self.message = text.trim().to_owned();
            }
        }
        false
    }

    fn moved(&mut self, session: &mut Session, message: &str) {
        self.message = message.to_owned();
        self.follow(session);
    }

    /// The cursor goes to the statement that comes next, or to the last one between two scans.
    fn follow(&mut self, session: &Session) {
        let history = session.history();
        let place = history.next_place().or(history.last().map(|event| event.place));
        let first = || session.listing().goal("OB1", None, Language::English).ok().map(|goal| goal.place);
        let Some(span) = place.or_else(first).and_then(|place| session.listing().span(place)) else { return };
        self.file = span.file;
        self.cursor = session.listing().places().line(span).saturating_sub(1);
    }

    fn goal(&self, session: &Session) -> Result<session::Goal, String> {
        let name = &session.build().project.texts.program.file(self.file).name;
        session.goal(&format!("{name}:{}", self.cursor + 1))
    }

    /// Switches the chosen bit.
    fn switch(&mut self, session: &mut Session) {
        let Some(&(area, byte)) = self.bytes.get(self.chosen.0) else { return };
        let address = Address { area, width: Width::Bit, byte, bit: self.chosen.1 }.spell(Mnemonics::English);
        let image = session.cpu().machine().memory.area(area).get(byte as usize).is_some_and(|byte| byte >> self.chosen.1 & 1 == 1);
        let scan = session.history().scans();
        if self.switched_in != scan {
            self.switched.clear();
            self.switched_in = scan;
        }
        let wanted = !self.switched.get(&(byte, self.chosen.1)).copied().filter(|_| area == Area::Input).unwrap_or(image);
        let setting = session.name_in(&address, None).and_then(|name| Setting::new(name, if wanted { "1" } else { "0" }));
        if let Err(error) = setting.and_then(|setting| session.set(setting)) {
            self.message = error.to_string();
        } else if area == Area::Input {
            self.switched.insert((byte, self.chosen.1), wanted);
            let address = self.spell(session, area, byte);
            let becomes = pick(session.language, ["becomes", "wird"]);
            let when = pick(session.language, ["with the next scan", "mit dem nächsten Zyklus"]);
            self.message = format!("{address}.{} {becomes} {} {when}", self.chosen.1, u8::from(wanted));
        }
    }

    /// `I 0`.
    fn spell(&self, session: &Session, area: Area, byte: u32) -> String {
        format!("{} {byte}", area.prefix(session.listing().places().mnemonics))
    }

    /// The network where the run stands as a diagram, with what its statements did in this scan so far.
    fn diagram(&mut self, session: &Session, view: &View, order: &[(FaultPlace, Registers)]) -> Option<(String, Vec<String>)> {
        let form = self.diagram?;
        let place = view.next.as_ref().or(view.executed.as_ref())?.place;
        let blocks = self.blocks.get_or_insert_with(|| Rc::new(diagrams::blocks(session.build()))).clone();
        let block = blocks.get(&place.block)?;
        let number = session.listing().network(place)?;
        let network = block.networks.iter().find(|network| network.number == number)?;
        let mut watch = Watching::new(place.block, network);
        order.iter().for_each(|(place, after)| watch.take(*place, after));
        let build = session.build();
        let status = watch.status(network, session.cpu(), &build.project.symbols);
        let places = session.listing().places();
        let diagrams = Diagrams::of(build, &places, blocks.clone());
        let drawn = diagrams.shown_in(place.block, network, form, Some(&status), DIAGRAM_COLUMNS);
        let lines = match (drawn.text(Characters::Unicode), &drawn.reason) {
            (Some(text), _) => text.lines().map(shown).collect(),
            (None, reason) => vec![shown(reason.as_deref().unwrap_or_default())],
        };
        Some((shown(&drawn.title), lines))
    }

    /// The picture of where the run stands.
    pub(super) fn picture(&mut self, session: &mut Session) -> Picture {
        let Trail { seen, order, .. } = Trail::of(session);
        let view = session.view();
        let diagram = match self.register_bits {
            true => Some(register_bits(session)),
            false => self.diagram(session, &view, &order),
        };
        let texts = &session.build().project.texts.program;
        let file = texts.file(self.file);
        self.cursor = self.cursor.min(file.text.lines().count().saturating_sub(1));
        let in_file = |place: FaultPlace| {
            let span = session.listing().span(place).filter(|span| span.file == self.file)?;
            Some(session.listing().places().line(span))
        };
        let mut beside: BTreeMap<usize, (u32, Seen)> = BTreeMap::new();
        for (place, seen) in seen {
            if let Some(line) = in_file(place)
                && beside.get(&line).is_none_or(|(statement, _)| *statement <= place.statement)
            {
                beside.insert(line, (place.statement, seen));
            }
        }
        let breaks: BTreeSet<usize> = session
            .breakpoints()
            .iter()
            .filter_map(|breakpoint| match breakpoint.target {
                Target::Statement(place, _) => in_file(place),
                _ => None,
            })
            .collect();
        let line_of = |line: &Option<session::Line>| line.as_ref().and_then(|line| in_file(line.place));
        let (next, executed) = (line_of(&view.next), line_of(&view.executed));
        let lines = file.text.lines().enumerate().map(|(index, text)| {
            let number = index + 1;
            SourceLine {
                number,
                text: visible(&text.replace('\t', "    ")).into_owned(),
                breakpoint: breaks.contains(&number),
                next: next == Some(number),
                executed: executed == Some(number),
                cursor: index == self.cursor && self.focus == Focus::Source,
                seen: beside.get(&number).map(|(_, seen)| seen.clone()),
            }
        });
        let lines = lines.collect();
        let memory = &session.cpu().machine().memory;
        let bytes = self.bytes.iter().enumerate().map(|(index, &(area, byte))| ByteLine {
            name: self.spell(session, area, byte),
            bits: memory.area(area).get(byte as usize).copied().unwrap_or_default(),
            chosen: (self.focus == Focus::Bits && index == self.chosen.0).then(|| {
                let pending = area == Area::Input && self.switched_in == session.history().scans();
                (self.chosen.1, self.switched.get(&(byte, self.chosen.1)).copied().filter(|_| pending))
            }),
        });
        let bytes = bytes.collect();
        let valued = |name: &Name| (shown(name.text()), shown(&session.value(name)));
        let watched: Vec<(String, String)> = session.watched().iter().map(valued).collect();
        let here = view.next.as_ref().or(view.executed.as_ref()).map(|line| line.place.block);
        let on_registers = session.on_registers(here);
        let is_watched = |name: &&Name| !session.watched().iter().any(|watched| watched.operand() == name.operand());
        let used = self.values.from(here).into_iter().filter(is_watched).map(valued).collect();
        let variables = if self.variables || !on_registers { variables(session, on_registers) } else { Vec::new() };
        let hits = view.hits.join("; ");
        Picture {
            language: session.language,
            colour: self.colour,
            focus: self.focus,
            stack: shown(&view.stack.iter().map(|&block| session.listing().called(block)).collect::<Vec<_>>().join(" › ")),
            registers: session.registers(),
            four_accumulators: session.build().cpu.accumulators == 4,
            file: shown(file.name.rsplit(['/', '\\']).next().unwrap_or(&file.name)),
            lines,
            cursor: self.cursor,
            bytes,
            watched,
            used,
            on_registers,
            only_variables: self.variables,
            variables,
            diagram,
            statement: view.executed.as_ref().map_or_else(String::new, |line| shown(line.said(session.language))),
            reason: shown(&session.reason()),
            message: shown(if self.message.is_empty() { &hits } else { &self.message }),
            prompt: self.prompt.clone(),
            help: self.help,
            view,
        }
    }
}

/// The variables of the block that runs, or those that the program keeps; single ones before the parts of others. ST calls them without `#`.
fn variables(session: &Session, on_registers: bool) -> Vec<(String, Vec<(String, String)>)> {
    let value = |one: &LocalValue| {
        let name = one.name.text();
        let value = match &one.value {
            None => "-".to_owned(),
            Some(Shown::Bit(bit)) if !on_registers => if *bit { "TRUE" } else { "FALSE" }.to_owned(),
            Some(value) => shown(&value.readable()),
        };
        (shown(if on_registers { name } else { name.trim_start_matches('#') }), value)
    };
    let of = |all: Variables| {
        let mut values: Vec<(String, String)> = all.values.iter().map(value).collect();
        values.sort_by_key(|(name, _)| name.matches(['.', '[']).count());
        (shown(&session.owner(&all)), values)
    };
    session.locals().into_iter().map(of).collect()
}

/// Accumulators and address registers bit by bit, below the numbers of the bits; beside them the number or pointer that they are.
fn register_bits(session: &mut Session) -> (String, Vec<String>) {
    let language = session.language;
    let registers = session.registers();
    let four = session.build().cpu.accumulators == 4;
    let binary = |bits: u64| Format::Bin.show(&Kind::Bits(32), &Content::Bits(bits & u64::from(u32::MAX)));
    let accumulator = |number: u32, bits: u64| {
        let name = pick(language, ["ACCU", "AKKU"]);
        format!("{name}{number} {}  {}", binary(bits).text, bits as u32 as i32)
    };
    let pointer_register = |number: u32, bits: u64| format!("AR{number}   {}  {}", binary(bits).text, pointer(bits));
    let numbers = binary(0).details.concat();
    let mut lines = vec![format!("      {numbers}")];
    lines.extend([accumulator(1, registers.accu1), accumulator(2, registers.accu2)]);
    lines.extend([pointer_register(1, registers.ar1), pointer_register(2, registers.ar2)]);
    if four {
        lines.extend([accumulator(3, registers.accu3), accumulator(4, registers.accu4)]);
    }
    lines.extend(pointers(session));
    (pick(language, ["Registers, bit by bit", "Register, Bit für Bit"]).to_owned(), lines)
}

/// The parameters of the block that are a POINTER or an ANY, with their fields.
fn pointers(session: &Session) -> Vec<String> {
    let block = session.here();
    let fields = |one: &LocalValue| {
        let format = match one.name.kind() {
            Kind::Typed(DataType::Pointer) => Format::Pointer,
            Kind::Typed(DataType::Any) => Format::Any,
            _ => return Vec::new(),
        };
        let Ok(name) = session.name_in(&format!("{}:{format}", one.name.text()), block) else { return Vec::new() };
        let details = names::details(&name, session.cpu());
        let first = format!("{} {}", one.name.text(), session.value(&name));
        [first].into_iter().chain(details.into_iter().map(|line| format!("      {line}"))).map(|line| shown(&line)).collect()
    };
    session.locals().iter().filter(|of| of.data_block.is_none()).flat_map(|of| &of.values).flat_map(fields).collect()
}

/// A text in which nothing commands the terminal.
fn shown(text: &str) -> String {
    visible(text).into_owned()
}

/// A pointer as it stands among the registers.
pub(super) fn pointer(bits: u64) -> String {
    Value::Pointer(bits as u32).spell()
}
