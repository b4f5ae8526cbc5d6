// The page in a browser: its questions go to the server it came from, its design lives in the address.
const KEY = "elastica-key"; // of this tab, so that it can be loaded again

function kept(key) {
  try {
    if (key) sessionStorage.setItem(KEY, key);
    return sessionStorage.getItem(KEY);
  } catch { return key; }
}

// The key of the address is taken out of it at once. Without a design beside it, the design `before` stays.
function takeKey(before = "") {
  const [, key, design = before] = location.hash.match(/^#key=([^#]*)(#.+)?$/) ?? [];
  if (key !== undefined) history.replaceState(null, "", location.pathname + design);
  return kept(key);
}

const key = takeKey();
addEventListener("hashchange", ({ oldURL }) => { // another address was typed in this tab
  takeKey(new URL(oldURL).hash);
  location.reload();
});

const hello = key && await enter(key);
if (!hello) document.getElementById("shut").hidden = false;

async function enter(key) {
  const [{ mount }, { Channel }, { unpacked }] = await Promise.all(["./studio.js", "./channel.js", "./design.js"].map((name) => import(name)));
  const channel = new Channel(`ws://${location.host}/talk`, key), hello = await channel.opened;
  const text = location.hash.slice(1), linked = await unpacked(text);
  if (hello) mount(document.getElementById("studio"), channel, hello, { linked, unread: Boolean(text && !linked), address: true });
  return hello;
}
