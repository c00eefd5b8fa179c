//! Where a name of a block is declared: in the block, in the one that it belongs to, or in one that these extend.

use sieben_model::block::BlockId;

use super::ast;
use super::items::Items;

/// Where a name is declared.
#[derive(Clone, Copy)]
pub(super) struct Declaring<'a> {
    /// The block that declares it.
    pub(super) block: BlockId,
    pub(super) section: &'a ast::VarSection,
    pub(super) declaration: &'a ast::Declaration,
}

impl<'a> Items<'a> {
    /// A block, the one that it is a member of, and what these extend, in the order in which names are looked for.
    pub(super) fn line(&self, block: BlockId) -> Vec<BlockId> {
        let mut line = vec![block];
        let member = self.code.get(&block).and_then(|code| Some((code.space, code.block.member.as_ref()?)));
        line.extend(member.and_then(|(space, member)| self.block_in(space, &member.of.text)));
        while let Some(base) = line.last().and_then(|&last| self.objects.get(last)?.base)
            && !line.contains(&base)
        {
            line.push(base);
        }
        line
    }

    /// The declaration that a name means in a block.
    pub(super) fn declaration_of(&self, block: BlockId, name: &str) -> Option<Declaring<'a>> {
        self.line(block).into_iter().find_map(|block| self.own_declaration(block, name))
    }

    /// The declaration of a name in a block itself.
    pub(super) fn own_declaration(&self, block: BlockId, name: &str) -> Option<Declaring<'a>> {
        let sections = &self.code.get(&block)?.block.sections;
        let mut all = sections.iter().flat_map(|section| section.declarations.iter().map(move |declaration| (section, declaration)));
        let (section, declaration) = all.find(|(_, declaration)| declares(declaration, name))?;
        Some(Declaring { block, section, declaration })
    }
}

/// Whether a declaration has a name among its own.
pub(super) fn declares(declaration: &ast::Declaration, name: &str) -> bool {
    declaration.names.iter().any(|declared| declared.name.is(name))
}
