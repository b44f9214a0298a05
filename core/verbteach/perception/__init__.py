"""What the robot sees: noise models and beliefs over fluents."""
