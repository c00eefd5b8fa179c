//! The interpreter's loop.

use sieben_model::address::Width;
use sieben_model::block::{BlockId, BlockKind};

use super::Interpreter;
use super::local_data;
use super::prepare::{Block, Step};
use super::stores;
use crate::access::{
    File, Target, after_call, caller_registers, in_data_block, load_file, locate, move_bytes, open, plan_move, read_peripheral, registers,
    restore_caller, store_file, write_peripheral, write_start_information,
};
use crate::fault::{Abort, Fault, Place};
use crate::host::{Context, Entry, Exit, Reaction, StopReason};
use crate::ir::{Callee, OnFault};
use crate::machine::{Frame, Machine, Origin, Register, Registers};
use crate::texts;
use crate::tracer::StatementEvent;

/// Where the loop goes on after something unusual.
enum Next {
    /// At this step of the same block.
    At(usize),
    /// In the block of the newest frame, at its `resume`.
    Frame,
    /// Not at all.
    Leave(Exit),
}

/// What goes on after the end of a block.
enum Left {
    /// The block that called it, or a statement whose load failed.
    Caller,
    /// A block that was interrupted between two statements.
    Interrupted,
    /// None: it was the outermost block.
    Nothing,
}

/// The statement whose event is still open, while someone watches.
struct Watched {
    place: Place,
    before: Registers,
}

impl Interpreter {
    pub(super) fn start(&self, context: &mut Context<'_>, entry: &Entry) -> Exit {
        let Some(&code) = self.index.get(&entry.block) else { return Exit::Finished };
        context.machine.frames.clear();
        context.machine.parameters.clear();
        context.machine.registers = entry.registers.as_deref().cloned().unwrap_or_else(Registers::fresh);
        let mut file = load_file(&context.machine.registers);
        if let Err(abort) = self.enter(context.machine, &mut file, code, Origin::Start, 0) {
            return match self.fault(context, &mut file, &self.blocks[code as usize], 0, &Fault::Abort(abort), None) {
                Next::Leave(exit) => exit,
                Next::At(_) | Next::Frame => Exit::Finished,
            };
        }
        write_start_information(context.machine, &entry.start_information);
        self.go_on(context)
    }

    /// Goes on with the frames of the machine. Whatever may interrupt them comes first.
    pub(super) fn resume(&self, context: &mut Context<'_>) -> Exit {
        let mut file = load_file(&context.machine.registers);
        if let Next::Leave(exit) = self.interrupt_ended(context, &mut file) {
            return exit;
        }
        store_file(context.machine, &file);
        self.go_on(context)
    }

    /// Goes on with the frames of the machine at once, for an engine that has an interpreter beside it: unlike after `resume`, the
    /// place where the newest frame goes on is no safe point.
    pub fn go_on(&self, context: &mut Context<'_>) -> Exit {
        if context.tracer.is_some() { self.execute::<true>(context) } else { self.execute::<false>(context) }
    }

    /// Pushes the frame of a block. Registers change as at the start of a block.
    fn enter(&self, machine: &mut Machine, file: &mut File, code: u32, origin: Origin, parameters: u16) -> Result<(), Abort> {
        let block = &self.blocks[code as usize];
        machine.push_frame(block.id, code, block.local_size, parameters, origin)?;
        file[Register::Nesting as usize] = 0;
        file[Register::Ma as usize] = 0;
        Ok(())
    }

