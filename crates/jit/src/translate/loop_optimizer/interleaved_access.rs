//! Interleaved-access groups: fields of structures and instances in arrays that are near each other, in four iterations. Eight or sixteen
//! bytes of each iteration are loaded together and transposed into vectors of one field of all four, and fields that are written are
//! transposed back. A store is deferred until its last field is known, or until another access may alias it.

use std::collections::BTreeMap;
use std::ops::Range;

use cranelift_codegen::ir::types::{F32X4, F64, F64X2, I8, I8X16, I16, I16X8, I32, I32X4, I64};
use cranelift_codegen::ir::{InstBuilder, InstructionData, Opcode, Value};
use sieben_model::address::Width;

use super::super::Translator;
use super::super::memory::data;
use super::super::scalar_promotion::Base;
use super::super::value::Val;
use super::emission::Emitter;
use super::kernel::{Definition, Effect, Kernel, Node};
use super::modular_addressing::ByteWindow;
use super::scalar_evolution::Shape;
use super::strided_access::{FIRST_WORDS_TURNED, Strided};
use super::vectorization::{Lanes, little};
use crate::passes::Pass;

/// Vectorized iterations.
const ITERATIONS: u32 = 4;
/// The bytes between two fields that are written that may be written with them.
const GAP_MAX: i32 = 3;

/// What it costs to read one field of four iterations, to iteration rows into vectors, and to put a field together of two of them.
const FIELD_COST: u32 = 8;
const ROWS: [(i32, u32); 2] = [(8, 8), (16, 12)];
const PARTS_COST: u32 = 3;

/// What it costs to write a piece of four iterations: as it was read elsewhere, the same bytes of each, rows of sixteen or eight bytes made
/// of columns, four bytes out of a column, and one or two.
const COPY_COST: u32 = 12;
const SAME_COST: u32 = 8;
const ROWS_COST: u32 = 24;
const SHORT_ROWS_COST: u32 = 16;
const WORDS_COST: u32 = 14;
const BYTES_COST: u32 = 16;
/// What it costs to move a column by some bytes.
const MOVE_COST: u32 = 2;

/// Rows of so many bytes, with such a step from iteration to iteration, lie beside each other: two are read or written at once.
const SIDE_BY_SIDE: (i32, i32) = (8, 8);

/// The first 16 bits of each number of 32 bits out of eight numbers of 16, turned around.
const WORDS_TURNED_APART: [u8; 16] = [1, 0, 1, 0, 3, 2, 3, 2, 5, 4, 5, 4, 7, 6, 7, 6];

/// The same places in the rows of four iterations: 32 bits of each, as they are in memory.
#[derive(Clone, Copy)]
enum FieldVector {
    Same(u32),
    Lanes(Value),
}

/// The first 16 bits of each number of 32 bits of one vector, and the second ones of another one.
const SECOND_WORDS: [u8; 16] = [0, 1, 18, 19, 4, 5, 22, 23, 8, 9, 26, 27, 12, 13, 30, 31];

/// A part of the rows that is known.
#[derive(Clone, Copy)]
struct FieldPart {
    at: i32,
    /// How many bytes it has, and how many of the column are as in the row: what follows was not written.
    bytes: i32,
    known: i32,
    column: FieldVector,
    /// The access that read these bytes, if they are just as it found them.
    source: Option<usize>,
}

impl FieldPart {
    /// So many bytes that were read there.
    fn as_found(at: i32, known: i32, column: FieldVector) -> Self {
        Self { at, bytes: 0, known, column, source: None }
    }

    fn range(&self) -> Range<i32> {
        self.at..self.at + self.bytes
    }

    fn meets(&self, bytes: &Range<i32>) -> bool {
        self.at < bytes.end && bytes.start < self.range().end
    }
}

/// Bytes that are written as they lie elsewhere, and where the first of them is there.
struct CopiedBytes {
    bytes: Range<i32>,
    apart: Strided,
}

/// What is written to some bytes of each iteration.
enum StoredBytes {
    Columns(Vec<FieldVector>),
    /// What was read of each iteration.
    AsRead(Vec<Value>),
}

/// The structure or instance of each iteration to whose fields accesses go.
#[derive(Clone)]
struct AccessGroup {
    accesses: Vec<usize>,
    /// The access that writes last.
    last: Option<usize>,
    rows: Vec<LoadGroup>,
    /// What was read, as it was.
    old: Vec<FieldPart>,
    /// What is to be written, and where.
    new: Vec<FieldPart>,
    /// Where they are written.
    place: Option<Strided>,
}

