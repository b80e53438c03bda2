"""Steps on a device: the counterparts of the passes that a step is composed of."""
