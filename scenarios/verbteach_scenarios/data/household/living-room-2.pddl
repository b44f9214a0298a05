; A quiet reading room.

(define (problem living-room-2)
(:domain household)

(:objects
  Armchair_1 Armchair_2 Sofa_1 - seat
  Desk_1 SideTable_1 CoffeeTable_1 Shelf_1 Shelf_2 Shelf_3 Windowsill_1 - surface
  Lamp_1 Lamp_2 Lamp_3 - lamp
  Radio_1 - gadget
  VolumeUp_1 VolumeDown_1 - button
  Drawer_1 Drawer_2 - drawer
  Cabinet_1 - cupboard
  WasteBasket_1 - bin
  Basket_1 - basket
  Window_1 Curtain_1 Door_1 - opening
  Plant_1 Plant_2 - plant
  WateringJug_1 Teapot_1 - jug
  Book_1 Book_2 Book_3 Book_4 Book_5 Magazine_1 - book
  Newspaper_1 Newspaper_2 Glasses_1 Pen_1 Letter_1 Blanket_1 CatToy_1 - ware
  Mug_1 Mug_2 WineGlass_1 - cup
  Sugar_1 - jar
  Spoon_1 - spoon
  Plate_1 - plate
  Cookie_1 - food
  Pillow_1 Pillow_2 - cushion
  Wine_1 - bottle
  Duster_1 - cloth)

(:init
  ; what never changes
  (switchable Lamp_1) (landmark Lamp_1) (stands-on Lamp_1 Desk_1) (switchable Lamp_2)
  (landmark Lamp_2) (stands-on Lamp_2 SideTable_1) (switchable Lamp_3) (switchable Radio_1)
  (landmark Radio_1) (stands-on Radio_1 Shelf_2) (volume-up VolumeUp_1 Radio_1)
  (volume-down VolumeDown_1 Radio_1) (openable Drawer_1) (openable Drawer_2)
  (openable Cabinet_1) (openable Window_1) (openable Curtain_1) (openable Door_1)
  (landmark Plant_1) (stands-on Plant_1 Windowsill_1) (landmark Plant_2)
  (stands-on Plant_2 Windowsill_1) (openable Book_1) (openable Book_2) (openable Book_3)
  (openable Book_4) (openable Book_5) (foldable Newspaper_1) (foldable Newspaper_2)
  (openable Magazine_1) (foldable Letter_1) (contains Sugar_1 Sugar) (foldable Blanket_1)
  (contains Wine_1 Wine) (foldable Duster_1) (louder Silent Quiet) (louder Quiet Normal)
  (louder Normal Loud)
  ; where things are
  (on WateringJug_1 Windowsill_1) (on Book_1 Desk_1) (on Book_2 Armchair_1)
  (on Book_3 Shelf_1) (on Book_4 Shelf_2) (on Book_5 CoffeeTable_1)
  (on Newspaper_1 CoffeeTable_1) (on Newspaper_2 Sofa_1) (on Magazine_1 SideTable_1)
  (on Glasses_1 SideTable_1) (on Pen_1 Desk_1) (in Letter_1 Drawer_1) (stowed Letter_1)
  (on Mug_1 SideTable_1) (on Mug_2 Desk_1) (on Teapot_1 CoffeeTable_1)
  (on Sugar_1 CoffeeTable_1) (on Spoon_1 CoffeeTable_1) (on Plate_1 CoffeeTable_1)
  (on Cookie_1 Plate_1) (on Pillow_1 Sofa_1) (on Pillow_2 Armchair_2) (on Blanket_1 Sofa_1)
  (in Wine_1 Cabinet_1) (stowed Wine_1) (in WineGlass_1 Cabinet_1) (stowed WineGlass_1)
  (in Duster_1 Drawer_2) (stowed Duster_1) (on CatToy_1 Sofa_1)
  ; how things are
  (dirty Desk_1) (is-on Lamp_2) (volume Radio_1 Quiet) (open Door_1) (has WateringJug_1 Water)
  (open Book_1) (open Book_2) (folded Newspaper_2) (folded Letter_1) (has Mug_1 Tea)
  (dirty Mug_2) (has Teapot_1 Tea) (hot Teapot_1) (hot Tea) (folded Blanket_1))

(:goal (and))
)
