"""Speed and memory of this installation: each module measures one thing, for `verbteach bench`.

Everything is measured on the bundled scenes and lessons, with clocks of this
process; nothing here reaches a session that anybody keeps.
"""
