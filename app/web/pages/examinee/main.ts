import { Field } from "./field";
import { Link } from "../shared/link";
import { decodeBinary, encodeHand, Phase, Probe, Reply } from "./messages";
import { Action, lostView, takenOverView, View, viewOf } from "./views";

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found as T;
}

const field = new Field(element<HTMLCanvasElement>("field"));
const picture = element<HTMLCanvasElement>("picture");

let phase: Phase | null = null;
let onset = Infinity;   // of the question, as painted [ms, performance.now()]
let replied = false;    // one reply a showing
let mayFinish = false;
let decoding = false;

const link = new Link<Reply>({
  text: (message) => show(JSON.parse(message) as Phase),
  binary: showBinary,
  lost: () => showApart(lostView),
  takenOver: () => showApart(takenOverView),
});

function show(next: Phase): void {
  phase = next;
  replied = false;
  mayFinish = false;
  onset = Infinity;
  document.body.dataset.phase = next.phase;
  document.body.dataset.showing = `${next.id}`;
  showKind(next);
  showProgress(next);
  document.body.style.setProperty("--choices", `${Math.max(2, next.choices.length)}`);
  render(viewOf(next), next.notice);
  picture.hidden = !next.picture;
  if (pressing(next)) field.begin();
  else if (next.phase === "pause") field.rest();
  else field.release();
  field.draw();
  if (next.phase === "question") startClock(next.id);
}

function pressing(shown: Phase): boolean {
  return shown.phase === "interval" || shown.phase === "gesture";
}

/** The clock starts when the question has been painted; whatever was pressed before is not an answer. */
function startClock(id: number): void {
  requestAnimationFrame(() => requestAnimationFrame((now) => {
    if (phase?.id !== id) return;
    onset = now;
    document.body.dataset.onset = `${id}`;
  }));
}

function showApart(view: View): void {
  phase = null;
  document.body.dataset.phase = "apart";
  field.release();
  render(view, "");
}

function showKind(next: Phase): void {
  element("channel").hidden = !next.pseudo_haptic;
  const mode = element("mode");
  mode.hidden = next.run_mode === "study";
  mode.textContent = next.run_mode === "pilot" ? "Pilot: not part of the study" : "Practice: not part of the study";
}

function showProgress(next: Phase): void {
  element("progress").classList.toggle("unseen", next.phase === "welcome" || next.phase === "gesture");
  const finished = next.number === 0;
  element("progress-text").textContent =
      finished ? "All questions answered" : `Question ${next.number} of ${next.questions}`;
  element<HTMLProgressElement>("progress-bar").value = finished ? 1 : (next.number - 1) / next.questions;
}

function paragraph(text: string, kind = ""): HTMLElement {
  const p = document.createElement("p");
  p.textContent = text;
  p.className = kind;
  return p;
}

function render(view: View, notice: string): void {
  element("title").textContent = view.title;
  const text = element("text");
  text.replaceChildren(...(notice ? [paragraph(notice, "notice")] : []), ...view.paragraphs.map((p) => paragraph(p)));
  if (view.list) {
    const list = document.createElement("ol");
    list.append(...view.list.map((item) => {
      const li = document.createElement("li");
      li.textContent = item;
      return li;
    }));
    text.append(list);
  }
  if (view.actions.some((action) => action.does === "strategy")) text.append(strategyBox());
  document.body.classList.toggle("pressing", view.stage);
  element("hint").textContent = view.hint ?? "";
  element("live").textContent = notice ? `${notice} ${view.spoken}` : view.spoken;
  const actions = element("actions");
  actions.replaceChildren(...view.actions.map(button));
  element("title").focus({ preventScroll: true });
}

function button(action: Action): HTMLButtonElement {
  const made = document.createElement("button");
  made.type = "button";
  made.className = action.primary ? "primary" : "";
  made.dataset.does = action.does;
  if (action.choice) made.dataset.choice = `${action.choice}`;
  made.disabled = action.does === "finish";
  const label = document.createElement("span");
  label.append(action.label);
  if (action.aside) {
    const aside = document.createElement("small");
    aside.textContent = action.aside;
    label.append(aside);
  }
  made.append(label);
  if (action.key) {
    const key = document.createElement("kbd");
    key.textContent = action.key;
    made.append(key);
  }
  made.addEventListener("click", (event) => act(action, event.timeStamp));
  return made;
}

