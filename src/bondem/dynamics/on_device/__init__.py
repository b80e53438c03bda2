"""Steps on a device: kernel launches that correspond to the passes of a step, called their counterparts."""
