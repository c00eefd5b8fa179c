//! The words of test files: what they are given, and the question to the CPU that each becomes.

use sieben_model::address::{Address, Area, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Section;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::testing::{HOLD_INPUT, Operand, SET_INPUT, Signal, TEXTS, TOLERANCE, WORD, Word, WordCall};
use sieben_model::types::DataType;

use super::calls::Called;
use super::places::Reached;
use super::typed::{Target, Typed};
use super::types::{Class, Kind};
use super::{Checker, operators};
use crate::st::ast::{self, BinaryOperator, Expression, ExpressionKind, LiteralKind, Name, Quoting};
use crate::st::tree::{Argument, Base, Call, Callee, Place, Scalar, Statement, StatementKind, Text, TextRoom, Value, ValueKind};

/// Nanoseconds of a millisecond.
const MILLISECOND: i64 = 1_000_000;
/// The name of an instance, as a number: the data block above, the pointer below.
const ADDRESS: Scalar = Scalar::U64;

/// What a word asks of the CPU.
#[derive(Default)]
struct Question {
    /// Statements before it.
    before: Vec<Statement>,
    /// Whether the assertion holds.
    holds: Option<Value>,
    /// Its values, three at most.
    values: Vec<Value>,
    /// What the plan says about them.
    operands: Vec<Operand>,
    signals: Vec<Signal>,
    mocked: Option<(BlockId, String)>,
}

impl Checker<'_> {
    /// The word of a test that a call of a name nobody has declared is.
    pub(super) fn test_word(&self, name: &Name) -> Option<Word> {
        Word::find(&name.text).filter(|_| self.dialect.is_test() && name.quoting == Quoting::Bare)
    }

    /// Says that a word of tests stands where none can.
    pub(super) fn misplaced_word(&mut self, name: &Name) -> bool {
        let Some(word) = Word::find(&name.text) else { return false };
        match self.dialect.is_test() {
            true => {
                let message = format!("`{}` is a statement of its own: it has no value", word.text());
                self.report(Problem::P2305, name.span, message).help = Some(format!("Write `{};`.", word.usage().trim_end_matches(';')));
            }
            false => {
                let message = format!("`{}` is a word of test files", word.text());
                self.report(Problem::P2304, name.span, message).help =
                    Some("Write it in a file whose name ends with `.test.st`, and run that with `sieben test`.".to_owned());
            }
        }
        true
    }

    /// A word of tests as a statement.
    pub(super) fn test_statement(&mut self, word: Word, call: &ast::Call, span: Span) -> Option<StatementKind> {
        let (arguments, message) = self.word_arguments(word, call, span)?;
        let mut question = Question::default();
        let asked = match (word, arguments.as_slice()) {
            (Word::AssertTrue | Word::AssertFalse, [a]) => self.assert_bool(word, a, &mut question),
            (Word::AssertNear, [a, b, tolerance @ ..]) => self.assert_near(a, b, tolerance.first().copied(), span, &mut question),
            (Word::Scan, []) => self.constant_value(1, &mut question, span),
            (Word::Scan, [cycles]) => self.plain(cycles, &DataType::DoubleInt, &mut question),
            (Word::AdvanceTime, [time]) => self.time(time, &mut question),
            (Word::Start | Word::Stop, []) => Some(()),
            (Word::ExpectStop, []) => self.constant_value(0, &mut question, span),
            (Word::ExpectStop, [event]) => self.event(event, &mut question),
            (Word::Mock | Word::VerifyCalled, [what]) => self.mocked(word, what, &mut question),
            (Word::MockFunction, [what, value @ ..]) => self.mock_function(what, value.first().copied(), &mut question),
            (Word::VerifyCallCount, [what, count]) => {
                self.mocked(word, what, &mut question)?;
                self.plain(count, &DataType::DoubleInt, &mut question)
            }
            (_, [a, b]) => {
                let row = self.row(word, span, message.clone(), &question);
                if let Some(texts) = self.assert_texts(word, a, b, row, span) {
                    return texts;
                }
                self.assert_compare(word, a, b, &mut question)
            }
            _ => None,
        };
        asked?;
        if self.failed {
            return None;
        }
        let row = self.row(word, span, message, &question);
        Some(self.ask(row, question, span))
    }

    /// Takes in a row of the plan; its number.
    fn row(&mut self, word: Word, span: Span, message: Option<String>, question: &Question) -> u32 {
        let Question { operands, signals, mocked, .. } = question;
        let call = WordCall { word, span, message, operands: operands.clone(), signals: signals.clone(), mocked: mocked.clone() };
        self.words.insert(span.start, call);
        span.start
    }

    /// The arguments of a word and its message.
    fn word_arguments<'c>(&mut self, word: Word, call: &'c ast::Call, span: Span) -> Option<(Vec<&'c Expression>, Option<String>)> {
        let (least, most) = word.parameters();
        let mut arguments = Vec::with_capacity(call.arguments.len());
        for argument in &call.arguments {
            match (&argument.name, &argument.value) {
                (None, Some(value)) => arguments.push(value),
                _ => {
                    let message = format!("the parameters of `{}` have no names", word.text());
                    self.report(Problem::P2305, argument.span, message).help = Some(format!("Write `{}`.", word.usage()));
                    return None;
                }
            }
        }
        let mut message = None;
        if word.takes_message()
            && arguments.len() > least
            && let Some(text) = arguments.last().and_then(|last| message_text(last))
        {
            message = Some(text);
            arguments.pop();
        }
        if arguments.len() < least || arguments.len() > most {
            let wanted = match (least, most) {
                (0, 0) => "no parameter".to_owned(),
                (least, most) if least == most => super::calls::counted(least, "parameter"),
                (least, most) => format!("{least} to {most} parameters"),
            };
            let more = if word.takes_message() { ", and a message in quotes" } else { "" };
            let said = format!(
                "`{}` takes {wanted}{more}; here {} {}",
                word.text(),
                if arguments.len() == 1 { "is" } else { "are" },
                arguments.len()
            );
            self.report(Problem::P2305, span, said).help = Some(format!("Write `{}`.", word.usage()));
            return None;
        }
        Some((arguments, message))
    }

    /// The call that asks.
    fn ask(&mut self, row: u32, question: Question, span: Span) -> StatementKind {
        let Question { before: mut statements, holds, values, .. } = question;
        let number = |value: u64, scalar| Value { kind: ValueKind::Constant(value), scalar, span };
        let holds = holds.unwrap_or_else(|| number(0, Scalar::Bool));
        let mut arguments = vec![
            Argument::Value { parameter: 0, value: number(u64::from(row), Scalar::U32) },
            Argument::Value { parameter: 1, value: holds },
        ];
        arguments.extend((2..).zip(values).map(|(parameter, value)| Argument::Value { parameter, value }));
        statements.push(call_of(WORD, arguments, span));
        StatementKind::Block(statements)
    }

    /// Keeps a value of an operand and notes what it is.
    fn keep(&mut self, typed: Typed, expression: &Expression, question: &mut Question) -> Typed {
        match typed {
            Typed::Scalar { value, data_type } => {
                let bytes = value.scalar.bits().div_ceil(8) as u8;
                question.operands.push(Operand { span: expression.span, data_type: Some(data_type.clone()), bytes });
                self.signals(expression, question);
                let (statement, load) = self.kept(value);
                question.before.push(statement);
                question.values.push(load.clone());
                Typed::Scalar { value: load, data_type }
            }
            other => {
                // A literal says its value; what is computed of constants does not.
                let literal = matches!(expression.kind, ExpressionKind::Literal(_));
                let shown = if literal { None } else { shown_constant(&other) };
                let (data_type, scalar, bits) =
                    shown.map_or((None, Scalar::U32, 0), |(data_type, scalar, bits)| (Some(data_type), scalar, bits));
                question.operands.push(Operand { span: expression.span, data_type, bytes: scalar.bits().div_ceil(8) as u8 });
                question.values.push(Value { kind: ValueKind::Constant(bits), scalar, span: expression.span });
                other
            }
        }
    }

    /// What an expression reads at constant addresses.
    fn signals(&mut self, expression: &Expression, question: &mut Question) {
        let mut found: Vec<Expression> = Vec::new();
        super::walk::expression(expression, &mut |part| {
            let reads = matches!(
                part.kind,
                ExpressionKind::Name(_)
                    | ExpressionKind::Global(_)
                    | ExpressionKind::Address(_)
                    | ExpressionKind::Member(..)
                    | ExpressionKind::DataAddress(_)
            );
            // The parts of a path are no signals of their own.
            let inside = |outer: &Expression| outer.span.start <= part.span.start && part.span.end <= outer.span.end;
            if reads && !found.iter().any(inside) {
                found.push(part.clone());
            }
        });
        for part in found {
            let reached = self.quietly(|checker| checker.reach(&part));
            let Reached::Target(Target { place, data_type, .. }) = reached else { continue };
            if let Some(signal) = signal(&place, &data_type, String::new()) {
                let signal = Signal { name: self.source_text(&part), ..signal };
                if !question.signals.contains(&signal) {
                    question.signals.push(signal);
                }
            }
        }
    }

    /// How a path is written; addresses and names carry their text.
    fn source_text(&self, expression: &Expression) -> String {
        match &expression.kind {
            ExpressionKind::Name(name) | ExpressionKind::Global(name) => name.text.clone(),
            ExpressionKind::Address(address) => {
                let percent = if address.percent { "%" } else { "" };
                format!("{percent}{}{}", address.written.text, bit_of(&address.position))
            }
            ExpressionKind::Member(base, name) => format!("{}.{}", self.source_text(base), name.text),
            ExpressionKind::DataAddress(address) => {
                format!("{}.{}{}", self.source_text(&address.block), address.written.text, bit_of(&address.position))
            }
            ExpressionKind::Parenthesized(inner) => self.source_text(inner),
            _ => String::new(),
        }
    }

    fn assert_bool(&mut self, word: Word, a: &Expression, question: &mut Question) -> Option<()> {
        let value = self.condition(a)?;
        let typed = self.keep(Typed::Scalar { value, data_type: DataType::Bool }, a, question);
        let Typed::Scalar { value, .. } = typed else { return None };
        question.holds = Some(match word {
            Word::AssertTrue => value,
            _ => operators::compute(operators::inversion(Scalar::Bool)?, vec![value], Scalar::Bool),
        });
        Some(())
    }

    fn assert_compare(&mut self, word: Word, a: &Expression, b: &Expression, question: &mut Question) -> Option<()> {
        let operator = operator(word)?;
        let (left, right) = self.both(a, b);
        if left == Typed::Poison || right == Typed::Poison {
            return None;
        }
        let (left, right) = self.addresses_as_other(a, left, b, right);
        let left = self.keep(left, a, question);
        let right = self.keep(right, b, question);
        let sign = Span { end: b.span.start, start: a.span.end, ..a.span };
        match self.comparison(operator, sign, (left, a.span), (right, b.span)) {
            Typed::Scalar { value, .. } => {
                question.holds = Some(value);
                Some(())
            }
            _ => None,
        }
    }

    /// In a test an address has the type of what stands beside it: `ASSERT_EQ(%MW10, -3)`.
    fn addresses_as_other(&self, a: &Expression, left: Typed, b: &Expression, right: Typed) -> (Typed, Typed) {
        let (of_left, of_right) = (self.type_beside(&left), self.type_beside(&right));
        (self.address_as(a, left, of_right), self.address_as(b, right, of_left))
    }

    /// The same for an assignment, on either side of it.
    pub(super) fn beside_address(&mut self, target: Target, written: &Expression, value: &Expression, typed: Typed) -> (Target, Typed) {
        if !self.dialect.is_test() {
            return (target, typed);
        }
        if let Some(signal) = signal(&target.place, &target.data_type, String::new()) {
            self.writes.insert(written.span.start, Signal { name: self.source_text(written), ..signal });
        }
        let wanted = Some(target.data_type.clone());
        let typed = self.address_as(value, typed, wanted);
        match self.type_beside(&typed) {
            Some(other) if is_address(written) && fits(&target.data_type, &other) => (Target { data_type: other, ..target }, typed),
            _ => (target, typed),
        }
    }

    /// The type that a value gives to an address beside it: a decimal number that of an INT or DINT, one in hex none.
    fn type_beside(&self, typed: &Typed) -> Option<DataType> {
        match typed {
            Typed::Scalar { data_type, .. } => Some(data_type.clone()),
            Typed::Integer { value, radix: 10 } if i16::try_from(*value).is_ok() => Some(DataType::Int),
            Typed::Integer { value, radix: 10 } if i32::try_from(*value).is_ok() => Some(DataType::DoubleInt),
            Typed::Real { .. } => Some(DataType::Real),
            _ => None,
        }
    }

    /// The value at an address, as one of another type with as many bits.
    fn address_as(&self, expression: &Expression, typed: Typed, other: Option<DataType>) -> Typed {
        match (typed, other) {
            (Typed::Scalar { value, data_type }, Some(other)) if is_address(expression) => {
                // A small number beside a double word is a DINT.
                let other = if other == DataType::Int && data_type == DataType::DoubleWord { DataType::DoubleInt } else { other };
                match Kind::of(&other).filter(|_| fits(&data_type, &other)) {
                    Some(kind) => Typed::Scalar { value: Value { scalar: kind.scalar(self.dialect), ..value }, data_type: other },
                    None => Typed::Scalar { value, data_type },
                }
            }
            (typed, _) => typed,
        }
    }

    /// A comparison of texts; `None` if it is none. The texts are handed over only where it does not hold.
    fn assert_texts(&mut self, word: Word, a: &Expression, b: &Expression, row: u32, span: Span) -> Option<Option<StatementKind>> {
        let texts = |typed: &Typed| matches!(typed, Typed::Text(_));
        let (left, right) = self.quietly(|checker| checker.both(a, b));
        let long = |typed: &Typed| matches!(typed, Typed::Text(text @ (Text::Constant(_) | Text::WideConstant(_))) if text.room().characters_max != 1);
        let variable = |typed: &Typed| matches!(typed, Typed::Text(text) if !matches!(text, Text::Constant(_) | Text::WideConstant(_)));
        if !(texts(&left) || texts(&right)) || !(long(&left) || long(&right) || variable(&left) || variable(&right)) {
            return None;
        }
        let (left, right) = self.both(a, b);
        let operator = operator(word)?;
        let Typed::Scalar { value, .. } = self.comparison(operator, a.span, (left.clone(), a.span), (right.clone(), b.span)) else {
            return Some(None);
        };
        let (Some(left), Some(right)) = (self.text(left, a.span), self.text(right, b.span)) else { return Some(None) };
        let narrow = |text: Text| if text.is_wide() { Text::Converted(Box::new(text)) } else { text };
        let (left, right) = (narrow(left), narrow(right));
        let mut question = Question::default();
        for one in [a, b] {
            question.operands.push(Operand { span: one.span, data_type: Some(DataType::String(254)), bytes: 0 });
        }
        if let Some(call) = self.words.get_mut(&row) {
            call.operands = question.operands;
        }
        let failed = operators::compute(operators::inversion(Scalar::Bool)?, vec![value], Scalar::Bool);
        let row = Value { kind: ValueKind::Constant(u64::from(row)), scalar: Scalar::U32, span };
        let arguments = vec![
            Argument::Value { parameter: 0, value: row },
            Argument::Text { parameter: 1, text: left, room: TextRoom::narrow(254) },
            Argument::Text { parameter: 2, text: right, room: TextRoom::narrow(254) },
        ];
        let call = call_of(TEXTS, arguments, span);
        Some(Some(StatementKind::If { branches: vec![(failed, vec![call])], otherwise: Vec::new() }))
    }

    fn assert_near(
        &mut self,
        a: &Expression,
        b: &Expression,
        tolerance: Option<&Expression>,
        span: Span,
        question: &mut Question,
    ) -> Option<()> {
        let mut numbers = Vec::with_capacity(3);
        let mut kinds: Vec<Kind> = Vec::with_capacity(3);
        for expression in [Some(a), Some(b), tolerance].into_iter().flatten() {
            let typed = self.expression(expression);
            if typed == Typed::Poison {
                return None;
            }
            let literal = matches!(typed, Typed::Integer { .. } | Typed::Real { .. });
            let kept = self.keep(typed, expression, question);
            let (value, data_type) = self.scalar(kept, expression.span)?;
            let kind = Kind::of(&data_type).filter(|kind| kind.is_number() || kind.class == Class::Duration);
            let Some(kind) = kind else {
                let message = format!("`ASSERT_NEAR` compares numbers and durations, not {}", self.words(&data_type));
                self.report(Problem::P2305, expression.span, message).help = Some("Write `ASSERT_EQ(a, b)`.".to_owned());
                return None;
            };
            if let Some(first) = kinds.first()
                && (first.class == Class::Duration || kind.class == Class::Duration)
                && (first.class, first.bits) != (kind.class, kind.bits)
            {
                let message = format!(
                    "`ASSERT_NEAR` compares values of one kind, not {} with {}",
                    self.words(&first.data_type()),
                    self.words(&data_type)
                );
                self.report(Problem::P2305, expression.span, message);
                return None;
            }
            if !literal || kinds.is_empty() {
                kinds.push(kind);
            }
            numbers.push(operators::convert(value, Scalar::F64));
        }
        let tolerance = match numbers.get(2) {
            Some(value) => value.clone(),
            None => Value { kind: ValueKind::Constant(TOLERANCE.to_bits()), scalar: Scalar::F64, span },
        };
        let (a, b) = (numbers.first()?.clone(), numbers.get(1)?.clone());
        let (minus, _) = operators::binary(BinaryOperator::Subtract, Scalar::F64)?;
        let (at_most, _) = operators::binary(BinaryOperator::LessEqual, Scalar::F64)?;
        let (and, _) = operators::binary(BinaryOperator::And, Scalar::Bool)?;
        let within = |x: Value, y: Value| {
            let difference = operators::compute(minus, vec![x, y], Scalar::F64);
            operators::compute(at_most, vec![difference, tolerance.clone()], Scalar::Bool)
        };
        let both = vec![within(a.clone(), b.clone()), within(b, a)];
        question.holds = Some(operators::compute(and, both, Scalar::Bool));
        Some(())
    }

    fn constant_value(&mut self, value: u64, question: &mut Question, span: Span) -> Option<()> {
        question.values.push(Value { kind: ValueKind::Constant(value), scalar: Scalar::I64, span });
        Some(())
    }

    /// A whole number.
    fn plain(&mut self, expression: &Expression, data_type: &DataType, question: &mut Question) -> Option<()> {
        let value = self.value(expression, data_type)?;
        question.values.push(operators::convert(value, Scalar::I64));
        Some(())
    }

    /// A duration, as nanoseconds.
    fn time(&mut self, expression: &Expression, question: &mut Question) -> Option<()> {
        let typed = self.expression(expression);
        if let Typed::Integer { value, .. } = typed {
            let nanoseconds = u64::try_from(value).ok().filter(|&value| i64::try_from(value).is_ok());
            let Some(nanoseconds) = nanoseconds else {
                self.report(Problem::P2305, expression.span, "time goes on by 0 to 9223372036854775807 nanoseconds");
                return None;
            };
            return self.constant_value(nanoseconds, question, expression.span);
        }
        let (value, data_type) = self.scalar(typed, expression.span)?;
        let kind = Kind::of(&data_type);
        let wide = operators::convert(value, Scalar::I64);
        let nanoseconds = match kind {
            Some(Kind { class: Class::Duration, bits: 64 }) => wide,
            Some(Kind { class: Class::Duration, .. }) => {
                let factor = Value { kind: ValueKind::Constant(MILLISECOND as u64), scalar: Scalar::I64, span: expression.span };
                let (times, _) = operators::binary(BinaryOperator::Multiply, Scalar::I64)?;
                operators::compute(times, vec![wide, factor], Scalar::I64)
            }
            Some(kind) if kind.is_integer() => wide,
            _ => {
                let message = format!("`ADVANCE_TIME` takes a duration, or a whole number of nanoseconds, not {}", self.words(&data_type));
                self.report(Problem::P2305, expression.span, message).help = Some("Write `ADVANCE_TIME(T#5s)`.".to_owned());
                return None;
            }
        };
        question.values.push(nanoseconds);
        Some(())
    }

    /// The event of a STOP: a number, or any.
    fn event(&mut self, expression: &Expression, question: &mut Question) -> Option<()> {
        if let Some(text) = message_text(expression) {
            if text.eq_ignore_ascii_case("any") {
                return self.constant_value(0, question, expression.span);
            }
            let message = format!("`{text}` is no event; a STOP is expected with its number, or with 'any'");
            self.report(Problem::P2305, expression.span, message).help = Some("Write `EXPECT_STOP(16#4562)`.".to_owned());
            return None;
        }
        let typed = self.expression(expression);
        let (value, data_type) = self.scalar(typed, expression.span)?;
        if !Kind::of(&data_type).is_some_and(|kind| kind.is_integer() || kind.class == Class::Bits && kind.bits > 1) {
            let message = format!("the event of a STOP is a number such as 16#4562, not {}", self.words(&data_type));
            self.report(Problem::P2305, expression.span, message);
            return None;
        }
        question.values.push(operators::convert(value, Scalar::I64));
        Some(())
    }

    /// The instance or function that MOCK and its like name.
    fn mocked(&mut self, word: Word, expression: &Expression, question: &mut Question) -> Option<()> {
        let before = self.diagnostics.len();
        let text = self.source_text(expression);
        let called = self.quietly(|checker| checker.called(expression));
        match called {
            Called::Instance(block, target, _) => {
                let value = Value { kind: ValueKind::AddressOf(target.place), scalar: ADDRESS, span: expression.span };
                question.values.push(value);
                question.mocked = Some((block, text));
                Some(())
            }
            Called::Function(block) if word != Word::Mock => {
                self.constant_value(0, question, expression.span)?;
                question.mocked = Some((block, text));
                Some(())
            }
            Called::Function(_) => {
                let message = format!("`{text}` is a function and has no instance");
                self.report(Problem::P2306, expression.span, message).help = Some(format!("Write `MOCK_FUNCTION {text} RETURNS 0;`."));
                None
            }
            Called::Standard(name) if Word::find(&name.text).is_none() && self.names.global(&name.text).is_none() => {
                // A name that nobody knows, or a function of the language.
                let known = self.quietly(|checker| checker.reach(expression));
                let unknown = matches!(known, Reached::Other(Typed::Poison));
                if unknown && crate::st::standard::resolve(&name.text, self.dialect, &[]).is_none() {
                    self.reach(expression);
                } else {
                    let message = format!("`{}` is part of the language: only blocks can be mocked", name.text);
                    self.report(Problem::P2306, expression.span, message);
                }
                None
            }
            _ => {
                // What is wrong with the name itself says more.
                self.called(expression);
                if self.diagnostics.len() == before {
                    let message = format!("`{text}` can be neither an instance nor a function to mock");
                    self.report(Problem::P2306, expression.span, message);
                }
                None
            }
        }
    }

    fn mock_function(&mut self, expression: &Expression, returns: Option<&Expression>, question: &mut Question) -> Option<()> {
        self.mocked(Word::MockFunction, expression, question)?;
        let (block, text) = question.mocked.clone()?;
        if !matches!(block.kind, BlockKind::Function | BlockKind::SystemFunction) {
            let message = format!("`{text}` is an instance");
            self.report(Problem::P2306, expression.span, message).help = Some(format!("Write `MOCK {text};` and set its outputs."));
            return None;
        }
        let interface = self.interface(block, expression.span)?;
        let result = interface.variables.iter().find(|variable| {
            variable.section == Section::Return || variable.section == Section::Output && variable.name.eq_ignore_ascii_case("RET_VAL")
        });
        let Some(returns) = returns else { return self.constant_value(0, question, expression.span) };
        let Some(result) = result else {
            self.report(Problem::P2306, returns.span, format!("`{text}` has no result")).help =
                Some(format!("Write `MOCK_FUNCTION {text};`."));
            return None;
        };
        if Kind::of(&result.data_type).is_none() {
            let message = format!("`{text}` returns {}; only elementary results can be mocked", self.words(&result.data_type));
            self.report(Problem::P2306, returns.span, message);
            return None;
        }
        let value = self.value(returns, &result.data_type)?;
        question.values.push(value);
        Some(())
    }

    /// `%PIW256 := value` in a test: what the module answers from now on.
    pub(super) fn set_peripheral(&mut self, target: &Target, value: &Expression, span: Span) -> Option<StatementKind> {
        let value = self.value(value, &target.data_type)?;
        let bytes = match target.data_type.bits() {
            bits @ (8 | 16 | 32) if target.place.indexes.is_empty() => bits / 8,
            _ => {
                let message = "a peripheral input is set as a byte, a word or a double word at a constant address";
                self.report(Problem::P6204, target.place.span, message);
                return None;
            }
        };
        let value = operators::convert(value, Scalar::U32);
        let arguments = [number(u64::from(target.place.offset / 8), span), number(bytes, span), value];
        Some(call_of(SET_INPUT, in_order(arguments), span).kind)
    }
}

