//! Patterns of paths: `src/**/*.awl`.

/// A pattern: `*` and `?` stay inside one name, `**` as a whole name stands for any number of folders.
#[derive(Clone, Debug)]
pub(crate) struct Pattern {
    parts: Vec<String>,
}

impl Pattern {
    /// Reads a pattern. Every text is one.
    pub(crate) fn new(text: &str) -> Self {
        let mut parts: Vec<String> = text.split('/').filter(|part| !part.is_empty() && *part != ".").map(str::to_owned).collect();
        // `**/**` means the same as `**` and would only make the search slow.
        parts.dedup_by(|a, b| a == "**" && b == "**");
        Self { parts }
    }

    /// Whether a path with `/` between its names matches.
    pub(crate) fn matches(&self, path: &str) -> bool {
        let names: Vec<&str> = path.split('/').collect();
        wildcard(
            &self.parts,
            &names,
            |part| part == "**",
            |part, name| {
                let (part, name): (Vec<char>, Vec<char>) = (part.chars().collect(), name.chars().collect());
                wildcard(&part, &name, |&c| c == '*', |&wanted, &found| wanted == '?' || wanted == found)
            },
        )
    }
}

/// Matches items one by one; a `many` item of the pattern stands for any number of items.
///
/// Only the last `many` is ever tried again, so that the time is at most the product of both lengths.
fn wildcard<P, T>(pattern: &[P], items: &[T], many: impl Fn(&P) -> bool, one: impl Fn(&P, &T) -> bool) -> bool {
    let (mut p, mut i) = (0, 0);
    let mut retry: Option<(usize, usize)> = None;
    while i < items.len() {
        if p < pattern.len() && many(&pattern[p]) {
            retry = Some((p, i));
            p += 1;
        } else if p < pattern.len() && one(&pattern[p], &items[i]) {
            p += 1;
            i += 1;
        } else if let Some((at, from)) = retry {
            retry = Some((at, from + 1));
            p = at + 1;
            i = from + 1;
        } else {
            return false;
        }
    }
    pattern[p..].iter().all(many)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_match_as_people_expect() {
        for (pattern, path, expected) in [
            ("src/**/*.awl", "src/main.awl", true),
            ("src/**/*.awl", "src/a/b/main.awl", true),
            ("src/**/*.awl", "main.awl", false),
            ("src/*.awl", "src/a/main.awl", false),
            ("*.awl", "main.awl", true),
            ("./main.awl", "main.awl", true),
            ("**", "a/b/c", true),
            ("**/x/**/y", "a/x/b/x/c/y", true),
            ("ma?n.awl", "main.awl", true),
            ("ma?n.awl", "man.awl", false),
            ("*a*b*c*", "xxaxxbxxc", true),
            ("symbols.csv", "symbols.csv", true),
        ] {
            assert_eq!(Pattern::new(pattern).matches(path), expected, "{pattern} {path}");
        }
    }

    #[test]
    fn a_nasty_pattern_is_answered_at_once() {
        let pattern = Pattern::new(&"*a".repeat(500));
        assert!(!pattern.matches(&"a".repeat(5_000).replace("aaaaa", "aaaab")));
    }
}
