//! Tests of the checks of a cover-plate splice.
