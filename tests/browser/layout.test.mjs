import assert from "node:assert/strict";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

import { Examinee, launchBrowser, Program } from "./driver.mjs";
import { checkPlaces, checkWords, Look, sizes } from "./look.mjs";

const protocol = join(dirname(fileURLToPath(import.meta.url)), "short.toml");
const folder = mkdtempSync(join(tmpdir(), "palpate-layout-"));
let browser;

before(async () => { browser = await launchBrowser(); });
after(async () => {
  Program.endAll();
  await browser.close();
});

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
  assert.equal(look.seen.length, 11 * sizes.length);
  checkPlaces(look.seen);
  checkWords(look.seen);
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
