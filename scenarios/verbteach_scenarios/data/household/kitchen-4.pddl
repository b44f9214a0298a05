; An office kitchenette.

(define (problem kitchen-4)
(:domain household)

(:objects
  Counter_1 Counter_2 Table_1 - surface
  Sink_1 - sink
  Tap_1 CoffeeMachine_1 Dispenser_1 - spout
  DispenserButton_1 LightSwitch_1 - button
  Microwave_1 - heater
  Dishwasher_1 - washer
  Fridge_1 - fridge
  Cupboard_1 Cupboard_2 - cupboard
  Drawer_1 Drawer_2 - drawer
  Bin_1 Bin_2 - bin
  CeilingLight_1 - lamp
  Blinds_1 - opening
  Mug_1 Mug_2 Mug_3 Mug_4 Glass_1 Glass_2 - cup
  Bowl_1 Bowl_2 - bowl
  Plate_1 Plate_2 - plate
  Jug_1 - jug
  Spoon_1 - spoon
  Fork_1 - utensil
  Knife_1 - knife
  MilkCarton_1 OatMilk_1 Cola_1 Juice_1 - bottle
  Sugar_1 Cocoa_1 - jar
  TeaBag_1 TeaBag_2 - teabag
  Sandwich_1 Orange_1 Banana_1 Cake_1 Lasagna_1 - food
  Sponge_1 Towel_1 - cloth
  Newspaper_1 - ware
  Stool_1 - seat
  Plant_1 - plant)

(:init
  ; what never changes
  (landmark Sink_1) (stands-on Sink_1 Counter_1) (switchable Tap_1)
  (stands-on Tap_1 Counter_1) (feeds Tap_1 Sink_1) (dispenses Tap_1 Water)
  (switchable CoffeeMachine_1) (landmark CoffeeMachine_1)
  (stands-on CoffeeMachine_1 Counter_1) (dispenses CoffeeMachine_1 Coffee)
  (dispenses Dispenser_1 Water) (powers DispenserButton_1 Dispenser_1) (openable Microwave_1)
  (landmark Microwave_1) (stands-on Microwave_1 Counter_2) (openable Dishwasher_1)
  (openable Fridge_1) (openable Cupboard_1) (openable Cupboard_2) (openable Drawer_1)
  (openable Drawer_2) (powers LightSwitch_1 CeilingLight_1) (openable Blinds_1)
  (contains MilkCarton_1 Milk) (contains OatMilk_1 Milk) (contains Cola_1 Cola)
  (contains Juice_1 Juice) (contains Sugar_1 Sugar) (contains Cocoa_1 CoffeePowder)
  (foldable Towel_1) (foldable Newspaper_1) (landmark Plant_1) (stands-on Plant_1 Counter_2)
  ; where things are
  (in Mug_1 Cupboard_1) (stowed Mug_1) (in Mug_2 Cupboard_1) (stowed Mug_2) (on Mug_3 Table_1)
  (in Mug_4 Dishwasher_1) (stowed Mug_4) (in Glass_1 Cupboard_1) (stowed Glass_1)
  (on Glass_2 Counter_1) (beside Glass_2 Sink_1) (in Bowl_1 Cupboard_2) (stowed Bowl_1)
  (on Bowl_2 Counter_2) (in Plate_1 Cupboard_2) (stowed Plate_1) (on Plate_2 Table_1)
  (on Jug_1 Counter_2) (in Spoon_1 Drawer_1) (stowed Spoon_1) (in Fork_1 Drawer_1)
  (stowed Fork_1) (in Knife_1 Drawer_1) (stowed Knife_1) (in MilkCarton_1 Fridge_1)
  (stowed MilkCarton_1) (in OatMilk_1 Fridge_1) (stowed OatMilk_1) (in Cola_1 Fridge_1)
  (stowed Cola_1) (in Juice_1 Fridge_1) (stowed Juice_1) (on Sugar_1 Counter_1)
  (in Cocoa_1 Cupboard_2) (stowed Cocoa_1) (in TeaBag_1 Drawer_2) (stowed TeaBag_1)
  (in TeaBag_2 Drawer_2) (stowed TeaBag_2) (in Sandwich_1 Fridge_1) (stowed Sandwich_1)
  (in Orange_1 Bowl_2) (in Banana_1 Bowl_2) (on Cake_1 Plate_2) (in Lasagna_1 Fridge_1)
  (stowed Lasagna_1) (on Sponge_1 Counter_1) (beside Sponge_1 Sink_1) (on Towel_1 Counter_1)
  (on Newspaper_1 Table_1)
  ; how things are
  (dirty Table_1) (dirty Mug_3) (dirty Mug_4) (dirty Glass_2) (dirty Plate_2)
  (cold MilkCarton_1) (cold OatMilk_1) (cold Cola_1) (cold Juice_1) (cold Sandwich_1)
  (cold Lasagna_1))

(:goal (and))
)
