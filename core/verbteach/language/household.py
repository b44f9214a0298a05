"""Open-class words of a household: common verbs by how they build, nouns, adjectives.

General English only, so that a command can be cut into phrases before any
scene is known. What a word refers to is decided by the scene and the lexicon.
"""

from __future__ import annotations

from verbteach.language.wordlist import word_set

PLACING = word_set(
    "put place move set lay leave store hang stick insert drop stack rest return arrange spread "
    "sprinkle position park sit install load mount deposit pile dump throw toss pour squeeze "
    "drizzle slide slip tuck fix attach plug hook balance lean stand stow replace keep shove "
    "stuff squirt add scatter fold pack insert screw organize spray divide split distribute share "
    "chuck plop hide shelve plunge dip submerge rack push bury line nest pop display assemble"
)
"""The place after the object is where it goes."""

PROCESSING = word_set(
    "heat cook warm boil bake fry toast microwave mix stir wash rinse freeze cool chill dry soak "
    "melt roast grill steam simmer brew blend defrost thaw reheat clean scrub refrigerate whisk "
    "beat make prepare serve marinate dissolve poach scramble combine saute brown use eat drink "
    "charge play insert watch iron press hold carry build do test try read cut chop slice peel "
    "dice grate"
) - word_set("press insert hold carry use watch read test try clean")
"""The place after the object is where, or in what, the thing is done."""

MOVING = word_set(
    "go come walk drive move run step travel return head look sit stand wait stop stay turn get "
    "climb enter fly roll rush hurry proceed crawl jump lie sleep knock reach lean press"
) - word_set("get press turn")
"""May stand without an object; the place after it belongs to the verb."""

INTRANSITIVE = MOVING | word_set("help relax sleep rise listen wake")

FETCHING = word_set(
    "get take grab bring fetch pick find show give hand pass see locate collect gather grasp buy "
    "want need select choose identify carry hold remove retrieve lift seek spot point touch like "
    "have deliver lend offer send catch transport"
)
"""The place after the object usually says which one."""

MOSTLY_VERBS = word_set(
    "place set drop rest stand step stick load switch lock show cover take wrap pack"
)
"""Nouns that without a determiner are verbs: ``and place on the table``."""

TRANSFERRING = (
    PLACING
    | MOVING
    | FETCHING
    | word_set(
        "move transfer change connect bring give add turn switch tie push pull drag pour feed send "
        "throw toss deliver shift carry empty set adjust convert increase decrease point glue tape "
        "introduce compare apply read talk speak sing say belong listen rotate raise lower bind "
        "swap exchange drain strap clip fasten pin nail"
    )
)
"""``to`` after the object belongs to the verb."""

TO_DATIVE = word_set(
    "bring give hand pass show send throw toss serve offer lend read tell teach feed sell pay owe "
    "promise deliver sing slide"
)
FOR_DATIVE = word_set(
    "get fetch find make cook pour buy prepare grab build fix choose bake brew order pick save "
    "leave heat warm boil toast fill cut slice open mix play take peel wash clean book"
)

USING = word_set("use using take")

OTHER_VERBS = word_set(
    "open close shut lock unlock turn switch start stop press push pull fill empty drain wipe "
    "dust sweep mop vacuum polish tidy cut chop slice peel dice grate mince mash crush grind "
    "carve crack break tear season salt pepper butter water light extinguish ignite unplug "
    "activate deactivate enable disable toggle flip rotate twist tilt shake crumple knead flatten "
    "wrap unwrap cover uncover seal unseal fold unfold fasten unfasten tie untie zip unzip button "
    "unbutton raise lower lift adjust increase decrease reduce dim brighten mute unmute pause "
    "resume rewind skip change tune check inspect examine count measure weigh sort separate "
    "divide split join connect disconnect attach detach link assemble disassemble remove discard "
    "dispose trash recycle compost clear unload unpack pack untangle straighten fluff make set "
    "prepare finish complete do use call dial ring answer follow guard feed pet groom brush comb "
    "shave bathe shower dress undress wear paint draw write type print copy scan photograph "
    "record film post mail ship scoop ladle strain filter sift knock hit tap kick squash smash "
    "bend stretch scrape scrub sharpen repair mend sew knit weave trim mow rake dig plant prune "
    "harvest pick pump inflate deflate top refill replenish restock exchange swap trade borrow "
    "fetch try taste smell sniff touch feel see watch hear listen tell say ask explain describe "
    "teach learn show demonstrate repeat undo forget remember let have help work ensure verify "
    "confirm monitor avoid begin continue keep hold release grasp grip seize clutch clench drag "
    "tow haul transfer transport spill flush sanitize disinfect sterilize declutter rearrange "
    "organise reorganize decorate garnish drape stuff stream eject bookmark cancel schedule "
    "snooze program configure pair sync wake bang beat microwave nuke dehydrate ferment pickle "
    "blanch sear glaze frost ice sweeten dilute decant uncork uncap cap crumble shred portion "
    "plate bag box bottle can jar book table rotate spin swirl swing hoist vent air fan water "
    "iron steam press squeeze wring rub massage scratch seek choose select pick order buy pay "
    "open eat drink sip swallow lick chew bite cool hand want need like vacate evacuate turn wash "
    "blow douse quench kill snuff tighten loosen"
)

