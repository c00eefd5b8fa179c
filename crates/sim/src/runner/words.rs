//! What each word of a test does.

use sieben_cpu::{Asked, OperatingMode};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::literal;
use sieben_model::testing::{Operand, Word, WordCall};
use sieben_model::types::DataType;

use super::{Run, ShownValue, Wrong};

/// Characters of a value that are shown.
const SHOWN_MAX: usize = 120;

fn wrong(message: impl Into<String>) -> Box<Wrong> {
    Box::new(Wrong { message: message.into(), ..Wrong::default() })
}

/// A value as a whole number.
fn whole(asked: &Asked, index: usize) -> i64 {
    i64::from_be_bytes(asked.values[index])
}

impl Run<'_> {
    pub(super) fn word(&mut self, call: &WordCall, asked: &Asked) -> Result<(), Box<Wrong>> {
        let word = call.word;
        match word {
            Word::ExpectStop => return self.expect_stop(whole(asked, 0)),
            Word::Scan => {
                self.unexpected_stop(Some(word.text()))?;
                return self.scans(call, whole(asked, 0));
            }
            Word::Start => {
                self.unexpected_stop(Some(word.text()))?;
                self.restart();
            }
            Word::Stop => {
                self.unexpected_stop(Some(word.text()))?;
                self.cpu.stop();
                self.expected_stop = true;
                self.own_stop = self.cpu.stop_cause().cloned();
            }
            Word::AdvanceTime => {
                self.unexpected_stop(Some(word.text()))?;
                let nanoseconds = whole(asked, 0);
                let Ok(nanoseconds) = u64::try_from(nanoseconds) else {
                    return Err(wrong(format!("time does not go back: {nanoseconds} ns")));
                };
                self.cpu.let_time_pass(nanoseconds / 1000);
                self.check_limits(Some(call.span))?;
            }
            Word::Mock | Word::MockFunction => {
                let Some((block, _)) = call.mocked else { return Ok(()) };
                let value = match word {
                    Word::MockFunction => u64::from_be_bytes(asked.values[1]) >> (64 - 8 * bytes_of_result(self, block)),
                    _ => 0,
                };
                self.cpu.mock(block, instance(block, asked), value);
            }
            Word::VerifyCalled | Word::VerifyCallCount => return self.verify(call, asked),
            _ => return Err(self.failed(call, asked)),
        }
        Ok(())
    }

    fn scans(&mut self, call: &WordCall, cycles: i64) -> Result<(), Box<Wrong>> {
        if cycles < 0 {
            return Err(wrong(format!("`SCAN` runs 0 or more cycles, not {cycles}")));
        }
        for _ in 0..cycles {
            self.scan();
            self.check_limits(Some(call.span))?;
        }
        Ok(())
    }

    fn expect_stop(&mut self, event: i64) -> Result<(), Box<Wrong>> {
        let Some(cause) = self.stopped.take().or_else(|| self.own_stop.take()) else {
            return Err(wrong(match self.cpu.mode() {
                OperatingMode::Stop => "the CPU has not gone to STOP again: it is still in the STOP that was expected before".to_owned(),
                mode => format!("the CPU has not gone to STOP: it is in {mode}"),
            }));
        };
        self.own_stop = None;
        self.expected_stop = true;
        if event == 0 || event == i64::from(cause.event) || event == i64::from(cause.first_event) {
            return Ok(());
        }
        let first = match cause.first_event {
            first if first != cause.event => format!(" (first 16#{first:04X})"),
            _ => String::new(),
        };
        let message = format!("the CPU went to STOP with event 16#{:04X}{first}, not 16#{event:04X}: {}", cause.event, cause.text);
        Err(Box::new(Wrong { place: cause.place, ..*wrong(message) }))
    }

    fn verify(&mut self, call: &WordCall, asked: &Asked) -> Result<(), Box<Wrong>> {
        let Some((block, name)) = &call.mocked else { return Ok(()) };
        let Some(calls) = self.cpu.mock_calls(*block, instance(*block, asked)) else {
            let how = match block.kind {
                BlockKind::Function | BlockKind::SystemFunction => format!("MOCK_FUNCTION {name} RETURNS 0;"),
                _ => format!("MOCK {name};"),
            };
            return Err(wrong(format!("`{name}` is not mocked: write `{how}` before it")));
        };
        match call.word {
            Word::VerifyCalled if calls == 0 => Err(wrong(format!("`{name}` was not called"))),
            Word::VerifyCallCount if i128::from(calls) != i128::from(whole(asked, 1)) => {
                let times = |count: i128| if count == 1 { "once".to_owned() } else { format!("{count} times") };
                let message = format!("`{name}` was called {}, not {}", times(i128::from(calls)), times(i128::from(whole(asked, 1))));
                Err(wrong(message))
            }
            _ => Ok(()),
        }
    }

    /// An assertion that does not hold.
    fn failed(&mut self, call: &WordCall, asked: &Asked) -> Box<Wrong> {
        let values: Vec<ShownValue> = call.operands.iter().enumerate().map(|(index, operand)| self.shown(operand, asked, index)).collect();
        let holds = match (call.word, values.as_slice()) {
            (Word::AssertTrue, [a]) => format!("`{}` is FALSE", a.expression),
            (Word::AssertFalse, [a]) => format!("`{}` is TRUE", a.expression),
            (word, [a, b, ..]) => compared(word, a, b, values.get(2)),
            _ => format!("`{}` does not hold", call.word.text()),
        };
        let stop = match self.stopped.take() {
            Some(cause) => {
                self.expected_stop = true;
                format!("; the CPU went to STOP before: {}", cause.text)
            }
            None => String::new(),
        };
        Box::new(Wrong { values, signals: call.signals.clone(), ..*wrong(format!("{holds}{stop}")) })
    }

    fn shown(&self, operand: &Operand, asked: &Asked, index: usize) -> ShownValue {
        let expression = self.sources.slice(operand.span).split_whitespace().collect::<Vec<_>>().join(" ");
        let Some(data_type) = &operand.data_type else {
            return ShownValue { value: expression.clone(), expression, data_type: String::new() };
        };
        let value = match (&asked.texts, asked.values.get(index)) {
            (Some(texts), _) => texts.get(index).map_or(String::new(), |text| quoted(text)),
            (None, Some(bytes)) => value(data_type, bytes, operand.bytes),
            (None, None) => String::new(),
        };
        let word = match data_type {
            DataType::String(_) => "STRING".to_owned(),
            other => other.to_string(),
        };
        // Where DATE and DT have 64 bits they are called so, and LDATE and LDT are types of their own.
        let is_short = self.cpu.program().names.short_dates && matches!(data_type, DataType::LongDate | DataType::LongDateAndTime);
        let called = |text: String| if is_short { text.trim_start_matches('L').to_owned() } else { text };
        let (value, word) = (called(value), called(word));
        ShownValue { expression, value, data_type: word }
    }
}

