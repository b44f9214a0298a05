"""Which particles go with which verbs of the household, as data."""

from __future__ import annotations

_TABLE = """
air: out
back: up
bag: up
beat: up
blow: out up
boil: down off up over
box: up
break: down up off
bring: in up down back over out along
buckle: up
button: up
call: up back
calm: down
cap: off
carry: in out up down over away
check: out over
chill: down
chop: up off
clean: up out off
clear: up off out away
close: up down off
collect: up
come: back in over out up down along
cook: up down
cool: down off
cover: up over
crank: up down
crush: up
cut: up off out down
deal: out
dim: down
dish: out up
divide: up
drain: off out
draw: up out
drink: up
drop: off in down
dry: off up out
dump: out
dust: off
eat: up
empty: out
even: out
feed: up
fill: up in out
find: out
finish: up off
fish: out
flatten: out down
flip: over on off up
fold: up down away
freshen: up
fry: up
gather: up
get: out up back down off
give: back out away up
go: back out in away up down over along on off
grind: up
hand: over out in back
hang: up out
heat: up
hide: away
hit: up
hold: up out on
hook: up
hurry: up
keep: on up away off out
kick: over out
knock: over down out
lay: down out
leave: out on off
let: out in down go
level: out off
lie: down
lift: up off out
light: up
line: up
lock: up down
log: in out on off
look: up over around out
loosen: up
mash: up
melt: down
mix: up in
mop: up
move: over up down away back aside in out
open: up
pack: up away
pass: over out around along back
peel: off back
pick: up out off
pile: up
place: down back
plug: in up
point: out
polish: up off
pop: in out up open
pour: out in off over
power: on off up down
press: down in
prop: up
pull: out up down off over back in
pump: up
push: in down up over back out away
put: on down away back out up together off
ring: up
rinse: out off
roll: up down out
round: up
run: out away back
scoop: up out
scrape: off out up
screw: on in off
scrub: off out down
send: back away off out
separate: out
serve: up out
set: up down out aside off
shake: out off up
shut: off down up
sit: down up
slice: up off
slide: over out in
slow: down
snap: on off
soak: up
sort: out
speed: up
spill: out
spread: out
squeeze: out
stack: up
stand: up
start: up over
stay: away back out
step: back aside away in out
stir: in up
stock: up
store: away up
stow: away
straighten: up out
strap: in down
stretch: out
strip: off
swap: out over
sweep: up out off away
switch: on off over out
take: out off away back up down along apart
tear: up off out down
throw: out away up back in
tidy: up away
tie: up down
tighten: up
tip: over out up
tone: down
top: up off
toss: out away
trim: off
try: on out
tuck: in away
turn: on off up down over around out
use: up
vacuum: up
wake: up
walk: away back around over
warm: up over
wash: up off out down
whip: up
wind: up down
wipe: up off down out
work: out
wrap: up
write: down up out
zip: up
"""

PARTICLES_OF = {
    verb: frozenset(particles.split())
    for verb, _, particles in (line.partition(": ") for line in _TABLE.strip().splitlines())
}
"""Particles that each verb takes; others are recognised by where they stand."""
