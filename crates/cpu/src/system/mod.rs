//! System functions: one file each, one row here.

mod any;
mod consistent_data;
mod created_data_blocks;
mod error_masks;
mod extension;
mod iec_timer;
mod instance;
mod interrupt_blocks;
mod interrupt_locks;
mod output_bits;
mod parameters;
mod process_image_partitions;
mod run_time_meters;
mod sfb000_ctu;
mod sfb001_ctd;
mod sfb002_ctud;
mod sfb003_tp;
mod sfb004_ton;
mod sfb005_tof;
mod sfc000_set_clk;
mod sfc001_read_clk;
mod sfc002_set_rtm;
mod sfc003_ctrl_rtm;
mod sfc004_read_rtm;
mod sfc006_rd_sinfo;
mod sfc014_dprd_dat;
mod sfc015_dpwr_dat;
mod sfc020_blkmov;
mod sfc021_fill;
mod sfc022_creat_db;
mod sfc023_del_db;
mod sfc024_test_db;
mod sfc025_compress;
mod sfc026_updat_pi;
mod sfc027_updat_po;
mod sfc028_set_tint;
mod sfc029_can_tint;
mod sfc030_act_tint;
mod sfc031_qry_tint;
mod sfc032_srt_dint;
mod sfc033_can_dint;
mod sfc034_qry_dint;
mod sfc035_mp_alm;
mod sfc036_msk_flt;
mod sfc037_dmsk_flt;
mod sfc038_read_err;
mod sfc039_dis_irt;
mod sfc040_en_irt;
mod sfc041_dis_airt;
mod sfc042_en_airt;
mod sfc043_re_trigr;
mod sfc044_repl_val;
mod sfc046_stp;
mod sfc047_wait;
mod sfc064_time_tck;
mod sfc078_ob_rt;
mod sfc079_set;
mod sfc080_rset;
mod sfc081_ublkmov;
mod state;
#[cfg(test)]
mod tests;

use sieben_engine::{Machine, Reaction};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Interface, Section, SystemBlock, Variable};
use sieben_model::source::Span;
use sieben_model::types::{DataType, place};

use crate::host::CpuHost;

pub(crate) use created_data_blocks::{create, created, delete_created, fit};
pub(crate) use error_masks::filter_bit;
use parameters::Answer;
pub(crate) use state::{Meter, Running, State};

/// A call: the machine, the CPU behind it, and the first parameter pointer.
pub(crate) struct Call<'a, 'h> {
    pub(crate) machine: &'a mut Machine,
    pub(crate) host: &'a mut CpuHost<'h>,
    pub(crate) first: usize,
}

/// What a system block does.
enum Run {
    /// Only its reaction counts; BR stays.
    Reaction(fn(&mut Call<'_, '_>) -> Reaction),
    /// A function with RET_VAL: a value of at least 0 and BR = 1, or an error code and BR = 0.
    Value(fn(&mut Call<'_, '_>) -> Answer),
    /// A function block; the answer is BR.
    Instance(fn(&mut Call<'_, '_>) -> bool),
}

/// The type of a parameter.
enum Type {
    Plain(DataType),
    Made(fn() -> DataType),
}

/// One parameter or variable of an instance.
struct Parameter {
    name: &'static str,
    section: Section,
    data_type: Type,
}

const fn input(name: &'static str, data_type: DataType) -> Parameter {
    Parameter { name, section: Section::Input, data_type: Type::Plain(data_type) }
}

const fn output(name: &'static str, data_type: DataType) -> Parameter {
    Parameter { name, section: Section::Output, data_type: Type::Plain(data_type) }
}

const fn stored(name: &'static str, data_type: DataType) -> Parameter {
    Parameter { name, section: Section::Static, data_type: Type::Plain(data_type) }
}

/// The result. It is the first output in the declaration of a system function: error codes count parameters so.
const fn ret_val() -> Parameter {
    output(RET_VAL, DataType::Int)
}

const RET_VAL: &str = "RET_VAL";

/// One row: the block, its name, its parameters, what it does.
struct Row {
    block: BlockId,
    name: &'static str,
    parameters: &'static [Parameter],
    run: Run,
}

const fn sfc(number: u16, name: &'static str, parameters: &'static [Parameter], run: Run) -> Row {
    Row { block: BlockId::new(BlockKind::SystemFunction, number), name, parameters, run }
}

const fn sfb(number: u16, name: &'static str, parameters: &'static [Parameter], run: fn(&mut Call<'_, '_>) -> bool) -> Row {
    Row { block: BlockId::new(BlockKind::SystemFunctionBlock, number), name, parameters, run: Run::Instance(run) }
}

