//! What is drawn of each channel: its steps, and columns that know how often it changed in them.

use std::ops::RangeInclusive;

use super::axis::Axis;
use crate::names::{Kind, Sample};
use crate::trace::{Channel, Trace, TraceError};

/// How positions become columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Columns {
    /// How many there are.
    pub(super) count: usize,
    /// Positions that share a column; 1 unit of the axis or more.
    pub(super) positions: u64,
    /// Columns that those positions have, more than 1 only where `positions` is one unit.
    pub(super) columns: usize,
}

impl Columns {
    /// As many columns as a position unit has room for, or as few as needed to fit them all.
    pub(super) fn fit(axis: &Axis, room: usize, columns_max: usize) -> Self {
        let units = axis.span().div_ceil(axis.unit);
        let room_units = (room as u64).max(1);
        if units <= room_units {
            let columns = ((room_units / units) as usize).clamp(1, columns_max);
            return Self { count: units as usize * columns, positions: axis.unit, columns };
        }
        let positions = axis.unit.saturating_mul(super::axis::round_number(units.div_ceil(room_units)));
        Self { count: axis.span().div_ceil(positions) as usize, positions, columns: 1 }
    }

    /// The column in which a position lies.
    pub(super) fn of(&self, axis: &Axis, position: u64) -> usize {
        let from_start = position.saturating_sub(axis.start);
        let column = match self.columns {
            1 => from_start / self.positions,
            columns => (u128::from(from_start) * columns as u128 / u128::from(self.positions)) as u64,
        };
        usize::try_from(column).unwrap_or(usize::MAX).min(self.count - 1)
    }
}

/// A channel in one column.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Cell {
    /// The value at its end.
    pub(super) last: Sample,
    /// How often the channel changed in it.
    pub(super) changes: u32,
    /// The least and the greatest value that was reached in it.
    pub(super) extent: Option<(f64, f64)>,
}

impl Cell {
    /// Whether no single line can show what happened.
    pub(super) fn is_crowded(&self) -> bool {
        self.changes > 1
    }
}

/// A value that holds from a position on.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Step {
    pub(super) position: u64,
    pub(super) value: Sample,
}

/// What is drawn of a channel.
#[derive(Clone, Debug, Default)]
pub(super) struct Lane {
    /// One for each column.
    pub(super) cells: Vec<Cell>,
    /// Every value from the beginning on; empty if there are too many.
    pub(super) steps: Vec<Step>,
    /// Changes behind the beginning.
    pub(super) changes: u64,
    /// The least value on the scale of the channel.
    pub(super) low: Option<(f64, Sample)>,
    /// The greatest.
    pub(super) high: Option<(f64, Sample)>,
}

impl Lane {
    /// The least and the greatest value, if the channel has a scale and was at two places of it.
    pub(super) fn scale(&self, channel: &Channel) -> Option<Scale<'_>> {
        let (low, high) = (self.low.as_ref()?, self.high.as_ref()?);
        (channel.kind != Kind::Bit && low.0 < high.0).then_some(Scale { low: low.0, high: high.0, low_value: &low.1, high_value: &high.1 })
    }

    fn meet(&mut self, number: Option<f64>, value: &Sample) {
        let Some(number) = number else { return };
        if self.low.as_ref().is_none_or(|low| number < low.0) {
            self.low = Some((number, value.clone()));
        }
        if self.high.as_ref().is_none_or(|high| number > high.0) {
            self.high = Some((number, value.clone()));
        }
    }
}

/// The scale of a lane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale<'a> {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) low_value: &'a Sample,
    pub(super) high_value: &'a Sample,
}

impl Scale<'_> {
    /// Where a number lies: 0 at the least value, 1 at the greatest.
    pub(super) fn place(&self, number: f64) -> f64 {
        // The difference of two great LREAL is more than an f64 holds; their halves are not.
        let span = self.high / 2.0 - self.low / 2.0;
        ((number / 2.0 - self.low / 2.0) / span).clamp(0.0, 1.0)
    }
}

/// What is drawn of all channels, and their values at the cursors.
pub(super) struct Lanes {
    pub(super) lanes: Vec<Lane>,
    /// For each cursor the values of all channels.
    pub(super) cursors: Vec<Vec<Sample>>,
}

/// Goes through the scans of a range once.
pub(super) fn collect(
    trace: &Trace,
    range: &RangeInclusive<u64>,
    axis: &Axis,
    columns: Columns,
    steps_max: usize,
    cursors_us: &[u64],
) -> Result<Lanes, TraceError> {
    let channels = trace.channels();
    let mut lanes: Vec<Lane> = channels.iter().map(|_| Lane { cells: vec![Cell::default(); columns.count], ..Lane::default() }).collect();
    let mut begun = false;
    let mut state = vec![Sample::Absent; channels.len()];
    let mut cursors: Vec<Option<Vec<Sample>>> = vec![None; cursors_us.len()];
    trace.visit(range, &mut |scans| {
        let position = axis.position(scans.first);
        for (cursor, time_us) in cursors.iter_mut().zip(cursors_us) {
            if cursor.is_none() && begun && *time_us < scans.first.time_us {
                *cursor = Some(state.clone());
            }
        }
        let column = columns.of(axis, position);
        for &index in scans.changed {
            let (lane, value) = (&mut lanes[index], &scans.values[index]);
            let number = value.number(&channels[index].kind);
            lane.meet(number, value);
            if begun {
                lane.changes += 1;
            }
            if lane.changes as usize <= steps_max {
                lane.steps.push(Step { position, value: value.clone() });
            } else {
                lane.steps = Vec::new();
            }
            let cell = &mut lane.cells[column];
            cell.changes += u32::from(begun);
            cell.last = value.clone();
            if let Some(number) = number {
                let (low, high) = cell.extent.unwrap_or((number, number));
                cell.extent = Some((low.min(number), high.max(number)));
            }
            state[index] = value.clone();
        }
        begun = true;
        Ok(())
    })?;
    for lane in &mut lanes {
        let mut last = Sample::Absent;
        for (index, cell) in lane.cells.iter_mut().enumerate() {
            match cell.changes {
                0 if index > 0 => cell.last = last.clone(),
                _ => last = cell.last.clone(),
            }
        }
    }
    let cursors = cursors.into_iter().map(|cursor| cursor.unwrap_or_else(|| state.clone())).collect();
    Ok(Lanes { lanes, cursors })
}
