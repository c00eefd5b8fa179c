//! Every source of the library in ST compiles, whether or not a program needs it.

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section, SystemBlock, Variable};
use sieben_model::source::Span;
use sieben_model::types::DataType;

use super::*;

/// A system function for the clock, as the CPU has it.
fn clock(name: &'static str, number: u16, parameter: &str) -> SystemBlock {
    let variable = |(offset, name, section, data_type): (u32, &str, Section, DataType)| Variable {
        name: name.to_owned(),
        section,
        data_type,
        offset,
        initial: Vec::new(),
        comment: String::new(),
        span: Span::default(),
    };
    let section = if number == 0 { Section::Input } else { Section::Output };
    let parameters = [(0, parameter, section, DataType::DateAndTime), (1, "RET_VAL", Section::Output, DataType::Int)];
    let interface = Interface { variables: parameters.into_iter().map(variable).collect(), instance_size: 0, local_size: 0 };
    SystemBlock { block: BlockId::new(BlockKind::SystemFunction, number), name, interface, only: None }
}

#[test]
fn every_block_of_the_library_in_st_compiles() {
    let options = Options { system_blocks: vec![clock("SET_CLK", 0, "PDT"), clock("READ_CLK", 1, "CDT")], ..Options::default() };
    for &source in st::standard::library::SOURCES {
        let mut database = Database::new(SymbolTable::default(), options.clone());
        let mut needed = Needed { blocks: Vec::new(), sources: vec![source] };
        let compiled = loop {
            let (compiled, demands, _) = database.round(Goal::Code, &needed);
            if !needed.add(&demands) {
                break compiled;
            }
        };
        for linked in &compiled.st_library {
            assert!(!linked.blocks.is_empty(), "{} holds blocks", linked.source.path);
            for block in &linked.blocks {
                let name = compiled.block_names.get(block).cloned().unwrap_or_default();
                assert!(compiled.program.code.contains_key(block), "`{name}` of {} compiles", linked.source.path);
            }
        }
    }
}
