"""The paper's experiments: which runs there are, their rows, and the tables beside the paper's."""
