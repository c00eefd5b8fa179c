//! Data blocks that come to a program, take the place of others in it or go, while all of its code stays.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::Arc;

use sieben_engine::Program;
use sieben_engine::ir::{Inst, Place, Var};
use sieben_model::block::BlockId;
use sieben_model::cpu_type::CpuType;
use sieben_model::program::DataBlock;
use sieben_model::types::Structure;

/// Where the number of a data block stands in a pointer that leads into one.
const NUMBER_SHIFT: u32 = 32;

/// What a program is to have of data blocks.
#[derive(Clone, Debug)]
pub struct DataBlockChange {
    pub(crate) base: Arc<Program>,
    pub(crate) cpu_type: &'static CpuType,
    put: BTreeMap<u16, DataBlock>,
    removed: BTreeSet<u16>,
}

/// Why data blocks are not deleted: the code of a block names one of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DataBlockInUse {
    /// The data block.
    pub number: u16,
    /// The block that names it.
    pub by: BlockId,
}

impl fmt::Display for DataBlockInUse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` uses DB{}", self.by, self.number)
    }
}

impl std::error::Error for DataBlockInUse {}

impl DataBlockChange {
    pub(crate) fn new(base: Arc<Program>, cpu_type: &'static CpuType, put: Vec<DataBlock>, removed: BTreeSet<u16>) -> Self {
        Self { base, cpu_type, put: put.into_iter().map(|block| (block.number, block)).collect(), removed }
    }

    /// The data blocks that keep no value: they have those of the change, or go.
    pub(crate) fn taken(&self) -> BTreeSet<u16> {
        self.put.keys().chain(&self.removed).copied().collect()
    }

    /// The program with the change.
    ///
    /// # Errors
    /// Code uses a data block that is to go.
    pub(crate) fn program(&self) -> Result<Program, DataBlockInUse> {
        for (&by, block) in &self.base.code {
            if let Some(number) = self.removed.iter().copied().find(|&number| names(&block.code.insts, number)) {
                return Err(DataBlockInUse { number, by });
            }
        }
        let mut program = Program::clone(&self.base);
        for number in &self.removed {
            program.data.remove(number);
            program.attributes.remove(&BlockId::db(*number));
        }
        program.data.extend(self.put.iter().map(|(&number, block)| (number, block.clone())));
        Ok(program)
    }
}

/// Whether statements open a data block, call it as an instance or point into it with a number that stands in them.
fn names(insts: &[Inst], number: u16) -> bool {
    let mut constants = [None; 256];
    for inst in insts {
        let constant = |Var(var): &Var| constants[usize::from(*var)];
        let points = |pointer: &Var| constant(pointer).is_some_and(|value: u64| value >> NUMBER_SHIFT & 0xFFFF == u64::from(number));
        let leads = |place: &Place| match place {
            Place::Crossing { pointer, .. } => points(pointer),
            Place::Fixed { .. } | Place::Indirect { .. } => false,
        };
        let named = match inst {
            Inst::Constant { dst: Var(dst), value } => {
                constants[usize::from(*dst)] = Some(*value);
                false
            }
            Inst::Open { number: opened, .. } => constant(opened) == Some(u64::from(number)),
            Inst::Load { place, .. } | Inst::Store { place, .. } => leads(place),
            Inst::Move { from, to, .. } | Inst::Text { from, to, .. } => leads(from) || leads(to),
            Inst::PassParameter { src } => points(src),
            _ => false,
        };
        if named {
            return true;
        }
    }
    false
}

/// A data block that has only its bytes: nothing says how they are declared.
pub fn undeclared(number: u16, values: Vec<u8>) -> DataBlock {
    let size = u32::try_from(values.len()).unwrap_or(u32::MAX);
    let structure = Structure { name: None, fields: Vec::new(), size, index: Default::default() };
    DataBlock {
        number,
        based_on: None,
        structure: Arc::new(structure),
        image: values,
        read_only: false,
        non_retain: false,
        unlinked: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sieben_engine::CodeBlock;
    use sieben_engine::ir::{Code, DataRegister};
    use sieben_model::address::Width;

    /// DB 1 to DB 3, and OB 1 with these instructions.
    fn base(insts: Vec<Inst>) -> Arc<Program> {
        let code = CodeBlock { code: Code { insts, ..Code::default() }, ..CodeBlock::default() };
        Arc::new(Program {
            code: [(BlockId::ob(1), code)].into(),
            data: [1, 2, 3].map(|number| (number, undeclared(number, vec![number as u8; 4]))).into(),
            ..Program::default()
        })
    }

    fn changed(base: &Arc<Program>, put: Vec<DataBlock>, removed: &[u16]) -> Result<Vec<(u16, Vec<u8>)>, DataBlockInUse> {
        let change = DataBlockChange::new(Arc::clone(base), &CpuType::ALL[0], put, removed.iter().copied().collect());
        Ok(change.program()?.data.into_iter().map(|(number, block)| (number, block.image)).collect())
    }

    #[test]
    fn data_blocks_come_change_and_go_and_the_rest_stays() {
        let base = base(Vec::new());
        let after = changed(&base, vec![undeclared(2, vec![9; 6]), undeclared(7, vec![8; 2])], &[3]);
        assert_eq!(after, Ok(vec![(1, vec![1; 4]), (2, vec![9; 6]), (7, vec![8; 2])]));
        assert_eq!(changed(&base, Vec::new(), &[]).map(|data| data.len()), Ok(3));
    }

    #[test]
    fn a_data_block_that_code_names_does_not_go() {
        let [a, b] = [Var(100), Var(101)];
        let constant = |dst, value| Inst::Constant { dst, value };
        let open = |number| Inst::Open { register: DataRegister::Shared, number };
        let through = |pointer| Inst::Store { place: Place::Crossing { pointer, offset: 0 }, width: Width::Byte, src: a };
        let cases = [
            (vec![constant(a, 1), open(a)], [true, false, false]),
            (vec![constant(a, 1), constant(a, 2), open(a)], [false, true, false]),
            (vec![constant(a, 1), constant(b, 2), open(a), open(b)], [true, true, false]),
            (vec![constant(a, 3)], [false, false, false]),
            (vec![constant(a, 3 << 32 | 0x8400_0000), through(a)], [false, false, true]),
            (vec![constant(a, 3 << 32), Inst::PassParameter { src: a }], [false, false, true]),
            (Vec::new(), [false, false, false]),
        ];
        for (insts, used) in cases {
            let base = base(insts);
            for (number, used) in (1..).zip(used) {
                let refused = Err(DataBlockInUse { number, by: BlockId::ob(1) });
                let after = changed(&base, Vec::new(), &[number]).map(|data| data.len());
                assert_eq!(after, if used { refused } else { Ok(2) }, "DB {number}: {:?}", base.code);
            }
        }
    }
}
