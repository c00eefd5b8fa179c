//! What the ST sources of a project declare, by name and by number.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::hash::{Hash, Hasher};

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::cpu_type::CpuType;
use sieben_model::diagnostic::Diagnostic;
use sieben_model::problems::Problem;
use sieben_model::source::{FileId, Span};

use super::needed::Demand;
use super::numbers::{Wanted, assign};
use super::objects::objects;
use super::{StFile, ast};
use crate::declarations::reuse::Stamp;
use crate::scope::{Scope, key};
use crate::st::dialect::Dialect;
use crate::st::objects::Objects;

/// A block with statements.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Code<'a> {
    pub(crate) block: &'a ast::Block,
    pub(crate) dialect: Dialect,
    /// Where it stands, in [`Items::spaces`].
    pub(crate) space: usize,
    /// Which syntax it is.
    pub(crate) stamp: Stamp,
}

/// A place where names are written: a file, or a namespace in it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surroundings {
    /// The namespace with a point behind it; empty outside any.
    pub(crate) prefix: String,
    /// The namespaces that USING makes known in a block or a namespace, with a point behind each: before what is in none.
    pub(crate) near: Vec<String>,
    /// Those of USING in the file, behind what is in none.
    pub(crate) usings: Vec<String>,
}

/// A DATA_BLOCK.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Data<'a> {
    pub(crate) block: &'a ast::DataBlock,
    pub(crate) dialect: Dialect,
}

/// A type of a TYPE section.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Type<'a> {
    pub(crate) declaration: &'a ast::TypeDeclaration,
    pub(crate) dialect: Dialect,
    /// Where it stands, in [`Items::spaces`].
    pub(crate) space: usize,
}

/// An instance of a PROGRAM, or of statements outside any block.
#[derive(Clone, Debug)]
pub(crate) struct Program {
    /// What the instance is called: as a CONFIGURATION says, else like the PROGRAM.
    pub(crate) name: String,
    /// The name of the PROGRAM.
    pub(crate) of: String,
    pub(crate) block: BlockId,
    pub(crate) instance: u16,
    /// RETAIN (`true`) or NON_RETAIN that a CONFIGURATION says of all its variables.
    pub(crate) retain: Option<bool>,
    /// The place of its name.
    pub(crate) span: Span,
    /// It has no name.
    pub(crate) implicit: bool,
}

/// SETUP, TEARDOWN or TEST: a function block with its instance.
#[derive(Clone, Debug)]
pub(crate) struct TestBlock<'a> {
    pub(crate) part: ast::TestPart,
    pub(crate) block: BlockId,
    pub(crate) instance: u16,
    pub(crate) source: &'a ast::Block,
}

/// A VAR_GLOBAL section.
#[derive(Clone, Debug)]
pub(crate) struct List<'a> {
    /// What its variables can be qualified by, and its data block is called, unless several sections have the name.
    pub(crate) name: String,
    pub(crate) section: &'a ast::VarSection,
    pub(crate) dialect: Dialect,
    /// Its data block.
    pub(crate) number: u16,
}

