"""Teachers made from records: exact replay and fitted users; records as logs of a policy."""
