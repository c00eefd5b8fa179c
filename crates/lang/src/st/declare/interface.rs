//! VAR sections of a block → its interface, and what its names stand for.

use std::collections::HashMap;
use std::sync::Arc;

use sieben_model::address::Area;
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::{Section, Variable as Declaration};
use sieben_model::literal::Value;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Field, Structure, place};

use super::access::{OpenAddress, open_type};
use super::initial::bytes;
use super::items::{Code, INITIAL_CALL, Items};
use super::types::Resolver;
use super::{Declared, Located, Types, WatchedEdge, ast, globals};
use crate::declarations::BLOCK_BYTES_MAX;
use crate::declarations::interface::{Declared as Unplaced, is_complex, lay_out, lay_out_behind};
use crate::declarations::types::{BlockInterface, describe};
use crate::scope::key;
use crate::st::check::members::is_super;
use crate::st::check::names::{Entity, Role, Variable};
use crate::st::check::walk;
use crate::st::dialect::Construct;
use crate::st::objects::TYPE_NUMBER;
use crate::st::open_arrays::{bound_names, is_open};
use crate::st::tree::{Base, Local};
use crate::st::variants::{Told, is_variant, told_name};

/// What stands behind the name of an instance that does not last in the name of what it begins with.
pub(super) const INITIAL: &str = "__INITIAL";

/// What remembers that an organization block was called since the restart.
const CALLED: &str = "__CALLED";

/// The input of an organization block that tells whether there are retentive data: a restart always finds them.
const REMANENCE: &str = "Remanence";

/// Where the variables of a section lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Store {
    /// In the interface of the block.
    Interface(Section),
    /// In the data block that a function has for what it keeps.
    Kept,
}

/// A variable before it has a place.
struct Pending {
    name: String,
    store: Store,
    role: Role,
    data_type: DataType,
    initial: Vec<Value>,
    comment: String,
    span: Span,
}

/// `view AT x`.
struct View {
    name: ast::Name,
    of: ast::Name,
    data_type: DataType,
}

