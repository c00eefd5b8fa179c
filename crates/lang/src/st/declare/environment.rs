//! What the names in the statements of a block stand for: the answers to the questions of the checker.

use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use sieben_engine::ir::Op;
use sieben_model::address::{Address, Area, Operand, Width};
use sieben_model::block::{BlockId, BlockKind};
use sieben_model::interface::Interface;
use sieben_model::literal::Value;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Structure};

use super::initial::bytes;
use super::interface::unknown;
use super::items::{Items, numbered};
use super::{Declared, Demand, InitialAddress, Known, Located, Named, ast};
use crate::declarations::data_block::DataLayout;
use crate::declarations::types::{BlockInterface, State};
use crate::library::LibraryBlock;
use crate::library::link::Links;
use crate::scope::{LostResults, Scope, is_nearer, key};
use crate::st::check::names::{DataBlockView, Entity, Names, Role, Variable};
use crate::st::dialect::Dialect;
use crate::st::objects::Objects;
use crate::st::standard::Provided;
use crate::st::tree::{self, Base, Local, Place, Scalar, Statement, StatementKind, Text, TextRoom, ValueKind};
use crate::st::type_class;

pub(crate) use super::globals::Globals;

/// The place of names outside all files, in [`Items::spaces`].
const OUTSIDE: usize = usize::MAX;

/// Everything that the statements of ST may name.
pub(crate) struct Environment<'a> {
    pub(crate) items: &'a Items<'a>,
    scope: &'a Scope,
    /// Blocks of the S7 library that the program has.
    pub(super) links: &'a Links,
    pub(super) interfaces: &'a HashMap<BlockId, BlockInterface>,
    data: &'a HashMap<u16, DataLayout>,
    /// Types of TYPE sections by key.
    named: HashMap<String, Arc<Named>>,
    pub(super) globals: Globals,
    blocks: HashMap<BlockId, Arc<Declared>>,
    /// How many suggestions were made; they cost a look at every name.
    suggestions: RefCell<BTreeSet<String>>,
    /// What of the library the program needs and does not have yet.
    demands: RefCell<Vec<Demand>>,
    /// What the statements of the block that is checked now ask for.
    questions: RefCell<Questions>,
    /// Variables with an address that begin with a value.
    pub(super) located: Vec<Located>,
    /// The references and pointers that begin with an address, by the initial value of their variable.
    pub(super) addresses: HashMap<Span, Vec<InitialAddress>>,
}

/// What the statements of one block ask for.
#[derive(Default)]
pub(crate) struct Questions {
    /// Blocks of which the interface, the fields or the declarations are looked at.
    pub(crate) blocks: BTreeSet<BlockId>,
    /// What of the library they use, there or not.
    pub(crate) uses: Vec<Demand>,
    /// Whether a name was looked for that looks like another one: the answer depends on who asked before.
    pub(crate) names: bool,
}

/// Puts together what is known when everything is declared.
pub(crate) fn environment<'a>(
    items: &'a Items<'a>,
    (scope, links): (&'a Scope, &'a Links),
    interfaces: &'a HashMap<BlockId, BlockInterface>,
    data: &'a HashMap<u16, DataLayout>,
    known: Known,
    globals: Globals,
) -> Environment<'a> {
    let named = known.named.into_iter().filter_map(|(name, state)| match state {
        State::Done(Some(named)) => Some((name, named)),
        _ => None,
    });
    Environment {
        items,
        scope,
        links,
        interfaces,
        data,
        named: named.collect(),
        globals,
        blocks: known.blocks,
        suggestions: RefCell::default(),
        demands: RefCell::new(known.demands),
        questions: RefCell::default(),
        located: known.located,
        addresses: known.addresses,
    }
}

impl<'a> Environment<'a> {
    /// What a block declares.
    pub(crate) fn declared(&self, block: BlockId) -> Option<&Declared> {
        self.ask(block);
        self.blocks.get(&block).map(|declared| &**declared)
    }

