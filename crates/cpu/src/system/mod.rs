//! System functions: one file each, one row here.

mod any;
mod connection;
mod consistent_data;
mod controller;
#[cfg(test)]
mod controller_tests;
mod data_blocks;
mod declaration;
mod dpv1;
mod error_masks;
mod extension;
mod fuzz;
mod iec_timer;
mod instance;
mod interrupt_blocks;
mod interrupt_locks;
mod load_memory;
mod modules;
mod mpi_partner;
mod output_bits;
pub(crate) mod own_errors;
mod parameters;
mod process_image_partitions;
mod records;
mod run_time_meters;
mod sfb000_ctu;
mod sfb001_ctd;
mod sfb002_ctud;
mod sfb003_tp;
mod sfb004_ton;
mod sfb005_tof;
mod sfb008_usend;
mod sfb009_urcv;
mod sfb012_bsend;
mod sfb013_brcv;
mod sfb014_get;
mod sfb015_put;
mod sfb032_drum;
mod sfb041_cont_c;
mod sfb042_cont_s;
mod sfb043_pulsegen;
mod sfb052_rdrec;
mod sfb053_wrrec;
mod sfb054_ralrm;
mod sfc000_set_clk;
mod sfc001_read_clk;
mod sfc002_set_rtm;
mod sfc003_ctrl_rtm;
mod sfc004_read_rtm;
mod sfc005_gadr_lgc;
mod sfc006_rd_sinfo;
mod sfc013_dpnrm_dg;
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
mod sfc049_lgc_gadr;
mod sfc050_rd_lgadr;
mod sfc051_rdsysst;
mod sfc052_wr_usmsg;
mod sfc058_wr_rec;
mod sfc059_rd_rec;
mod sfc062_control;
mod sfc064_time_tck;
mod sfc065_x_send;
mod sfc066_x_rcv;
mod sfc067_x_get;
mod sfc068_x_put;
mod sfc069_x_abort;
mod sfc078_ob_rt;
mod sfc079_set;
mod sfc080_rset;
mod sfc081_ublkmov;
mod sfc083_read_dbl;
mod sfc084_writ_dbl;
mod sfc085_crea_db;
mod sfc100_set_clks;
mod sfc101_rtm;
pub mod summaries;
pub(crate) mod testing;
#[cfg(test)]
mod tests;
mod unavailable;

use sieben_engine::{Machine, Reaction};
use sieben_model::address::Width;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::extension::is_negative;
use sieben_model::interface::{Interface, SystemBlock};

use crate::host::CpuHost;

use declaration::{
    Initial, Parameter, RET_VAL, Row, Run, Type, in_out, input, made, output, preset, ret_val, sfb, sfc, stored, stored_preset,
};
pub(crate) use error_masks::filter_bit;
pub use fuzz::fuzz;

/// A call: the machine, the CPU behind it, and the first parameter pointer.
pub(crate) struct Call<'a, 'h> {
    pub(crate) machine: &'a mut Machine,
    pub(crate) host: &'a mut CpuHost<'h>,
    pub(crate) first: usize,
}