/// The interface of a block of ST, laid out; what its names stand for is kept in [`super::Known`]. `None` if it has too many bytes.
pub(crate) fn interface_of<'a>(types: &mut Types<'a>, items: &'a Items<'a>, id: BlockId) -> Option<BlockInterface> {
    let code = *items.code.get(&id)?;
    let before = types.errors();
    let mut sections = Sections {
        resolver: Resolver::new(types, items, code.dialect).within(code.space),
        id,
        pending: Vec::new(),
        views: Vec::new(),
        located: Vec::new(),
        inherited: Vec::new(),
        inherited_edges: Vec::new(),
        edges: Vec::new(),
        places: HashMap::new(),
        twice: Vec::new(),
        begin_again: Vec::new(),
        partial: false,
    };
    sections.resolver.own = Some(id);
    let base = sections.base(id);
    sections.owner(code);
    sections.constants(code);
    for section in &code.block.sections {
        sections.section(section);
    }
    if id.kind == BlockKind::Function {
        sections.result(code);
    }
    let Sections { resolver, pending, views, located, inherited, inherited_edges, edges, twice, begin_again, partial, .. } = sections;
    let is_of_library = items.is_of_library(id);
    let unplaced = pending.iter().enumerate().filter_map(|(index, one)| {
        let unplaced = one.unplaced()?;
        let around = if is_of_library { around(&pending, index) } else { None };
        Some(match around {
            Some(section) => unplaced.beside(section),
            None => unplaced,
        })
    });
    let unplaced: Vec<Unplaced> = unplaced.collect();
    let laid_out = lay_out_behind(id, base.as_ref(), unplaced);
    let Some(mut block) = laid_out else {
        let message = format!("the variables of `{id}` need more than {BLOCK_BYTES_MAX} bytes (4 for each parameter of a function)");
        types.report(Problem::P5002, code.block.name.span, message);
        return None;
    };
    if let Some(name) = items.names.get(&id) {
        // Messages call an instance by the name of its block.
        Arc::make_mut(&mut block.instance).name = Some(name.clone());
    }
    let mut declared = Declared { names: resolver.names, variables: inherited, edges: inherited_edges, ..Declared::default() };
    let kept = kept_structure(&pending);
    if let (Some(structure), Some(&number)) = (kept.clone(), items.kept.get(&id)) {
        types.known.statics.push((number, structure));
    }
    let keep = items.kept.get(&id).copied();
    let initialised = code.dialect.switches().temporaries_initialised;
    let mut by_name: HashMap<&str, Vec<&Declaration>> = HashMap::new();
    for variable in &block.interface.variables {
        by_name.entry(&variable.name).or_default().push(variable);
    }
    for one in pending {
        let Some(variable) = placed(&one, id, &by_name, kept.as_deref(), keep) else { continue };
        let local = variable.base == Base::Area(Area::Local);
        if local {
            // A text needs its room: the first byte says how much there is.
            let text = matches!(one.data_type, DataType::String(_) | DataType::WideString(_));
            let starts = initialised || text || !one.initial.is_empty() || one.role == Role::Input;
            let initial = starts.then(|| bytes(&one.data_type, &one.initial));
            declared.locals.push(Local { position: variable.offset, data_type: one.data_type.clone(), initial });
        }
        match one.role {
            Role::Result => {
                let name = code.block.member.as_ref().map_or(&code.block.name, |member| &member.name);
                declared.names.insert(key(&name.text), Entity::Variable(variable.clone()));
                declared.result = Some((variable, one.initial));
                continue;
            }
            Role::Output if id.kind == BlockKind::Function && initialised => {
                declared.outputs.push((variable.clone(), one.initial));
            }
            _ => {}
        }
        declared.names.insert(key(&one.name), Entity::Variable(variable.clone()));
        declared.variables.push(variable);
    }
    declared.locals.sort_by_key(|local| local.position);
    for variable in located {
        declared.names.insert(key(&variable.name), Entity::Variable(variable.clone()));
        declared.variables.push(variable);
    }
    for (names, edge) in edges {
        let variable = |name: &String| match declared.names.get(&key(name)) {
            Some(Entity::Variable(variable)) => Some(variable.clone()),
            _ => None,
        };
        let [input, was, now] = &names;
        let (Some(input), Some(was), Some(now)) = (variable(input), variable(was), variable(now)) else { continue };
        // The statements see the edge under the name of the input.
        let seen = Variable { name: input.name.clone(), role: Role::Input, span: input.span, ..now };
        declared.names.insert(key(&input.name), Entity::Variable(seen.clone()));
        declared.edges.push(WatchedEdge { input, was, now: seen, edge });
    }
    for (name, whole) in begin_again {
        // What the instance begins with has no name in the statements.
        let whole = declared.names.remove(&key(&whole));
        declared.variables.retain(|one| one.name != format!("{name}{INITIAL}"));
        if let (Some(Entity::Variable(variable)), Some(Entity::Variable(whole))) = (declared.names.get(&key(&name)), whole) {
            declared.begin_again.push((variable.clone(), whole));
        }
    }
    let variable = |name: &str| match declared.names.get(&key(name)) {
        Some(Entity::Variable(variable)) if id.kind == BlockKind::OrganizationBlock => Some(variable.clone()),
        _ => None,
    };
    declared.first_call = variable(INITIAL_CALL).zip(variable(CALLED));
    for view in views {
        view.declare(types, &mut declared);
    }
    let members = named_like_members(types, items, id, &declared);
    // Which of the two is meant where the name is used, nobody knows (decision 270).
    for name in twice.iter().chain(&members) {
        declared.names.insert(key(&name.text), unknown(name));
    }
    declared.nameless = code.block.sections.iter().any(|section| section.nameless);
    declared.broken = partial || types.errors() > before;
    types.known.blocks.insert(id, Arc::new(declared));
    Some(block)
}

/// The section of parameters on both sides of a static variable, if it is one: in blocks of the library it lies between these (decision 352).
fn around(pending: &[Pending], index: usize) -> Option<Section> {
    let parameters = |one: &Pending| match one.store {
        Store::Interface(section @ (Section::Input | Section::Output)) => Some(section),
        _ => None,
    };
    let (before, behind) = pending.split_at(index);
    let is_static = behind[0].store == Store::Interface(Section::Static);
    let section = before.iter().rev().find_map(parameters).filter(|_| is_static)?;
    (behind.iter().find_map(parameters) == Some(section)).then_some(section)
}

