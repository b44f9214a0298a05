// Runs before the terminal: says where its other end is, whatever name or proxy led here, and
// how large its letters are: in a narrow window smaller ones, so that the smallest layout fits.
"use strict";
const COLUMNS = 60, LETTER = 0.6, SMALLEST = 7; // a letter's width is that much of its size
const socket = new URL("ws", document.baseURI);
socket.protocol = socket.protocol.replace("http", "ws");
const { dataset } = document.getElementById("terminal");
dataset.sessionWebsocketUrl = socket.href;
const fitting = Math.max(window.innerWidth / (COLUMNS * LETTER), SMALLEST);
dataset.fontSize = Math.min(dataset.fontSize, fitting);
document.getElementById("again").addEventListener("click", () => window.location.reload());
// Keys go to the terminal without a click first, and to the button once there is only that.
const focus = (found) => found && found.focus();
new MutationObserver(() => {
  const { classList } = document.body;
  if (classList.contains("-closed")) focus(document.getElementById("again"));
  else if (classList.contains("-first-byte")) focus(document.querySelector(".xterm-helper-textarea"));
}).observe(document.body, { attributes: true, attributeFilter: ["class"] });
