//! System blocks that need hardware or a configuration that these CPU types do not have: their interfaces, so that a program
//! that calls them compiles, and the errors that a CPU without that hardware answers with.

use sieben_model::address::Width;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Section;
use sieben_model::types::DataType::{self, Any, BlockData, Bool, Byte, Char, DoubleInt, DoubleWord, Int, String, Word};

use super::instance::Instance;
use super::parameters::NO_JOB;
use super::{Call, Row, Run, in_out, input, output, ret_val};

/// STATUS of a function block that the CPU does not have.
const NOT_ON_THIS_CPU: u32 = 27;
/// The same where STATUS is a double word: no such function (DPV1).
const NOT_ON_THIS_CPU_DPV1: u32 = 0xDF80_B500;

/// A row of the table. A macro, because only in a literal do the parameters live as long as the table.
macro_rules! unavailable {
    ($kind:ident $number:literal $name:literal [$($parameter:expr),*] $code:expr, $only:literal) => {
        Row {
            block: BlockId::new(BlockKind::$kind, $number),
            name: $name,
            parameters: &[$($parameter),*],
            run: Run::Unavailable($code),
            only: Some($only),
        }
    };
}

/// The answer: RET_VAL is the code, BUSY 0; a function block sets ERROR and STATUS. BR = 0.
pub(super) fn run(row: &Row, call: &mut Call<'_, '_>, code: u32) {
    if row.block.kind == BlockKind::SystemFunction {
        if let Some(busy) = row.parameters.iter().position(|parameter| parameter.name == "BUSY") {
            // A BUSY that cannot be written changes nothing about the answer.
            let _ = call.output(busy, Width::Bit, 0);
        }
        let asked = row.parameters.first().is_none_or(|first| first.name != "REQ") || call.input(0, Width::Bit) != Ok(0);
        call.answer(row.parameters, if asked { Err(code as u16) } else { Ok(NO_JOB) });
        return;
    }
    call.machine.registers.br = 0;
    let Some(mut instance) = Instance::open(call.machine, row.interface().instance_size) else { return };
    for (parameter, data_type, offset) in row.laid_out().filter(|(parameter, ..)| parameter.section == Section::Output) {
        let (byte, bit) = ((offset / 8) as usize, (offset % 8) as u8);
        match (parameter.name, data_type) {
            ("ERROR" | "JOB_ERR", _) => instance.set_bit(byte, bit, true),
            ("STATUS", DataType::DoubleWord) => instance.set_time(byte, NOT_ON_THIS_CPU_DPV1 as i32),
            ("STATUS" | "JOB_STAT", _) => instance.set_int(byte, code as i16),
            _ => {}
        }
    }
}

