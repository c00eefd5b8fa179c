//! Typed trees of Structured Text become IR that does what they say, on both engines.

#[path = "lowering/trees.rs"]
mod trees;

use sieben_engine::ir::Op;
use sieben_lang::st::tree::{
    Argument, Base, Bounds, Branch, Call, Callee, For, Local, Place, Scalar, Statement, StatementKind, Text, TextRoom, Value, ValueKind,
};
use sieben_model::address::{Area, Width};
use sieben_model::block::BlockId;
use sieben_model::interface::Section;
use sieben_model::source::Span;
use sieben_model::types::DataType;
use trees::{
    Block, add, assign, bit, block, compile, compute, db, dint, get, indexed, int, l, m, own, place, run, run_statements, run_with,
    statement, value, variable,
};

const I16: Scalar = Scalar::I16;
const I32: Scalar = Scalar::I32;

fn i16_at(byte: u32) -> Value {
    get(m(byte), I16)
}

fn less(a: Value, b: Value) -> Value {
    compute(Op::LtI16, Scalar::Bool, vec![a, b])
}

fn for_loop(variable: Place, (from, to, by): (Value, Value, Value), body: Vec<Statement>) -> Statement {
    let scalar = from.scalar;
    statement(StatementKind::For(Box::new(For { variable, scalar, from, to, by, each_pass: false, body })))
}

fn call(callee: Callee, arguments: Vec<Argument>, result: DataType) -> Call {
    Call { callee, arguments, enable: None, result, clears_ok: false, of_library: false, written_out: None, span: Span::default() }
}

/// FC with INT inputs named a, b … and an INT result.
fn function(number: u16, inputs: usize, statements: Vec<Statement>) -> Block {
    let mut block = block(BlockId::fc(number), statements);
    for index in 0..inputs {
        block.interface.variables.push(variable(&format!("x{index}"), Section::Input, DataType::Int, index as u32));
    }
    block.interface.variables.push(variable("RET_VAL", Section::Return, DataType::Int, inputs as u32));
    block
}

fn parameter(index: u16) -> Place {
    place(Base::Parameter(index), 0)
}

fn call_function(number: u16, values: Vec<Value>) -> Value {
    let arguments = values.into_iter().enumerate().map(|(index, value)| Argument::Value { parameter: index as u32, value }).collect();
    value(ValueKind::Call(Box::new(call(Callee::Function(BlockId::fc(number)), arguments, DataType::Int))), I16)
}

#[test]
fn an_assignment_is_a_few_instructions() {
    let program = compile(&[block(BlockId::ob(1), vec![assign(m(0), add(i16_at(2), i16_at(4)))])]);
    let code = &program.code[&BlockId::ob(1)].code;
    assert_eq!(code.statement(0).len(), 4, "{code}");
    let element = indexed(m(100), get(l(30), I32), 3, 10, 2, Bounds::None);
    let program = compile(&[block(BlockId::ob(1), vec![assign(m(0), get(element, I16))])]);
    let code = &program.code[&BlockId::ob(1)].code;
    assert_eq!(code.statement(0).len(), 5, "load, shift, indirect load, store: {code}");
    let body = vec![assign(m(0), int(1))];
    let if_less = StatementKind::If { branches: vec![(less(i16_at(2), i16_at(4)), body)], otherwise: Vec::new() };
    let program = compile(&[block(BlockId::ob(1), vec![statement(if_less)])]);
    let code = &program.code[&BlockId::ob(1)].code;
    assert_eq!(code.statement(0).len(), 4, "two loads, one comparison, one branch: {code}");
}

#[test]
fn values_of_every_width_come_and_go() {
    let wide = value(ValueKind::Constant(0x0102_0304_0506_0708), Scalar::U64);
    let outcome = run_statements(vec![
        assign(m(0), wide),
        assign(db(1, 8), get(m(0), Scalar::U64)),
        assign(m(8), get(db(1, 12), Scalar::U32)),
        assign(m(12), get(db(1, 14), Scalar::U16)),
        assign(m(14), get(db(1, 15), Scalar::U8)),
        assign(place(Base::Area(Area::BitMemory), 15 * 8 + 3), bit(true)),
        assign(l(40), get(m(0), Scalar::U64)),
        assign(m(16), get(l(40), Scalar::F64)),
        assign(db(2, 0), get(db(1, 8), Scalar::U64)),
    ]);
    assert_eq!(outcome.memory[..24], [1, 2, 3, 4, 5, 6, 7, 8, 5, 6, 7, 8, 7, 8, 8, 8, 1, 2, 3, 4, 5, 6, 7, 8]);
    assert_eq!(outcome.data[1][..8], [1, 2, 3, 4, 5, 6, 7, 8]);
    assert_eq!(outcome.asked, [""; 0]);
    assert_eq!(outcome.br, 1);
}

