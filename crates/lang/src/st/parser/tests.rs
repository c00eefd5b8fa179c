//! What the parser must do with whole sources.

use sieben_model::source::FileId;

use super::super::ast::*;
use super::super::dialect::Dialect;
use super::{Parsed, fuzz, parse};

fn parsed(text: &str, dialect: Dialect) -> Parsed {
    let parsed = parse(FileId::default(), text, dialect);
    assert_eq!(parsed.syntax(text).text(), text, "the tree holds every byte");
    parsed
}

/// Parses what has no problems.
fn clean(text: &str, dialect: Dialect) -> File {
    let parsed = parsed(text, dialect);
    assert!(parsed.diagnostics.is_empty(), "{text}\n{:#?}", parsed.diagnostics);
    parsed.file
}

/// The messages about a source, as `code text-of-the-place -> replacement`.
fn messages(text: &str, dialect: Dialect) -> Vec<String> {
    let show = |span: sieben_model::source::Span| &text[span.start as usize..span.end as usize];
    parsed(text, dialect)
        .diagnostics
        .iter()
        .map(|diagnostic| {
            let fix = diagnostic.fix.as_ref().map(|fix| format!(" -> {}", fix.replacement)).unwrap_or_default();
            format!("{} {}{fix}", diagnostic.problem.code(), show(diagnostic.span))
        })
        .collect()
}

fn body(text: &str, dialect: Dialect) -> Vec<Statement> {
    match clean(text, dialect).items.into_iter().next() {
        Some(Item::Block(block)) => block.body,
        other => panic!("{other:?}"),
    }
}

/// An expression with all its brackets.
fn written(expression: &Expression) -> String {
    match &expression.kind {
        ExpressionKind::Binary(operator, _, left, right) => format!("({} {} {})", written(left), operator.sign(), written(right)),
        ExpressionKind::Unary(operator, operand) => format!("({operator:?} {})", written(operand)),
        ExpressionKind::Name(name) => name.text.clone(),
        ExpressionKind::Literal(Literal { kind: LiteralKind::Integer { value, .. }, .. }) => value.to_string(),
        ExpressionKind::Parenthesized(inner) => written(inner),
        ExpressionKind::Member(left, name) => format!("{}.{}", written(left), name.text),
        other => format!("{other:?}"),
    }
}

fn value(text: &str, dialect: Dialect) -> Expression {
    match body(&format!("x := {text};"), dialect).remove(0).kind {
        StatementKind::Assign { value, .. } => value,
        other => panic!("{other:?}"),
    }
}

#[test]
fn operators_bind_as_the_dialect_says() {
    for (text, iec, scl) in [
        ("-a ** b", "((Minus a) ** b)", "(Minus (a ** b))"),
        ("2 ** 3 ** 2", "((2 ** 3) ** 2)", "((2 ** 3) ** 2)"),
        ("a + b * c - d", "((a + (b * c)) - d)", "((a + (b * c)) - d)"),
        ("a < b = c < d", "((a < b) = (c < d))", "((a < b) = (c < d))"),
        ("NOT a = b", "((Not a) = b)", "((Not a) = b)"),
        ("a OR b XOR c AND d", "(a OR (b XOR (c AND d)))", "(a OR (b XOR (c AND d)))"),
        ("-a MOD b", "((Minus a) MOD b)", "((Minus a) MOD b)"),
        ("a & b OR c", "((a AND b) OR c)", "((a AND b) OR c)"),
        ("a ** -b", "(a ** (Minus b))", "(a ** (Minus b))"),
    ] {
        assert_eq!(written(&value(text, Dialect::Iec)), iec, "{text}");
        assert_eq!(written(&value(text, Dialect::Tia)), scl, "{text}");
    }
}

