// Where the parts of the examinee's page lie on each screen of a sitting, and whether its words can be read.

import assert from "node:assert/strict";

export const sizes = [{ width: 1280, height: 800 }, { width: 900, height: 700 }, { width: 390, height: 844 }];
const parts = ["#title", "#progress-bar", "#field", "#actions", "#actions button:first-child"];

/** Where the parts of the page lie, and whether any word is cut off. A title is as wide and high as its words. */
function measure(page) {
  return page.evaluate((selectors) => {
    const box = (selector) => {
      const found = document.querySelector(selector);
      if (!found) return null;
      const { x, y, width, height } = found.getBoundingClientRect();
      return selector === "#title" ? [x, y] : [x, y, width, height];
    };
    const words = document.getElementById("words");
    const cut = [...document.querySelectorAll("#words, button")].some((e) =>
      e.scrollHeight > e.clientHeight + 1 || e.scrollWidth > e.clientWidth + 1);
    const lowest = Math.max(...[...words.children].map((e) => e.getBoundingClientRect().bottom));
    const field = document.getElementById("field");
    const shown = getComputedStyle(field).visibility === "visible";
    const inColumn = words.getBoundingClientRect().right > field.getBoundingClientRect().left;
    return {
      boxes: Object.fromEntries(selectors.map((selector) => [selector, box(selector)])),
      cut,
      covered: shown && inColumn && lowest > field.getBoundingClientRect().top,
      wide: document.documentElement.scrollWidth > document.documentElement.clientWidth,
      below: document.querySelector("#actions").getBoundingClientRect().bottom > window.innerHeight,
      text: document.body.innerText,
    };
  }, parts);
}

/** Looks at every screen in every size, and goes back to the first. */
export class Look {
  seen = [];

  constructor(page, examinee) {
    this.page = page;
    this.examinee = examinee;
  }

  async at(name) {
    for (const size of [...sizes.slice(1), sizes[0]]) {
      await this.page.setViewportSize(size);
      this.seen.push({ name, width: size.width, ...await measure(this.page) });
      await this.examinee.picture(`layout-${size.width}-${name}`);
    }
  }
}

/** Title, progress, button and field lie where they lay on the first screen. */
export function checkPlaces(seen) {
  for (const { width } of sizes) {
    const screens = seen.filter((screen) => screen.width === width);
    for (const part of parts) {
      const first = screens.find((screen) => screen.boxes[part]);
      for (const screen of screens.filter((other) => other.boxes[part]))
        for (const [i, value] of screen.boxes[part].entries())
          assert.ok(Math.abs(value - first.boxes[part][i]) <= 1,
            `${width} pixels wide: ${part} lies at ${screen.boxes[part]} in ${screen.name}, at ${first.boxes[part]} in ${first.name}`);
    }
  }
}

/** No word is cut off, covered or outside the window. */
export function checkWords(seen) {
  for (const screen of seen) {
    const where = `${screen.name}, ${screen.width} pixels wide`;
    assert.ok(!screen.cut, `words are cut off: ${where}`);
    assert.ok(!screen.covered, `words lie on the field: ${where}`);
    assert.ok(!screen.wide, `wider than the window: ${where}`);
    assert.ok(!screen.below, `the button lies below the window: ${where}`);
  }
}
