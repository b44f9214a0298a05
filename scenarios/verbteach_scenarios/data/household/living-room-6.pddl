; A studio flat's living corner.

(define (problem living-room-6)
(:domain household)

(:objects
  SofaBed_1 Pouf_1 DeskChair_1 - seat
  Desk_1 CoffeeTable_1 Shelf_1 Shelf_2 Windowsill_1 Rug_1 - surface
  Projector_1 - screen
  ChannelUp_1 ChannelDown_1 VolumeUp_1 VolumeDown_1 LightSwitch_1 - button
  BluRayPlayer_1 - player
  Heater_1 Vacuum_1 - gadget
  Phone_1 Laptop_1 Newspaper_1 Keys_1 Wallet_1 Umbrella_1 Jacket_1 Scarf_1 Blanket_1
  TakeoutBox_1 - ware
  Lamp_1 Lamp_2 FairyLights_1 - lamp
  Closet_1 - cupboard
  Drawer_1 Drawer_2 - drawer
  Crate_1 Basket_1 - basket
  Bin_1 - bin
  Window_1 Blinds_1 Door_1 - opening
  Remote_1 - remote
  Movie_1 - disc
  Book_1 Book_2 - book
  Towel_1 Cloth_1 - cloth
  Pillow_1 Pillow_2 - cushion
  Mug_1 Mug_2 Glass_1 - cup
  Popcorn_1 - packet
  Bowl_1 - bowl
  Cactus_1 Fern_1 - plant)

(:init
  ; what never changes
  (switchable Projector_1) (landmark Projector_1) (stands-on Projector_1 Shelf_1)
  (channel-up ChannelUp_1 Projector_1) (channel-down ChannelDown_1 Projector_1)
  (volume-up VolumeUp_1 Projector_1) (volume-down VolumeDown_1 Projector_1)
  (switchable BluRayPlayer_1) (landmark BluRayPlayer_1) (stands-on BluRayPlayer_1 Shelf_2)
  (switchable Heater_1) (switchable Vacuum_1) (switchable Phone_1) (openable Laptop_1)
  (switchable Laptop_1) (switchable Lamp_1) (landmark Lamp_1) (stands-on Lamp_1 Desk_1)
  (switchable Lamp_2) (landmark FairyLights_1) (stands-on FairyLights_1 Shelf_1)
  (powers LightSwitch_1 FairyLights_1) (openable Closet_1) (openable Drawer_1)
  (openable Drawer_2) (openable Window_1) (openable Blinds_1) (openable Door_1)
  (powers Remote_1 Projector_1) (openable Book_1) (openable Book_2) (foldable Newspaper_1)
  (foldable Umbrella_1) (foldable Jacket_1) (foldable Scarf_1) (foldable Towel_1)
  (foldable Cloth_1) (foldable Blanket_1) (openable Popcorn_1) (contains Popcorn_1 Chips)
  (landmark Cactus_1) (stands-on Cactus_1 Windowsill_1) (landmark Fern_1)
  (stands-on Fern_1 Shelf_2) (next-channel News Sports) (next-channel Sports Movies)
  (next-channel Movies Music) (next-channel Music Cartoons) (next-channel Cartoons News)
  (louder Silent Quiet) (louder Quiet Normal) (louder Normal Loud)
  ; where things are
  (on Phone_1 Desk_1) (on Laptop_1 Desk_1) (on Remote_1 SofaBed_1) (on Movie_1 Shelf_2)
  (on Book_1 SofaBed_1) (on Book_2 Shelf_1) (on Newspaper_1 Rug_1) (on Keys_1 Desk_1)
  (in Wallet_1 Drawer_1) (stowed Wallet_1) (on Umbrella_1 Rug_1) (on Jacket_1 DeskChair_1)
  (in Scarf_1 Closet_1) (stowed Scarf_1) (in Towel_1 Closet_1) (stowed Towel_1)
  (on Cloth_1 Windowsill_1) (on Pillow_1 SofaBed_1) (on Pillow_2 SofaBed_1)
  (on Blanket_1 SofaBed_1) (on Mug_1 Desk_1) (on Mug_2 CoffeeTable_1)
  (on Glass_1 Windowsill_1) (on Popcorn_1 CoffeeTable_1) (on Bowl_1 Shelf_2)
  (on TakeoutBox_1 CoffeeTable_1)
  ; how things are
  (dirty CoffeeTable_1) (channel Projector_1 News) (volume Projector_1 Quiet) (is-on Phone_1)
  (is-on Lamp_1) (open Blinds_1) (open Book_1) (folded Scarf_1) (folded Towel_1)
  (has Mug_1 Tea) (dirty Mug_2) (has Glass_1 Water))

(:goal (and))
)
