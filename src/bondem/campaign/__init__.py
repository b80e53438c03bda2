"""Campaigns: many studies over varied parameters on a cluster, with one table of results."""
