//! Tests of the hand checks of simple joints.

mod behaviour;
mod fixture;
mod published;
mod reference;
mod second_implementation;
