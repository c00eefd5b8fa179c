//! `FUNCTIONBLOCK` and `END_FUNCTIONBLOCK`: words of blocks without the underline.

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};

use crate::st::keywords::Keyword;
use crate::st::lexer::{Raw, Token};

/// What is written, what is meant, and the keyword.
const WORDS: &[(&str, &str, Keyword)] = &[
    ("FUNCTIONBLOCK", "FUNCTION_BLOCK", Keyword::FunctionBlock),
    ("ORGANIZATIONBLOCK", "ORGANIZATION_BLOCK", Keyword::OrganizationBlock),
    ("DATABLOCK", "DATA_BLOCK", Keyword::DataBlock),
    ("END_FUNCTIONBLOCK", "END_FUNCTION_BLOCK", Keyword::EndFunctionBlock),
    ("ENDFUNCTIONBLOCK", "END_FUNCTION_BLOCK", Keyword::EndFunctionBlock),
    ("ENDFUNCTION_BLOCK", "END_FUNCTION_BLOCK", Keyword::EndFunctionBlock),
    ("ENDFUNCTION", "END_FUNCTION", Keyword::EndFunction),
    ("ENDPROGRAM", "END_PROGRAM", Keyword::EndProgram),
    ("END_ORGANIZATIONBLOCK", "END_ORGANIZATION_BLOCK", Keyword::EndOrganizationBlock),
    ("END_DATABLOCK", "END_DATA_BLOCK", Keyword::EndDataBlock),
];

/// Reads such a word as the keyword, with a message, where it stands at the beginning of a line: one that begins something before a name
/// on its line, one that ends something alone.
pub(super) fn read(file: FileId, text: &str, tokens: &mut [Token], diagnostics: &mut Vec<Diagnostic>) {
    let mut line_begins = true;
    for index in 0..tokens.len() {
        let token = tokens[index];
        if token.raw.is_trivia() || token.raw == Raw::Newline {
            line_begins |= token.raw == Raw::Newline;
            continue;
        }
        let begins = std::mem::replace(&mut line_begins, false);
        let word = &text[token.start as usize..token.end as usize];
        if !begins || token.raw != Raw::Word || token.keyword.is_some() {
            continue;
        }
        let Some(&(_, right, keyword)) = WORDS.iter().find(|(written, ..)| word.eq_ignore_ascii_case(written)) else { continue };
        let next = tokens[index + 1..].iter().find(|next| next.raw == Raw::Newline || !next.raw.is_trivia()).map(|next| next.raw);
        let fits = match keyword.is_end() {
            true => matches!(next, None | Some(Raw::Newline | Raw::End | Raw::Semicolon)),
            false => matches!(next, Some(Raw::Word | Raw::Quoted)),
        };
        if !fits {
            continue;
        }
        tokens[index].keyword = Some(keyword);
        let span = Span::new(file, token.start, token.end);
        let message = format!("`{word}` is no word of ST: did you mean `{right}`?");
        diagnostics.push(Diagnostic::new(Problem::P6058, span, message).fix(span, right, format!("write `{right}`")));
    }
}
