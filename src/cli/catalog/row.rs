//! A row of the catalogue as text: its fields with their units.

use bracket_base::diag::in_line;
use serde_json::Value;

/// The fields of a row with their units, one per line.
pub fn values(kind: &str, row: &Value) -> String {
    let mut text = String::new();
    for (key, value) in row.as_object().into_iter().flatten().filter(|(key, _)| *key != "source") {
        let shown = match value {
            Value::String(s) => in_line(s),
            Value::Bool(b) => if *b { "yes" } else { "no" }.to_owned(),
            Value::Number(n) => {
                let n = n.as_f64().unwrap_or(f64::NAN);
                // mass and moduli of sections follow from their dimensions
                let n = if kind == "section" { hundredths(n) } else { n.to_string() };
                format!("{n} {}", unit(kind, key)).trim_end().to_owned()
            }
            Value::Array(bands) if bands.is_empty() => "none".to_owned(),
            Value::Array(bands) => bands.iter().map(band).collect::<Vec<_>>().join("; "),
            Value::Object(nested) => dimensions(nested),
            other => other.to_string(),
        };
        text += &format!("  {key}: {shown}\n");
    }
    text
}

/// A number rounded to hundredths.
pub fn hundredths(v: f64) -> String {
    ((100.0 * v).round() / 100.0).to_string()
}

/// The shape of a section with its dimensions: `angle, h 100 mm, b 100 mm, t 10 mm`.
fn dimensions(shape: &serde_json::Map<String, Value>) -> String {
    let all = |(kind, values): (&String, &Value)| {
        let of = |(key, v): (&String, &Value)| match key.as_str() {
            "slope" => format!(", slope of the flange {v}"),
            key => format!(", {key} {} mm", v.as_f64().unwrap_or(f64::NAN)),
        };
        kind.clone() + &values.as_object().into_iter().flatten().map(of).collect::<String>()
    };
    shape.iter().map(all).collect()
}

fn band(b: &Value) -> String {
    format!("t {} to {} mm: fy {} fu {} MPa", b["over"], b["up_to"], b["fy"], b["fu"])
}

/// Unit of a field, as in the doc comments of the catalogue's types.
fn unit(kind: &str, key: &str) -> &'static str {
    match key {
        "area" if matches!(kind, "profile" | "section") => "cm2",
        "h" | "b" | "tw" | "tf" | "r" | "r_detailing" | "d" | "pitch" | "hole_normal"
        | "hole_oversize" | "slot_short" | "slot_long" | "head_width" | "head_corners"
        | "head_height" | "thread_length" | "nut_width" | "nut_height" | "washer_inner"
        | "washer_outer" | "washer_thickness" => "mm",
        "area" | "stress_area" => "mm2",
        "mass" => "kg/m",
        "i_y" | "i_z" | "i_t" => "cm4",
        "w_el_y" | "w_pl_y" | "w_el_z" | "w_pl_z" => "cm3",
        "i_w" => "cm6",
        "fyb" | "fub" | "e" => "MPa",
        "density" => "kg/m3",
        _ => "",
    }
}
