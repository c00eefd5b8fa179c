//! A plant as an answer to `plants` has it, made into what its picture is drawn of.

use serde_json::Value;
use sieben_sim::devices::Kind;

use super::plants::PlantLook;

/// Bytes as hex digits.
fn bytes(hex: &Value) -> Vec<u8> {
    let hex = hex.as_str().unwrap_or_default().as_bytes();
    let byte = |pair: &[u8]| std::str::from_utf8(pair).ok().and_then(|pair| u8::from_str_radix(pair, 16).ok()).unwrap_or_default();
    hex.chunks(2).map(byte).collect()
}

/// What a picture is drawn of; `None` for a kind that this Sieben does not know.
pub(super) fn look(plant: &Value) -> Option<PlantLook> {
    let kind = Kind::by_name(plant["kind"].as_str()?)?;
    let byte = |key: &str| plant[key].as_u64().and_then(|byte| u32::try_from(byte).ok()).unwrap_or_default();
    let list = |key: &str| plant[key].as_array().into_iter().flatten();
    let mut parameters: Vec<f64> = list("parameters").filter_map(Value::as_f64).collect();
    let usual = kind.parameters.iter().map(|parameter| parameter.usual);
    parameters.extend(usual.skip(parameters.len()));
    let symbol = |signal: &Value| Some((signal["address"].as_str()?.to_owned(), signal["symbol"].as_str()?.to_owned()));
    let state = |row: &Value| Some((row["name"].as_str()?.to_owned(), row["value"].as_f64()?));
    Some(PlantLook {
        kind,
        name: plant["module"].as_str().unwrap_or_default().to_owned(),
        input: byte("input"),
        output: byte("output"),
        parameters,
        inputs: bytes(&plant["inputs"]),
        outputs: bytes(&plant["outputs"]),
        state: list("state").filter_map(state).collect(),
        faults: list("acting").filter_map(|fault| fault.as_str().map(str::to_owned)).collect(),
        symbols: list("signals").filter_map(symbol).collect(),
    })
}
