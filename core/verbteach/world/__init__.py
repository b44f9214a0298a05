"""Worlds as plain values: fluents, domains, scenes, the grounded task, simulator and planner."""
