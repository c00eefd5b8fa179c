//! The fourth step: the code of one block.

use std::sync::Arc;

use sieben_engine::CodeBlock;
use sieben_model::block::BlockId;

use super::check::Checked;
use super::declarations::Names;
use crate::body::CheckedBody;
use crate::coverage::Countable;
use crate::st::declare::Environment;
use crate::stl::lower::{lower, lower_counted};

/// A block in IR.
#[derive(Clone, Debug)]
pub(super) struct Lowered {
    /// What it was made of.
    of: Arc<Checked>,
    pub(super) code: CodeBlock,
    /// What can be counted in it, if that is asked for.
    pub(super) countable: Option<Countable>,
}

/// The code of a block that could be checked; that of before, if it was made of the same. Lowering asks only for interfaces that the check
/// asked for, and for members of objects, which belong to the surroundings.
pub(super) fn block(
    names: &Names<'_>,
    environment: &Environment<'_>,
    id: BlockId,
    checked: &Arc<Checked>,
    counted: bool,
    before: Option<&Arc<Lowered>>,
) -> Option<Arc<Lowered>> {
    if let Some(before) = before.filter(|before| Arc::ptr_eq(&before.of, checked)) {
        return Some(Arc::clone(before));
    }
    let body = checked.body.as_deref()?;
    let (code, countable) = match body {
        CheckedBody::Stl(block) => {
            let code = if counted { lower_counted(block, &names.cpu) } else { lower(block, &names.cpu) };
            let countable = if counted { body.countable(&code) } else { None };
            (code, countable)
        }
        CheckedBody::St(typed) => environment.lower_block(id, *names.items.code.get(&id)?, typed, counted),
    };
    Some(Arc::new(Lowered { of: Arc::clone(checked), code, countable }))
}
