"""What the sample is: material, shape, elements, bonds and regions, all frozen."""