    /// Notes that a block is asked for.
    pub(super) fn ask(&self, block: BlockId) {
        self.questions.borrow_mut().blocks.insert(block);
    }

    /// What was asked for since this was called last.
    pub(crate) fn take_questions(&self) -> Questions {
        self.questions.take()
    }

    /// The names of a block.
    pub(crate) fn names(&self, block: BlockId, dialect: Dialect) -> Option<BlockNames<'_, 'a>> {
        let code = self.items.code.get(&block)?;
        let this = match &code.block.member {
            Some(member) => self.items.block_in(code.space, &member.of.text),
            None => (block.kind == BlockKind::FunctionBlock).then_some(block),
        };
        // A method knows what its block has, unless it declares the name itself.
        let owner = this.filter(|&this| this != block).and_then(|this| self.declared(this));
        Some(BlockNames { environment: self, declared: self.declared(block)?, owner, this, dialect, block, space: code.space, list: None })
    }

    /// What of the library the program needs and does not have yet.
    pub(crate) fn demands(&self) -> Vec<Demand> {
        self.demands.borrow().iter().chain(&self.items.demands).copied().collect()
    }

    /// The fields of a data block.
    pub(super) fn structure_of(&self, number: u16) -> Option<Arc<Structure>> {
        self.data.get(&number).map(|layout| Arc::clone(&layout.structure))
    }

    fn type_entity(&self, wanted: &str) -> Option<Entity> {
        self.named.get(wanted).map(|named| Entity::Type(named.data_type.clone()))
    }

    /// A value of an enumeration that is written without its type.
    fn enumeration_value(&self, wanted: &str) -> Option<Entity> {
        let owners = self.items.values.get(wanted)?;
        if owners.len() > 1 {
            let names = owners.iter().filter_map(|owner| self.items.types.get(owner));
            return Some(Entity::Ambiguous(names.map(|found| format!("{}#{wanted}", found.declaration.name.text)).collect()));
        }
        self.value_of(owners.first()?, wanted)
    }

    fn value_of(&self, owner: &str, wanted: &str) -> Option<Entity> {
        let data_type = &self.named.get(owner)?.data_type;
        let DataType::Enumeration(enumeration) = data_type else { return None };
        let (_, number) = enumeration.values.iter().find(|(name, _)| key(name) == wanted)?;
        Some(Entity::EnumValue { data_type: data_type.clone(), value: i128::from(*number) })
    }

    /// A symbol of the symbol table, or a block of the CPU or of the library by its name.
    fn symbol(&self, name: &str) -> Option<Entity> {
        let global = self.scope.global(name)?;
        Some(match global.operand? {
            Operand::Block(block) => Entity::Block(block),
            Operand::Timer(number) => Entity::Number { data_type: DataType::Timer, number },
            Operand::Counter(number) => Entity::Number { data_type: DataType::Counter, number },
            Operand::Address(address) => {
                Entity::Variable(self.at_address(&global.name, Base::Area(address.area), address, &global.data_type)?)
            }
            Operand::InDataBlock { db, address } => {
                Entity::Variable(self.at_address(&global.name, Base::DataBlock(db), address, &global.data_type)?)
            }
        })
    }

    fn at_address(&self, name: &str, base: Base, address: Address, written: &str) -> Option<Variable> {
        if matches!(address.area, Area::Local | Area::CallerLocal | Area::InstanceData) {
            return None;
        }
        let declared = DataType::from_any_word(written).filter(|data_type| data_type.width() == Some(address.width));
        let data_type = declared.unwrap_or(match address.width {
            Width::Bit => DataType::Bool,
            Width::Byte => DataType::Byte,
            Width::Word => DataType::Word,
            Width::DoubleWord => DataType::DoubleWord,
            #[allow(unreachable_patterns)] // A width of 64 bits has no symbol.
            _ => return None,
        });
        let offset = address.byte.checked_mul(8)?.checked_add(u32::from(address.bit))?;
        Some(Variable { name: name.to_owned(), role: Role::Global, data_type, base, offset, span: Span::default() })
    }

