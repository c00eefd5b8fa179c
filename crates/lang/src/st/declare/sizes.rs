//! SIZEOF in constant expressions.

use sieben_model::block::BlockId;
use sieben_model::problems::Problem;
use sieben_model::types::{DataType, ReferenceKind};

use super::constants::path_of;
use super::types::Resolver;
use crate::scope::key;
use crate::st::ast::{self, Expression, ExpressionKind, Name};
use crate::st::check::names::Entity;

/// Why something has no size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unsized {
    /// It is neither a type nor a variable.
    Unknown,
    /// Its type is wrong, which is reported where it is declared.
    Reported,
}

impl<'a> Resolver<'_, 'a> {
    /// The bytes of a type or a variable, as SIZEOF counts them.
    pub(super) fn size_of(&mut self, call: &ast::Call) -> Result<i128, Unsized> {
        let [ast::Argument { value: Some(argument), .. }] = call.arguments.as_slice() else { return Err(Unsized::Unknown) };
        let data_type = self.type_of(argument)?;
        Ok(i128::from(data_type.bits_used().div_ceil(8)))
    }

    /// The type that an expression names, or has as a variable or a part of one. A REFERENCE TO is what it refers to.
    fn type_of(&mut self, expression: &Expression) -> Result<DataType, Unsized> {
        let data_type = match &expression.kind {
            ExpressionKind::Parenthesized(inner) => self.type_of(inner)?,
            ExpressionKind::Name(name) | ExpressionKind::Global(name) => match self.type_of_local(name) {
                Some(found) => found?,
                None => self.type_of_global(name)?,
            },
            ExpressionKind::Member(base, name) => self.type_of_member(base, name, expression)?,
            ExpressionKind::Index(base, _) => match self.type_of(base)? {
                DataType::Array { element, .. } => *element,
                DataType::Reference(reference) if reference.kind == ReferenceKind::Pointer => reference.target.clone(),
                _ => return Err(Unsized::Unknown),
            },
            ExpressionKind::Dereference(base) => match self.type_of(base)? {
                DataType::Reference(reference) => reference.target.clone(),
                _ => return Err(Unsized::Unknown),
            },
            _ => return Err(Unsized::Unknown),
        };
        let data_type = match data_type {
            DataType::Reference(reference) if reference.kind == ReferenceKind::Reference => reference.target.clone(),
            other => other,
        };
        self.finished(data_type, expression)
    }

    /// The type of a variable of the block that is declared, of the one that it belongs to, or of one that these extend.
    fn type_of_local(&mut self, name: &Name) -> Option<Result<DataType, Unsized>> {
        let items = self.items;
        let own = self.own.and_then(|own| items.own_declaration(own, &name.text));
        if let Some(found) = own {
            return Some(self.type_of_declaration(found.declaration));
        }
        match self.names.get(&key(&name.text)) {
            Some(Entity::Variable(variable)) if variable.data_type == DataType::Void => return Some(Err(Unsized::Reported)),
            Some(Entity::Variable(variable)) => return Some(Ok(variable.data_type.clone())),
            Some(Entity::Constant(constant)) => return Some(constant.data_type.clone().ok_or(Unsized::Unknown)),
            _ => {}
        }
        let found = items.declaration_of(self.own?, &name.text)?;
        Some(self.type_inside_block(found.block, found.declaration))
    }

    /// The type of a declaration of another block; what is wrong with it is reported there.
    fn type_inside_block(&mut self, block: BlockId, declaration: &ast::Declaration) -> Result<DataType, Unsized> {
        self.types.reuse.depends_on_order();
        if !self.types.enter(declaration.span) {
            return Err(Unsized::Reported);
        }
        let sized = self.sized.clone();
        let found = self.inside(block).ok_or(Unsized::Unknown).and_then(|mut inner| {
            inner.sized = sized;
            inner.type_of_declaration(declaration)
        });
        self.types.leave();
        found
    }

    /// The type of a declaration. What is wrong with it is reported where it is declared, but for what makes it need its own size.
    fn type_of_declaration(&mut self, declaration: &ast::Declaration) -> Result<DataType, Unsized> {
        if self.sized.contains(&declaration.span) {
            let name = declaration.names.first().map_or("", |declared| declared.name.text.as_str());
            self.report(Problem::P3016, declaration.span, format!("the size of `{name}` is defined by itself"));
            return Err(Unsized::Reported);
        }
        self.sized.push(declaration.span);
        // What is looked for is a type of its own, whatever is being declared.
        let kept = (self.open_arrays, self.behind_pointer, self.behind_reference);
        (self.open_arrays, self.behind_pointer, self.behind_reference) = (false, false, false);
        let reported = self.types.diagnostics.len();
        let found = self.data_type(&declaration.data_type);
        let new = self.types.diagnostics.split_off(reported);
        self.types.diagnostics.extend(new.into_iter().filter(|diagnostic| self.sized.contains(&diagnostic.span)));
        (self.open_arrays, self.behind_pointer, self.behind_reference) = kept;
        self.sized.pop();
        found.ok_or(Unsized::Reported)
    }

    /// The type of a global variable, or that of a type by its name.
    fn type_of_global(&mut self, name: &Name) -> Result<DataType, Unsized> {
        let of_list = self.list.map(|list| key(&format!("{list}.{}", name.text)));
        let global = of_list.into_iter().chain([key(&name.text)]).find_map(|name| self.items.globals.get(&name));
        if let Some(&(_, declaration)) = global {
            return self.type_of_declaration(declaration);
        }
        self.type_by_name(name)
    }

    fn type_by_name(&mut self, name: &Name) -> Result<DataType, Unsized> {
        let path = ast::Path { names: vec![name.clone()], span: name.span };
        self.named(&path).map(|named| named.data_type.clone()).ok_or(Unsized::Reported)
    }

    fn type_of_member(&mut self, base: &Expression, name: &Name, whole: &Expression) -> Result<DataType, Unsized> {
        let items = self.items;
        if let Some(path) = path_of(whole)
            && !self.is_local(path.first().copied().unwrap_or_default())
        {
            if let Some(&(_, declaration)) = items.globals.get(&key(&path.join("."))) {
                return self.type_of_declaration(declaration);
            }
            // A variable of a PROGRAM.
            let program = items.block_in(self.space, &path[..path.len() - 1].join("."));
            if let Some(program) = program.filter(|&block| items.programs.iter().any(|program| program.block == block))
                && let Some(found) = items.own_declaration(program, &name.text)
            {
                return match self.own == Some(program) {
                    true => self.type_of_declaration(found.declaration),
                    false => self.type_inside_block(program, found.declaration),
                };
            }
        }
        match self.type_of(base)? {
            DataType::Struct(structure) | DataType::Instance { structure, .. } => {
                structure.field(&name.text).map(|field| field.data_type.clone()).ok_or(Unsized::Unknown)
            }
            _ => Err(Unsized::Unknown),
        }
    }

    /// Whether a name is one of the block that is declared.
    fn is_local(&self, name: &str) -> bool {
        self.names.contains_key(&key(name)) || self.own.is_some_and(|own| self.items.declaration_of(own, name).is_some())
    }

    /// The whole type, where what is pointed to is known by its name alone.
    fn finished(&mut self, data_type: DataType, expression: &Expression) -> Result<DataType, Unsized> {
        match data_type {
            DataType::Instance { block, structure } => {
                let whole = match structure.fields.is_empty() && structure.size == 0 {
                    true => self.types.type_of_block(block, expression.span).ok_or(Unsized::Reported)?,
                    false => DataType::Instance { block, structure },
                };
                let broken = self.types.known.blocks.get(&block).is_some_and(|declared| declared.broken);
                if broken { Err(Unsized::Reported) } else { Ok(whole) }
            }
            DataType::Struct(structure) if structure.fields.is_empty() && structure.size == 0 => {
                let text = structure.name.clone().unwrap_or_default();
                self.type_by_name(&Name { text, span: expression.span, ..Name::default() })
            }
            DataType::Array { bounds, element } => Ok(DataType::Array { bounds, element: Box::new(self.finished(*element, expression)?) }),
            other => Ok(other),
        }
    }
}