#[test]
fn an_expression_may_be_as_deep_as_it_likes() {
    let right = (0..600).fold(int(0), |sum, number| add(get(m(2 * (number % 4)), I16), sum));
    let left = (0..600).fold(int(0), |sum, number| add(sum, get(m(2 * (number % 4)), I16)));
    let outcome = run_with(&[block(BlockId::ob(1), vec![assign(m(20), right), assign(m(22), left)])], &|machine| {
        let start = machine.memory.layout.bit_memory.start;
        machine.memory.arena[start..start + 8].copy_from_slice(&[0, 1, 0, 2, 0, 3, 0, 4]);
    });
    assert_eq!([outcome.int(20), outcome.int(22)], [1500, 1500]);
}

#[test]
fn indexes_out_of_range_do_what_is_asked() {
    let read = |to: u32, index: i32, check| assign(m(to), get(indexed(m(100), dint(index), -1, 4, 2, check), I16));
    let write = |index: i32, check| assign(indexed(m(200), get(m(80), I32), -1, 4, 2, check), int(100 + index as i16));
    let mut ob = block(BlockId::ob(1), vec![]);
    ob.body.uses_ok = true;
    let ok = |to: u32| assign(m(to), value(ValueKind::Ok, Scalar::Bool));
    ob.body.statements = vec![
        read(0, -1, Bounds::Fault),
        read(2, 2, Bounds::None),
        ok(50),
        read(4, 3, Bounds::Clamp),
        read(6, -2, Bounds::Clamp),
        ok(51),
        read(8, 3, Bounds::Skip),
        ok(52),
        statement(StatementKind::SetOk(bit(true))),
        read(10, 3, Bounds::Fault),
        read(10, i32::MIN, Bounds::Fault),
        ok(53),
    ];
    for (index, check) in [(-1, Bounds::Fault), (2, Bounds::Skip), (7, Bounds::Skip), (9, Bounds::Clamp), (3, Bounds::Fault)] {
        ob.body.statements.push(assign(m(80), dint(index)));
        ob.body.statements.push(write(index, check));
    }
    let outcome = run_with(&[ob], &|machine| {
        let start = machine.memory.layout.bit_memory.start;
        for number in 0..4 {
            machine.memory.arena[start + 101 + 2 * number] = 11 + number as u8;
        }
        machine.memory.arena[start + 9] = 99;
        machine.memory.arena[start + 11] = 98;
    });
    assert_eq!([0, 2, 4, 6, 8, 10].map(|byte| outcome.int(byte)), [11, 14, 14, 11, 0, 98]);
    assert_eq!(outcome.memory[50..54], [1, 1, 0, 1]);
    // 99, 101, unchanged, 109 at the last one.
    assert_eq!([200, 202, 204, 206].map(|byte| outcome.int(byte)), [99, 0, 0, 109]);
    let (noted, failed): (Vec<&String>, Vec<&String>) =
        outcome.asked.iter().partition(|asked| asked.contains("code: 162") || asked.contains("code: 163"));
    assert_eq!(failed.len(), 3, "{:?}", outcome.asked);
    assert_eq!(noted.len(), 2, "an index that is skipped is told: {:?}", outcome.asked);
    assert_eq!(outcome.br, 0, "OK was cleared by an index that was skipped");
}

#[test]
fn a_failed_part_leaves_the_whole_statement_out() {
    let bad = get(indexed(m(100), dint(9), 0, 4, 2, Bounds::Fault), I16);
    let condition = less(bad.clone(), int(5));
    let branches = vec![(condition.clone(), vec![assign(m(0), int(1))]), (bit(true), vec![assign(m(0), int(2))])];
    let outcome = run_statements(vec![
        statement(StatementKind::If { branches, otherwise: vec![assign(m(0), int(3))] }),
        statement(StatementKind::While { condition: condition.clone(), body: vec![assign(m(2), int(1))] }),
        statement(StatementKind::Repeat { body: vec![assign(m(4), add(i16_at(4), int(1)))], until: condition.clone() }),
        statement(StatementKind::Case {
            selector: bad.clone(),
            branches: vec![Branch { ranges: vec![(0, 5)], span: Span::default(), body: vec![assign(m(6), int(1))] }],
            otherwise: vec![assign(m(6), int(2))],
        }),
        for_loop(m(40), (bad.clone(), int(5), int(1)), vec![assign(m(8), int(1))]),
        assign(
            m(10),
            value(ValueKind::Choose { condition: Box::new(condition.clone()), a: Box::new(bad.clone()), b: Box::new(int(7)) }, I16),
        ),
        assign(
            m(12),
            compute(Op::Not, Scalar::Bool, vec![value(ValueKind::AndThen(Box::new(bit(true)), Box::new(condition)), Scalar::Bool)]),
        ),
        assign(m(14), int(1)),
    ]);
    assert_eq!(outcome.memory[..16], [0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1]);
    assert_eq!(outcome.asked.len(), 7, "{:?}", outcome.asked);
}