VERBS = (
    PLACING
    | PROCESSING
    | MOVING
    | FETCHING
    | TO_DATIVE
    | FOR_DATIVE
    | USING
    | OTHER_VERBS
    | word_set("look come go transfer change drag shift clean read")
) - word_set("using")

NOUNS = word_set(
    "water milk juice coffee tea beer wine soda cola coke drink beverage syrup sauce oil vinegar "
    "soup stew broth ramen noodle pasta rice bread toast sandwich pizza burger cake pie cookie "
    "biscuit muffin pancake waffle egg omelette bacon ham sausage meat beef pork chicken turkey "
    "fish steak cheese butter yogurt cream ice sugar salt pepper flour honey jam jelly chocolate "
    "candy snack chip cracker popcorn cereal oatmeal apple banana orange lemon lime grape peach "
    "pear plum berry strawberry melon pineapple mango tomato potato onion garlic carrot lettuce "
    "cabbage spinach broccoli pea bean corn mushroom cucumber celery avocado herb spice food meal "
    "breakfast lunch dinner supper dessert ingredient leftover grocery topping flavor flavour cup "
    "mug glass plate dish bowl pot pan kettle saucepan skillet wok lid jar bottle can tin pitcher "
    "jug carafe thermos tray basket box bin bucket pail bag sack package packet container carton "
    "crate case tube canister shaker fork knife spoon spatula ladle whisk tongs chopstick scoop "
    "peeler grater opener corkscrew strainer colander sieve funnel board mat coaster napkin towel "
    "cloth rag sponge brush broom mop duster vacuum cleaner dustpan soap detergent bleach shampoo "
    "toothbrush toothpaste tissue paper foil wrap utensil silverware cutlery crockery table desk "
    "counter countertop bench shelf rack cupboard cabinet drawer closet wardrobe dresser "
    "nightstand sideboard bookcase bookshelf chair armchair stool couch sofa loveseat settee "
    "ottoman bed mattress pillow cushion blanket sheet quilt duvet curtain blind rug carpet lamp "
    "light bulb lantern candle mirror picture painting frame clock vase flower plant pot bouquet "
    "fridge refrigerator freezer oven stove stovetop cooker hob burner microwave toaster kettle "
    "dishwasher sink faucet tap blender mixer processor grill fryer fan heater radiator "
    "conditioner thermostat washer dryer machine iron vacuum hoover tv television screen monitor "
    "remote controller control console xbox playstation computer laptop tablet phone telephone "
    "charger cable cord wire plug socket outlet switch button knob dial lever handle radio stereo "
    "speaker headphones camera battery channel volume movie film game cd dvd disc disk record song "
    "music show program book magazine newspaper letter envelope note pen pencil marker crayon "
    "eraser scissors tape glue stapler ruler notebook folder card calendar key keychain wallet "
    "purse backpack suitcase luggage umbrella coat jacket sweater shirt tshirt pants trousers "
    "jeans skirt dress sock shoe slipper boot sandal hat cap glove scarf belt tie clothes laundry "
    "hanger hamper hook toy doll ball puzzle block trash garbage rubbish waste recycling litter "
    "trashcan dustbin wastebasket debris crumb mess dust dirt stain spill kitchen bathroom "
    "bedroom livingroom room hall hallway corridor garage basement attic balcony porch patio "
    "garden yard lawn office study pantry laundry door doorway window wall floor ceiling stairs "
    "step roof corner edge middle center centre left right top bottom side front house home "
    "apartment place spot position area thing object item stuff one piece slice half quarter part "
    "rest bit portion serving bar loaf stick scoop spoonful teaspoon tablespoon drop splash pinch "
    "cube pack set pair stack pile heap row group bunch bundle load batch minute second hour "
    "moment degree percent temperature time dog cat pet puppy kitten bird person man woman child "
    "kid baby guest friend mom dad mother father brother sister grandma grandpa boy girl doctor "
    "neighbor neighbour robot tool hammer screwdriver wrench nail screw drill saw ladder rope "
    "string chain lock hinge medicine pill bandage alarm timer bell fire flame smoke steam heat "
    "heatpad pad pedestal stand holder tap furniture appliance decoration ornament shower bathtub "
    "tub toilet basin recipe surface space party guests sandwich piano guitar hook vase armrest "
    "cover bedsheet"
)

