//! The blocks of a row of the table of diagrams.

/// The networks of each block: blocks are divided by `;` with the name of a block after it, networks by `//`.
pub(crate) fn blocks_of(text: &str) -> Vec<(String, Vec<String>)> {
    let mut blocks: Vec<(String, String)> = Vec::new();
    for part in text.split(" ; ") {
        let named = part.split_once(": ").filter(|(name, _)| matches!(*name, "OB1" | "FC1"));
        match (named, blocks.last_mut()) {
            (Some((name, networks)), _) => blocks.push((name.to_owned(), networks.to_owned())),
            (None, Some((_, last))) => *last += &format!(" ; {part}"),
            (None, None) => blocks.push(("OB1".to_owned(), part.to_owned())),
        }
    }
    blocks.into_iter().map(|(name, text)| (name, text.split(" // ").map(str::to_owned).collect())).collect()
}
