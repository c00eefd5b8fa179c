//! Tests as the CPU runs them: an organization block for each, which calls SETUP and then the test.

use sieben_model::address::Area;
use sieben_model::block::BlockId;
use sieben_model::testing::{FIRST_TEST_BLOCK, Test};

use super::bodies::Bodies;
use super::environment::Environment;
use super::items::TestBlock;
use crate::declarations::interface::lay_out;
use crate::st::ast::TestPart;
use crate::st::check::Checked;
use crate::st::lower::{Known, lower};
use crate::st::tree::{Base, Body, Call, Callee, Place, Statement, StatementKind, TypedBlock};

impl Environment<'_> {
    /// Makes the organization blocks of the tests and writes the plan.
    pub(super) fn tests(&self, bodies: &mut Bodies) {
        let all = &self.items.tests;
        let of = |part: TestPart| all.iter().filter(move |test| test.part == part);
        let setup = of(TestPart::Setup).next();
        let mut number = FIRST_TEST_BLOCK;
        for test in of(TestPart::Test) {
            let block = BlockId::ob(number);
            number += 1;
            self.call_all(block, setup.into_iter().chain([test]), bodies);
            let title = test.source.header.title.as_ref();
            let name = title.map_or(String::new(), |title| title.text.clone());
            let span = title.map_or(test.source.name.span, |title| title.span);
            bodies.tests.tests.push(Test { name, span, block });
        }
        if let Some(teardown) = of(TestPart::Teardown).next() {
            let block = BlockId::ob(number);
            self.call_all(block, [teardown].into_iter(), bodies);
            bodies.tests.teardown = Some(block);
        }
    }

    /// The words of a block, with the data block that the variables of a test lie in.
    pub(super) fn words(&self, block: BlockId, checked: &mut Checked) {
        let own = self.items.tests.iter().find(|test| test.block == block).map(|test| test.instance);
        let of_words = checked.words.values_mut().flat_map(|call| &mut call.signals);
        for signal in of_words.chain(checked.writes.values_mut()) {
            if signal.address.area == Area::InstanceData {
                signal.data_block = own;
                signal.address.area = Area::SharedData;
            }
        }
    }

    /// An organization block that calls parts of a test file one after the other.
    fn call_all<'t>(&self, id: BlockId, parts: impl Iterator<Item = &'t TestBlock<'t>>, bodies: &mut Bodies) {
        let Some(laid_out) = lay_out(id, Vec::new()) else { return };
        let mut body = Body::default();
        for part in parts {
            let span = part.source.name.span;
            let instance = Place { base: Base::DataBlock(part.instance), offset: 0, indexes: Vec::new(), span };
            let callee = Callee::Instance { block: part.block, instance, dispatch: None };
            let call = Call::plain(callee, Vec::new(), span);
            body.statements.push(Statement { kind: StatementKind::Call(call), span });
            bodies.calls.entry(id).or_default().insert(part.block);
        }
        bodies
            .code
            .insert(id, lower(id, &laid_out.interface, &body, &Known { interface: &|block| self.interface_of(block), is_stl: &|_| false }));
        bodies.made.insert(id, TypedBlock { interface: laid_out.interface, body });
        bodies.tests.blocks.insert(id);
    }
}
