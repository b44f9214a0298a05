; A living room with a play corner.

(define (problem living-room-4)
(:domain household)

(:objects
  Sofa_1 Armchair_1 SmallChair_1 - seat
  PlayTable_1 CoffeeTable_1 Sideboard_1 Shelf_1 PlayMat_1 - surface
  Tv_1 - screen
  TvPower_1 ChannelUp_1 ChannelDown_1 VolumeUp_1 VolumeDown_1 - button
  NightLight_1 Lamp_1 - lamp
  Piano_1 - gadget
  ToyBox_1 Basket_1 - basket
  Bin_1 DiaperBin_1 - bin
  Cabinet_1 - cupboard
  Drawer_1 Drawer_2 - drawer
  Window_1 Gate_1 Curtain_1 - opening
  Teddy_1 Doll_1 Car_1 Train_1 Ball_1 Blocks_1 Blanket_1 Blanket_2 Diaper_1 - ware
  Puzzle_1 Crayons_1 - packet
  Book_1 Book_2 Book_3 - book
  Dvd_1 - disc
  DvdPlayer_1 - player
  Pillow_1 Pillow_2 - cushion
  Cup_1 Cup_2 Mug_1 - cup
  Juice_1 - bottle
  Bowl_1 - bowl
  Cookie_1 Banana_1 - food
  Wipes_1 - cloth
  Plant_1 - plant
  Jug_1 - jug)

(:init
  ; what never changes
  (switchable Tv_1) (landmark Tv_1) (stands-on Tv_1 Sideboard_1) (powers TvPower_1 Tv_1)
  (channel-up ChannelUp_1 Tv_1) (channel-down ChannelDown_1 Tv_1) (volume-up VolumeUp_1 Tv_1)
  (volume-down VolumeDown_1 Tv_1) (switchable NightLight_1) (landmark NightLight_1)
  (stands-on NightLight_1 Shelf_1) (switchable Lamp_1) (landmark Lamp_1)
  (stands-on Lamp_1 Sideboard_1) (switchable Piano_1) (openable Cabinet_1) (openable Drawer_1)
  (openable Drawer_2) (openable Window_1) (openable Gate_1) (openable Curtain_1)
  (openable Puzzle_1) (openable Crayons_1) (openable Book_1) (openable Book_2)
  (openable Book_3) (switchable DvdPlayer_1) (landmark DvdPlayer_1)
  (stands-on DvdPlayer_1 Sideboard_1) (foldable Blanket_1) (foldable Blanket_2)
  (contains Juice_1 Juice) (landmark Plant_1) (stands-on Plant_1 Sideboard_1)
  (next-channel News Sports) (next-channel Sports Movies) (next-channel Movies Music)
  (next-channel Music Cartoons) (next-channel Cartoons News) (louder Silent Quiet)
  (louder Quiet Normal) (louder Normal Loud)
  ; where things are
  (on Teddy_1 PlayMat_1) (on Doll_1 SmallChair_1) (on Car_1 PlayMat_1)
  (on Train_1 PlayTable_1) (on Ball_1 PlayMat_1) (on Blocks_1 PlayMat_1)
  (on Puzzle_1 PlayTable_1) (in Crayons_1 Drawer_2) (stowed Crayons_1) (on Book_1 PlayMat_1)
  (on Book_2 Shelf_1) (on Book_3 CoffeeTable_1) (on Dvd_1 Shelf_1) (on Blanket_1 Sofa_1)
  (on Blanket_2 Armchair_1) (on Pillow_1 PlayMat_1) (on Pillow_2 Sofa_1)
  (on Cup_1 CoffeeTable_1) (on Cup_2 PlayTable_1) (on Mug_1 CoffeeTable_1)
  (on Juice_1 CoffeeTable_1) (on Bowl_1 PlayTable_1) (in Cookie_1 Bowl_1)
  (on Banana_1 CoffeeTable_1) (in Wipes_1 Drawer_1) (stowed Wipes_1) (on Diaper_1 Sofa_1)
  (on Jug_1 Sideboard_1)
  ; how things are
  (dirty PlayTable_1) (is-on Tv_1) (channel Tv_1 Cartoons) (volume Tv_1 Loud) (open Drawer_2)
  (open Window_1) (open Curtain_1) (open Book_1) (folded Blanket_2) (has Cup_1 Juice)
  (dirty Cup_2) (has Mug_1 Coffee) (dirty Diaper_1) (has Jug_1 Water))

(:goal (and))
)
