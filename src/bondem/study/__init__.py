"""A study: what to pack, calibrate and test, as a TOML file, and the pipeline that carries it out."""
