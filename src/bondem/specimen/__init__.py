"""Description of the sample: material, shape, elements, bonds and regions, all frozen."""
