//! Reads the `.vtu` files that this program writes.

use crate::result::fields::vtu::{TETRA, VtuError, VtuGrid, nodes_per_cell};

impl VtuGrid {
    /// Reads the bytes of a file that [`VtuGrid::to_bytes`] made.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, VtuError> {
        let form = |why: &str| VtuError::Form(why.into());
        let marker = b"<AppendedData encoding=\"raw\">\n_";
        let start = bytes
            .windows(marker.len())
            .position(|w| w == marker)
            .ok_or_else(|| form("it has no raw appended data"))?
            + marker.len();
        let head =
            std::str::from_utf8(&bytes[..start]).map_err(|_| form("its header is not text"))?;
        if !head.contains("byte_order=\"LittleEndian\"") || !head.contains("header_type=\"UInt64\"")
        {
            return Err(form("it is not little-endian with 64-bit block headers"));
        }
        let data = &bytes[start..];
        let mut grid = VtuGrid::default();
        let (mut section, mut points, mut cells, mut offsets, mut types) =
            (String::new(), None, None, None, None);
        let mut counts = None;
        for tag in head
            .split('<')
            .skip(1)
            .filter_map(|t| t.split_once('>'))
            .map(|(t, _)| t.trim_end_matches('/').trim())
        {
            let word = tag.split_whitespace().next().unwrap_or_default();
            match word {
                "FieldData" | "Points" | "Cells" | "PointData" | "CellData" => {
                    section = word.into()
                }
                "Piece" => {
                    counts = Some((number(tag, "NumberOfPoints")?, number(tag, "NumberOfCells")?));
                }
                "DataArray" => {
                    let name = unescape(
                        attribute(tag, "Name").ok_or_else(|| form("an array has no name"))?,
                    );
                    let kind = attribute(tag, "type").unwrap_or_default();
                    let block = block(data, number(tag, "offset")?, &name)?;
                    match (section.as_str(), kind, name.as_str()) {
                        ("Points", "Float64", _) => points = Some(floats(block, &name)?),
                        ("Cells", "Int64", "connectivity") => cells = Some(words(block, &name)?),
                        ("Cells", "Int64", "offsets") => offsets = Some(words(block, &name)?),
                        ("Cells", "UInt8", "types") => types = Some(block),
                        ("FieldData" | "PointData" | "CellData", "Float64", _) => {
                            let components = match attribute(tag, "NumberOfComponents") {
                                Some(_) => number(tag, "NumberOfComponents")?,
                                None => 1,
                            };
                            let list = match section.as_str() {
                                "FieldData" => &mut grid.field_data,
                                "PointData" => &mut grid.point_data,
                                _ => &mut grid.cell_data,
                            };
                            let values = floats(block, &name)?;
                            list.push((name, components, values));
                        }
                        _ => {
                            return Err(VtuError::Form(format!(
                                "array `{name}` of type `{kind}` is out of place"
                            )));
                        }
                    }
                }
                _ => {}
            }
        }
        let (point_count, cell_count) = counts.ok_or_else(|| form("it has no piece"))?;
        let points = points.ok_or_else(|| form("it has no points"))?;
        let cells = cells.ok_or_else(|| form("it has no connectivity"))?;
        let (offsets, types) =
            offsets.zip(types).ok_or_else(|| form("it has no offsets or types"))?;
        let length = |name: &str, found: usize, wanted: usize| {
            (found == wanted).then_some(()).ok_or(VtuError::Length {
                name: name.into(),
                found,
                wanted,
            })
        };
        length("Points", points.len(), point_count.saturating_mul(3))?;
        length("offsets", offsets.len(), cell_count)?;
        length("types", types.len(), cell_count)?;
        // an empty grid has no cell that states its type: it is read as linear
        grid.cell_type = types.first().copied().unwrap_or(TETRA);
        let per_cell = nodes_per_cell(grid.cell_type)?;
        if types.iter().any(|&t| t != grid.cell_type)
            || offsets.iter().enumerate().any(|(i, &o)| o != ((i + 1) * per_cell) as u64)
        {
            return Err(form("its cells are not all of one type"));
        }
        length("connectivity", cells.len(), cell_count.saturating_mul(per_cell))?;
        grid.points = points.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect();
        grid.cells = cells
            .into_iter()
            .map(|n| {
                u32::try_from(n).map_err(|_| VtuError::Point { found: n, points: point_count })
            })
            .collect::<Result<_, _>>()?;
        grid.check()?;
        Ok(grid)
    }
}

fn unescape(text: &str) -> String {
    text.replace("&quot;", "\"").replace("&gt;", ">").replace("&lt;", "<").replace("&amp;", "&")
}

