//! The texts of a project at a moment, and what is known of each.

use std::sync::Arc;

use sieben_lang::Options;

use super::TextId;

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
}

impl Snapshot {
    /// A project with these texts.
    pub fn new(texts: Vec<Text>, options: &Options) -> Self {
        let _ = options;
        Self { texts: Arc::new(texts) }
    }

    /// The project with other texts or options; what is known of a text that is the same is kept.
    pub fn changed(&self, texts: Vec<Text>, options: &Options) -> Self {
        Self::new(texts, options)
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
}
