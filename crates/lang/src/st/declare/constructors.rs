//! FB_Init of codesys: the organization blocks of a restart call it for every instance that lasts.

use std::collections::BTreeSet;

use sieben_model::block::BlockId;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::interface::Section;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Field, Structure};

use super::bodies::Bodies;
use super::declaring::declares;
use super::environment::{BlockNames, Environment};
use super::interface::INITIAL;
use super::{Declared, InitialAddress, ast};
use crate::declarations::NESTING_MAX;
use crate::scope::key;
use crate::st::ast::{MemberKind, TypeKind, VarSection};
use crate::st::check::construct::{Begun, Referring, construct, refer};
use crate::st::check::names::Names;
use crate::st::check::places::element_step;
use crate::st::check::{Block, Checked};
use crate::st::dialect::Dialect;
use crate::st::tree::{Base, Body, Place, Statement, StatementKind};

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
    /// The declarations of its variables.
    declarations: Vec<&'a ast::Declaration>,
    /// The block that declares them.
    declared_in: Option<BlockId>,
    /// The instance that they belong to: what its names are inside, they are where it lies.
    owner: Option<Place>,
    /// The list of global variables that it is.
    list: Option<&'w str>,
    dialect: Dialect,
}

impl<'a> Environment<'a> {
    /// The calls of FB_Init, those of inner instances first.
    pub(super) fn beginning(&self, bodies: &mut Bodies) -> Beginning {
        let mut beginning = Beginning::default();
        let has_any = self.items.objects.iter().any(|(block, _)| self.initializer(block).is_some());
        let constructed = |section: &&VarSection| section.declarations.iter().any(|one| gives_arguments(&one.data_type.kind));
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
            let (declarations, name) = (list.section.declarations.iter().collect(), Some(list.name.as_str()));
            let within =
                Within { place, structure: &structure, declarations, declared_in: None, owner: None, list: name, dialect: list.dialect };
            self.begin_inside(&within, &mut beginning, bodies);
        }
        for program in &self.items.programs {
            let place = Place { base: Base::DataBlock(program.instance), offset: 0, indexes: Vec::new(), span: program.span };
            self.begin(program.block, &place, None, &[], program.span, &mut beginning, bodies);
        }
        // What instances of functions begin with at each call.
        for (owner, &number) in &self.items.kept {
            let (Some(structure), Some(code)) = (self.structure_of(number), self.items.code.get(owner)) else { continue };
            let place = Place { base: Base::DataBlock(number), offset: 0, indexes: Vec::new(), span: code.block.name.span };
            let declarations = code.block.sections.iter().flat_map(|section| &section.declarations).collect();
            let (structure, dialect) = (&*structure, code.dialect);
            let within = Within { place, structure, declarations, declared_in: Some(*owner), owner: None, list: None, dialect };
            self.begin_inside(&within, &mut beginning, bodies);
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
        (object.dialect.has_pointers() && !method.is_abstract).then_some(method.function)
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
        let mut line = self.items.line(block);
        line.reverse();
        let codes = line.iter().filter_map(|one| self.items.code.get(one));
        let sections = codes.flat_map(|code| &code.block.sections);
        let declarations: Vec<&ast::Declaration> = sections.flat_map(|section| &section.declarations).collect();
        if let (Some(code), Some(names)) =
            (self.items.code.get(&block), self.items.code.get(&block).and_then(|code| self.names(block, code.dialect)))
            && let Some(structure) = names.instance(block)
        {
            let (place, owner) = (place.clone(), Some(place.clone()));
            let (structure, dialect) = (&*structure, code.dialect);
            let inside = Within { place, structure, declarations, declared_in: Some(block), owner, list: None, dialect };
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
        let Some(arguments) = self.named_arguments(last, arguments, bodies) else { return };
        for function in initializers {
            // What FB_Init of a base does not take is for the one that extends it.
            let takes = |argument: &&ast::Argument| {
                let Some(name) = &argument.name else { return true };
                function == last
                    || self.interface_of(function).is_some_and(|interface| interface.parameters().any(|formal| name.is(&formal.name)))
            };
            let arguments: Vec<ast::Argument> = arguments.iter().filter(takes).cloned().collect();
            let owner = within.and_then(|within| within.owner.clone());
            let begun = Begun { function, instance: place.clone(), owner, arguments: &arguments, span };
            self.take(within, span, beginning, bodies, |block, names| construct(block, names, &begun));
        }
    }

    /// Arguments by position with the names of the inputs that they are for; `None` if there are no such inputs, which is reported.
    fn named_arguments(&self, function: BlockId, arguments: &[ast::Argument], bodies: &mut Bodies) -> Option<Vec<ast::Argument>> {
        let interface = self.interface_of(function);
        let takes = |formal: &&sieben_model::interface::Variable| matches!(formal.section, Section::Input | Section::InOut);
        let formals: Vec<_> = interface.iter().flat_map(|interface| interface.parameters()).filter(takes).skip(2).collect();
        let mut wrong = |span, message: String| {
            let inputs: Vec<String> = formals.iter().map(|formal| format!("`{}`", formal.name)).collect();
            let help = match inputs.as_slice() {
                [] => "It takes none.".to_owned(),
                inputs => format!("It takes {}.", inputs.join(", ")),
            };
            let diagnostic = Diagnostic::new(Problem::P6327, span, message).help(help);
            bodies.failed = true;
            if !bodies.diagnostics.contains(&diagnostic) {
                bodies.diagnostics.push(diagnostic);
            }
            None
        };
        let shown = self.items.names.get(&function).cloned().unwrap_or_default();
        let mut named = Vec::with_capacity(arguments.len());
        for (index, argument) in arguments.iter().enumerate() {
            match (&argument.name, formals.get(index)) {
                (Some(name), _) if !formals.iter().any(|formal| name.is(&formal.name)) => {
                    return wrong(name.span, format!("`{shown}` has no input `{}`", name.text));
                }
                (Some(_), _) => named.push(argument.clone()),
                (None, Some(formal)) => {
                    let name = ast::Name { text: formal.name.clone(), span: argument.span, ..ast::Name::default() };
                    named.push(ast::Argument { name: Some(name), ..argument.clone() });
                }
                (None, None) => {
                    return wrong(argument.span, format!("`{shown}` takes {} arguments here, not {}", formals.len(), arguments.len()));
                }
            }
        }
        Some(named)
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
        let owner = within.owner.clone();
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
        let mut checked = match within.and_then(|within| self.names(within.declared_in?, dialect)) {
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
            if field.name.strip_suffix(INITIAL).is_some_and(|name| within.structure.field(name).is_some()) {
                continue;
            }
            let before = beginning.body.statements.len();
            self.begin_field(field, within, beginning, bodies);
            // What does not last begins at each call with what it begins with here: at its own place, where its pointers lead.
            let whole = within.structure.field(&format!("{}{INITIAL}", field.name));
            if let Some(whole) = whole.filter(|_| beginning.body.statements.len() > before) {
                let span = within.place.span;
                let place = |field: &Field| Place { offset: within.place.offset + field.offset, ..within.place.clone() };
                let bytes = u32::try_from(field.data_type.bits().div_ceil(8)).unwrap_or(u32::MAX);
                let copy = |target, source| Statement { kind: StatementKind::Copy { target, source, bytes }, span };
                beginning.body.statements.insert(before, copy(place(field), place(whole)));
                beginning.body.statements.push(copy(place(whole), place(field)));
            }
        }
    }

    /// A variable of an instance or a list: the addresses that it begins with, and the instances in it.
    fn begin_field(&self, field: &Field, within: &Within<'_, 'a>, beginning: &mut Beginning, bodies: &mut Bodies) {
        let declaration = within.declarations.iter().copied().find(|one| declares(one, &field.name));
        let addresses = declaration.and_then(|one| self.addresses.get(&one.initial.as_ref()?.span));
        for address in addresses.into_iter().flatten() {
            self.begin_reference(within, field, address, beginning, bodies);
        }
        let (count, innermost) = elements(&field.data_type);
        if !innermost.holds_instance() || count > ELEMENTS_MAX {
            return;
        }
        let (arguments, given) = declaration.and_then(|one| self.constructed(&one.data_type.kind)).unwrap_or_default();
        let span = declaration.map_or(within.place.span, |declaration| declaration.span);
        // A type that has arguments for its elements gives them to each variable of it.
        let own = declaration.is_some_and(|one| gives_arguments(&one.data_type.kind));
        let fits = if own { given.len() as u64 == count } else { count.is_multiple_of(given.len() as u64) };
        if !given.is_empty() && !fits {
            let message = format!("`{}` has {count} elements, and arguments are given for {} of them", field.name, given.len());
            bodies.failed = true;
            bodies.diagnostics.push(Diagnostic::new(Problem::P6327, span, message).help("Give each element its own, in order."));
            return;
        }
        let mut offsets = Vec::new();
        element_offsets(&field.data_type, within.place.offset + field.offset, &mut offsets);
        for (index, offset) in offsets.into_iter().enumerate() {
            let arguments = if given.is_empty() { arguments } else { &given[index % given.len()] };
            let place = Place { offset, span, ..within.place.clone() };
            match innermost {
                DataType::Instance { block, .. } => self.begin(*block, &place, Some(within), arguments, span, beginning, bodies),
                DataType::Struct(structure) => {
                    let declarations = self.fields_of(declaration.map(|one| &one.data_type.kind), structure.name.as_deref());
                    let (list, dialect, owner) = (within.list, within.dialect, within.owner.clone());
                    let inside = Within { place, structure, declarations, declared_in: within.declared_in, owner, list, dialect };
                    self.begin_inside(&inside, beginning, bodies);
                }
                _ => {}
            }
        }
    }
}

/// How many elements an array of arrays has in all, and what they are.
fn elements(data_type: &DataType) -> (u64, &DataType) {
    match data_type {
        DataType::Array { element, .. } => {
            let (inside, innermost) = elements(element);
            (data_type.elements().saturating_mul(inside), innermost)
        }
        other => (1, other),
    }
}

/// Where the elements of an array of arrays lie, in order.
fn element_offsets(data_type: &DataType, offset: u32, found: &mut Vec<u32>) {
    let DataType::Array { element, .. } = data_type else { return found.push(offset) };
    for index in 0..data_type.elements() {
        element_offsets(element, offset.saturating_add((index as u32).saturating_mul(element_step(element))), found);
    }
}

impl<'a> Environment<'a> {
    /// The declarations of the fields of a structure, by what is written where its variable is declared, or by its name.
    fn fields_of(&self, written: Option<&'a TypeKind>, name: Option<&str>) -> Vec<&'a ast::Declaration> {
        match written {
            Some(TypeKind::Struct { fields, .. }) => return fields.iter().collect(),
            Some(TypeKind::Array { element, .. }) => return self.fields_of(Some(&element.kind), name),
            _ => {}
        }
        let mut found = Vec::new();
        let mut wanted = name.map(key);
        // A structure has the fields of what it extends.
        for _ in 0..NESTING_MAX {
            let Some(declaration) = wanted.take().and_then(|name| self.type_named(&name)) else { break };
            if let TypeKind::Struct { fields, .. } = &declaration.data_type.kind {
                found.extend(fields);
            }
            wanted = declaration.extends.as_ref().and_then(|path| path.names.last()).map(|name| key(&name.text));
        }
        found
    }

    /// What a declaration gives to FB_Init, by itself or by the type that it names: to an instance, or to each element of an array.
    fn constructed(&self, kind: &'a TypeKind) -> Option<(&'a [ast::Argument], &'a [Vec<ast::Argument>])> {
        let mut kind = kind;
        for _ in 0..NESTING_MAX {
            kind = match kind {
                TypeKind::Constructed { arguments, elements, .. } => return Some((arguments, elements)),
                TypeKind::Array { element, .. } => &element.kind,
                TypeKind::Named(path) => &self.type_named(&path.names.last()?.text)?.data_type.kind,
                _ => return None,
            };
        }
        None
    }

    /// The type that a name means, wherever it is declared.
    fn type_named(&self, name: &str) -> Option<&'a ast::TypeDeclaration> {
        let name = key(name);
        let own = |full: &str| full.rsplit('.').next().is_some_and(|own| own == name);
        let all = &self.items.types;
        let found = all.get(&name).or_else(|| all.iter().find(|(full, _)| own(full)).map(|(_, found)| found));
        found.map(|found| found.declaration)
    }
}

/// Whether a declaration gives arguments to FB_Init.
fn gives_arguments(kind: &TypeKind) -> bool {
    match kind {
        TypeKind::Constructed { .. } => true,
        TypeKind::Array { element, .. } => gives_arguments(&element.kind),
        _ => false,
    }
}
