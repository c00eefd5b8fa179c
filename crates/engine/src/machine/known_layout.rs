//! Which engine has found that a memory is laid out as its code expects.

use std::sync::Arc;

use super::layout::Layout;

/// The engine that has looked last, and the layout at which it looked.
#[derive(Clone, Debug, Default)]
pub struct KnownLayout(Option<(u64, Arc<Layout>)>);

impl KnownLayout {
    /// Whether the engine with this number has found that this layout is its own.
    #[inline]
    pub fn is_known(&self, engine: u64, layout: &Arc<Layout>) -> bool {
        self.0.as_ref().is_some_and(|(known, of)| *known == engine && Arc::ptr_eq(of, layout))
    }

    /// Notes that it has.
    pub fn note(&mut self, engine: u64, layout: &Arc<Layout>) {
        self.0 = Some((engine, Arc::clone(layout)));
    }
}

/// Who has looked at a memory makes no other memory of it.
impl PartialEq for KnownLayout {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use sieben_model::cpu_type::CpuType;

    use super::*;
    use crate::Program;

    #[test]
    fn another_layout_or_engine_has_to_be_looked_at() {
        let [first, second] = [(); 2].map(|()| Arc::new(Layout::new(&CpuType::ALL[0], &Program::default())));
        let mut known = KnownLayout::default();
        assert!(!known.is_known(1, &first));
        known.note(1, &first);
        assert!(known.is_known(1, &first) && !known.is_known(2, &first) && !known.is_known(1, &second));
        known.note(2, &second);
        assert!(known.is_known(2, &second) && !known.is_known(1, &first));
    }
}