#[test]
fn short_circuits_leave_out_what_they_promise() {
    let bad = || less(get(indexed(m(100), dint(9), 0, 4, 2, Bounds::Fault), I16), int(5));
    let and = |a: Value, b: Value| value(ValueKind::AndThen(Box::new(a), Box::new(b)), Scalar::Bool);
    let or = |a: Value, b: Value| value(ValueKind::OrElse(Box::new(a), Box::new(b)), Scalar::Bool);
    let if_then = |condition: Value, to: u32| {
        let branches = vec![(condition, vec![assign(m(to), int(1))])];
        statement(StatementKind::If { branches, otherwise: vec![assign(m(to), int(2))] })
    };
    let outcome = run_statements(vec![
        if_then(and(bit(false), bad()), 0),
        if_then(or(less(i16_at(90), int(1)), bad()), 2),
        if_then(and(or(bit(true), bad()), or(bit(false), bit(true))), 4),
        if_then(or(and(bit(true), less(int(1), i16_at(90))), and(bit(true), bit(true))), 6),
        assign(m(8), or(bit(true), bad())),
        assign(m(9), and(less(i16_at(90), int(0)), bad())),
        if_then(compute(Op::Not, Scalar::Bool, vec![and(less(i16_at(90), int(0)), bad())]), 10),
    ]);
    assert_eq!(outcome.asked, [""; 0]);
    assert_eq!(outcome.memory[..12], [0, 2, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1]);
}

#[test]
fn for_counts_to_the_last_value_of_its_type() {
    let counts = |variable: u32, counter: u32, bounds: (Value, Value, Value)| {
        for_loop(m(variable), bounds, vec![assign(m(counter), add(i16_at(counter), int(1)))])
    };
    let byte = |number: u64| value(ValueKind::Constant(number), Scalar::U8);
    let outcome = run_statements(vec![
        counts(0, 100, (int(1), int(10), int(1))),
        counts(2, 102, (int(10), int(1), int(-3))),
        counts(4, 104, (int(5), int(1), int(1))),
        counts(6, 106, (int(32_760), int(32_767), int(1))),
        counts(8, 108, (int(-32_760), int(-32_768), int(-4))),
        counts(10, 110, (byte(250), byte(255), byte(2))),
        assign(m(200), int(3)),
        counts(12, 112, (i16_at(200), int(9), i16_at(200))),
        assign(m(202), int(-3)),
        counts(14, 114, (int(9), i16_at(200), i16_at(202))),
        assign(m(204), int(0)),
        counts(16, 116, (int(1), int(3), i16_at(204))),
        counts(18, 118, (int(1), i16_at(200), int(1))),
        counts(20, 120, (i16_at(204), int(32_767), int(32_767))),
    ]);
    let passes: Vec<i16> = (0..11).map(|index| outcome.int(100 + 2 * index)).collect();
    assert_eq!(passes, [10, 4, 0, 8, 3, 3, 3, 3, 0, 3, 2]);
    let left: Vec<i16> = (0..10).filter(|&index| index != 5).map(|index| outcome.int(2 * index)).collect();
    assert_eq!(left, [11, -2, 5, -32_768, 32_764, 12, 0, 1, 4]);
    assert_eq!(outcome.memory[10], 0);
}

#[test]
fn loops_are_left_and_continued() {
    let exit = |depth| statement(StatementKind::Exit { depth });
    let go_on = |depth| statement(StatementKind::Continue { depth });
    let when =
        |condition: Value, then: Statement| statement(StatementKind::If { branches: vec![(condition, vec![then])], otherwise: Vec::new() });
    let count = |byte: u32| assign(m(byte), add(i16_at(byte), int(1)));
    let equal = |a: Value, b: Value| compute(Op::Equal, Scalar::Bool, vec![a, b]);
    let outcome = run_statements(vec![
        for_loop(
            m(0),
            (int(1), int(9), int(1)),
            vec![
                when(equal(i16_at(0), int(3)), go_on(0)),
                for_loop(
                    m(2),
                    (int(1), int(9), int(1)),
                    vec![when(equal(i16_at(2), int(4)), go_on(1)), when(equal(i16_at(0), int(6)), exit(1)), count(10)],
                ),
                count(12),
            ],
        ),
        statement(StatementKind::While {
            condition: bit(true),
            body: vec![count(4), when(less(int(6), i16_at(4)), exit(0)), when(less(int(3), i16_at(4)), go_on(0)), count(6)],
        }),
        statement(StatementKind::Repeat { body: vec![count(8), when(bit(true), go_on(0)), count(8)], until: less(int(4), i16_at(8)) }),
        statement(StatementKind::Goto(1)),
        count(14),
        statement(StatementKind::Label(1)),
        count(16),
        when(less(i16_at(16), int(3)), statement(StatementKind::Goto(1))),
        statement(StatementKind::Return),
        count(16),
    ]);
    assert_eq!([0, 2, 10, 12, 4, 6, 8, 14, 16].map(|byte| outcome.int(byte)), [6, 1, 12, 0, 7, 3, 5, 0, 3]);
}

