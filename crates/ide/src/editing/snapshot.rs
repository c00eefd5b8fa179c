//! The texts of a project at a moment, and what is known of each.

use std::collections::HashMap;
use std::sync::Arc;

use sieben_lang::language::Language;
use sieben_lang::names::{At, DefId, Found, Names, Occurrence, SourceNames, of_system};
use sieben_lang::source_names::{of_library, of_source, of_symbols};
use sieben_lang::{Options, names};
use sieben_model::mnemonics::Mnemonics;

use super::{Bytes, Edit, Place, Position, TextId};

/// What a text is in its project.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// A source of any language, also a test file.
    Source,
    /// A symbol table in any format.
    Symbols,
    /// Something that has no names of the program.
    Other,
}

/// A text of a project.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text {
    /// Its path or name.
    pub name: String,
    /// What it says, in UTF-8, line ends as they came.
    pub text: Arc<str>,
    /// What it is.
    pub role: Role,
    /// Why services must not change it, as a sentence; `None` where they may: "`a.awl` is read with the wrong encoding".
    pub fixed: Option<String>,
}

/// The texts of a project at a moment. A copy is cheap.
#[derive(Clone, Debug)]
pub struct Snapshot {
    texts: Arc<Vec<Text>>,
    languages: Arc<Vec<Option<Language>>>,
    names: Arc<Names>,
    system: Arc<SourceNames>,
    options: Arc<Options>,
}

impl Snapshot {
    /// A project with these texts.
    pub fn new(texts: Vec<Text>, options: &Options) -> Self {
        Self::build(texts, options, None)
    }

    /// The project with other texts or options; what is known of a text that is the same is kept.
    pub fn changed(&self, texts: Vec<Text>, options: &Options) -> Self {
        Self::build(texts, options, Some(self))
    }

    /// The project after edits, which are in the order of their places.
    pub(crate) fn with_edits(&self, edits: &[Edit]) -> Self {
        let mut texts = self.texts.to_vec();
        for edits in edits.chunk_by(|one, next| one.place.text == next.place.text) {
            let Some(text) = edits.first().and_then(|edit| texts.get_mut(edit.place.text.0)) else { continue };
            let mut edited = String::with_capacity(text.text.len());
            let mut at = 0;
            for edit in edits {
                edited.push_str(text.text.get(at..edit.place.range.start).unwrap_or_default());
                edited.push_str(&edit.new_text);
                at = edit.place.range.end;
            }
            edited.push_str(text.text.get(at..).unwrap_or_default());
            text.text = Arc::from(edited);
        }
        Self::build(texts, &self.options, Some(self))
    }

    fn build(texts: Vec<Text>, options: &Options, before: Option<&Self>) -> Self {
        let before = before.filter(|before| (before.options.mnemonics, before.options.dialect) == (options.mnemonics, options.dialect));
        let known: HashMap<&str, usize> = before
            .map(|before| before.texts.iter().enumerate().map(|(index, text)| (text.name.as_str(), index)).collect())
            .unwrap_or_default();
        let mut languages = Vec::with_capacity(texts.len());
        let mut sources: Vec<Arc<SourceNames>> = Vec::with_capacity(texts.len() + of_library().len() + 1);
        for (index, text) in texts.iter().enumerate() {
            let same = before.and_then(|before| {
                let known = *known.get(text.name.as_str())?;
                let old = before.texts.get(known)?;
                let is_same = old.role == text.role && (Arc::ptr_eq(&old.text, &text.text) || old.text == text.text);
                is_same.then(|| (before.languages.get(known).copied().flatten(), before.names.texts().get(known).cloned()))
            });
            if let Some((language, Some(names))) = same {
                languages.push(language);
                sources.push(names);
                continue;
            }
            let (language, names) = match text.role {
                Role::Source => {
                    let language = Language::of(&text.name, &text.text, options.dialect);
                    let language = match language {
                        // A test file is written in the dialect of the sources before it.
                        Language::St(dialect) if language.is_of_tests() => {
                            let first =
                                texts[..index].iter().zip(&languages).find_map(|(_, language)| language.and_then(Language::dialect));
                            Language::St(first.unwrap_or(dialect).for_tests())
                        }
                        other => other,
                    };
                    (Some(language), of_source(&text.name, &text.text, language, options))
                }
                Role::Symbols => (None, of_symbols(&text.name, &text.text)),
                Role::Other => (None, SourceNames::default()),
            };
            languages.push(language);
            sources.push(Arc::new(names));
        }
        let system = match before {
            Some(before) if before.options.system_blocks.len() == options.system_blocks.len() => Arc::clone(&before.system),
            _ => Arc::new(of_system(&options.system_blocks)),
        };
        sources.push(Arc::clone(&system));
        sources.extend(of_library().iter().cloned());
        Self {
            texts: Arc::new(texts),
            languages: Arc::new(languages),
            names: Arc::new(Names::new(sources)),
            system,
            options: Arc::new(options.clone()),
        }
    }