/// Everything that the ST sources declare.
#[derive(Debug, Default)]
pub(crate) struct Items<'a> {
    pub(crate) code: BTreeMap<BlockId, Code<'a>>,
    pub(crate) data: BTreeMap<u16, Data<'a>>,
    /// By the key of the name.
    pub(crate) types: HashMap<String, Type<'a>>,
    /// Keys of the types that have a UDT number.
    pub(crate) numbered_types: HashMap<u16, String>,
    /// Types that declare a value of an enumeration of this name, by the key of the value.
    pub(crate) values: HashMap<String, Vec<String>>,
    /// Blocks by the key of their names.
    pub(crate) blocks: HashMap<String, BlockId>,
    /// Blocks of the library by the path of their source and the key of their names.
    pub(crate) library: HashMap<(&'static str, String), BlockId>,
    /// Names of blocks as they are spelled.
    pub(crate) names: BTreeMap<BlockId, String>,
    pub(crate) programs: Vec<Program>,
    /// RETAIN (`true`) and NON_RETAIN of the instances that a CONFIGURATION makes, by the key of their names.
    pub(crate) retained: HashMap<String, bool>,
    /// The data block of what tasks with SINGLE remember.
    pub(crate) tasks: Option<u16>,
    /// VAR_CONFIG and VAR_ACCESS.
    pub(crate) access: Vec<(&'a ast::VarSection, Dialect)>,
    /// The parts of the test file in their order.
    pub(crate) tests: Vec<TestBlock<'a>>,
    pub(crate) lists: Vec<List<'a>>,
    /// Global variables and constants by key: list and declaration.
    pub(crate) globals: HashMap<String, (usize, &'a ast::Declaration)>,
    pub(crate) configurations: Vec<(&'a ast::Configuration, Dialect)>,
    /// Functions and function blocks with VAR_STAT, functions with VAR CONSTANT of their own: the data block that keeps it.
    pub(crate) kept: BTreeMap<BlockId, u16>,
    /// Keys of the blocks and types that are declared twice: which of them is meant, nobody knows (decision 270).
    pub(crate) twice: BTreeSet<String>,
    /// The same for global variables.
    pub(crate) twice_global: BTreeSet<String>,
    /// Names before a point.
    pub(crate) qualifiers: BTreeSet<String>,
    /// Keys of all namespaces.
    pub(crate) namespaces: BTreeSet<String>,
    /// Where names are written.
    pub(crate) spaces: Vec<Surroundings>,
    /// Blocks as objects.
    pub(crate) objects: Objects,
    /// Sources of the library that blocks extend and that are not there yet.
    pub(crate) demands: Vec<Demand>,
    /// What of the library the user's blocks extend, there or not.
    pub(crate) uses: Vec<Demand>,
}

/// The block that a name such as `FB10` means by itself.
pub(crate) fn numbered(text: &str, dialect: Dialect) -> Option<BlockId> {
    if dialect.switches().numbered_blocks { numbered_anywhere(text) } else { None }
}

/// The block of a name such as `OB35`, as the header of a block may say it in every dialect.
fn numbered_anywhere(text: &str) -> Option<BlockId> {
    let digits = text.find(|c: char| c.is_ascii_digit())?;
    let (word, number) = text.split_at(digits);
    Some(BlockId::new(BlockKind::from_abbreviation(word)?, number.parse().ok()?))
}

/// The input of an organization block that is TRUE in its first call after a restart.
pub(super) const INITIAL_CALL: &str = "Initial_Call";

/// The number of an organization block by its name alone: `OB1`, or a usual name such as `Main`.
pub(crate) fn usual_organization_block(name: &str) -> Option<u16> {
    let numbered = numbered_anywhere(name).filter(|id| id.kind == BlockKind::OrganizationBlock);
    numbered.map(|id| id.number).or_else(|| usual_name(name))
}

fn usual_name(name: &str) -> Option<u16> {
    NAMED_ORGANIZATION_BLOCKS.iter().find(|(usual, _)| usual.eq_ignore_ascii_case(name)).map(|&(_, number)| number)
}

/// Organization blocks that have a usual name and no number in their source.
const NAMED_ORGANIZATION_BLOCKS: &[(&str, u16)] = &[
    ("Main", 1),
    ("Cyclic interrupt", 35),
    ("Startup", 100),
    ("Time of day", 10),
    ("Time delay interrupt", 20),
    ("Hardware interrupt", 40),
    ("Time error interrupt", 80),
    ("Diagnostic error interrupt", 82),
    ("Pull or plug of modules", 83),
    ("Rack or station failure", 86),
    ("Programming error", 121),
    ("IO access error", 122),
];

/// Something that needs a number, on the way to it.
pub(super) enum Pending<'a> {
    Code(Code<'a>),
    Data(Data<'a>),
    /// An instance of the program at this position.
    Instance(usize),
    List(usize),
    /// What the function at this position keeps.
    Kept(usize),
    /// What the tasks with SINGLE remember.
    Tasks,
}

pub(super) struct Collector<'a, 's> {
    pub(super) items: Items<'a>,
    scope: &'s Scope,
    pub(super) pending: Vec<(Wanted, Pending<'a>)>,
    /// Where names were declared.
    places: HashMap<(Space, String), Span>,
    diagnostics: Vec<Diagnostic>,
    /// The namespace that is open, with a point behind it.
    namespace: String,
    /// Where it is, in [`Items::spaces`].
    space: usize,
    /// What USING names.
    usings: Vec<&'a ast::Path>,
    /// The path of the file, if it is one of the library.
    library: Option<&'static str>,
    /// The stamps of the blocks of the file that are still to come.
    stamps: std::slice::Iter<'a, Stamp>,
}

/// What may have the same name without being confused.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Space {
    /// Blocks and types.
    Block,
    Global,
}

/// Finds everything that the sources declare and gives numbers to what has none.
///
/// `taken` are the blocks of STL with the places of their names; those found here are added. Blocks of the
/// library get the numbers that the others leave.
pub(crate) fn collect<'a>(
    files: &'a [StFile],
    scope: &mut Scope,
    cpu: &CpuType,
    replacing: Option<FileId>,
    taken: &mut HashMap<BlockId, Span>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Items<'a> {
    let mut collector = Collector {
        items: Items::default(),
        scope,
        pending: Vec::new(),
        places: HashMap::new(),
        diagnostics: Vec::new(),
        namespace: String::new(),
        space: 0,
        usings: Vec::new(),
        library: None,
        stamps: [].iter(),
    };
    for file in files {
        collector.library = file.library.map(|source| source.path);
        collector.stamps = file.stamps.iter();
        collector.space(&file.file.items, file.dialect);
    }
    collector.configured_instances();
    collector.local_instances();
    let Collector { mut items, pending, usings, diagnostics: mut found, .. } = collector;
    for path in usings {
        if !items.namespaces.contains(&key(&joined(path))) {
            let message = format!("there is no namespace `{}`", joined(path));
            let diagnostic = Diagnostic::new(Problem::P3001, path.span, message).elsewhere();
            found.push(diagnostic.help("Write the full name of a NAMESPACE of the project."));
        }
    }
    let wanted: Vec<&Wanted> = pending.iter().map(|(wanted, _)| wanted).collect();
    let numbers = assign(&wanted, scope, cpu, replacing, taken, &mut found);
    let mut instances: Vec<(BlockId, String, u16, Span)> = Vec::new();
    for ((wanted, pending), id) in pending.into_iter().zip(numbers.iter().copied()) {
        let Some(id) = id else { continue };
        if !wanted.name.is_empty() {
            items.names.insert(id, wanted.name.clone());
            if !matches!(pending, Pending::Instance(_) | Pending::List(_) | Pending::Kept(_) | Pending::Tasks) {
                match wanted.library {
                    Some(path) => drop(items.library.insert((path, key(&wanted.name)), id)),
                    None => drop(items.blocks.insert(key(&wanted.name), id)),
                }
            }
        }
        match pending {
            Pending::Code(code) => {
                items.code.insert(id, code);
                if let ast::BlockKind::Test(part) = code.block.kind {
                    items.tests.push(TestBlock { part, block: id, instance: 0, source: code.block });
                }
            }
            Pending::Data(data) => {
                items.data.insert(id.number, data);
            }
            Pending::Instance(owner) => instances.extend(numbers[owner].map(|owner| (owner, wanted.name, id.number, wanted.span))),
            Pending::Tasks => items.tasks = Some(id.number),
            Pending::List(list) => items.lists[list].number = id.number,
            Pending::Kept(owner) => items.kept.extend(numbers[owner].map(|owner| (owner, id.number))),
        }
    }
    for (block, name, instance, span) in instances {
        let Some(code) = items.code.get(&block) else { continue };
        let implicit = code.block.kind == ast::BlockKind::Implicit;
        match code.block.kind {
            ast::BlockKind::Test(_) => items.tests.iter_mut().filter(|test| test.block == block).for_each(|test| test.instance = instance),
            _ => {
                let of = items.names.get(&block).cloned().unwrap_or_default();
                let retain = items.retained.get(&key(&name)).copied();
                let span = if implicit { code.block.span } else { span };
                items.programs.push(Program { name, of, block, instance, retain, span, implicit });
            }
        }
    }
    items.tests.sort_by_key(|test| test.source.span.start);
    for (name, id) in items.blocks.iter().filter(|(_, id)| items.code.get(id).is_none_or(|code| code.block.member.is_none())) {
        scope.define_block(name, items.names.get(id).map_or(name.as_str(), String::as_str), *id);
    }
    let (mut demands, mut uses) = (Vec::new(), Vec::new());
    items.objects = objects(&items, scope, &mut found, (&mut demands, &mut uses));
    (items.demands, items.uses) = (demands, uses);
    diagnostics.append(&mut found);
    items
}

/// A path as it is written.
pub(super) fn joined(path: &ast::Path) -> String {
    path.names.iter().map(|name| name.text.as_str()).collect::<Vec<_>>().join(".")
}

/// What stands behind the name of a function in the name of the data block that keeps its static variables.
pub(super) const KEPT: &str = ".static";
/// The name of statements outside any block.
const IMPLICIT: &str = "MAIN";

impl Items<'_> {
    /// Whether a block is one of the library.
    pub(crate) fn is_of_library(&self, block: BlockId) -> bool {
        self.library.values().any(|&known| known == block)
    }

    /// What there is and what it is called, without what the blocks declare. Of blocks that know one another's declarations by EXTENDS,
    /// IMPLEMENTS or as members of one another it is their whole syntax.
    pub(crate) fn hash_names(&self, state: &mut impl Hasher) {
        for (id, code) in &self.code {
            (id, code.block.kind, code.dialect, code.space, &code.block.name.text).hash(state);
            let modifiers = ast::Modifiers { span: Span::default(), ..code.block.modifiers };
            if code.block.member.is_some() || modifiers != ast::Modifiers::default() {
                code.stamp.syntax.hash(state);
            }
        }
        for (id, object) in self.objects.iter() {
            let related = object.base.is_some() || object.lacks_base || !object.interfaces.is_empty() || !object.members.is_empty();
            for block in object.base.into_iter().chain(related.then_some(id)) {
                (block, self.code.get(&block).map(|code| code.stamp.syntax)).hash(state);
            }
        }
        (&self.names, &self.kept, self.tasks, &self.twice, &self.twice_global, &self.qualifiers, &self.namespaces).hash(state);
        for program in &self.programs {
            (&program.name, &program.of, program.block, program.instance, program.retain, program.implicit).hash(state);
        }
        for test in &self.tests {
            (test.block, test.instance).hash(state);
        }
        for space in &self.spaces {
            (&space.prefix, &space.near, &space.usings).hash(state);
        }
        for list in &self.lists {
            (&list.name, list.number).hash(state);
        }
    }

    /// The instance of a PROGRAM of this name; the name of the PROGRAM itself is enough if there is one only.
    pub(crate) fn program(&self, wanted: &str) -> Option<&Program> {
        self.programs.iter().find(|program| key(&program.name) == wanted).or_else(|| {
            let mut all = self.programs.iter().filter(|program| key(&program.of) == wanted);
            all.next().filter(|_| all.next().is_none())
        })
    }

    /// Blocks that have one instance from the beginning: programs, and the parts of a test file. The block, its instance, its place.
    pub(crate) fn own_instances(&self) -> impl Iterator<Item = (BlockId, u16, Span)> {
        let programs = self.programs.iter().map(|program| (program.block, program.instance, program.span));
        programs.chain(self.tests.iter().map(|test| (test.block, test.instance, test.source.name.span)))
    }

    /// The keys under which a name may be known that is written at a place: in its namespace, in those around it, by USING.
    pub(crate) fn spellings(&self, space: usize, name: &str) -> Vec<String> {
        let Some(space) = self.spaces.get(space) else { return vec![key(name)] };
        let mut found = Vec::new();
        let mut prefix = space.prefix.as_str();
        while !prefix.is_empty() {
            found.push(key(&format!("{prefix}{name}")));
            let outer = prefix.trim_end_matches('.');
            prefix = &prefix[..outer.rfind('.').map_or(0, |point| point + 1)];
        }
        found.extend(space.near.iter().map(|using| key(&format!("{using}{name}"))));
        found.push(key(name));
        found.extend(space.usings.iter().map(|using| key(&format!("{using}{name}"))));
        found
    }

    /// The block of this name as it is written at a place.
    pub(crate) fn block_in(&self, space: usize, name: &str) -> Option<BlockId> {
        self.spellings(space, name).iter().find_map(|spelled| self.blocks.get(spelled).copied())
    }

    /// Whether what a name means in a place is declared twice.
    pub(crate) fn is_twice(&self, space: usize, name: &str) -> bool {
        !self.twice.is_empty() && self.spellings(space, name).iter().any(|spelled| self.twice.contains(spelled))
    }

    /// Function blocks that are called with a data block by its number, `FB10.DB20(…)`: both, and the place.
    pub(crate) fn instances_called(&self) -> Vec<(BlockId, u16, Span)> {
        let mut found = Vec::new();
        for code in self.code.values() {
            calls(&code.block.body, &mut |call, span| {
                // `DB20` behind a point could be a data byte, too.
                let (block, data) = match &call.callee.kind {
                    ast::ExpressionKind::Member(block, data) => (&**block, data),
                    ast::ExpressionKind::DataAddress(address) => (&address.block, &address.written),
                    _ => return,
                };
                let ast::ExpressionKind::Name(block) = &block.kind else { return };
                let block = numbered(&block.text, code.dialect).or_else(|| self.blocks.get(&key(&block.text)).copied());
                let data = numbered(&data.text, code.dialect).or_else(|| self.blocks.get(&key(&data.text)).copied());
                if let (Some(block), Some(BlockId { kind: BlockKind::DataBlock, number })) = (block, data) {
                    found.push((block, number, span));
                }
            });
        }
        found
    }
}

/// Shows all calls that are statements of their own.
fn calls(statements: &[ast::Statement], found: &mut dyn FnMut(&ast::Call, Span)) {
    for statement in statements {
        match &statement.kind {
            ast::StatementKind::Expression(expression) => {
                if let ast::ExpressionKind::Call(call) = &expression.kind {
                    found(call, expression.span);
                }
            }
            ast::StatementKind::If { branches, otherwise } => {
                branches.iter().for_each(|branch| calls(&branch.body, found));
                otherwise.iter().for_each(|body| calls(body, found));
            }
            ast::StatementKind::Case { arms, otherwise, .. } => {
                arms.iter().for_each(|arm| calls(&arm.body, found));
                otherwise.iter().for_each(|body| calls(body, found));
            }
            ast::StatementKind::For(one) => calls(&one.body, found),
            ast::StatementKind::While { body, .. } | ast::StatementKind::Repeat { body, .. } | ast::StatementKind::Region { body, .. } => {
                calls(body, found);
            }
            ast::StatementKind::Try { body, catch, finally, .. } => {
                [body, catch, finally].into_iter().for_each(|body| calls(body, found));
            }
            _ => {}
        }
    }
}

impl<'a> Collector<'a, '_> {
    /// The items of a file or a namespace.
    fn space(&mut self, items: &'a [ast::Item], dialect: Dialect) {
        let outer = self.space;
        self.space = self.items.spaces.len();
        let around = match self.namespace.is_empty() {
            true => Surroundings::default(),
            false => self.items.spaces.get(outer).cloned().unwrap_or_default(),
        };
        let mut usings = Vec::new();
        for item in items {
            if let ast::Item::Using(path) = item {
                self.usings.push(path);
                usings.push(format!("{}.", joined(path)));
            }
        }
        let prefix = self.namespace.clone();
        self.items.spaces.push(match prefix.is_empty() {
            true => Surroundings { prefix, usings, ..around },
            false => Surroundings { prefix, near: usings.into_iter().chain(around.near).collect(), usings: around.usings },
        });
        self.items(items, dialect);
        self.space = outer;
    }

    fn items(&mut self, items: &'a [ast::Item], dialect: Dialect) {
        for item in items {
            match item {
                ast::Item::Block(block) => self.block(block, dialect),
                ast::Item::DataBlock(block) => {
                    let wanted = self.wanted(&block.name, BlockKind::DataBlock, dialect);
                    self.pending.extend(wanted.map(|wanted| (wanted, Pending::Data(Data { block, dialect }))));
                }
                ast::Item::Type(declaration) => self.type_declaration(declaration, dialect),
                ast::Item::Globals(section) => self.globals(section, dialect),
                ast::Item::Interface(_) => unreachable!("interfaces are blocks here"),
                ast::Item::Namespace(namespace) => {
                    let names: Vec<&str> = namespace.name.names.iter().map(|name| name.text.as_str()).collect();
                    let outer = std::mem::take(&mut self.namespace);
                    self.namespace = format!("{outer}{}.", names.join("."));
                    let mut full = outer.clone();
                    for name in names {
                        self.items.qualifiers.insert(key(name));
                        full.push_str(name);
                        self.items.namespaces.insert(key(&full));
                        full.push('.');
                    }
                    self.space(&namespace.items, dialect);
                    self.namespace = outer;
                }
                ast::Item::Using(_) => {}
                ast::Item::Configuration(configuration) => {
                    let name = &configuration.name;
                    let same = |(other, _): &&(&ast::Configuration, Dialect)| other.name.is(&name.text);
                    if let Some((first, _)) = self.items.configurations.iter().find(same).filter(|_| !name.text.is_empty()) {
                        let message = format!("`{}` is declared twice", name.text);
                        let first = first.name.span;
                        self.diagnostics.push(Diagnostic::new(Problem::P3006, name.span, message).related(first, "first declared here"));
                    }
                    self.items.configurations.push((configuration, dialect));
                    let sections = configuration.sections.iter();
                    for section in sections.chain(configuration.resources.iter().flat_map(|resource| &resource.sections)) {
                        self.globals(section, dialect);
                    }
                }
            }
        }
    }

    fn block(&mut self, block: &'a ast::Block, dialect: Dialect) {
        let stamp = self.stamps.next().copied().unwrap_or_default();
        let kind = match block.kind {
            ast::BlockKind::Function | ast::BlockKind::Method => BlockKind::Function,
            ast::BlockKind::OrganizationBlock => BlockKind::OrganizationBlock,
            ast::BlockKind::Program
            | ast::BlockKind::FunctionBlock
            | ast::BlockKind::Class
            | ast::BlockKind::Interface
            | ast::BlockKind::Implicit
            | ast::BlockKind::Test(_) => BlockKind::FunctionBlock,
        };
        let wanted = match block.kind {
            ast::BlockKind::Implicit => Some(Wanted {
                name: self.free_name(IMPLICIT),
                kind,
                fixed: None,
                span: Span { end: block.span.start, ..block.span },
                library: self.library,
            }),
            _ => self.wanted(&block.name, kind, dialect),
        };
        let Some(wanted) = wanted else { return };
        let mut space = self.space;
        if let (false, Some(around)) = (block.usings.is_empty(), self.items.spaces.get(space).cloned()) {
            space = self.items.spaces.len();
            let own = block.usings.iter().map(|path| format!("{}.", joined(path)));
            self.items.spaces.push(Surroundings { near: own.chain(around.near).collect(), ..around });
            self.usings.extend(&block.usings);
        }
        let owner = Wanted { kind: BlockKind::DataBlock, fixed: None, ..wanted.clone() };
        let behind = self.pending.len() + 1;
        if matches!(block.kind, ast::BlockKind::Test(_)) {
            self.pending.push((owner, Pending::Instance(behind)));
        } else if matches!(block.kind, ast::BlockKind::Program | ast::BlockKind::Implicit) {
            self.items.qualifiers.insert(key(&wanted.name));
            self.pending.push((owner, Pending::Instance(behind)));
        } else if matches!(
            block.kind,
            ast::BlockKind::Function | ast::BlockKind::FunctionBlock | ast::BlockKind::Method | ast::BlockKind::OrganizationBlock
        ) && block.sections.iter().any(|section| section.kind == ast::SectionKind::Static || is_called_first(block, section))
        {
            self.pending.push((Wanted { name: format!("{}{KEPT}", wanted.name), ..owner }, Pending::Kept(behind)));
        }
        self.pending.push((wanted, Pending::Code(Code { block, dialect, space, stamp })));
    }

    /// A name that no block has, made from this one.
    pub(super) fn free_name(&self, name: &str) -> String {
        let taken = |name: &str| self.places.contains_key(&(Space::Block, key(name)));
        if !taken(name) {
            return name.to_owned();
        }
        (2..).map(|number| format!("{name}_{number}")).find(|name| !taken(name)).unwrap_or_default()
    }

    /// Declares a name; whether it is the first of its kind.
    pub(super) fn declare(&mut self, space: Space, name: &str, span: Span) -> bool {
        match self.places.get(&(space, key(name))) {
            Some(&first) => {
                let message = format!("`{name}` is declared twice");
                self.diagnostics.push(Diagnostic::new(Problem::P3006, span, message).related(first, "first declared here"));
                let twice = match space {
                    Space::Block => &mut self.items.twice,
                    Space::Global => &mut self.items.twice_global,
                };
                twice.insert(key(name));
                false
            }
            None => {
                self.places.insert((space, key(name)), span);
                true
            }
        }
    }

    /// The number that a block has by its name or by the symbol table, or that it wants one.
    fn wanted(&mut self, name: &ast::Name, kind: BlockKind, dialect: Dialect) -> Option<Wanted> {
        // The parser has reported a name that is missing.
        if name.text.is_empty() {
            return None;
        }
        let span = name.span;
        let bare = !matches!(name.quoting, ast::Quoting::Global);
        let numbered = match kind {
            BlockKind::OrganizationBlock => numbered_anywhere(&name.text).filter(|id| id.kind == kind),
            _ => numbered(&name.text, dialect),
        };
        let numbered = numbered.filter(|_| bare);
        let full = format!("{}{}", self.namespace, name.text);
        let mut first = || match self.library {
            Some(_) => true,
            None => self.declare(Space::Block, &full, span),
        };
        if numbered.is_none() && !first() {
            return None;
        }
        let by_table = || self.scope.own_block(&name.text);
        let fixed =
            numbered.or_else(by_table).or_else(|| usual_name(&name.text).filter(|_| kind == BlockKind::OrganizationBlock).map(BlockId::ob));
        let shown = if numbered.is_some() { String::new() } else { full };
        match fixed {
            Some(id) if id.kind != kind => {
                let message = format!("`{}` stands for `{id}`, which is no {}", name.text, kind.abbreviation());
                self.diagnostics.push(Diagnostic::new(Problem::P2200, span, message));
                None
            }
            None if kind == BlockKind::OrganizationBlock => {
                let message = format!("`{}` does not say which organization block it is", name.text);
                let help = "Give the name in the symbol table the address of an OB, or write `ORGANIZATION_BLOCK OB1`.";
                self.diagnostics.push(Diagnostic::new(Problem::P6120, span, message).help(help).elsewhere());
                None
            }
            fixed => Some(Wanted { name: shown, kind, fixed, span, library: self.library }),
        }
    }

    fn type_declaration(&mut self, declaration: &'a ast::TypeDeclaration, dialect: Dialect) {
        let name = &declaration.name;
        if name.text.is_empty() {
            return;
        }
        let full = format!("{}{}", self.namespace, name.text);
        if name.quoting == ast::Quoting::Bare && crate::st::standard::type_of_word(&name.text, dialect).is_some() {
            let message = format!("`{}` is a type of {} and cannot be the name of another one", name.text, dialect.title());
            self.diagnostics.push(Diagnostic::new(Problem::P6060, name.span, message));
            return;
        }
        if !self.declare(Space::Block, &full, name.span) {
            return;
        }
        let id = numbered(&name.text, dialect).or_else(|| self.scope.own_block(&name.text));
        if let Some(BlockId { kind: BlockKind::UserDefinedType, number }) = id {
            self.items.numbered_types.insert(number, key(&full));
        }
        let qualified = declaration.attributes.iter().any(|attribute| attribute.name.is("qualified_only"));
        if let (ast::TypeKind::Enumeration { values, .. }, false) = (&declaration.data_type.kind, qualified) {
            for (value, _) in values {
                let owners = self.items.values.entry(key(&value.text)).or_default();
                if !owners.contains(&key(&full)) {
                    owners.push(key(&full));
                }
            }
        }
        self.items.types.insert(key(&full), Type { declaration, dialect, space: self.space });
    }

    fn globals(&mut self, section: &'a ast::VarSection, dialect: Dialect) {
        if section.kind != ast::SectionKind::Global {
            self.items.access.push((section, dialect));
            return;
        }
        let written = section.name.as_ref().map_or("Globals", |name| name.text.as_str());
        let of_data = self.free_name(written);
        // Several sections may make one list.
        let goes_on = section.name.is_some() && self.items.lists.iter().any(|list| list.name.eq_ignore_ascii_case(written));
        let name = if goes_on { written.to_owned() } else { of_data.clone() };
        self.places.insert((Space::Block, key(&of_data)), section.span);
        let qualified = section.attributes.iter().any(|attribute| attribute.name.is("qualified_only"));
        let list = self.items.lists.len();
        self.items.qualifiers.insert(key(&name));
        for declaration in &section.declarations {
            for declared in &declaration.names {
                let word = &declared.name;
                let full = format!("{name}.{}", word.text);
                if self.declare(Space::Global, if qualified { &full } else { &word.text }, word.span) {
                    self.items.globals.insert(key(&full), (list, declaration));
                    if !qualified {
                        self.items.globals.entry(key(&word.text)).or_insert((list, declaration));
                    }
                }
            }
        }
        let wanted = Wanted { name: of_data, kind: BlockKind::DataBlock, fixed: None, span: section.span, library: self.library };
        self.items.lists.push(List { name, section, dialect, number: 0 });
        self.pending.push((wanted, Pending::List(list)));
    }
}

/// Whether an organization block has an input of this section that tells of its first call.
pub(super) fn is_called_first(block: &ast::Block, section: &ast::VarSection) -> bool {
    let mut names = section.declarations.iter().flat_map(|declaration| &declaration.names);
    block.kind == ast::BlockKind::OrganizationBlock
        && section.kind == ast::SectionKind::Input
        && names.any(|declared| declared.name.is(INITIAL_CALL))
}
