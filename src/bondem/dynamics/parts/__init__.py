"""Parts of a step: each module gives the passes of one subject, by the stages of a step."""
