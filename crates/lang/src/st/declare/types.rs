//! Types as written in ST → types with a layout.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use sieben_model::block::{BlockId, BlockKind};
use sieben_model::diagnostic::Diagnostic;
use sieben_model::literal::Value;
use sieben_model::problems::Problem;
use sieben_model::source::Span;
use sieben_model::types::{DataType, Enumeration, Field, Reference, ReferenceKind, STRING_LENGTH_MAX, Structure, Subrange, place};

use super::initial::range;
use super::items::{Items, numbered};
use super::{Demand, InitialAddress, Named, Types, ast};
use crate::declarations::BLOCK_BYTES_MAX;
use crate::declarations::reuse::Knows;
use crate::declarations::types::State;
use crate::scope::{did_you_mean, key};
use crate::st::ast::{Dimension, TypeKind, TypeSpec};
use crate::st::check::names::Entity;
use crate::st::dialect::{Calendar, Construct, Dialect, Judgement};
use crate::st::open_arrays::OPEN;
use crate::st::standard::Provided;
use crate::st::standard::library::block_type;
use crate::st::variants;
use crate::st::{dtl, error_struct, points, type_class};

/// Function blocks that every dialect has as types of instances.
const BLOCKS_OF_ALL_DIALECTS: [&str; 6] = ["TP", "TON", "TOF", "CTU", "CTD", "CTUD"];

/// Dimensions that an array may have.
const DIMENSIONS_MAX: usize = 16;
/// No place in particular: names mean what they mean outside any namespace.
const NOWHERE: usize = usize::MAX;
/// Values that an enumeration may have.
const VALUES_MAX: usize = 65_536;

/// The structure of a user-defined type that ST declares; `None` if it is another one.
pub(super) fn user_defined<'a>(types: &mut Types<'a>, items: &'a Items<'a>, number: u16, span: Span) -> Option<Option<Arc<Structure>>> {
    let wanted = items.numbered_types.get(&number)?;
    let dialect = items.types.get(wanted)?.dialect;
    let named = Resolver::new(types, items, dialect).type_of_key(wanted, span);
    Some(match named?.data_type.clone() {
        DataType::Struct(structure) => Some(structure),
        _ => {
            types.report(Problem::P2210, span, format!("`UDT {number}` is no STRUCT"));
            None
        }
    })
}

/// Resolves the types that nobody has asked for, so that all that is wrong with them is said.
pub(crate) fn all_types<'a>(types: &mut Types<'a>, items: &'a Items<'a>) {
    let mut all: Vec<_> = items.types.iter().map(|(wanted, found)| (found.declaration.name.span, wanted, found.dialect)).collect();
    all.sort_unstable();
    for (span, wanted, dialect) in all {
        Resolver::new(types, items, dialect).type_of_key(wanted, span);
    }
}

/// Resolves what the declarations of one block, or of one type, say.
pub(super) struct Resolver<'t, 'a> {
    pub(super) types: &'t mut Types<'a>,
    pub(super) items: &'a Items<'a>,
    pub(super) dialect: Dialect,
    /// Where the names are written, in [`Items::spaces`].
    pub(super) space: usize,
    /// What the names of the block stand for, as far as it is known.
    pub(super) names: HashMap<String, Entity>,
    /// Constants of the block that nobody has asked for yet.
    pub(super) constant_declarations: HashMap<String, &'a ast::Declaration>,
    /// Whether the type that comes next may be an ARRAY[*].
    pub(super) open_arrays: bool,
    /// Whether the array that comes next is what a pointer points to.
    pub(super) behind_pointer: bool,
    /// Whether the type that comes next is only pointed to.
    pub(super) behind_reference: bool,
    /// Whether the variable that comes next lasts, so that a restart can write what it begins with.
    pub(super) later: bool,
    /// The list of global variables that is laid out: it knows its own names.
    pub(super) list: Option<&'a str>,
    /// The block whose declarations these are.
    pub(super) own: Option<BlockId>,
    /// Declarations whose sizes are being looked for.
    pub(super) sized: Vec<Span>,
    /// What of the variable begins with an address.
    pub(super) addresses: Vec<InitialAddress>,
}

/// Words of codesys for what is as wide as a pointer.
const POINTER_SIZED: &[(&str, DataType)] =
    &[("__XWORD", DataType::LongWord), ("__UXINT", DataType::UnsignedLongInt), ("__XINT", DataType::LongInt)];

