//! The languages that Sieben speaks to people; messages for programs, such as JSON, are English.

/// The language of a sentence; that of the mnemonics is the source's own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// German.
    German,
}

impl Language {
    /// Both.
    pub const ALL: [Self; 2] = [Self::English, Self::German];

    /// The language with this code, `en` or `de`.
    pub fn from_code(code: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|language| language.code() == code)
    }

    /// The language of a locale as the environment names it, such as `de_AT.UTF-8`: English for all that are not German.
    pub fn of_locale(locale: &str) -> Self {
        let code = locale.split(['_', '.', '@', '-']).next().unwrap_or_default();
        if code.eq_ignore_ascii_case("de") { Self::German } else { Self::English }
    }

    /// Its code, `en` or `de`.
    pub fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
        }
    }
}

/// A text in English and German.
pub type Text = [&'static str; 2];

/// One of two texts.
pub fn pick(language: Language, [english, german]: Text) -> &'static str {
    match language {
        Language::English => english,
        Language::German => german,
    }
}

/// A text with values in their places.
pub fn fill(language: Language, text: Text, values: &[&dyn std::fmt::Display]) -> String {
    let mut out = String::new();
    let mut rest = pick(language, text);
    while let Some((before, after)) = rest.split_once('{') {
        out.push_str(before);
        let (index, after) = after.split_once('}').unwrap_or((after, ""));
        if let Some(value) = index.parse::<usize>().ok().and_then(|index| values.get(index)) {
            out.push_str(&value.to_string());
        }
        rest = after;
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_locale_names_its_language_first() {
        let german = ["de", "de_DE", "de_AT.UTF-8", "DE", "de@euro", "de-CH"];
        assert!(german.iter().all(|locale| Language::of_locale(locale) == Language::German));
        let others = ["", "C", "C.UTF-8", "POSIX", "en_US.UTF-8", "dev", "den_DE", "nl_DE"];
        assert!(others.iter().all(|locale| Language::of_locale(locale) == Language::English));
    }

    #[test]
    fn values_stand_where_the_text_of_each_language_wants_them() {
        let text = ["{0} of {1}", "von {1} die {0}"];
        assert_eq!(fill(Language::English, text, &[&1, &"two"]), "1 of two");
        assert_eq!(fill(Language::German, text, &[&1, &"two"]), "von two die 1");
        assert_eq!(fill(Language::English, ["a { b", ""], &[]), "a ");
    }
}
