//! FB_Init of codesys: the organization blocks of a restart call it for every instance that lasts.

use std::collections::BTreeSet;

use sieben_model::block::BlockId;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Section;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Field, Structure};

use super::bodies::Bodies;
use super::environment::{BlockNames, Environment};
use super::types::holds_instance;
use super::{Declared, InitialAddress, ast};
use crate::scope::key;
use crate::st::ast::{MemberKind, TypeKind, VarSection};
use crate::st::check::construct::{Begun, Referring, construct, refer};
use crate::st::check::names::Names;
use crate::st::check::places::element_step;
use crate::st::check::{Block, Checked};
use crate::st::dialect::{Construct, Dialect, Judgement};
use crate::st::tree::{Base, Body, Place};

/// The method.
pub(super) const FB_INIT: &str = "FB_Init";
/// Instances of an array that are begun one by one; FB_Init of more than these is not called.
const ELEMENTS_MAX: u64 = 10_000;

/// What is done before the first cycle.
#[derive(Default)]
pub(super) struct Beginning {
    pub(super) body: Body,
    pub(super) called: BTreeSet<BlockId>,
    /// The first declaration with an FB_Init.
    pub(super) span: Span,
    /// Where references begin with an address already: what the variable says goes before what its block says.
    begun: BTreeSet<(u16, u32)>,
}

/// Where the walk is: an instance, or a list of global variables.
struct Within<'w, 'a> {
    place: Place,
    structure: &'w Structure,
    sections: Vec<&'a VarSection>,
    /// The function block whose instance it is.
    owner: Option<BlockId>,
    /// The list of global variables that it is.
    list: Option<&'w str>,
    dialect: Dialect,
}

impl<'a> Environment<'a> {
    /// The calls of FB_Init, those of inner instances first.
    pub(super) fn beginning(&self, bodies: &mut Bodies) -> Beginning {
        let mut beginning = Beginning::default();
        let has_any = self.items.objects.iter().any(|(block, _)| self.initializer(block).is_some());
        let constructed =
            |section: &&VarSection| section.declarations.iter().any(|one| matches!(one.data_type.kind, TypeKind::Constructed { .. }));
        let sections = self.items.code.values().flat_map(|code| &code.block.sections);
        self.misdeclared(bodies);
        if !has_any
            && self.addresses.is_empty()
            && !sections.chain(self.items.lists.iter().map(|list| list.section)).any(|section| constructed(&section))
        {
            return beginning;
        }
        for list in &self.items.lists {
            let Some(structure) = self.structure_of(list.number) else { continue };
            let place = Place { base: Base::DataBlock(list.number), offset: 0, indexes: Vec::new(), span: list.section.span };
            let (sections, name) = (vec![list.section], Some(list.name.as_str()));
            let within = Within { place, structure: &structure, sections, owner: None, list: name, dialect: list.dialect };
            self.begin_inside(&within, &mut beginning, bodies);
        }
        for program in &self.items.programs {
            let place = Place { base: Base::DataBlock(program.instance), offset: 0, indexes: Vec::new(), span: program.span };
            self.begin(program.block, &place, None, &[], program.span, &mut beginning, bodies);
        }
        beginning
    }

    /// Says which FB_Init does not begin with the two inputs that every one has; that of a broken declaration is told there.
    fn misdeclared(&self, bodies: &mut Bodies) {
        for (block, _) in self.items.objects.iter() {
            let Some(function) = self.initializer(block) else { continue };
            let Some(interface) = self.interface_of(function).filter(|_| self.declared(function).is_some_and(|found| !found.broken)) else {
                continue;
            };
            let inputs = interface.parameters().filter(|formal| formal.section == Section::Input).take(2);
            let Some(code) = self.items.code.get(&function) else { continue };
            if inputs.filter(|formal| formal.data_type == DataType::Bool).count() < 2 {
                let help = "Write `VAR_INPUT bInitRetains : BOOL; bInCopyCode : BOOL; END_VAR`, then the inputs of your own.";
                let message = "FB_Init begins with two inputs of the system, both BOOL";
                bodies.failed = true;
                bodies.diagnostics.push(Diagnostic::new(Problem::P6327, code.block.name.span, message).help(help));
            }
        }
    }

    /// The FB_Init that a block itself declares.
    fn initializer(&self, block: BlockId) -> Option<BlockId> {
        let object = self.items.objects.get(block)?;
        let method = object.members.get(&(key(FB_INIT), MemberKind::Method))?;
        (object.dialect.judge(Construct::PointerTo) != Judgement::Reject && !method.is_abstract).then_some(method.function)
    }

