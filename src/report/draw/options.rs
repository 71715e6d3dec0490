//! How a picture of a mesh is made: size, view, colours.

/// A field at the nodes of the mesh, shown in bands of colour.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a> {
    /// Name for the legend: `von Mises stress`.
    pub name: &'a str,
    /// Its unit, for the legend; empty for a plain number.
    pub unit: &'a str,
    /// One value a node; NaN where the field is not defined (shown grey).
    pub values: &'a [f64],
    /// Lowest and highest value of the colours; absent: of the field. Values beyond keep the last
    /// colour.
    pub range: Option<[f64; 2]>,
}

/// Displacements drawn larger than they are.
#[derive(Clone, Copy, Debug)]
pub struct Deformed<'a> {
    /// Displacement of each node of the mesh \[mm\].
    pub displacement: &'a [[f64; 3]],
    /// Times this.
    pub factor: f64,
    /// Whether the factor means anything: velocities of a mechanism have no size.
    pub to_scale: bool,
}

/// How a picture is made.
#[derive(Clone, Debug)]
pub struct PictureOptions<'a> {
    /// Width \[pixels\], at least 320.
    pub width: usize,
    /// Height at most \[pixels\], at least 240; less is used where the shape is flat.
    pub max_height: usize,
    /// Axes (0 = x, 1 = y, 2 = z) whose plane through the origin is a symmetry plane to complete
    /// the shape by.
    pub mirror: &'a [usize],
    /// Direction from the shape to the eye; absent: chosen from the shape.
    pub eye: Option<[f64; 3]>,
    /// Bodies to come close to: the frame is theirs plus a quarter, the rest is cut at its border.
    /// Empty: everything.
    pub focus: &'a [&'a str],
    /// Whether the lines of the mesh are drawn.
    pub mesh_lines: bool,
    /// A field instead of body colours.
    pub field: Option<Field<'a>>,
    /// The deformed shape instead of the given one.
    pub deformed: Option<Deformed<'a>>,
}

impl Default for PictureOptions<'_> {
    fn default() -> Self {
        Self {
            width: 1600,
            max_height: 1200,
            mirror: &[],
            eye: None,
            focus: &[],
            mesh_lines: true,
            field: None,
            deformed: None,
        }
    }
}
