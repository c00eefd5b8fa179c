//! The blocks of the CPU itself, as far as names are concerned.

use sieben_model::address::Operand;
use sieben_model::block::BlockKind;
use sieben_model::interface::{Section, SystemBlock};

use super::{Builder, Bytes, DefinitionKind, SourceNames};

/// The names of the blocks of the CPU: they stand in no text.
pub fn of_system(blocks: &[SystemBlock]) -> SourceNames {
    let mut builder = Builder::new("", None);
    let nowhere = Bytes::default();
    for block in blocks {
        let kind = match block.block.kind {
            BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock => DefinitionKind::FunctionBlock,
            _ => DefinitionKind::Function,
        };
        let index = builder.define_at(kind, block.name, nowhere, nowhere);
        builder.definition(index).operand = Some(Operand::Block(block.block));
        builder.parent = Some(index);
        for variable in &block.interface.variables {
            let kind = match variable.section {
                Section::Input => DefinitionKind::Input,
                Section::Output => DefinitionKind::Output,
                Section::InOut => DefinitionKind::InOut,
                Section::Static => DefinitionKind::Static,
                Section::Temp => DefinitionKind::Temp,
                Section::Return => DefinitionKind::Result,
            };
            let member = builder.define_at(kind, &variable.name, nowhere, nowhere);
            builder.definition(member).data_type = variable.data_type.to_string();
            builder.definition(member).comment.clone_from(&variable.comment);
        }
        builder.parent = None;
    }
    let mut names = builder.finish();
    names.is_built_in = true;
    names
}
