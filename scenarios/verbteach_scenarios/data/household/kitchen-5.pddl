; A baker's kitchen.

(define (problem kitchen-5)
(:domain household)

(:objects
  Counter_1 Counter_2 Board_1 Rack_1 - surface
  Sink_1 - sink
  Tap_1 - spout
  Oven_1 - heater
  Burner_1 Burner_2 Burner_3 - burner
  StoveKnob_1 StoveKnob_2 StoveKnob_3 - knob
  Fridge_1 - fridge
  Cupboard_1 - cupboard
  Drawer_1 - drawer
  Bin_1 - bin
  Fan_1 Radio_1 - gadget
  Window_1 - opening
  VolumeUp_1 VolumeDown_1 - button
  Pot_1 Pot_2 Kettle_1 - cookware
  Bowl_1 Bowl_2 Bowl_3 - bowl
  Jug_1 - jug
  Mug_1 Mug_2 - cup
  Plate_1 Plate_2 - plate
  Spoon_1 Spoon_2 - spoon
  Knife_1 - knife
  Whisk_1 RollingPin_1 - utensil
  Flour_1 Sugar_1 - jar
  Milk_1 Oil_1 - bottle
  Honey_1 Syrup_1 - squeezer
  Butter_1 Egg_1 Egg_2 Dough_1 Cake_1 Muffin_1 - food
  Towel_1 Sponge_1 - cloth)

(:init
  ; what never changes
  (landmark Sink_1) (stands-on Sink_1 Counter_2) (switchable Tap_1)
  (stands-on Tap_1 Counter_2) (feeds Tap_1 Sink_1) (dispenses Tap_1 Water) (openable Oven_1)
  (controls StoveKnob_1 Burner_1) (controls StoveKnob_2 Burner_2)
  (controls StoveKnob_3 Burner_3) (openable Fridge_1) (openable Cupboard_1)
  (openable Drawer_1) (switchable Fan_1) (openable Window_1) (switchable Radio_1)
  (landmark Radio_1) (stands-on Radio_1 Counter_2) (volume-up VolumeUp_1 Radio_1)
  (volume-down VolumeDown_1 Radio_1) (contains Flour_1 Flour) (contains Sugar_1 Sugar)
  (contains Milk_1 Milk) (contains Oil_1 Oil) (contains Honey_1 Honey)
  (contains Syrup_1 Syrup) (foldable Towel_1) (louder Silent Quiet) (louder Quiet Normal)
  (louder Normal Loud)
  ; where things are
  (on Pot_1 Burner_1) (in Pot_2 Cupboard_1) (stowed Pot_2) (on Kettle_1 Burner_3)
  (on Bowl_1 Counter_1) (on Bowl_2 Counter_1) (in Bowl_3 Cupboard_1) (stowed Bowl_3)
  (on Jug_1 Counter_1) (on Mug_1 Counter_2) (in Mug_2 Cupboard_1) (stowed Mug_2)
  (in Plate_1 Cupboard_1) (stowed Plate_1) (in Plate_2 Sink_1) (in Spoon_1 Drawer_1)
  (stowed Spoon_1) (on Spoon_2 Counter_1) (on Knife_1 Board_1) (in Whisk_1 Drawer_1)
  (stowed Whisk_1) (on RollingPin_1 Counter_1) (on Flour_1 Counter_1) (on Sugar_1 Counter_1)
  (in Milk_1 Fridge_1) (stowed Milk_1) (on Oil_1 Counter_2) (in Honey_1 Cupboard_1)
  (stowed Honey_1) (in Syrup_1 Cupboard_1) (stowed Syrup_1) (in Butter_1 Fridge_1)
  (stowed Butter_1) (in Egg_1 Fridge_1) (stowed Egg_1) (in Egg_2 Bowl_2) (in Dough_1 Bowl_1)
  (on Cake_1 Rack_1) (on Muffin_1 Rack_1) (on Towel_1 Counter_2) (in Sponge_1 Sink_1)
  ; how things are
  (dirty Counter_1) (open Fridge_1) (is-on Fan_1) (volume Radio_1 Quiet) (has Mug_1 Tea)
  (dirty Plate_2) (dirty RollingPin_1) (cold Milk_1) (cold Butter_1) (cold Egg_1)
  (folded Towel_1))

(:goal (and))
)