/// A number without a type as a report shows it: with all its digits.
fn shown_constant(typed: &Typed) -> Option<(DataType, Scalar, u64)> {
    match *typed {
        Typed::Integer { value, .. } => Some((DataType::LongInt, Scalar::I64, i64::try_from(value).ok()? as u64)),
        Typed::Real { value, .. } => Some((DataType::LongReal, Scalar::F64, value.to_bits())),
        _ => None,
    }
}

/// `%I0.0 := value` in a test: behind the assignment, the module is told to keep the value even if it had it already.
pub(super) fn and_hold(place: &Place, data_type: &DataType, assignment: StatementKind, span: Span) -> StatementKind {
    if place.base != Base::Area(Area::Input) || !place.indexes.is_empty() {
        return assignment;
    }
    let arguments = [number(u64::from(place.offset), span), number(data_type.bits(), span)];
    StatementKind::Block(vec![Statement { kind: assignment, span }, call_of(HOLD_INPUT, in_order(arguments), span)])
}

fn number(value: u64, span: Span) -> Value {
    Value { kind: ValueKind::Constant(value), scalar: Scalar::U32, span }
}

fn in_order<const N: usize>(values: [Value; N]) -> Vec<Argument> {
    (0..).zip(values).map(|(parameter, value)| Argument::Value { parameter, value }).collect()
}

