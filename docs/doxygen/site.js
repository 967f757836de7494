// The list of pages shows the page that is open; code can be copied; headings have links to themselves.
"use strict";
(function () {
  const page = location.pathname.split("/").pop() || "index.html";
  // Pages that the list leaves out stand below one that it has.
  const language = /^(python|fortran|rust)_(?!reference)/.exec(page);
  const listed = language ? language[1] + "_reference.html"
    : /_8h\.html$|^struct/.test(page) ? "c_reference.html" : page;
  for (const link of document.querySelectorAll(".pages a, .bar .first a")) {
    if (link.getAttribute("href") !== listed) continue;
    link.classList.add("here");
    const group = link.closest("details");
    if (group) {
      group.open = true;
      link.scrollIntoView({ block: "nearest" });
    }
  }
  if (!document.querySelector(".pages details[open]")) {
    const first = document.querySelector(".pages details");
    if (first) first.open = true;
  }
  // Doxygen makes a table of contents for pages only, not for headers.
  const members = [...document.querySelectorAll("h2.memtitle")];
  if (members.length > 2 && !document.querySelector("div.toc")) {
    const contents = document.createElement("div");
    contents.className = "toc";
    contents.append(document.createElement("ul"));
    for (const member of members) {
      const link = document.createElement("a");
      link.href = member.querySelector("a").getAttribute("href");
      link.textContent = member.textContent.replace(/^\W+|\(\)$/g, "");
      const entry = document.createElement("li");
      entry.append(link);
      contents.lastChild.append(entry);
    }
    document.querySelector(".contents").prepend(contents);
  }
  // The table of contents is beside the page where there is room; elsewhere it opens above the page.
  const contents = document.querySelector("div.toc");
  if (contents) {
    document.body.classList.add("has-contents");
    const folded = document.createElement("details"), title = document.createElement("summary");
    title.textContent = "On this page";
    folded.append(title, ...contents.querySelectorAll(":scope > ul"));
    contents.replaceChildren(folded);
    const hasRoom = matchMedia("(min-width: 84rem)"), fold = () => { folded.open = hasRoom.matches; };
    hasRoom.addEventListener("change", fold);
    fold();
  }

  // A command and its output: prompts are no part of what is copied.
  for (const block of document.querySelectorAll("div.fragment")) {
    const lines = [...block.querySelectorAll("div.line")];
    const commands = lines.filter((line) => line.textContent.startsWith("$ "));
    for (const line of commands) {
      const typed = document.createElement("span");
      typed.className = "typed";
      typed.textContent = line.textContent.slice(2);
      const prompt = document.createElement("span");
      prompt.className = "prompt";
      prompt.textContent = "$ ";
      line.replaceChildren(prompt, typed);
    }
    const button = document.createElement("button");
    button.className = "copy";
    button.textContent = "Copy";
    button.addEventListener("click", () => {
      const text = commands.length
        ? commands.map((line) => line.textContent.slice(2)) : lines.map((line) => line.textContent);
      navigator.clipboard.writeText(text.join("\n") + "\n");
      button.textContent = "Copied";
    });
    block.append(button);
  }

  for (const heading of document.querySelectorAll(".contents h1, .contents h2, .contents h3")) {
    const anchor = heading.querySelector("a.anchor[id]");
    if (!anchor) continue;
    const link = document.createElement("a");
    link.className = "link-here";
    link.href = "#" + anchor.id;
    link.textContent = "#";
    link.setAttribute("aria-label", "Link to this section");
    heading.append(link);
  }
})();
