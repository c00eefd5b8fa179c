//! The optimizations by their names, and which of them are used.

use std::fmt;
use std::str::FromStr;

macro_rules! passes {
    ($($variant:ident $name:literal [$($file:literal),*] $about:literal)*) => {
        /// An optimization that can be left out.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Pass {
            $(#[doc = $about] $variant,)*
        }

        impl Pass {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// What the command line calls it.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }

            /// What it does, in a sentence.
            pub fn about(self) -> &'static str {
                match self {
                    $(Self::$variant => $about,)*
                }
            }

            /// The files that serve it alone, below `crates/jit/src`.
            pub fn files(self) -> &'static [&'static str] {
                match self {
                    $(Self::$variant => &[$($file),*],)*
                }
            }
        }
    };
}

#[rustfmt::skip] // A table.
passes! {
    AddressReuse "address-reuse" ["translate/address_reuse.rs"] "Fields of one element share its address (common subexpression elimination)."
    BaseRelative "base-relative" ["translate/range_analysis/base_relative.rs"] "Ranges of pointers that are AR2 and something more."
    BooleanSimplification "boolean-simplification" ["translate/loop_optimizer/boolean_simplification.rs"] "Selects between bits become logic."
    BranchOnSuperword "branch-on-superword" ["translate/loop_optimizer/branch_on_superword.rs"] "Where a condition is the same in all lanes a shorter version goes on."
    BitFillIdiom "bit-fill-idiom" ["translate/loop_optimizer/bit_fill_idiom.rs"] "Loops that set or reset bits with a stride write bytes."
    BitCountIdiom "bit-count-idiom" ["translate/loop_optimizer/bit_count_idiom.rs"] "Loops that count bits or combine arrays of them take 56 at a time."
    BitInterleaving "bit-interleaving" ["translate/loop_optimizer/bit_interleaving.rs"] "Eight iterations make one byte of bits."
    BracketPromotion "bracket-promotion" ["translate/bracket_promotion.rs"] "The nesting stack is known statically and stays in registers."
    DivisionByConstants "division-by-constants" ["translate/division_by_constants.rs"] "Divisions by constants are multiplications."
    GatheredBits "gathered-bits" ["translate/loop_optimizer/gathered_bits.rs"] "Rows of bits and computed addresses in four lanes."
    IfConversion "if-conversion" ["translate/if_conversion.rs"] "Short branches become selects."
    Inlining "inlining" ["translate/inlining.rs"] "Small blocks become part of their callers."
    InspectorExecutor "inspector-executor" ["translate/loop_optimizer/inspector_executor.rs"] "All indexes of a loop are checked before it."
    InterleavedAccess "interleaved-access" ["translate/loop_optimizer/interleaved_access.rs"] "Fields of structures in four elements are transposed into vectors."
    LiveRangeSplitting "live-range-splitting" ["translate/live_range_splitting.rs"] "Long functions load the address of the arena again."
    LoadElimination "load-elimination" ["translate/load_elimination.rs"] "What is known at computed addresses is not read again."
    LoadSinking "load-sinking" ["translate/load_sinking.rs"] "Reads move to where they are needed."
    LoopVersioning "loop-versioning" ["translate/loop_optimizer.rs"] "A version of a loop without checks is entered where all of them hold."
    MemoryToRegister "memory-to-register" ["translate/memory_to_register.rs"] "Numbers in local data are values."
    MinMaxReduction "min-max-reduction" ["translate/loop_optimizer/min_max_reduction.rs"] "The least or greatest of all iterations is a reduction."
    ModRef "mod-ref" ["translate/mod_ref.rs", "translate/mod_ref/strings.rs"] "Summaries tell what an inlined block may write."
    ModularAddressing "modular-addressing" ["translate/loop_optimizer/modular_addressing.rs"] "Ring buffers in instances stay apart from other variables."
    OrderedReduction "ordered-reduction" ["translate/loop_optimizer/ordered_reduction.rs"] "Vectorized loops do a few operations in order."
    PredictiveCommoning "predictive-commoning" ["translate/loop_optimizer/predictive_commoning.rs"] "What the next iteration reads is handed on to it."
    RangeAnalysis "range-analysis" ["translate/range_analysis.rs", "translate/range_analysis/access.rs", "translate/range_analysis/calls.rs", "translate/range_analysis/interval.rs", "translate/range_analysis/places.rs", "translate/range_analysis/statements.rs", "translate/congruence.rs"] "Ranges of numbers make checks of indexes needless."
    Reassociation "reassociation" ["translate/loop_optimizer/reassociation.rs"] "Sums in several steps are one reduction."
    RegionExit "region-exit" ["translate/region_exits.rs"] "One check of the budget serves a region, which the interpreter does otherwise."
    SafepointCoalescing "safepoint-coalescing" ["translate/safepoint_coalescing.rs"] "One check of the budget serves several blocks."
    ScalarPromotion "scalar-promotion" ["translate/scalar_promotion.rs"] "Variables of a loop stay in registers."
    SlpCalls "slp-calls" ["translate/slp_calls.rs", "translate/loop_optimizer/slp_calls.rs"] "Calls of one block with consecutive instances are vectorized iterations."
    SparseIterations "sparse-iterations" ["translate/loop_optimizer/sparse_iterations.rs"] "Iterations that do nothing are passed over by their bits."
    Specialization "specialization" ["translate/specialization.rs"] "A block is compiled for the instance it is called with."
    StackLifetimes "stack-lifetimes" ["stack_lifetimes.rs"] "Local data that nothing reads any more is not written."
    StringConversion "string-conversion" ["translate/string_conversion.rs"] "Numbers become strings and strings numbers in a register."
    StringLengths "string-lengths" ["translate/string_lengths.rs"] "Lengths of strings stay in registers in loops."
    StructCopies "struct-copies" ["translate/loop_optimizer/structure_copies.rs", "translate/loop_optimizer/structure_fields.rs"] "Loops copy structures."
    SymbolicSummaries "symbolic-summaries" ["translate/symbolic_summaries.rs"] "Summaries hold for any instance."
    Unrolling "unrolling" ["unrolling.rs", "translate/unrolling.rs"] "Loops of few iterations are unrolled."
    Vectorization "vectorization" ["translate/loop_optimizer/vectorization.rs", "translate/loop_optimizer/wide_lanes.rs", "translate/loop_optimizer/masks.rs", "translate/loop_optimizer/vector_division.rs", "translate/loop_optimizer/strided_access.rs"] "Iterations are done in lanes of vectors."
}