    /// The loop. `WATCHED` costs nothing when it is false.
    fn execute<const WATCHED: bool>(&self, context: &mut Context<'_>) -> Exit {
        let mut file = load_file(&context.machine.registers);
        let mut watched: Option<Watched> = None;
        'block: loop {
            let Some(frame) = context.machine.frames.last() else { return Exit::Finished };
            let block = &self.blocks[frame.code as usize];
            let steps = block.steps.as_slice();
            let local = context.machine.memory.layout.local.start + frame.local_base as usize;
            let parameters = frame.parameters as usize..frame.parameters_end as usize;
            let mut at = if frame.resume == Frame::ENTERED { 0 } else { frame.resume as usize };
            if WATCHED && frame.resume == 0 {
                local_data::entered(context);
            }
            let Some(frame) = context.machine.frames.last() else { return Exit::Finished };
            if frame.resume == 0 {
                context.machine.budget -= i64::from(block.weight);
                if context.machine.budget < 0 {
                    match self.safe_point(context, &mut file, block, 0) {
                        Next::At(_) => {}
                        Next::Frame => continue 'block,
                        Next::Leave(exit) => {
                            if WATCHED {
                                self.finish_event(context, &file, &mut watched);
                            }
                            return exit;
                        }
                    }
                }
            }
            /// Goes on as the answer to a fault or safe point says.
            macro_rules! go {
                ($next:expr) => {
                    match $next {
                        Next::At(step) => {
                            at = step;
                            continue;
                        }
                        Next::Frame => continue 'block,
                        Next::Leave(exit) => {
                            if WATCHED {
                                self.finish_event(context, &file, &mut watched);
                            }
                            return exit;
                        }
                    }
                };
            }
            macro_rules! var {
                ($var:expr) => {
                    file[usize::from($var)]
                };
            }
            macro_rules! store {
                ($at:expr, $bit:expr, $width:expr, $value:expr) => {{
                    if WATCHED {
                        stores::value(context, $at, $bit, $width);
                    }
                    write(context.machine, $at, $bit, $width, $value)
                }};
            }
            loop {
                if WATCHED && block.statements.binary_search(&(at as u32)).is_ok() {
                    self.finish_event(context, &file, &mut watched);
                    let statement = block.statements.partition_point(|&first| first as usize <= at) - 1;
                    let place = Place { block: block.id, statement: statement as u32 };
                    store_file(context.machine, &file);
                    if let Some(tracer) = context.tracer.as_deref_mut()
                        && tracer.pauses_before(context.machine, place)
                    {
                        interrupt_at(context.machine, at);
                        return Exit::Paused;
                    }
                    watched = Some(Watched { place, before: registers(&file) });
                }
                match steps[at] {
                    Step::Compute { op, dst, args } => {
                        let [a, b, c, d] = args;
                        var!(dst) = op.eval([var!(a), var!(b), var!(c), var!(d)]);
                    }
                    Step::Copy { dst, src } => var!(dst) = var!(src),
                    Step::Scan { op, keeps_or, bit, at } => {
                        let scanned = u64::from(context.machine.memory.arena[at as usize] >> (bit & 7) & 1);
                        let (or, fc) = (file[Register::Or as usize], file[Register::Fc as usize]);
                        let third = if keeps_or { or } else { fc };
                        file[Register::Rlo as usize] = op.eval([file[Register::Rlo as usize], scanned, third, fc]);
                        file[Register::Sta as usize] = scanned;
                        file[Register::Or as usize] = if keeps_or { or & fc } else { 0 };
                        file[Register::Fc as usize] = 1;
                    }
                    Step::Assign { bit, at } => {
                        if WATCHED {
                            stores::value(context, at as usize, bit, Width::Bit);
                        }
                        let rlo = file[Register::Rlo as usize];
                        let byte = &mut context.machine.memory.arena[at as usize];
                        *byte = *byte & !(1 << (bit & 7)) | ((rlo & 1) as u8) << (bit & 7);
                        file[Register::Sta as usize] = rlo;
                        file[Register::Or as usize] = 0;
                        file[Register::Fc as usize] = 0;
                    }
                    Step::Constant { dst, value } => var!(dst) = u64::from(value),
                    Step::Constants { count, targets, values } => {
                        for (target, value) in targets.into_iter().zip(values).take(usize::from(count)) {
                            var!(target) = u64::from(value);
                        }
                    }
                    Step::WideConstant { dst, index } => var!(dst) = block.constants[index as usize],
                    Step::LoadBit { dst, bit, at } => {
                        var!(dst) = u64::from(context.machine.memory.arena[at as usize] >> (bit & 7) & 1);
                    }
                    Step::LoadByte { dst, at } => var!(dst) = u64::from(context.machine.memory.arena[at as usize]),
                    Step::LoadWord { dst, at } => var!(dst) = read(context.machine, at as usize, 0, Width::Word),
                    Step::LoadDouble { dst, at } => var!(dst) = read(context.machine, at as usize, 0, Width::DoubleWord),
                    Step::LoadQuad { dst, at } => var!(dst) = read(context.machine, at as usize, 0, Width::QuadWord),
                    Step::StoreBit { src, bit, at } => {
                        if WATCHED {
                            stores::value(context, at as usize, bit, Width::Bit);
                        }
                        let value = (var!(src) & 1) as u8;
                        let byte = &mut context.machine.memory.arena[at as usize];
                        *byte = *byte & !(1 << (bit & 7)) | value << (bit & 7);
                    }
                    Step::StoreByte { src, at } => store!(at as usize, 0, Width::Byte, var!(src)),
                    Step::StoreWord { src, at } => store!(at as usize, 0, Width::Word, var!(src)),
                    Step::StoreDouble { src, at } => store!(at as usize, 0, Width::DoubleWord, var!(src)),
                    Step::StoreQuad { src, at } => store!(at as usize, 0, Width::QuadWord, var!(src)),
                    Step::LoadLocal { dst, bit, width, byte } => {
                        if WATCHED {
                            local_data::read(context, place_of(block, at), local + byte as usize, bit, width);
                        }
                        var!(dst) = read(context.machine, local + byte as usize, bit, width);
                    }
                    Step::StoreLocal { src, bit, width, byte } => {
                        if WATCHED {
                            local_data::written(context, place_of(block, at), local + byte as usize, bit, width);
                        }
                        store!(local + byte as usize, bit, width, var!(src));
                    }
                    Step::LoadData { dst, register, width, on_fault, position } => {
                        let write = on_fault == OnFault::SkipWrite;
                        match in_data_block(context.machine, &file, register, position, width, write) {
                            Ok((byte, bit)) => var!(dst) = read(context.machine, byte, bit, width),
                            Err(fault) => go!(self.fault(context, &mut file, block, at, &fault, deliver(on_fault, dst))),
                        }
                    }
                    Step::StoreData { src, register, width, position } => {
                        match in_data_block(context.machine, &file, register, position, width, true) {
                            Ok((byte, bit)) => store!(byte, bit, width, var!(src)),
                            Err(fault) => go!(self.fault(context, &mut file, block, at, &fault, None)),
                        }
                    }
                    Step::LoadPlace { dst, width, on_fault, place } => {
                        let write = on_fault == OnFault::SkipWrite;
                        let machine = &*context.machine;
                        let local = |outwards: usize| machine.local_data(outwards);
                        let result = match locate(machine, &file, &local, block.places[place as usize], width, write) {
                            Ok(Target::Arena(byte, bit)) => {
                                if WATCHED && !write {
                                    local_data::read(context, place_of(block, at), byte, bit, width);
                                }
                                Ok(read(context.machine, byte, bit, width))
                            }
                            Ok(Target::Peripheral(byte)) => match read_peripheral(context, byte, width) {
                                Some(value) => Ok(value),
                                None => Err(Fault::IoAccess { write: false, width, byte }),
                            },
                            Err(fault) => Err(fault),
                        };
                        match result {
                            Ok(value) => var!(dst) = value,
                            Err(fault) => go!(self.fault(context, &mut file, block, at, &fault, deliver(on_fault, dst))),
                        }
                    }
                    Step::StorePlace { src, width, place } => {
                        let value = var!(src);
                        let machine = &*context.machine;
                        let local = |outwards: usize| machine.local_data(outwards);
                        let result = match locate(machine, &file, &local, block.places[place as usize], width, true) {
                            Ok(Target::Arena(byte, bit)) => {
                                if WATCHED {
                                    local_data::written(context, place_of(block, at), byte, bit, width);
                                }
                                store!(byte, bit, width, value);
                                Ok(())
                            }
                            Ok(Target::Peripheral(byte)) if write_peripheral(context, byte, width, value) => {
                                if WATCHED {
                                    stores::peripheral(context, byte, width);
                                }
                                Ok(())
                            }
                            Ok(Target::Peripheral(byte)) => Err(Fault::IoAccess { write: true, width, byte }),
                            Err(fault) => Err(fault),
                        };
                        if let Err(fault) = result {
                            go!(self.fault(context, &mut file, block, at, &fault, None));
                        }
                    }
                    Step::Move { index } => {
                        let (from, to, bytes) = block.moves[index as usize];
                        if WATCHED {
                            local_data::moved(context, &file, place_of(block, at), (from, to, bytes));
                            stores::moved(context, &file, to, bytes);
                        }
                        let machine = &*context.machine;
                        match plan_move(machine, &file, &|outwards| machine.local_data(outwards), (from, to, bytes)) {
                            Ok(plan) => move_bytes(context.machine, plan, bytes),
                            Err(fault) => go!(self.fault(context, &mut file, block, at, &fault, None)),
                        }
                    }
                    Step::Text { dst, index } => {
                        let (action, to, from, [first, count]) = block.texts[index as usize];
                        if WATCHED && action.writes() {
                            let bytes = if to.room.is_unknown() { to.room.head() } else { to.room.bytes() };
                            local_data::moved(context, &file, place_of(block, at), (from.place, to.place, bytes));
                            stores::moved(context, &file, to.place, bytes);
                        }
                        let machine = &*context.machine;
                        let word = action.word([var!(first), var!(count)]);
                        match texts::find(machine, &file, &|outwards| machine.local_data(outwards), action, [to, from], word) {
                            Ok(found) => var!(dst) = found.run(&mut context.machine.memory.arena, action, word),
                            Err(fault) => go!(self.fault(context, &mut file, block, at, &fault, None)),
                        }
                    }
                    Step::Parameter { dst, index } => {
                        let pointer = context.machine.parameters[parameters.clone()].get(usize::from(index)).copied();
                        var!(dst) = u64::from(pointer.unwrap_or_default());
                    }
                    Step::PassParameter { src } => context.machine.parameters.push(var!(src) as u32),
                    Step::Intrinsic { dst, intrinsic, args } => {
                        let [a, b, c, d] = args;
                        match intrinsic.run(context.machine, [var!(a), var!(b), var!(c), var!(d)]) {
                            Ok(value) => {
                                if WATCHED {
                                    stores::intrinsic(context, intrinsic, [var!(a), var!(b)]);
                                }
                                var!(dst) = value;
                            }
                            Err(fault) => go!(self.fault(context, &mut file, block, at, &fault, None)),
                        }
                    }
                    Step::Require { condition, code, register } => {
                        if var!(condition) & 1 == 0 {
                            let fault = Fault::programming(code, var!(register) as u16);
                            if fault.is_noted() {
                                let place = Place { block: block.id, statement: block.statement_of(at) };
                                context.host.fault(context.machine, &fault, place);
                                at += 1;
                                continue;
                            }
                            go!(self.fault(context, &mut file, block, at, &fault, None));
                        }
                    }
                    Step::RequireStack { condition, abort } => {
                        if var!(condition) & 1 == 0 {
                            go!(self.fault(context, &mut file, block, at, &Fault::Abort(abort), None));
                        }
                    }
                    Step::Open { register, number } => {
                        let number = var!(number);
                        if let Err(fault) = open(context.machine, &mut file, register, number) {
                            go!(self.fault(context, &mut file, block, at, &fault, None));
                        }
                    }
                    Step::Jump { to } => {
                        at = to as usize;
                        continue;
                    }
                    Step::Branch { condition, to } => {
                        if var!(condition) & 1 != 0 {
                            at = to as usize;
                            continue;
                        }
                    }
                    Step::JumpBack { weight, to } => go!(self.jump_back(context, &mut file, block, weight, to)),
                    Step::BranchBack { condition, weight, to } => {
                        if var!(condition) & 1 != 0 {
                            go!(self.jump_back(context, &mut file, block, weight, to));
                        }
                    }
                    Step::JumpTable { index, table } => {
                        let table = &block.tables[table as usize];
                        let index = usize::try_from(var!(index)).unwrap_or(usize::MAX);
                        let (to, weight) = table.targets.get(index).copied().unwrap_or(table.otherwise);
                        if let Some(weight) = weight {
                            go!(self.jump_back(context, &mut file, block, weight, to));
                        }
                        at = to as usize;
                        continue;
                    }
                    Step::Call { code, parameters } => go!(self.call(context, &mut file, block, at, code, parameters)),
                    Step::CallOther { callee, parameters } => {
                        let callee = match block.callees[callee as usize] {
                            Callee::Block(id) => id,
                            Callee::Number(kind, number) => BlockId::new(kind, var!(number.0) as u16),
                        };
                        go!(self.call_other(context, &mut file, block, at, callee, parameters));
                    }
                    Step::Return => {
                        if WATCHED {
                            self.finish_event(context, &file, &mut watched);
                        }
                        match self.leave(context.machine, &mut file) {
                            Left::Caller => continue 'block,
                            Left::Interrupted => match self.interrupt_ended(context, &mut file) {
                                Next::Leave(exit) => return exit,
                                Next::At(_) | Next::Frame => continue 'block,
                            },
                            Left::Nothing => {
                                store_file(context.machine, &file);
                                return Exit::Finished;
                            }
                        }
                    }
                }
                at += 1;
            }
        }
    }

    /// Ends the newest block. The registers of the outermost one stay as they are.
    fn leave(&self, machine: &mut Machine, file: &mut File) -> Left {
        let Some(frame) = machine.frames.pop() else { return Left::Nothing };
        machine.parameters.truncate(frame.parameters as usize);
        match frame.origin {
            Origin::Start => Left::Nothing,
            Origin::Call(caller) => {
                restore_caller(file, &caller);
                after_call(file);
                Left::Caller
            }
            Origin::Interrupt { registers, deliver } => {
                *file = load_file(&registers);
                match deliver {
                    Some((var, value)) => {
                        file[usize::from(var)] = u64::from(value);
                        Left::Caller
                    }
                    None => Left::Interrupted,
                }
            }
        }
    }

    /// Between two statements the end of an organization block is a safe point: another one may have waited for it.
    fn interrupt_ended(&self, context: &mut Context<'_>, file: &mut File) -> Next {
        let Some(frame) = context.machine.frames.last() else { return Next::Frame };
        let block = &self.blocks[frame.code as usize];
        let at = if frame.resume == Frame::ENTERED { 0 } else { frame.resume as usize };
        match self.safe_point(context, file, block, at) {
            // The frame still says where to go on.
            Next::At(_) => Next::Frame,
            other => other,
        }
    }

    fn call(&self, context: &mut Context<'_>, file: &mut File, block: &Block, at: usize, code: u32, parameters: u16) -> Next {
        let caller = caller_registers(file);
        if let Some(frame) = context.machine.frames.last_mut() {
            frame.resume = at as u32 + 1;
        }
        match self.enter(context.machine, file, code, Origin::Call(caller), parameters) {
            Ok(()) => {
                after_call(file);
                Next::Frame
            }
            Err(abort) => self.fault(context, file, block, at, &Fault::Abort(abort), None),
        }
    }

    /// A call whose block was not known when the program was loaded: a computed number, a system block, or none at all.
    fn call_other(&self, context: &mut Context<'_>, file: &mut File, block: &Block, at: usize, callee: BlockId, parameters: u16) -> Next {
        if let Some(&code) = self.index.get(&callee) {
            return self.call(context, file, block, at, code, parameters);
        }
        let number = callee.number;
        let too_high = number > context.machine.memory.layout.fc_number_max;
        let code = match callee.kind {
            BlockKind::SystemFunction | BlockKind::SystemFunctionBlock => {
                return self.system_call(context, file, block, at, callee, parameters);
            }
            BlockKind::FunctionBlock if too_high => 0x35,
            BlockKind::FunctionBlock => 0x3E,
            _ if too_high => 0x34,
            _ => 0x3C,
        };
        self.fault(context, file, block, at, &Fault::programming(code, number), None)
    }

    fn system_call(&self, context: &mut Context<'_>, file: &mut File, block: &Block, at: usize, callee: BlockId, parameters: u16) -> Next {
        store_file(context.machine, file);
        if context.tracer.is_some() {
            local_data::given(context, place_of(block, at), parameters);
        }
        if !context.host.has_system_function(callee) {
            let code = if callee.kind == BlockKind::SystemFunction { 0x3D } else { 0x3F };
            return self.fault(context, file, block, at, &Fault::programming(code, callee.number), None);
        }
        let first = context.machine.parameters.len().saturating_sub(usize::from(parameters));
        let mut reaction = context.host.system_function(context.machine, callee, first);
        if let Reaction::Stop(reason) = &mut reaction {
            reason.place.get_or_insert(Place { block: block.id, statement: block.statement_of(at) });
        }
        if context.tracer.is_some() {
            stores::system_function(context, callee);
        }
        *file = load_file(&context.machine.registers);
        context.machine.parameters.truncate(first);
        after_call(file);
        match reaction {
            Reaction::Fail(fault) => self.fault(context, file, block, at, &fault, None),
            other => {
                let place = Place { block: block.id, statement: block.statement_of(at) };
                self.react(context, file, place, at + 1, other, None)
            }
        }
    }

    fn jump_back(&self, context: &mut Context<'_>, file: &mut File, block: &Block, weight: u16, to: u32) -> Next {
        context.machine.budget -= i64::from(weight);
        if context.machine.budget < 0 {
            return self.safe_point(context, file, block, to as usize);
        }
        Next::At(to as usize)
    }

    /// Asks the Host because the budget is used up; goes on at `at`, the first step of a statement.
    #[cold]
    fn safe_point(&self, context: &mut Context<'_>, file: &mut File, block: &Block, at: usize) -> Next {
        store_file(context.machine, file);
        let place = Place { block: block.id, statement: block.statement_of(at) };
        let reaction = context.host.safe_point(context.machine, place);
        self.react(context, file, place, at, reaction, None)
    }

    /// Asks the Host about a failed statement. `deliver` is the variable of a load that counts as done.
    #[cold]
    fn fault(&self, context: &mut Context<'_>, file: &mut File, block: &Block, at: usize, fault: &Fault, deliver: Option<u8>) -> Next {
        store_file(context.machine, file);
        if deliver.is_none() {
            Self::drop_parameters(context.machine);
        }
        let place = Place { block: block.id, statement: block.statement_of(at) };
        let reaction = context.host.fault(context.machine, fault, place);
        if let Fault::Abort(_) = fault
            && !matches!(reaction, Reaction::Stop(_))
        {
            // A block that cannot go on has no next statement.
            return Next::Leave(Exit::Stopped(StopReason { event: fault.event(), place: Some(place) }));
        }
        let resume = if deliver.is_some() { at + 1 } else { block.behind_statement(at) };
        self.react(context, file, place, resume, reaction, deliver)
    }

    /// Drops the parameters that a failed statement had begun to pass.
    fn drop_parameters(machine: &mut Machine) {
        if let Some(frame) = machine.frames.last() {
            machine.parameters.truncate(frame.parameters_end as usize);
        }
    }

    fn react(
        &self,
        context: &mut Context<'_>,
        file: &mut File,
        place: Place,
        resume: usize,
        reaction: Reaction,
        deliver: Option<u8>,
    ) -> Next {
        match reaction {
            // Only a system function fails in this way, and it has been asked about already.
            Reaction::Continue | Reaction::Replace(_) | Reaction::Fail(_) => {
                if let Some(var) = deliver {
                    file[usize::from(var)] = if let Reaction::Replace(value) = reaction { u64::from(value) } else { 0 };
                }
                Next::At(resume)
            }
            Reaction::Enter { block: id, start_information } => {
                let Some(&code) = self.index.get(&id) else {
                    if let Some(var) = deliver {
                        file[usize::from(var)] = 0;
                    }
                    return Next::At(resume);
                };
                interrupt_at(context.machine, resume);
                let origin = Origin::Interrupt { registers: Box::new(registers(file)), deliver: deliver.map(|var| (var, 0)) };
                *file = load_file(&Registers::fresh());
                match self.enter(context.machine, file, code, origin, 0) {
                    Ok(()) => {
                        write_start_information(context.machine, &start_information);
                        Next::Frame
                    }
                    Err(abort) => {
                        let fault = Fault::Abort(abort);
                        let exit = match context.host.fault(context.machine, &fault, place) {
                            Reaction::Stop(reason) => Exit::Stopped(reason),
                            _ => Exit::Stopped(StopReason { event: fault.event(), place: Some(place) }),
                        };
                        Next::Leave(exit)
                    }
                }
            }
            Reaction::Stop(reason) => {
                // A hot restart goes on here.
                interrupt_at(context.machine, resume);
                store_file(context.machine, file);
                Next::Leave(Exit::Stopped(reason))
            }
            Reaction::Suspend if deliver.is_some() => {
                // Inside a statement nothing can be resumed: the Host is asked again at the next safe point.
                context.machine.budget = 0;
                if let Some(var) = deliver {
                    file[usize::from(var)] = 0;
                }
                Next::At(resume)
            }
            Reaction::Suspend => {
                interrupt_at(context.machine, resume);
                store_file(context.machine, file);
                Next::Leave(Exit::Suspended)
            }
        }
    }

    fn finish_event(&self, context: &mut Context<'_>, file: &File, watched: &mut Option<Watched>) {
        if let (Some(watched), Some(tracer)) = (watched.take(), context.tracer.as_deref_mut()) {
            let event = StatementEvent { place: watched.place, before: watched.before, after: registers(file) };
            tracer.statement(context.machine, &event);
        }
    }
}

/// Remembers where the newest block goes on.
fn interrupt_at(machine: &mut Machine, resume: usize) {
    if let Some(frame) = machine.frames.last_mut() {
        frame.resume = if resume == 0 { Frame::ENTERED } else { resume as u32 };
    }
}

fn place_of(block: &Block, at: usize) -> Place {
    Place { block: block.id, statement: block.statement_of(at) }
}

fn deliver(on_fault: OnFault, dst: u8) -> Option<u8> {
    (on_fault == OnFault::DeliverZero).then_some(dst)
}

#[inline(always)]
fn read(machine: &Machine, at: usize, bit: u8, width: Width) -> u64 {
    machine.memory.read_wide(at, bit, width)
}

#[inline(always)]
fn write(machine: &mut Machine, at: usize, bit: u8, width: Width, value: u64) {
    machine.memory.write_wide(at, bit, width, value);
}
