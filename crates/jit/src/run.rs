//! The runtime frame of machine code: registers, links between activations, and what runtime calls work on.

use std::cell::Cell;
use std::ops::Range;

use sieben_engine::access::File;
use sieben_engine::machine::{CallerRegisters, Memory, Origin};
use sieben_engine::{Context, Exit, Fault, Layout};

use sieben_model::address::Area;

use crate::jit::Compiled;

/// Activations that a run can nest: the depth of the CPU types and every interrupt that another one interrupts.
/// What nests deeper goes on in the interpreter.
pub(crate) const LINKS: usize = 256;

/// Interrupts that machine code nests: the Rust code between two of them takes several KiB of the native stack, more without
/// optimization. What nests deeper goes on in the interpreter.
pub(crate) const INTERRUPTS: usize = 64;

/// One activation of a block; written by whoever enters it, read when a frame must be shown to the Host.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Link {
    /// The block in the engine's list.
    pub(crate) code: u64,
    /// The instruction of the caller that entered it; for an organization block not used.
    pub(crate) site: u64,
    /// Address of its local data.
    pub(crate) local: u64,
    /// Address of its first parameter.
    pub(crate) parameters: u64,
    /// Address behind its last parameter.
    pub(crate) parameters_end: u64,
    /// DB register of the caller: number, base, length.
    pub(crate) shared: [u64; 3],
    /// DI register of the caller: number, base, length.
    pub(crate) instance: [u64; 3],
    /// Whether the MCR was active in the caller.
    pub(crate) mcr_active: u64,
    /// The nesting stack of the caller.
    pub(crate) nesting: u64,
}

/// Memory of a run that is worth keeping for the next one.
#[derive(Debug)]
pub(crate) struct Scratch {
    pub(crate) links: Box<[Link]>,
    pub(crate) parameters: Box<[u32]>,
    /// Registers and temporaries as access has them.
    pub(crate) file: Box<File>,
}

thread_local! {
    /// The scratch memory of the last run in this thread.
    static SPARE: Cell<Option<Box<Scratch>>> = const { Cell::new(None) };
}

impl Scratch {
    /// Scratch memory with room for so many parameters: that of the last run in this thread, if it is enough.
    #[inline]
    pub(crate) fn take(parameters: usize) -> Box<Self> {
        let spare = SPARE.try_with(Cell::take).ok().flatten();
        spare.filter(|scratch| scratch.parameters.len() >= parameters).unwrap_or_else(|| Box::new(Self::new(parameters)))
    }

    /// Keeps scratch memory for the next run in this thread.
    #[inline]
    pub(crate) fn keep(self: Box<Self>) {
        let mut own = Some(self);
        // A thread that ends needs it no more.
        let _ = SPARE.try_with(|spare| own = spare.replace(own.take()));
        if let Some(other) = own {
            Self::forget(other);
        }
    }

    /// Frees scratch memory that a run inside another one has kept.
    #[cold]
    #[inline(never)]
    fn forget(_: Box<Self>) {}

    /// The parameters of a run of blocks that pass at most so many at once: every activation has those that it was given behind those of
    /// its caller, and room for those that it passes.
    pub(crate) fn parameters(parameters_max: usize) -> usize {
        (LINKS + 2) * parameters_max.max(1)
    }

    #[cold]
    fn new(parameters: usize) -> Self {
        Self {
            links: vec![Link::default(); LINKS].into_boxed_slice(),
            parameters: vec![0; parameters].into_boxed_slice(),
            file: Box::new([0; 256]),
        }
    }
}

/// First byte in the arena and length of I, Q and M, under the low half of their codes in pointers; no bytes under other codes.
pub(crate) type Areas = [[u64; 2]; 16];

/// The areas of a layout.
pub(crate) fn areas(layout: &Layout) -> Areas {
    let mut areas = [[0; 2]; 16];
    for area in [Area::Input, Area::Output, Area::BitMemory] {
        let range = layout.area(area).unwrap_or(0..0);
        areas[usize::from(area.pointer_code() & 0xF)] = [range.start as u64, range.len() as u64];
    }
    areas
}

/// Data blocks by number, as they were loaded: first byte in the arena and length; behind the last one that is not loaded.
pub(crate) type OpenTable = Box<[[u32; 2]]>;