    /// A variable of a program: `PLC_PRG.x`.
    fn of_program(&self, program: &str, wanted: &str) -> Option<Entity> {
        let program = self.items.program(program)?;
        self.ask(BlockId::db(program.instance));
        let structure = &self.data.get(&program.instance)?.structure;
        let field = structure.fields.iter().find(|field| key(&field.name) == wanted)?;
        Some(Entity::Variable(Variable {
            name: field.name.clone(),
            role: Role::Global,
            data_type: field.data_type.clone(),
            base: Base::DataBlock(program.instance),
            offset: field.offset,
            span: program.span,
        }))
    }
}

/// The names of one block.
pub(crate) struct BlockNames<'e, 'a> {
    environment: &'e Environment<'a>,
    declared: &'e Declared,
    /// What the block declares that a method belongs to.
    owner: Option<&'e Declared>,
    /// The function block whose instance the block works on.
    this: Option<BlockId>,
    dialect: Dialect,
    block: BlockId,
    /// Where it stands.
    space: usize,
    /// The list of global variables whose initial values these are: it knows its own names.
    list: Option<&'e str>,
}

impl Names for BlockNames<'_, '_> {
    fn local(&self, name: &str) -> Option<Entity> {
        let found = self.declared.names.get(&key(name)).cloned().or_else(|| self.owner.and_then(|_| self.of_instance(name)));
        let nameless = found.is_none() && (self.declared.nameless || self.owner.is_some_and(|owner| owner.nameless));
        // It may be the name that is lost.
        found.or_else(|| if nameless && self.global(name).is_some() { Some(nothing(name)) } else { None })
    }

    fn global(&self, name: &str) -> Option<Entity> {
        let environment = self.environment;
        let wanted = key(name);
        let of_list = self.list.map(|list| key(&format!("{list}.{name}")));
        if let Some(entity) = of_list.iter().chain([&wanted]).find_map(|name| environment.globals.get(name)) {
            return Some(entity.clone());
        }
        // In a CONFIGURATION the name is that of the instance: `PROGRAM hall : Hall`.
        if self.space == OUTSIDE
            && environment.is_configured()
            && let Some(program) = environment.items.programs.iter().find(|one| key(&one.name) == wanted)
        {
            return Some(Entity::Block(BlockId::db(program.instance)));
        }
        if environment.items.is_twice(self.space, name) {
            return Some(nothing(name));
        }
        if let Some(block) = environment.items.block_in(self.space, name) {
            return Some(Entity::Block(block));
        }
        // An instance that a CONFIGURATION makes: `p1.x`.
        if let Some(program) = environment.items.programs.iter().find(|one| key(&one.name) == wanted && one.name != one.of) {
            return Some(Entity::Block(BlockId::db(program.instance)));
        }
        let named = environment.items.spellings(self.space, name);
        if let Some(entity) = named.iter().find_map(|full| environment.type_entity(full)).or_else(|| environment.enumeration_value(&wanted))
        {
            return Some(entity);
        }
        if let Some(block) = numbered(name, self.dialect) {
            return Some(match block.kind {
                BlockKind::UserDefinedType => environment.type_entity(environment.items.numbered_types.get(&block.number)?)?,
                _ => Entity::Block(block),
            });
        }
        if let Some(entity) = environment.symbol(name) {
            return Some(entity);
        }
        if self.dialect.has_pointers() && wanted == key(type_class::WORD) {
            return Some(Entity::Type(type_class::data_type()));
        }
        if self.dialect.has_pointers() && wanted == key(type_class::SYSTEM) {
            return Some(Entity::Qualifier);
        }
        environment.items.qualifiers.contains(&wanted).then_some(Entity::Qualifier)
    }

