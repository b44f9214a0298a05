"""How well would another policy have done? Off-policy evaluation of logged choices."""
