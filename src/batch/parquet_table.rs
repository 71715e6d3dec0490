//! `results.parquet`: the rows of a sweep as a column file, for data frames and databases.

use super::results_table::Kind;
use bracket_base::diag::Diagnostic;
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::Type;
use serde_json::{Map, Value};
use std::sync::Arc;

/// Rows of a group: what a reader takes at once.
const GROUP: usize = 100_000;

/// The column of a kind.
fn field(kind: Kind, name: &str) -> Result<Type, ParquetError> {
    let (physical, logical) = match kind {
        Kind::Number => (Physical::DOUBLE, None),
        Kind::Integer => (Physical::INT64, None),
        Kind::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
    };
    Type::primitive_type_builder(name, physical)
        .with_repetition(Repetition::OPTIONAL)
        .with_logical_type(logical)
        .build()
}

/// The rows as a Parquet file. All rows have the columns of the first; null is an absent value.
pub fn parquet(rows: &[Map<String, Value>]) -> Result<Vec<u8>, Box<Diagnostic>> {
    write(rows).map_err(|e| {
        let message = format!("the table cannot be written as Parquet: {e}");
        Box::new(Diagnostic::environment("sweep/write", message))
    })
}

fn write(rows: &[Map<String, Value>]) -> Result<Vec<u8>, ParquetError> {
    let names: Vec<&String> = rows.first().map(|r| r.keys().collect()).unwrap_or_default();
    let fields = names.iter().map(|n| Ok(Arc::new(field(Kind::of(n), n)?)));
    let fields = fields.collect::<Result<Vec<_>, ParquetError>>()?;
    let schema = Arc::new(Type::group_type_builder("results").with_fields(fields).build()?);
    let properties = Arc::new(WriterProperties::builder().build());
    let mut writer = SerializedFileWriter::new(Vec::new(), schema, properties)?;
    for part in rows.chunks(GROUP) {
        let mut group = writer.next_row_group()?;
        for name in &names {
            let Some(column) = group.next_column()? else { break };
            let values: Vec<&Value> = part.iter().map(|r| &r[*name]).collect();
            write_column(column, Kind::of(name), &values)?;
        }
        group.close()?;
    }
    writer.into_inner()
}

fn write_column(
    mut column: SerializedColumnWriter<'_>,
    kind: Kind,
    values: &[&Value],
) -> Result<(), ParquetError> {
    // levels: 1 where there is a value
    fn some<T>(of: impl Iterator<Item = Option<T>>) -> (Vec<T>, Vec<i16>) {
        let mut levels = Vec::new();
        let all = of.inspect(|v| levels.push(i16::from(v.is_some())));
        (all.flatten().collect(), levels)
    }
    match kind {
        Kind::Number => {
            let (all, levels) = some(values.iter().map(|v| v.as_f64()));
            column.typed::<DoubleType>().write_batch(&all, Some(&levels), None)?;
        }
        Kind::Integer => {
            let (all, levels) = some(values.iter().map(|v| v.as_i64()));
            column.typed::<Int64Type>().write_batch(&all, Some(&levels), None)?;
        }
        Kind::Text => {
            let text = |v: &&Value| v.as_str().map(|s| ByteArray::from(s.as_bytes().to_vec()));
            let (all, levels) = some(values.iter().map(text));
            column.typed::<ByteArrayType>().write_batch(&all, Some(&levels), None)?;
        }
    }
    column.close()
}

#[cfg(test)]
mod tests {
    use super::*;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;
    use serde_json::json;
    use std::io::Write;

    /// Values of each kind, nulls and names of users come back as they were.
    #[test]
    fn rows_come_back() {
        let row = |case: &str, low: Value, bolts: Value, cause: Value| -> Map<String, Value> {
            let values =
                [("case", json!(case)), ("lambda_low", low), ("bolts", bolts), ("cause", cause)];
            values.into_iter().map(|(k, v)| (k.to_string(), v)).collect()
        };
        let rows = [
            row("Träger \"1\"", json!(1.25), json!(6), Value::Null),
            row("b", Value::Null, Value::Null, json!("no mesher")),
        ];
        let mut file = tempfile::tempfile().expect("a file");
        file.write_all(&parquet(&rows).expect("a table")).expect("written");
        let reader = SerializedFileReader::new(file).expect("a reader");
        let read: Vec<Vec<(String, Field)>> = reader
            .get_row_iter(None)
            .expect("rows")
            .map(|r| r.expect("a row").into_columns())
            .collect();
        assert_eq!(read.len(), 2);
        let fields = |i: usize| read[i].iter().map(|(_, f)| f.clone()).collect::<Vec<_>>();
        let text = |t: &str| Field::Str(t.into());
        assert_eq!(
            fields(0),
            [text("Träger \"1\""), Field::Double(1.25), Field::Long(6), Field::Null]
        );
        assert_eq!(fields(1), [text("b"), Field::Null, Field::Null, text("no mesher")]);
    }
}