/// The structures and instances that the iterations of a loop read and write.
#[derive(Clone, Default)]
pub(super) struct AccessGroups(Vec<AccessGroup>);

impl AccessGroups {
    /// The one to whose field an access goes.
    fn of(&self, number: usize) -> Option<usize> {
        self.0.iter().position(|record| record.accesses.contains(&number))
    }

    /// The row with which a field is read.
    fn row(&self, kernel: &Kernel, number: usize) -> Option<(usize, LoadGroup)> {
        let at = self.of(number)?;
        let (start, bytes) = kernel.field(number);
        let row = self.0[at].rows.iter().copied().find(|row| row.0 <= start && start + bytes <= row.0 + row.1)?;
        Some((at, row))
    }
}

/// A field of them: its first byte, and the bytes that it has.
type Field = (i32, i32);
/// Bytes that are read at once: where they begin, and how many they are.
pub(super) type LoadGroup = (i32, i32);

/// The cheapest way to read a field and those behind it: the row that begins with it, and the first field behind that.
#[derive(Clone, Copy)]
struct Best {
    cost: u32,
    row: Option<LoadGroup>,
    next: usize,
}

impl Kernel {
    /// The structures and instances of vectorized iterations.
    pub(super) fn records(&self, lanes: u32) -> AccessGroups {
        if !self.passes.has(Pass::InterleavedAccess) {
            return AccessGroups::default();
        }
        if lanes != ITERATIONS || !self.is_spread() {
            return AccessGroups::default();
        }
        let mut all: BTreeMap<(Base, Node, u32, i32), Vec<usize>> = BTreeMap::new();
        for step in &self.outer.steps {
            if let Effect::Access(number) = *step
                && let access = &self.accesses[number]
                && access.width != Width::QuadWord
                && let Some(step) = self.apart(access)
            {
                let (base, pointer, offset) = access.counted();
                all.entry((base, pointer, offset, step)).or_default().push(number);
            }
        }
        let mut records = Vec::new();
        for ((.., step), accesses) in all {
            records.extend(self.by_array(accesses).into_iter().filter_map(|accesses| self.record(accesses, step)));
        }
        AccessGroups(records)
    }

    /// Accesses that may go to the same bytes in some iterations, which are those to one array.
    fn by_array(&self, accesses: Vec<usize>) -> Vec<Vec<usize>> {
        let mut arrays: Vec<(Range<i64>, Vec<usize>)> = Vec::new();
        for number in accesses {
            let (_, mut bytes) = self.accesses[number].bytes();
            let mut own = Vec::new();
            arrays.retain_mut(|(other, accesses)| {
                let is_apart = other.end <= bytes.start || bytes.end <= other.start;
                if !is_apart {
                    bytes = bytes.start.min(other.start)..bytes.end.max(other.end);
                    own.append(accesses);
                }
                is_apart
            });
            own.push(number);
            own.sort_unstable();
            arrays.push((bytes, own));
        }
        arrays.into_iter().map(|(_, accesses)| accesses).collect()
    }

    /// The fields to which accesses go, if they all lie between where they go in one iteration and where they go in the next.
    fn record(&self, accesses: Vec<usize>, step: i32) -> Option<AccessGroup> {
        let fields: Vec<Field> = accesses.iter().map(|&number| self.field(number)).collect();
        let start = fields.iter().map(|&(at, _)| at).min()?;
        let end = fields.iter().map(|&(at, bytes)| at + bytes).max()?;
        if end - start > step.abs() {
            return None;
        }
        let written = |&number: &usize| self.accesses[number].value.is_some();
        let is_read = |&number: &usize| !written(&number) || self.accesses[number].width == Width::Bit;
        let mut read: Vec<(Field, usize)> = accesses.iter().copied().filter(is_read).map(|number| (self.field(number), number)).collect();
        read.sort_unstable();
        read.dedup_by_key(|&mut (field, _)| field);
        let last = accesses.iter().copied().rfind(written);
        Some(AccessGroup { last, rows: self.rows(&read), accesses, old: Vec::new(), new: Vec::new(), place: None })
    }

    /// Where a field lies.
    fn field(&self, number: usize) -> Field {
        let access = &self.accesses[number];
        let (_, start, _) = access.area;
        (start + access.part.map_or(0, |part| part.bytes), access.width.bytes() as i32)
    }

