"""What is kept on disk: the run file (output and restart in one) and files for ParaView."""
