//! Runtime calls: the slow paths of machine code. Access to places that are not known when code is compiled, and everything that the Host
//! answers.
//!
//! Machine code names a *site*: the block in the high half, the instruction of its IR in the low half. `try_` functions change nothing when
//! they fail and return 1; machine code then stores its registers and calls [`failed`], which calls the Host.

use sieben_engine::access::{self, Target, data_registers};
use sieben_engine::ir::{Callee, DataRegister, Inst, OnFault, Place, TextAction, TextRoom, Var};
use sieben_engine::machine::{Origin, Register, Registers};
use sieben_engine::texts::{self, Both, Found, Text};
use sieben_engine::{Abort, Exit, Fault, FaultPlace, Reaction, StopReason};
use sieben_model::address::Width;
use sieben_model::block::{BlockId, BlockKind};

use crate::deoptimization::iteration;
use crate::jit::Native;
use crate::run::{INTERRUPTS, Run};

/// The program goes on behind what it asked for.
pub(crate) const GO_ON: u64 = 0;
/// Every function returns at once: the run is left.
pub(crate) const LEAVE: u64 = 1;
/// The program goes on with the next statement.
pub(crate) const NEXT_STATEMENT: u64 = 2;

/// A function that machine code calls, its name and its number of arguments.
pub(crate) struct RuntimeFunction {
    pub(crate) name: &'static str,
    pub(crate) arguments: usize,
    pub(crate) address: *const u8,
}

