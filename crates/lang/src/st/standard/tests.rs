//! Functions of constants: what the table of vectors says, without the rest of the compiler.

use sieben_model::address::Area;
use sieben_model::types::DataType as T;

use super::*;
use crate::st::tree::{Base, ValueKind};

/// An argument: its kind, and its bits once it has the type of its parameter.
#[derive(Clone)]
enum Arg {
    Int(i128),
    Real(f64),
    Of(T, u64),
}
use Arg::{Int, Of, Real};

fn bits(arg: &Arg, scalar: Scalar) -> u64 {
    let number = match arg {
        Of(_, bits) => return *bits,
        Int(value) => *value as f64,
        Real(value) => *value,
    };
    match scalar {
        Scalar::F32 => u64::from((number as f32).to_bits()),
        Scalar::F64 => number.to_bits(),
        _ => (number as i128 as u64) & (u64::MAX >> (64 - scalar.bits())),
    }
}

/// The bits of the result, and whether something was found to fail.
fn run(dialect: Dialect, name: &str, args: &[Arg]) -> Result<(u64, bool), String> {
    let given: Vec<Given<'_>> = args
        .iter()
        .map(|arg| Given {
            name: None,
            kind: match arg {
                Int(value) => GivenKind::Integer { value: *value, radix: 10 },
                Real(_) => GivenKind::Real,
                Of(data_type, _) => GivenKind::Typed(data_type.clone()),
            },
        })
        .collect();
    let resolved = resolve(name, dialect, &given).ok_or("no such function")?.map_err(|refusal| refusal.message)?;
    let Meaning::Build(build) = resolved.meaning else { return Err("not built of operations".to_owned()) };
    let values = args
        .iter()
        .zip(&resolved.parameters)
        .map(|(arg, parameter)| {
            let scalar = generic::scalar_of(&parameter.data_type, dialect).expect("an elementary parameter");
            let arg = match arg {
                // As the implicit conversion: only numbers of the tests become REAL.
                Of(T::Int, value) if scalar == Scalar::F32 => Real(f64::from(*value as i16)),
                other => other.clone(),
            };
            build::constant(bits(&arg, scalar), scalar, Span::default())
        })
        .collect();
    let mut temporary = |_| Place { base: Base::Area(Area::Local), offset: 0, indexes: Vec::new(), span: Span::default() };
    let value = build(values, &mut Building { span: Span::default(), checked: true, quotients: true, temporary: &mut temporary });
    Ok(result(&value))
}

fn result(value: &Value) -> (u64, bool) {
    match &value.kind {
        ValueKind::Constant(bits) => (*bits, false),
        ValueKind::Compute { op, args } | ValueKind::Checked { op, args, .. } => {
            let mut words = [0; 4];
            let mut failed = false;
            for (word, arg) in words.iter_mut().zip(args) {
                let (bits, lost) = result(arg);
                *word = bits;
                failed |= lost;
            }
            if let ValueKind::Checked { failed: check, .. } = &value.kind {
                failed |= check.eval(words) & 1 != 0;
            }
            (op.eval(words), failed)
        }
        other => panic!("{other:?} is no constant"),
    }
}

const IEC: Dialect = Dialect::Iec;
const CODESYS: Dialect = Dialect::Codesys;
const SCL: Dialect = Dialect::Scl;
const TIA: Dialect = Dialect::Tia;

/// Dialects, function, arguments, the bits of the result, and whether it is out of range.
type Row<'a> = (&'a [Dialect], &'a str, &'a [Arg], u64, bool);