    /// The rows with which fields in their order are read in the fewest steps.
    fn rows(&self, fields: &[(Field, usize)]) -> Vec<LoadGroup> {
        let mut best = vec![Best { cost: 0, row: None, next: fields.len() }; fields.len() + 1];
        for first in (0..fields.len()).rev() {
            best[first] = Best { cost: FIELD_COST + best[first + 1].cost, row: None, next: first + 1 };
            for (bytes, cost) in ROWS {
                for ahead in 0..4 {
                    let start = fields[first].0.0 - ahead;
                    let inside = |&&((at, own), number): &&(Field, usize)| {
                        at + own <= start + bytes && self.may_be_read(number, at, start..start + bytes)
                    };
                    let own: Vec<Field> = fields[first..].iter().take_while(inside).map(|&(field, _)| field).collect();
                    let in_parts = |&(at, own): &Field| {
                        let place = (at - start) % 4;
                        if place + own > 4 { PARTS_COST } else { u32::from(own == 1 && place != 0) }
                    };
                    let next = first + own.len();
                    let cost = cost + own.iter().map(in_parts).sum::<u32>() + best[next].cost;
                    if own.len() > 1 && cost < best[first].cost {
                        best[first] = Best { cost, row: Some((start, bytes)), next };
                    }
                }
            }
        }
        let mut rows = Vec::new();
        let mut at = 0;
        while at < fields.len() {
            rows.extend(best[at].row);
            at = best[at].next;
        }
        rows
    }

    /// Whether these bytes around a field may be read, so near to the ends of the arena.
    fn may_be_read(&self, number: usize, at: i32, row: Range<i32>) -> bool {
        let access = &self.accesses[number];
        let (base, bytes) = access.bytes();
        let (before, behind) = (i64::from(at - row.start), i64::from(row.end - at) - i64::from(access.width.bytes()));
        base == Base::Arena && bytes.start >= before && usize::try_from(bytes.end + behind).is_ok_and(|end| end <= self.size)
    }
}

impl AccessGroup {
    /// The parts of which the bytes from a place on are put together, those of the first ones given first; `None` if some are not known.
    fn parts(&self, wanted: Range<i32>) -> Option<Vec<(FieldPart, Vec<i32>)>> {
        let mut open: Vec<i32> = wanted.collect();
        let mut parts = Vec::new();
        let mut take = |part: &FieldPart, bytes: Range<i32>, open: &mut Vec<i32>| {
            let own: Vec<i32> = open.iter().copied().filter(|at| bytes.contains(at)).collect();
            if !own.is_empty() {
                open.retain(|at| !bytes.contains(at));
                parts.push((*part, own));
            }
        };
        self.new.iter().for_each(|part| take(part, part.range(), &mut open));
        let known = |part: &FieldPart| part.at..part.at + part.known;
        self.new.iter().for_each(|part| take(part, known(part), &mut open));
        self.old.iter().for_each(|part| take(part, known(part), &mut open));
        let mut merged: Vec<(FieldPart, Vec<i32>)> = Vec::new();
        for (part, bytes) in parts {
            match merged.iter_mut().find(|(other, _)| {
                other.at == part.at && matches!((other.column, part.column), (FieldVector::Lanes(a), FieldVector::Lanes(b)) if a == b)
            }) {
                Some((_, all)) => all.extend(bytes),
                None => merged.push((part, bytes)),
            }
        }
        open.is_empty().then_some(merged)
    }

    /// The bytes to be written that follow one another, with those between them that are known.
    fn runs(&self) -> Vec<Range<i32>> {
        let mut ranges: Vec<Range<i32>> = self.new.iter().map(FieldPart::range).collect();
        ranges.sort_unstable_by_key(|range| range.start);
        let mut runs: Vec<Range<i32>> = Vec::new();
        for range in ranges {
            match runs.last_mut() {
                Some(run) if range.start - run.end <= GAP_MAX && self.parts(run.end..range.start).is_some() => run.end = range.end,
                _ => runs.push(range),
            }
        }
        runs
    }

    /// The columns of bytes of a run, each with the place of its first byte and its parts.
    fn columns(&self, range: &Range<i32>) -> impl Iterator<Item = (i32, Vec<(FieldPart, Vec<i32>)>)> {
        let end = range.end;
        range.clone().step_by(4).map(move |at| (at, self.parts(at..(at + 4).min(end)).expect("the bytes of a run are known")))
    }

