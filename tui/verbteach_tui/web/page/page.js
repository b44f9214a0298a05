// Runs before the terminal: says where its other end is, whatever name or proxy led here.
"use strict";
const socket = new URL("ws", document.baseURI);
socket.protocol = socket.protocol.replace("http", "ws");
document.getElementById("terminal").dataset.sessionWebsocketUrl = socket.href;
document.getElementById("again").addEventListener("click", () => window.location.reload());
new MutationObserver(() => {
  if (document.body.classList.contains("-closed")) document.getElementById("again").focus();
}).observe(document.body, { attributes: true, attributeFilter: ["class"] });
