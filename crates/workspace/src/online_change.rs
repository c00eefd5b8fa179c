//! What an online change does and what it cannot keep, for people and programs.

use serde_json::{Value, json};
use sieben_cpu::OnlineChange;
use sieben_cpu::online_change::Loss;

/// Most values that are listed for people; JSON has all.
const LISTED_MAX: usize = 50;

/// `OB 1 changed, FC 5 added`; of very many the first.
pub fn blocks(change: &OnlineChange) -> String {
    let mut blocks: Vec<String> = change.blocks.iter().take(LISTED_MAX).map(|(id, what)| format!("{id} {}", what.word())).collect();
    if change.blocks.len() > LISTED_MAX {
        blocks.push(format!("and {} more", change.blocks.len() - LISTED_MAX));
    }
    if blocks.is_empty() { "no block is different".to_owned() } else { blocks.join(", ") }
}

/// What cannot be kept and what stays although the sources say something else, in lines.
pub fn details(change: &OnlineChange) -> String {
    let mut text = String::new();
    if !change.losses.is_empty() {
        text.push_str("What cannot be kept:\n");
    }
    for loss in change.losses.iter().take(LISTED_MAX) {
        text.push_str(&format!("  {loss}\n"));
    }
    if change.losses.len() > LISTED_MAX {
        text.push_str(&format!("  and {} more\n", change.losses.len() - LISTED_MAX));
    }
    if !change.initial_values.is_empty() {
        let mut names = change.initial_names.iter().take(LISTED_MAX).cloned().collect::<Vec<_>>().join(", ");
        if change.initial_names.len() > LISTED_MAX {
            names.push_str(&format!(" and {} more", change.initial_names.len() - LISTED_MAX));
        }
        text.push_str(&format!("New initial values come with a cold restart: {names}.\n"));
    }
    text
}

/// All of it for programs.
pub fn to_json(change: &OnlineChange) -> Value {
    let blocks: Vec<Value> = change.blocks.iter().map(|(id, what)| json!({ "block": id.to_string(), "change": what.word() })).collect();
    let loss = |loss: &Loss| {
        json!({
            "data_block": loss.data_block, "name": loss.name, "old_type": loss.old_type, "new_type": loss.new_type,
            "reason": loss.reason.text(),
        })
    };
    let losses: Vec<Value> = change.losses.iter().map(loss).collect();
    json!({ "blocks": blocks, "losses": losses, "initial_values": change.initial_values, "initial_names": change.initial_names })
}