/// All of them, functions first, by number. RET_VAL is 16#8090 where an address is named that nothing is configured at, else
/// mostly 16#80B0: not possible here.
#[rustfmt::skip] // A table.
pub(super) static ROWS: &[Row] = &[
    unavailable!(SystemFunction 7 "DP_PRAL" [input("REQ", Bool), input("IOID", Byte), input("LADDR", Word), input("AL_INFO", DoubleWord), ret_val(), output("BUSY", Bool)] 0x8090, "a DP slave with an interface module"),
    unavailable!(SystemFunction 9 "EN_MSG" [input("REQ", Bool), input("MODE", Byte), input("MESGN", DoubleWord), ret_val(), output("BUSY", Bool)] 0x80B0, "the message system of an S7-400"),
    unavailable!(SystemFunction 10 "DIS_MSG" [input("REQ", Bool), input("MODE", Byte), input("MESGN", DoubleWord), ret_val(), output("BUSY", Bool)] 0x80B0, "the message system of an S7-400"),
    unavailable!(SystemFunction 11 "DPSYC_FR" [input("REQ", Bool), input("LADDR", Word), input("GROUP", Byte), input("MODE", Byte), ret_val(), output("BUSY", Bool)] 0x8090, "a CPU with a DP master"),
    unavailable!(SystemFunction 12 "D_ACT_DP" [input("REQ", Bool), input("MODE", Byte), input("LADDR", Word), ret_val(), output("BUSY", Bool)] 0x8090, "a CPU with a DP master or a PROFINET controller"),
    unavailable!(SystemFunction 17 "ALARM_SQ" [input("SIG", Bool), input("ID", Word), input("EV_ID", DoubleWord), input("SD", Any), ret_val()] 0x80B0, "a CPU with a registered display device"),
    unavailable!(SystemFunction 18 "ALARM_S" [input("SIG", Bool), input("ID", Word), input("EV_ID", DoubleWord), input("SD", Any), ret_val()] 0x80B0, "a CPU with a registered display device"),
    unavailable!(SystemFunction 19 "ALARM_SC" [input("EV_ID", DoubleWord), ret_val(), output("STATE", Bool), output("Q_STATE", Bool)] 0x80B0, "a CPU with a registered display device"),
    unavailable!(SystemFunction 48 "SNC_RTCB" [ret_val()] 0x80B0, "a CPU with slave clocks"),
    unavailable!(SystemFunction 54 "RD_DPARM" [input("IOID", Byte), input("LADDR", Word), input("RECNUM", Byte), ret_val(), output("RECORD", Any)] 0x8090, "a CPU with configured modules"),
    unavailable!(SystemFunction 55 "WR_PARM" [input("REQ", Bool), input("IOID", Byte), input("LADDR", Word), input("RECNUM", Byte), input("RECORD", Any), ret_val(), output("BUSY", Bool)] 0x8090, "a CPU with configured modules"),
    unavailable!(SystemFunction 56 "WR_DPARM" [input("REQ", Bool), input("IOID", Byte), input("LADDR", Word), input("RECNUM", Byte), ret_val(), output("BUSY", Bool)] 0x8090, "a CPU with configured modules"),
    unavailable!(SystemFunction 57 "PARM_MOD" [input("REQ", Bool), input("IOID", Byte), input("LADDR", Word), ret_val(), output("BUSY", Bool)] 0x8090, "a CPU with configured modules"),
    unavailable!(SystemFunction 60 "GD_SND" [input("CIRCLE_ID", Byte), input("BLOCK_ID", Byte), ret_val()] 0x8081, "a CPU with global data communication"),
    unavailable!(SystemFunction 61 "GD_RCV" [input("CIRCLE_ID", Byte), input("BLOCK_ID", Byte), ret_val()] 0x8081, "a CPU with global data communication"),
    unavailable!(SystemFunction 63 "AB_CALL" [ret_val()] 0x80B0, "CPU 614"),
    unavailable!(SystemFunction 70 "GEO_LOG" [input("MASTER", Int), input("STATION", Int), input("SLOT", Int), input("SUBSLOT", Int), ret_val(), output("LADDR", Word)] 0x8094, "a CPU with configured stations"),
    unavailable!(SystemFunction 71 "LOG_GEO" [input("LADDR", Word), ret_val(), output("AREA", Int), output("MASTER", Int), output("STATION", Int), output("SLOT", Int), output("SUBSLOT", Int), output("OFFSET", Int)] 0x8090, "a CPU with configured stations"),
    unavailable!(SystemFunction 72 "I_GET" [input("REQ", Bool), input("CONT", Bool), input("IOID", Byte), input("LADDR", Word), input("VAR_ADDR", Any), ret_val(), output("BUSY", Bool), output("RD", Any)] 0x8090, "a CPU with intelligent modules in its own station"),
    unavailable!(SystemFunction 73 "I_PUT" [input("REQ", Bool), input("CONT", Bool), input("IOID", Byte), input("LADDR", Word), input("VAR_ADDR", Any), input("SD", Any), ret_val(), output("BUSY", Bool)] 0x8090, "a CPU with intelligent modules in its own station"),
    unavailable!(SystemFunction 74 "I_ABORT" [input("REQ", Bool), input("IOID", Byte), input("LADDR", Word), ret_val(), output("BUSY", Bool)] 0x8090, "a CPU with intelligent modules in its own station"),
    unavailable!(SystemFunction 82 "CREA_DBL" [input("REQ", Bool), input("LOW_LIMIT", Word), input("UP_LIMIT", Word), input("COUNT", Word), input("ATTRIB", Byte), input("SRCBLK", Any), ret_val(), output("BUSY", Bool), output("DB_NUM", Word)] 0x80B0, "a CPU with a memory card"),
    unavailable!(SystemFunction 87 "C_DIAG" [input("REQ", Bool), input("MODE", Byte), ret_val(), output("BUSY", Bool), output("N_CON", Int), output("CON_ARR", Any)] 0x80B0, "a CPU with configured connections"),
    unavailable!(SystemFunction 90 "H_CTRL" [input("MODE", Byte), input("SUBMODE", Byte), ret_val()] 0x80B0, "an S7-400H"),
    unavailable!(SystemFunction 99 "WWW" [input("DB_WEB", BlockData), ret_val()] 0x80B0, "a CPU with a web server"),
    unavailable!(SystemFunction 102 "RD_DPARA" [input("REQ", Bool), input("IOID", Byte), input("LADDR", Word), input("RECNUM", Byte), ret_val(), output("BUSY", Bool), output("RECORD", Any)] 0x8090, "a CPU with configured modules"),
    unavailable!(SystemFunction 103 "DP_TOPOL" [input("REQ", Bool), input("R", Bool), input("DP_ID", Int), ret_val(), output("BUSY", Bool), output("DPR", Byte), output("DPRI", Byte)] 0x80B0, "a CPU with a DP master"),
    unavailable!(SystemFunction 104 "CiR" [input("MODE", Byte), input("FRZ_TIME", Int), ret_val(), output("A_FT", Int)] 0x80B0, "an S7-400 with configuration in RUN"),
    unavailable!(SystemFunction 105 "READ_SI" [input("MODE", Byte), ret_val(), output("N_SYS", Int), output("SYS_INST", Any)] 0x80B0, "a CPU with a registered display device"),
    unavailable!(SystemFunction 106 "DEL_SI" [input("MODE", Byte), input("ID_NR", DoubleWord), ret_val()] 0x80B0, "a CPU with a registered display device"),
    unavailable!(SystemFunction 107 "ALARM_DQ" [input("SIG", Bool), input("ID", Word), input("EV_ID", DoubleWord), input("CMP_ID", DoubleWord), input("SD", Any), ret_val()] 0x80B0, "a CPU with a registered display device"),
    unavailable!(SystemFunction 108 "ALARM_D" [input("SIG", Bool), input("ID", Word), input("EV_ID", DoubleWord), input("CMP_ID", DoubleWord), input("SD", Any), ret_val()] 0x80B0, "a CPU with a registered display device"),
    unavailable!(SystemFunction 109 "PROTECT" [input("MODE", Word), ret_val()] 0x80B0, "a CPU with protection levels"),
    unavailable!(SystemFunction 112 "PN_IN" [ret_val()] 0x80B0, "a CPU with PROFINET CBA"),
    unavailable!(SystemFunction 113 "PN_OUT" [ret_val()] 0x80B0, "a CPU with PROFINET CBA"),
    unavailable!(SystemFunctionBlock 16 "PRINT" [input("REQ", Bool), input("ID", Word), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("PRN_NR", Byte), in_out("FORMAT", String(254)), in_out("SD_1", Any), in_out("SD_2", Any), in_out("SD_3", Any), in_out("SD_4", Any)] NOT_ON_THIS_CPU, "an S7-400 with a printer connection"),
    unavailable!(SystemFunctionBlock 19 "START" [input("REQ", Bool), input("ID", Word), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("PI_NAME", Any), in_out("ARG", Any), in_out("IO_STATE", Byte)] NOT_ON_THIS_CPU, "an S7-400 with configured connections"),
    unavailable!(SystemFunctionBlock 20 "STOP" [input("REQ", Bool), input("ID", Word), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("PI_NAME", Any), in_out("IO_STATE", Byte)] NOT_ON_THIS_CPU, "an S7-400 with configured connections"),
    unavailable!(SystemFunctionBlock 21 "RESUME" [input("REQ", Bool), input("ID", Word), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("PI_NAME", Any), in_out("ARG", Any), in_out("IO_STATE", Byte)] NOT_ON_THIS_CPU, "an S7-400 with configured connections"),
    unavailable!(SystemFunctionBlock 22 "STATUS" [input("REQ", Bool), input("ID", Word), output("NDR", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("PHYS", Any), in_out("LOG", Any), in_out("LOCAL", Any)] NOT_ON_THIS_CPU, "an S7-400 with configured connections"),
    unavailable!(SystemFunctionBlock 23 "USTATUS" [input("EN_R", Bool), input("ID", Word), output("NDR", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("PHYS", Any), in_out("LOG", Any), in_out("LOCAL", Any)] NOT_ON_THIS_CPU, "an S7-400 with configured connections"),
    unavailable!(SystemFunctionBlock 29 "HS_COUNT" [input("PRES_COUNT", DoubleInt), input("PRES_COMP_A", DoubleInt), input("PRES_COMP_B", DoubleInt), input("EN_COUNT", Bool), input("EN_DO", Bool), input("SET_COUNT", Bool), input("SET_COMP_A", Bool), input("SET_COMP_B", Bool), output("COUNT", DoubleInt), output("COMP_A", DoubleInt), output("COMP_B", DoubleInt), output("STATUS_A", Bool), output("STATUS_B", Bool)] NOT_ON_THIS_CPU, "CPU 312 IFM and 314 IFM"),
    unavailable!(SystemFunctionBlock 30 "FREQ_MES" [input("PRES_U_LIMIT", DoubleInt), input("PRES_L_LIMIT", DoubleInt), input("SET_U_LIMIT", Bool), input("SET_L_LIMIT", Bool), output("FREQ", DoubleInt), output("U_LIMIT", DoubleInt), output("L_LIMIT", DoubleInt), output("STATUS_U", Bool), output("STATUS_L", Bool)] NOT_ON_THIS_CPU, "CPU 312 IFM and 314 IFM"),
    unavailable!(SystemFunctionBlock 31 "NOTIFY_8P" [input("SIG_1", Bool), input("SIG_2", Bool), input("SIG_3", Bool), input("SIG_4", Bool), input("SIG_5", Bool), input("SIG_6", Bool), input("SIG_7", Bool), input("SIG_8", Bool), input("ID", Word), input("EV_ID", DoubleWord), input("SEVERITY", Word), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("SD_1", Any), in_out("SD_2", Any), in_out("SD_3", Any), in_out("SD_4", Any), in_out("SD_5", Any), in_out("SD_6", Any), in_out("SD_7", Any), in_out("SD_8", Any), in_out("SD_9", Any), in_out("SD_10", Any)] NOT_ON_THIS_CPU, "an S7-400 with a display device"),
    unavailable!(SystemFunctionBlock 33 "ALARM" [input("EN_R", Bool), input("SIG", Bool), input("ID", Word), input("EV_ID", DoubleWord), input("SEVERITY", Word), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), output("ACK_DN", Bool), output("ACK_UP", Bool), in_out("SD_1", Any), in_out("SD_2", Any), in_out("SD_3", Any), in_out("SD_4", Any), in_out("SD_5", Any), in_out("SD_6", Any), in_out("SD_7", Any), in_out("SD_8", Any), in_out("SD_9", Any), in_out("SD_10", Any)] NOT_ON_THIS_CPU, "an S7-400 with a display device"),
    unavailable!(SystemFunctionBlock 34 "ALARM_8" [input("EN_R", Bool), input("SIG_1", Bool), input("SIG_2", Bool), input("SIG_3", Bool), input("SIG_4", Bool), input("SIG_5", Bool), input("SIG_6", Bool), input("SIG_7", Bool), input("SIG_8", Bool), input("ID", Word), input("EV_ID", DoubleWord), input("SEVERITY", Word), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), output("ACK_STATE", Word)] NOT_ON_THIS_CPU, "an S7-400 with a display device"),
    unavailable!(SystemFunctionBlock 35 "ALARM_8P" [input("EN_R", Bool), input("SIG_1", Bool), input("SIG_2", Bool), input("SIG_3", Bool), input("SIG_4", Bool), input("SIG_5", Bool), input("SIG_6", Bool), input("SIG_7", Bool), input("SIG_8", Bool), input("ID", Word), input("EV_ID", DoubleWord), input("SEVERITY", Word), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), output("ACK_STATE", Word), in_out("SD_1", Any), in_out("SD_2", Any), in_out("SD_3", Any), in_out("SD_4", Any), in_out("SD_5", Any), in_out("SD_6", Any), in_out("SD_7", Any), in_out("SD_8", Any), in_out("SD_9", Any), in_out("SD_10", Any)] NOT_ON_THIS_CPU, "an S7-400 with a display device"),
    unavailable!(SystemFunctionBlock 36 "NOTIFY" [input("SIG", Bool), input("ID", Word), input("EV_ID", DoubleWord), input("SEVERITY", Word), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("SD_1", Any), in_out("SD_2", Any), in_out("SD_3", Any), in_out("SD_4", Any), in_out("SD_5", Any), in_out("SD_6", Any), in_out("SD_7", Any), in_out("SD_8", Any), in_out("SD_9", Any), in_out("SD_10", Any)] NOT_ON_THIS_CPU, "an S7-400 with a display device"),
    unavailable!(SystemFunctionBlock 37 "AR_SEND" [input("REQ", Bool), input("R", Bool), input("ID", Word), input("AR_ID", DoubleWord), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Int), in_out("SD_1", Any), in_out("LEN", Word)] NOT_ON_THIS_CPU, "an S7-400 with WinCC"),
    unavailable!(SystemFunctionBlock 38 "HSC_A_B" [output("ERROR", Bool), output("STATUS", Word)] NOT_ON_THIS_CPU, "CPU 314 IFM"),
    unavailable!(SystemFunctionBlock 39 "POS" [output("ERROR", Bool), output("STATUS", Word)] NOT_ON_THIS_CPU, "CPU 314 IFM"),
    unavailable!(SystemFunctionBlock 44 "ANALOG" [output("ERROR", Bool), output("STATUS", Word)] NOT_ON_THIS_CPU, "CPU 31xC"),
    unavailable!(SystemFunctionBlock 46 "DIGITAL" [output("ERROR", Bool), output("STATUS", Word)] NOT_ON_THIS_CPU, "CPU 31xC"),
    unavailable!(SystemFunctionBlock 47 "COUNT" [input("LADDR", Word), input("CHANNEL", Int), input("SW_GATE", Bool), input("JOB_REQ", Bool), input("JOB_ID", Word), input("JOB_VAL", DoubleInt), output("STS_GATE", Bool), output("STS_STRT", Bool), output("STS_LTCH", Bool), output("STS_DO", Bool), output("STS_C_DN", Bool), output("STS_C_UP", Bool), output("COUNTVAL", DoubleInt), output("LATCHVAL", DoubleInt), output("JOB_DONE", Bool), output("JOB_ERR", Bool), output("JOB_STAT", Word)] NOT_ON_THIS_CPU, "CPU 31xC"),
    unavailable!(SystemFunctionBlock 48 "FREQUENC" [input("LADDR", Word), input("CHANNEL", Int), input("SW_GATE", Bool), input("JOB_REQ", Bool), input("JOB_ID", Word), input("JOB_VAL", DoubleInt), output("STS_GATE", Bool), output("STS_STRT", Bool), output("STS_DO", Bool), output("STS_C_DN", Bool), output("STS_C_UP", Bool), output("MEAS_VAL", DoubleInt), output("COUNTVAL", DoubleInt), output("JOB_DONE", Bool), output("JOB_ERR", Bool), output("JOB_STAT", Word)] NOT_ON_THIS_CPU, "CPU 31xC"),
    unavailable!(SystemFunctionBlock 49 "PULSE" [input("LADDR", Word), input("CHANNEL", Int), input("SW_EN", Bool), input("MAN_DO", Bool), input("SET_DO", Bool), input("OUTP_VAL", Int), input("JOB_REQ", Bool), input("JOB_ID", Word), input("JOB_VAL", DoubleInt), output("STS_EN", Bool), output("STS_STRT", Bool), output("STS_DO", Bool), output("JOB_DONE", Bool), output("JOB_ERR", Bool), output("JOB_STAT", Word)] NOT_ON_THIS_CPU, "CPU 31xC"),
    unavailable!(SystemFunctionBlock 60 "SEND_PTP" [input("REQ", Bool), input("R", Bool), input("LADDR", Word), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("SD_1", Any), in_out("LEN", Int)] NOT_ON_THIS_CPU, "CPU 31xC PtP"),
    unavailable!(SystemFunctionBlock 61 "RCV_PTP" [input("EN_R", Bool), input("R", Bool), input("LADDR", Word), output("NDR", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("RD_1", Any), in_out("LEN", Int)] NOT_ON_THIS_CPU, "CPU 31xC PtP"),
    unavailable!(SystemFunctionBlock 62 "RES_RCVB" [input("REQ", Bool), input("R", Bool), input("LADDR", Word), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word)] NOT_ON_THIS_CPU, "CPU 31xC PtP"),
    unavailable!(SystemFunctionBlock 63 "SEND_RK" [input("SYNC_DB", Int), input("REQ", Bool), input("R", Bool), input("LADDR", Word), input("R_CPU", Int), input("R_TYPE", Char), input("R_DBNO", Int), input("R_OFFSET", Int), input("R_CF_BYT", Int), input("R_CF_BIT", Int), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("SD_1", Any), in_out("LEN", Int)] NOT_ON_THIS_CPU, "CPU 31xC PtP"),
    unavailable!(SystemFunctionBlock 64 "FETCH_RK" [input("SYNC_DB", Int), input("REQ", Bool), input("R", Bool), input("LADDR", Word), input("R_CPU", Int), input("R_TYPE", Char), input("R_DBNO", Int), input("R_OFFSET", Int), input("R_CF_BYT", Int), input("R_CF_BIT", Int), output("DONE", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("RD_1", Any), in_out("LEN", Int)] NOT_ON_THIS_CPU, "CPU 31xC PtP"),
    unavailable!(SystemFunctionBlock 65 "SERVE_RK" [input("SYNC_DB", Int), input("EN_R", Bool), input("R", Bool), input("LADDR", Word), output("L_TYPE", Char), output("L_DBNO", Int), output("L_OFFSET", Int), output("L_CF_BYT", Int), output("L_CF_BIT", Int), output("NDR", Bool), output("ERROR", Bool), output("STATUS", Word), in_out("LEN", Int)] NOT_ON_THIS_CPU, "CPU 31xC PtP"),
    unavailable!(SystemFunctionBlock 73 "RCVREC" [input("MODE", Int), input("F_ID", DoubleWord), input("MLEN", Int), input("CODE1", Byte), input("CODE2", Byte), output("NEW", Bool), output("STATUS", DoubleWord), output("SLOT", Int), output("SUBSLOT", Int), output("INDEX", Int), output("LEN", Int), in_out("RECORD", Any)] NOT_ON_THIS_CPU, "an I-device"),
    unavailable!(SystemFunctionBlock 75 "SALRM" [input("REQ", Bool), input("ID", DoubleWord), input("ATYPE", Int), input("ASPEC", Byte), input("LEN", Int), output("DONE", Bool), output("BUSY", Bool), output("ERROR", Bool), output("STATUS", DoubleWord), in_out("AINFO", Any)] NOT_ON_THIS_CPU, "an I-device"),
    unavailable!(SystemFunctionBlock 81 "RD_DPAR" [input("REQ", Bool), input("LADDR", Word), input("INDEX", Int), output("VALID", Bool), output("BUSY", Bool), output("ERROR", Bool), output("STATUS", DoubleWord), output("LEN", Int), in_out("RECORD", Any)] NOT_ON_THIS_CPU, "a CPU with configured modules"),
];
