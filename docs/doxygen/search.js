// The search: sections of which heading, title or text have all words, those with words in headings first.
"use strict";
(function () {
  const field = document.getElementById("search-words");
  const list = document.getElementById("search-results");
  const maxResults = 30;
  let chosen = -1;

  function load() {
    if (document.getElementById("search-index")) return;
    const script = document.createElement("script");
    script.id = "search-index";
    script.src = field.dataset.root + "search_index.js";
    script.onload = show;
    document.head.append(script);
  }

  function score(entry, words) {
    const [title, heading, , text] = entry.lower;
    let sum = 0;
    for (const word of words) {
      if (heading === word || heading === word + "()") sum += 60;
      else if (heading.startsWith(word)) sum += 30;
      else if (title.startsWith(word) && !heading) sum += 40;
      else if (heading.includes(word)) sum += 20;
      else if (title.includes(word)) sum += heading ? 6 : 15;
      else if (text.includes(word)) sum += 2;
      else return 0;
    }
    return /^(rust|fortran|python): /.test(title) ? sum / 2 : sum;
  }

  function excerpt(text, word) {
    const at = Math.max(0, text.toLowerCase().indexOf(word) - 40);
    return (at > 0 ? "…" : "") + text.slice(at, at + 130) + (text.length > at + 130 ? "…" : "");
  }

  function part(name, text) {
    const element = document.createElement(name);
    element.textContent = text;
    return element;
  }

  function show() {
    const words = field.value.toLowerCase().split(/\s+/).filter((word) => word.length > 0);
    chosen = -1;
    list.replaceChildren();
    list.hidden = words.length === 0;
    if (typeof pagesOfSite === "undefined" || words.length === 0) return;
    for (const entry of pagesOfSite) entry.lower = entry.lower || entry.map((one) => one.toLowerCase());
    const found = pagesOfSite.map((entry) => [score(entry, words), entry]).filter(([points]) => points > 0);
    found.sort((a, b) => b[0] - a[0]);
    for (const [, [title, heading, address, text]] of found.slice(0, maxResults)) {
      const link = document.createElement("a");
      link.href = field.dataset.root + address;
      link.append(part("strong", heading || title), part("span", heading ? title : ""),
        part("p", excerpt(text, words[0])));
      list.append(link);
    }
    if (found.length === 0) list.append(part("p", "Nothing found."));
  }

  function choose(step) {
    const links = list.querySelectorAll("a");
    if (links.length === 0) return;
    if (chosen >= 0) links[chosen].classList.remove("chosen");
    chosen = (chosen + step + links.length) % links.length;
    links[chosen].classList.add("chosen");
    links[chosen].scrollIntoView({ block: "nearest" });
  }

  field.addEventListener("focus", load);
  field.addEventListener("input", show);
  field.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown") choose(1);
    else if (event.key === "ArrowUp") choose(-1);
    else if (event.key === "Enter") (list.querySelectorAll("a")[Math.max(chosen, 0)] || field).click();
    else if (event.key === "Escape") list.hidden = true;
    else return;
    event.preventDefault();
  });
  document.addEventListener("click", (event) => {
    if (!event.target.closest(".search")) list.hidden = true;
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "/" && document.activeElement.tagName !== "INPUT") {
      event.preventDefault();
      field.focus();
    }
  });
})();
