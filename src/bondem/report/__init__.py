"""Tables, figures and one HTML page: all plotting lives here."""