    /// All texts.
    pub fn texts(&self) -> &[Text] {
        &self.texts
    }

    /// A text; `None` if there is none of this number.
    pub fn text(&self, text: TextId) -> Option<&Text> {
        self.texts.get(text.0)
    }

    /// The text with this name.
    pub fn find(&self, name: &str) -> Option<TextId> {
        self.texts.iter().position(|text| text.name == name).map(TextId)
    }

    /// The language of a text that is a source.
    pub fn language(&self, text: TextId) -> Option<Language> {
        self.languages.get(text.0).copied().flatten()
    }

    /// The names of the project.
    pub(crate) fn names(&self) -> &Names {
        &self.names
    }

    /// The names of a text.
    pub(crate) fn of_text(&self, text: TextId) -> Option<&SourceNames> {
        self.text(text)?;
        self.names.text(text.0 as u32)
    }

    /// The mnemonic language of a text, or else that of the project.
    pub(crate) fn mnemonics(&self, text: TextId) -> Mnemonics {
        self.of_text(text).and_then(|names| names.mnemonics).or(self.options.mnemonics).unwrap_or_default()
    }

    /// The mnemonic language that the whole project is shown in: that of most sources of STL.
    pub(crate) fn usual_mnemonics(&self) -> Mnemonics {
        if let Some(mnemonics) = self.options.mnemonics {
            return mnemonics;
        }
        let all = self.names.texts().iter().take(self.texts.len()).filter_map(|names| names.mnemonics);
        let (mut german, mut english) = (0, 0);
        all.for_each(|mnemonics| if mnemonics == Mnemonics::German { german += 1 } else { english += 1 });
        if german > english { Mnemonics::German } else { Mnemonics::English }
    }

    /// A byte of a text that is no further than its end and begins a character.
    pub(crate) fn offset(&self, position: Position) -> Option<usize> {
        let text = self.text(position.text)?;
        let mut offset = position.offset.min(text.text.len());
        while !text.text.is_char_boundary(offset) {
            offset -= 1;
        }
        Some(offset)
    }

    /// The occurrence at a position, and what it stands for.
    pub(crate) fn named(&self, position: Position) -> Option<(u32, Occurrence, DefId)> {
        let offset = self.offset(position)?;
        let names = self.of_text(position.text)?;
        let index = names.at(offset)?;
        let one = *names.occurrence(index)?;
        Some((index, one, self.names.resolve(position.text.0 as u32, index)?))
    }

    /// The bytes of a text.
    pub(crate) fn slice(&self, text: TextId, bytes: Bytes) -> &str {
        self.text(text).and_then(|text| text.text.get(bytes.start..bytes.end)).unwrap_or_default()
    }

    /// Where a use stands, if that is in a text of the user.
    pub(crate) fn place_of(&self, found: Found) -> Option<Place> {
        let text = TextId(found.text as usize);
        let one = self.of_text(text)?.occurrence(found.occurrence)?;
        Some(Place { text, range: one.span.into() })
    }

    /// Where the name of a definition and the whole of it stand, if that is in a text of the user.
    pub(crate) fn places_of(&self, (text, index): At) -> Option<(Place, Place)> {
        let id = TextId(text as usize);
        let definition = self.of_text(id)?.definition(index)?;
        Some((Place { text: id, range: definition.span.into() }, Place { text: id, range: definition.whole.into() }))
    }
}

impl From<names::Bytes> for Bytes {
    fn from(bytes: names::Bytes) -> Self {
        Self { start: bytes.start as usize, end: bytes.end as usize }
    }
}
