//! Bodies that are diagrams, and the operands in them.

use std::collections::HashSet;

use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::Span;

use super::super::ast::{
    Block, BlockKind, Declaration, DeclaredName, Expression, ExpressionKind, Initializer, InitializerKind, Literal, LiteralKind, Name,
    Path, Quoting, SectionKind, Statement, TypeKind, TypeSpec, VarSection,
};
use super::super::diagrams::lower::{Lowering, Source};
use super::super::diagrams::{Bodies, EdgeMemory, Language, Memory, read};
use super::super::lexer::{Raw, Token, tokens};
use super::{DIAGNOSTICS_MAX, Parser, SyntaxKind};

/// The expression that a part of a source is, and what is wrong with it.
pub(in crate::st) fn fragment(
    source: Source<'_>,
    start: usize,
    end: usize,
    declared: &mut HashSet<String>,
) -> (Expression, Vec<Diagnostic>) {
    let place = u32::try_from(start).unwrap_or(u32::MAX);
    let shifted = |token: Token| Token { start: token.start.saturating_add(place), end: token.end.saturating_add(place), ..token };
    let tokens = tokens(source.text.get(start..end).unwrap_or_default(), source.dialect).into_iter().map(shifted).collect();
    let mut parser = Parser::new(source.file, source.text, source.dialect, tokens);
    parser.previous = place;
    parser.declared = std::mem::take(declared);
    parser.skip_trivia();
    let expression = parser.expression();
    if parser.raw() != Raw::End {
        let shown = parser.shown();
        parser.unexpected(Problem::P6054, format!("{shown} does not belong here: this is one operand of a diagram"));
    }
    *declared = std::mem::take(&mut parser.declared);
    (expression, parser.diagnostics)
}

impl Parser<'_> {
    /// The body of a block that is a diagram, from its first word.
    pub(super) fn diagram_of(&mut self, block: &mut Block) {
        let mut body = std::mem::take(&mut block.body);
        self.diagram_into(&mut body, &mut block.labels);
        block.body = body;
    }

    /// A body that is a diagram, from its first word; statements before it are reported.
    pub(super) fn diagram_into(&mut self, body: &mut Vec<Statement>, labels: &mut Vec<Name>) {
        if !body.is_empty() {
            let token = self.token();
            let message = "a body is either a diagram or statements, and statements stand before this one";
            self.error(Problem::P2442, token.start, token.end, message);
        }
        let mut statements = self.diagram(labels);
        body.append(&mut statements);
    }

    /// A diagram from its first word, as statements.
    fn diagram(&mut self, labels: &mut Vec<Name>) -> Vec<Statement> {
        let language = Language::of(self.current()).unwrap_or(Language::Ladder);
        self.bump(SyntaxKind::Keyword);
        if self.raw() != Raw::Diagram {
            return Vec::new();
        }
        let token = self.token();
        let networks = read::networks(self.text, token.start as usize..token.end as usize, language);
        for mistake in &networks.mistakes {
            let diagnostic = read::diagnostic(mistake, self.file);
            self.push(diagnostic);
        }
        let mut diagnostics = Vec::new();
        let source = Source { file: self.file, text: self.text, dialect: self.dialect };
        let owner = self.owner.take();
        let memory = owner.as_deref().map_or(Memory::None, Memory::Instance);
        let known = Bodies { language, memory, edges: self.edges.len() };
        let mut lowering = Lowering::new(source, known, &mut self.declared, &mut diagnostics);
        lowering.networks(&networks.networks);
        let lowered = lowering.finish();
        self.owner = owner;
        diagnostics.truncate(DIAGNOSTICS_MAX + 1);
        diagnostics.into_iter().for_each(|diagnostic| self.push(diagnostic));
        self.edges.extend(lowered.edges);
        // A label of a diagram needs no declaration.
        labels.extend(lowered.labels);
        self.bump(SyntaxKind::Diagram);
        lowered.statements
    }

    /// Notes whose instance the edges of diagrams remember in.
    pub(super) fn begin_diagrams_of(&mut self, block: &Block) {
        let lasts = matches!(block.kind, BlockKind::FunctionBlock | BlockKind::Program | BlockKind::Implicit);
        self.owner = lasts.then(|| block.name.text.clone());
        self.edges.clear();
    }

    /// Gives a block the variables that the edges of its diagrams need.
    pub(super) fn end_diagrams_of(&mut self, block: &mut Block) {
        self.owner = None;
        let edges = std::mem::take(&mut self.edges);
        let Some((first, last)) = edges.first().zip(edges.last()) else { return };
        let span = first.span.to(last.span);
        let declarations = edges.iter().map(declaration).collect();
        block.sections.push(VarSection {
            kind: SectionKind::Var,
            qualifiers: Vec::new(),
            name: None,
            attributes: Vec::new(),
            declarations,
            partial: false,
            nameless: false,
            span,
        });
    }
}

/// `name : BOOL := TRUE;`.
fn declaration(edge: &EdgeMemory) -> Declaration {
    let span = edge.span;
    let word = |text: &str| Name { text: text.to_owned(), quoting: Quoting::Bare, span };
    let literal = |value| ExpressionKind::Literal(Literal { kind: LiteralKind::Bool(value), prefix: None });
    let initial = |span: Span| Initializer { kind: InitializerKind::Expression(Expression { kind: literal(true), span }), span };
    Declaration {
        names: vec![DeclaredName { qualifier: Vec::new(), name: word(&edge.name), elements: Vec::new() }],
        attributes: Vec::new(),
        location: None,
        data_type: TypeSpec { kind: TypeKind::Named(Path { names: vec![word("BOOL")], span }), span },
        edge: None,
        initial: edge.begins_true.then(|| initial(span)),
        writable: None,
        comment: String::new(),
        span,
    }
}
