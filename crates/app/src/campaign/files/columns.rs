//! Rows of scenarios as columns of Arrow: the ledger and the result have the same ones.

use std::collections::HashMap;
use std::sync::Arc;

use arrow_array::builder::{BooleanBuilder, Float64Builder, StringBuilder, StringDictionaryBuilder};
use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int32Type, Int64Type, UInt32Type, UInt64Type};
use arrow_array::{Array, ArrayRef, Float64Array, Int64Array, RecordBatch, UInt32Array, UInt64Array};
use arrow_schema::{ArrowError, DataType, Field, Schema, SchemaRef};
use sieben_campaign::row::{Row, Verdict};
use sieben_campaign::spec::{Parameter, Value};
use sieben_sim::trace::Moment;
use sieben_workspace::campaign::Campaign;

use crate::campaign::said;

/// Columns that every campaign has; those of parameters, faults and measures follow them.
const FIXED: usize = 11;

/// The columns of a campaign.
#[derive(Clone, Debug)]
pub(crate) struct Columns {
    /// What rows call the properties of the file.
    properties: Vec<String>,
    /// The bits of `[exhaustive]`: they are the number of the scenario.
    bits: usize,
    parameters: Vec<DataType>,
    faults: usize,
    measures: usize,
    schema: SchemaRef,
}

/// The type of a column.
fn kind(parameter: &Parameter<'_>) -> DataType {
    let all = |is: fn(&Value) -> bool| parameter.values.is_none_or(|values| values.iter().all(is));
    match () {
        () if all(|value| matches!(value, Value::Number(_))) => DataType::Float64,
        () if all(|value| matches!(value, Value::Boolean(_))) => DataType::Boolean,
        () => DataType::Utf8,
    }
}

fn with_unit(field: Field, unit: Option<&str>) -> Field {
    match unit {
        Some(unit) => field.with_metadata(HashMap::from([("unit".to_owned(), unit.to_owned())])),
        None => field,
    }
}

fn words() -> DataType {
    DataType::Dictionary(Box::new(DataType::Int32), Box::new(DataType::Utf8))
}

pub(super) fn fixed() -> [Field; FIXED] {
    let microseconds = |name, nullable| with_unit(Field::new(name, DataType::Int64, nullable), Some("us"));
    [
        Field::new("scenario", DataType::UInt64, false),
        Field::new("seed", DataType::UInt64, false),
        Field::new("verdict", words(), false),
        Field::new("property", words(), true),
        Field::new("scan", DataType::UInt32, true),
        microseconds("at_us", true),
        Field::new("scans", DataType::UInt32, false),
        microseconds("virtual_us", false),
        Field::new("margin", DataType::Float64, true),
        Field::new("trace_hash", DataType::UInt64, false),
        Field::new("message", DataType::Utf8, true),
    ]
}

impl Columns {
    /// Of a campaign.
    pub(crate) fn of(campaign: &Campaign) -> Self {
        let spec = &campaign.spec;
        let mut fields = fixed().to_vec();
        fields.extend(campaign.bits().map(|name| Field::new(format!("p.{name}"), DataType::Boolean, false)));
        let bits = fields.len() - FIXED;
        let parameters: Vec<DataType> = spec.parameters().map(|parameter| kind(&parameter)).collect();
        fields.extend(
            spec.parameters()
                .zip(&parameters)
                .map(|(parameter, kind)| with_unit(Field::new(format!("p.{}", parameter.name), kind.clone(), false), parameter.unit)),
        );
        fields.extend(spec.faults.iter().map(|row| Field::new(format!("f.{}", row.stream), DataType::Utf8, true)));
        fields.extend(
            spec.measures
                .iter()
                .map(|measure| with_unit(Field::new(format!("m.{}", measure.name), DataType::Float64, true), measure.unit.as_deref())),
        );
        Self {
            properties: spec.properties.iter().map(|property| property.name.clone()).collect(),
            bits,
            parameters,
            faults: spec.faults.len(),
            measures: spec.measures.len(),
            schema: Arc::new(Schema::new(fields)),
        }
    }