macro_rules! asks {
    ($($(#[doc = $doc:literal])* $Name:ident = $function:ident ( $($argument:ident),* );)*) => {
        /// Functions that machine code calls, by name.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub(crate) enum RuntimeCall { $($(#[doc = $doc])* $Name,)* }

        impl RuntimeCall {
            /// All of them.
            pub(crate) const ALL: &[Self] = &[$(Self::$Name),*];
            /// The function.
            pub(crate) fn ask(self) -> RuntimeFunction {
                match self { $(Self::$Name => {
                    let function: extern "C" fn(&mut Run<'_, '_>, $(asks!(@word $argument)),*) -> u64 = $function;
                    RuntimeFunction {
                        name: stringify!($function),
                        arguments: 1 + [$(stringify!($argument)),*].len(),
                        address: function as *const u8,
                    }
                }),* }
            }
        }
    };
    (@word $argument:ident) => { u64 };
}

asks! {
    /// Reads a place; the value is in `run.value`.
    TryLoad = try_load(link, site, pointer);
    /// Writes a place.
    TryStore = try_store(link, site, pointer, value);
    /// Moves bytes.
    TryMove = try_move(link, site, from, to);
    /// Works on texts; the result is in `run.value`.
    TryText = try_text(link, site, from, to, piece);
    /// Works on texts that are inside their areas, which begin at these bytes of the arena; its result.
    Text = text(kind, from, to, piece);
    /// Copies bytes of the arena, as if through a temporary.
    CopyBytes = copy_bytes(from, to, count);
    /// Whether as many bytes of the arena differ.
    BytesDiffer = bytes_differ(a, b, count);
    /// Runs an intrinsic; the result is in `run.value`.
    TryIntrinsic = try_intrinsic(site, a, b, c);
    /// Finds a data block to open: its first byte in the low half of the value, its length in the high half.
    TryOpen = try_open(site, number);
    /// Asks the Host about what failed.
    Failed = failed(link, site);
    /// A condition of a statement does not hold.
    Unmet = unmet(link, site, register);
    /// The budget is used up before this statement.
    SafePoint = safe_point(link, code, statement);
    /// Lets the interpreter go on with a statement: memory is not as the code relies on.
    Interpret = interpret(link, code, statement);
    /// Lets the interpreter do the rest of an iteration; the statement behind it is in `run.value`.
    Iteration = iteration(link, code, statement, span, home);
    /// Calls a block that is not known beforehand, or a system block.
    CallOther = call_other(link, site, number, passed);
}

/// The two halves of a site.
fn parts(site: u64) -> (usize, usize) {
    ((site >> 32) as usize, (site & 0xFFFF_FFFF) as usize)
}

impl Run<'_, '_> {
    fn block(&self, code: usize) -> &Native {
        &self.compiled.blocks[code]
    }

    fn inst(&self, site: u64) -> Inst {
        let (code, inst) = parts(site);
        self.block(code).code.insts[inst]
    }

    /// The statement of a site, as the Host names it.
    fn place(&self, site: u64) -> FaultPlace {
        let (code, inst) = parts(site);
        let block = self.block(code);
        FaultPlace { block: block.id, statement: block.statement_of(inst) }
    }

    /// Puts the registers where access finds them.
    fn show_registers(&mut self) {
        self.scratch.file[..Register::COUNT].copy_from_slice(&self.context.machine.registers.to_words());
    }

    /// Puts the value of a place's pointer there.
    fn point(&mut self, place: Place, value: u64) {
        if let Place::Indirect { pointer: Var(var), .. } | Place::Crossing { pointer: Var(var), .. } = place {
            self.scratch.file[usize::from(var)] = value;
        }
    }

    fn locate(&self, link: u64, place: Place, width: Width, write: bool) -> Result<Target, Fault> {
        let depth = self.depth(link);
        let local = |outwards: usize| self.local_data(depth, outwards);
        access::locate(self.context.machine, &self.scratch.file, &local, place, width, write)
    }

    /// Notes a fault; what a function that failed returns.
    fn note(&mut self, fault: Fault) -> u64 {
        self.fault = Some(fault);
        1
    }

    fn load(&mut self, link: u64, site: u64, pointer: u64) -> Result<u64, Fault> {
        let Inst::Load { place, width, on_fault, .. } = self.inst(site) else { unreachable!("a site of `try_load` is a load") };
        self.show_registers();
        self.point(place, pointer);
        match self.locate(link, place, width, on_fault == OnFault::SkipWrite)? {
            Target::Arena(byte, bit) => Ok(self.context.machine.memory.read_wide(byte, bit, width)),
            Target::Peripheral(byte) => {
                self.show(self.depth(link), 0);
                let value = access::read_peripheral(self.context, byte, width);
                self.take_back();
                value.ok_or(Fault::IoAccess { write: false, width, byte })
            }
        }
    }

    fn store(&mut self, link: u64, site: u64, pointer: u64, value: u64) -> Result<(), Fault> {
        let Inst::Store { place, width, .. } = self.inst(site) else { unreachable!("a site of `try_store` is a store") };
        self.show_registers();
        self.point(place, pointer);
        match self.locate(link, place, width, true)? {
            Target::Arena(byte, bit) => self.context.machine.memory.write_wide(byte, bit, width, value),
            Target::Peripheral(byte) => {
                self.show(self.depth(link), 0);
                let written = access::write_peripheral(self.context, byte, width, value);
                self.take_back();
                if !written {
                    return Err(Fault::IoAccess { write: true, width, byte });
                }
            }
        }
        Ok(())
    }

    fn move_bytes(&mut self, link: u64, site: u64, pointers: [u64; 2]) -> Result<(), Fault> {
        let Inst::Move { from, to, bytes } = self.inst(site) else { unreachable!("a site of `try_move` is a move") };
        self.show_registers();
        self.point(from, pointers[0]);
        self.point(to, pointers[1]);
        let depth = self.depth(link);
        let local = |outwards: usize| self.local_data(depth, outwards);
        let plan = access::plan_move(self.context.machine, &self.scratch.file, &local, (from, to, bytes))?;
        access::move_bytes(self.context.machine, plan, bytes);
        Ok(())
    }

    fn text(&mut self, link: u64, site: u64, pointers: [u64; 2], word: u64) -> Result<u64, Fault> {
        let Inst::Text { action, to, to_room, from, from_room, .. } = self.inst(site) else {
            unreachable!("a site of `try_text` works on texts")
        };
        self.show_registers();
        self.point(from, pointers[0]);
        self.point(to, pointers[1]);
        let depth = self.depth(link);
        let local = |outwards: usize| self.local_data(depth, outwards);
        let texts = [(to, to_room), (from, from_room)].map(|(place, room)| Text { place, room });
        let found = texts::find(self.context.machine, &self.scratch.file, &local, action, texts, word)?;
        Ok(found.run(&mut self.context.machine.memory.arena, action, word))
    }

    /// Ends the run; `None` = the interpreter goes on with the frames as they are.
    fn leave(&mut self, exit: Option<Exit>) -> u64 {
        self.exit = exit;
        LEAVE
    }

    /// Lets the interpreter go on: the newest frame continues at `resume`.
    fn interpret(&mut self, resume: u32) -> u64 {
        if let Some(frame) = self.context.machine.frames.last_mut() {
            frame.resume = resume;
        }
        self.leave(None)
    }

    /// Asks the Host about a fault. Shows the machine first.
    fn ask_fault(&mut self, link: u64, site: u64, fault: &Fault) -> u64 {
        let (code, inst) = parts(site);
        let block = self.block(code);
        let deliver = match block.code.insts[inst] {
            Inst::Load { dst, on_fault: OnFault::DeliverZero, .. } => Some(dst.0),
            _ => None,
        };
        let passed = if deliver.is_some() { block.passed_before(inst) } else { 0 };
        let place = self.place(site);
        self.show(self.depth(link), passed);
        let reaction = self.context.host.fault(self.context.machine, fault, place);
        self.take_back();
        if let Fault::Abort(_) = fault
            && !matches!(reaction, Reaction::Stop(_))
        {
            // A block that cannot go on has no next statement.
            return self.leave(Some(Exit::Stopped(StopReason { event: fault.event(), place: Some(place) })));
        }
        let resume = match deliver {
            Some(_) => self.compiled.interpreter.resume_behind(code as u32, inst as u32),
            None => self.compiled.interpreter.resume_at(code as u32, place.statement + 1),
        };
        self.react(link, resume, place, reaction, deliver)
    }

    /// Does what the Host answered. The machine was shown before, and its newest frame goes on at `resume`.
    fn react(&mut self, link: u64, resume: u32, place: FaultPlace, mut reaction: Reaction, deliver: Option<u8>) -> u64 {
        loop {
            self.value = 0;
            match reaction {
                // Only a system function fails in this way, and it has been asked about already.
                Reaction::Continue | Reaction::Fail(_) => return GO_ON,
                Reaction::Replace(value) => {
                    self.value = u64::from(value);
                    return GO_ON;
                }
                Reaction::Enter { block, start_information } => {
                    let Some(code) = self.compiled.interpreter.code(block) else { return GO_ON };
                    self.interrupt_at(resume);
                    let answer = self.interrupt(link, place, code, &start_information, deliver);
                    if answer != GO_ON || deliver.is_some() {
                        return answer;
                    }
                    // Between two statements the end of an organization block is a safe point: another one may have waited for it.
                    let depth = self.depth(link);
                    let code = self.scratch.links[depth].code as u32;
                    let block = self.block(code as usize).id;
                    let place = FaultPlace { block, statement: self.compiled.interpreter.statement_at(code, resume) };
                    self.show(depth, 0);
                    reaction = self.context.host.safe_point(self.context.machine, place);
                    self.take_back();
                }
                Reaction::Stop(reason) => {
                    // A hot restart goes on here.
                    self.interrupt_at(resume);
                    return self.leave(Some(Exit::Stopped(reason)));
                }
                Reaction::Suspend if deliver.is_some() => {
                    // Inside a statement nothing can be resumed: the Host is asked again at the next safe point.
                    self.budget = 0;
                    return GO_ON;
                }
                Reaction::Suspend => {
                    self.interrupt_at(resume);
                    return self.leave(Some(Exit::Suspended));
                }
            }
        }
    }

    /// Remembers where the newest frame goes on.
    pub(crate) fn interrupt_at(&mut self, resume: u32) {
        if let Some(frame) = self.context.machine.frames.last_mut() {
            frame.resume = resume;
        }
    }

    /// Runs an organization block before what follows.
    fn interrupt(&mut self, link: u64, place: FaultPlace, code: u32, information: &[u8; 20], deliver: Option<u8>) -> u64 {
        let depth = self.depth(link);
        let (id, local_size) = (self.block(code as usize).id, self.block(code as usize).local_size);
        let interrupted = self.scratch.links[depth];
        let local = self.local_range(depth).end;
        let saved = self.context.machine.registers.clone();
        let [shared, instance] = open_blocks(&saved);
        let origin = Origin::Interrupt { registers: Box::new(saved), deliver: deliver.map(|var| (var, 0)) };
        if let Err(abort) = self.context.machine.push_frame(id, code, local_size, 0, origin) {
            let fault = Fault::Abort(abort);
            let exit = match self.context.host.fault(self.context.machine, &fault, place) {
                Reaction::Stop(reason) => Exit::Stopped(reason),
                _ => Exit::Stopped(StopReason { event: fault.event(), place: Some(place) }),
            };
            self.take_back();
            return self.leave(Some(exit));
        }
        self.context.machine.registers = Registers::fresh();
        access::write_start_information(self.context.machine, information);
        // The block may call as deep as its class allows.
        let layout = &self.context.machine.memory.layout;
        let deepest = depth + 2 + usize::from(layout.nesting_depth) + usize::from(layout.nesting_depth_error);
        let too_deep = deepest >= self.compiled.generation.levels() || self.interrupts >= INTERRUPTS;
        let called_only = id.kind != BlockKind::OrganizationBlock;
        if called_only || too_deep || !self.compiled.fits(&self.context.machine.memory) {
            // Too deep for machine code, or data blocks are not as it takes them to be (a system function may change them and be
            // followed by an interrupt), or the code relies on a caller: the frame of the block begins in the interpreter.
            return self.leave(None);
        }
        let (kept, limits) = (self.kept, (self.link_max, self.local_end));
        self.kept = depth + 2;
        self.interrupts += 1;
        self.limit_calls();
        let local = self.arena() as usize + local;
        let room = self.compiled.rooms[code as usize];
        let deepest = self.link_address(depth + 1 + room.depth) as u64;
        if deepest > self.link_max || (local + local_size as usize + room.local) as u64 > self.local_end {
            // The interpreter looks at each call.
            return self.leave(None);
        }
        // Behind everything that the interrupted block may be about to pass.
        let free = interrupted.parameters_end + 4 * self.compiled.parameters_max as u64;
        let next = &mut self.scratch.links[depth + 1];
        (next.code, next.site, next.local) = (u64::from(code), 0, local as u64);
        (next.parameters, next.parameters_end) = (free, free);
        (next.shared, next.instance) = (shared, instance);
        let compiled = self.compiled;
        if compiled.generation.call(code as usize, self, local, self.link_address(depth + 1)) {
            return LEAVE;
        }
        let machine = &mut *self.context.machine;
        machine.frames.truncate(depth + 2);
        let frame = machine.frames.pop().expect("the frame of the interrupt stays until it ends");
        machine.parameters.truncate(frame.parameters as usize);
        self.kept = kept;
        self.interrupts -= 1;
        (self.link_max, self.local_end) = limits;
        if let Origin::Interrupt { registers, deliver } = frame.origin {
            machine.registers = *registers;
            self.value = deliver.map_or(0, |(_, value)| u64::from(value));
        }
        GO_ON
    }

    /// Calls a loaded block whose number the program computed.
    fn call_loaded(&mut self, link: u64, site: u64, code: usize, parameters: u16, passed: usize) -> u64 {
        let depth = self.depth(link);
        let local = self.local_range(depth).end + self.arena() as usize;
        let size = self.block(code).local_size as usize;
        if self.link_address(depth + 1) as u64 > self.link_max || (local + size) as u64 > self.local_end {
            return self.ask_no_room(link, site);
        }
        let mut registers = self.context.machine.registers.to_words();
        let caller = access::caller_registers(&registers);
        let own = self.scratch.links[depth];
        let end = own.parameters_end + 4 * passed as u64;
        let next = &mut self.scratch.links[depth + 1];
        next.code = code as u64;
        next.site = site & 0xFFFF_FFFF;
        next.local = local as u64;
        next.parameters = end.saturating_sub(4 * u64::from(parameters));
        next.parameters_end = end;
        (next.shared, next.instance) = (caller.shared, caller.instance);
        (next.mcr_active, next.nesting) = (caller.mcr_active, caller.nesting);
        registers[Register::Nesting as usize] = 0;
        registers[Register::Ma as usize] = 0;
        access::after_call(&mut registers);
        access::store_file(self.context.machine, &registers);
        let compiled = self.compiled;
        if compiled.generation.call(code, self, local, self.link_address(depth + 1)) {
            return LEAVE;
        }
        let mut registers = self.context.machine.registers.to_words();
        access::restore_caller(&mut registers, &caller);
        access::after_call(&mut registers);
        access::store_file(self.context.machine, &registers);
        GO_ON
    }

    fn ask_no_room(&mut self, link: u64, site: u64) -> u64 {
        let deep = self.link_address(self.depth(link) + 1) as u64 > self.link_max;
        let abort = if deep { Abort::BlockStack } else { Abort::LocalData };
        self.ask_fault(link, site, &Fault::Abort(abort))
    }

    fn call_system(&mut self, link: u64, site: u64, block: BlockId, parameters: u16, passed: usize) -> u64 {
        self.show(self.depth(link), passed);
        if !self.context.host.has_system_function(block) {
            let code = if block.kind == BlockKind::SystemFunction { 0x3D } else { 0x3F };
            return self.fail_statement(link, site, &programming(code, block.number));
        }
        let first = self.context.machine.parameters.len().saturating_sub(usize::from(parameters));
        let mut reaction = self.context.host.system_function(self.context.machine, block, first);
        self.take_back();
        let place = self.place(site);
        if let Reaction::Stop(reason) = &mut reaction {
            reason.place.get_or_insert(place);
        }
        self.check_open_blocks();
        let mut registers = self.context.machine.registers.to_words();
        access::after_call(&mut registers);
        access::store_file(self.context.machine, &registers);
        self.context.machine.parameters.truncate(first);
        let fits = self.follow_frames() && self.compiled.fits(&self.context.machine.memory);
        let (code, inst) = parts(site);
        let (answer, resume) = match reaction {
            Reaction::Fail(fault) => {
                let resume = self.compiled.interpreter.resume_at(code as u32, place.statement + 1);
                (self.fail_statement(link, site, &fault), resume)
            }
            other => {
                let resume = self.compiled.interpreter.resume_behind(code as u32, inst as u32);
                (self.react(link, resume, place, other, None), resume)
            }
        };
        if answer == LEAVE || fits {
            return answer;
        }
        // The program changed data blocks that this code takes to be as they were.
        self.show(self.depth(link), 0);
        self.interpret(resume)
    }

    /// A fault of a statement that then counts as NOP.
    fn fail_statement(&mut self, link: u64, site: u64, fault: &Fault) -> u64 {
        match self.ask_fault(link, site, fault) {
            GO_ON => NEXT_STATEMENT,
            other => other,
        }
    }
}

/// The open data blocks in saved registers: DB and DI, each number, base, length.
fn open_blocks(registers: &Registers) -> [[u64; 3]; 2] {
    [[registers.db_number, registers.db_base, registers.db_length], [registers.di_number, registers.di_base, registers.di_length]]
}

fn programming(code: u8, register: u16) -> Fault {
    Fault::Programming { code, register, access: 0 }
}

extern "C" fn try_load(run: &mut Run<'_, '_>, link: u64, site: u64, pointer: u64) -> u64 {
    match run.load(link, site, pointer) {
        Ok(value) => {
            run.value = value;
            0
        }
        Err(fault) => run.note(fault),
    }
}

extern "C" fn try_store(run: &mut Run<'_, '_>, link: u64, site: u64, pointer: u64, value: u64) -> u64 {
    match run.store(link, site, pointer, value) {
        Ok(()) => 0,
        Err(fault) => run.note(fault),
    }
}

extern "C" fn try_move(run: &mut Run<'_, '_>, link: u64, site: u64, from: u64, to: u64) -> u64 {
    match run.move_bytes(link, site, [from, to]) {
        Ok(()) => 0,
        Err(fault) => run.note(fault),
    }
}

/// What is done with texts that are inside their areas, in one word: what they have room for, and the action.
pub(crate) fn text_kind(action: TextAction, to: TextRoom, from: TextRoom) -> u64 {
    let room = |room: TextRoom| u64::from(room.characters_max) << 1 | u64::from(room.wide);
    room(to) | room(from) << ROOM_BITS | (action as u64) << (2 * ROOM_BITS)
}

/// Bits that tell what a text has room for.
const ROOM_BITS: u32 = 17;

extern "C" fn text(run: &mut Run<'_, '_>, kind: u64, from: u64, to: u64, word: u64) -> u64 {
    let found = |start: u64, room: u64| {
        let room = TextRoom { characters_max: (room >> 1) as u16, wide: room & 1 != 0 };
        Found { start: start as usize, room }
    };
    let both = Both { to: found(to, kind), from: found(from, kind >> ROOM_BITS) };
    let action = TextAction::ALL[(kind >> (2 * ROOM_BITS)) as usize];
    both.run(&mut run.context.machine.memory.arena, action, word)
}

extern "C" fn copy_bytes(run: &mut Run<'_, '_>, from: u64, to: u64, count: u64) -> u64 {
    run.context.machine.memory.arena.copy_within(from as usize..(from + count) as usize, to as usize);
    0
}

extern "C" fn bytes_differ(run: &mut Run<'_, '_>, a: u64, b: u64, count: u64) -> u64 {
    let arena = &run.context.machine.memory.arena;
    let bytes = |start: u64| &arena[start as usize..(start + count) as usize];
    u64::from(bytes(a) != bytes(b))
}

extern "C" fn try_text(run: &mut Run<'_, '_>, link: u64, site: u64, from: u64, to: u64, word: u64) -> u64 {
    match run.text(link, site, [from, to], word) {
        Ok(value) => {
            run.value = value;
            0
        }
        Err(fault) => run.note(fault),
    }
}

extern "C" fn try_intrinsic(run: &mut Run<'_, '_>, site: u64, a: u64, b: u64, c: u64) -> u64 {
    let Inst::Intrinsic { intrinsic, .. } = run.inst(site) else { unreachable!("a site of `try_intrinsic` is an intrinsic") };
    match intrinsic.run(run.context.machine, [a, b, c, 0]) {
        Ok(value) => {
            run.value = value;
            0
        }
        Err(fault) => run.note(fault),
    }
}

extern "C" fn try_open(run: &mut Run<'_, '_>, site: u64, number: u64) -> u64 {
    let Inst::Open { register, .. } = run.inst(site) else { unreachable!("a site of `try_open` is an open") };
    let register: DataRegister = register;
    let mut registers = run.context.machine.registers.to_words();
    match access::open(run.context.machine, &mut registers, register, number) {
        Ok(()) => {
            // The registers of the machine stay as they are: what a caller has open there may be stored by nothing any more.
            let [_, base, length] = data_registers(register).map(|register| registers[register as usize]);
            run.check_open_block(base, length);
            run.value = base | length << 32;
            0
        }
        Err(fault) => run.note(fault),
    }
}

extern "C" fn failed(run: &mut Run<'_, '_>, link: u64, site: u64) -> u64 {
    match run.fault.take() {
        Some(fault) => run.ask_fault(link, site, &fault),
        None => unreachable!("something failed before"),
    }
}

extern "C" fn unmet(run: &mut Run<'_, '_>, link: u64, site: u64, register: u64) -> u64 {
    let fault = match run.inst(site) {
        Inst::Require { code, .. } => programming(code, register as u16),
        Inst::RequireStack { abort, .. } => Fault::Abort(abort),
        _ => unreachable!("a site of `unmet` is a condition"),
    };
    if fault.is_noted() {
        let place = run.place(site);
        run.show(run.depth(link), 0);
        run.context.host.fault(run.context.machine, &fault, place);
        run.take_back();
        return GO_ON;
    }
    run.ask_fault(link, site, &fault)
}

extern "C" fn safe_point(run: &mut Run<'_, '_>, link: u64, code: u64, statement: u64) -> u64 {
    let block = run.block(code as usize);
    let place = FaultPlace { block: block.id, statement: statement as u32 };
    run.show(run.depth(link), 0);
    let reaction = run.context.host.safe_point(run.context.machine, place);
    run.take_back();
    let resume = run.compiled.interpreter.resume_at(code as u32, statement as u32);
    run.react(link, resume, place, reaction, None)
}

extern "C" fn interpret(run: &mut Run<'_, '_>, link: u64, code: u64, statement: u64) -> u64 {
    run.show(run.depth(link), 0);
    let resume = run.compiled.interpreter.resume_at(code as u32, statement as u32);
    run.interpret(resume)
}

extern "C" fn call_other(run: &mut Run<'_, '_>, link: u64, site: u64, number: u64, passed: u64) -> u64 {
    let Inst::Call { callee, parameters } = run.inst(site) else { unreachable!("a site of `call_other` is a call") };
    let block = match callee {
        Callee::Block(id) => id,
        Callee::Number(kind, _) => BlockId::new(kind, number as u16),
    };
    if let Some(code) = run.compiled.interpreter.code(block) {
        return run.call_loaded(link, site, code as usize, parameters, passed as usize);
    }
    let too_high = block.number > run.context.machine.memory.layout.fc_number_max;
    let code = match block.kind {
        BlockKind::SystemFunction | BlockKind::SystemFunctionBlock => {
            return run.call_system(link, site, block, parameters, passed as usize);
        }
        BlockKind::FunctionBlock if too_high => 0x35,
        BlockKind::FunctionBlock => 0x3E,
        _ if too_high => 0x34,
        _ => 0x3C,
    };
    run.fail_statement(link, site, &programming(code, block.number))
}
