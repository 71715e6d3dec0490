//! Options for a picture of a mesh: size, view, colours.

/// A field at the nodes of the mesh, shown in bands of colour.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a> {
    /// Name for the legend: `von Mises stress`.
    pub name: &'a str,
    /// Its unit, for the legend; empty for a plain number.
    pub unit: &'a str,
    /// One value per node; NaN where the field is not defined (shown grey, up to the middle of the
    /// triangles there).
    pub values: &'a [f64],
    /// Lowest and highest value of the colours; absent: those of the field. Values outside have the
    /// first or last colour.
    pub range: Option<[f64; 2]>,
    /// Its colours.
    pub colours: Colours,
}

/// The colours of a field.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colours {
    /// From blue over green to red, for a field that has a value everywhere.
    #[default]
    Spectrum,
    /// From grey over yellow to red, for a field that is zero in most places.
    Fire,
    /// From grey over light blue to dark violet, for another such field.
    Violet,
}

/// Magnified displacements.
#[derive(Clone, Copy, Debug)]
pub struct Deformed<'a> {
    /// Displacement of each node of the mesh \[mm\].
    pub displacement: &'a [[f64; 3]],
    /// Magnification.
    pub factor: f64,
    /// What the shape shows, for the line below it: `displacements × 20`.
    pub caption: &'a str,
}

/// A point of the shape with a text beside it.
#[derive(Clone, Copy, Debug)]
pub struct Mark<'a> {
    /// The point \[mm\].
    pub at: [f64; 3],
    /// What stands there: `1.2 %`.
    pub text: &'a str,
}

/// Options for a picture.
#[derive(Clone, Debug)]
pub struct PictureOptions<'a> {
    /// Width \[pixels\], at least 320.
    pub width: usize,
    /// Largest height \[pixels\], at least 240; the picture is lower if the shape is flat.
    pub max_height: usize,
    /// Axes (0 = x, 1 = y, 2 = z) whose normal plane through the origin is a symmetry plane. The
    /// shape is completed by reflection in these planes.
    pub mirror: &'a [usize],
    /// Direction from the shape to the eye; absent: chosen from the shape.
    pub eye: Option<[f64; 3]>,
    /// Bodies to zoom in on. The frame is their extent plus a quarter, and the rest is cut at its
    /// border. Empty: the whole shape.
    pub focus: &'a [&'a str],
    /// Zooms in on the places where the field reaches this value, in the same way.
    pub around: Option<f64>,
    /// Whether the lines of the mesh are drawn.
    pub mesh_lines: bool,
    /// A field instead of body colours.
    pub field: Option<Field<'a>>,
    /// The deformed shape instead of the given one.
    pub deformed: Option<Deformed<'a>>,
    /// Whether the edges of the given shape are drawn behind the deformed one.
    pub ghost: bool,
    /// A marked point of the shape at rest.
    pub mark: Option<Mark<'a>>,
    /// A line below the legend: `limit 5 %`.
    pub note: Option<&'a str>,
}

impl Default for PictureOptions<'_> {
    fn default() -> Self {
        Self {
            width: 1600,
            max_height: 1200,
            mirror: &[],
            eye: None,
            focus: &[],
            around: None,
            mesh_lines: true,
            field: None,
            deformed: None,
            ghost: false,
            mark: None,
            note: None,
        }
    }
}
