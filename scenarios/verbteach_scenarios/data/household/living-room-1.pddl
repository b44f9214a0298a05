; A family living room after a film night.

(define (problem living-room-1)
(:domain household)

(:objects
  Sofa_1 Loveseat_1 Armchair_1 - seat
  CoffeeTable_1 TvTable_1 Shelf_1 Shelf_2 Rug_1 - surface
  Tv_1 - screen
  TvPower_1 ChannelUp_1 ChannelDown_1 VolumeUp_1 VolumeDown_1 LightSwitch_1 - button
  DvdPlayer_1 - player
  Lamp_1 Lamp_2 CeilingLight_1 - lamp
  Cabinet_1 - cupboard
  Drawer_1 - drawer
  Bin_1 - bin
  ToyBasket_1 - basket
  Window_1 Curtain_1 - opening
  Remote_1 - remote
  Pillow_1 Pillow_2 Pillow_3 Pillow_4 - cushion
  Blanket_1 Teddy_1 - ware
  Book_1 Book_2 Book_3 - book
  Dvd_1 Dvd_2 - disc
  Cloth_1 - cloth
  Beer_1 Beer_2 Cola_1 - bottle
  Chips_1 - packet
  Bowl_1 - bowl
  Glass_1 Mug_1 - cup
  Plate_1 - plate
  Flower_1 - plant)

(:init
  ; what never changes
  (switchable Tv_1) (landmark Tv_1) (stands-on Tv_1 TvTable_1) (powers TvPower_1 Tv_1)
  (channel-up ChannelUp_1 Tv_1) (channel-down ChannelDown_1 Tv_1) (volume-up VolumeUp_1 Tv_1)
  (volume-down VolumeDown_1 Tv_1) (switchable DvdPlayer_1) (landmark DvdPlayer_1)
  (stands-on DvdPlayer_1 TvTable_1) (switchable Lamp_1) (landmark Lamp_1)
  (stands-on Lamp_1 TvTable_1) (switchable Lamp_2) (powers LightSwitch_1 CeilingLight_1)
  (openable Cabinet_1) (openable Drawer_1) (openable Window_1) (openable Curtain_1)
  (powers Remote_1 Tv_1) (foldable Blanket_1) (openable Book_1) (openable Book_2)
  (openable Book_3) (foldable Cloth_1) (contains Beer_1 Beer) (contains Cola_1 Cola)
  (openable Chips_1) (contains Chips_1 Chips) (landmark Flower_1)
  (stands-on Flower_1 TvTable_1) (next-channel News Sports) (next-channel Sports Movies)
  (next-channel Movies Music) (next-channel Music Cartoons) (next-channel Cartoons News)
  (louder Silent Quiet) (louder Quiet Normal) (louder Normal Loud)
  ; where things are
  (on Remote_1 Sofa_1) (on Pillow_1 Sofa_1) (on Pillow_2 Sofa_1) (on Pillow_3 Rug_1)
  (on Pillow_4 Shelf_2) (on Blanket_1 Loveseat_1) (on Book_1 CoffeeTable_1)
  (on Book_2 Shelf_1) (on Book_3 Shelf_1) (on Dvd_1 Shelf_2) (in Dvd_2 Cabinet_1)
  (stowed Dvd_2) (in Cloth_1 Drawer_1) (stowed Cloth_1) (on Beer_1 CoffeeTable_1)
  (on Beer_2 Rug_1) (on Cola_1 Shelf_2) (on Chips_1 CoffeeTable_1) (on Bowl_1 CoffeeTable_1)
  (on Glass_1 CoffeeTable_1) (on Mug_1 Shelf_2) (on Plate_1 Rug_1) (on Teddy_1 Armchair_1)
  ; how things are
  (dirty CoffeeTable_1) (dirty Rug_1) (is-on Tv_1) (channel Tv_1 Movies) (volume Tv_1 Normal)
  (is-on Lamp_2) (open Curtain_1) (open Book_1) (has Glass_1 Water) (dirty Mug_1)
  (dirty Plate_1))

(:goal (and))
)
