//! What a typed tree means, by walking over it: a second definition, which the code of the lowering is compared with.

use sieben_lang::st::tree::{Argument, Base, Bounds, Call, Callee, For, Index, Place, Scalar, Statement, StatementKind, Value, ValueKind};
use sieben_model::address::Area;
use sieben_model::types::DataType;

/// Bytes of each piece of memory that trees work with.
pub(super) const REGION: usize = 128;
/// Begin of the local variables in the local data of every block, in bytes.
pub(super) const LOCAL: u32 = 20;
/// Statements after which the model gives up: the engines are compared with each other only.
const STEPS_MAX: usize = 20_000;

/// Why a statement does not go on.
enum Stop {
    /// It counts as NOP.
    Fault,
    /// It leaves loops or the block.
    Exit(u32),
    Continue(u32),
    Return,
    /// The model gives up.
    TooLong,
}

type Done<T> = Result<T, Stop>;

/// The blocks of a program: OB 1, FC 1 and FB 1.
pub(super) struct Blocks<'a> {
    pub(super) main: &'a [Statement],
    pub(super) function: &'a [Statement],
    pub(super) function_block: &'a [Statement],
    /// Whether OB 1, FC 1 and FB 1 use ENO/OK.
    pub(super) uses_ok: [bool; 3],
}

/// The memory that both engines and the model end with.
pub(super) struct Model<'a> {
    blocks: Blocks<'a>,
    pub(super) memory: [u8; REGION],
    pub(super) data: [u8; REGION],
    pub(super) instance: [u8; REGION],
    pub(super) faults: usize,
    br: bool,
    steps: usize,
}

/// A block being executed.
struct Frame {
    local: [u8; REGION],
    /// Values of the parameters of FC 1, by their index.
    parameters: [u64; 5],
    ok: bool,
    uses_ok: bool,
}

impl<'a> Model<'a> {
    pub(super) fn new(blocks: Blocks<'a>, memory: [u8; REGION]) -> Self {
        Self { blocks, memory, data: [0; REGION], instance: [0; REGION], faults: 0, br: true, steps: 0 }
    }

    /// Runs OB 1; BR at its end, `None` if it takes too long.
    pub(super) fn run(&mut self) -> Option<bool> {
        let mut frame = self.frame(0, [0; 5]);
        let main = self.blocks.main;
        self.block(&mut frame, main)?;
        Some(self.br)
    }

    fn frame(&self, block: usize, parameters: [u64; 5]) -> Frame {
        Frame { local: [0; REGION], parameters, ok: true, uses_ok: self.blocks.uses_ok[block] }
    }

    fn block(&mut self, frame: &mut Frame, statements: &[Statement]) -> Option<()> {
        if matches!(self.statements(frame, statements), Err(Stop::TooLong)) {
            return None;
        }
        self.br = !frame.uses_ok || frame.ok;
        Some(())
    }

    fn statements(&mut self, frame: &mut Frame, statements: &[Statement]) -> Done<()> {
        for statement in statements {
            self.steps += 1;
            if self.steps > STEPS_MAX {
                return Err(Stop::TooLong);
            }
            match self.statement(frame, &statement.kind) {
                Err(Stop::Fault) => self.faults += 1,
                other => other?,
            }
        }
        Ok(())
    }

    fn statement(&mut self, frame: &mut Frame, kind: &StatementKind) -> Done<()> {
        match kind {
            StatementKind::Assign { target, value } => {
                let new = self.value(frame, value)?;
                self.store(frame, target, value.scalar, new).map(|_| ())
            }
            StatementKind::Call(call) => self.call(frame, call).map(|_| ()),
            StatementKind::If { branches, otherwise } => {
                for (condition, body) in branches {
                    if self.value(frame, condition)? & 1 != 0 {
                        return self.statements(frame, body);
                    }
                }
                self.statements(frame, otherwise)
            }
            StatementKind::Case { selector, branches, otherwise } => {
                let value = number(selector.scalar, self.value(frame, selector)?);
                let hit = branches.iter().find(|branch| branch.ranges.iter().any(|&(low, high)| (low..=high).contains(&value)));
                self.statements(frame, hit.map_or(otherwise, |branch| &branch.body))
            }
            StatementKind::For(for_loop) => self.for_loop(frame, for_loop),
            StatementKind::While { condition, body } => {
                while self.value(frame, condition)? & 1 != 0 {
                    if self.pass(frame, body)? {
                        break;
                    }
                }
                Ok(())
            }
            StatementKind::Repeat { body, until } => loop {
                if self.pass(frame, body)? || self.value(frame, until)? & 1 != 0 {
                    return Ok(());
                }
            },
            StatementKind::Exit { depth } => Err(Stop::Exit(*depth)),
            StatementKind::Continue { depth } => Err(Stop::Continue(*depth)),
            StatementKind::Return => Err(Stop::Return),
            StatementKind::SetOk(value) => {
                let ok = self.value(frame, value)? & 1 != 0;
                frame.ok = ok;
                Ok(())
            }
            _ => unreachable!("the generator does not make this"),
        }
    }