/// Types of tia that name a module, a connection or an organization block by its number, by the beginning of their word.
const NUMBERS_OF_TIA: &[(&str, DataType)] = &[
    ("HW_", DataType::Word),
    ("CONN_", DataType::Word),
    ("OB_", DataType::Int),
    ("EVENT_", DataType::DoubleWord),
    ("AOM_IDENT", DataType::DoubleWord),
    ("PORT", DataType::UnsignedInt),
    ("RTM", DataType::UnsignedInt),
    ("PIP", DataType::UnsignedInt),
];

/// What stands behind the beginning of such a word.
#[rustfmt::skip] // A table.
const NUMBERED_OF_TIA: &[&str] = &[
    "", "ANY", "IO", "DEVICE", "DPMASTER", "DPSLAVE", "IOSYSTEM", "SUBMODULE", "MODULE", "INTERFACE", "IEPORT", "HSC", "PWM", "PTO", "PRG", "OUC", "R_ID",
    "DELAY", "TOD", "CYCLIC", "ATT", "PCYCLE", "HWINT", "DIAG", "TIMEERROR", "STARTUP",
];

/// The longest STRING that is taken as one of 254 characters.
const LONG_STRING_MAX: i128 = 65_535;

impl<'t, 'a> Resolver<'t, 'a> {
    pub(super) fn new(types: &'t mut Types<'a>, items: &'a Items<'a>, dialect: Dialect) -> Self {
        let (names, constant_declarations) = (HashMap::new(), HashMap::new());
        Self {
            types,
            items,
            dialect,
            space: NOWHERE,
            names,
            constant_declarations,
            open_arrays: false,
            behind_pointer: false,
            behind_reference: false,
            later: false,
            list: None,
            own: None,
            sized: Vec::new(),
            addresses: Vec::new(),
        }
    }

    /// Whether what lasts may begin with an address: in dialects whose blocks have objects, which a restart begins.
    pub(super) fn begins_later(&self, lasts: bool) -> bool {
        lasts && self.dialect.judge(Construct::ObjectOrientation) != crate::st::dialect::Judgement::Reject
    }

    /// The same for names that are written at this place.
    pub(super) fn within(mut self, space: usize) -> Self {
        self.space = space;
        self
    }

    pub(super) fn report(&mut self, problem: Problem, span: Span, message: impl Into<String>) -> &mut Diagnostic {
        self.types.report(problem, span, message)
    }

    /// Says what the dialect thinks of a construct; whether it is part of it.
    pub(super) fn judge(&mut self, construct: Construct, span: Span) -> bool {
        let row = construct.row();
        let title = self.dialect.title();
        match self.dialect.judge(construct) {
            Judgement::Accept => true,
            Judgement::Note => {
                self.report(Problem::P6051, span, format!("{} is not written in {title}", row.title)).help = Some(advice(row.instead));
                true
            }
            Judgement::Reject => {
                self.report(Problem::P6050, span, format!("{title} does not have {}", row.title)).help = Some(advice(row.instead));
                false
            }
        }
    }