/// A set of optimizations.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct PassSet(u128);

impl Default for PassSet {
    /// All of them.
    fn default() -> Self {
        Self(u128::MAX)
    }
}

impl PassSet {
    /// The set without one of them.
    #[must_use]
    pub fn without(self, pass: Pass) -> Self {
        Self(self.0 & !(1 << pass as u32))
    }

    /// The set without any of these.
    #[must_use]
    pub fn without_all<'p>(self, passes: impl IntoIterator<Item = &'p Pass>) -> Self {
        passes.into_iter().fold(self, |left, &pass| left.without(pass))
    }

    /// Whether it has one of them.
    pub fn has(self, pass: Pass) -> bool {
        self.0 & 1 << pass as u32 != 0
    }
}

impl fmt::Debug for PassSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let absent = Pass::ALL.iter().filter(|&&pass| !self.has(pass));
        f.write_str("all")?;
        absent.into_iter().try_for_each(|pass| write!(f, " without {}", pass.name()))
    }
}

impl FromStr for Pass {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let found = Self::ALL.iter().copied().find(|pass| pass.name() == name);
        found.ok_or_else(|| format!("there is no optimization `{name}`: docs/benchmarks/ablation.md lists them"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_optimization_has_a_name_of_its_own_and_files_that_are_there() {
        let names: std::collections::BTreeSet<&str> = Pass::ALL.iter().map(|pass| pass.name()).collect();
        assert_eq!(names.len(), Pass::ALL.len());
        assert!(Pass::ALL.len() <= 128);
        let source = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        for &pass in Pass::ALL {
            assert_eq!(pass.name().parse(), Ok(pass));
            assert!(!PassSet::default().without(pass).has(pass) && PassSet::default().has(pass));
            assert!(!pass.files().is_empty() && pass.files().iter().all(|file| source.join(file).is_file()), "{}", pass.name());
        }
        assert!("faster".parse::<Pass>().is_err());
    }
}
