//! Data blocks with the bytes that their declarations give them.

use std::sync::Arc;

use sieben_model::block::BlockId;
use sieben_model::program::DataBlock;
use sieben_model::types::{DataType, Structure};

use super::values::write_initial;

/// The layout of a data block and what it is based on.
#[derive(Clone, Debug)]
pub(crate) struct DataLayout {
    pub(crate) structure: Arc<Structure>,
    pub(crate) based_on: Option<BlockId>,
}

/// A data block as its declarations alone define it.
pub(crate) fn instance(number: u16, layout: &DataLayout) -> DataBlock {
    let mut image = vec![0; layout.structure.size as usize];
    write_initial(&mut image, 0, &DataType::Struct(Arc::clone(&layout.structure)), &[]);
    DataBlock {
        number,
        based_on: layout.based_on,
        structure: Arc::clone(&layout.structure),
        image,
        read_only: false,
        non_retain: false,
        unlinked: false,
    }
}
