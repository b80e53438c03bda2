"""Studies: TOML files that state what to pack, calibrate and test, and the pipeline that runs them."""