    /// The pieces in which these bytes are written in the fewest steps; of several ways the one whose first pieces are the longest. What a
    /// piece begins with may have been written by the one before.
    fn cheapest(&self, run: Range<i32>, step: i32, copies: &[CopiedBytes]) -> Vec<Range<i32>> {
        let places = |bytes: i32| (run.start..=run.end - bytes).rev().map(move |start| start..start + bytes);
        let all = [16, 8, 4, 2, 1].into_iter().flat_map(places).map(|range| (self.cost(&range, step, copies), range));
        let all: Vec<(u32, Range<i32>)> = all.collect();
        let mut best: BTreeMap<i32, (u32, Range<i32>)> = BTreeMap::from([(run.end, (0, run.end..run.end))]);
        for at in run.clone().rev() {
            let own = all.iter().filter(|(_, range)| range.contains(&at));
            let ways = own.map(|(cost, range)| (cost + best[&range.end].0, range.clone()));
            let cheapest = ways.min_by_key(|&(cost, _)| cost).expect("each byte can be written by itself");
            best.insert(at, cheapest);
        }
        let mut pieces = Vec::new();
        let mut at = run.start;
        while at < run.end {
            let (_, range) = best[&at].clone();
            at = range.end;
            pieces.push(range);
        }
        pieces
    }

    /// What it costs to write these bytes at once.
    fn cost(&self, range: &Range<i32>, step: i32, copies: &[CopiedBytes]) -> u32 {
        if as_read(copies, range).is_some() {
            return COPY_COST;
        }
        let mut all_same = true;
        let mut cost = 0;
        for (at, parts) in self.columns(range) {
            if parts.iter().all(|(part, _)| matches!(part.column, FieldVector::Same(_))) {
                continue;
            }
            all_same = false;
            cost += match &parts[..] {
                [(part, _)] if part.at == at => 0,
                [_] => MOVE_COST,
                parts => PARTS_COST * parts.len() as u32,
            };
        }
        cost + match range.len() {
            _ if all_same => SAME_COST,
            16 => ROWS_COST,
            8 if (range.len() as i32, step) == SIDE_BY_SIDE => SAME_COST,
            8 => SHORT_ROWS_COST,
            4 => WORDS_COST,
            _ => BYTES_COST,
        }
    }
}