    fn qualified(&self, path: &[&str]) -> Option<Entity> {
        let environment = self.environment;
        let full = key(&path.join("."));
        let (last, before) = path.split_last()?;
        let (last, before) = (key(last), key(&before.join(".")));
        let spellings = environment.items.spellings(self.space, &path.join("."));
        let block = || environment.items.block_in(self.space, &path.join(".")).map(Entity::Block);
        environment
            .globals
            .get(&full)
            .cloned()
            .or_else(|| environment.items.spellings(self.space, &before).iter().find_map(|owner| environment.value_of(owner, &last)))
            .or_else(|| environment.of_program(&before, &last))
            .or_else(|| spellings.iter().find_map(|full| environment.type_entity(full)))
            .or_else(block)
            .or_else(|| spellings.iter().any(|full| environment.items.namespaces.contains(full)).then_some(Entity::Qualifier))
            .or_else(|| {
                let system = self.dialect.has_pointers() && before == key(type_class::SYSTEM) && last == key(type_class::WORD);
                system.then(|| Entity::Type(type_class::data_type()))
            })
            // `Standard.TON`: the library of a block needs not be told.
            .or_else(|| if environment.items.qualifiers.contains(&before) || before == "standard" { self.global(&last) } else { None })
    }

    fn interface(&self, block: BlockId) -> Option<Arc<Interface>> {
        self.environment.ask(block);
        self.environment.interfaces.get(&block).map(|found| Arc::clone(&found.interface))
    }

    fn data_block(&self, number: u16) -> Option<DataBlockView> {
        self.environment.ask(BlockId::db(number));
        let layout = self.environment.data.get(&number)?;
        Some(DataBlockView { based_on: layout.based_on, structure: Arc::clone(&layout.structure) })
    }

    fn block_name(&self, block: BlockId) -> String {
        let own = self.environment.items.names.get(&block).cloned();
        own.unwrap_or_else(|| block.to_string())
    }

    fn nearest(&self, name: &str) -> Option<String> {
        let environment = self.environment;
        environment.questions.borrow_mut().names = true;
        if !environment.suggestions.borrow_mut().insert(key(name)) {
            return None;
        }
        let owner = self.owner.iter().flat_map(|owner| &owner.variables);
        let own = self.declared.variables.iter().chain(owner).map(|variable| variable.name.as_str());
        let globals = environment.globals.values().filter_map(|entity| match entity {
            Entity::Variable(variable) => Some(variable.name.as_str()),
            _ => None,
        });
        let constants = self.declared.names.keys().map(String::as_str);
        let blocks = environment.items.names.values().map(String::as_str);
        // A variable of the block goes before a block or a global variable that is no nearer.
        let near_own = environment.scope.nearest(name, own);
        let near = environment.scope.nearest(name, near_own.iter().map(String::as_str).chain(globals).chain(blocks));
        let near = match (near_own, near) {
            (Some(own), Some(other)) if is_nearer(name, &other, &own) => Some(other),
            (own, other) => own.or(other),
        };
        near.or_else(|| environment.scope.nearest(name, constants.chain(environment.scope.names())))
    }

    fn locals(&self) -> Vec<Local> {
        self.declared.locals.clone()
    }

    fn program(&self, block: BlockId) -> Option<BlockId> {
        let items = self.environment.items;
        let is_program = items.code.get(&block).is_some_and(|code| code.block.kind == ast::BlockKind::Program);
        let mut all = items.programs.iter().filter(|one| is_program && one.block == block);
        all.next().filter(|_| all.next().is_none()).map(|only| BlockId::db(only.instance))
    }

