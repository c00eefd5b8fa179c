//! Calls of system functions with whatever bytes as parameters, instances and memory.

use std::sync::Arc;

use sieben_engine::machine::{Frame, Origin};
use sieben_engine::{Interpreter, Layout, Program};
use sieben_model::cpu_type::CpuType;
use sieben_model::program::DataBlock;

use super::*;
use crate::clock::{DateAndTime, TimeSource};
use crate::communication::Communication;
use crate::diagnostic_buffer::DiagnosticBuffer;
use crate::failed_statements::FailedStatements;
use crate::forcing::Forces;
use crate::host::{Requests, Time, Watchdog};
use crate::interrupts::Interrupts;
use crate::io::Rack;
use crate::process_image::Images;
use crate::start_information::StartInformation;
use crate::system_state::State;

/// Bytes of each data block: room for the largest instance.
const DATA_BLOCK_BYTES: usize = 400;
/// Parameters that one call passes at most.
const PARAMETERS_MAX: usize = 16;

/// Runs the calls that an input describes: the CPU type, the instance in AR2 (4 bytes), the length of the memory and its bytes,
/// which repeat over all areas; then for each call the row of the table, the number of parameters and their pointers.
///
/// # Panics
/// A call has changed the size of the memory, or left a data block that does not lie in it.
pub fn fuzz(data: &[u8]) {
    let mut rest = data.iter().copied();
    let mut byte = || rest.next();
    let cpu_type = &CpuType::ALL[usize::from(byte().unwrap_or(0)) % CpuType::ALL.len()];
    let ar2 = u32::from_be_bytes([0x84, 0, byte().unwrap_or(0), byte().unwrap_or(0)]);
    let length = usize::from(byte().unwrap_or(0)).max(1);
    let memory: Vec<u8> = (0..length).map(|_| byte().unwrap_or(0)).collect();
    let all: Vec<&Row> = rows().chain(extension::CALLED).collect();
    with_host(cpu_type, &memory, &[], ar2, |call| {
        let size = call.machine.memory.arena.len();
        while let Some(row) = byte() {
            let row = all[usize::from(row) % all.len()];
            let count = usize::from(byte().unwrap_or(0)) % (PARAMETERS_MAX + 1);
            let mut pointer = || u32::from_be_bytes(std::array::from_fn(|_| byte().unwrap_or(0)));
            call.machine.parameters = (0..count).map(|_| pointer()).collect();
            row.run(call);
            assert_eq!(call.machine.memory.arena.len(), size, "{} keeps the memory", row.name);
            for entry in call.machine.memory.data_blocks.iter().flatten() {
                assert!((entry.base + entry.length) as usize <= size, "{} leaves data blocks inside the memory", row.name);
            }
        }
    });
}

fn frame(block: BlockId, origin: Origin, local_base: u32) -> Frame {
    Frame {
        block,
        code: 0,
        resume: 0,
        local_base,
        local_size: 64,
        parameters: 0,
        parameters_end: 0,
        depth: 0,
        class_base: 0,
        in_error: false,
        origin,
    }
}

/// A CPU with DB 1, DB 2 (read-only) and three blocks running, the newest in OB 121.
pub(super) fn with_host(cpu_type: &'static CpuType, memory: &[u8], parameters: &[u32], ar2: u32, check: impl FnOnce(&mut Call<'_, '_>)) {
    let mut program = Program::default();
    for number in [1, 2] {
        let block = DataBlock {
            number,
            based_on: None,
            structure: Arc::default(),
            image: vec![0; DATA_BLOCK_BYTES],
            read_only: number == 2,
            non_retain: false,
            unlinked: false,
        };
        program.data.insert(number, block);
    }
    let layout = Layout::new(cpu_type, &program);
    let engine = Interpreter::load(&program, &layout);
    let mut machine = Machine::new(Arc::new(layout));
    machine.memory.add_reserve();
    for (byte, &value) in machine.memory.arena.iter_mut().zip(memory.iter().cycle()) {
        *byte = value;
    }
    machine.parameters = parameters.to_vec();
    machine.registers.ar2 = u64::from(ar2);
    machine.registers.db_number = 1;
    machine.registers.di_number = 1;
    let registers = Box::new(machine.registers.clone());
    machine.frames =
        vec![frame(BlockId::ob(1), Origin::Start, 0), frame(BlockId::ob(121), Origin::Interrupt { registers, deliver: Some((30, 0)) }, 64)];
    let mut rack = Rack::simulated(cpu_type);
    let mut diagnostics = DiagnosticBuffer::new(100);
    let mut failed_statements = FailedStatements::default();
    let requests = Requests::default();
    let mut clock = || 0;
    let mut watchdog = Watchdog::default();
    let mut state = State::default();
    let mut interrupts = Interrupts::new(|number| cpu_type.has_organization_block(number));
    let mut images = Images::new(Arc::default());
    let communication = Communication::default();
    let mut host = CpuHost {
        cpu_type,
        engine: &*engine,
        rack: &mut rack,
        diagnostics: &mut diagnostics,
        failed_statements: &mut failed_statements,
        scans: 1,
        requests: &requests,
        time: Time { source: TimeSource::Virtual, clock: &mut clock, now_us: 5_000_000, start: DateAndTime::DEFAULT },
        watchdog: &mut watchdog,
        class: StartInformation::default(),
        first: None,
        abort: None,
        program: &program,
        system: &mut state,
        interrupts: &mut interrupts,
        clock_set: false,
        slice: None,
        testing: false,
        images: &mut images,
        written: Vec::new(),
        communication: &communication,
        forces: Forces::Some,
    };
    check(&mut Call { machine: &mut machine, host: &mut host, first: 0 });
}
