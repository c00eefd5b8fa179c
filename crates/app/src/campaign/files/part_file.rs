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
        && part.first().is_some() == (part.tally.failures() > 0);
    if fits { Ok(part) } else { Err("its rows are not those of its scenarios".to_owned()) }
}

fn metadata(all: &HashMap<String, String>) -> Option<Json> {
    serde_json::from_str(all.get(KEY)?).ok()
}

/// What tells these bytes from any other: the first 16 hexadecimal digits of their SHA-256.
pub(crate) fn digest(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes)[..8])
}

#[cfg(test)]
mod tests {
    use arrow_schema::{DataType, Field, Schema};
    use proptest::prelude::*;
    use sieben_campaign::row::{Row, Verdict};
    use sieben_campaign::spec::{Keep, Spec, Value};
    use sieben_sim::trace::Moment;

    use super::*;
    use crate::campaign::files::columns::fixed;

    fn columns() -> Columns {
        let mut fields = fixed().to_vec();
        fields.extend([
            Field::new("p.gain", DataType::Float64, false),
            Field::new("p.on", DataType::Boolean, false),
            Field::new("p.mode", DataType::Utf8, false),
            Field::new("f.signal", DataType::Utf8, true),
            Field::new("m.most", DataType::Float64, true),
        ]);
        Columns::of_schema(&Schema::new(fields), vec!["first".to_owned(), "second".to_owned()]).expect("they are columns of a campaign")
    }

    fn part() -> Part {
        let mut part = Part::new(&Spec::default(), 10);
        for scenario in 10..30 {
            let failed = scenario % 3 == 0;
            let row = Row {
                scenario,
                seed: scenario * 77,
                verdict: if failed { Verdict::Fail } else { Verdict::Pass },
                property: failed.then_some(1),
                at: failed.then_some(Moment { scan: 4, time_us: 40_000 }),
                scans: 5,
                virtual_us: 50_000,
                margin: failed.then_some(-0.5),
                trace_hash: scenario,
                parameters: vec![Value::Number(0.1), Value::Boolean(failed), Value::Text("manual".to_owned())],
                faults: vec![failed.then(|| "stuck@1s".to_owned())],
                measures: vec![(!failed).then_some(1.5)],
                came: Vec::new(),
                message: failed.then(|| "too high".to_owned()),
            };
            part.add(row, Keep::All);
        }
        part
    }

    #[test]
    fn a_part_comes_back_from_its_bytes() {
        assert_eq!(decode(&encode(&part(), &columns()), &columns(), Keep::All), Ok(part()));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1_000))]

        #[test]
        fn bytes_that_were_changed_never_end_the_program(changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8), cut: Option<prop::sample::Index>) {
            let mut bytes = encode(&part(), &columns());
            for (at, byte) in changes {
                let at = at.index(bytes.len());
                bytes[at] = byte;
            }
            if let Some(cut) = cut {
                bytes.truncate(cut.index(bytes.len()));
            }
            if let Ok(read) = decode(&bytes, &columns(), Keep::All) {
                prop_assert_eq!((read.range, read.rows.len()), (10..30, 20));
            }
        }
    }
}
