; A kitchen small enough to search exhaustively, with every construct that is supported.
(define (domain kitchenette)
  (:requirements :strips :typing :negative-preconditions :equality
                 :conditional-effects :universal-preconditions)
  (:types
    thing - object
    item fixture - thing
    cup food - item
    box stove sink - fixture)
  (:constants Sink_1 - sink Tap_1 - fixture)
  (:predicates
    (near ?o - thing)
    (holding ?i - item)
    (busy)
    (on ?i - item ?o - thing)
    (in ?i - item ?b - box)
    (enclosed ?i - item)
    (open ?b - box)
    (hinged ?b - box)
    (burning ?s - stove)
    (running)
    (hot ?i - item)
    (wet ?i - item))

  (:action moveto
    :parameters (?o - thing)
    :precondition (not (near ?o))
    :effect (and (near ?o)
                 (forall (?x - thing)
                   (when (and (near ?x) (not (= ?x ?o))) (not (near ?x))))))

  (:action grasp
    :parameters (?i - item)
    :precondition (and (near ?i) (not (busy)) (not (enclosed ?i)))
    :effect (and (holding ?i) (busy)
                 (forall (?o - thing) (when (on ?i ?o) (not (on ?i ?o))))
                 (forall (?b - box) (when (in ?i ?b) (not (in ?i ?b))))))

  (:action puton
    :parameters (?i - item ?o - thing)
    :precondition (and (holding ?i) (near ?o) (not (= ?i ?o)))
    :effect (and (not (holding ?i)) (not (busy)) (on ?i ?o)
                 (forall (?s - stove)
                   (when (and (= ?s ?o) (burning ?s)) (and (hot ?i) (not (wet ?i)))))
                 (when (and (= ?o Sink_1) (running)) (and (wet ?i) (not (hot ?i))))))

  (:action putin
    :parameters (?i - item ?b - box)
    :precondition (and (holding ?i) (near ?b) (open ?b))
    :effect (and (not (holding ?i)) (not (busy)) (in ?i ?b)))

  (:action open
    :parameters (?b - box)
    :precondition (and (near ?b) (hinged ?b) (not (open ?b)))
    :effect (and (open ?b)
                 (forall (?i - item) (when (in ?i ?b) (not (enclosed ?i))))))

  (:action close
    :parameters (?b - box)
    :precondition (and (near ?b) (hinged ?b) (open ?b))
    :effect (and (not (open ?b))
                 (forall (?i - item) (when (in ?i ?b) (enclosed ?i)))))

  (:action light
    :parameters (?s - stove)
    :precondition (near ?s)
    :effect (and (when (burning ?s) (not (burning ?s)))
                 (when (not (burning ?s)) (burning ?s))
                 (forall (?i - item)
                   (when (and (on ?i ?s) (not (burning ?s))) (and (hot ?i) (not (wet ?i)))))))

  (:action turn
    :parameters ()
    :precondition (near Tap_1)
    :effect (and (when (running) (not (running)))
                 (when (not (running)) (running))
                 (forall (?i - item)
                   (when (and (on ?i Sink_1) (not (running))) (and (wet ?i) (not (hot ?i))))))))
