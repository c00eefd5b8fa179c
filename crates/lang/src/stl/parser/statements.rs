//! Networks and statements: labels, instruction words, CALL with its parameters.

use std::collections::{HashMap, HashSet};

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::Span;

use super::blocks::Keyword;
use super::{DIAGNOSTICS_MAX, OTHER_ALPHABET, Parser, latin};
use crate::stl::ast::{Argument, Block, Call, Operand, Statement, Word};
use crate::stl::extension::PREFIX;
use crate::stl::instructions::Instruction;
use crate::stl::lexer::{Raw, in_word, token};
use crate::stl::mnemonics::{instruction_in, translate_instruction};
use crate::stl::operands::OperandClass;
use crate::stl::syntax::SyntaxKind;

/// A label has at most this many characters.
pub(super) const LABEL_MAX: usize = 4;

/// Words of IEC instruction list and of ladder logic, and the STL instructions that do the same.
const ELSEWHERE: &[(&[&str], &[&str])] = &[
    (&["AND", "UND"], &["A"]),
    (&["ANDN"], &["AN"]),
    (&["OR", "ODER"], &["O"]),
    (&["ORN"], &["ON"]),
    (&["XOR"], &["X"]),
    (&["LD", "LOAD"], &["A", "L"]),
    (&["LDN"], &["AN"]),
    (&["ST", "STORE", "OUT"], &["=", "T"]),
    (&["MOV", "MOVE"], &["L", "T"]),
    (&["JMP", "GOTO"], &["JU"]),
    (&["JMPC"], &["JC"]),
    (&["JMPCN"], &["JCN"]),
    (&["CAL"], &["CALL"]),
    (&["RET"], &["BEC", "BEU"]),
    (&["RETC"], &["BEC"]),
    (&["ADD"], &["+I", "+D", "+R"]),
    (&["SUB"], &["-I", "-D", "-R"]),
    (&["MUL"], &["*I", "*D", "*R"]),
    (&["DIV"], &["/I", "/D", "/R"]),
    (&["EQ"], &["==I", "==D", "==R"]),
    (&["NE"], &["<>I", "<>D", "<>R"]),
    (&["GT"], &[">I", ">D", ">R"]),
    (&["GE"], &[">=I", ">=D", ">=R"]),
    (&["LT"], &["<I", "<D", "<R"]),
    (&["LE"], &["<=I", "<=D", "<=R"]),
    (&["TP"], &["SE"]),
    (&["TON"], &["SD"]),
    (&["TOF"], &["SF"]),
    (&["CTU"], &["CU"]),
    (&["CTD"], &["CD"]),
];

/// Words that begin a statement of Structured Text.
const STRUCTURED_TEXT: &[&str] = &[
    "IF",
    "ELSIF",
    "ELSE",
    "END_IF",
    "CASE",
    "END_CASE",
    "FOR",
    "END_FOR",
    "WHILE",
    "END_WHILE",
    "REPEAT",
    "UNTIL",
    "END_REPEAT",
    "RETURN",
    "EXIT",
];

