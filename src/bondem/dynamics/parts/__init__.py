"""Parts of a step: one module per subject, each with the passes that it adds to the stages of a step."""