impl Emitter<'_, '_, '_> {
    /// Four bytes of each iteration from where a field lies on, if they are read in rows; none behind the field are sure to be its own.
    pub(super) fn read_in_rows(&mut self, number: usize, apart: Strided) -> Option<Value> {
        let at = self.records.of(number)?;
        let (start, bytes) = self.kernel.field(number);
        let field = start..start + bytes;
        if self.records.0[at].new.iter().any(|part| part.meets(&field)) {
            self.write_record(at);
            return None;
        }
        let record = &self.records.0[at];
        let (_, row) = self.records.row(self.kernel, number)?;
        if record.parts(field.clone()).is_none() {
            let accesses = record.accesses.clone();
            accesses.iter().for_each(|&access| self.settle_records(access, true));
            let columns = self.t.read_rows(apart, row);
            let parts = (row.0..).step_by(4).zip(columns).map(|(at, column)| FieldPart::as_found(at, 4, FieldVector::Lanes(column)));
            self.records.0[at].old.extend(parts);
        }
        let parts = self.records.0[at].parts(field.clone())?;
        let column = self.t.put_in_column(field.start, &parts);
        // What follows it in the same column is known, too.
        if let [(part, _)] = &parts[..] {
            let known = part.at + part.known - field.start;
            self.records.0[at].old.push(FieldPart::as_found(field.start, known, column));
        }
        Some(self.t.lanes_of_column(column))
    }

    /// Notes that four bytes were read where a field lies.
    pub(super) fn note_old(&mut self, number: usize, vector: Value) {
        let (at, _) = self.kernel.field(number);
        if let Some(record) = self.records.of(number) {
            self.records.0[record].old.push(FieldPart::as_found(at, 4, FieldVector::Lanes(vector)));
        }
    }

    /// The 32 bits of each iteration that were read where a field lies, of which these are its bytes.
    pub(super) fn column_with(&self, number: usize, bytes: Value) -> Option<Value> {
        let record = &self.records.0[self.records.of(number)?];
        let (start, _) = self.kernel.field(number);
        let is_cut = |column| self.t.low_bytes_of(bytes) == Some(column);
        record.old.iter().filter(|part| part.at == start).find_map(|part| match part.column {
            FieldVector::Lanes(column) if is_cut(column) => Some(column),
            _ => None,
        })
    }

    /// Lets a field wait until it is written with others. Bytes are the lowest of 32 bits each; of what was read there with other bits, the
    /// bytes behind it are known, too.
    pub(super) fn write_in_rows(&mut self, number: usize, apart: Strided, value: &Lanes, with_others: bool) -> bool {
        let Some(at) = self.records.of(number) else { return false };
        let (start, bytes) = self.kernel.field(number);
        let field = start..start + bytes;
        if self.records.0[at].new.iter().any(|part| part.meets(&field) && part.range() != field) {
            self.write_record(at);
        }
        let column = match *value {
            Lanes::One(Val::Const(number)) => {
                let number = number.to_le_bytes();
                let mut turned = [0; 4];
                (0..bytes as usize).for_each(|byte| turned[byte] = number[bytes as usize - 1 - byte]);
                FieldVector::Same(u32::from_le_bytes(turned))
            }
            _ => FieldVector::Lanes(self.t.column_of(value, bytes)),
        };
        let source = self.source_of(number).filter(|_| !with_others);
        let record = &mut self.records.0[at];
        // The other bits of a byte, and the bytes behind it, are those that were read.
        let whole = matches!(column, FieldVector::Lanes(_)) && with_others;
        let known = record.old.iter().filter(|part| whole && part.at == start).map(|part| part.known).max().unwrap_or(bytes);
        record.new.retain(|part| part.at != start);
        record.new.push(FieldPart { at: start, bytes, known, column, source });
        record.place = Some(apart);
        if record.last == Some(number) {
            self.write_record(at);
        }
        true
    }

    /// Sees to it that memory holds what waits, where an access may go to it; one that writes may change what was read there.
    pub(super) fn settle_records(&mut self, number: usize, only_read: bool) {
        for at in 0..self.records.0.len() {
            let record = &self.records.0[at];
            if record.accesses.contains(&number) || record.new.is_empty() && (only_read || record.old.is_empty()) {
                continue;
            }
            if record.accesses.iter().any(|&own| self.kernel.touches(own, true, number)) {
                self.write_record(at);
            }
        }
    }

    /// Forgets what was read around fields where an access at an address of its own has written.
    pub(super) fn forget_around(&mut self, number: usize) {
        let written = &self.kernel.accesses[number];
        for record in &mut self.records.0 {
            let own = &self.kernel.accesses[record.accesses[0]];
            let (_, start, _) = own.area;
            let places = self.kernel.places(written);
            let place = places.into_iter().find(|place| (place.pointer, written.area) == (own.pointer, own.area));
            record.old.retain(|part| {
                let from = i64::from(part.at - start);
                let is_apart = |place: ByteWindow| from + i64::from(part.known) <= place.byte || place.byte + place.bytes <= from;
                own.part.is_some() && place.is_some_and(is_apart)
            });
        }
    }

    /// Writes all that waits.
    pub(super) fn write_records(&mut self) {
        (0..self.records.0.len()).for_each(|at| self.write_record(at));
    }

    fn write_record(&mut self, at: usize) {
        let record = &self.records.0[at];
        if let Some(place) = record.place {
            let copies = self.copies(record);
            let mut pieces: Vec<(Range<i32>, StoredBytes)> = Vec::new();
            for range in record.runs().into_iter().flat_map(|run| record.cheapest(run, place.step, &copies)) {
                let piece = match as_read(&copies, &range) {
                    Some((apart, from)) => StoredBytes::AsRead(self.t.read_as_it_is(apart, from, range.len())),
                    None => StoredBytes::Columns(record.columns(&range).map(|(at, parts)| self.t.put_in_column(at, &parts)).collect()),
                };
                pieces.push((range, piece));
            }
            for (range, piece) in pieces {
                match piece {
                    StoredBytes::Columns(columns) => self.t.write_rows(place, range, &columns),
                    StoredBytes::AsRead(numbers) => {
                        for (lane, number) in (0..).zip(numbers) {
                            self.t.b.ins().store(data(), number, place.first.base, range.start + place.step * lane);
                        }
                    }
                }
            }
        }
        let record = &mut self.records.0[at];
        record.place = None;
        record.new.clear();
        record.old.clear();
    }

    /// The access that read what another one writes, if it is written as it was read.
    fn source_of(&self, number: usize) -> Option<usize> {
        let written = &self.kernel.accesses[number];
        let Definition::Read(source) = self.kernel.what(written.value?) else { return None };
        let read = &self.kernel.accesses[source];
        (read.width == written.width && read.width != Width::Bit).then_some(source)
    }

    /// What is written as it was read, if it is still there.
    fn copies(&self, record: &AccessGroup) -> Vec<CopiedBytes> {
        let written = |&&own: &&usize| self.kernel.accesses[own].value.is_some();
        let copied = |part: &FieldPart| {
            let source = part.source?;
            let &(_, apart) = self.outer.sources.iter().find(|(number, _)| *number == source)?;
            let mut others = self.written.iter().chain(record.accesses.iter().filter(written));
            (!others.any(|&other| self.kernel.touches(source, false, other))).then(|| CopiedBytes { bytes: part.range(), apart })
        };
        record.new.iter().filter_map(copied).collect()
    }
}

