//! The call structure as JSON.

use sieben_ide::call_structure::{CallStructure, Callee};
use sieben_model::block::BlockId;
use sieben_workspace::places::Places;
use sieben_workspace::project::Build;

/// What people call a block that is called.
pub(crate) fn callee_name(places: &Places<'_>, callee: &Callee) -> String {
    match callee {
        Callee::Block(block) => block.to_string(),
        Callee::Unknown(target) => target.spell(places.mnemonics),
    }
}

/// Who calls whom.
pub(crate) fn json(build: &Build, places: &Places<'_>, structure: &CallStructure) -> serde_json::Value {
    let names = |blocks: &[BlockId]| blocks.iter().map(BlockId::to_string).collect::<Vec<_>>();
    let blocks: serde_json::Map<String, serde_json::Value> = structure
        .blocks
        .iter()
        .map(|(id, caller)| {
            let calls: serde_json::Value = caller
                .calls
                .iter()
                .map(|site| {
                    let calls: serde_json::Value = site
                        .places
                        .iter()
                        .map(|&(network, statement, span)| {
                            serde_json::json!({ "network": network, "statement": statement,
                                "file": places.file(span), "line": places.line(span) })
                        })
                        .collect();
                    let instance = site.instance.as_ref().map(|target| target.spell(places.mnemonics));
                    serde_json::json!({ "block": callee_name(places, &site.callee), "known": matches!(site.callee, Callee::Block(_)),
                        "call": site.kind.word(), "instance": instance, "places": calls })
                })
                .collect();
            let value = serde_json::json!({ "symbol": places.block_symbol(*id), "local_data": caller.local_data,
                "path_local_data": caller.path_local_data, "path_depth": caller.path_depth,
                "recursive": caller.recursive, "library": build.compiled.is_of_library(*id), "calls": calls });
            (id.to_string(), value)
        })
        .collect();
    serde_json::json!({ "cpu": build.cpu.name, "organization_blocks": names(&structure.roots),
        "not_called": names(&structure.not_called), "blocks": blocks })
}
