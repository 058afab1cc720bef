import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync } from "node:fs";
import http from "node:http";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

import { Examinee, launchBrowser, Program, run, Traffic } from "./driver.mjs";

const protocol = join(dirname(fileURLToPath(import.meta.url)), "short.toml");
const folder = mkdtempSync(join(tmpdir(), "palpate-browser-"));
let browser;

before(async () => { browser = await launchBrowser(); });
after(async () => {
  Program.endAll();
  await browser.close();
});

function begin(study, ...words) {
  return Program.start(protocol, "--study", join(folder, study), ...words);
}

async function openPage(link, traffic, viewport = { width: 1280, height: 800 }) {
  const page = await browser.newPage({ viewport });
  traffic?.watch(page);
  page.on("pageerror", (error) => { throw error; });
  await page.goto(link);
  return page;
}

/** The status of a raw request, sent just so. */
function status(link, { path, headers = {}, method = "GET" } = {}) {
  const url = new URL(link);
  return new Promise((resolve, reject) => {
    const request = http.request({ host: "127.0.0.1", port: url.port, path: path ?? url.pathname, method, headers });
    request.on("response", (response) => { response.resume(); resolve(response.statusCode); });
    request.on("upgrade", (response, socket) => { socket.destroy(); resolve(response.statusCode); });
    request.on("error", reject);
    request.end();
  });
}

/** From the examinee's first page to the first trial. */
async function arrive(examinee) {
  await examinee.sees("welcome");
  await examinee.page.keyboard.press("Space");
  await examinee.sees("gesture");
  await examinee.page.keyboard.press("Space");
  await examinee.sees("ready");
}

test("a whole session, with the program killed in the middle", async () => {
  const traffic = new Traffic();
  const words = ["--examinee", "P01"];
  let program = await begin("whole.db", ...words);
  let page = await openPage(program.link, traffic);
  let examinee = new Examinee(page);

  await examinee.sees("welcome");
  await examinee.picture("01-welcome");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await examinee.sees("gesture");
  const seen = traffic.binaries.length, since = Date.now();
  await examinee.press(9, async () => {
    await page.waitForTimeout(2000);
    await examinee.picture("02-gesture-pressed");
  });
  const frames = traffic.binaries.slice(seen).filter(({ bytes }) => bytes[0] === 3);
  const rate = frames.length * 1000 / (Date.now() - since);
  console.log(`frames of the organs at 640x480: ${rate.toFixed(1)} a second`);
  assert.ok(rate > 3, "pictures come");  // 30 and more on a machine that has nothing else to do
  assert.ok(frames.every(({ bytes }) => bytes[1] === 0xff && bytes[2] === 0xd8), "frames are JPEG");
  await examinee.picture("03-gesture");
  await page.keyboard.press("Space");
  await examinee.sees("ready");
  await examinee.picture("04-ready");

  // Trial 1: an early key, and a key that is held into the question.
  await page.keyboard.press("Space");
  await examinee.sees("interval");
  await page.keyboard.press("1");
  await examinee.press(9, () => examinee.picture("05-interval"));
  await examinee.press(9);
  await examinee.sees("pause");
  await examinee.picture("06-pause");
  await examinee.sees("interval");
  await page.keyboard.down("2");
  await examinee.oneInterval();
  await examinee.question();
  await examinee.picture("07-question");
  for (let k = 0; k < 5; ++k) await page.keyboard.down("2");  // repeats of a key that was down before
  await page.waitForTimeout(300);
  assert.equal(await page.getAttribute("body", "data-phase"), "question", "a held key is no answer");
  await page.keyboard.up("2");
  await page.keyboard.press("1");
  await examinee.sees("ready");
  assert.equal(traffic.sent.filter((text) => text.includes('"answer"')).length, 1);
  assert.equal(traffic.sent.filter((text) => text.includes('"early"')).length, 2);

  // Trial 2: a press that is too shallow is shown again, calmly; the answer by a button.
  await page.keyboard.press("Space");
  await examinee.sees("interval");
  await examinee.press(1);
  await examinee.press(1);
  await examinee.sees("again");
  await examinee.picture("08-again");
  await page.keyboard.press("Space");
  await examinee.sees("interval");
  await examinee.press(11);
  await page.keyboard.press("Space");  // felt enough
  await examinee.sees("pause");
  await examinee.oneInterval();
  await examinee.question();
  await page.click('button[data-choice="2"]');
  await examinee.sees("ready");

  // Trial 3: killed while the finger presses.
  await page.keyboard.press("Space");
  await examinee.sees("interval");
  await examinee.moveTo(-2);
  await examinee.moveTo(9);
  assert.equal((await program.signal("SIGKILL")).signal, "SIGKILL");
  await examinee.sees("apart");
  await examinee.picture("09-connection-lost");
  await page.setViewportSize({ width: 1024, height: 640 });
  const { link } = program;
  program = await begin("whole.db", ...words);
  assert.match(program.err, /P01 has an unfinished session: it goes on, 2 of 4 questions are answered/);
  assert.equal(program.link, link, "a sitting keeps its link");
  await examinee.sees("welcome");  // by itself
  await examinee.picture("10-welcome-back-small-screen");
  await arrive(examinee);
  for (const key of ["ArrowLeft", "ArrowRight"]) {
    await page.keyboard.press("Space");
    await examinee.bothIntervals();
    await examinee.question();
    await examinee.picture(`11-question-small-screen`);
    await page.keyboard.press(key);
    await page.waitForFunction(() => document.body.dataset.phase !== "question");
  }
  await examinee.sees("thanks");
  await page.fill("#strategy", "How far the pointer stayed behind.");
  await examinee.picture("12-thanks");
  await page.click('button[data-does="strategy"]');
  await examinee.sees("end");
  await examinee.picture("13-end");
  const { code } = await program.ended;
  assert.equal(code, 0, program.err);
  assert.match(program.out, /P01: 4 of 4 questions answered/);
  const receipt = /receipt (\S+)/.exec(program.out)[1];

  const verified = await run("verify", join(folder, "whole.db"), "--receipt", receipt);
  assert.equal(verified.code, 0, verified.out + verified.err);
  checkExport(await exported("whole.db"));
  checkTraffic(traffic);
  for (const word of ["kuroda", "sibille", "soft", "hard ", "interval order"])
    assert.ok(!program.err.includes(word), `the technician's terminal says "${word}"`);
  const again = await run("run", protocol, "--study", join(folder, "whole.db"), ...words, "--no-browser");
  assert.equal(again.code, 1);
  assert.match(again.err, /P01: has finished/);
});

