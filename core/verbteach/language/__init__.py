"""From a command to a verb frame, from an answer to a reading, and from fluents to English."""