#[test]
fn case_finds_the_first_branch_however_it_looks_for_it() {
    let dense: Vec<Vec<(i128, i128)>> = (0..20).map(|index| vec![(index - 5, index - 5)]).collect();
    let sparse: Vec<Vec<(i128, i128)>> =
        (0..20).map(|index| vec![(index * 1000 - 9000, index * 1000 - 8990), (index * 7 + 20_000, index * 7 + 20_001)]).collect();
    let few = vec![vec![(3, 3), (10, 20)], vec![(15, 30)], vec![(-32_768, -32_000)]];
    for ranges in [dense, sparse, few] {
        let find =
            |selector: i16| ranges.iter().position(|ranges| ranges.iter().any(|&(low, high)| (low..=high).contains(&i128::from(selector))));
        let selectors: Vec<i16> =
            (-40..40)
                .chain((0..20).flat_map(|index| {
                    [index * 1000 - 9000, index * 1000 - 8989, index * 1000 - 9001, index * 7 + 20_000, index * 7 + 20_002]
                }))
                .chain([i16::MIN, i16::MAX, -32_000, -31_999])
                .collect();
        for chunk in selectors.chunks(50) {
            let branches: Vec<Branch> = ranges
                .iter()
                .enumerate()
                .map(|(index, ranges)| Branch {
                    ranges: ranges.clone(),
                    span: Span::default(),
                    body: vec![assign(m(2), int(index as i16 + 1))],
                })
                .collect();
            let mut statements = Vec::new();
            for (index, &selector) in chunk.iter().enumerate() {
                statements.push(assign(m(0), int(selector)));
                statements.push(statement(StatementKind::Case {
                    selector: i16_at(0),
                    branches: branches.clone(),
                    otherwise: vec![assign(m(2), int(-1))],
                }));
                statements.push(assign(m(100 + 2 * index as u32), i16_at(2)));
            }
            let outcome = run_statements(statements);
            for (index, &selector) in chunk.iter().enumerate() {
                let expected = find(selector).map_or(-1, |branch| branch as i16 + 1);
                assert_eq!(outcome.int(100 + 2 * index), expected, "selector {selector}");
            }
        }
    }
}

#[test]
fn functions_are_called_in_the_middle_of_expressions() {
    let result = parameter(2);
    let difference =
        function(1, 2, vec![assign(result.clone(), compute(Op::SubU16, I16, vec![get(parameter(0), I16), get(parameter(1), I16)]))]);
    // FACULTY, by recursion.
    let faculty = function(
        2,
        1,
        vec![statement(StatementKind::If {
            branches: vec![(less(get(parameter(0), I16), int(2)), vec![assign(parameter(1), int(1))])],
            otherwise: vec![assign(
                parameter(1),
                compute(
                    Op::MulU16,
                    I16,
                    vec![get(parameter(0), I16), call_function(2, vec![compute(Op::SubU16, I16, vec![get(parameter(0), I16), int(1)])])],
                ),
            )],
        })],
    );
    let nested =
        add(i16_at(0), call_function(1, vec![call_function(1, vec![int(100), i16_at(0)]), call_function(1, vec![i16_at(0), int(5)])]));
    let main = block(
        BlockId::ob(1),
        vec![
            assign(m(0), int(7)),
            assign(m(2), nested),
            assign(m(4), call_function(2, vec![int(6)])),
            assign(
                indexed(m(20), compute(Op::Extend16, I32, vec![call_function(1, vec![int(9), i16_at(0)])]), 0, 10, 2, Bounds::Fault),
                add(call_function(1, vec![int(1), int(2)]), i16_at(0)),
            ),
            // What a function leaves unset is 0.
            assign(m(6), call_function(3, vec![])),
            // A call that is left out by EN.
            statement(StatementKind::Call(Call {
                enable: Some(less(i16_at(0), int(0))),
                arguments: vec![Argument::Eno { target: m(8) }],
                ..call(Callee::Function(BlockId::fc(1)), vec![], DataType::Int)
            })),
            assign(m(9), bit(true)),
            statement(StatementKind::Call(Call {
                enable: Some(bit(true)),
                arguments: vec![Argument::Value { parameter: 0, value: int(3) }, Argument::Eno { target: m(10) }],
                ..call(Callee::Function(BlockId::fc(1)), vec![], DataType::Int)
            })),
        ],
    );
    let outcome = run(&[main, difference, faculty, function(3, 0, vec![])]);
    assert_eq!([2, 4, 24, 6].map(|byte| outcome.int(byte)), [98, 720, 6, 0]);
    assert_eq!(outcome.memory[8..11], [0, 1, 1]);
    assert_eq!(outcome.asked, [""; 0]);
}

