; A student's galley kitchen.

(define (problem kitchen-2)
(:domain household)

(:objects
  Counter_1 Shelf_1 Table_1 - surface
  Sink_1 - sink
  Tap_1 - spout
  Burner_1 - burner
  StoveKnob_1 - knob
  Microwave_1 - heater
  Fridge_1 - fridge
  Cupboard_1 - cupboard
  Drawer_1 - drawer
  Bin_1 Bin_2 - bin
  Window_1 - opening
  Radio_1 - gadget
  VolumeUp_1 VolumeDown_1 - button
  Kettle_1 Pot_1 - cookware
  Mug_1 Mug_2 Mug_3 Glass_1 Glass_2 - cup
  Bowl_1 Bowl_2 - bowl
  Plate_1 Plate_2 - plate
  Spoon_1 - spoon
  Knife_1 - knife
  Fork_1 - utensil
  MilkCarton_1 Cola_1 Beer_1 Beer_2 Salt_1 - bottle
  CoffeeJar_1 SugarJar_1 - jar
  Ketchup_1 - squeezer
  Ramen_1 Ramen_2 PizzaSlice_1 Banana_1 - food
  TeaBag_1 - teabag
  Sponge_1 Towel_1 - cloth
  Chair_1 - seat)

(:init
  ; what never changes
  (landmark Sink_1) (stands-on Sink_1 Counter_1) (switchable Tap_1)
  (stands-on Tap_1 Counter_1) (feeds Tap_1 Sink_1) (dispenses Tap_1 Water)
  (controls StoveKnob_1 Burner_1) (openable Microwave_1) (landmark Microwave_1)
  (stands-on Microwave_1 Shelf_1) (openable Fridge_1) (openable Cupboard_1)
  (openable Drawer_1) (openable Window_1) (switchable Radio_1) (landmark Radio_1)
  (stands-on Radio_1 Shelf_1) (volume-up VolumeUp_1 Radio_1)
  (volume-down VolumeDown_1 Radio_1) (contains MilkCarton_1 Milk) (contains Cola_1 Cola)
  (contains Beer_1 Beer) (contains Beer_2 Beer) (contains CoffeeJar_1 CoffeePowder)
  (contains SugarJar_1 Sugar) (contains Salt_1 Salt) (contains Ketchup_1 Ketchup)
  (foldable Towel_1) (louder Silent Quiet) (louder Quiet Normal) (louder Normal Loud)
  ; where things are
  (on Kettle_1 Burner_1) (in Pot_1 Sink_1) (in Mug_1 Sink_1) (on Mug_2 Table_1)
  (on Mug_3 Shelf_1) (on Glass_1 Table_1) (in Glass_2 Cupboard_1) (stowed Glass_2)
  (in Bowl_1 Cupboard_1) (stowed Bowl_1) (in Bowl_2 Sink_1) (on Plate_1 Counter_1)
  (in Plate_2 Cupboard_1) (stowed Plate_2) (in Spoon_1 Drawer_1) (stowed Spoon_1)
  (on Knife_1 Counter_1) (in Fork_1 Drawer_1) (stowed Fork_1) (in MilkCarton_1 Fridge_1)
  (stowed MilkCarton_1) (in Cola_1 Fridge_1) (stowed Cola_1) (on Beer_1 Table_1)
  (in Beer_2 Fridge_1) (stowed Beer_2) (on CoffeeJar_1 Shelf_1) (on SugarJar_1 Shelf_1)
  (on Salt_1 Shelf_1) (in Ketchup_1 Fridge_1) (stowed Ketchup_1) (on Ramen_1 Shelf_1)
  (in Ramen_2 Cupboard_1) (stowed Ramen_2) (on PizzaSlice_1 Plate_1) (on Banana_1 Table_1)
  (in TeaBag_1 Cupboard_1) (stowed TeaBag_1) (on Sponge_1 Counter_1) (beside Sponge_1 Sink_1)
  (on Towel_1 Table_1)
  ; how things are
  (dirty Counter_1) (open Cupboard_1) (open Window_1) (is-on Radio_1) (volume Radio_1 Normal)
  (dirty Pot_1) (dirty Mug_1) (has Mug_2 Coffee) (dirty Glass_1) (dirty Bowl_2)
  (dirty Plate_1) (dirty Knife_1) (cold MilkCarton_1) (cold Cola_1) (cold Beer_2)
  (cold Ketchup_1) (dirty Towel_1))

(:goal (and))
)