async function exported(study) {
  const out = join(folder, `${study}-export`);
  const { code, err } = await run("export", join(folder, study), "--as", "json", "--out", out);
  assert.equal(code, 0, err);
  return JSON.parse(readFileSync(join(out, "study.json"), "utf8"));
}

/** What was answered is what was stored. */
function checkExport(study) {
  const trials = study.trials.rows;
  assert.equal(trials.length, 4);
  assert.deepEqual(trials.map((trial) => Number(trial.response)), [1, 2, 1, 2]);
  for (const trial of trials) {
    assert.equal(trial.participant_id, "P01");
    assert.equal(trial.run_mode, "study");
    assert.equal(Number(trial.pseudo_haptic), 1);
    assert.ok(trial.response_time_s > 0 && trial.response_time_s < 20, `${trial.response_time_s} s`);
  }
}

/** Nothing that the page hears tells condition, model or answer. */
function checkTraffic(traffic) {
  const question = "In which interval did it feel harder?";
  const telling = /\b(soft|hard|kuroda|sibille|absent|exact|none|young|modulus|stiff\w*|[mk]pa|correct|cell|condition|truth)\b/i;
  assert.ok(traffic.texts.length > 20 && traffic.bodies.length >= 4);
  for (const text of traffic.texts) assert.doesNotMatch(text.replaceAll(question, ""), telling);
  for (const body of traffic.bodies.filter((b) => !b.includes(".css"))) {
    const said = body.replace(/default-src 'none'.*frame-ancestors 'none'/, "").replace(/\bnone\b/g, "");  // a word of CSS and SVG
    assert.doesNotMatch(said.replaceAll(question, ""), telling);
  }
  const keys = new Set(traffic.texts.map((text) => Object.keys(JSON.parse(text)).join()));
  assert.equal(keys.size, 1, "every phase message has the same fields");
  const inIntervals = traffic.binaries.filter(({ phase }) => phase === "interval");
  assert.ok(inIntervals.length > 200);
  for (const { bytes } of inIntervals.filter(({ bytes }) => bytes[0] !== 3)) assert.equal(bytes.length, 12);
  assert.equal(inIntervals.filter(({ bytes }) => bytes[0] === 3).length, 0, "no pictures while they are hidden");
}

/** Where two elements lie on each other. */
async function overlap(page, a, b) {
  const [one, other] = [await page.locator(a).boundingBox(), await page.locator(b).boundingBox()];
  return one.x < other.x + other.width && other.x < one.x + one.width &&
         one.y < other.y + other.height && other.y < one.y + one.height;
}

test("without the browser's pointer lock, only the pointer in the field presses", async () => {
  const program = await begin("unlocked.db", "--examinee", "P06");
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.addInitScript(() => { HTMLElement.prototype.requestPointerLock = undefined; });
  const traffic = new Traffic();
  traffic.watch(page);
  await page.goto(program.link);
  const examinee = new Examinee(page);
  await arrive(examinee);
  await page.keyboard.press("Space");
  await examinee.sees("interval");
  await examinee.press(5);
  const before = traffic.binaries.length;
  await page.click('button[data-does="finish"]', { noWaitAfter: true });
  await examinee.sees("pause");
  const depths = traffic.binaries.slice(before).map(({ bytes }) => bytes.readInt32LE(8));
  assert.ok(depths.every((depth) => depth < 0), "a click on the button presses nothing");
  await program.signal("SIGINT");
});