    fn provided(&self, block: &Provided) -> Option<BlockId> {
        let environment = self.environment;
        let (name, demand) = match *block {
            Provided::System(block) => return Some(block),
            Provided::Library(block) => (block.name, Demand::Block(block)),
            Provided::Source { name, source } => (name, Demand::Source(source)),
        };
        let found = match demand {
            Demand::Source(source) => environment.items.library.get(&(source.path, key(name))).copied(),
            Demand::Block(block) => {
                environment.scope.block(name).filter(|id| id.kind == block.block.kind && environment.interfaces.contains_key(id))
            }
        };
        environment.questions.borrow_mut().uses.push(demand);
        if let Demand::Block(_) = demand {
            found.iter().for_each(|&id| environment.ask(id));
        }
        if found.is_none() {
            environment.demands.borrow_mut().push(demand);
        }
        found
    }

    fn is_of_library(&self, block: BlockId) -> bool {
        let environment = self.environment;
        environment.items.is_of_library(block) || environment.links.contains_key(&block)
    }

    fn tells_lost(&self) -> LostResults {
        self.environment.scope.tells_lost
    }

    fn linked(&self, block: BlockId) -> Option<&'static LibraryBlock> {
        self.environment.links.get(&block).copied()
    }

    fn local_size(&self) -> u32 {
        self.environment.interfaces.get(&self.block).map_or(0, |found| found.interface.local_size)
    }

    fn declared(&self) -> Vec<Variable> {
        self.declared.variables.clone()
    }

    fn objects(&self) -> &Objects {
        &self.environment.items.objects
    }

    fn namespace(&self) -> &str {
        self.environment.items.spaces.get(self.space).map_or("", |space| space.prefix.as_str())
    }

    fn this(&self) -> Option<BlockId> {
        self.this
    }

    fn of_instance(&self, name: &str) -> Option<Entity> {
        let declared = self.owner.unwrap_or(self.declared);
        declared.names.get(&key(name)).filter(|entity| entity.is_of_instance()).cloned()
    }

    fn access_of(&self, block: BlockId, variable: &str) -> Option<(BlockId, Option<ast::Access>)> {
        let (block, section) = self.section_of(block, variable)?;
        let all = [ast::Access::Public, ast::Access::Private, ast::Access::Protected, ast::Access::Internal];
        Some((block, all.into_iter().find(|&access| section.has(ast::Qualifier::Access(access)))))
    }

    fn constant_of(&self, block: BlockId, name: &str) -> Option<Entity> {
        let found = self.environment.declared(block)?.names.get(&key(name))?;
        let found = Some(found).filter(|found| matches!(found, Entity::Constant(_)))?;
        // The value belongs to no interface that could be compared with that of before.
        self.environment.questions.borrow_mut().names = true;
        Some(found.clone())
    }

    fn is_read_only(&self, block: BlockId, variable: &str) -> bool {
        let section = self.section_of(block, variable);
        let read_only =
            section.is_some_and(|(_, section)| section.kind == ast::SectionKind::InOut && section.has(ast::Qualifier::Constant));
        // No interface says so that could be compared with that of before.
        self.environment.questions.borrow_mut().names |= read_only;
        read_only
    }

    fn is_broken(&self, block: BlockId) -> bool {
        let items = self.environment.items;
        let twice = !items.twice.is_empty() && items.names.get(&block).is_some_and(|name| items.twice.contains(&key(name)));
        twice || self.environment.declared(block).is_some_and(|declared| declared.broken)
    }

    fn is_wrong_data(&self, number: u16) -> bool {
        let items = self.environment.items;
        self.environment.ask(BlockId::db(number));
        !self.environment.data.contains_key(&number) && items.data.contains_key(&number)
    }

    fn is_twice(&self, block: BlockId, variable: &str) -> bool {
        let declared = self.environment.declared(block).and_then(|declared| declared.names.get(&key(variable)));
        matches!(declared, Some(Entity::Variable(variable)) if variable.data_type == DataType::Void)
    }

    fn has_initial(&self, block: BlockId, variable: &str) -> bool {
        self.environment.ask(block);
        self.environment.items.own_declaration(block, variable).is_some_and(|found| found.declaration.initial.is_some())
    }

    fn knows_instances(&self) -> bool {
        self.space == OUTSIDE
    }

    fn instance(&self, block: BlockId) -> Option<Arc<Structure>> {
        self.environment.ask(block);
        self.environment.interfaces.get(&block).map(|found| Arc::clone(&found.instance))
    }
}