/// The variables of a block that are called like one of its members, which is said here.
fn named_like_members(types: &mut Types<'_>, items: &Items<'_>, id: BlockId, declared: &Declared) -> Vec<ast::Name> {
    let mut found: Vec<ast::Name> = Vec::new();
    let Some(object) = items.objects.get(id) else { return found };
    for member in object.members.values() {
        // GET and SET have one name.
        if found.iter().any(|known| known.is(&member.name)) {
            continue;
        }
        let Some(Entity::Variable(variable)) = declared.names.get(&key(&member.name)) else { continue };
        if variable.data_type != DataType::Void {
            let message = format!("`{}` is declared twice in `{}`", member.name, object.name);
            let report = types.report(Problem::P3006, member.span, message);
            report.related.push((variable.span, "first declared here".to_owned()));
            report.help = Some("Give the member or the variable another name.".to_owned());
        }
        found.push(ast::Name { text: member.name.clone(), span: member.span, ..ast::Name::default() });
    }
    found
}

impl Pending {
    fn unplaced(&self) -> Option<Unplaced> {
        let Store::Interface(section) = self.store else { return None };
        Some(Unplaced::from_variable(Declaration {
            name: self.name.clone(),
            section,
            data_type: self.data_type.clone(),
            offset: 0,
            initial: self.initial.clone(),
            comment: self.comment.clone(),
            span: self.span,
        }))
    }
}

impl View {
    fn declare(self, types: &mut Types<'_>, declared: &mut Declared) {
        let Some(Entity::Variable(variable)) = declared.names.get(&key(&self.of.text)).cloned() else {
            let message = format!("`{}` is no variable of this block before `{}`", self.of.text, self.name.text);
            types.report(Problem::P3001, self.of.span, message);
            return;
        };
        // The type of the variable is told to be none already.
        if variable.data_type == DataType::Void {
            declared.names.insert(key(&self.name.text), unknown(&self.name));
            return;
        }
        if self.data_type.bits() > variable.data_type.bits() {
            let message = format!("{} is longer than `{}`, {}", describe(&self.data_type), self.of.text, describe(&variable.data_type));
            types.report(Problem::P6127, self.name.span, message);
            return;
        }
        let view = Variable { name: self.name.text.clone(), data_type: self.data_type, span: self.name.span, ..variable };
        declared.names.insert(key(&view.name), Entity::Variable(view.clone()));
        declared.variables.push(view);
    }
}

/// The fields of what a function keeps.
fn kept_structure(pending: &[Pending]) -> Option<Arc<Structure>> {
    let mut structure = Structure::default();
    let mut cursor = 0;
    for one in pending.iter().filter(|one| one.store == Store::Kept) {
        let (offset, behind) = place(cursor, &one.data_type);
        cursor = behind;
        structure.fields.push(Field {
            name: one.name.clone(),
            data_type: one.data_type.clone(),
            offset: u32::try_from(offset).ok()?,
            initial: one.initial.clone(),
            comment: one.comment.clone(),
        });
    }
    if structure.fields.is_empty() || cursor > BLOCK_BYTES_MAX * 8 {
        return None;
    }
    structure.size = (cursor.next_multiple_of(16) / 8) as u32;
    Some(Arc::new(structure))
}

/// A variable with its place.
fn placed(
    one: &Pending,
    id: BlockId,
    by_name: &HashMap<&str, Vec<&Declaration>>,
    kept: Option<&Structure>,
    keep: Option<u16>,
) -> Option<Variable> {
    let (base, offset) = match one.store {
        Store::Kept => (Base::DataBlock(keep?), kept?.field(&one.name)?.offset),
        Store::Interface(section) => {
            let variable = by_name.get(one.name.as_str())?.iter().find(|variable| variable.section == section)?;
            match (section, id.kind) {
                (Section::Temp, _) => (Base::Area(Area::Local), variable.offset),
                (_, BlockKind::Function) => {
                    let index = u16::try_from(variable.offset).ok()?;
                    (if is_complex(&one.data_type) { Base::ComplexParameter(index) } else { Base::Parameter(index) }, 0)
                }
                (Section::InOut, _) if is_complex(&one.data_type) => (Base::InstancePointer(variable.offset), 0),
                _ => (Base::Instance, variable.offset),
            }
        }
    };
    Some(Variable { name: one.name.clone(), role: one.role, data_type: one.data_type.clone(), base, offset, span: one.span })
}

