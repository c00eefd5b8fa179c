//! All names that a program and its symbols have.

use sieben_engine::Program;
use sieben_model::symbols::SymbolTable;
use sieben_model::types::{DataType, Structure};

use super::Name;
use super::local::parts;

/// Single values of an array or structure that are listed at most: a table of thousands is asked for by its elements.
const VALUES_MAX: usize = 32;

/// The symbols, then the variables of the program, then the fields of data blocks that it knows by their numbers.
pub fn catalogue(symbols: &SymbolTable, program: &Program) -> Vec<Name> {
    let quoted = |name: &str| if name.contains(['.', ':', ',', '[', '=', ' ']) { format!("\"{name}\"") } else { name.to_owned() };
    let mut texts: Vec<String> = symbols.symbols().iter().map(|symbol| quoted(&symbol.name)).collect();
    texts.extend(program.names.located.keys().cloned());
    for number in &program.names.open {
        if let Some(data) = program.data.get(number) {
            fields("", &data.structure, &mut texts);
        }
    }
    for (name, number) in &program.names.blocks {
        if let Some(data) = program.data.get(number) {
            fields(&format!("{name}."), &data.structure, &mut texts);
        }
    }
    let is_named = |number: &u16| program.names.open.contains(number) || program.names.blocks.values().any(|named| named == number);
    for (number, data) in program.data.iter().filter(|(number, _)| !is_named(number)) {
        fields(&format!("DB{number}."), &data.structure, &mut texts);
    }
    let mut seen = std::collections::HashSet::new();
    texts.retain(|text| seen.insert(text.to_lowercase()));
    let mut places = std::collections::HashSet::new();
    let named = texts.iter().filter_map(|text| Name::parse(text, symbols, program).ok());
    // A variable that has two names is listed with the first, unless it is something else there.
    named.filter(|name| places.insert(format!("{:?}", name.item()))).collect()
}

/// The single values of a structure, each with its path.
fn fields(before: &str, structure: &Structure, texts: &mut Vec<String>) {
    for field in &structure.fields {
        let mut left = VALUES_MAX;
        parts(&field.data_type, &format!("{before}{}", field.name), &mut left, &mut |path: &str, _: &DataType| texts.push(path.to_owned()));
    }
}
