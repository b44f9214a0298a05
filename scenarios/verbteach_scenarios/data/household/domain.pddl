; A household as a robot with two hands finds it.
;
; Substances are values, not things: a vessel has water, there is no water to
; grasp. Heat and cold belong to things and to substances alike: a substance is
; hot once some of it in the room has been heated. A hot vessel has something
; hot in it, and a drink poured from it makes the next one hot.
;
; The robot handles what it is near to. It is near what it last went to, what it
; holds, and what it has just put down.

(define (domain household)

(:requirements :strips :typing :negative-preconditions :equality
               :conditional-effects :universal-preconditions)

(:types
  thing substance channel level - object
  liquid solid - substance

  being fixture item - thing
  robot person - being

  support burner receptacle storage opening device control plant hearth - fixture
  surface seat - support
  bin basket sink - receptacle                ; open at the top
  cupboard drawer fridge machine - storage    ; open and shut
  heater washer - machine                     ; microwaves and ovens; dishwashers and the like
  lamp screen player spout gadget - device    ; a spout is a tap, a dispenser, a coffee machine
  knob button - control

  holder plate utensil food cloth book disc cushion remote lighter candle ware - item
  vessel supply - holder                      ; a supply never runs out
  cup bowl cookware jug - vessel              ; cookware is pots, pans and kettles
  bottle jar squeezer packet - supply
  spoon knife - utensil
  teabag - food)

(:constants
  Robot - robot
  Person - person
  Water Milk Juice Coffee Tea Cola Beer Wine Soup Oil - liquid
  Sugar Salt Flour Rice Cereal Chips IceCream CoffeePowder Honey Syrup Ketchup - solid
  News Sports Movies Music Cartoons - channel
  Silent Quiet Normal Loud - level)

(:predicates
  ; where things are
  (near ?r - robot ?x - thing)
  (grasping ?b - being ?x - item)
  (carrying ?r - robot)                       ; at least one hand is taken
  (hands-full ?r - robot)                     ; both are
  (on ?x - item ?y - thing)
  (in ?x - item ?y - thing)
  (beside ?x - item ?y - fixture)
  (stowed ?x - thing)                         ; in a storage, at whatever depth
  ; how things are
  (open ?x - thing)
  (is-on ?x - thing)
  (lit ?x - thing)
  (has ?x - item ?s - substance)
  (topped ?x - food ?s - substance)
  (mixed ?v - vessel)
  (hot ?o - object)
  (cold ?o - object)
  (dirty ?x - thing)
  (folded ?x - item)
  (sliced ?x - food)
  (watered ?p - plant)
  (channel ?d - screen ?c - channel)
  (volume ?d - device ?l - level)
  ; what never changes
  (openable ?x - thing)
  (switchable ?x - thing)
  (lightable ?x - thing)
  (foldable ?x - item)
  (landmark ?y - fixture)                     ; has room beside it on what it stands on
  (stands-on ?y - fixture ?s - support)
  (contains ?x - holder ?s - substance)
  (dispenses ?t - spout ?s - liquid)
  (feeds ?t - spout ?k - sink)
  (controls ?k - knob ?b - burner)
  (powers ?b - thing ?d - thing)
  (channel-up ?b - button ?d - screen)
  (channel-down ?b - button ?d - screen)
  (volume-up ?b - button ?d - device)
  (volume-down ?b - button ?d - device)
  (next-channel ?c ?n - channel)
  (louder ?l ?m - level))

; ---- going, taking, putting ----

(:action moveto
  :parameters (?x - thing)
  :precondition (not (= ?x Robot))
  :effect (and
    (forall (?y - fixture) (not (near Robot ?y)))
    (forall (?p - person) (not (near Robot ?p)))
    (forall (?i - item) (when (not (grasping Robot ?i)) (not (near Robot ?i))))
    (near Robot ?x)))

(:action grasp
  :parameters (?x - item)
  :precondition (and (near Robot ?x) (not (stowed ?x))
                     (not (grasping Robot ?x)) (not (hands-full Robot)))
  :effect (and
    (grasping Robot ?x) (not (grasping Person ?x))
    (carrying Robot) (when (carrying Robot) (hands-full Robot))
    (forall (?y - fixture) (and (not (on ?x ?y)) (not (in ?x ?y)) (not (beside ?x ?y))))
    (forall (?v - vessel) (not (in ?x ?v)))
    (forall (?p - plate) (not (on ?x ?p)))))

(:action take-out
  :parameters (?x - item ?s - storage)
  :precondition (and (near Robot ?s) (open ?s) (in ?x ?s) (not (hands-full Robot)))
  :effect (and
    (grasping Robot ?x) (near Robot ?x) (not (in ?x ?s)) (not (stowed ?x))
    (carrying Robot) (when (carrying Robot) (hands-full Robot))
    ; a dish brings along what lies in it
    (forall (?v - vessel ?f - food) (when (and (= ?v ?x) (in ?f ?v)) (not (stowed ?f))))
    (forall (?p - plate ?f - food) (when (and (= ?p ?x) (on ?f ?p)) (not (stowed ?f))))))

(:action put-on
  :parameters (?x - item ?y - support)
  :precondition (and (grasping Robot ?x) (near Robot ?y))
  :effect (and
    (on ?x ?y) (not (grasping Robot ?x))
    (not (hands-full Robot)) (when (not (hands-full Robot)) (not (carrying Robot)))))

(:action set-on
  :parameters (?c - cookware ?b - burner)
  :precondition (and (grasping Robot ?c) (near Robot ?b))
  :effect (and
    (on ?c ?b) (not (grasping Robot ?c))
    (not (hands-full Robot)) (when (not (hands-full Robot)) (not (carrying Robot)))
    ; a burning burner heats what is set on it, and what is in that
    (when (is-on ?b) (and (hot ?c) (not (cold ?c))))
    (forall (?f - food)
      (when (and (is-on ?b) (in ?f ?c)) (and (hot ?f) (not (cold ?f)))))
    (forall (?s - substance)
      (when (and (is-on ?b) (has ?c ?s)) (and (hot ?s) (not (cold ?s)))))))

(:action put-in
  :parameters (?x - item ?s - storage)
  :precondition (and (grasping Robot ?x) (near Robot ?s) (open ?s))
  :effect (and
    (in ?x ?s) (stowed ?x) (not (grasping Robot ?x))
    (not (hands-full Robot)) (when (not (hands-full Robot)) (not (carrying Robot)))
    (forall (?v - vessel ?f - food) (when (and (= ?v ?x) (in ?f ?v)) (stowed ?f)))
    (forall (?p - plate ?f - food) (when (and (= ?p ?x) (on ?f ?p)) (stowed ?f)))
    ; a fridge cools what is put into it, and the drink in it
    (forall (?r - fridge) (when (= ?r ?s) (and (cold ?x) (not (hot ?x)))))
    (forall (?r - fridge ?v - vessel ?l - liquid)
      (when (and (= ?r ?s) (= ?v ?x) (has ?v ?l)) (and (cold ?l) (not (hot ?l)))))))

(:action drop-in
  :parameters (?x - item ?y - receptacle)
  :precondition (and (grasping Robot ?x) (near Robot ?y))
  :effect (and
    (in ?x ?y) (not (grasping Robot ?x))
    (not (hands-full Robot)) (when (not (hands-full Robot)) (not (carrying Robot)))
    ; a running tap rinses and fills what is put under it
    (forall (?t - spout ?k - sink)
      (when (and (= ?k ?y) (feeds ?t ?k) (is-on ?t)) (not (dirty ?x))))
    (forall (?t - spout ?k - sink ?v - vessel)
      (when (and (= ?k ?y) (= ?v ?x) (feeds ?t ?k) (is-on ?t)) (has ?v Water)))))

(:action put-near
  :parameters (?x - item ?y - fixture)
  :precondition (and (landmark ?y) (grasping Robot ?x) (near Robot ?y))
  :effect (and
    (beside ?x ?y) (not (grasping Robot ?x))
    (not (hands-full Robot)) (when (not (hands-full Robot)) (not (carrying Robot)))
    (forall (?s - support) (when (stands-on ?y ?s) (on ?x ?s)))))

(:action hand-over
  :parameters (?x - item ?p - person)
  :precondition (and (grasping Robot ?x) (near Robot ?p))
  :effect (and
    (grasping ?p ?x) (not (grasping Robot ?x))
    (not (hands-full Robot)) (when (not (hands-full Robot)) (not (carrying Robot)))))

; ---- doors, lids, covers ----

(:action open
  :parameters (?x - thing)
  :precondition (and (openable ?x) (near Robot ?x) (not (open ?x)) (not (stowed ?x)))
  :effect (and
    (open ?x)
    (forall (?m - machine) (when (= ?m ?x) (not (is-on ?m))))))

(:action close
  :parameters (?x - thing)
  :precondition (and (openable ?x) (near Robot ?x) (open ?x) (not (stowed ?x)))
  :effect (not (open ?x)))

(:action fold
  :parameters (?x - item)
  :precondition (and (foldable ?x) (near Robot ?x) (not (folded ?x)) (not (stowed ?x)))
  :effect (folded ?x))

(:action unfold
  :parameters (?x - item)
  :precondition (and (foldable ?x) (near Robot ?x) (folded ?x) (not (stowed ?x)))
  :effect (not (folded ?x)))

; ---- switches ----

(:action turn-on
  :parameters (?x - thing)
  :precondition (and (switchable ?x) (near Robot ?x) (not (is-on ?x)) (not (stowed ?x)))
  :effect (and
    (is-on ?x)
    (forall (?t - spout ?k - sink ?i - item)
      (when (and (= ?t ?x) (feeds ?t ?k) (in ?i ?k)) (not (dirty ?i))))
    (forall (?t - spout ?k - sink ?v - vessel)
      (when (and (= ?t ?x) (feeds ?t ?k) (in ?v ?k)) (has ?v Water)))))

(:action turn-off
  :parameters (?x - thing)
  :precondition (and (switchable ?x) (near Robot ?x) (is-on ?x) (not (stowed ?x)))
  :effect (not (is-on ?x)))

(:action start
  :parameters (?m - machine)
  :precondition (and (near Robot ?m) (not (open ?m)) (not (is-on ?m)))
  :effect (and
    (is-on ?m)
    (forall (?h - heater ?x - item)
      (when (and (= ?h ?m) (in ?x ?h)) (and (hot ?x) (not (cold ?x)))))
    (forall (?h - heater ?v - vessel ?f - food)
      (when (and (= ?h ?m) (in ?v ?h) (in ?f ?v)) (and (hot ?f) (not (cold ?f)))))
    (forall (?h - heater ?p - plate ?f - food)
      (when (and (= ?h ?m) (in ?p ?h) (on ?f ?p)) (and (hot ?f) (not (cold ?f)))))
    (forall (?h - heater ?v - vessel ?s - substance)
      (when (and (= ?h ?m) (in ?v ?h) (has ?v ?s)) (and (hot ?s) (not (cold ?s)))))
    (forall (?w - washer ?x - item)
      (when (and (= ?w ?m) (in ?x ?w)) (not (dirty ?x))))))

(:action stop
  :parameters (?m - machine)
  :precondition (and (near Robot ?m) (is-on ?m))
  :effect (not (is-on ?m)))

(:action turn
  :parameters (?k - knob)
  :precondition (near Robot ?k)
  :effect (and
    (forall (?b - burner) (when (and (controls ?k ?b) (is-on ?b)) (not (is-on ?b))))
    (forall (?b - burner) (when (and (controls ?k ?b) (not (is-on ?b))) (is-on ?b)))
    (forall (?b - burner ?c - cookware)
      (when (and (controls ?k ?b) (not (is-on ?b)) (on ?c ?b))
            (and (hot ?c) (not (cold ?c)))))
    (forall (?b - burner ?c - cookware ?f - food)
      (when (and (controls ?k ?b) (not (is-on ?b)) (on ?c ?b) (in ?f ?c))
            (and (hot ?f) (not (cold ?f)))))
    (forall (?b - burner ?c - cookware ?s - substance)
      (when (and (controls ?k ?b) (not (is-on ?b)) (on ?c ?b) (has ?c ?s))
            (and (hot ?s) (not (cold ?s)))))))

(:action press
  :parameters (?b - button)
  :precondition (near Robot ?b)
  :effect (and
    (forall (?d - thing) (when (and (powers ?b ?d) (is-on ?d)) (not (is-on ?d))))
    (forall (?d - thing) (when (and (powers ?b ?d) (not (is-on ?d))) (is-on ?d)))
    (forall (?d - screen ?c ?n - channel)
      (when (and (channel-up ?b ?d) (next-channel ?c ?n) (is-on ?d) (channel ?d ?c))
            (and (channel ?d ?n) (not (channel ?d ?c)))))
    (forall (?d - screen ?c ?n - channel)
      (when (and (channel-down ?b ?d) (next-channel ?n ?c) (is-on ?d) (channel ?d ?c))
            (and (channel ?d ?n) (not (channel ?d ?c)))))
    (forall (?d - device ?l ?m - level)
      (when (and (volume-up ?b ?d) (louder ?l ?m) (is-on ?d) (volume ?d ?l))
            (and (volume ?d ?m) (not (volume ?d ?l)))))
    (forall (?d - device ?l ?m - level)
      (when (and (volume-down ?b ?d) (louder ?m ?l) (is-on ?d) (volume ?d ?l))
            (and (volume ?d ?m) (not (volume ?d ?l)))))))

(:action click
  :parameters (?r - remote ?d - device)
  :precondition (and (powers ?r ?d) (grasping Robot ?r))
  :effect (and
    (when (is-on ?d) (not (is-on ?d)))
    (when (not (is-on ?d)) (is-on ?d))))

(:action light
  :parameters (?x - thing ?l - lighter)
  :precondition (and (lightable ?x) (near Robot ?x) (grasping Robot ?l)
                     (not (lit ?x)) (not (stowed ?x)))
  :effect (lit ?x))

(:action extinguish
  :parameters (?x - thing)
  :precondition (and (lightable ?x) (near Robot ?x) (lit ?x))
  :effect (not (lit ?x)))

; ---- food and drink ----

(:action pour
  :parameters (?x - holder ?y - vessel)
  :precondition (and (grasping Robot ?x) (near Robot ?y) (not (stowed ?y)) (not (= ?x ?y)))
  :effect (and
    (forall (?s - substance) (when (contains ?x ?s) (has ?y ?s)))
    (forall (?v - vessel ?s - substance)
      (when (and (= ?v ?x) (has ?v ?s)) (and (has ?y ?s) (not (has ?v ?s)))))
    (forall (?v - vessel ?l - liquid)
      (when (and (= ?v ?x) (hot ?v) (has ?v ?l)) (and (hot ?y) (not (cold ?y)))))
    (not (mixed ?y))))

(:action fill
  :parameters (?v - vessel ?t - spout)
  :precondition (and (grasping Robot ?v) (near Robot ?t) (is-on ?t))
  :effect (and
    (forall (?l - liquid) (when (dispenses ?t ?l) (has ?v ?l)))
    (not (mixed ?v))))

(:action empty
  :parameters (?v - vessel ?y - receptacle)
  :precondition (and (grasping Robot ?v) (near Robot ?y))
  :effect (and
    (forall (?s - substance) (not (has ?v ?s)))
    (forall (?f - food) (when (in ?f ?v) (and (in ?f ?y) (not (in ?f ?v)))))
    (not (mixed ?v))))

(:action add
  :parameters (?f - food ?v - vessel)
  :precondition (and (grasping Robot ?f) (near Robot ?v) (not (stowed ?v)))
  :effect (and
    (in ?f ?v) (not (grasping Robot ?f)) (not (mixed ?v))
    (not (hands-full Robot)) (when (not (hands-full Robot)) (not (carrying Robot)))))

(:action serve
  :parameters (?f - food ?p - plate)
  :precondition (and (grasping Robot ?f) (near Robot ?p) (not (stowed ?p)))
  :effect (and
    (on ?f ?p) (not (grasping Robot ?f))
    (not (hands-full Robot)) (when (not (hands-full Robot)) (not (carrying Robot)))))

(:action scoop
  :parameters (?t - spoon ?x - holder)
  :precondition (and (grasping Robot ?t) (near Robot ?x) (not (stowed ?x)))
  :effect (and
    (forall (?s - substance) (when (contains ?x ?s) (has ?t ?s)))
    (forall (?v - vessel ?s - substance) (when (and (= ?v ?x) (has ?v ?s)) (has ?t ?s)))))

(:action tip
  :parameters (?t - spoon ?v - vessel)
  :precondition (and (grasping Robot ?t) (near Robot ?v) (not (stowed ?v)))
  :effect (and
    (forall (?s - substance) (when (has ?t ?s) (and (has ?v ?s) (not (has ?t ?s)))))
    (not (mixed ?v))))

(:action stir
  :parameters (?v - vessel ?t - spoon)
  :precondition (and (grasping Robot ?t) (near Robot ?v) (not (stowed ?v)))
  :effect (and
    (mixed ?v)
    ; instant coffee and tea are made in a hot cup of water
    (forall (?c - cup)
      (when (and (= ?c ?v) (hot ?c) (has ?c CoffeePowder) (has ?c Water))
            (and (has ?c Coffee) (hot Coffee)
                 (not (has ?c CoffeePowder)) (not (has ?c Water)))))
    (forall (?c - cup ?b - teabag)
      (when (and (= ?c ?v) (hot ?c) (in ?b ?c) (has ?c Water))
            (and (has ?c Tea) (hot Tea) (not (has ?c Water)))))))

(:action squeeze
  :parameters (?b - squeezer ?v - vessel)
  :precondition (and (grasping Robot ?b) (near Robot ?v) (not (stowed ?v)))
  :effect (and
    (forall (?s - substance) (when (contains ?b ?s) (has ?v ?s)))
    (not (mixed ?v))))

(:action drizzle
  :parameters (?b - squeezer ?f - food)
  :precondition (and (grasping Robot ?b) (near Robot ?f) (not (stowed ?f)))
  :effect (forall (?s - substance) (when (contains ?b ?s) (topped ?f ?s))))

(:action cut
  :parameters (?f - food ?k - knife)
  :precondition (and (grasping Robot ?k) (near Robot ?f) (not (stowed ?f)))
  :effect (sliced ?f))

(:action wait
  :parameters ()
  :precondition (and)
  :effect (and
    ; what has come into a pot since it began to heat
    (forall (?b - burner ?c - cookware)
      (when (and (is-on ?b) (on ?c ?b)) (and (hot ?c) (not (cold ?c)))))
    (forall (?b - burner ?c - cookware ?f - food)
      (when (and (is-on ?b) (on ?c ?b) (in ?f ?c)) (and (hot ?f) (not (cold ?f)))))
    (forall (?b - burner ?c - cookware ?s - substance)
      (when (and (is-on ?b) (on ?c ?b) (has ?c ?s)) (and (hot ?s) (not (cold ?s)))))))

; ---- the rest of the house ----

(:action water
  :parameters (?p - plant ?v - vessel)
  :precondition (and (grasping Robot ?v) (near Robot ?p) (has ?v Water))
  :effect (and (watered ?p) (not (has ?v Water))))

(:action wipe
  :parameters (?x - thing ?c - cloth)
  :precondition (and (grasping Robot ?c) (near Robot ?x) (not (stowed ?x)) (not (= ?x ?c)))
  :effect (not (dirty ?x)))

(:action insert
  :parameters (?d - disc ?p - player)
  :precondition (and (grasping Robot ?d) (near Robot ?p))
  :effect (and
    (in ?d ?p) (not (grasping Robot ?d))
    (not (hands-full Robot)) (when (not (hands-full Robot)) (not (carrying Robot)))))

)
