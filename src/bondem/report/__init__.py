"""Reports: tables, figures and one HTML page; all plotting code."""
