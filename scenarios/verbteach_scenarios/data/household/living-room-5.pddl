; A sitting room with a fireplace.

(define (problem living-room-5)
(:domain household)

(:objects
  Sofa_1 Armchair_1 Footstool_1 - seat
  CoffeeTable_1 Mantel_1 Cart_1 RecordTable_1 Hearthrug_1 - surface
  Fireplace_1 - hearth
  RecordPlayer_1 - player
  VolumeUp_1 VolumeDown_1 LightSwitch_1 - button
  Lamp_1 Lamp_2 Chandelier_1 - lamp
  Cabinet_1 Chest_1 - cupboard
  Drawer_1 - drawer
  LogBasket_1 - basket
  Bin_1 - bin
  Window_1 Curtain_1 Door_1 - opening
  Candle_1 Candle_2 Candle_3 - candle
  Lighter_1 Matches_1 - lighter
  Log_1 Log_2 Vase_1 Clock_1 Photo_1 Blanket_1 - ware
  Record_1 Record_2 - disc
  Wine_1 Brandy_1 - bottle
  Decanter_1 Pitcher_1 - jug
  WineGlass_1 WineGlass_2 Tumbler_1 - cup
  Bowl_1 - bowl
  Chocolate_1 Grapes_1 - food
  Plate_1 - plate
  Book_1 Book_2 - book
  Pillow_1 Pillow_2 Pillow_3 - cushion
  Cloth_1 - cloth
  Plant_1 - plant)

(:init
  ; what never changes
  (lightable Fireplace_1) (switchable RecordPlayer_1) (landmark RecordPlayer_1)
  (stands-on RecordPlayer_1 RecordTable_1) (volume-up VolumeUp_1 RecordPlayer_1)
  (volume-down VolumeDown_1 RecordPlayer_1) (switchable Lamp_1) (landmark Lamp_1)
  (stands-on Lamp_1 RecordTable_1) (switchable Lamp_2) (powers LightSwitch_1 Chandelier_1)
  (openable Cabinet_1) (openable Chest_1) (openable Drawer_1) (openable Window_1)
  (openable Curtain_1) (openable Door_1) (lightable Candle_1) (lightable Candle_2)
  (lightable Candle_3) (contains Wine_1 Wine) (contains Brandy_1 Wine) (openable Book_1)
  (openable Book_2) (foldable Blanket_1) (foldable Cloth_1) (landmark Plant_1)
  (stands-on Plant_1 Cart_1) (louder Silent Quiet) (louder Quiet Normal) (louder Normal Loud)
  ; where things are
  (on Candle_1 Mantel_1) (on Candle_2 Mantel_1) (on Candle_3 CoffeeTable_1)
  (on Lighter_1 Mantel_1) (in Matches_1 Drawer_1) (stowed Matches_1) (in Log_1 LogBasket_1)
  (on Log_2 Hearthrug_1) (on Record_1 RecordTable_1) (on Record_2 Sofa_1) (on Vase_1 Mantel_1)
  (on Clock_1 Mantel_1) (on Photo_1 CoffeeTable_1) (on Wine_1 Cart_1) (in Brandy_1 Cabinet_1)
  (stowed Brandy_1) (on Decanter_1 Cart_1) (on WineGlass_1 Cart_1)
  (on WineGlass_2 CoffeeTable_1) (in Tumbler_1 Cabinet_1) (stowed Tumbler_1)
  (on Bowl_1 CoffeeTable_1) (in Chocolate_1 Bowl_1) (on Grapes_1 Plate_1) (on Plate_1 Cart_1)
  (on Book_1 Armchair_1) (on Book_2 Mantel_1) (on Pillow_1 Sofa_1) (on Pillow_2 Sofa_1)
  (on Pillow_3 Armchair_1) (in Blanket_1 Chest_1) (stowed Blanket_1) (on Cloth_1 Cart_1)
  (on Pitcher_1 CoffeeTable_1)
  ; how things are
  (dirty Hearthrug_1) (volume RecordPlayer_1 Normal) (is-on Lamp_1) (is-on Chandelier_1)
  (lit Candle_2) (dirty WineGlass_2) (has WineGlass_2 Wine) (folded Blanket_1)
  (folded Cloth_1) (has Pitcher_1 Water))

(:goal (and))
)