/// The VAR sections of a block on the way to its interface.
struct Sections<'t, 'a> {
    resolver: Resolver<'t, 'a>,
    id: BlockId,
    pending: Vec<Pending>,
    views: Vec<View>,
    /// Variables with an address.
    located: Vec<Variable>,
    /// The variables of the block that this one extends.
    inherited: Vec<Variable>,
    /// The inputs of that block of which the statements see the edges.
    inherited_edges: Vec<WatchedEdge>,
    /// Inputs of which the statements see the edges: the names of the input, of what it was, and of the edge.
    edges: Vec<([String; 3], ast::Edge)>,
    /// Where names were declared.
    places: HashMap<String, Span>,
    /// Names that are declared twice.
    twice: Vec<ast::Name>,
    /// Instances that do not last, with the variables that hold what they begin with at each call.
    begin_again: Vec<(String, String)>,
    /// Whether a declaration was not understood, which may have been said when it was read.
    partial: bool,
}

/// How a section begins.
fn keyword(kind: ast::SectionKind) -> &'static str {
    match kind {
        ast::SectionKind::Var => "VAR",
        ast::SectionKind::Input => "VAR_INPUT",
        ast::SectionKind::Output => "VAR_OUTPUT",
        ast::SectionKind::InOut => "VAR_IN_OUT",
        ast::SectionKind::Temp => "VAR_TEMP",
        ast::SectionKind::Static => "VAR_STAT",
        ast::SectionKind::Instance => "VAR_INST",
        ast::SectionKind::Global => "VAR_GLOBAL",
        ast::SectionKind::External => "VAR_EXTERNAL",
        ast::SectionKind::Config => "VAR_CONFIG",
        ast::SectionKind::Access => "VAR_ACCESS",
        ast::SectionKind::Const => "CONST",
    }
}

/// Whether declarations of a section are constants that need no memory: those with a single value.
pub(super) fn is_constant(section: &ast::VarSection, declaration: &ast::Declaration) -> bool {
    let constant = section.kind == ast::SectionKind::Const || section.has(ast::Qualifier::Constant);
    let single = match &declaration.initial {
        Some(initial) => matches!(initial.kind, ast::InitializerKind::Expression(_)),
        None => matches!(declaration.data_type.kind, ast::TypeKind::Inferred),
    };
    constant && single && declaration.location.is_none()
}

