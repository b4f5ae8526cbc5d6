// The page in a browser: its questions go to the server it came from, its design lives in the address.
import { mount } from "./studio.js";
import { Channel } from "./channel.js";
import { unpacked } from "./design.js";

history.replaceState(null, "", location.pathname + location.hash); // the token is a cookie by now

const channel = new Channel(`ws://${location.host}/talk`);
const hello = await channel.opened;
const text = location.hash.slice(1), linked = await unpacked(text);
mount(document.getElementById("studio"), channel, hello, { linked, unread: Boolean(text && !linked), address: true });
