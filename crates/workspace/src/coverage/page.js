// n and p go to the next and the previous place where something is missing.
document.addEventListener("keydown", event => {
  if (event.ctrlKey || event.metaKey || event.altKey || !["n", "p"].includes(event.key)) return;
  const gaps = [...document.querySelectorAll("[data-gap]")];
  const here = gaps.findIndex(gap => "#" + gap.id === location.hash);
  const next = event.key === "n" ? here + 1 : here < 0 ? gaps.length - 1 : here - 1;
  if (gaps[next]) {
    location.hash = gaps[next].id;
    gaps[next].querySelector("a").focus({ preventScroll: true });
  }
});