impl<'a> Sections<'_, 'a> {
    /// What the instance of the block begins with: that of the block that it extends, or the number that says of which block it is.
    fn base(&mut self, id: BlockId) -> Option<BlockInterface> {
        let items = self.resolver.items;
        if !items.objects.is_typed(id) {
            return None;
        }
        let number = vec![Value::Word(id.number)];
        let object = items.objects.get(id)?;
        let Some(base) = object.base else {
            let variable = Declaration {
                name: TYPE_NUMBER.to_owned(),
                section: Section::Static,
                data_type: DataType::Word,
                offset: 0,
                initial: number,
                comment: String::new(),
                span: object.span,
            };
            return lay_out(id, vec![Unplaced::from_variable(variable)]);
        };
        let mut found = self.resolver.types.interface(base, object.span)?;
        let of_type = |name: &str| name == TYPE_NUMBER;
        let interface = Arc::make_mut(&mut found.interface);
        interface.variables.iter_mut().filter(|variable| of_type(&variable.name)).for_each(|variable| variable.initial.clone_from(&number));
        let instance = Arc::make_mut(&mut found.instance);
        instance.fields.iter_mut().filter(|field| of_type(&field.name)).for_each(|field| field.initial.clone_from(&number));
        if let Some(declared) = self.resolver.types.known.blocks.get(&base) {
            for (name, entity) in declared.names.iter().filter(|(_, entity)| entity.is_of_instance()) {
                if let Entity::Variable(variable) = entity {
                    self.places.insert(name.clone(), variable.span);
                }
                self.resolver.names.insert(name.clone(), entity.clone());
            }
            // The statements of the base look for the edges themselves where SUPER calls them.
            let code = items.code.get(&id);
            if !code.is_some_and(|code| calls_super(&code.block.body)) {
                self.inherited_edges.clone_from(&declared.edges);
            }
            self.inherited = declared.variables.iter().filter(|variable| variable.is_of_instance()).cloned().collect();
        }
        Some(found)
    }

    /// Makes the constants of the block known that a method belongs to, and the variables that the method keeps there.
    fn owner(&mut self, code: Code<'a>) {
        let Some(member) = &code.block.member else { return };
        let items = self.resolver.items;
        let Some(owner) = items.block_in(code.space, &member.of.text) else { return };
        if self.resolver.types.interface(owner, member.of.span).is_none() {
            return;
        }
        let Some(declared) = self.resolver.types.known.blocks.get(&owner) else { return };
        for (name, entity) in &declared.names {
            if matches!(entity, Entity::Constant(_) | Entity::EnumValue { .. }) {
                self.resolver.names.insert(name.clone(), entity.clone());
            }
        }
        for (name, inside) in &member.kept {
            if let Some(entity) = declared.names.get(&key(inside)) {
                self.places.insert(key(&name.text), name.span);
                self.resolver.names.insert(key(&name.text), entity.clone());
            }
        }
    }

    /// Makes the constants of the block known, whichever stands first.
    fn constants(&mut self, code: Code<'a>) {
        for section in &code.block.sections {
            for declaration in section.declarations.iter().filter(|declaration| is_constant(section, declaration)) {
                for declared in &declaration.names {
                    if self.is_first(&declared.name) {
                        self.resolver.constant_declarations.insert(key(&declared.name.text), declaration);
                    }
                }
            }
        }
        for section in &code.block.sections {
            for declaration in section.declarations.iter().filter(|declaration| is_constant(section, declaration)) {
                for declared in &declaration.names {
                    let wanted = key(&declared.name.text);
                    if self.resolver.constant_declarations.remove(&wanted).is_some()
                        && let Some(constant) = self.resolver.declared_constant(declaration)
                    {
                        self.resolver.names.insert(wanted, Entity::Constant(constant));
                    }
                }
            }
        }
    }

    /// Whether a name is not declared yet; else it is reported.
    fn is_first(&mut self, name: &ast::Name) -> bool {
        if name.text.is_empty() {
            return false;
        }
        match self.places.get(&key(&name.text)) {
            Some(&first) => {
                let message = format!("`{}` is declared twice in this block", name.text);
                let report = self.resolver.report(Problem::P3006, name.span, message);
                report.related.push((first, "first declared here".to_owned()));
                self.twice.push(name.clone());
                false
            }
            None => {
                self.places.insert(key(&name.text), name.span);
                true
            }
        }
    }

    /// Where the variables of a section lie, and what may be done with them; `None` if the block has no such section.
    fn store(&self, section: &ast::VarSection) -> Option<(Store, Role)> {
        use ast::SectionKind as Kind;
        let has_instance = self.id.kind == BlockKind::FunctionBlock;
        let kept = self.resolver.items.kept.contains_key(&self.id);
        let (store, role) = match section.kind {
            // The CPU gives them; they lie in the local data.
            Kind::Input if self.id.kind == BlockKind::OrganizationBlock && self.resolver.dialect.switches().organization_block_inputs => {
                (Store::Interface(Section::Temp), Role::Input)
            }
            Kind::Input if self.id.kind != BlockKind::OrganizationBlock => (Store::Interface(Section::Input), Role::Input),
            Kind::Output if self.id.kind != BlockKind::OrganizationBlock => (Store::Interface(Section::Output), Role::Output),
            Kind::InOut if self.id.kind != BlockKind::OrganizationBlock => (Store::Interface(Section::InOut), Role::InOut),
            Kind::Var if has_instance => (Store::Interface(Section::Static), Role::Static),
            // A program has one instance, whose variables it is.
            Kind::Static if has_instance && !kept => (Store::Interface(Section::Static), Role::Static),
            Kind::Static => (Store::Kept, Role::Static),
            Kind::Var if kept && section.has(ast::Qualifier::Constant) => (Store::Kept, Role::Constant),
            Kind::Var | Kind::Temp => (Store::Interface(Section::Temp), Role::Temp),
            _ => return None,
        };
        Some((store, if section.has(ast::Qualifier::Constant) { Role::Constant } else { role }))
    }

    fn section(&mut self, section: &'a ast::VarSection) {
        self.partial |= section.partial;
        if section.kind == ast::SectionKind::External {
            return self.external(section);
        }
        let variables = section.declarations.iter().filter(|declaration| !is_constant(section, declaration));
        let Some((store, role)) = self.store(section) else {
            if section.kind != ast::SectionKind::Const {
                let message = format!("`{}` has no place in an {}", keyword(section.kind), self.id.kind.abbreviation());
                self.resolver.report(Problem::P2201, section.span, message);
            }
            for declaration in variables {
                self.unknown(declaration);
            }
            return;
        };
        // Statics would need a data block, which an organization block has not.
        if self.id.kind == BlockKind::OrganizationBlock
            && section.kind == ast::SectionKind::Var
            && role == Role::Temp
            && self.resolver.dialect.switches().numbered_blocks
        {
            let span = Span { end: section.span.start + 3, ..section.span };
            let message = "`VAR` of an organization block lasts for one call, and begins on the start information";
            self.resolver.report(Problem::P6332, span, message);
        }
        let known = self.pending.len();
        for declaration in variables {
            self.declaration(declaration, store, role, section.has(ast::Qualifier::Retain));
        }
        if self.id.kind == BlockKind::OrganizationBlock && role == Role::Input {
            self.given_by_cpu(known);
        }
    }

    /// The inputs of an organization block, which begin behind so many variables: what they hold, unless it is 0 and FALSE.
    fn given_by_cpu(&mut self, known: usize) {
        let mut remembers = None;
        for input in self.pending.iter_mut().skip(known).filter(|input| input.data_type == DataType::Bool) {
            if input.name.eq_ignore_ascii_case(REMANENCE) {
                input.initial = vec![Value::Bool(true)];
            } else if input.name.eq_ignore_ascii_case(INITIAL_CALL) {
                remembers = Some(input.span);
            }
        }
        self.pending.extend(remembers.map(|span| Pending {
            name: CALLED.to_owned(),
            store: Store::Kept,
            role: Role::Static,
            data_type: DataType::Bool,
            initial: Vec::new(),
            comment: String::new(),
            span,
        }));
    }

    /// The names of a declaration that was not understood stay declared, so that their uses are not reported too.
    fn unknown(&mut self, declaration: &ast::Declaration) {
        self.partial = true;
        for declared in &declaration.names {
            if self.is_first(&declared.name) {
                self.resolver.names.insert(key(&declared.name.text), unknown(&declared.name));
            }
        }
    }

    fn declaration(&mut self, declaration: &'a ast::Declaration, store: Store, role: Role, retain: bool) {
        let (input, in_out) = (Store::Interface(Section::Input), Store::Interface(Section::InOut));
        // A function gets the array of the caller either way; from an input it only reads.
        let open = (store == in_out || store == input && self.id.kind == BlockKind::Function)
            && matches!(declaration.data_type.kind, ast::TypeKind::Array { .. });
        self.resolver.open_arrays = open;
        let Some((data_type, named)) = self.resolver.type_and_initial(&declaration.data_type) else {
            return self.unknown(declaration);
        };
        // Organization blocks are told a data block by its number.
        let given = self.id.kind == BlockKind::OrganizationBlock && role == Role::Input && data_type == DataType::BlockData;
        let data_type = if given { DataType::Word } else { data_type };
        let read_only = store == input && is_open(&data_type);
        if read_only && !self.resolver.judge(Construct::OpenArrayInput, declaration.data_type.span) {
            return self.unknown(declaration);
        }
        let role = if read_only { Role::Constant } else { role };
        let (store, begins_again) = match self.local_instance(&data_type, store) {
            Some(store) => (store, true),
            None => (store, false),
        };
        if let Some((problem, why)) = misplaced(&data_type, store) {
            let message = format!("{} may not stand here: {why}", self.resolver.dialect.type_words(&data_type));
            self.resolver.report(problem, declaration.data_type.span, message);
            return self.unknown(declaration);
        }
        if store != Store::Interface(Section::InOut) {
            self.resolver.no_abstract(&data_type, declaration.data_type.span);
        }
        if declaration.edge.is_some()
            && (self.id.kind != BlockKind::FunctionBlock || store != Store::Interface(Section::Input) || data_type != DataType::Bool)
        {
            let message = "R_EDGE and F_EDGE stand behind a BOOL in VAR_INPUT of a function block or program";
            self.resolver.report(Problem::P4009, declaration.span, message);
            return self.unknown(declaration);
        }
        let of_instance = matches!(store, Store::Interface(Section::Static | Section::Input | Section::Output));
        let lasts = self.id.kind == BlockKind::FunctionBlock && of_instance;
        self.resolver.later = self.resolver.begins_later(lasts && declaration.location.is_none());
        let initial = match &declaration.initial {
            Some(initializer) if store == Store::Interface(Section::InOut) => {
                let message = "VAR_IN_OUT keeps no initial value; the variable that is given has one";
                self.resolver.report(Problem::P2212, initializer.span, message);
                Vec::new()
            }
            Some(initializer) => self.resolver.initial(initializer, &data_type),
            None => named,
        };
        for declared in &declaration.names {
            let name = &declared.name;
            if !self.is_first(name) {
                continue;
            }
            match self.resolver.linked(declaration.location.as_ref(), name.span) {
                Some(ast::Location::View(of)) => {
                    self.views.push(View { name: name.clone(), of: of.clone(), data_type: data_type.clone() });
                }
                Some(ast::Location::Relative { span, .. }) => {
                    let message = "such an address is one in a STRUCT; a variable lies in an area, as in `%MW10`";
                    self.resolver.report(Problem::P6127, *span, message);
                    self.resolver.names.insert(key(&name.text), unknown(name));
                }
                // VAR_ACCESS, which is told to be none of a block.
                Some(ast::Location::Path(_)) => {
                    self.resolver.names.insert(key(&name.text), unknown(name));
                }
                Some(ast::Location::Address(address))
                    if address.position == ast::Position::Open
                        && self.id.kind == BlockKind::FunctionBlock
                        && store == Store::Interface(Section::Static) =>
                {
                    let open = OpenAddress {
                        block: self.id,
                        name: name.text.clone(),
                        data_type: data_type.clone(),
                        area: address.area,
                        span: name.span,
                    };
                    self.resolver.types.known.open.push(open);
                    if let Some(initial) = &declaration.initial {
                        let message = "a variable that VAR_CONFIG gives an address has no initial value";
                        self.resolver.report(Problem::P2212, initial.span, message);
                    }
                    self.pending.push(Pending {
                        name: name.text.clone(),
                        store,
                        role,
                        data_type: open_type(&data_type),
                        initial: Vec::new(),
                        comment: declaration.comment.clone(),
                        span: name.span,
                    });
                }
                Some(ast::Location::Address(address)) => match globals::located(&mut self.resolver, address, &data_type) {
                    Some((base, offset)) => {
                        let variable =
                            Variable { name: name.text.clone(), role, data_type: data_type.clone(), base, offset, span: name.span };
                        if declaration.initial.is_some() {
                            let one = Located { variable: variable.clone(), initial: initial.clone(), retain };
                            self.resolver.types.known.located.push(one);
                        }
                        self.located.push(variable);
                    }
                    None => drop(self.resolver.names.insert(key(&name.text), unknown(name))),
                },
                None if declaration.edge.is_some() => {
                    let names = [name.text.clone(), format!("{}__WAS", name.text), format!("{}__EDGE", name.text)];
                    self.edges.extend(declaration.edge.map(|edge| (names.clone(), edge)));
                    let places = [
                        (store, role),
                        (Store::Interface(Section::Static), Role::Static),
                        (Store::Interface(Section::Static), Role::Static),
                    ];
                    for (position, (name_inside, (store, role))) in names.into_iter().zip(places).enumerate() {
                        let initial = if position == 0 { initial.clone() } else { Vec::new() };
                        let (comment, span) = (declaration.comment.clone(), name.span);
                        self.pending.push(Pending { name: name_inside, store, role, data_type: DataType::Bool, initial, comment, span });
                    }
                }
                None => {
                    // The caller tells the bounds of an ARRAY[*], and what a VARIANT is.
                    let bounds = bound_names(&name.text, &data_type).into_iter().map(|bound| (bound, DataType::DoubleInt));
                    let is_parameter = matches!(store, Store::Interface(Section::Input | Section::Output | Section::InOut));
                    let variant = is_variant(&declaration.data_type) && self.resolver.has_variants();
                    let variant = is_parameter && (variant || data_type == DataType::Any && self.resolver.dialect.has_pointers());
                    let told = Told::BOTH.into_iter().filter(|_| variant).map(|told| (told_name(&name.text, told), told.data_type()));
                    if begins_again {
                        let whole = format!("{}{INITIAL}", name.text);
                        self.begin_again.push((name.text.clone(), whole.clone()));
                        self.pending.push(Pending {
                            name: whole,
                            store,
                            role: Role::Static,
                            data_type: data_type.clone(),
                            initial: initial.clone(),
                            comment: String::new(),
                            span: name.span,
                        });
                    }
                    for (name_inside, data_type) in bounds.chain(told) {
                        self.pending.push(Pending {
                            name: name_inside,
                            store: Store::Interface(Section::Input),
                            role: Role::Input,
                            data_type,
                            initial: Vec::new(),
                            comment: String::new(),
                            span: name.span,
                        });
                    }
                    self.pending.push(Pending {
                        name: name.text.clone(),
                        store,
                        role,
                        data_type: data_type.clone(),
                        initial: initial.clone(),
                        comment: declaration.comment.clone(),
                        span: name.span,
                    });
                }
            }
        }
    }

    /// Where an instance lies that does not last: what calls it and its data stay where an instance can be called, and each call of the
    /// block begins with it as it is declared. `None` for all else.
    fn local_instance(&self, data_type: &DataType, store: Store) -> Option<Store> {
        let accepts = self.resolver.dialect.has_local_instances();
        if store != Store::Interface(Section::Temp) || !accepts || !data_type.holds_instance() {
            return None;
        }
        match self.id.kind {
            BlockKind::FunctionBlock => Some(Store::Interface(Section::Static)),
            BlockKind::Function if self.resolver.items.kept.contains_key(&self.id) => Some(Store::Kept),
            _ => None,
        }
    }

    /// VAR_EXTERNAL: names of global variables that the block uses.
    fn external(&mut self, section: &'a ast::VarSection) {
        for declaration in &section.declarations {
            let data_type = self.resolver.data_type(&declaration.data_type);
            for declared in &declaration.names {
                let name = &declared.name;
                if !self.is_first(name) {
                    continue;
                }
                let items = self.resolver.items;
                let Some(&(list, global)) = items.globals.get(&key(&name.text)) else {
                    let message = format!("there is no global variable `{}`", name.text);
                    self.resolver.report(Problem::P3001, name.span, message).may_be_elsewhere = true;
                    self.resolver.names.insert(key(&name.text), unknown(name));
                    continue;
                };
                let dialect = items.lists[list].dialect;
                let own = Resolver::new(self.resolver.types, items, dialect).data_type(&global.data_type);
                if let (Some(data_type), Some(own)) = (&data_type, &own)
                    && data_type != own
                {
                    let message = format!(
                        "`{}` is {} where it is declared, not {}",
                        name.text,
                        dialect.type_words(own),
                        dialect.type_words(data_type)
                    );
                    let first = global.span;
                    let report = self.resolver.report(Problem::P4006, declaration.data_type.span, message);
                    report.related.push((first, "declared here".to_owned()));
                }
            }
        }
    }

    /// The result of a function, its last parameter.
    fn result(&mut self, code: Code<'a>) {
        let Some(written) = &code.block.result else { return };
        let Some((data_type, initial)) = self.resolver.type_and_initial(written) else {
            self.partial = true;
            let name = code.block.member.as_ref().map_or(&code.block.name, |member| &member.name);
            self.resolver.names.insert(key(&name.text), unknown(name));
            return;
        };
        if data_type == DataType::Void {
            return;
        }
        let instance = data_type.holds_instance() && !self.resolver.dialect.has_local_instances();
        if instance || data_type.is_number() {
            let message = format!("a function cannot have {} as its result", self.resolver.dialect.type_words(&data_type));
            self.resolver.report(Problem::P4009, written.span, message);
            return;
        }
        self.pending.push(Pending {
            name: "RET_VAL".to_owned(),
            store: Store::Interface(Section::Return),
            role: Role::Result,
            data_type,
            initial,
            comment: String::new(),
            span: code.block.name.span,
        });
    }
}