/// Value of an attribute. The tag is read from the left, because a value may hold what looks like
/// an attribute.
fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let mut rest = tag;
    while let Some((before, after)) = rest.split_once("=\"") {
        let (value, next) = after.split_once('"')?;
        if before.rsplit(char::is_whitespace).next() == Some(name) {
            return Some(value);
        }
        rest = next;
    }
    None
}

fn number(tag: &str, name: &str) -> Result<usize, VtuError> {
    let text =
        attribute(tag, name).ok_or_else(|| VtuError::Form(format!("`{name}` is missing")))?;
    text.parse().map_err(|_| VtuError::Form(format!("`{name}` is `{text}`, not a count")))
}

fn block<'a>(data: &'a [u8], offset: usize, name: &str) -> Result<&'a [u8], VtuError> {
    let truncated = || VtuError::Truncated { name: name.into() };
    let rest = data.get(offset..).ok_or_else(truncated)?;
    let (head, rest) = rest.split_first_chunk::<8>().ok_or_else(truncated)?;
    let length = usize::try_from(u64::from_le_bytes(*head)).map_err(|_| truncated())?;
    rest.get(..length).ok_or_else(truncated)
}

fn words(block: &[u8], name: &str) -> Result<Vec<u64>, VtuError> {
    let (words, rest) = block.as_chunks::<8>();
    if !rest.is_empty() {
        return Err(VtuError::Truncated { name: name.into() });
    }
    Ok(words.iter().map(|w| u64::from_le_bytes(*w)).collect())
}

fn floats(block: &[u8], name: &str) -> Result<Vec<f64>, VtuError> {
    Ok(words(block, name)?.into_iter().map(f64::from_bits).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> VtuGrid {
        VtuGrid {
            points: vec![
                [0.0; 3],
                [1.0, 0.0, 0.0],
                [0.0, 1.0 / 3.0, 0.0],
                [0.1, 0.2, f64::MIN_POSITIVE / 8.0],
            ],
            cells: vec![0, 1, 2, 3],
            cell_type: TETRA,
            point_data: vec![(
                "u <mm> & \"more\"".into(),
                3,
                (0..12).map(|i| f64::from(i).sqrt()).collect(),
            )],
            cell_data: vec![("body".into(), 1, vec![-0.0])],
            field_data: vec![
                ("bound".into(), 1, vec![-334201.713]),
                ("pair".into(), 2, vec![1.0, f64::NAN]),
            ],
        }
    }

    #[test]
    fn comes_back_bit_for_bit() {
        let grid = sample();
        let bytes = grid.to_bytes().expect("writes");
        let back = VtuGrid::from_bytes(&bytes).expect("reads");
        // NaN and −0 compare by bits: the bytes written again are the same
        assert_eq!(back.to_bytes().expect("writes"), bytes);
        assert_eq!(back.points, grid.points);
        assert_eq!(back.point_data[0].0, "u <mm> & \"more\"");
        assert!(back.cell_data[0].2[0].is_sign_negative());
    }

    #[test]
    fn every_cut_and_every_broken_length_is_an_error_not_a_panic() {
        let bytes = sample().to_bytes().expect("writes");
        let data = bytes.windows(2).position(|w| w == b"\n_").expect("has data") + 2;
        let end = bytes.len() - b"\n</AppendedData>\n</VTKFile>\n".len();
        for cut in 0..end {
            assert!(VtuGrid::from_bytes(&bytes[..cut]).is_err(), "cut at {cut}");
        }
        for at in [data, data + 7] {
            let mut broken = bytes.clone();
            broken[at] ^= 0xff;
            assert!(VtuGrid::from_bytes(&broken).is_err(), "length broken at {at}");
        }
    }

    #[test]
    fn wrong_arrays_are_refused() {
        let mut grid = sample();
        grid.point_data[0].2.pop();
        assert!(matches!(grid.to_bytes(), Err(VtuError::Length { found: 11, wanted: 12, .. })));
        let mut grid = sample();
        grid.cells[3] = 4;
        assert!(matches!(grid.to_bytes(), Err(VtuError::Point { found: 4, points: 4 })));
        let mut grid = sample();
        grid.cell_type = 12;
        assert_eq!(grid.to_bytes(), Err(VtuError::CellType(12)));
        let mut grid = sample();
        grid.point_data[0].0 = "u NumberOfComponents=".into();
        let bytes = grid.to_bytes().expect("any name can be written");
        assert_eq!(VtuGrid::from_bytes(&bytes).expect("and read").to_bytes(), Ok(bytes));
        let mut grid = sample();
        grid.field_data[1].0 = "bound".into();
        assert!(matches!(grid.to_bytes(), Err(VtuError::Name(_))));
    }
}