/// All system blocks of the CPU, functions first, by number.
static TABLE: &[Row] = &[
    sfc000_set_clk::ROW,
    sfc001_read_clk::ROW,
    sfc002_set_rtm::ROW,
    sfc003_ctrl_rtm::ROW,
    sfc004_read_rtm::ROW,
    sfc006_rd_sinfo::ROW,
    sfc014_dprd_dat::ROW,
    sfc015_dpwr_dat::ROW,
    sfc020_blkmov::ROW,
    sfc021_fill::ROW,
    sfc022_creat_db::ROW,
    sfc023_del_db::ROW,
    sfc024_test_db::ROW,
    sfc025_compress::ROW,
    sfc026_updat_pi::ROW,
    sfc027_updat_po::ROW,
    sfc028_set_tint::ROW,
    sfc029_can_tint::ROW,
    sfc030_act_tint::ROW,
    sfc031_qry_tint::ROW,
    sfc032_srt_dint::ROW,
    sfc033_can_dint::ROW,
    sfc034_qry_dint::ROW,
    sfc035_mp_alm::ROW,
    sfc036_msk_flt::ROW,
    sfc037_dmsk_flt::ROW,
    sfc038_read_err::ROW,
    sfc039_dis_irt::ROW,
    sfc040_en_irt::ROW,
    sfc041_dis_airt::ROW,
    sfc042_en_airt::ROW,
    sfc043_re_trigr::ROW,
    sfc044_repl_val::ROW,
    sfc046_stp::ROW,
    sfc047_wait::ROW,
    sfc064_time_tck::ROW,
    sfc078_ob_rt::ROW,
    sfc079_set::ROW,
    sfc080_rset::ROW,
    sfc081_ublkmov::ROW,
    sfb000_ctu::ROW,
    sfb001_ctd::ROW,
    sfb002_ctud::ROW,
    sfb003_tp::ROW,
    sfb004_ton::ROW,
    sfb005_tof::ROW,
];

impl Row {
    fn interface(&self) -> Interface {
        let function = self.block.kind == BlockKind::SystemFunction;
        let mut interface = Interface::default();
        let (mut cursor, mut section) = (0, None);
        for (index, parameter) in self.parameters.iter().enumerate() {
            let data_type = match &parameter.data_type {
                Type::Plain(data_type) => data_type.clone(),
                Type::Made(make) => make(),
            };
            // Each section of an instance starts at an even byte.
            if section.replace(parameter.section) != Some(parameter.section) {
                cursor = u64::next_multiple_of(cursor, 16);
            }
            let (offset, behind) = place(cursor, &data_type);
            cursor = behind;
            interface.variables.push(Variable {
                name: parameter.name.to_owned(),
                section: parameter.section,
                data_type,
                offset: if function { index as u32 } else { offset as u32 },
                initial: Vec::new(),
                comment: String::new(),
                span: Span::default(),
            });
        }
        if !function {
            interface.instance_size = (cursor.next_multiple_of(16) / 8) as u32;
        }
        interface
    }

    fn run(&self, call: &mut Call<'_, '_>) -> Reaction {
        match self.run {
            Run::Reaction(run) => return run(call),
            Run::Value(run) => {
                let answer = run(call);
                call.answer(self.parameters, answer);
            }
            Run::Instance(run) => {
                let done = run(call);
                call.machine.registers.br = u64::from(done);
            }
        }
        Reaction::Continue
    }
}

/// The interfaces of all system functions, for those who compile and complete calls.
pub fn interfaces() -> Vec<SystemBlock> {
    TABLE.iter().map(|row| SystemBlock { block: row.block, name: row.name, interface: row.interface() }).collect()
}

/// The interfaces of the system functions with negative numbers, which only extended programs call.
pub fn extension_interfaces() -> Vec<SystemBlock> {
    extension::CALLED.iter().map(|row| SystemBlock { block: row.block, name: row.name, interface: row.interface() }).collect()
}

/// The row of a system function.
fn row(block: BlockId) -> Option<&'static Row> {
    TABLE.iter().chain(extension::CALLED).find(|row| row.block == block)
}

/// Whether the CPU has this system function.
pub(crate) fn has(block: BlockId) -> bool {
    row(block).is_some() || extension::asked(block).is_some()
}

/// Runs a system function; `None` if the CPU does not have it.
pub(crate) fn run(block: BlockId, call: &mut Call<'_, '_>) -> Option<Reaction> {
    match row(block) {
        Some(row) => Some(row.run(call)),
        None => extension::asked(block).map(|run| run(call)),
    }
}