/// All system blocks of the CPU, functions first, by number.
static TABLE: &[Row] = &[
    sfc000_set_clk::ROW,
    sfc001_read_clk::ROW,
    sfc002_set_rtm::ROW,
    sfc003_ctrl_rtm::ROW,
    sfc004_read_rtm::ROW,
    sfc005_gadr_lgc::ROW,
    sfc006_rd_sinfo::ROW,
    sfc013_dpnrm_dg::ROW,
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
    sfc049_lgc_gadr::ROW,
    sfc050_rd_lgadr::ROW,
    sfc051_rdsysst::ROW,
    sfc052_wr_usmsg::ROW,
    sfc058_wr_rec::ROW,
    sfc059_rd_rec::ROW,
    sfc062_control::ROW,
    sfc064_time_tck::ROW,
    sfc065_x_send::ROW,
    sfc066_x_rcv::ROW,
    sfc067_x_get::ROW,
    sfc068_x_put::ROW,
    sfc069_x_abort::ROW,
    sfc078_ob_rt::ROW,
    sfc079_set::ROW,
    sfc080_rset::ROW,
    sfc081_ublkmov::ROW,
    sfc083_read_dbl::ROW,
    sfc084_writ_dbl::ROW,
    sfc085_crea_db::ROW,
    sfc100_set_clks::ROW,
    sfc101_rtm::ROW,
    sfb000_ctu::ROW,
    sfb001_ctd::ROW,
    sfb002_ctud::ROW,
    sfb003_tp::ROW,
    sfb004_ton::ROW,
    sfb005_tof::ROW,
    sfb008_usend::ROW,
    sfb009_urcv::ROW,
    sfb012_bsend::ROW,
    sfb013_brcv::ROW,
    sfb014_get::ROW,
    sfb015_put::ROW,
    sfb032_drum::ROW,
    sfb041_cont_c::ROW,
    sfb042_cont_s::ROW,
    sfb043_pulsegen::ROW,
    sfb052_rdrec::ROW,
    sfb053_wrrec::ROW,
    sfb054_ralrm::ROW,
];

/// Every system block, those that this CPU does not have included.
fn rows() -> impl Iterator<Item = &'static Row> {
    TABLE.iter().chain(unavailable::ROWS)
}

/// The interfaces of all system functions, by number, functions first, for those who compile and complete calls. Those with negative
/// numbers among them are what the code of an instruction asks.
pub fn interfaces() -> Vec<SystemBlock> {
    let mut blocks: Vec<SystemBlock> = rows().chain(own_errors::CALLED).map(Row::system_block).collect();
    blocks.sort_by_key(|block| block.block);
    blocks
}

/// The interfaces of those that programs call by their numbers.
pub fn numbered() -> Vec<SystemBlock> {
    interfaces().into_iter().filter(|block| !is_negative(block.block)).collect()
}

/// The interfaces of the system functions with negative numbers, which only extended programs call.
pub fn extension_interfaces() -> Vec<SystemBlock> {
    extension::CALLED.iter().map(Row::system_block).collect()
}

/// The interfaces of what the code of tests asks, which only programs with a test file call.
pub fn test_interfaces() -> Vec<SystemBlock> {
    testing::CALLED.iter().map(Row::system_block).collect()
}

/// Bytes of the instance of a system function block; `None` for a function.
pub(crate) fn instance_bytes(block: BlockId) -> Option<u32> {
    let is_function_block = block.kind == BlockKind::SystemFunctionBlock;
    row(block).filter(|_| is_function_block).map(|row| row.system_block().interface.instance_size)
}

/// How wide the result of a function is; `None` if it has none that is elementary.
pub fn result_width(interface: &Interface) -> Option<Width> {
    testing::result_of(interface).map(|(_, width)| width)
}

/// The row of a system function. The two large tables are sorted.
fn row(block: BlockId) -> Option<&'static Row> {
    let sorted = |table: &'static [Row]| table.binary_search_by_key(&block, |row| row.block).ok().map(|at| &table[at]);
    sorted(TABLE)
        .or_else(|| sorted(unavailable::ROWS))
        .or_else(|| extension::CALLED.iter().chain(testing::CALLED).chain(own_errors::CALLED).find(|row| row.block == block))
}

/// Whether a call of this system function does something: those that the CPU does not have answer with an error.
pub(crate) fn has(block: BlockId) -> bool {
    row(block).is_some() || extension::asked(block).is_some()
}

/// Runs a system function; `None` if there is none of this number.
pub(crate) fn run(block: BlockId, call: &mut Call<'_, '_>) -> Option<Reaction> {
    match row(block) {
        Some(row) => Some(row.run(call)),
        None => extension::asked(block).map(|run| run(call)),
    }
}