/// Whether statements call those of the base, `SUPER^()`.
fn calls_super(body: &[ast::Statement]) -> bool {
    let mut found = false;
    walk::expressions(body, &mut |expression| {
        found |= matches!(&expression.kind, ast::ExpressionKind::Call(call) if is_super(&call.callee));
    });
    found
}

/// What a name stands for whose declaration was not understood: a variable about which nothing more is said.
pub(super) fn unknown(name: &ast::Name) -> Entity {
    Entity::Variable(Variable {
        name: name.text.clone(),
        role: Role::Static,
        data_type: DataType::Void,
        base: Base::Instance,
        offset: 0,
        span: name.span,
    })
}

/// Why the type may not stand there, if it may not.
fn misplaced(data_type: &DataType, store: Store) -> Option<(Problem, &'static str)> {
    let parameter = matches!(store, Store::Interface(Section::Input | Section::Output | Section::InOut));
    let local = store == Store::Interface(Section::Temp);
    Some(match data_type {
        DataType::Void => (Problem::P4009, "it is only the result of a function"),
        passed if !parameter && (passed.is_number() || *passed == DataType::Pointer) => {
            (Problem::P4009, "it is only for parameters (VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT)")
        }
        DataType::Any if !parameter && !local => (Problem::P4009, "it is only for parameters and VAR_TEMP"),
        other if local && other.holds_instance() => {
            (Problem::P6132, "an instance keeps its data from one call to the next, and these variables do not last")
        }
        _ => return None,
    })
}
