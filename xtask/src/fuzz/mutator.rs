//! Makes inputs: a seed of the corpus, changed a few times. Input `n` depends only on seed, corpus and `n`.

use std::fs;

use super::targets::Target;
use crate::markdown;
use crate::workspace;

/// Longer inputs only make a run slower.
pub const INPUT_BYTES_MAX: usize = 16 << 10;
/// How many changes one input gets at most.
const CHANGES_MAX: u64 = 8;
/// Bytes that stand at the edge of something.
const EDGE_BYTES: &[u8] = &[
    0, 1, b'\n', b'\r', b'\t', b' ', b'"', b'\'', b'#', b'(', b')', b'0', b'9', b':', b';', b'[', b'{', 0x7F, 0x80, 0xBF, 0xC3, 0xEF, 0xFE,
    0xFF,
];
/// Numbers that stand at the edge of a range.
const EDGE_NUMBERS: &[&str] = &[
    "0",
    "-1",
    "7",
    "8",
    "255",
    "256",
    "32767",
    "32768",
    "-32769",
    "65535",
    "65536",
    "2147483648",
    "4294967296",
    "99999999999999999999",
    "1e39",
];

/// Makes the inputs of one run.
pub struct Mutator {
    corpus: Vec<Vec<u8>>,
    words: Vec<&'static str>,
    seed: u64,
}

impl Mutator {
    /// Loads the corpus of a target: its folder, and the fences of the pages that it names.
    pub fn new(target: &Target, seed: u64) -> Self {
        let root = workspace::root();
        let mut corpus = vec![Vec::new()];
        let mut files: Vec<_> =
            fs::read_dir(root.join("fuzz-corpus").join(target.corpus)).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
        files.sort();
        corpus.extend(files.iter().filter_map(|file| fs::read(file).ok()));
        if !target.fences.is_empty() {
            let mut pages: Vec<_> = workspace::text_files(&root.join("spec"));
            pages.retain(|page| page.path.ends_with(".md"));
            let fences = pages.iter().flat_map(|page| markdown::read(&page.text).fences);
            corpus.extend(
                fences
                    .filter(|fence| target.fences.iter().any(|language| fence.language == *language))
                    .map(|fence| fence.text.into_bytes()),
            );
        }
        corpus.iter_mut().for_each(|input| input.truncate(INPUT_BYTES_MAX));
        Self { corpus, words: (target.words)(), seed }
    }

    /// How many first inputs there are, the empty one included.
    pub fn corpus_size(&self) -> usize {
        self.corpus.len()
    }

    /// Input `number`. The first ones are the corpus itself.
    pub fn input(&self, number: u64) -> Vec<u8> {
        if let Some(whole) = usize::try_from(number).ok().and_then(|number| self.corpus.get(number)) {
            return whole.clone();
        }
        let mut random = Random(self.seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ number.wrapping_mul(0xD1B5_4A32_D192_ED03));
        let mut input = random.pick(&self.corpus).clone();
        for _ in 0..=random.below(CHANGES_MAX) {
            self.change(&mut input, &mut random);
        }
        input.truncate(INPUT_BYTES_MAX);
        input
    }

    fn change(&self, input: &mut Vec<u8>, random: &mut Random) {
        let at = random.below(input.len() as u64 + 1) as usize;
        let length = (random.below(16) as usize + 1).min(input.len() - at);
        match random.below(12) {
            0 if at < input.len() => input[at] ^= 1 << random.below(8),
            1 if at < input.len() => input[at] = random.next() as u8,
            2 => insert(input, at, &[*random.pick(EDGE_BYTES)]),
            3 => drop(input.drain(at..at + length)),
            4 => input.truncate(at),
            5 | 6 if !self.words.is_empty() => insert(input, at, format!(" {} ", random.pick(&self.words)).as_bytes()),
            7 => replace_number(input, at, random.pick::<&'static str>(EDGE_NUMBERS)),
            8 => {
                // A piece of the input again, many times: brackets, nesting, long words.
                let piece = input[at..at + length].to_vec();
                let times = 1 << random.below(9);
                insert(input, at, &piece.repeat(times));
            }
            9 => {
                // The head of this one with the tail of another.
                let other = random.pick(&self.corpus);
                let cut = random.below(other.len() as u64 + 1) as usize;
                input.truncate(at);
                input.extend_from_slice(&other[cut..]);
            }
            10 => swap_lines(input, random),
            _ => {
                // A line of another one.
                let other = random.pick(&self.corpus);
                let lines: Vec<&[u8]> = other.split_inclusive(|byte| *byte == b'\n').collect();
                if !lines.is_empty() {
                    let start = line_start(input, at);
                    let line: &[u8] = lines[random.below(lines.len() as u64) as usize];
                    insert(input, start, line);
                }
            }
        }
    }
}

fn insert(input: &mut Vec<u8>, at: usize, bytes: &[u8]) {
    input.splice(at..at, bytes.iter().copied());
    input.truncate(INPUT_BYTES_MAX);
}

fn line_start(input: &[u8], at: usize) -> usize {
    input[..at].iter().rposition(|byte| *byte == b'\n').map_or(0, |index| index + 1)
}

/// Replaces the next run of digits.
fn replace_number(input: &mut Vec<u8>, at: usize, number: &str) {
    let Some(start) = input[at..].iter().position(u8::is_ascii_digit).map(|offset| at + offset) else { return };
    let end = input[start..].iter().position(|byte| !byte.is_ascii_digit()).map_or(input.len(), |offset| start + offset);
    input.splice(start..end, number.bytes());
}

fn swap_lines(input: &mut Vec<u8>, random: &mut Random) {
    let mut lines: Vec<Vec<u8>> = input.split_inclusive(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
    if lines.len() < 2 {
        return;
    }
    let (a, b) = (random.below(lines.len() as u64) as usize, random.below(lines.len() as u64) as usize);
    lines.swap(a, b);
    *input = lines.concat();
}

/// SplitMix64: small, and the same on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
    fn below(&mut self, limit: u64) -> u64 {
        self.next() % limit
    }
    fn pick<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len() as u64) as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_input_depends_on_seed_and_number_only() {
        let target = &super::super::TARGETS[0];
        let (a, b, other) = (Mutator::new(target, 1), Mutator::new(target, 1), Mutator::new(target, 2));
        let number = 100_000;
        assert_eq!(a.input(number), b.input(number));
        assert!((number..number + 8).any(|number| a.input(number) != other.input(number)));
        assert!((0..2_000).all(|number| a.input(number).len() <= INPUT_BYTES_MAX));
    }
}
