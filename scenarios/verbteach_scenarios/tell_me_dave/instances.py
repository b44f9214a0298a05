"""The corpus's clauses as instances: which clauses count, and how they are grounded.

The files list noun phrases with every object they may mean. The gold object
is the first of those that the demonstration changed, as in She & Chai 2016.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import TypeAlias

from verbteach.verbs.instance import Instance
from verbteach_scenarios.tell_me_dave.clauses import noun_phrases
from verbteach_scenarios.tell_me_dave.cleaning import cleaned
from verbteach_scenarios.tell_me_dave.documents import Clause, Corpus, Document
from verbteach_scenarios.tell_me_dave.rooms import Rooms, whole

Filter: TypeAlias = Callable[[Document, Clause], bool]
"""Whether a clause of a document is an instance."""


@dataclass(frozen=True)
class CorpusInstance:
    """An instance with the document and the clause it was read from."""

    instance: Instance
    document: Document
    clause: Clause

    @property
    def noun_phrases(self) -> tuple[str, ...]:
        """The noun phrases of the clause's frame in lower case, grounded or not."""
        return tuple(phrase.lower() for phrase in noun_phrases(self.clause.frame))


def acted(document: Document, clause: Clause) -> bool:
    """Whether at least one action carries the clause out."""
    return clause.length > 0


def acted_on_phrase(document: Document, clause: Clause) -> bool:
    """Whether the clause has an action and a noun phrase, grounded or not."""
    return clause.length > 0 and bool(noun_phrases(clause.frame))


def acted_on_object(document: Document, clause: Clause) -> bool:
    """Whether the clause has an action and a grounded noun phrase. The default."""
    return clause.length > 0 and bool(clause.mapping)


def changed_something(document: Document, clause: Clause) -> bool:
    """Whether the clause has a grounded noun phrase and changed the state."""
    if not acted_on_object(document, clause):
        return False
    return document.steps[clause.start].state != document.steps[clause.end + 1].state


FILTERS: Mapping[str, Filter] = {
    "acted": acted,
    "acted-on-phrase": acted_on_phrase,
    "acted-on-object": acted_on_object,
    "changed-something": changed_something,
}


def instances(
    corpus: Corpus, chosen: Filter = acted_on_object, rooms: Rooms | None = None
) -> tuple[CorpusInstance, ...]:
    """Return the clauses that pass the filter, in the order of documents and clauses."""
    rooms = rooms or Rooms.of(corpus)
    return tuple(
        CorpusInstance(_instance(document, number, clause, rooms), document, clause)
        for document in corpus.documents
        for number, clause in enumerate(document.clauses)
        if chosen(document, clause)
    )


def _instance(document: Document, number: int, clause: Clause, rooms: Rooms) -> Instance:
    key = rooms.of_document[document.name]
    static = rooms.static(key)
    candidates = tuple(objects for _, objects in clause.mapping)
    instance = Instance(
        id=f"{document.name.zfill(4)}-{number:02d}",
        group=document.name,
        environment=rooms.environments[document.name],
        verb=clause.verb.lower(),
        phrases=tuple(phrase.lower() for phrase, _ in clause.mapping),
        candidates=candidates,
        grounding=tuple(objects[0] for objects in candidates),
        start=whole(document.steps[clause.start].state, static),
        actions=document.actions(clause),
        end=whole(document.steps[clause.end + 1].state, static),
        goal=None,
        task_key=key,
        gold=cleaned(document, clause),
    )
    return replace(instance, grounding=tuple(objects[0] for objects in instance.narrowed))