#[test]
fn parameters_of_functions_go_in_and_out() {
    let mut inner = block(
        BlockId::fc(1),
        vec![
            assign(parameter(1), add(get(parameter(0), I16), int(1))),
            assign(parameter(2), add(get(parameter(2), I16), get(parameter(0), I16))),
            assign(place(Base::ComplexParameter(3), 16), get(place(Base::ComplexParameter(3), 0), I16)),
            assign(
                place(Base::ComplexParameter(4), 0),
                compute(
                    Op::AddU64,
                    Scalar::I64,
                    vec![get(place(Base::ComplexParameter(4), 0), Scalar::I64), value(ValueKind::Constant(1), Scalar::I64)],
                ),
            ),
            statement(StatementKind::SetOk(less(get(parameter(0), I16), int(10)))),
        ],
    );
    inner.body.uses_ok = true;
    let array = DataType::Array { bounds: vec![(0, 3)], element: Box::new(DataType::Int) };
    for (index, (section, data_type)) in [
        (Section::Input, DataType::Int),
        (Section::Output, DataType::Int),
        (Section::InOut, DataType::Int),
        (Section::InOut, array.clone()),
        (Section::InOut, DataType::LongInt),
    ]
    .into_iter()
    .enumerate()
    {
        inner.interface.variables.push(variable(&format!("x{index}"), section, data_type, index as u32));
    }
    // FC 2 passes its own parameters on.
    let mut outer = Block { id: BlockId::fc(2), interface: inner.interface.clone(), body: sieben_lang::st::tree::Body::default() };
    let arguments = |input: Value, output: Place, in_out: Place, whole: Place, long: Place| {
        vec![
            Argument::Value { parameter: 0, value: input },
            Argument::Output { parameter: 1, scalar: I16, target: output, convert: vec![Op::Extend16], converted: I32 },
            Argument::InOut { parameter: 2, place: in_out, data_type: DataType::Int },
            Argument::InOut { parameter: 3, place: whole, data_type: array.clone() },
            Argument::InOut { parameter: 4, place: long, data_type: DataType::LongInt },
            Argument::Eno { target: place(Base::Area(Area::BitMemory), 90 * 8) },
        ]
    };
    outer.body.statements = vec![statement(StatementKind::Call(call(
        Callee::Function(BlockId::fc(1)),
        arguments(get(parameter(0), I16), m(60), parameter(2), place(Base::ComplexParameter(3), 0), place(Base::ComplexParameter(4), 0)),
        DataType::Void,
    )))];
    let with = |block: u16, arguments: Vec<Argument>| {
        statement(StatementKind::Call(call(Callee::Function(BlockId::fc(block)), arguments, DataType::Void)))
    };
    let main = block(
        BlockId::ob(1),
        vec![
            assign(l(30), int(50)),
            assign(db(1, 0), int(7)),
            with(1, arguments(int(5), m(0), m(4), db(1, 0), db(1, 8))),
            with(1, arguments(int(50), db(2, 0), indexed(db(1, 20), dint(3), 0, 10, 2, Bounds::Fault), l(30), m(80))),
            assign(m(6), get(l(32), I16)),
            with(2, arguments(int(6), m(64), l(40), l(30), m(80))),
            assign(m(8), get(l(40), I16)),
            assign(m(10), get(place(Base::Area(Area::BitMemory), 90 * 8), Scalar::Bool)),
        ],
    );
    let outcome = run(&[main, inner, outer]);
    assert_eq!(outcome.asked, [""; 0]);
    assert_eq!(outcome.read(0, Width::DoubleWord), 6);
    assert_eq!([4, 6, 8].map(|byte| outcome.int(byte)), [5, 50, 6]);
    assert_eq!(outcome.read(60, Width::DoubleWord), 7);
    assert_eq!(outcome.read(80, Width::QuadWord), 2);
    assert_eq!(outcome.data[0][..4], [0, 7, 0, 7]);
    assert_eq!(outcome.data[0][8..16], [0, 0, 0, 0, 0, 0, 0, 1]);
    assert_eq!(outcome.data[0][26..28], [0, 50]);
    assert_eq!(outcome.data[1][..4], [0, 0, 0, 51]);
    assert_eq!(outcome.memory[10], 1, "ENO of the last call that FC 2 made");
}

