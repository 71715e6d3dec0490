#![no_main]
libfuzzer_sys::fuzz_target!(|data: &[u8]| bracket_fuzz::expression(data));