fn call_of(block: BlockId, arguments: Vec<Argument>, span: Span) -> Statement {
    let call = Call::plain(Callee::Function(block), arguments, span);
    Statement { kind: StatementKind::Call(call), span }
}

/// The number of the bit that an address ends with.
fn bit_of(position: &ast::Position) -> String {
    match position {
        ast::Position::Fixed(numbers) => numbers.get(1).map_or(String::new(), |bit| format!(".{bit}")),
        _ => String::new(),
    }
}

/// Whether it is an address, which has bits and no type of its own.
fn is_address(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Address(_) | ExpressionKind::DataAddress(_) => true,
        ExpressionKind::Parenthesized(inner) => is_address(inner),
        _ => false,
    }
}

/// Whether the bits of an address can be a value of the other type.
fn fits(address: &DataType, other: &DataType) -> bool {
    match (Kind::of(address), Kind::of(other)) {
        (Some(address), Some(other)) => {
            address.class == Class::Bits && address.bits > 1 && address.bits == other.bits && other.class != Class::Reference
        }
        _ => false,
    }
}

/// The operator that an assertion means.
fn operator(word: Word) -> Option<BinaryOperator> {
    Some(match word {
        Word::AssertEqual => BinaryOperator::Equal,
        Word::AssertNotEqual => BinaryOperator::NotEqual,
        Word::AssertGreater => BinaryOperator::Greater,
        Word::AssertGreaterEqual => BinaryOperator::GreaterEqual,
        Word::AssertLess => BinaryOperator::Less,
        Word::AssertLessEqual => BinaryOperator::LessEqual,
        _ => return None,
    })
}

/// A text in single or double quotes.
fn message_text(expression: &Expression) -> Option<String> {
    match &expression.kind {
        ExpressionKind::Literal(ast::Literal { kind: LiteralKind::Characters(text), .. }) => {
            Some(text.iter().map(|&byte| char::from(byte)).collect())
        }
        ExpressionKind::Name(Name { text, quoting: Quoting::Global, .. }) => Some(text.clone()),
        _ => None,
    }
}

/// The variable at a place that is known when the program is compiled.
fn signal(place: &Place, data_type: &DataType, name: String) -> Option<Signal> {
    let width = data_type.width()?;
    let (data_block, area) = match place.base {
        Base::Area(area @ (Area::Input | Area::Output | Area::BitMemory)) => (None, area),
        Base::DataBlock(number) => (Some(number), Area::SharedData),
        // Whose instance it is, the declarations know.
        Base::Instance => (None, Area::InstanceData),
        _ => return None,
    };
    if !place.indexes.is_empty() {
        return None;
    }
    let bit = if width == Width::Bit { (place.offset % 8) as u8 } else { 0 };
    let address = Address { area, width, byte: place.offset / 8, bit };
    Some(Signal { name, data_block, address, data_type: data_type.clone() })
}