#[test]
fn instances_keep_their_data() {
    // FB 1: x at 0, q at 2, count at 4; adds x to count. FB 2 holds two of FB 1 at 0 and 6, and calls DB 2 too.
    let mut counter = block(
        BlockId::new(sieben_model::block::BlockKind::FunctionBlock, 1),
        vec![assign(own(4), add(get(own(4), I16), get(own(0), I16))), assign(own(2), get(own(4), I16))],
    );
    for (name, section, offset) in [("x", Section::Input, 0), ("q", Section::Output, 16), ("n", Section::Static, 32)] {
        counter.interface.variables.push(variable(name, section, DataType::Int, offset));
    }
    let fb1 = counter.id;
    let invoke = |instance: Place, input: i16, target: Place| {
        statement(StatementKind::Call(call(
            Callee::Instance { block: fb1, instance, dispatch: None },
            vec![
                Argument::Value { parameter: 0, value: int(input) },
                Argument::Output { parameter: 16, scalar: I16, target, convert: vec![], converted: I16 },
            ],
            DataType::Void,
        )))
    };
    let fb2 = BlockId::new(sieben_model::block::BlockKind::FunctionBlock, 2);
    let outer = block(
        fb2,
        vec![
            invoke(own(6), 10, own(20)),
            invoke(db(2, 0), 3, own(22)),
            invoke(indexed(own(0), get(own(26), I32), 0, 2, 6, Bounds::Fault), 100, own(24)),
            assign(own(30), add(get(own(20), I16), get(own(24), I16))),
        ],
    );
    let main = block(
        BlockId::ob(1),
        vec![
            invoke(db(2, 0), 4, m(0)),
            statement(StatementKind::Call(call(
                Callee::Instance { block: fb2, instance: db(1, 0), dispatch: None },
                vec![],
                DataType::Void,
            ))),
            assign(m(2), get(db(1, 30), I16)),
            statement(StatementKind::Call(call(
                Callee::Instance { block: fb2, instance: db(1, 0), dispatch: None },
                vec![],
                DataType::Void,
            ))),
            assign(m(4), get(db(1, 30), I16)),
            assign(m(6), get(db(2, 2), I16)),
            invoke(indexed(db(2, 10), get(m(40), I32), 0, 3, 6, Bounds::None), 8, m(8)),
        ],
    );
    let outcome = run_with(&[main, outer, counter], &|machine| {
        let start = machine.memory.layout.bit_memory.start;
        machine.memory.arena[start + 43] = 2;
    });
    assert_eq!(outcome.asked, [""; 0]);
    assert_eq!([0, 2, 4, 6, 8].map(|byte| outcome.int(byte)), [4, 110, 220, 10, 8]);
    assert_eq!(outcome.data[0][..12], [0, 100, 0, 200, 0, 200, 0, 10, 0, 20, 0, 20]);
    assert_eq!(outcome.data[0][20..26], [0, 20, 0, 10, 0, 200]);
    assert_eq!(outcome.data[1][22..28], [0, 8, 0, 8, 0, 8]);
}

#[test]
fn texts_are_cut_compared_and_measured() {
    let constant = |text: &str| Text::Constant(text.as_bytes().to_vec());
    let at = |place: Place, capacity: u8| Text::Place { place, room: TextRoom::narrow(capacity) };
    let set = |target: Place, capacity: u8, source: Text| {
        statement(StatementKind::AssignString { target, room: TextRoom::narrow(capacity), source })
    };
    let compare = |a: Text, b: Text| value(ValueKind::CompareTexts(Box::new(a), Box::new(b)), I32);
    let length = |text: Text| value(ValueKind::Length(Box::new(text)), I16);
    let long: String = "0123456789".repeat(25);
    let outcome = run_statements(vec![
        set(db(1, 0), 10, constant("hello")),
        set(db(1, 12), 4, at(db(1, 0), 10)),
        set(m(100), 10, at(db(1, 12), 4)),
        set(db(2, 0), 20, at(db(1, 0), 10)),
        assign(m(0), length(at(m(100), 10))),
        assign(m(2), compare(constant("abc"), constant("abd"))),
        assign(m(6), compare(at(db(1, 0), 0), constant("hell"))),
        assign(m(10), compare(at(db(2, 0), 20), at(db(1, 0), 10))),
        set(m(200), 8, Text::Character(Box::new(value(ValueKind::Constant(65), Scalar::U8)))),
        set(m(120), 60, constant(&long)),
        assign(m(14), length(constant(&long))),
        // As the first byte says: 4 characters.
        set(db(1, 12), 0, constant("abcdefgh")),
        assign(m(16), length(at(db(1, 60), 10))),
        set(m(300), 5, constant("")),
    ]);
    assert_eq!(outcome.data[0][..7], [10, 5, b'h', b'e', b'l', b'l', b'o']);
    assert_eq!(outcome.data[0][12..18], [4, 4, b'a', b'b', b'c', b'd']);
    assert_eq!(outcome.memory[100..106], [10, 4, b'h', b'e', b'l', b'l']);
    assert_eq!(outcome.data[1][..4], [20, 5, b'h', b'e']);
    assert_eq!(outcome.int(0), 4);
    assert_eq!([2, 6, 10].map(|byte| outcome.read(byte, Width::DoubleWord) as i32), [-1, 1, 0]);
    assert_eq!(outcome.memory[200..203], [8, 1, 65]);
    assert_eq!(outcome.memory[120..124], [60, 60, b'0', b'1']);
    assert_eq!([outcome.int(14), outcome.int(16)], [250, 0]);
    assert_eq!(outcome.memory[300..302], [5, 0]);
    assert_eq!(outcome.asked, [""; 0]);
}