test("a narrow window, by touch", async () => {
  const program = await begin("touch.db", "--examinee", "P07");
  const context = await browser.newContext({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const page = await context.newPage();
  await page.goto(program.link);
  const examinee = new Examinee(page);
  const finger = await context.newCDPSession(page);
  const touch = (type, y) => finger.send("Input.dispatchTouchEvent",
    { type, touchPoints: type === "touchEnd" ? [] : [{ x: 195, y }] });
  for (const phase of ["welcome", "gesture", "ready"]) {
    await examinee.sees(phase);
    assert.doesNotMatch(await page.textContent("main"), /Space|mouse/, "what is not there is not spoken of");
    await page.tap("#actions button");
  }
  await examinee.sees("interval");
  assert.ok(!(await overlap(page, "#field", '#actions button')), "the field leaves the button free");
  const field = await page.locator("#field").boundingBox();
  const skin = field.y + Number(await page.getAttribute("#field", "data-skin"));
  await touch("touchStart", skin - 40);
  for (let step = 1; step <= 10; ++step) await touch("touchMove", skin - 40 + 16 * step);
  await page.waitForTimeout(300);
  await examinee.picture("16-touch-narrow");
  await touch("touchEnd");
  await page.waitForFunction(() => !document.querySelector('button[data-does="finish"]').disabled);
  await page.tap('button[data-does="finish"]');
  await examinee.sees("pause");
  await program.signal("SIGINT");
});

test("strangers are turned away", async () => {
  const program = await begin("strangers.db", "--examinee", "P02");
  const { link } = program;
  const { host, pathname } = new URL(link);
  const upgrade = {
    Connection: "Upgrade", Upgrade: "websocket", "Sec-WebSocket-Version": "13", "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==",
  };
  const live = `${pathname}live`;
  assert.equal(await status(link), 200);
  assert.equal(await status(link, { headers: { Host: "evil.example" } }), 403);
  assert.equal(await status(link, { headers: { Host: `localhost:${new URL(link).port}` } }), 403);
  assert.equal(await status(link, { headers: { Origin: "http://evil.example" } }), 403);
  assert.equal(await status(link, { path: "/" }), 403);
  assert.equal(await status(link, { path: `/${"0".repeat(48)}/` }), 403);
  assert.equal(await status(link, { path: `${pathname}../../etc/passwd` }), 404);
  assert.equal(await status(link, { path: `${pathname}secret` }), 404);
  assert.equal(await status(link, { method: "POST" }), 405);
  assert.equal(await status(link, { path: live, headers: upgrade }), 403, "no origin");
  assert.equal(await status(link, { path: live, headers: { ...upgrade, Origin: "http://evil.example" } }), 403);
  assert.equal(await status(link, { path: `/${"0".repeat(48)}/live`, headers: { ...upgrade, Origin: `http://${host}` } }), 403);
  assert.equal(await status(link, { path: live, headers: { ...upgrade, Origin: `http://${host}` } }), 101);
  await assert.rejects(status(link, { headers: { Padding: "x".repeat(20000) } }));
  assert.equal((await program.signal("SIGINT")).code, 130);
});

test("two windows, a reload, and Ctrl-C", async () => {
  const words = ["--examinee", "P03", "--pilot"];
  let program = await begin("windows.db", ...words);
  const first = new Examinee(await openPage(program.link));
  await arrive(first);
  const second = new Examinee(await openPage(program.link));
  await second.sees("ready");
  await first.sees("apart");
  await first.picture("14-taken-over");
  assert.match(await first.page.textContent("h1"), /another window/);

  await second.page.keyboard.press("Space");
  await second.sees("interval");
  await second.page.reload();
  await second.sees("ready");
  assert.match(await second.page.textContent("#text"), /interruption/);
  assert.match(await second.page.textContent("header"), /Pilot/);
  await second.picture("15-after-a-reload-pilot");

  await second.page.keyboard.press("Space");
  await second.sees("interval");
  assert.equal((await program.signal("SIGINT")).code, 130, program.err);
  assert.match(program.err, /the same command takes it up again/);
  program = await begin("windows.db", ...words);
  assert.match(program.err, /0 of 4 questions are answered/);
  assert.equal((await program.signal("SIGTERM")).code, 130);
  assert.equal((await run("verify", join(folder, "windows.db"))).code, 0);
});

test("a port that is taken is said, and no study file is made", async () => {
  const program = await begin("port.db", "--examinee", "P04");
  const { port } = new URL(program.link);
  const refused = await run("run", protocol, "--study", join(folder, "refused.db"), "--examinee", "P05",
    "--no-browser", "--port", port);
  assert.equal(refused.code, 3);
  assert.match(refused.err, new RegExp(`port ${port} of 127\\.0\\.0\\.1 cannot be had`));
  assert.ok(!existsSync(join(folder, "refused.db")));
  await program.signal("SIGINT");
});
