//! The reserved words of ST and SCL, by what they are: for editors that colour texts.

use super::dialect::Dialect;
use super::keywords::Keyword;

/// A kind of words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Begins or ends a block, a type or a test.
    Block,
    /// Begins or ends declarations.
    Declaration,
    /// Directs the flow of statements, or ends what does.
    Control,
    /// Combines values.
    Operator,
    /// Is a value.
    Constant,
    /// Is none of these: `OF`, `THIS`.
    Other,
}

/// A reserved word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// It, in capital letters.
    pub word: &'static str,
    /// What it is.
    pub kind: Kind,
    /// Whether no dialect reserves it: it is one in test files alone.
    pub of_tests: bool,
    keyword: Keyword,
}

impl Word {
    /// Whether a dialect reserves it.
    pub fn is_of(&self, dialect: Dialect) -> bool {
        Keyword::of(self.word, dialect) == Some(self.keyword)
    }
}

/// All words, sorted.
pub fn all() -> impl Iterator<Item = Word> {
    Keyword::all().map(|keyword| Word { word: keyword.word(), kind: kind(keyword), of_tests: keyword.is_of_tests(), keyword })
}

fn kind(keyword: Keyword) -> Kind {
    use Keyword as K;
    match keyword {
        K::And | K::AndThen | K::Div | K::Mod | K::Not | K::Or | K::OrElse | K::Xor => Kind::Operator,
        K::False | K::Nil | K::Null | K::True => Kind::Constant,
        K::Array | K::Super | K::This => Kind::Other,
        K::Struct | K::EndStruct | K::Union | K::EndUnion | K::EndVar | K::EndConst | K::EndLabel => Kind::Declaration,
        keyword if keyword.begins_section() => Kind::Declaration,
        K::By | K::Catch | K::Do | K::Else | K::Elsif | K::Finally | K::Of | K::Then | K::To | K::Until => Kind::Control,
        keyword if keyword.begins_statement() || keyword.ends_statement() => Kind::Control,
        _ => Kind::Block,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_begins_is_of_the_kind_of_what_ends_it() {
        let words: Vec<Word> = all().collect();
        for word in &words {
            let end = ["END_", "__END"].map(|start| format!("{start}{}", word.word.trim_start_matches("__")));
            if let Some(end) = words.iter().find(|other| end.iter().any(|end| other.word == end)) {
                assert_eq!(word.kind, end.kind, "{}", word.word);
            }
        }
    }

    #[test]
    fn a_word_knows_its_dialects() {
        let named = |name: &str| all().find(|word| word.word == name).expect("a word");
        assert!(named("REGION").is_of(Dialect::Tia) && !named("REGION").is_of(Dialect::Scl));
        assert!(named("END_TEST").of_tests && !named("IF").of_tests);
    }
}
