"""What fracture leaves: pieces. Arrays in, arrays out."""
