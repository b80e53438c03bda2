"""What is measured of a specimen for the studies alone."""
