"""Contacts of elements with each other and with walls."""
