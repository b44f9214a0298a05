; A holiday flat's open kitchen.

(define (problem kitchen-6)
(:domain household)

(:objects
  Counter_1 Counter_2 Table_1 - surface
  Sink_1 - sink
  Tap_1 CoffeeMachine_1 - spout
  Burner_1 Burner_2 - burner
  StoveKnob_1 StoveKnob_2 - knob
  Microwave_1 - heater
  Fridge_1 - fridge
  Cupboard_1 Cupboard_2 - cupboard
  Drawer_1 - drawer
  Bin_1 - bin
  BalconyDoor_1 Curtain_1 - opening
  Lamp_1 CeilingLight_1 - lamp
  LightSwitch_1 - button
  Kettle_1 Pan_1 Pot_1 - cookware
  WineGlass_1 WineGlass_2 Glass_1 Glass_2 Mug_1 Mug_2 - cup
  Bowl_1 Bowl_2 - bowl
  Plate_1 Plate_2 Plate_3 - plate
  Jug_1 - jug
  Spoon_1 - spoon
  Knife_1 - knife
  Juice_1 Wine_1 Wine_2 Cola_1 Salt_1 - bottle
  IceCream_1 - jar
  Rice_1 - packet
  Pasta_1 Tomato_1 Pear_1 Apple_1 Steak_1 - food
  Cloth_1 Towel_1 - cloth
  Candle_1 - candle
  Lighter_1 - lighter
  Stool_1 - seat)

(:init
  ; what never changes
  (landmark Sink_1) (stands-on Sink_1 Counter_1) (switchable Tap_1)
  (stands-on Tap_1 Counter_1) (feeds Tap_1 Sink_1) (dispenses Tap_1 Water)
  (controls StoveKnob_1 Burner_1) (controls StoveKnob_2 Burner_2) (openable Microwave_1)
  (landmark Microwave_1) (stands-on Microwave_1 Counter_1) (openable Fridge_1)
  (switchable CoffeeMachine_1) (landmark CoffeeMachine_1)
  (stands-on CoffeeMachine_1 Counter_2) (dispenses CoffeeMachine_1 Coffee)
  (openable Cupboard_1) (openable Cupboard_2) (openable Drawer_1) (openable BalconyDoor_1)
  (openable Curtain_1) (switchable Lamp_1) (landmark Lamp_1) (stands-on Lamp_1 Counter_2)
  (powers LightSwitch_1 CeilingLight_1) (contains Juice_1 Juice) (contains Wine_1 Wine)
  (contains Wine_2 Wine) (contains Cola_1 Cola) (contains Salt_1 Salt)
  (contains IceCream_1 IceCream) (openable Rice_1) (contains Rice_1 Rice) (foldable Cloth_1)
  (foldable Towel_1) (lightable Candle_1)
  ; where things are
  (on Kettle_1 Counter_1) (on Pan_1 Burner_2) (on Pot_1 Burner_1) (in WineGlass_1 Cupboard_1)
  (stowed WineGlass_1) (on WineGlass_2 Table_1) (in Glass_1 Cupboard_1) (stowed Glass_1)
  (on Glass_2 Counter_2) (in Mug_1 Cupboard_1) (stowed Mug_1) (on Mug_2 Counter_2)
  (on Bowl_1 Counter_2) (in Bowl_2 Cupboard_1) (stowed Bowl_2) (in Plate_1 Cupboard_1)
  (stowed Plate_1) (in Plate_2 Cupboard_1) (stowed Plate_2) (on Plate_3 Table_1)
  (in Jug_1 Fridge_1) (stowed Jug_1) (in Spoon_1 Drawer_1) (stowed Spoon_1)
  (on Knife_1 Counter_1) (in Juice_1 Fridge_1) (stowed Juice_1) (on Wine_1 Counter_2)
  (in Wine_2 Fridge_1) (stowed Wine_2) (in Cola_1 Fridge_1) (stowed Cola_1)
  (on Salt_1 Counter_1) (in IceCream_1 Fridge_1) (stowed IceCream_1) (in Rice_1 Cupboard_2)
  (stowed Rice_1) (in Pasta_1 Cupboard_2) (stowed Pasta_1) (on Tomato_1 Counter_1)
  (in Pear_1 Bowl_1) (in Apple_1 Bowl_1) (in Steak_1 Fridge_1) (stowed Steak_1)
  (on Cloth_1 Counter_1) (beside Cloth_1 Sink_1) (on Towel_1 Counter_2) (on Candle_1 Table_1)
  (in Lighter_1 Drawer_1) (stowed Lighter_1)
  ; how things are
  (is-on Tap_1) (is-on Burner_2) (open Microwave_1) (open BalconyDoor_1) (has Pan_1 Oil)
  (hot Pan_1) (hot Oil) (dirty WineGlass_2) (has Glass_2 Juice) (dirty Mug_2) (dirty Plate_3)
  (cold Jug_1) (has Jug_1 Water) (cold Juice_1) (cold Wine_2) (cold Cola_1) (cold IceCream_1)
  (cold Steak_1))

(:goal (and))
)
