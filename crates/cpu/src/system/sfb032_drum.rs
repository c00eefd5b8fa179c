//! SFB 32 DRUM: a step sequencer of up to 16 steps.

use sieben_model::interface::Section;
use sieben_model::types::DataType;

use super::instance::Instance;
use super::{Call, Parameter, Row, input, made, output, sfb, stored};

pub(super) const ROW: Row = sfb(32, "DRUM", VARIABLES, run);

const VARIABLES: &[Parameter] = &[
    input("RESET", DataType::Bool),
    input("JOG", DataType::Bool),
    input("DRUM_EN", DataType::Bool),
    input("LST_STEP", DataType::Byte),
    input("EVENT1", DataType::Bool),
    input("EVENT2", DataType::Bool),
    input("EVENT3", DataType::Bool),
    input("EVENT4", DataType::Bool),
    input("EVENT5", DataType::Bool),
    input("EVENT6", DataType::Bool),
    input("EVENT7", DataType::Bool),
    input("EVENT8", DataType::Bool),
    input("EVENT9", DataType::Bool),
    input("EVENT10", DataType::Bool),
    input("EVENT11", DataType::Bool),
    input("EVENT12", DataType::Bool),
    input("EVENT13", DataType::Bool),
    input("EVENT14", DataType::Bool),
    input("EVENT15", DataType::Bool),
    input("EVENT16", DataType::Bool),
    output("OUT0", DataType::Bool),
    output("OUT1", DataType::Bool),
    output("OUT2", DataType::Bool),
    output("OUT3", DataType::Bool),
    output("OUT4", DataType::Bool),
    output("OUT5", DataType::Bool),
    output("OUT6", DataType::Bool),
    output("OUT7", DataType::Bool),
    output("OUT8", DataType::Bool),
    output("OUT9", DataType::Bool),
    output("OUT10", DataType::Bool),
    output("OUT11", DataType::Bool),
    output("OUT12", DataType::Bool),
    output("OUT13", DataType::Bool),
    output("OUT14", DataType::Bool),
    output("OUT15", DataType::Bool),
    output("Q", DataType::Bool),
    output("OUT_WORD", DataType::Word),
    output("ERR_CODE", DataType::Word),
    stored("JOG_HIS", DataType::Bool),
    stored("EOD", DataType::Bool),
    stored("DSP", DataType::Byte),
    stored("DSC", DataType::Byte),
    stored("DCC", DataType::DoubleWord),
    stored("DTBP", DataType::Word),
    stored("PREV_TIME", DataType::DoubleWord),
    made("S_PRESET", Section::Static, presets),
    made("OUT_VAL", Section::Static, step_bits),
    made("S_MASK", Section::Static, step_bits),
];

const RESET: u8 = 0;
const JOG: u8 = 1;
const DRUM_EN: u8 = 2;
const LST_STEP: usize = 1;
const EVENTS: usize = 2;
const OUTPUTS: usize = 4;
const Q: usize = 6;
const OUT_WORD: usize = 8;
const ERR_CODE: usize = 10;
/// JOG_HIS and EOD.
const HISTORY: usize = 12;
const EOD: u8 = 1;
const DSP: usize = 13;
const DSC: usize = 14;
const DCC: usize = 16;
const DTBP: usize = 20;
const PREV_TIME: usize = 22;
const S_PRESET: usize = 26;
const OUT_VAL: usize = 58;
const S_MASK: usize = 90;
const BYTES: u32 = 122;

const STEPS: u8 = 16;
const BAD_LAST_STEP: u16 = 0x8081;
const BAD_CURRENT_STEP: u16 = 0x8082;
const BAD_DEFAULT_STEP: u16 = 0x8083;
const TOO_LONG: u16 = 0x8084;

fn presets() -> DataType {
    DataType::Array { bounds: vec![(1, 16)], element: Box::new(DataType::Word) }
}

fn step_bits() -> DataType {
    DataType::Array { bounds: vec![(1, 16), (0, 15)], element: Box::new(DataType::Bool) }
}

fn run(call: &mut Call<'_, '_>) -> bool {
    let Some(mut instance) = Instance::open(call.machine, BYTES) else { return false };
    let answer = step(&mut instance);
    instance.set_word(ERR_CODE, answer.err().unwrap_or(0));
    answer.is_ok()
}

/// One call. After an error everything but ERR_CODE stays as it was.
fn step(instance: &mut Instance<'_>) -> Result<(), u16> {
    let last = instance.byte(LST_STEP);
    let valid = |step: u8| (1..=last).contains(&step);
    if !(1..=STEPS).contains(&last) {
        return Err(BAD_LAST_STEP);
    }
    let start = instance.byte(DSP);
    if !valid(start) {
        return Err(BAD_DEFAULT_STEP);
    }
    let reset = instance.bit(0, RESET);
    let mut current = if reset { start } else { instance.byte(DSC) };
    if !valid(current) {
        return Err(BAD_CURRENT_STEP);
    }
    let jogged = instance.bit(0, JOG) && !instance.bit(HISTORY, 0);
    let now = instance.now() as u32;
    let passed = now.wrapping_sub(instance.double_word(PREV_TIME)) & i32::MAX as u32;
    let mut left = instance.double_word(DCC);
    let mut ended = !reset && instance.bit(HISTORY, EOD);
    if reset {
        left = duration(instance, start)?;
    } else if !ended {
        let enabled = instance.bit(0, DRUM_EN);
        if enabled {
            left = left.saturating_sub(passed);
        }
        let event = instance.bit(EVENTS + usize::from(current - 1) / 8, (current - 1) % 8);
        if jogged || (enabled && left == 0 && event) {
            if current == last {
                ended = true;
                left = 0;
            } else {
                current += 1;
                left = duration(instance, current)?;
            }
        }
    }
    let bit = instance.bit(0, JOG);
    instance.set_bit(HISTORY, 0, bit);
    instance.set_bit(HISTORY, EOD, ended);
    instance.set_bit(Q, 0, ended);
    instance.set_byte(DSC, current);
    instance.set_double_word(DCC, left);
    instance.set_double_word(PREV_TIME, now);
    outputs(instance, current);
    Ok(())
}

/// How long a step lasts, in milliseconds.
fn duration(instance: &Instance<'_>, step: u8) -> Result<u32, u16> {
    let preset = instance.word(S_PRESET + usize::from(step - 1) * 2);
    let duration = u32::from(instance.word(DTBP)) * u32::from(preset);
    if duration > i32::MAX as u32 { Err(TOO_LONG) } else { Ok(duration) }
}

/// The outputs of a step: its values where its mask is 1; the others stay.
fn outputs(instance: &mut Instance<'_>, step: u8) {
    let row = usize::from(step - 1) * 2;
    let mut word = 0;
    for output in 0..16_u8 {
        let (byte, bit) = (usize::from(output / 8), output % 8);
        if instance.bit(S_MASK + row + byte, bit) {
            let value = instance.bit(OUT_VAL + row + byte, bit);
            instance.set_bit(OUTPUTS + byte, bit, value);
        }
        word |= u16::from(instance.bit(OUTPUTS + byte, bit)) << output;
    }
    instance.set_word(OUT_WORD, word);
}
