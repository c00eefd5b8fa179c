//! Declared variables → interface of a block.

use std::sync::Arc;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::{Interface, Section, Variable};
use sieben_model::literal::Value;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Field, Structure, place};

use super::BLOCK_BYTES_MAX;
use super::reuse::Knows;
use super::types::{BlockInterface, Types};

/// Bytes of start information at the beginning of an organization block's local data.
pub(crate) const START_INFORMATION_BYTES: u32 = 20;

/// A variable that is declared but has no place yet.
pub(crate) struct Declared {
    name: String,
    section: Section,
    /// The section among whose variables it lies, mostly its own.
    beside: Section,
    data_type: DataType,
    initial: Vec<Value>,
    comment: String,
    span: Span,
}

impl Declared {
    pub(crate) fn from_variable(variable: Variable) -> Self {
        let Variable { name, section, data_type, initial, comment, span, .. } = variable;
        Self { name, section, beside: section, data_type, initial, comment, span }
    }

    /// The same variable, lying among those of another section.
    pub(crate) fn beside(self, beside: Section) -> Self {
        Self { beside, ..self }
    }
}

/// What a call keeps for each parameter of a function: the pointer to the actual one. They stand in the calling block.
const PARAMETER_BYTES: u64 = 4;

/// Gives every variable its place; `None` if they need more bytes than a block has.
pub(crate) fn lay_out(id: BlockId, declared: Vec<Declared>) -> Option<BlockInterface> {
    lay_out_behind(id, None, declared)
}

/// The same; too many bytes are reported at the name of the block.
pub(crate) fn lay_out_or_report<K: Knows>(
    types: &mut Types<'_, K>,
    id: BlockId,
    declared: Vec<Declared>,
    named: Span,
) -> Option<BlockInterface> {
    let laid_out = lay_out(id, declared);
    if laid_out.is_none() {
        let message = format!("the variables of `{id}` need more than {BLOCK_BYTES_MAX} bytes (4 for each parameter of a function)");
        types.report(Problem::P5002, named, message);
    }
    laid_out
}

/// The same for a block whose instance begins with that of another one.
pub(crate) fn lay_out_behind(id: BlockId, base: Option<&BlockInterface>, mut declared: Vec<Declared>) -> Option<BlockInterface> {
    declared.sort_by_key(|variable| variable.beside);
    let function = matches!(id.kind, BlockKind::Function | BlockKind::SystemFunction);
    let mut interface = Interface::default();
    let mut instance = Structure { name: Some(id.to_string()), ..Structure::default() };
    let (mut instance_cursor, mut local_cursor, mut parameters) = (0u64, 0u64, 0u32);
    if let Some(base) = base {
        let kept = base.interface.variables.iter().filter(|variable| variable.section != Section::Temp);
        interface.variables.extend(kept.cloned());
        instance.fields.clone_from(&base.instance.fields);
        instance_cursor = u64::from(base.instance.size) * 8;
    }
    let inherited = interface.variables.len();
    let mut last = None;
    for variable in declared {
        let Declared { name, section, beside, data_type, initial, comment, span } = variable;
        // Each section of an instance starts at an even byte.
        if last.replace(beside) != Some(beside) {
            instance_cursor = instance_cursor.next_multiple_of(16);
        }
        let offset = match section {
            Section::Temp => {
                let (offset, behind) = place(local_cursor, &data_type);
                local_cursor = behind;
                offset
            }
            _ if function => {
                parameters += 1;
                if u64::from(parameters) * PARAMETER_BYTES > BLOCK_BYTES_MAX {
                    return None;
                }
                u64::from(parameters - 1)
            }
            _ => {
                let in_instance = stored_type(section, &data_type);
                let (offset, behind) = place(instance_cursor, &in_instance);
                instance_cursor = behind;
                if behind > BLOCK_BYTES_MAX * 8 {
                    return None;
                }
                instance.fields.push(Field {
                    name: name.clone(),
                    data_type: in_instance,
                    offset: offset as u32,
                    initial: initial.clone(),
                    comment: comment.clone(),
                });
                offset
            }
        };
        if local_cursor > BLOCK_BYTES_MAX * 8 {
            return None;
        }
        interface.variables.push(Variable { name, section, data_type, offset: offset as u32, initial, comment, span });
    }
    interface.variables[inherited..].sort_by_key(|variable| variable.section);
    instance.size = (instance_cursor.next_multiple_of(16) / 8) as u32;
    interface.instance_size = instance.size;
    interface.local_size = (local_cursor.next_multiple_of(16) / 8) as u32;
    if id.kind == BlockKind::OrganizationBlock {
        // The declared variables of an OB overlay its start information.
        interface.local_size = interface.local_size.max(START_INFORMATION_BYTES);
    }
    Some(BlockInterface { interface: Arc::new(interface), instance: Arc::new(instance) })
}

/// What is wrong where a block declares more local data than a block of the CPU has; `shown` is what people call it. A CPU refuses to load
/// a block of STEP 7 with more; `loadable` says that the language knows no such limit.
pub(crate) fn too_much_local_data(
    shown: impl FnOnce() -> String,
    interface: &Interface,
    cpu: &CpuType,
    named: Span,
    loadable: bool,
) -> Option<Diagnostic> {
    let (declared, most) = (interface.local_size, cpu.local_data_block);
    let message = || format!("`{}` declares {declared} bytes of local data; CPU {} has {most} for a block", shown(), cpu.name);
    let problem = if loadable { Problem::P5007 } else { Problem::P4025 };
    (declared > most).then(|| Diagnostic::new(problem, named, message()))
}

/// What lies in the instance: the value, or for a complex VAR_IN_OUT a POINTER to it.
pub(crate) fn stored_type(section: Section, data_type: &DataType) -> DataType {
    if section == Section::InOut && is_complex(data_type) { DataType::Pointer } else { data_type.clone() }
}

/// Types that do not fit an accumulator and are passed by a POINTER.
pub(crate) fn is_complex(data_type: &DataType) -> bool {
    data_type.is_long()
        || matches!(
            data_type,
            DataType::DateAndTime
                | DataType::String(_)
                | DataType::WideString(_)
                | DataType::Array { .. }
                | DataType::Struct(_)
                | DataType::Instance { .. }
        )
}
