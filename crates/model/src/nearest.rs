//! The word that a user may have meant.

/// The candidate closest to a word, without regard to case, if it is close enough to be a slip of the fingers.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.to_lowercase();
    let length = word.chars().count();
    let limit = (length / 3).max(1);
    candidates
        .into_iter()
        .map(|candidate| {
            let other = candidate.to_lowercase();
            (strsim::damerau_levenshtein(&word, &other), sorted(&word) != sorted(&other), candidate)
        })
        .filter(|&(distance, ..)| distance <= limit && distance < length)
        // Of words at the same distance the one with the same letters: they were only exchanged.
        .min_by_key(|&(distance, other_letters, _)| (distance, other_letters))
        .map(|(.., candidate)| candidate)
}

/// The letters of a word in one order.
fn sorted(word: &str) -> Vec<char> {
    let mut letters: Vec<char> = word.chars().collect();
    letters.sort_unstable();
    letters
}

/// Words as a sentence part: `a`, `b` or `c`.
pub fn one_of<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let words: Vec<String> = words.into_iter().map(|word| format!("`{word}`")).collect();
    match words.split_last() {
        None => String::new(),
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_close_word_is_suggested() {
        assert_eq!(nearest("soruces", ["sources", "symbols"]), Some("sources"));
        assert_eq!(nearest("CYCLE", ["cycle", "type"]), Some("cycle"));
        assert_eq!(nearest("JBNI", ["JBI", "JNBI"]), Some("JNBI"));
        assert_eq!(nearest("xyz", ["sources", "symbols"]), None);
        assert_eq!(nearest("", ["A"]).or(nearest("€", ["A"])), None);
    }
}
