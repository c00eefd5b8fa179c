//! Collects proposals that have the letters typed so far.

use sieben_lang::language::Language;
use sieben_lang::names::{DefId, Definition, DefinitionKind};
use sieben_lang::source_names::{is_identifier, key};
use sieben_lang::st::standard::catalogue::page;
use sieben_model::address::Operand;

use super::super::context::{Quoting, Typed, quotes_names, resolve};
use super::super::{Bytes, Position, Snapshot, hover, symbols};
use super::{Completion, ITEMS_MAX, Item, Kind};

pub(super) struct Collector<'s> {
    pub(super) snapshot: &'s Snapshot,
    pub(super) position: Position,
    pub(super) typed: &'s Typed,
    letters: Vec<char>,
    range: Bytes,
    items: Vec<(usize, Item)>,
}

/// How much a proposal belongs to the place: the order of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    Parameter,
    Local,
    Fitting,
    Other,
    Word,
}

impl<'s> Collector<'s> {
    pub(super) fn new(snapshot: &'s Snapshot, position: Position, typed: &'s Typed) -> Self {
        let letters = typed.word.text.to_lowercase().chars().filter(|letter| !letter.is_whitespace()).collect();
        // The closing quote belongs to what is replaced.
        let after = snapshot.slice(position.text, Bytes { start: position.offset, end: position.offset + 1 });
        let is_closed = typed.word.quoting == Quoting::Global && after == "\"";
        let range = Bytes { start: typed.start, end: position.offset + usize::from(is_closed) };
        Self { snapshot, position, typed, letters, range, items: Vec::new() }
    }

    pub(super) fn language(&self) -> Option<Language> {
        self.snapshot.language(self.position.text)
    }

    /// Adds a proposal if it has the letters.
    pub(super) fn add(&mut self, rank: Rank, kind: Kind, label: &str, new_text: String, detail: String, documentation: String) {
        self.item(rank, kind, label, new_text, detail, documentation, false);
    }

    /// Adds a text with places to fill in.
    pub(super) fn snippet(&mut self, rank: Rank, kind: Kind, label: &str, new_text: String, detail: String) {
        self.item(rank, kind, label, new_text, detail, String::new(), true);
    }

    #[allow(clippy::too_many_arguments)] // The columns of a proposal.
    fn item(&mut self, rank: Rank, kind: Kind, label: &str, new_text: String, detail: String, documentation: String, snippet: bool) {
        let name = label.trim_matches(['"', '#']);
        let Some(score) = symbols::score(name, &self.letters) else { return };
        let filter = match self.typed.word.quoting {
            Quoting::Bare => label.trim_start_matches(['"', '#']).to_owned(),
            Quoting::Global => format!("\"{name}"),
            Quoting::Local => format!("#{name}"),
        };
        let sort = format!("{}{score:05}{}", rank as u8, name.to_lowercase());
        let item = Item { label: label.to_owned(), kind, detail, documentation, range: self.range, new_text, snippet, filter, sort };
        self.items.push((score, item));
    }

    pub(super) fn finish(mut self) -> Completion {
        self.items.sort_by(|(_, one), (_, other)| one.sort.cmp(&other.sort));
        self.items.dedup_by(|(_, one), (_, other)| one.label == other.label && one.new_text == other.new_text);
        let incomplete = self.items.len() > ITEMS_MAX;
        self.items.truncate(ITEMS_MAX);
        Completion { items: self.items.into_iter().map(|(_, item)| item).collect(), incomplete }
    }

    /// The members of what stands before the point.
    pub(super) fn members(&mut self) {
        let names = self.snapshot.names();
        let Some(target) = resolve(self.snapshot, self.position, &self.typed.path) else { return };
        let quotes = self.language().is_some_and(quotes_names);
        for at in names.members(target) {
            let Some(definition) = names.definition_at(at) else { continue };
            // Of a block of the library only its parameters are meant for others.
            let is_inner = definition.kind == DefinitionKind::Static && names.text(at.0).is_some_and(|text| text.is_built_in);
            if is_inner || matches!(definition.kind, DefinitionKind::Label | DefinitionKind::Temp) {
                continue;
            }
            let plain = self.language().is_none_or(|language| is_identifier(&definition.name, language));
            let new_text = if plain || !quotes { definition.name.clone() } else { format!("\"{}\"", definition.name) };
            let kind = if definition.kind == DefinitionKind::EnumValue { Kind::Constant } else { Kind::Field };
            self.add(Rank::Local, kind, &definition.name, new_text, detail(definition), definition.comment.clone());
        }
    }

    /// What the block around the position declares, if it fits.
    pub(super) fn locals(&mut self, mark: &str, fits: impl Fn(&Definition) -> bool) {
        let names = self.snapshot.names();
        let Some(source) = self.snapshot.of_text(self.position.text) else { return };
        let mut scope = source.scope_at(self.position.offset);
        while let Some(index) = scope {
            let Some(block) = source.definition(index) else { return };
            let of = names.of_definition((self.position.text.0 as u32, index));
            for at in of.map(|of| names.members(of)).unwrap_or_default() {
                let Some(definition) = names.definition_at(at).filter(|one| one.kind != DefinitionKind::Label) else { continue };
                if fits(definition) && definition.name != "RET_VAL" {
                    let is_word = definition.name.chars().all(super::super::context::in_word);
                    let new_text = match (mark, is_word) {
                        ("#", false) => format!("#\"{}\"", definition.name),
                        _ => format!("{mark}{}", definition.name),
                    };
                    let label = format!("{mark}{}", definition.name);
                    self.add(Rank::Local, Kind::Variable, &label, new_text, detail(definition), definition.comment.clone());
                }
            }
            scope = block.parent;
        }
    }

