// The gallery: cards that a search filters, and a stage on which the chosen scene is played.

const search = document.querySelector(".search"), none = document.querySelector(".none");
const cards = [...document.querySelectorAll(".card")], sections = [...document.querySelectorAll("main section")];
const stage = document.querySelector(".stage"), slot = stage.querySelector(".slot");
let player, opened = 0;

function filter() {
  const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  for (const card of cards) card.hidden = !words.every((word) => card.dataset.words.includes(word));
  for (const section of sections) section.hidden = !section.querySelector(".card:not([hidden])");
  for (const chip of document.querySelectorAll(".themes a")) {
    chip.hidden = document.getElementById(chip.hash.slice(1)).hidden;
  }
  none.hidden = sections.some((section) => !section.hidden);
}

/** Only the film that is on the stage is unpacked. */
async function show(card) {
  const turn = ++opened;
  leave();
  stage.querySelector("h2").textContent = card.querySelector("h3").textContent;
  stage.querySelector(".about").textContent = card.querySelector(".about").textContent;
  stage.querySelector("code").textContent = card.dataset.command;
  if (!stage.open) stage.showModal();
  const root = make("div", "player", slot);
  try {
    const film = await Film.open(card.dataset.film);
    if (turn !== opened) return;
    player = new Player(root, film);
    root.focus({ preventScroll: true });
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) player.toggle();
  } catch (error) {
    root.textContent = `This film cannot be shown here: ${error.message}`;
    root.classList.add("broken");
    throw error;
  }
}

function leave() {
  if (player) player.playing = false;
  player = undefined;
  slot.textContent = "";
}

/** The card after the one on the stage among those that the search shows, or before it. */
function turnTo(way) {
  const shown = cards.filter((card) => !card.hidden), at = shown.findIndex((card) => card.hash === location.hash);
  if (shown.length) location.hash = shown[(at + way + shown.length) % shown.length].hash;
}

function follow() {
  const card = cards.find((one) => one.hash === location.hash);
  if (card) show(card);
  else if (stage.open) stage.close();
}

search.addEventListener("input", filter);
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (stage.open && ["PageUp", "PageDown"].includes(event.key)) {
    event.preventDefault();
    turnTo(event.key === "PageUp" ? -1 : 1);
  } else if (!stage.open && event.target !== search && /^[\p{L}\p{N}]$|^\/$/u.test(event.key)) {
    search.focus(); // what is typed goes into the search, but for the slash that only asks for it
    if (event.key === "/") event.preventDefault();
  } else if (event.target === search && event.key === "Escape") {
    search.value = "";
    filter();
  }
});
stage.querySelector(".back").addEventListener("click", () => turnTo(-1));
stage.querySelector(".on").addEventListener("click", () => turnTo(1));
stage.querySelector(".close").addEventListener("click", () => stage.close());
stage.addEventListener("click", (event) => event.target === stage && stage.close());
stage.addEventListener("close", () => {
  opened++;
  leave();
  if (cards.some((card) => card.hash === location.hash)) history.replaceState(null, "", location.pathname + location.search);
});
addEventListener("hashchange", follow);
filter();
follow();