#[test]
fn a_block_of_each_dialect_is_understood() {
    let iec = clean(
        "FUNCTION_BLOCK Counter\nVAR_INPUT up : BOOL R_EDGE; limit : INT := 5; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nVAR n : INT; t : TON := (PT := T#1s); a : ARRAY[1..3, 0..1] OF REAL := [1.0, 2(0.5)]; END_VAR\nIF up THEN n := n + 1; ELSIF n > limit THEN n := 0; ELSE ; END_IF;\nt(IN := up, Q => q);\nEND_FUNCTION_BLOCK\nPROGRAM Main VAR c : Counter; x AT %MW10 : INT; END_VAR c(up := TRUE); x := %IW0; x.3 := c.q; END_PROGRAM\n",
        Dialect::Iec,
    );
    assert_eq!(iec.items.len(), 2);
    let scl = clean(
        "FUNCTION FC10 : INT\nTITLE = What it's for\nVERSION : '1.0'\nAUTHOR : me\nCONST\n  N := 5;\nEND_CONST\nLABEL weiter; END_LABEL\nVAR_INPUT\n  a : INT; // first\n  b { S7_visible := 'false' } : BYTE;\nEND_VAR\nVAR_TEMP w : WORD; v AT w : ARRAY[0..1] OF BYTE; END_VAR\nBEGIN\n  FC10 := a DIV N;\n  MW[a] := DB10.DW[2 * a];\n  M0.1 := DB10.DX4.0 AND I 0.0;\n  GOTO weiter;\nweiter:\n  FB10.DB20(x := EW4);\nEND_FUNCTION\nDATA_BLOCK DB5 FB10\nBEGIN\n  x := 5;\n  y[2] := 3(0);\nEND_DATA_BLOCK\nTYPE UDT1\nSTRUCT a : INT; END_STRUCT\nEND_TYPE\n"
            .replace("I 0.0", "I0.0")
            .as_str(),
        Dialect::Scl,
    );
    assert_eq!(scl.items.len(), 3);
    let Item::Block(block) = &scl.items[0] else { panic!() };
    assert_eq!(block.header.title.as_ref().map(|title| title.text.as_str()), Some("What it's for"));
    assert_eq!(block.sections[1].declarations[0].comment, "first");
    assert_eq!(block.sections[1].declarations[1].attributes[0].value.as_deref(), Some("false"));
    assert_eq!(block.labels.len(), 1);
}

