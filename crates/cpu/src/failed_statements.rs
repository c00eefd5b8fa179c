//! Statements that failed while the program went on: how many, and which was the first.

use sieben_engine::FaultPlace;
use sieben_engine::fault::lost;

use crate::clock::DateAndTime;
use crate::diagnostic_buffer::DiagnosticEntry;
use crate::start_information::StartInformation;

/// One of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FailedStatement {
    fields: StartInformation,
    /// The statement.
    pub place: FaultPlace,
    /// The scan, counted from 0 since the last restart; `None` = before the first one.
    pub scan: Option<u64>,
}

impl FailedStatement {
    /// What was wrong, without the place.
    pub fn text(&self) -> String {
        let StartInformation { event, info_1, .. } = self.fields;
        match event.to_be_bytes() {
            [0x25, lost::QUOTIENT] if info_1 == 0 => "division by 0".to_owned(),
            [0x25, lost::QUOTIENT] => "a quotient that does not fit its type".to_owned(),
            [0x25, lost::OVERFLOW] => "overflow: the result does not fit its type".to_owned(),
            [0x25, lost::NO_NUMBER] => "the result is infinite or no number".to_owned(),
            [0x25, lost::CONVERSION] => "a value for which there is no result, or none that fits its type".to_owned(),
            [0x25, lost::STEP] => "a FOR with a step of 0 is left out".to_owned(),
            [0x25, lost::CHARACTER] => "a character that a STRING does not know".to_owned(),
            // Here it stands without the width of an access: what was looked at is the index.
            [0x25, 0x22 | 0x23] if self.fields.data_id & 0xFF == 0 => format!("index {} is outside its array", info_1 as i16),
            _ => DiagnosticEntry { fields: self.fields, time: DateAndTime::DEFAULT, place: None }.text(),
        }
    }
}

/// Statements that failed since the CPU was loaded, without those whose error the program masks or handles itself, and without the one
/// that led to STOP.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FailedStatements {
    /// How often one failed: one that fails in each scan counts each time, and two indexes of one statement count twice.
    pub count: u64,
    /// The first one.
    pub first: Option<Box<FailedStatement>>,
}

impl FailedStatements {
    /// Takes in one more; `number` is how many scans have begun.
    pub(crate) fn add(&mut self, fields: StartInformation, place: FaultPlace, number: u64) {
        self.count = self.count.saturating_add(1);
        self.first.get_or_insert_with(|| Box::new(FailedStatement { fields, place, scan: number.checked_sub(1) }));
    }
}
