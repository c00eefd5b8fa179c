//! The names in a source of Structured Text.

mod expressions;

use sieben_model::address::Operand as Address;
use sieben_model::source::{FileId, Span};
use sieben_model::types::DataType;

use super::ast::{
    Block, BlockKind, Configuration, DataBlock, Declaration, Initializer, InitializerKind, Interface, Item, Location, Method, Name, Path,
    Property, Qualifier, Quoting, Resource, SectionKind, TestPart, TypeDeclaration, TypeKind, TypeSpec, VarSection,
};
use super::dialect::Dialect;
use super::parser::parse;
use crate::codesys_files;
use crate::names::{Access, Builder, Bytes, DefinitionKind, SourceNames, TypeRef, Written};

/// The names of a source.
pub(crate) fn names(name: &str, text: &str, dialect: Dialect) -> SourceNames {
    let read = codesys_files::read(FileId::default(), name, text);
    let mut parsed = parse(FileId::default(), read.as_ref().map_or(text, |read| &read.text), dialect);
    if dialect == Dialect::Codesys {
        super::declare::name_lists(&mut parsed.file, name);
    }
    let mut collector = Collector { to: Builder::new(text, None), calls_with_data_blocks: dialect == Dialect::Scl };
    collector.items(&parsed.file.items);
    let mut names = collector.to.finish();
    names.is_test = dialect.is_test();
    names
}

struct Collector<'t> {
    to: Builder<'t>,
    /// `FB10.DB20(…)` calls a function block with a data block, as in S7-SCL.
    calls_with_data_blocks: bool,
}

/// What a section declares, in a block of a kind.
fn section_kind(section: &VarSection, has_instance: bool) -> DefinitionKind {
    if section.has(Qualifier::Constant) || section.kind == SectionKind::Const {
        return DefinitionKind::Constant;
    }
    match section.kind {
        SectionKind::Input => DefinitionKind::Input,
        SectionKind::Output => DefinitionKind::Output,
        SectionKind::InOut => DefinitionKind::InOut,
        SectionKind::Temp => DefinitionKind::Temp,
        SectionKind::Var if !has_instance => DefinitionKind::Temp,
        SectionKind::Global => DefinitionKind::Global,
        _ => DefinitionKind::Static,
    }
}

/// How a name of an expression is written.
fn written(name: &Name) -> fn(u32) -> Written {
    match name.quoting {
        Quoting::Bare | Quoting::Backquoted => Written::Plain,
        Quoting::Global => Written::Global,
        Quoting::Local => Written::Local,
    }
}

/// The block that a name is by its number: `FB10`.
fn numbered(name: &Name) -> Option<Address> {
    let is_bare = name.quoting == Quoting::Bare && name.text.ends_with(|last: char| last.is_ascii_digit());
    is_bare.then(|| Address::parse(&name.text)).flatten().filter(|operand| matches!(operand, Address::Block(_)))
}