#[test]
fn texts_are_parameters_and_results() {
    // FC 1 (s : STRING) : STRING[20] puts the text into its result, which has room for 3 of it.
    let mut echo = block(
        BlockId::fc(1),
        vec![statement(StatementKind::AssignString {
            target: place(Base::ComplexParameter(1), 0),
            room: TextRoom::narrow(0),
            source: Text::Place { place: place(Base::ComplexParameter(0), 0), room: TextRoom::narrow(0) },
        })],
    );
    echo.interface.variables.push(variable("s", Section::Input, DataType::String(254), 0));
    echo.interface.variables.push(variable("RET_VAL", Section::Return, DataType::String(20), 1));
    let invoke = |text: Text| Text::Call {
        call: Box::new(call(
            Callee::Function(BlockId::fc(1)),
            vec![Argument::Text { parameter: 0, text, room: TextRoom::narrow(254) }],
            DataType::String(20),
        )),
        room: TextRoom::narrow(20),
    };
    let constant = |text: &str| Text::Constant(text.as_bytes().to_vec());
    let main = block(
        BlockId::ob(1),
        vec![
            statement(StatementKind::AssignString {
                target: m(0),
                room: TextRoom::narrow(30),
                source: invoke(invoke(constant("one, two, three, four, five"))),
            }),
            assign(m(50), value(ValueKind::CompareTexts(Box::new(invoke(constant("b"))), Box::new(invoke(constant("a")))), I32)),
        ],
    );
    let outcome = run(&[main, echo]);
    assert_eq!(outcome.memory[..22], *b"\x1E\x14one, two, three, fou");
    assert_eq!(outcome.read(50, Width::DoubleWord), 1);
    assert_eq!(outcome.asked, [""; 0]);
}

#[test]
fn wholes_are_copied_as_if_through_a_temporary() {
    let copy = |target: Place, source: Place, bytes| statement(StatementKind::Copy { target, source, bytes });
    let outcome = run_with(
        &[block(
            BlockId::ob(1),
            vec![
                copy(m(2), m(0), 8),
                copy(db(1, 0), m(2), 8),
                copy(db(2, 10), db(1, 0), 8),
                copy(l(30), db(2, 10), 8),
                copy(m(20), l(30), 8),
                copy(indexed(db(1, 20), dint(2), 1, 3, 8, Bounds::Fault), l(30), 8),
                copy(indexed(db(1, 20), dint(4), 1, 3, 8, Bounds::Fault), l(30), 8),
                copy(m(40), indexed(db(1, 20), dint(2), 1, 3, 8, Bounds::Fault), 8),
            ],
        )],
        &|machine| {
            let start = machine.memory.layout.bit_memory.start;
            machine.memory.arena[start..start + 8].copy_from_slice(&[1, 2, 3, 4, 5, 6, 7, 8]);
        },
    );
    let text = [1, 2, 3, 4, 5, 6, 7, 8];
    assert_eq!(outcome.memory[2..10], text);
    assert_eq!(outcome.memory[20..28], text);
    assert_eq!(outcome.memory[40..48], text);
    assert_eq!(outcome.data[0][28..36], text);
    assert_eq!(outcome.data[1][10..18], text);
    assert_eq!(outcome.asked.len(), 1);
}

