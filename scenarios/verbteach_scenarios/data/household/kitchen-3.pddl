; A farmhouse kitchen.

(define (problem kitchen-3)
(:domain household)

(:objects
  Table_1 Counter_1 Shelf_1 Shelf_2 - surface
  Sink_1 - sink
  Tap_1 - spout
  Burner_1 Burner_2 - burner
  StoveKnob_1 StoveKnob_2 - knob
  Oven_1 - heater
  Fridge_1 - fridge
  Cupboard_1 - cupboard
  Drawer_1 - drawer
  Bin_1 - bin
  Basket_1 - basket
  BackDoor_1 Window_1 - opening
  Lamp_1 - lamp
  Kettle_1 Pot_1 Pan_1 - cookware
  Jug_1 Jug_2 - jug
  Mug_1 Mug_2 Mug_3 - cup
  Bowl_1 Bowl_2 - bowl
  Plate_1 Plate_2 Plate_3 - plate
  Spoon_1 Ladle_1 - spoon
  Knife_1 - knife
  Honey_1 - squeezer
  Flour_1 - packet
  Salt_1 - jar
  Oil_1 Wine_1 - bottle
  Apple_1 Apple_2 Bread_1 Cheese_1 Egg_1 Egg_2 Potato_1 - food
  Cloth_1 - cloth
  Candle_1 - candle
  Matches_1 - lighter
  Plant_1 - plant
  Bench_1 - seat)

(:init
  ; what never changes
  (landmark Sink_1) (stands-on Sink_1 Counter_1) (switchable Tap_1)
  (stands-on Tap_1 Counter_1) (feeds Tap_1 Sink_1) (dispenses Tap_1 Water)
  (controls StoveKnob_1 Burner_1) (controls StoveKnob_2 Burner_2) (openable Oven_1)
  (openable Fridge_1) (openable Cupboard_1) (openable Drawer_1) (openable BackDoor_1)
  (openable Window_1) (switchable Lamp_1) (landmark Lamp_1) (stands-on Lamp_1 Shelf_1)
  (contains Honey_1 Honey) (openable Flour_1) (contains Flour_1 Flour) (contains Salt_1 Salt)
  (contains Oil_1 Oil) (contains Wine_1 Wine) (foldable Cloth_1) (lightable Candle_1)
  (landmark Plant_1) (stands-on Plant_1 Counter_1)
  ; where things are
  (on Kettle_1 Burner_2) (on Pot_1 Burner_1) (in Pan_1 Cupboard_1) (stowed Pan_1)
  (on Jug_1 Table_1) (on Jug_2 Shelf_1) (on Mug_1 Shelf_1) (on Mug_2 Shelf_1)
  (on Mug_3 Table_1) (on Bowl_1 Table_1) (on Bowl_2 Shelf_1) (on Plate_1 Shelf_1)
  (on Plate_2 Shelf_1) (on Plate_3 Counter_1) (in Spoon_1 Drawer_1) (stowed Spoon_1)
  (on Ladle_1 Counter_1) (on Knife_1 Table_1) (on Honey_1 Shelf_2) (in Flour_1 Cupboard_1)
  (stowed Flour_1) (on Salt_1 Shelf_2) (on Oil_1 Counter_1) (on Wine_1 Shelf_2)
  (in Apple_1 Basket_1) (in Apple_2 Basket_1) (on Bread_1 Table_1) (in Cheese_1 Fridge_1)
  (stowed Cheese_1) (in Egg_1 Bowl_1) (in Egg_2 Bowl_1) (in Potato_1 Sink_1)
  (on Cloth_1 Counter_1) (on Candle_1 Table_1) (in Matches_1 Drawer_1) (stowed Matches_1)
  ; how things are
  (has Kettle_1 Water) (has Pot_1 Soup) (has Jug_1 Milk) (dirty Mug_3) (dirty Plate_3)
  (cold Cheese_1) (dirty Potato_1))

(:goal (and))
)