/// The first byte of a data block that is not loaded.
pub(crate) const NOT_LOADED: u32 = u32::MAX;

/// Where machine code finds nothing and asks: the data blocks are not as they were loaded.
static NONE_LOADED: [[u32; 2]; 1] = [[NOT_LOADED, 0]];

/// The data blocks of a layout.
pub(crate) fn open_table(layout: &Layout) -> OpenTable {
    let last = layout.data_blocks.keys().next_back().map_or(0, |&number| usize::from(number));
    let mut table = vec![[NOT_LOADED, 0]; last + 2];
    table[0] = [0, 0];
    for (&number, range) in &layout.data_blocks {
        table[usize::from(number)] = [range.start as u32, range.len() as u32];
    }
    table.into_boxed_slice()
}

/// What all blocks that become part of a function, and those that it calls first, need together.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Room {
    /// Activations below that of the function.
    pub(crate) depth: usize,
    /// Bytes of local data behind its own.
    pub(crate) local: usize,
}

/// Limits of the calls of an outermost block.
#[derive(Debug)]
pub(crate) struct Limits {
    /// First byte of its local data in the arena.
    pub(crate) local_start: usize,
    /// First byte behind the local data of its priority class.
    local_end: u64,
    /// Bytes of the links before the last one that a call may use.
    links: u64,
}

impl Limits {
    /// The limits in a layout.
    pub(crate) fn new(layout: &Layout) -> Self {
        let local_end = (layout.local.start + layout.local_class).min(layout.local.end);
        let link_max = usize::from(layout.nesting_depth).min(LINKS - 2);
        Self { local_start: layout.local.start, local_end: local_end as u64, links: (link_max * size_of::<Link>()) as u64 }
    }

    /// Whether an organization block with so many bytes of local data has room for all that it enters itself.
    pub(crate) fn have(&self, local_size: usize, room: Room) -> bool {
        (room.depth * size_of::<Link>()) as u64 <= self.links && (self.local_start + local_size + room.local) as u64 <= self.local_end
    }
}

/// Where machine code looks for data blocks by their numbers, as address and last index.
#[inline]
fn data_blocks_to_open(memory: &Memory, compiled: &Compiled) -> (u64, u64) {
    let table: &[[u32; 2]] = if memory.data_blocks.is_as_laid_out() { &compiled.open_table } else { &NONE_LOADED };
    (table.as_ptr() as u64, table.len() as u64 - 1)
}

/// One run of machine code. The fields before `context` are reached by machine code through their offsets.
#[repr(C)]
pub(crate) struct Run<'a, 'c> {
    /// Address of the machine's registers; they are current wherever machine code asks for something.
    pub(crate) registers: u64,
    /// The result of what was asked for.
    pub(crate) value: u64,
    /// The answer of what was asked in cold code.
    pub(crate) answer: u64,
    /// `machine.budget`, current while machine code runs.
    pub(crate) budget: i64,
    /// Address behind the local data of the priority class.
    pub(crate) local_end: u64,
    /// Address of the last link that a call may use.
    pub(crate) link_max: u64,
    pub(crate) areas: &'a Areas,
    /// Address of the table of data blocks, and its last index, under which none is loaded.
    pub(crate) open_table: u64,
    pub(crate) open_last: u64,
    /// Address of the first timer.
    pub(crate) timers: u64,
    /// Address of the first counter.
    pub(crate) counters: u64,
    /// `machine.clock_us`, and the same in milliseconds.
    pub(crate) clock_us: u64,
    pub(crate) clock_ms: u64,
    pub(crate) context: &'a mut Context<'c>,
    pub(crate) compiled: &'a Compiled,
    pub(crate) scratch: &'a mut Scratch,
    /// The fault of the access that was tried last.
    pub(crate) fault: Option<Fault>,
    /// How the run ends, once it is left; `None` = the interpreter goes on.
    pub(crate) exit: Option<Exit>,
    /// Frames of the machine that stay while machine code runs: all up to the newest organization block.
    pub(crate) kept: usize,
    /// Interrupts that machine code is in.
    pub(crate) interrupts: usize,
    arena: *mut u8,
    arena_bytes: usize,
}