    /// Of a file, whose properties are called so; bits are parameters here.
    pub(crate) fn of_schema(schema: &Schema, properties: Vec<String>) -> Option<Self> {
        let (first, rest) = schema.fields().split_at_checked(FIXED)?;
        if first.iter().zip(fixed()).any(|(field, wanted)| **field != wanted) {
            return None;
        }
        let of = |prefix: &str| rest.iter().filter(|field| field.name().starts_with(prefix)).count();
        let (parameters, faults, measures) = (of("p."), of("f."), of("m."));
        let kinds: Vec<DataType> = rest.iter().map(|field| field.data_type().clone()).collect();
        let is_kind = |kind: &DataType| matches!(kind, DataType::Float64 | DataType::Boolean | DataType::Utf8);
        let fits = parameters + faults + measures == rest.len()
            && kinds[..parameters].iter().all(is_kind)
            && kinds[parameters..parameters + faults].iter().all(|kind| *kind == DataType::Utf8)
            && kinds[parameters + faults..].iter().all(|kind| *kind == DataType::Float64);
        // Metadata of the schema is no part of the columns.
        let schema = Arc::new(Schema::new(schema.fields().clone()));
        fits.then(|| Self { properties, bits: 0, parameters: kinds[..parameters].to_vec(), faults, measures, schema })
    }

    /// The columns as a schema.
    pub(crate) fn schema(&self) -> &SchemaRef {
        &self.schema
    }

    /// What the parameters, faults or measures are called, with their units: their columns begin with `p.`, `f.`, `m.`.
    pub(crate) fn named(&self, prefix: &str) -> Vec<(String, Option<String>)> {
        let of = |field: &Arc<Field>| Some((field.name().strip_prefix(prefix)?.to_owned(), field.metadata().get("unit").cloned()));
        self.schema.fields().iter().skip(FIXED).filter_map(of).collect()
    }

    /// Rows as columns.
    pub(crate) fn batch(&self, rows: &[Row]) -> RecordBatch {
        let numbers = |of: &dyn Fn(&Row) -> u64| -> ArrayRef { Arc::new(UInt64Array::from_iter_values(rows.iter().map(of))) };
        let small = |of: &dyn Fn(&Row) -> Option<u64>| -> ArrayRef {
            Arc::new(rows.iter().map(of).map(|n| n.map(u32_of)).collect::<UInt32Array>())
        };
        let time =
            |of: &dyn Fn(&Row) -> Option<u64>| -> ArrayRef { Arc::new(rows.iter().map(of).map(|n| n.map(i64_of)).collect::<Int64Array>()) };
        let text = |of: &dyn Fn(&Row) -> Option<String>| -> ArrayRef {
            let mut builder = StringBuilder::new();
            rows.iter().for_each(|row| builder.append_option(of(row)));
            Arc::new(builder.finish())
        };
        let mut all = vec![
            numbers(&|row| row.scenario),
            numbers(&|row| row.seed),
            dictionary(rows.iter().map(|row| Some(row.verdict.word()))),
            dictionary(rows.iter().map(|row| self.properties.get(row.property?).map(String::as_str))),
            small(&|row| row.at.map(|at| at.scan)),
            time(&|row| row.at.map(|at| at.time_us)),
            small(&|row| Some(row.scans)),
            time(&|row| Some(row.virtual_us)),
            Arc::new(rows.iter().map(|row| row.margin).collect::<Float64Array>()),
            numbers(&|row| row.trace_hash),
            text(&|row| row.message.clone()),
        ];
        for bit in 0..self.bits {
            let mut builder = BooleanBuilder::with_capacity(rows.len());
            rows.iter().for_each(|row| builder.append_value(row.scenario >> bit & 1 != 0));
            all.push(Arc::new(builder.finish()));
        }
        for (index, kind) in self.parameters.iter().enumerate() {
            let values = rows.iter().map(|row| &row.parameters[index]);
            all.push(match kind {
                DataType::Float64 => {
                    let mut builder = Float64Builder::with_capacity(rows.len());
                    values.for_each(|value| builder.append_option(if let Value::Number(number) = value { Some(*number) } else { None }));
                    Arc::new(builder.finish())
                }
                DataType::Boolean => {
                    let mut builder = BooleanBuilder::with_capacity(rows.len());
                    values.for_each(|value| builder.append_option(if let Value::Boolean(value) = value { Some(*value) } else { None }));
                    Arc::new(builder.finish())
                }
                _ => text(&|row| Some(said::value(&row.parameters[index]))),
            });
        }
        all.extend((0..self.faults).map(|index| text(&|row| row.faults[index].clone())));
        for index in 0..self.measures {
            let mut builder = Float64Builder::with_capacity(rows.len());
            rows.iter().for_each(|row| builder.append_option(row.measures[index]));
            all.push(Arc::new(builder.finish()));
        }
        RecordBatch::try_new(self.schema.clone(), all).expect("every column has its type and all rows")
    }