#[test]
fn references_reach_what_they_were_taken_of() {
    let address = |place: Place| value(ValueKind::AddressOf(place), Scalar::U64);
    let at = |reference: Place, offset: u32| place(Base::Reference(Box::new(get(reference, Scalar::U64))), offset * 8);
    let outcome = run_statements(vec![
        assign(m(0), address(m(100))),
        assign(m(8), address(indexed(db(1, 10), dint(3), 0, 5, 2, Bounds::Fault))),
        assign(at(m(0), 2), int(5)),
        assign(at(m(8), 0), add(get(at(m(0), 2), I16), int(1))),
        assign(place(Base::ComputedDataBlock(Box::new(i16_at(30))), 32), int(9)),
        // NULL: the statement does nothing.
        assign(m(20), int(4)),
        assign(m(20), get(at(m(16), 0), I16)),
        assign(at(m(16), 0), int(4)),
        statement(StatementKind::Copy { target: m(110), source: at(m(8), 0), bytes: 4 }),
        assign(m(30), int(1)),
        assign(place(Base::ComputedDataBlock(Box::new(i16_at(30))), 32), int(9)),
    ]);
    assert_eq!(outcome.int(102), 5);
    assert_eq!(outcome.data[0][16..18], [0, 6]);
    assert_eq!(outcome.int(20), 4);
    assert_eq!(outcome.int(110), 6);
    assert_eq!(outcome.data[0][4..6], [0, 9]);
    assert_eq!(outcome.asked.len(), 3, "{:?}", outcome.asked);
}

#[test]
fn local_variables_begin_with_their_values() {
    let mut ob = block(
        BlockId::ob(1),
        vec![
            assign(m(0), get(l(20), I16)),
            assign(m(2), get(l(22), Scalar::U64)),
            statement(StatementKind::Copy { target: m(100), source: l(30), bytes: 180 }),
            assign(l(20), int(1)),
            assign(m(10), get(place(Base::Area(Area::Local), 212 * 8), Scalar::Bool)),
        ],
    );
    let mut bytes = vec![7; 180];
    bytes[20..150].fill(0);
    ob.interface.local_size = 220;
    ob.body.locals = vec![
        Local { position: 160, data_type: DataType::Int, initial: Some(vec![1, 2]) },
        Local { position: 176, data_type: DataType::LongInt, initial: Some(vec![1, 2, 3, 4, 5, 6, 7, 8]) },
        Local { position: 1696, data_type: DataType::Bool, initial: Some(vec![1]) },
        Local {
            position: 240,
            data_type: DataType::Array { bounds: vec![(1, 180)], element: Box::new(DataType::Byte) },
            initial: Some(bytes.clone()),
        },
    ];
    let outcome = run(&[ob]);
    assert_eq!(outcome.memory[..11], [1, 2, 1, 2, 3, 4, 5, 6, 7, 8, 1]);
    assert_eq!(outcome.memory[100..280], bytes);
}

#[test]
fn only_what_nobody_else_sees_is_private() {
    let mut ob = block(
        BlockId::ob(1),
        vec![
            assign(l(20), int(1)),
            assign(l(22), dint(1)),
            // Two widths at one place.
            assign(l(26), dint(1)),
            assign(l(28), int(1)),
            // An array.
            assign(indexed(l(30), dint(1), 0, 4, 2, Bounds::Fault), int(1)),
            assign(l(32), int(1)),
            // A pointer leads to it.
            assign(m(0), value(ValueKind::AddressOf(l(40)), Scalar::U64)),
            assign(l(40), int(1)),
            assign(l(42), int(1)),
        ],
    );
    ob.body.locals = vec![Local { position: 320, data_type: DataType::Int, initial: None }];
    let program = compile(&[ob]);
    let private = &program.code[&BlockId::ob(1)].private;
    assert_eq!(private[..3], [(160, Width::Word), (176, Width::DoubleWord), (336, Width::Word)]);
    assert!(private[3..].iter().all(|&(position, _)| position >= 64 * 8), "{private:?}");
}

#[test]
fn checked_operations_clear_ok() {
    let mut ob = block(BlockId::ob(1), vec![]);
    ob.body.uses_ok = true;
    let checked = |a: Value, b: Value| value(ValueKind::Checked { op: Op::AddU16, failed: Op::AddOverflowsI16, args: vec![a, b] }, I16);
    ob.body.statements = vec![
        assign(m(0), checked(int(1), i16_at(50))),
        assign(m(10), value(ValueKind::Ok, Scalar::Bool)),
        assign(m(2), checked(int(32_767), int(1))),
        assign(m(11), value(ValueKind::Ok, Scalar::Bool)),
        statement(StatementKind::Return),
        statement(StatementKind::SetOk(bit(true))),
    ];
    let outcome = run(&[ob]);
    assert_eq!([outcome.int(0), outcome.int(2)], [1, -32_768]);
    assert_eq!(outcome.memory[10..12], [1, 0]);
    assert_eq!(outcome.br, 0);
}

#[test]
fn a_function_that_is_written_out_keeps_what_was_computed_before() {
    let after = |statements: Vec<Statement>, then: Value| value(ValueKind::After(statements, Box::new(then)), I16);
    let outcome = run_statements(vec![
        assign(m(0), int(5)),
        assign(m(2), add(i16_at(0), after(vec![assign(m(0), int(7)), assign(m(4), add(i16_at(0), int(1)))], i16_at(4)))),
    ]);
    assert_eq!([outcome.int(0), outcome.int(2)], [7, 13]);
}