impl<'e, 'a> BlockNames<'e, 'a> {
    /// The section that declares a variable of a block, with the block, which may be one that it extends.
    fn section_of(&self, block: BlockId, variable: &str) -> Option<(BlockId, &'a ast::VarSection)> {
        for block in self.environment.items.line(block) {
            self.environment.ask(block);
            if let Some(found) = self.environment.items.own_declaration(block, variable) {
                return Some((block, found.section));
            }
        }
        None
    }

    /// What names mean outside all blocks, to statements that no source writes.
    pub(super) fn outside(environment: &'e Environment<'a>, declared: &'e Declared, block: BlockId, dialect: Dialect) -> Self {
        Self { environment, declared, owner: None, this: None, dialect, block, space: OUTSIDE, list: None }
    }

    /// The same inside a list of global variables.
    pub(super) fn in_list(self, list: Option<&'e str>) -> Self {
        Self { list, ..self }
    }

    /// The result of the block, if it is a function with one.
    pub(super) fn result(&self) -> Option<Variable> {
        self.declared.result.as_ref().map(|(variable, _)| variable.clone())
    }

    /// How the block is shown in messages.
    pub(super) fn shown(&self) -> String {
        self.block_name(self.block)
    }

    /// Statements that find the edges of inputs: `now := input AND NOT was; was := input`, with the input turned round for F_EDGE.
    fn edges(&self, span: Span) -> Vec<Statement> {
        // The statements of a base that SUPER calls see the edges of this call.
        let own = self.this == Some(self.block);
        let place = |variable: &Variable| Place { base: variable.base.clone(), offset: variable.offset, indexes: Vec::new(), span };
        let bool_value = |kind| tree::Value { kind, scalar: Scalar::Bool, span };
        let assign = |target: &Variable, value| Statement { kind: StatementKind::Assign { target: place(target), value }, span };
        let one = |watched: &super::WatchedEdge| {
            let input = bool_value(ValueKind::Load(place(&watched.input)));
            let input = match watched.edge {
                crate::st::ast::Edge::Rising => input,
                crate::st::ast::Edge::Falling => bool_value(ValueKind::Compute { op: Op::Not, args: vec![input] }),
            };
            let was = bool_value(ValueKind::Load(place(&watched.was)));
            let edge = bool_value(ValueKind::Compute { op: Op::AndNot, args: vec![input.clone(), was] });
            [assign(&watched.now, edge), assign(&watched.was, input)]
        };
        self.declared.edges.iter().filter(|_| own).flat_map(one).collect()
    }

    /// `Initial_Call := NOT called; called := TRUE`.
    fn first_call(&self, span: Span) -> Vec<Statement> {
        let Some((input, called)) = &self.declared.first_call else { return Vec::new() };
        let place = |variable: &Variable| Place { base: variable.base.clone(), offset: variable.offset, indexes: Vec::new(), span };
        let value = |kind| tree::Value { kind, scalar: Scalar::Bool, span };
        let assign = |target: &Variable, value| Statement { kind: StatementKind::Assign { target: place(target), value }, span };
        let first = value(ValueKind::Compute { op: Op::Not, args: vec![value(ValueKind::Load(place(called)))] });
        vec![assign(input, first), assign(called, value(ValueKind::Constant(1)))]
    }