function strategyBox(): HTMLElement {
  const label = document.createElement("label");
  label.append("What did you pay attention to?");
  const box = document.createElement("textarea");
  box.id = "strategy";
  box.rows = 4;
  box.maxLength = 2000;
  label.append(box);
  return label;
}

function act(action: Action, time: number): void {
  if (!phase || replied) return;
  const id = phase.id;
  switch (action.does) {
    case "answer":
      if (time < onset || action.choice === undefined) return;
      link.send({ type: "answer", id, choice: action.choice, ms: time - onset });
      break;
    case "strategy":
      link.send({ type: "strategy", id, text: element<HTMLTextAreaElement>("strategy").value });
      break;
    case "finish":
      if (!mayFinish) return;
      link.send({ type: "finish", id });
      break;
    case "continue":
      link.send({ type: "continue", id });
      break;
  }
  replied = true;
  for (const made of document.querySelectorAll<HTMLButtonElement>("#actions button")) made.disabled = true;
}

function showBinary(message: ArrayBuffer): void {
  const { probe, frame } = decodeBinary(message);
  if (probe) showProbe(probe);
  if (frame) showFrame(frame);
}

/** How far the interval is: all of it follows from the hand. */
function progressOf(probe: Probe, shown: Phase): string {
  if (probe.over) return "";
  if (!probe.begun) return "Bring the pointer up to the line to begin.";
  const [least, most] = shown.presses;
  const asked = least === most ? `${most}` : `${least} to ${most}`;
  const depth = probe.deepEnough ? "deep enough" : probe.presses > 0 ? "a little deeper, please" : "press down, and let go";
  return `Presses so far: ${probe.presses} (${asked} ${asked === "1" ? "is" : "are"} asked for), ${depth}. ${probe.secondsLeft}\u00a0s\u00a0left.`;
}

function showProbe(probe: Probe): void {
  if (!phase || !pressing(phase)) return;
  field.place(probe.depth);
  if (phase.phase !== "interval") return;
  const told = progressOf(probe, phase);
  if (element("hint").textContent !== told) element("hint").textContent = told;
  if (probe.mayFinish === mayFinish || replied) return;
  mayFinish = probe.mayFinish;
  const finish = document.querySelector<HTMLButtonElement>('button[data-does="finish"]');
  if (finish) finish.disabled = !mayFinish;
}

function showFrame(jpeg: Blob): void {
  if (decoding || picture.hidden) return;
  decoding = true;
  createImageBitmap(jpeg)
    .then((bitmap) => {
      picture.getContext("2d")?.drawImage(bitmap, 0, 0);
      bitmap.close();
    })
    .catch(() => undefined)  // a damaged frame is followed by the next one
    .finally(() => { decoding = false; });
}

/** The number of the choice that a key gives; 0 for none. */
function choiceOf(key: string, shown: Phase): number {
  return shown.choices.findIndex((choice) => choice.keys.includes(key)) + 1;
}

function keyDown(event: KeyboardEvent): void {
  if (event.repeat || event.ctrlKey || event.altKey || event.metaKey || !phase) return;
  if (event.target instanceof HTMLTextAreaElement) return;
  const choice = choiceOf(event.key, phase);
  if (choice > 0) return answerKey(event, choice);
  if (event.key === " " && !(event.target instanceof HTMLButtonElement)) {
    const action = viewOf(phase).actions.find((a) => a.key === "Space");
    if (!action) return;
    event.preventDefault();
    act(action, event.timeStamp);
  }
}

function answerKey(event: KeyboardEvent, choice: number): void {
  if (!phase) return;
  if (phase.phase === "question" && event.timeStamp >= onset) {
    event.preventDefault();
    act({ label: "", key: "", primary: true, does: "answer", choice }, event.timeStamp);
  } else if (["interval", "pause", "question"].includes(phase.phase) && !replied) {
    link.send({ type: "early", id: phase.id, key: event.key });
  }
}

function everyFrame(): void {
  if (phase && pressing(phase)) {
    const depth = field.handDepth;
    if (depth !== null) link.sendBinary(encodeHand(phase.id, depth));
    field.draw();
  }
  requestAnimationFrame(everyFrame);
}

/** Without a pointer of the browser's no button can be clicked: a click with the hand off the skin is the button. */
function clicked(event: MouseEvent): void {
  const action = phase && field.locked && field.lifted ? viewOf(phase).actions[0] : undefined;
  if (action) act(action, event.timeStamp);
}

window.addEventListener("keydown", keyDown);
window.addEventListener("click", clicked);
requestAnimationFrame(everyFrame);