    /// One pass of a loop; whether it is left.
    fn pass(&mut self, frame: &mut Frame, body: &[Statement]) -> Done<bool> {
        self.steps += 1;
        if self.steps > STEPS_MAX {
            return Err(Stop::TooLong);
        }
        match self.statements(frame, body) {
            Err(Stop::Exit(0)) => Ok(true),
            Err(Stop::Continue(0)) | Ok(()) => Ok(false),
            Err(Stop::Exit(depth)) => Err(Stop::Exit(depth - 1)),
            Err(Stop::Continue(depth)) => Err(Stop::Continue(depth - 1)),
            Err(other) => Err(other),
        }
    }

    fn for_loop(&mut self, frame: &mut Frame, for_loop: &For) -> Done<()> {
        let scalar = for_loop.scalar;
        let mut variable = for_loop.variable.clone();
        for index in &mut variable.indexes {
            let value = self.value(frame, &index.value)?;
            index.value.kind = ValueKind::Constant(value);
        }
        let from = self.value(frame, &for_loop.from)?;
        if !self.store(frame, &variable, scalar, from)? {
            return Ok(());
        }
        let to = number(scalar, self.value(frame, &for_loop.to)?);
        let by = number(scalar, self.value(frame, &for_loop.by)?);
        if by == 0 {
            frame.ok &= !frame.uses_ok;
            return Ok(());
        }
        let past = |value: i128| if by > 0 { value > to } else { value < to };
        let first = self.load(frame, &variable, scalar)?;
        if past(number(scalar, first)) {
            return Ok(());
        }
        loop {
            if self.pass(frame, &for_loop.body)? {
                return Ok(());
            }
            let next = number(scalar, self.load(frame, &variable, scalar)?) + by;
            let bits = next as u64 & mask(scalar);
            self.store(frame, &variable, scalar, bits)?;
            if number(scalar, bits) != next || past(next) {
                return Ok(());
            }
        }
    }

    fn value(&mut self, frame: &mut Frame, value: &Value) -> Done<u64> {
        Ok(match &value.kind {
            ValueKind::Constant(bits) => *bits,
            ValueKind::Load(place) => self.load(frame, place, value.scalar)?,
            ValueKind::Compute { op, args } => op.eval(self.args(frame, args)?),
            ValueKind::Checked { op, failed, args } => {
                let args = self.args(frame, args)?;
                if frame.uses_ok && failed.eval(args) & 1 != 0 {
                    frame.ok = false;
                }
                op.eval(args)
            }
            ValueKind::AndThen(a, b) => match self.value(frame, a)? & 1 {
                0 => 0,
                _ => self.value(frame, b)?,
            },
            ValueKind::OrElse(a, b) => match self.value(frame, a)? & 1 {
                0 => self.value(frame, b)?,
                _ => 1,
            },
            ValueKind::Choose { condition, a, b } => match self.value(frame, condition)? & 1 {
                0 => self.value(frame, b)?,
                _ => self.value(frame, a)?,
            },
            ValueKind::Call(call) => self.call(frame, call)?,
            ValueKind::Ok => u64::from(frame.ok || !frame.uses_ok),
            ValueKind::After(statements, then) => {
                self.statements(frame, statements)?;
                self.value(frame, then)?
            }
            _ => unreachable!("the generator does not make this"),
        })
    }

    fn args(&mut self, frame: &mut Frame, args: &[Value]) -> Done<[u64; 4]> {
        let mut values = [0; 4];
        for (value, arg) in values.iter_mut().zip(args) {
            *value = self.value(frame, arg)?;
        }
        Ok(values)
    }

    fn call(&mut self, frame: &mut Frame, call: &Call) -> Done<u64> {
        if let Some(enable) = &call.enable
            && self.value(frame, enable)? & 1 == 0
        {
            self.br = false;
            self.eno(frame, call)?;
            return Ok(0);
        }
        let mut parameters = [0; 5];
        let mut places: Vec<(Place, &Argument)> = Vec::new();
        let is_function = matches!(call.callee, Callee::Function(_));
        for argument in &call.arguments {
            match argument {
                Argument::Value { parameter, value } => {
                    let new = self.value(frame, value)?;
                    if is_function {
                        parameters[*parameter as usize] = new;
                    } else {
                        write(&mut self.instance, *parameter as usize, value.scalar, new);
                    }
                }
                Argument::InOut { parameter, place, .. } => {
                    let mut frozen = place.clone();
                    for index in &mut frozen.indexes {
                        let value = self.value(frame, &index.value)?;
                        index.value.kind = ValueKind::Constant(value);
                    }
                    parameters[*parameter as usize] = self.load(frame, &frozen, Scalar::I32)?;
                    places.push((frozen, argument));
                }
                Argument::Output { target, .. } => places.push((target.clone(), argument)),
                Argument::Eno { .. } => {}
                _ => unreachable!("the generator does not make this"),
            }
        }
        let (statements, mut inner) = if is_function {
            (self.blocks.function, self.frame(1, parameters))
        } else {
            (self.blocks.function_block, self.frame(2, [0; 5]))
        };
        self.block(&mut inner, statements).ok_or(Stop::TooLong)?;
        for (place, argument) in places {
            match argument {
                Argument::Output { parameter, scalar, .. } => {
                    let value = match is_function {
                        true => inner.parameters[*parameter as usize],
                        false => read(&self.instance, *parameter as usize, *scalar),
                    };
                    self.store(frame, &place, *scalar, value)?;
                }
                _ => {
                    self.store(frame, &place, Scalar::I32, inner.parameters[3])?;
                }
            }
        }
        frame.ok &= self.br || !call.clears_ok;
        self.eno(frame, call)?;
        Ok(if call.result == DataType::Void { 0 } else { inner.parameters[4] })
    }

