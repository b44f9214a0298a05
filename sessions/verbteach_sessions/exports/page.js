"use strict";
// All that comes from a record gets into the page as text, never as markup.
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const turns = data.turns;
  const items = Array.from(document.querySelectorAll("#dialogue li"));
  const slider = document.getElementById("slider");
  const where = document.getElementById("where");
  const mind = document.getElementById("mind");
  const room = document.getElementById("sight");

  const make = (tag, text, kind) => {
    const node = document.createElement(tag);
    if (text !== undefined) node.textContent = text;
    if (kind) node.className = kind;
    return node;
  };

  const thing = (one) => {
    const item = make("li");
    if (one.relation) item.append(make("small", one.relation));
    item.append(make("span", one.label));
    for (const condition of one.conditions) item.append(make("span", condition, "tag"));
    if (one.contents.length) item.append(list(one.contents));
    return item;
  };

  const list = (things, kind) => {
    const node = make("ul", undefined, kind);
    for (const one of things) node.append(thing(one));
    return node;
  };

  const bar = (name, share, told, chosen) => {
    const node = make("div", undefined, chosen ? "bar chosen" : "bar");
    const fill = make("i");
    fill.style.width = `${Math.max(0, Math.min(1, share)) * 100}%`;
    node.append(fill, make("span", name), make("span", told));
    return node;
  };

  const percent = (share) => `${Math.round(share * 100)} %`;

  const bars = (pairs) => pairs.map(([name, share]) => bar(name, share, percent(share)));

  const section = (panel, title, nodes) => {
    if (nodes.length) panel.append(make("h2", title), ...nodes);
  };

  const sight = (seen) => {
    const nodes = [];
    for (const actor of seen.actors) {
      const near = actor.near.length ? ` is near ${actor.near.join(", ")}` : "";
      if (near || actor.holds.length) nodes.push(make("p", actor.label + near));
      if (actor.holds.length) nodes.push(make("h3", `${actor.label} holds`), list(actor.holds));
    }
    if (seen.places.length) nodes.push(list(seen.places, "place"));
    if (seen.others.length) {
      nodes.push(make("h3", "Also in the room"), list(seen.others, "place"));
    }
    return nodes;
  };

  const choice = (one) => {
    const values = one.candidates.map((row) => row[1]).filter((q) => q !== null);
    const low = Math.min(0, ...values);
    const high = Math.max(low + 1e-9, ...values);
    const rows = one.candidates.map(([name, q, chosen]) => {
      const share = q === null ? (chosen ? 1 : 0) : (q - low) / (high - low);
      const told = q === null ? (chosen ? "chosen" : "") : `Q ${q.toFixed(2)}`;
      return bar(chosen ? `› ${name}` : name, share, told, chosen);
    });
    if (one.more) rows.push(make("p", `and ${one.more} more`, "quiet"));
    if (one.reason) rows.push(make("p", one.reason, "quiet"));
    return rows;
  };

  // A teacher's turn shows what the robot had in mind when it last spoke.
  const thinking = (number) => {
    for (let index = number; index >= 0; index -= 1) {
      if (items[index].classList.contains("robot")) return turns[index];
    }
    return turns[number];
  };

  const show = (number, scroll) => {
    const turn = turns[number];
    const said = thinking(number);
    slider.value = String(number);
    where.textContent = `turn ${number} of ${turns.length - 1}, ${turn.at} s`;
    items.forEach((item, index) => {
      item.classList.toggle("now", index === number);
      item.classList.toggle("later", index > number);
    });
    if (scroll) items[number].scrollIntoView({ block: "nearest" });
    room.replaceChildren();
    mind.replaceChildren();
    if (turn.sight === null) {
      section(room, "The scene", [make("p", "Not known at this turn.", "quiet")]);
    } else {
      const seen = data.sights[turn.sight];
      section(room, seen.title, sight(seen));
    }
    const phrases = said.phrases.flatMap((one) => [make("h3", one.name), ...bars(one.bars)]);
    section(mind, "What the words may mean", phrases);
    section(mind, "Goals it thinks may be meant", bars(said.goals));
    const unsure = bars(said.uncertain);
    if (said.unlisted) unsure.push(make("p", `and ${said.unlisted} more`, "quiet"));
    section(mind, "What it is not sure to see", unsure);
    section(mind, "What it weighed", said.choices.flatMap(choice));
    section(mind, "Verbs learned", said.verbs.length ? [make("p", said.verbs.join(", "))] : []);
    if (!mind.childNodes.length) {
      section(mind, "The robot's mind", [make("p", "Nothing to show at this turn.", "quiet")]);
    }
  };

  const step = (by) => {
    const number = Number(slider.value) + by;
    if (number >= 0 && number < turns.length) show(number, true);
  };

  slider.addEventListener("input", () => show(Number(slider.value), true));
  document.getElementById("back").addEventListener("click", () => step(-1));
  document.getElementById("on").addEventListener("click", () => step(1));
  items.forEach((item, index) => item.addEventListener("click", () => show(index, false)));
  document.addEventListener("keydown", (event) => {
    if (event.target === slider || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "ArrowLeft") step(-1);
    if (event.key === "ArrowRight") step(1);
  });
  document.getElementById("controls").hidden = false;
  const asked = Number(location.hash.slice(1));
  show(Number.isInteger(asked) && asked > 0 && asked < turns.length ? asked : 0, asked > 0);
})();
