; A family kitchen in the morning.

(define (problem kitchen-1)
(:domain household)

(:objects
  Counter_1 Table_1 - surface
  Sink_1 - sink
  Tap_1 - spout
  Burner_1 Burner_2 - burner
  StoveKnob_1 StoveKnob_2 - knob
  Microwave_1 - heater
  Fridge_1 - fridge
  Cupboard_1 Cupboard_2 - cupboard
  Drawer_1 - drawer
  Bin_1 - bin
  Window_1 - opening
  CeilingLight_1 - lamp
  LightSwitch_1 - button
  Kettle_1 Pot_1 Pan_1 - cookware
  Mug_1 Mug_2 Mug_3 Glass_1 - cup
  Bowl_1 Bowl_2 - bowl
  Plate_1 Plate_2 - plate
  Spoon_1 Ladle_1 - spoon
  Knife_1 - knife
  MilkCarton_1 JuiceBottle_1 SaltShaker_1 Beer_1 - bottle
  SugarJar_1 CoffeeJar_1 - jar
  Cereal_1 - packet
  Syrup_1 - squeezer
  Ramen_1 Egg_1 Bread_1 Apple_1 - food
  Sponge_1 Towel_1 - cloth
  Chair_1 - seat)

(:init
  ; what never changes
  (landmark Sink_1) (stands-on Sink_1 Counter_1) (switchable Tap_1)
  (stands-on Tap_1 Counter_1) (feeds Tap_1 Sink_1) (dispenses Tap_1 Water)
  (controls StoveKnob_1 Burner_1) (controls StoveKnob_2 Burner_2) (openable Microwave_1)
  (landmark Microwave_1) (stands-on Microwave_1 Counter_1) (openable Fridge_1)
  (openable Cupboard_1) (openable Cupboard_2) (openable Drawer_1) (openable Window_1)
  (powers LightSwitch_1 CeilingLight_1) (contains MilkCarton_1 Milk)
  (contains JuiceBottle_1 Juice) (contains SaltShaker_1 Salt) (contains SugarJar_1 Sugar)
  (contains CoffeeJar_1 CoffeePowder) (openable Cereal_1) (contains Cereal_1 Cereal)
  (contains Syrup_1 Syrup) (foldable Towel_1) (contains Beer_1 Beer)
  ; where things are
  (on Kettle_1 Counter_1) (in Pot_1 Cupboard_2) (stowed Pot_1) (on Pan_1 Burner_2)
  (on Mug_1 Table_1) (on Mug_2 Counter_1) (in Mug_3 Cupboard_1) (stowed Mug_3)
  (in Glass_1 Cupboard_1) (stowed Glass_1) (on Bowl_1 Counter_1) (in Bowl_2 Cupboard_1)
  (stowed Bowl_2) (in Plate_1 Cupboard_1) (stowed Plate_1) (on Plate_2 Table_1)
  (in Spoon_1 Drawer_1) (stowed Spoon_1) (on Ladle_1 Counter_1) (in Knife_1 Drawer_1)
  (stowed Knife_1) (in MilkCarton_1 Fridge_1) (stowed MilkCarton_1)
  (in JuiceBottle_1 Fridge_1) (stowed JuiceBottle_1) (on SaltShaker_1 Table_1)
  (on SugarJar_1 Counter_1) (in CoffeeJar_1 Cupboard_1) (stowed CoffeeJar_1)
  (on Cereal_1 Table_1) (on Syrup_1 Table_1) (in Ramen_1 Cupboard_2) (stowed Ramen_1)
  (in Egg_1 Fridge_1) (stowed Egg_1) (on Bread_1 Table_1) (in Apple_1 Bowl_1)
  (on Sponge_1 Counter_1) (beside Sponge_1 Sink_1) (on Towel_1 Counter_1) (on Beer_1 Table_1)
  ; how things are
  (dirty Table_1) (is-on CeilingLight_1) (has Kettle_1 Water) (dirty Pan_1) (dirty Mug_2)
  (dirty Plate_2) (cold MilkCarton_1) (cold JuiceBottle_1) (cold Egg_1))

(:goal (and))
)