    /// The labels of the block around the position.
    pub(super) fn labels(&mut self) {
        let Some(source) = self.snapshot.of_text(self.position.text) else { return };
        let Some(block) = source.scope_at(self.position.offset).and_then(|scope| source.definition(scope)) else { return };
        let labels = block.members.iter().filter_map(|&member| source.definition(member));
        for label in labels.filter(|one| one.kind == DefinitionKind::Label) {
            self.add(Rank::Local, Kind::Label, &label.name, label.name.clone(), "label".to_owned(), String::new());
        }
    }

    /// How something global is written here.
    fn global_name(&self, name: &str) -> String {
        let quotes = self.language().is_some_and(quotes_names);
        if quotes { format!("\"{name}\"") } else { name.to_owned() }
    }

    /// The symbols whose addresses fit.
    pub(super) fn symbols(&mut self, fits: impl Fn(Operand) -> bool) {
        let names = self.snapshot.names();
        let mnemonics = self.snapshot.mnemonics(self.position.text);
        let quotes = self.language().is_some_and(quotes_names);
        for (name, at) in names.symbols() {
            if symbols::score(name, &self.letters).is_none() {
                continue;
            }
            let Some(row) = names.definition_at(at) else { continue };
            let Some(operand) = row.operand.filter(|operand| !matches!(operand, Operand::Block(_)) && fits(*operand)) else { continue };
            if !quotes && self.language().is_some_and(|language| !is_identifier(&row.name, language)) {
                continue;
            }
            let written = self.global_name(&row.name);
            let detail = format!("{} {}", operand.spell(mnemonics), row.data_type);
            self.add(Rank::Fitting, Kind::Symbol, &written.clone(), written, detail.trim().to_owned(), row.comment.clone());
        }
    }

    /// The blocks, types and global names of the project that fit, each with how it is written.
    pub(super) fn globals(&self, fits: impl Fn(&Definition) -> bool) -> Vec<(String, &'s Definition, DefId)> {
        let names = self.snapshot.names();
        let mut found = Vec::new();
        let quotes = self.language().is_some_and(quotes_names);
        let is_st = self.language().is_some_and(|language| language.dialect().is_some());
        let mut seen = std::collections::HashSet::new();
        for (_, all) in names.globals() {
            for &at in all {
                let Some(definition) = names.definition_at(at).filter(|one| fits(one) && !one.name.is_empty()) else { continue };
                let is_own = self.snapshot.places_of(at).is_some();
                // STL calls blocks with numbers; functions of ST have pages of their own.
                let is_known = match (is_st, definition.operand) {
                    (false, operand) => operand.is_some(),
                    (true, operand) => {
                        definition.kind == DefinitionKind::FunctionBlock && (operand.is_some() || page(&definition.name).is_some())
                    }
                };
                if !is_own && !is_known {
                    continue;
                }
                let Some(target) = names.of_definition(at) else { continue };
                // A block of the project takes the place of one of the library with its number.
                if !names.heads(target).contains(&at) || !seen.insert(target) {
                    continue;
                }
                let symbol = names.operand(target).and_then(|operand| names.symbol_of(operand));
                let name = symbol.map_or(definition.name.as_str(), |symbol| symbol.name.as_str());
                if symbols::score(name, &self.letters).is_none() {
                    continue;
                }
                let is_number = symbol.is_none() && Operand::parse(name).is_some();
                let written = match (is_number, definition.kind) {
                    (true, _) if quotes => name.to_owned(),
                    (true, _) => name.replace(' ', ""),
                    (false, DefinitionKind::Constant | DefinitionKind::EnumValue | DefinitionKind::Global) if !quotes => name.to_owned(),
                    _ => self.global_name(name),
                };
                found.push((written, definition, target));
            }
        }
        found
    }

    /// What is of the project comes before what is of the library.
    pub(super) fn rank(&self, target: DefId) -> Rank {
        let is_own = self.snapshot.names().heads(target).into_iter().any(|at| self.snapshot.places_of(at).is_some());
        if is_own { Rank::Fitting } else { Rank::Other }
    }

    /// The parameters of the call around the position that are not given yet, each with what assigns it.
    pub(super) fn parameters(&mut self, of: DefId, given: &[String], sign: impl Fn(&Definition) -> &'static str) {
        for parameter in super::super::signature::parameters(self.snapshot, of) {
            let is_st = self.language().is_some_and(|language| language.dialect().is_some());
            if is_st && parameter.kind == DefinitionKind::Result {
                continue;
            }
            if given.iter().any(|known| key(known) == key(&parameter.name)) || parameter.name.is_empty() {
                continue;
            }
            let new_text = format!("{} {} ", parameter.name, sign(parameter));
            self.add(Rank::Parameter, Kind::Parameter, &parameter.name, new_text, detail(parameter), parameter.comment.clone());
        }
    }
}

/// Kind and type of a definition in a few words.
pub(super) fn detail(definition: &Definition) -> String {
    let address = definition.operand.map(|operand| operand.spell(Default::default())).unwrap_or_default();
    let parts = [hover::word(definition.kind), definition.data_type.as_str(), address.as_str()];
    parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ")
}