#[test]
fn functions_of_constants_give_what_the_dialect_says() {
    let real = |value: f32| u64::from(value.to_bits());
    let int = |value: i16| u64::from(value as u16);
    let word = |value| Of(T::Word, value);
    #[rustfmt::skip] // A table.
    let rows: &[Row] = &[
        (&[IEC, CODESYS, SCL, TIA], "ABS", &[Int(-7)], 7, false),
        (&[IEC], "ABS", &[Of(T::Int, 0x8000)], 0x8000, true),
        (&[IEC, CODESYS, SCL, TIA], "SQRT", &[Real(16.0)], real(4.0), false),
        (&[IEC, SCL], "SQRT", &[Real(-1.0)], real(f32::NAN), true),
        (&[IEC, CODESYS, SCL], "LOG", &[Real(1000.0)], real(3.0), false),
        (&[SCL, TIA], "SQR", &[Real(-3.0)], real(9.0), false),
        (&[IEC], "EXPT", &[Real(2.0), Int(10)], real(1024.0), false),
        (&[IEC], "EXPT", &[Real(0.0), Int(0)], real(1.0), false),
        (&[CODESYS], "EXPT", &[Int(7), Int(2)], real(49.0), false),
        (&[TIA], "FRAC", &[Real(-2.25)], real(-0.25), false),
        (&[IEC], "MUL", &[Int(2), Int(3), Int(4)], 24, false),
        (&[IEC, CODESYS], "DIV", &[Int(-7), Int(2)], int(-3), false),
        (&[IEC], "DIV", &[Int(7), Int(0)], 0, true),
        (&[IEC, CODESYS], "MOD", &[Int(-7), Int(2)], int(-1), false),
        (&[IEC, CODESYS, SCL, TIA], "SHL", &[word(0x0045), Int(2)], 0x0114, false),
        (&[IEC], "SHL", &[Of(T::Byte, 0x45), Int(2)], 0x14, false),
        (&[IEC, CODESYS, SCL, TIA], "SHL", &[word(0x8001), Int(17)], 0, false),
        (&[IEC], "SHL", &[word(0x8001), Int(-1)], 0x8001, true),
        (&[CODESYS], "SHL", &[word(0x8001), Int(-1)], 0, false),
        (&[IEC, CODESYS], "ROL", &[word(0x8001), Int(17)], 0x0003, false),
        (&[IEC, CODESYS], "ROL", &[Of(T::Byte, 0x81), Int(4)], 0x18, false),
        (&[CODESYS, TIA], "SHR", &[Of(T::Int, int(-8)), Int(1)], int(-4), false),
        (&[CODESYS, TIA], "SHR", &[Of(T::Int, int(-8)), Int(20)], int(-1), false),
        (&[IEC, CODESYS], "SHR", &[Of(T::DoubleWord, 0x8000_0000), Int(31)], 1, false),
        (&[IEC, CODESYS, SCL, TIA], "LIMIT", &[Int(0), Int(15), Int(10)], 10, false),
        (&[IEC, CODESYS], "LIMIT", &[Int(10), Int(5), Int(0)], 0, false),
        (&[IEC, CODESYS], "MIN", &[Int(3), Int(9), Int(-2)], int(-2), false),
        (&[IEC, CODESYS], "MUX", &[Int(2), Int(30), Int(40), Int(50)], 50, false),
        (&[CODESYS], "MUX", &[Int(7), Int(30), Int(40), Int(50)], 50, false),
        (&[CODESYS], "MUX", &[Int(-1), Int(30), Int(40), Int(50)], 50, false),
        (&[IEC], "MUX", &[Int(7), Int(30), Int(40), Int(50)], 0, true),
        (&[IEC], "GT", &[Int(3), Int(2), Int(2)], 0, false),
        (&[IEC], "LE", &[Int(1), Int(1), Int(2)], 1, false),
        (&[IEC], "XOR", &[Of(T::Bool, 1), Of(T::Bool, 1), Of(T::Bool, 1)], 1, false),
        (&[IEC, SCL, TIA], "REAL_TO_INT", &[Real(2.5)], 2, false),
        (&[CODESYS], "REAL_TO_INT", &[Real(-1.5)], int(-2), false),
        (&[IEC], "REAL_TO_INT", &[Real(1.0e6)], 32767, true),
        (&[IEC, CODESYS, SCL, TIA], "TRUNC", &[Real(-1.9)], 0xFFFF_FFFF, false),
        (&[SCL, TIA], "ROUND", &[Real(10.5)], 10, false),
        (&[TIA], "FLOOR", &[Real(-1.1)], 0xFFFF_FFFE, false),
        (&[IEC, TIA], "DINT_TO_INT", &[Of(T::DoubleInt, 70000)], 4464, true),
        (&[IEC, CODESYS], "INT_TO_UINT", &[Of(T::Int, int(-1))], 65535, true),
        (&[IEC, CODESYS, SCL, TIA], "WORD_TO_INT", &[word(0xFFFF)], 0xFFFF, false),
        (&[IEC, CODESYS], "BYTE_TO_INT", &[Of(T::Byte, 0xFF)], 255, false),
        (&[IEC, SCL, TIA], "DWORD_TO_REAL", &[Of(T::DoubleWord, 0x3F80_0000)], real(1.0), false),
        (&[CODESYS], "REAL_TO_DWORD", &[Real(1.0)], 1, false),
        (&[CODESYS], "INT_TO_BOOL", &[Of(T::Int, 2)], 1, false),
        (&[SCL], "WORD_TO_BOOL", &[word(2)], 0, false),
        (&[IEC], "WORD_BCD_TO_UINT", &[word(0x1234)], 1234, false),
        (&[IEC], "WORD_BCD_TO_UINT", &[word(0x12A4)], 0, true),
        (&[IEC], "UINT_TO_BCD_WORD", &[Of(T::UnsignedInt, 1234)], 0x1234, false),
        (&[SCL], "INT_TO_BCD_WORD", &[Of(T::Int, int(-123))], 0xF123, false),
        (&[CODESYS], "BCD_TO_INT", &[Of(T::Byte, 0x49)], 49, false),
        (&[IEC, CODESYS], "TIME_TO_DINT", &[Of(T::Time, 1500)], 1500, false),
        (&[IEC, CODESYS], "TIME_TO_LTIME", &[Of(T::Time, 1500)], 1_500_000_000, false),
        (&[IEC, CODESYS], "DT_TO_UDINT", &[Of(T::LongDateAndTime, 5_000_000_000)], 5, false),
        (&[IEC], "LDT_TO_ULINT", &[Of(T::LongDateAndTime, 5_000_000_000)], 5_000_000_000, false),
        (&[IEC], "TO_INT", &[Real(2.5)], 2, false),
        (&[IEC], "DT_TO_TOD", &[Of(T::LongDateAndTime, 86_400_000_000_000 + 3_000_000_000)], 3000, false),
        (&[IEC], "CONCAT_DATE_TOD", &[Of(T::LongDate, 86_400_000_000_000), Of(T::TimeOfDay, 3000)], 86_403_000_000_000, false),
        (&[IEC], "ADD_TOD_TIME", &[Of(T::TimeOfDay, 86_399_000), Of(T::Time, 2000)], 1000, true),
        (&[IEC], "SUB_DATE_DATE", &[Of(T::LongDate, 172_800_000_000_000), Of(T::LongDate, 0)], 172_800_000, false),
        (&[IEC], "DIV_TIME", &[Of(T::Time, 5000), Int(0)], 0, true),
        (&[IEC], "MUL_TIME", &[Of(T::Time, 1000), Real(1.5)], 1500, false),
    ];
    let mut wrong = Vec::new();
    for (dialects, name, args, expected, failed) in rows {
        for &dialect in *dialects {
            let got = run(dialect, name, args);
            // CODESYS has no ENO in its text.
            let fails = got.as_ref().is_ok_and(|(_, lost)| *lost == *failed || dialect == CODESYS);
            if got.as_ref().map(|(bits, _)| *bits) != Ok(*expected) || !fails {
                wrong.push(format!("{dialect:?} {name}: {got:X?}, not {expected:X} {failed}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_a_function_does_not_take_is_said() {
    let refused = |dialect, name, args: &[Arg]| run(dialect, name, args).expect_err("it is refused");
    assert_eq!(refused(IEC, "SHL", &[Of(T::Int, 1), Int(1)]), "`SHL` takes a bit string such as BYTE, WORD or DWORD here, not INT");
    assert_eq!(refused(IEC, "NE", &[Int(1), Int(2), Int(3)]), "`NE` takes 2 inputs, not 3");
    assert_eq!(refused(IEC, "SEL", &[Of(T::Bool, 1), Int(2)]), "`SEL` is called without `IN1`; it takes 3 inputs");
    assert_eq!(refused(SCL, "DWORD_TO_INT", &[Of(T::DoubleWord, 1)]), "no such function");
    assert_eq!(refused(IEC, "MAX", &[Of(T::Time, 1), Of(T::Int, 1)]), "the inputs of `MAX` have no type in common");
}