/// `a` is 5, not 7.
fn compared(word: Word, a: &ShownValue, b: &ShownValue, tolerance: Option<&ShownValue>) -> String {
    let of = |shown: &ShownValue| match shown.expression == shown.value || shown.data_type.is_empty() {
        true => format!("`{}`", shown.expression),
        false => format!("`{}` ({} = {})", shown.expression, shown.data_type, shown.value),
    };
    let typed = |shown: &ShownValue| match shown.data_type.is_empty() {
        true => shown.value.clone(),
        false => format!("{} ({})", shown.value, shown.data_type),
    };
    match word {
        Word::AssertEqual => format!("`{}` is {}, not {}", a.expression, typed(a), not(b, &of)),
        Word::AssertNotEqual => format!("`{}` is {}, the same as {}", a.expression, typed(a), not(b, &of)),
        Word::AssertNear => {
            let within = tolerance.map_or(String::new(), |tolerance| format!(" (± {})", tolerance.value));
            format!("`{}` is {}, which is not near {}{within}", a.expression, typed(a), not(b, &of))
        }
        other => format!("`{}` is {}, which is not {} {}", a.expression, typed(a), other.sign().unwrap_or_default(), not(b, &of)),
    }
}

/// The other side: a constant as it is written, else with its value.
fn not(shown: &ShownValue, of: &dyn Fn(&ShownValue) -> String) -> String {
    match shown.data_type.is_empty() {
        true => shown.expression.clone(),
        false => of(shown),
    }
}

/// Bytes that the result of a function was handed over in.
fn bytes_of_result(run: &Run<'_>, block: BlockId) -> u32 {
    let code = run.cpu.program().code.get(&block);
    let interface = match code {
        Some(code) => Some(code.interface.clone()),
        None => sieben_cpu::system::interfaces().into_iter().find(|system| system.block == block).map(|system| system.interface),
    };
    let width = interface.and_then(|interface| sieben_cpu::system::result_width(&interface));
    width.map_or(4, sieben_model::address::Width::bytes)
}

/// The instance that a question is about: data block and first byte.
fn instance(block: BlockId, asked: &Asked) -> Option<(u16, u32)> {
    let address = u64::from_be_bytes(asked.values[0]);
    let first = (address as u32 & 0x00FF_FFFF) >> 3;
    matches!(block.kind, BlockKind::FunctionBlock | BlockKind::SystemFunctionBlock).then_some(((address >> 32) as u16, first))
}

/// A value of an elementary type.
fn value(data_type: &DataType, bytes: &[u8; 8], length: u8) -> String {
    let wide = u64::from_be_bytes(*bytes);
    let length = u32::from(length.clamp(1, 8));
    let bits = wide >> (64 - 8 * length);
    let bits = match data_type.bits() {
        1 => return if bits & 1 == 1 { "TRUE" } else { "FALSE" }.to_owned(),
        width @ 2..64 => bits & ((1 << width) - 1),
        _ => bits,
    };
    if let DataType::Enumeration(enumeration) = data_type {
        let number = literal::format_as(&enumeration.base, bits);
        let named = enumeration.values.iter().find(|(_, value)| value.to_string() == number);
        return named.map_or(number, |(name, _)| name.clone());
    }
    match data_type.base() {
        DataType::Real => format!("{:?}", f32::from_bits(bits as u32)),
        DataType::LongReal => format!("{:?}", f64::from_bits(bits)),
        base => literal::format_as(base, bits),
    }
}

/// A text between apostrophes.
fn quoted(text: &[u8]) -> String {
    let characters: String = text.iter().take(SHOWN_MAX).map(|&byte| char::from(byte)).collect();
    let more = if text.len() > SHOWN_MAX { format!("… ({} characters)", text.len()) } else { String::new() };
    format!("'{}'{more}", characters.escape_debug().to_string().replace("\\'", "$'").replace("\\\"", "\""))
}
