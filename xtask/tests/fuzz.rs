//! Every fuzz target survives its corpus and a few hundred mutations, so that an input that once failed stays mended.

use xtask::fuzz::TARGETS;
use xtask::fuzz::mutator::Mutator;

const MUTATIONS: u64 = 300;

#[test]
fn fuzz_targets_survive_their_corpus() {
    for target in TARGETS {
        let mutator = Mutator::new(target, 1);
        for number in 0..mutator.corpus_size() as u64 + MUTATIONS {
            (target.fuzz)(&mutator.input(number));
        }
    }
}

#[test]
fn every_fuzz_target_has_first_inputs() {
    for target in TARGETS {
        assert!(Mutator::new(target, 1).corpus_size() > 1, "{} has no file in fuzz-corpus/{}", target.name, target.corpus);
    }
}
