"""Evaluation of fracture in a model or state: implied properties, fragments, cracks and acoustic emission."""
