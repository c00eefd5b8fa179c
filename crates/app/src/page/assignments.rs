//! The assignment list as JSON.

use sieben_ide::assignment_list::{AssignmentList, BitUse, PartOf};
use sieben_ide::cross_reference::Reference;
use sieben_workspace::places::Places;

/// Which addresses are used.
pub(crate) fn json(places: &Places<'_>, list: &AssignmentList) -> serde_json::Value {
    let references = |references: &[Reference]| -> serde_json::Value {
        references
            .iter()
            .map(|reference| {
                let mut value = places.reference_json(reference);
                value["address"] = reference.target.spell(places.mnemonics).into();
                value
            })
            .collect()
    };
    let areas: serde_json::Value = list
        .areas
        .iter()
        .map(|(area, used)| {
            let bytes: serde_json::Value = used
                .bytes
                .iter()
                .map(|(number, byte)| {
                    let of = |wanted: BitUse| (0..8).filter(|&bit| byte.bits[bit] == wanted).collect::<Vec<_>>();
                    serde_json::json!({ "byte": number, "bits": of(BitUse::Direct), "bits_of_wider_accesses": of(BitUse::Wider),
                        "accessed_as_byte": byte.byte != PartOf::None, "accessed_as_word": byte.word != PartOf::None,
                        "accessed_as_double_word": byte.double_word != PartOf::None, "named_by_pointer": byte.pointer })
                })
                .collect();
            serde_json::json!({ "area": area.prefix(places.mnemonics), "bytes": bytes, "indirect": references(&used.indirect) })
        })
        .collect();
    serde_json::json!({ "areas": areas,
        "timers": list.timers, "timers_indirect": references(&list.timers_indirect),
        "counters": list.counters, "counters_indirect": references(&list.counters_indirect),
        "area_known_at_run_time": references(&list.crossing) })
}