impl Parser<'_> {
    /// Networks and statements up to the end of the block, the beginning of another one or the end of the source.
    pub(super) fn code(&mut self, block: &mut Block) {
        loop {
            self.trivia();
            self.network_comment(block);
            if let Some(drawing) = self.drawing_here(block).filter(|_| self.at_diagram()) {
                self.diagram(block, drawing);
                continue;
            }
            if self.at_heading() {
                return;
            }
            if self.printed_mark(block) {
                continue;
            }
            if let Some(label) = self.label() {
                self.statement(block, label);
                continue;
            }
            match self.raw {
                Raw::End => return,
                Raw::Semicolon => {
                    self.bump(SyntaxKind::Semicolon);
                    continue;
                }
                _ => {}
            }
            match self.keyword() {
                None => {
                    let checkpoint = self.builder.checkpoint();
                    self.start_at(checkpoint, SyntaxKind::Statement);
                    self.plain_statement(block, None);
                    self.finish();
                }
                Some(Keyword::BlockStart(_) | Keyword::BlockEnd(_)) => return,
                Some(Keyword::Network) => self.network(block),
                Some(Keyword::Title) => self.network_title(block),
                Some(Keyword::Section(section)) => {
                    if !block.implicit {
                        let message = format!("{} stands behind BEGIN; declarations belong before it", self.shown());
                        self.error(Problem::P2019, self.position, self.end, message);
                    }
                    let section = self.section(section);
                    block.sections.push(section);
                }
                Some(Keyword::Begin) if block.implicit && block.statements.is_empty() => {
                    self.bump(SyntaxKind::Keyword);
                }
                Some(_) => {
                    let message = format!("{} does not belong between statements", self.shown());
                    self.error(Problem::P2019, self.position, self.end, message);
                    self.bump(SyntaxKind::Keyword);
                    self.statement_end();
                }
            }
        }
    }

    /// Comments directly under NETWORK and its TITLE belong to the network.
    fn network_comment(&mut self, block: &mut Block) {
        if self.comments.is_empty() {
            return;
        }
        let count = block.statements.len();
        let comment = match block.networks.last() {
            Some(network) if network.first_statement == count && network.comment.is_empty() => self.take_comments(),
            _ => return self.comments.clear(),
        };
        if let Some(network) = block.networks.last_mut() {
            network.comment = comment;
        }
    }

    /// A word before a colon.
    fn label(&mut self) -> Option<(Word, rowan::Checkpoint)> {
        if self.raw != Raw::Word || self.raw_behind_blanks() != Raw::Colon {
            return None;
        }
        let checkpoint = self.builder.checkpoint();
        let word = self.name_word(SyntaxKind::Label);
        self.blanks();
        self.bump(SyntaxKind::Punctuation);
        Some((word, checkpoint))
    }

    fn statement(&mut self, block: &mut Block, (label, checkpoint): (Word, rowan::Checkpoint)) {
        self.start_at(checkpoint, SyntaxKind::Statement);
        self.blanks();
        self.ellipsis();
        let only_label = self.at_statement_end() || self.keyword().is_some() || self.label_follows();
        if only_label {
            let place = label.span.end as usize;
            let span = self.span(place, place);
            let mnemonic = Word { text: String::new(), span };
            block.statements.push(Statement { label: Some(label), mnemonic, operand: Operand::None, operand_span: span, span });
            if self.raw == Raw::Semicolon {
                self.bump(SyntaxKind::Semicolon);
            }
        } else {
            self.plain_statement(block, Some(label));
        }
        self.finish();
    }

    fn label_follows(&self) -> bool {
        self.raw == Raw::Word && self.raw_behind_blanks() == Raw::Colon
    }

    fn plain_statement(&mut self, block: &mut Block, label: Option<Word>) {
        let start = self.position;
        let Some(mnemonic) = self.mnemonic() else {
            self.unknown_statement();
            if let Some(label) = label {
                let span = self.span(start, self.position);
                let mnemonic = Word { text: String::new(), span };
                block.statements.push(Statement { label: Some(label), mnemonic, operand: Operand::Error, operand_span: span, span });
            }
            if self.raw == Raw::Semicolon {
                self.bump(SyntaxKind::Semicolon);
            }
            return;
        };
        let mut end = self.position;
        let mut operand_start = end;
        let mut operand = Operand::None;
        let behind = self.behind_blanks(end);
        if mnemonic.text.ends_with('(') {
            // A bracket has no operand; what follows on the line is the next statement even without `;`.
            self.blanks();
        } else if !matches!(token(self.text, behind).0, Raw::Semicolon | Raw::Newline | Raw::LineComment | Raw::End) {
            self.blanks();
            operand_start = self.position;
            operand = match mnemonic.text.as_str() {
                call if call.eq_ignore_ascii_case("CALL") => self.call(),
                extension if extension.starts_with(PREFIX) => self.extension_operands(),
                _ => {
                    let wants_label =
                        Instruction::candidates(&mnemonic.text, self.mnemonics).any(|row| row.operand() == OperandClass::Label);
                    self.start(SyntaxKind::Operand);
                    let operand = match self.step5_label(wants_label, &mnemonic) {
                        Some(operand) => operand,
                        None => self.operand(wants_label),
                    };
                    let operand = if wants_label { operand } else { self.spaced_name(operand) };
                    self.finish();
                    operand
                }
            };
            end = self.position.max(operand_start);
            operand = self.exchanged_registers(&mnemonic, operand, end);
        }
        self.report_foreign();
        let opens = mnemonic.text.ends_with('(');
        let operand_span = self.span(operand_start, end);
        let statement = Statement { label, mnemonic, operand, operand_span, span: self.span(start, end) };
        block.statements.push(statement);
        let over = std::mem::take(&mut self.statement_over)
            || (opens && !self.at_statement_end())
            || self.at_next_on_line()
            || self.lost_line_end();
        if !over {
            self.statement_end();
        }
    }

    /// `LAR2 AR1`: the instructions that copy one address register into the other begin with AR1.
    fn exchanged_registers(&mut self, mnemonic: &Word, operand: Operand, end: usize) -> Operand {
        let right = match mnemonic.text.to_ascii_uppercase().as_str() {
            "LAR2" => "TAR1 AR2",
            "TAR2" => "LAR1 AR2",
            _ => return operand,
        };
        if !matches!(&operand, Operand::Name { word, path } if path.is_empty() && word.text.eq_ignore_ascii_case("AR1")) {
            return operand;
        }
        let start = mnemonic.span.start as usize;
        let span = self.span(start, end);
        let message = format!("`{}` is written `{right}`", self.slice(start, end));
        self.report(Diagnostic::new(Problem::P2008, span, message).fix(span, right, format!("write `{right}`")));
        Operand::Error
    }

    /// Brackets are closed on the line of their last scan in many sources: `A( ; … )` needs no `;` before the `)`.
    fn at_next_on_line(&mut self) -> bool {
        token(self.text, self.behind_blanks(self.position)).0 == Raw::ParenClose && {
            self.blanks();
            true
        }
    }

    fn unknown_statement(&mut self) {
        let (start, end) = (self.position, self.end);
        let span = self.span(start, end);
        let shown = self.shown();
        let diagnostic = match self.raw {
            Raw::Unknown => {
                let diagnostic = Diagnostic::new(Problem::P1001, span, format!("{shown} is no character of STL"));
                if shown == "`#`" { diagnostic.help("a comment begins with `//`") } else { diagnostic }
            }
            Raw::Word | Raw::Local | Raw::Symbol if self.assigns() => {
                Diagnostic::new(Problem::P2001, span, format!("{shown} is no instruction"))
                    .help("STL assigns with instructions: `A` and `=` for a bit, `L` and `T` for a value")
            }
            Raw::Word => {
                let diagnostic = Diagnostic::new(Problem::P2001, span, format!("{shown} is no instruction"));
                match self
                    .known_elsewhere(self.current())
                    .or_else(|| self.similar(self.current()).map(|word| format!("did you mean `{word}`?")))
                {
                    Some(help) => diagnostic.help(help),
                    None => diagnostic,
                }
            }
            _ => Diagnostic::new(Problem::P2001, span, format!("{shown} where an instruction begins a statement")),
        };
        self.report(diagnostic);
        self.bump_unexpected();
        self.skip_statement();
    }

    /// Whether `:=` stands in the rest of this statement.
    pub(super) fn assigns(&self) -> bool {
        let mut at = self.end;
        loop {
            let (raw, end) = token(self.text, at);
            match raw {
                Raw::Becomes => return true,
                Raw::End | Raw::Newline | Raw::Semicolon | Raw::LineComment | Raw::ParenOpen => return false,
                _ => at = end,
            }
        }
    }

    /// What STL has for a word of another language of controllers; a similar looking instruction would mislead there.
    fn known_elsewhere(&self, word: &str) -> Option<String> {
        let word = word.to_ascii_uppercase();
        if STRUCTURED_TEXT.contains(&word.as_str()) {
            return Some("this looks like Structured Text or SCL; in STL a jump such as `JC` or `LOOP` does it".to_owned());
        }
        let (_, own) = ELSEWHERE.iter().find(|(words, _)| words.contains(&word.as_str()))?;
        let own: Vec<String> = own.iter().map(|&english| format!("`{}`", instruction_in(english, self.mnemonics))).collect();
        Some(format!("in STL this is {}", own.join(" or ")))
    }

    /// An instruction of the file's language that differs in one letter.
    fn similar(&self, word: &str) -> Option<&'static str> {
        let word = word.to_ascii_uppercase();
        if !(3..=6).contains(&word.len()) {
            return None;
        }
        let near = Instruction::ALL.iter().map(|row| row.mnemonic(self.mnemonics));
        // Of words that are equally near the one with the same letters: they were only exchanged.
        near.filter(|right| right.len() >= 2 && one_letter_apart(&word, right)).min_by_key(|right| !has_letters_of(&word, right))
    }

    fn knows(&self, word: &str) -> bool {
        Instruction::candidates(word, self.mnemonics).next().is_some()
    }

    /// The instruction word; nothing is taken if there is none.
    pub(super) fn mnemonic(&mut self) -> Option<Word> {
        let start = self.position;
        match self.raw {
            Raw::Word => self.word_mnemonic(),
            Raw::ParenClose => {
                let at = self.behind_blanks(self.end);
                let (raw, end) = token(self.text, at);
                if raw == Raw::Word && self.text[at..end].eq_ignore_ascii_case("MCR") {
                    return Some(self.take_mnemonic(")MCR".to_owned(), at, end));
                }
                Some(self.take_mnemonic(")".to_owned(), start, self.end))
            }
            Raw::Sign => self.sign_mnemonic(),
            Raw::Unknown => self.typeset_mnemonic(),
            // The digit is a classic misprint of the course texts.
            Raw::Number if self.current() == "0" => {
                let mut end = self.end;
                let mut right = "O".to_owned();
                let (raw, behind) = token(self.text, end);
                if raw == Raw::Word && self.text[end..behind].eq_ignore_ascii_case("N") {
                    end = behind;
                    right = "ON".to_owned();
                }
                self.slip(Problem::P1005, start, end, &right, "begins with the digit zero where an instruction begins with the letter O");
                let at = self.behind_blanks(end);
                if let (Raw::ParenOpen, close) = token(self.text, at) {
                    right.push('(');
                    self.bump_to(SyntaxKind::Mnemonic, end);
                    self.blanks();
                    end = close;
                }
                self.bump_to(SyntaxKind::Mnemonic, end);
                Some(Word { text: right, span: self.span(start, end) })
            }
            _ => None,
        }
    }

    /// Puts an instruction word into the tree whose last part begins at `last`.
    pub(super) fn take_mnemonic(&mut self, text: String, last: usize, end: usize) -> Word {
        let start = self.position;
        if last > self.end {
            // Blanks inside: `A (`, `) MCR`.
            self.bump_to(SyntaxKind::Mnemonic, self.end);
            self.blanks();
        }
        self.bump_to(SyntaxKind::Mnemonic, end);
        Word { text, span: self.span(start, end) }
    }

    fn word_mnemonic(&mut self) -> Option<Word> {
        if let Some(extension) = self.extension_mnemonic() {
            return Some(extension);
        }
        let (start, end, word) = (self.position, self.end, self.current());
        let at = self.behind_blanks(end);
        if let (Raw::ParenOpen, close) = token(self.text, at) {
            let written = format!("{word}(");
            if self.knows(&written) {
                return Some(self.take_mnemonic(written, at, close));
            }
            if let Some(right) = translate_instruction(&written, self.mnemonics.other()) {
                self.foreign(start, end, right.trim_end_matches('('));
                return Some(self.take_mnemonic(right.to_owned(), at, close));
            }
        }
        if let Some(sign) = self.text[end..].chars().next().filter(|sign| matches!(sign, '+' | '-')) {
            let written = format!("{word}{sign}");
            if self.knows(&written) {
                return Some(self.take_mnemonic(written, start, end + 1));
            }
        }
        if self.knows(word) {
            // `LC#5` is `L C#5`: no name begins with a digit.
            let number = self.text[end..].strip_prefix('#').is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
            if number && let Some(glued) = self.glued_mnemonic() {
                return Some(glued);
            }
            return Some(self.take_mnemonic(word.to_owned(), start, end));
        }
        if let Some(open) = self.step5_open() {
            return Some(open);
        }
        if let Some(right) = translate_instruction(word, self.mnemonics.other()) {
            self.foreign(start, end, right);
            return Some(self.take_mnemonic(right.to_owned(), start, end));
        }
        if word.eq_ignore_ascii_case("JBNI") && self.knows("JNBI") {
            self.slip(Problem::P2008, start, end, "JNBI", "is a misprint of the course texts");
            return Some(self.take_mnemonic("JNBI".to_owned(), start, end));
        }
        if let Some(right) = latin(word).filter(|right| self.knows(right)) {
            self.slip(Problem::P1005, start, end, &right, OTHER_ALPHABET);
            return Some(self.take_mnemonic(right, start, end));
        }
        self.glued_mnemonic()
    }

    /// `==I`, `+I`, `+AR1`, `=`, `+`.
    fn sign_mnemonic(&mut self) -> Option<Word> {
        let start = self.position;
        let rest = &self.text[start..];
        let run = rest.bytes().take(2).take_while(|byte| b"=<>+-*/".contains(byte)).count();
        for length in (1..=run).rev() {
            let letters = rest[length..].chars().take_while(|&character| in_word(character)).map(char::len_utf8).sum::<usize>();
            if letters > 3
                && let Some(glued) = self.glued_mnemonic()
            {
                return Some(glued);
            }
            if letters == 0 || letters > 3 {
                continue;
            }
            let end = start + length + letters;
            let written = self.slice(start, end);
            if self.knows(written) {
                return Some(self.take_mnemonic(written.to_owned(), start, end));
            }
            let turned = match &rest[..length] {
                "=<" => "<=",
                "=>" => ">=",
                _ => continue,
            };
            let right = format!("{turned}{}", &rest[length..length + letters]);
            if self.knows(&right) {
                self.slip(Problem::P2008, start, end, &right, "has its signs in the wrong order");
                return Some(self.take_mnemonic(right, start, end));
            }
        }
        if run > 0
            && let Some(word) = self.torn_apart(run)
        {
            return Some(word);
        }
        if rest.starts_with("=:") && self.knows("=") {
            self.slip(Problem::P2008, start, start + 2, "=", "is no assignment of STL");
            return Some(self.take_mnemonic("=".to_owned(), start, start + 2));
        }
        let sign = &rest[..1];
        self.knows(sign).then(|| self.take_mnemonic(sign.to_owned(), start, start + 1))
    }

    /// `≥I`, `–D`: signs of typesetting.
    fn typeset_mnemonic(&mut self) -> Option<Word> {
        let (start, signs) = (self.position, self.typeset_sign()?);
        let at = self.behind_blanks(self.end);
        let (raw, end) = token(self.text, at);
        let right = format!("{signs}{}", if raw == Raw::Word { &self.text[at..end] } else { "" });
        let end = if raw == Raw::Word { end } else { self.end };
        if !self.knows(&right) {
            return None;
        }
        self.slip(Problem::P1005, start, end, &right, "has a sign of typesetting");
        self.bump(SyntaxKind::Mnemonic);
        if raw == Raw::Word {
            self.blanks();
            self.bump_to(SyntaxKind::Mnemonic, end);
        }
        Some(Word { text: right, span: self.span(start, end) })
    }

    /// `+ I`, `>= D`: signs and type with a blank between them, and nothing behind.
    fn torn_apart(&mut self, run: usize) -> Option<Word> {
        let start = self.position;
        let mut signs = self.slice(start, start + run).to_owned();
        let mut at = self.behind_blanks(start + run);
        // `> = I`: the signs themselves are parted.
        if run == 1
            && let (Raw::Sign, second) = token(self.text, at)
            && matches!((signs.as_str(), &self.text[at..second]), (">" | "<" | "=", "=") | ("<", ">"))
        {
            signs.push_str(&self.text[at..second]);
            at = self.behind_blanks(second);
        }
        let (raw, end) = token(self.text, at);
        let over = matches!(token(self.text, self.behind_blanks(end)).0, Raw::Semicolon | Raw::Newline | Raw::LineComment | Raw::End);
        if raw != Raw::Word || at == start + run || !over || !matches!(&self.text[at..end], "I" | "D" | "R" | "i" | "d" | "r") {
            return None;
        }
        let right = format!("{signs}{}", self.slice(at, end));
        if !self.knows(&right) {
            return None;
        }
        self.slip(Problem::P2008, start, end, &right, "has a space inside");
        while self.position < at {
            self.bump(SyntaxKind::Mnemonic);
            self.blanks();
        }
        self.bump_to(SyntaxKind::Mnemonic, end);
        Some(Word { text: right, span: self.span(start, end) })
    }

    /// What stands behind CALL.
    fn call(&mut self) -> Operand {
        self.start(SyntaxKind::Operand);
        let start = self.position;
        let callee = self.operand(false);
        let callee_span = self.span(start, self.position);
        let mut instance = None;
        let behind = self.behind_blanks(self.position);
        if token(self.text, behind).0 == Raw::Comma {
            self.blanks();
            self.bump(SyntaxKind::Punctuation);
            if token(self.text, self.behind_trivia(self.position)).0 != Raw::ParenOpen {
                self.trivia();
                let start = self.position;
                let operand = self.operand(false);
                instance = Some((operand, self.span(start, self.position)));
            }
        }
        self.report_foreign();
        let mut arguments = Vec::new();
        let behind = self.behind_trivia(self.position);
        let (raw, end) = token(self.text, behind);
        if raw == Raw::ParenOpen {
            self.trivia();
            self.arguments(&mut arguments);
        } else if raw == Raw::Word && self.argument_sign_at(self.spaced_words_end(end)) {
            // The listing of the STL editor has the parameters on lines of their own without brackets.
            loop {
                let behind = self.behind_trivia(self.position);
                let (raw, end) = token(self.text, behind);
                if raw != Raw::Word || !self.argument_sign_at(self.spaced_words_end(end)) {
                    break;
                }
                self.trivia();
                let argument = self.argument();
                arguments.push(argument);
                if token(self.text, self.behind_blanks(self.position)).0 == Raw::Comma {
                    self.blanks();
                    self.bump(SyntaxKind::Punctuation);
                }
            }
        }
        self.comments.clear();
        self.finish();
        Operand::Call(Box::new(Call { callee, callee_span, instance, arguments }))
    }

    /// `:=` or a slip for it behind the byte.
    fn argument_sign_at(&self, end: usize) -> bool {
        let at = self.behind_blanks(end);
        let rest = &self.text[at..];
        rest.starts_with(":=") || rest.starts_with("=:") || rest.starts_with("=>")
    }

    fn arguments(&mut self, arguments: &mut Vec<Argument>) {
        let opened = (self.position, self.end);
        self.bump(SyntaxKind::Punctuation);
        loop {
            self.trivia();
            match self.raw {
                Raw::ParenClose => {
                    self.bump(SyntaxKind::Punctuation);
                    return;
                }
                Raw::Comma => {
                    self.bump(SyntaxKind::Punctuation);
                }
                // Inside brackets the sign may stand on the next line.
                Raw::Word | Raw::Local | Raw::Symbol if self.argument_sign_at(self.behind_trivia(self.spaced_words_end(self.end))) => {
                    let argument = self.argument();
                    arguments.push(argument);
                }
                Raw::Semicolon if self.parameter_follows() => {
                    let span = self.span(self.position, self.end);
                    let diagnostic = Diagnostic::new(Problem::P2030, span, "`;` ends a statement; parameters are separated by `,`");
                    self.report(diagnostic.fix(span, ",", "write `,`"));
                    self.bump(SyntaxKind::Unexpected);
                }
                Raw::End | Raw::Semicolon | Raw::Word => {
                    self.statement_over = self.raw == Raw::Word;
                    let message = format!("this parameter list has no `)` before {}", self.shown());
                    self.error(Problem::P2031, opened.0, opened.1, message);
                    return;
                }
                _ => {
                    let message = format!("{} is no parameter; write `name := value`", self.shown());
                    self.error(Problem::P2030, self.position, self.end, message);
                    self.bump_unexpected();
                }
            }
        }
    }

    /// Behind the current token stands `name :=`.
    fn parameter_follows(&self) -> bool {
        let (raw, end) = token(self.text, self.behind_trivia(self.end));
        raw == Raw::Word && self.argument_sign_at(end)
    }

    fn argument(&mut self) -> Argument {
        self.start(SyntaxKind::Argument);
        let name = self.argument_name();
        self.trivia();
        self.becomes();
        let behind = self.behind_trivia(self.position);
        let (raw, end) = token(self.text, behind);
        let omitted = match raw {
            Raw::Comma | Raw::ParenClose | Raw::Semicolon | Raw::End => true,
            Raw::Word => self.argument_sign_at(self.spaced_words_end(end)),
            _ => false,
        };
        let (value, span) = if omitted {
            (Operand::None, self.span(self.position, self.position))
        } else {
            self.trivia();
            let start = self.position;
            let value = self.operand(false);
            (value, self.span(start, self.position))
        };
        self.report_foreign();
        self.finish();
        Argument { name, value, span }
    }

    /// Reports labels that are too long, with a short name that is free, at the label and at each jump to it.
    pub(super) fn check_labels(&mut self, block: &mut Block) {
        let labels = || block.statements.iter().filter_map(|statement| statement.label.as_ref());
        if labels().all(|label| label.text.chars().count() <= LABEL_MAX) {
            return;
        }
        let mut taken: HashSet<String> = labels().map(|label| label.text.clone()).collect();
        let mut short = HashMap::new();
        let mut wrong = Vec::new();
        // A free name is searched for each; more than are shown would cost time for nothing.
        for label in labels().filter(|label| label.text.chars().count() > LABEL_MAX).take(DIAGNOSTICS_MAX) {
            let name = short.entry(label.text.clone()).or_insert_with(|| {
                let name = shorten(&label.text, &taken);
                taken.insert(name.clone());
                name
            });
            wrong.push((label.span, label.text.clone(), name.clone()));
        }
        for statement in &block.statements {
            let mut rows = Instruction::candidates(&statement.mnemonic.text, self.mnemonics);
            if let Operand::Name { word, .. } = &statement.operand
                && rows.any(|row| row.operand() == OperandClass::Label)
                && let Some(name) = short.get(&word.text)
            {
                wrong.push((word.span, word.text.clone(), name.clone()));
            }
        }
        // Another fix at one of its places would keep a label from being renamed there, and only there.
        let taken = |span: Span| {
            let fixes = self.diagnostics.iter().filter_map(|one| one.fix.as_ref());
            fixes.into_iter().any(|fix| fix.span.start < span.end && span.start < fix.span.end)
        };
        let kept: HashSet<String> = wrong.iter().filter(|(span, ..)| taken(*span)).map(|(_, text, _)| text.clone()).collect();
        for (span, text, name) in wrong {
            let message = format!("the label `{text}` has more than {LABEL_MAX} characters");
            let diagnostic = Diagnostic::new(Problem::P2006, span, message);
            let title = format!("write `{name}`");
            self.report(if kept.contains(&text) { diagnostic.guess(span, name, title) } else { diagnostic.fix(span, name, title) });
        }
    }
}