impl Collector<'_> {
    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Block(block) => self.block(block),
                Item::DataBlock(block) => self.data_block(block),
                Item::Type(declared) => self.type_declaration(declared),
                Item::Globals(section) => self.globals(section),
                Item::Interface(interface) => self.interface(interface),
                Item::Namespace(namespace) => {
                    let Some(name) = namespace.name.names.last() else { continue };
                    let group = self.to.define(DefinitionKind::Group, &name.text, name.span, namespace.span);
                    let parent = self.to.parent.replace(group);
                    self.items(&namespace.items);
                    self.to.parent = parent;
                }
                Item::Using(path) => _ = self.type_path(path, Access::Path),
                Item::Configuration(configuration) => self.configuration(configuration),
            }
        }
    }

    /// A definition of something global, by its name or its number.
    fn define(&mut self, kind: DefinitionKind, name: &Name, whole: Span) -> u32 {
        let operand = numbered(name);
        let shown = operand.map_or_else(|| name.text.clone(), |operand| operand.spell(Default::default()));
        let index = match operand {
            Some(_) => self.to.define_at(kind, &shown, bytes(name.span), bytes(whole)),
            None => self.to.define(kind, &shown, name.span, whole),
        };
        self.to.definition(index).operand = operand;
        index
    }

    fn block(&mut self, block: &Block) {
        let kind = match block.kind {
            BlockKind::Program => DefinitionKind::Program,
            BlockKind::Function => DefinitionKind::Function,
            BlockKind::FunctionBlock | BlockKind::Class => DefinitionKind::FunctionBlock,
            BlockKind::OrganizationBlock | BlockKind::Implicit => DefinitionKind::OrganizationBlock,
            BlockKind::Interface => DefinitionKind::Interface,
            BlockKind::Method => DefinitionKind::Method,
            BlockKind::Test(_) => DefinitionKind::Test,
        };
        let title = block.header.title.as_ref();
        let index = match (block.kind, title) {
            (BlockKind::Test(TestPart::Test), Some(title)) => self.to.define(kind, &title.text, title.span, block.span),
            (BlockKind::Test(_) | BlockKind::Implicit, _) => {
                let place = Bytes { start: block.span.start, end: block.span.start };
                self.to.define_at(kind, &block.name.text, place, bytes(block.span))
            }
            _ => self.define(kind, &block.name, block.span),
        };
        self.to.definition(index).comment = title.map(|title| title.text.trim().to_owned()).unwrap_or_default();
        let outer = (self.to.scope.replace(index), self.to.parent.replace(index));
        for path in block.extends.iter().chain(&block.implements) {
            if self.type_path(path, Access::Type).is_some()
                && let Some(last) = path.names.last()
            {
                let id = self.to.id(&last.text);
                self.to.definition(index).extends.push(id);
            }
        }
        block.usings.iter().for_each(|path| _ = self.type_path(path, Access::Path));
        let has_instance = matches!(block.kind, BlockKind::FunctionBlock | BlockKind::Program | BlockKind::Class);
        block.sections.iter().for_each(|section| self.section(section, has_instance));
        for label in &block.labels {
            self.to.define(DefinitionKind::Label, &label.text, label.span, label.span);
        }
        if let Some(result) = &block.result {
            self.typed(index, result);
        }
        block.methods.iter().for_each(|method| self.method(method));
        block.properties.iter().for_each(|property| self.property(property));
        for action in &block.actions {
            let inner = self.to.define(DefinitionKind::Action, &action.name.text, action.name.span, action.span);
            self.body(inner, &action.body);
        }
        self.body(index, &block.body);
        (self.to.scope, self.to.parent) = outer;
    }

    /// The statements of a block.
    fn body(&mut self, index: u32, body: &[super::ast::Statement]) {
        if let (Some(first), Some(last)) = (body.first(), body.last()) {
            self.to.definition(index).body = Bytes { start: first.span.start, end: last.span.end.max(first.span.start) };
        }
        let outer = (self.to.scope.replace(index), self.to.parent.replace(index));
        self.labels(body);
        self.statements(body);
        (self.to.scope, self.to.parent) = outer;
    }

    fn method(&mut self, method: &Method) {
        let index = self.to.define(DefinitionKind::Method, &method.name.text, method.name.span, method.span);
        let outer = (self.to.scope.replace(index), self.to.parent.replace(index));
        method.sections.iter().for_each(|section| self.section(section, false));
        if let Some(result) = &method.result {
            self.typed(index, result);
        }
        self.body(index, &method.body);
        (self.to.scope, self.to.parent) = outer;
    }

    fn property(&mut self, property: &Property) {
        let index = self.to.define(DefinitionKind::Property, &property.name.text, property.name.span, property.span);
        self.typed(index, &property.data_type);
        let outer = (self.to.scope.replace(index), self.to.parent.replace(index));
        for accessor in property.get.iter().chain(&property.set) {
            accessor.sections.iter().for_each(|section| self.section(section, false));
            self.labels(&accessor.body);
            self.statements(&accessor.body);
        }
        (self.to.scope, self.to.parent) = outer;
    }

    fn interface(&mut self, interface: &Interface) {
        let index = self.define(DefinitionKind::Interface, &interface.name, interface.span);
        let parent = self.to.parent.replace(index);
        for path in &interface.extends {
            if self.type_path(path, Access::Type).is_some()
                && let Some(last) = path.names.last()
            {
                let id = self.to.id(&last.text);
                self.to.definition(index).extends.push(id);
            }
        }
        interface.methods.iter().for_each(|method| self.method(method));
        interface.properties.iter().for_each(|property| self.property(property));
        self.to.parent = parent;
    }

    fn data_block(&mut self, block: &DataBlock) {
        let index = self.define(DefinitionKind::DataBlock, &block.name, block.span);
        let title = block.header.title.as_ref().map(|title| title.text.trim().to_owned());
        self.to.definition(index).comment = title.unwrap_or_default();
        let outer = (self.to.scope.replace(index), self.to.parent.replace(index));
        match &block.data_type.kind {
            TypeKind::Struct { fields, .. } => {
                self.to.definition(index).of = TypeRef::Inline;
                fields.iter().for_each(|field| self.declaration(field, DefinitionKind::Field));
            }
            TypeKind::Missing => {
                self.to.definition(index).of = TypeRef::Inline;
                block.sections.iter().for_each(|section| self.section(section, true));
            }
            _ => self.typed(index, &block.data_type),
        }
        for (target, value) in &block.assignments {
            let target = self.assigned(target);
            self.initializer(value, target);
        }
        (self.to.scope, self.to.parent) = outer;
    }

    fn type_declaration(&mut self, declared: &TypeDeclaration) {
        let index = self.define(DefinitionKind::Type, &declared.name, declared.span);
        self.to.definition(index).comment = declared.comment.trim().to_owned();
        if let Some(path) = &declared.extends
            && self.type_path(path, Access::Type).is_some()
            && let Some(last) = path.names.last()
        {
            let id = self.to.id(&last.text);
            self.to.definition(index).extends.push(id);
        }
        self.typed(index, &declared.data_type);
        if let Some(initial) = &declared.initial {
            self.initializer(initial, None);
        }
    }

    fn globals(&mut self, section: &VarSection) {
        let parent = self.to.parent;
        if let Some(name) = &section.name {
            self.to.parent = Some(self.to.define(DefinitionKind::Group, &name.text, name.span, section.span));
        }
        self.section(section, true);
        self.to.parent = parent;
    }

    fn configuration(&mut self, configuration: &Configuration) {
        let group = self.to.define(DefinitionKind::Group, &configuration.name.text, configuration.name.span, configuration.span);
        let parent = self.to.parent.replace(group);
        configuration.sections.iter().for_each(|section| self.section(section, true));
        configuration.resources.iter().for_each(|resource| self.resource(resource));
        self.to.parent = parent;
    }

    fn resource(&mut self, resource: &Resource) {
        let parent = self.to.parent;
        if !resource.name.text.is_empty() {
            self.to.parent = Some(self.to.define(DefinitionKind::Group, &resource.name.text, resource.name.span, resource.span));
        }
        resource.sections.iter().for_each(|section| self.section(section, true));
        for task in &resource.tasks {
            self.to.define(DefinitionKind::Group, &task.name.text, task.name.span, task.span);
            self.arguments(None, &task.arguments);
        }
        for program in &resource.programs {
            let instance = self.to.define(DefinitionKind::Global, &program.name.text, program.name.span, program.span);
            if let Some(task) = &program.task {
                self.to.name(&task.text, task.span, Written::Plain, Access::Path);
            }
            let callee = self.type_path(&program.program, Access::Type);
            if let Some(name) = program.program.names.last() {
                self.to.definition(instance).data_type.clone_from(&name.text);
                let id = self.to.id(&name.text);
                self.to.definition(instance).of = TypeRef::Named(id);
            }
            self.arguments(callee, &program.arguments);
        }
        self.to.parent = parent;
    }

    fn section(&mut self, section: &VarSection, has_instance: bool) {
        let is_mention = matches!(section.kind, SectionKind::External | SectionKind::Config);
        let kind = section_kind(section, has_instance);
        for declaration in &section.declarations {
            if !is_mention {
                self.declaration(declaration, kind);
                continue;
            }
            // What is declared elsewhere.
            for declared in &declaration.names {
                let mut last = None;
                for name in declared.qualifier.iter().chain([&declared.name]) {
                    last = match last {
                        None => self.to.name(&name.text, name.span, Written::Plain, Access::Path),
                        Some(of) => self.to.name(&name.text, name.span, |id| Written::Member(of, id), Access::Path),
                    };
                }
            }
            self.type_spec(None, &declaration.data_type);
        }
    }

    fn declaration(&mut self, declaration: &Declaration, kind: DefinitionKind) {
        let mut first = None;
        for declared in &declaration.names {
            let name = &declared.name;
            let index = self.to.define(kind, &name.text, name.span, declaration.span);
            self.to.definition(index).comment = declaration.comment.trim().to_owned();
            match first {
                None => self.typed(index, &declaration.data_type),
                Some(first) => self.to.share_type(index, first),
            }
            first = first.or(Some(index));
            match &declaration.location {
                Some(Location::Address(address)) => {
                    let operand = Address::parse(address.written_text(self.to.text()));
                    self.to.definition(index).operand = operand;
                    if let Some(operand) = operand {
                        self.to.operand(operand, address.span, Access::Definition);
                    }
                }
                Some(Location::View(view)) => _ = self.to.name(&view.text, view.span, written(view), Access::Path),
                Some(Location::Path(path)) => _ = self.expression(path, Access::Path),
                Some(Location::Relative { .. }) | None => {}
            }
        }
        if let Some(initial) = &declaration.initial {
            let of = first.and_then(|first| self.to.occurrence_of(first));
            self.initializer(initial, of);
        }
    }

    fn initializer(&mut self, initializer: &Initializer, of: Option<u32>) {
        match &initializer.kind {
            InitializerKind::Expression(value) => _ = self.expression(value, Access::Read),
            InitializerKind::List { elements, .. } => elements.iter().for_each(|element| self.initializer(element, of)),
            InitializerKind::Repeat { values, .. } => values.iter().for_each(|value| self.initializer(value, of)),
            InitializerKind::Structure(fields) => {
                for (name, value) in fields {
                    let field = of.and_then(|of| self.to.name(&name.text, name.span, |id| Written::Member(of, id), Access::Write));
                    self.initializer(value, field);
                }
            }
        }
    }

    /// The type of a definition.
    fn typed(&mut self, index: u32, data_type: &TypeSpec) {
        let text = self.to.text().get(data_type.span.start as usize..data_type.span.end as usize).unwrap_or_default();
        let shown = match &data_type.kind {
            TypeKind::Struct { .. } => "STRUCT".to_owned(),
            TypeKind::Union(_) => "UNION".to_owned(),
            _ => text.split_whitespace().collect::<Vec<_>>().join(" "),
        };
        self.to.definition(index).data_type = shown;
        let of = self.type_spec(Some(index), data_type);
        self.to.definition(index).of = of;
    }

    /// Where the members of a type are; those that it declares itself belong to the definition.
    fn type_spec(&mut self, index: Option<u32>, data_type: &TypeSpec) -> TypeRef {
        match &data_type.kind {
            TypeKind::Named(path) => {
                let Some(name) = path.names.last() else { return TypeRef::None };
                if name.quoting == Quoting::Bare && DataType::from_word(&name.text.to_ascii_uppercase()).is_some() {
                    return TypeRef::None;
                }
                self.type_path(path, Access::Type);
                match numbered(name) {
                    Some(Address::Block(block)) => TypeRef::Block(block),
                    _ => TypeRef::Named(self.to.id(&name.text)),
                }
            }
            TypeKind::String { length, .. } => {
                length.iter().for_each(|length| _ = self.expression(length, Access::Read));
                TypeRef::None
            }
            TypeKind::Array { dimensions, element } => {
                for dimension in dimensions {
                    if let super::ast::Dimension::Bounds(bounds) = dimension {
                        self.expression(&bounds.0, Access::Read);
                        self.expression(&bounds.1, Access::Read);
                    }
                }
                self.type_spec(index, element)
            }
            TypeKind::Struct { fields, .. } | TypeKind::Union(fields) => {
                let parent = std::mem::replace(&mut self.to.parent, index);
                fields.iter().for_each(|field| self.declaration(field, DefinitionKind::Field));
                self.to.parent = parent;
                TypeRef::Inline
            }
            TypeKind::Subrange { base, low, high } => {
                self.expression(low, Access::Read);
                self.expression(high, Access::Read);
                _ = self.elementary_or(base);
                TypeRef::None
            }
            TypeKind::Enumeration { base, values } => {
                if let Some(base) = base {
                    _ = self.elementary_or(base);
                }
                let parent = std::mem::replace(&mut self.to.parent, index);
                for (name, value) in values {
                    self.to.define(DefinitionKind::EnumValue, &name.text, name.span, name.span);
                    value.iter().for_each(|value| _ = self.expression(value, Access::Read));
                }
                self.to.parent = parent;
                TypeRef::Inline
            }
            TypeKind::Constructed { block, arguments, elements } => {
                let callee = self.type_path(block, Access::Type);
                self.arguments(callee, arguments);
                elements.iter().for_each(|arguments| self.arguments(callee, arguments));
                block.names.last().map_or(TypeRef::None, |name| TypeRef::Named(self.to.id(&name.text)))
            }
            TypeKind::Reference(inner) | TypeKind::Pointer(inner) | TypeKind::Alias(inner) => self.type_spec(index, inner),
            TypeKind::Inferred | TypeKind::Missing => TypeRef::None,
        }
    }

    fn elementary_or(&mut self, path: &Path) -> Option<u32> {
        let name = path.names.last()?;
        let is_elementary = DataType::from_word(&name.text.to_ascii_uppercase()).is_some();
        if is_elementary { None } else { self.type_path(path, Access::Type) }
    }

    /// The name of a type, a block or a namespace, with what it is qualified by.
    fn type_path(&mut self, path: &Path, access: Access) -> Option<u32> {
        let (last, qualifiers) = path.names.split_last()?;
        for name in qualifiers {
            self.to.name(&name.text, name.span, Written::Global, Access::Path);
        }
        match numbered(last) {
            Some(operand) => self.to.operand(operand, last.span, access),
            None => self.to.name(&last.text, last.span, Written::Global, access),
        }
    }
}

fn bytes(span: Span) -> Bytes {
    Bytes { start: span.start, end: span.end.max(span.start) }
}
