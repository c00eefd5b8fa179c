//! Which names of functions and blocks a dialect of ST knows, asked of the compiler.

use sieben_model::diagnostic::Severity;
use sieben_model::problems::Problem;
use sieben_model::source::Sources;
use sieben_model::symbols::SymbolTable;

use crate::options::Options;
use crate::project::compile;
use crate::st::dialect::Dialect;
use crate::st::standard::catalogue::{is_keyword, named_anywhere};

/// Names that the compiler is asked for at once: it reports only so many problems of a file.
const ASKED_AT_ONCE: usize = 20;

/// Which of the names a dialect knows as a function, or as the type of an instance: asked of the compiler.
pub fn known(names: &[&str], dialect: Dialect, options: &Options) -> Vec<bool> {
    names.chunks(ASKED_AT_ONCE).flat_map(|names| known_at_once(names, dialect, options)).collect()
}

fn known_at_once(names: &[&str], dialect: Dialect, options: &Options) -> Vec<bool> {
    let lines = |line: &dyn Fn(usize, &str) -> String| names.iter().enumerate().map(|(index, name)| line(index, name) + "\n").collect();
    let source =
        |name: &str| name.split_once("_TO_").map(|(source, _)| source.to_owned()).filter(|source| named_anywhere(source).is_some());
    // A conversion gets what it converts, others a number.
    let given: String = lines(&|index, name| format!("given{index} : {};", source(name).unwrap_or_else(|| "INT".to_owned())));
    let values: String = lines(&|index, name| format!("result := {name}(given{index});"));
    let statements: String = lines(&|index, name| format!("{name}(given{index});"));
    // Where a declaration cannot be read, nothing is said of types that are unknown.
    let instances: String = lines(&|index, name| format!("instance{index} : {name}{};", if is_keyword(name, dialect) { "_" } else { "" }));
    let body = if matches!(dialect.base(), Dialect::Scl | Dialect::Tia) { "BEGIN\n" } else { "" };
    let head = format!("FUNCTION_BLOCK Names\nVAR\nresult : INT;\n{given}END_VAR\n{body}");
    let value = problems(&head, &values, "", dialect, options);
    let statement = problems(&head, &statements, "", dialect, options);
    let instance = problems("FUNCTION_BLOCK Names\nVAR\n", &instances, &format!("END_VAR\n{body}"), dialect, options);
    let called = |line: usize| {
        let has = |found: &[(usize, Problem)], problem| found.contains(&(line, problem));
        // A word of the language is no name at all; some functions give no value; some conversions are not for every type.
        let is_word = has(&value, Problem::P6055);
        let says_no = |problem| has(&value, problem) && has(&statement, problem);
        let is_unknown = says_no(Problem::P3008) || says_no(Problem::P6323);
        let converts_nothing = source(names[line]).is_some() && has(&value, Problem::P4011);
        !is_word && !is_unknown && !converts_nothing
    };
    let block = |line: usize| named_anywhere(names[line]).is_none() && !instance.iter().any(|(at, _)| *at == line);
    (0..names.len()).map(|line| called(line) || block(line)).collect()
}

/// What is wrong with each line of a block between its head and its tail, counted from 0.
fn problems(head: &str, lines: &str, tail: &str, dialect: Dialect, options: &Options) -> Vec<(usize, Problem)> {
    let mut sources = Sources::default();
    let file = sources.add("names.st", format!("{head}{lines}{tail}END_FUNCTION_BLOCK\n"));
    let options = Options { dialect: Some(dialect), ..options.clone() };
    let found = compile(&sources, &SymbolTable::default(), &options).diagnostics;
    let line = |at: u32| Some(lines.get(..(at as usize).checked_sub(head.len())?)?.matches('\n').count());
    let found = found.iter().filter(|diagnostic| diagnostic.span.file == file && diagnostic.severity() == Severity::Error);
    found.filter_map(|diagnostic| Some((line(diagnostic.span.start)?, diagnostic.problem))).collect()
}
