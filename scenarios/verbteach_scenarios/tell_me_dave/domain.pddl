; The primitive actions of the Tell Me Dave corpus, as its recorded traces show them.
;
; Fluents and object names are the corpus's own. Affordance marks (IsGraspable ...)
; stand in each document's object list; the relations between parts, appliances and
; values (reached-at ... next) follow from the object names: see fittings.py.
; docs/benchmark.md gives the evidence for each rule.
(define (domain tell-me-dave)
  (:requirements :typing :equality :negative-preconditions :conditional-effects
                 :universal-preconditions)
  (:types
    robot item value - object
    scoopful - item                        ; what a spoon carries, named without a spoon
    channel content mode - value)
  (:constants
    Robot - robot
    Water Coffee Chocolate Vanilla IceCream Ramen Egg Salt - content
    Channel1 Channel2 Channel3 Channel4 Channel5 Channel6 - channel
    TapIsOn StoveFire1 StoveFire2 StoveFire3 StoveFire4 MicrowaveIsOn DoorIsOpen
    LeftDoorIsOpen RightDoorIsOpen WaterDispenserIsOpen IsOpen IsOn Volume
    HasChips ScoopsLeft CD - mode)
  (:predicates
    ; what changes
    (state ?o - item ?v - value)
    (Grasping ?r - robot ?o - item)
    (Near ?a - object ?b - item)
    (In ?a ?b - item)
    (On ?a ?b - item)
    ; affordance marks
    (IsGraspable ?o - item)
    (IsPourable ?o - item)
    (IsPlaceableOn ?o - item)
    (IsPlaceableIn ?o - item)
    (IsPlacable ?o - item)
    (IsScoopable ?o - item)
    (IsAddable ?o - item)
    (IsSqueezeable ?o - item)
    (IsTurnable ?o - item)
    (Turnable ?o - item)
    (Openable ?o - item)
    (Pressable ?o - item)
    ; parts and what they do; ?d is the part (or appliance) that the action names
    (opened-at ?d ?h - item)               ; opened and closed near ?h
    (opened-with ?d ?h - item)             ; opened while holding ?h
    (turned-at ?d ?h - item)
    (pressed-at ?d ?h - item)
    (pressed-with ?d ?h - item)
    (opens ?d ?o - item ?v - value)        ; ?d is a door of ?o: open means (state ?o ?v)
    (door-of ?o - item ?v - value)         ; ?o has a door, open when (state ?o ?v)
    (doorless ?o - item)
    (ends ?d ?o - item ?v - value)         ; opening ?d ends (state ?o ?v)
    (switches ?d ?o - item ?v - value)     ; a toggle of (state ?o ?v)
    (taps ?d ?s - item)                    ; a tap over the sink ?s
    (dispenses ?d - item ?v - value)       ; ?v starting puts water into what is held
    (channel-up ?d ?o - item)
    (channel-down ?d ?o - item)
    (louder ?d ?o - item)
    (softer ?d ?o - item)
    (next ?a ?b - channel)
    ; what goes where
    (ingredient ?x - item ?c - content)    ; ?x put into something shows there as ?c
    (helping ?x - scoopful ?c - content)       ; a scoopful of ?c: (add IceCreamScoop y)
    (hides ?o - item ?c - content)         ; ?c in ?o does not show
    (fits ?x ?y - item))                   ; a disc and its player

  (:action wait :parameters () :precondition () :effect ())

  (:action moveto
    :parameters (?o - item)
    :precondition ()
    :effect (and
      (forall (?x - item) (not (Near ?o ?x)))
      (Near Robot ?o)))

  (:action grasp
    :parameters (?o - item)
    :precondition (and (IsGraspable ?o) (Near Robot ?o))
    :effect (and
      (Grasping Robot ?o)
      (not (Near Robot ?o))
      (forall (?x - item) (when (not (= ?o ?x)) (and
        (not (Near ?o ?x)) (not (Near ?x ?o))
        (not (In ?o ?x)) (not (In ?x ?o))
        (not (On ?o ?x)) (not (On ?x ?o)))))))

  (:action release
    :parameters (?o - item)
    :precondition (and (IsGraspable ?o) (Grasping Robot ?o))
    :effect (not (Grasping Robot ?o)))

  (:action keep-on
    :parameters (?x ?z - item)
    :precondition (and (IsGraspable ?x) (IsPlaceableOn ?z) (not (= ?x ?z))
                       (Grasping Robot ?x) (Near Robot ?z))
    :effect (and
      (not (Grasping Robot ?x))
      (On ?x ?z)
      (forall (?k - item)
        (when (and (taps ?k ?z) (state ?k TapIsOn) (IsPourable ?x)) (state ?x Water)))))

  ; Behind shut doors nothing happens: with two doors, either one will do.
  (:action keep-in
    :parameters (?x ?z - item)
    :precondition (and (IsGraspable ?x) (IsPlaceableIn ?z) (not (= ?x ?z))
                       (Grasping Robot ?x) (Near Robot ?z))
    :effect (and
      (when (doorless ?z) (and (not (Grasping Robot ?x)) (In ?x ?z)))
      (forall (?v - value)
        (when (and (door-of ?z ?v) (state ?z ?v))
          (and (not (Grasping Robot ?x)) (In ?x ?z))))))

  ; As recorded, "Inside" only lets go.
  (:action keep-inside
    :parameters (?x ?z - item)
    :precondition (and (IsGraspable ?x) (IsPlaceableIn ?z) (not (= ?x ?z))
                       (Grasping Robot ?x) (Near Robot ?z))
    :effect (not (Grasping Robot ?x)))

  (:action keep-near
    :parameters (?x ?z - item)
    :precondition (and (IsGraspable ?x) (not (= ?x ?z))
                       (Grasping Robot ?x) (Near Robot ?z))
    :effect (and (not (Grasping Robot ?x)) (Near ?x ?z)))

  (:action open
    :parameters (?d ?h - item)
    :precondition (and (opened-at ?d ?h) (Near Robot ?h))
    :effect (forall (?o - item ?v - value) (and
      (when (opens ?d ?o ?v) (state ?o ?v))
      (when (ends ?d ?o ?v) (not (state ?o ?v))))))

  (:action open-held
    :parameters (?d ?h - item)
    :precondition (and (opened-with ?d ?h) (Grasping Robot ?h))
    :effect (forall (?o - item ?v - value)
      (when (opens ?d ?o ?v) (state ?o ?v))))

  (:action close
    :parameters (?d ?h - item)
    :precondition (and (opened-at ?d ?h) (Near Robot ?h))
    :effect (forall (?o - item ?v - value)
      (when (opens ?d ?o ?v) (not (state ?o ?v)))))

  (:action close-held
    :parameters (?d ?h - item)
    :precondition (and (opened-with ?d ?h) (Grasping Robot ?h))
    :effect (forall (?o - item ?v - value)
      (when (opens ?d ?o ?v) (not (state ?o ?v)))))

  (:action turn
    :parameters (?d ?h - item)
    :precondition (and (turned-at ?d ?h) (Near Robot ?h))
    :effect (and
      (forall (?o - item ?v - value) (and
        (when (and (switches ?d ?o ?v) (state ?o ?v)) (not (state ?o ?v)))
        (when (and (switches ?d ?o ?v) (not (state ?o ?v))) (state ?o ?v))))
      (forall (?s ?x - item)
        (when (and (taps ?d ?s) (not (state ?d TapIsOn)) (On ?x ?s) (IsPourable ?x))
          (state ?x Water)))))

  (:action press
    :parameters (?d ?h - item)
    :precondition (and (pressed-at ?d ?h) (Near Robot ?h))
    :effect (and
      (forall (?o - item ?v - value)
        (when (and (switches ?d ?o ?v) (state ?o ?v)) (not (state ?o ?v))))
      (forall (?o - item ?v - value)
        (when (and (switches ?d ?o ?v) (not (state ?o ?v)) (not (state ?o DoorIsOpen)))
          (state ?o ?v)))
      (forall (?o - item ?a ?b - channel) (and
        (when (and (channel-up ?d ?o) (next ?a ?b) (state ?o IsOn) (state ?o ?a))
          (and (not (state ?o ?a)) (state ?o ?b)))
        (when (and (channel-down ?d ?o) (next ?b ?a) (state ?o IsOn) (state ?o ?a))
          (and (not (state ?o ?a)) (state ?o ?b)))))
      (forall (?o - item) (and
        (when (and (louder ?d ?o) (state ?o IsOn)) (state ?o Volume))
        (when (and (softer ?d ?o) (state ?o IsOn)) (not (state ?o Volume)))))
      (forall (?v - value ?x - item)
        (when (and (dispenses ?d ?v) (not (state ?h ?v)) (Grasping Robot ?x) (IsPourable ?x))
          (state ?x Water)))))

  (:action press-held
    :parameters (?d ?h - item)
    :precondition (and (pressed-with ?d ?h) (Grasping Robot ?h))
    :effect (and
      (forall (?o - item ?v - value)
        (when (and (switches ?d ?o ?v) (state ?o ?v)) (not (state ?o ?v))))
      (forall (?o - item ?v - value)
        (when (and (switches ?d ?o ?v) (not (state ?o ?v)) (not (state ?o DoorIsOpen)))
          (state ?o ?v)))
      (forall (?o - item ?a ?b - channel) (and
        (when (and (channel-up ?d ?o) (next ?a ?b) (state ?o IsOn) (state ?o ?a))
          (and (not (state ?o ?a)) (state ?o ?b)))
        (when (and (channel-down ?d ?o) (next ?b ?a) (state ?o IsOn) (state ?o ?a))
          (and (not (state ?o ?a)) (state ?o ?b)))))
      (forall (?o - item) (and
        (when (and (louder ?d ?o) (state ?o IsOn)) (state ?o Volume))
        (when (and (softer ?d ?o) (state ?o IsOn)) (not (state ?o Volume)))))))

  (:action pour
    :parameters (?x - item)
    :precondition (and (IsPourable ?x) (Grasping Robot ?x))
    :effect (forall (?c - content) (not (state ?x ?c))))

  ; What is poured from keeps its contents.
  (:action pour-into
    :parameters (?x ?y - item)
    :precondition (and (IsPourable ?x) (IsGraspable ?y) (not (= ?x ?y))
                       (Grasping Robot ?x) (Grasping Robot ?y))
    :effect (forall (?c - content)
      (when (and (state ?x ?c) (not (hides ?y ?c))) (state ?y ?c))))

  (:action squeeze
    :parameters (?x ?y - item)
    :precondition (and (IsSqueezeable ?x) (IsGraspable ?y) (not (= ?x ?y))
                       (Grasping Robot ?x) (Grasping Robot ?y))
    :effect (forall (?c - content)
      (when (and (state ?x ?c) (not (hides ?y ?c))) (state ?y ?c))))

  (:action add
    :parameters (?x ?y - item)
    :precondition (and (IsAddable ?x) (IsGraspable ?y) (not (= ?x ?y))
                       (Grasping Robot ?x) (Grasping Robot ?y))
    :effect (and
      (not (Grasping Robot ?x))
      (In ?x ?y)
      (forall (?c - content)
        (when (and (ingredient ?x ?c) (not (hides ?y ?c))) (state ?y ?c)))))

  (:action scoop
    :parameters (?s ?x - item)
    :precondition (and (IsScoopable ?s) (IsGraspable ?x) (not (= ?s ?x))
                       (Grasping Robot ?s) (Grasping Robot ?x) (state ?x ScoopsLeft))
    :effect (state ?s ScoopsLeft))

  ; ?x is the scoopful, which nobody grasps: it is on a spoon in hand.
  (:action add-scoop
    :parameters (?x - scoopful ?y - item)
    :precondition (and (IsGraspable ?y) (Grasping Robot ?y))
    :effect (forall (?s - item) (and
      (when (and (IsScoopable ?s) (Grasping Robot ?s) (state ?s ScoopsLeft))
        (not (state ?s ScoopsLeft)))
      (forall (?c - content)
        (when (and (helping ?x ?c) (not (hides ?y ?c))
                   (IsScoopable ?s) (Grasping Robot ?s) (state ?s ScoopsLeft))
          (state ?y ?c))))))

  (:action insert
    :parameters (?x ?y - item)
    :precondition (and (fits ?x ?y) (Grasping Robot ?x) (Grasping Robot ?y))
    :effect (and
      (not (Grasping Robot ?x))
      (In ?x ?y)
      (state ?y CD)))
)