    /// The type that a word names by itself in the dialect.
    pub(super) fn word(&self, word: &str) -> Option<DataType> {
        let long = self.dialect.switches().calendar == Calendar::Long;
        let data_type = match DataType::from_any_word(word) {
            Some(DataType::Date) if long => DataType::LongDate,
            Some(DataType::DateAndTime) if long => DataType::LongDateAndTime,
            Some(data_type @ (DataType::LongDate | DataType::LongDateAndTime)) if long => data_type.of_nanoseconds(word),
            Some(DataType::String(_)) => DataType::String(self.string_length()),
            Some(DataType::WideString(_)) => DataType::WideString(u16::from(self.string_length())),
            // Words of the S7 that elsewhere are names like others.
            Some(data_type) if data_type.is_number() && !self.dialect.switches().numbered_blocks => return None,
            Some(data_type) => data_type,
            None if self.dialect.has_pointers()
                && let Some((_, data_type)) = POINTER_SIZED.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)) =>
            {
                data_type.clone()
            }
            None if self.dialect.has_pointers() && type_class::ANY_WORDS.iter().any(|any| any.eq_ignore_ascii_case(word)) => DataType::Any,
            None if self.dialect.has_pointers() && word.eq_ignore_ascii_case(type_class::WORD) => type_class::data_type(),
            None if word.eq_ignore_ascii_case("BIT") => DataType::Bool,
            None if word.eq_ignore_ascii_case(variants::WORD) => DataType::Any,
            None if word.eq_ignore_ascii_case(dtl::WORD) && self.dialect.judge(Construct::PeekPoke) == Judgement::Accept => {
                dtl::data_type()
            }
            None if self.has_variants() && error_struct::data_type(word).is_some() => error_struct::data_type(word)?,
            None if self.dialect.switches().organization_block_inputs && number_of_tia(word).is_some() => number_of_tia(word)?,
            None if word.eq_ignore_ascii_case("DB_ANY") && self.dialect.switches().numbered_blocks => DataType::BlockData,
            None => return None,
        };
        Some(data_type)
    }

    /// Whether a VARIANT is more than an ANY.
    pub(super) fn has_variants(&self) -> bool {
        self.dialect.judge(Construct::PeekPoke) == Judgement::Accept
    }

    fn string_length(&self) -> u8 {
        u8::try_from(self.dialect.switches().string_length).unwrap_or(STRING_LENGTH_MAX).min(STRING_LENGTH_MAX)
    }

    /// The type as written; `None` if something was wrong with it, which is reported.
    pub(super) fn data_type(&mut self, written: &TypeSpec) -> Option<DataType> {
        self.type_and_initial(written).map(|(data_type, _)| data_type)
    }

    /// The type as written, with the initial values that its name brings along.
    pub(super) fn type_and_initial(&mut self, written: &TypeSpec) -> Option<(DataType, Vec<Value>)> {
        if !self.types.enter(written.span) {
            return None;
        }
        let found = self.type_inside(written, None);
        self.types.leave();
        found
    }

    fn type_inside(&mut self, written: &TypeSpec, name: Option<&str>) -> Option<(DataType, Vec<Value>)> {
        let span = written.span;
        let plain = |data_type| Some((data_type, Vec::new()));
        match &written.kind {
            TypeKind::Missing => None,
            TypeKind::Inferred => {
                self.report(Problem::P3015, span, "this declaration has no type");
                None
            }
            TypeKind::Named(path) => {
                let named = self.named(path)?;
                Some((named.data_type.clone(), named.initial.clone()))
            }
            TypeKind::String { wide, length } => {
                let length = match length {
                    Some(length) => self.integer(length)?,
                    None => i128::from(self.string_length()),
                };
                let limit = if *wide { 16_382 } else { i128::from(STRING_LENGTH_MAX) };
                // Where strings are longer by nature, those of programs often have room for 255.
                if !*wide && (limit + 1..=LONG_STRING_MAX).contains(&length) && !self.dialect.switches().numbered_blocks {
                    let message = format!("this STRING has room for {limit} characters here, not for {length}");
                    self.report(Problem::P6326, span, message);
                    return plain(DataType::String(STRING_LENGTH_MAX));
                }
                if !(0..=limit).contains(&length) {
                    let message = format!("a {} has 0 to {limit} characters, not {length}", if *wide { "WSTRING" } else { "STRING" });
                    self.report(Problem::P4004, span, message);
                    return None;
                }
                plain(if *wide { DataType::WideString(length as u16) } else { DataType::String(length as u8) })
            }
            TypeKind::Array { dimensions, element } => plain(self.array(dimensions, element, span)?),
            TypeKind::Struct { fields, overlap } => {
                let layout = if *overlap { FieldLayout::Overlap } else { FieldLayout::Sequence };
                plain(DataType::Struct(self.structure(fields, name, None, layout, span)?))
            }
            TypeKind::Union(fields) => plain(DataType::Struct(self.structure(fields, name, None, FieldLayout::Union, span)?)),
            TypeKind::Subrange { base, low, high } => {
                let base = self.named(base)?.data_type.clone();
                let Some(limits) = range(&base) else {
                    self.report(Problem::P3015, span, format!("{} has no subranges; an integer type has", self.dialect.type_words(&base)));
                    return None;
                };
                let (low, high) = (self.integer(low), self.integer(high));
                let (low, high) = (low?, high?);
                if low > high || low < limits.0 || high > limits.1 {
                    let message = format!("{low}..{high} is no part of {}, {} to {}", self.dialect.type_words(&base), limits.0, limits.1);
                    self.report(Problem::P4004, span, message);
                    return None;
                }
                let initial = if (low..=high).contains(&0) { 0 } else { low };
                plain(DataType::Subrange(Arc::new(Subrange { name: name.map(str::to_owned), base, low, high, initial })))
            }
            TypeKind::Enumeration { base, values } => {
                let data_type = self.enumeration(base.as_ref(), values, name, span)?;
                if name.is_none()
                    && let DataType::Enumeration(enumeration) = &data_type
                {
                    for (value, number) in &enumeration.values {
                        let entity = Entity::EnumValue { data_type: data_type.clone(), value: i128::from(*number) };
                        self.names.entry(key(value)).or_insert(entity);
                    }
                }
                plain(data_type)
            }
            // What is given to FB_Init, the restart calls it with.
            TypeKind::Constructed { block, .. } => {
                let named = self.named(block)?;
                if !matches!(named.data_type, DataType::Instance { .. }) {
                    let message =
                        format!("{} is no function block, and only these take arguments here", self.dialect.type_words(&named.data_type));
                    self.report(Problem::P3015, span, message);
                    return None;
                }
                Some((named.data_type.clone(), named.initial.clone()))
            }
            TypeKind::Reference(target) => self.reference(target, ReferenceKind::RefTo),
            TypeKind::Pointer(target) => self.reference(target, ReferenceKind::Pointer),
            TypeKind::Alias(target) => self.reference(target, ReferenceKind::Reference),
        }
    }

    /// Says that there are no instances of a type, if it is that of an ABSTRACT block.
    pub(super) fn no_abstract(&mut self, data_type: &DataType, span: Span) {
        match data_type {
            DataType::Array { element, .. } => self.no_abstract(element, span),
            DataType::Instance { block, .. } => {
                let items = self.items;
                let Some(object) = items.objects.get(*block).filter(|object| object.is_abstract) else { return };
                let message = format!("`{}` is ABSTRACT and has no instances of its own", object.name);
                self.report(Problem::P6285, span, message).help =
                    Some("Declare an instance of a block that extends it, or a reference to it.".to_owned());
            }
            _ => {}
        }
    }

    fn reference(&mut self, target: &TypeSpec, kind: ReferenceKind) -> Option<(DataType, Vec<Value>)> {
        self.behind_pointer = matches!(target.kind, TypeKind::Array { .. });
        let target = match &target.kind {
            TypeKind::Named(path) if let Some(unfinished) = self.unfinished(path) => unfinished,
            _ => {
                self.behind_reference = true;
                let target = self.data_type(target);
                self.behind_reference = false;
                target?
            }
        };
        Some((DataType::Reference(Arc::new(Reference { target, kind })), Vec::new()))
    }

    /// A function block, or a structure that is being declared, by its name alone: what points to it may be a part of it.
    fn unfinished(&self, path: &ast::Path) -> Option<DataType> {
        let words: Vec<&str> = path.names.iter().map(|name| name.text.as_str()).collect();
        let full_name = words.join(".");
        let spellings = self.items.spellings(self.space, &full_name);
        if let Some(full) = spellings.iter().find(|full| self.items.types.contains_key(*full)) {
            let found = self.items.types.get(full)?;
            let is_structure = matches!(found.declaration.data_type.kind, TypeKind::Struct { .. } | TypeKind::Union(_));
            let begun = matches!(self.types.known.named.get(full), Some(State::InProgress));
            let structure = Structure { name: Some(found.declaration.name.text.clone()), ..Structure::default() };
            return (is_structure && begun).then(|| DataType::Struct(Arc::new(structure)));
        }
        let block = self.items.block_in(self.space, &full_name)?;
        let own = block.kind == BlockKind::FunctionBlock && self.items.code.contains_key(&block);
        let is_plain = own && !self.items.objects.is_interface(block) && !self.items.is_twice(self.space, &full_name);
        let name = self.items.names.get(&block).cloned();
        is_plain.then(|| DataType::Instance { block, structure: Arc::new(Structure { name, ..Structure::default() }) })
    }

    /// The type of a name: a word, a block by number, a type or a function block of the project, a symbol.
    pub(super) fn named(&mut self, path: &ast::Path) -> Option<Arc<Named>> {
        let span = path.span;
        let plain = |data_type: DataType| Some(Arc::new(Named { data_type, initial: Vec::new() }));
        if let Some(name) = path.single() {
            if name.quoting != ast::Quoting::Global {
                // `Counter` and `Timer` are usual names of function blocks, and type words of the S7.
                let own = self
                    .items
                    .spellings(self.space, &name.text)
                    .iter()
                    .any(|full| self.items.blocks.contains_key(full) || self.items.types.contains_key(full));
                if let Some(data_type) = self.word(&name.text).filter(|data_type| !(own && data_type.is_number())) {
                    return plain(data_type);
                }
                if let Some(id) = numbered(&name.text, self.dialect) {
                    return plain(self.types.type_of_block(id, span)?);
                }
            }
        } else if path.names.is_empty() {
            return None;
        } else if let ([system, name], true) = (path.names.as_slice(), self.dialect.has_pointers())
            && system.is(type_class::SYSTEM)
            && name.is(type_class::WORD)
        {
            return plain(type_class::data_type());
        }
        let words: Vec<&str> = path.names.iter().map(|name| name.text.as_str()).collect();
        let full_name = words.join(".");
        if self.items.is_twice(self.space, &full_name) {
            return None;
        }
        let spellings = self.items.spellings(self.space, &full_name);
        if let Some(full) = spellings.iter().find(|full| self.items.types.contains_key(*full)) {
            return self.type_of_key(full, span);
        }
        // `Standard.TON`: the library of a block needs not be told.
        let last = words.last().copied().unwrap_or_default();
        if self.items.types.contains_key(&key(last)) && words.len() > 1 {
            return self.type_of_key(&key(last), span);
        }
        let items = self.items;
        let own = spellings.iter().find_map(|full| items.blocks.get(full)).or_else(|| items.blocks.get(&key(last))).copied();
        let block = own.or_else(|| self.types.scope.own_block(last));
        if let Some(id) = block {
            if items.code.get(&id).is_some_and(|code| code.block.kind == ast::BlockKind::Program) {
                let message = format!("`{full_name}` is a PROGRAM, and only a CONFIGURATION makes instances of one");
                self.report(Problem::P3015, span, message).help =
                    Some(format!("Write `FUNCTION_BLOCK {full_name}` if it is to have instances."));
                return None;
            }
            let target = self.types.type_of_block(id, span)?;
            // A variable of an interface refers to an instance of a block that implements it.
            return plain(match items.objects.is_interface(id) {
                true => DataType::Reference(Arc::new(Reference { target, kind: ReferenceKind::Interface })),
                false => target,
            });
        }
        if last.eq_ignore_ascii_case(points::WORD) && block_type("CHARCURVE", self.dialect).is_some() {
            return plain(points::data_type());
        }
        match self.of_library(last) {
            Some(Some(id)) => return plain(self.types.type_of_block(id, span)?),
            // Known in a moment, when the block of the library is there.
            Some(None) => return None,
            None => {}
        }
        match self.types.scope.block(last) {
            Some(id) => plain(self.types.type_of_block(id, span)?),
            None => {
                let blocks = items.names.iter().filter(|(id, _)| id.kind == BlockKind::FunctionBlock).map(|(_, name)| name.as_str());
                let own = items.types.values().map(|found| found.declaration.name.text.as_str());
                let scope = self.types.scope;
                let own = scope.nearest(last, own.chain(blocks));
                // A type that only other dialects have is not what was meant.
                let words = DataType::all_words().chain(["ARRAY", "STRUCT"]);
                let words = words.filter(|word| !word.eq_ignore_ascii_case(last));
                let library = crate::st::standard::library::block_types(self.dialect).chain(BLOCKS_OF_ALL_DIALECTS);
                let nearest = scope.nearest(last, own.as_deref().into_iter().chain(words.chain(library).map(|word| word as &str)));
                let nearest = nearest.or_else(|| scope.nearest_symbol(last));
                let message = format!("there is no type `{full_name}`{}", did_you_mean(nearest));
                self.report(Problem::P3015, span, message).may_be_elsewhere = true;
                None
            }
        }
    }

    /// The function block of the library with this name; `Some(None)` if the program does not have it yet, which is asked for.
    fn of_library(&mut self, name: &str) -> Option<Option<BlockId>> {
        let function_block = || crate::library::by_name(name).filter(|block| block.block.kind == BlockKind::FunctionBlock);
        let provided = block_type(name, self.dialect).or_else(|| function_block().map(Provided::Library))?;
        let (found, demand) = match provided {
            Provided::System(block) => return Some(Some(block)),
            Provided::Source { name, source } => (self.items.library.get(&(source.path, key(name))).copied(), Demand::Source(source)),
            Provided::Library(block) => {
                let id = self.types.scope.block(block.name).filter(|&id| self.types.exists(id));
                (id, Demand::Block(block))
            }
        };
        self.types.known.uses.push(demand);
        if found.is_none() {
            self.types.known.demands.push(demand);
        }
        Some(found)
    }

    /// A type of a TYPE section.
    pub(super) fn type_of_key(&mut self, wanted: &str, span: Span) -> Option<Arc<Named>> {
        match self.types.known.named.get(wanted) {
            Some(State::Done(done)) => return done.clone(),
            Some(State::InProgress) => {
                let name = self.items.types.get(wanted).map_or(wanted, |found| found.declaration.name.text.as_str());
                self.report(Problem::P3016, span, format!("`{name}` contains itself"));
                return None;
            }
            None => {}
        }
        let items = self.items;
        let found = items.types.get(wanted)?;
        if !self.types.enter(span) {
            return None;
        }
        self.types.known.named.insert(wanted.to_owned(), State::InProgress);
        let declaration = found.declaration;
        let before = self.types.known.mark();
        self.types.reuse.begin_shared();
        let mut inner = Resolver::new(self.types, items, found.dialect).within(found.space);
        let resolved = inner.declared_type(declaration).map(Arc::new);
        self.types.reuse.end_shared();
        if !self.types.known.has_only_blocks_since(&before) {
            // Initial values at addresses are written in the order in which they are found.
            self.types.reuse.depends_on_order();
        }
        self.types.leave();
        self.types.known.named.insert(wanted.to_owned(), State::Done(resolved.clone()));
        resolved
    }

    fn declared_type(&mut self, declaration: &ast::TypeDeclaration) -> Option<Named> {
        let name = Some(declaration.name.text.as_str());
        let span = declaration.data_type.span;
        let (mut data_type, mut initial) = match (&declaration.data_type.kind, &declaration.extends) {
            (TypeKind::Struct { fields, .. }, Some(base)) => {
                let Some(extended) = self.named(base) else {
                    // The fields of its own may have their own mistakes.
                    drop(self.structure(fields, name, None, FieldLayout::Sequence, span));
                    return None;
                };
                let base = match &extended.data_type {
                    DataType::Struct(structure) => Arc::clone(structure),
                    _ => {
                        self.report(Problem::P3015, base.span, "a structure extends a structure");
                        return None;
                    }
                };
                (DataType::Struct(self.structure(fields, name, Some(&base), FieldLayout::Sequence, span)?), Vec::new())
            }
            _ => self.type_inside(&declaration.data_type, name)?,
        };
        let named = declaration.attributes.iter().any(|attribute| attribute.name.is("to_string"));
        if let (DataType::Enumeration(enumeration), true) = (&mut data_type, named) {
            Arc::make_mut(enumeration).named = true;
        }
        if let Some(initializer) = &declaration.initial {
            let values = self.initial(initializer, &data_type);
            match (&mut data_type, values.as_slice()) {
                (DataType::Enumeration(enumeration), [value]) => {
                    if let Some(number) = number_of(value, &enumeration.base) {
                        Arc::make_mut(enumeration).initial = i64::try_from(number).unwrap_or_default();
                    }
                }
                (DataType::Subrange(subrange), [value]) => {
                    if let Some(number) = number_of(value, &subrange.base) {
                        Arc::make_mut(subrange).initial = number;
                    }
                }
                _ => initial = values,
            }
        }
        Some(Named { data_type, initial })
    }

    fn enumeration(
        &mut self,
        base: Option<&ast::Path>,
        values: &[(ast::Name, Option<ast::Expression>)],
        name: Option<&str>,
        span: Span,
    ) -> Option<DataType> {
        let base = match base {
            Some(path) => self.named(path)?.data_type.clone(),
            None => DataType::Int,
        };
        let Some((low, high)) = range(&base) else {
            self.report(
                Problem::P3015,
                span,
                format!("{} cannot hold the values of an enumeration; an integer type can", self.dialect.type_words(&base)),
            );
            return None;
        };
        if values.is_empty() || values.len() > VALUES_MAX {
            self.report(Problem::P4004, span, format!("an enumeration has 1 to {VALUES_MAX} values, not {}", values.len()));
            return None;
        }
        let mut found: Vec<(String, i64)> = Vec::with_capacity(values.len());
        let mut seen: HashSet<String> = HashSet::new();
        let mut next = 0_i128;
        for (value, written) in values {
            if !seen.insert(key(&value.text)) {
                self.report(Problem::P3006, value.span, format!("`{}` is declared twice in this enumeration", value.text));
                continue;
            }
            if let Some(expression) = written {
                let own = match &expression.kind {
                    ast::ExpressionKind::Name(name) => found.iter().find(|(known, _)| known.eq_ignore_ascii_case(&name.text)),
                    _ => None,
                };
                next = match own {
                    Some(&(_, number)) => i128::from(number),
                    None => self.integer(expression)?,
                };
            }
            if !(low..=high).contains(&next) || i64::try_from(next).is_err() {
                self.report(
                    Problem::P4001,
                    value.span,
                    format!("the value {next} of `{}` is outside the range of {}", value.text, self.dialect.type_words(&base)),
                );
                return None;
            }
            found.push((value.text.clone(), next as i64));
            next += 1;
        }
        let initial = found.first().map_or(0, |&(_, number)| number);
        Some(DataType::Enumeration(Arc::new(Enumeration {
            name: name.map(str::to_owned),
            base,
            values: found,
            initial,
            named: false,
            index: Default::default(),
        })))
    }

    fn array(&mut self, dimensions: &[Dimension], element: &TypeSpec, span: Span) -> Option<DataType> {
        let open = std::mem::take(&mut self.open_arrays);
        let behind_pointer = std::mem::take(&mut self.behind_pointer);
        // What an array consists of that is only pointed to, is known by its name.
        let by_name = match &element.kind {
            TypeKind::Named(path) if self.behind_reference => self.unfinished(path),
            _ => None,
        };
        let element = by_name.or_else(|| self.data_type(element));
        if dimensions.is_empty() || dimensions.len() > DIMENSIONS_MAX {
            let message = format!("an array has 1 to {DIMENSIONS_MAX} dimensions, not {}", dimensions.len());
            self.report(Problem::P4004, span, message);
            return None;
        }
        let mut bounds = Vec::with_capacity(dimensions.len());
        let mut whole = true;
        for dimension in dimensions {
            let Dimension::Bounds(pair) = dimension else {
                if !open {
                    let message = "ARRAY[*] is only for VAR_IN_OUT, and VAR_INPUT of functions: the caller has the array";
                    self.report(Problem::P4009, span, message).help = Some("Give the array its bounds here.".to_owned());
                    return None;
                }
                bounds.push(OPEN);
                continue;
            };
            let (low, high) = (self.integer(&pair.0), self.integer(&pair.1));
            let (Some(low), Some(high)) = (low, high) else {
                whole = false;
                continue;
            };
            let place = pair.0.span.to(pair.1.span);
            let (Ok(low_index), Ok(high_index)) = (i32::try_from(low), i32::try_from(high)) else {
                let message = format!("array bounds lie between {} and {}, not {low}..{high}", i32::MIN, i32::MAX);
                self.report(Problem::P4004, place, message);
                return None;
            };
            if low > high {
                self.report(Problem::P4004, place, format!("the lower array bound {low} is above the upper bound {high}"));
                return None;
            }
            bounds.push((low_index, high_index));
        }
        let element = element?;
        if !whole {
            return None;
        }
        if element == DataType::Void || element.is_number() {
            self.report(Problem::P4009, span, format!("an array cannot consist of {}", self.dialect.type_words(&element)));
            return None;
        }
        if bounds.contains(&OPEN) && bounds.iter().any(|bounds| *bounds != OPEN) {
            self.report(Problem::P4009, span, "the bounds of an ARRAY[*] are all `*`, or none is");
            return None;
        }
        let room = BLOCK_BYTES_MAX * 8 / u64::from(crate::st::check::places::element_step(&element).max(1));
        if let (true, [(low, high)]) = (behind_pointer, &mut bounds[..])
            && (i64::from(*high) - i64::from(*low)) as u64 >= room
        {
            // As many elements as any data block has room for: whoever writes 32000 means all that are there.
            *high = (i64::from(*low) + room as i64 - 1) as i32;
        }
        let array = DataType::Array { bounds, element: Box::new(element) };
        if array.bits() > BLOCK_BYTES_MAX * 8 {
            let message = format!("this array needs {} bytes; a block has at most {BLOCK_BYTES_MAX}", array.bits().div_ceil(8));
            self.report(Problem::P5002, span, message);
            return None;
        }
        Some(array)
    }

    /// The fields of a STRUCT, one behind the other and behind those of its base, or of a UNION, all at the beginning.
    pub(super) fn structure(
        &mut self,
        declarations: &[ast::Declaration],
        name: Option<&str>,
        base: Option<&Structure>,
        layout: FieldLayout,
        span: Span,
    ) -> Option<Arc<Structure>> {
        let mut structure = Structure { name: name.map(str::to_owned), ..Structure::default() };
        let mut cursor = 0;
        if let Some(base) = base {
            structure.fields.clone_from(&base.fields);
            // The bytes of an empty base are its own alone.
            cursor = if base.fields.is_empty() { 0 } else { u64::from(base.size) * 8 };
        }
        let mut names: HashSet<String> = structure.fields.iter().map(|field| key(&field.name)).collect();
        let mut whole = true;
        let mut end = cursor;
        for declaration in declarations {
            let Some((data_type, named)) = self.type_and_initial(&declaration.data_type) else {
                whole = false;
                continue;
            };
            if data_type == DataType::Void || data_type.is_number() {
                self.report(
                    Problem::P4009,
                    declaration.data_type.span,
                    format!("a STRUCT cannot hold {}", self.dialect.type_words(&data_type)),
                );
                whole = false;
                continue;
            }
            let placed = match &declaration.location {
                Some(ast::Location::Relative { offset, bits, span }) => {
                    let elementary = data_type.is_elementary() || data_type.is_long();
                    let fits = !elementary && *bits >= 8 || data_type.bits() == u64::from(*bits);
                    match offset.filter(|offset| fits && *offset < BLOCK_BYTES_MAX * 8) {
                        Some(offset) => Some(offset),
                        None => {
                            let message = format!("{} cannot lie there in a STRUCT", self.dialect.type_words(&data_type));
                            let help =
                                "A BOOL is written `AT %X2.0`, all else with the byte and its own width: `AT %B2`, `AT %W2`, `AT %D4`.";
                            self.report(Problem::P6127, *span, message).help = Some(help.to_owned());
                            whole = false;
                            continue;
                        }
                    }
                }
                // A field that is linked to an input or output where the controller is configured.
                Some(ast::Location::Address(address))
                    if address.position == ast::Position::Open && self.dialect.switches().unlinked_is_memory =>
                {
                    self.is_memory(address.span);
                    None
                }
                Some(ast::Location::Address(address)) => {
                    let message = "a field lies in its STRUCT, not in an area of the CPU";
                    self.report(Problem::P6127, address.span, message).help = Some("Write where it begins, as in `AT %B2`.".to_owned());
                    whole = false;
                    continue;
                }
                _ => None,
            };
            let initial = match &declaration.initial {
                Some(initializer) => self.initial(initializer, &data_type),
                None => named,
            };
            for declared in &declaration.names {
                let word = &declared.name;
                if !names.insert(key(&word.text)) {
                    self.report(Problem::P3006, word.span, format!("`{}` is declared twice in this STRUCT", word.text));
                    whole = false;
                    continue;
                }
                let (offset, behind) = match placed {
                    Some(offset) => (offset, offset + data_type.bits()),
                    None => place(if layout == FieldLayout::Union { 0 } else { cursor }, &data_type),
                };
                let covers = |field: &&Field| {
                    let begin = u64::from(field.offset);
                    begin < behind && offset < begin + field.data_type.bits()
                };
                // Behind all others nothing is covered.
                let covered = if offset < end { structure.fields.iter().find(covers) } else { None };
                if let (FieldLayout::Sequence, Some(covered)) = (layout, covered) {
                    let message = format!("`{}` lies where `{}` lies", word.text, covered.name);
                    self.report(Problem::P6127, word.span, message).help = Some("Write `STRUCT OVERLAP` if this is meant.".to_owned());
                    whole = false;
                    continue;
                }
                // What begins first says what the bytes hold that fields share.
                let shared = match layout {
                    FieldLayout::Union => !structure.fields.is_empty(),
                    _ => covered.is_some(),
                };
                cursor = behind;
                end = end.max(behind);
                if end > BLOCK_BYTES_MAX * 8 {
                    let message = format!("with `{}` this STRUCT is larger than {BLOCK_BYTES_MAX} bytes", word.text);
                    self.report(Problem::P5002, word.span, message);
                    return None;
                }
                structure.fields.push(Field {
                    name: word.text.clone(),
                    data_type: data_type.clone(),
                    offset: offset as u32,
                    initial: if shared { vec![Value::Image(Vec::new())] } else { initial.clone() },
                    comment: declaration.comment.clone(),
                });
            }
        }
        if !whole {
            return None;
        }
        // A base that only others give fields to.
        if structure.fields.is_empty() && layout == FieldLayout::Sequence && self.dialect.judge(Construct::EmptyStruct) == Judgement::Accept
        {
            structure.size = 2;
            return Some(Arc::new(structure));
        }
        self.types.closed(structure, end, span)
    }
}