/// Where these bytes of each iteration lie as they are.
fn as_read(copies: &[CopiedBytes], range: &Range<i32>) -> Option<(Strided, i32)> {
    let mut found: Option<(Strided, i32)> = None;
    let mut at = range.start;
    while at < range.end {
        let CopiedBytes { bytes, apart } = copies.iter().find(|copied| copied.bytes.contains(&at))?;
        let place = apart.first.offset - bytes.start + range.start;
        match found {
            None => found = Some((*apart, place)),
            Some((known, at)) if (known.first.base, known.step, at) == (apart.first.base, apart.step, place) => {}
            Some(_) => return None,
        }
        at = bytes.end;
    }
    found
}

impl Translator<'_> {
    fn lanes_of_column(&mut self, column: FieldVector) -> Value {
        match column {
            FieldVector::Lanes(lanes) => lanes,
            FieldVector::Same(number) => self.all_words(number),
        }
    }

    /// A field of which a column begins with the bytes.
    pub(super) fn of_column(&mut self, column: Value, shape: Shape, width: Width) -> Lanes {
        let (ty, _) = shape.vectors(ITERATIONS);
        let turned = match width {
            Width::Byte => {
                let low = self.all_words(0xFF);
                return Lanes::Words(vec![self.b.ins().band(column, low)]);
            }
            Width::Word => self.shuffled(column, column, FIRST_WORDS_TURNED),
            _ => {
                let bytes = self.b.ins().bitcast(I8X16, little(), column);
                self.turned(bytes, 4)
            }
        };
        shape.of(vec![self.b.ins().bitcast(ty, little(), turned)])
    }

    /// The vector of which these are the lowest bytes of each number.
    fn low_bytes_of(&self, bytes: Value) -> Option<Value> {
        let dfg = &self.b.func.dfg;
        let inst = dfg.value_def(bytes).inst()?;
        let InstructionData::Binary { opcode: Opcode::Band, args: [of, low] } = dfg.insts[inst] else { return None };
        let low = dfg.value_def(low).inst()?;
        let InstructionData::UnaryConst { opcode: Opcode::Vconst, constant_handle } = dfg.insts[low] else { return None };
        (dfg.constants.get(constant_handle).as_slice() == 0xFF_u32.to_le_bytes().repeat(4)).then_some(of)
    }

    /// What is written to a field, as it will be in memory.
    fn column_of(&mut self, value: &Lanes, bytes: i32) -> Value {
        if bytes == 1 {
            return self.words(value, ITERATIONS)[0];
        }
        let vector = self.vectors_to_write(value, bytes as u8, ITERATIONS)[0];
        let turned = match bytes {
            2 => self.shuffled(vector, vector, WORDS_TURNED_APART),
            _ => {
                let vector = self.b.ins().bitcast(I8X16, little(), vector);
                self.turned(vector, 4)
            }
        };
        self.b.ins().bitcast(I32X4, little(), turned)
    }

    /// Four bytes of each iteration from a place on, put together of parts.
    fn put_in_column(&mut self, at: i32, parts: &[(FieldPart, Vec<i32>)]) -> FieldVector {
        if let Some(column) = self.put_in_words(at, parts) {
            return column;
        }
        let moved = |number: u32, by: i32| if by >= 0 { number << (8 * by) } else { number >> (-8 * by) };
        let mask = |bytes: &[i32]| bytes.iter().fold(0, |mask, byte| mask | 0xFF << (8 * (byte - at)));
        let mut same = 0;
        let mut lanes: Option<Value> = None;
        for (number, (part, bytes)) in parts.iter().enumerate() {
            let by = part.at - at;
            let FieldVector::Lanes(vector) = part.column else {
                if let FieldVector::Same(number) = part.column {
                    same |= moved(number, by) & mask(bytes);
                }
                continue;
            };
            let own = match by {
                0 => vector,
                1.. => self.b.ins().ishl_imm_u(vector, i64::from(8 * by)),
                _ => self.b.ins().ushr_imm_u(vector, i64::from(-8 * by)),
            };
            // What moving it has made 0 needs no mask, nor what nobody wants.
            let others = parts.iter().enumerate().filter(|&(other, _)| other != number).map(|(_, (_, bytes))| mask(bytes));
            let left = moved(!0, by) & others.fold(0, |all, own| all | own);
            let own = if left == 0 {
                own
            } else {
                let kept = self.all_words(mask(bytes));
                self.b.ins().band(own, kept)
            };
            lanes = Some(lanes.map_or(own, |before| self.b.ins().bor(before, own)));
        }
        match lanes {
            None => FieldVector::Same(same),
            Some(lanes) if same == 0 => FieldVector::Lanes(lanes),
            Some(lanes) => {
                let same = self.all_words(same);
                FieldVector::Lanes(self.b.ins().bor(lanes, same))
            }
        }
    }

    /// The same where each word of 16 bits is of one part: they are put together in one step each.
    fn put_in_words(&mut self, at: i32, parts: &[(FieldPart, Vec<i32>)]) -> Option<FieldVector> {
        let words_of = |bytes: &[i32]| [0, 2].map(|word| bytes.iter().any(|byte| (byte - at) & 2 == word));
        let all: Vec<[bool; 2]> = parts.iter().map(|(_, bytes)| words_of(bytes)).collect();
        let is_one = |word: usize| all.iter().filter(|words| words[word]).count() <= 1;
        if parts.len() != 2 || !is_one(0) || !is_one(1) || parts.iter().all(|(part, _)| matches!(part.column, FieldVector::Same(_))) {
            return None;
        }
        let second = all.iter().position(|words| words[1])?;
        let [low, high] = [1 - second, second].map(|number| {
            let (part, _) = &parts[number];
            let by = part.at - at;
            match part.column {
                FieldVector::Same(number) => {
                    let moved = if by >= 0 { number << (8 * by) } else { number >> (-8 * by) };
                    self.all_words(moved)
                }
                FieldVector::Lanes(vector) => self.moved_column(vector, by),
            }
        });
        let words = self.shuffled(low, high, SECOND_WORDS);
        Some(FieldVector::Lanes(self.b.ins().bitcast(I32X4, little(), words)))
    }

    /// 32 bits of each iteration, so many bytes further on; nothing uses what comes from outside them.
    fn moved_column(&mut self, vector: Value, by: i32) -> Value {
        if by == 0 {
            return vector;
        }
        if let Some((of, bytes)) = self.shuffled_of(vector) {
            let place = |at: i32| bytes[(at / 4 * 4 + (at % 4 - by).clamp(0, 3)) as usize];
            let moved: Vec<u8> = (0..16).map(place).collect();
            let moved = self.shuffled(of, of, moved.try_into().expect("sixteen bytes"));
            return self.b.ins().bitcast(I32X4, little(), moved);
        }
        match by {
            1.. => self.b.ins().ishl_imm_u(vector, i64::from(8 * by)),
            _ => self.b.ins().ushr_imm_u(vector, i64::from(-8 * by)),
        }
    }

    /// Reads bytes of each iteration that are written as they are.
    fn read_as_it_is(&mut self, apart: Strided, from: i32, bytes: usize) -> Vec<Value> {
        let ty = [I8, I16, I32, I64, I8X16].into_iter().find(|ty| ty.bytes() as usize == bytes).expect("so many bytes at once");
        (0..ITERATIONS as i32).map(|lane| self.b.ins().load(ty, data(), apart.first.base, from + apart.step * lane)).collect()
    }

    /// Reads rows, as columns.
    fn read_rows(&mut self, apart: Strided, (start, bytes): LoadGroup) -> Vec<Value> {
        if (bytes, apart.step) == SIDE_BY_SIDE {
            let [a, b] = [0, 2].map(|lane| self.b.ins().load(I8X16, data(), apart.first.base, start + apart.step * lane));
            return [0, 1].map(|column| self.every_second(a, b, column)).to_vec();
        }
        let rows: Vec<Value> = (0..ITERATIONS as i32)
            .map(|lane| {
                let offset = start + apart.step * lane;
                if bytes == 16 {
                    return self.b.ins().load(I8X16, data(), apart.first.base, offset);
                }
                let row = self.b.ins().load(F64, data(), apart.first.base, offset);
                let row = self.b.ins().splat(F64X2, row);
                self.b.ins().bitcast(I8X16, little(), row)
            })
            .collect();
        let columns =
            if bytes == 16 { self.exchanged([rows[0], rows[1], rows[2], rows[3]]).to_vec() } else { self.columns_of_short_rows(&rows) };
        columns.into_iter().map(|column| self.b.ins().bitcast(I32X4, little(), column)).collect()
    }

    /// The first or second number of each of four rows of two, of which each vector has two.
    fn every_second(&mut self, a: Value, b: Value, number: u8) -> Value {
        let bytes: Vec<u8> = (0..4).flat_map(|row| (0..4).map(move |byte| row * 8 + number * 4 + byte)).collect();
        let column = self.shuffled(a, b, bytes.try_into().expect("sixteen bytes"));
        self.b.ins().bitcast(I32X4, little(), column)
    }

    /// Two numbers of each of four rows, as two columns.
    fn columns_of_short_rows(&mut self, rows: &[Value]) -> Vec<Value> {
        let [a, b] = [(0, 1), (2, 3)].map(|(first, second)| self.pairs(rows[first], rows[second], false));
        vec![self.halves_of(a, b, false), self.halves_of(a, b, true)]
    }

    /// Four rows of four numbers as columns, and the other way round.
    fn exchanged(&mut self, [a, b, c, d]: [Value; 4]) -> [Value; 4] {
        let [low_a, high_a] = [false, true].map(|high| self.pairs(a, b, high));
        let [low_c, high_c] = [false, true].map(|high| self.pairs(c, d, high));
        [
            self.halves_of(low_a, low_c, false),
            self.halves_of(low_a, low_c, true),
            self.halves_of(high_a, high_c, false),
            self.halves_of(high_a, high_c, true),
        ]
    }

    /// The first or last two numbers of each of two vectors, by iterations.
    fn pairs(&mut self, a: Value, b: Value, high: bool) -> Value {
        let first = if high { 8 } else { 0 };
        let number = |vector: u8, at: u8| (0..4).map(move |byte| vector * 16 + first + at * 4 + byte);
        let bytes: Vec<u8> = (0..2).flat_map(|at| number(0, at).chain(number(1, at))).collect();
        self.shuffled(a, b, bytes.try_into().expect("sixteen bytes"))
    }

    /// The first or last halves of two vectors.
    fn halves_of(&mut self, a: Value, b: Value, high: bool) -> Value {
        let first = if high { 8 } else { 0 };
        let bytes: Vec<u8> = (first..first + 8).chain(16 + first..24 + first).collect();
        self.shuffled(a, b, bytes.try_into().expect("sixteen bytes"))
    }

    /// Writes these bytes of each iteration.
    fn write_rows(&mut self, apart: Strided, range: Range<i32>, columns: &[FieldVector]) {
        let place = |lane: i32| range.start + apart.step * lane;
        let bytes = range.len();
        let base = apart.first.base;
        let all_same: Option<Vec<u8>> = columns
            .iter()
            .map(|column| if let FieldVector::Same(number) = column { Some(number.to_le_bytes()) } else { None })
            .collect::<Option<Vec<_>>>()
            .map(|all| all.concat());
        if let Some(same) = all_same {
            let ty = [I8, I16, I32, I64].into_iter().find(|ty| ty.bytes() as usize == bytes);
            let row = match ty {
                Some(ty) => {
                    let mut number = [0; 8];
                    number[..bytes].copy_from_slice(&same[..bytes]);
                    self.b.ins().iconst(ty, i64::from_le_bytes(number))
                }
                None => self.constant_vector(I8X16, same),
            };
            for lane in 0..ITERATIONS as i32 {
                self.b.ins().store(data(), row, base, place(lane));
            }
            return;
        }
        let columns: Vec<Value> = columns.iter().map(|&column| self.lanes_of_column(column)).collect();
        match (bytes, &columns[..]) {
            (16, &[a, b, c, d]) => {
                for (lane, row) in (0..).zip(self.exchanged([a, b, c, d])) {
                    self.b.ins().store(data(), row, base, place(lane));
                }
            }
            (8, &[a, b]) if (bytes as i32, apart.step) == SIDE_BY_SIDE => {
                for high in [false, true] {
                    let rows = self.pairs(a, b, high);
                    self.b.ins().store(data(), rows, base, place(2 * i32::from(high)));
                }
            }
            (8, &[a, b]) => {
                for high in [false, true] {
                    let rows = self.pairs(a, b, high);
                    let rows = self.b.ins().bitcast(F64X2, little(), rows);
                    for at in 0..2 {
                        let row = self.b.ins().extractlane(rows, at);
                        self.b.ins().store(data(), row, base, place(2 * i32::from(high) + i32::from(at)));
                    }
                }
            }
            (_, &[column]) => {
                for lane in 0..ITERATIONS as u8 {
                    let (ty, at) = match bytes {
                        1 => (I8X16, 4 * lane),
                        2 => (I16X8, 2 * lane),
                        // The lowest one is written out of the vector in one step as a REAL.
                        _ if lane == 0 => (F32X4, 0),
                        _ => (I32X4, lane),
                    };
                    let vector = if ty == I32X4 { column } else { self.b.ins().bitcast(ty, little(), column) };
                    let number = self.b.ins().extractlane(vector, at);
                    self.b.ins().store(data(), number, base, place(i32::from(lane)));
                }
            }
            _ => unreachable!("rows have one, two, or four columns"),
        }
    }
}
