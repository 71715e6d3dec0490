//! Pictures of a result.

use bracket_base::words::Text;
use serde::{Deserialize, Serialize};

/// A picture of the result folder.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PictureRef {
    /// File name, relative to the folder.
    pub file: String,
    /// Caption.
    pub caption: Text,
    /// Texts of the drawing, so that their data are kept beside the file.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub texts: Vec<Text>,
}
