; A students' shared living room.

(define (problem living-room-3)
(:domain household)

(:objects
  Sofa_1 Beanbag_1 Chair_1 - seat
  CoffeeTable_1 Desk_1 TvTable_1 Shelf_1 Floor_1 - surface
  Tv_1 - screen
  ChannelUp_1 ChannelDown_1 VolumeUp_1 VolumeDown_1 LightSwitch_1 - button
  Xbox_1 - player
  Speaker_1 Fan_1 - gadget
  Lamp_1 CeilingLight_1 - lamp
  Fridge_1 - fridge
  Locker_1 - cupboard
  Drawer_1 - drawer
  Bin_1 - bin
  LaundryBasket_1 - basket
  Blinds_1 Door_1 - opening
  Remote_1 Remote_2 - remote
  Controller_1 Controller_2 Headphones_1 Laptop_1 Tshirt_1 Socks_1 GarbageBag_1 - ware
  Game_1 Game_2 - disc
  Book_1 Book_2 - book
  Pillow_1 Pillow_2 - cushion
  Towel_1 - cloth
  PizzaBox_1 Chips_1 - packet
  Pizza_1 - food
  Plate_1 - plate
  Beer_1 Beer_2 Cola_1 EnergyDrink_1 - bottle
  Mug_1 Glass_1 - cup
  Bowl_1 - bowl)

(:init
  ; what never changes
  (switchable Tv_1) (landmark Tv_1) (stands-on Tv_1 TvTable_1) (channel-up ChannelUp_1 Tv_1)
  (channel-down ChannelDown_1 Tv_1) (volume-up VolumeUp_1 Tv_1)
  (volume-down VolumeDown_1 Tv_1) (switchable Xbox_1) (landmark Xbox_1)
  (stands-on Xbox_1 TvTable_1) (switchable Speaker_1) (landmark Speaker_1)
  (stands-on Speaker_1 Desk_1) (switchable Fan_1) (switchable Lamp_1) (landmark Lamp_1)
  (stands-on Lamp_1 Desk_1) (powers LightSwitch_1 CeilingLight_1) (openable Fridge_1)
  (openable Locker_1) (openable Drawer_1) (openable Blinds_1) (openable Door_1)
  (powers Remote_1 Tv_1) (powers Remote_2 Speaker_1) (openable Laptop_1) (switchable Laptop_1)
  (openable Book_1) (openable Book_2) (foldable Tshirt_1) (foldable Towel_1)
  (openable PizzaBox_1) (contains Beer_1 Beer) (contains Beer_2 Beer) (contains Cola_1 Cola)
  (openable Chips_1) (contains Chips_1 Chips) (next-channel News Sports)
  (next-channel Sports Movies) (next-channel Movies Music) (next-channel Music Cartoons)
  (next-channel Cartoons News) (louder Silent Quiet) (louder Quiet Normal)
  (louder Normal Loud)
  ; where things are
  (on Remote_1 Floor_1) (in Remote_2 Drawer_1) (stowed Remote_2)
  (on Controller_1 CoffeeTable_1) (on Controller_2 Beanbag_1) (on Game_1 Shelf_1)
  (on Game_2 CoffeeTable_1) (on Headphones_1 Desk_1) (on Laptop_1 Desk_1) (on Book_1 Floor_1)
  (on Book_2 Desk_1) (on Pillow_1 Floor_1) (on Pillow_2 Sofa_1) (on Tshirt_1 Sofa_1)
  (on Towel_1 Chair_1) (on Socks_1 Floor_1) (on PizzaBox_1 CoffeeTable_1) (on Pizza_1 Plate_1)
  (on Plate_1 CoffeeTable_1) (on Beer_1 CoffeeTable_1) (in Beer_2 Fridge_1) (stowed Beer_2)
  (on Cola_1 Desk_1) (in EnergyDrink_1 Fridge_1) (stowed EnergyDrink_1) (on Mug_1 Desk_1)
  (on Glass_1 Floor_1) (in Chips_1 Locker_1) (stowed Chips_1) (on Bowl_1 Shelf_1)
  (on GarbageBag_1 Floor_1)
  ; how things are
  (dirty Sofa_1) (dirty CoffeeTable_1) (dirty Floor_1) (channel Tv_1 Sports)
  (volume Tv_1 Loud) (is-on Fan_1) (is-on CeilingLight_1) (open Locker_1) (open Laptop_1)
  (is-on Laptop_1) (open Book_1) (dirty Tshirt_1) (dirty Towel_1) (dirty Socks_1)
  (dirty Plate_1) (cold Beer_2) (cold EnergyDrink_1) (has Mug_1 Coffee) (dirty Mug_1)
  (dirty Glass_1))

(:goal (and))
)
