pub(super) mod fixture;
mod properties;
mod published;
mod rules;
mod second;
