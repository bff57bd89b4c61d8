// Players are set up when they come into sight.

async function open(root) {
  try {
    const { got, expected } = root.dataset;
    root.player = new Player(root, await Film.open(got), expected ? await Film.open(expected) : undefined);
  } catch (error) {
    root.textContent = `This film cannot be shown here: ${error.message}`;
    root.classList.add("broken");
    throw error;
  }
}

const watcher = new IntersectionObserver((entries) => {
  for (const entry of entries.filter((one) => one.isIntersecting)) {
    watcher.unobserve(entry.target);
    open(entry.target);
  }
}, { rootMargin: "200px" });
document.querySelectorAll(".player").forEach((root) => watcher.observe(root));

// Where the player has the page to itself, keys are meant for it wherever the focus is.
if (document.body.classList.contains("alone")) document.addEventListener("keydown", (event) => {
  if (event.target === document.body) document.querySelector(".player").player?.key(event);
});
