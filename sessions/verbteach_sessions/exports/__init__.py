"""Sessions in other people's formats: one module a format, all made from one common reading."""