    /// The rows of columns, but for what only the tally knows.
    pub(crate) fn rows(&self, batch: &RecordBatch) -> Result<Vec<Row>, ArrowError> {
        let wrong = || ArrowError::SchemaError("these are other columns".to_owned());
        if batch.schema().fields() != self.schema.fields() {
            return Err(wrong());
        }
        let column = |index: usize| batch.column(index);
        let strings = |index: usize| batch.column(index).as_string_opt::<i32>().ok_or_else(wrong);
        let (scenario, seed) = (column(0).as_primitive::<UInt64Type>(), column(1).as_primitive::<UInt64Type>());
        let (scan, at_us) = (column(4).as_primitive::<UInt32Type>(), column(5).as_primitive::<Int64Type>());
        let (scans, virtual_us) = (column(6).as_primitive::<UInt32Type>(), column(7).as_primitive::<Int64Type>());
        let (margin, trace_hash) = (column(8).as_primitive::<Float64Type>(), column(9).as_primitive::<UInt64Type>());
        let message = strings(10)?;
        let parameters = FIXED + self.bits;
        let faults = parameters + self.parameters.len();
        let measures = faults + self.faults;
        let is = |array: &dyn Array, row: usize| !array.is_null(row);
        let row = |row: usize| -> Option<Row> {
            let verdict = word_at(column(2), row)?;
            let property = word_at(column(3), row).and_then(|name| self.properties.iter().position(|property| property == name));
            let parameter = |index: usize| {
                let array = column(parameters + index);
                Some(match &self.parameters[index] {
                    DataType::Float64 => Value::Number(array.as_primitive::<Float64Type>().value(row)),
                    DataType::Boolean => Value::Boolean(array.as_boolean().value(row)),
                    _ => Value::Text(array.as_string_opt::<i32>()?.value(row).to_owned()),
                })
            };
            let fault = |index: usize| {
                let array = column(faults + index).as_string_opt::<i32>()?;
                Some(is(array, row).then(|| array.value(row).to_owned()))
            };
            let measure = |index: usize| {
                let array = column(measures + index).as_primitive::<Float64Type>();
                is(array, row).then(|| array.value(row))
            };
            Some(Row {
                scenario: scenario.value(row),
                seed: seed.value(row),
                verdict: Verdict::ALL.into_iter().find(|known| known.word() == verdict)?,
                property,
                at: is(scan, row).then(|| Moment { scan: scan.value(row).into(), time_us: u64_of(at_us.value(row)) }),
                scans: scans.value(row).into(),
                virtual_us: u64_of(virtual_us.value(row)),
                margin: is(margin, row).then(|| margin.value(row)),
                trace_hash: trace_hash.value(row),
                parameters: (0..self.parameters.len()).map(parameter).collect::<Option<_>>()?,
                faults: (0..self.faults).map(fault).collect::<Option<_>>()?,
                measures: (0..self.measures).map(measure).collect(),
                came: Vec::new(),
                message: is(message, row).then(|| message.value(row).to_owned()),
            })
        };
        (0..batch.num_rows()).map(row).collect::<Option<_>>().ok_or_else(wrong)
    }
}

/// A column of words.
fn dictionary<'w>(words: impl Iterator<Item = Option<&'w str>>) -> ArrayRef {
    let mut builder = StringDictionaryBuilder::<Int32Type>::new();
    words.for_each(|word| builder.append_option(word));
    Arc::new(builder.finish())
}

/// The word of a column of words.
fn word_at(array: &ArrayRef, row: usize) -> Option<&str> {
    let words = array.as_dictionary_opt::<Int32Type>()?;
    let values = words.values().as_string_opt::<i32>()?;
    let key = words.key(row)?;
    (key < values.len()).then(|| values.value(key))
}

// Scans and times of a scenario are far below these limits: a scenario ends before.
fn u32_of(number: u64) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}

fn i64_of(number: u64) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX)
}

fn u64_of(number: i64) -> u64 {
    u64::try_from(number).unwrap_or(0)
}