impl<'a, 'c> Run<'a, 'c> {
    /// A run that begins with the registers of the machine.
    #[inline]
    pub(crate) fn new(context: &'a mut Context<'c>, compiled: &'a Compiled, scratch: &'a mut Scratch) -> Self {
        let registers = std::ptr::from_mut(&mut context.machine.registers) as u64;
        let memory = &mut context.machine.memory;
        let arena = memory.arena.as_mut_ptr();
        let arena_bytes = memory.arena.len();
        let budget = context.machine.budget;
        let (timers, counters) = (context.machine.timers.as_mut_ptr() as u64, context.machine.counters.as_mut_ptr() as u64);
        let clock_us = context.machine.clock_us;
        let (open_table, open_last) = data_blocks_to_open(memory, compiled);
        Self {
            registers,
            value: 0,
            answer: 0,
            budget,
            local_end: arena as u64 + compiled.limits.local_end,
            link_max: scratch.links.as_ptr() as u64 + compiled.limits.links,
            areas: &compiled.areas,
            open_table,
            open_last,
            timers,
            counters,
            clock_us,
            clock_ms: clock_us / 1000,
            context,
            compiled,
            scratch,
            fault: None,
            exit: None,
            kept: 0,
            interrupts: 0,
            arena,
            arena_bytes,
        }
    }

    /// First byte of the arena.
    ///
    /// # Panics
    /// If the arena moved in a scan: the contract with the Host forbids it, and machine code holds addresses in it.
    pub(crate) fn arena(&self) -> *mut u8 {
        let arena = &self.context.machine.memory.arena;
        assert!(arena.as_ptr() == self.arena && arena.len() == self.arena_bytes, "the arena does not move in a scan");
        self.arena
    }

    /// First byte of the arena when the run began.
    #[inline]
    pub(crate) fn arena_at_first(&self) -> *mut u8 {
        self.arena
    }

    /// Address of the local data of the outermost block.
    pub(crate) fn local_start(&self) -> usize {
        self.arena as usize + self.compiled.limits.local_start
    }

    /// Address of a link.
    pub(crate) fn link_address(&self, depth: usize) -> usize {
        self.scratch.links.as_ptr() as usize + depth * size_of::<Link>()
    }

    /// The depth of an activation, from the address of its link.
    pub(crate) fn depth(&self, link: u64) -> usize {
        (link as usize - self.scratch.links.as_ptr() as usize) / size_of::<Link>()
    }

    /// Address of the first place for parameters.
    pub(crate) fn parameters_start(&self) -> u64 {
        self.scratch.parameters.as_ptr() as u64
    }

    /// Sets the limits of calls, those of the priority class to which the newest frame of the machine belongs.
    pub(crate) fn limit_calls(&mut self) {
        let machine = &*self.context.machine;
        let layout = &machine.memory.layout;
        let Some((newest, frame)) = machine.frames.iter().enumerate().next_back() else { return };
        let deeper = if frame.in_error { layout.nesting_depth_error } else { 0 };
        let depth_max = usize::from(layout.nesting_depth.saturating_add(deeper));
        // Activations are counted through all priority classes, frames in each of them again.
        let link_max = (newest - usize::from(frame.depth).min(newest) + depth_max).min(LINKS - 2);
        let local_end = (layout.local.start + frame.class_base as usize + layout.local_class).min(layout.local.end);
        self.link_max = self.link_address(link_max) as u64;
        self.local_end = self.arena as u64 + local_end as u64;
    }

    /// The local data of an activation's caller, the caller of that and so on, as ranges of the arena: as `Machine::local_data` has them.
    pub(crate) fn local_data(&self, depth: usize, outwards: usize) -> Range<usize> {
        // Behind the newest organization block there are calls only.
        let organization_block = self.kept.saturating_sub(1);
        match depth.checked_sub(outwards) {
            Some(index) if index >= organization_block => self.local_range(index),
            _ => 0..0,
        }
    }

    /// The local data of an activation, as a range of the arena.
    pub(crate) fn local_range(&self, depth: usize) -> Range<usize> {
        let link = &self.scratch.links[depth];
        let start = link.local as usize - self.arena as usize;
        start..start + self.compiled.blocks[link.code as usize].local_size as usize
    }