    /// Statements that give the result and the outputs of a function what they hold at the start, and find the edges of inputs.
    pub(super) fn starting_statements(&self, span: Span) -> Vec<Statement> {
        let mut all = self.edges(span);
        all.extend(self.first_call(span));
        all.extend(self.declared.begin_again.iter().map(|(variable, whole)| {
            let place = |variable: &Variable| Place { base: variable.base.clone(), offset: variable.offset, indexes: Vec::new(), span };
            let bytes = u32::try_from(variable.data_type.bits().div_ceil(8)).unwrap_or(u32::MAX);
            Statement { kind: StatementKind::Copy { target: place(variable), source: place(whole), bytes }, span }
        }));
        let starting = self.declared.result.iter().chain(&self.declared.outputs);
        let one = |(variable, initial): &(Variable, Vec<Value>)| self::starting(variable, initial, span);
        all.extend(starting.flat_map(one));
        all
    }
}

/// What a name stands for of which nothing is said: what is wrong with it was told where it is declared.
fn nothing(name: &str) -> Entity {
    unknown(&ast::Name { text: name.to_owned(), ..ast::Name::default() })
}

/// Statements that give a variable its initial value.
pub(crate) fn starting(variable: &Variable, initial: &[Value], span: Span) -> Vec<Statement> {
    match starting_statement(variable, initial, span) {
        Some(statement) => vec![statement],
        None => starting_bytes(variable, initial, span),
    }
}

/// Largest array or structure that a function gives its initial value, in bytes; a larger one keeps what the caller has there.
const STARTING_BYTES_MAX: usize = 2048;

/// Statements that write the bytes of an array, a structure or a date, eight at a time.
fn starting_bytes(variable: &Variable, initial: &[Value], span: Span) -> Vec<Statement> {
    if variable.data_type.bits().div_ceil(8) > STARTING_BYTES_MAX as u64 {
        return Vec::new();
    }
    let image = bytes(&variable.data_type, initial);
    let mut statements = Vec::new();
    let mut done = 0;
    while done < image.len() {
        let (length, scalar) = match image.len() - done {
            8.. => (8, Scalar::U64),
            4.. => (4, Scalar::U32),
            2.. => (2, Scalar::U16),
            _ => (1, Scalar::U8),
        };
        let bits = image[done..done + length].iter().fold(0, |bits: u64, &byte| bits << 8 | u64::from(byte));
        let offset = variable.offset + (done as u32) * 8;
        let target = Place { base: variable.base.clone(), offset, indexes: Vec::new(), span };
        let value = tree::Value { kind: ValueKind::Constant(bits), scalar, span };
        statements.push(Statement { kind: StatementKind::Assign { target, value }, span });
        done += length;
    }
    statements
}

/// `variable := initial;`; `None` for what is no elementary value and no text.
fn starting_statement(variable: &Variable, initial: &[Value], span: Span) -> Option<Statement> {
    let target = Place { base: variable.base.clone(), offset: variable.offset, indexes: Vec::new(), span };
    let data_type = &variable.data_type;
    let kind = match data_type {
        DataType::String(length) => {
            let text = match initial {
                [Value::Characters(text)] => text.clone(),
                _ => Vec::new(),
            };
            StatementKind::AssignString { target, room: TextRoom::narrow(*length), source: Text::Constant(text) }
        }
        DataType::WideString(length) => {
            let image = bytes(data_type, initial);
            let words: Vec<u16> = image.chunks_exact(2).map(|word| u16::from_be_bytes([word[0], word[1]])).collect();
            let text = words[2..].iter().copied().take(usize::from(words[1])).collect();
            StatementKind::AssignString { target, room: TextRoom::wide(*length), source: Text::WideConstant(text) }
        }
        _ if data_type.is_elementary() || data_type.is_long() => {
            let scalar = match data_type.bits() {
                1 => Scalar::Bool,
                8 => Scalar::U8,
                16 => Scalar::U16,
                32 => Scalar::U32,
                _ => Scalar::U64,
            };
            let bits = bytes(data_type, initial).iter().fold(0, |bits: u64, &byte| bits << 8 | u64::from(byte));
            StatementKind::Assign { target, value: tree::Value { kind: ValueKind::Constant(bits), scalar, span } }
        }
        _ => return None,
    };
    Some(Statement { kind, span })
}