/// At most four characters of a label that no other label has.
fn shorten(label: &str, taken: &HashSet<String>) -> String {
    let head = |count: usize| label.chars().take(count).collect::<String>();
    let first = head(LABEL_MAX);
    if !taken.contains(&first) {
        return first;
    }
    for (keep, numbers) in [(3, 0..10), (2, 10..100), (1, 100..1000)] {
        for number in numbers {
            let name = format!("{}{number}", head(keep));
            if !taken.contains(&name) {
                return name;
            }
        }
    }
    first
}

/// Whether two words have the same letters, in any order.
fn has_letters_of(left: &str, right: &str) -> bool {
    let sorted = |word: &str| {
        let mut letters: Vec<char> = word.chars().collect();
        letters.sort_unstable();
        letters
    };
    sorted(left) == sorted(right)
}

/// One letter is changed, added or missing, or two neighbours are exchanged.
fn one_letter_apart(left: &str, right: &str) -> bool {
    let (left, right) = (left.as_bytes(), right.as_bytes());
    let same = left.iter().zip(right).take_while(|(a, b)| a == b).count();
    let (l, r) = (&left[same..], &right[same..]);
    match left.len().cmp(&right.len()) {
        std::cmp::Ordering::Equal => {
            !l.is_empty() && (l[1..] == r[1..] || (l.len() >= 2 && l[0] == r[1] && l[1] == r[0] && l[2..] == r[2..]))
        }
        std::cmp::Ordering::Less => r.len() == l.len() + 1 && &r[1..] == l,
        std::cmp::Ordering::Greater => l.len() == r.len() + 1 && &l[1..] == r,
    }
}