    /// The places of parameters between two addresses.
    fn parameter_range(&self, from: u64, to: u64) -> Range<usize> {
        let start = self.parameters_start();
        let index = |address: u64| (address.saturating_sub(start) / 4) as usize;
        index(from)..index(to)
    }

    /// Shows all activations up to `depth` as frames of the machine, with `passed` parameters that the newest is about to pass, and
    /// and the budget.
    pub(crate) fn show(&mut self, depth: usize, passed: usize) {
        let first = self.kept;
        let parameters_kept = match first.checked_sub(1) {
            Some(newest) => self.context.machine.frames[newest].parameters_end as usize,
            None => 0,
        };
        self.context.machine.frames.truncate(first);
        self.context.machine.parameters.truncate(parameters_kept);
        for index in first..=depth {
            let link = self.scratch.links[index];
            let block = &self.compiled.blocks[link.code as usize];
            if let Some(caller) = self.context.machine.frames.last_mut() {
                caller.resume = self.compiled.interpreter.resume_behind(caller.code, link.site as u32);
            }
            let given = self.parameter_range(link.parameters, link.parameters_end);
            let machine = &mut *self.context.machine;
            machine.parameters.extend_from_slice(&self.scratch.parameters[given.clone()]);
            let origin = match index {
                0 => Origin::Start,
                _ => Origin::Call(CallerRegisters {
                    shared: link.shared,
                    instance: link.instance,
                    mcr_active: link.mcr_active,
                    nesting: link.nesting,
                }),
            };
            let pushed = machine.push_frame(block.id, link.code as u32, block.local_size, given.len() as u16, origin);
            assert_eq!(pushed, Ok(()), "machine code keeps the limits of calls");
        }
        let end = self.scratch.links[depth].parameters_end;
        let passed = self.parameter_range(end, end + 4 * passed as u64);
        let machine = &mut *self.context.machine;
        machine.parameters.extend_from_slice(&self.scratch.parameters[passed]);
        machine.budget = self.budget;
    }

    /// Takes over what the Host changed, apart from the registers.
    ///
    /// # Panics
    /// If the arena moved, or timers or counters were taken away: the contract with the Host forbids it.
    pub(crate) fn take_back(&mut self) {
        let machine = &mut *self.context.machine;
        (self.budget, self.clock_us, self.clock_ms) = (machine.budget, machine.clock_us, machine.clock_us / 1000);
        let layout = &machine.memory.layout;
        let there = machine.timers.len() == usize::from(layout.timers) && machine.counters.len() == usize::from(layout.counters);
        assert!(there, "a CPU keeps its timers and counters");
        (self.timers, self.counters) = (machine.timers.as_mut_ptr() as u64, machine.counters.as_mut_ptr() as u64);
        (self.open_table, self.open_last) = data_blocks_to_open(&machine.memory, self.compiled);
        self.arena();
    }

    /// Whether the open data blocks lie inside the arena, on which machine code relies.
    ///
    /// # Panics
    /// If they do not: only the engine and system functions write these registers.
    pub(crate) fn check_open_blocks(&self) {
        let registers = &self.context.machine.registers;
        self.check_open_block(registers.db_base, registers.db_length);
        self.check_open_block(registers.di_base, registers.di_length);
    }

    /// Makes sure that a data block that is to be open lies inside the arena.
    pub(crate) fn check_open_block(&self, base: u64, length: u64) {
        let end = base.checked_add(length);
        assert!(end.is_some_and(|end| end <= self.arena_bytes as u64), "an open data block lies inside the arena");
    }

    /// Takes over what a system function changed in the frames: it may move data blocks that callers have open. Whether nothing changed,
    /// so that the code of the callers has the right addresses.
    pub(crate) fn follow_frames(&mut self) -> bool {
        let mut same = true;
        let frames = &self.context.machine.frames;
        for (frame, link) in frames.iter().zip(self.scratch.links.iter_mut()).skip(1) {
            let open = match &frame.origin {
                Origin::Start => continue,
                Origin::Call(caller) => [caller.shared, caller.instance],
                Origin::Interrupt { registers, .. } => [
                    [registers.db_number, registers.db_base, registers.db_length],
                    [registers.di_number, registers.di_base, registers.di_length],
                ],
            };
            same &= open == [link.shared, link.instance];
            [link.shared, link.instance] = open;
        }
        same
    }
}
