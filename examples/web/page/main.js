// Copyright (C) 2026 The libgcv authors
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The page: its views, one of which is shown, and what is round the stage.

import { Answers } from "./answers.js";
import { listen } from "./gestures.js";
import { pressed } from "./keys.js";
import { Objects } from "./objects.js";
import { coloursOf, Pen } from "./pen.js";
import { sourcesOf } from "./reading.js";
import { Stage } from "./stage.js";
import { BlocksView } from "./views/blocks.js";
import { SheetView } from "./views/sheet.js";
import { SumView } from "./views/sum.js";

/** @template {Element} T @param {string} id @param {new () => T} Type @returns {T} */
function element(id, Type) {
  const found = document.getElementById(id);
  if (!(found instanceof Type)) {
    throw new Error(`${id} is not there`);
  }
  return found;
}

let colours = coloursOf();
export const stage = new Stage(element("stage", HTMLCanvasElement), (context) => {
  const pen = new Pen(context, stage, colours);
  if (stage.isSnapping) {
    pen.grid();
  }
  view.draw(pen);
  objects.place();
  frames.textContent = `${stage.frames} frames in the last second`;
  clearTimeout(idle);
  idle = window.setTimeout(() => (frames.textContent = ""), 1500);
});

let idle = 0;
const frames = element("frames", HTMLElement);
const live = element("live", HTMLElement);
const problem = element("problem", HTMLElement);
const list = element("facts", HTMLElement);

let saying = 0;
/** Says words to screen readers and below the stage, once nothing is said any more.
 * @param {string} words */
function say(words) {
  clearTimeout(saying);
  saying = window.setTimeout(() => (live.textContent = words), 150);
}

/** @type {import("./view.js").Page} */
const page = {
  stage,
  answers: new Answers(),
  say,
  isShown: (one) => one === view,
  report: (words) => {
    if (problem.textContent !== words) {
      problem.textContent = words;
    }
  },
  shapesChanged: () => {
    if (view.camera === null) {
      fit();
    }
    objects.update();
    if (view.isDragging) {
      objects.focus();
    }
  },
  answered: (milliseconds) => {
    window.dispatchEvent(new CustomEvent("answered", { detail: milliseconds }));
    if (!view.isDragging) {
      objects.update();
    }
  },
  facts: (facts) => {
    while (list.childElementCount > 2 * facts.length) {
      list.lastElementChild?.remove();
    }
    while (list.childElementCount < 2 * facts.length) {
      list.append(document.createElement("dt"), document.createElement("dd"));
    }
    facts.flat().forEach((words, k) => {
      const item = list.children[k];
      if (item.textContent !== words) {
        item.textContent = words;
      }
    });
  },
};

const views = /** @type {Record<string, import("./view.js").View>} */ ({
  sum: new SumView(page),
  sheet: new SheetView(page),
  blocks: new BlocksView(page),
});
let view = views["sum"];
const objects = new Objects(element("objects", HTMLElement), stage, () => view);
const tabs = Object.keys(views).map((name) => element(`tab-${name}`, HTMLButtonElement));

/** The view that is shown. */
export const shownView = () => view;

/** @param {string} name */
function show(name) {
  if (view !== views[name]) {
    view.camera = stage.camera;
    view = views[name];
    page.facts([]);
  }
  for (const tab of tabs) {
    const isChosen = tab.id === `tab-${name}`;
    tab.setAttribute("aria-selected", String(isChosen));
    tab.tabIndex = isChosen ? 0 : -1;
    element(tab.id.replace("tab", "panel"), HTMLElement).hidden = !isChosen;
  }
  element("vertices", HTMLElement).hidden = !view.hasVertices;
  clearTimeout(saying);
  live.textContent = "";
  if (view.camera === null) {
    fit();
  } else {
    stage.camera = view.camera;
  }
  objects.update();
  view.changed();
}

function fit() {
  stage.fit(view.box());
  view.camera = stage.camera;
}

tabs.forEach((tab, k) => {
  tab.addEventListener("click", () => show(tab.id.replace("tab-", "")));
  tab.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (step !== undefined) {
      event.preventDefault();
      const next = tabs[(k + step + tabs.length) % tabs.length];
      next.click();
      next.focus();
    }
  });
});

/** @param {string} id @param {() => void} act */
const on = (id, act) => element(id, HTMLButtonElement).addEventListener("click", act);
on("fit", fit);
on("closer", () => stage.zoom(1.25));
on("further", () => stage.zoom(0.8));
on("add-vertex", () => view.addCorner());
on("remove-vertex", () => view.removeCorner());
on("paste", () =>
  navigator.clipboard.readText().then(
    (text) => take([text], null),
    () => page.report("The clipboard cannot be read. Press Ctrl+V instead."),
  ),
);
const snap = element("snap", HTMLInputElement);
snap.addEventListener("change", () => {
  stage.isSnapping = snap.checked;
  stage.redraw();
});
const help = element("help", HTMLDetailsElement);
help.addEventListener("toggle", () => help.open && help.scrollIntoView({ block: "start" }));
const file = element("file", HTMLInputElement);
on("open", () => file.click());
file.addEventListener("change", async () => {
  await takeFiles(file.files);
  file.value = "";
});

/** The polygons of texts, all of them or none. @param {string[]} texts
 * @param {import("./shapes.js").Point | null} point */
async function take(texts, point) {
  try {
    const { answer } = await page.answers.ask("read", texts.flatMap(sourcesOf));
    view.take(answer, point);
    fit();
    page.report("");
    page.say(`Read ${answer.length === 1 ? "one polygon" : `${answer.length} polygons`}.`);
  } catch (error) {
    page.report(/** @type {Error} */ (error).message);
  }
}

/** @param {FileList | null | undefined} list @param {import("./shapes.js").Point | null} point */
async function takeFiles(list, point = null) {
  if (list && list.length > 0) {
    await take(await Promise.all(Array.from(list, (one) => one.text())), point);
  }
}

listen(stage, () => view);
stage.onResize = fit;

window.addEventListener("dragover", (event) => {
  event.preventDefault();
  document.body.classList.add("dropping");
});
window.addEventListener("dragleave", (event) => {
  if (event.relatedTarget === null) {
    document.body.classList.remove("dropping");
  }
});
window.addEventListener("drop", (event) => {
  event.preventDefault();
  document.body.classList.remove("dropping");
  const point = stage.pointOf(event);
  const { files = null } = event.dataTransfer ?? {};
  if (files !== null && files.length > 0) {
    void takeFiles(files, point);
  } else {
    void take([event.dataTransfer?.getData("text/plain") ?? ""], point);
  }
});
window.addEventListener("paste", (event) => {
  const { files = null } = event.clipboardData ?? {};
  void (files !== null && files.length > 0
    ? takeFiles(files)
    : take([event.clipboardData?.getData("text/plain") ?? ""], null));
});

window.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) {
    return;
  }
  if (objects.hasFocus && pressed(view, event)) {
    event.preventDefault();
    return;
  }
  if (event.target instanceof HTMLSelectElement) {
    return;
  }
  const acts = /** @type {Record<string, () => void>} */ ({
    1: () => show("sum"),
    2: () => show("sheet"),
    3: () => show("blocks"),
    f: fit,
    "+": () => stage.zoom(1.25),
    "-": () => stage.zoom(0.8),
    g: () => snap.click(),
    "?": () => (help.open = !help.open),
  });
  acts[event.key]?.();
});

const isDark = matchMedia("(prefers-color-scheme: dark)");
isDark.addEventListener("change", () => {
  colours = coloursOf();
  stage.redraw();
});

show("sum");
