"""Metrics, protocols and tables of the experiments."""
