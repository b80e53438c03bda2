"""What is read off a model or a state: read, never write."""
