// A study that says after each answer whether it was right.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

import { Examinee, launchBrowser, Program, run, Traffic } from "./driver.mjs";
import { checkPlaces, checkWords, Look, sizes } from "./look.mjs";

const protocol = join(dirname(fileURLToPath(import.meta.url)), "feedback.toml");
const folder = mkdtempSync(join(tmpdir(), "palpate-feedback-"));
const kLasts = 3000;  // trials/protocol/protocol.hpp, kFeedbackTime [ms]
let browser;

before(async () => { browser = await launchBrowser(); });
after(async () => {
  Program.endAll();
  await browser.close();
});

/** Notes in the page itself when each phase is shown and what a screen reader is told, for a test comes too late. */
function noteShowings(page) {
  return page.addInitScript(() => {
    window.showings = [];
    document.addEventListener("DOMContentLoaded", () => {
      new MutationObserver(() => queueMicrotask(() => window.showings.push({
        at: performance.now(), phase: document.body.dataset.phase,
        words: document.getElementById("words").innerText, live: document.getElementById("live").textContent,
        progress: document.getElementById("progress-text").textContent,
      }))).observe(document.body, { attributes: true, attributeFilter: ["data-showing"] });
    });
  });
}

async function answerBoth(examinee, look, key) {
  await examinee.page.keyboard.press("Space");
  await examinee.bothIntervals();
  await examinee.question();
  await look.at(`f-question-${key}`);
  await examinee.page.keyboard.press(key);
  await examinee.sees("feedback");
}

async function trialsOf(study) {
  const out = join(folder, "export");
  const { code, err } = await run("export", study, "--as", "json", "--out", out);
  assert.equal(code, 0, err);
  return JSON.parse(readFileSync(join(out, "study.json"), "utf8")).trials.rows;
}

/** The page and a screen reader say of an answer what the study file says. */
function checkShowing(showing, trial, number) {
  const [turn, right] = [["first", "second"][Number(trial.correct_answer) - 1], Number(trial.correct) === 1];
  const title = right ? "That was right." : "That was not right.";
  assert.equal(showing.words.trim().replace(/\s+/g, " "), `${title} It was the ${turn} turn.`);
  assert.equal(showing.live, `${title} It was the ${turn} turn.`);
  assert.equal(showing.progress, `Question ${number} of 2`);
}

test("it is said calmly, for the same time, and of the answer that is stored", async () => {
  const study = join(folder, "study.db");
  const program = await Program.start(protocol, "--study", study, "--examinee", "P01");
  const page = await browser.newPage({ viewport: sizes[0] });
  const traffic = new Traffic();
  traffic.watch(page);
  await noteShowings(page);
  await page.goto(program.link);
  const examinee = new Examinee(page), look = new Look(page, examinee);
  await examinee.sees("welcome");
  assert.match(await page.textContent("main"), /Each time you are told whether you were right/);
  await look.at("f-welcome");
  await page.keyboard.press("Space");
  await examinee.sees("gesture");
  await page.keyboard.press("Space");
  await examinee.sees("ready");
  await look.at("f-ready");
  await answerBoth(examinee, look, "1");
  await page.keyboard.press("Space");  // neither a key nor a click ends it
  await page.keyboard.press("2");
  await look.at("f-feedback");
  await examinee.sees("ready");
  assert.match(await page.textContent("#text"), /Your answer is saved\./);
  await look.at("f-ready-again");
  await answerBoth(examinee, look, "2");
  await examinee.sees("thanks");
  await look.at("f-thanks");
  const showings = await page.evaluate(() => window.showings);
  await page.click('button[data-does="strategy"]');
  assert.equal((await program.ended).code, 0, program.err);

  checkPlaces(look.seen);
  checkWords(look.seen);
  const trials = await trialsOf(study);
  const told = showings.map((showing, i) => ({ ...showing, lasted: showings[i + 1]?.at - showing.at }))
    .filter(({ phase }) => phase === "feedback");
  assert.equal(told.length, 2);
  for (const [i, showing] of told.entries()) {
    checkShowing(showing, trials[i], i + 1);
    assert.ok(Math.abs(showing.lasted - kLasts) < 500, `${showing.lasted} ms`);
  }
  const answers = traffic.sent.filter((text) => text.includes('"answer"'));
  assert.equal(answers.length, 2, "a key during feedback is no answer");
  const messages = traffic.texts.map((text) => JSON.parse(text));
  for (const message of messages) assert.equal("feedback" in message, message.phase === "feedback");
});

test("a page that comes back is not told again", async () => {
  const program = await Program.start(protocol, "--study", join(folder, "again.db"), "--examinee", "P02");
  const page = await browser.newPage({ viewport: sizes[0] });
  await page.goto(program.link);
  const examinee = new Examinee(page), nowhere = { at: async () => {} };
  for (const phase of ["welcome", "gesture"]) {
    await examinee.sees(phase);
    await page.keyboard.press("Space");
  }
  await examinee.sees("ready");
  await answerBoth(examinee, nowhere, "1");
  const traffic = new Traffic();
  traffic.watch(page);
  await page.reload();
  await examinee.sees("ready");
  assert.match(await page.textContent("#text"), /Your answer is saved\./);
  await page.waitForTimeout(kLasts + 500);
  assert.ok(traffic.texts.length > 0);
  for (const text of traffic.texts) assert.ok(!("feedback" in JSON.parse(text)), text);
  await program.signal("SIGINT");
});