    fn eno(&mut self, frame: &mut Frame, call: &Call) -> Done<()> {
        for argument in &call.arguments {
            if let Argument::Eno { target } = argument {
                self.store(frame, target, Scalar::Bool, u64::from(self.br))?;
            }
        }
        Ok(())
    }

    /// The position of a place and whether it is to be used.
    fn locate(&mut self, frame: &mut Frame, place: &Place) -> Done<(usize, bool)> {
        let mut position = i64::from(place.offset);
        let mut used = true;
        for Index { value, low, count, step, check } in &place.indexes {
            let index = number(value.scalar, self.value(frame, value)?) as i64;
            let inside = (*low..low + *count as i64).contains(&index);
            let index = match check {
                _ if inside => index,
                Bounds::Fault => return Err(Stop::Fault),
                Bounds::Clamp => index.clamp(*low, low + *count as i64 - 1),
                Bounds::Skip | Bounds::None => {
                    used = false;
                    *low
                }
            };
            position += (index - low) * i64::from(*step);
        }
        frame.ok &= used || !frame.uses_ok;
        Ok((position as usize, used))
    }

    fn load(&mut self, frame: &mut Frame, place: &Place, scalar: Scalar) -> Done<u64> {
        let (position, used) = self.locate(frame, place)?;
        if let Base::Parameter(index) = place.base {
            return Ok(frame.parameters[usize::from(index)]);
        }
        let bytes = self.bytes(frame, &place.base);
        let position = if place.base == Base::Area(Area::Local) { position - 8 * LOCAL as usize } else { position };
        Ok(if used { read(bytes, position, scalar) } else { 0 })
    }

    /// Whether the variable is there.
    fn store(&mut self, frame: &mut Frame, place: &Place, scalar: Scalar, value: u64) -> Done<bool> {
        let (position, used) = self.locate(frame, place)?;
        if let Base::Parameter(index) = place.base {
            frame.parameters[usize::from(index)] = value;
            return Ok(true);
        }
        let bytes = self.bytes(frame, &place.base);
        let position = if place.base == Base::Area(Area::Local) { position - 8 * LOCAL as usize } else { position };
        if used {
            write(bytes, position, scalar, value);
        }
        Ok(used)
    }

    fn bytes<'m>(&'m mut self, frame: &'m mut Frame, base: &Base) -> &'m mut [u8; REGION] {
        match base {
            Base::Area(Area::Local) => &mut frame.local,
            Base::Area(_) => &mut self.memory,
            Base::DataBlock(_) => &mut self.data,
            _ => &mut self.instance,
        }
    }
}

fn mask(scalar: Scalar) -> u64 {
    u64::MAX >> (64 - scalar.bits())
}

/// The number that bits mean.
fn number(scalar: Scalar, bits: u64) -> i128 {
    let bits = i128::from(bits & mask(scalar));
    let signed = matches!(scalar, Scalar::I8 | Scalar::I16 | Scalar::I32 | Scalar::I64);
    if signed && bits >> (scalar.bits() - 1) & 1 != 0 { bits - (1 << scalar.bits()) } else { bits }
}

fn read(bytes: &[u8; REGION], position: usize, scalar: Scalar) -> u64 {
    if scalar == Scalar::Bool {
        return u64::from(bytes[position / 8] >> (position % 8) & 1);
    }
    bytes[position / 8..][..scalar.bits() as usize / 8].iter().fold(0, |all, &byte| all << 8 | u64::from(byte))
}

fn write(bytes: &mut [u8; REGION], position: usize, scalar: Scalar, value: u64) {
    if scalar == Scalar::Bool {
        let byte = &mut bytes[position / 8];
        *byte = *byte & !(1 << (position % 8)) | ((value & 1) as u8) << (position % 8);
        return;
    }
    let count = scalar.bits() as usize / 8;
    bytes[position / 8..][..count].copy_from_slice(&value.to_be_bytes()[8 - count..]);
}