ADJECTIVES = word_set(
    "red blue green yellow white black brown grey gray orange pink purple silver golden gold "
    "beige turquoise violet maroon navy teal dark bright pale transparent clear colourful "
    "colorful big small large little tiny huge tall short long wide narrow thin thick medium "
    "giant mini round square rectangular oval flat deep shallow heavy light full empty clean "
    "dirty wet dry hot cold warm cool frozen fresh old new broken open closed shut locked "
    "unlocked wooden plastic metal metallic steel ceramic leather cotton woolen glassy shiny "
    "matte soft hard rough smooth sharp blunt spare extra other another different same next last "
    "first second third left right top bottom upper lower middle front rear inner outer near far "
    "nearest closest farthest biggest smallest largest tallest shortest leftmost rightmost "
    "remaining entire whole raw cooked ripe sweet salty spicy sour bitter boiled fried baked "
    "toasted roasted grilled chopped sliced peeled washed unwashed used unused hidden favorite "
    "favourite nice pretty ugly correct wrong main central own only bigger smaller larger taller "
    "shorter"
)

RESULTS = word_set(
    "open shut closed clean dry hot cold warm cool empty full ready wet lit locked unlocked "
    "upright straight flat crisp tidy dark bright soft boiled cooked melted done off on red green "
    "blue white black alone"
)
"""What an object may be made or left: ``leave the door open``."""

RESULTATIVES = word_set(
    "leave keep make get push pull wipe set slide pop hold swing prop rub have let turn paint "
    "cook wash sweep"
)

CAUSATIVES = word_set("let make have help watch see")
"""``let the water boil`` is about boiling the water."""

PARTS = word_set(
    "lid handle stripe pattern label dot flower spout cap top cover picture logo edge rim leg arm "
    "drawer door wheel button knob frame base shade corner hole crack stain"
)
"""``the box with the green lid``: a part tells which one."""

CONTROLS = word_set("button knob switch lever handle dial key")
"""Things that stay where they are: a place behind them says which one."""

TOOLS = word_set(
    "sponge towel cloth rag brush broom mop duster vacuum cleaner knife fork spoon spatula ladle "
    "whisk tongs chopstick scoop peeler grater opener corkscrew hand finger gripper arm key tool "
    "hammer screwdriver wrench scissors remote controller soap detergent napkin tissue glove "
    "strainer funnel cutter blender mixer tweezers stick tape lighter match"
)
"""``with`` one of these says what to do it with."""

PLACES = word_set(
    "table desk counter countertop bench shelf rack cupboard cabinet drawer closet wardrobe "
    "dresser nightstand sideboard bookcase bookshelf chair armchair stool couch sofa loveseat bed "
    "fridge refrigerator freezer oven stove stovetop burner microwave dishwasher sink tray basket "
    "box bin bucket trashcan dustbin kitchen bathroom bedroom room hall garage basement balcony "
    "floor wall corner pantry trash garbage mat pad"
)
"""Things that other things are put on or in."""

CONTAINERS = word_set(
    "cup mug glass plate dish bowl pot pan kettle jar bottle can tin pitcher jug tray basket box "
    "bin bucket bag sack package packet container carton crate case tube"
)
"""Nouns that measure what is in them: ``a bag of chips``."""

APPROACHES = word_set("door key lid way entrance window path gate answer solution guide side")
"""``the door to the kitchen``: ``to`` may belong to these."""

COMPOUNDS = frozenset(
    {
        ("washing", "machine"),
        ("living", "room"),
        ("dining", "room"),
        ("dining", "table"),
        ("cutting", "board"),
        ("frying", "pan"),
        ("ironing", "board"),
        ("baking", "tray"),
        ("baking", "sheet"),
        ("drying", "rack"),
        ("cooking", "pot"),
        ("mixing", "bowl"),
        ("serving", "bowl"),
        ("serving", "spoon"),
        ("measuring", "cup"),
        ("cooking", "oil"),
        ("lighting", "fixture"),
    }
)
"""Nouns that begin with what looks like a gerund."""
