//! What a campaign came to as JSON: it lies in the result, and everything that is said of a result is made of it.

use serde_json::{Value as Json, json};
use sieben_campaign::ranges::Ranges;
use sieben_campaign::row::Verdict;
use sieben_campaign::spec::{Keep, PropertyKind};
use sieben_campaign::tally::Tally;
use sieben_workspace::campaign::Campaign;

/// Ranges that are told; of more it is said that there are more.
const SHOWN_MAX: usize = 5;

/// Of a campaign that is called so.
pub(crate) fn of(campaign: &Campaign, name: &str, keep: Keep, tally: &Tally, there: &Ranges) -> Json {
    let spec = &campaign.spec;
    let properties: Vec<Json> = spec
        .properties
        .iter()
        .map(|property| json!({ "kind": property.kind.word(), "name": property.name, "expr": property.expression.text }))
        .collect();
    let measures: Vec<Json> =
        spec.measures.iter().map(|measure| json!({ "name": measure.name, "of": measure.of.word(), "unit": measure.unit })).collect();
    let names = json!({ "name": name, "keep": keep.word(), "properties": properties, "measures": measures });
    merged(&names, tally, there)
}

/// Which scenarios a summary is of.
pub(crate) fn there(summary: &Json) -> Ranges {
    let range = |pair: &Json| Some(pair[0].as_u64()?..pair[1].as_u64()?.checked_add(1)?);
    let mut there = Ranges::default();
    for range in summary["ranges"].as_array().into_iter().flatten().filter_map(range) {
        there.insert(range);
    }
    there
}

/// The scenarios of a campaign that are missing, in one line; nothing if all are there.
pub(crate) fn missing(there: &Ranges, scenarios: u64) -> Option<String> {
    let missing: Vec<_> = there.missing(0..scenarios).collect();
    let shown: Vec<String> = missing.iter().take(SHOWN_MAX).map(|range| format!("{}..{}", range.start, range.end - 1)).collect();
    let more = if missing.len() > shown.len() { ", and more" } else { "" };
    (!shown.is_empty()).then(|| format!("missing: scenarios {}{more}\n", shown.join(", ")))
}

/// Whether all scenarios of a campaign are there, all passed, and what has to come sometimes came.
pub(crate) fn holds(summary: &Json, there: &Ranges, scenarios: u64) -> bool {
    let mut properties = summary["properties"].as_array().into_iter().flatten();
    let never_came = properties.any(|property| property["kind"] == PropertyKind::Sometimes.word() && property["came"] == 0);
    !never_came && summary[Verdict::Pass.word()] == there.count() && missing(there, scenarios).is_none()
}

/// How many ended with each verdict: `58 pass, 2 fail`.
pub(crate) fn counts(summary: &Json) -> String {
    let count = |verdict: Verdict| summary[verdict.word()].as_u64().unwrap_or(0);
    let others = Verdict::ALL[1..].iter().filter(|&&verdict| count(verdict) > 0);
    let others: String = others.map(|&verdict| format!(", {} {}", count(verdict), verdict.word())).collect();
    format!("{} {}{others}", count(Verdict::Pass), Verdict::Pass.word())
}

/// Of another tally with the names of a summary.
pub(crate) fn merged(names: &Json, tally: &Tally, there: &Ranges) -> Json {
    let mut all = tally.to_json();
    for (key, by) in [("properties", ["kind", "name", "expr"]), ("measures", ["name", "of", "unit"])] {
        let both = all[key].as_array().into_iter().flatten().zip(names[key].as_array().into_iter().flatten());
        let named: Vec<Json> = both
            .map(|(of, names)| {
                let mut named: serde_json::Map<String, Json> = by.iter().map(|&key| (key.to_owned(), names[key].clone())).collect();
                named.extend(of.as_object().into_iter().flatten().map(|(key, value)| (key.clone(), value.clone())));
                named.into()
            })
            .collect();
        all[key] = named.into();
    }
    let mut summary = json!({ "name": names["name"], "keep": names["keep"] });
    summary["ranges"] = there.iter().map(|range| json!([range.start, range.end - 1])).collect();
    if let (Some(summary), Some(all)) = (summary.as_object_mut(), all.as_object()) {
        summary.extend(all.clone());
    }
    summary
}
