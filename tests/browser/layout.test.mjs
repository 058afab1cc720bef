import assert from "node:assert/strict";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

import { Examinee, launchBrowser, Program } from "./driver.mjs";

const protocol = join(dirname(fileURLToPath(import.meta.url)), "short.toml");
const folder = mkdtempSync(join(tmpdir(), "palpate-layout-"));
const sizes = [{ width: 1280, height: 800 }, { width: 900, height: 700 }, { width: 390, height: 844 }];
const parts = ["#title", "#progress-bar", "#field", "#actions", "#actions button:first-child"];
let browser;

before(async () => { browser = await launchBrowser(); });
after(async () => {
  Program.endAll();
  await browser.close();
});

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
class Look {
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

/** The sitting from its first screen to its last; every kind of screen is looked at. */
async function sit(page, examinee, look) {
  await examinee.sees("welcome");
  await look.at("01-welcome");
  await page.keyboard.press("Space");
  await examinee.sees("gesture");
  await examinee.press(6, () => look.at("02-gesture"));
  await page.keyboard.press("Space");
  await examinee.sees("ready");
  await look.at("03-ready");
  await page.keyboard.press("Space");
  await examinee.sees("interval");
  await look.at("04-first-turn");
  await examinee.press(1);
  await examinee.press(1);
  await examinee.sees("again");
  await look.at("05-again");
  await page.keyboard.press("Space");
  await examinee.oneInterval();
  await examinee.sees("pause");
  await look.at("06-pause");
  await examinee.sees("interval");
  await examinee.press(6, () => look.at("07-second-turn"));
  await examinee.oneInterval();
  for (let trial = 1; trial <= 4; ++trial) {
    await examinee.question();
    if (trial === 1) await look.at("08-question");
    await page.keyboard.press("1");
    await page.waitForFunction(() => document.body.dataset.phase !== "question");
    if (trial === 4) break;
    if (trial === 1) await look.at("09-ready-again");
    await page.keyboard.press("Space");
    await examinee.bothIntervals();
  }
  await examinee.sees("thanks");
  await look.at("10-thanks");
  await page.click('button[data-does="strategy"]');
  await examinee.sees("end");
  await look.at("11-end");
}

test("title, progress, button and field keep their places over a whole sitting", async () => {
  const program = await Program.start(protocol, "--study", join(folder, "still.db"), "--examinee", "P01");
  const page = await browser.newPage({ viewport: sizes[0] });
  await page.goto(program.link);
  const examinee = new Examinee(page);
  const look = new Look(page, examinee);
  await sit(page, examinee, look);
  for (const { width } of sizes) {
    const screens = look.seen.filter((screen) => screen.width === width);
    assert.equal(screens.length, 11);
    for (const part of parts) {
      const first = screens.find((screen) => screen.boxes[part]);
      for (const screen of screens.filter((other) => other.boxes[part]))
        for (const [i, value] of screen.boxes[part].entries())
          assert.ok(Math.abs(value - first.boxes[part][i]) <= 1,
            `${width} pixels wide: ${part} lies at ${screen.boxes[part]} in ${screen.name}, at ${first.boxes[part]} in ${first.name}`);
    }
  }
  for (const screen of look.seen) {
    const where = `${screen.name}, ${screen.width} pixels wide`;
    assert.ok(!screen.cut, `words are cut off: ${where}`);
    assert.ok(!screen.covered, `words lie on the field: ${where}`);
    assert.ok(!screen.wide, `wider than the window: ${where}`);
    assert.ok(!screen.below, `the button lies below the window: ${where}`);
  }
});

test("who skips the welcome knows what an interval is", async () => {
  const program = await Program.start(protocol, "--study", join(folder, "words.db"), "--examinee", "P02");
  const page = await browser.newPage({ viewport: sizes[0] });
  await page.goto(program.link);
  const examinee = new Examinee(page);
  const said = {};
  const look = { at: async (name) => { said[name] = await page.evaluate(() => document.body.innerText); } };
  await sit(page, examinee, look);
  const question = "In which interval did it feel harder?";
  for (const [name, words] of Object.entries(said))
    assert.doesNotMatch(words.replaceAll(question, "").replaceAll(/turn\s+\(?interval \d/g, "turn"), /interval/i, name);
  assert.match(said["04-first-turn"], /First turn \(interval 1\)/);
  assert.match(said["07-second-turn"], /Second turn \(interval 2\)/);
  assert.match(said["08-question"], /First turn\s+interval 1[^]*Second turn\s+interval 2/);
});
