"""The Tell Me Dave corpus: reading it, its actions as a domain, its clauses as instances."""