    /// One instance: what is in it, then the instance itself.
    #[allow(clippy::too_many_arguments)] // An instance, and what its declaration says.
    fn begin(
        &self,
        block: BlockId,
        place: &Place,
        within: Option<&Within<'_, 'a>>,
        arguments: &[ast::Argument],
        span: Span,
        beginning: &mut Beginning,
        bodies: &mut Bodies,
    ) {
        let mut line = vec![block];
        while let Some(base) = line.last().and_then(|&last| self.items.objects.get(last)?.base)
            && !line.contains(&base)
        {
            line.push(base);
        }
        line.reverse();
        let codes = line.iter().filter_map(|one| self.items.code.get(one));
        let sections: Vec<&VarSection> = codes.flat_map(|code| &code.block.sections).collect();
        if let (Some(code), Some(names)) =
            (self.items.code.get(&block), self.items.code.get(&block).and_then(|code| self.names(block, code.dialect)))
            && let Some(structure) = names.instance(block)
        {
            let place = place.clone();
            let inside = Within { place, structure: &structure, sections, owner: Some(block), list: None, dialect: code.dialect };
            self.begin_inside(&inside, beginning, bodies);
        }
        let initializers: Vec<BlockId> = line.iter().filter_map(|&one| self.initializer(one)).collect();
        let Some(&last) = initializers.last() else {
            if let Some(first) = arguments.first() {
                let message =
                    format!("`{}` has no FB_Init that takes arguments", self.items.names.get(&block).cloned().unwrap_or_default());
                bodies.failed = true;
                bodies.diagnostics.push(Diagnostic::new(Problem::P6327, first.span, message));
            }
            return;
        };
        for function in initializers {
            // What FB_Init of a base does not take is for the one that extends it.
            let takes = |argument: &&ast::Argument| {
                let Some(name) = &argument.name else { return true };
                function == last
                    || self.interface_of(function).is_some_and(|interface| interface.parameters().any(|formal| name.is(&formal.name)))
            };
            let arguments: Vec<ast::Argument> = arguments.iter().filter(takes).cloned().collect();
            let owner = within.and_then(|within| within.owner.map(|_| within.place.clone()));
            let begun = Begun { function, instance: place.clone(), owner, arguments: &arguments, span };
            self.take(within, span, beginning, bodies, |block, names| construct(block, names, &begun));
        }
    }

    /// A reference or a pointer that begins with an address.
    fn begin_reference(
        &self,
        within: &Within<'_, 'a>,
        field: &Field,
        address: &InitialAddress,
        beginning: &mut Beginning,
        bodies: &mut Bodies,
    ) {
        let InitialAddress { offset, data_type, value } = address;
        let offset = within.place.offset + field.offset + u32::try_from(*offset).unwrap_or(u32::MAX);
        if let Base::DataBlock(number) = within.place.base
            && !beginning.begun.insert((number, offset))
        {
            return;
        }
        let place = Place { offset, span: value.span, ..within.place.clone() };
        let owner = within.owner.map(|_| within.place.clone());
        let referring = Referring { place, name: &field.name, data_type, owner, value };
        self.take(Some(within), value.span, beginning, bodies, |block, names| refer(block, names, &referring));
    }

    /// Takes in what is done for one declaration, whose names are those of the block that declares it.
    fn take(
        &self,
        within: Option<&Within<'_, 'a>>,
        span: Span,
        beginning: &mut Beginning,
        bodies: &mut Bodies,
        make: impl FnOnce(&Block<'_>, &dyn Names) -> Checked,
    ) {
        let dialect = within.map_or_else(Dialect::default, |within| within.dialect);
        let checked_as = Block { id: BlockId::ob(100), dialect, body: &[], labels: &[], actions: &[], result: None, end: span };
        let nothing = Declared::default();
        let mut checked = match within.and_then(|within| self.names(within.owner?, dialect)) {
            Some(names) => make(&checked_as, &names),
            None => {
                let names = BlockNames::outside(self, &nothing, checked_as.id, dialect);
                make(&checked_as, &names.in_list(within.and_then(|within| within.list)))
            }
        };
        // A declaration is wrong once, however many instances it has.
        checked.diagnostics.retain(|new| !bodies.diagnostics.contains(new));
        bodies.diagnostics.append(&mut checked.diagnostics);
        bodies.failed |= checked.body.is_none();
        let Some(mut body) = checked.body else { return };
        if beginning.body.statements.is_empty() {
            beginning.span = span;
        }
        beginning.called.append(&mut checked.called);
        beginning.body.local_size = beginning.body.local_size.max(body.local_size);
        beginning.body.statements.append(&mut body.statements);
    }

    /// The instances among the variables of an instance or a list.
    fn begin_inside(&self, within: &Within<'_, 'a>, beginning: &mut Beginning, bodies: &mut Bodies) {
        for field in &within.structure.fields {
            let (element, count) = match &field.data_type {
                DataType::Array { bounds, element } => {
                    (&**element, bounds.iter().map(|(low, high)| (i64::from(*high) - i64::from(*low) + 1).max(0) as u64).product())
                }
                other => (other, 1),
            };
            let declared = within.sections.iter().flat_map(|section| &section.declarations);
            let declaration = declared.into_iter().find(|one| one.names.iter().any(|declared| declared.name.is(&field.name)));
            let addresses = declaration.and_then(|one| self.addresses.get(&one.initial.as_ref()?.span));
            for address in addresses.into_iter().flatten() {
                self.begin_reference(within, field, address, beginning, bodies);
            }
            if !holds_instance(element) || count > ELEMENTS_MAX {
                continue;
            }
            // Fields of structures are instances without arguments.
            let arguments: &[ast::Argument] = match declaration.map(|declaration| &declaration.data_type.kind) {
                Some(TypeKind::Constructed { arguments, .. }) => arguments,
                _ => &[],
            };
            let span = declaration.map_or(within.place.span, |declaration| declaration.span);
            for index in 0..count {
                let offset = within.place.offset + field.offset + (index as u32).saturating_mul(element_step(element));
                let place = Place { offset, span, ..within.place.clone() };
                match element {
                    DataType::Instance { block, .. } => self.begin(*block, &place, Some(within), arguments, span, beginning, bodies),
                    DataType::Struct(structure) => {
                        let inside = Within { place, structure, sections: Vec::new(), ..*within };
                        self.begin_inside(&inside, beginning, bodies);
                    }
                    _ => {}
                }
            }
        }
    }
}