#[test]
fn a_slip_gives_one_message_at_its_place() {
    let mut failures = Vec::new();
    for (text, expected) in [
        ("x =: 5;", "P2007 =: -> :="),
        ("IF a THEN x := 1; ENDIF;", "P6058 ENDIF -> END_IF"),
        ("WHILE a DO x := 1; endwhile;", "P6058 endwhile -> END_WHILE"),
        ("x :=> 5;", "P2007 :=> -> :="),
        ("x = 5;", "P2007 = -> :="),
        ("x == 5;", "P2007 == -> :="),
        ("IF a THEN x := 1; ELSE IF b THEN x := 2; END_IF;", "P6061 ELSE IF -> ELSIF"),
        ("IF a THEN x := 1; ELSEIF b THEN x := 2; END_IF;", "P6061 ELSEIF -> ELSIF"),
        ("IF a THEN x := 1; Elif (b) THEN x := 2; END_IF;", "P6061 Elif -> ELSIF"),
        ("x++; y := 2;", "P6052 ++ -> x := x + 1"),
        ("a[1].n--; y := 2;", "P6052 -- -> a[1].n := a[1].n - 1"),
        ("x := 5,3; y := 2;", "P6054 5,3 -> 5.3"),
        ("IF a == b THEN x := 1; END_IF;", "P6052 == -> ="),
        ("IF a != b THEN x := 1; END_IF;", "P6052 != -> <>"),
        ("IF a := b THEN x := 1; END_IF;", "P6052 := -> ="),
        ("IF a && b THEN x := 1; END_IF;", "P6052 && -> AND"),
        ("x := 1\ny := 2;", "P6053 1 -> ;"),
        ("IF a THEN x := 1; END_IF\ny := 2;", "P6053 F -> ;"),
        ("IF a x := 1; END_IF;", "P6056 a ->  THEN"),
        ("WHILE a\nx := 1; END_WHILE;", "P6056 a ->  DO"),
        ("CASE a\n1: x := 1; END_CASE;", "P6056 a ->  OF"),
        ("IF a THEN x := 1; END_WHILE;", "P6058 END_WHILE -> END_IF"),
        ("IF a DO x := 1; END_IF;", "P6056 DO -> THEN"),
        ("FOR i := 1 TO 5\nx := 1; END_FOR;", "P6056 5 ->  DO"),
        ("a < b THEN x := 1; END_IF;", "P6056 a < b -> IF "),
        ("x := a +;", "P6055 ;"),
        ("x := (a + b;", "P6065 b -> )"),
        ("x := a[1;", "P2016 1 -> ]"),
        ("f(a := 1;", "P2031 1 -> )"),
        ("f(a := 1 b := 2);", "P2030 1 -> ,"),
        ("f(a =: 1);", "P2007 =: -> :="),
        ("x := LEFT IN := s, L := 2);", "P2030 LEFT"),
        ("x := LEFTIN := s, L := 2);", "P2030 LEFTIN"),
        ("tIN := a, Q => b);", "P2030 tIN"),
        ("(IN := a, Q => b);", "P6055 ("),
        ("x := (IN := a, L := 2);", "P6055 ("),
        ("x := f((a, b), c);", "P6065 ,"),
        ("x := f(g(a) h(b), c);", "P2030 h"),
        ("x := f(a 5);", "P2030 a ->  :="),
        ("VAR by : INT; END_VAR by := 1; x := by + 1;", "P6060 by"),
        ("by := 1;", "P6054 by"),
        ("TYPE t : (a, , b); END_TYPE", "P2020 ,"),
        ("TYPE t : (a b, c); END_TYPE", "P2020 a -> ,"),
        ("FUNCTION_BLOCK f a : STRUCT b : INT; END_STRUCT; END_VAR x := 1; END_FUNCTION_BLOCK", "P2020 a -> VAR "),
        ("f(a 1, b := 2);", "P2030 a ->  :="),
        ("f(:= 1, b := 2);", "P6055 :="),
        ("VAR if : INT; END_VAR x := 1;", "P6060 if"),
        ("VAR end_if : INT; END_VAR x := 1;", "P6060 end_if"),
        ("VAR a b : INT; END_VAR x := 1;", "P2020 a -> ,"),
        ("VAR a, , b : INT; END_VAR x := 1;", "P2020 ,"),
        ("FUNCTION_BLOCK f METHOD m INT m := 1; END_METHOD END_FUNCTION_BLOCK", "P2020 m ->  :"),
        ("FUNCTION_BLOCK f x := 1; END_METHOD END_FUNCTION_BLOCK", "P2013 END_METHOD"),
        ("VAR a INT; END_VAR x := 1;", "P2020 a ->  :"),
        ("VAR a : INT END_VAR x := 1;", "P6053 T -> ;"),
        ("VAR a : INT;\nx := 1;", "P2023 ; -> \nEND_VAR"),
        ("a : INT; END_VAR x := 1;", "P2020 a -> VAR "),
        ("RETURN 5;", "P6064 5"),
        ("x := 5x;", "P4202 5x"),
        ("x := T#5;", "P4202 T#5"),
        ("END_IF; x := 1;", "P6059 END_IF"),
        ("x := 'abc;\ny := 1;", "P1002 'abc;"),
        ("FUNCTION f : INT f := 1; END_FUNCTION_BLOCK", "P2012 END_FUNCTION_BLOCK -> END_FUNCTION"),
        ("FUNCTION f : INT f := 1;", "P2011 FUNCTION"),
        ("PROGRAM VAR a : INT; END_VAR a := 1; END_PROGRAM", "P2010 M"),
        ("(* x := 1;", "P1004 (*"),
        ("REPEAT x := 1; END_REPEAT;", "P6056 ; ->  UNTIL"),
        ("CASE a OF 1 x := 1; END_CASE;", "P6071 1"),
        ("IF a THEN x := 1;", "P6057 ;"),
        ("x := a b;", "P6054 b"),
        ("x := 5 § 3;", "P1001 §"),
        ("f VAR_INPUT a : INT; END_VAR f := a; END_FUNCTION", "P6056 f -> FUNCTION "),
        ("TYPE t : ARRAY[1..3] OF INT := ,2; END_TYPE", "P6055 ,"),
        ("PROGRAM p .x ; END_PROGRAM", "P6054 .x"),
        ("FUNCTIONBLOCK f\nVAR a : INT; END_VAR\na := 1;\nEND_FUNCTION_BLOCK", "P6058 FUNCTIONBLOCK -> FUNCTION_BLOCK"),
        ("FUNCTION_BLOCK f\nVAR a : INT; END_VAR\na := 1;\nEND_FUNCTIONBLOCK", "P6058 END_FUNCTIONBLOCK -> END_FUNCTION_BLOCK"),
        ("PROGRAM p\nVAR x : INT; END_VAR\nLD x\nADD 3\nST x\nEND_PROGRAM", "P6331 LD"),
        ("FUNCTION_BLOCK f\nVAR t : TON; END_VAR\nagain:\nCAL t(IN := TRUE)\nJMP again\nEND_FUNCTION_BLOCK", "P6331 CAL"),
        (
            "FUNCTION_BLOCK f\nVAR_INPUT go : BOOL; END_VAR\nINITIAL_STEP S0:\nEND_STEP\nTRANSITION FROM S0 TO S1\n := go;\n\
             END_TRANSITION\nSTEP S1:\n a(N);\nEND_STEP\nEND_FUNCTION_BLOCK",
            "P6331 INITIAL_STEP",
        ),
    ] {
        let mut found = messages(text, Dialect::Iec);
        // What is missing at the end of the text is missing in every message about it.
        found.sort();
        if found != [expected] {
            failures.push(format!("{text}\n  wanted {expected}\n  found {found:?}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn depth_gives_a_message_and_no_overflow() {
    for (open, close) in
        [("(", ")"), ("a[", "]"), ("f(", ")"), ("-", ""), ("NOT ", ""), ("IF a THEN ", "END_IF;"), ("a + ", ""), ("a.", ""), ("a(1).", "")]
    {
        let count = 100_000;
        let statement = open.starts_with("IF");
        let text = match statement {
            true => format!("{}{}", open.repeat(count), close.repeat(count)),
            false => format!("x := {}a{};", open.repeat(count), close.repeat(count)),
        };
        let found = parsed(&text, Dialect::Iec).diagnostics;
        assert!(!found.is_empty() && found.len() < 10, "{open}: {} {:?}", found.len(), found.first());
        assert!(found.iter().any(|diagnostic| diagnostic.problem == sieben_model::problems::Problem::P6063), "{open}: {found:?}");
    }
    let chain = vec!["a"; 100_000].join(" OR ");
    clean(&format!("x := {chain};"), Dialect::Iec);
    let fields = "STRUCT a : ".repeat(10_000);
    assert!(!parsed(&format!("TYPE t : {fields}"), Dialect::Iec).diagnostics.is_empty());
}

#[test]
fn numbers_with_a_blank_as_stl_writes_them() {
    clean("TYPE UDT 1\nSTRUCT a : INT; END_STRUCT\nEND_TYPE\nDATA_BLOCK DB 2 UDT 1\nBEGIN\nEND_DATA_BLOCK", Dialect::Scl);
    clean("DATA_BLOCK DB 20 FB 20\nBEGIN\nEND_DATA_BLOCK", Dialect::Scl);
    let text = |line: &str| format!("FUNCTION FC1 : VOID\nBEGIN\n{line}\nEND_FUNCTION");
    assert_eq!(messages(&text("MW 10 := IW 2;"), Dialect::Scl), ["P2005 MW 10 -> MW10", "P2005 IW 2 -> IW2"]);
    assert_eq!(messages(&text("IF M 0.1 THEN FC 5(); END_IF;"), Dialect::Scl), ["P2005 M 0.1 -> M0.1", "P2005 FC 5 -> FC5"]);
    assert_eq!(messages("VAR x : INT; END_VAR\nx := MW 4;", Dialect::Iec), ["P2005 MW 4 -> %MW4"]);
}

#[test]
fn fields_of_data_blocks_may_be_called_like_areas() {
    let text = "DATA_BLOCK DB1\nSTRUCT m : ARRAY [1..4] OF INT; i : INT; END_STRUCT\nBEGIN\nm[2] := 7;\ni := 1;\nEND_DATA_BLOCK";
    let Some(Item::DataBlock(block)) = clean(text, Dialect::Scl).items.into_iter().next() else { panic!("a data block") };
    assert!(matches!(&block.assignments[0].0.kind, ExpressionKind::Index(base, _) if matches!(base.kind, ExpressionKind::Name(_))));
}

#[test]
fn blanks_of_several_bytes_do_not_split_letters() {
    assert!(!messages("x := 1\u{2000}+\u{2000}", Dialect::Iec).is_empty());
    assert!(!messages("x := a b\u{3000}c\u{a0}= IF", Dialect::Iec).is_empty());
}

#[test]
fn a_word_that_begins_nothing_is_passed() {
    for text in [
        "EXTENDS\nEND_INTERFACE",
        "EXTENDS x\nEND_INTERFACE\n",
        "IMPLEMENTS END_INTERFACE",
        "PUBLIC a END_INTERFACE",
        "x\nEND_INTERFACE",
        "EXTENDS EXTENDS\nEND_INTERFACE",
    ] {
        fuzz(text.as_bytes());
    }
}
