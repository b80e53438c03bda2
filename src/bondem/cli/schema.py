"""`bondem schema`: JSON schema of study files."""

import json

import click

from bondem.study.keys import schema


@click.command("schema")
def command() -> None:
    """Print the JSON schema of study files, for editors that complete and check TOML.

    Save the output as bondem.schema.json and refer to it in the first line of a study: #:schema ./bondem.schema.json
    """
    click.echo(json.dumps(schema(), indent=2))
