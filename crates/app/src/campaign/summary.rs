//! What a campaign came to as JSON: it lies in the result, and everything that is said of a result is made of it.

use serde_json::{Value as Json, json};
use sieben_campaign::ranges::Ranges;
use sieben_campaign::spec::Keep;
use sieben_campaign::tally::Tally;
use sieben_workspace::campaign::Campaign;

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
