"""PDDL files read into the core's values; the only place that knows PDDL's grammar.

What is read: typing, negative preconditions, equality, conditional effects and
universal quantification in effects. Everything else is refused by name and line.
"""

from verbteach_scenarios.errors import DomainFileError, SceneFileError, WorldFileError
from verbteach_scenarios.pddl.domain_file import parse_domain, read_domain
from verbteach_scenarios.pddl.problem_file import Problem, parse_problem, read_problem
from verbteach_scenarios.pddl.writing import domain_text, problem_text

__all__ = [
    "DomainFileError",
    "Problem",
    "SceneFileError",
    "WorldFileError",
    "domain_text",
    "parse_domain",
    "parse_problem",
    "problem_text",
    "read_domain",
    "read_problem",
]
