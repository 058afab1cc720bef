// Starts palpate, and sits a session as an examinee does: by mouse and keys.

import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

function needed(name) {
  const value = process.env[name];
  if (!value) throw new Error(`set ${name}: run this test by ctest (label browser)`);
  return value;
}

export const folder = needed("PALPATE_BROWSER_FOLDER");
export const palpate = needed("PALPATE");
export const screenshots = join(folder, "screenshots");
mkdirSync(screenshots, { recursive: true });
const { chromium } = createRequire(join(folder, "package.json"))("playwright-core");

export function launchBrowser() {
  return chromium.launch({
    executablePath: needed("CHROMIUM"),
    args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync"],
  });
}

/** Runs a command to its end. */
export async function run(...words) {
  const child = spawn(palpate, words);
  let out = "", err = "";
  child.stdout.on("data", (data) => { out += data; });
  child.stderr.on("data", (data) => { err += data; });
  const [code] = await once(child, "close");
  return { code, out, err };
}

/** palpate run, until it prints its link. */
export class Program {
  static all = [];
  out = "";
  err = "";

  /** Whatever a test that failed has left behind. */
  static endAll() {
    for (const program of Program.all) program.child.kill("SIGKILL");
  }

  static async start(...words) {
    const program = new Program();
    program.child = spawn(palpate, ["run", ...words, "--no-browser"]);
    Program.all.push(program);
    program.ended = once(program.child, "close").then(([code, signal]) => ({ code, signal }));
    program.child.stderr.on("data", (data) => { program.err += data; });
    await new Promise((resolve, reject) => {
      program.child.stdout.on("data", (data) => {
        program.out += data;
        program.link = /http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]+\//.exec(program.out)?.[0];
        if (program.link) resolve();
      });
      program.ended.then(({ code }) => reject(new Error(`palpate ended with ${code}: ${program.err}`)));
    });
    return program;
  }

  signal(name) {
    this.child.kill(name);
    return this.ended;
  }
}

/** All that passes between page and program. */
export class Traffic {
  bodies = [];    // of HTTP answers, with their headers
  texts = [];     // WebSocket messages to the page
  binaries = [];  // { bytes, phase }
  sent = [];      // WebSocket text messages from the page
  phase = "";

  watch(page) {
    page.on("response", async (response) => {
      const body = await response.text().catch(() => "");
      this.bodies.push(`${response.url()}\n${JSON.stringify(response.headers())}\n${body}`);
    });
    page.on("websocket", (socket) => {
      socket.on("framereceived", ({ payload }) => this.received(payload));
      socket.on("framesent", ({ payload }) => { if (typeof payload === "string") this.sent.push(payload); });
    });
  }

  received(payload) {
    if (typeof payload !== "string") {
      this.binaries.push({ bytes: payload, phase: this.phase });
      return;
    }
    this.texts.push(payload);
    this.phase = JSON.parse(payload).phase;
  }
}

const kPixelsPerMillimetre = 32;  // of the field; pages/examinee/field.ts
const kLockedSkin = 100;          // any place will do [CSS px]

/** An examinee before one open page. */
export class Examinee {
  constructor(page) {
    this.page = page;
  }

  async sees(phase, timeout = 20000) {
    await this.page.waitForSelector(`body[data-phase="${phase}"]`, { timeout });
  }

  async picture(name) {
    await this.page.screenshot({ path: join(screenshots, `${name}.png`) });
  }

  /** The hand's place. A mouse whose pointer the page has taken tells only how far it was moved. */
  async moveTo(millimetres, steps = 8) {
    const field = this.page.locator("#field");
    const box = await field.boundingBox();
    const locked = await this.page.evaluate(() => document.pointerLockElement !== null);
    const skin = locked ? kLockedSkin : Number(await field.getAttribute("data-skin"));
    await this.page.mouse.move(box.x + box.width / 2, box.y + skin + millimetres * kPixelsPerMillimetre, { steps });
  }

  /** Off the skin, in, a while, and out again. */
  async press(millimetres, meanwhile = async () => {}) {
    await this.moveTo(-2);
    await this.page.waitForTimeout(150);
    await this.moveTo(millimetres);
    await this.page.waitForTimeout(400);
    await meanwhile();
    await this.moveTo(-2);
    await this.page.waitForTimeout(250);
  }

  /** Presses until the program shows something else. */
  async explore(presses = 2, millimetres = 11) {
    const showing = await this.page.getAttribute("body", "data-showing");
    for (let k = 0; k < presses; ++k) await this.press(millimetres);
    await this.page.waitForFunction((id) => document.body.dataset.showing !== id, showing, { timeout: 20000 });
  }

  /** An interval until it has been felt enough; a machine that is slow to hear may ask for it once more. */
  async oneInterval() {
    for (let attempt = 0; attempt < 4; ++attempt) {
      await this.sees("interval");
      await this.explore();
      if (await this.page.getAttribute("body", "data-phase") !== "again") return;
      await this.page.keyboard.press("Space");
    }
    throw new Error("the interval was never explored enough");
  }

  async bothIntervals() {
    await this.oneInterval();
    await this.sees("pause");
    await this.oneInterval();
  }

  /** Until the question has been painted. */
  async question() {
    await this.sees("question");
    await this.page.waitForFunction(() => document.body.dataset.onset === document.body.dataset.showing);
  }
}