/// How the fields of a structure lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FieldLayout {
    /// One behind the other.
    Sequence,
    /// Where they say, also in the same bytes.
    Overlap,
    /// All at the begin.
    Union,
}

/// A row's advice as a sentence.
pub(super) fn advice(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map(|first| first.to_uppercase().collect::<String>() + characters.as_str() + ".").unwrap_or_default()
}

/// The number that an initial value is.
fn number_of(value: &Value, base: &DataType) -> Option<i128> {
    let bits = match value {
        Value::Image(bytes) => bytes.iter().take(8).fold(0, |bits: u64, &byte| bits << 8 | u64::from(byte)),
        other => other.bits()?,
    };
    let (low, high) = range(base)?;
    let width = base.bits();
    let number = i128::from(bits);
    Some(if low < 0 && number > high { number - (1 << width) } else { number })
}

/// The block that a data type is an instance of.
pub(super) fn instance_of(data_type: &DataType) -> Option<BlockId> {
    match data_type {
        DataType::Instance { block, .. } => Some(*block),
        _ => None,
    }
}

/// The number that `HW_IO` and its like are.
fn number_of_tia(word: &str) -> Option<DataType> {
    let word = word.to_ascii_uppercase();
    NUMBERS_OF_TIA.iter().find_map(|(begin, data_type)| {
        let rest = word.strip_prefix(begin)?;
        (rest.is_empty() != begin.ends_with('_') && NUMBERED_OF_TIA.contains(&rest)).then(|| data_type.clone())
    })
}
