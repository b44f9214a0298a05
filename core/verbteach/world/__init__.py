"""Worlds as plain values: fluents, domains, scenes, the grounded task, the simulator, the planner."""
