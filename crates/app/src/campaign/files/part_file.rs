//! What came of a range of scenarios as bytes: a file of Arrow IPC whose metadata has what all of them came to.

use std::collections::HashMap;
use std::io::Cursor;

use arrow_array::RecordBatch;
use arrow_ipc::reader::FileReader;
use arrow_ipc::writer::FileWriter;
use arrow_schema::ArrowError;
use serde_json::{Value as Json, json};
use sha2::{Digest, Sha256};
use sieben_campaign::identity::hex;
use sieben_campaign::part::Part;
use sieben_campaign::row::Verdict;
use sieben_campaign::spec::Keep;
use sieben_campaign::tally::Tally;

use super::columns::Columns;
use crate::panics;

/// The key of the metadata.
const KEY: &str = "sieben.part";

/// A part as bytes: the same part has the same ones.
pub(crate) fn encode(part: &Part, columns: &Columns) -> Vec<u8> {
    let written = |bytes: &mut Vec<u8>| -> Result<(), ArrowError> {
        let mut writer = FileWriter::try_new(bytes, columns.schema())?;
        writer.write(&columns.batch(&part.rows))?;
        let metadata = json!({ "from": part.range.start, "to": part.range.end, "tally": part.tally.to_json() });
        writer.write_metadata(KEY, metadata.to_string());
        writer.finish()
    };
    let mut bytes = Vec::new();
    written(&mut bytes).expect("writing to memory does not fail");
    bytes
}

/// The part of bytes that may be anything.
pub(crate) fn decode(bytes: &[u8], columns: &Columns, keep: Keep) -> Result<Part, String> {
    // The library may not have thought of everything that bytes can be.
    panics::survive(|| read(bytes, columns, keep)).map_err(|trouble| trouble.of_bytes())
}

fn read(bytes: &[u8], columns: &Columns, keep: Keep) -> Result<Part, String> {
    let told = |error: ArrowError| error.to_string();
    let reader = FileReader::try_new(Cursor::new(bytes), None).map_err(told)?;
    let metadata = metadata(reader.custom_metadata()).ok_or("it does not say what it is of")?;
    let mut rows = Vec::new();
    for batch in reader {
        let batch: RecordBatch = batch.map_err(told)?;
        rows.extend(columns.rows(&batch).map_err(told)?);
    }
    let part = |metadata: &Json| {
        let range = metadata["from"].as_u64()?..metadata["to"].as_u64()?;
        Some(Part { range, tally: Tally::from_json(&metadata["tally"])?, rows })
    };
    let part = part(&metadata).ok_or("it does not say what it is of")?;
    let fits = part.range.start < part.range.end
        && part.tally.verdicts.iter().try_fold(0_u64, |all, &count| all.checked_add(count)) == Some(part.range.end - part.range.start)
        && part.rows.iter().all(|row| part.range.contains(&row.scenario))
        && (keep == Keep::Failures || part.rows.len() as u64 == part.range.end - part.range.start)
        && part.rows.windows(2).all(|pair| pair[0].scenario < pair[1].scenario)
        && part.first().is_some() == (part.tally.of(Verdict::Pass) != part.tally.run());
    if fits { Ok(part) } else { Err("its rows are not those of its scenarios".to_owned()) }
}

fn metadata(all: &HashMap<String, String>) -> Option<Json> {
    serde_json::from_str(all.get(KEY)?).ok()
}

/// What tells these bytes from any other: the first 16 hexadecimal digits of their SHA-256.
pub(crate) fn digest(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes)[..8])
}
